"""The typed syntax tree of GoDonnie. Every node has the span of the text that the learner wrote.

Names are folded (lower case, no accents); the typed name is ``program.source[span.start:span.end]``.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from enum import Enum, auto
from typing import TypeAlias

from msgspec import Struct

from devices.ports.robot import Bearing


class Span(Struct, frozen=True):
    """A stretch of source text: offsets in characters, line and column of its start from 1."""

    start: int
    end: int
    line: int
    column: int


class Node(Struct, frozen=True):
    """A part of the tree."""

    span: Span


class Axis(Enum):
    """The parts of the pose that POS reads."""

    X = "x"
    Y = "y"
    ANGLE = "a"


class Direction(Enum):
    FORWARD = auto()
    BACKWARD = auto()


class Side(Enum):
    RIGHT = auto()
    LEFT = auto()


# --- expressions ---------------------------------------------------------------------------------


class NumberLiteral(Node, frozen=True):
    value: int


class TextLiteral(Node, frozen=True):
    text: str


class Name(Node, frozen=True):
    name: str


class Negative(Node, frozen=True):
    """One sign before an operand. A plus sign leaves no node."""

    operand: Expression


class Binary(Node, frozen=True):
    operator: str
    """One of ``+ - * /``."""
    left: Expression
    right: Expression


class DistanceSensor(Node, frozen=True):
    bearing: Bearing


class NamedDistanceSensor(Node, frozen=True):
    name: str
    """A ranger's name in the robot's world, as it was typed."""


class PositionSensor(Node, frozen=True):
    axis: Axis


class ColourSensor(Node, frozen=True):
    colour: str
    """The English word of the colour."""


Sensor: TypeAlias = DistanceSensor | NamedDistanceSensor | PositionSensor | ColourSensor
Expression: TypeAlias = NumberLiteral | Name | Negative | Binary | Sensor


class Condition(Node, frozen=True):
    comparator: str
    """One of ``== <> < > <= >=``."""
    left: Expression
    right: Expression


# --- statements ----------------------------------------------------------------------------------


class Declare(Node, frozen=True):
    """VAR name, VAR name = value. Without a value the variable starts at 0."""

    name: Name
    value: Expression | None


class Assign(Node, frozen=True):
    name: Name
    value: Expression


class SpeakCommand(Node, frozen=True):
    what: Expression | TextLiteral


class SoundCommand(Node, frozen=True):
    on: bool


class WalkCommand(Node, frozen=True):
    direction: Direction
    steps: Expression


class TurnCommand(Node, frozen=True):
    side: Side
    degrees: Expression


class ActionCommand(Node, frozen=True):
    """A command of one word: SCAN, STATE, HISTORY, GRIP, RELEASE, and POS, which announces the whole pose."""

    action: str
    """The name of the action."""


class UnusedSensor(Node, frozen=True):
    """A sensor on a line of its own: does nothing; the checker hints at SPEAK."""

    value: Sensor


class WaitCommand(Node, frozen=True):
    seconds: Expression


class BeltCommand(Node, frozen=True):
    on: bool


class VibrateCommand(Node, frozen=True):
    bearing: Bearing


class HelpCommand(Node, frozen=True):
    """HELP, HELP word. ``topic`` is the word as it was typed, or None."""

    topic: str | None


class QuitCommand(Node, frozen=True):
    pass


class RunCommand(Node, frozen=True):
    """RUN: a word of the terminal, as QUIT is."""


class If(Node, frozen=True):
    condition: Condition
    then: tuple[Statement, ...]
    otherwise: tuple[Statement, ...] | None


class For(Node, frozen=True):
    start: Declare | Assign
    condition: Condition
    step: Assign
    body: tuple[Statement, ...]


class Repeat(Node, frozen=True):
    times: Expression
    body: tuple[Statement, ...]


class While(Node, frozen=True):
    condition: Condition
    body: tuple[Statement, ...]


class Procedure(Node, frozen=True):
    name: Name
    parameters: tuple[Name, ...]
    body: tuple[Statement, ...]


class Call(Node, frozen=True):
    name: Name
    arguments: tuple[Expression, ...]


Command: TypeAlias = (
    SpeakCommand
    | SoundCommand
    | WalkCommand
    | TurnCommand
    | ActionCommand
    | WaitCommand
    | BeltCommand
    | VibrateCommand
    | HelpCommand
    | QuitCommand
    | RunCommand
)
Block: TypeAlias = If | For | Repeat | While | Procedure
Statement: TypeAlias = Declare | Assign | Call | UnusedSensor | Command | Block


class Program(Struct, frozen=True):
    source: str
    body: tuple[Statement, ...]

    def typed(self, span: Span) -> str:
        """The learner's text at a span, white space folded to single blanks."""
        return " ".join(self.source[span.start : span.end].split())


def blocks_of(statement: Statement) -> tuple[tuple[Statement, ...], ...]:
    """The statement lists inside a statement, in the order of the text."""
    match statement:
        case If(then=then, otherwise=otherwise):
            return (then,) if otherwise is None else (then, otherwise)
        case For(body=body) | Repeat(body=body) | While(body=body) | Procedure(body=body):
            return (body,)
        case _:
            return ()


def walk(statements: tuple[Statement, ...]) -> Iterator[Statement]:
    """Every statement, blocks before their contents."""
    for statement in statements:
        yield statement
        for block in blocks_of(statement):
            yield from walk(block)


# --- scopes --------------------------------------------------------------------------------------


class DeclaredProcedure(Struct, frozen=True):
    """A procedure and the program that declared it, as a later batch finds it in the memory."""

    procedure: Procedure
    program: Program

    @property
    def typed_name(self) -> str:
        return self.program.typed(self.procedure.name.span)


class Scope(Struct, frozen=True):
    """A program without its procedures, or one procedure without those that are declared in it.

    Each scope has variables of its own.
    """

    program: Program
    procedure: Procedure | None

    @property
    def body(self) -> tuple[Statement, ...]:
        return self.program.body if self.procedure is None else self.procedure.body

    @property
    def parameters(self) -> tuple[Name, ...]:
        return () if self.procedure is None else self.procedure.parameters

    def statements(self) -> Iterator[Statement]:
        """Every statement of this scope, in no particular order; a procedure in it counts as one."""
        pending = list(self.body)
        while pending:
            statement = pending.pop()
            yield statement
            if not isinstance(statement, Procedure):
                for block in blocks_of(statement):
                    pending.extend(block)

    def declarations(self) -> Counter[str]:
        """How many parameters, VAR statements and FOR headers declare each name."""
        names = Counter(parameter.name for parameter in self.parameters)
        for statement in self.statements():
            start = statement.start if isinstance(statement, For) else statement
            if isinstance(start, Declare):
                names[start.name.name] += 1
        return names

    def calls(self) -> frozenset[str]:
        """The names of the procedures that the scope may call."""
        return frozenset(each.name.name for each in self.statements() if isinstance(each, Call))


def scopes_of(outermost: Scope) -> tuple[Scope, ...]:
    """The scope itself, then every procedure declared in it or in one of those."""
    found = [outermost]
    for scope in found:
        found.extend(
            Scope(scope.program, statement)
            for statement in scope.statements()
            if isinstance(statement, Procedure)
        )
    return tuple(found)
