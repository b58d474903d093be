"""Procedures that are called without their brackets: ``AB 2``, ``AB: 2``, ``AB (2)``, ``CD``."""

from __future__ import annotations

from collections.abc import Sequence

from language.diagnostics import Kind
from language.lexer import KIND, NAME, NUMBER, Token
from language.recovery.going_on import read_as
from language.recovery.kinds import BEGINNERS, BEHIND_FIRST_NAME, LPAR, SEMICOLON, VAR
from language.recovery.reading import Reading

_PUNCTUATION = (LPAR, *(KIND[name] for name in ("COLON", "COMMA", "RPAR")))
"""What may stand between the values of such a call."""


def read_call_without_brackets(reading: Reading) -> bool:
    """Whether a procedure's name stands here, which is told with the way to call it."""
    token = reading.token
    names = reading.procedures.get(token[5])
    if names is None:
        return False
    typed, (values, width) = reading.typed(token), _values(reading)
    meant = f"{typed} [{', '.join(values)}]" if values is not None and len(values) == len(names) else ""
    reading.begun = reading.at
    details: dict[str, str | int] = {"call": f"{typed} [{', '.join(names)}]"}
    reading.tell(Kind.UNKNOWN_COMMAND, token, "procedure", ("command",), meant, details, width=width)
    read_as(reading, None, 1)
    return True


def _values(reading: Reading) -> tuple[list[str] | None, int]:
    """The values behind the name on its line, None if they are no plain ones, and the words up to there."""
    line = _rest_of_line(reading)
    values: list[str] = []
    width = 1
    for at, token in enumerate(line):
        if token[0] in (NAME, NUMBER) and not _begins_another(line, at):
            values.append(reading.typed(token))
        elif token[0] not in _PUNCTUATION:
            return (values if _begins_another(line, at) else None), width
        width = at + 2
    return values, width


def _rest_of_line(reading: Reading) -> Sequence[Token]:
    at = end = reading.at + 1
    while reading.tokens[end][0] and reading.tokens[end][3] == reading.token[3]:
        end += 1
    return reading.tokens[at:end]


def _begins_another(line: Sequence[Token], at: int) -> bool:
    kind = line[at][0]
    following = line[at + 1][0] if at + 1 < len(line) else 0
    return kind in BEGINNERS or kind in (SEMICOLON, VAR) or (kind == NAME and following in BEHIND_FIRST_NAME)
