"""Where a program can hold: BREAK at an END, or at a line of words for people, would never hold.

Both front ends set breakpoints by it.
"""

from __future__ import annotations

from collections.abc import Callable

from donnie_tui.core.wording import Wording
from language.parser import Parsed
from language.syntax import walk

LARGEST = 100_000
"""Characters of a program that is read to find where its commands begin."""


def holding_line(text: str, line: int, parse: Callable[[str], Parsed]) -> int | None:
    """Where a program holds that is to hold at ``line``: there, or at the next command; None behind the last.

    ``parse`` reads GoDonnie. A program with mistakes, or a long one, may hold anywhere.
    """
    program = parse(text).program if len(text) <= LARGEST else None
    if program is None:
        return line
    lines = {each.span.line for each in walk(program.body)}
    return min((each for each in lines if each >= line), default=None)


def toggled(
    breakpoints: frozenset[int], line: int, text: str, parse: Callable[[str], Parsed]
) -> tuple[frozenset[int], int | None]:
    """The breakpoints after BREAK with ``line``, and which line that was about."""
    if line in breakpoints:
        return breakpoints - {line}, line
    at = holding_line(text, line, parse)
    return (breakpoints if at is None else breakpoints | {at}), at


def told_elsewhere(line: int, at: int | None, wording: Wording) -> tuple[str, ...]:
    """That nothing holds at ``line``, where it is ``at`` another one or nowhere."""
    return () if at == line else (wording("break-nowhere", line=line),)
