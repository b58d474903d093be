"""Signs by name: a screen reader may leave a lone sign out, so sentences name it."""

from donnie_tui.i18n.sentence import Sentence

CODE_OF = {
    "=": "sign-equals",
    "==": "sign-double-equals",
    "<>": "sign-different",
    "<": "sign-less",
    ">": "sign-greater",
    "<=": "sign-less-or-equal",
    ">=": "sign-greater-or-equal",
    "+": "sign-plus",
    "-": "sign-minus",
    "*": "sign-star",
    "/": "sign-slash",
    "(": "sign-opening-parenthesis",
    ")": "sign-closing-parenthesis",
    "[": "sign-opening-bracket",
    "]": "sign-closing-bracket",
    ",": "sign-comma",
    ":": "sign-colon",
    ";": "sign-semicolon",
    ".": "sign-full-stop",
    "!": "sign-exclamation",
    "?": "sign-question",
    "#": "sign-hash",
    "$": "sign-dollar",
    "%": "sign-percent",
    "&": "sign-ampersand",
    "@": "sign-at",
    "'": "sign-apostrophe",
    "’": "sign-apostrophe",
    "‘": "sign-apostrophe",
    '"': "sign-quote",
    "“": "sign-quote",
    "”": "sign-quote",
    "\\": "sign-backslash",
    "_": "sign-underscore",
    "^": "sign-caret",
    "`": "sign-grave",
    "{": "sign-opening-brace",
    "}": "sign-closing-brace",
    "|": "sign-bar",
    "~": "sign-tilde",
}

_NAMES: dict[str, Sentence] = {
    "sign-equals": Sentence("an equals sign", "um sinal de igual", "un signo igual"),
    "sign-double-equals": Sentence("two equals signs", "dois sinais de igual", "dos signos igual"),
    "sign-different": Sentence("the sign different", "o sinal diferente", "el signo distinto"),
    "sign-less": Sentence("a less sign", "um sinal de menor", "un signo menor"),
    "sign-greater": Sentence("a greater sign", "um sinal de maior", "un signo mayor"),
    "sign-less-or-equal": Sentence(
        "the sign less or equal", "o sinal menor ou igual", "el signo menor o igual"
    ),
    "sign-greater-or-equal": Sentence(
        "the sign greater or equal", "o sinal maior ou igual", "el signo mayor o igual"
    ),
    "sign-plus": Sentence("a plus sign", "um sinal de mais", "un signo más"),
    "sign-minus": Sentence("a minus sign", "um sinal de menos", "un signo menos"),
    "sign-star": Sentence("a star", "um asterisco", "un asterisco"),
    "sign-slash": Sentence("a slash", "uma barra", "una barra"),
    "sign-opening-parenthesis": Sentence(
        "an opening parenthesis", "um abre parênteses", "un paréntesis que abre"
    ),
    "sign-closing-parenthesis": Sentence(
        "a closing parenthesis", "um fecha parênteses", "un paréntesis que cierra"
    ),
    "sign-opening-bracket": Sentence("an opening bracket", "um abre colchetes", "un corchete que abre"),
    "sign-closing-bracket": Sentence("a closing bracket", "um fecha colchetes", "un corchete que cierra"),
    "sign-comma": Sentence("a comma", "uma vírgula", "una coma"),
    "sign-colon": Sentence("a colon", "dois-pontos", "dos puntos"),
    "sign-semicolon": Sentence("a semicolon", "um ponto e vírgula", "un punto y coma"),
    "sign-full-stop": Sentence("a full stop", "um ponto", "un punto"),
    "sign-exclamation": Sentence("an exclamation mark", "um ponto de exclamação", "un signo de exclamación"),
    "sign-question": Sentence("a question mark", "um ponto de interrogação", "un signo de interrogación"),
    "sign-hash": Sentence("a hash sign", "uma cerquilha", "una almohadilla"),
    "sign-dollar": Sentence("a dollar sign", "um cifrão", "un signo de dólar"),
    "sign-percent": Sentence("a percent sign", "um sinal de porcentagem", "un signo de porcentaje"),
    "sign-ampersand": Sentence("an ampersand", "um e comercial", "un signo et"),
    "sign-at": Sentence("an at sign", "uma arroba", "una arroba"),
    "sign-apostrophe": Sentence("an apostrophe", "um apóstrofo", "un apóstrofo"),
    "sign-quote": Sentence("a quotation mark", "aspas", "comillas"),
    "sign-backslash": Sentence("a backslash", "uma barra invertida", "una barra invertida"),
    "sign-underscore": Sentence("an underscore", "um sublinhado", "un guion bajo"),
    "sign-caret": Sentence("a caret", "um circunflexo", "un circunflejo"),
    "sign-grave": Sentence("a grave accent", "um acento grave", "un acento grave"),
    "sign-opening-brace": Sentence("an opening brace", "um abre chaves", "una llave que abre"),
    "sign-closing-brace": Sentence("a closing brace", "um fecha chaves", "una llave que cierra"),
    "sign-bar": Sentence("a vertical bar", "uma barra vertical", "una barra vertical"),
    "sign-tilde": Sentence("a tilde", "um til", "una tilde"),
    "sign-other": Sentence("the character {sign}", "o caractere {sign}", "el carácter {sign}"),
}

_ARTICLES = ("an ", "a ", "uma ", "um ", "una ", "un ")


def _bare(name: str) -> str:
    """Without its article: among letters that are spelled it would only take time."""
    article = next((each for each in _ARTICLES if name.startswith(each)), "")
    return name.removeprefix(article)


def _spelled(name: Sentence) -> Sentence:
    return Sentence(_bare(name.en), _bare(name.pt), _bare(name.es))


SPELLED_OF = {sign: code.replace("sign-", "spell-") for sign, code in CODE_OF.items() if len(sign) == 1}
"""How each sign is called where it is spelled."""

SENTENCES: dict[str, Sentence] = _NAMES | {
    code: _spelled(_NAMES[CODE_OF[sign]]) for sign, code in SPELLED_OF.items()
}
