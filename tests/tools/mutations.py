"""Small mistakes that a test should notice: every place in a module where one can be made."""

from __future__ import annotations

import ast
import os
import select
import signal
import socket
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise

_COMPARISONS = {
    ast.Lt: "<=", ast.LtE: "<", ast.Gt: ">=", ast.GtE: ">", ast.Eq: "!=", ast.NotEq: "==",
    ast.Is: "is not", ast.IsNot: "is", ast.In: "not in", ast.NotIn: "in",
}  # fmt: skip
_OPERATORS = {
    ast.Add: "-", ast.Sub: "+", ast.Mult: "/", ast.Div: "*", ast.FloorDiv: "*", ast.Mod: "*", ast.Pow: "*",
    ast.BitOr: "&", ast.BitAnd: "|",
}  # fmt: skip


@dataclass(frozen=True, slots=True)
class Mutation:
    """One mistake in a module: other text in place of a piece of it."""

    path: str
    line: int
    start: int
    """The first byte of the piece."""
    end: int
    text: str
    """What stands there instead."""
    kind: str

    def applied(self, source: bytes) -> bytes:
        return source[: self.start] + self.text.encode() + source[self.end :]

    def can_be_read(self, source: bytes) -> bool:
        """Whether Python compiles the module with it."""
        try:
            compile(self.applied(source), self.path, "exec", dont_inherit=True)
        except SyntaxError:
            return False
        return True

    def __str__(self) -> str:
        return f"{self.path}:{self.line}: {self.kind}"


def mutations(path: str, source: str) -> list[Mutation]:
    """All that can be made in that module, in its order."""
    return [*_Places(path, source).all()]


class _Places:
    """Walks one module.

    What no test can notice is left out: types, docstrings, assertions, protocols, and what only other
    platforms run.
    """

    def __init__(self, path: str, source: str) -> None:
        self._path, self._source = path, source.encode()
        self._tree = ast.parse(source)
        self._starts = [0]
        for line in self._source.split(b"\n"):
            self._starts.append(self._starts[-1] + len(line) + 1)

    def all(self) -> Iterator[Mutation]:
        for node in self._walk(self._tree):
            yield from self._of(node)

    def _walk(self, node: ast.AST) -> Iterator[ast.AST]:
        if self._is_left_out(node):
            return
        yield node
        never = _of_other_platforms(node)
        for name, value in ast.iter_fields(node):
            if name in ("annotation", "returns", "decorator_list", "type_params", "bases", *never):
                continue
            for child in value if isinstance(value, list) else [value]:
                if isinstance(child, ast.AST):
                    yield from self._walk(child)

    def _is_left_out(self, node: ast.AST) -> bool:
        match node:
            case ast.Assert() | ast.Import() | ast.ImportFrom() | ast.JoinedStr():
                return True
            case ast.Expr(value=ast.Constant()):
                return True
            case ast.If(test=ast.Name(id="TYPE_CHECKING")) | ast.keyword(arg="frozen" | "strict"):
                return True
            case ast.ClassDef(bases=bases):
                return any(isinstance(each, ast.Name) and each.id == "Protocol" for each in bases)
            case ast.AnnAssign(annotation=ast.Name(id="TypeAlias")):
                return True
            case ast.Assign(targets=[ast.Name(id=name)]):
                return name == "TYPE_CHECKING" or name.startswith("__")
            case ast.FunctionDef(name=name):
                return name in ("__repr__", "__hash__")
            case ast.Raise(exc=ast.Call(func=ast.Name(id=name))):
                return name in ("AssertionError", "NotImplementedError", "TypeError")
        return False

    def _of(self, node: ast.AST) -> Iterator[Mutation]:
        match node:
            case ast.Compare(left=left, ops=ops, comparators=comparators):
                for one, operator, other in zip([left, *comparators], ops, comparators, strict=False):
                    yield self._between(one, other, _COMPARISONS[type(operator)], "comparison")
            case ast.BinOp(left=left, op=operator, right=right) if type(operator) in _OPERATORS:
                if not _is_text(left) and not _is_text(right):
                    yield self._between(left, right, _OPERATORS[type(operator)], "operator")
            case ast.BoolOp(op=operator, values=values):
                word = "or" if isinstance(operator, ast.And) else "and"
                for one, other in pairwise(values):
                    yield self._between(one, other, word, f"{word} in place of the other")
                for left_out in values:
                    if _on_this_platform(left_out) == isinstance(operator, ast.And):
                        continue
                    rest = [self._text(each) for each in values if each is not left_out]
                    joined = f" {'and' if word == 'or' else 'or'} ".join(f"({each})" for each in rest)
                    yield self._instead(node, f"({joined})", f"without {self._text(left_out)!r}")
            case ast.UnaryOp(op=ast.Not(), operand=operand):
                yield self._instead(node, f"({self._text(operand)})", "without not")
            case ast.Constant(value=bool() as value):
                yield self._instead(node, str(not value), "the other truth")
            case ast.Constant(value=int() | float() as value):
                yield self._instead(node, repr(value + 1), f"{value + 1} in place of {value}")
            case ast.Constant(value=str() as value) if value:
                yield self._instead(node, repr(f"x{value}x"), f"another text than {value[:20]!r}")
            case ast.If(test=test) | ast.While(test=test) | ast.IfExp(test=test):
                known = _on_this_platform(test)
                if not isinstance(test, ast.Constant) and known is not False:
                    yield self._instead(test, "False", "a condition that is never true")
                if (
                    not isinstance(test, ast.Constant)
                    and known is not True
                    and not isinstance(node, ast.While)
                ):
                    yield self._instead(test, "True", "a condition that is always true")
            case ast.Return(value=ast.expr() as value) if not _is_none(value):
                yield self._instead(value, "None", "returns None")
            case ast.Break():
                yield self._instead(node, "continue", "continue in place of break")
            case ast.Continue():
                yield self._instead(node, "break", "break in place of continue")
            case ast.Expr(value=ast.Call() | ast.Await()) | ast.AugAssign():
                yield self._instead(node, "pass", f"without {self._text(node)[:40]!r}")
            case ast.Assign(targets=[ast.Attribute() | ast.Subscript(), *_]):
                yield self._instead(node, "pass", f"without {self._text(node)[:40]!r}")

    def _between(self, one: ast.expr, other: ast.expr, text: str, kind: str) -> Mutation:
        """In place of the operator between two operands; brackets around these stay."""
        start, end = self._place(one)[1], self._place(other)[0]
        gap = self._source[start:end].decode()
        before = gap[: len(gap) - len(gap.lstrip(" )\n\\"))]
        after = gap[len(gap.rstrip(" (\n\\")) :]
        return self._mutation(one, start, end, f"{before or ' '}{text}{after or ' '}", f"{kind}: {text}")

    def _instead(self, node: ast.expr | ast.stmt, text: str, kind: str) -> Mutation:
        return self._mutation(node, *self._place(node), text, kind)

    def _mutation(self, node: ast.expr | ast.stmt, start: int, end: int, text: str, kind: str) -> Mutation:
        return Mutation(self._path, node.lineno, start, end, text, kind)

    def _place(self, node: ast.expr | ast.stmt) -> tuple[int, int]:
        assert node.end_lineno is not None and node.end_col_offset is not None
        return (
            self._starts[node.lineno - 1] + node.col_offset,
            self._starts[node.end_lineno - 1] + node.end_col_offset,
        )

    def _text(self, node: ast.expr | ast.stmt) -> str:
        start, end = self._place(node)
        return self._source[start:end].decode()


def _on_this_platform(test: ast.expr) -> bool | None:
    """What a condition about the platform is here; None if it is about something else."""
    match test:
        case ast.UnaryOp(op=ast.Not(), operand=operand):
            opposite = _on_this_platform(operand)
            return None if opposite is None else not opposite
        case (
            ast.Compare(left=ast.Attribute(value=ast.Name("sys"), attr="platform"))
            | ast.Compare(left=ast.Attribute(value=ast.Name("os"), attr="name"))
            | ast.Call(func=ast.Attribute(ast.Attribute(ast.Name("sys"), "platform"), "startswith"))
            | ast.Call(func=ast.Name("hasattr"), args=[ast.Name("os" | "select" | "signal" | "socket"), _])
        ):
            modules = {"os": os, "select": select, "signal": signal, "socket": socket, "sys": sys}
            return bool(eval(ast.unparse(test), modules))
    return None


def _of_other_platforms(node: ast.AST) -> tuple[str, ...]:
    """The parts of an ``if`` that can't run here, and its condition if it is about the platform."""
    match node:
        case ast.If(test=test) | ast.IfExp(test=test):
            known = _on_this_platform(test)
            return () if known is None else ("test", "orelse" if known else "body")
    return ()


def _is_text(node: ast.expr) -> bool:
    return isinstance(node, ast.JoinedStr) or (isinstance(node, ast.Constant) and isinstance(node.value, str))


def _is_none(node: ast.expr) -> bool:
    return isinstance(node, ast.Constant) and node.value is None
