"""A line to a simulated board, with a clock of its own: 20 milliseconds go by with each read."""

from __future__ import annotations

from collections.abc import Callable

from devices.belt.board import BeltBoard
from devices.belt.frame import BAUD
from devices.firmware_double.board import SimulatedBoard
from devices.port_talk.line import GLANCE, Line


class BoardLine:
    """A robot's board, or silence. ``resets``: opening the line restarts it, as on USB."""

    def __init__(self, board: SimulatedBoard | None) -> None:
        self.board = board
        self.written: list[bytes] = []
        self.is_closed = False
        self._now = 0.0

    def read(self) -> bytes:
        self._now += GLANCE
        return self.board.advance(GLANCE) if self.board else b""

    def write(self, data: bytes) -> None:
        self.written.append(data)
        if self.board:
            self.board.receive(data)

    def now(self) -> float:
        return self._now

    def set_speed(self, baud: int) -> None:
        """A robot's board makes nothing of another speed."""
        self.board = None

    def close(self) -> None:
        self.is_closed = True


class BeltOnly(BoardLine):
    """A belt's board: deaf until the line has its speed."""

    def __init__(self) -> None:
        super().__init__(None)
        self._belt: BeltBoard | None = None
        self._answer = b""

    def set_speed(self, baud: int) -> None:
        self._belt = BeltBoard() if baud == BAUD else None

    def write(self, data: bytes) -> None:
        self.written.append(data)
        self._answer += self._belt.feed(data, self._now) if self._belt else b""

    def read(self) -> bytes:
        self._now += GLANCE
        answer, self._answer = self._answer, b""
        return answer


def opening(line: Line) -> Callable[..., Line]:
    """What opens that line, whatever is asked for."""
    return lambda *_port, **_how: line


def running(board: SimulatedBoard, frame: bytes = b"") -> SimulatedBoard:
    """The board after it was configured, and told something besides."""
    from devices.wire.commands import CONFIGURE

    board.advance(2.1)
    board.receive(CONFIGURE)
    board.advance(0.2)
    board.receive(frame)
    board.advance(0.2)
    return board
