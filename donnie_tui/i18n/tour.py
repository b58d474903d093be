"""TOUR, page by page: Donnie in five minutes. ``tour-1-2`` of the catalogue is the second line of page 1."""

from __future__ import annotations

from donnie_tui.i18n.words import Words

PAGES = 9
_MOST_LINES = 6


def page(number: int, words: Words) -> tuple[str, ...]:
    """The lines of one page, from 1."""
    codes = (f"tour-{number}-{line}" for line in range(1, _MOST_LINES + 1))
    return tuple(words(each) for each in codes if words.knows(each))


def tour(words: Words) -> tuple[str, ...]:
    """All pages."""
    return tuple(line for number in range(1, PAGES + 1) for line in page(number, words))
