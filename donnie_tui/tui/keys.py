"""The keys of the full screen's actions, by their names, and how a key is told.

What the actions are for, the use cases say (``actions``); they are loaded behind the first frame, which needs
the keys alone.
"""

from __future__ import annotations

MENU = "ctrl+k"
"""Before a letter: the key of what has none of its own. It lists those letters."""

PALETTE = "ctrl+p"
"""Lists every action."""

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
