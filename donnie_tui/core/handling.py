"""The things of the world, as far as a robot moves them: gripping, releasing, pushing.

GoDonnie has no words for the gripper: a front end asks for it, as for a run of its own, so that it has its
place among what happens.
"""

from __future__ import annotations

from collections.abc import Callable
from enum import Enum

from devices.ports.hints import Protocol, TypeAlias, TypeGuard
from devices.ports.robot import Gripped, Robot, RobotProblem
from donnie_tui.core.events import GripperUsed, PlacedThing, ThingsMoved
from donnie_tui.core.hub import Hub
from donnie_tui.core.telling import Teller
from language.control import ExecutionControl
from language.runtime import Actions, Frame, Memory, Trace

MovedThings: TypeAlias = Callable[[], tuple[PlacedThing, ...] | None]
"""Where things are that are not at their start; None if that is as it was when it was last asked."""


class Gripping(Protocol):
    """A robot that may have a gripper."""

    def grip(self) -> Gripped:
        """Take what is between the paddles, or just before them. Raises ``RobotProblem``."""

    def release(self) -> Gripped: ...


def _has_gripper(robot: object) -> TypeGuard[Gripping]:
    return hasattr(robot, "grip")


class Handling:
    """One robot's."""

    def __init__(self, robot: Robot, hub: Hub, teller: Teller, moved_things: MovedThings) -> None:
        self._robot = robot
        self._hub = hub
        self._tell = teller
        self._moved_things = moved_things

    def use_gripper(self, deed: Deed) -> None:
        """Do it, and tell what came of it; that there is no gripper, too."""
        try:
            done = self._gripped(deed)
        except RobotProblem as problem:
            self._tell.announce("gripper", f"problem-{problem.code}")
            return
        self._hub.publish(GripperUsed(done.outcome, done.name, done.kind, done.colour))
        self.tell_things()

    def _gripped(self, deed: Deed) -> Gripped:
        robot = self._robot
        if not _has_gripper(robot):
            raise RobotProblem("no-gripper")
        return robot.grip() if deed is Deed.GRIP else robot.release()

    def tell_things(self) -> None:
        """Where things are now, if that has changed; behind a fresh start too, which may put them back."""
        places = self._moved_things()
        if places is not None:
            self._hub.publish(ThingsMoved(places))


class Deed(Enum):
    """What a front end may ask of a gripper; the values are what the run is called."""

    GRIP = "GRIP"
    RELEASE = "RELEASE"


class DeedRun:
    """A deed, to be run as programs are."""

    def __init__(self, deed: Deed, handling: Handling) -> None:
        self._deed = deed
        self._handling = handling

    def run(
        self,
        actions: Actions,  # noqa: ARG002 -- as of every program
        control: ExecutionControl,
        memory: Memory,  # noqa: ARG002
        *,
        trace: Trace | None = None,  # noqa: ARG002
    ) -> None:
        self._handling.use_gripper(self._deed)
        control.ended()

    def frames(self) -> tuple[Frame, ...]:
        """Nothing of GoDonnie runs."""
        return ()
