"""How the linear mode behaves, as far as that can be chosen: SET says it, changes it and keeps it.

Every habit has a name and its values in three languages; in the settings file stand the English ones. The
first value of each is the default.
"""

from __future__ import annotations

from collections.abc import Mapping
from enum import Enum

from devices.ports.values import Mutable, field_names
from donnie_tui.core.typed_words import SWITCH, switched
from donnie_tui.i18n.first_words import PROMPT
from donnie_tui.settings.chosen import Settings
from donnie_tui.settings.readers import LONGEST_PROGRESS
from language.source import fold_name


class Page(Enum):
    """What comes between two screenfuls of an answer."""

    REST = "rest"
    ASK = "ask"
    OFF = "off"


class Prompt(Enum):
    """What stands before the line that is typed."""

    SHORT = "short"
    NONE = "none"
    WORD = "word"
    ANSWER = "answer"
    """The last line of the answer, so that the cursor of a braille display stays on it."""


class Habits(Mutable):
    """What is chosen now."""

    page: Page = Page.REST
    prompt: Prompt = Prompt.SHORT
    hold: bool = False
    """Each line of an answer waits for Enter."""
    editor: bool = True
    """Lines are edited by us; else by the terminal, and nothing but text is ever written."""
    enter: bool = False
    """Enter runs each complete line at once."""
    progress: int = 10
    """Seconds between two signs of life of a run; 0 is never."""
    clock: bool = False
    """Directions as on a clock face."""
    free: str = ""
    """The letter of a free square in a picture; empty is a full stop."""

    def prompt_at(self, depth: int) -> str:
        """What stands before a line that is typed inside so many blocks."""
        level = str(depth) if depth else ""
        match self.prompt:
            case Prompt.NONE:
                return ""
            case Prompt.WORD:
                return f"{f'Donnie {level}'.strip()}{PROMPT}"
            case _:
                return f"{level}{PROMPT}"


SPELLINGS: dict[str, tuple[tuple[str, str, str], Mapping[object, tuple[str, str, str]]]] = {
    "page": (
        ("page", "página", "página"),
        {
            Page.REST: ("rest", "pausa", "pausa"),
            Page.ASK: ("ask", "perguntar", "preguntar"),
            Page.OFF: ("off", "nada", "nada"),
        },
    ),
    "prompt": (
        ("prompt", "convite", "indicador"),
        {
            Prompt.SHORT: ("short", "curto", "corto"),
            Prompt.NONE: ("none", "nenhum", "ninguno"),
            Prompt.WORD: ("word", "palavra", "palabra"),
            Prompt.ANSWER: ("answer", "resposta", "respuesta"),
        },
    ),
    "hold": (("hold", "segurar", "retener"), SWITCH),
    "editor": (
        ("editor", "editor", "editor"),
        {True: ("own", "próprio", "propio"), False: ("plain", "simples", "simple")},
    ),
    "enter": (
        ("enter", "enter", "enter"),
        {False: ("waits", "espera", "espera"), True: ("runs", "executa", "ejecuta")},
    ),
    "progress": (("progress", "progresso", "progreso"), {}),
    "clock": (("clock", "relógio", "reloj"), SWITCH),
    "free": (("free", "livre", "libre"), {"": ("dot", "ponto", "punto")}),
}


def find(typed: str) -> str | None:
    """The field that a name of any language means."""
    folded = fold_name(typed)
    return next((field for field, (names, _) in SPELLINGS.items() if folded in map(fold_name, names)), None)


def read(field: str, typed: str) -> object:
    """The value that a word of any language, or a number, or a letter, means. Raises ``ValueError``."""
    folded, is_on = fold_name(typed), switched(typed)
    if is_on is not None and SPELLINGS[field][1] is SWITCH:
        return is_on
    for value, words in SPELLINGS[field][1].items():
        if folded in map(fold_name, words):
            return value
    if field == "progress" and typed.isdecimal() and int(typed) <= LONGEST_PROGRESS:
        return int(typed)
    if field == "free" and len(typed) == 1 and typed.isalpha() and typed.isascii():
        return typed
    raise ValueError(typed)


def spelled(field: str, value: object, at: int) -> str:
    """A value as it is typed in the language number ``at``."""
    words = SPELLINGS[field][1].get(value)
    return words[at] if words else str(value)


def choices(field: str, at: int) -> str:
    """The values that there are, as they are typed."""
    words = [each[at] for each in SPELLINGS[field][1].values()]
    return ", ".join(words + (["0 10 60"] if field == "progress" else ["f"] if field == "free" else []))


def of_settings(settings: Settings) -> Habits:
    """What the settings say; they were read, so every value is one of those that there are."""
    habits = Habits()
    for name in field_names(Habits):
        setattr(habits, name, read(name, getattr(settings, name)))
    return habits


def kept_as(field: str, value: object) -> str:
    """How the settings file has a value: the English word."""
    return spelled(field, value, 0)
