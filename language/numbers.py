"""The numbers of GoDonnie: exact integers of at most 4300 digits; a division truncates towards zero.

The compiler derives the possible values of each variable from all its assignments before a program runs, so
that the code makes only the necessary checks:

``NumberSizes``   how many bits a variable can have at most. Most programs can never reach the largest number:
                  a counter that grows by one needs 10**4300 iterations for it. For a variable whose new value
                  is its old one plus or minus something the limit is that of 2**64 assignments, more than any
                  run can make. If variables depend on each other in a circle, or a variable is multiplied by
                  itself, the bits are infinite. A division never makes a number larger.
``NonNegatives``  which variables are never negative: for them Python's own division is right. A variable is
                  one of them until an assignment contradicts. Readings of sensors may be negative.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Mapping
from math import inf
from typing import TypeAlias

from language import syntax
from language.diagnostics import ActionRefused, MistakeKind
from language.syntax import Binary, Expression, Name, Scope, Statement

LARGEST_DIGITS = 4300

LIMIT: int = 10**LARGEST_DIGITS
"""No number reaches this, nor its negative."""

SAFE_BITS = LIMIT.bit_length() - 1
"""A number with no more bits than this is below the limit."""


def checked(value: int) -> int:
    """``value``, or a refusal if it is too large."""
    if -LIMIT < value < LIMIT:
        return value
    raise ActionRefused(MistakeKind.NUMBER_TOO_LARGE, limit=LARGEST_DIGITS)


def divide(dividend: int, divisor: int) -> int:
    """The quotient without its fraction: -7 / 2 is -3."""
    if divisor == 0:
        raise ActionRefused(MistakeKind.DIVISION_BY_ZERO)
    quotient = abs(dividend) // abs(divisor)
    return quotient if (dividend < 0) == (divisor < 0) else -quotient


Variable: TypeAlias = tuple[int, str]
"""The number of a scope and a name in it."""

Given: TypeAlias = tuple[int, Expression]
"""An expression, and the scope that it is evaluated in."""


def assignments_of(scopes: tuple[Scope, ...]) -> dict[Variable, list[Given]]:
    """The assigned values by variable, without the 0 of a plain VAR. All calls stay within the scopes."""
    given: dict[Variable, list[Given]] = defaultdict(list)
    procedures: dict[tuple[str, int], list[int]] = defaultdict(list)
    """The scopes of procedures by name and number of parameters."""
    for number, scope in enumerate(scopes):
        if scope.procedure is not None:
            procedures[scope.procedure.name.name, len(scope.parameters)].append(number)
    for number, scope in enumerate(scopes):
        for statement in scope.statements():
            for name, value in _assigned(statement):
                given[number, name].append((number, value))
            if isinstance(statement, syntax.Call):
                for callee in procedures[statement.name.name, len(statement.arguments)]:
                    pairs = zip(scopes[callee].parameters, statement.arguments, strict=True)
                    for parameter, argument in pairs:
                        given[callee, parameter.name].append((number, argument))
    return given


def _assigned(statement: Statement) -> Iterator[tuple[str, Expression]]:
    match statement:
        case syntax.Declare(name=name, value=value) | syntax.Assign(name=name, value=value) if (
            value is not None
        ):
            yield name.name, value
        case syntax.For(start=start, step=step):
            yield from _assigned(start)
            yield from _assigned(step)


SENSOR_BITS = 64
"""The largest reading of a sensor; the robots' own limits are far below."""

_ASSIGNMENT_BITS = 64


class NumberSizes:
    """The most bits of each variable of some scopes. All calls stay within these scopes."""

    def __init__(self, given: Mapping[Variable, list[Given]], stored: Mapping[str, int]) -> None:
        """``stored``: the values of the first scope's variables before it runs."""
        self._given = given
        self._bits: dict[Variable, float] = {}
        self._stored = {(0, name): value.bit_length() for name, value in stored.items()}
        self._open: set[Variable] = set()

    def bits(self, scope: int, name: str) -> float:
        """The bits of one variable; infinite if the limit is unknown."""
        variable = (scope, name)
        if variable not in self._bits:
            if variable in self._open:
                return inf
            self._open.add(variable)
            self._bits[variable] = self._most(variable)
            self._open.remove(variable)
        return self._bits[variable]

    def _most(self, variable: Variable) -> float:
        most: float = self._stored.get(variable, 0)
        for scope, value in self._given.get(variable, ()):
            most = max(most, self._of_new_value(variable, scope, value))
        return most + 1

    def _of_new_value(self, variable: Variable, scope: int, value: Expression) -> float:
        terms = tuple(_parts(value, "+-"))
        own = sum(isinstance(term, Name) and (scope, term.name) == variable for term in terms)
        if own > 1:
            return inf
        others = [
            self._of_term(scope, term)
            for term in terms
            if not (isinstance(term, Name) and (scope, term.name) == variable)
        ]
        return max(others, default=0) + len(terms).bit_length() + own * _ASSIGNMENT_BITS

    def _of_term(self, scope: int, term: Expression) -> float:
        match term:
            case Name(name=name):
                return self.bits(scope, name)
            case syntax.NumberLiteral(value=value):
                return value.bit_length()
            case Binary(operator="*"):
                return sum(self._of_factor(scope, factor) for factor in _parts(term, "*"))
            case _:
                return SENSOR_BITS

    def _of_factor(self, scope: int, factor: Expression) -> float:
        terms = tuple(_parts(factor, "+-"))
        return max(self._of_term(scope, term) for term in terms) + len(terms).bit_length()


def _parts(expression: Expression, operators: str) -> Iterator[Expression]:
    """The terms of a sum (``+-``) or the factors of a product (``*``); a quotient counts as its dividend."""
    pending = [expression]
    while pending:
        match pending.pop():
            case Binary(operator=operator, left=left, right=right) if operator in operators:
                pending += (left, right)
            case Binary(operator="/", left=left):
                pending.append(left)
            case syntax.Negative(operand=operand) if operators == "+-":
                pending.append(operand)
            case part:
                yield part


class NonNegatives:
    """The variables of some scopes that are never negative. All calls stay within these scopes."""

    def __init__(self, given: Mapping[Variable, list[Given]], stored: Mapping[str, int]) -> None:
        """``stored``: the values of the first scope's variables before it runs."""
        self._others: set[Variable] = set()
        self._dependent: dict[Variable, list[Variable]] = defaultdict(list)
        found = [(0, name) for name, value in stored.items() if value < 0]
        for variable, values in given.items():
            for scope, value in values:
                if not self._looks_natural(variable, scope, value):
                    found.append(variable)
        self._spread(found)

    def has(self, scope: int, name: str) -> bool:
        return (scope, name) not in self._others

    def _looks_natural(self, variable: Variable, scope: int, value: Expression) -> bool:
        """Whether a value contains no minus. Notes the variables in it."""
        pending = [value]
        while pending:
            match pending.pop():
                case syntax.NumberLiteral():
                    pass
                case Name(name=name):
                    self._dependent[scope, name].append(variable)
                case Binary(operator="+" | "*" | "/", left=left, right=right):
                    pending += (left, right)
                case _:
                    return False
        return True

    def _spread(self, found: list[Variable]) -> None:
        """Mark variables that may be negative, and all whose values depend on them."""
        while found:
            variable = found.pop()
            if variable not in self._others:
                self._others.add(variable)
                found += self._dependent[variable]
