"""What the sensors of a simulated robot read, against closed forms."""

from collections.abc import Sequence
from math import atan, cos, degrees, hypot, radians, sin

import pytest

from devices.ports.robot import Bearing, RobotProblem
from sim import cameras
from sim.geometry import Point, Spot
from sim.ground import Ground
from sim.motion import Surroundings
from sim.parts import Part
from sim.rangers import Around, Height
from sim.rays import Hit
from sim.sensors import senses_of
from tests.unit.sim.floors import IDEAL, ideal, robot, scene


def centimetres(text: str, spot: Spot) -> int | None:
    """The reading of the ideal robot's front sonar at a spot of a world."""
    it = scene(text + "\nideal( pose [ -50 -50 0 0 ] )")
    me = it.robots[-1]
    (front,) = senses_of(it, me).at(Bearing.FRONT)
    return front.centimetres(Surroundings(Ground(it), me), spot)


@pytest.mark.parametrize("angle", [0, 10, 30, -45, 60, -75])
@pytest.mark.parametrize("away", [0.3, 1.0, 2.0])
def test_a_slanting_wall_is_read_where_the_cone_meets_it_first(angle: float, away: float) -> None:
    """The wall goes through (away, 0), turned by angle from upright; the cone is 15 degrees."""
    x, y = away + 0.05 * cos(radians(angle)), 0.05 * sin(radians(angle))
    wall = f"model( size [ 0.1 20 1 ] pose [ {x} {y} 0 {angle} ] )"
    edge = min(7.5, abs(angle))
    expected = away * cos(radians(angle)) / cos(radians(abs(angle) - edge))

    assert centimetres(IDEAL + wall, Spot(0, 0, 0)) == pytest.approx(expected * 100, abs=0.6)


@pytest.mark.parametrize(("off", "seen"), [(0, True), (7.2, True), (-7.2, True), (7.8, False), (-7.8, False)])
def test_a_thin_pole_is_seen_within_half_the_cone(off: float, seen: bool) -> None:
    pole = f"thing( pose [ {cos(radians(off))} {sin(radians(off))} 0 0 ] )"

    assert (centimetres(IDEAL + pole, Spot(0, 0, 0)) is not None) is seen


def test_a_wall_at_the_side_is_seen_only_where_the_cone_reaches_it() -> None:
    wall = "model( size [ 20 0.1 1 ] pose [ 0 0.15 0 0 ] )"  # its face at 0.1 to the left

    expected = 0.1 / sin(radians(7.5))
    assert centimetres(IDEAL + wall, Spot(0, 0, 0)) == pytest.approx(expected * 100, abs=0.6)


def test_a_sensor_inside_a_thing_reads_nothing_but_zero() -> None:
    assert centimetres(IDEAL + "model( size [ 1 1 1 ] )", Spot(0, 0, 0)) == 0


@pytest.mark.parametrize(
    ("yaw", "fov", "bearings"),
    [
        (0, 15, {Bearing.FRONT}),
        (-45, 15, {Bearing.FRONT_RIGHT}),
        (-180, 15, {Bearing.BACK}),
        (225, 15, {Bearing.BACK_RIGHT}),
        (20, 15, {Bearing.FRONT}),
        (-30, 15, {Bearing.FRONT_RIGHT}),
        (22.5, 15, {Bearing.FRONT, Bearing.FRONT_LEFT}),
        (90, 15, set()),
        (-90, 15, set()),
        (60, 60, {Bearing.FRONT_LEFT}),
        (0, 120, {Bearing.FRONT, Bearing.FRONT_LEFT, Bearing.FRONT_RIGHT}),
    ],
)
def test_a_sensor_serves_the_bearings_that_it_looks_to(
    yaw: float, fov: float, bearings: set[Bearing]
) -> None:
    it = scene(f"position( ranger( sensor( pose [ 0 0 0 {yaw} ] fov {fov} ) ) )")
    senses = senses_of(it, 0)

    assert {bearing for bearing in Bearing if senses.at(bearing)} == bearings


def test_the_sensors_of_parts_are_known_by_their_names() -> None:
    """A part without a sensor has none to ask, and Stage's own names are no learner's."""
    parts = 'ranger( name "nose" sensor( fov 1 ) ) ranger( sensor( fov 1 ) ) model( name "hat" )'

    assert list(senses_of(scene(f"position( {parts} )"), 0).by_name) == ["nose"]


@pytest.mark.parametrize(
    ("bearing", "x", "y"),
    [
        (Bearing.FRONT, 0, 9),
        (Bearing.FRONT_RIGHT, 9, 9),
        (Bearing.FRONT_LEFT, -9, 9),
        (Bearing.BACK, 0, -9),
        (Bearing.BACK_RIGHT, 9, -9),
        (Bearing.BACK_LEFT, -9, -9),
    ],
)
def test_each_bearing_looks_in_its_direction(bearing: Bearing, x: float, y: float) -> None:
    it = ideal([("red", x, y)])

    readings = {other: it.distance(other) for other in Bearing}

    assert readings.pop(bearing) == int(hypot(x, y))
    assert set(readings.values()) == {60}


def test_a_thing_beyond_the_range_is_at_the_maximum_of_the_sensor() -> None:
    assert ideal([("red", 0, 61)]).distance(Bearing.FRONT) == 60
    assert ideal([("red", 0, 59)]).distance(Bearing.FRONT) == 59


def test_a_thing_nearer_than_the_minimum_of_a_sensor_is_at_the_minimum() -> None:
    blunt = IDEAL.replace("range [ 0 3.0 ]", "range [ 0.5 3.0 ]")
    it = robot(blunt + "ideal( pose [ 0 0 0 90 ] ) thing( pose [ 0 0.2 0 0 ] )")

    assert it.distance(Bearing.FRONT) == 10


def test_a_thing_that_rangers_do_not_see_is_hit() -> None:
    glass = "box( ranger_return -1 pose [ 0 0.5 0 0 ] )"
    it = robot(IDEAL + "ideal( pose [ 0 0 0 90 ] )" + glass)

    assert it.distance(Bearing.FRONT) == 60
    assert it.forward(20).walked == 8


def test_a_mark_on_the_floor_is_neither_read_nor_hit() -> None:
    zone = "model( size [ 1 1 0.01 ] obstacle_return 0 pose [ 0 1 0 0 ] )"
    it = robot(IDEAL + "ideal( pose [ 0 0 0 90 ] )" + zone)

    assert it.distance(Bearing.FRONT) == 60
    assert it.forward(40).walked == 40


def test_a_sensor_on_a_part_of_a_part_reads_from_where_it_is() -> None:
    text = (
        "define eye sensor( range [ 0 3 ] fov 10 )"
        "position( size [ 0.1 0.1 0.1 ] pose [ 0 0 0 90 ]"
        " position( size [ 0.05 0.05 0.05 ] pose [ 0.1 0 0 90 ]"
        "  ranger( pose [ 0.05 0 0 -90 ] eye( pose [ 0.02 0 0 0 ] ) ) ) )"
        "model( size [ 0.1 0.1 1 ] pose [ -0.05 1.05 0 0 ] )"
    )

    # the turned mount carries the ranger 0.05 to the left, which turns back to look ahead
    assert robot(text).distance(Bearing.FRONT) == int((1.0 - 0.12) * 100) // 5


def test_a_wide_scanner_serves_each_bearing_with_a_sector() -> None:
    text = "position( size [ 0.1 0.1 0.1 ] ranger( sensor( range [ 0 3 ] fov 180 samples 180 ) ) )"
    beside = "model( size [ 0.1 0.1 1 ] pose [ 0 0.5 0 0 ] )"

    assert robot(text + beside).distance(Bearing.FRONT) == 60


def test_there_is_no_distance_where_no_sensor_looks() -> None:
    it = robot("position( ranger( sensor( range [ 0 1 ] ) ) )")

    assert it.distance(Bearing.FRONT) == 20
    with pytest.raises(RobotProblem) as problem:
        it.distance(Bearing.BACK_LEFT)
    assert (problem.value.code, problem.value.values) == ("no-sensor", {"bearing": "back left"})


@pytest.mark.parametrize(
    ("ranges", "poles", "steps"),
    [
        # nothing is there: as far as the one that reaches farthest
        *(
            ((0.5, 0.8), (), 16),
            ((0.8, 0.5), (), 16),
            ((5.0,), (), 100),
            ((4.994,), (), 99),
            ((4.996,), (), 100),
        ),
        # something is: the nearest counts, whichever sensor sees it
        *(
            ((3.0, 3.0), (1, None), 20),
            ((3.0, 3.0), (None, 1), 20),
            ((3.0, 3.0), (1, 2), 20),
            ((3.0, 3.0), (2, 1), 20),
        ),
    ],
)
def test_of_several_sensors_of_a_bearing_the_nearest_reading_counts(
    ranges: tuple[float, ...], poles: tuple[float | None, ...], steps: int
) -> None:
    """They look straight ahead, a metre to the left and to the right."""
    sensors = "".join(
        f"sensor( range [ 0 {most} ] fov 10 pose [ 0 {1 - 2 * at} 0 0 ] )" for at, most in enumerate(ranges)
    )
    things = "".join(
        f"model( size [ 0.1 0.1 1 ] pose [ {away + 0.05} {1 - 2 * at} 0 0 ] )"
        for at, away in enumerate(poles)
        if away
    )

    assert (
        robot(f"position( size [ 0.1 0.1 0.1 ] ranger( {sensors} ) ) {things}").distance(Bearing.FRONT)
        == steps
    )


# --- looking around ------------------------------------------------------------------------------


def seen(it: object) -> list[tuple[int, str, int]]:
    return [(round(s.degrees), s.colour, int(s.steps)) for s in it.scan()]  # type: ignore[attr-defined]


def test_things_are_seen_from_left_to_right() -> None:
    it = ideal([("green", -10, 10), ("blue", 0, 15), ("blue", 10, 10), ("red", 4, 0)])

    assert seen(it) == [(-45, "green", 14), (0, "blue", 15), (45, "blue", 14), (90, "red", 4)]


def test_things_behind_and_too_far_away_are_not_seen() -> None:
    assert seen(ideal([("red", 0, -5), ("red", 3, -3), ("red", 0, 61)])) == []


def test_colours_that_the_camera_does_not_know_are_not_seen_but_hide() -> None:
    assert seen(ideal([("yellow", 0, 5), ("red", 0, 10)])) == []


def test_a_camera_looks_only_where_something_coloured_is(monkeypatch: pytest.MonkeyPatch) -> None:
    """A thing of less than a step, 10 steps away, shows 6 degrees at most: a look for each, and a border."""
    looks, plain = list[int](), cameras.first_hits

    def counted(around: Around, x: float, y: float, ends: Sequence[Point], height: Height) -> list[Hit[Part]]:
        looks.append(len(ends))
        return plain(around, x, y, ends, height)

    monkeypatch.setattr(cameras, "first_hits", counted)

    assert seen(ideal([("red", 0, 10), ("yellow", 10, 0)])) == [(0, "red", 10)]
    assert 1 <= looks[0] <= 12


def test_a_thing_behind_a_nearer_thing_is_not_seen() -> None:
    it = robot(
        IDEAL
        + 'ideal( pose [ 0 0 0 90 ] ) box( pose [ 0 0.5 0 0 ] color "green" )'
        + 'thing( pose [ 0 1 0 0 ] color "red" )'
    )

    assert seen(it) == [(0, "green", 9)]


def test_a_half_hidden_thing_is_seen_at_the_middle_of_its_visible_part() -> None:
    """A wall a metre wide, a metre away; a box hides its left half."""
    it = robot(
        IDEAL
        + 'ideal( pose [ 0 0 0 90 ] ) model( size [ 1 0.1 1 ] pose [ 0 1.05 0 0 ] color "red" )'
        + 'model( size [ 1 0.1 1 ] pose [ -0.5 0.55 0 0 ] color "yellow" )'
    )

    (sighting,) = it.scan()

    right = degrees(atan(0.5 / 1.0))
    assert sighting.degrees == pytest.approx(right / 2, abs=0.5)
    assert sighting.steps == pytest.approx(20, abs=0.2)


def test_a_thing_that_shows_on_both_sides_of_a_pole_is_seen_once() -> None:
    it = robot(
        IDEAL
        + 'ideal( pose [ 0 0 0 90 ] ) model( name "wall" size [ 2 0.1 1 ] pose [ 0 1.05 0 0 ] color "red" )'
        + 'thing( pose [ -0.1 0.5 0 0 ] color "yellow" )'
    )

    (sighting,) = it.scan()

    assert sighting.name == "wall"
    assert sighting.degrees > 0  # the wider part, to the right of the pole


def test_a_thing_of_several_parts_is_seen_once() -> None:
    it = robot(
        IDEAL
        + 'ideal( pose [ 0 0 0 90 ] ) box( name "tower" pose [ 0 1 0 0 ] color "blue" box( color "red" ) )'
    )

    assert [s.name for s in it.scan()] == ["tower"]


def test_colours_are_compared_as_in_stage_and_reported_as_families() -> None:
    text = IDEAL.replace('colors_count 3 colors [ "red" "green" "blue" ]', 'colors [ "DarkBlue" "green3" ]')
    it = robot(
        text
        + 'ideal( pose [ 0 0 0 90 ] ) thing( pose [ 0 1 0 0 ] color "darkblue" )'
        + 'thing( pose [ 0.3 1 0 0 ] color "green" ) thing( pose [ -0.3 1 0 0 ] color_rgba [ 0 0.804 0 1 ] )'
    )

    assert it.colours == {"blue", "green"}
    assert [s.colour for s in it.scan()] == ["green", "blue"]


def test_a_camera_sees_only_as_many_colours_as_its_count() -> None:
    things = [
        f'thing( pose [ {x} 1 0 0 ] color "{name}" )'
        for x, name in ((-0.3, "red"), (0, "green"), (0.3, "blue"))
    ]
    it = robot(
        IDEAL.replace("colors_count 3", "colors_count 2") + "ideal( pose [ 0 0 0 90 ] )" + "\n".join(things)
    )

    assert it.colours == {"red", "green"}
    assert {seen.colour for seen in it.scan()} == {"red", "green"}


def test_blob_return_zero_is_invisible_to_the_camera() -> None:
    it = robot(IDEAL + 'ideal( pose [ 0 0 0 90 ] ) box( blob_return 0 color "red" pose [ 0 1 0 0 ] )')

    assert it.scan() == ()


def test_a_robot_without_a_camera_says_so() -> None:
    it = robot("position( ranger( sensor() ) ) model( pose [ 2 0 0 0 ] )")

    with pytest.raises(RobotProblem) as problem:
        it.scan()
    assert (problem.value.code, problem.value.values) == ("no-eyes", {})
    assert it.colours == frozenset()


def test_a_thing_straight_ahead_is_as_far_for_the_camera_as_for_the_sonar() -> None:
    donnie = (
        "define sonar sensor( range [ 0.02 3 ] fov 15 )"
        "position( size [ 0.128 0.128 0.1 ] pose [ 0 0 0 90 ] ranger( sonar( pose [ 0.0635 0 0 0 ] ) )"
        '  position( size [ 0.01 0.01 0.01 ] blobfinder( colors [ "red" ] range 5 ) ) )'
    )
    for away in (0.3, 0.777, 1.0, 1.234, 2.5):
        it = robot(donnie + f'model( size [ 0.1 0.1 1 ] color "red" pose [ 0 {away} 0 0 ] )')
        (sighting,) = it.scan()

        assert int(sighting.steps) == it.distance(Bearing.FRONT)


def test_an_outline_drawn_as_one_winding_polygon_hides_and_is_read_edge_by_edge() -> None:
    """A U around the robot, open ahead: not convex, and the robot stands in its notch."""
    points = [(0, 0), (3, 0), (3, 3), (2, 3), (2, 1), (1, 1), (1, 3), (0, 3)]
    block = "".join(f"point[{i}] [ {x} {y} ] " for i, (x, y) in enumerate(points))
    it = robot(
        IDEAL
        + "ideal( pose [ 0 0 0 90 ] )"
        + f'model( color "gray" size [ 3 3 1 ] pose [ 0 -0.5 0 0 ] block( points 8 {block} ) )'
        + 'thing( pose [ 2 0 0 0 ] color "red" ) thing( pose [ 0 2 0 0 ] color "green" )'
    )

    assert seen(it) == [(0, "green", 40)]
    assert it.distance(Bearing.BACK) == 20
    assert it.distance(Bearing.FRONT_RIGHT) == int(0.5 / sin(radians(52.5)) * 100) // 5
