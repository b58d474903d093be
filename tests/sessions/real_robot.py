"""What the sessions with a robot on a real line have in common."""

from __future__ import annotations

import os
import time
from collections.abc import Callable
from pathlib import Path

from devices.wire.frames import CONFIGURE, MotorDrive, drive_frame
from donnie_tui.bootstrap import Donnie, assemble
from donnie_tui.settings.settings import Settings
from tests.board_on_pty import PtyBoard
from tests.timeouts import TIMEOUT

LONG_WALK = "FW 100\n"
SOON = {"DONNIE_ROBOT_TIMEOUTS": "6"}
"""The wheels of a robot that does not stop are watched for nine seconds."""


def until(is_met: Callable[[], bool]) -> bool:
    """Wait for it, looking often."""
    ends = time.monotonic() + TIMEOUT
    while not is_met() and time.monotonic() < ends:
        time.sleep(0.005)
    return is_met()


def program(folder: Path, text: str) -> str:
    file = folder / "program.gd"
    file.write_text(text, encoding="utf-8")
    return str(file)


def serial(robot: PtyBoard) -> tuple[str, ...]:
    return "--robot", f"serial:{robot.path}"


def is_suspended(pid: int) -> bool:
    _, status = os.waitpid(pid, os.WUNTRACED)
    return os.WIFSTOPPED(status)


def half_a_frame(robot: PtyBoard) -> None:
    """The board takes what is said next for the rest of fifty bytes, the stops as well."""
    robot.disturb(bytes.fromhex("aabb3228"))


def leave_driving(robot: PtyBoard) -> None:
    """As a program does that was killed with its guard. A board that starts reads nothing yet."""

    def drive() -> bool:
        robot.disturb(CONFIGURE + drive_frame(MotorDrive.FORWARD))
        return robot.board.is_driving

    assert until(drive)


def assembled(robot: PtyBoard) -> Donnie:
    settings = Settings(robot=f"serial:{robot.path}", speech="off", sound=False)
    return assemble(settings, terminal=False)
