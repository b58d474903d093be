"""Where translated code can be interrupted, and what it does when it must end.

That is at the end of each turn of a loop, at each call and after each command: the global ``flag`` is true
when anything is wanted. Asking it is four times as cheap as drawing from a shared iterator. The compilation
for stepping asks before each statement instead, and for a loop's own line once more after each of its turns:
each line has a global of its own, ``w_`` and its number, that is None if nothing is wanted there, or else the
number of open calls up to which ``hook`` is to be called.

A procedure that is stopped returns True, and what called it does the same: that is many times as fast as
an exception that goes through thousands of open calls. Only the program itself raises it.
"""

from __future__ import annotations

import ast

from language.building import Sites, both, call, compare, constant, do, element, give_back, load, when
from language.syntax import Statement
from language.translated_names import wanted_at


class Interruption:
    """Makes the places of one scope where it can be interrupted."""

    def __init__(self, sites: Sites, *, in_procedure: bool, hooked: bool) -> None:
        self._sites = sites
        self._in_procedure = in_procedure
        self._hooked = hooked
        self.lines: set[int] = set()
        """Where it can be held."""

    def at_beginning(self, site: int) -> list[ast.stmt]:
        """Of the whole scope."""
        return [] if self._hooked else [self.checkpoint(site)]

    def before(self, site: int, statement: Statement) -> list[ast.stmt]:
        return [self._hook(site, statement)] if self._hooked else []

    def after_turn(self, site: int, loop: Statement) -> list[ast.stmt]:
        return [self._hook(site, loop) if self._hooked else self.checkpoint(site)]

    def checkpoint(self, site: int) -> ast.stmt:
        """``if flag and check(): (end)``."""
        return when(site, both(site, load(site, "flag"), call(site, "check")), [self._end(site)])

    def called(self, site: int, name: str, *arguments: ast.expr) -> ast.stmt:
        """``if name(...) is not None: (end)``."""
        ended = compare(site, call(site, name, *arguments), ("is not", constant(site, None)))
        return when(site, ended, [self._end(site)])

    def _hook(self, site: int, statement: Statement) -> ast.stmt:
        """``if w_line is not None and depth <= w_line and hook(line, column, depth): (end)``."""
        self.lines.add(statement.span.line)
        name = wanted_at(statement.span.line)
        line, column = constant(site, statement.span.line), constant(site, statement.span.column)
        is_wanted = compare(site, load(site, name), ("is not", constant(site, None)))
        if self._in_procedure:
            depth = element(site, "d", 0)
            is_near = [compare(site, depth, ("<=", load(site, name)))]
        else:
            is_near, depth = [], constant(site, 0)
        test = both(site, is_wanted, *is_near, call(site, "hook", line, column, depth))
        return when(site, test, [self._end(site)])

    def _end(self, site: int) -> ast.stmt:
        if self._in_procedure:
            return give_back(site, constant(site, True))
        return do(site, call(site, "stop"))
