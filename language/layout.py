"""Tokens and comments in canonical lines: what stands on a line of its own, how deep, with which blanks.

Rule: a command begins a line, and so do ELSE and END. A comment stays behind what it was behind, or on
its own line if it had one; a command that goes on after a comment goes on in the next line, one level
deeper. One between the words of a keyword goes behind the keyword. Of several blank lines between commands
one is kept, at the borders of blocks none.
"""

from __future__ import annotations

import re
from collections.abc import Collection

from language.lexer import DISTANCE, KIND, NAME, NUMBER, Comment, Lexed, Token
from language.outline import ENDS, OPENERS
from language.source import COMMENT_MARK, line_ends
from language.translation import Translation

INDENT = "  "

_ELSE, _DO, _SEMICOLON, _SIGN = (KIND[name] for name in ("ELSE", "DO", "SEMICOLON", "SIGN"))
_FOR, _LPAR, _LSQB = (KIND[name] for name in ("FOR", "LPAR", "LSQB"))
_GLUED_TO_BEFORE = frozenset(KIND[name] for name in ("RPAR", "RSQB", "COMMA", "COLON", "SEMICOLON"))
_OPERAND_ENDS = frozenset(KIND[name] for name in ("RPAR", "DIRECTION", "AXIS", "COLOUR")) | {
    NAME,
    NUMBER,
    DISTANCE,
}
_mark = re.compile(COMMENT_MARK)


def laid_out(lexed: Lexed, starts: Collection[int], translation: Translation) -> str:
    """The text of a program without mistakes. ``starts`` are the offsets at which its commands begin."""
    layout = _Layout(lexed, starts, translation)
    comments = iter([*lexed.comments, None])
    comment = next(comments)
    for index, token in enumerate(lexed.tokens):
        while comment is not None and comment.before == index:
            layout.add_comment(comment)
            comment = next(comments)
        layout.add(token)
    while comment is not None:
        layout.add_comment(comment)
        comment = next(comments)
    return layout.text()


class _Layout:
    """The lines so far."""

    def __init__(self, lexed: Lexed, starts: Collection[int], translation: Translation) -> None:
        self._lexed = lexed
        self._starts = starts
        self._translation = translation
        self._lines: list[str] = []
        self._depth = 0
        self._command_depth = 0
        self._before: Token | None = None
        self._last_line = 0
        self._is_in_for = False
        self._is_unary = False
        self._must_break = False
        self._is_first_in_block = True

    def text(self) -> str:
        return "".join(f"{line}\n" for line in self._lines)

    def add(self, token: Token) -> None:
        kind = token[0]
        if kind == _SEMICOLON and not self._is_in_for:
            self._last_line = token[3]
            return
        written = self._translation.written(token, self._lexed.source[token[1] : token[2]])
        if self._begins_line(token):
            self._begin_line(token, written)
        elif self._must_break:
            self._lines.append(INDENT * (self._command_depth + 1) + written)
        else:
            self._lines[-1] += self._blank_before(token) + written
        self._must_break = False
        self._is_unary = kind == _SIGN and (self._before is None or self._before[0] not in _OPERAND_ENDS)
        self._before = token
        self._last_line = token[3] + len(line_ends(self._lexed.source[token[1] : token[2]]))
        self._is_in_for = kind == _FOR or (self._is_in_for and kind != _DO)

    def _begins_line(self, token: Token) -> bool:
        return token[1] in self._starts or token[0] in ENDS or token[0] == _ELSE

    def _begin_line(self, token: Token, written: str) -> None:
        kind = token[0]
        closes = kind in ENDS or kind == _ELSE
        if closes:
            self._depth -= 1
        elif not self._is_first_in_block:
            self._keep_blank_line(token[3])
        self._lines.append(INDENT * self._depth + written)
        self._command_depth = self._depth
        self._is_first_in_block = kind in OPENERS or kind == _ELSE
        if self._is_first_in_block:
            self._depth += 1

    def _keep_blank_line(self, line: int) -> None:
        if line > self._last_line + 1:
            self._lines.append("")

    def _blank_before(self, token: Token) -> str:
        before = self._before[0] if self._before else 0
        if token[0] in _GLUED_TO_BEFORE or before in (_LPAR, _LSQB):
            return ""
        return "" if self._is_unary and token[0] != _SIGN else " "

    def add_comment(self, comment: Comment) -> None:
        written = _comment(self._lexed.source[comment.start : comment.end])
        following = self._lexed.tokens[comment.before : comment.before + 1]
        is_within = bool(following) and not self._ends_command(following[0])
        is_in_keyword = self._before is not None and comment.start < self._before[2]
        is_behind = comment.line == self._last_line or is_in_keyword
        if self._lines and is_behind and not self._must_break:
            self._lines[-1] += f" {written}"
        elif is_within:
            self._lines.append(INDENT * (self._command_depth + 1) + written)
        else:
            if not self._is_first_in_block:
                self._keep_blank_line(comment.line)
            self._lines.append(INDENT * self._depth + written)
            self._is_first_in_block = False
        self._must_break = True
        self._last_line = max(self._last_line, comment.line)

    def _ends_command(self, following: Token) -> bool:
        return self._begins_line(following) or (following[0] == _SEMICOLON and not self._is_in_for)


def _comment(typed: str) -> str:
    words = _mark.sub("", typed, count=1).rstrip()
    return f"-- {words}" if words[:1].isalnum() else f"--{words}"
