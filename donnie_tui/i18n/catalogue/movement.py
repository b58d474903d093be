"""What the robot did, where it is and what it sees. The manual's own sentences are kept where it has them."""

from donnie_tui.i18n.sentence import Sentence

_STEPS_EN = "{steps} {steps:step|steps}"
_STEPS_PT = "{steps} {steps:passo|passos}"
_STEPS_ES = "{steps} {steps:paso|pasos}"
_DEGREES_EN = "{degrees} {degrees:degree|degrees}"
_DEGREES_PT = "{degrees} {degrees:grau|graus}"
_DEGREES_ES = "{degrees} {degrees:grado|grados}"

_REASONS = {
    "obstacle": ("I found an obstacle.", "Encontrei um obstáculo.", "Encontré un obstáculo."),
    "collision": ("I hit something.", "Bati em alguma coisa.", "Choqué con algo."),
    "stopped": ("I was stopped.", "Fui interrompido.", "Me detuvieron."),
}

_WALKS = {
    "forward": ("forward", "para frente", "hacia adelante"),
    "backward": ("backward", "para trás", "hacia atrás"),
}
_TURNS = {
    "right": ("to the right", "para a direita", "a la derecha"),
    "left": ("to the left", "para a esquerda", "a la izquierda"),
}


def _walked(way: tuple[str, str, str]) -> Sentence:
    en, pt, es = way
    return Sentence(
        f"I walked {_STEPS_EN} {en}.",
        f"Andei {_STEPS_PT} {pt}.",
        f"Caminé {_STEPS_ES} {es}.",
        brief=(f"{_STEPS_EN} {en}.", f"{_STEPS_PT} {pt}.", f"{_STEPS_ES} {es}."),
    )


def _walked_only(way: tuple[str, str, str], reason: tuple[str, str, str]) -> Sentence:
    (en, pt, es), (why_en, why_pt, why_es) = way, reason
    return Sentence(
        f"I walked only {_STEPS_EN} {en}. {why_en}",
        f"Andei só {_STEPS_PT} {pt}. {why_pt}",
        f"Caminé solo {_STEPS_ES} {es}. {why_es}",
        brief=(f"Only {_STEPS_EN}. {why_en}", f"Só {_STEPS_PT}. {why_pt}", f"Solo {_STEPS_ES}. {why_es}"),
    )


def _turned(way: tuple[str, str, str]) -> Sentence:
    en, pt, es = way
    return Sentence(
        f"I turned {_DEGREES_EN} {en}.",
        f"Girei {_DEGREES_PT} {pt}.",
        f"Giré {_DEGREES_ES} {es}.",
        brief=(f"{_DEGREES_EN} {en}.", f"{_DEGREES_PT} {pt}.", f"{_DEGREES_ES} {es}."),
    )


def _turned_only(way: tuple[str, str, str], reason: tuple[str, str, str]) -> Sentence:
    (en, pt, es), (why_en, why_pt, why_es) = way, reason
    return Sentence(
        f"I turned only {_DEGREES_EN} {en}. {why_en}",
        f"Girei só {_DEGREES_PT} {pt}. {why_pt}",
        f"Giré solo {_DEGREES_ES} {es}. {why_es}",
        brief=(
            f"Only {_DEGREES_EN}. {why_en}",
            f"Só {_DEGREES_PT}. {why_pt}",
            f"Solo {_DEGREES_ES}. {why_es}",
        ),
    )


def _movements() -> dict[str, Sentence]:
    sentences: dict[str, Sentence] = {}
    for code, way in _WALKS.items():
        sentences[f"walked-{code}"] = _walked(way)
        sentences |= {f"walked-{code}-{why}": _walked_only(way, text) for why, text in _REASONS.items()}
    for code, way in _TURNS.items():
        sentences[f"turned-{code}"] = _turned(way)
        sentences |= {f"turned-{code}-{why}": _turned_only(way, text) for why, text in _REASONS.items()}
    return sentences


_OBJECTS_EN = "{count} {count:object|objects} of color {colours} at " + _STEPS_EN + "."
_OBJECTS_PT = "{count} {count:objeto|objetos} de cor {colours} a " + _STEPS_PT + "."
_OBJECTS_ES = "{count} {count:objeto|objetos} de color {colours} a " + _STEPS_ES + "."
_BRIEF = "{colours}, {steps}."

SENTENCES: dict[str, Sentence] = _movements() | {
    "scan-left": Sentence(
        f"To the {_DEGREES_EN} in the left: {_OBJECTS_EN}",
        f"A {_DEGREES_PT} à esquerda: {_OBJECTS_PT}",
        f"A {_DEGREES_ES} a la izquierda: {_OBJECTS_ES}",
        brief=(
            "{degrees} left: " + _BRIEF,
            "{degrees} à esquerda: " + _BRIEF,
            "{degrees} a la izquierda: " + _BRIEF,
        ),
    ),
    "scan-right": Sentence(
        f"To the {_DEGREES_EN} in the right: {_OBJECTS_EN}",
        f"A {_DEGREES_PT} à direita: {_OBJECTS_PT}",
        f"A {_DEGREES_ES} a la derecha: {_OBJECTS_ES}",
        brief=(
            "{degrees} right: " + _BRIEF,
            "{degrees} à direita: " + _BRIEF,
            "{degrees} a la derecha: " + _BRIEF,
        ),
    ),
    "scan-ahead": Sentence(
        f"Ahead: {_OBJECTS_EN}",
        f"À frente: {_OBJECTS_PT}",
        f"Al frente: {_OBJECTS_ES}",
        brief=("Ahead: " + _BRIEF, "À frente: " + _BRIEF, "Al frente: " + _BRIEF),
    ),
    "scan-nothing": Sentence("I see no objects.", "Não vejo nenhum objeto.", "No veo ningún objeto."),
    "no-movement": Sentence(
        "No command executed, position [{x},{y},{heading}].",
        "Nenhum comando executado, posição [{x},{y},{heading}].",
        "Ningún comando ejecutado, posición [{x},{y},{heading}].",
        brief=(
            "No command, [{x},{y},{heading}].",
            "Nenhum comando, [{x},{y},{heading}].",
            "Ningún comando, [{x},{y},{heading}].",
        ),
    ),
    "movement-walked": Sentence(
        "Command {number} was {command}, walked {done}, {crashed}, position [{x},{y},{heading}].",
        "O comando {number} foi {command}, andou {done}, {crashed}, posição [{x},{y},{heading}].",
        "El comando {number} fue {command}, caminó {done}, {crashed}, posición [{x},{y},{heading}].",
        brief=(
            "{command}, walked {done}, {crashed}, [{x},{y},{heading}].",
            "{command}, andou {done}, {crashed}, [{x},{y},{heading}].",
            "{command}, caminó {done}, {crashed}, [{x},{y},{heading}].",
        ),
    ),
    "movement-turned": Sentence(
        "Command {number} was {command}, turned {done}, {crashed}, position [{x},{y},{heading}].",
        "O comando {number} foi {command}, girou {done}, {crashed}, posição [{x},{y},{heading}].",
        "El comando {number} fue {command}, giró {done}, {crashed}, posición [{x},{y},{heading}].",
        brief=(
            "{command}, turned {done}, {crashed}, [{x},{y},{heading}].",
            "{command}, girou {done}, {crashed}, [{x},{y},{heading}].",
            "{command}, giró {done}, {crashed}, [{x},{y},{heading}].",
        ),
    ),
    "crashed": Sentence("crashed", "bateu", "chocó"),
    "not-crashed": Sentence("didn't crash", "não bateu", "no chocó"),
    "position": Sentence(
        "Position {x}, {y}. Facing {facing}.",
        "Posição {x}, {y}. Virado para {facing}.",
        "Posición {x}, {y}. Mirando al {facing}.",
    ),
    "facing-between": Sentence(
        "{degrees} {degrees:degree|degrees}, near {point}",
        "{degrees} {degrees:grau|graus}, perto do {point}",
        "rumbo {degrees}, cerca del {point}",
    ),
    "compass-north": Sentence("north", "norte", "norte"),
    "compass-northeast": Sentence("northeast", "nordeste", "noreste"),
    "compass-east": Sentence("east", "leste", "este"),
    "compass-southeast": Sentence("southeast", "sudeste", "sureste"),
    "compass-south": Sentence("south", "sul", "sur"),
    "compass-southwest": Sentence("southwest", "sudoeste", "suroeste"),
    "compass-west": Sentence("west", "oeste", "oeste"),
    "compass-northwest": Sentence("northwest", "noroeste", "noroeste"),
    "sound-on": Sentence("Sound on.", "Som ligado.", "Sonido encendido."),
    "sound-off": Sentence("Sound off.", "Som desligado.", "Sonido apagado."),
    "belt-on": Sentence("Belt on.", "Cinto ligado.", "Cinturón encendido."),
    "belt-off": Sentence("Belt off.", "Cinto desligado.", "Cinturón apagado."),
    "waiting": Sentence(
        "Waiting {seconds} {seconds:second|seconds}.",
        "Esperando {seconds} {seconds:segundo|segundos}.",
        "Esperando {seconds} {seconds:segundo|segundos}.",
    ),
    "overwritten": Sentence(
        "{name} existed already. It is new now.",
        "{name} já existia. Agora é novo.",
        "{name} ya existía. Ahora es nuevo.",
    ),
    "link-connected": Sentence("Robot connected.", "Robô conectado.", "Robot conectado."),
    "link-lost": Sentence(
        "Robot lost. If it drives, switch it off.",
        "Perdi o robô. Se ele andar, desligue-o.",
        "Perdí el robot. Si se mueve, apágalo.",
    ),
    "link-restored": Sentence("Robot is back.", "O robô voltou.", "El robot volvió."),
    "colour-red": Sentence("red", "vermelho", "rojo"),
    "colour-green": Sentence("green", "verde", "verde"),
    "colour-blue": Sentence("blue", "azul", "azul"),
    "colour-yellow": Sentence("yellow", "amarelo", "amarillo"),
    "colour-orange": Sentence("orange", "laranja", "naranja"),
    "colour-pink": Sentence("pink", "rosa", "rosa"),
    "colour-": Sentence("unknown", "desconhecida", "desconocido"),  # what a robot without a camera meets
    "colour-gray": Sentence("gray", "cinza", "gris"),
}
