"""Which variables exist where, while one scope is translated, and what must be asked when it runs.

A variable that surely exists is not asked for before it gets a value. Of a name that could be declared twice
the code remembers which declaration made it, to refuse another one.
"""

from __future__ import annotations

from devices.ports.hints import TYPE_CHECKING
from language.scopes import Scope
from language.syntax import Declare, For, Name
from language.translated import (
    EARLIER,
    OWNER,
    PARAMETER,
    VARIABLE,
    Sites,
    assign,
    call,
    compare,
    constant,
    do,
    load,
    when,
)

if TYPE_CHECKING:
    import ast


class Declarations:
    """The variables of one scope."""

    def __init__(self, scope: Scope, sites: Sites, stored: frozenset[str]) -> None:
        """``stored``: the names that exist before it begins."""
        self._scope = scope
        self._sites = sites
        self._stored = stored
        self._parameters = {parameter.name for parameter in scope.parameters}
        self._clashing = _clashing(scope, stored)
        self._mortal = {
            each.start.name.name
            for each in scope.statements()
            if isinstance(each, For) and isinstance(each.start, Declare) and each.start.name.name in stored
        }
        """Stored names that a FOR takes away with its own variable."""
        self.known = {*stored, *self._parameters} - self._mortal
        """What surely exists here."""
        self.written: set[str] = set()
        """What was declared or got a value in the innermost open loop, or in all if none is open."""
        self._outside: list[tuple[set[str], set[str]]] = []
        """The same two of what is around each open loop."""

    # --- what the code asks and keeps

    def at_beginning(self, site: int) -> list[ast.stmt]:
        """Of the whole scope: what made each variable that could be declared again."""
        return [
            assign(site, OWNER + name, constant(site, self._owner_before(name)))
            for name in sorted(self._clashing)
        ]

    def _owner_before(self, name: str) -> int:
        if name in self._stored:
            return EARLIER
        return PARAMETER if name in self._parameters else 0

    def refused_if_other(self, site: int, name: Name) -> list[ast.stmt]:
        """Before the VAR at this site, which may be reached again: refuse if not itself made the variable."""
        if name.name not in self._clashing:
            return []
        is_other = compare(site, load(site, OWNER + name.name), ("<>", constant(site, site)))
        return [when(site, is_other, self.refused_if_any(name))]

    def refused_if_any(self, name: Name) -> list[ast.stmt]:
        """``if o_x: clash(o_x, ...)``: refuses, unless an earlier batch made the variable."""
        if name.name not in self._clashing:
            return []
        site = self._sites.new(name)
        owner = load(site, OWNER + name.name)
        typed = constant(site, self._scope.program.typed(name.span))
        return [when(site, owner, [do(site, call(site, "clash", owner, typed))])]

    def made_by(self, site: int, name: str, owner: int) -> list[ast.stmt]:
        """``o_x = owner``, where anybody asks for it."""
        return [assign(site, OWNER + name, constant(site, owner))] if name in self._clashing else []

    def asked_for(self, name: Name) -> list[ast.stmt]:
        """Before a variable gets a value: Python's own complaint if it does not exist."""
        if name.name in self.known:
            return []
        site = self._sites.new(name)
        return [do(site, load(site, VARIABLE + name.name))]

    # --- what is known here

    def give(self, name: str) -> None:
        """A variable was declared or got a value."""
        if name not in self._mortal:
            self.known.add(name)
        self.written.add(name)

    def forget(self, name: str) -> None:
        self.known.discard(name)

    def enter(self) -> None:
        """Begin a loop: what its body declares may never be declared."""
        self._outside.append((self.known, self.written))
        self.known, self.written = set(self.known), set()

    def leave(self) -> None:
        """End a loop."""
        self.known, written = self._outside.pop()
        self.written |= written


def _clashing(scope: Scope, stored: frozenset[str]) -> frozenset[str]:
    """The names that are declared at two places, or both here and by an earlier batch."""
    return frozenset(name for name, times in scope.declarations().items() if times > 1 or name in stored)
