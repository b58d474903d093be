"""Compiles programs to code objects of Python, which run much faster than a walk over the tree; runs them.

syntax tree -> scopes -> numbers (which results need a check) -> statements (Python's syntax tree)
-> units (code objects) -> Execution -> call_stack (events of the run in the learner's terms).

A batch is its program and the procedures of earlier batches that it may call. The compiler links them when
the batch begins, because only then the memory is known. So it sees every possible call and all variables. The
tests have a plain interpreter that walks the tree, and compare its behaviour with this one.

An ``Execution`` is one run: its globals, and its end. Invariant: however the program ends, the memory is
right before the end is reported.

CPython 3.11 specializes code only after eight entries or eight iterations of a ``for``. A program is entered
once, and its WHILE loops would stay slow. So each unit is entered before the run and left at its first
checkpoint, before any action. Later versions neither need this nor suffer from it."""

from __future__ import annotations

import sys
import threading
from collections import defaultdict
from collections.abc import Callable, Hashable, Iterator, Mapping
from contextlib import suppress
from functools import partial
from itertools import repeat
from operator import length_hint
from types import FunctionType
from typing import Any, NoReturn

from devices.ports.robot import Bearing
from language.call_stack import (
    DEEPEST_CALL,
    NO_CALLS,
    Activation,
    StackReader,
    failure_of,
    first_link,
    raise_recursion_limit,
    variables_in,
)
from language.control import ControlState, ExecutionControl
from language.diagnostics import ActionRefused, LanguageError, MistakeKind, QuitRequested, Stopped
from language.expressions import ValueBounds
from language.numbers import NonNegatives, NumberSizes, assignments_of, checked, divide
from language.python_code import EARLIER, PARAMETER, Unit, hook_depth_at, procedure_taking
from language.runtime import Actions, Frame, Memory, Runnable, Trace, shown_frames
from language.statements import ScopeCompiler
from language.syntax import Axis, DeclaredProcedure, Program, Scope, scopes_of


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

    def progress(self) -> Hashable:
        assert self._hooked and self._running is not None
        return self._running.progress()


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


# --- one run

_ACTIONS = tuple(name for name in vars(Actions) if not name.startswith("_"))
"""The names by which the compiled code calls the actions."""


class Execution:
    """Units that run once. The first is the program."""

    def __init__(
        self,
        units: tuple[Unit, ...],
        actions: Actions,
        control: ExecutionControl,
        memory: Memory,
        trace: Trace | None,
        *,
        hooked: bool,
    ) -> None:
        self._units = units
        self._actions = actions
        self._control = control
        self._memory = memory
        self._trace = trace
        self._hooked = hooked
        self._thread = threading.get_ident()
        self._stack = StackReader(units)
        self._declared: dict[str, Unit] = {}
        self._counts: dict[str, set[int]] = defaultdict(set)
        """The numbers of arguments in the calls of each procedure."""
        for name, count in frozenset[tuple[str, int]]().union(*(unit.calls for unit in units)):
            self._counts[name].add(count)
        self._hook_depths = {line: hook_depth_at(line) for unit in units for line in unit.lines}
        """For each line with a hook, the name of the global that switches it."""
        self._iterating: dict[tuple[int, int], Iterator[object]] = {}
        """Of a program with hooks: the iterations of each REPEAT, by its frame and its place there."""
        self._globals = self._make_globals()
        for unit in units:
            earlier = memory.procedures.get(unit.name)
            if unit.procedure is not None and earlier is not None and earlier.procedure is unit.procedure:
                self._bind(unit)

    def run(self) -> None:
        """Run to the end; raises as ``Runnable.run``."""
        stored = [value for _, value in sorted(self._memory.variables.items())]
        program = FunctionType(self._units[0].code, self._globals)
        link = first_link() if self._units[0].calls else NO_CALLS
        failure = None
        warm_up(self._units)
        self._control.attach(self._on_state)
        try:
            self._keep(variables_in(program(link, *stored)))
        except BaseException as error:
            failure = self._failure(error)
            if failure is None:
                raise
        finally:
            self._control.attach(None)
        # Raised here, so that it does not keep the frames of a deep recursion alive.
        if failure is not None:
            raise failure

    def frames(self) -> tuple[Frame, ...]:
        """The open calls, innermost first; from any thread."""
        stack = self._stack.of_frame(sys._current_frames().get(self._thread))
        return tuple(activation.snapshot() for activation in shown_frames(stack))

    def progress(self) -> Hashable:
        """See ``Runnable.progress``."""
        left = ((place, _left(iterator)) for place, iterator in self._iterating.items())
        return self._stack.values_of(sys._getframe(1)), frozenset(left), tuple(self._declared)

    def _iterations(self, times: int) -> Iterator[object]:
        frame = sys._getframe(1)
        found = self._iterating[id(frame), frame.f_lasti] = _iterations(times)
        return found

    def _failure(self, error: BaseException) -> LanguageError | None:
        """The learner's view of an exception. Updates the memory."""
        traceback = error.__traceback__
        if isinstance(error, Stopped):  # its place is not needed, and in a deep recursion it must be fast
            self._keep_remaining(self._stack.outermost(traceback))
            return Stopped()
        stack, inside = self._stack.of_traceback(traceback), self._stack.raised(traceback)
        self._keep_remaining(stack)
        return failure_of(error, stack, self._memory.procedures, inside=inside)

    def _keep(self, variables: dict[str, int]) -> None:
        self._memory.variables = variables  # a new dict: other threads may read the old one

    def _keep_remaining(self, stack: list[Activation]) -> None:
        """Keep the variables after an error, without those that end with an open FOR."""
        if stack:
            program = stack[0]
            ended = program.unit.headers_at(program.site or 0)
            self._keep({name: value for name, value in program.variables().items() if name not in ended})

    # --- the globals of the compiled code

    def _make_globals(self) -> dict[str, Any]:
        return {
            "flag": False,
            "hook": None,
            **dict.fromkeys(self._hook_depths.values()),
            "check": self._check,
            "stop": _stop,
            "checked": checked,
            "divide": divide,
            "iterations": self._iterations if self._hooked else _iterations,
            "clash": self._clash,
            "may_declare": self._may_declare,
            "declare": self._declare,
            "quit": _quit,
            "do_nothing": _do_nothing,
            "refuse_outside_terminal": _refuse_outside_terminal,
            **{name: getattr(self._actions, name) for name in _ACTIONS},
            **{bearing.name: bearing for bearing in Bearing},
            **{axis.name: axis for axis in Axis},
        }

    def _clash(self, owner: int, typed: str) -> None:
        """The program declares a name that exists already."""
        if owner == EARLIER:
            self._actions.overwritten(typed)
            return
        if owner == PARAMETER:
            raise ActionRefused(MistakeKind.ALREADY_DECLARED, name=typed, what="parameter")
        unit = self._stack.around(sys._getframe(1)).unit
        raise ActionRefused(
            MistakeKind.ALREADY_DECLARED, name=typed, what="variable", first_line=unit.span(owner).line
        )

    # --- requests of the control

    def _on_state(self, state: ControlState) -> None:
        """Switch the checkpoints to the control's new state. Called under its lock."""
        if self._hooked:
            self._globals["flag"] = state is ControlState.STOPPING
            self._set_hook(state)
        else:
            self._globals["flag"] = state is not ControlState.RUNNING

    def _set_hook(self, state: ControlState) -> None:
        """Switch the hooks: as few as possible, or all for a trace."""
        lines = self._control.holds_on_lines()
        depth: int | None = DEEPEST_CALL
        looks = self._control.looks_before_each
        is_traced = looks or self._trace is not None
        if not is_traced and state in (ControlState.RUNNING, ControlState.RUNNING_TO):
            depth = None
        elif not is_traced and state is ControlState.STEPPING_OVER:
            depth = int(min(self._control.holds_to_depth(), DEEPEST_CALL))
        depths = dict.fromkeys(self._hook_depths.values(), depth)
        depths |= {self._hook_depths[line]: DEEPEST_CALL for line in lines & self._hook_depths.keys()}
        has_no_request = state is ControlState.RUNNING and not lines and not looks
        self._globals.update(depths, hook=self._trace if has_no_request else self._visit)

    def _visit(self, line: int, column: int, depth: int) -> bool:
        """Called before a statement whose hook is on. Returns whether the program must end."""
        if self._must_end(line, depth, column):
            return True
        if self._trace is not None:
            self._trace(line, column, depth)
        return False

    def _check(self) -> bool:
        """Called at a checkpoint while the flag is set. Returns whether the program must end."""
        return self._must_end(self._stack.around(sys._getframe(1)).line, 0)

    def _must_end(self, line: int, depth: int, column: int = 0) -> bool:
        try:
            self._control.reached(line, depth, column)
        except Stopped:
            return True
        return False

    # --- procedures

    def _may_declare(self, number: int) -> None:
        """A PROCEDURE was reached: refuse it if this program declared another one of that name."""
        unit = self._units[number]
        name = unit.name
        other = self._declared.get(name)
        if other is None and name in self._memory.procedures:
            self._actions.overwritten(unit.typed_name)
        elif other is not None and other is not unit:
            first_line = other.declared.procedure.span.line
            raise ActionRefused(
                MistakeKind.ALREADY_DECLARED, name=unit.typed_name, what="procedure", first_line=first_line
            )

    def _declare(self, number: int) -> None:
        unit = self._units[number]
        self._declared[unit.name] = unit
        self._memory.procedures[unit.name] = unit.declared
        self._bind(unit)

    def _bind(self, unit: Unit) -> None:
        """Make the procedure callable with the right number of arguments; any other is refused."""
        for given in self._counts[unit.name]:
            self._globals[procedure_taking(unit.name, given)] = self._callable(unit, given)

    def _callable(self, unit: Unit, given: int) -> Callable[..., None]:
        wanted = len(unit.declared.procedure.parameters)
        if given == wanted:
            return FunctionType(unit.code, self._globals)

        def refuse(*_: int) -> NoReturn:
            raise ActionRefused(
                MistakeKind.WRONG_ARGUMENT_COUNT, name=unit.typed_name, wanted=wanted, given=given
            )

        return refuse


def _iterations(times: int) -> Iterator[object]:
    """Counts iterations without a number for each."""
    return iter(range(times)) if times > sys.maxsize else repeat(None, max(times, 0))


def _left(iterations: Iterator[object]) -> int | None:
    """How many there still are; None if they are more than Python counts."""
    try:
        return length_hint(iterations)
    except OverflowError:
        return None


def _stop() -> NoReturn:
    raise Stopped


def _quit() -> NoReturn:
    raise QuitRequested


def _do_nothing() -> None:
    """RUN among the commands of a terminal, which are running already."""


def _refuse_outside_terminal(typed: str) -> NoReturn:
    raise ActionRefused(MistakeKind.TERMINAL_ONLY, name=typed)


_ENTRIES = 8


class _Left(Exception):
    """The unit was entered and left again."""


def warm_up(units: tuple[Unit, ...]) -> None:
    """Enter each unit often enough. Each begins with a checkpoint, or with a hook if it has statements."""
    globals_: dict[str, Any] = {"flag": True, "check": _leave_at_once, "hook": _leave_at_once}
    for unit in units:
        globals_ |= {hook_depth_at(line): DEEPEST_CALL for line in unit.lines}
        function = FunctionType(unit.code, globals_)
        for _ in range(_ENTRIES):
            with suppress(_Left):
                function(NO_CALLS, *repeat(None, unit.code.co_argcount - 1))


def _leave_at_once(*_place: int) -> NoReturn:
    raise _Left
