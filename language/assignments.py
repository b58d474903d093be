"""What each variable of a program is ever given, by VAR, by assignment, by a FOR header or as an argument."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator
from typing import TypeAlias

from language.scopes import Scope
from language.syntax import Assign, Call, Declare, Expression, For, Statement

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
