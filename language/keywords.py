"""The one table of GoDonnie's words in all languages; each language has its own in ``keywords.toml``.

Lexer, formatter, help, completion and messages take all words from here. The formatter writes the first
spelling of a language. The first word of every command and every word between commands are reserved in all
languages. Words that only follow others (FRENTE, ON, RED) and the letters of directions and axes are ordinary
names in all other places. So are the words in ``ALSO_NAMES`` where no command may begin.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from functools import cache
from types import MappingProxyType
from unicodedata import normalize

from msgspec import Struct

from devices.ports.robot import Bearing
from language.locales import languages, words
from language.source import fold_name
from language.syntax import Axis


class Keyword(Struct, frozen=True):
    """One form of one keyword: FW and FORWARD are two words of the same terminal."""

    canonical: str
    """Its English spelling, which the code uses everywhere."""
    terminal: str
    """Its name in grammar.lark."""
    topic: str
    """The canonical word of the construct that it belongs to, for HELP."""
    spellings: Mapping[str, tuple[str, ...]]
    """By language; the canonical spelling of the language first."""


class ArgumentWord(Struct, frozen=True):
    """A word that has a meaning only after certain keywords."""

    terminal: str
    value: Bearing | Axis | str | bool
    topic: str
    spellings: Mapping[str, tuple[str, ...]]


def _spellings(section: str, key: str) -> Mapping[str, tuple[str, ...]]:
    return MappingProxyType({each: words(each, "keywords", section, key) for each in languages()})


def _word(canonical: str, terminal: str = "", topic: str = "") -> Keyword:
    terminal = terminal or canonical.replace(" ", "_")
    return Keyword(
        canonical, terminal, topic or terminal.removeprefix("END_"), _spellings("keywords", canonical)
    )


WORDS = (
    _word("QUIT"),
    _word("EXIT", "QUIT"),
    _word("VAR"),
    _word("SPEAK"),
    _word("SOUND"),
    _word("FW"),
    _word("FORWARD", "FW"),
    _word("BW"),
    _word("BACKWARD", "BW"),
    _word("TR"),
    _word("RIGHT TURN", "TR"),
    _word("TL"),
    _word("LEFT TURN", "TL"),
    _word("SCAN"),
    _word("STATE"),
    _word("DISTANCE"),
    _word("POS"),
    _word("POSITION", "POS"),
    _word("COLOR"),
    _word("WAIT"),
    _word("HISTORY"),
    _word("GRIP"),
    _word("RELEASE"),
    _word("BELT"),
    _word("VIBRATE"),
    _word("HELP"),
    _word("RUN"),
    _word("IF"),
    _word("THEN", topic="IF"),
    _word("ELSE", topic="IF"),
    _word("END IF"),
    _word("FOR"),
    _word("DO", topic="FOR"),
    _word("END FOR"),
    _word("REPEAT"),
    _word("TIMES", topic="REPEAT"),
    _word("END REPEAT"),
    _word("WHILE"),
    _word("END WHILE"),
    _word("PROCEDURE"),
    _word("END PROCEDURE"),
)

ALSO_NAMES = frozenset(("GRIP", "RELEASE"))
"""The terminals of words that are younger than the language: older programs use them as names."""


def _arguments_of(
    terminal: str, topic: str, section: str, values: Mapping[str, Bearing | Axis | str | bool]
) -> tuple[ArgumentWord, ...]:
    return tuple(
        ArgumentWord(terminal, value, topic, _spellings(section, key)) for key, value in values.items()
    )


_BEARINGS = (
    *(Bearing.FRONT, Bearing.FRONT_RIGHT, Bearing.FRONT_LEFT),
    *(Bearing.BACK, Bearing.BACK_RIGHT, Bearing.BACK_LEFT),
)
COLOURS = ("red", "green", "blue", "yellow", "orange", "pink", "gray")

ARGUMENTS = (
    *_arguments_of("DIRECTION", "DISTANCE", "directions", {each.name.lower(): each for each in _BEARINGS}),
    *_arguments_of("AXIS", "POS", "axes", {each.name.lower(): each for each in Axis}),
    *_arguments_of("COLOUR", "COLOR", "colours", {each: each for each in COLOURS}),
    *_arguments_of("SWITCH", "SOUND", "switch", {"on": True, "off": False}),
)


def folded_word(text: str) -> str:
    """One word or several in the form of the tables: folded, one blank between."""
    return " ".join(fold_name(text).split())


def _index() -> dict[str, list[Keyword]]:
    """The words by folded spelling. A spelling keeps the meaning that it has in an earlier language."""
    found: dict[str, list[Keyword]] = {}
    for language in languages():
        for each in WORDS:
            for spelled in each.spellings[language]:
                rows = found.setdefault(folded_word(spelled), [])
                if each not in rows and (not rows or rows[0].terminal == each.terminal):
                    rows.append(each)
    return found


_words = _index()
_by_canonical = {word.canonical: word for word in WORDS}


def _arguments() -> dict[str, dict[str, ArgumentWord]]:
    found: dict[str, dict[str, ArgumentWord]] = {}
    for argument in ARGUMENTS:
        rows = found.setdefault(argument.terminal, {})
        for spellings in argument.spellings.values():
            for each in spellings:
                rows.setdefault(fold_name(each), argument)
    return found


_arguments_by_terminal = _arguments()

TERMINAL_OF_WORD: Mapping[str, str] = MappingProxyType(
    {folded: rows[0].terminal for folded, rows in _words.items()}
)
"""Folded word, one blank between its parts, to its terminal in the grammar."""

END_WORDS = frozenset(
    folded.split()[0]
    for folded, rows in _words.items()
    if rows[0].terminal.startswith("END_") and " " in folded
)
"""``end`` and its words in other languages: alone they end nothing, but they are reserved."""

FIRST_OF_SEVERAL = frozenset(folded.split()[0] for folded in _words if " " in folded)
"""The folded first words of the keywords that have two."""


def word(text: str) -> Keyword | None:
    """The keyword with this spelling in any language, or None."""
    rows = _words.get(folded_word(text))
    return rows[0] if rows else None


def canonical(text: str) -> str | None:
    """The canonical word of a keyword in any spelling, or None: ``para  frente`` is ``FORWARD``."""
    found = word(text)
    return found.canonical if found else None


def canonical_of_terminal(terminal: str) -> str:
    """``END_IF`` is ``END IF``, ``FW`` is ``FW``."""
    return next(word.canonical for word in WORDS if word.terminal == terminal)


def spelling(canonical_word: str, language: str) -> str:
    """The spelling of a canonical word in a language. Raises ``KeyError`` for any other word."""
    return _by_canonical[canonical_word].spellings[language][0]


def argument(terminal: str, text: str) -> ArgumentWord | None:
    """The meaning of a word after a keyword: terminal is DIRECTION, AXIS, COLOUR or SWITCH."""
    return _arguments_by_terminal[terminal].get(fold_name(text))


def argument_spelling(value: Bearing | Axis | str | bool, language: str) -> str:
    """The spelling of a direction, an axis, a colour (its English word) or on and off in a language.

    Raises ``KeyError`` for any other value.
    """
    for each in ARGUMENTS:
        if each.value == value:
            return each.spellings[language][0]
    raise KeyError(value)


def argument_words(terminal: str, language: str) -> tuple[str, ...]:
    """Every word of that terminal in one language, in the order of the table."""
    return tuple(each.spellings[language][0] for each in ARGUMENTS if each.terminal == terminal)


@cache
def all_words(language: str | None = None) -> tuple[str, ...]:
    """Every keyword of one language or of all, as it is written; for completion and near misses."""
    codes = languages() if language is None else (language,)
    found = (each for word in WORDS for code in codes for each in word.spellings[code])
    return tuple(dict.fromkeys(found))


def is_reserved(name: str) -> bool:
    """Whether a name can't be given to a variable or a procedure."""
    folded = fold_name(name)
    terminal = TERMINAL_OF_WORD.get(folded)
    return folded in FIRST_OF_SEVERAL or (terminal is not None and terminal not in ALSO_NAMES)


def topic(text: str) -> str | None:
    """The canonical word of the construct that a word belongs to, for HELP word; None if it is no word.

    ``THEN``, ``fim se`` and ``ELSE`` belong to ``IF``, ``FORWARD`` to ``FW``, a colour to ``COLOR``.
    """
    found = word(text)
    if found:
        return found.topic
    folded = folded_word(text)
    rows = (table.get(folded) for table in _arguments_by_terminal.values())
    return next((each.topic for each in rows if each), None)


def topic_at(line: str, column: int) -> str:
    """The topic of the last command word that begins at or before a column, from 1; empty without one."""
    found = [*re.finditer(r"[^\W\d_]+", line)]
    begun = [at for at, each in enumerate(found) if each.start() < column]
    for at in reversed(begun):
        both = " ".join(each[0] for each in found[at : at + 2])
        known = word(both) or word(found[at][0])
        if known:
            return known.topic
    return ""


@cache
def _languages_by_word() -> dict[str, frozenset[str]]:
    return _languages_by_spelling(each.spellings for each in WORDS)


def _languages_by_spelling(words: Iterable[Mapping[str, Sequence[str]]]) -> dict[str, frozenset[str]]:
    """The languages of each folded spelling."""
    found: dict[str, set[str]] = {}
    for each in words:
        for language, spellings in each.items():
            for one in spellings:
                found.setdefault(folded_word(one), set()).add(language)
    return {folded: frozenset(languages) for folded, languages in found.items()}


def languages_of(text: str) -> frozenset[str]:
    """The languages in which a keyword has this spelling; empty for any other word."""
    return _languages_by_word().get(folded_word(text), frozenset())


@cache
def _languages_by_colour() -> dict[str, frozenset[str]]:
    return _languages_by_spelling(each.spellings for each in ARGUMENTS if each.terminal == "COLOUR")


def languages_of_colour(folded: str) -> frozenset[str]:
    """The languages in which a colour has this folded word; empty for any other word."""
    return _languages_by_colour().get(folded, frozenset())


@cache
def _written_differently() -> dict[str, dict[str, set[str]]]:
    """The keywords that languages write with different accents: folded word, spelling, languages."""
    found: dict[str, dict[str, set[str]]] = {}
    for each in WORDS:
        for language, spellings in each.spellings.items():
            for one in spellings:
                found.setdefault(folded_word(one), {}).setdefault(one, set()).add(language)
    return {folded: spellings for folded, spellings in found.items() if len(spellings) > 1}


def languages_by_accents(folded: str, typed: str) -> frozenset[str]:
    """The languages that write a keyword with these accents, if others write it with other ones."""
    spellings = _written_differently().get(folded)
    if not spellings:
        return frozenset()
    return frozenset(spellings.get(" ".join(normalize("NFC", typed).upper().split()), ()))
