"""TOUR, page by page: Donnie in five minutes. ``tour-1-2`` of the catalogue is the second line of page 1.

The full screen has pages of its own, ``screen-tour-1-2``: other keys and other panes, the same robot.
"""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

from donnie_tui.i18n.words import Words

PAGES = 9
SCREEN_PAGES = 9
_MOST_LINES = 6


def page(number: int, words: Words) -> tuple[str, ...]:
    """The lines of one page, from 1."""
    return _lines(f"tour-{number}", words)


def screen_page(number: int, words: Words, keys: Mapping[str, str]) -> tuple[str, ...]:
    """The lines of one page of the full screen; ``keys`` as they are told, by what they do."""
    return _lines(f"screen-tour-{number}", words, keys)


def _lines(page: str, words: Words, keys: Mapping[str, str] = MappingProxyType({})) -> tuple[str, ...]:
    codes = (f"{page}-{line}" for line in range(1, _MOST_LINES + 1))
    return tuple(words(each, **keys) for each in codes if words.knows(each))
