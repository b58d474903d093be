"""The keys of the full screen's actions, by their names, and how a key is told.

What the actions are for, the use cases say (``actions``); they are loaded behind the first frame, which needs
the keys alone.
"""

from __future__ import annotations

from donnie_tui import LANGUAGES

MENU = "ctrl+k"
"""Before a letter, a letter with Shift or a sign: the key of what has none of its own. It lists them."""

PALETTE = "ctrl+p"
"""Lists every action."""

KEYS: dict[str, tuple[str, ...]] = {
    "run": ("f5", "escape"),
    "again": ("ctrl+k shift+a",),
    "stop": ("f8",),
    "pause": ("f6",),
    "continue_": ("ctrl+k shift+c",),
    "step": ("f7",),
    "step_over": ("f9",),
    "step_back": ("ctrl+k k",),
    "run_to": ("f10",),
    "break_": ("ctrl+b",),
    "watch": ("ctrl+k shift+w",),
    "slower": ("f11",),
    "faster": ("f12",),
    "speed": ("ctrl+k f11",),
    "reset": ("ctrl+r",),
    "robots": ("ctrl+k shift+r",),
    "robot": ("ctrl+k at",),
    "start": ("ctrl+k slash",),
    "together": ("ctrl+k shift+j",),
    "stop_all": ("ctrl+k full_stop",),
    "grip": ("ctrl+k shift+g",),
    "release": ("ctrl+k shift+u",),
    "connect": ("ctrl+k shift+o",),
    "feel": ("ctrl+k ampersand",),
    "open": ("ctrl+o", "f3"),
    "save": ("ctrl+s", "f2"),
    "save_as": ("ctrl+k s",),
    "new": ("ctrl+n",),
    "recover": ("ctrl+k shift+v",),
    "recent": ("ctrl+k e",),
    "programs": ("ctrl+k b",),
    "save_log": ("ctrl+k v",),
    "report": ("ctrl+k percent_sign",),
    "open_log": ("ctrl+k g",),
    "undo": ("ctrl+z",),
    "redo": ("ctrl+y",),
    "read": ("ctrl+k space",),
    "next": ("ctrl+k shift+n",),
    "back": ("ctrl+k shift+b",),
    "first": ("ctrl+k less_than_sign",),
    "last_line": ("ctrl+k greater_than_sign",),
    "place": ("ctrl+k shift+p",),
    "up": ("ctrl+k u",),
    "down": ("ctrl+k d",),
    "next_same": ("ctrl+k right_parenthesis",),
    "back_same": ("ctrl+k left_parenthesis",),
    "outline": ("ctrl+l",),
    "list": ("ctrl+k shift+l",),
    "change": ("ctrl+k shift+x",),
    "insert": ("ctrl+k shift+i",),
    "delete": ("ctrl+k shift+d",),
    "move": ("ctrl+k equals_sign",),
    "complete": ("ctrl+space", "ctrl+@"),
    "fix": ("ctrl+t",),
    "search": ("ctrl+f",),
    "search_again": ("ctrl+k f3",),
    "replace": ("ctrl+k r",),
    "go_to": ("ctrl+g",),
    "format": ("ctrl+k m",),
    "translate": ("ctrl+k x",),
    "error": ("ctrl+k shift+e",),
    "error_next": ("ctrl+k right_square_bracket",),
    "error_previous": ("ctrl+k left_square_bracket",),
    "errors": ("ctrl+k exclamation_mark",),
    "explain": ("ctrl+k question_mark",),
    "last": ("ctrl+k shift+h",),
    "last_word": ("ctrl+k quotation_mark",),
    "spell": ("ctrl+k shift+z",),
    "find": ("ctrl+k shift+f",),
    "typed": ("ctrl+k shift+y",),
    "quiet": ("ctrl+k shift+q",),
    "cues": ("ctrl+k asterisk",),
    "where": ("ctrl+k i",),
    "around": ("ctrl+k j",),
    "map": ("ctrl+k shift+m",),
    "map_row": ("ctrl+k underscore",),
    "map_column": ("ctrl+k colon",),
    "map_picture": ("ctrl+k number_sign",),
    "trail": ("ctrl+k 6",),
    "sensors": ("ctrl+k shift+s",),
    "world": ("ctrl+k 8",),
    "worlds": ("ctrl+k o",),
    "tour": ("ctrl+k shift+t",),
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
    "language": ("ctrl+k f2",),
    "detail": ("ctrl+k semicolon",),
    "set": ("ctrl+k dollar_sign",),
    "theme": ("ctrl+k y",),
    "plain": ("ctrl+k z",),
    "redraw": ("ctrl+k f5",),
    "settings": ("ctrl+k comma",),
    "change_keys": ("ctrl+k shift+k",),
    "keys_here": ("ctrl+k 0",),
    "help": ("f1",),
    "manual": ("ctrl+k f1",),
    "linear": ("ctrl+k q",),
    "visual": ("ctrl+k f4",),
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
    "left_parenthesis": "(",
    "right_parenthesis": ")",
    "less_than_sign": "<",
    "greater_than_sign": ">",
    "question_mark": "?",
    "exclamation_mark": "!",
    "quotation_mark": '"',
    "asterisk": "*",
    "number_sign": "#",
    "underscore": "_",
    "colon": ":",
    "semicolon": ";",
    "percent_sign": "%",
    "equals_sign": "=",
    "at": "@",
    "ampersand": "&",
    "slash": "/",
    "dollar_sign": "$",
}


def behind_menu(key: str) -> str:
    """A key that was pressed, as it is named behind the menu key: a capital is its letter with Shift."""
    return f"shift+{key.lower()}" if len(key) == 1 and key.isupper() else key


_NAMES = {
    "escape": ("Esc", "Esc", "Esc"),
    "shift": ("Shift", "Shift", "Mayús"),
    "space": ("Space", "Espaço", "Espacio"),
    "up": ("Up", "Seta acima", "Arriba"),
    "down": ("Down", "Seta abaixo", "Abajo"),
    "left": ("Left", "Seta esquerda", "Izquierda"),
    "right": ("Right", "Seta direita", "Derecha"),
    "home": ("Home", "Home", "Inicio"),
    "end": ("End", "End", "Fin"),
    "pageup": ("Page Up", "Page Up", "Re Pág"),
    "pagedown": ("Page Down", "Page Down", "Av Pág"),
    "backspace": ("Backspace", "Backspace", "Retroceso"),
    "delete": ("Delete", "Delete", "Supr"),
    "insert": ("Insert", "Insert", "Insert"),
}
"""As keyboards of these languages have them: Brazilian ones keep most English names."""


def key_label(key: str, language: str) -> str:
    """The key as it is told: ``F5``, ``Ctrl+S``, ``Esc``, ``Ctrl+K Shift+A``, ``Ctrl+K Mayús+A``.

    Many terminals send Ctrl+Space as what Textual calls ``ctrl+@``.
    """
    at, key = LANGUAGES.index(language), key.replace("ctrl+@", "ctrl+space")
    return " ".join("+".join(_part_label(part, at) for part in each.split("+")) for each in key.split())


def _part_label(part: str, at: int) -> str:
    return _NAMES[part][at] if part in _NAMES else _SIGNS.get(part, part.title())
