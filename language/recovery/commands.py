"""What stands where a command may begin, and begins none."""

from __future__ import annotations

from language.diagnostics import Kind
from language.keywords import is_reserved, spelling
from language.lexer import NUMBER, STRING
from language.nearby import Near, nearest_keyword, pair_ending_with
from language.recovery.arguments import follows_taker, read_bad_argument
from language.recovery.calls import read_call_without_brackets
from language.recovery.going_on import can_open, read_as, skip_command
from language.recovery.kinds import ASSIGN, COMPARATOR, LPAR, SIGN
from language.recovery.pairs import pair_meant, pair_with_misspelt_first
from language.recovery.reading import Reading
from language.recovery.reserved import is_assigned_to_keyword, tell_reserved
from language.recovery.sensors import read_misspelt_sensor


def read_unknown_command(reading: Reading) -> None:
    token = reading.token
    if follows_taker(reading):
        read_bad_argument(reading)
        return
    if read_misspelt_sensor(reading) or read_call_without_brackets(reading):
        return
    if reading.following[0] == COMPARATOR and reading.following[5] == "==":
        _read_two_equals_signs(reading)
        return
    pair = pair_with_misspelt_first(reading)
    near, width = (pair, 2) if pair else (_command_meant(reading, token[5]), 1)
    code = "call-brackets" if reading.following[0] == LPAR and near is None else ""
    meant = near.text if near else _spoken_besides(reading)
    reading.begun = reading.at
    reading.tell(Kind.UNKNOWN_COMMAND, token, code, ("command",), meant, width=width)
    read_as(reading, near, width)


def _spoken_besides(reading: Reading) -> str:
    """SPEAK "a" x: one SPEAK says one thing."""
    token, before = reading.token, reading.before
    if reading.at == 0 or before[0] != STRING or before[3] != token[3]:
        return ""
    return f"{spelling('SPEAK', reading.language)} {reading.typed(token)}"


def _read_two_equals_signs(reading: Reading) -> None:
    """An assignment written as a comparison: ``x == 3``."""
    reading.begin()
    reading.go_on()
    reading.tell(Kind.SYNTAX, reading.token, "two-equals", ("=",), "=")
    reading.mark_flaw()
    reading.automaton.feed(ASSIGN)
    reading.at += 1


def _command_meant(reading: Reading, typed: str) -> Near | None:
    """The nearest word that leaves all ENDs what they are, or else the nearest one."""
    words = reading.automaton.acceptable()
    pair = pair_ending_with(typed, words)
    if pair:
        return pair
    fitting = frozenset(word for word in words if can_open(reading, word, 1))
    near = nearest_keyword(typed, fitting, reading.language)
    return near or nearest_keyword(typed, words, reading.language)


def read_unknown_pair(reading: Reading) -> None:
    """RIGHT without TURN, GIRAR DIRETA, PARA FRENT."""
    token = reading.token
    if follows_taker(reading):
        read_bad_argument(reading)
        return
    near, width = pair_meant(reading)
    reading.begun = reading.at
    if reading.tokens[reading.at + width][0] == ASSIGN:
        tell_reserved(reading, token)
        near = None
    else:
        reading.tell(Kind.UNKNOWN_COMMAND, token, "", ("command",), near.text if near else "", width=width)
    read_as(reading, near, width)


def read_stray(reading: Reading) -> None:
    """Something that no command begins with, and with which the one before can't go on."""
    token, before = reading.token, reading.before
    if follows_taker(reading) and token[0] in (NUMBER, STRING):
        read_bad_argument(reading)
        return
    if is_assigned_to_keyword(reading):
        tell_reserved(reading, before)
    elif reading.following[0] == ASSIGN and is_reserved(token[5]):
        tell_reserved(reading, token)
    else:
        code = "text-plus" if before[0] == STRING and token[0] == SIGN else ""
        code = "whole-numbers" if reading.is_decimal_comma else code
        reading.tell(Kind.SYNTAX, token, code, reading.automaton.expected())
    reading.at += 1
    skip_command(reading)
