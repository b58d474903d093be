"""When which bytes go to the belt: pure, time comes in as a parameter, bytes go out as an answer.

Rules: the newest levels only, and never a queue; a frame each 40 ms while a motor is on, because the board
turns its motors off by itself within 25 to 74 ms; off is one frame of ``P`` and then silence. Whatever the
board complains about is answered with a resync; but a resync has answers of its own, so that what comes
between it and the next frame means nothing, however late it is read. What was on is felt: a motor holds the
strongest level of the last quarter second, so that a pulse of no length is still one.
"""

from __future__ import annotations

from math import inf

from devices.belt.frame import OFF, RESYNC, frame

PERIOD = 0.040
"""Seconds between two frames."""

HOLD = 0.25
"""Seconds for which a motor that was switched on is felt at least."""

AFTER_RESYNC = 0.030
"""Seconds of silence behind a resync, in which the board's error lines come."""

_COMPLAINT = ord("E")


class BeltSender:
    """Decides; its owner writes. Not thread-safe: its owner holds a lock. ``now`` is in seconds."""

    def __init__(self) -> None:
        self._levels = OFF
        self._held_until = [(0, -inf)] * len(OFF)
        """Of each motor its strongest level lately, and until when it counts."""
        self._due = -inf
        self._is_lit = False
        """Whether the last frame had a motor on: it must be followed by another one."""
        self._must_resync = True
        self._is_framed = False
        """Whether a frame was sent since the last resync: only then there is something to complain about."""

    def show(self, levels: tuple[int, ...], now: float) -> None:
        """These levels from now on. Raises ``ValueError`` if they are none."""
        frame(levels)
        self._levels = levels
        for motor, level in enumerate(levels):
            if level >= self._felt_of(motor, now):
                self._held_until[motor] = (level, now + HOLD)

    def start_over(self) -> None:
        """The line is a new one: nobody knows what its board is in the middle of."""
        self._must_resync = True
        self._due = -inf

    def heard(self, received: bytes) -> None:
        """What the board said. Only complaints are known; anything else is noise."""
        if _COMPLAINT in received and self._is_framed:
            self._must_resync = True

    def wait(self, now: float) -> float | None:
        """Seconds until ``next`` has something to say; None if only ``show`` can change that."""
        if not (self._must_resync or self._is_lit or any(self._felt(now))):
            return None
        return max(0.0, self._due - now)

    def next(self, now: float) -> bytes:
        """The bytes that are due now, none if there are none. They count as written."""
        if now < self._due:
            return b""
        if self._must_resync:
            self._must_resync = self._is_framed = False
            self._due = now + AFTER_RESYNC
            return RESYNC
        return self._next_frame(now)

    def _next_frame(self, now: float) -> bytes:
        felt = self._felt(now)
        if not any(felt) and not self._is_lit:
            return b""
        self._is_lit, self._is_framed = any(felt), True
        self._due = now + PERIOD
        return frame(felt)

    def is_over(self, now: float) -> bool:
        """Whether the belt is off and was told so."""
        return not (self._is_lit or any(self._felt(now)))

    def _felt(self, now: float) -> tuple[int, ...]:
        return tuple(self._felt_of(motor, now) for motor in range(len(OFF)))

    def _felt_of(self, motor: int, now: float) -> int:
        level, until = self._held_until[motor]
        return max(self._levels[motor], level if now < until else 0)
