"""The words of a world file: text in, tokens with true places out. Lines and columns count from 1.

A word may hold an index, ``point[0]``, without a blank; every other ``[`` opens a tuple.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import NamedTuple

from sim.worldfile.mistakes import Code, WorldError

DEEPEST = 64
"""Parentheses and brackets inside each other."""
LARGEST = 1e12
"""No number of a world is larger; lengths are held to a narrower limit where they are used."""

_TOKEN = re.compile(
    r"""(?P<BLANK>[ \t\r\f\v\u00a0]+|\#[^\n]*)
    | (?P<NEWLINE>\n)
    | (?P<NUMBER>[+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?)(?![\w.])
    | (?P<WORD>[^\W\d_][\w.\-]*(?:\[[0-9]+\][\w.\-]*)*)
    | "(?P<STRING>[^"\n]*)"
    | (?P<LPAR>\() | (?P<RPAR>\)) | (?P<LSQB>\[) | (?P<RSQB>\])""",
    re.VERBOSE,
)
_CLOSES = {"RPAR": "LPAR", "RSQB": "LSQB"}


class Token(NamedTuple):
    kind: str
    """NUMBER, WORD, INCLUDE, DEFINE, STRING, LPAR, RPAR, LSQB or RSQB."""
    text: str
    line: int
    column: int


def tokens(text: str, file: str) -> Iterator[Token]:
    """The tokens of ``text``; WorldError at the first place that is none, or where something is left open."""
    opened: list[Token] = []
    for token in _read(text, file):
        if token.kind in ("LPAR", "LSQB"):
            opened.append(token)
            if len(opened) > DEEPEST:
                raise WorldError(Code.NESTED_TOO_DEEP, file, token.line, token.column, limit=DEEPEST)
        elif opened and opened[-1].kind == _CLOSES.get(token.kind):
            opened.pop()
        yield token
    if opened:
        last = opened[-1]
        sign = ")" if last.kind == "LPAR" else "]"
        raise WorldError(Code.UNCLOSED, file, last.line, last.column, (sign,), found=last.text)


def _read(text: str, file: str) -> Iterator[Token]:
    position, line, line_start = 0, 1, 0
    while position < len(text):
        column = position - line_start + 1
        match = _TOKEN.match(text, position)
        if match is None:
            raise _unreadable(text, position, file, line, column)
        position = match.end()
        kind = match.lastgroup
        if kind == "NEWLINE":
            line, line_start = line + 1, position
        elif kind != "BLANK":
            assert kind is not None
            yield _token(kind, match[kind], file, line, column)


def _token(kind: str, word: str, file: str, line: int, column: int) -> Token:
    if kind == "WORD" and word in ("include", "define"):
        kind = word.upper()
    if kind == "NUMBER" and not abs(float(word)) <= LARGEST:
        raise WorldError(Code.NUMBER_TOO_LARGE, file, line, column, found=word[:40], limit=LARGEST)
    return Token(kind, word, line, column)


_COMMENTS = ("//", "/*", "--", ";;")
"""What other languages begin comments with."""


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
