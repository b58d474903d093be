"""What stands within a command, and with which that can't go on."""

from __future__ import annotations

from language.diagnostics import Kind
from language.lexer import DISTANCE, FRAGMENT, KIND, NAME, NUMBER, STRING, TAKES
from language.nearby import nearest_keyword
from language.recovery.arguments import read_bad_argument, read_missing_argument
from language.recovery.going_on import give_up, read_as
from language.recovery.kinds import ASSIGN, COMPARATOR
from language.recovery.reading import Reading
from language.recovery.reserved import is_assigned_to_keyword, is_reserved_as_name, tell_reserved


def read_mistake_within(reading: Reading) -> None:
    token, before = reading.token, reading.before
    if before[0] in TAKES and reading.automaton.accepts(KIND[TAKES[before[0]]]):
        if token[0] in (NAME, NUMBER, STRING):
            read_bad_argument(reading)
            return
        if before[0] != DISTANCE:
            read_missing_argument(reading)
            return
    if is_reserved_as_name(reading):
        tell_reserved(reading, token)
        reading.automaton.feed(NAME)
        reading.at += 1
    elif is_assigned_to_keyword(reading):
        tell_reserved(reading, before)
        give_up(reading)
    elif token[0] == ASSIGN and reading.automaton.accepts(COMPARATOR):
        _read_equals_sign(reading)
    else:
        _read_unexpected(reading)


def _read_equals_sign(reading: Reading) -> None:
    """A comparison written with one equals sign, or as it is spoken: ``=>`` for greater or equal."""
    _, start, end, line, column, text = token = reading.token
    following = reading.following
    is_turned = following[1] == end and following[5] in ("<", ">")
    if is_turned:
        token = (ASSIGN, start, following[2], line, column, text + following[5])
    meant = f"{following[5]}=" if is_turned else "=="
    reading.tell(Kind.SYNTAX, token, "single-equals", ("comparison",), meant)
    reading.mark_flaw()
    reading.automaton.feed(COMPARATOR)
    reading.at += 2 if is_turned else 1


def _read_unexpected(reading: Reading) -> None:
    token, near = reading.token, None
    if token[0] in (NAME, FRAGMENT):
        near = nearest_keyword(token[5], reading.automaton.acceptable(), reading.language)
    code = "whole-numbers" if reading.is_decimal_comma else ""
    reading.tell(Kind.SYNTAX, token, code, reading.automaton.expected(), near.text if near else "")
    if near and not near.complete:
        read_as(reading, near, 1)
    else:
        give_up(reading)
