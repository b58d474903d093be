"""An interpreter that walks the tree: the reference for the compiler, and a short definition of GoDonnie.

It is slow, and only tests use it. Every statement is a checkpoint, so it can always be paused, stepped and
traced.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import TypeVar

from language.call_stack import DEEPEST_CALL, raise_recursion_limit
from language.control import ControlState, ExecutionControl
from language.diagnostics import (
    ActionRefused,
    CallSite,
    Diagnostic,
    MistakeKind,
    ProgramError,
    QuitRequested,
    Stopped,
    mistake_at,
)
from language.numbers import checked, divide
from language.runtime import Actions, Frame, Memory, Runnable, Trace, shown_frames
from language.suggestions import undeclared_procedure, undeclared_variable
from language.syntax import (
    ActionCommand,
    Assign,
    BeltCommand,
    Binary,
    Call,
    ColourSensor,
    Condition,
    Declare,
    DeclaredProcedure,
    Direction,
    DistanceSensor,
    Expression,
    For,
    HelpCommand,
    If,
    Name,
    NamedDistanceSensor,
    Negative,
    NumberLiteral,
    PositionSensor,
    Procedure,
    Program,
    QuitCommand,
    Repeat,
    RunCommand,
    Side,
    SoundCommand,
    Span,
    SpeakCommand,
    Statement,
    TextLiteral,
    TurnCommand,
    UnusedSensor,
    VibrateCommand,
    WaitCommand,
    WalkCommand,
    While,
)

_COMPARE: dict[str, Callable[[int, int], bool]] = {
    "==": lambda left, right: left == right,
    "<>": lambda left, right: left != right,
    "<": lambda left, right: left < right,
    ">": lambda left, right: left > right,
    "<=": lambda left, right: left <= right,
    ">=": lambda left, right: left >= right,
}

_CALCULATE: dict[str, Callable[[int, int], int]] = {
    "+": lambda left, right: checked(left + right),
    "-": lambda left, right: checked(left - right),
    "*": lambda left, right: checked(left * right),
    "/": divide,
}

_Result = TypeVar("_Result")

_EARLIER = "earlier"
_PARAMETER = "parameter"


@dataclass(slots=True)
class _Level:
    """The program or one open call: its variables, and who declared each."""

    program: Program
    procedure: str
    line: int
    variables: dict[str, int] = field(default_factory=dict)
    owners: dict[str, Declare | str] = field(default_factory=dict)


def interpreted_program(program: Program, *, terminal: bool = False) -> Runnable:
    """As ``compile_program`` with hooks."""
    return _InterpretedProgram(program, terminal=terminal)


class _InterpretedProgram:
    def __init__(self, program: Program, *, terminal: bool) -> None:
        self._program = program
        self._terminal = terminal
        self._running: _Run | None = None

    def run(
        self, actions: Actions, control: ExecutionControl, memory: Memory, *, trace: Trace | None = None
    ) -> None:
        raise_recursion_limit()
        if not self._terminal:
            memory.variables, memory.procedures = {}, {}
        self._running = _Run(self._program, actions, control, memory, trace, terminal=self._terminal)
        try:
            self._running.run()
        finally:
            self._running = None
            control.ended()

    def frames(self) -> tuple[Frame, ...]:
        running = self._running
        return () if running is None else running.frames()

    def progress(self) -> object:
        """Never equal to another one."""
        return object()


class _Run:
    """One run: a stack of levels and a method for each kind of statement."""

    def __init__(
        self,
        program: Program,
        actions: Actions,
        control: ExecutionControl,
        memory: Memory,
        trace: Trace | None,
        *,
        terminal: bool,
    ) -> None:
        self._actions = actions
        self._control = control
        self._memory = memory
        self._trace = trace
        self._terminal = terminal
        self._declared_here: dict[str, Procedure] = {}
        stored = dict(memory.variables)
        self._levels = [_Level(program, "", 1, stored, dict.fromkeys(stored, _EARLIER))]

    def run(self) -> None:
        program = self._levels[0]
        try:
            self._block(program.program.body)
        finally:
            self._memory.variables = dict(program.variables)

    def frames(self) -> tuple[Frame, ...]:
        return tuple(
            Frame(level.procedure, level.line, tuple(level.variables.items()))
            for level in shown_frames(list(self._levels))
        )

    # --- statements

    def _block(self, statements: tuple[Statement, ...]) -> None:
        for statement in statements:
            self._visit(statement)
            self._statement(statement)

    def _visit(self, statement: Statement) -> None:
        span, depth = statement.span, len(self._levels) - 1
        self._levels[-1].line = span.line
        self._control.reached(span.line, depth, span.column)
        if self._trace is not None:
            self._trace(span.line, span.column, depth)

    def _statement(self, statement: Statement) -> None:
        match statement:
            case Declare():
                self._declare(statement)
            case Assign():
                self._assign(statement)
            case If(condition=condition, then=then, otherwise=otherwise):
                self._block(then if self._holds(condition) else otherwise or ())
            case While():
                while self._holds(statement.condition):
                    self._turn(statement)
            case Repeat(times=times):
                left = self._value(times)
                while left > 0:
                    self._turn(statement)
                    left -= 1
            case For():
                self._for(statement)
            case Procedure():
                self._procedure(statement)
            case Call():
                self._call(statement)
            case UnusedSensor():
                pass
            case _:
                self._refusable(statement.span, lambda: self._command(statement))
                self._look_for_stop()

    def _turn(self, loop: While | Repeat | For) -> None:
        self._block(loop.body)
        self._visit(loop)

    def _look_for_stop(self) -> None:
        """After a command: it may have been cut short."""
        if self._control.state is ControlState.STOPPING:
            raise Stopped

    # --- variables

    def _declare(self, declare: Declare) -> None:
        level, name = self._levels[-1], declare.name.name
        owner = level.owners.get(name)
        if owner is not declare:
            self._refuse_clash(declare.name, owner)
        level.variables[name] = 0 if declare.value is None else self._value(declare.value)
        level.owners[name] = declare

    def _refuse_clash(self, name: Name, owner: Declare | str | None) -> None:
        typed = self._levels[-1].program.typed(name.span)
        match owner:
            case None:
                return
            case "earlier":
                self._actions.overwritten(typed)
            case Declare():
                raise self._mistake(
                    name.span,
                    MistakeKind.ALREADY_DECLARED,
                    name=typed,
                    what="variable",
                    first_line=owner.span.line,
                )
            case _:
                raise self._mistake(name.span, MistakeKind.ALREADY_DECLARED, name=typed, what="parameter")

    def _assign(self, assignment: Assign) -> None:
        self._variable(assignment.name)
        self._levels[-1].variables[assignment.name.name] = self._value(assignment.value)

    def _for(self, loop: For) -> None:
        if isinstance(loop.start, Assign):
            self._assign(loop.start)
            self._turns(loop)
            return
        level, name = self._levels[-1], loop.start.name.name
        self._refuse_clash(loop.start.name, level.owners.get(name))
        level.variables[name] = 0 if loop.start.value is None else self._value(loop.start.value)
        level.owners[name] = loop.start
        try:
            self._turns(loop)
        finally:
            del level.variables[name], level.owners[name]

    def _turns(self, loop: For) -> None:
        while self._holds(loop.condition):
            self._turn(loop)
            self._assign(loop.step)

    def _variable(self, name: Name) -> int:
        level = self._levels[-1]
        if name.name not in level.variables:
            of_program = self._levels[0].variables
            found = undeclared_variable(level.program, name, level.variables, level.procedure, of_program)
            raise self._error(found)
        return level.variables[name.name]

    # --- procedures

    def _procedure(self, procedure: Procedure) -> None:
        name, program = procedure.name, self._levels[-1].program
        other = self._declared_here.get(name.name)
        if other is None and name.name in self._memory.procedures:
            self._actions.overwritten(program.typed(name.span))
        elif other is not None and other is not procedure:
            details: dict[str, str | int] = {"what": "procedure", "first_line": other.span.line}
            raise self._mistake(
                name.span, MistakeKind.ALREADY_DECLARED, name=program.typed(name.span), **details
            )
        seen: set[str] = set()
        for parameter in procedure.parameters:
            if parameter.name in seen:
                self._refuse_clash(parameter, _PARAMETER)
            seen.add(parameter.name)
        self._declared_here[name.name] = procedure
        self._memory.procedures[name.name] = DeclaredProcedure(procedure, program)

    def _call(self, call: Call) -> None:
        program, span = self._levels[-1].program, call.name.span
        declared = self._memory.procedures.get(call.name.name)
        if declared is None:
            raise self._error(undeclared_procedure(program, call.name, self._memory.procedures))
        if len(self._levels) > DEEPEST_CALL:
            raise self._mistake(span, MistakeKind.RECURSION_LIMIT, limit=DEEPEST_CALL)
        values = [self._value(argument) for argument in call.arguments]
        parameters = declared.procedure.parameters
        if len(values) != len(parameters):
            details = {"wanted": len(parameters), "given": len(values)}
            raise self._mistake(span, MistakeKind.WRONG_ARGUMENT_COUNT, name=declared.typed_name, **details)
        names = [parameter.name for parameter in parameters]
        variables = dict(zip(names, values, strict=True))
        owners: dict[str, Declare | str] = dict.fromkeys(names, _PARAMETER)
        self._levels.append(
            _Level(declared.program, declared.typed_name, declared.procedure.span.line, variables, owners)
        )
        self._block(declared.procedure.body)
        self._levels.pop()

    # --- commands

    def _command(self, statement: Statement) -> None:
        do, value = self._actions, self._value
        typed = self._levels[-1].program.typed(statement.span)
        match statement:
            case SpeakCommand(what=what):
                do.speak(what.text if isinstance(what, TextLiteral) else value(what))
            case WalkCommand(direction=direction, steps=steps):
                go = do.forward if direction is Direction.FORWARD else do.backward
                go(value(steps), typed)
            case TurnCommand(side=side, degrees=degrees):
                turn = do.turn_right if side is Side.RIGHT else do.turn_left
                turn(value(degrees), typed)
            case WaitCommand(seconds=seconds):
                do.wait(value(seconds))
            case SoundCommand(on=on):
                do.sound(on)
            case BeltCommand(on=on):
                do.belt(on)
            case VibrateCommand(bearing=bearing):
                do.vibrate(bearing)
            case HelpCommand(topic=topic):
                do.help(topic)
            case ActionCommand(action=action):
                getattr(do, action)()
            case QuitCommand() | RunCommand() if not self._terminal:
                raise ActionRefused(MistakeKind.TERMINAL_ONLY, name=typed)
            case QuitCommand():
                raise QuitRequested

    # --- expressions

    def _holds(self, condition: Condition) -> bool:
        left = self._value(condition.left)
        return _COMPARE[condition.comparator](left, self._value(condition.right))

    def _value(self, expression: Expression) -> int:
        match expression:
            case NumberLiteral(value=value):
                return value
            case Name():
                return self._variable(expression)
            case Negative(operand=operand):
                return -self._value(operand)
            case Binary(operator=operator, left=left, right=right):
                first, second = self._value(left), self._value(right)
                return self._refusable(expression.span, lambda: _CALCULATE[operator](first, second))
            case DistanceSensor(bearing=bearing):
                return self._refusable(expression.span, lambda: self._actions.distance(bearing))
            case NamedDistanceSensor(name=name):
                return self._refusable(expression.span, lambda: self._actions.named_distance(name))
            case PositionSensor(axis=axis):
                return self._refusable(expression.span, lambda: self._actions.position(axis))
            case ColourSensor(colour=colour):
                return self._refusable(expression.span, lambda: self._actions.colour(colour))

    # --- mistakes

    def _refusable(self, span: Span, do: Callable[[], _Result]) -> _Result:
        """What ``do`` returns; a refusal gets its place."""
        try:
            return do()
        except ActionRefused as refused:
            refusal = refused
        raise self._mistake(span, refusal.kind, **refusal.details)

    def _mistake(self, span: Span, kind: MistakeKind, **details: str | int) -> ProgramError:
        return self._error(mistake_at(self._levels[-1].program, span, kind, details))

    def _error(self, found: Diagnostic) -> ProgramError:
        pairs = zip(self._levels[-2::-1], self._levels[:0:-1], strict=True)
        return ProgramError(found, tuple(CallSite(callee.procedure, caller.line) for caller, callee in pairs))
