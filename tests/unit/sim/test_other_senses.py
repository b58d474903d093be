"""Cameras that don't turn, marks, bumpers and the beams of a gripper."""

from math import asin, atan, atan2, degrees, hypot

import pytest

from devices.ports.robot import Bearing, RobotProblem
from sim.geometry import Spot
from sim.rangers import Bar
from sim.world import World
from tests.unit.sim.floors import Unpaced
from tests.unit.sim.sensing import Sensing

BODY = "size [ 0.2 0.2 0.2 ]"


def names_and_bearings(it: Sensing) -> list[tuple[str, int]]:
    return [(it.name(seen.root), round(seen.degrees)) for seen in it.senses.look(it.around, it.spot)]


def pole(name: str, x: float, y: float, colour: str = "red", more: str = "") -> str:
    return f'model( name "{name}" size [ 0.02 0.02 1 ] pose [ {x} {y} 0 0 ] color "{colour}" {more} )\n'


# --- cameras

POLES = pole("ahead", 1, 0) + pole("left", 1, 0.5) + pole("far left", 1, 1) + pole("behind", -1, 0)


@pytest.mark.parametrize(
    ("camera", "expected"),
    [
        ("fov 60", [("left", 27), ("ahead", 0)]),
        ("fov 50", [("ahead", 0)]),
        ("fov 100", [("far left", 45), ("left", 27), ("ahead", 0)]),
        ("fov 10 pose [ 0 0 0 45 ]", [("far left", 45)]),
        ("fov 10 pan 45", [("far left", 45)]),
        ("fov 20 pose [ 0 0 0 180 ]", [("behind", 180)]),
        ("fov 360", [("behind", 180), ("far left", 45), ("left", 27), ("ahead", 0)]),
        ("fov 60 range 1.05", [("ahead", 0)]),
        ("fov 60 range 0.5", []),
    ],
)
def test_a_fixed_camera_sees_its_field_of_view(camera: str, expected: list[tuple[str, int]]) -> None:
    it = Sensing(f"position( {BODY} blobfinder( {camera} ) )" + POLES)

    assert names_and_bearings(it) == expected


def test_a_camera_on_a_head_looks_over_the_half_circle_ahead() -> None:
    it = Sensing(f"position( {BODY} position( {BODY} blobfinder( fov 10 ) ) )" + POLES)

    assert names_and_bearings(it) == [("far left", 45), ("left", 27), ("ahead", 0)]


def test_a_robot_with_six_sonars_at_donnies_bearings_has_donnies_head() -> None:
    sonars = "".join(f"sensor( pose [ 0 0 0 {-bearing.value} ] )" for bearing in Bearing)
    it = Sensing(f"position( {BODY} ranger( {sonars} ) blobfinder( fov 10 ) )" + POLES)

    assert names_and_bearings(it) == [("far left", 45), ("left", 27), ("ahead", 0)]


def test_a_robot_with_six_sonars_next_to_donnies_bearings_has_no_head() -> None:
    sonars = "".join(f"sensor( pose [ 0 0 0 {5 - bearing.value} ] )" for bearing in Bearing)
    it = Sensing(f"position( {BODY} ranger( {sonars} ) blobfinder( fov 10 ) )" + POLES)

    assert names_and_bearings(it) == [("ahead", 0)]


def test_a_head_without_a_sonar_ahead_measures_from_the_middle() -> None:
    it = Sensing(f"position( {BODY} position( {BODY} blobfinder( ) ) )" + pole("ahead", 1, 0))
    (seen,) = it.senses.look(it.around, it.spot)

    assert seen.centimetres == 99


def test_a_fixed_camera_measures_from_where_it_is() -> None:
    it = Sensing(f"position( {BODY} blobfinder( pose [ 0.3 0 0 0 ] ) )" + POLES)

    (seen,) = it.senses.look(it.around, it.spot)

    assert seen.centimetres == 69


def test_two_cameras_report_a_thing_once() -> None:
    it = Sensing(
        f'position( {BODY} blobfinder( colors [ "red" ] fov 30 ) blobfinder( colors [ "blue" ] fov 100 ) )'
        + pole("ahead", 1, 0)
        + pole("blue", 1, 1, "blue")
    )

    assert names_and_bearings(it) == [("blue", 45), ("ahead", 0)]
    assert World(it.scene).robot(pace=Unpaced()).colours == {"red", "blue"}


def test_a_nearer_thing_hides_a_farther_one_at_its_own_height_only() -> None:
    low = 'model( name "low" size [ 0.1 1 0.1 ] pose [ 0.5 0 0 0 ] color "yellow" )'
    robot = f'position( {BODY} blobfinder( colors [ "red" ] ) )'
    things = low + pole("ahead", 1, 0)

    assert names_and_bearings(Sensing(robot + things)) == []
    assert names_and_bearings(Sensing("ignore_zloc 0 " + robot + things)) == [("ahead", 0)]


def test_a_thing_of_several_parts_is_where_its_widest_stretch_is() -> None:
    """A wall of three blocks, 1.2 m wide and 1 m away; a post hides a piece of its right end."""
    corners = "point[0] [ 0 {0} ] point[1] [ 1 {0} ] point[2] [ 1 {1} ] point[3] [ 0 {1} ]"
    blocks = "".join(f"block( points 4 {corners.format(y, y + 1)} ) " for y in range(3))
    wall = f'model( name "wall" size [ 0.02 1.2 1 ] pose [ 1 0 0 0 ] color "red" {blocks} )'
    it = Sensing(f"position( {BODY} blobfinder( fov 90 ) ) {wall} {pole('post', 0.5, -0.2, 'yellow')}")

    found = {it.name(seen.root): seen.degrees for seen in it.senses.look(it.around, it.spot)}

    left, right = degrees(atan(0.6 / 0.99)), -degrees(atan(0.19 / 0.51))
    assert found["wall"] == pytest.approx((left + right) / 2, abs=0.01)


def test_of_a_wall_that_leads_out_of_the_range_the_piece_in_range_is_seen() -> None:
    """Its face is 0.5 m to the left of the robot, and 2 m away up to where its angle has the sine 0.25."""
    wall = 'model( size [ 10 0.1 1 ] pose [ 5 0.55 0 0 ] color "red" )'
    it = Sensing(f"position( {BODY} blobfinder( fov 60 range 2 ) ) {wall}")

    (seen,) = it.senses.look(it.around, it.spot)

    assert seen.degrees == pytest.approx((degrees(asin(0.25)) + 30) / 2, abs=0.01)


@pytest.mark.parametrize(("away", "is_seen"), [(3.06, True), (3.07, False)])
def test_the_range_of_a_camera_on_a_head_begins_at_its_sonar(away: float, is_seen: bool) -> None:
    head = f"ranger( sensor( pose [ 0.0635 0 0 0 ] ) ) position( {BODY} blobfinder( range 3 ) )"
    box = f'model( size [ 0.1 0.1 1 ] pose [ {away + 0.05} 0 0 0 ] color "red" )'
    it = Sensing(f"position( {BODY} {head} ) {box}")

    assert bool(it.senses.look(it.around, it.spot)) is is_seen


def test_a_thing_nearer_than_the_sonar_of_a_head_is_at_0() -> None:
    head = f"ranger( sensor( pose [ 0.0635 0 0 0 ] ) ) position( {BODY} blobfinder( ) )"
    it = Sensing(f"position( {BODY} {head} ) {pole('red', 0.05, 0)}")

    (seen,) = it.senses.look(it.around, it.spot)

    assert seen.centimetres == 0


def test_a_look_without_a_camera_is_refused() -> None:
    it = Sensing(f"position( {BODY} bumper( ) )")

    with pytest.raises(RobotProblem) as problem:
        it.senses.look(it.around, it.spot)
    assert problem.value.code == "no-eyes"


@pytest.mark.parametrize(
    ("more", "seen"),
    [
        ("", []),
        ("ranger_return -1", []),
        ("size [ 0.1 1 0.1 ]", ["red"]),
        ("size [ 1 1 0.01 ] obstacle_return 0", ["red"]),
    ],
)
def test_a_solid_thing_hides_at_its_height_also_where_rangers_do_not_see_it(
    more: str, seen: list[str]
) -> None:
    thing = f'model( name "glass" size [ 0.1 1 1 ] pose [ 0.5 0 0 0 ] color "yellow" {more} )'
    it = Sensing(
        f'ignore_zloc 0 position( {BODY} blobfinder( colors [ "red" ] ) ) {thing}' + pole("red", 1, 0)
    )

    assert [name for name, _ in names_and_bearings(it)] == seen


def test_of_two_cameras_the_nearer_one_counts_and_of_equal_ones_the_first() -> None:
    """The second camera is 20 cm ahead of the first, and the third as far behind it."""
    cameras = "".join(f"blobfinder( pose [ {x} 0 0 0 ] )" for x in (0, 0.2, -0.2))
    it = Sensing(f"position( {BODY} {cameras} ) {pole('a', 1, 0.3)} {pole('b', 1, -0.3)}")

    found = [
        (round(seen.degrees), seen.centimetres, seen.steps) for seen in it.senses.look(it.around, it.spot)
    ]
    near = int(100 * hypot(0.79, 0.29) + 0.5)
    angle = round(degrees(atan(0.3 / 0.8)))
    assert found == [(angle, near, near / 5), (-angle, near, near / 5)]


@pytest.mark.parametrize(
    ("wall", "angle", "away"),
    [
        ("size [ 10 0.1 1 ] pose [ 0 0.55 0 0 ]", 90, 0.5),
        ("size [ 10 0.1 1 ] pose [ 0 -0.55 0 0 ]", -90, 0.5),
        ("size [ 0.1 2 1 ] pose [ 1.05 0 0 0 ]", 0, 1),
        (
            "size [ 0.1 2 1 ] pose [ -1.05 0.5 0 0 ]",
            (degrees(atan2(1.5, -1)) + degrees(atan2(-0.5, -1)) + 360) / 2,
            1,
        ),
        (
            "size [ 0.1 2 1 ] pose [ -1.05 -0.5 0 0 ]",
            -(degrees(atan2(1.5, -1)) + degrees(atan2(-0.5, -1)) + 360) / 2,
            1,
        ),
    ],
)
def test_a_long_wall_is_seen_in_the_middle_of_what_shows_of_it_also_behind(
    wall: str, angle: float, away: float
) -> None:
    it = Sensing(f'position( {BODY} blobfinder( fov 360 range 5 ) ) model( {wall} color "red" )')
    (seen,) = it.senses.look(it.around, it.spot)

    assert seen.degrees == pytest.approx(angle, abs=0.05)
    assert seen.centimetres == round(100 * away)


# --- marks


def finder(settings: str = "", things: str = "", robot: str = "") -> Sensing:
    return Sensing(f"position( {BODY} {robot} fiducial( {settings} ) )" + things)


def marks(it: Sensing) -> list[tuple[object, ...]]:
    found = it.senses.marks(it.around, it.spot)
    return [(it.name(f.model), round(f.degrees), pytest.approx(f.metres), f.number) for f in found]


def test_marks_are_reported_from_left_to_right_with_their_numbers() -> None:
    things = pole("door", 3, 0, more="fiducial_return 7") + pole("window", 0, 2, more="fiducial_return 9")

    assert marks(finder("", things + pole("plain", 1, -1))) == [("window", 90, 2, 9), ("door", 0, 3, 7)]


def test_a_mark_that_is_too_far_to_be_read_has_the_number_zero() -> None:
    things = pole("near", 1.9, 0, more="fiducial_return 7") + pole("far", 2, 1, more="fiducial_return 8")

    assert marks(finder("range_max_id 2", things)) == [("far", 27, 5**0.5, 0), ("near", 0, 1.9, 7)]


@pytest.mark.parametrize(
    ("settings", "mark", "expected"),
    [
        ("range_max 2.9", "", False),
        ("range_max 3", "", True),
        ("range_max 3.1", "", True),
        ("range_min 5", "", True),
        ("fiducial_key 3", "", False),
        ("fiducial_key 3", "fiducial_key 3", True),
        ("", "fiducial_key 3", False),
        ("fov 30 pose [ 0 0 0 16 ]", "", False),
        ("fov 34 pose [ 0 0 0 16 ]", "", True),
    ],
)
def test_a_finder_finds_within_its_range_its_view_and_its_key(
    settings: str, mark: str, expected: bool
) -> None:
    it = finder(settings, pole("door", 3, 0, more=f"fiducial_return 1 {mark}"))

    assert [found[0] for found in marks(it)] == (["door"] if expected else [])


def test_a_finder_finds_at_the_very_edge_of_its_view() -> None:
    edge = pole("edge", 2, 2, more="fiducial_return 1")

    assert [found[0] for found in marks(finder("fov 90", edge))] == ["edge"]
    assert marks(finder("fov 89.9", edge)) == []


def test_the_range_of_a_finder_is_a_circle() -> None:
    """The mark is 2.83 metres away, to the left and ahead."""
    corner = pole("corner", 2, 2, more="fiducial_return 1")

    assert [found[0] for found in marks(finder("range_max 2.84", corner))] == ["corner"]
    assert marks(finder("range_max 2.82", corner)) == []


@pytest.mark.parametrize(("yaw", "place", "degrees"), [(90, "0 3", 90), (-90, "0 -3", -90), (30, "3 0", 0)])
def test_a_mark_has_its_direction_from_the_front_of_the_robot(yaw: int, place: str, degrees: int) -> None:
    x, y = map(float, place.split())
    (found,) = marks(finder(f"pose [ 0 0 0 {yaw} ]", pole("door", x, y, more="fiducial_return 1")))

    assert found[:3] == ("door", degrees, pytest.approx(3))


def test_a_mark_at_the_limit_of_reading_is_not_read() -> None:
    ((*_, number),) = marks(finder("range_max_id 3", pole("door", 3, 0, more="fiducial_return 7")))

    assert number == 0


def test_a_mark_nearer_than_the_minimum_of_a_finder_is_at_the_minimum() -> None:
    ((_, _, metres, _),) = marks(finder("range_min 5", pole("door", 3, 0, more="fiducial_return 1")))

    assert metres == 5


def test_a_thing_between_hides_a_mark() -> None:
    things = pole("door", 3, 0, more="fiducial_return 1") + pole("side", 3, 0.3, more="fiducial_return 2")

    assert [found[0] for found in marks(finder("", things + pole("post", 1, 0)))] == ["side"]


def test_a_mark_counts_at_its_height_and_without_a_shape_at_its_place() -> None:
    low = 'model( name "low" size [ 0.1 0.1 0.1 ] pose [ 2 0 0 0 ] fiducial_return 3 )'
    aside = 'model( name "aside" size [ 0.1 0.1 1 ] origin [ 0 0.5 0 ] pose [ 2 0 0 0 ] fiducial_return 3 )'
    robot = f"position( {BODY} fiducial( ) )"

    assert [found[0] for found in marks(Sensing(robot + low))] == ["low"]
    assert marks(Sensing("ignore_zloc 0 " + robot + low)) == []
    assert [found[0] for found in marks(Sensing(robot + aside))] == ["aside"]


def test_a_robot_does_not_find_its_own_mark() -> None:
    assert marks(finder("", "", "fiducial_return 5")) == []


def seen_by(robot: str, things: str) -> list[tuple[str, int, int, int | None]]:
    sightings = World(Sensing(f"position( {BODY} {robot} )" + things).scene).robot(pace=Unpaced()).scan()
    return [(it.name, round(it.degrees), int(it.steps), it.mark) for it in sightings]


def test_a_scan_finds_things_then_the_marks_in_the_half_circle_ahead() -> None:
    robot = "blobfinder( fov 120 ) fiducial( range_max_id 2.5 )"
    things = (
        pole("door", 0.6, 0, more="fiducial_return 3")
        + pole("post", 1, -1)
        + pole("window", 0, 2, more="fiducial_return 9")
        + pole("far", 3, -0.3, more="fiducial_return 4")
        + pole("behind", -1, 1, more="fiducial_return 5")
    )

    assert seen_by(robot, things) == [
        ("door", 0, 11, None),
        ("far", 6, 60, None),
        ("post", 45, 28, None),
        ("window", -90, 40, 9),
        ("door", 0, 12, 3),
        ("far", 6, 60, 0),
    ]


def test_a_mark_of_two_finders_is_seen_once_as_it_can_be_read() -> None:
    robot = "fiducial( range_max_id 0.5 ) fiducial( pose [ -0.2 0 0 0 ] )"

    assert seen_by(robot, pole("door", 0.6, 0, more="fiducial_return 3")) == [("door", 0, 16, 3)]


def test_a_robot_without_eyes_sees_that_there_is_no_mark() -> None:
    assert seen_by("fiducial( )", pole("post", 1, 0)) == []


# --- bumpers

BUMPERS = (
    f"position( {BODY} bumper( bcount 3 blength 0.2"
    " bpose[0] [ 0.1 0 0 0 ] bpose[1] [ -0.1 0 0 180 ] bpose[2] [ 0 0.1 0 90 ] blength[2] 0.02 ) )"
)


@pytest.mark.parametrize(
    ("wall", "expected"),
    [
        ("size [ 0.1 1 1 ] pose [ 0.151 0 0 0 ]", (True, False, False)),
        ("size [ 0.1 1 1 ] pose [ 0.165 0 0 0 ]", (False, False, False)),
        ("size [ 0.1 0.05 1 ] pose [ 0.151 0.14 0 0 ]", (False, False, False)),
        ("size [ 0.1 1 1 ] pose [ -0.155 0 0 0 ]", (False, True, False)),
        ("size [ 0.02 0.1 1 ] pose [ 0 0.155 0 0 ]", (False, False, True)),
        ("size [ 0.02 0.1 1 ] pose [ 0.05 0.155 0 0 ]", (False, False, False)),
        ("size [ 0.1 1 1 ] pose [ 0.151 0 0 0 ] obstacle_return 0", (False, False, False)),
    ],
)
def test_a_solid_thing_that_touches_its_bar_presses_a_bumper(wall: str, expected: tuple[bool, ...]) -> None:
    it = Sensing(BUMPERS + f"model( {wall} )")

    assert tuple(bar.is_pressed(it.around, it.spot) for bar in it.senses.bumpers) == expected


@pytest.mark.parametrize(
    ("x", "y", "pressed"),
    [
        # the bar is 20 cm long and 10 cm ahead, the thing a post of 2 cm
        *((0.1199, 0, True), (0.1201, 0, False), (0.0801, 0, True), (0.0799, 0, False), (0.1, 0.1199, True)),
        *((0.1, 0.1201, False), (0.1, -0.1199, True), (0.1, -0.1201, False), (0.1, 0.05, True)),
    ],
)
def test_a_bumper_is_pressed_by_what_is_a_centimetre_from_its_bar(x: float, y: float, pressed: bool) -> None:
    bar = Bar(0.1, 0, 0, 0.2)
    it = Sensing(
        f"position( pose [ -9 0 0 0 ] bumper( bcount 1 ) ) model( size [ 0.02 0.02 1 ] pose [ {x} {y} 0 0 ] )"
    )

    assert bar.is_pressed(it.around, Spot(0, 0, 0)) is pressed


@pytest.mark.parametrize(
    ("solid", "noticed", "pressed"), [(1, (), True), (0, (), False), (0, (1,), False), (0, (2,), True)]
)
def test_a_bumper_in_a_thing_is_pressed_if_that_is_solid_or_noticed(
    solid: int, noticed: tuple[int, ...], pressed: bool
) -> None:
    it = Sensing(
        f"position( pose [ -9 0 0 0 ] bumper( bcount 1 ) ) model( size [ 2 2 1 ] obstacle_return {solid} )"
    )

    assert Bar(0, 0, 0, 0.1).is_pressed(it.around, Spot(0, 0, 0), noticed) is pressed


# --- the manual's robot

BIGBOB = """
define sonar sensor ( size [ 0.01 0.05 0.01 ] range [ 0.3 2.0 ] fov 10 )
define laser sensor ( size [ 0.025 0.025 0.025 ] range [ 0 0.25 ] fov 20 samples 180 )
define bigbob position
(
  size [ 1.25 1 1 ] origin [ 0.125 0 0 ]
  block ( points 6 point[5] [0 0] point[4] [0 1] point[3] [0.75 1] point[2] [1 0.75] point[1] [1 0.25]
          point[0] [0.75 0] z [0 1] )
  block ( points 4 point[3] [1 0.75] point[2] [1.25 0.75] point[1] [1.25 0.625] point[0] [1 0.625] z [0 0.5] )
  block ( points 4 point[3] [1 0.375] point[2] [1.25 0.375] point[1] [1.25 0.25] point[0] [1 0.25] z [0 0.5] )
  ranger ( sonar( pose [ 0.75 0.1875 0 0] ) sonar( pose [ 0.75 -0.1875 0 0] )
           sonar( pose [ 0.25 0.5 0 30] ) sonar( pose [ 0.25 -0.5 0 -30] ) )
  blobfinder ( colors_count 2 colors ["orange" "DarkBlue"] image [160 120] range 5.00 fov 60 )
  ranger ( laser( pose [ 0.625 0.125 -0.975 270 ] ) )
)
bigbob ( name "bob1" )
"""
WALL = 'model( size [ 0.1 8 0.5 ] pose [ 2.05 0 0 0 ] color "gray30" )'


def test_bigbob_sees_the_walls_that_stage_shoots_over() -> None:
    it = Sensing(BIGBOB + WALL)

    assert it.senses.steps(it.around, it.spot, Bearing.FRONT) == 25  # 1.25 m before its teeth
    with pytest.raises(RobotProblem):
        it.senses.steps(it.around, it.spot, Bearing.BACK_RIGHT)  # the laser looks across its teeth


def test_bigbob_is_blind_where_the_world_asks_for_stages_heights() -> None:
    it = Sensing("ignore_zloc 0\n" + BIGBOB + WALL)

    assert it.senses.steps(it.around, it.spot, Bearing.FRONT) == 40


def test_bigbobs_laser_notices_what_lies_between_its_teeth() -> None:
    orange = 'model( name "orange" size [ 0.15 0.15 0.15 ] pose [ 0.625 0 0 0 ] color "orange" )'
    for thing, expected in (("", 0.25), (orange, 0.05)):
        it = Sensing(BIGBOB + thing)
        laser = it.senses.rangers[-1]

        assert min(laser.metres(it.around, it.spot), 0.25) == pytest.approx(expected)


def test_bigbob_sees_oranges_and_cartons_within_its_sixty_degrees() -> None:
    side = degrees(atan(1 / 2))
    things = pole("orange", 2, 1, "orange") + pole("carton", 2, -1, "DarkBlue") + pole("red", 2, 0)

    it = Sensing(BIGBOB + things + pole("far left", 1, 1, "orange"))

    assert names_and_bearings(it) == [("orange", round(side)), ("carton", -round(side))]
