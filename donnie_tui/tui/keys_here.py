"""What can be pressed where the focus is, in words: ``here-PANE-N`` of the catalogue, and actions."""

from __future__ import annotations

from donnie_tui.commands.keys import KeyTable
from donnie_tui.i18n.words import Words
from donnie_tui.tui.screens.workplace import Workplace

MOST_LINES = 9

_ACTIONS = {
    "program": ("run", "step", "break_", "complete", "fix", "search", "outline", "undo", "save"),
    "map": ("where", "around"),
    "variables": ("show_variables", "feel"),
    "log": ("open_log", "find", "save_log"),
    "command": ("typed", "run"),
}
"""The use cases that are near at hand in each pane."""
_EVERYWHERE = ("stop", "keys_here", "help", "quit")


def keys_here(place: Workplace, words: Words, table: KeyTable) -> tuple[str, ...]:
    """A heading, then a line each."""
    pane = _pane(place)
    codes = (f"here-{pane}-{number}" for number in range(1, MOST_LINES + 1))
    own = (words(code) for code in codes if words.knows(code))
    names = (*_ACTIONS[pane], *_EVERYWHERE)
    actions = (
        words("here-key", keys=table.labels(name, words.language), purpose=words(f"action-{name}"))
        for name in names
        if table.of(name)
    )
    return (words(f"here-{pane}"), *own, *actions, words("here-tab"))


def _pane(place: Workplace) -> str:
    """The pane of the focus; the program where there is none."""
    if place.map.has_focus:
        return "map"
    if place.inspector.has_focus:
        return "variables"
    if place.log_rows.has_focus:
        return "log"
    return "command" if place.command_line.has_focus else "program"
