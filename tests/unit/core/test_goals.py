"""Goals and verdicts of challenges. The distances are worked out by hand, in steps."""

from pathlib import Path

import pytest
from msgspec.structs import replace

from devices.ports.robot import Met, Pose, StoppedBy
from donnie_tui.core.events import (
    Event,
    HowStarted,
    Moved,
    Outcome,
    PlacedThing,
    Reset,
    RunEnded,
    RunStarted,
    Spoke,
    Stamped,
    ThingsMoved,
    Turned,
)
from donnie_tui.core.goals import Inventory, Item, Judgment, judge, unknown_things
from worlds.challenges import Challenge, ChallengeText, Goal, Limit, Never, Rules

START = Pose(0.0, 0.0, 0.0)
CHAIR = Item(1, "chair 1", "chair", "green", 10.0, 0.0, 2.0, 2.0)
BOX = Item(2, "box", "cube", "red", 3.0, 4.0, 1.0, 1.0)
ROOM = Inventory((CHAIR, BOX), radius=3.0)


def challenge(*goals: Goal, never: Never | None = None, limit: Limit | None = None) -> Challenge:
    rules = Rules(1, "first_room", goals, never=never or Never(), limit=limit or Limit())
    return Challenge("it", Path("it.toml"), rules, {"en": ChallengeText("It", "Do it.")})


def run(
    *happened: Event, end: Pose = START, seconds: float = 1.0, fresh: bool = True, **variables: int
) -> list[Stamped]:
    events: list[Event] = [
        RunStarted("p", "w", "donnie", 0, "0", HowStarted("", 1, fresh, False, False, START)),
        *happened,
        RunEnded(Outcome.COMPLETED, end, variables, seconds),
    ]
    return [Stamped(at, 0.0, each) for at, each in enumerate(events, start=1)]


def walk(x: float, y: float, *, met: Met | None = None, steps: int = 1) -> Moved:
    stopped_by = None if met is None else StoppedBy.COLLISION
    return Moved("FW", steps, steps, stopped_by, Pose(x, y, 0.0), True, met)


def codes(verdict: Judgment) -> list[str]:
    return [each.code for each in verdict.shortfalls]


@pytest.mark.parametrize(
    ("end", "steps", "bearing"),
    [((4.0, 0.0), 4, 180), ((4.0, 8.0), 4, 0), ((1.0, 4.0), 3, 270), ((7.0, 4.0), 3, 90)],
)
def test_a_stop_elsewhere_says_how_far_and_on_which_side(
    end: tuple[float, float], steps: int, bearing: float
) -> None:
    verdict = judge(challenge(Goal(at=(4.0, 4.0))), ROOM, run(end=Pose(*end, 0.0)))

    assert (verdict.met, verdict.goals) == (0, 1)
    (missing,) = verdict.shortfalls
    assert missing.code == "goal-at-place"
    assert (missing.values["steps"], missing.values["direction"]) == (steps, bearing)


@pytest.mark.parametrize(("x", "solved"), [(4.0, True), (3.9, False)])
def test_the_distance_to_a_thing_is_between_the_body_and_its_box(x: float, solved: bool) -> None:
    # From x to the chair's west side at 8, less the body's 3: 1 step at 4.0.
    verdict = judge(challenge(Goal(at="green chair", within=1.0)), ROOM, run(end=Pose(x, 0.0, 90.0)))

    assert verdict.is_solved is solved


def test_a_thing_that_was_moved_counts_where_it_is_now() -> None:
    pushed = ThingsMoved((PlacedThing("box", Pose(3.0, 9.0, 0.0), 2),))
    events = run(pushed)

    assert judge(challenge(Goal(thing="red box", at=(3.0, 9.0))), ROOM, events).is_solved
    (missing,) = judge(challenge(Goal(thing="red box", at=(6.0, 9.0))), ROOM, events).shortfalls
    assert (missing.code, missing.values["steps"], missing.values["direction"]) == ("goal-thing", 3, 270)


@pytest.mark.parametrize(
    ("heading", "missing"), [(90, []), (99, []), (60, ["goal-facing-right"]), (120, ["goal-facing-left"])]
)
def test_a_wrong_heading_says_how_to_turn_on(heading: float, missing: list[str]) -> None:
    turned = Turned("TR", 1, 1, None, Pose(0.0, 0.0, heading), True)
    verdict = judge(challenge(Goal(facing=90.0)), ROOM, run(turned, end=Pose(0.0, 0.0, heading)))

    assert codes(verdict) == missing


def test_a_heading_across_north_is_near() -> None:
    assert judge(challenge(Goal(facing=0.0)), ROOM, run(end=Pose(0.0, 0.0, 355.0))).is_solved


def test_places_are_visited_in_their_order_unless_any_order_will_do() -> None:
    way = run(walk(0, 6), walk(6, 6), end=Pose(6.0, 6.0, 0.0))
    forth, back = ((0.0, 6.0), (6.0, 6.0)), ((6.0, 6.0), (0.0, 6.0))

    assert judge(challenge(Goal(visited=forth)), ROOM, way).is_solved
    assert codes(judge(challenge(Goal(visited=back)), ROOM, way)) == ["goal-visited"]
    assert judge(challenge(Goal(visited=back, any_order=True)), ROOM, way).is_solved


def test_passing_close_counts_in_the_middle_of_a_walk() -> None:
    # At y 4 the way from 0, 0 to 0, 8 is 2 steps from the box, whose west side is at 2: less than the body.
    way = run(walk(0, 8), end=Pose(0.0, 8.0, 0.0))

    assert judge(challenge(Goal(near="box", within=0.0)), ROOM, way).is_solved
    # To the chair's corner at 8, 2 it is 8 steps, less the body's 3: 5.
    (missing,) = judge(challenge(Goal(near="chair", within=2.0)), ROOM, way).shortfalls
    assert (missing.code, missing.values["steps"]) == ("goal-near", 5)


@pytest.mark.parametrize(
    ("wanted", "said", "solved"),
    [("here", "HERE!", True), ("você", "Voce", True), (7, "7.0", True), ("here", "there", False)],
)
def test_what_is_said_counts_without_case_accents_and_punctuation(
    wanted: str | int, said: str, solved: bool
) -> None:
    assert judge(challenge(Goal(said=wanted)), ROOM, run(Spoke(said))).is_solved is solved


def test_a_variable_counts_with_its_value_at_the_end() -> None:
    goal = challenge(Goal(counted="n", value=3))

    assert judge(goal, ROOM, run(N=3)).is_solved
    assert codes(judge(goal, ROOM, run(N=2))) == ["goal-counted"]
    assert codes(judge(goal, ROOM, run())) == ["goal-not-counted"]


def test_bumping_and_touching_are_reported_after_the_goals() -> None:
    bump = walk(0, 1, met=Met("chair", "chair 1", 0.0))
    never = Never(bump=True, touch=("green chair", "box"))
    verdict = judge(challenge(Goal(said="x"), never=never), ROOM, run(bump))

    assert codes(verdict) == ["goal-said", "never-bump", "never-touch"]
    assert verdict.shortfalls[2].values["target"] == "green chair"


def test_each_limit_says_what_was_needed() -> None:
    limit = Limit(commands=1, seconds=5, steps=3, turns=0)
    turned = Turned("TR", 90, 90, None, START, True)
    verdict = judge(
        challenge(Goal(at=(0, 0)), limit=limit), ROOM, run(walk(0, 0, steps=4), turned, seconds=6)
    )

    needed = {each.code: each.values["count"] for each in verdict.shortfalls}
    assert needed == {"limit-commands": 2, "limit-seconds": 6, "limit-steps": 4, "limit-turns": 1}


def test_what_was_done_since_the_start_counts() -> None:
    said, goal = run(Spoke("here")), challenge(Goal(said="here"))

    assert codes(judge(goal, ROOM, [*said, *run()])) == ["goal-said"]
    assert judge(goal, ROOM, [*said, *run(fresh=False)]).is_solved
    reset = Stamped(9, 0.0, Reset(START))
    assert codes(judge(goal, ROOM, [*said, reset, *run(fresh=False)])) == ["goal-said"]


def test_each_goal_says_whether_it_is_met() -> None:
    judgment = judge(challenge(Goal(said="here"), Goal(at=(0, 0))), ROOM, run())

    assert [each and each.code for each in judgment.of_goals] == ["goal-said", None]


def test_a_stopped_run_solves_nothing() -> None:
    *events, last = run()
    ended = RunEnded(Outcome.STOPPED, START, {}, 1.0)

    verdict = judge(challenge(Goal(at=(0, 0))), ROOM, [*events, replace(last, event=ended)])

    assert codes(verdict) == ["goal-endless"]


def test_names_that_no_thing_has_are_found() -> None:
    goals = challenge(Goal(at="green chiar"), Goal(near="box"), never=Never(touch=("lamp",)))

    assert unknown_things(goals, ROOM) == ("green chiar", "lamp")
