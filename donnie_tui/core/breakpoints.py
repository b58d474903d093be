"""Breakpoints: lines of a program, from 1, at which a run pauses.

They move with their lines when the program is edited, and are kept in a file from one start to the next.
The file is a convenience: a fault in it is never reported. This module imports little, because the first
screen needs it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from contextlib import suppress
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from pathlib import Path

    from language.parser import Parsed

MOST_PROGRAMS = 200
MOST_LINES = 200
"""Breakpoints of one program that are kept."""
LARGEST = 400_000
"""Bytes of the file; a larger one is damaged."""
LONGEST_PARSED = 100_000
"""Characters of a program that is parsed to find the lines where statements begin."""


# --- editing


def common_lines(before: Sequence[str], after: Sequence[str]) -> tuple[int, int]:
    """How many lines are the same at the beginning of both, and how many of the rest at their ends."""
    shorter = min(len(before), len(after))
    top = next((at for at in range(shorter) if before[at] != after[at]), shorter)
    rest = shorter - top
    return top, next((at for at in range(rest) if before[-1 - at] != after[-1 - at]), rest)


def shifted(lines: Iterable[int], first: int, last: int, added: int) -> frozenset[int]:
    """Moves the lines after ``last`` by ``added``, and drops the ones after ``first`` up to ``last``."""
    kept = (each for each in lines if not first < each <= last)
    return frozenset(each + added if each > last else each for each in kept)


def followed(lines: Iterable[int], before: Sequence[str], after: Sequence[str]) -> frozenset[int]:
    """Where the lines are once the program ``before`` is the program ``after``, as far as a diff shows it."""
    added = len(after) - len(before)
    top, same = common_lines(before, after)
    return shifted(lines, top, len(before) - same, added) if added else frozenset(lines)


# --- setting


def toggled(
    breakpoints: frozenset[int], line: int, text: str, parse: Callable[[str], Parsed]
) -> tuple[frozenset[int], int | None]:
    """The breakpoints after BREAK with ``line``, and the line that was set or cleared."""
    if line in breakpoints:
        return breakpoints - {line}, line
    at = pausing_line(text, line, parse)
    return (breakpoints if at is None else breakpoints | {at}), at


def pausing_line(text: str, line: int, parse: Callable[[str], Parsed]) -> int | None:
    """The first line from ``line`` on where a run can pause; None after the last statement.

    A run never pauses at an END or at a comment. ``parse`` reads GoDonnie. In a program that has mistakes,
    or is long, every line counts.
    """
    program = parse(text).program if len(text) <= LONGEST_PARSED else None
    if program is None:
        return line
    from language.syntax import walk

    lines = {each.span.line for each in walk(program.body)}
    return min((each for each in lines if each >= line), default=None)


# --- keeping


class BreakpointFile:
    """The breakpoints of each program that has a file, by its path; the program used last comes first."""

    def __init__(self, file: str) -> None:
        self._file_name = file

    @property
    def _file(self) -> Path:
        from pathlib import Path  # slow to load, and few programs have a file at the start

        return Path(self._file_name)

    def read(self, program: Path | None, line_count: int) -> frozenset[int]:
        """The breakpoints of that program, as far as its lines reach."""
        if program is None:
            return frozenset()
        lines = dict(self._entries()).get(_name(program), ())
        return frozenset(each for each in lines if 1 <= each <= line_count)

    def write(self, program: Path | None, lines: Iterable[int]) -> None:
        """Keep these for the next start. Ignores a program without a file, and a file it can't write."""
        if program is None:
            return
        name, chosen = _name(program), tuple(sorted(lines))[:MOST_LINES]
        before = self._entries()
        if dict(before).get(name, ()) == chosen:
            return
        others = [each for each in before if each[0] != name]
        entries = [(name, chosen), *others][:MOST_PROGRAMS] if chosen else others
        with suppress(OSError, ValueError):
            self._file.parent.mkdir(parents=True, exist_ok=True)
            self._file.write_text("".join(map(_line, entries)), encoding="utf-8")

    def _entries(self) -> list[tuple[str, tuple[int, ...]]]:
        with suppress(OSError, ValueError):
            if self._file.stat().st_size <= LARGEST:
                text = self._file.read_text(encoding="utf-8")
                return [entry for line in text.split("\n") if (entry := _entry(line)) is not None]
        return []


def _name(program: Path) -> str:
    try:
        return str(program.resolve())
    except (OSError, RuntimeError):
        return str(program)


def _line(entry: tuple[str, tuple[int, ...]]) -> str:
    """``3 7``, a tab and the path; empty for a path that does not fit into a line of text."""
    name, lines = entry
    return f"{' '.join(map(str, lines))}\t{name}\n" if name.isprintable() else ""


def _entry(line: str) -> tuple[str, tuple[int, ...]] | None:
    numbers, tab, name = line.partition("\t")
    given = numbers.split()
    if not tab or not name or not all(each.isdecimal() and len(each) < 9 for each in given):
        return None
    return name, tuple(map(int, given))
