"""How much room text takes on a terminal, and where it wraps.

A cluster is what one key deletes and one arrow passes: a character with the marks on it. Characters
joined into one emoji count as one cluster, two cells wide.
"""

from __future__ import annotations

import unicodedata

_JOINER = "\u200d"


def clusters(text: str) -> list[str]:
    """The text cut into clusters."""
    found: list[str] = []
    for character in text:
        if found and (_is_mark(character) or found[-1].endswith(_JOINER)):
            found[-1] += character
        else:
            found.append(character)
    return found


def width(cluster: str) -> int:
    """Cells that a cluster fills: 2 if it is wide, 0 if it is but a mark."""
    if unicodedata.east_asian_width(cluster[0]) in "WF":
        return 2
    return 0 if _is_mark(cluster[0]) else 1


def places(row: int, column: int, text: list[str], columns: int) -> list[tuple[int, int]]:
    """Where each cluster stands, as row and column, and where the next one would.

    The text begins at ``column`` of ``row``; a wide cluster that does not fit moves to the next row.
    """
    found: list[tuple[int, int]] = []
    for cluster in text:
        cells = width(cluster)
        if column + cells > columns:
            row, column = row + 1, 0
        found.append((row, column))
        column += cells
    if column >= columns:
        row, column = row + 1, 0
    return [*found, (row, column)]


def _is_mark(character: str) -> bool:
    return (
        character == _JOINER
        or unicodedata.category(character) in ("Mn", "Me")
        or "\ufe00" <= character <= "\ufe0f"
    )
