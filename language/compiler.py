"""A program that can run: translated to code objects of Python, because these are by far the fastest.

syntax tree -> scopes -> growth (which results need a check) -> statements (Python's syntax tree)
-> units (code objects) -> execution -> failures and levels (what happened, in the learner's terms).

``plain`` runs the same trees the obvious way; the tests hold both to the same behaviour.
"""

from __future__ import annotations

from language.control import ExecutionControl
from language.execution import Execution
from language.linking import link
from language.runnable import Runnable as Runnable
from language.runnable import Trace
from language.runtime import Actions, Frame, Memory
from language.syntax import Program


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
