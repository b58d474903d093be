"""The numbers of GoDonnie: exact integers of at most 4300 digits, divided by cutting towards zero.

What a program's variables can hold is found before it runs, from everything that each is ever given, so
that the compiled program tests no more than it must:

``Growth``    how many bits they can have at most. Most programs can't reach the largest number however long
              they run: a counter that grows by one needs 10**4300 turns for it. A variable whose new value is
              its old one plus or minus something is reckoned with 2**64 assignments, which nothing lives to
              see; where variables feed each other in a circle, or a variable is multiplied by itself, nothing
              is known and the bits are infinite. Dividing never makes a number larger.
``Naturals``  which are never negative: then Python's own division is the right one. So are all until the
              opposite is found; what sensors tell is not relied on.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Mapping
from math import inf

from devices.ports.hints import TypeAlias
from language.diagnostics import Kind, Refused
from language.scopes import Scope
from language.syntax import Assign, Binary, Call, Declare, Expression, For, Name, Negative, Number, Statement

LARGEST_DIGITS = 4300

LIMIT: int = 10**LARGEST_DIGITS
"""No number reaches this, nor its negative."""

SAFE_BITS = LIMIT.bit_length() - 1
"""Whatever has no more bits than this is below the limit."""


def checked(value: int) -> int:
    """``value``, or a refusal if it is too large."""
    if -LIMIT < value < LIMIT:
        return value
    raise Refused(Kind.NUMBER_TOO_LARGE, limit=LARGEST_DIGITS)


def divide(dividend: int, divisor: int) -> int:
    """The quotient without its fraction: -7 / 2 is -3."""
    if divisor == 0:
        raise Refused(Kind.DIVISION_BY_ZERO)
    quotient = abs(dividend) // abs(divisor)
    return quotient if (dividend < 0) == (divisor < 0) else -quotient


Variable: TypeAlias = tuple[int, str]
"""The number of a scope and a name in it."""

Given: TypeAlias = tuple[int, Expression]
"""An expression, and the scope that it is evaluated in."""


def assignments_of(scopes: tuple[Scope, ...]) -> dict[Variable, list[Given]]:
    """By variable; the scopes must call nothing outside them. The 0 of a plain VAR is left out."""
    given: dict[Variable, list[Given]] = defaultdict(list)
    procedures = _procedures(scopes)
    for number, scope in enumerate(scopes):
        for statement in scope.statements():
            for name, value in _values(statement):
                given[number, name].append((number, value))
            if isinstance(statement, Call):
                for callee in procedures[statement.name.name, len(statement.arguments)]:
                    for parameter, argument in zip(
                        scopes[callee].parameters, statement.arguments, strict=True
                    ):
                        given[callee, parameter.name].append((number, argument))
    return given


def _procedures(scopes: tuple[Scope, ...]) -> dict[tuple[str, int], list[int]]:
    """The scopes of procedures by name and number of parameters."""
    found: dict[tuple[str, int], list[int]] = defaultdict(list)
    for number, scope in enumerate(scopes):
        if scope.procedure is not None:
            found[scope.procedure.name.name, len(scope.parameters)].append(number)
    return found


def _values(statement: Statement) -> Iterator[tuple[str, Expression]]:
    match statement:
        case Declare(name=name, value=value) | Assign(name=name, value=value) if value is not None:
            yield name.name, value
        case For(start=start, step=step):
            yield from _values(start)
            yield from _values(step)


SENSOR_BITS = 64
"""What a sensor can tell; the robots' own limits are far below."""

_ASSIGNMENT_BITS = 64


class Growth:
    """The most bits of each variable of some scopes that call nothing outside them."""

    def __init__(self, given: Mapping[Variable, list[Given]], stored: Mapping[str, int]) -> None:
        """``stored``: what the first scope's variables hold before it runs."""
        self._given = given
        self._bits: dict[Variable, float] = {}
        self._stored = {(0, name): value.bit_length() for name, value in stored.items()}
        self._open: set[Variable] = set()

    def bits(self, scope: int, name: str) -> float:
        """The bits of one variable; infinite where nothing is known."""
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
        terms = tuple(_terms(value))
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
            case Number(value=value):
                return value.bit_length()
            case Binary(operator="*"):
                return sum(self._of_factor(scope, factor) for factor in _factors(term))
            case _:
                return SENSOR_BITS

    def _of_factor(self, scope: int, factor: Expression) -> float:
        terms = tuple(_terms(factor))
        return max(self._of_term(scope, term) for term in terms) + len(terms).bit_length()


def _terms(expression: Expression) -> Iterator[Expression]:
    """What is added up in an expression; of a quotient, what is divided."""
    waiting = [expression]
    while waiting:
        match waiting.pop():
            case Binary(operator="+" | "-", left=left, right=right):
                waiting += (left, right)
            case Binary(operator="/", left=left):
                waiting.append(left)
            case Negative(operand=operand):
                waiting.append(operand)
            case term:
                yield term


def _factors(product: Expression) -> Iterator[Expression]:
    """What is multiplied in an expression; of a quotient, what is divided."""
    waiting = [product]
    while waiting:
        match waiting.pop():
            case Binary(operator="*", left=left, right=right):
                waiting += (left, right)
            case Binary(operator="/", left=left):
                waiting.append(left)
            case factor:
                yield factor


class Naturals:
    """The variables of some scopes that call nothing outside them."""

    def __init__(self, given: Mapping[Variable, list[Given]], stored: Mapping[str, int]) -> None:
        """``stored``: what the first scope's variables hold before it runs."""
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
        """Whether a value has no minus in it; the variables in it are noted."""
        waiting = [value]
        while waiting:
            match waiting.pop():
                case Number():
                    pass
                case Name(name=name):
                    self._dependent[scope, name].append(variable)
                case Binary(operator="+" | "*" | "/", left=left, right=right):
                    waiting += (left, right)
                case _:
                    return False
        return True

    def _spread(self, found: list[Variable]) -> None:
        """Variables that may be negative, and all that are given something of them."""
        while found:
            variable = found.pop()
            if variable not in self._others:
                self._others.add(variable)
                found += self._dependent[variable]
