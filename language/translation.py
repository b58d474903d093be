"""How a token is written: keywords in capitals, in their own language or another; the rest as it was.

Short forms stay short and long ones long: FW is PF and FORWARD is PARA FRENTE.
"""

from __future__ import annotations

from language.keywords import LANGUAGES, argument, argument_spelling, languages_of, word
from language.lexer import KIND, STRING, TOPIC, Token
from language.source import fold_name

_ARGUMENTS = {KIND[name]: name for name in ("DIRECTION", "AXIS", "COLOUR", "SWITCH")}
_FIRST_KEYWORD = KIND["VAR"]


class Translation:
    """The writing of one text."""

    def __init__(self, to: str | None, written_in: str) -> None:
        """``to`` is None to keep each word's language; ``written_in`` decides for words of several.

        Raises ``KeyError`` for a language that there is not.
        """
        if to is not None and to not in LANGUAGES:
            raise KeyError(to)
        self._to = to
        self._written_in = written_in

    def written(self, token: Token, typed: str) -> str:
        """``typed`` is what stands there in the text."""
        kind = token[0]
        if kind in _ARGUMENTS:
            return self._argument(_ARGUMENTS[kind], token[5])
        if kind == TOPIC:
            return self._keyword(token[5]) or " ".join(typed.split())
        if kind >= _FIRST_KEYWORD:
            return self._keyword(token[5])
        return typed.replace("\r\n", "\n").replace("\r", "\n") if kind == STRING else typed

    def _keyword(self, text: str) -> str:
        """Empty for what is none."""
        found = word(text)
        return found.spellings[self._language(languages_of(text))][0] if found else ""

    def _argument(self, terminal: str, text: str) -> str:
        found = argument(terminal, text)
        assert found is not None, "the lexer makes these terminals of such words only"
        spoken = (code for code, words in found.spellings.items() if text in map(fold_name, words))
        return argument_spelling(found.value, self._language(frozenset(spoken)))

    def _language(self, possible: frozenset[str]) -> str:
        if self._to is not None:
            return self._to
        if self._written_in in possible:
            return self._written_in
        return next(language for language in LANGUAGES if language in possible)
