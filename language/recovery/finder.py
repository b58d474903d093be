"""The mistakes in a text, found by reading it to its end, or to where nobody wants to hear of more."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import pairwise

from language.diagnostics import MOST_MISTAKES, Diagnostic, Kind
from language.lexer import DISTANCE, END, FOR, FRAGMENT, NAME, TAKES, Lexed, lex
from language.outline import ENDS, is_split_else
from language.recovery.arguments import tell_missing_argument
from language.recovery.commands import read_stray, read_unknown_command, read_unknown_pair
from language.recovery.ends import (
    is_misspelt_end,
    read_else,
    read_end,
    read_split_else,
    tell_missing_ends,
)
from language.recovery.kinds import BEHIND_FIRST_NAME, COMMANDS, ELSE
from language.recovery.pairs import has_misspelt_second
from language.recovery.reading import Reading
from language.recovery.within import read_mistake_within
from language.scopes import Declared
from language.source import line_ends
from language.tree import MOST_LEVELS

_DEEPEST = 4000
"""States of the automaton; only what is too deep anyway gets there."""


def mistakes_in(
    lexed: Lexed,
    others: tuple[Diagnostic, ...] = (),
    first_line: int = 1,
    colours: frozenset[str] | None = None,
    declared: Mapping[str, Declared] | None = None,
) -> tuple[Diagnostic, ...]:
    """The mistakes in a text, together with ``others`` that are known, in the order of the text.

    ``colours`` are the ones that the robot can see, where that is known. ``declared``: see ``Reading``.
    """
    found = _found_in(lexed, first_line, colours, declared or {})
    if lexed.open_quote is not None and len(found) > len(lexed.mistakes):
        again = _with_another_quote_open(lexed, first_line)
        found_again = _found_in(again, first_line, colours, declared or {}) if again else found
        found = found_again if len(found_again) <= len(found) else found
    if any(each.kind is Kind.TOO_DEEP for each in others):
        found = [each for each in found if each.kind is not Kind.TOO_DEEP]
    everything = [*others, *found]
    everything.sort(key=lambda each: each.span.start)
    return tuple(everything[:MOST_MISTAKES])


def _found_in(
    lexed: Lexed, first_line: int, colours: frozenset[str] | None, declared: Mapping[str, Declared]
) -> list[Diagnostic]:
    reading = Reading(lexed, first_line, colours, declared)
    _read(reading)
    return lexed.mistakes + reading.found


def _with_another_quote_open(lexed: Lexed, first_line: int) -> Lexed | None:
    """The text read with the forgotten quotation mark on the first line with an odd number of them.

    Because strings may go over lines, a forgotten mark turns all later strings inside out. None if there
    is no such line.
    """
    source = lexed.source
    ends = [*line_ends(source), len(source)]
    for start, end in pairwise((0, *ends)):
        if source.count('"', start, end) % 2:
            return lex(source, first_line, source.rindex('"', start, end))
    return None


def _read(reading: Reading) -> None:
    """To the end of the text, unless there are too many mistakes before, or it is too deep."""
    while not reading.is_at_end and len(reading.found) < MOST_MISTAKES and not _is_too_deep(reading):
        _step(reading)
    if reading.is_at_end:
        _finish(reading)
    elif not reading.found and _is_too_deep(reading):
        reading.tell(Kind.TOO_DEEP, reading.token, "expression", details={"limit": MOST_LEVELS})


def _is_too_deep(reading: Reading) -> bool:
    return len(reading.automaton.states) > _DEEPEST


def _step(reading: Reading) -> None:
    if reading.automaton.is_between_commands():
        _begin_or_go_on(reading)
    elif reading.automaton.accepts(reading.token[0]):
        reading.go_on()
    else:
        read_mistake_within(reading)


def _begin_or_go_on(reading: Reading) -> None:
    """Where a command may begin: begin it, or go on with the one before, which may be longer."""
    kind = reading.token[0]
    if kind in ENDS or kind == END or (kind == NAME and is_misspelt_end(reading)):
        read_end(reading)
    elif kind == ELSE:
        read_else(reading)
    elif is_split_else(reading.tokens, reading.at) and reading.automaton.accepts(ELSE):
        read_split_else(reading)
    elif kind == NAME and reading.following[0] not in BEHIND_FIRST_NAME:
        read_unknown_command(reading)
    elif kind == FRAGMENT or (kind == FOR and has_misspelt_second(reading)):
        read_unknown_pair(reading)
    elif not reading.automaton.accepts(kind):
        read_stray(reading)
    else:
        if kind in COMMANDS:
            reading.begin()
        reading.go_on()


def _finish(reading: Reading) -> None:
    if not reading.automaton.is_between_commands():
        _tell_incomplete(reading)
        if reading.head is not None:
            reading.blocks.pop()
    tell_missing_ends(reading)


def _tell_incomplete(reading: Reading) -> None:
    taker = reading.before[0]
    if taker in TAKES and taker != DISTANCE:
        tell_missing_argument(reading)
    else:
        reading.tell(Kind.SYNTAX, reading.token, "", reading.automaton.expected())
