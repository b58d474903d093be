"""What the full screen does of the use cases, and with which keys.

Words, arguments and purposes are the use cases' own (``core.use_cases``), the same as in the linear mode;
the keys are in ``keys``. From here it reaches the bottom line, the palette, the help screen and the command
line. Short labels are sentences of the catalogue: ``key-NAME``.
"""

from __future__ import annotations

from devices.ports.values import Frozen
from donnie_tui import LANGUAGES
from donnie_tui.core import use_cases
from donnie_tui.core.use_cases import USE_CASES, UseCase
from donnie_tui.core.view_cases import VIEW_CASES
from donnie_tui.tui.keys import KEYS

_ASK_THEMSELVES = ("replace", "translate", "robot")
"""Without what must stand behind their words they ask for it, in more than one step or by a list."""


class Action(Frozen):
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
    def needs_asking(self) -> bool:
        """Whether a key for it means nothing until what stands behind its word is asked for."""
        return self.name == "speed" or (self.case.required and self.name not in _ASK_THEMSELVES)

    @property
    def hidden(self) -> bool:
        return self.case.hidden

    def word(self, language: str) -> str:
        """What is typed for it."""
        return self.case.word(language)


CASES = USE_CASES + VIEW_CASES

ACTIONS = tuple(Action(each, () if each.hidden else KEYS[each.name]) for each in CASES if each.name in KEYS)
BY_NAME = {each.name: each for each in reversed(ACTIONS)}
FIRST_WORDS = {
    BY_NAME[name].word(language).casefold(): name
    for name in ("linear", "tour", "recover")
    for language in LANGUAGES
}
"""What the first lines of the log ask for, and the action of each."""

_BY_CASE = {each.case: each for each in ACTIONS}
DONE_HERE = tuple(_BY_CASE)
"""The use cases that the screen does."""


def find(typed: str) -> tuple[Action, str] | None:
    """The action that a typed line asks for, in any language, and what stands behind its word; None if none.

    Behind a word of GoDonnie's own, what stands there is GoDonnie's too.
    """
    found = use_cases.find(typed, CASES)
    if found is None:
        return None
    case, argument = found
    if case not in _BY_CASE or (argument and case.is_godonnie):
        return None
    return _BY_CASE[case], argument
