"""What each alternative of grammar.lark makes of its parts.

The parser calls the function that the grammar names. Parts are nodes, lists of nodes and, where a terminal
stands, the lexer's token: kind, start, end, line, column, folded text. The spans are the learner's text from
the first part to the last.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from devices.ports.robot import Bearing
from language import syntax
from language.keywords import argument
from language.lexer import KIND, Token
from language.syntax import Binary, Condition, Direction, Name, Negative, Number, Side, Span

MOST_LEVELS = 200
"""Of an expression: signs and operators in each other. What walks the tree may do so recursively."""

_CHUNK = 500
"""Digits that every Python converts at once, however its own limit is set."""

_DIRECTIONS = {KIND["FW"]: Direction.FORWARD, KIND["BW"]: Direction.BACKWARD}
_SIDES = {KIND["TR"]: Side.RIGHT, KIND["TL"]: Side.LEFT}


class TooDeep(Exception):
    """An expression has too many levels. ``span`` is where it is."""

    def __init__(self, span: Span) -> None:
        super().__init__()
        self.span = span


class Reductions:
    """The functions by their names in the grammar. Made for one text, because a string needs it."""

    def __init__(self, source: str) -> None:
        self._source = source
        self._levels: dict[int, int] = {}
        """How many levels a long expression has, by its identity."""

    def functions(self, names: list[str]) -> list[Callable[[list[Any]], Any] | None]:
        """In the order of ``names``; None for an empty name."""
        return [getattr(self, name) if name else None for name in names]

    # --- lists ---------------------------------------------------------------------------------------

    @staticmethod
    def none(_parts: list[Any]) -> list[Any]:
        return []

    @staticmethod
    def more(parts: list[Any]) -> Any:
        parts[0].append(parts[1])
        return parts[0]

    @staticmethod
    def hand_on_first(parts: list[Any]) -> Any:
        return parts[0]

    @staticmethod
    def first(parts: list[Any]) -> list[Any]:
        return [parts[0]]

    @staticmethod
    def next_(parts: list[Any]) -> Any:
        parts[0].append(parts[2])
        return parts[0]

    @staticmethod
    def first_name(parts: list[Any]) -> list[Name]:
        return [_name(parts[0])]

    @staticmethod
    def next_name(parts: list[Any]) -> Any:
        parts[0].append(_name(parts[2]))
        return parts[0]

    # --- expressions ---------------------------------------------------------------------------------

    @staticmethod
    def number(parts: list[Token]) -> Number:
        _, start, end, line, column, digits = parts[0]
        return Number(Span(start, end, line, column), int(digits) if end - start < _CHUNK else _long(digits))

    @staticmethod
    def name(parts: list[Token]) -> Name:
        _, start, end, line, column, text = parts[0]
        return Name(Span(start, end, line, column), text)

    def signed(self, parts: list[Any]) -> Any:
        sign, operand = parts
        whole = _to(sign, operand)
        made = _respanned(operand, whole) if sign[5] == "+" else Negative(whole, operand)
        return self._limited(made) if whole.end - whole.start >= MOST_LEVELS else made

    def binary(self, parts: list[Any]) -> Any:
        left, operator, right = parts
        whole = _between(left, right)
        made = Binary(whole, operator[5], left, right)
        return self._limited(made) if whole.end - whole.start >= MOST_LEVELS else made

    def parenthesised(self, parts: list[Any]) -> Any:
        whole = _tokens_span(parts[0], parts[2])
        made = _respanned(parts[1], whole)
        return self._limited(made) if whole.end - whole.start >= MOST_LEVELS else made

    def _limited(self, node: Any) -> Any:
        """The node, unless it has too many levels. Asked only where the text is long enough for that."""
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
    def distance(parts: list[Token]) -> syntax.Distance:
        bearing = _value("DIRECTION", parts[1]) if len(parts) > 1 else Bearing.FRONT
        return syntax.Distance(_tokens_span(parts[0], parts[-1]), bearing)

    @staticmethod
    def position(parts: list[Token]) -> syntax.Position:
        return syntax.Position(_tokens_span(parts[0], parts[1]), _value("AXIS", parts[1]))

    @staticmethod
    def colour(parts: list[Token]) -> syntax.Colour:
        return syntax.Colour(_tokens_span(parts[0], parts[1]), _value("COLOUR", parts[1]))

    @staticmethod
    def condition(parts: list[Any]) -> Condition:
        left, comparator, right = parts
        return Condition(_between(left, right), comparator[5], left, right)

    # --- commands ------------------------------------------------------------------------------------

    @staticmethod
    def declare(parts: list[Any]) -> syntax.Declare:
        var, name = parts[0], _name(parts[1])
        value = parts[3] if len(parts) > 2 else None
        return syntax.Declare(_to(var, value or name), name, value)

    @staticmethod
    def assign(parts: list[Any]) -> syntax.Assign:
        return syntax.Assign(_to(parts[0], parts[2]), _name(parts[0]), parts[2])

    @staticmethod
    def call_without(parts: list[Any]) -> syntax.Call:
        return syntax.Call(_tokens_span(parts[0], parts[2]), _name(parts[0]), ())

    @staticmethod
    def call(parts: list[Any]) -> syntax.Call:
        return syntax.Call(_tokens_span(parts[0], parts[3]), _name(parts[0]), tuple(parts[2]))

    @staticmethod
    def speak(parts: list[Any]) -> syntax.Speak:
        return syntax.Speak(_to(parts[0], parts[1]), parts[1])

    def speak_text(self, parts: list[Any]) -> syntax.Speak:
        word, string = parts
        text = self._source[string[1] + 1 : string[2] - 1]
        if "\r" in text:
            text = text.replace("\r\n", "\n").replace("\r", "\n")
        return syntax.Speak(_tokens_span(word, string), syntax.Text(_token_span(string), text))

    @staticmethod
    def sound(parts: list[Token]) -> syntax.Sound:
        return syntax.Sound(_tokens_span(*parts), _value("SWITCH", parts[1]))

    @staticmethod
    def walk(parts: list[Any]) -> syntax.Walk:
        return syntax.Walk(_to(*parts), _DIRECTIONS[parts[0][0]], parts[1])

    @staticmethod
    def turn(parts: list[Any]) -> syntax.Turn:
        return syntax.Turn(_to(*parts), _SIDES[parts[0][0]], parts[1])

    @staticmethod
    def scan(parts: list[Token]) -> syntax.Scan:
        return syntax.Scan(_token_span(parts[0]))

    @staticmethod
    def state(parts: list[Token]) -> syntax.State:
        return syntax.State(_token_span(parts[0]))

    @staticmethod
    def history(parts: list[Token]) -> syntax.History:
        return syntax.History(_token_span(parts[0]))

    @staticmethod
    def tell_position(parts: list[Token]) -> syntax.TellPosition:
        return syntax.TellPosition(_token_span(parts[0]))

    @staticmethod
    def unused(parts: list[Any]) -> syntax.Unused:
        return syntax.Unused(parts[0].span, parts[0])

    @staticmethod
    def wait(parts: list[Any]) -> syntax.Wait:
        return syntax.Wait(_to(*parts), parts[1])

    @staticmethod
    def belt(parts: list[Token]) -> syntax.BeltSwitch:
        return syntax.BeltSwitch(_tokens_span(*parts), _value("SWITCH", parts[1]))

    @staticmethod
    def vibrate(parts: list[Token]) -> syntax.Vibrate:
        return syntax.Vibrate(_tokens_span(*parts), _value("DIRECTION", parts[1]))

    def help_(self, parts: list[Token]) -> syntax.Help:
        topic = " ".join(self._source[parts[1][1] : parts[1][2]].split()) if len(parts) > 1 else None
        return syntax.Help(_tokens_span(parts[0], parts[-1]), topic)

    @staticmethod
    def quit_(parts: list[Token]) -> syntax.Quit:
        return syntax.Quit(_token_span(parts[0]))

    @staticmethod
    def run(parts: list[Token]) -> syntax.RunTyped:
        return syntax.RunTyped(_token_span(parts[0]))

    # --- blocks --------------------------------------------------------------------------------------

    @staticmethod
    def if_(parts: list[Any]) -> syntax.If:
        return syntax.If(_tokens_span(parts[0], parts[4]), parts[1], tuple(parts[3]), None)

    @staticmethod
    def if_else(parts: list[Any]) -> syntax.If:
        return syntax.If(_tokens_span(parts[0], parts[6]), parts[1], tuple(parts[3]), tuple(parts[5]))

    @staticmethod
    def for_(parts: list[Any]) -> syntax.For:
        whole = _tokens_span(parts[0], parts[8])
        return syntax.For(whole, parts[1], parts[3], parts[5], tuple(parts[7]))

    @staticmethod
    def repeat(parts: list[Any]) -> syntax.Repeat:
        return syntax.Repeat(_tokens_span(parts[0], parts[-1]), parts[1], tuple(parts[-2]))

    @staticmethod
    def while_(parts: list[Any]) -> syntax.While:
        return syntax.While(_tokens_span(parts[0], parts[4]), parts[1], tuple(parts[3]))

    @staticmethod
    def procedure(parts: list[Any]) -> syntax.Procedure:
        return syntax.Procedure(_tokens_span(parts[0], parts[4]), _name(parts[1]), (), tuple(parts[3]))

    @staticmethod
    def procedure_with(parts: list[Any]) -> syntax.Procedure:
        whole = _tokens_span(parts[0], parts[6])
        return syntax.Procedure(whole, _name(parts[1]), tuple(parts[3]), tuple(parts[5]))


def _name(token: Token) -> Name:
    return Name(_token_span(token), token[5])


def _value(terminal: str, token: Token) -> Any:
    """Any: a bearing, an axis, a colour or a switch, as the terminal says."""
    found = argument(terminal, token[5])
    assert found is not None, "the lexer makes that terminal of such a word only"
    return found.value


def _token_span(token: Token) -> Span:
    return Span(token[1], token[2], token[3], token[4])


def _tokens_span(first: Token, last: Token) -> Span:
    return Span(first[1], last[2], first[3], first[4])


def _to(first: Token, last: Any) -> Span:
    return Span(first[1], last.span.end, first[3], first[4])


def _between(left: Any, right: Any) -> Span:
    span: Span = left.span
    return Span(span.start, right.span.end, span.line, span.column)


def _respanned(node: Any, span: Span) -> Any:
    """The same expression with what stands around it: a parenthesis, a plus sign."""
    match node:
        case Binary(operator=operator, left=left, right=right):
            return Binary(span, operator, left, right)
        case Negative(operand=operand):
            return Negative(span, operand)
        case Number(value=value):
            return Number(span, value)
        case Name(name=name):
            return Name(span, name)
        case syntax.Distance(bearing=bearing):
            return syntax.Distance(span, bearing)
        case syntax.Position(axis=axis):
            return syntax.Position(span, axis)
        case _:
            return syntax.Colour(span, node.colour)


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
