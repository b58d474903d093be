"""Loops in the Python code, and the checkpoints at which a running program can be held or stopped.

``Checkpoints``: at the end of each iteration, at each call and after each command the code looks at the
global ``flag``. It is true if the control requests anything. To read it is four times as cheap as to draw
from a shared iterator.
The compilation for stepping looks before each statement instead, and for a loop's own line once more after
each iteration. Each line has a global of its own, ``w_`` and its number: None, or the deepest call for which
the code calls ``hook`` there. A stopped procedure returns True, and so does its caller: that is many times as
fast as an exception that passes thousands of open calls. Only the program itself raises it.

``LoopNesting``: loops that are nested too deep for Python become functions of their own.

``is_counting``: FOR loops that only count become ``range``, which is much faster than a test and a sum each
iteration. A FOR counts if its step is a plain number towards a limit that is a plain number or a variable, if
no statement in the loop writes its variable or that limit, and if the variable ends with the loop, so that no
statement can read its last value.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable

from language import python_code as py
from language.expressions import Expressions
from language.syntax import Binary, Declare, Expression, For, Name, NumberLiteral, Statement

_MOST_LOOPS = 18
"""Loops inside each other in one function; CPython allows 20."""


class LoopNesting:
    """The loops that are open while one scope is compiled."""

    def __init__(self, checkpoints: Checkpoints) -> None:
        self._checkpoints = checkpoints
        self._depths = [0]
        """For each open loop, the number of loops around it in its function of Python, itself included."""
        self._outlined: set[str] = set()
        """The variables of the loops that became functions."""

    def enter(self) -> None:
        """Begin a loop."""
        depth = self._depths[-1]
        self._depths.append(1 if depth == _MOST_LOOPS else depth + 1)

    def leave(self, site: int, loop: list[py.Stmt]) -> list[py.Stmt]:
        """End a loop. Returns the statements for it."""
        self._depths.pop()
        if self._depths[-1] < _MOST_LOOPS:
            return loop
        names = sorted(_assigned_variables(loop))
        self._outlined |= set(names)
        declared = [py.nonlocal_(site, names)] if names else []
        body = [*declared, *loop]
        return [py.function(site, "loop", (), body), self._checkpoints.called(site, "loop")]

    def at_beginning(self, site: int) -> list[py.Stmt]:
        """Code that never runs; it makes the variables of all loops belong to the outermost function."""
        if not self._outlined:
            return []
        given = [py.assign(site, name, py.constant(site, 0)) for name in sorted(self._outlined)]
        return [py.if_(site, py.constant(site, False), given)]


def _assigned_variables(statements: Iterable[py.Stmt]) -> set[str]:
    """The variables that some statements assign or delete, those of functions inside them too."""
    import ast  # few nest so many loops

    return {
        node.id
        for statement in statements
        for node in ast.walk(statement)
        if isinstance(node, ast.Name)
        and not isinstance(node.ctx, ast.Load)
        and node.id.startswith((py.VARIABLE, py.OWNER))
    }


def is_counting(loop: For, written: Collection[str], expressions: Expressions) -> bool:
    """Whether the loop only counts. ``written``: the names that its body may declare or assign."""
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


def range_of(loop: For, site: int, expressions: Expressions) -> py.Expr:
    """``range(v_i, limit, step)``."""
    step = _step_of(loop)
    limit = expressions.value(loop.condition.right)
    if loop.condition.comparator in ("<=", ">="):  # the limit itself counts too
        limit = py.binary(site, "+" if step > 0 else "-", limit, py.constant(site, 1))
    first = py.load(site, py.VARIABLE + loop.step.name.name)
    return py.call(site, "range", first, limit, py.constant(site, step))


def _step_of(loop: For) -> int:
    """The number that each iteration adds to the variable; 0 if that is not a plain number."""
    name = loop.step.name.name
    match loop.step.value:
        case Binary(operator="+", left=left, right=NumberLiteral(value=step)) if _is(left, name):
            return step
        case Binary(operator="+", left=NumberLiteral(value=step), right=right) if _is(right, name):
            return step
        case Binary(operator="-", left=left, right=NumberLiteral(value=step)) if _is(left, name):
            return -step
        case _:
            return 0


def _is(expression: Expression, name: str) -> bool:
    return isinstance(expression, Name) and expression.name == name


def _is_steady(limit: Expression, written: Collection[str]) -> bool:
    return isinstance(limit, NumberLiteral) or (isinstance(limit, Name) and limit.name not in written)


class Checkpoints:
    """Makes the checkpoints of one scope."""

    def __init__(self, *, in_procedure: bool, hooked: bool) -> None:
        self._in_procedure = in_procedure
        self._hooked = hooked
        self.lines: set[int] = set()
        """The lines with a hook."""

    def at_beginning(self, site: int) -> list[py.Stmt]:
        """Code for the beginning of the scope."""
        return [] if self._hooked else [self.checkpoint(site)]

    def before(self, site: int, statement: Statement) -> list[py.Stmt]:
        return [self._hook(site, statement)] if self._hooked else []

    def after_iteration(self, site: int, loop: Statement) -> list[py.Stmt]:
        return [self._hook(site, loop) if self._hooked else self.checkpoint(site)]

    def checkpoint(self, site: int) -> py.Stmt:
        """``if flag and check(): (end)``."""
        return py.if_(site, py.and_(site, py.load(site, "flag"), py.call(site, "check")), [self._end(site)])

    def called(self, site: int, name: str, *arguments: py.Expr) -> py.Stmt:
        """``if name(...) is not None: (end)``."""
        ended = py.compare(site, py.call(site, name, *arguments), ("is not", py.constant(site, None)))
        return py.if_(site, ended, [self._end(site)])

    def _hook(self, site: int, statement: Statement) -> py.Stmt:
        """``if w_line is not None and depth <= w_line and hook(line, column, depth): (end)``."""
        self.lines.add(statement.span.line)
        name = py.hook_depth_at(statement.span.line)
        line, column = py.constant(site, statement.span.line), py.constant(site, statement.span.column)
        is_hooked = py.compare(site, py.load(site, name), ("is not", py.constant(site, None)))
        if self._in_procedure:
            depth = py.subscript(site, "d", 0)
            is_near = [py.compare(site, depth, ("<=", py.load(site, name)))]
        else:
            is_near, depth = [], py.constant(site, 0)
        test = py.and_(site, is_hooked, *is_near, py.call(site, "hook", line, column, depth))
        return py.if_(site, test, [self._end(site)])

    def _end(self, site: int) -> py.Stmt:
        if self._in_procedure:
            return py.return_(site, py.constant(site, True))
        return py.evaluate(site, py.call(site, "stop"))
