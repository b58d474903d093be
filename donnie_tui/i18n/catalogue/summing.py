"""What sums up movements that were told too fast, and what a movement ended at."""

from donnie_tui.i18n.sentence import Sentence

_MORE = {
    "more-steps": Sentence(
        "{steps} more {steps:step|steps}.",
        "Mais {steps} {steps:passo|passos}.",
        "{steps} {steps:paso|pasos} más.",
    ),
    "more-turns": Sentence("{turns} more turns.", "Mais {turns} giros.", "{turns} giros más."),
    "more-moves": Sentence(
        "{steps} more {steps:step|steps}, {turns} {turns:turn|turns}.",
        "Mais {steps} {steps:passo|passos}, {turns} {turns:giro|giros}.",
        "{steps} {steps:paso|pasos} y {turns} {turns:giro|giros} más.",
    ),
}

_MET = {
    "met": Sentence("{name:capital}, {where}.", "{name:capital}, {where}.", "{name:capital}, {where}."),
    "met-wall": Sentence("wall", "parede", "pared"),
    "met-something": Sentence("something", "algo", "algo"),
    "met-robot": Sentence("another robot", "outro robô", "otro robot"),
}

SENTENCES = _MORE | _MET
