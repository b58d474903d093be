"""What stands in the worlds that ship: a name for each kind of thing, and how its colour agrees with it.

A noun's gender is that of Portuguese and of Spanish; English has one article for all.
"""

from donnie_tui.i18n.sentence import Sentence

_NOUNS: dict[str, tuple[Sentence, str, str]] = {
    "chair": (Sentence("chair", "cadeira", "silla"), "f", "f"),
    "table": (Sentence("table", "mesa", "mesa"), "f", "f"),
    "small_sofa": (Sentence("small sofa", "sofá pequeno", "sofá pequeño"), "m", "m"),
    "large_sofa": (Sentence("large sofa", "sofá grande", "sofá grande"), "m", "m"),
    "box": (Sentence("box", "caixa", "caja"), "f", "f"),
    "ball": (Sentence("ball", "bola", "pelota"), "f", "f"),
    "cone": (Sentence("cone", "cone", "cono"), "m", "m"),
    "post": (Sentence("post", "poste", "poste"), "m", "m"),
    "flower": (Sentence("flower", "flor", "flor"), "f", "f"),
    "stone": (Sentence("stone", "pedra", "piedra"), "f", "f"),
    "crystal": (Sentence("crystal", "cristal", "cristal"), "m", "m"),
    "orange": (Sentence("orange", "laranja", "naranja"), "f", "f"),
    "carton": (Sentence("juice carton", "caixinha de suco", "cartón de zumo"), "f", "m"),
    "belt": (Sentence("conveyor belt", "esteira", "cinta transportadora"), "f", "f"),
}

SENTENCES: dict[str, Sentence] = {
    **{f"thing-{kind}": noun for kind, (noun, _, _) in _NOUNS.items()},
    **{f"gender-{kind}": Sentence("m", pt, es) for kind, (_, pt, es) in _NOUNS.items()},
    "gender-colour": Sentence("m", "f", "m"),
    "article-m": Sentence("the", "o", "el"),
    "article-f": Sentence("the", "a", "la"),
    "colour-red-f": Sentence("red", "vermelha", "roja"),
    "colour-green-f": Sentence("green", "verde", "verde"),
    "colour-blue-f": Sentence("blue", "azul", "azul"),
    "colour-yellow-f": Sentence("yellow", "amarela", "amarilla"),
    "colour-orange-f": Sentence("orange", "laranja", "naranja"),
    "colour-pink-f": Sentence("pink", "rosa", "rosa"),
    "colour-gray-f": Sentence("gray", "cinza", "gris"),
    "colour--f": Sentence("unknown", "desconhecida", "desconocida"),
    "listed-coloured": Sentence("{name}, {colour}", "{name} {colour}", "{name} {colour}"),
    "listed-one-colour": Sentence("{name}", "{name}", "{name}"),
    "the-one-colour": Sentence("{the} {name}", "{the} {name}", "{the} {name}"),
    "listed-coloured-foreign": Sentence(
        "{name}, {colour}", "{name} de cor {colour}", "{name} de color {colour}"
    ),
    "own-name": Sentence("{name}, {thing}", "{name}, {thing}", "{name}, {thing}"),
    "the-coloured": Sentence("{the} {colour} {name}", "{the} {name} {colour}", "{the} {name} {colour}"),
    "the-coloured-foreign": Sentence(
        "{name} of color {colour}", "{name} de cor {colour}", "{name} de color {colour}"
    ),
    # --- things that a robot moves
    "pushed": Sentence(
        "I pushed {thing} {steps} {steps:step|steps}.",
        "Empurrei {thing} {steps} {steps:passo|passos}.",
        "Empujé {thing} {steps} {steps:paso|pasos}.",
    ),
    "pushed-little": Sentence(
        "I pushed {thing} a little.", "Empurrei {thing} um pouco.", "Empujé {thing} un poco."
    ),
    "pushed-more": Sentence(
        "I pushed {count} more {count:thing|things}.",
        "Empurrei mais {count} {count:objeto|objetos}.",
        "Empujé {count} {count:objeto|objetos} más.",
    ),
}
