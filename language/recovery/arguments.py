"""A word behind one that takes a direction, an axis, a colour, or on and off: the wrong one, or none."""

from __future__ import annotations

from language.diagnostics import Kind
from language.keywords import argument, argument_words
from language.lexer import KIND, TAKES, Token
from language.nearby import nearest
from language.recovery.reading import Reading
from language.tables import TERMINALS

_CLASS_OF = {"DIRECTION": "direction", "AXIS": "axis", "COLOUR": "colour", "SWITCH": "on-or-off"}


def follows_taker(reading: Reading) -> bool:
    """Whether the word before wants one like this one, on the same line."""
    if reading.at <= reading.begun:
        return False
    return reading.before[0] in TAKES and reading.before[3] == reading.token[3]


def read_bad_argument(reading: Reading) -> None:
    """Also one that was taken for a name, because an equals sign follows it: that is no mistake yet."""
    token, taker = reading.token, reading.before
    if argument(TAKES[taker[0]], token[5]) is None:
        _tell(reading, token, taker, "")
    wanted = KIND[TAKES[taker[0]]]
    if reading.automaton.accepts(wanted):
        reading.automaton.feed(wanted)
    reading.at += 1


def read_missing_argument(reading: Reading) -> None:
    """As if it stood behind the word before."""
    tell_missing_argument(reading)
    reading.automaton.feed(KIND[TAKES[reading.before[0]]])
    reading.mark_flaw()


def tell_missing_argument(reading: Reading) -> None:
    _tell(reading, reading.before, reading.before, "missing-argument")


def _tell(reading: Reading, token: Token, taker: Token, code: str) -> None:
    terminal = TAKES[taker[0]]
    details: dict[str, str | int] = {"word": TERMINALS[taker[0]]}
    if terminal == "COLOUR" and reading.colours is not None:
        details["wanted"] = ", ".join(sorted(reading.colours))
    meant = "" if code else _meant(reading, token, terminal)
    reading.tell(Kind.BAD_ARGUMENT, token, code, (_CLASS_OF[terminal],), meant, details)


def _meant(reading: Reading, token: Token, terminal: str) -> str:
    if len(token[5]) <= 2:
        return ""
    preferred = argument_words(terminal, reading.language)
    words = [word for language in reading.spoken for word in argument_words(terminal, language)]
    return nearest(token[5], words, preferred) or ""
