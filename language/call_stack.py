"""The call stack of a running or a failed program: Python's frames read as open calls of GoDonnie.

An activation is the program or one open call of a procedure. If loops are nested too deep for Python, several
frames make one activation: its place is that of the innermost frame, its variables are in the outermost.

In the running program Python calls Python, which takes no C stack since 3.11. So any thread can run it, and
only the interpreter's own limit must be raised. The limit belongs to the whole process. It is raised once and
never lowered, because another thread may be deep in calls.
"""

from __future__ import annotations

import sys
from collections.abc import Collection, Iterable, Iterator, Mapping
from functools import cache
from itertools import islice
from types import CodeType, FrameType, TracebackType
from typing import TypeAlias

from msgspec import Struct

from language.diagnostics import (
    ActionRefused,
    CallSite,
    Diagnostic,
    LanguageError,
    MistakeKind,
    ProgramError,
    mistake_at,
)
from language.python_code import VARIABLE, Unit, procedure_taking
from language.runtime import Frame
from language.syntax import Call, Name

_Entry: TypeAlias = tuple[FrameType, int | None]
"""A frame and the site in it."""


class Activation(Struct):
    """One open call, or the program itself."""

    unit: Unit
    frame: FrameType
    site: int | None
    innermost: FrameType

    @property
    def line(self) -> int:
        return self.unit.span(self.site).line

    def next_site(self) -> int | None:
        """The site of the instruction after the current one.

        CPython 3.11 runs two simple instructions as one; if the second fails, it reports the first.
        """
        frame = self.innermost
        following = islice(frame.f_code.co_positions(), frame.f_lasti // 2 + 1, None)
        return next(following, (None,))[0]

    def variables(self) -> dict[str, int]:
        return variables_in(self.frame.f_locals)

    def snapshot(self) -> Frame:
        return Frame(self.unit.typed_name, self.line, tuple(self.variables().items()))


class StackReader:
    """Finds the activations of some units among Python's frames."""

    def __init__(self, units: Iterable[Unit]) -> None:
        self._roots = {id(unit.code): unit for unit in units}
        self._codes = {id(code) for unit in units for code in _codes(unit.code)}

    def of_traceback(self, traceback: TracebackType | None) -> list[Activation]:
        """The activations that an exception passed, outermost first."""
        return list(self._activations(_entries(traceback)))

    def outermost(self, traceback: TracebackType | None) -> list[Activation]:
        """The program's own activation only: fast, however deep the exception was raised."""
        return list(islice(self._activations(_entries(traceback)), 1))

    def of_frame(self, frame: FrameType | None) -> list[Activation]:
        """The activations of a running thread, outermost first."""
        entries: list[_Entry] = []
        while frame is not None:
            entries.append((frame, frame.f_lineno))
            frame = frame.f_back
        return list(self._activations(reversed(entries)))

    def values_of(self, frame: FrameType | None) -> tuple[tuple[int, int, tuple[tuple[str, int], ...]], ...]:
        """The place of each frame of the compiled code in a running thread, and its numbers."""
        found = list[tuple[int, int, tuple[tuple[str, int], ...]]]()
        while frame is not None:
            if id(frame.f_code) in self._codes:
                numbers = ((name, value) for name, value in frame.f_locals.items() if isinstance(value, int))
                found.append((id(frame.f_code), frame.f_lasti, tuple(numbers)))
            frame = frame.f_back
        return tuple(found)

    def raised(self, traceback: TracebackType | None) -> bool:
        """Whether the compiled code itself raised an exception, and not a function that it called."""
        *_, (innermost, _) = _entries(traceback)
        return id(innermost.f_code) in self._codes

    def around(self, frame: FrameType) -> Activation:
        """The activation of a frame of the compiled code."""
        site, innermost = frame.f_lineno, frame
        while id(frame.f_code) not in self._roots:
            assert frame.f_back is not None  # the scope of an outlined loop calls it
            frame = frame.f_back
        return Activation(self._roots[id(frame.f_code)], frame, site, innermost)

    def _activations(self, entries: Iterable[_Entry]) -> Iterator[Activation]:
        activation: Activation | None = None
        for frame, site in entries:
            if unit := self._roots.get(id(frame.f_code)):
                if activation is not None:
                    yield activation
                activation = Activation(unit, frame, site, frame)
            elif activation is not None and id(frame.f_code) in self._codes:
                activation.site, activation.innermost = site, frame
        if activation is not None:
            yield activation


def variables_in(names: Mapping[str, object]) -> dict[str, int]:
    """GoDonnie's variables among the names of a frame of the compiled code.

    Reads a copy: a running frame has one mapping for all threads, and any of them may fill it anew.
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
    pending = [code]
    while pending:
        inner = pending.pop()
        yield inner
        pending += (each for each in inner.co_consts if isinstance(each, CodeType))


# --- failures -----------------------------------------------------------------------------------------


def failure_of(
    error: BaseException, stack: list[Activation], procedures: Collection[str], *, inside: bool
) -> LanguageError | None:
    """The learner's mistake that caused an exception; None if the program did not cause it.

    ``procedures``: those that exist. ``inside``: the compiled code itself raised the exception, and not a
    function that it called.
    """
    found: Diagnostic | None = None
    if isinstance(error, ActionRefused) and stack:
        found = _refused(error, stack[-1])
    elif inside and isinstance(error, NameError):
        found = _undeclared(stack, procedures)
    elif inside and isinstance(error, ZeroDivisionError):
        found = _refused(ActionRefused(MistakeKind.DIVISION_BY_ZERO), stack[-1])
    elif inside and isinstance(error, IndexError):  # the deepest link has no next one
        found = _refused(ActionRefused(MistakeKind.RECURSION_LIMIT, limit=DEEPEST_CALL), stack[-1])
    if found is None:
        return None
    calls = zip(stack[-2::-1], stack[:0:-1], strict=True)
    sites = tuple(CallSite(callee.unit.typed_name, caller.line) for caller, callee in calls)
    return ProgramError(found, sites)


def _refused(refused: ActionRefused, place: Activation) -> Diagnostic:
    node = place.unit.node(place.site)
    span = node.name.span if isinstance(node, Call) else place.unit.span(place.site)
    return mistake_at(place.unit.program, span, refused.kind, refused.details)


def _undeclared(stack: list[Activation], procedures: Collection[str]) -> Diagnostic | None:
    """A name without a value: a procedure where it is called, else a variable."""
    from language.suggestions import undeclared_procedure, undeclared_variable  # only programs that fail

    place = stack[-1]
    unit, own = place.unit, place.variables()
    node = unit.node(place.site)
    if isinstance(node, Call):
        procedure = procedure_taking(node.name.name, len(node.arguments))
        if procedure not in place.frame.f_globals:
            return undeclared_procedure(unit.program, node.name, procedures)
    if not isinstance(node, Name) or node.name in own:
        node = unit.node(place.next_site())
    if not isinstance(node, Name):
        return None
    return undeclared_variable(unit.program, node, own, unit.typed_name, stack[0].variables())


# --- the depth of calls -------------------------------------------------------------------------------

DEEPEST_CALL = 20_000
"""Procedures that may be running inside each other."""

Link: TypeAlias = "tuple[int] | tuple[int, Link]"
"""The number of open calls, and the link for one call more; the deepest link has none."""

NO_CALLS: Link = (0,)
"""The link of a program that calls no procedure."""

_PYTHON_FRAMES = 1_000_000
"""More than a program can use: a call in deeply nested loops takes several frames of Python."""


@cache
def first_link(deepest: int = DEEPEST_CALL) -> Link:
    """The link of a program without open calls.

    To pass on a link is cheaper than to count, and Python raises an error after the deepest one.
    """
    link: Link = (deepest,)
    for depth in range(deepest - 1, -1, -1):
        link = (depth, link)
    return link


def raise_recursion_limit() -> None:
    """Allow Python as many calls as GoDonnie needs."""
    if sys.getrecursionlimit() < _PYTHON_FRAMES:
        sys.setrecursionlimit(_PYTHON_FRAMES)
