"""Everything that the full screen can do, declared once: name, keys, typed words.

From here it reaches the keys, the bottom line, the command palette, the help screen and the command line.
Purposes and short labels are sentences of the catalogue: ``action-NAME`` and ``key-NAME``.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

from donnie_tui.i18n.sentence import LANGUAGES


@dataclass(frozen=True, slots=True)
class Action:
    """One thing that can be done."""

    name: str
    keys: tuple[str, ...]
    """As Textual names them; the first is shown."""
    en: str
    pt: str
    es: str
    argument: str = ""
    """What may follow the word: ``file``, ``line`` or ``speed``; empty if nothing may."""
    required: bool = False
    """Whether the word means nothing without its argument."""
    hidden: bool = False
    """The word is GoDonnie's own, or a second word for the same: not listed again."""

    def word(self, language: str) -> str:
        """What is typed for it; empty where there is a key only."""
        return (self.en, self.pt, self.es)[LANGUAGES.index(language)]


ACTIONS = (
    Action("run", ("f5", "escape"), "RUN", "EXECUTAR", "EJECUTAR"),
    Action("stop", ("f8",), "STOP", "PARAR", "DETENER"),
    Action("pause", ("f6",), "PAUSE", "PAUSAR", "PAUSAR"),
    Action("continue_", (), "CONTINUE", "CONTINUAR", "CONTINUAR"),
    Action("step", ("f7",), "STEP", "PASSO", "PASO"),
    Action("step_over", ("f9",), "OVER", "PASSO INTEIRO", "PASO ENTERO"),
    Action("run_to", ("f10",), "UNTIL", "ATÉ", "HASTA", argument="line"),
    Action("slower", ("f11",), "SLOWER", "MAIS DEVAGAR", "MÁS LENTO"),
    Action("faster", ("f12",), "FASTER", "MAIS RÁPIDO", "MÁS RÁPIDO"),
    Action("speed", (), "SPEED", "VELOCIDADE", "VELOCIDAD", argument="speed", required=True),
    Action("reset", ("ctrl+r",), "RESET", "REINICIAR", "REINICIAR"),
    Action("where", (), "WHERE", "ONDE", "DÓNDE"),
    Action("open", ("ctrl+o", "f3"), "OPEN", "ABRIR", "ABRIR", argument="file"),
    Action("save", ("ctrl+s", "f2"), "SAVE", "SALVAR", "GUARDAR", argument="file"),
    Action("save_as", (), "SAVE AS", "SALVAR COMO", "GUARDAR COMO", argument="file"),
    Action("new", ("ctrl+n",), "NEW", "NOVO", "NUEVO"),
    Action("recover", (), "RECOVER", "RECUPERAR", "RECUPERAR"),
    Action("show_program", (), "SHOW PROGRAM", "MOSTRAR PROGRAMA", "MOSTRAR PROGRAMA"),
    Action("show_map", (), "SHOW MAP", "MOSTRAR MAPA", "MOSTRAR MAPA"),
    Action("show_log", (), "SHOW LOG", "MOSTRAR REGISTRO", "MOSTRAR REGISTRO"),
    Action("show_variables", ("f4",), "SHOW VARIABLES", "MOSTRAR VARIÁVEIS", "MOSTRAR VARIABLES"),
    Action("help", ("f1",), "HELP", "AJUDA", "AYUDA"),
    Action("linear", (), "LINEAR", "LINEAR", "LINEAL"),
    Action("quit", ("ctrl+q",), "QUIT", "SAIR", "SALIR"),
    Action("quit", (), "EXIT", "SAIR", "SALIR", hidden=True),
)

BY_NAME = {each.name: each for each in reversed(ACTIONS)}


def find(typed: str) -> tuple[Action, str] | None:
    """The action that a typed line asks for, in any language, and its argument; None if it is no action.

    ``speed = 3`` and ``open [2]`` are GoDonnie's: a learner may call a variable or procedure as we call
    an action.
    """
    words, by_word = typed.split(), _by_word()
    longest = max(len(word.split()) for word in by_word)
    for length in range(min(longest, len(words)), 0, -1):
        action = by_word.get(_folded(" ".join(words[:length])))
        if action is not None:
            argument = typed.strip().split(maxsplit=length)[length:]
            return _with_argument(action, argument[0] if argument else "")
    return None


def _with_argument(action: Action, argument: str) -> tuple[Action, str] | None:
    if argument.startswith(("=", "[")) or (argument and not action.argument):
        return None
    return action, argument


@cache
def _by_word() -> dict[str, Action]:
    return {_folded(each.word(language)): each for each in reversed(ACTIONS) for language in LANGUAGES}


def _folded(word: str) -> str:
    """As the language compares words. Loaded when first needed: the keys are there before the words are."""
    from language.source import fold_name

    return fold_name(word)


def key_label(key: str) -> str:
    """The key as it is told: ``F5``, ``Ctrl+S``, ``Esc``."""
    return key.replace("escape", "Esc").replace("ctrl+", "Ctrl+").title().replace("Ctrl+", "Ctrl+")
