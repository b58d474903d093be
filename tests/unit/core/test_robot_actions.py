"""The commands of a robot: what is published, in which order, and where the limits are."""

from __future__ import annotations

from types import SimpleNamespace as Part
from typing import Any

import pytest

from devices.ports.robot import (
    Bearing,
    Grip,
    GripResult,
    Met,
    Motion,
    Pose,
    Pushed,
    RobotProblem,
    Sighting,
    StoppedBy,
    TurnResult,
    WalkResult,
)
from donnie_tui.core.actions import LoopHints, RobotActions, RobotWatcher
from donnie_tui.core.events import (
    CueSounded,
    GripperUsed,
    Moved,
    Passing,
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
from donnie_tui.core.transcript import History
from language.diagnostics import ActionRefused, MistakeKind
from language.syntax import Axis

HERE, TRUE = Pose(2.4, -3.6, 361.6), Pose(9, 9, 9)
MET, PUSHED = Met("chair", "", 10.0), (Pushed("cone", "", "red", 2.0),)


class Actions:
    """``RobotActions`` on a robot that does what it is to, and all that they do in its order."""

    def __init__(self, **robot: Any) -> None:
        self.done: list[Any] = []
        named = {
            "time": lambda: 1.0, "pose": lambda: HERE, "true_pose": lambda: TRUE, "colours": ("red",),
            "known_distances": lambda: {Bearing.FRONT: 3, Bearing.BACK: 4},
        }  # fmt: skip
        self.robot: Any = Part(**{**named, **robot})
        hub: Any = Part(publish=self.done.append)
        sentences: Any = Part(
            announce=self.announce,
            **{name: self.noted(name) for name in ("place", "help", "movement", "no_movement")},
        )
        belt: Any = Part(
            is_on=True,
            **{
                name: self.noted(f"belt {name}")
                for name in ("show_bump", "update", "switch", "pulse", "forget")
            },
        )
        self.belt = belt
        self.actions = RobotActions(
            self.robot, hub, sentences, belt, may_continue=lambda: True, moved_things=lambda: ("things",)  # type: ignore[arg-type, return-value]
        )  # fmt: skip

    def announce(self, *codes: str, **values: object) -> None:
        self.done.append((*codes, values))

    def noted(self, name: str) -> Any:
        return lambda *values: self.done.append((name, *values))


def fail(code: str = "deaf", **values: str) -> Any:
    def failing(*_: object) -> None:
        raise RobotProblem(code, **values)

    return failing


def refusal(do: Any) -> tuple[object, dict[str, Any]]:
    with pytest.raises(ActionRefused) as refused:
        do()
    return refused.value.kind, dict(refused.value.details)


# --- moving


@pytest.mark.parametrize(("name", "is_forward", "bump"), [("forward", True, 0), ("backward", False, 180)])
@pytest.mark.parametrize("stopped_by", [None, StoppedBy.OBSTACLE, StoppedBy.COLLISION, StoppedBy.STALL])
def test_a_walk_is_published_then_what_it_pushed_then_shown_on_the_belt(
    name: str, is_forward: bool, bump: int, stopped_by: StoppedBy | None
) -> None:
    asked: list[int] = []

    def go(steps: int) -> WalkResult:
        asked.append(steps)
        return WalkResult(steps, 3, stopped_by, HERE, MET, PUSHED)

    it = Actions(**{name: go})
    getattr(it.actions, name)(-5, "FW -5")
    getattr(it.actions, name)(5, "FW 5")
    side = Bearing.FRONT if is_forward else Bearing.BACK
    is_bump = stopped_by in (StoppedBy.COLLISION, StoppedBy.STALL)

    assert asked == [0, 5]
    assert it.done[len(it.done) // 2 :] == [
        Moved("FW 5", 5, 3, stopped_by, HERE, is_forward, MET, PUSHED, TRUE),
        ThingsMoved(("things",)),  # type: ignore[arg-type]
        *([("belt show_bump", side)] if is_bump else []),
        ("belt update",),
    ]
    assert it.actions.past.movements[-1] == (2, it.done[len(it.done) // 2])


@pytest.mark.parametrize(
    ("name", "asked", "to_robot", "side"),
    [
        ("turn_right", 90, 90, Bearing.FRONT_RIGHT),
        ("turn_right", 0, 0, Bearing.FRONT_RIGHT),
        ("turn_right", -90, -90, Bearing.FRONT_LEFT),
        ("turn_left", 90, -90, Bearing.FRONT_LEFT),
        ("turn_left", -90, 90, Bearing.FRONT_RIGHT),
    ],
)
def test_a_turn_counts_in_the_direction_of_its_command(
    name: str, asked: int, to_robot: int, side: Bearing
) -> None:
    turns: list[int] = []

    def turn(degrees: int) -> TurnResult:
        turns.append(degrees)
        return TurnResult(degrees, degrees, StoppedBy.COLLISION, HERE, MET, PUSHED)

    it = Actions(turn=turn)
    getattr(it.actions, name)(asked, "TR")
    is_right = name == "turn_right"

    assert turns == [to_robot]
    assert it.done == [
        Turned("TR", asked, asked, StoppedBy.COLLISION, HERE, is_right, MET, PUSHED, TRUE),
        ThingsMoved(("things",)),  # type: ignore[arg-type]
        ("belt show_bump", side),
        ("belt update",),
    ]


@pytest.mark.parametrize(
    ("stopped_by", "problem"),
    [
        (StoppedBy.LINK, "link-lost"),
        (StoppedBy.WRONG_WAY, "wrong-way"),
        (StoppedBy.RUNAWAY, "runaway"),
    ],
)
def test_after_some_ends_of_a_movement_no_other_can_follow(stopped_by: StoppedBy, problem: str) -> None:
    it = Actions(forward=lambda steps: WalkResult(steps, 0, stopped_by, HERE))

    assert refusal(lambda: it.actions.forward(1, "FW 1")) == (MistakeKind.ROBOT, {"problem": problem})
    assert it.done[-1] == ("belt update",)


@pytest.mark.parametrize("name", ["forward", "backward", "turn_right", "turn_left", "wait"])
def test_what_the_robot_can_not_do_is_refused_with_its_problem_and_too_large_numbers_before(
    name: str,
) -> None:
    port = "turn" if name.startswith("turn") else name
    it = Actions(**{port: fail("deaf", why="so")})
    rest = () if name == "wait" else ("X",)
    do = getattr(it.actions, name)
    known = (MistakeKind.ROBOT, {"why": "so", "problem": "deaf"})

    assert refusal(lambda: do(1, *rest)) == refusal(lambda: do(10**9, *rest)) == known
    assert refusal(lambda: do(-(10**9), *rest)) == known
    too_large = (MistakeKind.NUMBER_TOO_LARGE, {"limit": 10**9})
    assert refusal(lambda: do(10**9 + 1, *rest)) == refusal(lambda: do(-(10**9) - 1, *rest)) == too_large


@pytest.mark.parametrize(
    ("asked", "is_whole", "waited"), [(5, True, 5), (5, False, 3), (-5, True, 0), (0, True, 0)]
)
def test_a_wait_that_is_cut_short_is_as_long_as_it_was(asked: int, is_whole: bool, waited: int) -> None:
    times = iter((10.0, 13.4))
    it = Actions(wait=lambda _: is_whole, time=lambda: next(times))
    it.actions.wait(asked)

    assert it.done == [*([("waiting", {"seconds": asked})] if asked > 0 else []), Waited(waited)]


# --- sensing


def test_a_reading_is_published_with_its_sensor_and_its_argument() -> None:
    it = Actions(distance=lambda _: 7, scan=lambda: SEEN)
    actions = it.actions

    assert actions.distance(Bearing.FRONT_LEFT) == 7
    assert [actions.position(axis) for axis in (Axis.X, Axis.Y, Axis.ANGLE)] == [2, -3, 1]
    assert actions.colour("red") == 2
    assert actions.colour("blue") == 1
    assert it.done == [
        Read("distance", Bearing.FRONT_LEFT.words, 7),
        *(Read("position", Axis.X.value, 2), Read("position", Axis.Y.value, -3)),
        Read("position", Axis.ANGLE.value, 1),
        *(Read("colour", "red", 2), Read("colour", "blue", 1)),
    ]


SEEN = (
    Sighting(2.4, 5.6, "red", ""),
    Sighting(-2.4, 4.4, "blue", ""),
    Sighting(-2.5, 9.0, "red", ""),
    Sighting(12.5, 3.0, "", "", 4),
    Sighting(-7.4, 3.6, "", "", 0),
)


def test_what_is_seen_is_grouped_by_five_degrees_and_marks_are_apart() -> None:
    it = Actions(scan=lambda: SEEN)
    it.actions.scan()

    assert it.done == [
        Scanned(
            (SeenGroup("left", 5, 9, ("red",)), SeenGroup("ahead", 0, 4, ("blue", "red"))),
            (SeenMark(4, "right", 15, 3), SeenMark(None, "left", 5, 3)),
        )
    ]


def test_sensors_that_fail_refuse_the_command() -> None:
    it = Actions(distance=fail(), scan=fail(), ranger_names=("Nose",), named_distance=fail())

    assert refusal(lambda: it.actions.distance(Bearing.FRONT)) == (
        *(MistakeKind.ROBOT, {"bearing": Bearing.FRONT.words, "problem": "deaf"}),
    )
    for do in (it.actions.scan, lambda: it.actions.colour("red"), lambda: it.actions.named_distance("nose")):
        assert refusal(do) == (MistakeKind.ROBOT, {"problem": "deaf"})


def test_a_named_ranger_is_found_in_any_case_and_an_unknown_one_refused_with_the_names() -> None:
    it = Actions(ranger_names=("Nose", "Tail"), named_distance=lambda name: len(name))

    assert it.actions.named_distance("NÓSE") == 4
    assert it.done == [Read("distance", "Nose", 4)]
    assert refusal(lambda: it.actions.named_distance("ear")) == (
        *(MistakeKind.ROBOT, {"name": "ear", "names": "Nose, Tail", "problem": "no-ranger"}),
    )
    for robot in (Actions(), Actions(ranger_names=(), named_distance=fail())):
        assert refusal(lambda robot=robot: robot.actions.named_distance("ear")) == (
            *(MistakeKind.ROBOT, {"name": "ear", "names": "", "problem": "no-named-rangers"}),
        )


def test_a_robot_without_a_camera_says_so_once_a_run_and_counts_none() -> None:
    it = Actions(colours=())
    none, said = Read("colour", "red", 0), ("camera", "problem-no-camera", {})
    assert [it.actions.colour("red") for _ in range(2)] == [0, 0]
    assert it.done == [said, none, none]

    it.done.clear()
    it.actions.begin_run()
    it.actions.colour("red")
    assert it.done == [said, none]


# --- the gripper, switches, sentences


def test_the_gripper_publishes_what_it_did_or_that_there_is_none() -> None:
    it = Actions(
        grip=lambda: GripResult(Grip.GRIPPED, "n", "k", "red"),
        release=lambda: GripResult(Grip.RELEASED, "n", "k", "red"),
    )
    it.actions.grip()
    it.actions.release()
    things = ThingsMoved(("things",))  # type: ignore[arg-type]
    assert it.done == [
        *(GripperUsed(Grip.GRIPPED, "n", "k", "red"), things),
        *(GripperUsed(Grip.RELEASED, "n", "k", "red"), things),
    ]

    for robot, code in (
        (Actions(), "no-gripper"),
        (Actions(grip=fail("stuck"), release=fail("stuck")), "stuck"),
    ):
        robot.actions.grip()
        robot.actions.release()
        assert robot.done == [("no-gripper", f"problem-{code}", {})] * 2


def test_sentences_and_switches_go_where_they_belong() -> None:
    it = Actions()
    actions = it.actions
    actions.speak(3)
    actions.sound(False)
    actions.belt(True)
    actions.belt(False)
    actions.vibrate(Bearing.BACK_LEFT)
    actions.help("FW")
    actions.overwritten("a")
    actions.announce_pose()
    actions.state()
    actions.forget()

    assert it.done == [
        *(Spoke("3"), SoundSwitched(False)),
        *(("belt", "belt-on", {}), ("belt switch", True), ("belt", "belt-off", {}), ("belt switch", False)),
        *(("belt pulse", Bearing.BACK_LEFT), ("help", "FW"), ("hint", "overwritten", {"name": "a"})),
        *(("place", "position", HERE), ("no_movement", "state", HERE), ("belt forget",)),
    ]
    it.done.clear()
    it.belt.is_on = False
    assert refusal(lambda: actions.vibrate(Bearing.BACK_LEFT))[0] == MistakeKind.BELT_OFF
    assert it.done == []


def test_the_state_is_the_last_movement_and_the_history_all_after_how_many_are_forgotten() -> None:
    it = Actions(forward=lambda steps: WalkResult(steps, steps, None, HERE))
    it.actions.past = History(2)
    said = []
    for steps in range(4):
        if steps:
            it.actions.forward(steps, f"FW {steps}")
        for say in (it.actions.state, it.actions.history):
            it.done.clear()
            say()
            said.append(it.done.copy())
    one, two, three = (
        Moved(f"FW {each}", each, each, None, HERE, True, true_pose=TRUE) for each in (1, 2, 3)
    )

    assert said == [
        *([("no_movement", "state", HERE)], [("no_movement", "history", HERE)]),
        *([("movement", "state", 1, one)], [("movement", "history", 1, one)]),
        [("movement", "state", 2, two)],
        [("movement", "history", 1, one), ("movement", "history", 2, two)],
        [("movement", "state", 3, three)],
        [
            ("history", "history-forgotten", {"count": 1}),
            *(("movement", "history", 2, two), ("movement", "history", 3, three)),
        ],
    ]


def test_a_history_ends_when_the_program_may_not_continue() -> None:
    it = Actions(forward=lambda steps: WalkResult(steps, steps, None, HERE))
    for steps in (1, 2, 3):
        it.actions.forward(steps, f"FW {steps}")
    it.done.clear()
    may_continue = iter((True, True, False))
    it.actions._may_continue = lambda: next(may_continue)
    it.actions.history()
    assert [each[:3] for each in it.done] == [("movement", "history", 1), ("movement", "history", 2)]


# --- what a robot reports on its way


@pytest.mark.parametrize(
    ("motion", "name", "bearing"),
    [
        (Motion.FORWARD, "step-forward", 0.0),
        (Motion.BACKWARD, "step-back", 180.0),
        (Motion.RIGHT, "turn-right", 90.0),
        (Motion.LEFT, "turn-left", -90.0),
    ],
)
def test_each_step_and_turn_has_a_cue_from_its_side(motion: Motion, name: str, bearing: float) -> None:
    done: list[Any] = []
    watcher = RobotWatcher(Part(publish=done.append))  # type: ignore[arg-type]
    watcher.progressed(motion, HERE)
    watcher.sense_failed(RobotProblem("deaf"))
    watcher.passing(HERE)
    assert done == [CueSounded(name, bearing, None), Passing(HERE)]

    done.clear()
    watcher.belt = Part(update=lambda: done.append("belt"))  # type: ignore[assignment]
    watcher.on_problem = lambda problem: done.append(problem.code)
    watcher.progressed(motion, HERE)
    watcher.sense_failed(RobotProblem("deaf"))
    assert done == [CueSounded(name, bearing, None), "belt", "deaf"]


# --- hints for loops


class Hints:
    def __init__(self, **robot: Any) -> None:
        self.said: list[Any] = []
        known = {Bearing.FRONT: 3, Bearing.BACK: 4}
        made: Any = Part(**{"known_distances": lambda: known, **robot})
        sentences: Any = Part(announce=lambda *what, **values: self.said.append((*what, values)))
        self.hints = LoopHints(made, sentences)

    def walk(self, walked: int = 0, asked: int = 5, command: str = "FW", forward: bool = True) -> None:
        self.hints.walked(Moved(command, asked, walked, None, HERE, forward))


@pytest.mark.parametrize(("forward", "steps"), [(True, 3), (False, 4)])
def test_the_third_walk_of_no_steps_has_a_hint_with_the_distance(forward: bool, steps: int) -> None:
    it = Hints()
    for number in range(1, 6):
        it.walk(forward=forward)
        assert len(it.said) == (number >= 3), number
    assert it.said == [("hint", "hint-no-nearer", {"steps": steps})]


def test_another_walk_or_run_begins_the_count_anew() -> None:
    it = Hints()
    others = ({"walked": 1}, {"asked": 0}, {"command": "FW 2"})
    for between in (*(lambda how=how: it.walk(**how) for how in others), it.hints.begin_run):  # type: ignore[misc]
        it.hints.begin_run()
        it.walk()
        it.walk()
        between()
        it.walk()
        assert it.said == []
    it = Hints(known_distances=dict)
    for _ in range(4):
        it.walk()
    assert it.said == []


def test_the_two_hundredth_reading_of_one_distance_in_the_open_has_a_hint() -> None:
    for is_open, said in ((True, [("hint", "hint-no-wall", {})]), (False, [])):
        it = Hints(is_in_the_open=is_open)
        for number in range(1, 402):
            it.hints.read(Bearing.FRONT)
            it.hints.read(Bearing.BACK_LEFT) if number < 200 else None
            if number == 199:
                assert it.said == []
            if number == 200:
                assert it.said == said
        assert it.said == said
    it = Hints()
    for _ in range(201):
        it.hints.read(Bearing.FRONT)
    assert it.said == []


def test_a_run_forgets_the_readings_of_the_one_before() -> None:
    it = Hints(is_in_the_open=True)
    for _ in range(2):
        for _ in range(199):
            it.hints.read(Bearing.FRONT)
        it.hints.begin_run()
    assert it.said == []


def test_walks_and_readings_of_a_robot_count_for_its_hints() -> None:
    it = Actions(
        forward=lambda steps: WalkResult(steps, 0, StoppedBy.OBSTACLE, HERE), distance=lambda _: 1,
        is_in_the_open=True,
    )  # fmt: skip
    for _ in range(3):
        it.actions.forward(5, "FW 5")
    for _ in range(200):
        it.actions.distance(Bearing.FRONT)
    hints = [each for each in it.done if isinstance(each, tuple) and each[0] == "hint"]

    assert hints == [("hint", "hint-no-nearer", {"steps": 3}), ("hint", "hint-no-wall", {})]


def test_another_run_begins_the_hints_anew() -> None:
    it = Actions(forward=lambda steps: WalkResult(steps, 0, StoppedBy.OBSTACLE, HERE))
    for _ in range(2):
        for _ in range(2):
            it.actions.forward(5, "FW 5")
        it.actions.begin_run()

    assert [each for each in it.done if isinstance(each, tuple) and each[0] == "hint"] == []


def test_a_program_waits_for_the_voice_after_its_sentence() -> None:
    it = Actions()
    it.actions._speech_wait = Part(wait=lambda goes_on: it.done.append(("waits", goes_on())))  # type: ignore[assignment]
    it.actions.speak("a")

    assert it.done == [Spoke("a"), ("waits", True)]
