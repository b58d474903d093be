"""Which languages a text is written in, as far as its keywords tell."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from unicodedata import normalize

from language.keywords import LANGUAGES, all_words, languages_of
from language.lexer import Token


def languages_in(tokens: Iterable[Token], source: str = "") -> frozenset[str]:
    """The language of ``language_of``, and each other one that has a keyword to itself in the text."""
    tokens = tuple(tokens)
    spoken = [languages_of(token[5]) for token in tokens if token[5][:1].isalpha()]
    only = [languages for languages in spoken if len(languages) == 1]
    return frozenset({language_of(tokens, source)}).union(*only)


def language_of(tokens: Iterable[Token], source: str = "") -> str:
    """The language that most of the telling keywords belong to; English if none tells.

    Where ``source`` is given, the accents in it decide between languages that are equal otherwise.
    """
    tokens = [token for token in tokens if token[5][:1].isalpha()]
    words = Counter(token[5] for token in tokens)
    typed = Counter(normalize("NFC", source[token[1] : token[2]]).upper() for token in tokens)
    votes = {language: [0, 0] for language in LANGUAGES}
    for word, count in words.items():
        languages = languages_of(word)
        if len(languages) < len(LANGUAGES):
            for language in languages:
                votes[language][0] += count
    for language in LANGUAGES:
        votes[language][1] = sum(typed[word] for word in all_words(language))
    return max(LANGUAGES, key=votes.__getitem__)
