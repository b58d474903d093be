"""Ports with a simulated board at the other end and a clock of their own: 20 ms pass with each read."""

from __future__ import annotations

from collections.abc import Callable

from devices.belt import BAUD
from devices.board_simulator.board import SimulatedBoard
from devices.port_exchange import READ_TIMEOUT
from devices.wire.frames import CONFIGURE
from tests.simulated_belt import SimulatedBelt


class BoardPort:
    """The port of a robot's board, or a silent one."""

    def __init__(self, board: SimulatedBoard | None) -> None:
        self.board = board
        self.written: list[bytes] = []
        self.is_closed = False
        self._now = 0.0

    def read(self) -> bytes:
        self._now += READ_TIMEOUT
        return self.board.advance(READ_TIMEOUT) if self.board else b""

    def write(self, data: bytes) -> None:
        self.written.append(data)
        if self.board:
            self.board.receive(data)

    def now(self) -> float:
        return self._now

    def set_baud(self, baud: int) -> None:
        """A robot's board understands nothing at another speed."""
        self.board = None

    def close(self) -> None:
        self.is_closed = True


class BeltOnly(BoardPort):
    """The port of a belt's board, which understands nothing until the speed is right."""

    def __init__(self) -> None:
        super().__init__(None)
        self._belt: SimulatedBelt | None = None
        self._answer = b""

    def set_baud(self, baud: int) -> None:
        self._belt = SimulatedBelt() if baud == BAUD else None

    def write(self, data: bytes) -> None:
        self.written.append(data)
        self._answer += self._belt.feed(data, self._now) if self._belt else b""

    def read(self) -> bytes:
        self._now += READ_TIMEOUT
        answer, self._answer = self._answer, b""
        return answer


def opener(port: BoardPort) -> Callable[..., BoardPort]:
    """Opens that port, whatever address and options it is given."""
    return lambda *_address, **_options: port


def running(board: SimulatedBoard, frame: bytes = b"") -> SimulatedBoard:
    """The board, configured and streaming, after it has received ``frame``."""
    board.advance(2.1)
    board.receive(CONFIGURE)
    board.advance(0.2)
    board.receive(frame)
    board.advance(0.2)
    return board
