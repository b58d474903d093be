"""The last moves in words and as a table."""

from collections.abc import Sequence
from itertools import pairwise
from math import cos, hypot, inf, sin
from random import Random

import pytest

from devices.ports.robot import Pose, StoppedBy
from donnie_tui.core import timeline
from donnie_tui.core.events import (
    Driven,
    HowStarted,
    Moved,
    Outcome,
    Reset,
    RunEnded,
    RunStarted,
    Stamped,
    Turned,
)
from donnie_tui.core.map_grid import path_in_words
from donnie_tui.core.timeline import MOVES_KEPT, PLACES_KEPT, DrivenPath, Trail
from donnie_tui.i18n.words import Words

WALK = Moved("FW 3", 3, 3, None, Pose(0, 3, 0), True)
TURN = Turned("TR 90", 90, 90, None, Pose(0, 3, 90), True)
BLOCKED = Moved("FW 9", 9, 2, StoppedBy.OBSTACLE, Pose(2, 3, 90), True)


def trail(*events: object) -> Trail:
    made = Trail()
    for number, event in enumerate(events, 1):
        made.on_event(Stamped(number, 0.0, event))  # type: ignore[arg-type] # events
    return made


def test_moves_are_listed_oldest_first_with_their_final_places() -> None:
    assert trail(WALK, TURN, BLOCKED).in_words(5, Words()) == (
        "FW 3: 3 steps, to 0, 3.",
        "TR 90: now facing east.",
        "FW 9: blocked after 2 steps, at 2, 3.",
    )
    assert trail(WALK, TURN, BLOCKED).in_words(1, Words("pt")) == ("FW 9: obstáculo após 2 passos, em 2, 3.",)


def test_a_move_that_was_stopped_is_not_called_blocked() -> None:
    stopped = Moved("FW 9", 9, 2, StoppedBy.USER, Pose(0, 2, 0), True)

    assert trail(stopped).in_words(1, Words()) == ("FW 9: stopped after 2 steps, at 0, 2.",)


def test_a_trail_without_moves_says_so() -> None:
    assert trail().in_words(5, Words("es")) == ("Todavía no me moví.",)


def test_the_table_has_one_row_per_move() -> None:
    assert trail(WALK, TURN, BLOCKED).rows() == (
        ("FW 3", 3, 0, 3, 0, False),
        ("TR 90", 90, 0, 3, 90, False),
        ("FW 9", 2, 2, 3, 90, True),
    )


def test_the_last_place_is_known_without_a_move_too() -> None:
    ended = RunEnded(Outcome.COMPLETED, Pose(7, 7, 0), {}, 1.0)

    assert trail(WALK, ended).last_pose == Pose(7, 7, 0)
    assert trail().last_pose is None


def test_the_oldest_moves_are_forgotten() -> None:
    assert len(trail(*[WALK] * (MOVES_KEPT + 10)).rows()) == MOVES_KEPT


def test_each_robot_has_a_trail_of_its_own() -> None:
    talked_to = "alice"
    trail = Trail(lambda: talked_to)
    there = Moved("FW 3", 3, 3, None, Pose(0, 3, 0), True)
    trail.on_event(Stamped(1, 0.0, there, "alice"))

    assert trail.in_words(5, Words()) == ("FW 3: 3 steps, to 0, 3.",)
    talked_to = "bob"
    assert trail.in_words(5, Words()) == ("I have not moved yet.",)
    assert trail.last_pose is None


def started(pose: Pose) -> RunStarted:
    return RunStarted("program", "w", "donnie", 0, "0", HowStarted("", 1, True, False, False, pose))


def test_the_path_has_a_sentence_for_each_straight_leg_and_its_length() -> None:
    here, there = Pose(0, 0, 0), Pose(4, 3, 90)
    moves = (
        WALK,
        TURN,
        Moved("FW 2", 2, 2, None, Pose(2, 3, 90), True),
        Moved("FW 2", 2, 2, None, there, True),
    )
    back = Moved("BW 3", 3, 3, None, Pose(4, 0, 0), False)

    path = trail(started(here), *moves, back).path

    assert path_in_words(path, Words()) == (
        "The path starts at 0, 0.",
        "North: 3 steps, to 0, 3.",
        "East: 4 steps, to 4, 3.",
        "South: 3 steps, to 4, 0.",
        "10 steps in all.",
    )
    assert path_in_words(path, Words("pt"))[1] == "Norte: 3 passos, até 0, 3."
    assert path_in_words(path, Words("es"))[1] == "Norte: 3 pasos, hasta 0, 3."


def test_the_path_continues_in_the_next_run_and_begins_anew_where_the_robot_was_put() -> None:
    first = (started(Pose(0, 0, 0)), WALK)

    assert len(trail(*first, started(Pose(0, 3, 0)), BLOCKED).path.poses) == 3
    assert trail(*first, started(Pose(9, 9, 0))).path.poses == (Pose(9, 9, 0),)
    assert path_in_words(trail(*first, Reset(Pose(0, 0, 0))).path, Words()) == ("I have not moved yet.",)


def test_the_path_ends_as_the_robot_looks_and_only_one_that_drove_has_a_path_to_draw() -> None:
    turned = Turned("TR 90", 90, 90, None, Pose(0, 0, 90), True)

    (path,) = trail(started(Pose(0, 0, 0)), WALK, TURN).paths
    assert (path.robot, path.poses) == ("", (Pose(0, 0, 0), Pose(0, 3, 0), Pose(0, 3, 90)))
    assert trail(started(Pose(0, 0, 0)), turned).paths == ()


# --- long paths

SQUARE = (
    *(Moved("FW 5", 5, 5, None, Pose(0, 5, 0), True), Turned("TR 90", 90, 90, None, Pose(0, 5, 90), True)),
    *(Moved("FW 5", 5, 5, None, Pose(5, 5, 90), True), Turned("TR 90", 90, 90, None, Pose(5, 5, 180), True)),
    *(Moved("FW 5", 5, 5, None, Pose(5, 0, 180), True), Turned("TR 90", 90, 90, None, Pose(5, 0, 270), True)),
    *(Moved("FW 5", 5, 5, None, Pose(0, 0, 270), True), Turned("TR 90", 90, 90, None, Pose(0, 0, 0), True)),
)
"""A round of 20 steps; positions by arithmetic."""


def from_way(pose: Pose, way: Sequence[Pose]) -> float:
    """Steps from a place to the nearest point of straight legs."""
    best = inf
    for here, there in pairwise(way):
        x, y = there.x - here.x, there.y - here.y
        length = x * x + y * y
        part = ((pose.x - here.x) * x + (pose.y - here.y) * y) / length if length else 0.0
        part = min(1.0, max(0.0, part))
        best = min(best, hypot(here.x + part * x - pose.x, here.y + part * y - pose.y))
    return best


def test_straight_on_is_one_leg_however_often_the_robot_walks() -> None:
    steps = (Moved("FW 1", 1, 1, None, Pose(0, at, 0), True) for at in range(1, 5001))

    path = trail(started(Pose(0, 0, 0)), *steps).path

    assert path.poses == (Pose(0, 0, 0), Pose(0, 5000, 0))
    assert path_in_words(path, Words())[-1] == "5000 steps in all."


def test_a_path_longer_than_the_moves_that_are_kept_has_its_true_start_and_length() -> None:
    """4000 rounds are 32 000 moves, 80 000 steps. The first way leads to a corner of the room and back."""
    there = Moved("BW 7", 7, 7, None, Pose(0, -7, 0), False)
    back = Moved("FW 7", 7, 7, None, Pose(0, 0, 0), True)

    path = trail(started(Pose(0, 0, 0)), there, back, *SQUARE * 4000, SQUARE[0]).path

    assert len(path.poses) <= PLACES_KEPT
    assert (path.poses[0], path.poses[-1]) == (Pose(0, 0, 0), Pose(0, 5, 0))
    assert path.lengths[-1] == 14 + 4000 * 20 + 5
    corners = {(pose.x, pose.y) for pose in path.poses}
    assert corners == {(0, 0), (0, -7), (0, 5), (5, 5), (5, 0)}
    said = path_in_words(path, Words(), 4)
    assert said[:3] == ("The path starts at 0, 0.", "South: 7 steps, to 0, -7.", "North: 12 steps, to 0, 5.")
    assert said[3].startswith(f"I leave out {len(path_in_words(path, Words())) - 7} legs, to ")
    assert said[4:6] == ("West: 5 steps, to 0, 0.", "North: 5 steps, to 0, 5.")
    assert said[6].endswith(" steps of repeated rounds.")
    assert said[7] == "80019 steps in all."


def test_a_long_curve_is_within_a_tenth_of_a_step_of_the_driven_one() -> None:
    """A spiral of 200 turns, an eighth of a step from turn to turn."""
    angles = [at / 30 for at in range(37_700)]
    driven = [Pose(angle / 50 * cos(angle), angle / 50 * sin(angle), 0) for angle in angles]

    path = trail(*(Driven("left", pose) for pose in driven)).path

    assert len(path.poses) <= PLACES_KEPT
    assert not path.has_gap
    assert (path.poses[0], path.poses[-1]) == (driven[0], driven[-1])
    for pose in driven[::631]:
        near = [each for each in path.poses if hypot(each.x - pose.x, each.y - pose.y) < 2]
        ends = {each: number for number, each in enumerate(path.poses)}
        legs = [path.poses[ends[each] - 1 : ends[each] + 2] for each in near if ends[each]]
        assert min(from_way(pose, leg) for leg in legs) < 0.1


def test_a_wandering_robot_has_a_bounded_path_with_its_true_start_and_one_gap() -> None:
    chance = Random(7)
    places = [Pose(chance.uniform(-20, 20), chance.uniform(-20, 20), 0) for _ in range(2 * PLACES_KEPT)]
    steps = [hypot(b.x - a.x, b.y - a.y) for a, b in pairwise((Pose(0, 0, 0), *places))]

    path = trail(started(Pose(0, 0, 0)), *(Driven("forward", pose) for pose in places)).path
    (start,), known = path.pieces

    assert (start, len(known) > PLACES_KEPT / 2, len(path.poses) <= PLACES_KEPT) == (
        Pose(0, 0, 0),
        True,
        True,
    )
    assert {*known} <= {*places}
    assert known[-1] == places[-1]
    assert path.lengths[-1] == pytest.approx(sum(steps))
    forgotten = sum(steps[: places.index(known[0]) + 1])
    assert path_in_words(path, Words(), 10)[:2] == (
        "The path starts at 0, 0.",
        f"{round(forgotten)} steps that I forgot, to {round(known[0].x)}, {round(known[0].y)}.",
    )


def test_the_parts_of_a_shortened_path_are_driven_in_their_order() -> None:
    path = trail(started(Pose(0, 0, 0)), *SQUARE * 3000).path

    assert list(path.lengths) == sorted(path.lengths)
    assert len(path.lengths) == len(path.poses)


def test_a_path_that_is_made_has_the_lengths_of_its_legs() -> None:
    assert DrivenPath("", (Pose(0, 0, 0), Pose(3, 4, 0), Pose(3, 0, 0))).lengths == (0, 5, 9)


# --- what a path leaves out


def driven(*places: tuple[float, ...]) -> Trail:
    return trail(*(Driven("forward", Pose(*each, *[0.0] * (3 - len(each)))) for each in places))


@pytest.mark.parametrize(
    ("places", "count"),
    [
        ([(0, 0), (0, 1), (0, 2), (0, 9)], 2),
        ([(0, 0), (0, 1)], 2),
        ([(0, 0), (0, 2), (0, 1)], 3),  # back
        ([(0, 0), (0, 1), (0, 1)], 3),  # a stay
        ([(0, 0), (1, 0), (1, 1)], 3),  # aside
        ([(0, 0), (0, 1), (0.001, 2)], 3),
        ([(0, 0), (3, 4), (6, 8)], 2),
        *(([(x, y), (x + 1, y), (x + 3, y)], 2) for x, y in ((5, 5), (-5, 5), (-5, -5))),
        *(([(x, y), (x, y - 1), (x, y - 3)], 2) for x, y in ((5, 5), (-5, 5), (-5, -5))),
        *(([(x, y), (x + 2, y), (x + 1, y)], 3) for x, y in ((5, 5), (-5, 5), (-5, -5))),
        *(([(x, y), (x, y - 2), (x, y - 1)], 3) for x, y in ((5, 5), (-5, 5), (-5, -5))),
        ([(0, 0, 0), (0, 1, 0), (0, 2, 0.01)], 2),
        ([(0, 0, 0), (0, 1, 0), (0, 2, 0.02)], 3),
        ([(0, 0, 0.02), (0, 1, 0), (0, 2, 0)], 3),
        ([(0, 0, 0), (0, 0, 90), (0, 0, 180)], 2),  # two turns on one spot are one
        ([(0, 0, 0), (0, 0, 90), (0, 1, 90)], 3),
        ([(0, 0, 0), (0, 1, 0), (0, 1, 90)], 3),
    ],
)
def test_a_place_is_left_out_if_the_way_goes_straight_on_through_it(
    places: list[tuple[float, ...]], count: int
) -> None:
    path = driven(*places).path
    ways = sum(hypot(b[0] - a[0], b[1] - a[1]) for a, b in pairwise(places))

    assert len(path.poses) == count
    assert (path.poses[0].x, path.poses[-1].x, path.poses[-1].y) == (places[0][0], *places[-1][:2])
    assert path.lengths == (0, *path.lengths[1:-1], pytest.approx(ways))


@pytest.mark.parametrize(("count", "known"), [(8, 8), (9, 6), (10, 7), (11, 6), (12, 7), (13, 6)])
def test_of_a_path_with_too_many_places_the_start_and_the_newest_three_quarters_are_kept(
    monkeypatch: pytest.MonkeyPatch, count: int, known: int
) -> None:
    monkeypatch.setattr(timeline, "PLACES_KEPT", 8)
    places = [(at * 10.0, at % 2 * 10.0 + at * at) for at in range(count)]
    path = driven(*places).path
    ways = [0.0, *(hypot(b[0] - a[0], b[1] - a[1]) for a, b in pairwise(places))]
    kept = [places[0], *places[-known:]] if path.has_gap else places

    assert path.has_gap is (count > 8)
    assert [(each.x, each.y) for each in path.poses] == kept
    assert path.pieces == ((path.poses[:1], path.poses[1:]) if path.has_gap else (path.poses,))
    assert path.lengths == pytest.approx([sum(ways[: places.index(each) + 1]) for each in kept])


def test_a_round_that_is_driven_again_is_left_out_and_its_steps_are_counted(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(timeline, "PLACES_KEPT", 8)
    square = [(0.0, 0.0), (0.0, 5.0), (5.0, 5.0), (5.0, 0.0)]
    path = driven(*square, *square, *square[:2]).path
    there = [(each.x, each.y) for each in path.poses]

    assert there == [*square, (0, 0), (0, 0), (0, 5)]  # it waits
    assert path.lengths == (0, 5, 10, 15, 20, 40, 45)
    assert path.has_gap is False


@pytest.mark.parametrize(("aside", "count"), [(0.02, 2), (0.05, 9)])
def test_a_place_less_than_three_hundredths_of_a_step_from_the_way_is_left_out_of_a_long_path(
    monkeypatch: pytest.MonkeyPatch, aside: float, count: int
) -> None:
    monkeypatch.setattr(timeline, "PLACES_KEPT", 8)
    path = driven(*((at % 2 * aside, at * 1.0) for at in range(9))).path

    assert len(path.poses) == count - (count > 8) * 2  # the newest six and the start
    assert (path.poses[0], path.poses[-1]) == (Pose(0, 0, 0), Pose(0, 8, 0))


@pytest.mark.parametrize(("aside", "is_same"), [(0.01, True), (0.011, False)])
def test_a_run_that_begins_a_hundredth_of_a_step_away_continues_the_path(aside: float, is_same: bool) -> None:
    walked = trail(started(Pose(0, 0, 0)), WALK, started(Pose(aside, 3, 0)))

    assert (len(walked.path.poses) == 2) is is_same
    assert walked.last_pose == Pose(aside, 3, 0)
    assert bool(driven((0, 0), (aside, 0)).paths) is not is_same  # as far it did not drive


def test_a_run_of_an_older_version_changes_no_path() -> None:
    walked = trail(started(Pose(0, 0, 0)), WALK, RunStarted("a", "w", "donnie", 0, "0", None))

    assert (walked.path.poses, walked.last_pose) == ((Pose(0, 0, 0), Pose(0, 3, 0)), Pose(0, 3, 0))


@pytest.mark.parametrize("is_named", [True, False])
def test_a_run_belongs_to_its_robot_where_events_name_it(is_named: bool) -> None:
    how = HowStarted("", 1, True, False, False, Pose(1, 2, 0), named=is_named)
    name, walked = "donnie" if is_named else None, Trail(lambda: "donnie" if is_named else None)
    walked.on_event(Stamped(1, 0.0, RunStarted("a", "w", "donnie", 0, "0", how), "donnie"))
    walked.on_event(Stamped(2, 0.0, WALK, name))

    assert (walked.last_pose, walked.path.robot) == (Pose(0, 3, 0), name or "")
    assert [each.poses for each in walked.paths] == [(Pose(1, 2, 0), Pose(0, 3, 0))]


def test_moves_are_counted_also_those_that_are_forgotten() -> None:
    walked = Trail(most_moves=2)
    assert (walked.moves, walked.in_words(5, Words())) == (0, ("I have not moved yet.",))
    for number, event in enumerate((WALK, TURN, BLOCKED), 1):
        walked.on_event(Stamped(number, 0.0, event))

    assert (walked.moves, len(walked.rows())) == (3, 2)
    assert walked.in_words(0, Words()) == ("I have not moved yet.",)
    assert [len(walked.in_words(count, Words())) for count in (1, 2, 3)] == [1, 2, 2]


def test_a_copy_of_a_trail_goes_on_by_itself_and_one_for_another_robot_does_not() -> None:
    walked = trail(started(Pose(0, 0, 0)), WALK)
    copied, same = walked.copied(), walked.of(lambda: None)
    walked.on_event(Stamped(3, 0.0, TURN))

    assert (copied.moves, len(copied.rows()), len(copied.path.poses)) == (1, 1, 2)
    assert copied.last_pose == Pose(0, 3, 0)
    assert (same.moves, same.path, same.last_pose) == (2, walked.path, Pose(0, 3, 90))
    copied.on_event(Stamped(3, 0.0, BLOCKED))
    assert (copied.rows()[-1][0], walked.rows()[-1][0]) == ("FW 9", "TR 90")
    assert walked.of(lambda: "bob").moves == 0


@pytest.mark.parametrize("by", StoppedBy, ids=lambda by: by.name.lower())
def test_only_what_stands_in_the_way_blocks(by: StoppedBy) -> None:
    stopped = by in (StoppedBy.USER, StoppedBy.LINK, StoppedBy.WRONG_WAY, StoppedBy.RUNAWAY)
    moved = Moved("FW 9", 9, 2, by, Pose(2.9, -3.9, 0), True)

    (said,) = trail(moved).in_words(1, Words())
    assert said == f"FW 9: {'stopped' if stopped else 'blocked'} after 2 steps, at 2, -3."
    assert trail(moved).rows() == (("FW 9", 2, 2, -3, 0, True),)


def test_what_was_simplified_once_is_not_simplified_again(monkeypatch: pytest.MonkeyPatch) -> None:
    """Else a long path would get further off each time."""
    monkeypatch.setattr(timeline, "PLACES_KEPT", 16)
    monkeypatch.setattr(timeline, "_PART", 4)
    path = driven(*((at % 2 * 0.02, at * 1.0) for at in range(29))).path

    assert [each.y for each in path.poses] == list(range(0, 29, 4))
    assert path.lengths[-1] == pytest.approx(28 * hypot(1, 0.02))


def test_what_follows_a_gap_is_simplified_from_its_end_on(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(timeline, "PLACES_KEPT", 16)
    monkeypatch.setattr(timeline, "_PART", 4)
    far = [(at * 10.0, at % 2 * 10.0 + at * at) for at in range(17)]
    x, y = far[-1]
    path = driven(*far, *((x + at % 2 * 0.02, y + at) for at in range(1, 5))).path

    assert [(each.x, each.y) for each in path.poses] == [far[0], *far[-11:], (x, y + 4)]
