"""QUIET, CUES and the settings of voice and cues. In both modes the same."""

from donnie_tui.i18n.sentence import Sentence

_VALUES = {
    "speak": (
        ("here", "here", "aqui", "aquí"),
        ("robot", "at the robot", "no robô", "en el robot"),
        ("both", "here and there", "aqui e lá", "aquí y allá"),
    ),
    "punctuation": (
        ("none", "none", "nenhuma", "ninguna"),
        ("some", "some", "alguma", "alguna"),
        ("all", "all", "toda", "toda"),
    ),
    "wait_for_speech": (("on", "on", "sim", "sí"), ("off", "off", "não", "no")),
}

_OF_THE_SCREEN = {
    "setting-speak": Sentence("SPEAK is heard", "FALAR se ouve", "HABLAR se oye"),
    "setting-rate": Sentence("Words a minute", "Palavras por minuto", "Palabras por minuto"),
    "setting-pitch": Sentence("Pitch of the voice", "Tom da voz", "Tono de la voz"),
    "setting-volume": Sentence("Volume of the voice", "Volume da voz", "Volumen de la voz"),
    "setting-punctuation": Sentence("Signs that are said", "Pontuação que é dita", "Puntuación que se dice"),
    "setting-wait_for_speech": Sentence(
        "Programs wait for the voice", "Programas esperam a voz", "Los programas esperan la voz"
    ),
    "setting-rate-wanted": Sentence(
        "A number from 80 to 450:", "Um número de 80 a 450:", "Un número de 80 a 450:"
    ),
    **{
        f"setting-{key}-wanted": Sentence(
            "A number from 0 to 100:", "Um número de 0 a 100:", "Un número de 0 a 100:"
        )
        for key in ("pitch", "volume")
    },
    **{
        f"value-{key}-{value}": Sentence(en, pt, es)
        for key, values in _VALUES.items()
        for value, en, pt, es in values
    },
}

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
    **_OF_THE_SCREEN,
}
