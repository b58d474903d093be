"""What was typed behind a word: yes and no, on and off, languages and details, numbers, a line with its text.

Whatever language is spoken now, and the same for both front ends: a word that switches one thing switches
every thing. Rule: what is anything else is None and never taken for nothing, so that a slip of the fingers
deletes no line.
"""

from __future__ import annotations

from collections.abc import Mapping

from language.source import fold_name

_YES = frozenset({"yes", "y", "sim", "s", "si"})
_NO = frozenset({"no", "n", "nao"})
_ON = frozenset({"on", "yes", "ligado", "ligar", "sim", "encendido", "encender", "si"})
_OFF = frozenset({"off", "no", "desligado", "desligar", "nao", "apagado", "apagar"})

SWITCH: Mapping[object, tuple[str, str, str]] = {False: ("off", "não", "no"), True: ("on", "sim", "sí")}
"""How off and on are told and offered, by language."""

_LANGUAGES = {
    "en": {"en", "english", "ingles"},
    "pt": {"pt", "pt-br", "portuguese", "portugues"},
    "es": {"es", "spanish", "espanhol", "espanol"},
}
_DETAILS = {
    "brief": {"brief", "short", "breve", "curto", "corto"},
    "normal": {"normal"},
    "full": {"full", "long", "completo", "cheio", "largo"},
}


def language_named(typed: str) -> str | None:
    """The language that a word means; None if it means none of ours."""
    return _named(typed, _LANGUAGES)


def detail_named(typed: str) -> str | None:
    """How much is to be told: ``brief``, ``normal`` or ``full``; None for any other word."""
    return _named(typed, _DETAILS)


def answered(typed: str) -> bool | None:
    """Whether the answer is yes; None if it is neither yes nor no."""
    return _which(typed, _YES, _NO)


def switched(typed: str) -> bool | None:
    """Whether something is to be on; None if what was typed means neither on nor off."""
    return _which(typed, _ON, _OFF)


def _named(typed: str, table: Mapping[str, set[str]]) -> str | None:
    folded = fold_name(typed.strip())
    return next((name for name, spellings in table.items() if folded in spellings), None)


def _which(typed: str, meaning_true: frozenset[str], meaning_false: frozenset[str]) -> bool | None:
    folded = fold_name(typed.strip())
    if folded in meaning_true:
        return True
    return False if folded in meaning_false else None


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
