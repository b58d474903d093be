"""What is at a port: a robot, a belt, or nothing that answers. Nothing moves by being asked.

Opening the port restarts a board on USB. A robot that waits for its configuration is given it, because only
then it tells its battery; that does not move it.
"""

from __future__ import annotations

from collections.abc import Callable
from enum import Enum

from devices.belt.frame import BAUD as BELT_BAUD
from devices.belt.frame import RESYNC, is_complaint
from devices.port_talk.line import Line, PortLine, hold, telling_what_is_gone
from devices.ports.values import Frozen
from devices.wire.commands import CONFIGURE
from devices.wire.decoder import Decoder
from devices.wire.reports import ConfigWanted, Power, Report

ROBOT_BAUD = 115200
FIRST_ANSWER = 6.0
"""Seconds within which a robot's board that was just restarted says something."""

BATTERY = 2.0
"""Seconds more until it has told its battery: it does so three times a second once it is configured."""

BELT_ANSWER = 0.5


class Answer(Enum):
    """Who is there."""

    ROBOT = "robot"
    BELT = "belt"
    NOTHING = "nothing"


class Found(Frozen):
    """What was found out about a port."""

    answer: Answer
    millivolts: int | None = None
    """The robot's battery, if it told that."""
    restarted: bool = False
    """Whether opening the port restarted the robot's board."""


class RobotTalk:
    """Listens for a robot, and lets it tell its battery."""

    def __init__(self) -> None:
        self._decoder = Decoder()
        self._until: float | None = None
        self.answers = False
        self.restarted = False
        self.millivolts: int | None = None

    def next(self, received: bytes, now: float) -> bytes:
        if self._until is None:
            self._until = now + FIRST_ANSWER
        reply = b""
        for report in self._decoder.feed(received):
            reply = self._take(report, now) or reply
        return reply

    def _take(self, report: Report, now: float) -> bytes:
        if not self.answers:
            self.answers = True
            self._until = now + BATTERY
        if isinstance(report, Power):
            self.millivolts = report.millivolts
        elif isinstance(report, ConfigWanted):
            self.restarted = True
            return CONFIGURE
        return b""

    def is_over(self, now: float) -> bool:
        return self.millivolts is not None or (self._until is not None and now >= self._until)


class BeltTalk:
    """Asks for the belt's complaint about something that is no frame."""

    def __init__(self) -> None:
        self._said = bytearray()
        self._until: float | None = None

    @property
    def answers(self) -> bool:
        return is_complaint(self._said)

    def next(self, received: bytes, now: float) -> bytes:
        self._said = (self._said + received)[-64:]
        if self._until is None:
            self._until = now + BELT_ANSWER
            return RESYNC
        return b""

    def is_over(self, now: float) -> bool:
        return self.answers or (self._until is not None and now >= self._until)


def ask(
    port: str,
    opened: Callable[[str, int], Line] = PortLine,
    *,
    is_given_up: Callable[[], bool] = lambda: False,
) -> Found:
    """Who is at the port; some seven seconds at most. Raises ``PortProblem``.

    Any thread may have it given up: what is answered then means nothing.
    """
    line = opened(port, ROBOT_BAUD)
    try:
        robot = RobotTalk()
        hold(line, robot, port, is_given_up)
        if robot.answers:
            return Found(Answer.ROBOT, robot.millivolts, robot.restarted)
        with telling_what_is_gone(port):
            line.set_speed(BELT_BAUD)
        belt = BeltTalk()
        hold(line, belt, port, is_given_up)
        return Found(Answer.BELT if belt.answers else Answer.NOTHING)
    finally:
        line.close()
