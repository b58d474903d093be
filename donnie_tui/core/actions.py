"""The commands of GoDonnie that a robot carries out.

``RobotActions`` asks the robot and publishes what happened, no more. ``Announcer`` decides which sentences
and cues follow. ``LoopHints`` notices loops that get nowhere: walks that can't begin, and a wait for a wall
that isn't there. It gives each hint once a run.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from itertools import groupby, takewhile
from typing import TypeAlias, TypeGuard

from devices.ports.robot import (
    Bearing,
    Gripping,
    GripResult,
    KnowsItsWorld,
    Motion,
    NamedRangers,
    Pose,
    Robot,
    RobotProblem,
    Sighting,
    StoppedBy,
)
from donnie_tui.core.belt import BeltDisplay
from donnie_tui.core.events import (
    CueSounded,
    GripperUsed,
    Moved,
    Passing,
    PlacedThing,
    Read,
    Scanned,
    SeenGroup,
    SeenMark,
    SoundSwitched,
    Spoke,
    ThingsMoved,
    Turned,
    Waited,
)
from donnie_tui.core.hub import Hub
from donnie_tui.core.transcript import History, SentencePublisher
from donnie_tui.core.voice import SpeechWait
from donnie_tui.core.wording import compass_heading, whole_steps
from language.diagnostics import ActionRefused, MistakeKind
from language.source import fold_name
from language.syntax import Axis

MovedThings: TypeAlias = Callable[[], tuple[PlacedThing, ...] | None]
"""Returns the things that are not at their start; None if nothing changed since the last call."""


def _names_rangers(robot: object) -> TypeGuard[NamedRangers]:
    return hasattr(robot, "named_distance")


def _has_gripper(robot: object) -> TypeGuard[Gripping]:
    return hasattr(robot, "grip")


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
        self.belt: BeltDisplay | None = None
        """This and ``on_problem`` are set after construction: they need the robot, and it its watcher."""
        self.on_problem: Callable[[RobotProblem], None] | None = None

    def progressed(self, motion: Motion, pose: Pose) -> None:  # noqa: ARG002 -- the port gives the pose
        name, bearing = _CUE_OF[motion]
        self._hub.publish(CueSounded(name, bearing, None))
        if self.belt is not None:
            self.belt.update()

    def passing(self, pose: Pose) -> None:
        self._hub.publish(Passing(pose))

    def sense_failed(self, problem: RobotProblem) -> None:
        if self.on_problem is not None:
            self.on_problem(problem)


class RobotActions:
    """One robot's commands. Lives as long as the robot, so that history and switches stay."""

    def __init__(
        self,
        robot: Robot,
        hub: Hub,
        sentences: SentencePublisher,
        belt: BeltDisplay,
        *,
        may_continue: Callable[[], bool],
        speech_wait: SpeechWait | None = None,
        moved_things: MovedThings = lambda: None,
    ) -> None:
        """``may_continue`` is called during long commands; False ends them."""
        self._robot = robot
        self._may_continue = may_continue
        self._hub = hub
        self._sentences = sentences
        self.past = History()
        self._belt = belt
        self._loop_hints = LoopHints(robot, sentences)
        self._moved_things = moved_things
        self._speech_wait = speech_wait or SpeechWait()
        self._announced: set[str] = set()
        """The codes of the problems that were announced in this run."""

    def begin_run(self) -> None:
        """Forgets which problems and hints this run has announced."""
        self._announced.clear()
        self._loop_hints.begin_run()

    def announce_problem(self, problem: RobotProblem) -> None:
        """Announces a problem once a run, although a loop meets it again and again."""
        if problem.code not in self._announced:
            self._announced.add(problem.code)
            self._sentences.announce("camera", f"problem-{problem.code}", **problem.values)

    def forget(self) -> None:
        """Clears the history and switches the belt off."""
        self.past.forget()
        self._belt.forget()

    # --- sentences

    def speak(self, what: int | str) -> None:
        self._hub.publish(Spoke(str(what)))
        self._speech_wait.wait(self._may_continue)

    def state(self) -> None:
        self._say_movements("state", tuple(self.past.movements)[-1:])

    def history(self) -> None:
        if self.past.forgotten:
            self._sentences.announce("history", "history-forgotten", count=self.past.forgotten)
        self._say_movements("history", takewhile(lambda _: self._may_continue(), self.past.movements))

    def _say_movements(self, code: str, movements: Iterable[tuple[int, Moved | Turned]]) -> None:
        if not self.past.movements:
            self._sentences.no_movement(code, self._robot.pose())
        for number, event in movements:
            self._sentences.movement(code, number, event)

    def announce_pose(self) -> None:
        self._sentences.place("position", self._robot.pose())

    def help(self, topic: str | None) -> None:
        self._sentences.help(topic)

    def overwritten(self, name: str) -> None:
        self._sentences.announce("hint", "overwritten", name=name)

    # --- the gripper

    def grip(self) -> None:
        """Closes the gripper and publishes the result, even if the robot has none."""
        self._use_gripper(lambda gripper: gripper.grip())

    def release(self) -> None:
        """Opens the gripper, as ``grip`` closes it."""
        self._use_gripper(lambda gripper: gripper.release())

    def _use_gripper(self, command: Callable[[Gripping], GripResult]) -> None:
        try:
            if not _has_gripper(self._robot):
                raise RobotProblem("no-gripper")
            done = command(self._robot)
        except RobotProblem as problem:
            self._sentences.announce("no-gripper", f"problem-{problem.code}")
            return
        self._hub.publish(GripperUsed(done.outcome, done.name, done.kind, done.colour))
        self.publish_things()

    def publish_things(self) -> None:
        """Publishes the places of things if they changed, also after a fresh start."""
        places = self._moved_things()
        if places is not None:
            self._hub.publish(ThingsMoved(places))

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
        if asked:
            self._sentences.announce("waiting", seconds=asked)
        before = self._robot.time()
        try:
            whole_time = self._robot.wait(asked)
        except RobotProblem as problem:
            raise _refused(problem) from None
        self._hub.publish(Waited(asked if whole_time else whole_steps(self._robot.time() - before)))

    def _walk(self, steps: int, command: str, *, forward: bool) -> None:
        _refuse_beyond_limit(steps)
        go = self._robot.forward if forward else self._robot.backward
        try:
            done = go(max(0, steps))
        except RobotProblem as problem:
            raise _refused(problem) from None
        event = Moved(
            command,
            steps,
            done.walked,
            done.stopped_by,
            done.pose,
            forward,
            done.met,
            done.pushed,
            self._robot.true_pose(),
        )
        self._publish_movement(event, Bearing.FRONT if forward else Bearing.BACK)
        self._loop_hints.walked(event)

    def _turn(self, degrees: int, command: str, *, right: bool) -> None:
        _refuse_beyond_limit(degrees)
        try:
            done = self._robot.turn(degrees if right else -degrees)
        except RobotProblem as problem:
            raise _refused(problem) from None
        turned = done.turned if right else -done.turned
        event = Turned(
            command,
            degrees,
            turned,
            done.stopped_by,
            done.pose,
            right,
            done.met,
            done.pushed,
            self._robot.true_pose(),
        )
        to_the_right = right == (degrees >= 0)
        self._publish_movement(event, Bearing.FRONT_RIGHT if to_the_right else Bearing.FRONT_LEFT)

    def _publish_movement(self, event: Moved | Turned, ahead: Bearing) -> None:
        """Publishes a movement and what it pushed, and updates the belt. Raises if no movement can follow."""
        self.past.remember(event)
        self._hub.publish(event)
        self.publish_things()
        if event.stopped_by in (StoppedBy.COLLISION, StoppedBy.STALL):
            self._belt.show_bump(ahead)
        self._belt.update()
        if event.stopped_by in _FATAL:
            raise _refused(RobotProblem(_FATAL[event.stopped_by]))

    # --- sensing

    def distance(self, bearing: Bearing) -> int:
        try:
            steps = self._robot.distance(bearing)
        except RobotProblem as problem:
            raise _refused(problem, bearing=bearing.words) from None
        value = self._read("distance", bearing.words, steps)
        self._loop_hints.read(bearing)
        return value

    def named_distance(self, name: str) -> int:
        robot = self._robot
        names = robot.ranger_names if _names_rangers(robot) else ()
        called = next((each for each in names if fold_name(each) == fold_name(name)), None)
        if called is None or not _names_rangers(robot):
            code = "no-ranger" if names else "no-named-rangers"
            raise _refused(RobotProblem(code, name=name, names=", ".join(names)))
        try:
            return self._read("distance", called, robot.named_distance(called))
        except RobotProblem as problem:
            raise _refused(problem) from None

    def position(self, axis: Axis) -> int:
        pose = self._robot.pose()
        value = {
            Axis.X: whole_steps(pose.x),
            Axis.Y: whole_steps(pose.y),
            Axis.ANGLE: compass_heading(pose),
        }
        return self._read("position", axis.value, value[axis])

    def colour(self, colour: str) -> int:
        """Counts things of a colour. A robot that can't see colours says so, and counts none."""
        if not self._robot.colours:
            self.announce_problem(RobotProblem("no-camera"))
            return self._read("colour", colour, 0)
        seen = sum(each.colour == colour for each in self._look())
        return self._read("colour", colour, seen)

    def scan(self) -> None:
        seen = self._look()
        marks = tuple(_seen_mark(each) for each in seen if each.mark is not None)
        self._hub.publish(Scanned(_groups(tuple(each for each in seen if each.mark is None)), marks))

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
        self._sentences.announce("belt", "belt-on" if on else "belt-off")
        self._belt.switch(on)

    def vibrate(self, bearing: Bearing) -> None:
        if not self._belt.is_on:
            raise ActionRefused(MistakeKind.BELT_OFF)
        self._belt.pulse(bearing)


def _refused(problem: RobotProblem, **values: str) -> ActionRefused:
    """The robot's problem as a mistake of the program; its code maps to a sentence in i18n."""
    return ActionRefused(MistakeKind.ROBOT, **{**values, **problem.values, "problem": problem.code})


_FATAL = {
    StoppedBy.LINK: "link-lost",
    StoppedBy.WRONG_WAY: "wrong-way",
    StoppedBy.RUNAWAY: "runaway",
}
"""Ends of a movement that make every later one wrong, and the codes of their problems."""


def _refuse_beyond_limit(amount: int) -> None:
    if abs(amount) > LARGEST:
        raise ActionRefused(MistakeKind.NUMBER_TOO_LARGE, limit=LARGEST)


def _groups(sightings: tuple[Sighting, ...]) -> tuple[SeenGroup, ...]:
    """Groups things whose angles round to the same five degrees, with the nearest distance first."""
    seen = sorted(sightings, key=lambda each: (_to_five(each.degrees), each.steps))
    return tuple(
        _group(angle, list(several)) for angle, several in groupby(seen, lambda each: _to_five(each.degrees))
    )


def _seen_mark(sighting: Sighting) -> SeenMark:
    angle = _to_five(sighting.degrees)
    return SeenMark(sighting.mark or None, _side(angle), abs(angle), whole_steps(sighting.steps))


def _side(angle: int) -> str:
    return "left" if angle < 0 else "right" if angle > 0 else "ahead"


def _group(angle: int, several: list[Sighting]) -> SeenGroup:
    nearest = min(whole_steps(each.steps) for each in several)
    return SeenGroup(_side(angle), abs(angle), nearest, tuple(each.colour for each in several))


def _to_five(degrees: float) -> int:
    """The nearest multiple of five; halves round away from straight ahead."""
    fives = int(abs(degrees) / 5 + 0.5)
    return 5 * fives if degrees > 0 else -5 * fives


HINT_AFTER_WALKS = 3
"""Walks of 0 steps by one command, without another walk between them."""
HINT_AFTER_READINGS = 200
"""Readings of one distance."""


def _knows_its_world(robot: object) -> TypeGuard[KnowsItsWorld]:
    return hasattr(robot, "is_in_the_open")


class LoopHints:
    """Counts one robot's walks and readings in a run."""

    def __init__(self, robot: Robot, sentences: SentencePublisher) -> None:
        self._robot = robot
        self._sentences = sentences
        self._command = ""
        self.begin_run()

    def begin_run(self) -> None:
        self._walks = 0
        self._readings: dict[Bearing, int] = {}

    def walked(self, moved: Moved) -> None:
        is_blocked = moved.asked > 0 and moved.walked == 0
        if not is_blocked or moved.command != self._command:
            self._walks = 0
        self._walks += is_blocked
        self._command = moved.command
        if self._walks == HINT_AFTER_WALKS:
            ahead = Bearing.FRONT if moved.forward else Bearing.BACK
            steps = self._robot.known_distances().get(ahead)
            if steps is not None:
                self._sentences.announce("hint", "hint-no-nearer", steps=steps)

    def read(self, bearing: Bearing) -> None:
        self._readings[bearing] = self._readings.get(bearing, 0) + 1
        if self._readings[bearing] != HINT_AFTER_READINGS or not _knows_its_world(self._robot):
            return
        if self._robot.is_in_the_open:
            self._sentences.announce("hint", "hint-no-wall")
