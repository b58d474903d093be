"""What the linear mode says before anything else is loaded. Imports nothing; the catalogue has it from here.

A cause is how the linear mode came about: ``option``, ``variable`` (DONNIE_LINEAR or ACCESSIBLE),
``settings``, ``no-terminal``, ``simple-terminal`` (TERM=dumb) or ``word`` (LINEAR was typed).
"""

CAUSES = {
    "option": (
        "Linear mode, from the option.",
        "Modo linear, pela opção.",
        "Modo lineal, por la opción.",
    ),
    "variable": (
        "Linear mode, from the environment.",
        "Modo linear, pelo ambiente.",
        "Modo lineal, por el entorno.",
    ),
    "settings": (
        "Linear mode, from the settings.",
        "Modo linear, pelas configurações.",
        "Modo lineal, por los ajustes.",
    ),
    "no-terminal": (
        "Linear mode, without a terminal.",
        "Modo linear, sem um terminal.",
        "Modo lineal, sin un terminal.",
    ),
    "simple-terminal": (
        "Linear mode, for this terminal.",
        "Modo linear, por este terminal.",
        "Modo lineal, por este terminal.",
    ),
    "word": (
        "Linear mode, from the word.",
        "Modo linear, pela palavra.",
        "Modo lineal, por la palabra.",
    ),
}

HINT = ("HELP lists the commands.", "AJUDA lista os comandos.", "AYUDA lista los comandos.")

TOUR = (
    "New here? TOUR shows you around.",
    "Primeira vez? PASSEIO mostra tudo.",
    "¿Primera vez? PASEO te muestra todo.",
)
"""At the first start, once, in the place of the hint: no more than two lines come before a prompt."""

RESCUED = (
    "A program was rescued. RECOVER opens it.",
    "Programa resgatado. RECUPERAR o abre.",
    "Programa rescatado. RECUPERAR lo abre.",
)
"""In the place of the hint, too, where a crash left a program."""

PROMPT = "> "
