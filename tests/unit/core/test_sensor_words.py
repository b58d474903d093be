"""SENSORS: what a robot has, in words, and its fields of view on the map."""

import pytest

from devices.ports.robot import Pose
from donnie_tui.core.describe import MOST, sensors_in_words, sensors_of_board
from donnie_tui.core.map_grid import Cell, Kind
from donnie_tui.core.map_scene import MapScene
from donnie_tui.i18n.words import Words
from sim.picture import picture
from sim.sensors import Device, Mounted, mounted
from tests.unit.sim.floors import scene

ROBOT = """
define it position ( size [ 0.2 0.2 0.1 ] ranger( sensor( range [ 0 3 ] fov 15 pose [ 0.1 0 0 0 ] ) )
  camera( range [ 0 1 ] fov [ 60 40 ] pantilt [ -90 0 ] )
  blobfinder( range 5 fov 60 )
  gripper( size [ 0.1 0.2 0.1 ] pose [ 0.15 0 0 0 ] paddle_size [ 0.5 0.1 0.4 ] ) )
"""


def test_each_device_is_described_with_its_view() -> None:
    devices = mounted(scene(f'{ROBOT} it( name "al" pose [ 1 2 0 90 ] )'), "al")

    assert sensors_in_words(devices, "al", Words("en", "normal")) == (
        "al has:",
        "Distance sensor ahead, 15 degrees wide, range 3 m.",
        "Color camera ahead, 60 degrees wide, range 5 m.",
        "Camera 90 right, 60 degrees wide, range 1 m. No picture is made.",
        "Gripper ahead.",
    )


def test_a_sensor_with_a_name_is_described_by_it_and_a_finder_of_marks_is_there() -> None:
    """Only so does a learner know what DISTANCE can be asked for."""
    devices = mounted(
        scene(
            'define it position ( ranger( name "left eye" sensor( range [ 0 3 ] fov 15 pose [ 0 0 0 90 ] ) )'
            " ranger( sensor( range [ 0 2 ] fov 15 ) ) fiducial( range_max 5 fov 90 )"
            " ranger( sensor( range [ 0 4 ] fov 120 samples 31 pose [ 0 0 0 -45 ] ) ) )"
            ' it( name "al" )'
        ),
        "al",
    )

    assert sensors_in_words(devices, "al", Words("en", "normal"))[1:] == (
        'Distance sensor "left eye", 90 left, 15 degrees wide, range 3 m.',
        "Distance sensor ahead, 15 degrees wide, range 2 m.",
        "Distance sensor 45 right, 120 degrees wide, range 4 m.",
        "Finder of marks ahead, 90 degrees wide, range 5 m.",
    )


def test_a_robot_without_sensors_says_so() -> None:
    it = scene('define it position( size [ 0.1 0.1 0.1 ] bumper( bcount 0 ) ) it( name "al" )')

    assert sensors_in_words(mounted(it, "al"), "al", Words("en", "normal")) == ("al has no sensors.",)


def test_the_description_of_a_thousand_sensors_is_cut() -> None:
    devices = [Mounted(Device.BUMPER, degrees) for degrees in range(1, 101)]

    said = sensors_in_words(devices, "al", Words("pt", "normal"))

    assert len(said) == MOST + 2
    assert said[-1] == "E mais 80."


@pytest.mark.parametrize(
    ("degrees", "where"),
    [(0.4, "ahead"), (-1, "1 left"), (179, "179 right"), (-180, "behind"), (180, "behind")],
)
def test_the_direction_of_a_sensor_is_given_from_the_front(degrees: float, where: str) -> None:
    _, said = sensors_in_words([Mounted(Device.BUMPER, degrees)], "al", Words("en", "normal"))

    assert said == f"Bumper {where}."


@pytest.mark.parametrize(
    ("metres", "said"), [(3.0, "3"), (0.5, "0.5"), (0.256, "0.26"), (10.0, "10"), (0.101, "0.1")]
)
def test_the_range_of_a_sensor_has_no_more_digits_than_it_needs(metres: float, said: str) -> None:
    ranger = Mounted(Device.RANGER, 0.0, width=15.4, metres=metres)

    assert sensors_in_words([ranger], "al", Words("en", "normal"))[1:] == (
        f"Distance sensor ahead, 15 degrees wide, range {said} m.",
    )


def test_of_twenty_one_kinds_of_sensors_one_is_counted() -> None:
    devices = [Mounted(Device.BUMPER, degrees) for degrees in range(1, MOST + 2)]

    assert sensors_in_words(devices, "al", Words())[-2:] == ("Bumper 20 right.", "And 1 more.")


def test_twenty_kinds_of_sensors_are_all_described() -> None:
    devices = [Mounted(Device.BUMPER, degrees) for degrees in range(1, MOST + 1)]

    assert len(sensors_in_words(devices, "al", Words("en", "normal"))) == 1 + MOST
    assert sensors_in_words(devices[:1] * 3, "", Words("en", "normal")) == (
        "Donnie has:",
        "3 times: Bumper 1 right.",
    )


@pytest.mark.parametrize(
    ("name", "language", "has_camera", "said"),
    [
        (
            "",
            "en",
            True,
            ("Donnie has:", "One on its head, which turns for SCAN.", "Bumpers and a color camera."),
        ),
        (
            "al",
            "pt",
            False,
            ("al tem:", "Um na cabeça, que gira para ESPIAR.", "Sensores de toque. Sem câmera"),
        ),
    ],
)
def test_the_sensors_of_the_board_are_the_same_in_every_world(
    name: str, language: str, has_camera: bool, said: tuple[str, ...]
) -> None:
    title, _, head, last = sensors_of_board(name, Words(language), has_camera=has_camera)

    assert (title, head) == said[:2]
    assert last.startswith(said[2])


@pytest.mark.parametrize("yaw", [0, 90, 225])
def test_a_camera_looks_along_two_sides_and_an_arc_where_it_is_mounted(yaw: int) -> None:
    """20 steps at 60 degrees: 10 to either side of the middle, 17.3 away. It looks to the right."""
    (camera,) = (
        each
        for each in mounted(scene(f'{ROBOT} it( name "al" pose [ 3 -2 0 {yaw} ] )'), "al")
        if each.device is Device.CAMERA
    )

    left, right, arc = camera.lines

    assert left[1] == pytest.approx((20 * 3**0.5 / 2, 10))
    assert right[1] == pytest.approx((20 * 3**0.5 / 2, -10))
    assert (arc[0], arc[-1]) == (left[1], right[1])
    assert all(x * x + y * y == pytest.approx(400) for x, y in arc)


@pytest.mark.parametrize("yaw", [0, 90, 225])
def test_a_camera_that_is_not_in_the_middle_looks_from_where_it_is(yaw: int) -> None:
    """4 steps before the middle and 2 to its left; it sees nothing nearer than a step, at 30 degrees."""
    camera = "camera( pose [ 0.2 0.1 0 0 ] range [ 0.05 1 ] fov [ 60 40 ] )"
    text = f'define it position( {camera} ) it( name "al" pose [ 3 -2 0 {yaw} ] )'
    (left, right, _) = mounted(scene(text), "al")[0].lines

    assert left[0] == pytest.approx((-2 - 1 / 2, 4 + 3**0.5 / 2))
    assert right[0] == pytest.approx((-2 + 1 / 2, 4 + 3**0.5 / 2))
    assert left[1] == pytest.approx((-2 - 20 / 2, 4 + 20 * 3**0.5 / 2))


def test_the_paddles_of_a_gripper_are_two_lines_ahead() -> None:
    """0.1 by 0.2 m, a tenth of it each paddle: 0.08 m to either side, from the middle to 0.2 m ahead."""
    gripper = mounted(scene(f'{ROBOT} it( name "al" )'), "al")[-1]

    assert [point for line in gripper.lines for point in line] == [
        pytest.approx(each) for each in ((-1.6, 3), (-1.6, 4), (1.6, 3), (1.6, 4))
    ]


def test_the_field_of_view_is_on_the_map_up_to_a_wall_and_gone_when_the_robot_moves() -> None:
    wall = "define wall model ( size [ 3 0.05 1 ] ) wall( pose [ 0 0.5 0 0 ] )"
    it = scene(f'{ROBOT} {wall} it( name "al" pose [ 0 0 0 90 ] )')
    shown = MapScene(picture(it), Pose(0, 0, 0))

    changed = shown.show_fields([((0, 0), (0, 20)), ((0, 0), (20, 0))])

    at = shown.cell_at
    assert shown.kind(at(0, 9)) is Kind.RAY
    assert shown.kind(at(20, 0)) is Kind.RAY
    assert shown.kind(at(0, 11)) is not Kind.RAY
    assert at(0, 5) in changed
    assert isinstance(at(0, 5), Cell)
    shown.move(Pose(0, 1, 0))
    assert shown.kind(at(20, 0)) is not Kind.RAY


@pytest.mark.parametrize(
    ("heading", "east", "north"), [(0, 12, 16), (90, 16, -12), (180, -12, -16), (270, -16, 12)]
)
def test_a_field_of_view_turns_with_the_robot(heading: int, east: int, north: int) -> None:
    """12 steps to the right and 16 ahead."""
    shown = MapScene(picture(scene(f'{ROBOT} it( name "al" )')), Pose(0, 0, heading))

    shown.show_fields([((0, 0), (12, 16))])

    assert shown.kind(shown.cell_at(east, north)) is Kind.RAY
