"""Equipment of models: each property that counts, with its unit, its default and its mistakes."""

from pathlib import Path

import pytest
from msgspec.structs import replace
from PIL import Image

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
from sim.worldfile import Code, WorldError, load_text
from sim.worldfile.entities import Setting
from sim.worldfile.parser import Property, String, Tuple, Value
from sim.worldfile.values import ValueReader

PATH = Path("t.world")


def model(text: str) -> Model:
    """The first model of a world."""
    return load_text(text, PATH).models[0]


def mistake(text: str) -> tuple[str, int]:
    with pytest.raises(WorldError) as error:
        load_text(text, PATH)
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


TRIANGLE = "point[0] [ 0 0 ] point[1] [ 1 0 ] point[2] [ 0 1 ]"


@pytest.mark.parametrize(
    ("text", "same"),
    [
        # what is not said is as in Stage
        ("ranger ( )", "ranger ( size [ 0.15 0.15 0.2 ] color_rgba [ 0 0 0.5 1 ] )"),
        ("fiducial ( )", "fiducial ( size [ 0 0 0 ] )"),
        ("gripper ( )", "gripper ( size [ 0.2 0.3 0.2 ] )"),
        ("camera ( )", 'camera ( size [ 0.1 0.07 0.05 ] color "black" )'),
        ("blobfinder ( )", "blobfinder ( range 12 fov 60 image [ 80 60 ] pan 0 )"),
        ("bumper ( bcount 1 )", "bumper ( bcount 1 blength 0.1 )"),
        ("camera ( fov 60 )", "camera ( fov [ 60 40 ] )"),
        # angles
        ("ranger ( sensor ( fov 400 ) )", "ranger ( sensor ( fov 360 ) )"),
        ("ranger ( sensor ( fov -5 ) )", "ranger ( sensor ( fov 0 ) )"),
        ("blobfinder ( fov 361 )", "blobfinder ( fov 360 )"),
        ("fiducial ( fov -1 )", "fiducial ( fov 0 )"),
        ("camera ( fov [ 400 -1 ] )", "camera ( fov [ 360 0 ] )"),
        ("camera ( pantilt [ -30 370 ] )", "camera ( pantilt [ 330 10 ] )"),
        # lengths that can't be
        ("blobfinder ( range -1 )", "blobfinder ( range 0 )"),
        ("blobfinder ( image [ 0 100001 ] )", "blobfinder ( image [ 1 100000 ] )"),
        ("fiducial ( range_min -1 )", "fiducial ( range_min 0 )"),
        ("fiducial ( range_min 9 range_max 3 )", "fiducial ( range_min 9 range_max 9 )"),
        ("fiducial ( range_max_id -1 )", "fiducial ( range_max_id 0 )"),
        ("bumper ( bcount 2 blength -1 blength[1] -1 )", "bumper ( bcount 2 blength 0 blength[1] 0 )"),
        ("ranger ( sensor ( size [ -1 -2 3 ] ) )", "ranger ( sensor ( size [ 1 2 3 ] ) )"),
        ("gripper ( paddle_size [ 0 0 0 ] )", "gripper ( paddle_size [ 0.01 0.01 0.01 ] )"),
        ("gripper ( paddle_size [ 2 2 2 ] )", "gripper ( paddle_size [ 0.99 0.49 0.99 ] )"),
        ("position ( wheelbase 0 )", "position ( wheelbase 0.001 )"),
        ("model ( mass -3 )", "model ( mass 0 )"),
        ("model ( size [ 0.006 0.004 1 ] boundary 1 )", "model ( size [ -0.006 -0.004 1 ] boundary 1 )"),
        (f"model ( block ( points 3 {TRIANGLE} z [ 1 0 ] ) )", f"model ( block ( points 3 {TRIANGLE} ) )"),
        # errors
        ("position ( odom_error [ -0.1 5 9 ] )", "position ( odom_error [ 0.1 2 2 ] )"),
        (
            "ranger ( sensor ( noise [ -0.1 2 -3 ] ) )",
            "ranger ( sensor ( range_noise 0.1 range_noise_const 2 angle_noise 3 ) )",
        ),
        ("ranger ( sensor ( noise [ 5 0 999 ] ) )", "ranger ( sensor ( noise [ 1 0 360 ] ) )"),
        ('unit_length "cm" ranger ( sensor ( noise [ 0 200 0 ] ) )', "ranger ( sensor ( noise [ 0 2 0 ] ) )"),
        # colours
        ("model ( color_rgba [ 2 -1 0.5 ] )", "model ( color_rgba [ 1 0 0.5 1 ] )"),
        ('blobfinder ( colors "red" )', 'blobfinder ( colors [ "red" ] colors_count 1 )'),
        ('blobfinder ( colors [ "red" "blue" ] colors_count 1 )', 'blobfinder ( colors [ "red" ] )'),
        ('blobfinder ( colors [ "red" ] colors_count -1 )', "blobfinder ( colors [ ] )"),
    ],
)
def test_a_value_that_is_missing_or_can_not_be_is_the_nearest_that_can(text: str, same: str) -> None:
    models, others = ([flat(each) for each in load_text(it, PATH).models] for it in (text, same))

    assert models == others


def flat(it: Model) -> Model:
    """Without the order of the corners of its shapes, which a mirrored one has another way round."""
    shapes = {
        name: tuple(replace(each, points=tuple(sorted(each.points))) for each in getattr(it, name))
        for name in ("polygons", "walls")
    }
    return replace(it, **shapes)


@pytest.mark.parametrize("kind", ["ranger", "blobfinder", "fiducial"])
def test_what_only_looks_has_no_body(kind: str) -> None:
    assert model(f"{kind} ( )").polygons == ()


def test_a_thin_boundary_is_no_thicker_than_half_of_its_box() -> None:
    walls = model("model ( size [ 0.006 0.004 1 ] boundary 1 )").walls

    assert {round(x, 6) for wall in walls for x, _ in wall.points} == {-0.003, 0, 0.003}
    assert {round(y, 6) for wall in walls for _, y in wall.points} == {-0.002, 0, 0.002}
    assert {(wall.bottom, wall.top) for wall in walls} == {(0, 1)}


def test_a_shape_without_a_width_keeps_what_it_has() -> None:
    """Stage can't scale it."""
    line = "block ( points 3 point[0] [ 5 0 ] point[1] [ 5 4 ] point[2] [ 5 2 ] z [ -1 0 ] )"
    (shape,) = model(f"model ( size [ 2 2 3 ] {line} )").polygons

    assert sorted(shape.points) == [(0, -1), (0, 0), (0, 1)]
    assert (shape.bottom, shape.top) == (-1, 0)


@pytest.mark.parametrize(
    ("form", "most", "code"),
    [
        ("bumper ( bcount {} )", 1000, "out-of-range"),
        ("ranger ( sensor ( samples {} ) )", 10_000, "out-of-range"),
        ("model ( block ( points {} ) )", 2000, "too-few-points"),
        ("speedup {}", 10**12, "number-too-large"),
        ('model ( mass "{}" )', 10**12, "number-too-large"),
        ("model ( pose [ {} 0 0 0 ] )", 10**5, "out-of-range"),
        ("model ( pose [ -{} 0 0 0 ] )", 10**5, "out-of-range"),
    ],
)
def test_a_number_may_be_as_large_as_its_limit_and_no_larger(form: str, most: int, code: str) -> None:
    load_text(form.format(most), PATH)

    with pytest.raises(WorldError) as error:
        load_text(form.format(most + 1), PATH)
    assert (error.value.code.value, error.value.details["limit"]) == (code, most)


@pytest.mark.parametrize("number", ["1e999", "-1e999", '"1e999"', '"-1e999"'])
@pytest.mark.parametrize("form", ["bumper ( bcount {} )", "model ( pose [ 0 0 0 {} ] )"])
def test_no_number_is_infinite_in_quotes_or_without(form: str, number: str) -> None:
    assert mistake(form.format(number))[0] == "number-too-large"


def test_all_sensors_of_a_world_together_have_two_million_samples_at_most() -> None:
    fan = "sensor ( samples 10000 ) "
    load_text(f"ranger ( {fan * 150} ) ranger ( {fan * 50} )", PATH)

    with pytest.raises(WorldError) as error:
        load_text(f"ranger ( {fan * 150} ) ranger ( {fan * 50} sensor ( samples 1 ) )", PATH)
    assert (error.value.code.value, error.value.details) == (
        "too-much",
        {"what": "samples", "limit": 2_000_000},
    )


def test_a_misspelt_word_is_reported_with_the_nearest_right_one() -> None:
    (note,) = load_text('gripper ( paddle_state [ "opn" ] )', Path("t.world")).report.notes[:1]

    assert (note.code, note.details["found"], note.details["nearest"]) == ("unknown-word", "opn", "open")


@pytest.mark.parametrize("state", ["open", "closed", "up", "down"])
def test_the_words_for_paddles_are_known(state: str) -> None:
    notes = load_text(f'gripper ( paddle_state "{state}" )', PATH).report.notes

    assert "unknown-word" not in [note.code for note in notes]


def test_a_blinkenlight_is_as_small_as_in_stage() -> None:
    light = model("blinkenlight ( )")

    assert (light.size, light.colour.family) == ((0.02, 0.02, 0.02), "green")


def test_what_things_are_to_sensors_and_grippers_is_read_one_by_one() -> None:
    usual = {"obstacle": 1, "ranger": 1, "blob": 1, "fiducial": 0, "gripper": 0}
    for each in usual:
        it = model(f"model ( {each}_return 5 )")
        assert {name: getattr(it, f"{name}_return") for name in usual} == {**usual, each: 5}
    assert (model("model ( )").fiducial_key, model("model ( fiducial_key 2.9 )").fiducial_key) == (0, 2)


@pytest.mark.parametrize(
    ("text", "count"),
    [
        ("model ( )", 1),
        ("ranger ( )", 0),
        ("gripper ( )", 3),
        ("model ( boundary 1 )", 4),
        (f"model ( block ( points 3 {TRIANGLE} ) block ( points 3 {TRIANGLE} ) )", 2),
        (f"model ( boundary 1 block ( points 3 {TRIANGLE} ) )", 1),
        ('model ( bitmap "u.png" )', 1),
        ('model ( bitmap "u.png" boundary 1 )', 5),
        (f'model ( bitmap "u.png" block ( points 3 {TRIANGLE} ) )', 2),
        (f'model ( bitmap "u.png" boundary 1 block ( points 3 {TRIANGLE} ) )', 2),
    ],
)
def test_stage_makes_one_block_of_an_outline_and_has_walls_where_a_model_has_no_block(
    text: str, count: int, tmp_path: Path
) -> None:
    """The picture is a U, which is three rectangles and one outline."""
    picture = Image.new("L", (3, 2), 0)
    picture.putpixel((1, 0), 255)
    picture.save(tmp_path / "u.png")
    (it,) = load_text(text, tmp_path / "t.world").models

    assert it.stage_blocks == count
    assert it.bitmap == ("u.png" if "u.png" in text else "")


@pytest.mark.parametrize(
    ("text", "names"),
    [
        ("model ( ) model ( ) position ( )", ["model:1", "model:2", "position:0"]),
        ('model ( name "a" ranger ( ) model ( ) ranger ( ) )',
         ["a", "a.ranger:0", "a.model:0", "a.ranger:1"]),
        ('model ( name "a" model ( ) ) window ( model ( ) ) model ( )',
         ["a", "a.model:0", "model:2", "model:3"]),
        ("define box model ( ) box ( )", ["model:1"]),
    ],
)  # fmt: skip
def test_what_has_no_name_is_called_and_numbered_as_in_stage(text: str, names: list[str]) -> None:
    """Stage's floor is model 0."""
    assert [each.name for each in load_text(text, PATH).models] == names


@pytest.mark.parametrize(
    ("text", "notes"),
    [
        ("camera ( )", [("not-simulated", "ignored", 1, "camera", "camera:0")]),
        ('actuator ( name "a" )', [("not-simulated", "ignored", 1, "actuator", "a")]),
        ('lightindicator ( name "a" )', [("not-simulated", "ignored", 1, "lightindicator", "a")]),
        ("blinkenlight ( )", [("not-simulated", "ignored", 1, "blinkenlight", "blinkenlight:0")]),
        ('position ( name "p" ranger ( sensor ( ) ) )', []),
        ('position ( name "p" sensor ( ) )', [("lone-sensor", "repaired", 21, "p")]),
        ("model ( window ( ) )", [("lone-window", "warning", 9)]),
        ("model ( window ( x 1 ) )",
         [("unknown-property", "ignored", 18, "x", ""), ("lone-window", "warning", 9)]),
        ("model ( window ( friction 1 ) )", [("lone-window", "warning", 9)]),
        (f"model ( block ( points 4 {TRIANGLE} ) )", [("missing-point", "warning", 9, "point[3]")]),
        (f"model ( block ( x 1 points 3 {TRIANGLE} ) )", [("unknown-property", "ignored", 17, "x", "")]),
        (f"model ( block ( points 2 {TRIANGLE} ) )", [("line-block", "warning", 9)]),
        ("ranger ( sensor ( samples 0 ) )", [("no-samples", "warning", 10)]),
        ("ranger ( sensor ( x 1 ) )", [("unknown-property", "ignored", 19, "x", "")]),
        ("window ( friction 1 )", []),
        ("model ( friction 1 )", [("unused-property", "ignored", 9, "friction")]),
        ("model ( gui_nose 1 )", []),
        ("define a model ( mass 1 ) a ( ) a ( x 1 )", [("unknown-property", "ignored", 37, "x", "")]),
        ('model ( name "w" boundary 1 obstacle_return 0 )', [("walls-made-solid", "repaired", 0, "w")]),
    ],
)  # fmt: skip
def test_each_remark_has_its_kind_its_place_and_what_it_is_about(
    text: str, notes: list[tuple[str | int, ...]]
) -> None:
    found = load_text(text, PATH).report.notes

    said = [(each.code, each.kind.value, each.column, *each.details.values()) for each in found]
    assert [each for each in said if each[0] != "no-robot"] == notes


TUPLES = """
    pose origin size color_rgba point point[7] z velocity paddle_size noise odom_error velocity_bounds bpose
    acceleration_bounds localization_origin image scatter pantilt rotate center watts_size provides requires
    axis
"""
NUMBERS_AND_TEXTS = """
    name color bitmap boundary obstacle_return ranger_return blob_return fiducial_return fiducial_key pushable
    gripper_return mass ignore_zloc unit_length unit_angle range fov samples range_min range_max range_max_id
    range_noise range_noise_const angle_noise colors colors_count pan bcount blength blength[3] paddle_state
    autosnatch drive localization wheelbase points resolution type scale interval_sim paused quit_time threads
    gui_nose gui_grid gui_move gui_outline alwayson update_interval trail_length trail_interval debug
    map_resolution stack_children rebuild ctrl interval interval_real speedup show_data show_follow show_clock
    show_clock_interval show_flags show_blocks show_bboxerr show_grid show_trails show_occupancy pcam_on
    object_return friction energy_capacity joules joules_capacity watts watts_give watts_take kjoules
    max_speed max_position min_position start_position enabled break_beam period dutycycle sticky_return
    laser_return audio channel_count plugin worldfile model alarm say texture mesh
"""
WITHOUT_USE = """
    velocity pantilt rotate center watts_size provides requires axis scatter resolution type scale interval
    interval_sim interval_real paused speedup quit_time object_return friction threads show_data show_follow
    show_clock show_clock_interval show_flags show_blocks show_bboxerr show_grid show_trails show_occupancy
    pcam_on energy_capacity joules joules_capacity watts watts_give watts_take kjoules max_speed max_position
    min_position start_position enabled break_beam period dutycycle sticky_return laser_return audio
    channel_count plugin worldfile model alarm say texture mesh
"""
"""In a model, of those of Stage and the drivers of Player."""


def checked(name: str, value: Value, quiet: bool = False) -> list[str]:
    """The remarks about a property, by their codes."""
    reader = ValueReader()
    reader.check({name: Setting("t.world", Property(1, 1, name, value))}, quiet)
    return [each.code for each in reader.notes]


@pytest.mark.parametrize("name", (TUPLES + NUMBERS_AND_TEXTS).split())
def test_each_known_property_is_noted_if_nothing_uses_it(name: str) -> None:
    codes = ["unused-property"] if name in WITHOUT_USE.split() else []

    assert checked(name, Tuple(1, 1, ())) == codes
    assert checked(name, Tuple(1, 1, ()), quiet=True) == []


@pytest.mark.parametrize("name", TUPLES.split())
def test_a_property_of_several_numbers_is_a_tuple(name: str) -> None:
    with pytest.raises(WorldError) as error:
        checked(name, String(1, 1, "1"))

    assert (error.value.code, error.value.expected) == (Code.WRONG_TYPE, ("tuple",))


@pytest.mark.parametrize("name", NUMBERS_AND_TEXTS.split())
def test_a_property_of_one_value_may_be_written_plainly(name: str) -> None:
    assert checked(name, String(1, 1, "1"), quiet=True) == []


@pytest.mark.parametrize(
    "kind", ["blobfinder", "fiducial", "bumper", "gripper", "camera", "position", "ranger"]
)
def test_a_model_has_the_equipment_of_its_kind_only(kind: str) -> None:
    it = model(f"{kind} ( bcount 1 sensor ( ) )")
    given = {
        "blobfinder": it.blobfinder,
        "fiducial": it.fiducial_finder,
        "bumper": it.bumpers,
        "gripper": it.gripper,
        "camera": it.camera,
        "position": it.wheels,
        "ranger": it.sensors,
    }

    assert [each for each, equipment in given.items() if equipment] == [kind]


@pytest.mark.parametrize(
    ("text", "code", "column", "details"),
    [
        ("sensor ( )", "misplaced", 1, {"found": "sensor"}),
        ("block ( )", "misplaced", 1, {"found": "block"}),
        ("model ( block ( ) )", "too-few-points", 9, {"given": 0, "limit": 2000}),
        ("model ( block ( points 2001 ) )", "too-few-points", 9, {"given": 2001, "limit": 2000}),
        ("bumper ( bcount 1001 )", "out-of-range", 17, {"name": "bcount", "limit": 1000}),
    ],
)
def test_a_mistake_in_a_shape_says_what_there_is_and_what_may_be(
    text: str, code: str, column: int, details: dict[str, object]
) -> None:
    with pytest.raises(WorldError) as error:
        load_text(text, PATH)

    assert (error.value.code.value, error.value.column, error.value.details) == (code, column, details)


def test_the_paddles_of_a_gripper_close_to_the_middle_and_rise_with_the_lift() -> None:
    """Of a gripper of 1 by 1 by 1 m: paddles of 0.6 by 0.1, and 0.4 high."""
    text = 'gripper ( size [ 1 1 1 ] paddle_size [ 0.6 0.1 0.4 ] paddle_state [ "{}" "{}" ] )'

    def shapes(*state: str) -> list[tuple[float, ...]]:
        found = []
        for each in model(text.format(*state)).polygons:
            xs, ys = zip(*each.points, strict=True)
            found.append(
                tuple(round(at, 6) for at in (min(xs), max(xs), min(ys), max(ys), each.bottom, each.top))
            )
        return found

    base = (-0.5, -0.1, -0.5, 0.5, 0, 1)
    assert shapes("open", "down") == [base, (-0.1, 0.5, -0.5, -0.4, 0, 0.4), (-0.1, 0.5, 0.4, 0.5, 0, 0.4)]
    assert shapes("closed", "up") == [base, (-0.1, 0.5, -0.1, 0, 0.6, 1), (-0.1, 0.5, 0, 0.1, 0.6, 1)]


@pytest.mark.parametrize(
    ("size", "origin", "walls"),
    [
        ("4 2 1", "0 0 0", [(-2, 2, -1, -0.99), (-2, 2, 0.99, 1), (-2, -1.99, -1, 1), (1.99, 2, -1, 1)]),
        ("4 2 1", "1 0 0", [(-1, 3, -1, -0.99), (-1, 3, 0.99, 1), (-1, -0.99, -1, 1), (2.99, 3, -1, 1)]),
        ("4 2 1", "0 0 0 90", [(0.99, 1, -2, 2), (-1, -0.99, -2, 2), (-1, 1, -2, -1.99), (-1, 1, 1.99, 2)]),
    ],
)  # fmt: skip
def test_the_walls_of_a_boundary_lie_within_its_box_around_its_origin(
    size: str, origin: str, walls: list[tuple[float, ...]]
) -> None:
    found = []
    for each in model(f"model ( size [ {size} ] origin [ {origin} ] boundary 1 )").walls:
        xs, ys = zip(*each.points, strict=True)
        found.append(tuple(round(at, 6) for at in (min(xs), max(xs), min(ys), max(ys))))

    assert sorted(found) == sorted(walls)


def test_a_block_that_says_no_height_is_one_high_among_those_that_do() -> None:
    tall = f"block ( points 3 {TRIANGLE} z [ 2 4 ] )"
    usual, high = model(f"model ( size [ 1 1 2 ] block ( points 3 {TRIANGLE} ) {tall} )").polygons

    assert (usual.bottom, usual.top, high.bottom, high.top) == (0, 0.5, 1, 2)
    (whole,) = model("model ( size [ 1 1 2 ] )").polygons
    assert (whole.bottom, whole.top) == (0, 2)
