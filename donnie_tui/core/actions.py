"""What each command of GoDonnie does: it asks the robot and publishes what happened, no more.

What is told about it, and with which sound, is decided in ``announcer``.
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import groupby, takewhile

from devices.ports.robot import Bearing, Motion, Pose, Robot, Sighting
from donnie_tui.core import belt, numbers
from donnie_tui.core.events import (
    BeltShown,
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
from donnie_tui.core.history import History
from donnie_tui.core.hub import Hub
from donnie_tui.core.telling import Teller
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
    """Turns a robot's progress into cues and moving pictures."""

    def __init__(self, hub: Hub) -> None:
        self._hub = hub

    def progressed(self, motion: Motion, pose: Pose) -> None:  # noqa: ARG002 -- the port gives the pose
        name, bearing = _CUE_OF[motion]
        self._hub.publish(CueSounded(name, bearing, None))

    def passing(self, pose: Pose) -> None:
        self._hub.publish(Passing(pose))


class RobotActions:
    """The commands, done by one robot. Lives as long as the robot: the history and the switches stay."""

    def __init__(self, robot: Robot, hub: Hub, teller: Teller, *, goes_on: Callable[[], bool]) -> None:
        """``goes_on`` is asked in the midst of what may take long: False ends it."""
        self._robot = robot
        self._goes_on = goes_on
        self._hub = hub
        self._tell = teller
        self.past = History()
        self._belt_on = False

    def forget(self) -> None:
        """Begin anew: no movement so far, the belt off."""
        self.past.forget()
        self._belt_on = False

    # --- telling

    def speak(self, what: int | str) -> None:
        self._hub.publish(Spoke(str(what)))

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
        whole_time = self._robot.wait(asked)
        self._hub.publish(Waited(asked if whole_time else numbers.whole(self._robot.time() - before)))

    def _walk(self, steps: int, command: str, *, forward: bool) -> None:
        _refuse_beyond_limit(steps)
        go = self._robot.forward if forward else self._robot.backward
        done = go(max(0, steps))
        event = Moved(command, steps, done.walked, done.stopped_by, done.pose, forward)
        self.past.remember(event)
        self._hub.publish(event)

    def _turn(self, degrees: int, command: str, *, right: bool) -> None:
        _refuse_beyond_limit(degrees)
        done = self._robot.turn(degrees if right else -degrees)
        turned = done.turned if right else -done.turned
        event = Turned(command, degrees, turned, done.stopped_by, done.pose, right)
        self.past.remember(event)
        self._hub.publish(event)

    # --- sensing

    def distance(self, bearing: Bearing) -> int:
        return self._read("distance", bearing.name.lower().replace("_", " "), self._robot.distance(bearing))

    def position(self, axis: Axis) -> int:
        pose = self._robot.pose()
        value = {
            Axis.X: numbers.whole(pose.x),
            Axis.Y: numbers.whole(pose.y),
            Axis.ANGLE: numbers.heading(pose),
        }
        return self._read("position", axis.value, value[axis])

    def colour(self, colour: str) -> int:
        seen = sum(each.colour == colour for each in self._robot.scan())
        return self._read("colour", colour, seen)

    def scan(self) -> None:
        self._hub.publish(Scanned(_groups(self._robot.scan())))

    def _read(self, sensor: str, argument: str, value: int) -> int:
        self._hub.publish(Read(sensor, argument, value))
        return value

    # --- switches

    def sound(self, on: bool) -> None:
        self._hub.publish(SoundSwitched(on))

    def belt(self, on: bool) -> None:
        self._belt_on = on
        self._tell.belt(on)
        if not on:
            self._hub.publish(BeltShown(belt.OFF))

    def vibrate(self, bearing: Bearing) -> None:
        if not self._belt_on:
            raise Refused(Kind.BELT_OFF)
        self._hub.publish(BeltShown(belt.pulse(bearing)))
        self._hub.publish(BeltShown(belt.OFF))


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
    nearest = min(numbers.whole(each.steps) for each in several)
    return SeenGroup(side, abs(angle), nearest, tuple(each.colour for each in several))


def _to_five(degrees: float) -> int:
    """The nearest multiple of five; halfway goes away from straight ahead."""
    fives = int(abs(degrees) / 5 + 0.5)
    return 5 * fives if degrees > 0 else -5 * fives
