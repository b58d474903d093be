"""What the compiler makes of a scope: a code object, and what is known about the places in it."""

from __future__ import annotations

from types import CodeType

from devices.ports.values import frozen
from language.building import Node
from language.scopes import Declared
from language.syntax import Procedure, Program, Span


@frozen
class Header:
    """The sites at which the variable of a FOR header exists."""

    name: str
    first: int
    last: int


@frozen
class Unit:
    """One compiled scope."""

    program: Program
    procedure: Procedure | None
    code: CodeType
    nodes: tuple[Node, ...]
    """The node of each site; the first is site 1."""
    headers: tuple[Header, ...]
    calls: frozenset[tuple[str, int]]
    """What is called, with how many arguments."""
    lines: frozenset[int]
    """Where a statement begins before which it can be held; none unless it was compiled with hooks."""

    @property
    def typed_name(self) -> str:
        """The procedure's name as declared; empty for the program itself."""
        return "" if self.procedure is None else self.program.typed(self.procedure.name.span)

    @property
    def name(self) -> str:
        """The procedure's name, folded; empty for the program itself."""
        return "" if self.procedure is None else self.procedure.name.name

    @property
    def declared(self) -> Declared:
        """What the memory keeps of a procedure."""
        assert self.procedure is not None
        return Declared(self.procedure, self.program)

    def node(self, site: int | None) -> Node | None:
        return self.nodes[site - 1] if site and site <= len(self.nodes) else None

    def span(self, site: int | None) -> Span:
        """Where a site is; the beginning for code that belongs to none."""
        node = self.node(site) or self.procedure or next(iter(self.program.body), None)
        return Span(0, 0, 1, 1) if node is None else node.span

    def headers_at(self, site: int) -> frozenset[str]:
        """The names that a FOR header made, that surround a site, and end with it."""
        return frozenset(header.name for header in self.headers if header.first <= site <= header.last)
