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
    # --- going back
    "undone": Sentence("Back: {what}.", "De volta: {what}.", "Atrás: {what}."),
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
    "undone-run-ended": Sentence("end of the program", "fim do programa", "fin del programa"),
    "undone-scanned": Sentence("looked around", "olhei em volta", "miré alrededor"),
    "undone-sound": Sentence("sound switched", "som mudado", "sonido cambiado"),
    "undone-link": Sentence("news of the line", "notícia da ligação", "noticia de la conexión"),
    "undone-gripped": Sentence("gripper closed", "garra fechada", "pinza cerrada"),
    "undone-released": Sentence("gripper opened", "garra aberta", "pinza abierta"),
    "undone-reset": Sentence("back to the start", "volta ao começo", "vuelta al comienzo"),
}
