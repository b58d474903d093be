"""What a scope of GoDonnie becomes: Python's syntax tree, the names in it, and the compiled ``Unit``.

Every piece of the tree is made here, one way. It carries as its line not a line of anything but the number of
the place in the program that it was made from (``Sites``). So a traceback or a running frame tells the exact
node of GoDonnie. The names are of a kind that can't clash with Python's.
"""

from __future__ import annotations

import _ast as ast  # the nodes of ast alone: all else in it takes as long to load as the translator itself
from collections.abc import Sequence
from types import CodeType

from devices.ports.hints import TYPE_CHECKING, TypeAlias
from devices.ports.values import Frozen
from language.scopes import Declared
from language.syntax import Condition, Expression, Procedure, Program, Span, Statement

Node: TypeAlias = Statement | Expression | Condition

if TYPE_CHECKING:
    from typing import TypeVar

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
    """The places of one compiled scope, numbered from 1 in the order in which they were asked for."""

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


def load(site: int, name: str) -> ast.expr:
    return placed(ast.Name(name, ast.Load()), site)


def constant(site: int, value: int | str | bool | None) -> ast.expr:
    return placed(ast.Constant(value), site)


def binary(site: int, operator: str, left: ast.expr, right: ast.expr) -> ast.expr:
    return placed(ast.BinOp(left, _OPERATORS[operator](), right), site)


def negative(site: int, operand: ast.expr) -> ast.expr:
    return placed(ast.UnaryOp(ast.USub(), operand), site)


def compare(site: int, left: ast.expr, *rest: tuple[str, ast.expr]) -> ast.expr:
    """``left < middle < right`` and the like."""
    operators: list[ast.cmpop] = [_COMPARATORS[comparator]() for comparator, _ in rest]
    return placed(ast.Compare(left, operators, [operand for _, operand in rest]), site)


def any_of(site: int, *tests: ast.expr) -> ast.expr:
    return placed(ast.BoolOp(ast.Or(), list(tests)), site)


def both(site: int, *tests: ast.expr) -> ast.expr:
    return placed(ast.BoolOp(ast.And(), list(tests)), site)


def either(site: int, test: ast.expr, then: ast.expr, otherwise: ast.expr) -> ast.expr:
    return placed(ast.IfExp(test, then, otherwise), site)


def keeping(site: int, name: str, value: ast.expr) -> ast.expr:
    """``(name := value)``."""
    return placed(ast.NamedExpr(_target(site, name), value), site)


def element(site: int, name: str, index: int) -> ast.expr:
    """``name[index]``."""
    return placed(ast.Subscript(load(site, name), constant(site, index), ast.Load()), site)


def call(site: int, function: str, *arguments: ast.expr) -> ast.expr:
    return placed(ast.Call(load(site, function), list(arguments), []), site)


# --- statements ---


def do(site: int, expression: ast.expr) -> ast.stmt:
    return placed(ast.Expr(expression), site)


def assign(site: int, name: str, value: ast.expr) -> ast.stmt:
    return placed(ast.Assign([_target(site, name)], value), site)


def forget(site: int, name: str) -> ast.stmt:
    return placed(ast.Delete([placed(ast.Name(name, ast.Del()), site)]), site)


def when(
    site: int, test: ast.expr, then: list[ast.stmt], otherwise: list[ast.stmt] | None = None
) -> ast.stmt:
    return placed(ast.If(test, then, otherwise or []), site)


def unless_break(site: int, test: ast.expr) -> ast.stmt:
    """``if not test: break``."""
    return when(site, placed(ast.UnaryOp(ast.Not(), test), site), [placed(ast.Break(), site)])


def loop_while(site: int, test: ast.expr, body: list[ast.stmt]) -> ast.stmt:
    return placed(ast.While(test, body, []), site)


def loop_over(site: int, name: str, values: ast.expr, body: list[ast.stmt]) -> ast.stmt:
    return placed(ast.For(_target(site, name), values, body, []), site)


def give_back(site: int, value: ast.expr) -> ast.stmt:
    return placed(ast.Return(value), site)


def outer(site: int, names: list[str]) -> ast.stmt:
    return placed(ast.Nonlocal(names), site)


def function(site: int, name: str, parameters: Sequence[str], body: list[ast.stmt]) -> ast.stmt:
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


def compiled(definition: ast.stmt) -> CodeType:
    """The code of a function."""
    module = compile(ast.Module([definition], []), "<GoDonnie>", "exec")
    return next(code for code in module.co_consts if isinstance(code, CodeType))


def _target(site: int, name: str) -> ast.Name:
    return placed(ast.Name(name, ast.Store()), site)


VARIABLE = "v_"
"""What the Python name of a variable begins with."""

OWNER = "o_"
"""What the Python name of a variable's declaration begins with."""

EARLIER = -1
"""The declaration of a variable that an earlier batch left; others are the sites of a declaration."""

PARAMETER = -2
"""The declaration of a variable that is a parameter."""


def wanted_at(line: int) -> str:
    """The global that says whether anything is wanted at a line."""
    return f"w_{line}"


def procedure_taking(name: str, count: int) -> str:
    """The global that is a procedure, called with so many arguments."""
    return f"p_{name}_{count}"


class Header(Frozen):
    """The sites at which the variable of a FOR header exists."""

    name: str
    first: int
    last: int


class Unit(Frozen):
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
