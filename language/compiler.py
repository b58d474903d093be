"""Compiles programs to code objects of Python, which run much faster than a walk over the tree.

syntax tree -> scopes -> numbers (which results need a check) -> statements (Python's syntax tree)
-> units (code objects) -> execution -> call_stack (events of the run in the learner's terms).

A batch is its program and the procedures of earlier batches that it may call. The compiler links them when
the batch begins, because only then the memory is known. So it sees every possible call and all variables. The
tests have a plain interpreter that walks the tree, and compare its behaviour with this one.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial

from language.call_stack import raise_recursion_limit
from language.control import ExecutionControl
from language.execution import Execution
from language.expressions import ValueBounds
from language.numbers import NonNegatives, NumberSizes, assignments_of
from language.python_code import Unit
from language.runtime import Actions, Frame, Memory, Runnable, Trace
from language.statements import ScopeCompiler
from language.syntax import DeclaredProcedure, Program, Scope, scopes_of


def compile_program(program: Program, *, terminal: bool = False, hooked: bool = False) -> Runnable:
    """Compile a program. ``hooked``: it can be stepped through and traced, at some cost.

    In the ``terminal`` QUIT and RUN are allowed, and a later batch may declare a name again; a file
    begins with an empty memory.
    """
    return _CompiledProgram(program, terminal=terminal, hooked=hooked)


class _CompiledProgram:
    """A program that is linked anew for each run, because each may have another memory."""

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
            if not self._terminal:
                memory.variables, memory.procedures = {}, {}
            units = link(self._program, memory, terminal=self._terminal, hooked=self._hooked)
            self._running = Execution(units, actions, control, memory, trace, hooked=self._hooked)
            self._running.run()
        finally:
            self._running = None
            control.ended()

    def frames(self) -> tuple[Frame, ...]:
        running = self._running
        return () if running is None else running.frames()


def link(program: Program, memory: Memory, *, terminal: bool, hooked: bool) -> tuple[Unit, ...]:
    """The units of a batch: the program first, then every procedure that may run."""
    raise_recursion_limit()
    scopes = _reachable(program, memory.procedures)
    given = assignments_of(scopes)
    sizes, naturals = NumberSizes(given, memory.variables), NonNegatives(given, memory.variables)
    numbers = {id(scope.procedure): number for number, scope in enumerate(scopes)}
    stored = frozenset(memory.variables)
    return tuple(
        ScopeCompiler(
            scope,
            ValueBounds(partial(sizes.bits, number), partial(naturals.has, number)),
            numbers,
            frozenset() if number else stored,
            terminal=terminal,
            hooked=hooked,
        ).unit()
        for number, scope in enumerate(scopes)
    )


def _reachable(program: Program, earlier: Mapping[str, DeclaredProcedure]) -> tuple[Scope, ...]:
    """The program's scopes, and those of the earlier procedures that they call, and that those call."""
    scopes = list(scopes_of(Scope(program, None)))
    seen: set[str] = set()
    for scope in scopes:
        for name in scope.calls() & earlier.keys() - seen:
            seen.add(name)
            scopes += scopes_of(Scope(earlier[name].program, earlier[name].procedure))
    return tuple(scopes)
