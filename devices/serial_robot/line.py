"""What the robot needs of a line: ``devices.serial_link`` is one on a port, the double's is one without."""

from __future__ import annotations

from typing import Protocol

from devices.wire.commands import Drive
from devices.wire.link_state import LinkState
from devices.wire.telemetry import Telemetry


class RobotLine(Protocol):
    """A line to a board. Every method may be called from any thread and returns at once, but four."""

    @property
    def name(self) -> str:
        """The port, as it is told to a person."""

    @property
    def state(self) -> LinkState: ...

    @property
    def telemetry(self) -> Telemetry: ...

    @property
    def driving_since(self) -> float | None:
        """When the wheels were told to turn; None while they are to stand."""

    def now(self) -> float:
        """Seconds, from a start of its own, never back."""

    def permit(self) -> int:
        """To be named with each drive; void once anybody stops the robot or the line is lost."""

    def drive(self, permit: int, drive: Drive, until: float) -> bool:
        """See ``Connection.drive``. False if the permit is void."""

    def stop(self) -> None:
        """Wheels off, at once. Never raises."""

    def put(self, frame: bytes) -> None:
        """Have a frame sent when there is time."""

    def connect(self) -> None:
        """Open the port and wait for the board, some six seconds at most. Raises RobotProblem."""

    def give_up(self) -> None:
        """Have ``connect`` end at once, with the problem ``given-up``. Any thread, a signal's handler too."""

    def wait_until_standing(self) -> None:
        """Until the robot stands after a stop, or all was done that can be: some 1.3 seconds at most, at once
        if it stands. A line whose time goes on only while it is driven returns at once."""

    def wait_until_told(self) -> None:
        """Until what was to be told of the line was heard, half a second at most."""

    def close(self) -> None:
        """Stop the robot, wait until it stands, let go of the port. Never raises."""
