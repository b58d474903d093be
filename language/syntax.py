"""The typed syntax tree of GoDonnie. Every node has the span of the text that the learner wrote.

Names are folded (lower case, no accents); what was typed is ``program.source[span.start:span.end]``.
"""

from __future__ import annotations

from collections.abc import Iterator
from enum import Enum

from devices.ports.hints import TypeAlias
from devices.ports.robot import Bearing
from devices.ports.values import Frozen


class Node:
    """A part of the tree."""

    __slots__ = ()


class Span(Node, Frozen):
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


class Number(Node, Frozen):
    span: Span
    value: int


class Name(Node, Frozen):
    span: Span
    name: str


class Negative(Node, Frozen):
    """One sign before an operand. A plus sign leaves no node."""

    span: Span
    operand: Expression


class Binary(Node, Frozen):
    span: Span
    operator: str
    """One of ``+ - * /``."""
    left: Expression
    right: Expression


class Distance(Node, Frozen):
    span: Span
    bearing: Bearing


class Position(Node, Frozen):
    span: Span
    axis: Axis


class Colour(Node, Frozen):
    span: Span
    colour: str
    """The English word of the colour."""


Expression: TypeAlias = Number | Name | Negative | Binary | Distance | Position | Colour


class Condition(Node, Frozen):
    span: Span
    comparator: str
    """One of ``== <> < > <= >=``."""
    left: Expression
    right: Expression


class Text(Node, Frozen):
    span: Span
    text: str


# --- statements ----------------------------------------------------------------------------------


class Declare(Node, Frozen):
    """VAR name, VAR name = value. ``value`` is None where none is given: the variable starts at 0."""

    span: Span
    name: Name
    value: Expression | None


class Assign(Node, Frozen):
    span: Span
    name: Name
    value: Expression


class Speak(Node, Frozen):
    span: Span
    what: Expression | Text


class Sound(Node, Frozen):
    span: Span
    on: bool


class Walk(Node, Frozen):
    span: Span
    direction: Direction
    steps: Expression


class Turn(Node, Frozen):
    span: Span
    side: Side
    degrees: Expression


class Scan(Node, Frozen):
    span: Span


class State(Node, Frozen):
    span: Span


class History(Node, Frozen):
    span: Span


class TellPosition(Node, Frozen):
    """POS on a line of its own: says the whole pose."""

    span: Span


class Unused(Node, Frozen):
    """A sensor on a line of its own: read by nobody, does nothing; the checker hints at SPEAK."""

    span: Span
    value: Distance | Position | Colour


class Wait(Node, Frozen):
    span: Span
    seconds: Expression


class BeltSwitch(Node, Frozen):
    span: Span
    on: bool


class Vibrate(Node, Frozen):
    span: Span
    bearing: Bearing


class Help(Node, Frozen):
    """HELP, HELP word. ``topic`` is the word as it was typed, or None."""

    span: Span
    topic: str | None


class Quit(Node, Frozen):
    span: Span


class RunTyped(Node, Frozen):
    """RUN: a word of the terminal, as QUIT is."""

    span: Span


class If(Node, Frozen):
    span: Span
    condition: Condition
    then: tuple[Statement, ...]
    otherwise: tuple[Statement, ...] | None


class For(Node, Frozen):
    span: Span
    start: Declare | Assign
    condition: Condition
    step: Assign
    body: tuple[Statement, ...]


class Repeat(Node, Frozen):
    span: Span
    times: Expression
    body: tuple[Statement, ...]


class While(Node, Frozen):
    span: Span
    condition: Condition
    body: tuple[Statement, ...]


class Procedure(Node, Frozen):
    span: Span
    name: Name
    parameters: tuple[Name, ...]
    body: tuple[Statement, ...]


class Call(Node, Frozen):
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


class Program(Node, Frozen):
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
