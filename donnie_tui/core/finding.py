"""SEARCH in a program: the next place with a word, and once round. Size of letters and accents don't matter.

Rule: what is found is told as columns of the line as it was written, whatever was folded to compare it.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import chain

from devices.ports.values import Frozen
from donnie_tui.core.harmless import printable
from donnie_tui.core.wording import Wording
from language.source import MARK, fold, fold_name

LONGEST_TOLD = 40
"""Characters of a word that is told not to be there."""


NOTHING_INSTEAD = '""'
"""What is typed to delete a word everywhere."""


class Place(Frozen):
    """Where a word stands: its row and its columns, from 0, the last one not included."""

    row: int
    start: int
    end: int


def found_from(lines: Sequence[str], wanted: str, row: int, column: int = 0) -> Place | None:
    """The first place from there on; behind the last line it goes on with the first."""
    folded = fold_name(wanted)
    if not folded:
        return None
    here = [(row, column)] if row < len(lines) else []
    round_about = chain(range(row + 1, len(lines)), range(min(row + 1, len(lines))))
    order = chain(here, ((at, 0) for at in round_about))
    return next(filter(None, (_in_line(lines[at], folded, at, start) for at, start in order)), None)


def told(wanted: str) -> str:
    """The word as it is told."""
    return printable(wanted[:LONGEST_TOLD])


def replacement(typed: str | None) -> str | None:
    """What a word is to be replaced by; None for no answer and for Enter alone, which change nothing.

    Two quotes delete it: that is never typed by a slip.
    """
    return "" if typed == NOTHING_INSTEAD else typed or None


def not_found(wanted: str, wording: Wording) -> str:
    """That it stands nowhere."""
    return wording("screen-not-found", word=told(wanted))


def not_to_replace(lines: Sequence[str], wanted: str, wording: Wording) -> str:
    """That it stands nowhere, or nowhere as it was typed: REPLACE, unlike SEARCH, takes nothing else."""
    place = found_from(lines, wanted, 0)
    if place is None:
        return not_found(wanted, wording)
    written = told(lines[place.row][place.start : place.end])
    return wording("replace-otherwise", line=place.row + 1, word=written)


def _in_line(line: str, folded: str, row: int, column: int) -> Place | None:
    """Accents of their own take columns and are not compared."""
    if folded not in fold_name(line):
        return None
    columns = [at for at, character in enumerate(fold(line)) if character != MARK]
    skipped = sum(at < column for at in columns)
    at = fold_name(line).find(folded, skipped)
    if at < 0:
        return None
    behind = at + len(folded)
    return Place(row, columns[at], columns[behind] if behind < len(columns) else len(line))
