"""A link with a simulated board at its end, in virtual time."""

from __future__ import annotations

from devices.board_simulator.board import SimulatedBoard
from devices.board_simulator.floor import Floor
from devices.board_simulator.robot import VirtualLink
from devices.ports.robot import LinkNotice
from devices.wire.connection import BoardConnection
from devices.wire.frames import MotorDrive, encode_frame
from devices.wire.link_state import LinkConfig, LinkState
from tests.noisy_wire import NoisyWire, WiredBoard

FAR = 1e9

HALF_A_FRAME = bytes.fromhex("aabb3228")
"""Announces fifty bytes: the board takes the next ones for its data."""


class Bench:
    """Connected from the beginning by default."""

    def __init__(
        self,
        floor: Floor | None = None,
        *,
        connected: bool = True,
        resets_on_open: bool = True,
        noise: float = 0.0,
        cut: float = 0.0,
    ) -> None:
        self.notices: list[LinkNotice] = []
        self.texts: list[str] = []
        self.board = WiredBoard(floor, boot_loader=0.5, wire=NoisyWire(noise, cut, seed=7))
        self.link = VirtualLink(
            self.board,
            on_notice=lambda notice, _: self.notices.append(notice),
            resets_on_open=resets_on_open,
            on_text=self.texts.append,
        )
        self.written: list[tuple[float, bytes]] = []
        self.link.written = self.written
        if connected:
            self.link.connect()

    def drive(self, seconds: float, drive: MotorDrive = MotorDrive.FORWARD, until: float = FAR) -> bool:
        """Drive as a robot would, renewing it. False once the permit is void."""
        permit = self.link.permit()
        for _ in range(round(seconds / 0.02)):
            if not self.link.drive(permit, drive, until):
                return False
            self.link.advance(0.02)
        return True

    def sent_since(self, at: float) -> list[bytes]:
        return [data for when, data in self.written if when > at]

    @property
    def is_up(self) -> bool:
        return self.link.state is LinkState.STREAMING


def abandoned_board(half_a_frame: bytes = b"") -> SimulatedBoard:
    """Configured and driving, its host gone, perhaps in the middle of a frame."""
    board = SimulatedBoard(boot_loader=0.0)
    board.advance(1.5)
    board.receive(bytes.fromhex("aabb13c03f800000000000000000000040a0000003fdef"))
    board.advance(0.2)
    board.receive(bytes.fromhex("aabb05280f7ff07fcc") + half_a_frame)
    board.advance(0.2)
    return board


def streaming() -> BoardConnection:
    """A connection whose board has answered, at second 1."""
    connection = BoardConnection(LinkConfig())
    connection.open()
    connection.opened(0.0)
    connection.received(encode_frame(0xC7, b"\x2b"), 0.1)
    for now in (0.1, 0.2, 0.3):
        connection.actions(now)
    connection.received(encode_frame(0x81, bytes(8)), 1.0)
    assert connection.state is LinkState.STREAMING
    return connection
