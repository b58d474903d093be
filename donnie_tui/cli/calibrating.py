"""``donnie calibrate``: the robot walks and turns, a person measures, its sizes go into the settings file.

Rule: whatever ends it, a signal too, the robot stands before the port is let go.
"""

from __future__ import annotations

import sys
import threading
from collections.abc import Callable
from contextlib import closing
from dataclasses import dataclass
from types import FrameType
from typing import NoReturn

from devices.ports.robot import Moved, RobotProblem, Turned
from devices.serial_robot.calibration import axle_length, wheel_radius
from devices.serial_robot.config import RobotConfig
from devices.wire.telemetry import Telemetry
from donnie_tui.cli import codes
from donnie_tui.cli.ending import stopped_by_suspension
from donnie_tui.cli.order import Order
from donnie_tui.core.documents import DocumentError
from donnie_tui.i18n.words import Unusable
from donnie_tui.process.lost_readers import ReaderWatch
from donnie_tui.process.taken_signals import LEAVING, TakenSignals
from donnie_tui.robot.choice import sentences_of
from donnie_tui.robot.connection import MeasurableRobot, make_measurable, robot_config
from donnie_tui.settings.file import remember

STEPS = 20
"""A metre, so that a centimetre of a bad reading is a percent."""
DEGREES = 720
"""Two turns, for the same reason."""

_SMALLEST, _LARGEST = 0.001, 1.0
"""Metres that a radius or an axle can have in the settings."""


@dataclass(slots=True)
class _Steady:
    """The pace of a robot that nobody programs: real time, until somebody wants it to end."""

    ended: threading.Event

    def sleep(self, seconds: float) -> bool:
        return not self.ended.wait(seconds)


def calibrate(order: Order, made: Callable[..., MeasurableRobot] = make_measurable) -> int:
    """Ask, walk, ask, turn, ask, write. The exit code is 1 if nothing was measured."""
    try:
        robot = made(order.settings, order.words, _Steady(threading.Event()))
        with (
            TakenSignals(dict.fromkeys(LEAVING, _end)),
            closing(ReaderWatch()),
            closing(robot),
            stopped_by_suspension(lambda: _halted(robot)),
        ):
            return _Calibration(order, robot).talk()
    except RobotProblem as problem:
        raise Unusable(" ".join(sentences_of(problem, order.words))) from None


class _Calibration:
    """One conversation with whoever holds the tape measure."""

    def __init__(self, order: Order, robot: MeasurableRobot) -> None:
        self._order = order
        self._robot = robot
        self._config: RobotConfig = robot_config(order.settings)

    def talk(self) -> int:
        self._say("calibrate-start")
        self._robot.connect()
        radius = self._measured_radius()
        axle = self._measured_axle(radius or self._config.wheel_radius)
        for key, value in (("wheel_radius", radius), ("axle_length", axle)):
            if value is not None:
                self._write(key, value)
        if radius is None and axle is None:
            self._say("calibrate-nothing")
            return codes.FAILED
        return codes.DONE

    def _measured_radius(self) -> float | None:
        counts = self._counted("calibrate-walk", STEPS, lambda: self._robot.forward(STEPS))
        centimetres = self._ask("calibrate-ask-centimetres") if counts else None
        if not counts or centimetres is None:
            return None
        return self._sound(wheel_radius(counts, self._config.counts_a_turn, centimetres / 100))

    def _measured_axle(self, radius: float) -> float | None:
        counts = self._counted("calibrate-turn", DEGREES, lambda: self._robot.turn(DEGREES))
        degrees = self._ask("calibrate-ask-degrees") if counts else None
        if not counts or degrees is None:
            return None
        return self._sound(axle_length(counts, self._config.counts_a_turn, radius, degrees))

    def _counted(self, code: str, amount: int, go: Callable[[], Moved | Turned]) -> float:
        """What the wheels counted on the average of both; 0 if that is not to be measured."""
        self._say(code, amount=amount)
        if self._line() is None:
            return 0.0
        before = self._robot.telemetry
        done = go()
        if done.stopped_by is not None:
            self._say("calibrate-cut-short")
            return 0.0
        return _mean_counts(before, self._robot.telemetry)

    def _sound(self, metres: float) -> float | None:
        if _SMALLEST <= metres <= _LARGEST:
            return round(metres, 5)
        self._say("calibrate-absurd")
        return None

    def _write(self, key: str, value: float) -> None:
        try:
            remember(key, value, self._order.environment)
        except DocumentError as problem:
            raise Unusable(
                self._order.words(problem.code, path=problem.path, reason=problem.reason)
            ) from None
        self._say(f"calibrate-{key.replace('_', '-')}", millimetres=value * 1000)

    # --- asking

    def _ask(self, code: str) -> float | None:
        """A number above 0, or None for nothing."""
        self._say(code)
        while line := self._line():
            try:
                number = float(line.replace(",", "."))
            except ValueError:
                number = 0.0
            if 0 < number < 1e6:
                return number
            self._say("calibrate-number")
        return None

    def _line(self) -> str | None:
        """What was typed; None at the end of the input."""
        line = sys.stdin.readline()
        return line.strip() if line else None

    def _say(self, code: str, **values: object) -> None:
        self._order.output.line(self._order.words(code, **values))


def _halted(robot: MeasurableRobot) -> bool:
    robot.halt()
    robot.wait_until_standing()
    return True


def _mean_counts(before: Telemetry, after: Telemetry) -> float:
    return (abs(after.right - before.right) + abs(after.left - before.left)) / 2


def _end(_number: int, _frame: FrameType | None) -> NoReturn:
    """A signal ends the conversation as Ctrl+C does, so that the robot is stopped on the way out."""
    raise KeyboardInterrupt
