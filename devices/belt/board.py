"""A simulated belt board: what the original firmware does with each byte, and what its motors do meanwhile.

Pure: bytes and times in, bytes and motors out. It answers as the recording of a real board does (a test
holds it to that). Bounded: it keeps one frame.
"""

from __future__ import annotations

from devices.belt.frame import COLUMNS, COMPLAINTS, DARK, ROWS, START, motors

_CELLS = COLUMNS * ROWS
_LETTERS = range(ord("A"), ord("P") + 1)
_OUTSIDE, _INSIDE = COMPLAINTS
_PASSES = 100
"""Passes of the board's loop without a frame, after which all motors are off."""

_PASS, _PASS_A_CELL = 0.000212, 0.000038
"""Seconds that a pass takes, and that each lit cell adds: 25 ms with one of them, 74 ms with 14."""


class BeltBoard:
    """The board at the other end. ``now`` is in seconds, and never goes back."""

    def __init__(self) -> None:
        self._cells = bytes([DARK]) * _CELLS
        self._shown_at = 0.0
        self._coming: bytearray | None = None
        """The letters of a frame that began, or None outside of one."""
        self.frames = 0
        """Whole frames so far."""

    def feed(self, received: bytes, now: float) -> bytes:
        """The board's answer to these bytes."""
        return b"".join(self._take(byte, now) for byte in received)

    def motors(self, now: float) -> tuple[str, ...]:
        """The letter of each of the 14 motors, ``P`` for off."""
        lit = sum(cell != DARK for cell in self._cells)
        if now - self._shown_at > _PASSES * (_PASS + _PASS_A_CELL * lit):
            return ("P",) * len(motors(self._cells))
        return tuple(chr(each) for each in motors(self._cells))

    def _take(self, byte: int, now: float) -> bytes:
        if self._coming is None:
            if byte != START[0]:
                return _OUTSIDE
            self._coming = bytearray()
        elif byte not in _LETTERS:
            self._coming = None
            return _INSIDE
        else:
            self._coming.append(byte)
            self._show_whole(now)
        return b""

    def _show_whole(self, now: float) -> None:
        if self._coming is not None and len(self._coming) == _CELLS:
            self._cells, self._shown_at, self._coming = bytes(self._coming), now, None
            self.frames += 1
