"""What follows a command word: yes and no, on and off, languages, numbers, a line with its text.

The everyday words are in ``words.toml`` of each language, and are understood whatever language is spoken now:
a word that switches one thing switches every thing. What is anything else is None and never taken for
nothing, so that a slip of the fingers deletes no line.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache

from language import locales
from language.locales import ENGLISH, language_of_locale, languages
from language.source import fold_name


def spelled(key: str, language: str, *section: str) -> str:
    """An everyday word as Donnie prints it: ``north`` of the section ``compass``."""
    return locales.words(language, "words", *section, key)[0]


def meant(typed: str, *section: str) -> str | None:
    """The key of a section that a word of any language means, None for any other word."""
    return _meanings(section).get(_folded(typed))


def keys_of(*section: str) -> tuple[str, ...]:
    """Every key of a section, in the order of the English table."""
    return locales.keys(ENGLISH, "words", *section)


@cache
def _meanings(section: tuple[str, ...]) -> Mapping[str, str]:
    """By folded word. What a word means in an earlier language it means in all."""
    found: dict[str, str] = {}
    for language in languages():
        for key in keys_of(*section):
            for word in locales.words(language, "words", *section, key):
                found.setdefault(_folded(word), key)
    return found


def _folded(typed: str) -> str:
    return " ".join(fold_name(typed).split())


def language_named(typed: str) -> str | None:
    """The language that a code or a word means; None if there is none."""
    named = next((each for each in languages() if _is_name(typed, each)), None)
    return named or language_of_locale(typed.strip())


def _is_name(typed: str, language: str) -> bool:
    return _folded(typed) in {_folded(name) for each in languages() for name in names_of(language, each)}


def name_of_language(language: str, spoken: str) -> str:
    """What a language is called in another one, or in itself; its code where nothing names it."""
    names = names_of(language, spoken) or names_of(language, language) or names_of(language, ENGLISH)
    return names[0] if names else language


def names_of(language: str, spoken: str) -> tuple[str, ...]:
    """What the language ``spoken`` calls a language."""
    return locales.own_words(spoken, "words", "languages", language)


def detail_named(typed: str) -> str | None:
    """How much is to be printed: ``brief``, ``normal`` or ``full``; None for any other word."""
    return meant(typed, "details")


def answered(typed: str) -> bool | None:
    """Whether the answer is yes; None if it is neither yes nor no."""
    return {"yes": True, "no": False}.get(meant(typed, "answers") or "")


def switched(typed: str) -> bool | None:
    """Whether something is to be on; None if what was typed means neither on nor off."""
    return {"on": True, "off": False}.get(meant(typed, "switch") or "")


NO_REPLACEMENT = '""'
"""What is typed to delete a word everywhere."""


def replacement(typed: str | None) -> str | None:
    """What REPLACE puts in place of a word. None for no answer and for Enter alone, which change nothing.

    Two quotes delete the word: they are not typed by mistake.
    """
    return "" if typed == NO_REPLACEMENT else typed or None


LARGEST_NUMBER = 10_000_000
"""No program has so many lines, no session so many answers, no world so many squares."""
_MOST_CHARACTERS = 8


def numbers_in(typed: str, *, most: int) -> tuple[int, ...] | None:
    """At most so many whole numbers, blanks or commas between them."""
    words = typed.replace(",", " ").split()
    if len(words) > most or not all(map(_is_whole, words)):
        return None
    found = tuple(map(int, words))
    return found if all(abs(each) <= LARGEST_NUMBER for each in found) else None


def number_in(typed: str, default: int) -> int | None:
    """The one number that stands there, or ``default`` where nothing does."""
    found = numbers_in(typed, most=1)
    return found if found is None else next(iter(found), default)


def count_in(typed: str, default: int) -> int | None:
    """As ``number_in``, from 1."""
    found = number_in(typed, default)
    return None if found is None or found < 1 else found


def number_and_text(typed: str) -> tuple[int, str] | None:
    """``3 FW 2`` is line 3 with its text, which may be empty."""
    word, _blank, text = typed.partition(" ")
    found = numbers_in(word, most=1)
    return (found[0], text.strip()) if found else None


def _is_whole(word: str) -> bool:
    return len(word) <= _MOST_CHARACTERS and word.removeprefix("-").isdecimal()
