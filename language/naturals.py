"""Which variables are never negative, found before the program runs.

Where neither side of a division can be negative, Python's own division is the right one and needs no test.
A variable is natural as long as everything that it is given is made of natural numbers without a minus;
so all are until the opposite is found. What sensors tell is not relied on.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping

from language.assignments import Given, Variable
from language.syntax import Binary, Expression, Name, Number


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
