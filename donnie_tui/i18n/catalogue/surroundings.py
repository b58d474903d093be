"""Where the robot is, what is around it, the map and the trail in words: the same in both front ends."""

from donnie_tui.i18n.sentence import Sentence

_CELLS = {
    "cell-robot": Sentence("Donnie", "Donnie", "Donnie"),
    "cell-start": Sentence("the start", "o início", "el inicio"),
    "cell-trail": Sentence("trail", "rastro", "rastro"),
    "cell-wall": Sentence("wall", "parede", "pared"),
    "cell-outside": Sentence("outside the world", "fora do mundo", "fuera del mundo"),
    "cell-beyond": Sentence("beyond the map", "além do mapa", "más allá del mapa"),
    "cell-free": Sentence("free", "livre", "libre"),
    "cell-free-many": Sentence("free", "livres", "libres"),
}

_MAP = {
    "map-row": Sentence(
        "Row {number}, from {start}: {runs}.",
        "Linha {number}, de {start}: {runs}.",
        "Fila {number}, desde {start}: {runs}.",
    ),
    "map-column": Sentence(
        "Column {number}, from {start}: {runs}.",
        "Coluna {number}, de {start}: {runs}.",
        "Columna {number}, desde {start}: {runs}.",
    ),
    "map-no-row": Sentence(
        "No row {row}. Rows go from {first} to {last}.",
        "Não há linha {row}. Vão de {first} a {last}.",
        "No hay fila {row}. Van de {first} a {last}.",
    ),
    "map-no-column": Sentence(
        "No column {column}. They go from {first} to {last}.",
        "Não há coluna {column}. Vão de {first} a {last}.",
        "No hay columna {column}. Van de {first} a {last}.",
    ),
    "map-square": Sentence(
        "{x}, {y}: {what}. {place}.",
        "{x}, {y}: {what}. {place}.",
        "{x}, {y}: {what}. {place}.",
        brief=("{x}, {y}: {what}.", "{x}, {y}: {what}.", "{x}, {y}: {what}."),
    ),
    "picture-title-named": Sentence(
        "Picture, {width} by {height}. {name} is {robot}",
        "Imagem, {width} por {height}. {name} é {robot}",
        "Imagen, {width} por {height}. {name} es {robot}",
    ),
    "picture-title": Sentence(
        "Picture, {width} by {height}. The robot is {robot}",
        "Imagem, {width} por {height}. O robô é {robot}",
        "Imagen, {width} por {height}. El robot es {robot}",
        brief=(
            "{width} by {height}. The robot is {robot}",
            "{width} por {height}. O robô é {robot}",
            "{width} por {height}. El robot es {robot}",
        ),
    ),
    "picture-part": Sentence(
        "Only a part: x {left} to {right}, y {bottom} to {top}.",
        "Só uma parte: x {left} a {right}, y {bottom} a {top}.",
        "Solo una parte: x {left} a {right}, y {bottom} a {top}.",
        brief=(
            "Part: x {left} to {right}, y {bottom} to {top}.",
            "Parte: x {left} a {right}, y {bottom} a {top}.",
            "Parte: x {left} a {right}, y {bottom} a {top}.",
        ),
    ),
    "picture-whole": Sentence(
        "The whole: x {left} to {right}, y {bottom} to {top}. MAP ROW tells the rest.",
        "O todo: x {left} a {right}, y {bottom} a {top}. MAPA LINHA diz o resto.",
        "El todo: x {left} a {right}, y {bottom} a {top}. MAPA FILA dice el resto.",
        brief=(
            "Whole: x {left} to {right}, y {bottom} to {top}.",
            "Todo: x {left} a {right}, y {bottom} a {top}.",
            "Todo: x {left} a {right}, y {bottom} a {top}.",
        ),
    ),
    "picture-letter": Sentence(
        "{name:capital}: {letter}", "{name:capital}: {letter}", "{name:capital}: {letter}"
    ),
}

_AROUND = {
    "around-things": Sentence(
        "{count} {count:thing|things} within {steps} steps.",
        "{count} {count:objeto|objetos} até {steps} passos.",
        "{count} {count:objeto|objetos} hasta {steps} pasos.",
    ),
    "around-none": Sentence(
        "No things within {steps} steps.",
        "Nenhum objeto até {steps} passos.",
        "Ningún objeto hasta {steps} pasos.",
    ),
    "around-thing": Sentence(
        "{where:capital}: {thing}, {steps} {steps:step|steps}.",
        "{where:capital}: {thing}, {steps} {steps:passo|passos}.",
        "{where:capital}: {thing}, {steps} {steps:paso|pasos}.",
        brief=(
            "{where:capital}: {thing}, {steps}.",
            "{where:capital}: {thing}, {steps}.",
            "{where:capital}: {thing}, {steps}.",
        ),
    ),
    "around-free": Sentence(
        "{where:capital}: free, {steps} steps.",
        "{where:capital}: livre, {steps} passos.",
        "{where:capital}: libre, {steps} pasos.",
        brief=("{where:capital}: free.", "{where:capital}: livre.", "{where:capital}: libre."),
    ),
    "around-hour": Sentence("{hour} o'clock", "{hour} {hour:hora|horas}", "{hour} en punto"),
    "around-front": Sentence("ahead", "à frente", "al frente"),
    "around-front-right": Sentence("ahead right", "à frente, direita", "al frente, derecha"),
    "around-right": Sentence("right", "à direita", "a la derecha"),
    "around-back-right": Sentence("behind right", "atrás, direita", "atrás, derecha"),
    "around-back": Sentence("behind", "atrás", "atrás"),
    "around-back-left": Sentence("behind left", "atrás, esquerda", "atrás, izquierda"),
    "around-left": Sentence("left", "à esquerda", "a la izquierda"),
    "around-front-left": Sentence("ahead left", "à frente, esquerda", "al frente, izquierda"),
}

_TRAIL = {
    "trail-none": Sentence("I have not moved yet.", "Ainda não andei.", "Aún no me moví."),
    "trail-walked": Sentence(
        "{command}: {done} {done:step|steps}, to {x}, {y}.",
        "{command}: {done} {done:passo|passos}, até {x}, {y}.",
        "{command}: {done} {done:paso|pasos}, hasta {x}, {y}.",
    ),
    "trail-blocked": Sentence(
        "{command}: blocked after {done}, at {x}, {y}.",
        "{command}: bloqueado após {done}, em {x}, {y}.",
        "{command}: bloqueado tras {done}, en {x}, {y}.",
    ),
    "trail-stopped": Sentence(
        "{command}: stopped after {done}, at {x}, {y}.",
        "{command}: parado após {done}, em {x}, {y}.",
        "{command}: detenido tras {done}, en {x}, {y}.",
    ),
    "trail-turned": Sentence(
        "{command}: now facing {facing}.",
        "{command}: agora virado para {facing}.",
        "{command}: ahora mira al {facing}.",
        brief=("{command}: {facing}.", "{command}: {facing}.", "{command}: {facing}."),
    ),
}

_READING = {
    "line-empty": Sentence("empty.", "vazia.", "vacía."),
    "line-closes": Sentence(
        "{text}, closes line {opener}.",
        "{text}, fecha a linha {opener}.",
        "{text}, cierra la línea {opener}.",
    ),
    "line-level": Sentence(
        "Line {line}, level {level}: {text}",
        "Linha {line}, nível {level}: {text}",
        "Línea {line}, nivel {level}: {text}",
    ),
    "place-line": Sentence(
        "Line {line} of {lines}, level {level}.",
        "Linha {line} de {lines}, nível {level}.",
        "Línea {line} de {lines}, nivel {level}.",
    ),
    "place-in": Sentence(
        "In {opener} from line {line}.", "Em {opener} da linha {line}.", "En {opener} de la línea {line}."
    ),
    "outline-none": Sentence("There are no blocks.", "Não há blocos.", "No hay bloques."),
    "outline-count": Sentence(
        "{count} {count:block|blocks}.", "{count} {count:bloco|blocos}.", "{count} {count:bloque|bloques}."
    ),
    "read-no-up": Sentence("No block is around this.", "Nenhum bloco em volta.", "Ningún bloque alrededor."),
    "read-no-down": Sentence("No block opens here.", "Nenhum bloco abre aqui.", "Ningún bloque abre aquí."),
    "read-no-next_same": Sentence(
        "Nothing more on this level.", "Nada mais neste nível.", "Nada más en este nivel."
    ),
    "read-no-back_same": Sentence(
        "Nothing before on this level.", "Nada antes neste nível.", "Nada antes en este nivel."
    ),
    "read-no-next": Sentence("That is the last line.", "Essa é a última linha.", "Esa es la última línea."),
    "read-no-back": Sentence(
        "That is the first line.", "Essa é a primeira linha.", "Esa es la primera línea."
    ),
}

SENTENCES = _CELLS | _MAP | _AROUND | _TRAIL | _READING
