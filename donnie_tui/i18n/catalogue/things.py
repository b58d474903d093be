"""What stands in the worlds that ship: a name for each kind of thing that their files make."""

from donnie_tui.i18n.sentence import Sentence

SENTENCES: dict[str, Sentence] = {
    "thing-chair": Sentence("chair", "cadeira", "silla"),
    "thing-table": Sentence("table", "mesa", "mesa"),
    "thing-small_sofa": Sentence("small sofa", "sofá pequeno", "sofá pequeño"),
    "thing-large_sofa": Sentence("large sofa", "sofá grande", "sofá grande"),
    "thing-box": Sentence("box", "caixa", "caja"),
    "thing-ball": Sentence("ball", "bola", "pelota"),
    "thing-cone": Sentence("cone", "cone", "cono"),
    "thing-post": Sentence("post", "poste", "poste"),
    "thing-flower": Sentence("flower", "flor", "flor"),
    "thing-stone": Sentence("stone", "pedra", "piedra"),
    "thing-crystal": Sentence("crystal", "cristal", "cristal"),
    "thing-orange": Sentence("orange", "laranja", "naranja"),
    "thing-carton": Sentence("juice carton", "caixinha de suco", "cartón de zumo"),
    "thing-belt": Sentence("conveyor belt", "esteira", "cinta transportadora"),
}
