"""The sentences of a world file: text in, a tree out. The one place of the simulator that knows lark."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from importlib.resources import files

from lark import Lark, Token, Transformer, UnexpectedInput, UnexpectedToken, v_args
from lark.lexer import Lexer

from sim.worldfile import tree
from sim.worldfile.mistakes import Code, WorldError
from sim.worldfile.tokens import tokens

_TERMINALS = {"LPAR": "_LPAR", "RPAR": "_RPAR", "RSQB": "_RSQB"}
_EXPECTED = {
    "_LPAR": "(",
    "_RPAR": ")",
    "LSQB": "tuple",
    "_RSQB": "]",
    "WORD": "name",
    "NUMBER": "number",
    "STRING": "string",
    "INCLUDE": "include",
    "DEFINE": "define",
    "$END": "end of file",
}


def parse(text: str, file: str) -> tuple[tree.Statement, ...]:
    """The statements of one file, in order. WorldError at the first mistake of form."""
    try:
        statements: tuple[tree.Statement, ...] = _grammar().parse(_Source(text, file))  # type: ignore[assignment]
        return statements
    except UnexpectedToken as problem:
        raise _unexpected(problem, file) from None


def _unexpected(problem: UnexpectedToken, file: str) -> WorldError:
    token = problem.token
    line, column = int(token.line or 1), int(token.column or 1)
    if token.type in ("INCLUDE", "DEFINE"):
        return WorldError(Code.MISPLACED, file, line, column, found=str(token))
    expected = tuple(_EXPECTED[name] for name in sorted(_acceptable(problem)))
    return WorldError(Code.UNEXPECTED, file, line, column, expected, found=str(token)[:60])


def _acceptable(problem: UnexpectedInput) -> set[str]:
    """``problem.expected`` lists too much: only the parser itself knows what fits here."""
    parser = getattr(problem, "interactive_parser", None)
    return set(parser.accepts()) if parser is not None else set()


class _Source:
    """A text that knows its file, on its way through lark to our lexer."""

    def __init__(self, text: str, file: str) -> None:
        self.text = text
        self.file = file


class _Words(Lexer):
    """Our tokens in lark's clothes."""

    def __init__(self, lexer_conf: object) -> None:
        pass

    def lex(self, source: object) -> Iterator[Token]:  # type: ignore[override]  # lark's first interface
        assert isinstance(source, _Source)
        for kind, text, line, column in tokens(source.text, source.file):
            yield Token(_TERMINALS.get(kind, kind), text, 0, line, column)


@v_args(inline=True)
class _Builder(Transformer[Token, object]):
    def start(self, *statements: tree.Statement) -> tuple[tree.Statement, ...]:
        return statements

    def include(self, _: Token, path: Token) -> tree.Include:
        return tree.Include(*_place(path), str(path))

    def define(self, word: Token, name: Token, base: Token, body: tuple[tree.Item, ...]) -> tree.Define:
        return tree.Define(*_place(word), str(name), str(base), body, *_place(base))

    def instance(self, kind: Token, body: tuple[tree.Item, ...]) -> tree.Instance:
        return tree.Instance(*_place(kind), str(kind), body)

    def property(self, name: Token, value: tree.Value) -> tree.Property:
        return tree.Property(*_place(name), str(name), value)

    def body(self, *items: tree.Item) -> tuple[tree.Item, ...]:
        return items

    def number(self, number: Token) -> tree.Number:
        return tree.Number(*_place(number), float(number))

    def string(self, string: Token) -> tree.String:
        return tree.String(*_place(string), str(string))

    def tuple(self, bracket: Token, *items: tree.Value) -> tree.Tuple:
        return tree.Tuple(*_place(bracket), items)


def _place(token: Token) -> tuple[int, int]:
    return token.line or 1, token.column or 1


@cache
def _grammar() -> Lark:
    text = files("sim.worldfile").joinpath("worldfile.lark").read_text(encoding="utf-8")
    return Lark(text, parser="lalr", lexer=_Words, transformer=_Builder())
