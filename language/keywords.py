"""The one table of GoDonnie's words in English, Portuguese and Spanish.

Rule: whatever knows a word knows it from here: lexer, formatter, help, completion, messages. The first
spelling in a language is the one that the formatter writes. The first word of every command and every
word between commands is reserved in all languages at once; words that only follow (FRENTE, ON, RED)
and the letters of directions and axes are ordinary names everywhere else.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from functools import cache
from types import MappingProxyType

from devices.ports.robot import Bearing
from devices.ports.values import Frozen
from language.source import fold_name
from language.syntax import Axis

LANGUAGES = ("en", "pt", "es")


class Word(Frozen):
    """One form of one keyword: FW and FORWARD are two words of the same terminal."""

    canonical: str
    """Its English spelling, by which all of the program knows it."""
    terminal: str
    """Its name in grammar.lark."""
    topic: str
    """The canonical word of the construct that it belongs to, for HELP."""
    spellings: Mapping[str, tuple[str, ...]]
    """By language; the canonical spelling of the language first."""


class Argument(Frozen):
    """A word that means something only behind certain keywords."""

    terminal: str
    value: Bearing | Axis | str | bool
    topic: str
    spellings: Mapping[str, tuple[str, ...]]


def _spellings(en: str, pt: str, es: str) -> Mapping[str, tuple[str, ...]]:
    rows = zip(LANGUAGES, (en, pt, es), strict=True)
    return MappingProxyType({language: tuple(words.split("|")) for language, words in rows})


def _word(terminal: str, topic: str, en: str, pt: str, es: str) -> Word:
    return Word(en.split("|")[0], terminal, topic, _spellings(en, pt, es))


WORDS = (
    _word("QUIT", "QUIT", "QUIT", "SAIR", "SALIR"),
    _word("QUIT", "QUIT", "EXIT", "SAIR", "SALIR"),
    _word("VAR", "VAR", "VAR", "CRIAR", "CREAR"),
    _word("SPEAK", "SPEAK", "SPEAK", "FALAR", "HABLAR"),
    _word("SOUND", "SOUND", "SOUND", "SOM", "SONIDO"),
    _word("FW", "FW", "FW", "PF", "AV"),
    _word("FW", "FW", "FORWARD", "PARA FRENTE", "AVANZAR"),
    _word("BW", "BW", "BW", "PT", "RE"),
    _word("BW", "BW", "BACKWARD", "PARA TRÁS", "RETROCEDER"),
    _word("TR", "TR", "TR", "GD", "GD"),
    _word("TR", "TR", "RIGHT TURN", "GIRAR DIREITA", "GIRAR DERECHA"),
    _word("TL", "TL", "TL", "GE", "GI"),
    _word("TL", "TL", "LEFT TURN", "GIRAR ESQUERDA", "GIRAR IZQUIERDA"),
    _word("SCAN", "SCAN", "SCAN", "ESPIAR", "MIRAR"),
    _word("STATE", "STATE", "STATE", "ESTADO", "ESTADO"),
    _word("DISTANCE", "DISTANCE", "DISTANCE", "DISTÂNCIA", "DISTANCIA"),
    _word("POS", "POS", "POS", "POS", "POS"),
    _word("POS", "POS", "POSITION", "POSIÇÃO", "POSICIÓN"),
    _word("COLOR", "COLOR", "COLOR", "COR", "COLOR"),
    _word("WAIT", "WAIT", "WAIT", "ESPERAR", "ESPERAR"),
    _word("HISTORY", "HISTORY", "HISTORY", "HISTÓRICO", "HISTORIAL"),
    _word("BELT", "BELT", "BELT", "CINTO", "CINTURÓN"),
    _word("VIBRATE", "VIBRATE", "VIBRATE", "VIBRAR", "VIBRAR"),
    _word("HELP", "HELP", "HELP", "AJUDA", "AYUDA"),
    _word("RUN", "RUN", "RUN", "EXECUTAR", "EJECUTAR"),
    _word("IF", "IF", "IF", "SE", "SI"),
    _word("THEN", "IF", "THEN", "ENTÃO", "ENTONCES"),
    _word("ELSE", "IF", "ELSE", "SENÃO", "SINO"),
    _word("END_IF", "IF", "END IF", "FIM SE", "FIN SI"),
    _word("FOR", "FOR", "FOR", "PARA", "PARA"),
    _word("DO", "FOR", "DO", "FAÇA", "HACER"),
    _word("END_FOR", "FOR", "END FOR", "FIM PARA", "FIN PARA"),
    _word("REPEAT", "REPEAT", "REPEAT", "REPITA", "REPETIR"),
    _word("TIMES", "REPEAT", "TIMES", "VEZES", "VECES"),
    _word("END_REPEAT", "REPEAT", "END REPEAT", "FIM REPITA", "FIN REPETIR"),
    _word("WHILE", "WHILE", "WHILE", "ENQUANTO", "MIENTRAS"),
    _word("END_WHILE", "WHILE", "END WHILE", "FIM ENQUANTO", "FIN MIENTRAS"),
    _word("PROCEDURE", "PROCEDURE", "PROCEDURE", "APRENDER", "PROCEDIMIENTO"),
    _word("END_PROCEDURE", "PROCEDURE", "END PROCEDURE", "FIM APRENDER", "FIN PROCEDIMIENTO"),
)

ARGUMENTS = (
    Argument("DIRECTION", Bearing.FRONT, "DISTANCE", _spellings("F", "F", "F")),
    Argument("DIRECTION", Bearing.FRONT_RIGHT, "DISTANCE", _spellings("FR", "FD", "FD")),
    Argument("DIRECTION", Bearing.FRONT_LEFT, "DISTANCE", _spellings("FL", "FE", "FI")),
    Argument("DIRECTION", Bearing.BACK, "DISTANCE", _spellings("B", "T", "T")),
    Argument("DIRECTION", Bearing.BACK_RIGHT, "DISTANCE", _spellings("BR", "TD", "TD")),
    Argument("DIRECTION", Bearing.BACK_LEFT, "DISTANCE", _spellings("BL", "TE", "TI")),
    Argument("AXIS", Axis.X, "POS", _spellings("X", "X", "X")),
    Argument("AXIS", Axis.Y, "POS", _spellings("Y", "Y", "Y")),
    Argument("AXIS", Axis.ANGLE, "POS", _spellings("A", "A", "A")),
    Argument("COLOUR", "red", "COLOR", _spellings("RED", "VERMELHO", "ROJO")),
    Argument("COLOUR", "green", "COLOR", _spellings("GREEN", "VERDE", "VERDE")),
    Argument("COLOUR", "blue", "COLOR", _spellings("BLUE", "AZUL", "AZUL")),
    Argument("COLOUR", "yellow", "COLOR", _spellings("YELLOW", "AMARELO", "AMARILLO")),
    Argument("COLOUR", "orange", "COLOR", _spellings("ORANGE", "LARANJA", "NARANJA")),
    Argument("COLOUR", "pink", "COLOR", _spellings("PINK", "ROSA", "ROSA")),
    Argument("COLOUR", "gray", "COLOR", _spellings("GRAY|GREY", "CINZA", "GRIS")),
    Argument("SWITCH", True, "SOUND", _spellings("ON", "LIGADO", "ENCENDIDO")),
    Argument("SWITCH", False, "SOUND", _spellings("OFF", "DESLIGADO", "APAGADO")),
)

END_WORDS = frozenset({"end", "fim", "fin"})
"""Alone they end nothing, but they are reserved."""


def folded_word(text: str) -> str:
    """A word or several as the tables know them: folded, one blank between."""
    return " ".join(fold_name(text).split())


def _index(items: Iterable[Word | Argument]) -> dict[str, list[Word | Argument]]:
    found: dict[str, list[Word | Argument]] = {}
    for item in items:
        for spelling_ in (each for spellings in item.spellings.values() for each in spellings):
            rows = found.setdefault(folded_word(spelling_), [])
            if item not in rows:
                rows.append(item)
    return found


_words: dict[str, list[Word]] = _index(WORDS)  # type: ignore[assignment]
_by_canonical = {word.canonical: word for word in WORDS}


def _arguments() -> dict[str, dict[str, Argument]]:
    found: dict[str, dict[str, Argument]] = {}
    for argument in ARGUMENTS:
        rows = found.setdefault(argument.terminal, {})
        for spellings in argument.spellings.values():
            rows.update({fold_name(each): argument for each in spellings})
    return found


_arguments_by_terminal = _arguments()

TERMINAL_OF_WORD: Mapping[str, str] = MappingProxyType(
    {folded: rows[0].terminal for folded, rows in _words.items()}
)
"""Folded word, one blank between its parts, to its terminal in the grammar."""

FIRST_OF_SEVERAL = frozenset(folded.split()[0] for folded in _words if " " in folded)
"""The folded first words of the keywords that have two."""


def word(text: str) -> Word | None:
    """The word that is spelled so in any language, or None."""
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
    """How a language spells a canonical word. Raises ``KeyError`` for what is none."""
    return _by_canonical[canonical_word].spellings[language][0]


def argument(terminal: str, text: str) -> Argument | None:
    """What a word means behind a keyword: terminal is DIRECTION, AXIS, COLOUR or SWITCH."""
    return _arguments_by_terminal[terminal].get(fold_name(text))


def argument_spelling(value: Bearing | Axis | str | bool, language: str) -> str:
    """How a language spells a direction, an axis, a colour (its English word) or on and off.

    Raises ``KeyError`` for what is none.
    """
    for each in ARGUMENTS:
        if each.value is value or (isinstance(value, str) and each.value == value):
            return each.spellings[language][0]
    raise KeyError(value)


def argument_words(terminal: str, language: str) -> tuple[str, ...]:
    """Every word that may stand there in one language, in the order of the table."""
    return tuple(each.spellings[language][0] for each in ARGUMENTS if each.terminal == terminal)


@cache
def all_words(language: str | None = None) -> tuple[str, ...]:
    """Every keyword of one language or of all, as it is written; for completion and near misses."""
    languages = LANGUAGES if language is None else (language,)
    found = (each for word in WORDS for code in languages for each in word.spellings[code])
    return tuple(dict.fromkeys(found))


def is_reserved(name: str) -> bool:
    """Whether a name can't be given to a variable or a procedure."""
    folded = fold_name(name)
    reserved_first = folded in FIRST_OF_SEVERAL or folded in END_WORDS
    return reserved_first or folded in _words


def topic(text: str) -> str | None:
    """The canonical word of the construct that a word belongs to, for HELP word; None if it is no word.

    ``THEN``, ``fim se`` and ``ELSE`` are of ``IF``; ``FORWARD`` is of ``FW``; a colour is of ``COLOR``.
    """
    found = word(text)
    if found:
        return found.topic
    folded = folded_word(text)
    rows = (table.get(folded) for table in _arguments_by_terminal.values())
    return next((each.topic for each in rows if each), None)


def topic_at(line: str, column: int) -> str:
    """What the last command word is about that begins at or before a column, from 1; empty without one."""
    found = [*re.finditer(r"[^\W\d_]+", line)]
    begun = [at for at, each in enumerate(found) if each.start() < column]
    for at in reversed(begun):
        both = " ".join(each[0] for each in found[at : at + 2])
        known = word(both) or word(found[at][0])
        if known:
            return known.topic
    return ""


@cache
def _languages() -> dict[str, frozenset[str]]:
    found: dict[str, set[str]] = {}
    for each in WORDS:
        for language, spellings in each.spellings.items():
            for one in spellings:
                found.setdefault(folded_word(one), set()).add(language)
    return {folded: frozenset(languages) for folded, languages in found.items()}


def languages_of(text: str) -> frozenset[str]:
    """The languages in which a keyword is spelled so; none for what is no keyword."""
    return _languages().get(folded_word(text), frozenset())
