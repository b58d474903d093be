"""The driver's line with a simulated board at its end and no port, no thread and no clock between.

Time goes by only when it is told to, so that an hour of driving takes seconds and repeats to the last byte.
"""

from __future__ import annotations

from collections.abc import Callable

from devices.firmware_double.board import SimulatedBoard
from devices.firmware_double.faults import BadWire
from devices.ports.robot import LinkNews, Pace, RobotProblem
from devices.wire.commands import Drive
from devices.wire.connection import Action, Connection, Need, Write
from devices.wire.link_config import LinkConfig
from devices.wire.link_state import LinkState
from devices.wire.stopping import LONGEST_STOP
from devices.wire.telemetry import Telemetry

LOOK = 0.01
"""Seconds between two looks at the line, as on a real one."""


class VirtualLine:
    """A line to one board. See ``devices.serial_robot.line.RobotLine``. For one thread, but ``stop``."""

    def __init__(
        self,
        board: SimulatedBoard,
        config: LinkConfig | None = None,
        on_event: Callable[[LinkNews, str], None] | None = None,
        *,
        wire: BadWire | None = None,
        resets_on_open: bool = True,
        on_text: Callable[[str], None] | None = None,
        name: str = "double",
    ) -> None:
        """``resets_on_open``: as a board on USB does."""
        self.name = name
        self.board = board
        self.wire = wire or BadWire()
        self.is_plugged = True
        """A fault while it is False: the port is gone."""
        self.is_blocked = False
        """A fault: the system takes nothing more to be written."""
        self.look = LOOK
        """Seconds between two looks at the line; longer is cheaper."""
        self.written: list[tuple[float, bytes]] | None = None
        """When what was written, if somebody sets it to a list."""
        self._config = config or LinkConfig()
        self._connection = Connection(self._config, on_text)
        self._on_event = on_event
        self._resets_on_open = resets_on_open
        self._is_open = False
        self._now = 0.0

    @property
    def state(self) -> LinkState:
        return self._connection.state

    @property
    def telemetry(self) -> Telemetry:
        return self._connection.telemetry

    @property
    def driving_since(self) -> float | None:
        return self._connection.driving_since

    def now(self) -> float:
        return self._now

    def permit(self) -> int:
        return self._connection.permit

    def drive(self, permit: int, drive: Drive, until: float) -> bool:
        return self._connection.drive(permit, drive, until, self._now)

    def stop(self) -> None:
        self._connection.stop(self._now)

    def put(self, frame: bytes) -> None:
        self._connection.put(frame)

    def connect(self) -> None:
        if self.state is not LinkState.CLOSED:
            return
        self._connection.open(self._now)
        if not self.is_plugged:
            self._connection.close(self._now)
            raise RobotProblem("no-port", port=self.name, reason="unplugged")
        self._opened()
        while self._is_in(LinkState.WAITING):
            self._look()
        if not self._is_in(LinkState.STREAMING):
            self.close()
            raise RobotProblem("no-answer", port=self.name)

    def give_up(self) -> None:
        """Of no effect: connecting takes no real time."""

    def wait_until_standing(self) -> None:
        """Of no effect: the board rests while nobody moves its time along."""

    def wait_until_told(self) -> None:
        """Of no effect: what happens is told where the time is moved along."""

    def close(self) -> None:
        if self.state is LinkState.CLOSED:
            return
        self.stop()
        ends = self._now + LONGEST_STOP
        while not self._connection.is_standing and self._now < ends:
            self._look()
        self._connection.close(self._now)
        self._is_open = False

    def advance(self, seconds: float) -> None:
        """Let time go by, on the line and on the board."""
        ends = self._now + seconds
        while self._now < ends - 1e-9:
            self._look(min(self.look, ends - self._now))

    def _is_in(self, state: LinkState) -> bool:
        return self.state is state

    def _look(self, seconds: float = LOOK) -> None:
        self._now += seconds
        told = self.wire.to_host(self.board.advance(seconds))
        if self._is_open and not self.is_plugged:
            self._is_open = False
            self._connection.failed(self._now, "device disconnected")
        if self._is_open and told:
            self._connection.received(told, self._now)
        for action in self._connection.actions(self._now):
            self._do(action)
        for news, reason in self._connection.take_news():
            if self._on_event is not None:
                self._on_event(news, reason or self.name)

    def _do(self, action: Action) -> None:
        match action:
            case Write(data=data):
                self._write(data)
            case Need.FORCE:
                if self._is_open and self._resets_on_open:
                    self.board.reset()
            case Need.REOPEN:
                self._reopen()

    def _write(self, data: bytes) -> None:
        if not self._is_open:
            return
        if self.is_blocked:
            self._is_open = False
            self._connection.failed(self._now, "the port takes nothing")
            return
        if self.written is not None:
            self.written.append((self._now, data))
        self.board.receive(self.wire.to_board(data))

    def _reopen(self) -> None:
        self._is_open = False
        self._connection.open(self._now)
        if self.is_plugged:
            self._opened()
        else:
            self._connection.failed(self._now, "no such device")

    def _opened(self) -> None:
        self._is_open = True
        if self._resets_on_open:
            self.board.reset()
        self._connection.opened(self._now)


class VirtualPace:
    """A pace that moves the line's time along: as fast as wanted, or as fast as possible."""

    def __init__(self, line: VirtualLine, pace: Pace, speed: float | None = None) -> None:
        """``speed``: a multiple of real time; None is unlimited. ``pace`` does the real waiting."""
        self.speed = speed
        self._line = line
        self._pace = pace

    def sleep(self, seconds: float) -> bool:
        speed = self.speed
        if not self._pace.sleep(seconds / speed if speed is not None else 0.0):
            return False
        self._line.advance(seconds)
        return True
