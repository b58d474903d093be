"""A line with a simulated board at its end, in virtual time, and what is asked of both in the tests."""

from __future__ import annotations

from devices.firmware_double.board import SimulatedBoard
from devices.firmware_double.faults import BadWire
from devices.firmware_double.surroundings import Surroundings
from devices.firmware_double.virtual_line import VirtualLine
from devices.ports.robot import LinkNews
from devices.wire.commands import Drive, frame
from devices.wire.connection import Connection
from devices.wire.link_config import LinkConfig
from devices.wire.link_state import LinkState

FAR = 1e9

HALF_A_FRAME = bytes.fromhex("aabb3228")
"""Announces fifty bytes, and swallows whatever comes next as them."""


class Bench:
    """Connected from the beginning, unless it is told not to be."""

    def __init__(
        self,
        surroundings: Surroundings | None = None,
        *,
        connected: bool = True,
        resets_on_open: bool = True,
        noise: float = 0.0,
        cut: float = 0.0,
    ) -> None:
        self.news: list[LinkNews] = []
        self.texts: list[str] = []
        self.board = SimulatedBoard(surroundings, boot_loader=0.5)
        self.line = VirtualLine(
            self.board,
            on_event=lambda news, _: self.news.append(news),
            wire=BadWire(noise, cut, seed=7),
            resets_on_open=resets_on_open,
            on_text=self.texts.append,
        )
        self.written: list[tuple[float, bytes]] = []
        self.line.written = self.written
        if connected:
            self.line.connect()

    def drive(self, seconds: float, drive: Drive = Drive.FORWARD, until: float = FAR) -> bool:
        """Drive as a robot would, renewing it; False once the permit is void."""
        permit = self.line.permit()
        for _ in range(round(seconds / 0.02)):
            if not self.line.drive(permit, drive, until):
                return False
            self.line.advance(0.02)
        return True

    def sent_since(self, at: float) -> list[bytes]:
        return [data for when, data in self.written if when > at]

    @property
    def is_up(self) -> bool:
        return self.line.state is LinkState.STREAMING


def board_that_drives_on(half_a_frame: bytes = b"") -> SimulatedBoard:
    """Configured and driving, its host gone, perhaps in the middle of a frame."""
    board = SimulatedBoard(boot_loader=0.0)
    board.advance(1.5)
    board.receive(bytes.fromhex("aabb13c03f800000000000000000000040a0000003fdef"))
    board.advance(0.2)
    board.receive(bytes.fromhex("aabb05280f7ff07fcc") + half_a_frame)
    board.advance(0.2)
    return board


def streaming() -> Connection:
    """As a Connection is once a board has answered, at second 1."""
    connection = Connection(LinkConfig())
    connection.open(0.0)
    connection.opened(0.0)
    connection.received(frame(0xC7, b"\x2b"), 0.1)
    for now in (0.1, 0.2, 0.3):
        connection.actions(now)
    connection.received(frame(0x81, bytes(8)), 1.0)
    assert connection.state is LinkState.STREAMING
    return connection
