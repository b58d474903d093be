"""The numbers of GoDonnie: exact integers of at most 4300 digits, divided by cutting towards zero."""

from __future__ import annotations

from language.diagnostics import Kind, Refused

LARGEST_DIGITS = 4300

LIMIT: int = 10**LARGEST_DIGITS
"""No number reaches this, nor its negative."""

SAFE_BITS = LIMIT.bit_length() - 1
"""Whatever has no more bits than this is below the limit."""


def checked(value: int) -> int:
    """``value``, or a refusal if it is too large."""
    if -LIMIT < value < LIMIT:
        return value
    raise Refused(Kind.NUMBER_TOO_LARGE, limit=LARGEST_DIGITS)


def divide(dividend: int, divisor: int) -> int:
    """The quotient without its fraction: -7 / 2 is -3."""
    if divisor == 0:
        raise Refused(Kind.DIVISION_BY_ZERO)
    quotient = abs(dividend) // abs(divisor)
    return quotient if (dividend < 0) == (divisor < 0) else -quotient
