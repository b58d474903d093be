"""Suggests words for the letters before the cursor: commands, names, colours, directions.

Uses one language's keywords, and names as they were declared. Works on any text, finished or not.
"""

from __future__ import annotations

from collections.abc import Iterable

from msgspec import Struct

from language import keywords
from language.lexer import NAME, STRING, TAKES, lex
from language.outline import open_block
from language.source import fold_name

MOST = 50
"""Suggestions; a listener does not follow more."""
LARGEST = 50_000
"""Characters of a text that is searched."""


class Completion(Struct, frozen=True):
    """The words that the letters before the cursor can become."""

    typed: str
    words: tuple[str, ...]


def completion(text: str, at: int, language: str, colours: Iterable[str] | None = None) -> Completion:
    """The words for the letters that end at offset ``at``. ``colours``: those that the robot can see."""
    start = _start_of_word(text, at)
    typed = text[start:at]
    if len(text) > LARGEST or _is_inside_string(text, at):
        return Completion(typed, ())
    folded = fold_name(typed)
    fitting = [each for each in _words(text, start, at, language, colours) if fold_name(each) != folded]
    found = tuple(dict.fromkeys(each for each in fitting if fold_name(each).startswith(folded)))
    return Completion(typed, tuple(_as_typed(each, typed) for each in found[:MOST]))


def _start_of_word(text: str, at: int) -> int:
    start = at
    while start > 0 and (text[start - 1].isalnum() or text[start - 1] == "_"):
        start -= 1
    return start


def _is_inside_string(text: str, at: int) -> bool:
    line = text[text.rfind("\n", 0, at) + 1 : at]
    tokens = lex(line).tokens
    return (bool(tokens) and tokens[-1][0] == STRING and lex(line).open_quote is not None) or "--" in line


def _words(text: str, start: int, at: int, language: str, colours: Iterable[str] | None) -> Iterable[str]:
    before = lex(text[:start]).tokens
    terminal = TAKES.get(before[-1][0]) if before else None
    if terminal is not None:
        yield from _arguments(terminal, language, colours)
    else:
        if at > start:
            yield from _end_of_block(text[:start], language)
            yield from sorted(_names(text, start))
        yield from keywords.all_words(language)


def _end_of_block(before: str, language: str) -> Iterable[str]:
    """The word that ends the innermost block which is open there."""
    block = open_block(before)
    if block is not None:
        yield keywords.spelling(f"END {block.kind}", language)


def _arguments(terminal: str, language: str, colours: Iterable[str] | None) -> Iterable[str]:
    if terminal != "COLOUR" or colours is None:
        return keywords.argument_words(terminal, language)
    seen = set(colours)
    return (
        each
        for each in keywords.argument_words(terminal, language)
        if (found := keywords.argument(terminal, fold_name(each))) is not None and found.value in seen
    )


def _names(text: str, typed_at: int) -> set[str]:
    """The names of variables and procedures, but for the one that is being typed."""
    tokens = lex(text).tokens
    return {text[token[1] : token[2]] for token in tokens if token[0] == NAME and token[1] != typed_at}


def _as_typed(word: str, typed: str) -> str:
    """In small letters where those were typed, a name as it is."""
    return word.lower() if typed and typed.islower() and keywords.canonical(word) else word
