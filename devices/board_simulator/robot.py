"""The robot of ``--robot double``: the real robot's driver with a simulated board at the end of its link.

There is no port, no thread and no clock between them. Time passes only when ``VirtualLink.advance`` is
called, so an hour of driving takes seconds and repeats to the last byte, and a program can run at any speed.
"""

from __future__ import annotations

from collections.abc import Callable

from devices.board_simulator.board import QUICK_PASSES, SimulatedBoard
from devices.ports.robot import LinkNotice, Pace, Pose, RobotProblem, Watcher
from devices.serial_robot.config import RobotConfig
from devices.serial_robot.link import ConnectionState
from devices.serial_robot.robot import SerialRobot
from devices.wire.connection import Action, BoardConnection, PortAction, Write
from devices.wire.frames import MotorDrive, Wiring
from devices.wire.link_state import LinkConfig, LinkState

POLL = 0.01
"""Seconds between two polls of the link, as on a real one."""

STANDING = 0.1
"""Seconds after which the wheels surely stand."""


class VirtualLink(ConnectionState):
    """A ``RobotLink`` to one simulated board, for one thread; only ``stop`` may be called by any."""

    def __init__(
        self,
        board: SimulatedBoard,
        config: LinkConfig | None = None,
        on_notice: Callable[[LinkNotice, str], None] | None = None,
        *,
        resets_on_open: bool = True,
        on_text: Callable[[str], None] | None = None,
    ) -> None:
        """``resets_on_open``: opening the port restarts the board, as on USB."""
        super().__init__(BoardConnection(config or LinkConfig(), on_text))
        self.name = "double"
        self.board = board
        self.is_plugged = True
        """A fault while it is False: the port is gone."""
        self.is_blocked = False
        """A fault: the system accepts no more bytes to write."""
        self.poll = POLL
        """Seconds between two polls of the link; longer is cheaper."""
        self.written: list[tuple[float, bytes]] | None = None
        """Set it to a list to collect the times and bytes of all writes."""
        self._on_notice = on_notice
        self.has_reset_wire = resets_on_open
        """Whether opening the port, and force, restart the board."""
        self._is_open = False
        self._now = 0.0

    def now(self) -> float:
        return self._now

    def drive(self, permit: int, drive: MotorDrive, until: float) -> bool:
        return self._connection.drive(permit, drive, until, self._now)

    def stop(self) -> None:
        self._connection.stop(self._now)

    def put(self, frame: bytes) -> None:
        self._connection.put(frame)

    def rewire(self, wiring: Wiring) -> None:
        self._connection.rewire(wiring, self._now)

    def connect(self) -> None:
        if self.state is not LinkState.CLOSED:
            return
        self._connection.open()
        if not self.is_plugged:
            self._connection.close(self._now)
            raise RobotProblem("no-port", port=self.name, reason="unplugged")
        self._opened()
        while self._is_in(LinkState.WAITING):
            self._poll()
        if not self._is_in(LinkState.STREAMING):
            self.close()
            raise RobotProblem("no-answer", port=self.name)

    def give_up(self) -> None:
        """Has no effect: connecting takes no real time."""

    def await_stop(self) -> bool:
        ends = self._now + self._connection.longest_stop
        while not self._connection.is_stop_over and self._now < ends:
            self._poll()
        return not self.has_run_away

    def wait_until_standing(self) -> None:
        """Has no effect: the board does nothing while its time doesn't pass."""

    def wait_until_notified(self) -> None:
        """Has no effect: the listener is called while time passes."""

    def close(self) -> None:
        if self.state is LinkState.CLOSED:
            return
        self.stop()
        self.await_stop()
        self._connection.close(self._now)
        self._is_open = False

    def advance(self, seconds: float) -> None:
        """Let time pass, on the link and on the board."""
        ends = self._now + seconds
        while self._now < ends - 1e-9:
            self._poll(min(self.poll, ends - self._now))

    def _is_in(self, state: LinkState) -> bool:
        return self.state is state

    def _poll(self, seconds: float = POLL) -> None:
        self._now += seconds
        received = self.board.advance(seconds)
        if self._is_open and not self.is_plugged:
            self._is_open = False
            self._connection.failed(self._now, "device disconnected")
        if self._is_open and received:
            self._connection.received(received, self._now)
        for action in self._connection.actions(self._now):
            self._do(action)
        for notice, reason in self._connection.take_notices():
            if self._on_notice is not None:
                self._on_notice(notice, reason or self.name)

    def _do(self, action: Action) -> None:
        match action:
            case Write(data=data):
                self._write(data)
            case PortAction.RESET:
                if self._is_open and self.has_reset_wire:
                    self.board.reset()
                self._connection.forced(self._now)
            case PortAction.REOPEN:
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
        self.board.receive(data)

    def _reopen(self) -> None:
        self._is_open = False
        self._connection.open()
        if self.is_plugged:
            self._opened()
        else:
            self._connection.failed(self._now, "no such device")

    def _opened(self) -> None:
        self._is_open = True
        if self.has_reset_wire:
            self.board.reset()
        self._connection.opened(self._now)


class VirtualPace:
    """A pace that advances the link's time while it waits."""

    def __init__(self, link: VirtualLink, pace: Pace, speed: float | None = None) -> None:
        """``speed``: a multiple of real time; None is unlimited. ``pace`` waits in real time."""
        self.speed = speed
        self._link = link
        self._pace = pace

    def sleep(self, seconds: float) -> bool:
        speed = self.speed
        if not self._pace.sleep(seconds / speed if speed is not None else 0.0):
            return False
        self._link.advance(seconds)
        return True


class SimulatedSerialRobot(SerialRobot):
    """A ``SerialRobot`` with a simulated board instead of a port. It is connected from the beginning."""

    def __init__(
        self,
        board: SimulatedBoard | None = None,
        config: RobotConfig | None = None,
        *,
        pace: Pace,
        watcher: Watcher | None = None,
        speed: float | None = 1.0,
        start: Pose | None = None,
        on_notice: Callable[[LinkNotice, str], None] | None = None,
    ) -> None:
        """``start``: the pose that the robot takes itself to have where its board begins. ``speed``: a
        multiple of real time; None is unlimited."""
        self.board = board or SimulatedBoard(boot_loader=0.0, passes=QUICK_PASSES)
        self.link = VirtualLink(self.board, on_notice=on_notice)
        self._virtual_pace = VirtualPace(self.link, pace, speed)
        self._first_place = self.board.wheels.place
        super().__init__(
            self.link,
            config,
            pace=self._virtual_pace,
            watcher=watcher,
            start=start,
            on_notice=on_notice,
        )
        self.connect()

    @property
    def speed(self) -> float | None:
        """A multiple of real time; None is unlimited. Any thread may set it, at any time."""
        return self._virtual_pace.speed

    @speed.setter
    def speed(self, speed: float | None) -> None:
        self._virtual_pace.speed = speed

    def reset(self) -> None:
        """Back to where it began, as if a person carried it there."""
        self.link.advance(STANDING)
        self.board.wheels.place = self._first_place
        super().reset()
