"""The robot of ``--robot double``: the real robot's driver, and at the end of its line a simulated board.

It lives in virtual time, so that a program may be tried at any speed, and can be put back to its start.
"""

from __future__ import annotations

from collections.abc import Callable

from devices.firmware_double.board import SimulatedBoard
from devices.firmware_double.surroundings import Place, Surroundings
from devices.firmware_double.virtual_line import VirtualLine, VirtualPace
from devices.ports.robot import LinkNews, Pace, Pose, Watcher
from devices.serial_robot.config import RobotConfig
from devices.serial_robot.robot import SerialRobot

QUICK_PASSES = 150
"""Passes of the board's loop a second: a fifth of the real ones', for they are what takes time."""


class DoubleRobot(SerialRobot):
    """A SerialRobot without a serial line. Connected from the beginning."""

    def __init__(
        self,
        surroundings: Surroundings | None = None,
        config: RobotConfig | None = None,
        *,
        pace: Pace,
        watcher: Watcher | None = None,
        speed: float | None = 1.0,
        place: Place | None = None,
        start: Pose | None = None,
        on_event: Callable[[LinkNews, str], None] | None = None,
        passes: int = QUICK_PASSES,
    ) -> None:
        """``place``: where it begins; looking north from the origin if it isn't given. ``start``: what the
        robot calls that place."""
        self.board = SimulatedBoard(surroundings, place=place, boot_loader=0.0, passes=passes)
        self.line = VirtualLine(self.board, on_event=on_event)
        self._virtual = VirtualPace(self.line, pace, speed)
        self._start = self.board.wheels.place
        super().__init__(self.line, config, pace=self._virtual, watcher=watcher, start=start)
        self.connect()

    @property
    def speed(self) -> float | None:
        """A multiple of real time; None is unlimited. Any thread may set it, at any time."""
        return self._virtual.speed

    @speed.setter
    def speed(self, speed: float | None) -> None:
        self._virtual.speed = speed

    def reset(self) -> None:
        """Back to where it began, as somebody would carry it."""
        self.line.advance(STANDING)
        self.board.wheels.place = self._start
        super().reset()


STANDING = 0.1
"""Seconds in which the wheels surely stand."""
