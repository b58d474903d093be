"""Expressions of GoDonnie as expressions of Python that keep the rules of its numbers.

A result is checked against the largest number only where it may reach it (``numbers``). A sum of a
hundred thousand numbers is a tree a hundred thousand levels deep, which Python would not compile: the
first part of a deep expression becomes a statement of its own, which goes before (``take_prelude``).

Names for what is kept in between: ``t`` a result until it is checked, ``u`` and ``w`` a dividend and a
divisor, ``s`` the first part of an expression, ``a`` an operand. The number behind u and s is the depth
of parentheses, so that no two that are needed at once have the same name.
"""

from __future__ import annotations

from collections.abc import Callable

from devices.ports.hints import TYPE_CHECKING
from devices.ports.values import Frozen
from language.numbers import LIMIT, SAFE_BITS, SENSOR_BITS
from language.syntax import Binary, Colour, Condition, Distance, Expression, Name, Negative, Number, Position
from language.translated import (
    VARIABLE,
    Sites,
    any_of,
    assign,
    binary,
    both,
    call,
    compare,
    constant,
    either,
    keeping,
    load,
    negative,
)

if TYPE_CHECKING:
    import ast

SMALL = 2**30 - 1
"""CPython compares numbers up to this fastest."""

_DEEPEST = 60
"""Levels of Python's syntax tree in one expression."""


class Bounds(Frozen):
    """What is known about the variables of a scope, by name."""

    bits: Callable[[str], float]
    natural: Callable[[str], bool]


class _Value(Frozen):
    """A translated expression."""

    code: ast.expr
    bits: float
    depth: int = 1
    constant: int | None = None
    steady: bool = False
    """It may be evaluated several times: a number or a name."""
    natural: bool = False
    """It is never negative."""


class Expressions:
    """Translates the expressions of one scope."""

    def __init__(self, sites: Sites, bounds: Bounds) -> None:
        self._sites = sites
        self._bounds = bounds
        self._prelude: list[ast.stmt] = []
        self._level = 0

    def take_prelude(self) -> list[ast.stmt]:
        """The statements that must go before the expressions that were translated since the last call."""
        prelude, self._prelude = self._prelude, []
        return prelude

    def value(self, expression: Expression) -> ast.expr:
        return self._value(expression).code

    def values(self, expressions: tuple[Expression, ...]) -> list[ast.expr]:
        """Several expressions that are evaluated in the order of the text."""
        values: list[_Value] = []
        saved = 0
        for expression in expressions:
            before = len(self._prelude)
            value = self._value(expression)
            if len(self._prelude) > before:
                for index in range(saved, len(values)):
                    values[index] = self._save(f"a{index}", values[index], before)
                    before = before + 1
                saved = len(values)
            values.append(value)
        return [value.code for value in values]

    def may_add(self, name: str, number: int) -> bool:
        """Whether a number can be added to a variable without looking at the result."""
        return max(self._bounds.bits(name), number.bit_length()) + 1 <= SAFE_BITS

    def test(self, condition: Condition) -> ast.expr:
        left, right = self.values((condition.left, condition.right))
        return compare(self._sites.new(condition), left, (condition.comparator, right))

    def _value(self, expression: Expression) -> _Value:
        spine: list[Binary] = []
        while isinstance(expression, Binary):
            spine.append(expression)
            expression = expression.left
        self._level += 1
        value = self._operand(expression)
        for operation in reversed(spine):
            value = self._operate(operation, value)
        self._level -= 1
        return value

    def _operate(self, operation: Binary, left: _Value) -> _Value:
        before = len(self._prelude)
        right = self._operand(operation.right)
        if len(self._prelude) > before and left.constant is None:
            left = self._save(f"s{self._level}", left, before)
        result = self._combine(operation, left, right)
        if result.depth > _DEEPEST:
            result = self._save(f"s{self._level}", result, len(self._prelude))
        return result

    def _save(self, name: str, value: _Value, position: int) -> _Value:
        """Have a value evaluated before, at a place among the statements that go before."""
        site = value.code.lineno
        self._prelude.insert(position, assign(site, name, value.code))
        return _Value(load(site, name), value.bits, steady=True, natural=value.natural)

    def _operand(self, operand: Expression) -> _Value:
        match operand:
            case Number(value=number):
                return self._number(operand, number)
            case Name(name=name):
                code = load(self._sites.new(operand), VARIABLE + name)
                natural = self._bounds.natural(name)
                return _Value(code, self._bounds.bits(name), steady=True, natural=natural)
            case Negative():
                return self._negative(operand)
            case Distance(bearing=bearing):
                return self._sensor(operand, "distance", bearing.name)
            case Position(axis=axis):
                return self._sensor(operand, "position", axis.name)
            case Colour(colour=colour):
                site = self._sites.new(operand)
                return _Value(call(site, "colour", constant(site, colour)), SENSOR_BITS)
            case Binary():
                return self._value(operand)

    def _number(self, node: Expression, number: int) -> _Value:
        code = constant(self._sites.new(node), number)
        return _Value(code, number.bit_length(), constant=number, steady=True, natural=number >= 0)

    def _sensor(self, node: Expression, reading: str, argument: str) -> _Value:
        site = self._sites.new(node)
        return _Value(call(site, reading, load(site, argument)), SENSOR_BITS)

    def _negative(self, node: Negative) -> _Value:
        signs = 0
        operand: Expression = node
        while isinstance(operand, Negative):
            signs += 1
            operand = operand.operand
        value = self._operand(operand)
        if signs % 2 == 0:
            return value
        if value.constant is not None:
            return self._number(node, -value.constant)
        return _Value(negative(self._sites.new(node), value.code), value.bits, value.depth + 1)

    def _combine(self, operation: Binary, left: _Value, right: _Value) -> _Value:
        site = self._sites.new(operation)
        depth = max(left.depth, right.depth)
        natural = left.natural and right.natural and operation.operator != "-"
        if operation.operator == "/":
            return _Value(self._quotient(site, left, right), left.bits, depth + 4, natural=natural)
        code = binary(site, operation.operator, left.code, right.code)
        bits = left.bits + right.bits if operation.operator == "*" else max(left.bits, right.bits) + 1
        if bits <= SAFE_BITS:
            return _Value(code, bits, depth + 1, natural=natural)
        code = _checked(site, code, *_open_sides(operation.operator, left, right))
        return _Value(code, SAFE_BITS + 1, depth + 4, natural=natural)

    def _quotient(self, site: int, left: _Value, right: _Value) -> ast.expr:
        """Python rounds down, which is cutting where both signs are the same; it refuses zero by itself."""
        if right.constant is not None and right.constant > 0 and not left.natural:
            return self._quotient_by_number(site, left, right)
        if left.natural and right.natural:
            return binary(site, "//", left.code, right.code)
        return self._quotient_by_anything(site, left, right)

    def _quotient_by_number(self, site: int, left: _Value, right: _Value) -> ast.expr:
        first, again = _twice(site, f"u{self._level}", left)
        return either(
            site,
            compare(site, first, (">=", constant(site, 0))),
            binary(site, "//", again, right.code),
            negative(site, binary(site, "//", negative(site, again), right.code)),
        )

    def _quotient_by_anything(self, site: int, left: _Value, right: _Value) -> ast.expr:
        first, dividend = _twice(site, f"u{self._level}", left)
        second, divisor = _twice(site, "w", right)
        dividend_sign = compare(site, first, (">=", constant(site, 0)))
        divisor_sign = compare(site, second, (">", constant(site, 0)))
        test = (
            both(site, dividend_sign, divisor_sign)
            if right.steady
            else compare(site, dividend_sign, ("is", divisor_sign))
        )
        quotient = binary(site, "//", dividend, divisor)
        return either(site, test, quotient, call(site, "divide", dividend, divisor))


def _twice(site: int, name: str, value: _Value) -> tuple[ast.expr, ast.expr]:
    """The code for a value that is needed twice: where it comes first, and where it comes again."""
    return (value.code, value.code) if value.steady else (keeping(site, name, value.code), load(site, name))


def _open_sides(operator: str, left: _Value, right: _Value) -> tuple[bool, bool]:
    """Whether a result can be too large, and whether too far below zero, if the operands are neither."""
    if left.natural and right.natural:
        return operator != "-", False
    if operator != "*" and right.constant is not None:
        grows = (right.constant >= 0) == (operator == "+")
        return grows, not grows
    return True, True


def _checked(site: int, code: ast.expr, above: bool, below: bool) -> ast.expr:
    """The result if it is not too large, else what ``checked`` says. Small numbers are compared fastest."""
    if not above and not below:
        return code
    small = _within(site, keeping(site, "t", code), SMALL, above, below)
    allowed = _within(site, load(site, "t"), LIMIT, above, below)
    is_good = any_of(site, small, allowed)
    return either(site, is_good, load(site, "t"), call(site, "checked", load(site, "t")))


def _within(site: int, value: ast.expr, limit: int, above: bool, below: bool) -> ast.expr:
    most, least = ("<", constant(site, limit)), constant(site, -limit)
    if not below:
        return compare(site, value, most)
    return compare(site, least, ("<", value), most) if above else compare(site, value, (">", least))
