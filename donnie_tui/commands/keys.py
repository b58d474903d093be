"""The keys of the commands in the full screen: which key runs which command, and what a key is called.

The learner's own choice is a text, ``run f9, step ctrl+k 5``: the name of a command and its key, both in
English. A key runs one command. Entries without a meaning are skipped. Letters, and keys that move in a text,
can't be given away, except letters after the menu key.
"""

from __future__ import annotations

from collections.abc import Mapping

from donnie_tui.commands.declarations import BY_NAME, COMMANDS
from language.locales import words

MENU = "ctrl+k"
"""Begins the keys of commands without a key of their own, such as Ctrl+K W, and lists them."""

PALETTE = "ctrl+p"
"""Lists every action."""

KEYS = {each.name: each.keys for each in COMMANDS}
"""The keys of each command, as Textual names them; the first one is shown."""


SIGNS = {
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


def after_menu(key: str) -> str:
    """The name of a key pressed after the menu key: a capital is its letter with Shift."""
    return f"shift+{key.lower()}" if len(key) == 1 and key.isupper() else key


def key_label(key: str, language: str) -> str:
    """What the key is called: ``F5``, ``Ctrl+S``, ``Esc``, ``Ctrl+K Shift+A``, ``Ctrl+K Mayús+A``.

    Many terminals send Ctrl+Space as what Textual calls ``ctrl+@``.
    """
    keys = key.replace("ctrl+@", "ctrl+space").split()
    return " ".join("+".join(_part_label(part, language) for part in each.split("+")) for each in keys)


def _part_label(part: str, language: str) -> str:
    """The name on keyboards of that language; Brazilian ones keep most English names."""
    if part in SIGNS:
        return SIGNS[part]
    try:
        return words(language, "words", "keyboard", part)[0]
    except KeyError:
        return part.title()


def keys_in_words(chosen: str, language: str) -> str:
    """The learner's own choice: each key and the word of its command."""
    from donnie_tui.commands.lookup import word_of

    pairs = understood(chosen)
    return ", ".join(f"{key_label(key, language)} {word_of(BY_NAME[name], language)}" for name, key in pairs)


# --- the learner's own keys

_OF_TEXTS = frozenset(
    (
        *("tab", "shift+tab", "enter", "up", "down", "left", "right", "home", "end", "pageup", "pagedown"),
        *("backspace", "delete", "space", "ctrl+c", PALETTE, MENU),
    )
)
"""Keys that every text field needs, and the two that stop and list everything."""

_LONGEST_KEY = 40


class KeyTable:
    """The keys of each command; one table for the whole screen, changed in place."""

    def __init__(self, chosen: str = "", *, has_terminal: bool = True) -> None:
        self._keys: dict[str, tuple[str, ...]] = {}
        self._has_terminal = has_terminal
        self.choose(chosen)

    def choose(self, chosen: str) -> None:
        """Apply a choice to the default keys, and forget the choice before."""
        keys = dict(KEYS)
        for name, key in understood(chosen):
            keys = {other: tuple(each for each in have if each != key) for other, have in keys.items()}
            keys[name] = (key, *keys[name])
        self._keys = {name: have for name, have in keys.items() if self.offers(name)}

    def offers(self, name: str) -> bool:
        """Whether a command is possible here; in a browser not all are."""
        return self._has_terminal or not BY_NAME[name].needs_terminal

    @property
    def all(self) -> Mapping[str, tuple[str, ...]]:
        """The keys by the names of their commands; the key that is shown comes first."""
        return self._keys

    def of(self, name: str) -> tuple[str, ...]:
        return self._keys.get(name, ())

    def label(self, name: str, language: str) -> str:
        """The name of the key that is shown; empty if there is none."""
        return next((key_label(each, language) for each in self.of(name)), "")

    def labels(self, name: str, language: str) -> str:
        """The names of all its keys, in one line."""
        return ", ".join(dict.fromkeys(key_label(each, language) for each in self.of(name)))

    def command_of(self, key: str) -> str | None:
        """The name of the command that the key runs."""
        return next((name for name, keys in self._keys.items() if key in keys), None)


def is_free_to_give(key: str) -> bool:
    """Whether a key may be given to a command: none that is needed to type."""
    menu, _blank, letter = key.rpartition(" ")
    if menu:
        return menu == MENU and 0 < len(letter) <= _LONGEST_KEY and letter != "escape"
    return 1 < len(key) <= _LONGEST_KEY and key not in _OF_TEXTS and ("+" in key or _is_function_key(key))


def _is_function_key(key: str) -> bool:
    return key in ("escape", "insert") or (key[:1] == "f" and key[1:].isdecimal())


def understood(chosen: str) -> tuple[tuple[str, str], ...]:
    """The valid pairs of a choice: a command, and a key that can be given to it."""
    pairs = (_pair(entry) for entry in chosen.split(","))
    return tuple((name, key) for name, key in pairs if name in KEYS and is_free_to_give(key))


def not_understood(chosen: str) -> tuple[str, ...]:
    """The invalid entries of a choice."""
    known = set(understood(chosen))
    return tuple(each.strip() for each in chosen.split(",") if each.strip() and _pair(each) not in known)


def with_key(chosen: str, name: str, key: str | None) -> str:
    """The choice with this key for the command; with None the command has only its default keys."""
    kept = [pair for pair in understood(chosen) if pair[0] != name and pair[1] != key]
    return ", ".join(" ".join(pair) for pair in ([*kept, (name, key)] if key else kept))


def _pair(entry: str) -> tuple[str, str]:
    name, _blank, key = entry.strip().lower().partition(" ")
    return name, " ".join(key.split())
