"""Yes and no, on and off, languages and details as learners type them, whatever language is spoken now.

One place for both front ends: a word that switches one thing switches every thing.
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
