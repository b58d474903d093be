"""The command palette: every action, with its keys."""

from __future__ import annotations

from donnie_tui.core.wording import Wording
from donnie_tui.tui.actions import ACTIONS, Action
from donnie_tui.tui.key_table import KeyTable
from donnie_tui.tui.screens.chooser import Choice


def palette(words: Wording, table: KeyTable) -> tuple[str, str, str, tuple[Choice, ...]]:
    """What a chooser is given: title, keys, what is said where nothing fits, and the actions by name."""
    listed = (each for each in ACTIONS if not each.hidden)
    rows = tuple(Choice(each.name, _row(each, words, table)) for each in listed)
    return words("palette-ask"), words("chooser-keys"), words("palette-nothing"), rows


def _row(action: Action, words: Wording, table: KeyTable) -> str:
    label = table.label(action.name, words.language)
    keys = f" ({label})" if label else ""
    return f"{action.word(words.language)}{keys}: {words(f'action-{action.name}')}"
