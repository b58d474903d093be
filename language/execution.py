"""One run of translated code: the globals that it uses, and the way back from it.

The rule it keeps: whatever ends the program, the memory is true before anybody hears of it.

CPython 3.11 specializes code only after it was entered eight times or went round in a ``for`` eight times.
A program is entered once, and its WHILE loops would stay slow for ever. So each unit is entered before it
runs, and left at its first checkpoint, before anything happened. Later versions do not need it and are not
harmed by it.
"""

from __future__ import annotations

import sys
import threading
from collections import defaultdict
from collections.abc import Callable, Iterator
from contextlib import suppress
from itertools import repeat
from types import FunctionType

from devices.ports.hints import Any, NoReturn
from devices.ports.robot import Bearing
from language.control import ControlState, ExecutionControl
from language.diagnostics import Kind, LanguageError, QuitRequested, Refused, Stopped
from language.levels import DEEPEST_CALL, NO_CALLS, Level, Levels, first_link, variables_in
from language.numbers import checked, divide
from language.runtime import Actions, Frame, Memory, Trace, told_levels
from language.syntax import Axis
from language.translated import EARLIER, PARAMETER, Unit, procedure_taking, wanted_at

_ACTIONS = tuple(name for name in vars(Actions) if not name.startswith("_"))
"""What the translated code calls by its own name."""


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
        self._levels = Levels(units)
        self._declared: dict[str, Unit] = {}
        self._counts: dict[str, set[int]] = defaultdict(set)
        """With how many arguments each procedure is called."""
        for name, count in frozenset[tuple[str, int]]().union(*(unit.calls for unit in units)):
            self._counts[name].add(count)
        self._wanted = {line: wanted_at(line) for unit in units for line in unit.lines}
        """For each line at which it can be held, the name of what says whether it is."""
        self._globals = self._make_globals()
        self._bind_earlier()

    def run(self) -> None:
        """Run to the end; raises what ``Runnable.run`` says."""
        stored = [value for _, value in sorted(self._memory.variables.items())]
        program = FunctionType(self._units[0].code, self._globals)
        link = first_link() if self._units[0].calls else NO_CALLS
        failure = None
        warm_up(self._units)
        self._control.attach(self._heed)
        try:
            self._keep(variables_in(program(link, *stored)))
        except BaseException as error:
            failure = self._failure(error)
            if failure is None:
                raise
        finally:
            self._control.attach(None)
        # Raised here, so that it does not hold on to the frames of a deep recursion.
        if failure is not None:
            raise failure

    def frames(self) -> tuple[Frame, ...]:
        """The levels, innermost first, seen from any thread."""
        levels = self._levels.of_frame(sys._current_frames().get(self._thread))
        return tuple(level.told() for level in told_levels(levels))

    def _failure(self, error: BaseException) -> LanguageError | None:
        """What an exception means; the memory is true afterwards."""
        traceback = error.__traceback__
        if isinstance(error, Stopped):  # nobody asks where, and out of a deep recursion it must be quick
            self._keep_what_was(self._levels.outermost(traceback))
            return Stopped()
        levels, inside = self._levels.of_traceback(traceback), self._levels.raised(traceback)
        self._keep_what_was(levels)
        from language.mistakes import failure_of  # only programs that fail

        return failure_of(error, levels, self._memory.procedures, inside=inside)

    def _keep(self, variables: dict[str, int]) -> None:
        self._memory.variables = variables  # replaced as a whole: other threads may be reading the old ones

    def _keep_what_was(self, levels: list[Level]) -> None:
        """After an error: the variables as they are, without those that end with an open FOR."""
        if levels:
            program = levels[0]
            ended = program.unit.headers_at(program.site or 0)
            self._keep({name: value for name, value in program.variables().items() if name not in ended})

    # --- what the translated code uses

    def _make_globals(self) -> dict[str, Any]:
        return {
            "flag": False,
            "hook": None,
            **dict.fromkeys(self._wanted.values()),
            "check": self._check,
            "stop": _stop,
            "checked": checked,
            "divide": divide,
            "turns": _turns,
            "clash": self._clash,
            "may_declare": self._may_declare,
            "declare": self._declare,
            "leave": _leave,
            "go_on": _go_on,
            "refuse_outside_terminal": _refuse_outside_terminal,
            **{name: getattr(self._actions, name) for name in _ACTIONS},
            **{bearing.name: bearing for bearing in Bearing},
            **{axis.name: axis for axis in Axis},
        }

    def _clash(self, owner: int, typed: str) -> None:
        """A name is declared that was declared already."""
        if owner == EARLIER:
            self._actions.overwritten(typed)
            return
        if owner == PARAMETER:
            raise Refused(Kind.ALREADY_DECLARED, name=typed, what="parameter")
        unit = self._levels.around(sys._getframe(1)).unit
        raise Refused(Kind.ALREADY_DECLARED, name=typed, what="variable", first_line=unit.span(owner).line)

    # --- attention

    def _heed(self, state: ControlState) -> None:
        """The control's state changed: have the translated code look, or look away. Called under its lock."""
        if self._hooked:
            self._globals["flag"] = state is ControlState.STOPPING
            self._set_hook(state)
        else:
            self._globals["flag"] = state is not ControlState.RUNNING

    def _set_hook(self, state: ControlState) -> None:
        """What to call before which statements; as few as possible unless all are traced."""
        lines = self._control.holds_on_lines()
        near: int | None = DEEPEST_CALL
        looks = self._control.looks_before_each
        is_traced = looks or self._trace is not None
        if not is_traced and state in (ControlState.RUNNING, ControlState.RUNNING_TO):
            near = None
        elif not is_traced and state is ControlState.STEPPING_OVER:
            near = int(min(self._control.holds_to_depth(), DEEPEST_CALL))
        wanted = dict.fromkeys(self._wanted.values(), near)
        wanted |= {self._wanted[line]: DEEPEST_CALL for line in lines & self._wanted.keys()}
        looks_away = state is ControlState.RUNNING and not lines and not looks
        self._globals.update(wanted, hook=self._trace if looks_away else self._visit)

    def _visit(self, line: int, column: int, depth: int) -> bool:
        """Before a statement that is wanted. Whether the program must end."""
        if self._must_end(line, depth, column):
            return True
        if self._trace is not None:
            self._trace(line, column, depth)
        return False

    def _check(self) -> bool:
        """Something is wanted at a checkpoint. Whether the program must end."""
        return self._must_end(self._levels.around(sys._getframe(1)).line, 0)

    def _must_end(self, line: int, depth: int, column: int = 0) -> bool:
        try:
            self._control.reached(line, depth, column)
        except Stopped:
            return True
        return False

    # --- procedures

    def _may_declare(self, number: int) -> None:
        """A PROCEDURE was reached: refuse it if this program has another one of that name."""
        unit = self._units[number]
        name = unit.name
        other = self._declared.get(name)
        if other is None and name in self._memory.procedures:
            self._actions.overwritten(unit.typed_name)
        elif other is not None and other is not unit:
            first_line = other.declared.procedure.span.line
            raise Refused(
                Kind.ALREADY_DECLARED, name=unit.typed_name, what="procedure", first_line=first_line
            )

    def _declare(self, number: int) -> None:
        unit = self._units[number]
        self._declared[unit.name] = unit
        self._memory.procedures[unit.name] = unit.declared
        self._bind(unit)

    def _bind_earlier(self) -> None:
        for unit in self._units:
            if unit.procedure is not None and self._is_in_memory(unit):
                self._bind(unit)

    def _is_in_memory(self, unit: Unit) -> bool:
        earlier = self._memory.procedures.get(unit.name)
        return earlier is not None and earlier.procedure is unit.procedure

    def _bind(self, unit: Unit) -> None:
        """Make the procedure callable with the right number of arguments, and refused with any other."""
        for given in self._counts[unit.name]:
            self._globals[procedure_taking(unit.name, given)] = self._callable(unit, given)

    def _callable(self, unit: Unit, given: int) -> Callable[..., None]:
        wanted = len(unit.declared.procedure.parameters)
        if given == wanted:
            return FunctionType(unit.code, self._globals)

        def refuse(*_: int) -> NoReturn:
            raise Refused(Kind.WRONG_ARGUMENT_COUNT, name=unit.typed_name, wanted=wanted, given=given)

        return refuse


def _turns(times: int) -> Iterator[object]:
    """Counts turns without making a number of each."""
    return iter(range(times)) if times > sys.maxsize else repeat(None, max(times, 0))


def _stop() -> NoReturn:
    raise Stopped


def _leave() -> NoReturn:
    raise QuitRequested


def _go_on() -> None:
    """RUN among typed commands: they are running already."""


def _refuse_outside_terminal(typed: str) -> NoReturn:
    raise Refused(Kind.TERMINAL_ONLY, name=typed)


_ENTRIES = 8


class _Left(Exception):
    """The unit was entered and left again."""


def warm_up(units: tuple[Unit, ...]) -> None:
    """Enter each unit often enough. Each begins with a checkpoint, or with a hook if it does anything."""
    attention: dict[str, Any] = {"flag": True, "check": _leave_at_once, "hook": _leave_at_once}
    for unit in units:
        attention |= {wanted_at(line): DEEPEST_CALL for line in unit.lines}
        function = FunctionType(unit.code, attention)
        for _ in range(_ENTRIES):
            with suppress(_Left):
                function(NO_CALLS, *[0] * (unit.code.co_argcount - 1))


def _leave_at_once(*_place: int) -> NoReturn:
    raise _Left
