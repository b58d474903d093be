"""How many bits the numbers of a program can have at most, found before it runs.

Most programs can't reach the largest number however long they run: a counter that grows by one needs
10**4300 turns for it. Where that is certain, the compiled program need not check its results.

A variable whose new value is its old value plus or minus something is reckoned with 2**64 assignments,
which nothing lives to see; where variables feed each other in a circle, or a variable is multiplied by
itself, nothing is known and the bits are infinite. Dividing never makes a number larger.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from math import inf

from language.assignments import Given, Variable
from language.syntax import Binary, Expression, Name, Negative, Number

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
