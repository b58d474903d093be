"""What the grid finds near a place is what a look at everything finds."""

from math import atan2, cos, degrees, dist, hypot, inf, radians, sin
from random import Random

import pytest
from hypothesis import Phase, given, settings
from hypothesis import strategies as st

from sim.geometry import (
    HAIR,
    Placement,
    Spot,
    Wedge,
    contains,
    direction,
    edges,
    nearest_in_wedge,
    seen_from,
)
from sim.ground import Ground
from sim.index import NO_ROOT, VIEWED_FROM, MovingRoots, StillParts, Views, entries_of, is_whole
from sim.motion import Surroundings
from sim.parts import Part
from sim.rangers import Cone
from tests.effort import examples
from tests.unit.sim.floors import scene

CORNERS = ((0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2))
L = f"block( points 6 {' '.join(f'point[{i}] [ {x} {y} ]' for i, (x, y) in enumerate(CORNERS))} )"
"""Not convex."""


def a_world(chance: Random) -> str:
    """Things that stay, large and small, some of which aren't convex, and things that can be moved."""
    lines = ["position( size [ 0.1 0.1 0.1 ] )"]
    for _ in range(chance.randrange(60)):
        x, y, yaw = chance.uniform(-9, 9), chance.uniform(-9, 9), chance.uniform(0, 360)
        width, depth = chance.choice((0.05, 0.4, 3.0, 40.0)), chance.choice((0.05, 0.4))
        more = chance.choice(("", "", "pushable 1", "boundary 1", L))
        lines.append(f"model( size [ {width} {depth} 1 ] pose [ {x:.3f} {y:.3f} 0 {yaw:.1f} ] {more} )")
    return "\n".join(lines)


def pebbles(chance: Random) -> str:
    """Small things that stay: many close together, and some farther away."""
    places = [(chance.uniform(-far, far), chance.uniform(-far, far)) for far in (*[2] * 80, *[7] * 150)]
    things = [f"model( size [ 0.04 0.04 1 ] pose [ {x:.3f} {y:.3f} 0 0 ] )" for x, y in places]
    return "\n".join(["position( size [ 0.1 0.1 0.1 ] )", *things])


def has_a_corner_in(part: Part, left: float, bottom: float, right: float, top: float) -> bool:
    """Whether one of its corners is in the box."""
    return any(left <= x <= right and bottom <= y <= top for x, y in part.points)


@settings(max_examples=examples(60), deadline=None)
@given(st.integers(0, 10**6))
def test_all_parts_in_a_box_are_found_in_order_wherever_they_were_moved(seed: int) -> None:
    chance = Random(seed)
    ground = Ground(scene(a_world(chance)))
    for root in sorted(ground.movable):
        if chance.random() < 0.5:
            ground.put(
                root, Placement(chance.uniform(-9, 9), chance.uniform(-9, 9), 0, chance.uniform(0, 360))
            )

    for _ in range(10):
        x, y, width = chance.uniform(-9, 9), chance.uniform(-9, 9), chance.choice((0.0, 0.2, 3.0, 1e9))
        box = (x, y, x + width, y + width)
        found = ground.within(-2, *box, frozenset())
        ranks = [part.rank for part in found]

        assert ranks == sorted(set(ranks))
        assert {part.rank for part in ground.parts() if has_a_corner_in(part, *box)} <= set(ranks)
        assert all(ground.parts()[part.rank] is part for part in found)


def nearest_of_all(around: Surroundings, cone: Cone, spot: Spot) -> float:
    """The reading of a cone at the robot's centre that looks at everything."""
    yaw, nearest = spot.yaw + cone.yaw, inf
    for part in around.parts:
        if part.seen and contains(part.points, spot.x, spot.y):
            return 0.0
        if part.seen:
            outline = edges(seen_from(part.points, spot.x, spot.y, yaw))
            nearest = min(nearest, nearest_in_wedge(outline, cone.half_angle))
    return nearest if nearest <= cone.maximum else inf


@settings(max_examples=examples(30), deadline=None, phases=[Phase.generate])
@given(st.integers(0, 10**6))
def test_a_view_from_any_place_of_a_square_holds_all_in_reach_and_no_farther_than_it_is(seed: int) -> None:
    """Looks from the corners of a square, from which things are nearer than from its middle."""
    chance = Random(seed)
    parts = Ground(scene(pebbles(chance))).parts()
    views = Views(StillParts(parts))
    for _ in range(40):
        x, y = ((chance.randrange(-2, 2) + chance.choice((0.0, 0.5, 0.999))) * VIEWED_FROM for _ in "xy")
        yaw, half = chance.uniform(0, 360), chance.choice((7.5, 30.0))
        reach = chance.choice((0.3, 1.2, 6.0))
        wedge = Wedge(x, y, yaw, direction(yaw), direction(half), reach)
        known, found = views.of(wedge, reach)
        bounds = {part.rank: bound for bound, *_, part in found}

        assert known >= reach
        for part in parts:
            metres = nearest_in_wedge(edges(seen_from(part.points, x, y, yaw)), half)
            if part.seen and metres <= reach:
                assert bounds[part.rank] <= metres


def test_a_view_is_the_same_after_a_full_turn() -> None:
    """A sensor to the left of a robot that looks to 350 degrees looks to 440."""
    views = Views(StillParts(Ground(scene(pebbles(Random(1)))).parts()))
    eighty, full_turn_on = (
        views.of(Wedge(0.2, 0.2, yaw, direction(yaw), direction(7.5), 2.0), 2.0) for yaw in (80.0, 440.0)
    )

    assert eighty[1]
    assert eighty is full_turn_on


@settings(max_examples=examples(60), deadline=None)
@given(st.integers(0, 10**6))
def test_a_cone_reads_the_nearest_of_all_things_wherever_they_were_moved(seed: int) -> None:
    chance = Random(seed)
    ground = Ground(scene(a_world(chance)))
    around = Surroundings(ground, 0)
    cone = Cone(0.0, 0.0, 30.0, chance.choice((1.0, 7.5, 45.0)), 0.0, chance.choice((0.3, 0.6, 3.0, 8.0)))
    for _ in range(20):
        spot = Spot(chance.uniform(-9, 9), chance.uniform(-9, 9), chance.uniform(0, 360))
        for root in sorted(ground.movable - {0}):
            if chance.random() < 0.1:
                x, y = spot.x + chance.uniform(-3, 3), spot.y + chance.uniform(-3, 3)
                ground.put(root, Placement(x, y, 0, chance.uniform(0, 360)))

        assert cone.metres(around, spot) == pytest.approx(nearest_of_all(around, cone, spot), abs=1e-9)


@settings(max_examples=examples(30), deadline=None)
@given(st.integers(0, 10**6))
def test_looks_from_one_place_after_the_other_read_the_nearest_of_all_things(seed: int) -> None:
    """What was in view is kept for the next look, near and far, narrow and wide."""
    chance = Random(seed)
    ground = Ground(scene(a_world(chance)))
    around = Surroundings(ground, 0)
    x, y = chance.uniform(-5, 5), chance.uniform(-5, 5)
    for _ in range(60):
        x, y = x + chance.uniform(-0.2, 0.2), y + chance.uniform(-0.2, 0.2)
        half, farthest = chance.choice((1.0, 7.5, 30.0)), chance.choice((0.2, 3.0, 8.0))
        cone = Cone(0.0, 0.0, chance.choice((0.0, 45.0)), half, 0.0, farthest)
        spot = Spot(x, y, chance.choice((10.0, 14.0, 190.0)))

        assert cone.metres(around, spot) == pytest.approx(nearest_of_all(around, cone, spot), abs=1e-9)


@settings(max_examples=examples(40), deadline=None)
@given(st.integers(0, 10**6), st.sampled_from((3, 30, 120)))
def test_what_may_move_is_found_near_each_robot_however_all_drift(seed: int, count: int) -> None:
    """What is near a robot is kept: it changes when anything moves a little, or far."""
    chance = Random(seed)
    places = [(chance.uniform(-6, 6), chance.uniform(-6, 6)) for _ in range(count)]
    ground = Ground(scene("".join(f"position( pose [ {x:.3f} {y:.3f} 0 0 ] )\n" for x, y in places)))
    radius = hypot(0.2, 0.2)
    for _ in range(300):
        root = chance.randrange(count)
        now, far = ground.place(root), chance.choice((0.05, 0.05, 0.05, 0.4, 3.0))
        x, y = now.x + chance.uniform(-far, far), now.y + chance.uniform(-far, far)
        ground.put(root, Placement(x, y, 0, 0))
        asker, reach = chance.randrange(count), chance.choice((0.2, 0.5, 3.0, 8.0))
        x, y = ground.place(asker).x + chance.uniform(-0.3, 0.3), ground.place(asker).y

        found = ground.roots_within(asker, x, y, reach)

        others = {root: ground.place(root) for root in range(count) if root != asker}
        near = {root for root, it in others.items() if hypot(it.x - x, it.y - y) < reach + radius}
        assert sorted(found) == sorted(near)


def test_a_way_that_leads_out_of_the_room_that_is_known_is_free_if_nothing_is_near_it() -> None:
    """Known is a circle of 0.9 m: up to a wall at x = 1, less the guard of about 0.1 m."""
    around = Surroundings(Ground(scene("position( ) model( size [ 0.2 4 1 ] pose [ 1.1 0 0 0 ] )")), 0)
    around.keep(0.1)

    assert around.has_room(0.0, 0.0, 0.05, 0.0)
    assert around.has_room(0.85, 0.0, 0.85, 0.5, straight=True)
    assert not around.has_room(0.85, 0.0, 0.85, 0.5)
    assert not around.has_room(0.85, 0.0, 0.95, 0.0, straight=True)


@settings(max_examples=examples(60), deadline=None)
@given(st.integers(0, 10**6))
def test_a_circle_around_a_part_holds_all_of_it_wherever_it_was_moved(seed: int) -> None:
    chance = Random(seed)
    corners = " ".join(f"point[{i}] [ {chance.random():.3f} {chance.random():.3f} ]" for i in range(5))
    ground = Ground(scene(f"position( ) model( pushable 1 pose [ 3 1 0 20 ] block( points 5 {corners} ) )"))
    root = max(ground.movable)
    for _ in range(5):
        place = Placement(chance.uniform(-9, 9), chance.uniform(-9, 9), 0, chance.uniform(0, 360))
        ground.put(root, place)
        (part,) = ground.parts_of(root)

        assert all(dist(part.middle, point) <= part.reach + HAIR for point in part.points)


def meets(part: Part, left: float, bottom: float, right: float, top: float) -> bool:
    """Whether a box comes to the box around a convex part, or around an edge of another one."""
    pieces = [part.points] if part.model.walls or len(part.points) == 4 else []
    pieces = pieces or [((ax, ay), (bx, by)) for ax, ay, bx, by in edges(part.points)]
    boxes = (tuple(zip(*piece, strict=True)) for piece in pieces)
    return any(
        min(xs) <= right and left <= max(xs) and min(ys) <= top and bottom <= max(ys) for xs, ys in boxes
    )


@pytest.mark.parametrize("seed", range(12))
def test_still_parts_are_found_in_a_box_that_comes_to_the_box_around_them_and_no_others(seed: int) -> None:
    chance = Random(seed)
    parts = Ground(scene(a_world(chance))).parts()
    still = StillParts(parts)
    found_any = 0
    for _ in range(20):
        x, y = chance.uniform(-9, 9), chance.uniform(-9, 9)
        width, height = (chance.choice((0.0, 0.3, 2.0, 60.0)) for _ in "xy")
        box = (x, y, x + width, y + height)

        found = still.within(*box)

        assert {part.rank for part in parts if meets(part, *box)} == set(found)
        assert all(part.rank == rank for rank, part in found.items())
        found_any += len(found)
    assert found_any


def test_a_box_that_touches_a_part_finds_it() -> None:
    parts = Ground(scene("model( size [ 2 1 1 ] pose [ 3 0.5 0 0 ] )")).parts()
    still = StillParts(parts)  # from 2, 0 to 4, 1

    for box, is_found in (
        ((0, 0, 2, 1), True),
        ((0, 0, 2 - 1e-6, 1), False),
        ((4, 0, 5, 1), True),
        ((4 + 1e-6, 0, 5, 1), False),
        ((2, 1, 4, 2), True),
        ((2, 1 + 1e-6, 4, 2), False),
        ((2, -1, 4, 0), True),
        ((2, -1, 4, -1e-6), False),
        ((3, 0.5, 3, 0.5), True),
        ((-99, -99, 99, 99), True),
    ):
        assert bool(still.within(*box)) is is_found
    assert StillParts(()).within(-9, -9, 9, 9) == {}
    assert StillParts(()).reach_of(40) > 0


def test_a_polygon_that_is_not_convex_is_found_by_its_edges() -> None:
    """An L, and a line without an area."""
    hollow, line = Ground(scene(f"model( size [ 2 2 1 ] {L} ) model( size [ 1 0 1 ] )")).parts()

    assert not is_whole(hollow)
    assert len(entries_of(hollow, whole=False)) == 6
    assert len(entries_of(hollow, whole=True)) == 1
    assert entries_of(hollow, whole=True)[0][:4] == pytest.approx((-1, -1, 1, 1))
    assert not is_whole(line)
    assert StillParts((hollow,)).within(0.1, 0.1, 0.9, 0.9) == {}
    assert StillParts((hollow,)).within(0.1, -0.1, 0.9, 0.9) == {hollow.rank: hollow}


RADIUS = hypot(0.2, 0.1)
"""Of robots of 0.4 by 0.2 m."""


def some_robots(chance: Random, count: int) -> tuple[MovingRoots, dict[int, tuple[float, float]]]:
    """Robots that have moved since the first questions, and where they are."""
    lines = "position( size [ 0.4 0.2 0.1 ] )\n" * count
    ground = Ground(scene(lines))
    moving = MovingRoots(
        {root: ground.parts_of(root) for root in range(count)},
        {root: ground.place(root) for root in range(count)},
    )
    places = {}
    for far in (3.0, 0.3):
        for root in range(count):
            x, y = places.get(root, (0.0, 0.0))
            places[root] = x + chance.uniform(-far, far), y + chance.uniform(-far, far)
            moving.move(root, Placement(*places[root]))
            moving.close_to(root, *places[root], 0.5)
    return moving, places


@pytest.mark.parametrize("count", [1, 2, 40])
def test_others_are_found_that_may_come_into_a_circle_a_box_or_a_wedge(count: int) -> None:
    chance = Random(count)
    moving, places = some_robots(chance, count)
    assert {round(moving.extent(root), 6) for root in places} == {round(RADIUS, 6)}
    for _ in range(60):
        asker = chance.choice((NO_ROOT, *places))
        x, y = places.get(asker, (0.0, 0.0))
        x, y = x + chance.uniform(-0.6, 0.6), y + chance.uniform(-0.6, 0.6)
        width, height, reach = (chance.choice((0.0, 0.4, 1.5, 3.0)) for _ in range(3))
        others = {root: it for root, it in places.items() if root != asker}

        found = moving.close_to(asker, x, y, reach)
        near = {root for root, it in others.items() if dist(it, (x, y)) <= reach + RADIUS}
        assert sorted(found) == sorted(near)
        found = moving.within(asker, x, y, x + width, y + height)
        inside = {
            root
            for root, (its_x, its_y) in others.items()
            if -RADIUS <= its_x - x <= width + RADIUS and -RADIUS <= its_y - y <= height + RADIUS
        }
        assert sorted(found) == sorted(inside)
        yaw, half = chance.uniform(0, 360), chance.choice((1.0, 7.5, 45.0))
        wedge = Wedge(x, y, yaw, direction(yaw), direction(half), reach)
        found = moving.in_wedge(asker, wedge, reach)
        seen = set()
        for root, (its_x, its_y) in others.items():
            metres = hypot(its_x - x, its_y - y)
            off = abs((degrees(atan2(its_y - y, its_x - x)) - yaw + 180) % 360 - 180)
            along, beyond = metres * cos(radians(off)), metres * sin(radians(off - half))
            if root in near and -RADIUS <= along <= reach + RADIUS and beyond <= RADIUS:
                seen.add(root)
        assert {*seen} <= {*found}
        assert {*found} - {*seen} <= {*others} - near


def test_a_root_that_stays_within_a_reach_is_near_as_far_as_it_may_come() -> None:
    moving, _ = some_robots(Random(1), 3)
    for root, x in enumerate((0.0, 4.0, 8.0)):
        moving.move(root, Placement(x, 0.0))
    assert moving.close_to(0, 0.0, 0.0, 4.0 - RADIUS - 1e-6) == []
    assert moving.close_to(0, 0.0, 0.0, 4.0 - RADIUS + 1e-6) == [1]

    moving.cover(1, 4.0, 1.0, 2.0)

    reach = hypot(4.0, 1.0) - RADIUS - 2.0
    assert moving.close_to(0, 0.0, 0.0, reach - 1e-6) == []
    assert moving.close_to(0, 0.0, 0.0, reach + 1e-6) == [1]
    assert moving.close_to(2, 8.0, 0.0, reach + 1e-6) == [1]
    moving.move(1, Placement(-5.0, 0.0))
    assert moving.close_to(0, 0.0, 0.0, 4.0) == []
    assert moving.close_to(0, 0.0, 0.0, 5.0) == [1]


def test_a_view_is_in_order_and_without_what_lies_behind() -> None:
    ring = [(3 * cos(radians(each)), 3 * sin(radians(each))) for each in range(5, 365, 10)]
    things = "".join(f"model( size [ 0.04 0.04 1 ] pose [ {x:.6f} {y:.6f} 0 0 ] )\n" for x, y in ring)
    unseen = "model( size [ 0.04 0.04 1 ] pose [ 2 0 0 0 ] ranger_return -1 )"
    views = Views(StillParts(Ground(scene(f"{things}{unseen}")).parts()))

    for yaw in (0, 100, 200, 300):
        wedge = Wedge(0.5, 0.5, yaw, direction(yaw), direction(7.5), 4.0)
        _, found = views.of(wedge, 4.0)
        bounds = [bound for bound, *_ in found]
        off = [(degrees(atan2(y - 0.5, x - 0.5)) - yaw + 180) % 360 - 180 for _, _, x, y, _, _ in found]

        assert bounds == sorted(bounds)
        assert max(map(abs, off)) < 90
        assert len(found) == len({id(view[-1]) for view in found})
        _, again = views.of(wedge, 2.0)
        assert again is found
        known, farther = views.of(wedge, 5.0)
        assert (known, len(farther)) == (5.0, len(found))
