"""Canonical text: one command a line, keywords in capitals, two blanks a level; and translation.

Rule: only layout and the spelling of keywords change. Names, numbers, strings and the words of comments do
not change. Formatting a second time changes nothing.

A command begins a line, and so do ELSE and END. A comment stays after the same word, or on its own line if
it had one. A command that continues after a comment continues in the next line, one level deeper. A comment
between the words of a keyword moves after the keyword. One of several blank lines between commands is kept,
none at the borders of blocks.
"""

from __future__ import annotations

import re
from collections import deque
from collections.abc import Collection

from msgspec import Struct

from language.diagnostics import Diagnostic
from language.keywords import argument, argument_spelling, languages_of, word
from language.lexer import (
    KIND,
    NAME,
    NUMBER,
    SENSOR_FORMS,
    STRING,
    TAKES,
    TOPIC,
    Comment,
    Lexed,
    Token,
    language_of,
    lex,
)
from language.locales import languages
from language.outline import ENDS, INDENT, OPENERS
from language.parser import parse
from language.source import COMMENT_MARK, fold_name, line_breaks, with_newlines
from language.syntax import walk

_ELSE, _DO, _SEMICOLON, _SIGN = (KIND[name] for name in ("ELSE", "DO", "SEMICOLON", "SIGN"))
_FOR, _LPAR, _LSQB = (KIND[name] for name in ("FOR", "LPAR", "LSQB"))
_FIRST_KEYWORD = KIND["VAR"]
_ARGUMENTS = {KIND[name]: name for name in TAKES.values()}
_GLUED_TO_BEFORE = frozenset(KIND[name] for name in ("RPAR", "RSQB", "COMMA", "COLON", "SEMICOLON"))
_OPERAND_ENDS = {NAME, NUMBER, KIND["RPAR"]} | {KIND[form[-1]] for form in SENSOR_FORMS}
_mark = re.compile(COMMENT_MARK)


class Formatted(Struct, frozen=True):
    """The canonical text, or None and the mistakes."""

    text: str | None
    diagnostics: tuple[Diagnostic, ...]


def formatted(source: str, to: str | None = None) -> Formatted:
    """The canonical text of a program, with keywords in language ``to`` or in their own languages.

    None for a text with mistakes of form, with the mistakes. Raises ``KeyError`` for an unknown language.
    """
    parsed = parse(source)
    if parsed.program is None:
        return Formatted(None, parsed.diagnostics)
    lexed = lex(source)
    speller = _Speller(to, language_of(lexed.tokens, source))
    starts = {statement.span.start for statement in walk(parsed.program.body)}
    layout = _Layout(lexed, starts, speller)
    comments = deque(lexed.comments)
    for index, token in enumerate(lexed.tokens):
        while comments and comments[0].before == index:
            layout.add_comment(comments.popleft())
        layout.add(token)
    for comment in comments:
        layout.add_comment(comment)
    return Formatted("".join(f"{line}\n" for line in layout.lines), ())


class _Speller:
    """Spells the tokens of one text. Short forms stay short: FW is PF, and FORWARD is PARA FRENTE."""

    def __init__(self, to: str | None, written_in: str) -> None:
        """``to`` is None to keep each word's language; ``written_in`` decides for words of several.

        Raises ``KeyError`` for an unknown language.
        """
        if to is not None and to not in languages():
            raise KeyError(to)
        self._to = to
        self._written_in = written_in

    def spelled(self, token: Token, typed: str) -> str:
        """``typed`` is the text of the token."""
        kind = token[0]
        if kind in _ARGUMENTS:
            return self._argument(_ARGUMENTS[kind], token[5])
        if kind == TOPIC:
            return self._keyword(token[5]) or " ".join(typed.split())
        if kind >= _FIRST_KEYWORD:
            return self._keyword(token[5])
        return with_newlines(typed) if kind == STRING else typed

    def _keyword(self, text: str) -> str:
        """Empty for a word that is no keyword."""
        found = word(text)
        return found.spellings[self._language(languages_of(text))][0] if found else ""

    def _argument(self, terminal: str, text: str) -> str:
        found = argument(terminal, text)
        assert found is not None, "the lexer makes these terminals of such words only"
        possible = (code for code, words in found.spellings.items() if text in map(fold_name, words))
        return argument_spelling(found.value, self._language(frozenset(possible)))

    def _language(self, possible: frozenset[str]) -> str:
        if self._to is not None:
            return self._to
        if self._written_in in possible:
            return self._written_in
        return next(language for language in languages() if language in possible)


class _Layout:
    """Lays out tokens and comments in lines. ``starts`` are the offsets at which commands begin."""

    def __init__(self, lexed: Lexed, starts: Collection[int], speller: _Speller) -> None:
        self.lines: list[str] = []
        self._lexed = lexed
        self._starts = starts
        self._speller = speller
        self._depth = 0
        self._command_depth = 0
        self._before: Token | None = None
        self._last_line = 0
        self._is_in_for = False
        self._is_unary = False
        self._must_break = False
        self._is_first_in_block = True

    def add(self, token: Token) -> None:
        kind = token[0]
        if kind == _SEMICOLON and not self._is_in_for:
            self._last_line = token[3]
            return
        typed = self._lexed.source[token[1] : token[2]]
        spelled = self._speller.spelled(token, typed)
        if self._begins_line(token):
            self._begin_line(token, spelled)
        elif self._must_break:
            self.lines.append(INDENT * (self._command_depth + 1) + spelled)
        else:
            self.lines[-1] += self._blank_before(token) + spelled
        self._must_break = False
        self._is_unary = kind == _SIGN and (self._before is None or self._before[0] not in _OPERAND_ENDS)
        self._before = token
        self._last_line = token[3] + len(line_breaks(typed))
        self._is_in_for = kind == _FOR or (self._is_in_for and kind != _DO)

    def _begins_line(self, token: Token) -> bool:
        return token[1] in self._starts or token[0] in ENDS or token[0] == _ELSE

    def _begin_line(self, token: Token, spelled: str) -> None:
        kind = token[0]
        if kind in ENDS or kind == _ELSE:
            self._depth -= 1
        elif not self._is_first_in_block:
            self._keep_blank_line(token[3])
        self.lines.append(INDENT * self._depth + spelled)
        self._command_depth = self._depth
        self._is_first_in_block = kind in OPENERS or kind == _ELSE
        if self._is_first_in_block:
            self._depth += 1

    def _keep_blank_line(self, line: int) -> None:
        if line > self._last_line + 1:
            self.lines.append("")

    def _blank_before(self, token: Token) -> str:
        before = self._before[0] if self._before else 0
        if token[0] in _GLUED_TO_BEFORE or before in (_LPAR, _LSQB):
            return ""
        return "" if self._is_unary and token[0] != _SIGN else " "

    def add_comment(self, comment: Comment) -> None:
        words = _mark.sub("", self._lexed.source[comment.start : comment.end], count=1).rstrip()
        text = f"-- {words}" if words[:1].isalnum() else f"--{words}"
        following = self._lexed.tokens[comment.before : comment.before + 1]
        is_within = bool(following) and not self._is_end_of_command(following[0])
        is_in_keyword = self._before is not None and comment.start < self._before[2]
        is_after_word = comment.line == self._last_line or is_in_keyword
        if self.lines and is_after_word and not self._must_break:
            self.lines[-1] += f" {text}"
        elif is_within:
            self.lines.append(INDENT * (self._command_depth + 1) + text)
        else:
            if not self._is_first_in_block:
                self._keep_blank_line(comment.line)
            self.lines.append(INDENT * self._depth + text)
            self._is_first_in_block = False
        self._must_break = True
        self._last_line = max(self._last_line, comment.line)

    def _is_end_of_command(self, following: Token) -> bool:
        return self._begins_line(following) or (following[0] == _SEMICOLON and not self._is_in_for)
