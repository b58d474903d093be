"""What the full screen does of the use cases, and with which keys.

Words, arguments and purposes are the use cases' own (``core.use_cases``), the same as in the linear mode;
here are the keys. From here it reaches the keys, the bottom line, the palette, the help screen and the
command line. Short labels are sentences of the catalogue: ``key-NAME``.
"""

from __future__ import annotations

from dataclasses import dataclass

from donnie_tui.core import use_cases
from donnie_tui.core.use_cases import USE_CASES, UseCase

KEYS: dict[str, tuple[str, ...]] = {
    "run": ("f5", "escape"),
    "stop": ("f8",),
    "pause": ("f6",),
    "continue_": (),
    "step": ("f7",),
    "step_over": ("f9",),
    "run_to": ("f10",),
    "slower": ("f11",),
    "faster": ("f12",),
    "speed": (),
    "reset": ("ctrl+r",),
    "where": (),
    "connect": (),
    "feel": (),
    "open": ("ctrl+o", "f3"),
    "save": ("ctrl+s", "f2"),
    "save_as": (),
    "new": ("ctrl+n",),
    "recover": (),
    "show_program": (),
    "show_map": (),
    "show_log": (),
    "show_variables": ("f4",),
    "help": ("f1",),
    "linear": (),
    "quit": ("ctrl+q",),
}
"""Of each use case that the screen does, its keys as Textual names them; the first is shown."""


@dataclass(frozen=True, slots=True)
class Action:
    """A use case with its keys."""

    case: UseCase
    keys: tuple[str, ...]

    @property
    def name(self) -> str:
        return self.case.name

    @property
    def en(self) -> str:
        return self.case.en

    @property
    def argument(self) -> str:
        """What may follow the word; empty if nothing may."""
        return self.case.argument

    @property
    def required(self) -> bool:
        """Whether it means nothing without its argument: there is no sense in choosing it from a list."""
        return self.case.required or self.case.name == "speed"

    @property
    def hidden(self) -> bool:
        return self.case.hidden

    def word(self, language: str) -> str:
        """What is typed for it."""
        return self.case.word(language)


ACTIONS = tuple(
    Action(each, () if each.hidden else KEYS[each.name]) for each in USE_CASES if each.name in KEYS
)
BY_NAME = {each.name: each for each in reversed(ACTIONS)}
_BY_CASE = {each.case: each for each in ACTIONS}


def find(typed: str) -> tuple[Action, str] | None:
    """The action that a typed line asks for, in any language, and its argument; None if it is no action."""
    found = use_cases.find(typed)
    if found is None:
        return None
    case, argument = found
    takes_argument = bool(case.argument) and not case.is_godonnie
    if case not in _BY_CASE or (argument and not takes_argument):
        return None
    return _BY_CASE[case], argument


def key_label(key: str) -> str:
    """The key as it is told: ``F5``, ``Ctrl+S``, ``Esc``."""
    return key.replace("escape", "Esc").replace("ctrl+", "Ctrl+").title().replace("Ctrl+", "Ctrl+")
