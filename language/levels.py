"""Where a running or a failed program is, and how deep it may go: Python's frames read as levels of GoDonnie.

A level is the program or one open call of a procedure. Where loops were nested too deep for Python,
several frames make one level; the place is that of the innermost of them, the variables are in the outermost.

The running program is Python calling Python, which since 3.11 takes no C stack: any thread will do, and
only the interpreter's own limit has to be out of the way. That limit belongs to the whole process, so it
is raised once and never lowered: another thread may be deep in it.
"""

from __future__ import annotations

import sys
from collections.abc import Iterable, Iterator, Mapping
from functools import cache
from itertools import islice
from types import CodeType, FrameType, TracebackType

from devices.ports.hints import TypeAlias
from devices.ports.values import Mutable
from language.diagnostics import CallSite
from language.runtime import Frame
from language.translated import VARIABLE, Unit

_Entry: TypeAlias = tuple[FrameType, int | None]
"""A frame and the site in it."""


class Level(Mutable):
    """One open call, or the program itself."""

    unit: Unit
    frame: FrameType
    site: int | None
    innermost: FrameType

    @property
    def line(self) -> int:
        return self.unit.span(self.site).line

    def next_site(self) -> int | None:
        """Where the instruction after the current one is from.

        CPython 3.11 runs two simple instructions as one; if the second fails, it tells where the first is.
        """
        frame = self.innermost
        following = islice(frame.f_code.co_positions(), frame.f_lasti // 2 + 1, None)
        return next(following, (None,))[0]

    def variables(self) -> dict[str, int]:
        return variables_in(self.frame.f_locals)

    def told(self) -> Frame:
        return Frame(self.unit.typed_name, self.line, tuple(self.variables().items()))


class Levels:
    """Finds levels among the frames that belong to some units."""

    def __init__(self, units: Iterable[Unit]) -> None:
        self._roots = {id(unit.code): unit for unit in units}
        self._codes = {id(code) for unit in units for code in _codes(unit.code)}

    def of_traceback(self, traceback: TracebackType | None) -> list[Level]:
        """The levels that an exception went through, outermost first."""
        return list(self._levels(_entries(traceback)))

    def outermost(self, traceback: TracebackType | None) -> list[Level]:
        """The program's own level only: at once, however deep the exception was raised."""
        return list(islice(self._levels(_entries(traceback)), 1))

    def of_frame(self, frame: FrameType | None) -> list[Level]:
        """The levels of a running thread, outermost first."""
        entries: list[_Entry] = []
        while frame is not None:
            entries.append((frame, frame.f_lineno))
            frame = frame.f_back
        return list(self._levels(reversed(entries)))

    def raised(self, traceback: TracebackType | None) -> bool:
        """Whether an exception was raised by the translated code itself, and not in what it called."""
        *_, (innermost, _) = _entries(traceback)
        return id(innermost.f_code) in self._codes

    def around(self, frame: FrameType) -> Level:
        """The level that a frame of the translated code belongs to."""
        site, innermost = frame.f_lineno, frame
        while id(frame.f_code) not in self._roots:
            assert frame.f_back is not None  # a loop is called by what it was taken out of
            frame = frame.f_back
        return Level(self._roots[id(frame.f_code)], frame, site, innermost)

    def _levels(self, entries: Iterable[_Entry]) -> Iterator[Level]:
        level: Level | None = None
        for frame, site in entries:
            if unit := self._roots.get(id(frame.f_code)):
                if level is not None:
                    yield level
                level = Level(unit, frame, site, frame)
            elif level is not None and id(frame.f_code) in self._codes:
                level.site, level.innermost = site, frame
        if level is not None:
            yield level


def call_sites(levels: list[Level]) -> tuple[CallSite, ...]:
    """The open calls, innermost first: each procedure, and the line it was called from."""
    return tuple(
        CallSite(callee.unit.typed_name, caller.line)
        for caller, callee in zip(levels[-2::-1], levels[:0:-1], strict=True)
    )


def variables_in(names: Mapping[str, object]) -> dict[str, int]:
    """GoDonnie's variables among the names of a frame of the translated code.

    Of a copy: a running frame has one mapping of them for all threads, filled anew whenever one asks.
    """
    return {
        name.removeprefix(VARIABLE): value
        for name, value in dict(names).items()
        if name.startswith(VARIABLE) and isinstance(value, int)
    }


def _entries(traceback: TracebackType | None) -> Iterator[_Entry]:
    while traceback is not None:
        yield traceback.tb_frame, traceback.tb_lineno
        traceback = traceback.tb_next


def _codes(code: CodeType) -> Iterator[CodeType]:
    """A code object and those inside it."""
    waiting = [code]
    while waiting:
        inner = waiting.pop()
        yield inner
        waiting += (each for each in inner.co_consts if isinstance(each, CodeType))


DEEPEST_CALL = 20_000
"""Procedures that may be running inside each other."""

Link: TypeAlias = "tuple[int] | tuple[int, Link]"
"""How many calls are open, and the link for one call more; the deepest has none."""

NO_CALLS: Link = (0,)
"""The link of a program that calls no procedure."""

_PYTHON_FRAMES = 1_000_000
"""More than a program can use: a call in deeply nested loops takes several frames of Python."""


@cache
def first_link(deepest: int = DEEPEST_CALL) -> Link:
    """The link of a program without open calls.

    Handing on a link is cheaper than counting, and asking the deepest for the next one fails by itself.
    """
    link: Link = (deepest,)
    for depth in range(deepest - 1, -1, -1):
        link = (depth, link)
    return link


def make_room() -> None:
    """Let Python call as deep as GoDonnie may."""
    if sys.getrecursionlimit() < _PYTHON_FRAMES:
        sys.setrecursionlimit(_PYTHON_FRAMES)
