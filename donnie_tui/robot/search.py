"""Looking for a robot takes some seconds, and whoever waits may give it up. Imports nothing that takes time.

Rule: nothing here takes a lock, for it is called by a signal's handler in the midst of anything.
"""

from __future__ import annotations

from collections.abc import Callable

from devices.ports.hints import Protocol


class Searchable(Protocol):
    """A robot with a line."""

    def connect(self) -> None:
        """Raises ``RobotProblem``."""

    def give_up(self) -> None:
        """Have ``connect`` end at once."""


class Search:
    """For one session's robot, each time that it changes."""

    def __init__(self, *, is_coming: bool = False) -> None:
        """``is_coming``: as after ``expect``."""
        self._is_coming = is_coming
        self._is_given_up = False
        self._robot: Searchable | None = None
        self.on_slow: Callable[[], object] = _nothing
        """Tells that it goes on, where it takes longer than a second; in the thread that connects."""

    def expect(self) -> None:
        """It begins soon, and may be given up before. ``end`` is to follow."""
        self._is_coming = True

    def give_up(self) -> bool:
        """Whether there was anything to give up. Any thread."""
        robot = self._robot
        if robot is None and not self._is_coming:
            return False
        self._is_given_up = True
        if robot is not None:
            robot.give_up()
        return True

    def connect(self, robot: Searchable) -> None:
        """Raises ``RobotProblem``, ``given-up`` among them."""
        self._robot = robot
        if self._is_given_up:
            robot.give_up()
        robot.connect()

    def end(self) -> None:
        """Whatever came of it."""
        self._is_coming, self._robot = False, None
        self._is_given_up = False


def _nothing() -> None: ...
