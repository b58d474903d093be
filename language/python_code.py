"""The Python code that a scope of GoDonnie becomes: its syntax tree, its names, and the compiled ``Unit``.

Only this module makes nodes of Python's syntax tree. In place of a line each node carries a site: the number
of the GoDonnie node that it was made from (``Sites``). So a traceback or a running frame leads to the exact
node of GoDonnie. The names can't clash with Python's.
"""

from __future__ import annotations

import _ast as ast  # only the nodes: the rest of ast takes as long to load as the compiler itself
from collections.abc import Sequence
from types import CodeType
from typing import TypeAlias, TypeVar

from msgspec import Struct

from language.syntax import DeclaredProcedure, Node, Procedure, Program, Span

Expr: TypeAlias = ast.expr
Stmt: TypeAlias = ast.stmt

_Placed = TypeVar("_Placed", bound=ast.stmt | ast.expr | ast.arg)

_OPERATORS: dict[str, type[ast.operator]] = {
    "+": ast.Add,
    "-": ast.Sub,
    "*": ast.Mult,
    "//": ast.FloorDiv,
}
_COMPARATORS: dict[str, type[ast.cmpop]] = {
    "==": ast.Eq,
    "<>": ast.NotEq,
    "<": ast.Lt,
    ">": ast.Gt,
    "<=": ast.LtE,
    ">=": ast.GtE,
    "is": ast.Is,
    "is not": ast.IsNot,
}


class Sites:
    """The sites of one compiled scope, numbered from 1 in the order of their creation."""

    def __init__(self) -> None:
        self.nodes: list[Node] = []

    def new(self, node: Node) -> int:
        self.nodes.append(node)
        return len(self.nodes)

    @property
    def next(self) -> int:
        return len(self.nodes) + 1


def placed(node: _Placed, site: int) -> _Placed:
    node.lineno = node.end_lineno = site
    node.col_offset = node.end_col_offset = 0
    return node


# --- expressions ---


def load(site: int, name: str) -> Expr:
    return placed(ast.Name(name, ast.Load()), site)


def constant(site: int, value: int | str | bool | None) -> Expr:
    return placed(ast.Constant(value), site)


def binary(site: int, operator: str, left: Expr, right: Expr) -> Expr:
    return placed(ast.BinOp(left, _OPERATORS[operator](), right), site)


def negative(site: int, operand: Expr) -> Expr:
    return placed(ast.UnaryOp(ast.USub(), operand), site)


def compare(site: int, left: Expr, *rest: tuple[str, Expr]) -> Expr:
    """``left < middle < right`` and the like."""
    operators: list[ast.cmpop] = [_COMPARATORS[comparator]() for comparator, _ in rest]
    return placed(ast.Compare(left, operators, [operand for _, operand in rest]), site)


def or_(site: int, *tests: Expr) -> Expr:
    return placed(ast.BoolOp(ast.Or(), list(tests)), site)


def and_(site: int, *tests: Expr) -> Expr:
    return placed(ast.BoolOp(ast.And(), list(tests)), site)


def conditional(site: int, test: Expr, then: Expr, otherwise: Expr) -> Expr:
    return placed(ast.IfExp(test, then, otherwise), site)


def named(site: int, name: str, value: Expr) -> Expr:
    """``(name := value)``."""
    return placed(ast.NamedExpr(_target(site, name), value), site)


def subscript(site: int, name: str, index: int) -> Expr:
    """``name[index]``."""
    return placed(ast.Subscript(load(site, name), constant(site, index), ast.Load()), site)


def call(site: int, function: str, *arguments: Expr) -> Expr:
    return placed(ast.Call(load(site, function), list(arguments), []), site)


# --- statements ---


def evaluate(site: int, expression: Expr) -> Stmt:
    return placed(ast.Expr(expression), site)


def assign(site: int, name: str, value: Expr) -> Stmt:
    return placed(ast.Assign([_target(site, name)], value), site)


def delete(site: int, name: str) -> Stmt:
    return placed(ast.Delete([placed(ast.Name(name, ast.Del()), site)]), site)


def if_(site: int, test: Expr, then: list[Stmt], otherwise: list[Stmt] | None = None) -> Stmt:
    return placed(ast.If(test, then, otherwise or []), site)


def break_unless(site: int, test: Expr) -> Stmt:
    """``if not test: break``."""
    return if_(site, placed(ast.UnaryOp(ast.Not(), test), site), [placed(ast.Break(), site)])


def while_(site: int, test: Expr, body: list[Stmt]) -> Stmt:
    return placed(ast.While(test, body, []), site)


def for_(site: int, name: str, values: Expr, body: list[Stmt]) -> Stmt:
    return placed(ast.For(_target(site, name), values, body, []), site)


def return_(site: int, value: Expr) -> Stmt:
    return placed(ast.Return(value), site)


def nonlocal_(site: int, names: list[str]) -> Stmt:
    return placed(ast.Nonlocal(names), site)


def function(site: int, name: str, parameters: Sequence[str], body: list[Stmt]) -> Stmt:
    arguments = ast.arguments(
        posonlyargs=[],
        args=[placed(ast.arg(parameter), site) for parameter in parameters],
        kwonlyargs=[],
        kw_defaults=[],
        defaults=[],
    )
    definition = ast.FunctionDef(name, arguments, body or [placed(ast.Pass(), site)], [])
    vars(definition)["type_params"] = []  # Python 3.12 wants the field, 3.11 has none
    return placed(definition, site)


def compiled(definition: Stmt) -> CodeType:
    """The code of a function."""
    module = compile(ast.Module([definition], []), "<GoDonnie>", "exec")
    return next(code for code in module.co_consts if isinstance(code, CodeType))


def _target(site: int, name: str) -> ast.Name:
    return placed(ast.Name(name, ast.Store()), site)


VARIABLE = "v_"
"""The prefix of the Python name of a variable."""

OWNER = "o_"
"""The prefix of the Python name of a variable's declaration."""

EARLIER = -1
"""The declaration of a variable of an earlier batch; others are the sites of a declaration."""

PARAMETER = -2
"""The declaration of a variable that is a parameter."""


def hook_depth_at(line: int) -> str:
    """The global with the deepest call for which the hook is called at a line."""
    return f"w_{line}"


def procedure_taking(name: str, count: int) -> str:
    """The global that is a procedure, called with ``count`` arguments."""
    return f"p_{name}_{count}"


class ForHeader(Struct, frozen=True):
    """The sites at which the variable of a FOR header exists."""

    name: str
    first: int
    last: int


class Unit(Struct, frozen=True):
    """One compiled scope."""

    program: Program
    procedure: Procedure | None
    code: CodeType
    nodes: tuple[Node, ...]
    """The node of each site; the first is site 1."""
    headers: tuple[ForHeader, ...]
    calls: frozenset[tuple[str, int]]
    """The called procedures, with the number of arguments."""
    lines: frozenset[int]
    """The lines of the statements with a hook; none unless it was compiled with hooks."""

    @property
    def typed_name(self) -> str:
        """The procedure's name as declared; empty for the program itself."""
        return "" if self.procedure is None else self.program.typed(self.procedure.name.span)

    @property
    def name(self) -> str:
        """The procedure's name, folded; empty for the program itself."""
        return "" if self.procedure is None else self.procedure.name.name

    @property
    def declared(self) -> DeclaredProcedure:
        """The procedure as the memory keeps it."""
        assert self.procedure is not None
        return DeclaredProcedure(self.procedure, self.program)

    def node(self, site: int | None) -> Node | None:
        return self.nodes[site - 1] if site and site <= len(self.nodes) else None

    def span(self, site: int | None) -> Span:
        """The place of a site; the beginning for code without a site."""
        node = self.node(site) or self.procedure or next(iter(self.program.body), None)
        return Span(0, 0, 1, 1) if node is None else node.span

    def headers_at(self, site: int) -> frozenset[str]:
        """The variables of the FOR headers around a site, which end with their loops."""
        return frozenset(header.name for header in self.headers if header.first <= site <= header.last)
