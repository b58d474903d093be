"""A program that can run: translated to code objects of Python, because these are by far the fastest.

syntax tree -> scopes -> numbers (which results need a check) -> statements (Python's syntax tree)
-> units (code objects) -> execution -> levels and mistakes (what happened, in the learner's terms).

A batch is its program and the procedures of earlier batches that it may call. They are brought together when
it begins, for only then is it known what the memory holds: so the compiler sees every call that there can be,
and knows what the variables are. ``plain`` runs the same trees the obvious way; the tests hold both to the
same behaviour.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial

from language.control import ExecutionControl
from language.execution import Execution
from language.expressions import Bounds
from language.levels import make_room
from language.numbers import Growth, Naturals, assignments_of
from language.runtime import Actions, Frame, Memory, Trace
from language.runtime import Runnable as Runnable
from language.scopes import Declared, Scope, scopes_of
from language.statements import ScopeTranslator
from language.syntax import Program
from language.translated import Unit


def compile_program(program: Program, *, terminal: bool = False, hooked: bool = False) -> Runnable:
    """A program that can run. ``hooked``: it can be stepped through and traced, at some cost.

    In the ``terminal`` QUIT and RUN are allowed, and a later batch may declare a name again; a file
    begins with an empty memory whatever it is given.
    """
    return _CompiledProgram(program, terminal=terminal, hooked=hooked)


class _CompiledProgram:
    """Is linked anew for each run, because each may find another memory."""

    def __init__(self, program: Program, *, terminal: bool, hooked: bool) -> None:
        self._program = program
        self._terminal = terminal
        self._hooked = hooked
        self._running: Execution | None = None

    def run(
        self, actions: Actions, control: ExecutionControl, memory: Memory, *, trace: Trace | None = None
    ) -> None:
        if trace is not None and not self._hooked:
            raise ValueError("only a program that was compiled with hooks can be traced")
        try:
            self._run(actions, control, memory, trace)
        finally:
            self._running = None
            control.ended()

    def frames(self) -> tuple[Frame, ...]:
        running = self._running
        return () if running is None else running.frames()

    def _run(self, actions: Actions, control: ExecutionControl, memory: Memory, trace: Trace | None) -> None:
        if not self._terminal:
            memory.variables, memory.procedures = {}, {}
        units = link(self._program, memory, terminal=self._terminal, hooked=self._hooked)
        self._running = Execution(units, actions, control, memory, trace, hooked=self._hooked)
        self._running.run()


def link(program: Program, memory: Memory, *, terminal: bool, hooked: bool) -> tuple[Unit, ...]:
    """The units of a batch: the program first, then every procedure that may run."""
    make_room()
    scopes = _reachable(program, memory.procedures)
    given = assignments_of(scopes)
    growth, naturals = Growth(given, memory.variables), Naturals(given, memory.variables)
    numbers = {id(scope.procedure): number for number, scope in enumerate(scopes)}
    stored = frozenset(memory.variables)
    return tuple(
        ScopeTranslator(
            scope,
            Bounds(partial(growth.bits, number), partial(naturals.has, number)),
            numbers,
            frozenset() if number else stored,
            terminal=terminal,
            hooked=hooked,
        ).unit()
        for number, scope in enumerate(scopes)
    )


def _reachable(program: Program, earlier: Mapping[str, Declared]) -> tuple[Scope, ...]:
    """The program's scopes, and those of the earlier procedures that they call, and that those call."""
    scopes = list(scopes_of(Scope(program, None)))
    seen: set[str] = set()
    for scope in scopes:
        for name in scope.calls() & earlier.keys() - seen:
            seen.add(name)
            scopes += scopes_of(Scope(earlier[name].program, earlier[name].procedure))
    return tuple(scopes)
