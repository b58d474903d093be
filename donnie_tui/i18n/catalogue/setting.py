"""The settings by name: ``setting-KEY`` is the name of one, ``value-KEY-VALUE`` one of its values."""

from donnie_tui.i18n.sentence import Sentence

_ON_OFF = (("on", "on", "ligado", "sí"), ("off", "off", "desligado", "no"))

_VALUES = {
    "theme": (
        ("dark", "dark", "escuro", "oscuro"),
        ("light", "light", "claro", "claro"),
        ("contrast", "high contrast", "alto contraste", "alto contraste"),
        ("terminal", "the terminal's own", "o do terminal", "el del terminal"),
    ),
    "lang": (
        ("en", "English", "inglês", "inglés"),
        ("pt", "Portuguese", "português", "portugués"),
        ("es", "Spanish", "espanhol", "español"),
    ),
    "verbosity": (
        ("brief", "brief", "breve", "breve"),
        ("normal", "normal", "normal", "normal"),
        ("full", "full", "completo", "completo"),
    ),
    "speech": (
        ("auto", "automatic", "automática", "automática"),
        ("off", "off", "desligada", "no"),
        ("tts", "own voice", "voz própria", "voz propia"),
        ("text", "text only", "só texto", "solo texto"),
        ("ssip", "speech-dispatcher", "speech-dispatcher", "speech-dispatcher"),
        ("robot", "at the robot", "no robô", "en el robot"),
    ),
    "motion": (("full", "full", "completo", "completo"), ("reduced", "reduced", "reduzido", "reducido")),
    "sound": _ON_OFF,
    "plain": _ON_OFF,
    "mouse": _ON_OFF,
    "completion": _ON_OFF,
}

SENTENCES: dict[str, Sentence] = {
    "setting-row": Sentence("{name}: {value}.", "{name}: {value}.", "{name}: {value}."),
    "setting-theme": Sentence("Look", "Aparência", "Aspecto"),
    "setting-lang": Sentence("Language", "Idioma", "Idioma"),
    "setting-verbosity": Sentence("Detail", "Detalhe", "Detalle"),
    "setting-speed": Sentence("Speed", "Velocidade", "Velocidad"),
    "setting-speech": Sentence("Voice", "Voz", "Voz"),
    "setting-sound": Sentence("Sound", "Som", "Sonido"),
    "setting-plain": Sentence("Plain layout", "Tela simples", "Pantalla sencilla"),
    "setting-motion": Sentence("Motion", "Movimento", "Movimiento"),
    "setting-mouse": Sentence("Mouse", "Mouse", "Ratón"),
    "setting-completion": Sentence("Completion", "Completar palavras", "Completar palabras"),
    "setting-keys": Sentence("Keys", "Teclas", "Teclas"),
    "setting-speed-wanted": Sentence(
        "A number from 0.1 to 1000, or max:",
        "Um número de 0,1 a 1000, ou max:",
        "Un número de 0,1 a 1000, o max:",
    ),
    "setting-keys-wanted": Sentence(
        "Actions and keys, such as run f9, step f10:",
        "Ações e teclas, como run f9, step f10:",
        "Acciones y teclas, como run f9, step f10:",
    ),
    **{
        f"value-{key}-{value}": Sentence(en, pt, es)
        for key, values in _VALUES.items()
        for value, en, pt, es in values
    },
}
