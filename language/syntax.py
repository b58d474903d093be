"""The typed syntax tree of GoDonnie. Every node has the span of the text that the learner wrote.

Names are folded (lower case, no accents); what was typed is ``program.source[span.start:span.end]``.
"""

from __future__ import annotations

from collections.abc import Iterator
from enum import Enum
from typing import ClassVar, TypeAlias

from devices.ports.robot import Bearing
from devices.ports.values import frozen


class Node:
    """A part of the tree: equal to another one of its class with equal fields.

    Said once for all, because ``dataclass`` compiles each method for each class, a fifth of the time that
    it takes to be ready for a program.
    """

    __slots__ = ()
    __match_args__: ClassVar[tuple[str, ...]] = ()

    def __eq__(self, other: object) -> bool:
        if other.__class__ is not self.__class__:
            return NotImplemented
        return all(getattr(self, name) == getattr(other, name) for name in self.__match_args__)

    def __hash__(self) -> int:
        return hash(tuple(getattr(self, name) for name in self.__match_args__))

    def __repr__(self) -> str:
        fields = (f"{name}={getattr(self, name)!r}" for name in self.__match_args__)
        return f"{type(self).__name__}({', '.join(fields)})"


@frozen
class Span(Node):
    """A stretch of source text: offsets in characters, line and column of its start from 1."""

    start: int
    end: int
    line: int
    column: int


class Axis(Enum):
    """What POS tells."""

    X = "x"
    Y = "y"
    ANGLE = "a"


class Direction(Enum):
    FORWARD = "forward"
    BACKWARD = "backward"


class Side(Enum):
    RIGHT = "right"
    LEFT = "left"


# --- expressions ---------------------------------------------------------------------------------


@frozen
class Number(Node):
    span: Span
    value: int


@frozen
class Name(Node):
    span: Span
    name: str


@frozen
class Negative(Node):
    """One sign before an operand. A plus sign leaves no node."""

    span: Span
    operand: Expression


@frozen
class Binary(Node):
    span: Span
    operator: str
    """One of ``+ - * /``."""
    left: Expression
    right: Expression


@frozen
class Distance(Node):
    span: Span
    bearing: Bearing


@frozen
class Position(Node):
    span: Span
    axis: Axis


@frozen
class Colour(Node):
    span: Span
    colour: str
    """The English word of the colour."""


Expression: TypeAlias = Number | Name | Negative | Binary | Distance | Position | Colour


@frozen
class Condition(Node):
    span: Span
    comparator: str
    """One of ``== <> < > <= >=``."""
    left: Expression
    right: Expression


@frozen
class Text(Node):
    span: Span
    text: str


# --- statements ----------------------------------------------------------------------------------


@frozen
class Declare(Node):
    """VAR name, VAR name = value. ``value`` is None where none is given: the variable starts at 0."""

    span: Span
    name: Name
    value: Expression | None


@frozen
class Assign(Node):
    span: Span
    name: Name
    value: Expression


@frozen
class Speak(Node):
    span: Span
    what: Expression | Text


@frozen
class Sound(Node):
    span: Span
    on: bool


@frozen
class Walk(Node):
    span: Span
    direction: Direction
    steps: Expression


@frozen
class Turn(Node):
    span: Span
    side: Side
    degrees: Expression


@frozen
class Scan(Node):
    span: Span


@frozen
class State(Node):
    span: Span


@frozen
class History(Node):
    span: Span


@frozen
class TellPosition(Node):
    """POS on a line of its own: says the whole pose."""

    span: Span


@frozen
class Unused(Node):
    """A sensor on a line of its own: read by nobody, does nothing; the checker hints at SPEAK."""

    span: Span
    value: Distance | Position | Colour


@frozen
class Wait(Node):
    span: Span
    seconds: Expression


@frozen
class BeltSwitch(Node):
    span: Span
    on: bool


@frozen
class Vibrate(Node):
    span: Span
    bearing: Bearing


@frozen
class Help(Node):
    """HELP, HELP word. ``topic`` is the word as it was typed, or None."""

    span: Span
    topic: str | None


@frozen
class Quit(Node):
    span: Span


@frozen
class RunTyped(Node):
    """RUN: a word of the terminal, as QUIT is."""

    span: Span


@frozen
class If(Node):
    span: Span
    condition: Condition
    then: tuple[Statement, ...]
    otherwise: tuple[Statement, ...] | None


@frozen
class For(Node):
    span: Span
    start: Declare | Assign
    condition: Condition
    step: Assign
    body: tuple[Statement, ...]


@frozen
class Repeat(Node):
    span: Span
    times: Expression
    body: tuple[Statement, ...]


@frozen
class While(Node):
    span: Span
    condition: Condition
    body: tuple[Statement, ...]


@frozen
class Procedure(Node):
    span: Span
    name: Name
    parameters: tuple[Name, ...]
    body: tuple[Statement, ...]


@frozen
class Call(Node):
    span: Span
    name: Name
    arguments: tuple[Expression, ...]


Statement: TypeAlias = (
    Declare
    | Assign
    | Speak
    | Sound
    | Walk
    | Turn
    | Scan
    | State
    | History
    | TellPosition
    | Unused
    | Wait
    | BeltSwitch
    | Vibrate
    | Help
    | Quit
    | RunTyped
    | If
    | For
    | Repeat
    | While
    | Procedure
    | Call
)

Block: TypeAlias = If | For | Repeat | While | Procedure


@frozen
class Program(Node):
    source: str
    body: tuple[Statement, ...]

    def typed(self, span: Span) -> str:
        """What the learner wrote there, white space folded to single blanks."""
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
    """Every statement, blocks before what is in them."""
    for statement in statements:
        yield statement
        for block in blocks_of(statement):
            yield from walk(block)
