"""What goes over the belt's line, as values: levels become a frame of 36 bytes. Nothing here does I/O.

A frame is ``Z`` and 35 letters, five rows of seven cells. Only the second and the fourth row have motors.
``A`` is always on, ``B`` every second pass of the board's loop, ``C`` every third, and so on; ``P`` is off.
Source: the firmware of the original belt.
"""

from __future__ import annotations

BAUD = 9600
"""8N1: a frame takes 37.5 ms."""

COLUMNS, ROWS = 7, 5
MOTORS = 14
"""Two rows of seven: the upper one first."""

OFF = (0,) * MOTORS

START = b"Z"
DARK = ord("P")
"""The letter of a cell that is off."""

LETTERS = (DARK, ord("C"), ord("B"), ord("A"))
"""By level: off, weak, medium, strong."""

RESYNC = b"Z!"
"""Ends whatever the board is in the middle of: it answers with two error lines at most, and waits."""

COMPLAINTS = (b"E1\r\n", b"E2\r\n")
"""What the board says of a byte that is none of a frame's: outside of one, and inside."""

_UPPER, _LOWER = COLUMNS, 3 * COLUMNS


def frame(levels: tuple[int, ...]) -> bytes:
    """The frame for 14 levels, 0 off to 3 strong. Raises ``ValueError`` for anything else."""
    if len(levels) != MOTORS or not all(0 <= level < len(LETTERS) for level in levels):
        raise ValueError("a belt has 14 motors with levels 0 to 3")
    cells = bytearray([DARK]) * (COLUMNS * ROWS)
    letters = bytes(LETTERS[level] for level in levels)
    cells[_UPPER : _UPPER + COLUMNS] = letters[:COLUMNS]
    cells[_LOWER : _LOWER + COLUMNS] = letters[COLUMNS:]
    return START + bytes(cells)


def is_complaint(said: bytes | bytearray) -> bool:
    """Whether a belt's board said this: nothing else does."""
    return any(each in said for each in COMPLAINTS)


def motors(cells: bytes) -> tuple[int, ...]:
    """Of 35 cells those that have motors, in the order of the levels."""
    return (*cells[_UPPER : _UPPER + COLUMNS], *cells[_LOWER : _LOWER + COLUMNS])
