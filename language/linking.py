"""Brings together what one batch runs: its program, and the procedures of earlier batches that it may call.

It happens when the batch begins, for only then is it known what the memory holds. So the compiler sees
every call that there can be, and knows what the variables are.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial

from language.assignments import assignments_of
from language.expressions import Bounds
from language.growth import Growth
from language.naturals import Naturals
from language.runtime import Memory
from language.scopes import Declared, Scope, scopes_of
from language.stack import make_room
from language.statements import ScopeTranslator
from language.syntax import Program
from language.units import Unit


def link(program: Program, memory: Memory, *, terminal: bool, hooked: bool) -> tuple[Unit, ...]:
    """The units of a batch: the program first, then every procedure that may run."""
    make_room()
    scopes = _reachable(program, memory.procedures)
    given = assignments_of(scopes)
    growth, naturals = Growth(given, memory.variables), Naturals(given, memory.variables)
    numbers = {id(scope.procedure): number for number, scope in enumerate(scopes)}
    stored = frozenset(memory.variables)
    return tuple(
        ScopeTranslator(
            scope,
            Bounds(partial(growth.bits, number), partial(naturals.has, number)),
            numbers,
            frozenset() if number else stored,
            terminal=terminal,
            hooked=hooked,
        ).unit()
        for number, scope in enumerate(scopes)
    )


def _reachable(program: Program, earlier: Mapping[str, Declared]) -> tuple[Scope, ...]:
    """The program's scopes, and those of the earlier procedures that they call, and that those call."""
    scopes = list(scopes_of(Scope(program, None)))
    seen: set[str] = set()
    for scope in scopes:
        for name in scope.calls() & earlier.keys() - seen:
            seen.add(name)
            scopes += scopes_of(Scope(earlier[name].program, earlier[name].procedure))
    return tuple(scopes)
