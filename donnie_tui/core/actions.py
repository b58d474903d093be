"""What each command of GoDonnie does: it asks the robot and publishes what happened, no more.

What is told about it, and with which sound, is decided in ``announcer``.
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import groupby, takewhile

from devices.ports.robot import Bearing, Motion, Pose, Robot, RobotProblem, Sighting, StoppedBy
from donnie_tui.core import poses
from donnie_tui.core.belt import BeltFeeling
from donnie_tui.core.events import (
    CueSounded,
    Moved,
    Passing,
    Read,
    Scanned,
    SeenGroup,
    SoundSwitched,
    Spoke,
    Turned,
    Waited,
)
from donnie_tui.core.handling import Handling, MovedThings
from donnie_tui.core.hub import Hub
from donnie_tui.core.outlets import UntilSaid
from donnie_tui.core.telling import History, Teller
from language.diagnostics import Kind, Refused
from language.syntax import Axis

LARGEST = 1_000_000_000
"""Steps, degrees or seconds that one command may ask for."""

_CUE_OF = {
    Motion.FORWARD: ("step-forward", 0.0),
    Motion.BACKWARD: ("step-back", 180.0),
    Motion.RIGHT: ("turn-right", 90.0),
    Motion.LEFT: ("turn-left", -90.0),
}


class RobotWatcher:
    """Turns a robot's progress into cues and moving pictures, and lets the belt follow it."""

    def __init__(self, hub: Hub) -> None:
        self._hub = hub
        self.belt: BeltFeeling | None = None
        """It asks the robot, which is made after its watcher."""

    def progressed(self, motion: Motion, pose: Pose) -> None:  # noqa: ARG002 -- the port gives the pose
        name, bearing = _CUE_OF[motion]
        self._hub.publish(CueSounded(name, bearing, None))
        if self.belt is not None:
            self.belt.felt()

    def passing(self, pose: Pose) -> None:
        self._hub.publish(Passing(pose))


class RobotActions:
    """The commands, done by one robot. Lives as long as the robot: the history and the switches stay."""

    def __init__(
        self,
        robot: Robot,
        hub: Hub,
        teller: Teller,
        belt: BeltFeeling,
        *,
        goes_on: Callable[[], bool],
        until_said: UntilSaid | None = None,
        moved_things: MovedThings = lambda: None,
    ) -> None:
        """``goes_on`` is asked in the midst of what may take long: False ends it."""
        self._robot = robot
        self._goes_on = goes_on
        self._hub = hub
        self._tell = teller
        self.past = History()
        self._belt = belt
        self.handling = Handling(robot, hub, teller, moved_things)
        self._said = until_said or UntilSaid()

    def forget(self) -> None:
        """Begin anew: no movement so far, the belt off."""
        self.past.forget()
        self._belt.forget()

    # --- telling

    def speak(self, what: int | str) -> None:
        self._hub.publish(Spoke(str(what)))
        self._said.wait(self._goes_on)

    def state(self) -> None:
        self._tell.state(self.past.last, self._robot.pose())

    def history(self) -> None:
        if self.past.last is None:
            self._tell.no_history(self._robot.pose())
        self._tell.history(takewhile(lambda _: self._goes_on(), self.past.movements))

    def tell_position(self) -> None:
        self._tell.position(self._robot.pose())

    def help(self, topic: str | None) -> None:
        self._tell.help(topic)

    def overwritten(self, name: str) -> None:
        self._tell.overwritten(name)

    # --- moving

    def forward(self, steps: int, command: str) -> None:
        self._walk(steps, command, forward=True)

    def backward(self, steps: int, command: str) -> None:
        self._walk(steps, command, forward=False)

    def turn_right(self, degrees: int, command: str) -> None:
        self._turn(degrees, command, right=True)

    def turn_left(self, degrees: int, command: str) -> None:
        self._turn(degrees, command, right=False)

    def wait(self, seconds: int) -> None:
        _refuse_beyond_limit(seconds)
        asked = max(0, seconds)
        self._tell.waiting(asked)
        before = self._robot.time()
        try:
            whole_time = self._robot.wait(asked)
        except RobotProblem as problem:
            raise _refused(problem) from None
        self._hub.publish(Waited(asked if whole_time else poses.whole(self._robot.time() - before)))

    def _walk(self, steps: int, command: str, *, forward: bool) -> None:
        _refuse_beyond_limit(steps)
        go = self._robot.forward if forward else self._robot.backward
        try:
            done = go(max(0, steps))
        except RobotProblem as problem:
            raise _refused(problem) from None
        event = Moved(command, steps, done.walked, done.stopped_by, done.pose, forward, done.met, done.pushed)
        self.past.remember(event)
        self._hub.publish(event)
        self.handling.tell_things()
        self._feel(done.stopped_by, Bearing.FRONT if forward else Bearing.BACK)
        _refuse_after_lost_link(done.stopped_by)

    def _turn(self, degrees: int, command: str, *, right: bool) -> None:
        _refuse_beyond_limit(degrees)
        try:
            done = self._robot.turn(degrees if right else -degrees)
        except RobotProblem as problem:
            raise _refused(problem) from None
        turned = done.turned if right else -done.turned
        event = Turned(command, degrees, turned, done.stopped_by, done.pose, right, done.met, done.pushed)
        self.past.remember(event)
        self._hub.publish(event)
        self.handling.tell_things()
        to_the_right = right == (degrees >= 0)
        self._feel(done.stopped_by, Bearing.FRONT_RIGHT if to_the_right else Bearing.FRONT_LEFT)
        _refuse_after_lost_link(done.stopped_by)

    def _feel(self, stopped_by: StoppedBy | None, ahead: Bearing) -> None:
        """What a movement came to, on the belt."""
        if stopped_by in (StoppedBy.COLLISION, StoppedBy.STALL):
            self._belt.bumped(ahead)
        self._belt.felt()

    # --- sensing

    def distance(self, bearing: Bearing) -> int:
        try:
            steps = self._robot.distance(bearing)
        except RobotProblem as problem:
            raise _refused(problem, bearing=bearing_name(bearing)) from None
        return self._read("distance", bearing_name(bearing), steps)

    def position(self, axis: Axis) -> int:
        pose = self._robot.pose()
        value = {
            Axis.X: poses.whole(pose.x),
            Axis.Y: poses.whole(pose.y),
            Axis.ANGLE: poses.heading(pose),
        }
        return self._read("position", axis.value, value[axis])

    def colour(self, colour: str) -> int:
        """A robot that tells no colours apart says so: none seen would be invented."""
        if not self._robot.colours:
            raise _refused(RobotProblem("no-camera"))
        seen = sum(each.colour == colour for each in self._look())
        return self._read("colour", colour, seen)

    def scan(self) -> None:
        self._hub.publish(Scanned(_groups(self._look())))

    def _look(self) -> tuple[Sighting, ...]:
        try:
            return self._robot.scan()
        except RobotProblem as problem:
            raise _refused(problem) from None

    def _read(self, sensor: str, argument: str, value: int) -> int:
        self._hub.publish(Read(sensor, argument, value))
        return value

    # --- switches

    def sound(self, on: bool) -> None:
        self._hub.publish(SoundSwitched(on))

    def belt(self, on: bool) -> None:
        self._tell.belt(on)
        self._belt.switch(on)

    def vibrate(self, bearing: Bearing) -> None:
        if not self._belt.is_on:
            raise Refused(Kind.BELT_OFF)
        self._belt.pulse(bearing)


def bearing_name(bearing: Bearing) -> str:
    """As events have it: ``front right``."""
    return bearing.name.lower().replace("_", " ")


def _refused(problem: RobotProblem, **values: str) -> Refused:
    """What the robot can't do, as the program's mistake; i18n has the sentence by the problem's code."""
    return Refused(Kind.ROBOT, **{**values, **problem.values, "problem": problem.code})


def _refuse_after_lost_link(stopped_by: StoppedBy | None) -> None:
    """A program whose movement lost the line has failed, even if there is nothing behind it."""
    if stopped_by is StoppedBy.LINK:
        raise _refused(RobotProblem("link-lost"))


def _refuse_beyond_limit(amount: int) -> None:
    if abs(amount) > LARGEST:
        raise Refused(Kind.NUMBER_TOO_LARGE, limit=LARGEST)


def _groups(sightings: tuple[Sighting, ...]) -> tuple[SeenGroup, ...]:
    """Things whose angles fall on the same five degrees are told together, the nearest distance first."""
    seen = sorted(sightings, key=lambda each: (_to_five(each.degrees), each.steps))
    return tuple(
        _group(angle, list(several)) for angle, several in groupby(seen, lambda each: _to_five(each.degrees))
    )


def _group(angle: int, several: list[Sighting]) -> SeenGroup:
    side = "left" if angle < 0 else "right" if angle > 0 else "ahead"
    nearest = min(poses.whole(each.steps) for each in several)
    return SeenGroup(side, abs(angle), nearest, tuple(each.colour for each in several))


def _to_five(degrees: float) -> int:
    """The nearest multiple of five; halfway goes away from straight ahead."""
    fives = int(abs(degrees) / 5 + 0.5)
    return 5 * fives if degrees > 0 else -5 * fives
