"""A misspelt sensor: what stands behind it is no mistake of its own (DISTANSIA F, COLOUR blue)."""

from __future__ import annotations

from language.diagnostics import Kind
from language.lexer import NAME
from language.nearby import SENSORS, nearest_keyword
from language.recovery.reading import Reading


def read_misspelt_sensor(reading: Reading) -> bool:
    """Whether the name before was meant to be a sensor; then it is told, and both are read as its value."""
    token, before = reading.token, reading.before
    if token[0] != NAME or before[0] != NAME or before[3] != token[3] or reading.at - 1 <= reading.begun:
        return False
    near = nearest_keyword(before[5], SENSORS, reading.language)
    if near is None or near.complete:
        return False
    reading.tell(Kind.UNKNOWN_COMMAND, before, "sensor", ("expression",), near.text)
    reading.mark_flaw()
    reading.at += 1
    return True
