"""Colour words that the language knows, but that the robot at hand can't see."""

from __future__ import annotations

from language.diagnostics import Diagnostic, Kind
from language.keywords import argument
from language.lexer import Lexed, Token, span_of


def unseen_colours(lexed: Lexed, colours: frozenset[str] | None) -> tuple[Diagnostic, ...]:
    """A mistake for each colour outside ``colours``, which are English words; None allows all."""
    if colours is None:
        return ()
    return tuple(
        _unseen(lexed.source, token, colours) for token in lexed.colours if _english(token) not in colours
    )


def _english(token: Token) -> str:
    found = argument("COLOUR", token[5])
    return str(found.value) if found else ""


def _unseen(source: str, token: Token, colours: frozenset[str]) -> Diagnostic:
    return Diagnostic(
        Kind.BAD_ARGUMENT,
        span_of(token),
        code="unseen-colour",
        found=source[token[1] : token[2]],
        expected=("colour",),
        details={"word": "COLOR", "wanted": ", ".join(sorted(colours))},
    )
