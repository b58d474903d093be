"""Breakpoints: lines, from 1, that go with their program as it is edited, and are kept from start to start.

The file of them is a comfort only: whatever is wrong with it, nobody hears of it. Imports little: the first
screen needs it.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from contextlib import suppress

from devices.ports.hints import TYPE_CHECKING

if TYPE_CHECKING:
    from pathlib import Path

MOST_PROGRAMS = 200
MOST_LINES = 200
"""Breakpoints of one program that are kept."""
LARGEST = 400_000
"""Bytes of the file; more is not ours."""


def alike(before: Sequence[str], after: Sequence[str]) -> tuple[int, int]:
    """How many lines are the same at the beginning of both, and behind these at their ends."""
    shorter = min(len(before), len(after))
    top = next((at for at in range(shorter) if before[at] != after[at]), shorter)
    rest = shorter - top
    return top, next((at for at in range(rest) if before[-1 - at] != after[-1 - at]), rest)


def shifted(lines: Iterable[int], first: int, last: int, added: int) -> frozenset[int]:
    """Lines behind ``last`` have moved by ``added``; what is behind ``first`` up to there is gone."""
    kept = (each for each in lines if not first < each <= last)
    return frozenset(each + added if each > last else each for each in kept)


def followed(lines: Iterable[int], before: Sequence[str], after: Sequence[str]) -> frozenset[int]:
    """Where they are once the text ``before`` is the text ``after``: what differs is all that is known."""
    added = len(after) - len(before)
    top, same = alike(before, after)
    return shifted(lines, top, len(before) - same, added) if added else frozenset(lines)


class KeptBreakpoints:
    """Those of each program that has a file, by its path; the program used last comes first."""

    def __init__(self, file: str) -> None:
        self._file_name = file

    @property
    def _file(self) -> Path:
        from pathlib import Path  # slow to load, and few programs have a file at the start

        return Path(self._file_name)

    def of(self, program: Path | None, line_count: int) -> frozenset[int]:
        """As they were left; those behind the end of the text are forgotten."""
        if program is None:
            return frozenset()
        lines = dict(self._entries()).get(_name(program), ())
        return frozenset(each for each in lines if 1 <= each <= line_count)

    def keep(self, program: Path | None, lines: Iterable[int]) -> None:
        """From now on these; a program without a file, or that can't be written down, is passed over."""
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
    """``3 7`` and the path behind a tab; a path that would not stay a line is left out."""
    name, lines = entry
    return f"{' '.join(map(str, lines))}\t{name}\n" if name.isprintable() else ""


def _entry(line: str) -> tuple[str, tuple[int, ...]] | None:
    numbers, tab, name = line.partition("\t")
    given = numbers.split()
    if not tab or not name or not all(each.isdecimal() and len(each) < 9 for each in given):
        return None
    return name, tuple(map(int, given))
