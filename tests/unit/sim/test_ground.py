"""The ground of a world: what may move, what has moved since, and what is free."""

import pytest

from sim.geometry import Placement
from sim.ground import Ground
from tests.unit.sim.floors import scene

WORLD = """
define bot position ( size [ 0.2 0.1 0.1 ] )
bot( name "alice" ) bot( name "bob" pose [ 1 3 0 450 ] )
model( name "box" size [ 0.1 0.1 0.2 ] pose [ 0 1 0 0 ] pushable 1 )
model( name "can" size [ 0.1 0.1 0.2 ] pose [ 0 -1 0 0 ] gripper_return 1 )
model( name "wall" size [ 0.2 4 1 ] pose [ 2.1 0 0 0 ] )
"""
"""The face of the wall is at x = 2."""
ALICE, BOB, BOX, CAN, WALL = range(5)
THERE = Placement(-3, -3, 0, 10)


@pytest.fixture
def ground() -> Ground:
    return Ground(scene(WORLD))


def found(
    ground: Ground, asker: int, *box: float, but: tuple[int, ...] = (), has_still: bool = True
) -> list[int]:
    left, bottom, right, top = box
    parts = ground.within(asker, left, bottom, right, top, frozenset(but), has_still)
    return [part.root for part in parts]


def test_robots_and_what_can_be_pushed_or_gripped_may_move(ground: Ground) -> None:
    assert (ground.pushable, ground.grippable, ground.movable) == ({BOX}, {CAN}, {ALICE, BOB, BOX, CAN})
    assert ground.place(BOB) == ground.start(BOB) == Placement(1, 3, 0, 90)


def test_what_has_moved_is_not_at_its_start(ground: Ground) -> None:
    ground.put(BOX, THERE)
    ground.put(BOB, THERE)
    assert (ground.moved(), ground.place(BOX), ground.start(BOX)) == (
        {BOB: THERE, BOX: THERE},
        THERE,
        Placement(0, 1),
    )

    ground.put(BOB, ground.start(BOB))
    assert ground.moved() == {BOX: THERE}


def test_things_are_put_back_but_neither_robots_nor_what_they_hold(ground: Ground) -> None:
    for root in (ALICE, BOX, CAN):
        ground.put(root, THERE)
    ground.attach(CAN, BOB)
    jumps = ground.jumps

    ground.put_things_back()

    assert set(ground.moved()) == {ALICE, CAN}
    assert ground.jumps == jumps + 1
    ground.attach(CAN, None)
    ground.put_things_back()
    assert set(ground.moved()) == {ALICE}


def test_what_a_robot_holds_is_attached(ground: Ground) -> None:
    assert not any(map(ground.is_attached, (ALICE, BOX, CAN)))
    for holder in (ALICE, BOB):
        ground.attach(CAN, holder)
        assert [ground.is_attached(each) for each in (ALICE, BOB, BOX, CAN)] == [False, False, False, True]
    ground.attach(CAN, None)
    assert not ground.is_attached(CAN)


def test_a_moment_ends_when_anything_but_the_asker_moves(ground: Ground) -> None:
    since = ground.moment(ALICE)
    ground.put(ALICE, THERE)
    assert ground.is_unchanged(ALICE, since)

    ground.put(BOX, THERE)
    assert not ground.is_unchanged(ALICE, since)

    since = ground.moment(ALICE)
    ground.attach(CAN, ALICE)
    assert not ground.is_unchanged(ALICE, since)
    assert ground.is_unchanged(ALICE, ground.moment(ALICE))


def test_an_increase_of_the_speed_and_a_change_of_hands_count_as_jumps(ground: Ground) -> None:
    jumps = []
    for speed in (0.5, 0.5, 0.4, 0.6):
        ground.quicken(speed)
        jumps.append(ground.jumps)
    ground.attach(CAN, ALICE)

    assert (jumps, ground.jumps, ground.fastest) == ([1, 1, 1, 2], 3, 0.6)


@pytest.mark.parametrize("is_early", [True, False])
def test_a_guard_is_rounded_up_by_a_tenth_at_most(ground: Ground, is_early: bool) -> None:
    if not is_early:
        ground.begin()

    assert ground.guarded(1.0) == 1.0
    for wanted in (0.1, 0.3, 0.99, 1.01, 1.5):
        kept = ground.guarded(wanted)
        assert wanted <= kept < wanted * 1.1 + 1e-9
        assert ground.is_free_of_still(0, 0, (2 - kept - 0.001, 0), kept)
        assert not ground.is_free_of_still(0, 0, (2 - kept + 0.001, 0), kept)


def test_a_way_is_free_up_to_the_guard_before_a_thing(ground: Ground) -> None:
    guard = ground.guarded(0.1)

    def free(asker: int, x: float, y: float) -> float:
        return ground.free_way(asker, 0, 0, (x, y), guard, frozenset())

    assert free(ALICE, 4, 0) == pytest.approx((2 - guard) / 4)
    assert free(ALICE, 0, 2) == pytest.approx((0.95 - guard) / 2)
    assert free(ALICE, -4, 0) == free(ALICE, 0.5, 0) == 1.0
    ground.attach(BOX, ALICE)
    assert (free(ALICE, 0, 2), free(ALICE, 4, 0)) == (1.0, pytest.approx((2 - guard) / 4))
    ground.put(BOX, Placement(1, 0))
    assert free(BOB, 4, 0) == 0.0, "alice is there"
    ground.put(ALICE, THERE)
    assert free(BOB, 4, 0) == pytest.approx((0.95 - guard) / 4)


def test_the_room_around_a_place_reaches_to_what_never_moves(ground: Ground) -> None:
    guard = ground.guarded(0.1)

    assert ground.still_room(0, 0, guard) == pytest.approx(2 - guard)
    assert ground.still_room(1.5, 0, guard) == pytest.approx(0.5 - guard)
    assert ground.still_room(-50, 0, guard) == 5.0
    assert ground.still_room(2.1, 0, guard) < 0


def test_others_may_be_met_that_are_within_the_guard_of_a_way(ground: Ground) -> None:
    """The box is 1 m to the north, and its corners are 0.07 m from its place."""
    assert not ground.may_meet_others(ALICE, 0, 0, (0, 0.7), 0.2)
    assert ground.may_meet_others(ALICE, 0, 0, (0, 0.75), 0.2)
    assert not ground.may_meet_others(ALICE, 0, 0, (2, 0), 0.2)
    ground.attach(BOX, ALICE)
    assert not ground.may_meet_others(ALICE, 0, 0, (0, 0.75), 0.2)
    assert ground.may_meet_others(BOB, 0, 0, (0, 0.75), 0.2)


def test_in_a_box_are_all_parts_but_those_of_the_asker(ground: Ground) -> None:
    everywhere = (-9, -9, 9, 9)
    assert found(ground, -2, *everywhere) == [ALICE, BOB, BOX, CAN, WALL]
    assert found(ground, ALICE, *everywhere) == [BOB, BOX, CAN, WALL]
    assert found(ground, ALICE, *everywhere, but=(BOX,)) == [BOB, CAN, WALL]
    assert found(ground, ALICE, *everywhere, has_still=False) == [BOB, BOX, CAN]
    assert found(ground, ALICE, 1.5, -1, 2.5, 1) == [WALL]
    assert found(ground, ALICE, 1.5, -1, 2.5, 1, has_still=False) == []
    ground.attach(CAN, ALICE)
    assert found(ground, ALICE, *everywhere) == [BOB, BOX, WALL]
    assert found(ground, BOB, *everywhere) == [ALICE, BOX, CAN, WALL]
