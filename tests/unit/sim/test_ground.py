"""The ground of a world: what may move, what has moved since, and what is free."""

from math import hypot, inf

import pytest

from sim.clock import Clock, Glide, Seat, Turns
from sim.geometry import Placement, Wedge, direction
from sim.ground import Ground
from tests.unit.sim.floors import Unpaced, scene

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


def test_a_part_of_another_thing_is_not_moved_by_itself() -> None:
    text = "model( pushable 1 model( pushable 1 gripper_return 1 ) )"
    ground = Ground(scene(text))

    assert (ground.pushable, ground.grippable) == ({0}, frozenset())


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
    for there in ((3, 3.5), (3.5, 3), (2.5, 3.5)):  # bob is at 1, 3
        assert not ground.may_meet_others(ALICE, 3, 3, there, 0.2)
        assert ground.may_meet_others(ALICE, 3, 3, there, 1.9)
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


@pytest.mark.parametrize(
    ("x", "y", "root", "gap"), [(-4, 0, BOX, 0.95), (0, -2, CAN, 0.95), (4, 0, BOB, 0.95), (-1, -1, BOX, 0.6)]
)
def test_what_may_move_bars_a_way_to_any_side(
    ground: Ground, x: float, y: float, root: int, gap: float
) -> None:
    """The way begins at 0, 0; the thing is 0.05 m wide to each side, or looks to the north as bob does."""
    guard, length = ground.guarded(0.1), hypot(x, y)
    far = gap + 0.05
    for each in (BOX, CAN, BOB):
        ground.put(each, Placement(9, 9))
    assert ground.free_way(ALICE, 0, 0, (x, y), guard, frozenset()) == (1.0 if x <= 0 else (2 - guard) / x)

    ground.put(root, Placement(far * x / length, far * y / length, 0, 90))

    free = ground.free_way(ALICE, 0, 0, (x, y), guard, frozenset()) * length
    assert free == pytest.approx(gap - guard, abs=0.03)
    assert ground.free_way(ALICE, 0, 0, (x, y), guard, frozenset((root_rank(ground, root),))) > free / length
    assert ground.may_meet_others(ALICE, x / 2, y / 2, (x / 2, y / 2), 1.5)


def root_rank(ground: Ground, root: int) -> int:
    (part,) = ground.parts_of(root)
    return part.rank


# --- what rangers see


@pytest.mark.parametrize(
    ("yaw", "root", "metres"),
    [(0, WALL, 2), (90, BOX, 0.95), (-90, CAN, 0.95), (180, None, inf), (45, None, inf)],
)
def test_the_nearest_in_a_wedge_is_seen(ground: Ground, yaw: float, root: int | None, metres: float) -> None:
    def nearest(
        asker: int,
        reach: float = 2.5,
        height: float | None = None,
        but: tuple[int, ...] = (),
        still: bool = True,
    ) -> tuple[float, int | None]:
        wedge = Wedge(0, 0, yaw, direction(yaw), direction(5), reach)
        gap, part = ground.nearest(asker, wedge, height, frozenset(but), still)
        return gap, part.root if part else None

    assert nearest(ALICE) == (pytest.approx(metres), root)
    assert nearest(BOB) == (0.0, ALICE)
    for reach in (metres - 0.01, metres + 0.01):
        if root is not None:
            assert (nearest(ALICE, reach)[1] == root) is (reach > metres)
    if root is not None:
        assert nearest(ALICE, but=(root_rank(ground, root) if root != WALL else WALL,)) == (inf, None)
        assert (nearest(ALICE, still=False)[1] is None) is (root == WALL)
        assert (nearest(ALICE, height=0.3)[1] is None) is (root != WALL), "the things are 0.2 m high"
        assert nearest(ALICE, height=0.1)[1] == root


def test_of_a_wall_and_a_robot_the_nearer_one_is_seen(ground: Ground) -> None:
    wedge = Wedge(0, 0, 0, (1, 0), direction(5), 5.0)
    for x, root, metres in ((1.0, BOB, 0.95), (2.3, WALL, 2.0), (1.9, BOB, 1.85)):
        ground.put(BOB, Placement(x, 0, 0, 90))
        gap, part = ground.nearest(ALICE, wedge, None, frozenset())
        assert (gap, part.root if part else None) == (pytest.approx(metres), root)


@pytest.mark.parametrize("sides", [(0.25, 0.5), (0.5, 0.25)])
@pytest.mark.parametrize("first", ["", "pushable 1"])
@pytest.mark.parametrize("second", ["", "pushable 1"])
def test_of_things_that_are_equally_near_the_first_of_the_world_is_seen(
    sides: tuple[float, float], first: str, second: str
) -> None:
    """Both faces are a metre away; the middle of the smaller one is nearer."""
    boxes = (
        f"model( size [ {side} {side} 1 ] pose [ {1 + side / 2} 0 0 0 ] {more} )\n"
        for side, more in zip(sides, (first, second), strict=True)
    )
    ground = Ground(scene("position( )\n" + "".join(boxes)))

    gap, part = ground.nearest(0, Wedge(0, 0, 0, (1, 0), direction(5), 5.0), None, frozenset())

    assert (gap, part.root if part else None) == (1.0, 1)


def test_the_first_hits_of_rays_are_in_their_order(ground: Ground) -> None:
    ends = [(4.0, 0.0), (0.0, 2.0), (-3.0, 0.0), (0.0, -4.0)]

    def hits(asker: int, *but: int) -> list[tuple[int | None, float]]:
        found = ground.first_hits(asker, 0, 0, ends, False, frozenset(but))
        return [(part.root if part else None, pytest.approx(way)) for part, way in found]  # type: ignore[misc]

    assert hits(ALICE) == [(WALL, 0.5), (BOX, 0.475), (None, 1), (CAN, 0.2375)]
    assert hits(ALICE, BOX) == [(WALL, 0.5), (None, 1), (None, 1), (CAN, 0.2375)]
    ground.attach(CAN, ALICE)
    assert hits(ALICE)[3] == (None, 1)
    ground.put(BOX, Placement(1, 0))
    assert hits(ALICE)[:2] == [(BOX, 0.2375), (None, 1)]


# --- gliding robots

EXTENT = hypot(0.1, 0.05)
"""Of a robot; that of the box is the root of 0.005."""


class Gliding:
    """Alice glides from 0, 0 to 1, 0 in two seconds; what comes near is noted."""

    def __init__(self, ground: Ground, guard: float = 0.2) -> None:
        ground.guarded(0.5)
        self.ground = ground
        self.now = (0.0, 0.0)
        self.cut: list[int] = []
        ground.follow(lambda: self.now, lambda glides: self.cut.extend(each.root for each in glides))
        assert ground.begin_glide(self.glide(ALICE, 0.0, guard))

    def glide(self, root: int, y: float, guard: float) -> Glide:
        clock = Clock(Unpaced(), None, Seat(Turns(), root))
        return Glide(
            *(root, clock, lambda: [1.0, 2.0], lambda count: Placement(count / 2, y)),
            *((0.0, y, 1.0, y), guard),
        )


def test_a_gliding_robot_is_where_its_ticks_have_led_when_another_asks(ground: Ground) -> None:
    it = Gliding(ground)
    it.now = (1.5, 0.0)
    assert ground.place(ALICE) == Placement()

    assert ground.roots_within(ALICE, 0.5, 0, 0.1) == []
    assert ground.place(ALICE) == Placement(), "it does not see itself"
    assert ground.roots_within(BOB, 5.0, 0, 0.1) == []
    assert ground.place(ALICE) == Placement(), "no other came near"
    assert ground.roots_within(BOB, 1.0, 0, 0.1) == [ALICE]
    assert ground.place(ALICE) == Placement(0.5)
    it.now = (2.0, 9.0)
    assert ground.moved() == {ALICE: Placement(1.0)}
    (alice, *_) = ground.parts()
    assert alice.middle == pytest.approx((1.0, 0.0))
    ground.end_glide(ALICE, Placement(1.0, 0.0, 0.0, 7.0))
    assert ground.place(ALICE) == Placement(1.0, 0.0, 0.0, 7.0)
    assert ground.roots_within(BOB, 0.0, 0, 0.5) == []


@pytest.mark.parametrize("now", [None, Placement(0.25)])
def test_a_glide_may_end_where_it_was_seen_last(ground: Ground, now: Placement | None) -> None:
    it = Gliding(ground)
    it.now = (1.0, 9.0)
    assert len(ground.within(BOB, -1, -0.5, 1.9, 0.5, frozenset())) == 1
    it.now = (2.0, 9.0)

    ground.end_glide(ALICE, now)

    assert ground.place(ALICE) == (now or Placement(0.5))
    assert ground.moved() == {ALICE: now or Placement(0.5)}


@pytest.mark.parametrize(
    ("x", "y", "is_cut"),
    [
        (0.5, 0.27, True),
        (0.5, 0.272, False),
        (0.5, -0.27, True),
        (0.5, -0.272, False),
        (1.27, 0, True),
        (1.272, 0, False),
        (-0.27, 0, True),
        (-0.272, 0, False),
    ],
)
def test_what_is_put_near_to_a_way_cuts_the_glide(ground: Ground, x: float, y: float, is_cut: bool) -> None:
    """The guard is 0.2 m, and the corners of the box are 0.0707 m from its middle."""
    it = Gliding(ground)

    ground.put(BOX, Placement(x, y))

    assert it.cut == ([ALICE] if is_cut else [])


@pytest.mark.parametrize(
    ("y", "guard", "begins", "cut"),
    [
        (0.31, 0.2, False, []),
        (0.313, 0.2, True, []),
        (0.31, 0.21, False, []),
        (-0.31, 0.2, False, []),
        (-0.313, 0.2, True, []),
        (0.31, 0.19, True, [ALICE]),  # the other one has the wider guard
        (0.313, 0.19, True, []),
        (3.0, 0.2, True, []),
    ],
)
def test_a_glide_does_not_begin_too_near_to_another_one(
    ground: Ground, y: float, guard: float, begins: bool, cut: list[int]
) -> None:
    it = Gliding(ground)

    assert ground.begin_glide(it.glide(BOB, y, guard)) is begins

    assert it.cut == cut


def test_a_jump_cuts_every_glide(ground: Ground) -> None:
    it = Gliding(ground)
    assert ground.begin_glide(it.glide(BOB, 3.0, 0.2))
    jumps = ground.jumps

    ground.jump()
    assert (sorted(it.cut), ground.jumps) == ([ALICE, BOB], jumps + 1)
    ground.quicken(9.0)
    assert (len(it.cut), ground.jumps) == (4, jumps + 2)


def test_a_moment_ends_when_a_gliding_robot_has_made_a_tick(ground: Ground) -> None:
    assert ground.moment(BOB)[1] == (0.0, 0.0)
    it = Gliding(ground)
    it.now = (0.5, 9.0)
    since, own = ground.moment(BOB), ground.moment(ALICE)
    assert since[1] == it.now
    assert ground.is_unchanged(BOB, since)

    it.now = (0.9, 9.0)
    assert ground.is_unchanged(BOB, since)
    it.now = (1.0, 9.0)
    assert not ground.is_unchanged(BOB, since)
    assert ground.is_unchanged(ALICE, own)
    assert ground.is_unchanged(BOB, ground.moment(BOB))
