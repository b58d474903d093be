"""The typed syntax tree of GoDonnie. Every node has the span of the text that the learner wrote.

Names are folded (lower case, no accents); what was typed is ``program.source[span.start:span.end]``.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from enum import Enum
from typing import TypeAlias

from devices.ports.robot import Bearing


@dataclass(frozen=True, slots=True)
class Span:
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


@dataclass(frozen=True, slots=True)
class Number:
    span: Span
    value: int


@dataclass(frozen=True, slots=True)
class Name:
    span: Span
    name: str


@dataclass(frozen=True, slots=True)
class Negative:
    """One sign before an operand. A plus sign leaves no node."""

    span: Span
    operand: Expression


@dataclass(frozen=True, slots=True)
class Binary:
    span: Span
    operator: str
    """One of ``+ - * /``."""
    left: Expression
    right: Expression


@dataclass(frozen=True, slots=True)
class Distance:
    span: Span
    bearing: Bearing


@dataclass(frozen=True, slots=True)
class Position:
    span: Span
    axis: Axis


@dataclass(frozen=True, slots=True)
class Colour:
    span: Span
    colour: str
    """The English word of the colour."""


Expression: TypeAlias = Number | Name | Negative | Binary | Distance | Position | Colour


@dataclass(frozen=True, slots=True)
class Condition:
    span: Span
    comparator: str
    """One of ``== <> < > <= >=``."""
    left: Expression
    right: Expression


@dataclass(frozen=True, slots=True)
class Text:
    span: Span
    text: str


# --- statements ----------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class Declare:
    """VAR name, VAR name = value. ``value`` is None where none is given: the variable starts at 0."""

    span: Span
    name: Name
    value: Expression | None


@dataclass(frozen=True, slots=True)
class Assign:
    span: Span
    name: Name
    value: Expression


@dataclass(frozen=True, slots=True)
class Speak:
    span: Span
    what: Expression | Text


@dataclass(frozen=True, slots=True)
class Sound:
    span: Span
    on: bool


@dataclass(frozen=True, slots=True)
class Walk:
    span: Span
    direction: Direction
    steps: Expression


@dataclass(frozen=True, slots=True)
class Turn:
    span: Span
    side: Side
    degrees: Expression


@dataclass(frozen=True, slots=True)
class Scan:
    span: Span


@dataclass(frozen=True, slots=True)
class State:
    span: Span


@dataclass(frozen=True, slots=True)
class History:
    span: Span


@dataclass(frozen=True, slots=True)
class TellPosition:
    """POS on a line of its own: says the whole pose."""

    span: Span


@dataclass(frozen=True, slots=True)
class Unused:
    """A sensor on a line of its own: read by nobody, does nothing; the checker hints at SPEAK."""

    span: Span
    value: Distance | Position | Colour


@dataclass(frozen=True, slots=True)
class Wait:
    span: Span
    seconds: Expression


@dataclass(frozen=True, slots=True)
class BeltSwitch:
    span: Span
    on: bool


@dataclass(frozen=True, slots=True)
class Vibrate:
    span: Span
    bearing: Bearing


@dataclass(frozen=True, slots=True)
class Help:
    """HELP, HELP word. ``topic`` is the word as it was typed, or None."""

    span: Span
    topic: str | None


@dataclass(frozen=True, slots=True)
class Quit:
    span: Span


@dataclass(frozen=True, slots=True)
class RunTyped:
    """RUN: a word of the terminal, as QUIT is."""

    span: Span


@dataclass(frozen=True, slots=True)
class If:
    span: Span
    condition: Condition
    then: tuple[Statement, ...]
    otherwise: tuple[Statement, ...] | None


@dataclass(frozen=True, slots=True)
class For:
    span: Span
    start: Declare | Assign
    condition: Condition
    step: Assign
    body: tuple[Statement, ...]


@dataclass(frozen=True, slots=True)
class Repeat:
    span: Span
    times: Expression
    body: tuple[Statement, ...]


@dataclass(frozen=True, slots=True)
class While:
    span: Span
    condition: Condition
    body: tuple[Statement, ...]


@dataclass(frozen=True, slots=True)
class Procedure:
    span: Span
    name: Name
    parameters: tuple[Name, ...]
    body: tuple[Statement, ...]


@dataclass(frozen=True, slots=True)
class Call:
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


@dataclass(frozen=True, slots=True)
class Program:
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
