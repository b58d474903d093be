"""Which key does what just now: those of the table, with those that somebody chose in their place.

A choice is a text, ``run f9, step ctrl+k 5``: the action's name and its key, by their English names. Rules: a
key does one thing; what is not understood is passed over and can be told; keys that are letters, or that move
in a text, can't be given away, but for letters behind the menu key.
"""

from __future__ import annotations

from collections.abc import Mapping

from donnie_tui.tui.keys import KEYS, MENU, PALETTE, key_label

_OF_TEXTS = frozenset(
    (
        *("tab", "shift+tab", "enter", "up", "down", "left", "right", "home", "end", "pageup", "pagedown"),
        *("backspace", "delete", "space", "ctrl+c", PALETTE, MENU),
    )
)
"""They go on, write and move wherever the focus is; two of them stop and list everything."""

_LONGEST_KEY = 40


class KeyTable:
    """The keys of each action; one table for the whole screen, changed in place."""

    def __init__(self, chosen: str = "") -> None:
        self._keys: dict[str, tuple[str, ...]] = {}
        self.choose(chosen)

    def choose(self, chosen: str) -> None:
        """Those of the choice from now on, and no earlier one."""
        keys = dict(KEYS)
        for name, key in understood(chosen):
            keys = {other: tuple(each for each in have if each != key) for other, have in keys.items()}
            keys[name] = (key, *keys[name])
        self._keys = keys

    @property
    def all(self) -> Mapping[str, tuple[str, ...]]:
        """By the names of the actions, the key that is shown first."""
        return self._keys

    def of(self, name: str) -> tuple[str, ...]:
        return self._keys.get(name, ())

    def label(self, name: str, language: str) -> str:
        """The key that is shown, as it is told; empty where there is none."""
        return next((key_label(each, language) for each in self.of(name)), "")

    def labels(self, name: str, language: str) -> str:
        """All of them."""
        return ", ".join(dict.fromkeys(key_label(each, language) for each in self.of(name)))

    def action_of(self, key: str) -> str | None:
        """What that key does."""
        return next((name for name, keys in self._keys.items() if key in keys), None)


def is_free_to_give(key: str) -> bool:
    """Whether a key may be given to an action: none that is needed to type."""
    menu, _blank, letter = key.rpartition(" ")
    if menu:
        return menu == MENU and 0 < len(letter) <= _LONGEST_KEY and letter != "escape"
    return 1 < len(key) <= _LONGEST_KEY and key not in _OF_TEXTS and ("+" in key or _is_function_key(key))


def _is_function_key(key: str) -> bool:
    return key in ("escape", "insert") or (key[:1] == "f" and key[1:].isdecimal())


def understood(chosen: str) -> tuple[tuple[str, str], ...]:
    """The pairs of a choice that mean something: an action, and a key that can be given to it."""
    pairs = (_pair(entry) for entry in chosen.split(","))
    return tuple((name, key) for name, key in pairs if name in KEYS and is_free_to_give(key))


def not_understood(chosen: str) -> tuple[str, ...]:
    """The entries of a choice that mean nothing."""
    known = set(understood(chosen))
    return tuple(each.strip() for each in chosen.split(",") if each.strip() and _pair(each) not in known)


def with_choice(chosen: str, name: str, key: str | None) -> str:
    """A choice in which that action has this key; with None it has none but its own."""
    kept = [pair for pair in understood(chosen) if pair[0] != name and pair[1] != key]
    return ", ".join(" ".join(pair) for pair in ([*kept, (name, key)] if key else kept))


def _pair(entry: str) -> tuple[str, str]:
    name, _blank, key = entry.strip().lower().partition(" ")
    return name, " ".join(key.split())
