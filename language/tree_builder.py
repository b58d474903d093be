"""Builds the syntax tree: one method for each alternative of grammar.lark.

The parser calls the method that the grammar names with the parts: nodes, lists of nodes and the lexer's
tokens (kind, start, end, line, column, folded text). A span reaches from the first part to the last.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from msgspec.structs import replace

from devices.ports.robot import Bearing
from language import syntax
from language.keywords import argument
from language.lexer import KIND, Token, span_of
from language.syntax import Binary, Condition, Direction, Name, Negative, NumberLiteral, Side, Span

MOST_LEVELS = 200
"""Of an expression: signs and operators in each other. Recursive functions may walk the tree."""

_CHUNK = 500
"""Digits that Python converts at once, whatever its own limit is."""

_DIRECTIONS = {KIND["FW"]: Direction.FORWARD, KIND["BW"]: Direction.BACKWARD}
_SIDES = {KIND["TR"]: Side.RIGHT, KIND["TL"]: Side.LEFT}


class TooDeep(Exception):
    """An expression has too many levels. ``span`` is its place."""

    def __init__(self, span: Span) -> None:
        super().__init__()
        self.span = span


def _alone(node: Callable[..., syntax.Node], *parts: str) -> staticmethod[[Token], Any]:
    """The method for a command of one word."""
    return staticmethod(lambda word: node(span_of(word), *parts))


def _with(node: Callable[..., syntax.Node], terminal: str) -> staticmethod[[Token, Token], Any]:
    """The method for a word and another one of that terminal."""
    return staticmethod(lambda word, part: node(_tokens_span(word, part), _value(terminal, part)))


class TreeBuilder:
    """Builds the tree of one text, which it needs for the strings in it."""

    def __init__(self, source: str) -> None:
        self._source = source
        self._levels: dict[int, int] = {}
        """The number of levels of each long expression, by its identity."""

    # --- lists ---------------------------------------------------------------------------------------

    @staticmethod
    def none() -> list[Any]:
        return []

    @staticmethod
    def more(statements: list[Any], statement: Any) -> list[Any]:
        statements.append(statement)
        return statements

    @staticmethod
    def first_part(statements: list[Any], _semicolon: Token) -> list[Any]:
        return statements

    @staticmethod
    def first(expression: Any) -> list[Any]:
        return [expression]

    @staticmethod
    def next_(expressions: list[Any], _comma: Token, expression: Any) -> list[Any]:
        expressions.append(expression)
        return expressions

    @staticmethod
    def first_name(name: Token) -> list[Name]:
        return [_name(name)]

    @staticmethod
    def next_name(names: list[Name], _comma: Token, name: Token) -> list[Name]:
        names.append(_name(name))
        return names

    # --- expressions ---------------------------------------------------------------------------------

    @staticmethod
    def number(token: Token) -> NumberLiteral:
        _, start, end, line, column, digits = token
        value = int(digits) if end - start < _CHUNK else _long(digits)
        return NumberLiteral(Span(start, end, line, column), value)

    @staticmethod
    def name(token: Token) -> Name:
        _, start, end, line, column, text = token
        return Name(Span(start, end, line, column), text)

    def signed(self, sign: Token, operand: Any) -> Any:
        whole = _to(sign, operand)
        made = replace(operand, span=whole) if sign[5] == "+" else Negative(whole, operand)
        return self._limited(made) if whole.end - whole.start >= MOST_LEVELS else made

    def binary(self, left: Any, operator: Token, right: Any) -> Any:
        whole = _between(left, right)
        made = Binary(whole, operator[5], left, right)
        return self._limited(made) if whole.end - whole.start >= MOST_LEVELS else made

    def parenthesised(self, opening: Token, inner: Any, closing: Token) -> Any:
        whole = _tokens_span(opening, closing)
        made = replace(inner, span=whole)
        return self._limited(made) if whole.end - whole.start >= MOST_LEVELS else made

    def _limited(self, node: Any) -> Any:
        """The node; raises ``TooDeep``. Only a text as long as the limit can have so many levels."""
        level = 1 + max(map(self._level, _operands(node)), default=0)
        if level > MOST_LEVELS:
            raise TooDeep(node.span)
        self._levels[id(node)] = level
        return node

    def _level(self, node: Any) -> int:
        operands = _operands(node)
        if not operands:
            return 1
        if node.span.end - node.span.start >= MOST_LEVELS:
            return self._levels[id(node)]
        return 1 + max(map(self._level, operands))

    @staticmethod
    def distance(word: Token, direction: Token | None = None) -> syntax.DistanceSensor:
        bearing = _value("DIRECTION", direction) if direction else Bearing.FRONT
        return syntax.DistanceSensor(_tokens_span(word, direction or word), bearing)

    def named_distance(self, word: Token, string: Token) -> syntax.NamedDistanceSensor:
        name = self._source[string[1] + 1 : string[2] - 1]
        return syntax.NamedDistanceSensor(_tokens_span(word, string), " ".join(name.split()))

    position = _with(syntax.PositionSensor, "AXIS")
    colour = _with(syntax.ColourSensor, "COLOUR")

    @staticmethod
    def condition(left: Any, comparator: Token, right: Any) -> Condition:
        return Condition(_between(left, right), comparator[5], left, right)

    # --- commands ------------------------------------------------------------------------------------

    @staticmethod
    def declare(var: Token, new: Token, _equals: Token | None = None, value: Any = None) -> syntax.Declare:
        declared = _name(new)
        return syntax.Declare(_to(var, value or declared), declared, value)

    @staticmethod
    def assign(target: Token, _equals: Token, value: Any) -> syntax.Assign:
        return syntax.Assign(_to(target, value), _name(target), value)

    @staticmethod
    def call(called: Token, _opening: Token, *rest: Any) -> syntax.Call:
        *arguments, closing = rest
        return syntax.Call(_tokens_span(called, closing), _name(called), tuple(*arguments))

    @staticmethod
    def speak(word: Token, what: Any) -> syntax.SpeakCommand:
        return syntax.SpeakCommand(_to(word, what), what)

    def speak_text(self, word: Token, string: Token) -> syntax.SpeakCommand:
        said = self._source[string[1] + 1 : string[2] - 1]
        if "\r" in said:
            said = said.replace("\r\n", "\n").replace("\r", "\n")
        return syntax.SpeakCommand(_tokens_span(word, string), syntax.TextLiteral(span_of(string), said))

    sound = _with(syntax.SoundCommand, "SWITCH")

    @staticmethod
    def walk(word: Token, steps: Any) -> syntax.WalkCommand:
        return syntax.WalkCommand(_to(word, steps), _DIRECTIONS[word[0]], steps)

    @staticmethod
    def turn(word: Token, degrees: Any) -> syntax.TurnCommand:
        return syntax.TurnCommand(_to(word, degrees), _SIDES[word[0]], degrees)

    scan = _alone(syntax.ActionCommand, "scan")
    state = _alone(syntax.ActionCommand, "state")
    history = _alone(syntax.ActionCommand, "history")
    grip = _alone(syntax.ActionCommand, "grip")
    release = _alone(syntax.ActionCommand, "release")
    pose = _alone(syntax.ActionCommand, "announce_pose")

    @staticmethod
    def unused(sensor: Any) -> syntax.UnusedSensor:
        return syntax.UnusedSensor(sensor.span, sensor)

    @staticmethod
    def wait(word: Token, seconds: Any) -> syntax.WaitCommand:
        return syntax.WaitCommand(_to(word, seconds), seconds)

    belt = _with(syntax.BeltCommand, "SWITCH")
    vibrate = _with(syntax.VibrateCommand, "DIRECTION")

    def help_(self, word: Token, topic: Token | None = None) -> syntax.HelpCommand:
        typed = " ".join(self._source[topic[1] : topic[2]].split()) if topic else None
        return syntax.HelpCommand(_tokens_span(word, topic or word), typed)

    quit_ = _alone(syntax.QuitCommand)
    run = _alone(syntax.RunCommand)

    # --- blocks --------------------------------------------------------------------------------------

    @staticmethod
    def if_(word: Token, test: Condition, _then: Token, body: list[Any], *rest: Any) -> syntax.If:
        *others, end = rest
        otherwise = tuple(others[1]) if others else None
        return syntax.If(_tokens_span(word, end), test, tuple(body), otherwise)

    @staticmethod
    def for_(word: Token, start: Any, _1: Token, test: Condition, _2: Token, *rest: Any) -> syntax.For:
        step, _do, body, end = rest
        return syntax.For(_tokens_span(word, end), start, test, step, tuple(body))

    @staticmethod
    def repeat(word: Token, times: Any, _times: Token, *rest: Any) -> syntax.Repeat:
        *_do, body, end = rest
        return syntax.Repeat(_tokens_span(word, end), times, tuple(body))

    @staticmethod
    def while_(word: Token, test: Condition, _do: Token, body: list[Any], end: Token) -> syntax.While:
        return syntax.While(_tokens_span(word, end), test, tuple(body))

    @staticmethod
    def procedure(word: Token, new: Token, *rest: Any) -> syntax.Procedure:
        *parameters, _do, body, end = rest
        names = tuple(parameters[1]) if parameters else ()
        return syntax.Procedure(_tokens_span(word, end), _name(new), names, tuple(body))


def _name(token: Token) -> Name:
    return Name(span_of(token), token[5])


def _value(terminal: str, token: Token) -> Any:
    """Any: a bearing, an axis, a colour or a switch, as the terminal says."""
    found = argument(terminal, token[5])
    assert found is not None, "the lexer makes that terminal of such a word only"
    return found.value


def _tokens_span(first: Token, last: Token) -> Span:
    return Span(first[1], last[2], first[3], first[4])


def _to(first: Token, last: Any) -> Span:
    return Span(first[1], last.span.end, first[3], first[4])


def _between(left: Any, right: Any) -> Span:
    first: Span = left.span
    return Span(first.start, right.span.end, first.line, first.column)


def _long(digits: str) -> int:
    value = 0
    for start in range(0, len(digits), _CHUNK):
        chunk = digits[start : start + _CHUNK]
        value = value * 10 ** len(chunk) + int(chunk)
    return value


def _operands(node: Any) -> tuple[Any, ...]:
    match node:
        case Binary(left=left, right=right):
            return (left, right)
        case Negative(operand=operand):
            return (operand,)
        case _:
            return ()
