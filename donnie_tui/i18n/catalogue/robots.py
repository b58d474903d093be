"""Robots: several in one world, what one can't do, the gripper.

``problem-CODE`` tells a ``RobotProblem`` of that code.
"""

from donnie_tui.i18n.sentence import Sentence

_CUT_SHORT = {
    "stall": ("My wheels are stuck.", "Minhas rodas travaram.", "Mis ruedas no giran."),
    "link": ("I lost the line.", "Perdi a ligação.", "Perdí la conexión."),
}
"""What ends the movements of a real robot only."""


def _cut_short() -> dict[str, Sentence]:
    sentences: dict[str, Sentence] = {}
    for why, (en, pt, es) in _CUT_SHORT.items():
        walked = Sentence(
            f"Only {{steps}} {{steps:step|steps}}. {en}",
            f"Só {{steps}} {{steps:passo|passos}}. {pt}",
            f"Solo {{steps}} {{steps:paso|pasos}}. {es}",
        )
        turned = Sentence(
            f"Only {{degrees}} {{degrees:degree|degrees}}. {en}",
            f"Só {{degrees}} {{degrees:grau|graus}}. {pt}",
            f"Solo {{degrees}} {{degrees:grado|grados}}. {es}",
        )
        sentences |= {f"walked-{way}-{why}": walked for way in ("forward", "backward")}
        sentences |= {f"turned-{side}-{why}": turned for side in ("right", "left")}
    return sentences


SENTENCES: dict[str, Sentence] = _cut_short() | {
    "robot-says": Sentence("{robot}: {text}", "{robot}: {text}", "{robot}: {text}"),
    # --- what a robot can't do
    "problem-no-sensor": Sentence(
        "I have no sensor {where}.", "Não tenho sensor {where}.", "No tengo sensor {where}."
    ),
    "problem-no-eyes": Sentence(
        "I have no eyes: I see no colors.",
        "Não tenho olhos: não vejo cores.",
        "No tengo ojos: no veo colores.",
    ),
    "problem-no-camera": Sentence(
        "I have no camera: I see no colors.",
        "Não tenho câmera: não vejo cores.",
        "No tengo cámara: no veo colores.",
    ),
    "problem-no-gripper": Sentence("I have no gripper.", "Não tenho garra.", "No tengo pinza."),
    "problem-cannot-drive": Sentence("I can't move.", "Não consigo andar.", "No puedo moverme."),
    "problem-cannot-turn": Sentence(
        "I can't turn on the spot.", "Não consigo girar no lugar.", "No puedo girar en el lugar."
    ),
    "problem-link-lost": Sentence(
        "The line to the robot is lost.",
        "A ligação com o robô caiu.",
        "Se perdió la conexión con el robot.",
    ),
    "remedy-switch-off": Sentence(
        "If a robot drives, switch it off.",
        "Se um robô andar, desligue-o.",
        "Si un robot se mueve, apágalo.",
    ),
    # --- the gripper
    "gripper-gripped": Sentence("I hold {thing}.", "Estou segurando {thing}.", "Tengo {thing}."),
    "gripper-gripped-something": Sentence("I hold it.", "Peguei.", "Lo tengo."),
    "gripper-released": Sentence("I let go of {thing}.", "Soltei {thing}.", "Solté {thing}."),
    "gripper-released-something": Sentence("I let go.", "Soltei.", "Solté."),
    "gripper-nothing-there-something": Sentence(
        "There is nothing to grip.", "Não há nada para pegar.", "No hay nada para agarrar."
    ),
    "gripper-holds-already": Sentence(
        "I hold {thing} already.", "Já estou segurando {thing}.", "Ya tengo {thing}."
    ),
    "gripper-holds-already-something": Sentence(
        "I hold something already.", "Já estou segurando algo.", "Ya tengo algo."
    ),
    "gripper-holds-nothing-something": Sentence(
        "I hold nothing.", "Não estou segurando nada.", "No tengo nada."
    ),
    # --- several at once
    "robot-unknown": Sentence(
        "There is no robot {name} here. There {count:is|are} {names}.",
        "Não há robô {name} aqui. Há {names}.",
        "No hay ningún robot {name} aquí. Hay {names}.",
        brief=(
            "No robot {name}. There {count:is|are} {names}.",
            "Não há {name}. Há {names}.",
            "No hay {name}. Hay {names}.",
        ),
    ),
    "robot-twice": Sentence(
        "The robot {name} has two programs. One is enough.",
        "O robô {name} tem dois programas. Basta um.",
        "El robot {name} tiene dos programas. Basta uno.",
    ),
    "robots-need-names": Sentence(
        "Which robot runs {file}? Write ROBOT={file}.",
        "Que robô executa {file}? Escreva ROBÔ={file}.",
        "¿Qué robot ejecuta {file}? Escribe ROBOT={file}.",
    ),
    "robots-one-input": Sentence(
        "Only one robot can take its program from standard input.",
        "Só um robô pode ler seu programa da entrada padrão.",
        "Solo un robot puede leer su programa de la entrada estándar.",
    ),
    "robot-chosen": Sentence("You talk to {name}.", "Você fala com {name}.", "Hablas con {name}."),
    "robot-now-idle": Sentence(
        "No robot runs anything.", "Nenhum robô está em ação.", "Ningún robot está en marcha."
    ),
    "robot-all-stopped": Sentence("All stopped.", "Todos parados.", "Todos detenidos."),
    "robot-no-programs": Sentence(
        "No robot has a program yet. START gives it one.",
        "Nenhum robô tem programa. INICIAR dá um.",
        "Ningún robot tiene programa. INICIAR da uno.",
        brief=(
            "No programs yet. START gives one.",
            "Nenhum programa. INICIAR dá um.",
            "Ningún programa. INICIAR da uno.",
        ),
    ),
    "robot-started": Sentence("{name} begins.", "{name} começa.", "{name} empieza."),
    "robot-busy": Sentence("{name} is busy.", "{name} está ocupado.", "{name} está ocupado."),
    "holds-up": Sentence(
        "The others wait for {name}: it computes and does not move. Ctrl+C stops all.",
        "Os outros esperam por {name}: calcula e não anda. Ctrl+C para todos.",
        "Los demás esperan a {name}: calcula y no se mueve. Ctrl+C detiene todo.",
        brief=(
            "All wait for {name}. Ctrl+C stops it.",
            "Esperam por {name}. Ctrl+C para todos.",
            "Esperan a {name}. Ctrl+C detiene todo.",
        ),
    ),
    "robot-listed": Sentence(
        "{name}: {x}, {y}, facing {facing}.",
        "{name}: {x}, {y}, virado para {facing}.",
        "{name}: {x}, {y}, mirando al {facing}.",
    ),
    "robot-listed-running": Sentence(
        "{name} runs: {x}, {y}, facing {facing}.",
        "{name} em ação: {x}, {y}, virado para {facing}.",
        "{name} en marcha: {x}, {y}, mirando al {facing}.",
    ),
    "robots-more": Sentence("And {count} more.", "E mais {count}.", "Y {count} más."),
    # --- what the words are for
    "help-typed-robot": Sentence("bob", "bob", "bob"),
    "key-robots": Sentence("Robots", "Robôs", "Robots"),
    "key-robot": Sentence("Talk to", "Falar com", "Hablar con"),
    "key-start": Sentence("Start", "Iniciar", "Iniciar"),
    "key-together": Sentence("Together", "Juntos", "Juntos"),
    "key-stop_all": Sentence("Stop all", "Parar tudo", "Detener todo"),
    "key-grip": Sentence("Grip", "Pegar", "Agarrar"),
    "key-release": Sentence("Release", "Soltar", "Soltar"),
    "action-robots": Sentence("Who is here.", "Quem está aqui.", "Quién está aquí."),
    "action-robot": Sentence("Talks to bob from now on.", "Fala agora com o bob.", "Habla ahora con bob."),
    "action-start": Sentence("Runs; you can type on.", "Executa sem esperar.", "Ejecuta sin esperar."),
    "action-together": Sentence("All robots run.", "Todos os robôs andam.", "Andan todos los robots."),
    "action-stop_all": Sentence("Stops all robots.", "Para todos os robôs.", "Detiene a todos."),
    "action-grip": Sentence("Closes the gripper.", "Fecha a garra.", "Cierra la pinza."),
    "action-release": Sentence("Opens the gripper.", "Abre a garra.", "Abre la pinza."),
    "robots-only-one": Sentence(
        "There is one robot, {name}.", "Há um robô só, {name}.", "Hay un solo robot, {name}."
    ),
}
