"""Goals and verdicts of challenges. The distances are worked out by hand, in steps."""

from pathlib import Path

import pytest
from msgspec.structs import replace

from devices.ports.robot import Grip, Met, Pose, Pushed, StoppedBy
from donnie_tui.core.describe import target_in_words
from donnie_tui.core.events import (
    Error,
    Event,
    GripperUsed,
    HowStarted,
    Moved,
    Outcome,
    PlacedThing,
    Reset,
    RunEnded,
    RunStarted,
    Scanned,
    Spoke,
    Stamped,
    ThingsMoved,
    Turned,
    Waited,
)
from donnie_tui.core.goals import (
    Inventory,
    Judgment,
    Shortfall,
    folded,
    gap_to,
    goals_of_end,
    in_steps,
    judge,
    names_of,
    track_of,
    unknown_names,
    way_out,
)
from donnie_tui.core.wording import bearing
from donnie_tui.i18n.words import Words
from sim.picture import Thing
from worlds.challenges import (
    Challenge,
    ChallengeQuestion,
    ChallengeText,
    Goal,
    Limit,
    Never,
    Rules,
    Unsensed,
    Variant,
    find,
    names,
)

START = Pose(0.0, 0.0, 0.0)


def item(number: int, name: str, kind: str, colour: str, x: float, y: float, half: float = 0.0) -> Thing:
    """A thing with its middle there, from which it reaches ``half`` to each side."""
    return Thing(name, kind, "t", colour, x, y, 2 * half, 2 * half, index=number)


CHAIR = item(1, "chair 1", "chair", "green", 10.0, 0.0, 2.0)
BOX = item(2, "box", "cube", "red", 3.0, 4.0, 1.0)
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

    assert (verdict.counts["met"], verdict.counts["goals"]) == (0, 1)
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


@pytest.mark.parametrize("heading", [350.0, 355.0, 10.0])
def test_a_heading_across_north_is_near(heading: float) -> None:
    assert judge(challenge(Goal(facing=0.0)), ROOM, run(end=Pose(0.0, 0.0, heading))).is_solved


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


FAR_BOX = Inventory((item(2, "box", "cube", "red", 3.0, 20.0, 1.0),), radius=3.0)
"""The box begins 3 steps to the east of a way to the north: a robot that passes would touch it."""
AWAY = ThingsMoved((PlacedThing("box", Pose(20.0, 20.0, 0.0), 2),))
BACK = ThingsMoved((PlacedThing("box", Pose(3.0, 20.0, 0.0), 2),))


@pytest.mark.parametrize(
    ("happened", "is_near"),
    [
        ((walk(0, 40),), True),
        ((walk(0, 40), AWAY), True),
        ((AWAY, walk(0, 40)), False),
        ((AWAY, walk(0, 40), BACK), False),
        ((AWAY, walk(0, 40), walk(0, 20), BACK), True),
    ],
)
def test_near_counts_where_a_thing_is_at_that_moment(happened: tuple[Event, ...], is_near: bool) -> None:
    kept_away = challenge(Goal(said="x"), never=Never(near=("red box",)))
    end = [each.pose for each in happened if isinstance(each, Moved)][-1]

    assert ("never-near" in codes(judge(kept_away, FAR_BOX, run(*happened, end=end)))) is is_near
    assert judge(challenge(Goal(near="red box")), FAR_BOX, run(*happened, end=end)).is_solved is is_near
    visited = challenge(Goal(visited=("red box",)))
    assert judge(visited, FAR_BOX, run(*happened, end=end)).is_solved is is_near


def test_each_limit_says_what_was_needed() -> None:
    limit = Limit(commands=1, seconds=5, steps=3, turns=0)
    turned = Turned("TR", 90, 90, None, START, True)
    verdict = judge(
        challenge(Goal(at=(0, 0)), limit=limit), ROOM, run(walk(0, 0, steps=4), turned, seconds=6)
    )

    needed = {each.code: each.values["count"] for each in verdict.shortfalls}
    assert needed == {"limit-commands": 2, "limit-seconds": 6, "limit-steps": 4, "limit-turns": 1}


@pytest.mark.parametrize(
    ("limit", "needed"),
    [
        (Limit(commands=2, seconds=6, steps=4, turns=1), {}),
        (Limit(commands=1), {"limit-commands": (2, 1)}),
        (Limit(seconds=5.9), {"limit-seconds": (6, 6)}),
        (Limit(steps=3), {"limit-steps": (4, 3)}),
        (Limit(turns=0), {"limit-turns": (1, 0)}),
    ],
)
def test_what_a_limit_allows_is_not_above_it(limit: Limit, needed: dict[str, tuple[int, int]]) -> None:
    turned = Turned("TR", 90, 90, None, START, True)
    events = run(walk(0, 0, steps=4), turned, seconds=6.04)  # a twentieth of a second doesn't count
    verdict = judge(challenge(Goal(at=(0, 0)), limit=limit), ROOM, events)

    assert {each.code: (each.values["count"], each.values["most"]) for each in verdict.shortfalls} == needed


@pytest.mark.parametrize(
    ("y", "is_met"), [(5.0, True), (5.04, True), (5.06, False), (2.96, True), (2.94, False)]
)
def test_a_place_is_reached_within_a_step_and_a_twentieth(y: float, is_met: bool) -> None:
    verdict = judge(challenge(Goal(at=(0.0, 4.0))), ROOM, run(end=Pose(0.0, y, 0.0)))
    assert verdict.is_solved is is_met

    passed = [Stamped(1, 0.0, Reset(Pose(0.0, y, 0.0)))]
    assert judge(challenge(Goal(visited=((0.0, 4.0),))), ROOM, passed).is_solved is is_met
    assert judge(challenge(Goal(visited=((0.0, 4.0),), any_order=True)), ROOM, passed).is_solved is is_met
    assert judge(challenge(Goal(near=(0.0, 4.0))), ROOM, passed).is_solved is is_met


@pytest.mark.parametrize(
    ("heading", "within", "degrees"),
    [(100, 1, None), (101, 1, 11), (80, 1, None), (79, 1, 11), (110, 2, None), (111, 2, 21), (270, 1, 180)],
)
def test_a_step_of_a_heading_means_ten_degrees(heading: float, within: float, degrees: int | None) -> None:
    verdict = judge(challenge(Goal(facing=90.0, within=within)), ROOM, run(end=Pose(0.0, 0.0, heading)))

    assert [each.values["degrees"] for each in verdict.shortfalls] == ([] if degrees is None else [degrees])


@pytest.mark.parametrize(("y", "is_near"), [(6.0, True), (7.9, True), (8.1, False)])
def test_to_come_too_near_is_to_be_nearer_than_the_steps_to_keep_away(y: float, is_near: bool) -> None:
    """The box ends at y 5, less the body's 3: at y 8 nothing is between them."""
    kept = challenge(Goal(said="x"), never=Never(near=("box",), within=0.05))
    start = [Stamped(1, 0.0, Reset(Pose(3.0, y, 0.0)))]
    found = judge(kept, ROOM, start).shortfalls

    assert ("never-near" in [each.code for each in found]) is is_near


def test_a_pushed_thing_was_touched_and_another_of_its_kind_was_not() -> None:
    pushed = Moved("FW", 1, 1, None, START, True, None, (Pushed("cube", "box", "red", 0.2),))
    never = Never(touch=("chair", "red box"))
    verdict = judge(challenge(Goal(at=(0, 0)), never=never), ROOM, run(pushed))

    assert [(each.code, each.values["target"]) for each in verdict.shortfalls] == [("never-touch", "red box")]


def test_the_first_mistake_of_a_run_is_what_went_wrong() -> None:
    errors = [Error("x", line, 1, f"message {line}", "SAY") for line in (3, 5)]
    *events, last = run(*errors)
    ended = replace(last, event=RunEnded(Outcome.STOPPED, START, {}, 1.0))

    for end in (last, ended):
        (missing,) = judge(challenge(Goal(at=(0, 0))), ROOM, [*events, end]).shortfalls
        assert (missing.code, dict(missing.values)) == ("goal-mistake", {"line": 3, "message": "message 3"})


def test_what_was_done_since_the_start_counts() -> None:
    said, goal = run(Spoke("here")), challenge(Goal(said="here"))

    assert codes(judge(goal, ROOM, [*said, *run()])) == ["goal-said"]
    assert judge(goal, ROOM, [*said, *run(fresh=False)]).is_solved
    reset = Stamped(9, 0.0, Reset(START))
    assert codes(judge(goal, ROOM, [*said, reset, *run(fresh=False)])) == ["goal-said"]


def test_a_program_that_is_refused_leaves_what_was_done() -> None:
    """The robot was not put back to its start."""
    how = HowStarted("", 1, True, False, False, START, refused=True)
    refused = (RunStarted("p", "w", "donnie", 0, "0", how), Error("x", 3, 1, "message", None))
    events = [*run(Spoke("here")), *(Stamped(9, 0.0, each) for each in refused)]

    assert codes(judge(challenge(Goal(said="here")), ROOM, events)) == ["goal-mistake"]


def test_each_goal_says_whether_it_is_met() -> None:
    judgment = judge(challenge(Goal(said="here"), Goal(at=(0, 0))), ROOM, run())

    assert [each and each.code for each in judgment.of_goals] == ["goal-said", None]


def test_a_stopped_run_solves_nothing() -> None:
    *events, last = run()
    ended = RunEnded(Outcome.STOPPED, START, {}, 1.0)

    verdict = judge(challenge(Goal(at=(0, 0))), ROOM, [*events, replace(last, event=ended)])

    assert codes(verdict) == ["goal-endless"]


def test_names_that_no_thing_has_are_found() -> None:
    goals = challenge(Goal(near="box"), Goal(at="green chiar"), never=Never(touch=("lamp",)))

    assert {*unknown_names(goals.rules, ROOM)} == {
        ("goal[1]", "at", "green chiar"),
        ("never", "touch", "lamp"),
    }


AREA = ((0.0, 3.0), (4.0, 6.0))


def shortfalls(
    goal: Goal, events: list[Stamped], room: Inventory = ROOM
) -> list[tuple[str, dict[str, object]]]:
    found = judge(challenge(goal), room, events).shortfalls
    return [(each.code, {**each.values, **({"robot": each.robot} if each.robot else {})}) for each in found]


@pytest.mark.parametrize(
    ("end", "steps", "direction"), [((2, 1), 2, 180), ((9, 5), 5, 90), ((-3, 4), 3, 270), ((1, 10), 4, 0)]
)
def test_an_area_that_was_not_reached_says_how_far_outside(
    end: tuple[float, float], steps: int, direction: float
) -> None:
    start = Stamped(1, 0.0, Reset(Pose(*end, 0.0)))

    missing = {"steps": steps, "direction": direction, "area": AREA}
    assert shortfalls(Goal(area=AREA), [start]) == [("goal-area", missing)]


def test_an_area_counts_once_it_was_reached_unless_the_robot_must_stay() -> None:
    # From 2, 0 to 2, 8: in at y 3, out at y 6 to the north.
    way = [Stamped(1, 0.0, Reset(Pose(2.0, 0.0, 0.0))), Stamped(2, 1.0, walk(2, 8))]

    assert shortfalls(Goal(area=AREA), way) == []
    assert shortfalls(Goal(area=AREA, stay=True), way) == [
        ("goal-area-left", {"direction": 0.0, "area": AREA})
    ]
    stays = [way[0], Stamped(2, 1.0, walk(2, 5))]
    assert shortfalls(Goal(area=AREA, stay=True), stays) == []


def test_a_thing_belongs_into_an_area_and_its_corners_have_any_order() -> None:
    events = run(ThingsMoved((PlacedThing("box", Pose(7.0, 4.0, 0.0), 2),)))

    goal = Goal(thing="red box", area=((4.0, 6.0), (0.0, 3.0)))
    missing = {"steps": 3, "direction": 90, "target": "red box"}
    assert shortfalls(goal, events) == [("goal-thing-area", missing)]
    assert shortfalls(goal, run()) == []  # the box starts at 3, 4


def test_several_sentences_count_in_their_order() -> None:
    goal = Goal(said=("one", 2, "three"))

    assert shortfalls(goal, run(Spoke("One."), Spoke("other"), Spoke("2"), Spoke("THREE"))) == []
    assert shortfalls(goal, run(Spoke("one"))) == [("goal-said", {"text": "2", "before": "one"})]
    swapped = run(Spoke("2"), Spoke("one"), Spoke("three"))
    assert shortfalls(goal, swapped) == [("goal-said-order", {"text": "2", "before": "one"})]


@pytest.mark.parametrize(
    ("wanted", "said", "solved"),
    [(4, "04", True), (4, "4,0", True), (-5, "5", False), (-5, "-5", True), ("3 red", "3.0 RED!", True)],
)
def test_numbers_count_by_their_value_also_within_a_sentence(
    wanted: str | int, said: str, solved: bool
) -> None:
    assert judge(challenge(Goal(said=wanted)), ROOM, run(Spoke(said))).is_solved is solved


HALL = Inventory((BOX,), 3.0, {"alice": Pose(0.0, 0.0, 0.0), "bob": Pose(0.0, 30.0, 180.0)})


def walks(*way: tuple[str, float]) -> list[Stamped]:
    """To the y of each robot, one after the other."""
    return [
        Stamped(at, float(at), Moved("FW", 1, 1, None, Pose(0.0, y, 0.0), True), robot)
        for at, (robot, y) in enumerate((("alice", 0.0), *way), start=1)
    ]


def test_robots_meet_when_their_bodies_were_near_at_one_moment() -> None:
    # 30 steps between their middles, less two bodies of 3 steps: 24 between them at the start.
    starts = [Stamped(0, 0.0, Reset(HALL.robots["alice"]), "alice")]
    apart = {"first": "alice", "second": "bob", "steps": 4}
    goal = Goal(robots=("Alice", "bob"))

    assert shortfalls(goal, starts + walks(("alice", 20.0)), HALL) == [("goal-not-together", apart)]
    met = walks(("alice", 10.0), ("bob", 17.0), ("alice", 0.0))
    assert shortfalls(goal, starts + met, HALL) == []
    passed_later = walks(("alice", 20.0), ("alice", 0.0), ("bob", 12.0))
    assert shortfalls(goal, starts + passed_later, HALL)[0][1]["steps"] == 4


def test_robots_meet_at_the_distance_of_their_bodies_in_any_direction() -> None:
    """From 10, 0 to 4, 8 it is 10 steps, less two bodies of 3: 4."""
    hall = Inventory((), 3.0, {"alice": Pose(10.0, 0.0, 0.0), "bob": Pose(4.0, 8.0, 0.0)})
    begun = [Stamped(0, 0.0, Reset(hall.robots["alice"]), "alice")]
    apart = [("goal-not-together", {"first": "alice", "second": "bob", "steps": 4})]

    assert shortfalls(Goal(robots=("alice", "bob"), within=4), begun, hall) == []
    assert shortfalls(Goal(robots=("alice", "bob"), within=3.9), begun, hall) == apart


def test_no_robot_comes_near_what_is_to_be_kept_away_from() -> None:
    chair = item(1, "chair 1", "chair", "green", 5.0, 20.0, 1.0)
    hall = Inventory((chair,), HALL.radius, HALL.robots)
    kept = challenge(Goal(robots=("alice", "bob"), within=100), never=Never(near=("chair",)))

    starts = [Stamped(0, 0.0, Reset(HALL.robots["alice"]), "alice")]
    assert codes(judge(kept, hall, starts + walks(("alice", 8.0)))) == []
    assert codes(judge(kept, hall, starts + walks(("bob", 20.0)))) == ["never-near"]


def test_both_robots_at_a_place_and_each_one_at_its_own() -> None:
    ends = [Stamped(0, 0.0, Reset(HALL.robots["alice"]), "alice"), *walks(("alice", 12.0), ("bob", 20.0))]

    both = Goal(robots=("alice", "bob"), at=(0.0, 12.0), within=2)
    missing = {"steps": 8, "direction": 0.0, "target": (0.0, 12.0), "robot": "bob"}
    assert shortfalls(both, ends, HALL) == [("goal-at-place", missing)]
    assert shortfalls(Goal(at=(0.0, 20.0), robot="bob"), ends, HALL) == []
    assert shortfalls(Goal(at=(0.0, 20.0)), ends, HALL)[0][0] == "goal-at-place"


def test_one_robot_that_begins_anew_leaves_the_other_one_where_it_is() -> None:
    moved = [*walks(("alice", 12.0), ("bob", 20.0)), Stamped(9, 9.0, Reset(HALL.robots["alice"]), "alice")]

    assert shortfalls(Goal(at=(0.0, 20.0), robot="bob"), moved, HALL) == []
    assert shortfalls(Goal(at=(0.0, 0.0), robot="alice"), moved, HALL) == []


def test_the_end_of_a_solution_is_a_list_of_goals() -> None:
    pushed = ThingsMoved((PlacedThing("box", Pose(3.0, 9.0, 0.0), 2),))

    assert goals_of_end(ROOM, run(pushed, walk(0, 7), Spoke("one"), Spoke("2"), end=Pose(0.0, 7.0, 0.0))) == (
        Goal(at=(0.0, 7.0), within=0.5),
        Goal(thing="box", at=(3.0, 9.0)),
        Goal(said=("one", "2")),
    )
    alone = Inventory((), 3.0, {"alice": START})
    assert goals_of_end(alone, [Stamped(1, 0.0, walk(0, 7), "alice")]) == (Goal(at=(0.0, 7.0), within=0.5),)


def test_a_thing_may_belong_to_another_thing() -> None:
    """The chair is 7 steps east of the box and 4 south: 8.06 steps; from it the box is at 299.7 degrees."""
    assert shortfalls(Goal(thing="red box", at="green chair", within=8.1), run()) == []
    ((code, values),) = shortfalls(Goal(thing="red box", at="green chair", within=7.9), run())
    assert (code, values["steps"], values["target"]) == ("goal-thing", 8, "red box")
    assert values["direction"] == pytest.approx(299.74, abs=0.01)

    there = run(ThingsMoved((PlacedThing("box", Pose(6.05, 9.0, 0.0), 2),)))
    assert shortfalls(Goal(thing="red box", at=(5.0, 9.0)), there) == []
    assert shortfalls(Goal(thing="red box", at=(4.95, 9.0)), there)[0][1]["steps"] == 1


@pytest.mark.parametrize(
    ("text", "plain"),
    [
        ("Maçã", "maca"),
        ("mac\u0327a\u0303", "maca"),
        ("¡Sí,  médio!", " si   medio "),
        ("x2", "x2"),
        ("ﬁn", "fin"),
    ],
)
def test_of_a_text_letters_and_digits_count(text: str, plain: str) -> None:
    assert folded(text).split() == plain.split()


@pytest.mark.parametrize(
    ("language", "chair", "throne"),
    [("en", "chair", "trono do João"), ("pt", "cadeira", "trono do João"), ("es", "silla", "trono do João")],
)
def test_a_thing_with_a_name_of_its_own_is_called_by_it(language: str, chair: str, throne: str) -> None:
    room = Inventory((CHAIR, BOX, item(3, "trono do João", "chair", "green", 20.0, 0.0)), radius=3.0)
    words = Words(language)

    assert target_in_words("chair 1", room, words) == chair
    assert target_in_words("trono do joão", room, words) == throne


@pytest.mark.parametrize(
    ("thing", "names"),
    [
        (CHAIR, ("chair 1", "chair", "green chair 1", "green chair")),
        (item(3, "", "ball", "", 0, 0), ("ball",)),
        (item(3, "", "ball", "red", 0, 0), ("ball", "red ball")),
    ],
)
def test_a_goal_can_call_a_thing_by_its_name_its_kind_and_its_colour(
    thing: Thing, names: tuple[str, ...]
) -> None:
    assert names_of(thing) == names


def test_a_goal_without_a_name_means_the_first_robot() -> None:
    assert [HALL.robot_called(each) for each in ("", "Bob", "carl")] == ["alice", "bob", None]
    assert ROOM.robot_called("") == ""


def test_nothing_is_met_before_a_run_or_a_reset() -> None:
    reset = [Stamped(1, 0.0, Reset(START))]
    both, kept = (Goal(at=(0, 0)), Goal(said="x")), Never(touch=("box",), near=("box",), within=100)

    alone = replace(ROOM, robots={"donnie": START})
    before = judge(challenge(*both, never=kept), alone, [])
    assert [each and each.code for each in before.of_goals] == ["goal-no-run"] * 2
    assert codes(before) == ["goal-no-run"] * 2
    after = judge(challenge(*both, never=kept), alone, reset)
    assert [each and each.code for each in after.of_goals] == [None, "goal-said"]
    assert codes(after) == ["goal-said", "never-near"]


def test_everything_that_the_robot_does_is_a_command() -> None:
    stops = (StoppedBy.COLLISION, StoppedBy.OBSTACLE, StoppedBy.USER, None)
    walks = [Moved("FW", 9, 3, each, START, True) for each in stops]
    turns = [Turned("TR", 9, 3, each, START, True) for each in stops]
    others = (Waited(1), Spoke("a"), Scanned(()), GripperUsed(Grip.NOTHING_THERE, ""), Reset(START))
    first = run(Error("x", 1, 1, "m", None), *walks, *turns, *others[:4], seconds=1.5)
    second = run(*others[:2], fresh=False, seconds=2.0)

    verdict = judge(challenge(Goal(at=(0, 0))), ROOM, [*first, *second])
    assert verdict.track.counts == {"commands": 14, "seconds": 3.5, "steps": 12, "turns": 4, "bumps": 4}
    assert verdict.counts == {"goals": 1, "met": 1, "commands": 14, "steps": 12, "bumps": 4}


def test_the_robot_that_takes_longest_counts_for_the_time() -> None:
    ends = [
        Stamped(at, 0.0, RunEnded(Outcome.COMPLETED, START, {}, seconds), robot)
        for at, (robot, seconds) in enumerate((("alice", 2.0), ("bob", 3.0), ("alice", 0.5)))
    ]

    assert track_of(HALL, ends).counts["seconds"] == 3.0


@pytest.mark.parametrize(
    ("used", "held"),
    [
        ([], {}),
        ([(Grip.GRIPPED, "can")], {"": "can"}),
        ([(Grip.GRIPPED, "")], {"": "tin"}),
        ([(Grip.GRIPPED, "can"), (Grip.HOLDS_ALREADY, "can")], {"": "can"}),
        ([(Grip.GRIPPED, "can"), (Grip.RELEASED, "can")], {"": ""}),
    ],
)
def test_a_gripper_holds_what_it_took_until_it_opens(
    used: list[tuple[Grip, str]], held: dict[str, str]
) -> None:
    done = [GripperUsed(outcome, name, "tin") for outcome, name in used]
    can = Inventory((item(1, "can", "tin", "red", 0, 0), *ROOM.items), radius=3.0)

    assert track_of(can, run(*done)).held == held
    missing = shortfalls(Goal(holds="red tin"), run(*done), can)
    assert missing == ([] if any(held.values()) else [("goal-holds", {"target": "red tin"})])
    assert shortfalls(Goal(holds="box"), run(*done), can) == [("goal-holds", {"target": "box"})]


def test_a_gripper_that_finds_nothing_holds_nothing() -> None:
    done = [GripperUsed(each, "") for each in (Grip.NOTHING_THERE, Grip.HOLDS_NOTHING)]

    assert track_of(ROOM, run(*done)).held == {"": ""}


def test_the_programs_that_ran_are_in_rounds_in_which_no_robot_is_twice() -> None:
    def begun(text: str, *, refused: bool = False) -> RunStarted:
        return RunStarted(
            "p", "w", "d", 0, "0", HowStarted(text, 1, False, False, False, START, refused=refused)
        )

    ended = RunEnded(Outcome.COMPLETED, START, {}, 1.0)
    happened: list[tuple[str, Event]] = [
        ("alice", begun("1")),
        ("bob", begun("2")),
        ("alice", ended),
        ("alice", begun("3")),
        ("alice", ended),
        ("bob", ended),
        ("bob", begun("4")),
        ("bob", ended),
        ("bob", begun("5", refused=True)),
        ("bob", RunStarted("p", "w", "d", 0, "0")),
        ("alice", begun("6")),
    ]
    track = track_of(HALL, [Stamped(1, 0.0, each, robot) for robot, each in happened])

    assert [{name: how.text for name, how in each.items()} for each in track.rounds] == [
        {"alice": "1", "bob": "2"},
        {"alice": "3"},
        {"bob": "4"},
        {"alice": "6"},
    ]


def test_a_way_has_a_place_every_tenth_of_a_step() -> None:
    way = [
        Stamped(1, 0.0, Reset(START)),
        Stamped(2, 1.0, Moved("FW", 1, 1, None, Pose(0.3, 0.4, 90.0), True)),
    ]

    poses = [pose for pose, _ in track_of(ROOM, way).way("")]
    assert [(round(each.x, 6), round(each.y, 6), each.heading) for each in poses] == [
        *[(0.0, 0.0, 0.0)] * 2,
        *((0.06 * at, 0.08 * at, 90.0) for at in (1, 2, 3, 4, 5)),
    ]


def test_what_went_wrong_comes_before_words_goals_rules_and_limits() -> None:
    rules = Rules(
        *(1, "first_room", (Goal(said="x"),)),
        words=("FW",),
        required=("SPEAK",),
        never=Never(bump=True),
        limit=Limit(steps=0),
    )
    it = Challenge("it", Path("it.toml"), rules, {"en": ChallengeText("It", "Do it.")})
    events = run(Error("x", 3, 1, "m", None), walk(0, 1, met=Met("chair", "chair 1", 0.0)))
    how = HowStarted("TR 90 FW 1", 1, True, False, False, START)
    events[0] = replace(events[0], event=RunStarted("p", "w", "donnie", 0, "0", how))

    verdict = judge(it, ROOM, events)
    assert [each.partition("-")[0] for each in codes(verdict)] == [
        *("goal", "word", "word", "goal", "never", "limit")
    ]
    assert codes(verdict)[::2] == ["goal-mistake", "word-missing", "never-bump"]
    assert verdict.shortfalls[2].values == {"word": "SPEAK"}
    assert verdict.shortfalls[4].values == {"times": 1}
    assert not verdict.is_solved


def of_words(text: str, *, words: tuple[str, ...] = (), required: tuple[str, ...] = (), name: str = "it"):
    """What a program lacks for a challenge of that name with these words."""
    rules = Rules(1, "first_room", (Goal(at=(0, 0)),), words=words, required=required)
    it = Challenge(name, Path("it.toml"), rules, {"en": ChallengeText("It", "Do it.")})
    events = run()
    how = HowStarted(text, 1, True, False, False, START)
    events[0] = replace(events[0], event=RunStarted("p", "w", "donnie", 0, "0", how))
    return [(each.code, dict(each.values)) for each in judge(it, ROOM, events).shortfalls]


def test_only_the_words_of_a_lesson_are_allowed_in_any_language() -> None:
    assert of_words("FW 1\nPF 2\nforward 3", words=("FW",)) == []
    assert of_words("FW 1 TR 90", words=("AV", "GD")) == []
    assert of_words("FW 1 TR 90") == []


def test_the_words_of_all_lines_count() -> None:
    rules = Rules(1, "first_room", (Goal(at=(0, 0)),), words=("FW",))
    it = Challenge("it", Path("it.toml"), rules, {"en": ChallengeText("It", "Do it.")})
    events = run()
    for text in ("FW 1", "TR 90"):
        how = HowStarted(text, 1, False, True, False, START)
        events += run(fresh=False)
        events[-2] = replace(events[-2], event=RunStarted("p", "w", "donnie", 0, "0", how))

    (missing,) = judge(it, ROOM, events).shortfalls
    assert missing.values["word"] == "TR"


def test_the_words_that_a_lesson_is_about_are_needed() -> None:
    assert of_words("REPITA 2 VEZES PF 1 FIM REPITA", required=("REPEAT",)) == []
    assert of_words("FW 1", required=("REPEAT", "FW", "IF")) == [
        ("word-missing", {"word": "REPEAT"}),
        ("word-missing", {"word": "IF"}),
    ]


def test_a_word_of_a_later_challenge_has_its_number() -> None:
    """The first one of those that ship whose solution has it."""
    needing = [
        at for at, name in enumerate(names(), start=1) if "PROCEDURE" in find(name).solution().read_text()
    ]
    first = names()[needing[0] - 2], names()[needing[0] - 1]

    in_lesson = ("word-in-lesson", {"word": "PROCEDURE", "number": needing[0]})
    later = ("word-later", {"word": "PROCEDURE", "number": 0})
    assert needing[0] > 1
    assert [of_words("PROCEDURE", words=("FW",), name=each) for each in ("it", *first)] == [
        *([in_lesson], [in_lesson], [later])
    ]
    assert of_words("GRIP FW 1", words=("FW",))[0][0].startswith("word-")


def test_what_a_real_robot_can_not_sense_is_asked_about() -> None:
    sensed, near, far = Goal(at=(0, 0)), Goal(near="box"), Goal(near="chair")
    never = Never(touch=("box", "chair"), near=("chair",), within=0.4)
    touch_box, touch_chair, near_chair = never.avoided
    it = challenge(sensed, near, far, never=never)

    def found(answers: dict[Unsensed, bool]) -> list[tuple[str, dict[str, object]]]:
        return [(each.code, dict(each.values)) for each in judge(it, ROOM, run(), answers).shortfalls]

    assert found({near: True, far: True, touch_box: False, touch_chair: False, near_chair: False}) == []
    assert found({near: False, touch_box: True, near_chair: True}) == [
        ("goal-answered-no", {"number": 2}),
        ("goal-asked", {"number": 3}),
        ("never-touch", {"target": "box", "most": 1}),
        ("never-asked", {"target": "chair", "most": 1}),
        ("never-near", {"target": "chair", "most": 1}),
    ]
    assert codes(judge(challenge(Goal(at=(9, 9))), ROOM, run(), {})) == ["goal-at-place"]


def test_the_names_of_all_tables_are_looked_for() -> None:
    rules = Rules(
        1,
        "first_room",
        (
            Goal(at=(0, 0), robot="alice"),
            Goal(visited=("box", "lamp", (1, 2))),
            Goal(robots=("bob", "carl")),
            Goal(holds="can"),
            Goal(thing="box", at="sofa"),
            Goal(said="lamp"),
            Goal(counted="lamp"),
            Goal(at=(0, 0), robot="dora"),
            Goal(near="vase"),
            Goal(thing="jar", at=(1, 1)),
        ),
        never=Never(near=("rug",), touch=("box", "mat")),
        variant=(Variant(things={"box": (1, 1), "bob": (2, 2), "bed": (3, 3)}),),
        question=(
            ChallengeQuestion("count", "cup"),
            ChallengeQuestion("order", ("box", "pan"), "end"),
            ChallengeQuestion("distance", "box", "pot"),
            ChallengeQuestion("distance", "box", (1, 2)),
        ),
    )

    assert [*unknown_names(rules, HALL)] == [
        ("never", "touch", "mat"),
        ("never", "near", "rug"),
        ("goal[1]", "visited", "lamp"),
        ("goal[2]", "robots", "carl"),
        ("goal[3]", "holds", "can"),
        ("goal[4]", "at", "sofa"),
        ("goal[7]", "robot", "dora"),
        ("goal[8]", "near", "vase"),
        ("goal[9]", "thing", "jar"),
        ("variant[0]", "things", "bed"),
        ("question[0]", "of", "cup"),
        ("question[1]", "of", "pan"),
        ("question[2]", "from", "pot"),
    ]


def test_the_end_of_a_solution_of_several_robots_has_a_place_for_each_and_what_they_hold() -> None:
    can = item(7, "can", "tin", "red", 9.0, 9.0)
    hall = Inventory((can, item(8, "", "ball", "red", 1.0, 1.0), BOX), 3.0, HALL.robots)
    places = (
        PlacedThing("can", Pose(5.0, 5.0, 0.0), 7),
        PlacedThing("", Pose(1.26, 8.0, 0.0), 8),
        PlacedThing("box", Pose(3.05, 4.0, 0.0), 2),
    )
    happened = [
        ("alice", ThingsMoved(places)),
        ("bob", GripperUsed(Grip.GRIPPED, "can")),
        ("alice", GripperUsed(Grip.NOTHING_THERE, "")),
        ("bob", Moved("FW", 1, 1, None, Pose(0.26, 27.04, 180.0), True)),
    ]

    assert goals_of_end(hall, [Stamped(1, 0.0, each, robot) for robot, each in happened]) == (
        Goal(at=(0.0, 0.0), robot="alice", within=0.5),
        Goal(at=(0.3, 27.0), robot="bob", within=0.5),
        Goal(thing="ball", at=(1.3, 8.0)),
        Goal(holds="can"),
    )


@pytest.mark.parametrize(
    ("wanted", "said", "missing"),
    [
        (("a", "b"), ["a"], [("b", "a", "goal-said")]),
        (("a", "b"), ["b"], [("a", "", "goal-said")]),
        (("a", "a"), ["a"], [("a", "a", "goal-said-order")]),
        (-5, ["\u22125"], []),
        ("4,5 m", ["4.50 M."], []),
        ("4.5", ["45"], [("4.5", "", "goal-said")]),
        ("a b", ["a", "b"], [("a b", "", "goal-said")]),
    ],
)
def test_what_was_not_said_in_its_order_is_missing(
    wanted: str | int | tuple[str, ...], said: list[str], missing: list[tuple[str, str, str]]
) -> None:
    found = judge(challenge(Goal(said=wanted)), ROOM, run(*map(Spoke, said))).shortfalls

    assert [(each.values["text"], each.values["before"], each.code) for each in found] == missing


def test_a_variable_that_is_wrong_is_given_with_what_is_wanted() -> None:
    goal = Goal(counted="Número", value=0)

    assert shortfalls(goal, run(numero=0)) == []
    assert shortfalls(goal, run(numero=2)) == [("goal-counted", {"name": "Número", "value": 2, "wanted": 0})]
    assert shortfalls(goal, run()) == [("goal-not-counted", {"name": "Número"})]
    assert shortfalls(goal, run()[:-1]) == [("goal-not-counted", {"name": "Número"})]


def test_a_mistake_of_an_earlier_run_does_not_count() -> None:
    wrong = run(Error("x", 3, 1, "m", None))
    stopped = Stamped(9, 0.0, RunEnded(Outcome.STOPPED, START, {}, 1.0))
    goal = challenge(Goal(at=(0, 0)))

    assert codes(judge(goal, ROOM, wrong)) == ["goal-mistake"]
    assert codes(judge(goal, ROOM, [*wrong, *run(fresh=False)])) == []
    assert codes(judge(goal, ROOM, [*run(), stopped, *run(fresh=False)])) == []


@pytest.mark.parametrize(
    ("x", "y", "gap", "direction"),
    [(1, 2, 0, 0), (-3, 1, 3, 270), (0, 0, 0, 0), (5, 6, 5, 36.87), (2, -4, 4, 180)],
)
def test_the_way_out_of_an_area_is_the_shortest_one(x: float, y: float, gap: float, direction: float) -> None:
    found = way_out(x, y, ((2, 0), (0, 2)))

    assert found == (pytest.approx(gap), pytest.approx(direction, abs=0.01))


def test_the_nearest_thing_of_a_name_counts_and_touching_is_nothing() -> None:
    near, far = item(1, "", "box", "red", 0.0, 9.0, 1.0), item(2, "", "box", "red", -20.0, 0.0, 1.0)

    assert gap_to(START, "box", Inventory((far, near), 3.0)) == (5.0, 0.0)
    assert gap_to(Pose(0.0, 6.0, 0.0), "box", Inventory((far, near), 3.0)) == (0.0, 0.0)
    assert gap_to(START, (3.0, -4.0), ROOM) == (5.0, pytest.approx(bearing(3.0, -4.0, 0.0, 0.0)))
    assert [bearing(1, 1, *each) for each in ((1, 3), (3, 1), (1, -3), (-3, 1), (0, 0))] == [
        *(0.0, 90.0, 180.0, 270.0, 225.0)
    ]
    assert [in_steps(each) for each in (0.0, 0.4, 1.6, 2.4)] == [1, 1, 2, 2]


def test_a_touched_thing_is_known_by_its_kind_and_its_name() -> None:
    hits = (Met("chair", "chair 1", 0.0), Met("cube", "another", 0.0), Met("stool", "box", 0.0))
    turned = Turned("TR", 9, 3, StoppedBy.COLLISION, START, True, hits[0])
    never = challenge(Goal(at=(0, 0)), never=Never(touch=("chair", "box")))

    for hit, touched in zip(hits, (["chair"], [], []), strict=True):
        verdict = judge(never, ROOM, run(walk(0, 0, met=hit)))
        assert [each.values["target"] for each in verdict.shortfalls] == touched
    assert codes(judge(never, ROOM, run(turned))) == ["never-touch"]
    assert codes(judge(challenge(Goal(at=(0, 0)), never=Never(bump=True)), ROOM, run())) == []


def test_a_goal_of_a_robot_says_whose_it_is() -> None:
    ends = [Stamped(0, 0.0, Reset(HALL.robots["alice"]), "alice"), *walks(("bob", 20.0))]
    found = judge(challenge(Goal(at=(0, 0), robot="Bob"), Goal(at=(0, 9))), HALL, ends).shortfalls

    assert [each.robot for each in found] == ["Bob", None]
    assert found[0] == Shortfall(
        "goal-at-place", {"steps": 20, "direction": 0.0, "target": (0, 0)}, robot="Bob"
    )
