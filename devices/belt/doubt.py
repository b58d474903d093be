"""Whether what is at the belt's port is a belt: a robot's board, say, takes the bytes and never answers.

Pure: time comes in as a parameter. A belt answers each resync with an error line of its own. Its board may
have been starting when the first one came, so it is asked once more before anything is said.
"""

from __future__ import annotations

from enum import Enum, auto

from devices.belt.frame import is_complaint

ASKED_AGAIN = 3.0
"""Seconds behind the opening, when a board that opening restarted has surely begun."""

GIVEN_UP = 4.0
"""Seconds behind the opening, when an answer would long have come."""

_LONGEST = 16
"""Bytes of what was said last that are looked through."""


class Next(Enum):
    """What is to be done."""

    NOTHING = auto()
    ASK = auto()
    """A resync."""
    TELL = auto()
    """That no belt answers."""


class Doubt:
    """About one line, from its opening on. Each answer but NOTHING comes once."""

    def __init__(self, now: float) -> None:
        self._began = now
        self._said = b""
        self._has_asked = self._is_over = False

    def heard(self, received: bytes) -> None:
        self._said = (self._said + received)[-_LONGEST:]
        self._is_over |= is_complaint(self._said)

    def next(self, now: float) -> Next:
        waited = now - self._began
        if self._is_over or waited < ASKED_AGAIN:
            return Next.NOTHING
        if not self._has_asked:
            self._has_asked = True
            return Next.ASK
        if waited < GIVEN_UP:
            return Next.NOTHING
        self._is_over = True
        return Next.TELL
