"""The belt's protocol: frames, the times at which they are sent, and whether a belt answers at all. No I/O.

A frame is ``Z`` and 35 letters, five rows of seven cells, of which only the second and the fourth row have
motors. ``A`` is always on, ``B`` every second pass of the board's loop, ``C`` every third, and so on; ``P``
is off. Source: the firmware of the original belt.
"""

from __future__ import annotations

from enum import Enum, auto
from math import inf

BAUD = 9600
"""8N1: a frame takes 37.5 ms."""

COLUMNS, ROWS = 7, 5
CELLS = COLUMNS * ROWS
MOTORS = 14
"""Two rows of seven: the upper one first."""

OFF = (0,) * MOTORS

START = b"Z"
DARK = ord("P")
"""The letter of a cell that is off."""

LETTERS = (DARK, ord("C"), ord("B"), ord("A"))
"""By level: off, weak, medium, strong."""

RESYNC = b"Z!"
"""Ends a frame that the board may have received half of: it sends at most two error lines, and waits."""

COMPLAINTS = (b"E1\r\n", b"E2\r\n")
"""The board's errors about a byte that belongs to no frame: outside of one, and inside."""

PERIOD = 0.040
"""Seconds between two frames."""

HOLD = 0.25
"""Seconds that a motor is on at least, so that a short pulse is felt."""

AFTER_RESYNC = 0.030
"""Seconds of silence after a resync, in which the board's error lines arrive."""

ASKED_AGAIN = 3.0
"""Seconds after opening the port, when a board that was restarted by it has surely begun."""

GIVEN_UP = 4.0
"""Seconds after opening the port, when an answer would have come long ago."""

_UPPER, _LOWER = COLUMNS, 3 * COLUMNS
_COMPLAINT = ord("E")
_LONGEST = 16
"""Of the bytes received, so many are searched for a complaint."""


def encode_frame(levels: tuple[int, ...]) -> bytes:
    """The frame for 14 levels, 0 off to 3 strong. Raises ``ValueError`` for anything else."""
    if len(levels) != MOTORS or not all(0 <= level < len(LETTERS) for level in levels):
        raise ValueError("a belt has 14 motors with levels 0 to 3")
    cells = bytearray([DARK]) * CELLS
    letters = bytes(LETTERS[level] for level in levels)
    cells[_UPPER : _UPPER + COLUMNS] = letters[:COLUMNS]
    cells[_LOWER : _LOWER + COLUMNS] = letters[COLUMNS:]
    return START + bytes(cells)


def motor_cells(cells: bytes) -> tuple[int, ...]:
    """Of 35 cells, those that have motors, in the order of the levels."""
    return (*cells[_UPPER : _UPPER + COLUMNS], *cells[_LOWER : _LOWER + COLUMNS])


MOTOR_PLACES = tuple(len(START) + cell for cell in motor_cells(bytes(range(CELLS))))
"""The index of each motor's letter in a frame. Clients of Player use it as the motor's number."""


def contains_complaint(received: bytes | bytearray) -> bool:
    """Whether a belt's board sent this: no other device does."""
    return any(each in received for each in COMPLAINTS)


class BeltSender:
    """Decides which bytes are sent when; its owner writes them. Not thread-safe. ``now`` is in seconds.

    - Only the newest levels are sent. There is never a queue.
    - While a motor is on, a frame is sent every 40 ms: the board turns its motors off by itself after 25 to
      74 ms.
    - Off is one frame of ``P`` and then silence.
    - A complaint of the board is answered with a resync. A resync causes complaints of its own, so complaints
    between it and the next frame mean nothing, however late they are read.
    - A motor keeps the strongest level of the last quarter second, so that even the shortest pulse is felt.
    """

    def __init__(self) -> None:
        self._levels = OFF
        self._held_until = [(0, -inf)] * len(OFF)
        """Of each motor the strongest recent level, and until when it counts."""
        self._due = -inf
        self._is_lit = False
        """Whether the last frame had a motor on, so that another frame must follow."""
        self._must_resync = True
        self._is_framed = False
        """Whether a frame was sent since the last resync: only then a complaint means something."""

    def show(self, levels: tuple[int, ...], now: float) -> None:
        """Show these levels from now on. Raises ``ValueError`` if they are not valid."""
        encode_frame(levels)
        self._levels = levels
        for motor, level in enumerate(levels):
            if level >= self._felt_of(motor, now):
                self._held_until[motor] = (level, now + HOLD)

    def start_over(self) -> None:
        """The port was reopened: its board may be in the middle of a frame."""
        self._must_resync = True
        self._due = -inf

    def receive(self, received: bytes) -> None:
        """Take in what the board sent. Anything but a complaint is noise."""
        if _COMPLAINT in received and self._is_framed:
            self._must_resync = True

    def wait(self, now: float) -> float | None:
        """Seconds until ``next`` returns bytes; None if only ``show`` can change that."""
        if not (self._must_resync or self._is_lit or any(self._felt(now))):
            return None
        return max(0.0, self._due - now)

    def next(self, now: float) -> bytes:
        """The bytes that are due now, empty if there are none. They count as written."""
        if now < self._due:
            return b""
        if self._must_resync:
            self._must_resync = self._is_framed = False
            self._due = now + AFTER_RESYNC
            return RESYNC
        felt = self._felt(now)
        if not any(felt) and not self._is_lit:
            return b""
        self._is_lit, self._is_framed = any(felt), True
        self._due = now + PERIOD
        return encode_frame(felt)

    def is_over(self, now: float) -> bool:
        """Whether the belt is off, and the frame that turns it off was sent."""
        return not (self._is_lit or any(self._felt(now)))

    def _felt(self, now: float) -> tuple[int, ...]:
        return tuple(self._felt_of(motor, now) for motor in range(len(OFF)))

    def _felt_of(self, motor: int, now: float) -> int:
        level, until = self._held_until[motor]
        return max(self._levels[motor], level if now < until else 0)


class BeltCheck(Enum):
    """What ``BeltDetector`` asks its owner to do."""

    NOTHING = auto()
    ASK = auto()
    """Send a resync."""
    REPORT_MISSING = auto()
    """Report that no belt answers."""


class BeltDetector:
    """Finds out whether the device at the port is a belt: a robot's board, say, accepts the bytes and never
    answers. A belt answers each resync with an error line. Its board may have been starting when the first
    resync came, so a second one is sent before a missing belt is reported.
    """

    def __init__(self, now: float) -> None:
        """``now``: when the port was opened."""
        self._began = now
        self._received = b""
        self._has_asked = self._is_over = False

    def receive(self, received: bytes) -> None:
        self._received = (self._received + received)[-_LONGEST:]
        self._is_over |= contains_complaint(self._received)

    def next(self, now: float) -> BeltCheck:
        """Each answer but NOTHING is given once."""
        waited = now - self._began
        if self._is_over or waited < ASKED_AGAIN:
            return BeltCheck.NOTHING
        if not self._has_asked:
            self._has_asked = True
            return BeltCheck.ASK
        if waited < GIVEN_UP:
            return BeltCheck.NOTHING
        self._is_over = True
        return BeltCheck.REPORT_MISSING
