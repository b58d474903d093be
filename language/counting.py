"""FOR loops that only count, as Python's ``range``: much faster than a test and a sum each turn.

A FOR counts if its step is a plain number towards a limit that is a plain number or a variable, if nothing
in the loop writes its variable or that limit, and if the variable ends with the loop, so that nobody sees
what it would have been last.
"""

from __future__ import annotations

import ast
from collections.abc import Collection

from language.building import binary, call, constant, load
from language.expressions import Expressions
from language.syntax import Binary, Declare, Expression, For, Name, Number
from language.translated_names import VARIABLE


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
