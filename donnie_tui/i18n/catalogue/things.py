"""What stands in the worlds that ship: a name for each kind of thing that their files make."""

from donnie_tui.i18n.sentence import Sentence

SENTENCES: dict[str, Sentence] = {
    "thing-chair": Sentence("chair", "cadeira", "silla"),
    "thing-table": Sentence("table", "mesa", "mesa"),
    "thing-small_sofa": Sentence("small sofa", "sofá pequeno", "sofá pequeño"),
    "thing-large_sofa": Sentence("large sofa", "sofá grande", "sofá grande"),
}
