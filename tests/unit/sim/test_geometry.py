"""Plane geometry with small numbers, worked out by hand."""

from math import inf, sqrt

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
    ],
)
def test_a_direction_is_exact_at_right_angles(angle: float, x: float, y: float) -> None:
    found = geometry.direction(angle)

    assert found == ((x, y) if angle % 90 == 0 else pytest.approx((x, y)))


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
    assert geometry.seen_from([(2.0, 3.0)], 1.0, 1.0, 45.0)[0] == pytest.approx((3 * HALF, HALF))


def test_a_polygon_has_edges_an_area_and_an_inside() -> None:
    assert geometry.edges(UNIT) == (
        *((0.0, 1.0, 0.0, 0.0), (0.0, 0.0, 1.0, 0.0)),
        *((1.0, 0.0, 1.0, 1.0), (1.0, 1.0, 0.0, 1.0)),
    )
    assert geometry.signed_area(UNIT) == 1.0
    assert geometry.signed_area(UNIT[::-1]) == -1.0
    assert geometry.signed_area(ARROW) == 6.0  # a triangle of 8 without one of 2
    assert [geometry.contains(ARROW, *each) for each in ((3, 1), (1, 0.4), (2, 2), (5, 1), (-1, 0.5))] == [
        *(True, True, False),
        *(False, False),
    ]


@pytest.mark.parametrize(
    ("points", "is_convex"),
    [
        (UNIT, True),
        (UNIT[::-1], True),
        (ARROW, False),
        (ARROW[::-1], False),
        (((0, 0), (1, 0), (2, 0), (2, 2)), True),  # a corner that does not turn
        (((0, 3), (2, -3), (-3, 1), (3, 1), (-2, -3)), False),  # a star goes round twice
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


def test_a_disc_with_a_skin_stops_earlier_and_passes_what_its_body_passes() -> None:
    assert geometry.disc_contact(1.0, (5, -3, 5, 3), 0.5) == 3.5
    assert geometry.disc_contact(1.0, (5, 1.2, 5, 3), 0.5) == inf


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


def test_the_points_of_an_edge_at_a_distance_from_the_origin() -> None:
    assert geometry.at_radius(5, (3, -9, 3, 9)) == [pytest.approx((3, -4)), pytest.approx((3, 4))]
    assert geometry.at_radius(5, (3, 0, 3, 9)) == [pytest.approx((3, 4))]
    assert geometry.at_radius(5, (3, -3, 3, 3)) == []
    assert geometry.at_radius(5, (6, -9, 6, 9)) == []
    assert geometry.at_radius(5, (3, 4, 3, 4)) == []
    assert geometry.at_radius(5, (5, 0, 9, 0)) == [pytest.approx((5, 0))]


@pytest.mark.parametrize(
    ("x", "y", "overlap"),
    [(0.5, 0.5, True), (1, 0, False), (0, 1, False), (1.1, 0, False), (0.9, 0.9, True), (-0.9, 0.2, True)],
)
def test_polygons_overlap_where_they_share_more_than_a_border(x: float, y: float, overlap: bool) -> None:
    other = tuple((px + x, py + y) for px, py in UNIT)

    assert geometry.overlapping(UNIT, other) is overlap
    assert geometry.overlapping(other, UNIT) is overlap


def test_a_cross_overlaps_though_no_corner_is_inside() -> None:
    tall, wide = ((1, -5), (2, -5), (2, 5), (1, 5)), ((-5, 1), (5, 1), (5, 2), (-5, 2))

    assert geometry.overlapping(tall, wide)


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


def test_spots_lie_ahead_and_carry_what_is_mounted() -> None:
    spot = Spot(1, 2, 90)

    assert spot.ahead(3, 180) == Spot(-2, 2, 90)
    assert spot.ahead(3, 270) == Spot(1, -1, 90)
    assert spot.mounted(2, 1, 45) == Spot(0, 4, 135)


@pytest.mark.parametrize(
    ("spot", "pose"),
    [
        (Spot(0.15, 0.05, 90), Pose(3, 1, 0)),
        (Spot(-0.0, -0.05, 0), Pose(0, -1, 90)),
        (Placement(0.1, 0.0, 9, -90), Pose(2, 0, 180)),
        (Spot(0, 0, 180), Pose(0, 0, 270)),
        (Spot(0, 0, 90 + 1e-12), Pose(0, 0, 0)),  # not 360
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
    assert cells(box, 0.6) == {(x, y) for x in range(4) for y in range(4)}
