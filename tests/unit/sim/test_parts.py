"""The parts of a world as polygons at their places, and the body of a robot."""

from math import cos, hypot, pi, sin

import pytest

from sim.geometry import Placement
from sim.parts import body_of, parts_of
from tests.unit.sim.floors import scene


def polygon(corners: int, x: float = 0, radius: float = 1) -> str:
    """A block with that many corners around a place."""
    points = (
        (x + radius * cos(2 * pi * at / corners), radius * sin(2 * pi * at / corners))
        for at in range(corners)
    )
    written = " ".join(f"point[{at}] [ {px:.9f} {py:.9f} ]" for at, (px, py) in enumerate(points))
    return f"block ( points {corners} {written} )"


def test_each_polygon_is_a_part_with_the_place_and_the_heights_of_its_model() -> None:
    low, high = (
        f"block ( points 4 {box} z [ {z} ] )" for box, z in ((corners(0), "0 1"), (corners(2), "1 4"))
    )
    child = "model ( size [ 1 1 1 ] pose [ 1 0 0 0 ] )"
    it = scene(
        f"model ( size [ 3 1 2 ] pose [ 5 6 0.5 90 ] blob_return 0 {low} {high} {child} )"
        "model ( obstacle_return 0 size [ 1 1 0.01 ] ) position ( obstacle_return 0 ranger_return -1 )"
    )
    first, second, lid, mark, robot = parts_of(it)

    assert [each.rank for each in (first, second, lid, mark, robot)] == [0, 1, 2, 3, 4]
    assert [each.root for each in (first, second, lid, mark, robot)] == [0, 0, 0, 2, 3]
    assert [(each.bottom, each.top) for each in (first, second, lid)] == [(0.5, 1), (1, 2.5), (2.5, 3.5)]
    assert (first.place, lid.place) == ((5, 6), pytest.approx((5, 7)))
    assert first.middle == pytest.approx((5, 5))
    assert first.reach == pytest.approx(hypot(0.5, 0.5))
    assert len(first.outline) == 4
    assert [each.solid for each in (first, lid, mark, robot)] == [True, True, False, True]
    assert [each.seen for each in (first, lid, mark, robot)] == [True, True, False, False]
    assert [each.blob for each in (first, lid)] == [False, True]
    assert first.model.name == second.model.name != lid.model.name


def corners(x: float) -> str:
    at = enumerate(((x, 0), (x + 1, 0), (x + 1, 1), (x, 1)))
    return " ".join(f"point[{number}] [ {px} {py} ]" for number, (px, py) in at)


def test_a_part_moves_with_the_model_that_it_belongs_to() -> None:
    (_, lid) = parts_of(scene("model ( pose [ 5 6 0 90 ] model ( size [ 2 1 1 ] pose [ 1 0 0 0 ] ) )"))
    there = lid.moved(lid.seen_from(Placement(5, 6, 0, 90)), Placement(1, 1, 0, 0))

    assert {(round(x, 6), round(y, 6)) for x, y in there.points} == {(1, 0.5), (3, 0.5), (3, 1.5), (1, 1.5)}
    assert (there.place, there.middle) == (pytest.approx((2, 1)), pytest.approx((2, 1)))
    names = ("rank", "root", "model", "bottom", "top", "reach", "solid", "seen", "colour", "blob")
    assert [getattr(there, each) for each in names] == [getattr(lid, each) for each in names]


@pytest.mark.parametrize(
    ("shape", "radius", "is_round"),
    [
        # the inner circle is the cosine of half an angle of the outer one: 0.866, 0.901, 0.924
        *((polygon(4), 1, False), (polygon(6), 1, False), (polygon(7), 1, True), (polygon(8), 1, True)),
        (polygon(8) + polygon(4, x=2, radius=0.5), 2.5, False),
        (polygon(4) + polygon(8), 1, True),
        (polygon(8, x=2), 3, False),
    ],
)
def test_a_body_is_round_if_a_circle_in_it_is_nearly_as_wide_as_one_around_it(
    shape: str, radius: float, is_round: bool
) -> None:
    """Its size is that of its blocks, and it turns about its own place."""
    xs = [float(each) for each in numbers(shape, 0)]
    ys = [float(each) for each in numbers(shape, 1)]
    size = f"size [ {max(xs) - min(xs):.9f} {max(ys) - min(ys):.9f} 1 ]"
    origin = f"origin [ {(max(xs) + min(xs)) / 2:.9f} {(max(ys) + min(ys)) / 2:.9f} 0 ]"
    body = body_of(scene(f"position ( pose [ 7 8 0 30 ] {size} {origin} {shape} )"), 0)

    assert (body.radius, body.is_round) == (pytest.approx(radius, abs=1e-6), is_round)


def numbers(shape: str, side: int) -> list[str]:
    return [each.split()[side] for each in shape.split("[ ")[1:]]


def test_a_body_has_all_that_is_solid_and_its_own_shape_in_any_case() -> None:
    parts = (
        "model ( size [ 1 1 1 ] pose [ 1 0 0 0 ] ) model ( size [ 9 9 0.1 ] obstacle_return 0 ) ranger ( )"
    )
    body = body_of(scene(f"position ( size [ 1 1 1 ] obstacle_return 0 pose [ 3 3 0 90 ] {parts} )"), 0)

    assert len(body.polygons) == 2
    assert body.radius == pytest.approx(hypot(1.5, 0.5))
    assert len(body.outline(0)) == 8
    turned = {(round(ax, 6), round(ay, 6)) for ax, ay, _, _ in body.outline(90)}
    assert {(0.5, 1.5), (-0.5, 0.5), (0.5, -0.5)} <= turned
    held = body.holding([((4, 0), (5, 0), (5, 1))])
    assert (len(held.polygons), held.radius) == (3, pytest.approx(hypot(5, 1)))


def test_a_robot_without_a_shape_is_a_point() -> None:
    body = body_of(scene("ranger ( )"), 0)

    assert (body.polygons, body.radius, body.is_round) == ((), 0, True)
