"""A world as it is described before anything moves, and what is written of it: pictures, braille pages."""

from donnie_tui.i18n.sentence import Sentence

SENTENCES: dict[str, Sentence] = {
    # --- the list of worlds
    "world-listed": Sentence(
        "{name}: {title}, {difficulty}.", "{name}: {title}, {difficulty}.", "{name}: {title}, {difficulty}."
    ),
    "difficulty-easy": Sentence("easy", "fácil", "fácil"),
    "difficulty-medium": Sentence("medium", "médio", "medio"),
    "difficulty-hard": Sentence("hard", "difícil", "difícil"),
    # --- a world in words
    "world-difficulty": Sentence("Difficulty: {difficulty}.", "Nível: {difficulty}.", "Nivel: {difficulty}."),
    "world-no-robot": Sentence(
        "There is no robot. Places are told from the middle.",
        "Não há robô. Os lugares são contados a partir do meio.",
        "No hay robot. Los lugares se cuentan desde el centro.",
        brief=(
            "No robot. Places are from the middle.",
            "Sem robô. Lugares a partir do meio.",
            "Sin robot. Lugares desde el centro.",
        ),
    ),
    "world-robot-start": Sentence(
        "The robot {name} starts at {x}, {y}, facing {facing}.",
        "O robô {name} começa em {x}, {y}, virado para {facing}.",
        "El robot {name} empieza en {x}, {y}, mirando al {facing}.",
        brief=(
            "{name} starts at {x}, {y}, facing {facing}.",
            "{name} começa em {x}, {y}, para {facing}.",
            "{name} empieza en {x}, {y}, al {facing}.",
        ),
    ),
    "world-robots": Sentence(
        "{count} robots: {names}.", "{count} robôs: {names}.", "{count} robots: {names}."
    ),
    "world-robots-many": Sentence(
        "{count} robots: {names} and {more} more.",
        "{count} robôs: {names} e mais {more}.",
        "{count} robots: {names} y {more} más.",
    ),
    "world-robot": Sentence(
        "Robot {name}, from {first}: {place}, facing {facing}.",
        "Robô {name}, a partir de {first}: {place}, virado para {facing}.",
        "Robot {name}, desde {first}: {place}, mirando al {facing}.",
        brief=(
            "Robot {name}: {place}, facing {facing}.",
            "Robô {name}: {place}, para {facing}.",
            "Robot {name}: {place}, al {facing}.",
        ),
    ),
    "world-things-from-start": Sentence(
        "{count} {count:thing|things}, the nearest first, in steps.",
        "{count} {count:objeto|objetos}, o mais perto primeiro, em passos.",
        "{count} {count:objeto|objetos}, el más cercano primero, en pasos.",
        brief=(
            "{count} {count:thing|things}, nearest first, in steps.",
            "{count} {count:objeto|objetos}, por distância, em passos.",
            "{count} {count:objeto|objetos}, por distancia, en pasos.",
        ),
    ),
    "world-things-from-robot": Sentence(
        "{count} {count:thing|things}, in steps from {name}, the nearest first.",
        "{count} {count:objeto|objetos}, em passos a partir de {name}, o mais perto primeiro.",
        "{count} {count:objeto|objetos}, en pasos desde {name}, el más cercano primero.",
        brief=(
            "{count} {count:thing|things}, in steps from {name}.",
            "{count} {count:objeto|objetos}, em passos de {name}.",
            "{count} {count:objeto|objetos}, en pasos desde {name}.",
        ),
    ),
    "world-large-thing": Sentence(
        "{thing:capital}, {width} by {depth}: {place}.",
        "{thing:capital}, {width} por {depth}: {place}.",
        "{thing:capital}, {width} por {depth}: {place}.",
        brief=("{thing:capital}: {place}.", "{thing:capital}: {place}.", "{thing:capital}: {place}."),
    ),
    "world-more-things": Sentence(
        "{count} more {count:thing is|things are} farther away.",
        "Mais longe há mais {count} {count:objeto|objetos}.",
        "Más lejos hay {count} {count:objeto|objetos} más.",
    ),
    "world-more-of-kind": Sentence(
        "{count} of them: {thing}.",
        "{count} deles: {thing}.",
        "{count} de ellos: {thing}.",
    ),
    "place-north": Sentence("{steps} north", "{steps} ao norte", "{steps} al norte"),
    "place-south": Sentence("{steps} south", "{steps} ao sul", "{steps} al sur"),
    "place-east": Sentence("{steps} east", "{steps} a leste", "{steps} al este"),
    "place-west": Sentence("{steps} west", "{steps} a oeste", "{steps} al oeste"),
    # --- maps, pictures and braille pages
    "map-scale": Sentence(
        "Each letter stands for {steps} by {steps} steps.",
        "Cada letra vale {steps} por {steps} passos.",
        "Cada letra vale {steps} por {steps} pasos.",
    ),
    "paper-written": Sentence("I wrote {path}.", "Gravei {path}.", "Guardé {path}."),
    "paper-title": Sentence("Map of {name}", "Mapa de {name}", "Mapa de {name}"),
    "paper-north": Sentence("north is at the top", "o norte fica em cima", "el norte está arriba"),
    "paper-cell": Sentence(
        "a cell is {width} by {height} steps",
        "uma cela tem {width} por {height} passos",
        "una celda mide {width} por {height} pasos",
    ),
    "paper-scale": Sentence(
        "the line is {steps} steps", "a linha mede {steps} passos", "la línea mide {steps} pasos"
    ),
    "paper-legend-wall": Sentence("wall", "parede", "pared"),
    "paper-legend-robot": Sentence(
        "{name}, looks {facing}", "{name}, olha: {facing}", "{name}, mira: {facing}"
    ),
    "paper-legend-robots": Sentence("{count} more robots", "mais {count} robôs", "{count} robots más"),
}
