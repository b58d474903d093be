"""Which language a text is written in, as far as its keywords tell."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable

from language.keywords import LANGUAGES, languages_of
from language.lexer import Token


def language_of(tokens: Iterable[Token]) -> str:
    """The language that most of the telling keywords belong to; English if none tells."""
    words = Counter(token[5] for token in tokens if token[5][:1].isalpha())
    votes = dict.fromkeys(LANGUAGES, 0)
    for word, count in words.items():
        languages = languages_of(word)
        if len(languages) < len(LANGUAGES):
            for language in languages:
                votes[language] += count
    return max(LANGUAGES, key=votes.__getitem__)
