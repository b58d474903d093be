"""Expressions of GoDonnie as expressions of Python that keep the rules of its numbers.

The code checks a result against the largest number only if it may reach that (``numbers``). A sum of a
hundred thousand numbers is a tree a hundred thousand levels deep, which Python can't compile: the first part
of a deep expression becomes a statement before it (``take_prelude``).

Names of intermediate values: ``t`` a result until it is checked, ``u`` and ``w`` a dividend and a divisor,
``s`` the first part of an expression, ``a`` an operand. The number after u and s is the depth of parentheses,
so that two values that are needed at once have different names.
"""

from __future__ import annotations

from collections.abc import Callable

from msgspec import Struct

from language import python_code as py
from language import syntax
from language.numbers import LIMIT, SAFE_BITS, SENSOR_BITS
from language.syntax import Binary, Expression, Name

SMALL = 2**30 - 1
"""CPython compares numbers up to this fastest."""

_DEEPEST = 60
"""Levels of Python's syntax tree in one expression."""


class ValueBounds(Struct, frozen=True):
    """The known limits of the variables of a scope, by name."""

    bits: Callable[[str], float]
    natural: Callable[[str], bool]


class _Value(Struct, frozen=True):
    """A compiled expression."""

    code: py.Expr
    bits: float
    depth: int = 1
    constant: int | None = None
    steady: bool = False
    """It may be evaluated several times: a number or a name."""
    natural: bool = False
    """It is never negative."""


class Expressions:
    """Compiles the expressions of one scope."""

    def __init__(self, sites: py.Sites, bounds: ValueBounds) -> None:
        self._sites = sites
        self._bounds = bounds
        self._prelude: list[py.Stmt] = []
        self._level = 0

    def take_prelude(self) -> list[py.Stmt]:
        """The statements that must go before the expressions that were compiled since the last call."""
        prelude, self._prelude = self._prelude, []
        return prelude

    def value(self, expression: Expression) -> py.Expr:
        return self._value(expression).code

    def values(self, expressions: tuple[Expression, ...]) -> list[py.Expr]:
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
        """Whether a sum of a variable and a number needs no check."""
        return max(self._bounds.bits(name), number.bit_length()) + 1 <= SAFE_BITS

    def test(self, condition: syntax.Condition) -> py.Expr:
        left, right = self.values((condition.left, condition.right))
        return py.compare(self._sites.new(condition), left, (condition.comparator, right))

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
        """Evaluate a value in a statement before, at a position among those statements."""
        site = value.code.lineno
        self._prelude.insert(position, py.assign(site, name, value.code))
        return _Value(py.load(site, name), value.bits, steady=True, natural=value.natural)

    def _operand(self, operand: Expression) -> _Value:
        match operand:
            case syntax.NumberLiteral(value=number):
                return self._number(operand, number)
            case Name(name=name):
                code = py.load(self._sites.new(operand), py.VARIABLE + name)
                natural = self._bounds.natural(name)
                return _Value(code, self._bounds.bits(name), steady=True, natural=natural)
            case syntax.Negative():
                return self._negative(operand)
            case syntax.DistanceSensor(bearing=bearing):
                return self._sensor(operand, "distance", bearing.name)
            case syntax.NamedDistanceSensor(name=name):
                site = self._sites.new(operand)
                return _Value(py.call(site, "named_distance", py.constant(site, name)), SENSOR_BITS)
            case syntax.PositionSensor(axis=axis):
                return self._sensor(operand, "position", axis.name)
            case syntax.ColourSensor(colour=colour):
                site = self._sites.new(operand)
                return _Value(py.call(site, "colour", py.constant(site, colour)), SENSOR_BITS)
            case Binary():
                return self._value(operand)

    def _number(self, node: Expression, number: int) -> _Value:
        code = py.constant(self._sites.new(node), number)
        return _Value(code, number.bit_length(), constant=number, steady=True, natural=number >= 0)

    def _sensor(self, node: Expression, reading: str, argument: str) -> _Value:
        site = self._sites.new(node)
        return _Value(py.call(site, reading, py.load(site, argument)), SENSOR_BITS)

    def _negative(self, node: syntax.Negative) -> _Value:
        signs = 0
        operand: Expression = node
        while isinstance(operand, syntax.Negative):
            signs += 1
            operand = operand.operand
        value = self._operand(operand)
        if signs % 2 == 0:
            return value
        if value.constant is not None:
            return self._number(node, -value.constant)
        return _Value(py.negative(self._sites.new(node), value.code), value.bits, value.depth + 1)

    def _combine(self, operation: Binary, left: _Value, right: _Value) -> _Value:
        site = self._sites.new(operation)
        depth = max(left.depth, right.depth)
        natural = left.natural and right.natural and operation.operator != "-"
        if operation.operator == "/":
            return _Value(self._quotient(site, left, right), left.bits, depth + 4, natural=natural)
        code = py.binary(site, operation.operator, left.code, right.code)
        bits = left.bits + right.bits if operation.operator == "*" else max(left.bits, right.bits) + 1
        if bits <= SAFE_BITS:
            return _Value(code, bits, depth + 1, natural=natural)
        code = _checked(site, code, *_open_sides(operation.operator, left, right))
        return _Value(code, SAFE_BITS + 1, depth + 4, natural=natural)

    def _quotient(self, site: int, left: _Value, right: _Value) -> py.Expr:
        """Python rounds down, which truncates if both signs are the same. It raises an error for zero."""
        if left.natural and right.natural:
            return py.binary(site, "//", left.code, right.code)
        if right.constant is not None and right.constant > 0:
            return self._quotient_by_number(site, left, right)
        return self._quotient_by_anything(site, left, right)

    def _quotient_by_number(self, site: int, left: _Value, right: _Value) -> py.Expr:
        first, again = _twice(site, f"u{self._level}", left)
        return py.conditional(
            site,
            py.compare(site, first, (">=", py.constant(site, 0))),
            py.binary(site, "//", again, right.code),
            py.negative(site, py.binary(site, "//", py.negative(site, again), right.code)),
        )

    def _quotient_by_anything(self, site: int, left: _Value, right: _Value) -> py.Expr:
        first, dividend = _twice(site, f"u{self._level}", left)
        second, divisor = _twice(site, "w", right)
        dividend_sign = py.compare(site, first, (">=", py.constant(site, 0)))
        divisor_sign = py.compare(site, second, (">", py.constant(site, 0)))
        test = (
            py.and_(site, dividend_sign, divisor_sign)
            if right.steady
            else py.compare(site, dividend_sign, ("is", divisor_sign))
        )
        quotient = py.binary(site, "//", dividend, divisor)
        return py.conditional(site, test, quotient, py.call(site, "divide", dividend, divisor))


def _twice(site: int, name: str, value: _Value) -> tuple[py.Expr, py.Expr]:
    """The code for a value that is needed twice: for its first place, and for its second."""
    return (
        (value.code, value.code) if value.steady else (py.named(site, name, value.code), py.load(site, name))
    )


def _open_sides(operator: str, left: _Value, right: _Value) -> tuple[bool, bool]:
    """Whether a result can be too large, and whether too far below zero, if no operand is."""
    if left.natural and right.natural:
        return operator != "-", False
    if operator != "*" and right.constant is not None:
        grows = (right.constant >= 0) == (operator == "+")
        return grows, not grows
    return True, True


def _checked(site: int, code: py.Expr, above: bool, below: bool) -> py.Expr:
    """The result if it is not too large, else ``checked`` raises. Small numbers are compared fastest."""
    if not above and not below:
        return code
    small = _within(site, py.named(site, "t", code), SMALL, above, below)
    allowed = _within(site, py.load(site, "t"), LIMIT, above, below)
    is_good = py.or_(site, small, allowed)
    return py.conditional(site, is_good, py.load(site, "t"), py.call(site, "checked", py.load(site, "t")))


def _within(site: int, value: py.Expr, limit: int, above: bool, below: bool) -> py.Expr:
    most, least = ("<", py.constant(site, limit)), py.constant(site, -limit)
    if not below:
        return py.compare(site, value, most)
    return py.compare(site, least, ("<", value), most) if above else py.compare(site, value, (">", least))
