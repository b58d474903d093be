"""Loops inside each other: those that are nested too deep for Python become functions of their own."""

from __future__ import annotations

import ast
from collections.abc import Iterable

from language.building import assign, constant, function, outer, when
from language.interruption import Interruption
from language.translated_names import OWNER, VARIABLE

_MOST_LOOPS = 18
"""Loops inside each other in one function; CPython allows 20."""


class Nesting:
    """The loops that are open while one scope is translated."""

    def __init__(self, interruption: Interruption) -> None:
        self._interruption = interruption
        self._depths = [0]
        """How many loops each open one is inside of, itself counted, in its own function of Python."""
        self._outlined: set[str] = set()
        """The variables of loops that became functions."""

    def enter(self) -> None:
        """Begin a loop."""
        depth = self._depths[-1]
        self._depths.append(1 if depth == _MOST_LOOPS else depth + 1)

    def leave(self, site: int, loop: list[ast.stmt]) -> list[ast.stmt]:
        """End a loop. Returns what to put in its place."""
        self._depths.pop()
        if self._depths[-1] < _MOST_LOOPS:
            return loop
        names = sorted(_variables_given(loop))
        self._outlined |= set(names)
        declared = [outer(site, names)] if names else []
        body = [*declared, *loop]
        return [function(site, "loop", (), body), self._interruption.called(site, "loop")]

    def at_beginning(self, site: int) -> list[ast.stmt]:
        """Never runs: it only makes the variables of all loops belong to the outermost function."""
        if not self._outlined:
            return []
        given = [assign(site, name, constant(site, 0)) for name in sorted(self._outlined)]
        return [when(site, constant(site, False), given)]


def _variables_given(statements: Iterable[ast.stmt]) -> set[str]:
    """The variables that some statements assign or delete, those of functions inside them too."""
    return {
        node.id
        for statement in statements
        for node in ast.walk(statement)
        if isinstance(node, ast.Name)
        and not isinstance(node.ctx, ast.Load)
        and node.id.startswith((VARIABLE, OWNER))
    }
