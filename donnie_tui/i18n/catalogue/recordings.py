"""Recordings and replays, and going back through what happened."""

from donnie_tui.i18n.sentence import Sentence

SENTENCES: dict[str, Sentence] = {
    # --- the world of a recording
    "bundle-too-large": Sentence(
        "The world is too large for a recording: more than {limit} MB.",
        "O mundo é grande demais para uma gravação: mais de {limit} MB.",
        "El mundo es demasiado grande para una grabación: más de {limit} MB.",
    ),
    "bundle-damaged": Sentence(
        "The world in the recording is damaged.",
        "O mundo na gravação está danificado.",
        "El mundo en la grabación está dañado.",
    ),
    "bundle-incomplete": Sentence(
        "The world in the recording lacks {name}.",
        "Falta {name} no mundo da gravação.",
        "Falta {name} en el mundo de la grabación.",
    ),
    "bundle-unwritable": Sentence(
        "I can't unpack the world: {reason}.",
        "Não consigo desempacotar o mundo: {reason}.",
        "No puedo desempaquetar el mundo: {reason}.",
    ),
    # --- what must not be written
    "output-is-input": Sentence(
        "{option} would overwrite {path}, which is read here. Give another name.",
        "{option} sobrescreveria {path}, que é lido aqui. Dê outro nome.",
        "{option} sobrescribiría {path}, que se lee aquí. Da otro nombre.",
    ),
    "output-is-other": Sentence(
        "{option} would overwrite {path}, which is something else. Give another name.",
        "{option} sobrescreveria {path}, que é outra coisa. Dê outro nome.",
        "{option} sobrescribiría {path}, que es otra cosa. Da otro nombre.",
    ),
    "output-twice": Sentence(
        "{option} and {other} can't both write {path}. Give two names.",
        "{option} e {other} não podem gravar ambos em {path}. Dê dois nomes.",
        "{option} y {other} no pueden guardar ambos en {path}. Da dos nombres.",
    ),
    # --- what is wrong with a recording
    "no-recording": Sentence(
        "{path} is no recording.", "{path} não é uma gravação.", "{path} no es una grabación."
    ),
    "recording-too-large": Sentence(
        "{path} is too large for a recording.",
        "{path} é grande demais para uma gravação.",
        "{path} es demasiado grande para una grabación.",
    ),
    "damaged-line": Sentence(
        "Line {line} is damaged. The rest is told.",
        "A linha {line} está danificada. O resto é contado.",
        "La línea {line} está dañada. El resto se cuenta.",
    ),
    "damaged-header": Sentence(
        "Line {line}, the beginning, is damaged: there is no map.",
        "A linha {line}, o começo, está danificada: não há mapa.",
        "La línea {line}, el comienzo, está dañada: no hay mapa.",
    ),
    "damaged-newer": Sentence(
        "This recording is of a newer Donnie: there is no map, and some of it may be missing.",
        "Esta gravação é de um Donnie mais novo: não há mapa, e algo pode faltar.",
        "Esta grabación es de un Donnie más nuevo: no hay mapa, y puede faltar algo.",
    ),
    "damaged-no-header": Sentence(
        "The beginning is missing: there is no map.",
        "Falta o começo: não há mapa.",
        "Falta el comienzo: no hay mapa.",
    ),
    "damaged-missing": Sentence(
        "Before line {line}, {count} {count:event is|events are} missing.",
        "Antes da linha {line} {count:falta|faltam} {count} {count:evento|eventos}.",
        "Antes de la línea {line} {count:falta|faltan} {count} {count:evento|eventos}.",
    ),
    "damaged-end": Sentence(
        "The end of the recording is missing, from line {line} on.",
        "Falta o fim da gravação, a partir da linha {line}.",
        "Falta el final de la grabación, desde la línea {line}.",
    ),
    "damaged-too-many": Sentence(
        "The recording is too long. I read it up to line {line}.",
        "A gravação é longa demais. Li até a linha {line}.",
        "La grabación es demasiado larga. Leí hasta la línea {line}.",
    ),
    # --- telling it again
    "replay-no-such-event": Sentence(
        "There is no event {number}. The last one is {last}.",
        "Não há evento {number}. O último é {last}.",
        "No hay evento {number}. El último es {last}.",
    ),
    "replay-fixed": Sentence(
        "A replay tells what has happened: {option} does nothing here.",
        "Uma gravação conta o que aconteceu: {option} não faz nada aqui.",
        "Una grabación cuenta lo que pasó: {option} no hace nada aquí.",
    ),
    "options-not-together": Sentence(
        "{option} and {other} do not go together.",
        "{option} e {other} não combinam.",
        "{option} y {other} no van juntas.",
    ),
    "replay-steps": Sentence(
        "{events} {events:event|events}. Enter steps on, BACK steps back.",
        "{events} {events:evento|eventos}. Enter avança, VOLTAR volta.",
        "{events} {events:evento|eventos}. Enter avanza, VOLVER vuelve.",
    ),
    "replay-unknown-word": Sentence(
        "I do not know that word. HELP lists them.",
        "Não conheço essa palavra. AJUDA lista todas.",
        "No conozco esa palabra. AYUDA las lista.",
    ),
    "replay-end": Sentence("This is the end.", "Este é o fim.", "Este es el final."),
    "replay-speed": Sentence("Speed {speed}.", "Velocidade {speed}.", "Velocidad {speed}."),
    "replay-at": Sentence("Event {at} of {events}.", "Evento {at} de {events}.", "Evento {at} de {events}."),
    "replay-no-map": Sentence("There is no map here.", "Não há mapa aqui.", "Aquí no hay mapa."),
    "replay-map-of": Sentence("Map of {robot}.", "Mapa de {robot}.", "Mapa de {robot}."),
    "replay-word-next": Sentence(
        "a step on, as Enter alone", "um passo adiante, como só Enter", "un paso adelante, como solo Enter"
    ),
    "replay-word-back": Sentence("a step back", "um passo atrás", "un paso atrás"),
    "replay-word-go": Sentence(
        "on to the end, Ctrl+C holds", "até o fim, Ctrl+C segura", "hasta el final, Ctrl+C lo detiene"
    ),
    "replay-word-faster": Sentence("faster", "mais rápido", "más rápido"),
    "replay-word-slower": Sentence("slower", "mais devagar", "más lento"),
    "replay-word-where": Sentence("where each robot is", "onde está cada robô", "dónde está cada robot"),
    "replay-word-map": Sentence("the map as it was", "o mapa como era", "el mapa como era"),
    "replay-word-first": Sentence(
        "to the start; a number goes to that event",
        "para o começo; um número vai para esse evento",
        "al comienzo; un número va a ese evento",
    ),
    "replay-word-last": Sentence("to the end", "para o fim", "al final"),
    "replay-word-help": Sentence("these words", "estas palavras", "estas palabras"),
    "replay-word-quit": Sentence("leaves", "sai", "sale"),
    # --- running it again
    "recheck-same": Sentence(
        "Run again: {count} {count:event|events} alike.",
        "Executado de novo: {count} {count:evento igual|eventos iguais}.",
        "Ejecutado de nuevo: {count} {count:evento igual|eventos iguales}.",
    ),
    "recheck-different": Sentence(
        "Run again: line {line} differs.",
        "Executado de novo: a linha {line} é diferente.",
        "Ejecutado de nuevo: la línea {line} es diferente.",
    ),
    "recheck-stopped": Sentence(
        "Run again: the same up to line {line}, where it was stopped.",
        "Executado de novo: igual até a linha {line}, onde foi interrompido.",
        "Ejecutado de nuevo: igual hasta la línea {line}, donde se detuvo.",
    ),
    "recheck-overlapping": Sentence(
        "Run again: the same up to line {line}. There another robot was started by hand.",
        "Executado de novo: igual até a linha {line}. Ali outro robô foi iniciado à mão.",
        "Ejecutado de nuevo: igual hasta la línea {line}. Allí otro robot se inició a mano.",
    ),
    "recheck-then": Sentence("Then: {event}", "Antes: {event}", "Antes: {event}"),
    "recheck-now": Sentence("Now: {event}", "Agora: {event}", "Ahora: {event}"),
    "recheck-nothing": Sentence("nothing", "nada", "nada"),
    "recheck-version": Sentence(
        "It was recorded with version {then}; this is {now}.",
        "Foi gravado com a versão {then}; esta é {now}.",
        "Se grabó con la versión {then}; esta es {now}.",
    ),
    "recheck-damaged": Sentence(
        "The recording is damaged and can't be run again.",
        "A gravação está danificada e não pode ser executada de novo.",
        "La grabación está dañada y no se puede ejecutar de nuevo.",
    ),
    "recheck-real": Sentence(
        "It was made with the robot {robot} and can't be run again.",
        "Foi feita com o robô {robot} e não pode ser executada de novo.",
        "Se hizo con el robot {robot} y no se puede ejecutar de nuevo.",
    ),
    # --- the command line
    "usage-replay": Sentence(
        "Tell a recorded run again.",
        "Contar de novo uma execução gravada.",
        "Contar de nuevo una ejecución grabada.",
    ),
    "option-recording": Sentence("a recording", "uma gravação", "una grabación"),
    "option-backwards": Sentence("from the end", "a partir do fim", "desde el final"),
    "option-from": Sentence("begin with this event", "começar por este evento", "empezar por este evento"),
    "option-step": Sentence(
        "step by step, by typed words", "passo a passo, com palavras", "paso a paso, con palabras"
    ),
    "option-replay-map": Sentence(
        "the map at every movement", "o mapa a cada movimento", "el mapa en cada movimiento"
    ),
    "option-recheck": Sentence(
        "run it again and compare", "executar de novo e comparar", "ejecutar de nuevo y comparar"
    ),
    # --- going back
    "undone": Sentence("Back: {what}.", "De volta: {what}.", "Atrás: {what}."),
    "redone": Sentence("{what:capital}.", "{what:capital}.", "{what:capital}."),
    "undone-start": Sentence("This is the start.", "Este é o começo.", "Este es el comienzo."),
    "undone-position": Sentence("Position {x}, {y}.", "Posição {x}, {y}.", "Posición {x}, {y}."),
    "undone-facing": Sentence("Facing {facing}.", "Virado para {facing}.", "Mirando al {facing}."),
    "undone-waited": Sentence(
        "waited {seconds} {seconds:second|seconds}",
        "esperei {seconds} {seconds:segundo|segundos}",
        "esperé {seconds} {seconds:segundo|segundos}",
    ),
    "undone-error": Sentence("mistake in line {line}", "erro na linha {line}", "error en la línea {line}"),
    "undone-run-started": Sentence("start of {program}", "começo de {program}", "comienzo de {program}"),
    "undone-run-typed": Sentence("start of the program", "começo do programa", "comienzo del programa"),
    "undone-run-ended": Sentence("end of the program", "fim do programa", "fin del programa"),
    "undone-scanned": Sentence("looked around", "olhei em volta", "miré alrededor"),
    "undone-sound": Sentence("sound switched", "som mudado", "sonido cambiado"),
    "undone-link": Sentence("news of the line", "notícia da ligação", "noticia de la conexión"),
    "undone-gripper-gripped": Sentence("gripped", "peguei", "agarré"),
    "undone-gripper-released": Sentence("let go", "soltei", "solté"),
    "undone-gripper-nothing-there": Sentence("nothing gripped", "nada pego", "nada agarrado"),
    "undone-gripper-holds-already": Sentence("nothing gripped", "nada pego", "nada agarrado"),
    "undone-gripper-holds-nothing": Sentence("nothing let go", "nada solto", "nada soltado"),
    "undone-part-walk": Sentence("part of a walk", "parte de uma caminhada", "parte de una caminata"),
    "undone-part-turn": Sentence("part of a turn", "parte de um giro", "parte de un giro"),
    "undone-statement": Sentence(
        "beginning of line {line}", "começo da linha {line}", "comienzo de la línea {line}"
    ),
    "undone-read": Sentence("a sensor said {value}", "um sensor disse {value}", "un sensor dijo {value}"),
    "undone-cue": Sentence("a sound", "um som", "un sonido"),
    "undone-belt": Sentence("the belt changed", "o cinto mudou", "el cinturón cambió"),
    "undone-things": Sentence("things moved", "objetos movidos", "objetos movidos"),
    "undone-something": Sentence("a moment", "um momento", "un momento"),
    "undone-reset": Sentence("back to the start", "volta ao começo", "vuelta al comienzo"),
}
