"""What the full screen does of the use cases, and with which keys.

Words, arguments and purposes are the use cases' own (``core.use_cases``), the same as in the linear mode;
here are the keys. From here it reaches the keys, the bottom line, the palette, the help screen and the
command line. Short labels are sentences of the catalogue: ``key-NAME``.
"""

from __future__ import annotations

from devices.ports.values import frozen
from donnie_tui.core import use_cases
from donnie_tui.core.use_cases import USE_CASES, UseCase
from donnie_tui.core.view_cases import VIEW_CASES

MENU = "ctrl+k"
"""Before a letter: the key of what has none of its own. It lists those letters."""

KEYS: dict[str, tuple[str, ...]] = {
    "run": ("f5", "escape"),
    "again": (),
    "stop": ("f8",),
    "pause": ("f6",),
    "continue_": (),
    "step": ("f7",),
    "step_over": ("f9",),
    "step_back": ("ctrl+k k",),
    "run_to": ("f10",),
    "break_": ("ctrl+b",),
    "watch": (),
    "slower": ("f11",),
    "faster": ("f12",),
    "speed": (),
    "reset": ("ctrl+r",),
    "robots": (),
    "robot": (),
    "start": (),
    "together": (),
    "stop_all": ("ctrl+k full_stop",),
    "grip": (),
    "release": (),
    "connect": (),
    "feel": (),
    "open": ("ctrl+o", "f3"),
    "save": ("ctrl+s", "f2"),
    "save_as": ("ctrl+k s",),
    "new": ("ctrl+n",),
    "recover": (),
    "recent": ("ctrl+k e",),
    "programs": ("ctrl+k b",),
    "save_log": ("ctrl+k v",),
    "report": (),
    "open_log": ("ctrl+k g",),
    "undo": ("ctrl+z",),
    "redo": ("ctrl+y",),
    "read": (),
    "next": (),
    "back": (),
    "first": (),
    "last_line": (),
    "place": (),
    "up": ("ctrl+k u",),
    "down": ("ctrl+k d",),
    "next_same": (),
    "back_same": (),
    "outline": ("ctrl+l",),
    "list": (),
    "change": (),
    "insert": (),
    "delete": (),
    "move": (),
    "complete": ("ctrl+space", "ctrl+@"),
    "fix": ("ctrl+t",),
    "search": ("ctrl+f",),
    "search_again": ("ctrl+k f3",),
    "replace": ("ctrl+k r",),
    "go_to": ("ctrl+g",),
    "format": ("ctrl+k m",),
    "translate": ("ctrl+k x",),
    "error": (),
    "error_next": ("ctrl+k right_square_bracket",),
    "error_previous": ("ctrl+k left_square_bracket",),
    "errors": (),
    "explain": ("ctrl+k question_mark",),
    "last": (),
    "last_word": (),
    "spell": (),
    "find": (),
    "typed": (),
    "quiet": (),
    "cues": (),
    "where": ("ctrl+k i",),
    "around": ("ctrl+k j",),
    "map": (),
    "map_row": (),
    "map_column": (),
    "map_picture": (),
    "trail": (),
    "sensors": (),
    "world": (),
    "worlds": ("ctrl+k o",),
    "tour": (),
    "zoom_in": ("ctrl+k plus",),
    "zoom_out": ("ctrl+k minus",),
    "whole_map": ("ctrl+k a",),
    "names": ("ctrl+k t",),
    "coordinates": ("ctrl+k c",),
    "legend": ("ctrl+k l",),
    "next_thing": ("ctrl+k n",),
    "previous_thing": ("ctrl+k p",),
    "to_robot": ("ctrl+k h",),
    "from_here": ("ctrl+k f",),
    "to_there": ("ctrl+k w",),
    "show_program": ("ctrl+k 1",),
    "show_map": ("ctrl+k 2",),
    "show_log": ("ctrl+k 3",),
    "show_variables": ("f4",),
    "language": (),
    "detail": (),
    "set": (),
    "theme": ("ctrl+k y",),
    "plain": ("ctrl+k z",),
    "redraw": ("ctrl+k f5",),
    "settings": ("ctrl+k comma",),
    "change_keys": (),
    "keys_here": ("ctrl+k 0",),
    "help": ("f1",),
    "manual": ("ctrl+k f1",),
    "linear": ("ctrl+k q",),
    "visual": (),
    "quit": ("ctrl+q",),
}
"""Of each use case that the screen does, its keys as Textual names them; the first is shown."""


@frozen
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


CASES = USE_CASES + VIEW_CASES

ACTIONS = tuple(Action(each, () if each.hidden else KEYS[each.name]) for each in CASES if each.name in KEYS)
BY_NAME = {each.name: each for each in reversed(ACTIONS)}
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


_SIGNS = {
    "full_stop": ".",
    "plus": "+",
    "minus": "-",
    "comma": ",",
    "left_square_bracket": "[",
    "right_square_bracket": "]",
    "question_mark": "?",
}


def key_label(key: str) -> str:
    """The key as it is told: ``F5``, ``Ctrl+S``, ``Esc``, ``Ctrl+K A``.

    Many terminals send Ctrl+Space as what Textual calls ``ctrl+@``.
    """
    key = key.replace("ctrl+@", "ctrl+space")
    return " ".join("+".join(map(_part_label, each.split("+"))) for each in key.split())


def _part_label(part: str) -> str:
    return "Esc" if part == "escape" else _SIGNS.get(part, part.title())
