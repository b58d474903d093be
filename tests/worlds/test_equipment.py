"""Equipment of models: each property that counts, with its unit, its default and its mistakes."""

from pathlib import Path

import pytest

from sim.geometry import Placement
from sim.scene import (
    Bumper,
    Camera,
    Drive,
    FiducialFinder,
    Gripper,
    Limits,
    Localization,
    Model,
    OdometryError,
    RangeNoise,
    Wheels,
)
from sim.worldfile import WorldError, load_text


def model(text: str) -> Model:
    """The first model of a world."""
    return load_text(text, Path("t.world")).models[0]


def mistake(text: str) -> tuple[str, int]:
    with pytest.raises(WorldError) as error:
        load_text(text, Path("t.world"))
    return error.value.code.value, error.value.column


def test_a_position_has_the_defaults_of_stage() -> None:
    wheels = model("position ( )").wheels

    assert wheels == Wheels(
        Drive.DIFF, Localization.GPS, None, OdometryError(0.03, 0.03, 0.05), None, None, 1.0
    )
    assert model("model ( )").wheels is None


def test_wheels_are_read_with_their_units() -> None:
    text = 'unit_length "cm" unit_angle "radians" position ( drive "car" localization "odom" wheelbase 40'
    text += " odom_error [ 0.1 0.2 9 0.3 ] localization_origin [ 100 200 0 0 ]"
    text += " velocity_bounds [ -50 100 -1 2 7 8 -1 0.5 ] acceleration_bounds [ -5 6 0 0 0 0 0 0 ] )"

    wheels = model(text).wheels

    assert wheels is not None
    assert (wheels.drive, wheels.localization, wheels.wheelbase) == (Drive.CAR, Localization.ODOM, 0.4)
    assert wheels.odom_error == OdometryError(0.1, 0.2, 0.3)
    assert wheels.localization_origin == Placement(1, 2)
    limits = Limits((-0.5, 1.0), (-0.01, 0.02), (pytest.approx(-57.29578), pytest.approx(28.64789)))  # type: ignore[arg-type]
    assert wheels.velocity_bounds == limits
    assert wheels.acceleration_bounds == Limits((-0.05, 0.06), (0, 0), (0, 0))


def test_the_odometry_error_of_the_manual_has_three_numbers() -> None:
    wheels = model("position ( odom_error [ 0.1 0.2 0.3 ] )").wheels

    assert wheels is not None
    assert wheels.odom_error == OdometryError(0.1, 0.2, 0.3)


def test_a_gripper_has_the_defaults_of_stage() -> None:
    usual = model("gripper ( )")
    other = model('gripper ( paddle_size [ 0.5 0.2 0.3 ] paddle_state [ "closed" "up" ] autosnatch 1 )')

    assert usual.gripper == Gripper(0.66, 0.1, 0.4, closed=False, lifted=False, autosnatch=False)
    assert other.gripper == Gripper(0.5, 0.2, 0.3, closed=True, lifted=True, autosnatch=True)
    assert sorted({round(y, 9) for _, y in usual.polygons[1].points}) == [-0.15, -0.12]
    base, right, left = other.polygons
    assert (base.bottom, base.top) == pytest.approx((0, 0.2))
    assert (right.bottom, right.top) == pytest.approx((0.14, 0.2))
    assert max(y for _, y in right.points) == pytest.approx(min(y for _, y in left.points))  # they meet


def test_a_fiducial_finder_has_the_defaults_of_stage() -> None:
    finder = model("fiducial ( range_min 1 range_max 6 range_max_id 4 fov 90 fiducial_key 3 )")

    assert model("fiducial ( )").fiducial_finder == FiducialFinder(0, 8, 5, 180)
    assert (finder.fiducial_finder, finder.fiducial_key) == (FiducialFinder(1, 6, 4, 90), 3)


def test_bumpers_share_one_length_or_have_one_each() -> None:
    text = "bumper ( bcount 3 blength 0.3 bpose[0] [ 1 2 0 90 ] bpose[2] [ 3 4 0.5 0 ] blength[2] 0.2 )"

    assert model(text).bumpers == (
        Bumper(Placement(1, 2, 0, 90), 0.3),
        Bumper(Placement(), 0.3),
        Bumper(Placement(3, 4, 0.5, 0), 0.2),
    )
    assert len(model("bumper ( bpose[0] [ 1 2 0 90 ] )").bumpers) == 1
    assert model("bumper ( )").bumpers == ()


def test_a_blobfinder_may_look_to_the_side() -> None:
    eyes = model('blobfinder ( range 5 fov 90 pan -30 image [ 160 120 ] colors [ "red" ] )').blobfinder

    assert eyes is not None
    assert (eyes.maximum, eyes.fov, eyes.pan, eyes.image) == (5, 90, 330, (160, 120))
    assert [colour.name for colour in eyes.colours] == ["red"]


def test_a_camera_looks_ahead_and_sees_as_far_and_wide_as_in_stage() -> None:
    assert model("camera ( )").camera == Camera(0.2, 8, (70, 40), 0, 0)


def test_the_angles_of_a_camera_are_stored_in_degrees() -> None:
    text = 'unit_angle "radians" camera ( range [ 0.1 9 ] fov [ 60 30 ] pantilt [ 20 10 ] )'

    assert model(text).camera == Camera(0.1, 9, (60, 30), 20, 10)


def test_a_sensor_has_a_noise_and_a_size() -> None:
    text = (
        "ranger ( sensor ( size [ 0.01 0.05 0.03 ] range_noise 0.1 range_noise_const 0.02 angle_noise 3 ) )"
    )
    (sensor,) = model(text).sensors

    assert (sensor.size, sensor.noise) == ((0.01, 0.05, 0.03), RangeNoise(0.02, 0.1, 3))


def test_a_thing_is_pushed_gripped_and_weighed_only_where_its_file_says_so() -> None:
    usual, thing = model("model ( )"), model("model ( pushable 1 gripper_return 1 mass 2 ignore_zloc 0 )")

    assert (usual.pushable, usual.grippable, usual.mass, usual.ignore_zloc) == (False, False, 0, True)
    assert (thing.pushable, thing.grippable, thing.mass, thing.ignore_zloc) == (True, True, 2, False)
    assert not model("ignore_zloc 0 model ( )").ignore_zloc


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("position ( velocity_bounds [ 1 2 3 ] )", ("wrong-count", 28)),
        ("position ( odom_error [ 1 2 ] )", ("wrong-count", 23)),
        ("gripper ( paddle_state 1 )", ("wrong-type", 24)),
        ("gripper ( paddle_size [ 1 2 ] )", ("wrong-count", 23)),
        ("bumper ( bcount -1 )", ("out-of-range", 17)),
        ("bumper ( bcount 1 bpose[0] [ 1 ] )", ("wrong-count", 28)),
        ("ranger ( sensor ( samples -1 ) )", ("out-of-range", 27)),
        ("bumper ( bcount [ ] )", ("wrong-type", 17)),
        ("ranger ( sensor ( noise [ 1 2 ] ) )", ("wrong-count", 25)),
        ("model ( mass [ ] )", ("wrong-type", 14)),
        ("model ( mass [ [ 1 ] ] )", ("wrong-type", 16)),
    ],
)
def test_a_wrong_value_is_a_mistake_with_its_place(text: str, expected: tuple[str, int]) -> None:
    assert mistake(text) == expected


def test_a_misspelt_word_is_reported_with_the_nearest_right_one() -> None:
    (note,) = load_text('gripper ( paddle_state [ "opn" ] )', Path("t.world")).report.notes[:1]

    assert (note.code, note.details["found"], note.details["nearest"]) == ("unknown-word", "opn", "open")


def test_a_blinkenlight_is_as_small_as_in_stage() -> None:
    light = model("blinkenlight ( )")

    assert (light.size, light.colour.family) == ((0.02, 0.02, 0.02), "green")
