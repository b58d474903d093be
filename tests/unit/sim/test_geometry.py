"""Plane geometry with small numbers, worked out by hand."""

from math import acos, atan2, cos, degrees, hypot, inf, radians, sin, sqrt
from random import Random

import pytest

from devices.ports.robot import Pose
from sim import geometry
from sim.geometry import Placement, Point, Raster, Spot

UNIT = ((0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0))
ARROW = ((0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (2.0, 1.0))
"""Not convex: its last corner goes inwards."""
HALF = sqrt(0.5)


@pytest.mark.parametrize(
    ("angle", "x", "y"),
    [
        (0, 1, 0),
        (90, 0, 1),
        (180, -1, 0),
        (270, 0, -1),
        (-90, 0, -1),
        (450, 0, 1),
        (45, HALF, HALF),
        (225, -HALF, -HALF),
        (30, sqrt(0.75), 0.5),
        (-60, 0.5, -sqrt(0.75)),
        (-1e-20, 1, 0),  # its remainder of 360 is 360
    ],
)
def test_a_direction_is_exact_at_right_angles(angle: float, x: float, y: float) -> None:
    found = geometry.direction(angle)

    assert found == ((x, y) if angle % 90 % 90 == 0 else pytest.approx((x, y)))


@pytest.mark.parametrize(
    ("angle", "same"),
    [(0, 0), (180, 180), (181, -179), (-180, 180), (-181, 179), (360, 0), (725, 5), (270, -90)],
)
def test_an_angle_is_normal_from_above_minus_180_to_180(angle: float, same: float) -> None:
    assert geometry.normal(angle) == same


def test_an_angle_of_a_vector_counts_counter_clockwise_from_x() -> None:
    assert [geometry.angle_of(*each) for each in ((1, 0), (0, 2), (-1, 0), (0, -1))] == [0, 90, 180, -90]


def test_a_frame_is_placed_and_seen_from() -> None:
    """Turned by 90 degrees, 2 ahead is 2 to the north, and 1 to the left is 1 to the west."""
    assert geometry.placed([(2.0, 1.0)], 10.0, 20.0, 90.0) == ((9.0, 22.0),)
    assert geometry.seen_from([(9.0, 22.0)], 10.0, 20.0, 90.0) == ((2.0, 1.0),)
    assert geometry.placed([(sqrt(2), 0.0)], 1.0, 1.0, 45.0)[0] == pytest.approx((2.0, 2.0))
    assert geometry.placed([(2.0, 1.0)], 1.0, 3.0, 45.0)[0] == pytest.approx((1 + HALF, 3 + 3 * HALF))
    assert geometry.seen_from([(2.0, 3.0)], 1.0, 1.0, 45.0)[0] == pytest.approx((3 * HALF, HALF))
    assert geometry.seen_from([(3.0, 7.0)], 1.0, 3.0, 30.0)[0] == pytest.approx(
        (2 * sqrt(0.75) + 2, 4 * sqrt(0.75) - 1)
    )


def test_a_polygon_has_edges_an_area_and_an_inside() -> None:
    assert geometry.edges(UNIT) == (
        *((0.0, 1.0, 0.0, 0.0), (0.0, 0.0, 1.0, 0.0)),
        *((1.0, 0.0, 1.0, 1.0), (1.0, 1.0, 0.0, 1.0)),
    )
    assert geometry.signed_area(UNIT) == 1.0
    assert geometry.signed_area(UNIT[::-1]) == -1.0
    assert geometry.signed_area(ARROW) == 6.0  # a triangle of 8 without one of 2
    assert geometry.signed_area(((1.0, 2.0), (4.0, 3.0), (3.0, 7.0))) == 6.5  # half of 3 * 5 - 2 * 1
    assert [geometry.contains(ARROW, *each) for each in ((3, 1), (1, 0.4), (2, 2), (5, 1), (-1, 0.5))] == [
        *(True, True, False),
        *(False, False),
    ]
    diamond = ((1, 0), (0, 1), (-1, 0), (0, -1))
    level = [geometry.contains(diamond, x, 0) for x in (-2, -0.9, 0, 0.9, 2)]
    assert level == [False, True, True, True, False]  # corners at the same height are met once


@pytest.mark.parametrize(
    ("points", "is_convex"),
    [
        (UNIT, True),
        (UNIT[::-1], True),
        (ARROW, False),
        (ARROW[::-1], False),
        (((0, 0), (1, 0), (2, 0), (2, 2)), True),  # a corner that does not turn
        (((2, 2), (2, 0), (1, 0), (0, 0)), True),
        (((0, 3), (2, -3), (-3, 1), (3, 1), (-2, -3)), False),  # a star goes round twice
        (((-2, -3), (3, 1), (-3, 1), (2, -3), (0, 3)), False),
        (((0, 0), (4, 0), (4, 3.9), (3.9, 4), (0, 4)), True),  # with a small corner
        (((0, 0), (4, 0), (4, 4), (2.1, 4), (2, 3.9), (1.9, 4), (0, 4)), False),  # with a small notch
        (tuple((3 * cos(i / 2), 2 * sin(i / 2)) for i in range(12)), True),
        (tuple((3 * cos(i / 2), -2 * sin(i / 2)) for i in range(12)), True),
    ],
)
def test_an_outline_is_convex_if_no_corner_turns_back(points: tuple[Point, ...], is_convex: bool) -> None:
    assert geometry.is_convex(points) is is_convex


@pytest.mark.parametrize(
    ("edge", "nearest"),
    [
        ((2, -1, 2, 3), (2, 0)),
        ((2, 1, 2, 3), (2, 1)),
        ((2, -3, 2, -1), (2, -1)),
        ((2, 2, 2, 2), (2, 2)),
        ((4, 0, 0, 4), (2, 2)),
        ((3, 1, 5, 3), (3, 1)),
    ],
)
def test_the_nearest_point_of_an_edge(edge: geometry.Edge, nearest: Point) -> None:
    assert geometry.nearest_on_edge(edge) == nearest


@pytest.mark.parametrize(
    ("edge", "half_angle", "point"),
    [
        ((3, -5, 3, 5), 45, (3, 0)),
        ((3, 1, 3, 5), 45, (3, 1)),
        ((3, 2, 3, 5), 45, (3, 2)),
        ((3, 4, 3, 5), 45, None),  # beyond 3, 3 to the left
        ((3, -4, 3, -5), 45, None),
        ((-3, -5, -3, 5), 90, None),  # behind
        ((-1, 4, 3, 4), 90, (0, 4)),
        ((-4, 0, 4, 2), 45, (4 / 3, 4 / 3)),  # where it enters the wedge
        ((6, 5.9, 2, 1.9), 45, (2, 1.9)),
        ((5, -1, 1, -5), 45, (3, -3)),
    ],
)
def test_what_is_nearest_in_a_wedge(edge: geometry.Edge, half_angle: float, point: Point | None) -> None:
    found = geometry.nearest_point_in_wedge([edge, (50, -50, 50, 50)] if point else [edge], half_angle)
    gap = geometry.nearest_in_wedge([(90, -90, 90, 90), edge] if point else [edge], half_angle)

    assert found == (None if point is None else pytest.approx(point))
    assert gap == (inf if point is None else pytest.approx(sqrt(point[0] ** 2 + point[1] ** 2)))
    outline = ((edge[0], edge[1]), (edge[2], edge[3]))
    facing, aside = geometry.direction(0), geometry.direction(half_angle)
    assert geometry.nearest_seen(outline, 0, 0, facing, aside) == pytest.approx(gap)
    there = geometry.placed(outline, 7, 8, 120)
    assert geometry.nearest_seen(there, 7, 8, geometry.direction(120), aside) == pytest.approx(gap)


def nearest_of_triangle(corners: tuple[Point, ...], half_angle: float) -> float:
    """Of the feet of the origin, the corners, and where the wedge's sides cross, those that it sees."""
    found = [inf]
    for (ax, ay), (bx, by) in zip(corners, (*corners[1:], corners[0]), strict=True):
        dx, dy = bx - ax, by - ay
        parts = [0.0, -(ax * dx + ay * dy) / (dx * dx + dy * dy)]
        for angle in (half_angle, -half_angle):
            c, s = cos(radians(angle)), sin(radians(angle))
            parts.append((s * ax - c * ay) / (c * dy - s * dx))
        places = [(ax + t * dx, ay + t * dy) for t in parts if 0 <= t <= 1]
        seen = (hypot(x, y) for x, y in places if abs(degrees(atan2(y, x))) <= half_angle + 1e-9)
        found.extend(seen)
    return min(found)


@pytest.mark.parametrize("half_angle", [2.0, 7.5, 30.0, 45.0])
def test_a_wedge_sees_of_a_triangle_what_lies_between_its_sides(half_angle: float) -> None:
    chance = Random(1)
    aside, seen = geometry.direction(half_angle), 0
    for _ in range(150):
        corners = tuple((chance.uniform(-2, 2), chance.uniform(-2, 2)) for _ in range(3))
        expected = nearest_of_triangle(corners, half_angle)
        seen += expected < inf

        assert geometry.nearest_in_wedge(geometry.edges(corners), half_angle) == pytest.approx(expected)
        point = geometry.nearest_point_in_wedge(geometry.edges(corners), half_angle)
        assert (inf if point is None else hypot(*point)) == pytest.approx(expected)
        there = geometry.placed(corners, 7, 8, 120)
        found = geometry.nearest_seen(there, 7, 8, geometry.direction(120), aside)
        assert found == pytest.approx(expected)
        for most in (0.5, 1.5):
            found = geometry.nearest_seen(there, 7, 8, geometry.direction(120), aside, most)
            assert found == pytest.approx(min(most, expected))
    assert 10 < seen < 140


@pytest.mark.parametrize(
    ("edge", "half_angle", "point"),
    [
        ((0, -5, 0, 5), 90, (0, 0)),
        ((0, 1, 0, 5), 90, (0, 1)),  # on the side of the wedge
        ((0, 1, -1, 1), 90, (0, 1)),  # with one end
        ((-1, -1, 0, -1), 90, (0, -1)),
        ((-0.5, 0.5, -0.5, 5), 90, None),
        ((0.5, 0.25, 0.5, 0.25), 45, (0.5, 0.25)),
        ((0.5, 0.75, 0.5, 0.75), 45, None),
        ((-0.5, 0.5, 0.25, -0.25), 90, (0, 0)),
        ((2, -0.5, 0.5, 0.25), 90, (0.5, 0.25)),
        ((-3, -1, 1, 1), 0, None),  # a ray, which the edge crosses behind it
        ((-2, -1, -2, 1), 0, None),
        ((2, -1, 2, 1), 0, (2, 0)),
    ],
)
def test_an_edge_on_the_border_of_a_wedge_is_seen(
    edge: geometry.Edge, half_angle: float, point: Point | None
) -> None:
    gap = inf if point is None else hypot(*point)

    for each in (edge, (*edge[2:], *edge[:2])):
        assert geometry.nearest_point_in_wedge([each], half_angle) == point
        assert geometry.nearest_in_wedge([each], half_angle) == gap
    outline = ((edge[0], edge[1]), (edge[2], edge[3]))
    assert geometry.nearest_seen(outline, 0, 0, (1, 0), geometry.direction(half_angle)) == gap


@pytest.mark.parametrize(
    ("left", "bottom", "right", "top", "x", "y", "metres"),
    [
        (1, 0, 5, 4, 1.5, 0.25, 0),
        (0, 0, 0.2, 4, 0.05, 0.1, 0),
        (0, 0, 4, 0.2, 0.1, 0.05, 0),
        (0, 0, 4, 0.2, 3.9, 0.05, 0),
        (-2, 3, 6, 3.5, 2, 1, 2),  # in the circle around the bar, but before it
        (-2, 3, 6, 3.5, 2, 3.75, 9),  # after it
        (-2, 3, 6, 3.5, 2, -5, 8),
        (-2, 3, 6, 3.5, 2, -6.5, 9),
        (4, 3, 6, 3.5, 2, 2, 9),  # to the right
    ],
)
def test_a_wedge_begins_inside_or_outside_of_a_polygon(
    left: float, bottom: float, right: float, top: float, x: float, y: float, metres: float
) -> None:
    """It looks to the north, 45 degrees to either side, and 9 m far."""
    wedge = geometry.Wedge(x, y, 90, (0, 1), geometry.direction(45), 9)
    points = ((left, bottom), (right, bottom), (right, top), (left, top))
    middle, radius = ((left + right) / 2, (bottom + top) / 2), hypot(right - left, top - bottom) / 2

    assert wedge.metres(points, middle, radius, 9) == metres


def test_nothing_beyond_the_reach_is_looked_for() -> None:
    wall = ((3.0, -5.0), (3.0, 5.0))

    assert geometry.nearest_seen(wall, 0, 0, (1, 0), (HALF, HALF), 4.0) == 3.0
    assert geometry.nearest_seen(wall, 0, 0, (1, 0), (HALF, HALF), 2.0) == 2.0
    assert geometry.nearest_seen(wall, 1, 0, (1, 0), (HALF, HALF)) == 2.0


@pytest.mark.parametrize(
    ("edge", "way"),
    [
        ((5, -3, 5, 3), 4),
        ((5, 0.6, 5, 3), 5 - 0.8),  # by the end of the edge: a triangle of 0.6, 0.8, 1
        ((5, -3, 5, -0.6), 5 - 0.8),
        ((5, 1, 5, 3), inf),
        ((5, 1.1, 5, 3), inf),
        ((-5, -3, -5, 3), inf),
        ((4, -4, 12, 4), 8 - sqrt(2)),  # the line crosses the way at 8 with 45 degrees
        ((12, -4, 4, 4), 8 - sqrt(2)),
        ((2, 0, 9, 0), 1),
        ((1, -3, 1, 3), 0),
        ((-1, -3, -1, 3), inf),  # touches behind: it may leave
        ((0.5, 0, 0.5, 0), 0),
        ((5, 0, 5, 0), 4),
    ],
)
def test_a_disc_moves_until_it_touches_an_edge(edge: geometry.Edge, way: float) -> None:
    assert geometry.disc_contact(1.0, edge) == pytest.approx(way)


def metres_apart(edge: geometry.Edge, x: float) -> float:
    """Of the edge and the place at x, 0."""
    ax, ay, bx, by = edge
    dx, dy = bx - ax, by - ay
    part = min(1.0, max(0.0, ((x - ax) * dx - ay * dy) / (dx * dx + dy * dy)))
    return hypot(ax + part * dx - x, ay + part * dy)


def way_by_halving(radius: float, edge: geometry.Edge) -> float:
    """The distance from a moving place to an edge falls, and then rises again."""
    low, high = 0.0, 10.0
    for _ in range(80):
        one, other = (2 * low + high) / 3, (low + 2 * high) / 3
        low, high = (low, other) if metres_apart(edge, one) < metres_apart(edge, other) else (one, high)
    low, high = 0.0, low
    if metres_apart(edge, high) >= radius:
        return inf
    for _ in range(40):
        middle = (low + high) / 2
        low, high = (low, middle) if metres_apart(edge, middle) < radius else (middle, high)
    return high


def test_a_disc_stops_where_it_is_as_far_from_an_edge_as_it_is_wide() -> None:
    chance, met = Random(2), 0
    while met < 40:
        edge = (*(chance.uniform(-2, 4) for _ in range(4)),)
        radius = chance.choice((0.5, 1.25))
        if metres_apart(edge, 0.0) > radius:
            expected = way_by_halving(radius, edge)
            met += expected < inf
            assert geometry.disc_contact(radius, edge) == pytest.approx(expected, abs=1e-7)


@pytest.mark.parametrize(
    ("edge", "way"),
    [
        ((0.25, 0.25, 0.5, 3), 0),  # it reaches into what is ahead, or touches it
        ((0.6, 0.8, 0.6, 3), 0),
        ((0.6, -0.8, 0.6, -3), 0),
        ((-0.25, 0.25, -0.5, 3), inf),  # and may leave what is behind
        ((-0.6, 0.8, -0.6, 3), inf),
        ((0, 1, 0, 3), inf),  # or at its side
        ((-3, 1, 3, 1), inf),
        ((-3, -0.5, 3, -0.5), inf),
        ((-0.5, -3, 0, 3), inf),
        ((-3, 1.5, 3, 1.5), inf),
        ((0.25, 1, 0.25, 3), inf),
        ((0.25, -1, 0.25, -3), inf),
        ((0.25, 0.999, 0.25, 3), 0.25 - sqrt(1 - 0.999**2)),
    ],
)
def test_a_disc_that_touches_an_edge_may_only_leave(edge: geometry.Edge, way: float) -> None:
    for each in (edge, (*edge[2:], *edge[:2])):
        assert geometry.disc_contact(1.0, each) == pytest.approx(way)


def test_a_disc_with_a_skin_stops_earlier_and_passes_what_its_body_passes() -> None:
    assert geometry.disc_contact(1.0, (5, -3, 5, 3), 0.5) == 3.5
    assert geometry.disc_contact(1.0, (5, 1.2, 5, 3), 0.5) == inf
    assert geometry.disc_contact(1.0, (1.25, -3, 1.25, 3), 0.5) == 0
    assert geometry.disc_contact(1.0, (-5, -3, -5, 3), 0.5) == inf
    assert geometry.disc_contact(1.0, (5, 0, 5, 0), 0.5) == 3.5


def square(x: float, y: float, side: float = 2.0) -> tuple[geometry.Edge, ...]:
    return geometry.edges(((x, y), (x + side, y), (x + side, y + side), (x, y + side)))


@pytest.mark.parametrize(
    ("obstacle", "way", "squarely"),
    [
        (square(5, 0), 3, 1),
        (square(5, 1.9), 3, 1),
        (square(5, 2), inf, 1),  # slides along its side
        (square(5, -2), inf, 1),
        (square(5, -1.9), 3, 1),
        (square(-5, 0), inf, 1),
        (square(2, 0), 0, 1),
        (geometry.edges(((6, 1), (8, -1), (8, 3))), 4, 1),
        (geometry.edges(((2, 3), (5, 0), (5, 3))), 1, 1),
    ],
)
def test_an_outline_moves_until_it_touches_another(
    obstacle: tuple[geometry.Edge, ...], way: float, squarely: float
) -> None:
    assert geometry.outline_contact(square(0, 0), obstacle) == (way, squarely)


def x_range_at(corners: tuple[Point, ...], y: float) -> tuple[float, float]:
    """The least and the most x of a triangle at that height."""
    xs = []
    for (ax, ay), (bx, by) in zip(corners, (*corners[1:], corners[0]), strict=True):
        if min(ay, by) <= y <= max(ay, by):
            xs.extend([ax, bx] if ay == by else [ax + (y - ay) / (by - ay) * (bx - ax)])
    return min(xs), max(xs)


def test_a_triangle_goes_as_far_as_the_least_gap_before_another_one() -> None:
    """The gap is least at the height of a corner."""
    chance, met, passed = Random(3), 0, 0
    while met < 60 or passed < 60:
        mine, other = (
            tuple((chance.uniform(-2, 2) + ahead, chance.randrange(-4, 5) / 2) for _ in range(3))
            for ahead in (0, chance.choice((-3, 3)))
        )
        low = max(min(y for _, y in each) for each in (mine, other))
        high = min(max(y for _, y in each) for each in (mine, other))
        if abs(geometry.signed_area(mine)) < 0.1 or geometry.overlapping(mine, other):
            continue
        heights = {*(y for _, y in (*mine, *other) if low <= y <= high)} if low < high else set()
        gaps = [x_range_at(other, y)[0] - x_range_at(mine, y)[1] for y in heights]
        expected = min(gaps, default=inf) if min(gaps, default=0) >= 0 else inf
        met, passed = met + (expected < inf), passed + (expected == inf)

        found, _ = geometry.outline_contact(geometry.edges(mine), geometry.edges(other))
        assert found == pytest.approx(expected)


@pytest.mark.parametrize(
    ("mover", "obstacle", "way", "squarely"),
    [
        ([(0, 0, 0, 1)], [(5, 0, 5, 1), (9, 0, 9, 1), (1, 0, 1, 1)], 1, 1),
        ([(0, 100, 0, 101)], [(5, 100, 5, 101), (1, 100, 9, 101)], 1, 1),
        ([(0, 100, 0, 101)], [(5, 100, 5, 101), (9, 101, 1, 100)], 1, 1),
        ([(0, -100, -8, -99)], [(5, -100, 5, -99), (1, -100, 1, -99)], 1, 1),
        ([(-8, -99, 0, -100)], [(5, -100, 5, -99), (1, -100, 1, -99)], 1, 1),
        ([(5, 0, 5, 1)], [(8, 0, 8, 1), (6, 0, 6, 1)], 1, 1),
        ([(1, 0, 1, 5), (-3, 0, -3, 5)], [(4, 1, 4, 2)], 3, 1),
        ([(-3, 0, -3, 5), (1, 0, 1, 5)], [(4, 1, 4, 2)], 3, 1),
        ([(0, 0, 3, 4)], [(5, 0, 8, 4)], 5, 0.8),
        ([(3, 4, 0, 0)], [(5, 0, 8, 4)], 5, 0.8),
        ([(0, 0, 4, 3)], [(9, 0, 13, 3)], 9, 0.6),
        ([(0, 0, 4, -3)], [(9, 0, 13, -3)], 9, 0.6),
        ([(0, 0, 4, 3)], [(10, 0, 10, 3)], 6, 1),
        ([(0, 1, 2, 1), (0, 0, 0, 1)], [(5, 0, 8, 4)], 3.75, 0.8),
        ([(2, 1, 0, 1), (0, 0, 0, 1)], [(8, 4, 5, 0)], 3.75, 0.8),
        ([(0, 0, 3, 4)], [(9, 2, 7, 2), (9, 1, 9, 2)], 5.5, 0.8),
        ([(0, 0, 3, 4)], [(7, 2, 9, 2), (9, 1, 9, 2)], 5.5, 0.8),
        ([(2, 1, 2, 1), (0, 0, 0, 2)], [(5, 0, 8, 4)], 3.75, 1),
        ([(0, 0, 0, 5)], [(-5, 0, 3, 4)], 0, 1),
        ([(0, 0, 0, 5)], [(3, 0, -5, 4)], 0, 1),
        ([(0, 0, 0, 5)], [(-5, 0, -0.5, 4)], inf, 1),
        ([(0, 0, 0, 5)], [(-1e-10, 0, -1e-10, 4)], 0, 1),  # a rounding error
        ([(0, 0, 0, 5)], [(-1e-6, 0, -1e-6, 4)], inf, 1),
    ],
)
def test_an_outline_meets_the_nearest_edge_of_all(
    mover: list[geometry.Edge], obstacle: list[geometry.Edge], way: float, squarely: float
) -> None:
    """The other sides are far away, and as high."""

    def closed(outline: list[geometry.Edge], far: float) -> list[geometry.Edge]:
        ys = [y for edge in outline for y in edge[1::2]]
        return [*outline, (far, min(ys), far, max(ys)), (far, max(ys), far, min(ys))]

    found = geometry.outline_contact(closed(mover, -1000), closed(obstacle, 1000))
    assert found == pytest.approx((way, squarely)) if way < inf else found[0] > 900


@pytest.mark.parametrize(
    ("bottom", "top", "passes"),
    [(-3, 0, True), (-3, 0.01, False), (1, 4, True), (0.99, 4, False), (-3, 4, False), (7, 8, True)],
)
def test_what_only_slides_along_a_side_passes_by(bottom: float, top: float, passes: bool) -> None:
    """The mover reaches from 0 to 1."""
    mover, other = geometry.edges(UNIT), geometry.edges(((5, bottom), (6, bottom), (5, top)))

    assert geometry.passes_by(mover, other) is passes
    assert geometry.passes_by((), other) is True


def test_two_slopes_meet_as_squarely_as_the_steeper_one() -> None:
    diamond = geometry.edges(((0, -1), (1, 0), (0, 1), (-1, 0)))
    flat = geometry.edges(((4, 0.5), (8, 0.5), (8, 0.6)))

    way, squarely = geometry.outline_contact(diamond, flat)

    assert (way, squarely) == pytest.approx((3.5, HALF))


@pytest.mark.parametrize(
    ("obstacle", "sign", "degrees"),
    [
        (((0, 1), (0, 5)), 1, 90),  # the point at 2, 0 turns to 0, 2
        (((0, 1), (0, 5)), -1, 270),
        (((0, 3), (0, 5)), 1, inf),
        (((-1, 0), (-5, 0)), 1, 180),
        (((1, 0), (5, 0)), 1, 0),
    ],
)
def test_a_point_turns_until_it_meets_an_edge(
    obstacle: tuple[Point, Point], sign: int, degrees: float
) -> None:
    mine = ((2.0, 0.0, 2.0, 0.0),)
    ((ax, ay), (bx, by)) = obstacle
    found = geometry.turn_contact(mine, [(ax, ay, bx, by)], sign)

    assert found == pytest.approx(degrees)


@pytest.mark.parametrize(
    ("mover", "obstacle", "sign", "degrees"),
    [
        ([(2, 0, 1, 0)], [(-3, 0, -0.5, 0)], 1, 180),  # the far corner or the near one, together
        ([(2, 0, 0, 2)], [(0, -1.5, 0, -9)], -1, 90),  # a corner of 2 m, and another one that comes later
        ([(2, 0, 0, 2)], [(0, -1.5, 0, -9)], 1, 225 - degrees(acos(sqrt(2) / 1.5))),
        ([(0, 2, 2, 0)], [(0, -1.5, 0, -9)], 1, 180),
        ([(1, 0, 9, 0)], [(0, 2, 0, 2)], 1, 90),  # a corner of the obstacle, and a side of the mover
        ([(1, 0, 9, 0)], [(0, 2, 0, 2)], -1, 270),
        ([(3, 0, 9, 0)], [(0, 2, 0, 2)], 1, inf),
        ([(1, 0, 9, 0)], [(0, 2, 0, 2), (0, -3, 0, -3)], -1, 90),
        ([(1, 0, 1, 0)], [(0.5, 0.5, 2, 2), (-2, 0, -0.5, 0)], 1, 45),
        ([(1, 0, 1, 0)], [(-2, 0, -0.5, 0), (0.5, 0.5, 2, 2)], 1, 45),
        ([(1, 0, 1, 0)], [(0.5, -0.5, 2, -2)], 1, 315),
        ([(0, 0, 0, 0)], [(1, 0, 2, 0)], 1, inf),
        ([(2, 0, 2, 0)], [(2, 0, 2, 5)], -1, 0),  # it touches already
        ([(2, 0, 2, 0)], [(1, -2e-12, 5, -1e-11)], 1, 0),  # but for a rounding error
        ([(2, 0, 2, 0)], [(1, -2e-7, 5, -1e-6)], 1, 360 - degrees(2e-7)),
    ],
)
def test_a_turn_ends_at_the_first_corner_of_either(
    mover: list[geometry.Edge], obstacle: list[geometry.Edge], sign: int, degrees: float
) -> None:
    assert geometry.turn_contact(mover, obstacle, sign) == pytest.approx(degrees)


def test_the_points_of_an_edge_at_a_distance_from_the_origin() -> None:
    assert geometry.at_radius(5, (3, -9, 3, 9)) == [pytest.approx((3, -4)), pytest.approx((3, 4))]
    assert geometry.at_radius(5, (3, 0, 3, 9)) == [pytest.approx((3, 4))]
    assert geometry.at_radius(5, (3, -3, 3, 3)) == []
    assert geometry.at_radius(5, (6, -9, 6, 9)) == []
    assert geometry.at_radius(5, (3, 4, 3, 4)) == []
    assert geometry.at_radius(5, (5, 0, 9, 0)) == [pytest.approx((5, 0))]
    assert geometry.at_radius(5, (1, 0, 5, 0)) == [pytest.approx((5, 0))]
    assert geometry.at_radius(5, (-7, 1, 7, -1)) == [
        pytest.approx((-sqrt(24.5), sqrt(0.5))),
        pytest.approx((sqrt(24.5), -sqrt(0.5))),
    ]
    # 14.4 m away at 8.64, 11.52, and 4.2 m on, to either side, it is 15 m away
    assert geometry.at_radius(15, (0, 18, 24, 0)) == [pytest.approx((5.28, 14.04)), pytest.approx((12, 9))]
    assert geometry.at_radius(15, (24, 0, 8.64, 11.52)) == [pytest.approx((12, 9))]


@pytest.mark.parametrize(
    ("x", "y", "overlap"),
    [(0.5, 0.5, True), (1, 0, False), (0, 1, False), (1.1, 0, False), (0.9, 0.9, True), (-0.9, 0.2, True)],
)
def test_polygons_overlap_where_they_share_more_than_a_border(x: float, y: float, overlap: bool) -> None:
    other = tuple((px + x, py + y) for px, py in UNIT)

    assert geometry.overlapping(UNIT, other) is overlap
    assert geometry.overlapping(other, UNIT) is overlap


def have_a_line_between(mine: tuple[Point, ...], other: tuple[Point, ...]) -> bool:
    """Whether all of a triangle lies on one side of one of its edges, and all of the other one beyond it."""
    for points, against in ((mine, other), (other, mine)):
        for (ax, ay), (bx, by), (cx, cy) in (points, points[1:] + points[:1], points[2:] + points[:2]):
            inside = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
            if all(inside * ((bx - ax) * (y - ay) - (by - ay) * (x - ax)) <= 0 for x, y in against):
                return True
    return False


def test_triangles_overlap_unless_there_is_a_line_between_them() -> None:
    chance, overlap, apart = Random(4), 0, 0
    while overlap < 60 or apart < 60:
        mine, other = (tuple((chance.uniform(-2, 2), chance.uniform(-2, 2)) for _ in range(3)) for _ in "ab")
        expected = not have_a_line_between(mine, other)
        overlap, apart = overlap + expected, apart + (not expected)

        assert geometry.overlapping(mine, other) is expected


@pytest.mark.parametrize(
    ("x", "y", "size", "overlap"),
    [
        *((0.25, 0.25, 0.5, True), (-1, -1, 3, True)),  # one within the other
        *((1.5, 0, 1, False), (-1.5, 0, 1, False), (0, 1.5, 1, False), (0, -1.5, 1, False)),
        *((1.5, 1.5, 1, False), (-1.5, 1.5, 1, False), (0.75, 0.75, 1, True), (-0.75, -0.75, 1, True)),
    ],
)
def test_squares_overlap_on_every_side(x: float, y: float, size: float, overlap: bool) -> None:
    other = ((x, y), (x + size, y), (x + size, y + size), (x, y + size))

    assert geometry.overlapping(UNIT, other) is overlap
    assert geometry.overlapping(other, UNIT) is overlap


def test_what_lies_in_the_hollow_of_a_polygon_does_not_overlap_with_it() -> None:
    hollow = ((0, 0), (4, 0), (4, 4), (3, 4), (3, 1), (1, 1), (1, 4), (0, 4))
    within, across = ((1.5, 2), (2.5, 2), (2.5, 5)), ((1.5, 2), (3.5, 2), (2.5, 5))

    assert not geometry.overlapping(hollow, within)
    assert not geometry.overlapping(within, hollow)
    assert geometry.overlapping(hollow, across)
    assert geometry.overlapping(across, hollow)


def test_a_cross_overlaps_though_no_corner_is_inside() -> None:
    tall, wide = ((1, -5), (2, -5), (2, 5), (1, 5)), ((-5, 1), (5, 1), (5, 2), (-5, 2))

    assert geometry.overlapping(tall, wide)


def test_a_tip_that_touches_an_edge_overlaps_with_nothing() -> None:
    tip = ((0.0, 2.0), (0.5, 1.0), (1.0, 2.0))

    assert not geometry.overlapping(tip, UNIT)
    assert not geometry.overlapping(UNIT, tip)


@pytest.mark.parametrize(
    ("edge", "part"),
    [
        ((4, -1, 4, 1), 0.5),
        ((8, -1, 8, 0), 1),
        ((0, 0, 0, 5), 0),
        ((8.1, -1, 8.1, 1), inf),
        ((4, 1, 4, 2), inf),
        ((4, -2, 4, -1), inf),
        ((1, 1, 5, 1), inf),
        ((-1, -1, -1, 1), inf),
        ((1, -1, 3, 1), 0.25),
    ],
)
def test_where_a_ray_meets_an_edge(edge: geometry.Edge, part: float) -> None:
    assert geometry.along((0, 0, 8, 0), edge) == part


def test_a_ray_meets_the_edges_that_were_drawn_through_its_points() -> None:
    chance = Random(5)
    for _ in range(40):
        ax, ay, bx, by, dx, dy = (chance.uniform(-3, 3) for _ in range(6))
        for part in (-0.1, 0.1, 0.7, 0.9, 1.1, 1.9):
            x, y = ax + part * (bx - ax), ay + part * (by - ay)
            for before, after in ((0.3, 0.7), (0.9, 0.05), (-0.1, 0.8), (0.8, -0.1)):
                edge = (x - before * dx, y - before * dy, x + after * dx, y + after * dy)
                is_met = 0 <= part <= 1 and before > 0 and after > 0

                found = geometry.along((ax, ay, bx, by), edge)
                assert found == pytest.approx(part if is_met else inf)


def test_edges_are_as_far_apart_as_an_end_from_the_other_edge() -> None:
    chance, crossing = Random(6), 0
    for _ in range(60):
        mine, other = (tuple(chance.uniform(-2, 2) for _ in range(4)) for _ in "ab")
        ends = ((mine, other), (other, mine))
        gaps = []
        for (ax, ay, bx, by), (cx, cy, dx, dy) in ends:
            for x, y in ((ax, ay), (bx, by)):
                gaps.append(metres_apart((cx, cy - y, dx, dy - y), x))
        (ax, ay, bx, by), (cx, cy, dx, dy) = mine, other
        sides = [(bx - ax) * (y - ay) - (by - ay) * (x - ax) for x, y in ((cx, cy), (dx, dy))]
        sides += [(dx - cx) * (y - cy) - (dy - cy) * (x - cx) for x, y in ((ax, ay), (bx, by))]
        is_crossing = sides[0] * sides[1] < 0 and sides[2] * sides[3] < 0
        crossing += is_crossing

        found = geometry.edges_apart((ax, ay, bx, by), (cx, cy, dx, dy))
        assert found == pytest.approx(0 if is_crossing else min(gaps))
    assert 0 < crossing < 60


def test_how_far_edges_are_apart() -> None:
    mine = (0.0, 0.0, 4.0, 0.0)

    assert geometry.edges_apart(mine, (1, 3, 2, 2)) == 2
    assert geometry.edges_apart(mine, (7, 4, 9, 9)) == 5
    assert geometry.edges_apart(mine, (-3, -4, -3, -9)) == 5
    assert geometry.edges_apart(mine, (2, -1, 2, 1)) == 0
    assert geometry.edges_apart((2, 2, 2, 9), (0, 1, 9, 1)) == 1


def test_placements_follow_each_other_and_back() -> None:
    outer, inner = Placement(1, 2, 3, 90), Placement(5, 6, 7, 300)
    outside = outer.then(inner, lift=0.5)

    assert outside == Placement(1 - 6, 2 + 5, 10.5, 390)
    assert outside.within_a_turn() == Placement(-5, 7, 10.5, 30)
    assert geometry.relative(outside, outer) == Placement(5, 6, 7.5, 300)
    assert Placement() == Placement(0, 0, 0, 0)
    # turned by 30 degrees, 2 ahead and 4 to the left
    turned = Placement(1, 2, 3, 30).then(Placement(2, 4, 5, 6))
    assert (turned.x, turned.y) == pytest.approx((1 + 2 * sqrt(0.75) - 2, 2 + 1 + 4 * sqrt(0.75)))
    assert (turned.z, turned.yaw) == (8, 36)
    back = geometry.relative(turned, Placement(1, 2, 3, 30))
    assert (back.x, back.y, back.z, back.yaw) == pytest.approx((2, 4, 5, 6))


def test_spots_lie_ahead_and_carry_what_is_mounted() -> None:
    spot = Spot(1, 2, 90)

    assert spot.ahead(3, 180) == Spot(-2, 2, 90)
    assert spot.ahead(3, 270) == Spot(1, -1, 90)
    assert spot.mounted(2, 1, 45) == Spot(0, 4, 135)
    aslant = Spot(1, 2, 30).mounted(2, 4, 5)
    assert (aslant.x, aslant.y, aslant.yaw) == pytest.approx((2 * sqrt(0.75) - 1, 3 + 4 * sqrt(0.75), 35))
    ahead = spot.ahead(3, 30)
    assert (ahead.x, ahead.y, ahead.yaw) == pytest.approx((1 + 3 * sqrt(0.75), 3.5, 90))


@pytest.mark.parametrize(
    ("spot", "pose"),
    [
        (Spot(0.15, 0.05, 90), Pose(3, 1, 0)),
        (Spot(-0.0, -0.05, 0), Pose(0, -1, 90)),
        (Placement(0.1, 0.0, 9, -90), Pose(2, 0, 180)),
        (Spot(0, 0, 180), Pose(0, 0, 270)),
        (Spot(0, 0, 90 + 1e-12), Pose(0, 0, 0)),  # not 360
        (Spot(0, 0, 90.5), Pose(0, 0, 359.5)),
        (Spot(0, 0, -0.25), Pose(0, 0, 90.25)),
        (Spot(0, 0, -270), Pose(0, 0, 0)),
        (Spot(0.05 / 3, 0.15000000000000002, 1e-10), Pose(0.333333333, 3, 90)),
        (Spot(0, 0, 100.1234567891), Pose(0, 0, 349.876543211)),
        (Spot(0.123456789012, -0.05 * 0.4567890125, 0), Pose(2.46913578, -0.456789012, 90)),
    ],
)
def test_a_pose_is_in_steps_and_compass_degrees(spot: Spot | Placement, pose: Pose) -> None:
    found = geometry.pose_of(spot)

    assert found == pose
    assert str(found.x) != "-0.0"


def test_a_raster_covers_the_squares_of_a_polygon_and_not_those_at_its_border() -> None:
    """Cells of 1, the middle of the first one at 0, 0: the square from 0.5 to 2.5 covers two by two."""
    raster = Raster(0.0, 0.0, 1.0, 4, 5)
    box = ((0.5, 0.5), (2.5, 0.5), (2.5, 2.5), (0.5, 2.5))
    small = ((0.8, 2.9), (1.2, 2.9), (1.2, 3.1), (0.8, 3.1))

    def cells(outline: tuple[Point, ...], half: float) -> set[tuple[int, int]]:
        return {
            (column, row)
            for row, first, last in geometry.covered(outline, raster, half)
            for column in range(first, last + 1)
        }

    assert cells(box, 0.5) == {(1, 1), (2, 1), (1, 2), (2, 2)}
    assert cells(small, 0.5) == {(1, 3)}
    wide = ((-9.0, 3.6), (9.0, 3.6), (9.0, 9.0), (-9.0, 9.0))
    assert cells(wide, 0.5) == {(column, 4) for column in range(4)}
    assert cells(((-9.0, 9.0), (9.0, 9.0), (9.0, 12.0)), 0.5) == set()
    # a triangle with corners at 0, 0 and 3, 0 and 0, 3: half its squares, by their middles and its edge
    triangle = ((0.0, 0.0), (3.0, 0.0), (0.0, 3.0))
    assert cells(triangle, 0.5) == {(x, y) for x in range(4) for y in range(4) if x + y <= 3}
    assert cells(box[::-1], 0.5) == cells(box, 0.5)
    large = ((-0.4, -0.4), (-0.4, 4.4), (3.4, 4.4), (3.4, -0.4))  # clockwise, with squares far from its sides
    assert cells(large, 0.1) == {(x, y) for x in range(4) for y in range(5)}
    assert cells(box, 0.6) == {(x, y) for x in range(4) for y in range(4)}
    assert cells(box, 0.1) == {(1, 1), (2, 1), (1, 2), (2, 2)}
    beneath = ((-9.0, -9.0), (9.0, -9.0), (9.0, 0.4), (-9.0, 0.4))
    assert cells(beneath, 0.5) == {(column, 0) for column in range(4)}
    beside = ((3.4, 0.6), (9.0, 0.6), (9.0, 2.4), (3.4, 2.4))
    assert cells(beside, 0.5) == {(3, 1), (3, 2)}
    line = ((0.2, 1.0), (2.4, 1.0), (0.2, 1.0))  # without an area, but through the middles of squares
    assert cells(line, 0.1) == {(1, 1), (2, 1)}
