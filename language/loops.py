"""Loops and calls in translated code: where they can be interrupted, and how loops become Python's.

``Interruption``: at the end of each turn of a loop, at each call and after each command, for the global
``flag`` is true when anything is wanted. Asking it is four times as cheap as drawing from a shared iterator.
The compilation for stepping asks before each statement instead, and for a loop's own line once more after
each of its turns: each line has a global of its own, ``w_`` and its number, that is None if nothing is wanted
there, or else the number of open calls up to which ``hook`` is to be called. A procedure that is stopped
returns True, and what called it does the same: that is many times as fast as an exception that goes through
thousands of open calls. Only the program itself raises it.

``Nesting``: loops that are nested too deep for Python become functions of their own.

``counts``: FOR loops that only count become ``range``: much faster than a test and a sum each turn. A FOR
counts if its step is a plain number towards a limit that is a plain number or a variable, if nothing in the
loop writes its variable or that limit, and if the variable ends with the loop, so that nobody sees what it
would have been last.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable

from devices.ports.hints import TYPE_CHECKING
from language.expressions import Expressions
from language.syntax import Binary, Declare, Expression, For, Name, Number, Statement
from language.translated import (
    OWNER,
    VARIABLE,
    Sites,
    assign,
    binary,
    both,
    call,
    compare,
    constant,
    do,
    element,
    function,
    give_back,
    load,
    outer,
    wanted_at,
    when,
)

if TYPE_CHECKING:
    import ast

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
    import ast  # few nest so many loops

    return {
        node.id
        for statement in statements
        for node in ast.walk(statement)
        if isinstance(node, ast.Name)
        and not isinstance(node.ctx, ast.Load)
        and node.id.startswith((VARIABLE, OWNER))
    }


def counts(loop: For, written: Collection[str], expressions: Expressions) -> bool:
    """Whether the loop only counts. ``written``: the names that its body may declare or give a value."""
    name, step = loop.step.name.name, _step_of(loop)
    return (
        isinstance(loop.start, Declare)
        and loop.start.name.name == name
        and step != 0
        and name not in written
        and _is(loop.condition.left, name)
        and loop.condition.comparator in (("<", "<=") if step > 0 else (">", ">="))
        and _is_steady(loop.condition.right, {name, *written})
        and expressions.may_add(name, step)
    )


def turns_of(loop: For, site: int, expressions: Expressions) -> ast.expr:
    """``range(v_i, limit, step)``."""
    step = _step_of(loop)
    limit = expressions.value(loop.condition.right)
    if loop.condition.comparator in ("<=", ">="):  # the limit itself counts too
        limit = binary(site, "+" if step > 0 else "-", limit, constant(site, 1))
    first = load(site, VARIABLE + loop.step.name.name)
    return call(site, "range", first, limit, constant(site, step))


def _step_of(loop: For) -> int:
    """What is added to the variable each turn; 0 where that is not a plain number."""
    name = loop.step.name.name
    match loop.step.value:
        case Binary(operator="+", left=left, right=Number(value=step)) if _is(left, name):
            return step
        case Binary(operator="+", left=Number(value=step), right=right) if _is(right, name):
            return step
        case Binary(operator="-", left=left, right=Number(value=step)) if _is(left, name):
            return -step
        case _:
            return 0


def _is(expression: Expression, name: str) -> bool:
    return isinstance(expression, Name) and expression.name == name


def _is_steady(limit: Expression, written: Collection[str]) -> bool:
    return isinstance(limit, Number) or (isinstance(limit, Name) and limit.name not in written)


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
