"""How many bits the numbers of a program can have at most, found before it runs.

Most programs can't reach the largest number however long they run: a counter that grows by one needs
10**4300 turns for it. Where that is certain, the compiled program need not check its results.

A variable whose new value is its old value plus or minus something is reckoned with 2**64 assignments,
which nothing lives to see; where variables feed each other in a circle, or a variable is multiplied by
itself, nothing is known and the bits are infinite. Dividing never makes a number larger.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Mapping
from math import inf

from language.scopes import Scope
from language.syntax import Assign, Binary, Call, Declare, Expression, For, Name, Negative, Number

SENSOR_BITS = 64
"""What a sensor can tell; the robots' own limits are far below."""

_ASSIGNMENT_BITS = 64

Variable = tuple[int, str]
"""The number of a scope and a name in it."""


class Growth:
    """The most bits of each variable of some scopes that call nothing outside them."""

    def __init__(self, scopes: tuple[Scope, ...], stored: Mapping[str, int]) -> None:
        """``stored``: what the first scope's variables hold before it runs."""
        self._values: dict[Variable, list[tuple[int, Expression]]] = defaultdict(list)
        self._bits: dict[Variable, float] = {}
        self._stored = {(0, name): value.bit_length() for name, value in stored.items()}
        self._open: set[Variable] = set()
        self._collect(scopes)

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

    def _collect(self, scopes: tuple[Scope, ...]) -> None:
        parameters: dict[tuple[str, int], list[tuple[int, Scope]]] = defaultdict(list)
        for number, scope in enumerate(scopes):
            if scope.procedure is not None:
                parameters[scope.procedure.name.name, len(scope.parameters)].append((number, scope))
        for number, scope in enumerate(scopes):
            for statement in scope.statements():
                match statement:
                    case Declare(name=name, value=value) if value is not None:
                        self._values[number, name.name].append((number, value))
                    case Assign(name=name, value=value):
                        self._values[number, name.name].append((number, value))
                    case For(start=start, step=step):
                        self._values[number, step.name.name].append((number, step.value))
                        if start.value is not None:
                            self._values[number, start.name.name].append((number, start.value))
                    case Call(name=name, arguments=arguments):
                        for callee, called in parameters[name.name, len(arguments)]:
                            for parameter, argument in zip(called.parameters, arguments, strict=True):
                                self._values[callee, parameter.name].append((number, argument))

    def _most(self, variable: Variable) -> float:
        most: float = self._stored.get(variable, 0)
        for scope, value in self._values[variable]:
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
