"""What stands within a command, and with which that can't go on."""

from __future__ import annotations

from language.diagnostics import Kind
from language.keywords import spelling
from language.lexer import DISTANCE, FRAGMENT, KIND, NAME, NUMBER, STRING, TAKES
from language.nearby import nearest_keyword
from language.recovery.arguments import read_bad_argument, read_missing_argument
from language.recovery.going_on import end_of_head, give_up, is_behind_head, read_as
from language.recovery.kinds import ASSIGN, COMPARATOR, HEAD_ENDS
from language.recovery.reading import Reading
from language.recovery.reserved import is_assigned_to_keyword, is_reserved_as_name, tell_reserved
from language.recovery.sensors import read_misspelt_sensor


def read_mistake_within(reading: Reading) -> None:
    token, before = reading.token, reading.before
    if before[0] in TAKES and reading.automaton.accepts(KIND[TAKES[before[0]]]):
        if token[0] in (NAME, NUMBER, STRING):
            read_bad_argument(reading)
            return
        if before[0] != DISTANCE:
            read_missing_argument(reading)
            return
    if read_misspelt_sensor(reading):
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
    if _misses_end_of_head(reading):
        _tell_end_of_head(reading)
        give_up(reading)
        return
    if token[0] in (NAME, FRAGMENT):
        near = nearest_keyword(token[5], reading.automaton.acceptable(), reading.language)
    code = "whole-numbers" if reading.is_decimal_comma else ""
    head = reading.head
    details: dict[str, str | int] = {} if head is None else {"opener": head.kind}
    expected = reading.automaton.expected()
    reading.tell(Kind.SYNTAX, token, code, expected, near.text if near else "", details)
    if near and not near.complete:
        read_as(reading, near, 1)
    else:
        give_up(reading)


def _misses_end_of_head(reading: Reading) -> bool:
    """Whether only THEN, DO or TIMES is missing before a command, or another of them stands there."""
    head = reading.head
    if head is None or reading.is_at_end or not is_behind_head(reading, head):
        return False
    return reading.automaton.accepts(KIND[end_of_head(head)])


def _tell_end_of_head(reading: Reading) -> None:
    """Of several lines it belongs at the end of the line before."""
    assert reading.head is not None
    token, before, head = reading.token, reading.before, reading.head
    word = end_of_head(head)
    meant, expected = spelling(word, reading.language), reading.automaton.expected()
    details: dict[str, str | int] = {"opener": head.kind}
    if token[0] in HEAD_ENDS:
        reading.tell(Kind.SYNTAX, token, "", expected, meant, details)
        return
    code = "head-end" if token[3] == before[3] else "head-end-before"
    details |= {"missing": word, "line": before[3]}
    reading.tell(Kind.SYNTAX, token, code, expected, meant, details, meant_at=before[2])
