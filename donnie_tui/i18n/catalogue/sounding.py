"""QUIET, CUES and the settings of voice and cues. In both modes the same."""

from donnie_tui.i18n.sentence import Sentence

SENTENCES: dict[str, Sentence] = {
    "action-quiet": Sentence("Ends what is being said.", "Cala a voz.", "Calla la voz."),
    "action-cues": Sentence("Plays the sounds.", "Toca os sons.", "Toca los sonidos."),
    "help-typed-cue": Sentence("bump", "colisão", "choque"),
    "quiet": Sentence(
        "Quiet. LAST says it again.",
        "Silêncio. ÚLTIMO repete.",
        "Silencio. ÚLTIMO lo repite.",
    ),
    "cues-count": Sentence(
        "{count} sounds. Any key ends them.",
        "{count} sons. Uma tecla encerra.",
        "{count} sonidos. Una tecla los corta.",
    ),
    "cues-line": Sentence("{name}: {meaning}", "{name}: {meaning}", "{name}: {meaning}"),
    "cues-unknown": Sentence(
        "No sound {name}. CUES lists all.",
        "Não há o som {name}. SINAIS diz todos.",
        "No hay el sonido {name}. SEÑALES los dice.",
        brief=("No sound {name}.", "Não há o som {name}.", "No hay el sonido {name}."),
    ),
    "sound-setting": Sentence("Set {name}: {value}.", "Ajuste {name}: {value}.", "Ajuste {name}: {value}."),
    "sound-setting-cue": Sentence(
        "Set {name} {cue}: {value}.", "Ajuste {name} {cue}: {value}.", "Ajuste {name} {cue}: {value}."
    ),
}
