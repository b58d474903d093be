"""The simulated board of the belt. Bytes and seconds in, bytes out; no port, no clock."""

from __future__ import annotations

from devices.belt import CELLS, COMPLAINTS, DARK, START, motor_cells

_LETTERS = range(ord("A"), ord("P") + 1)
_OUTSIDE, _INSIDE = COMPLAINTS
_PASSES_OF_A_FRAME = 100
"""Passes of the belt's loop without a frame, after which all motors are off."""

_PASS, _PASS_A_CELL = 0.000212, 0.000038
"""Seconds that a pass takes, and that each lit cell adds: 25 ms with one of them, 74 ms with 14."""


class SimulatedBelt:
    """The belt's board: its answers and its motors. ``now`` is in seconds, and never runs backward.

    A test compares it with a recording of a real board. It keeps no more than one frame.
    """

    def __init__(self) -> None:
        self._cells = bytes([DARK]) * CELLS
        self._shown_at = 0.0
        self._incoming: bytearray | None = None
        """The letters of a frame that has begun, or None outside of one."""
        self.frames = 0
        """Whole frames so far."""

    def feed(self, received: bytes, now: float) -> bytes:
        """The board's answer to these bytes."""
        return b"".join(self._take(byte, now) for byte in received)

    def motors(self, now: float) -> tuple[str, ...]:
        """The letter of each of the 14 motors, ``P`` for off."""
        lit = sum(cell != DARK for cell in self._cells)
        if now - self._shown_at > _PASSES_OF_A_FRAME * (_PASS + _PASS_A_CELL * lit):
            return ("P",) * len(motor_cells(self._cells))
        return tuple(chr(each) for each in motor_cells(self._cells))

    def _take(self, byte: int, now: float) -> bytes:
        if self._incoming is None:
            if byte != START[0]:
                return _OUTSIDE
            self._incoming = bytearray()
        elif byte not in _LETTERS:
            self._incoming = None
            return _INSIDE
        else:
            self._incoming.append(byte)
            if len(self._incoming) == CELLS:
                self._cells, self._shown_at, self._incoming = bytes(self._incoming), now, None
                self.frames += 1
        return b""
