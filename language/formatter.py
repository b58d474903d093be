"""Canonical text: one command a line, keywords in capitals, two blanks a level; and translation.

Rule: only layout and the spelling of keywords change. Names, numbers, strings and the words of comments
stay as they were written, every comment stays between the same two words (one within a keyword goes
behind it), and one blank line between commands is kept. What is formatted twice does not change the
second time.
"""

from __future__ import annotations

from devices.ports.values import Frozen
from language.diagnostics import Diagnostic
from language.layout import laid_out
from language.lexer import lex
from language.origin import language_of
from language.parser import parse
from language.syntax import walk
from language.translation import Translation


class Formatted(Frozen):
    """The canonical text, or None and why."""

    text: str | None
    diagnostics: tuple[Diagnostic, ...]


class NotFormatted(ValueError):
    """The text has mistakes of form, so nothing of it was changed. ``diagnostics`` are the mistakes."""

    def __init__(self, diagnostics: tuple[Diagnostic, ...]) -> None:
        super().__init__("the text has mistakes")
        self.diagnostics = diagnostics


def formatted(source: str, to: str | None = None) -> Formatted:
    """The canonical text of a program, with keywords in language ``to`` or as they are.

    None for a text with mistakes of form, with the mistakes. Raises ``KeyError`` for an unknown language.
    """
    parsed = parse(source)
    if parsed.program is None:
        return Formatted(None, parsed.diagnostics)
    lexed = lex(source)
    translation = Translation(to, language_of(lexed.tokens, source))
    starts = {statement.span.start for statement in walk(parsed.program.body)}
    return Formatted(laid_out(lexed, starts, translation), ())


def format_source(source: str, to: str | None = None) -> str:
    """The canonical text. Raises ``NotFormatted`` for a text with mistakes of form."""
    result = formatted(source, to)
    if result.text is None:
        raise NotFormatted(result.diagnostics)
    return result.text
