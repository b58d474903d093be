"""The syntax of a world file: text in, a tree out. Lines and columns count from 1.

A word may have an index, ``point[0]``, without a blank; every other ``[`` opens a tuple. Only this module of
the simulator knows lark.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import cache
from importlib.resources import files
from typing import NamedTuple, TypeAlias

from lark import Lark, Token, Transformer, UnexpectedInput, UnexpectedToken, v_args
from lark.lexer import Lexer
from msgspec import Struct
from msgspec.structs import replace

from sim.worldfile.mistakes import Code, WorldError

DEEPEST = 64
"""Parentheses and brackets inside each other."""
MOST_WORDS = 60_000
"""Words, numbers and signs of all files of a world; one of 2000 models has some 30 000."""
MOST_WRONG = 20
"""Defines with mistakes in a file that loads because nothing uses them."""
LARGEST = 1e12
"""No number of a world is larger; lengths are held to a narrower limit where they are used."""

_TOKEN = re.compile(
    r"""(?P<BLANK>[ \t\r\f\v\u00a0]+|\#[^\n]*)
    | (?P<NEWLINE>\n)
    | (?P<NUMBER>[+-]?(?:[0-9]++(?:\.[0-9]*+)?|\.[0-9]++)(?:[eE][+-]?[0-9]++)?+)(?![\w.+\-])
    | (?P<SIGNS>[+\-.0-9]++)(?!\w)
    | (?P<WORD>[^\W\d_][\w.\-]*(?:\[[0-9]+\][\w.\-]*)*)
    | "(?P<STRING>[^"\n]*)"
    | (?P<LPAR>\() | (?P<RPAR>\)) | (?P<LSQB>\[) | (?P<RSQB>\])""",
    re.VERBOSE,
)
_LINE = re.compile(r".[^\n]*")
_CLOSES = {"RPAR": "LPAR", "RSQB": "LSQB"}
_LEADING = re.compile(r"[ \t]*+([+-]?(?:[0-9]++(?:\.[0-9]*+)?|\.[0-9]++)(?:[eE][+-]?[0-9]++)?+)")
REST = re.compile(r"[ \t]*+[^\w\s#()\[\]\"][^\n]*")
"""Of the line of an include: what can't begin anything."""


# --- the tree: as it was written, nothing is looked up yet


class Number(Struct, frozen=True):
    line: int
    column: int
    value: float
    text: str
    is_plain: bool = True
    """False: digits, points and signs in an order that is no number. Stage reads the first part that is."""


class String(Struct, frozen=True):
    line: int
    column: int
    text: str


class Tuple(Struct, frozen=True):
    line: int
    column: int
    items: tuple[Value, ...]


Value: TypeAlias = Number | String | Tuple


class Property(Struct, frozen=True):
    """``name value``."""

    line: int
    column: int
    name: str
    value: Value


class Instance(Struct, frozen=True):
    """``type ( ... )``."""

    line: int
    column: int
    type: str
    body: tuple[Item, ...]


class Define(Struct, frozen=True):
    """``define name base ( ... )``."""

    line: int
    column: int
    name: str
    base: str
    body: tuple[Item, ...]
    base_line: int
    base_column: int
    mistake: WorldError | None = None
    """Of its body, which is left out then. Stage reads a body only where it is used."""


class Include(Struct, frozen=True):
    """``include "path"``; the place is that of the path."""

    line: int
    column: int
    path: str
    rest: str = ""
    """What follows on its line and has no effect, as in Stage."""


class Included(Struct, frozen=True):
    """What stands in a file that a body includes."""

    file: str
    item: Property | Instance


Item: TypeAlias = Property | Instance | Include | Included
"""What stands in a body: as it is written, or with each include replaced by what it includes."""
Statement: TypeAlias = Property | Instance | Define | Include


# --- words


class WorldToken(NamedTuple):
    kind: str
    """NUMBER, WORD, INCLUDE, DEFINE, STRING, LPAR, RPAR, LSQB, RSQB, or REST, of the line of an include."""
    text: str
    line: int
    column: int


class WordCount:
    """Counts the tokens of all files of one world, before they are parsed: that takes many times as long."""

    def __init__(self) -> None:
        self._left = MOST_WORDS

    def take(self, text: str, file: str) -> None:
        """Raises ``WorldError`` where there are too many."""
        position = 0
        while position < len(text):
            match = _TOKEN.match(text, position) or _LINE.match(text, position)
            assert match is not None
            if match.lastgroup not in ("BLANK", "NEWLINE"):
                self._left -= 1
                if self._left < 0:
                    raise _too_many_words(text, file, position)
            position = match.end()


def _too_many_words(text: str, file: str, position: int) -> WorldError:
    line, column = text.count("\n", 0, position) + 1, position - text.rfind("\n", 0, position)
    return WorldError(Code.TOO_MUCH, file, line, column, what="words", limit=MOST_WORDS)


def tokens(text: str, file: str) -> Iterator[WorldToken]:
    """The tokens of ``text``; WorldError at the first place that is none, or where something is left open."""
    opened: list[WorldToken] = []
    for token in _read(text, file):
        if token.kind in ("LPAR", "LSQB"):
            opened.append(token)
            if len(opened) > DEEPEST:
                raise WorldError(Code.NESTED_TOO_DEEP, file, token.line, token.column, limit=DEEPEST)
        elif token.kind in _CLOSES:
            while token.kind == "RPAR" and len(opened) > 1 and opened[-1].kind == "LSQB":
                opened.pop()  # in a define that nothing uses, Stage counts parentheses only
            if opened and opened[-1].kind == _CLOSES[token.kind]:
                opened.pop()
        yield token
    if opened:
        last = opened[-1]
        sign = ")" if last.kind == "LPAR" else "]"
        raise WorldError(Code.UNCLOSED, file, last.line, last.column, (sign,), found=last.text)


def _read(text: str, file: str) -> Iterator[WorldToken]:
    position, line, line_start, before = 0, 1, 0, ("", "")
    while position < len(text):
        column = position - line_start + 1
        if before == ("INCLUDE", "STRING") and (rest := REST.match(text, position)) is not None:
            yield WorldToken("REST", rest[0].strip(), line, column)
            position, before = rest.end(), ("", "")
            continue
        match = _TOKEN.match(text, position)
        if match is None:
            raise _unreadable(text, position, file, line, column)
        position = match.end()
        kind = match.lastgroup
        if kind == "NEWLINE":
            line, line_start, before = line + 1, position, ("", "")
        elif kind != "BLANK":
            assert kind is not None
            token = _token(kind, match[kind], file, line, column)
            before = (before[1], token.kind)
            yield token


def _token(kind: str, word: str, file: str, line: int, column: int) -> WorldToken:
    if kind == "WORD" and word in ("include", "define"):
        kind = word.upper()
    number = float(word) if kind == "NUMBER" else leading_number(word) if kind == "SIGNS" else 0.0
    kind = "NUMBER" if kind == "SIGNS" else kind
    refuse_too_large(number, word, file, line, column)
    return WorldToken(kind, word, line, column)


def refuse_too_large(number: float, word: str, file: str, line: int, column: int) -> None:
    """Raises ``WorldError`` for a number beyond ``LARGEST``, as ``word`` has it."""
    if not abs(number) <= LARGEST:
        raise WorldError(Code.NUMBER_TOO_LARGE, file, line, column, found=word[:40], limit=LARGEST)


def leading_number(text: str) -> float:
    """The number with which a text begins; 0 if with none, as in Stage."""
    number = _LEADING.match(text)
    return float(number[1]) if number else 0.0


_DASHES = "--"
_COMMENTS = ("//", "/*", ";;")
"""What other languages begin comments with; those that begin with two dashes are found by the parser."""


def _unreadable(text: str, position: int, file: str, line: int, column: int) -> WorldError:
    found = text[position]
    if found == '"':
        return WorldError(Code.UNTERMINATED_STRING, file, line, column, ('"',))
    if found.isdigit() or (found in "+-." and text[position + 1 : position + 2].isdigit()):
        number = re.match(r"[\w.+\-]{1,40}", text[position : position + 40])
        word = number[0] if number else found
        return WorldError(Code.BAD_NUMBER, file, line, column, ("number",), found=word)
    if text.startswith(_COMMENTS, position):
        return WorldError(Code.COMMENT_SIGN, file, line, column, ("#",), found=text[position : position + 2])
    return WorldError(Code.UNKNOWN_CHARACTER, file, line, column, found=found)


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


def parse(text: str, file: str) -> tuple[Statement, ...]:
    """The statements of one file, in order. WorldError at the first mistake of form."""
    words: Iterable[WorldToken] = tokens(text, file)
    wrong: dict[tuple[int, int], WorldError] = {}
    while True:
        try:
            statements: tuple[Statement, ...] = _grammar().parse(_Source(words))  # type: ignore[assignment]
        except UnexpectedToken as problem:
            mistake = _unexpected(problem, file)
            try:
                rest = tuple(tokens(text, file)) if not wrong else tuple(words)
            except WorldError:  # after it is another one, which no define can hide
                raise mistake from None
            around = _define_around(rest, mistake)
            if around is None or len(wrong) == MOST_WRONG:
                raise mistake from None
            start, opened, closed = around
            wrong[rest[start].line, rest[start].column] = mistake
            words = (*rest[: opened + 1], *rest[closed:])
        else:
            return tuple(_with_mistake(each, wrong) for each in statements) if wrong else statements


def _define_around(words: Sequence[WorldToken], mistake: WorldError) -> tuple[int, int, int] | None:
    """The define in whose body a mistake is: where its word and the signs around its body are."""
    place, depth, start, opened = (mistake.line, mistake.column), 0, -1, 0
    for at, word in enumerate(words):
        match word.kind:
            case "DEFINE" if depth == 0:
                start = at
            case "LPAR":
                opened = at if depth == 0 else opened
                depth += 1
            case "RPAR":
                depth -= 1
                if depth == 0:
                    here = words[opened]
                    if start >= 0 and (here.line, here.column) < place <= (word.line, word.column):
                        return start, opened, at
                    start = -1
    return None


def _with_mistake(statement: Statement, wrong: Mapping[tuple[int, int], WorldError]) -> Statement:
    mistake = wrong.get((statement.line, statement.column))
    return replace(statement, mistake=mistake) if isinstance(statement, Define) and mistake else statement


def _unexpected(problem: UnexpectedToken, file: str) -> WorldError:
    token = problem.token
    line, column = int(token.line or 1), int(token.column or 1)
    if token.type in ("INCLUDE", "DEFINE"):
        return WorldError(Code.MISPLACED, file, line, column, found=str(token))
    if token.startswith(_DASHES):
        return WorldError(Code.COMMENT_SIGN, file, line, column, ("#",), found=_DASHES)
    expected = tuple(_EXPECTED[name] for name in sorted(_acceptable(problem) - {"REST"}))
    return WorldError(Code.UNEXPECTED, file, line, column, expected, found=str(token)[:60])


def _acceptable(problem: UnexpectedInput) -> set[str]:
    """The terminals that fit here; ``problem.expected`` lists too many."""
    parser = getattr(problem, "interactive_parser", None)
    return set(parser.accepts()) if parser is not None else set()


class _Source:
    """Tokens, passed through lark to ``_Words``."""

    def __init__(self, words: Iterable[WorldToken]) -> None:
        self.words = words


class _Words(Lexer):
    """A lark lexer over the tokens of ``tokens``."""

    def __init__(self, lexer_conf: object) -> None:
        pass

    def lex(self, source: object) -> Iterator[Token]:  # type: ignore[override]  # lark's first interface
        assert isinstance(source, _Source)
        for kind, text, line, column in source.words:
            yield Token(_TERMINALS.get(kind, kind), text, 0, line, column)


@v_args(inline=True)
class _Builder(Transformer[Token, object]):
    def start(self, *statements: Statement) -> tuple[Statement, ...]:
        return statements

    def include(self, _: Token, path: Token, rest: str = "") -> Include:
        return Include(*_place(path), str(path), str(rest))

    def define(self, word: Token, name: Token, base: Token, body: tuple[Item, ...]) -> Define:
        return Define(*_place(word), str(name), str(base), body, *_place(base))

    def instance(self, kind: Token, body: tuple[Item, ...]) -> Instance:
        return Instance(*_place(kind), str(kind), body)

    def property(self, name: Token, value: Value) -> Property:
        return Property(*_place(name), str(name), value)

    def body(self, *items: Item) -> tuple[Item, ...]:
        return items

    def number(self, number: Token) -> Number:
        try:
            return Number(*_place(number), float(number), str(number))
        except ValueError:  # few worlds have such a number, and the others load faster so
            return Number(*_place(number), leading_number(number), str(number), False)

    def string(self, string: Token) -> String:
        return String(*_place(string), str(string))

    def tuple(self, bracket: Token, *items: Value) -> Tuple:
        return Tuple(*_place(bracket), items)


def _place(token: Token) -> tuple[int, int]:
    return token.line or 1, token.column or 1


@cache
def _grammar() -> Lark:
    text = files("sim.worldfile").joinpath("worldfile.lark").read_text(encoding="utf-8")
    return Lark(text, parser="lalr", lexer=_Words, transformer=_Builder())
