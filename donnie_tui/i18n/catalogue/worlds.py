"""World files: what is wrong in one, and a world in words."""

from donnie_tui.i18n.sentence import Sentence

SENTENCES: dict[str, Sentence] = {
    # --- which world
    "world-unknown": Sentence(
        "There is no world {name}. The command donnie worlds lists them.",
        "Não existe o mundo {name}. O comando donnie worlds lista todos.",
        "No existe el mundo {name}. El comando donnie worlds los lista.",
    ),
    "world-unknown-near": Sentence(
        "There is no world {name}. Did you mean {near}?",
        "Não existe o mundo {name}. Você quis dizer {near}?",
        "No existe el mundo {name}. Quizá querías decir {near}.",
    ),
    "world-without-robot": Sentence(
        "The world {name} has no robot with sensors.",
        "O mundo {name} não tem robô com sensores.",
        "El mundo {name} no tiene un robot con sensores.",
        brief=(
            "World {name} has no robot.",
            "O mundo {name} não tem robô.",
            "El mundo {name} no tiene robot.",
        ),
    ),
    # --- a file that can't be used
    "world-error-at": Sentence(
        "Error, {file}, line {line}, column {column}: {message}",
        "Erro, {file}, linha {line}, coluna {column}: {message}",
        "Error, {file}, línea {line}, columna {column}: {message}",
    ),
    "world-file-not-found": Sentence(
        "There is no file {path}.", "Não existe o arquivo {path}.", "No existe el archivo {path}."
    ),
    "world-is-folder": Sentence(
        "{path} is a folder and no world file.",
        "{path} é uma pasta, não um mundo.",
        "{path} es una carpeta, no un mundo.",
    ),
    "world-file-unreadable": Sentence(
        "I can't read {path}.", "Não consigo ler {path}.", "No puedo leer {path}."
    ),
    "world-file-too-large": Sentence(
        "{path} is too large, at most {limit} bytes.",
        "{path} é grande demais, no máximo {limit} bytes.",
        "{path} es demasiado grande, como máximo {limit} bytes.",
    ),
    "world-include-cycle": Sentence(
        "{path} includes itself.", "{path} inclui a si mesmo.", "{path} se incluye a sí mismo."
    ),
    "world-include-outside": Sentence(
        "{path} lies outside the folder of the world. DONNIE_WORLDS can allow more folders.",
        "{path} fica fora da pasta do mundo. DONNIE_WORLDS pode permitir mais pastas.",
        "{path} está fuera de la carpeta del mundo. DONNIE_WORLDS puede permitir más carpetas.",
    ),
    "world-include-too-deep": Sentence(
        "Too many includes in each other, at most {limit}.",
        "Inclusões demais uma dentro da outra, no máximo {limit}.",
        "Demasiadas inclusiones una en otra, como máximo {limit}.",
    ),
    "world-no-world-file": Sentence(
        "This file names no worldfile and no real robot.",
        "Este arquivo não indica nenhum worldfile nem robô real.",
        "Este archivo no indica ningún worldfile ni robot real.",
    ),
    "world-bad-address": Sentence(
        "{found} is no device address. One looks like position2d:0 or 6665:position2d:0.",
        "{found} não é um endereço de dispositivo. Um exemplo é position2d:0 ou 6665:position2d:0.",
        "{found} no es una dirección de dispositivo. Un ejemplo es position2d:0 o 6665:position2d:0.",
    ),
    "world-bitmap-not-found": Sentence(
        "There is no picture {path}.", "Não existe a imagem {path}.", "No existe la imagen {path}."
    ),
    "world-bitmap-outside": Sentence(
        "The picture {path} lies outside the folder of the world. DONNIE_WORLDS can allow more folders.",
        "A imagem {path} fica fora da pasta do mundo. DONNIE_WORLDS pode permitir mais pastas.",
        "La imagen {path} está fuera de la carpeta del mundo. DONNIE_WORLDS puede permitir más carpetas.",
    ),
    "world-bitmap-unreadable": Sentence(
        "I can't read the picture {path}. It should be {expected}.",
        "Não consigo ler a imagem {path}. Deveria ser {expected}.",
        "No puedo leer la imagen {path}. Debería ser {expected}.",
    ),
    "world-unknown-character": Sentence(
        "I can't use {found} here.", "Não posso usar {found} aqui.", "No puedo usar {found} aquí."
    ),
    "world-comment-sign": Sentence(
        "A comment begins with #, not with {found}.",
        "Um comentário começa com #, não com {found}.",
        "Un comentario empieza con #, no con {found}.",
    ),
    "world-unterminated-string": Sentence(
        "This string has no closing quote.",
        "Falta fechar as aspas deste texto.",
        "Falta cerrar las comillas de este texto.",
    ),
    "world-bad-number": Sentence(
        "{found} is no number.", "{found} não é um número.", "{found} no es un número."
    ),
    "world-number-too-large": Sentence(
        "The number {found} is too large.",
        "O número {found} é grande demais.",
        "El número {found} es demasiado grande.",
    ),
    "world-nested-too-deep": Sentence(
        "Too many parentheses in each other, at most {limit}.",
        "Parênteses demais um dentro do outro, no máximo {limit}.",
        "Demasiados paréntesis uno en otro, como máximo {limit}.",
    ),
    "world-unexpected": Sentence(
        "I did not expect {found} here.", "Não esperava {found} aqui.", "No esperaba {found} aquí."
    ),
    "world-unexpected-expecting": Sentence(
        "I expected {expected}, not {found}.",
        "Esperava {expected}, não {found}.",
        "Esperaba {expected}, no {found}.",
    ),
    "world-unexpected-end": Sentence(
        "Missing at the end: {expected}.", "Falta no fim: {expected}.", "Falta al final: {expected}."
    ),
    "world-unclosed": Sentence(
        "{found} is never closed.", "{found} nunca é fechado.", "{found} no se cierra nunca."
    ),
    "world-misplaced": Sentence(
        "{found} stands at the top level only.",
        "{found} só fica no nível mais alto.",
        "{found} solo va en el nivel superior.",
    ),
    "world-unknown-type": Sentence(
        "I do not know the model {found}.",
        "Não conheço o modelo {found}.",
        "No conozco el modelo {found}.",
    ),
    "world-missing-include": Sentence(
        'I do not know the model {found}. It is in {path}: write include "{path}" above.',
        'Não conheço o modelo {found}. Está em {path}: escreva include "{path}" acima.',
        'No conozco el modelo {found}. Está en {path}: escribe include "{path}" arriba.',
    ),
    "world-meant": Sentence(
        "{message} Did you mean {near}?",
        "{message} Você quis dizer {near}?",
        "{message} Quizá querías decir {near}.",
    ),
    "world-define-cycle": Sentence(
        "{found} is made of itself.", "{found} é feito de si mesmo.", "{found} está hecho de sí mismo."
    ),
    "world-too-much": Sentence(
        "The world is too large, at most {limit} parts.",
        "O mundo é grande demais, no máximo {limit} partes.",
        "El mundo es demasiado grande, como máximo {limit} partes.",
    ),
    "world-wrong-type": Sentence(
        "{name} takes {expected}.", "{name} recebe {expected}.", "{name} recibe {expected}."
    ),
    "world-wrong-count": Sentence(
        "{name} takes {expected} values, not {given}.",
        "{name} recebe {expected} valores, não {given}.",
        "{name} recibe {expected} valores, no {given}.",
    ),
    "world-too-many": Sentence(
        "{name} has too many values, {given}.",
        "{name} tem valores demais, {given}.",
        "{name} tiene demasiados valores, {given}.",
    ),
    "world-out-of-range": Sentence(
        "{name} is too small or too large.",
        "{name} é pequeno ou grande demais.",
        "{name} es demasiado pequeño o grande.",
    ),
    "world-wrong-order": Sentence(
        "{name} takes the smaller number first.",
        "{name} recebe primeiro o número menor.",
        "{name} recibe primero el número menor.",
    ),
    "world-unknown-word": Sentence(
        "{name} takes {expected}, not {found}.",
        "{name} recebe {expected}, não {found}.",
        "{name} recibe {expected}, no {found}.",
    ),
    "world-missing-point": Sentence("{name} is missing.", "Falta {name}.", "Falta {name}."),
    "world-too-few-points": Sentence(
        "A block needs 3 to {limit} points, not {given}.",
        "Um bloco precisa de 3 a {limit} pontos, não {given}.",
        "Un bloque necesita de 3 a {limit} puntos, no {given}.",
    ),
    "world-control-character": Sentence(
        "a control character", "um caractere de controle", "un carácter de control"
    ),
    "world-expected-number": Sentence("a number", "um número", "un número"),
    "world-expected-string": Sentence("a text in quotes", "um texto entre aspas", "un texto entre comillas"),
    "world-expected-tuple": Sentence(
        "values in brackets", "valores entre colchetes", "valores entre corchetes"
    ),
    "world-expected-name": Sentence("a name", "um nome", "un nombre"),
    "world-expected-value": Sentence("a value", "um valor", "un valor"),
    # --- a world in words
    "world-real-only": Sentence(
        "{name} asks for the robot at {port} and has no world. Here is {floor}, on which it is drawn.",
        "{name} pede o robô em {port} e não tem mundo. Aqui está {floor}, em que ele é desenhado.",
        "{name} pide el robot en {port} y no tiene mundo. Aquí está {floor}, en el que se dibuja.",
    ),
    "world-title": Sentence("{name}: {title}.", "{name}: {title}.", "{name}: {title}."),
    "world-task": Sentence("Task: {task}", "Tarefa: {task}", "Tarea: {task}"),
    "world-endless": Sentence(
        "An open floor without walls.", "Um chão livre sem paredes.", "Un suelo libre sin paredes."
    ),
    "world-size": Sentence(
        "{width} by {height} steps, walls included.",
        "{width} por {height} passos, com as paredes.",
        "{width} por {height} pasos, con las paredes.",
    ),
    "walls-around": Sentence(
        "Walls are all around.", "Há paredes por todos os lados.", "Hay paredes por todos lados."
    ),
    "walls-seen": Sentence(
        "Walls from the robot, in steps: {sides}.",
        "Paredes a partir do robô, em passos: {sides}.",
        "Paredes desde el robot, en pasos: {sides}.",
        brief=("Walls: {sides}.", "Paredes: {sides}.", "Paredes: {sides}."),
    ),
    "walls-aside": Sentence(
        "No wall is straight north, east, south or west.",
        "Nenhuma parede fica bem ao norte, leste, sul ou oeste.",
        "Ninguna pared queda justo al norte, este, sur u oeste.",
        brief=("Walls are aside.", "As paredes ficam de lado.", "Las paredes quedan de lado."),
    ),
    "world-bare": Sentence("There are no things.", "Não há objetos.", "No hay objetos."),
    "world-things": Sentence(
        "{count} {count:thing|things}, the nearest first.",
        "{count} {count:objeto|objetos}, o mais perto primeiro.",
        "{count} {count:objeto|objetos}, el más cercano primero.",
    ),
    "world-thing": Sentence(
        "{thing:capital}: {place}.", "{thing:capital}: {place}.", "{thing:capital}: {place}."
    ),
    "place-left": Sentence(
        "{steps} left",
        "{steps} à esquerda",
        "{steps} a la izquierda",
        brief=("{steps} left", "{steps} esquerda", "{steps} izquierda"),
    ),
    "place-right": Sentence(
        "{steps} right",
        "{steps} à direita",
        "{steps} a la derecha",
        brief=("{steps} right", "{steps} direita", "{steps} derecha"),
    ),
    "place-ahead": Sentence(
        "{steps} ahead",
        "{steps} à frente",
        "{steps} al frente",
        brief=("{steps} ahead", "{steps} frente", "{steps} frente"),
    ),
    "place-behind": Sentence("{steps} behind", "{steps} atrás", "{steps} detrás"),
    "place-here": Sentence("here", "aqui", "aquí"),
    "map-legend": Sentence("{letter} is {name}.", "{letter} é {name}.", "{letter} es {name}."),
    # --- what was loaded
    "report-files": Sentence(
        "{count} {count:file|files}: {files}.",
        "{count} {count:arquivo|arquivos}: {files}.",
        "{count} {count:archivo|archivos}: {files}.",
    ),
    "report-loaded": Sentence("Loaded: {models}.", "Carregado: {models}.", "Cargado: {models}."),
    "report-robots": Sentence(
        "{count} {count:robot|robots}: {names}. The command donnie run {first}=FILE runs the first.",
        "{count} {count:robô|robôs}: {names}. O comando donnie run {first}=ARQUIVO executa o primeiro.",
        "{count} {count:robot|robots}: {names}. El comando donnie run {first}=ARCHIVO ejecuta el primero.",
    ),
    "report-ignored": Sentence("Ignored: {remark}", "Ignorado: {remark}", "Ignorado: {remark}"),
    "report-repaired": Sentence("Repaired: {remark}", "Corrigido: {remark}", "Corregido: {remark}"),
    "report-warning": Sentence("Warning: {remark}", "Aviso: {remark}", "Aviso: {remark}"),
    "report-clean": Sentence(
        "Nothing was ignored or repaired.",
        "Nada foi ignorado ou corrigido.",
        "Nada se ignoró ni se corrigió.",
    ),
}
