"""World files that load, and what each piece of the language means."""

from colorsys import hsv_to_rgb
from pathlib import Path

import pytest

from sim.colours import FAMILIES, colour_of, families, rgb
from sim.geometry import Placement
from sim.scene import Model, Note, NoteKind, Scene
from sim.worldfile import Code, WorldError, load_text, load_world


def load(text: str) -> Scene:
    return load_text(text, Path("test.world"))


def only(text: str) -> Model:
    (model,) = load(text).models
    return model


@pytest.mark.parametrize(
    "text",
    [
        "model(pose[1 2 0 3])",
        "model ( pose [ 1 2 0 3 ] )",
        "model # what\n(\n pose # where\n [ 1 # x\n 2 0\n\n 3 ] )",
        "model\r\n(\r\n\tpose [1 2 0 3]\r\n)\r\n",
        "\ufeffmodel ( pose [ +1.0 2e0 .0 30e-1 ] )",
        "model ( pose [ 9 9 9 9 ] pose [ 1. 2 0 3 ] )",
        "model ( pose [ 1 2 3 ] )",
        'unit_length "cm" model ( pose [ 100 200 0 3 ] )',
        'model ( pose [ 1000 2000 0 3 ] ) unit_length "mm"',
        'unit_angle "radians" model ( pose [ 1 2 0 0.05235987755982989 ] )',
        "define a model ( pose [ 1 2 0 3 ] ) a ( )",
        "define a model ( pose [ 7 7 7 7 ] ) define b a ( pose [ 1 2 0 3 ] ) b ( )",
        "define a model ( pose [ 1 2 0 3 ] ) define a model ( pose [ 9 9 9 9 ] ) a ( )",
        "a ( ) define a model ( pose [ 1 2 0 3 ] )",
    ],
)
def test_one_model_written_in_many_ways(text: str) -> None:
    pose = only(text.replace("\ufeff", "")).pose

    assert (pose.x, pose.y, pose.z, pose.yaw) == pytest.approx((1, 2, 0, 3))


@pytest.mark.parametrize("text", ["", "# nothing\n", "\n\n", "window ( size [ 3 3 ] )", "speedup 0"])
def test_a_world_may_be_empty(text: str) -> None:
    scene = load(text)

    assert scene.models == ()
    assert [note.code for note in scene.report.notes] == ["no-robot"]


def test_the_worlds_own_properties_are_kept() -> None:
    assert load('resolution 0.02 size [ 15 15 ] x "y"').settings == {
        "resolution": 0.02,
        "size": (15.0, 15.0),
        "x": "y",
    }


def test_defaults_are_those_of_stage() -> None:
    model = only("model ( )")

    assert (model.type, model.name, model.size) == ("model", "model:1", (0.4, 0.4, 1.0))
    assert (model.colour.red, model.colour.green, model.colour.blue) == (1, 0, 0)
    assert (model.obstacle_return, model.ranger_return, model.blob_return) == (1, 1, 1)
    assert (model.fiducial_return, model.gripper_return) == (0, 0)
    (block,) = model.polygons
    assert set(block.points) == {(-0.2, -0.2), (0.2, -0.2), (0.2, 0.2), (-0.2, 0.2)}


def test_children_stand_on_their_parent_and_turn_with_it() -> None:
    inner = "model ( pose [ 1 0 0.1 45 ] model ( pose [ 0 1 0 0 ] ) )"
    text = f"model ( pose [ 1 1 0 90 ] size [ 1 1 0.5 ] {inner} )"
    _, child, grandchild = load(text).models

    assert (child.pose.x, child.pose.y, child.pose.z, child.pose.yaw) == (1, 2, 0.6, 135)
    assert (grandchild.pose.x, grandchild.pose.y) == pytest.approx((1 - 0.5**0.5, 2 - 0.5**0.5))
    assert (child.parent, child.root, grandchild.parent, grandchild.root) == (0, 0, 1, 0)
    assert (child.name, grandchild.name) == ("model:1.model:0", "model:1.model:0.model:0")


@pytest.mark.parametrize(
    ("written", "pose", "origin"),
    [
        ("pose [ 1 2 90 ]", Placement(1, 2, 0, 90), Placement()),
        ("pose [ 1 2 3 90 ]", Placement(1, 2, 3, 90), Placement()),
        ("origin [ 1 2 3 ]", Placement(), Placement(1, 2, 3)),
        ("origin [ 1 2 3 90 ]", Placement(), Placement(1, 2, 3, 90)),
    ],
)
def test_the_third_of_three_numbers_is_the_yaw_of_a_pose_and_the_height_of_an_origin(
    written: str, pose: Placement, origin: Placement
) -> None:
    (model,) = load(f"model ( size [ 1 1 1 ] {written} )").models

    assert (model.pose, model.origin) == (pose, origin)


def test_an_include_that_leads_outside_gives_way_to_one_in_an_allowed_folder(tmp_path: Path) -> None:
    for folder in ("outside", "world", "allowed"):
        (tmp_path / folder).mkdir()
        (tmp_path / folder / "part.inc").write_text(f'model ( name "{folder}" )')
    (tmp_path / "world" / "part.inc").unlink()
    (tmp_path / "world" / "part.inc").symlink_to(tmp_path / "outside" / "part.inc")
    (tmp_path / "world" / "top.world").write_text('include "part.inc"')

    scene = load_world(tmp_path / "world" / "top.world", allowed=(tmp_path / "allowed",))

    assert [each.name for each in scene.models] == ["allowed"]


def test_origin_shifts_the_shape_and_not_the_children() -> None:
    parent, child = load("model ( size [ 2 2 1 ] origin [ 0.5 0 0 ] model ( ) )").models

    assert {x for x, _ in parent.polygons[0].points} == {-0.5, 1.5}
    assert (child.pose.x, child.pose.y) == (0, 0)


def test_all_blocks_together_are_scaled_and_centred_to_the_size() -> None:
    left = "block ( points 3 point[0] [ 10 10 ] point[1] [ 20 10 ] point[2] [ 10 30 ] z [ 0 2 ] )"
    right = "block ( points 3 point[0] [ 30 10 ] point[1] [ 20 10 ] point[2] [ 30 30 ] z [ 2 4 ] )"
    first, second = only(f"model ( size [ 2 1 1 ] {left} {right} )").polygons

    assert first.points == ((-1, -0.5), (0, -0.5), (-1, 0.5))
    assert second.points == ((1, -0.5), (0, -0.5), (1, 0.5))
    assert (first.bottom, first.top, second.bottom, second.top) == (0, 0.5, 0.5, 1)


def test_a_boundary_is_four_thin_walls_inside_the_box() -> None:
    model = only("model ( size [ 4 2 1 ] boundary 1 )")

    assert model.polygons == ()
    assert len(model.walls) == 4
    assert {round(x, 9) for wall in model.walls for x, _ in wall.points} == {-2, -1.99, 1.99, 2}
    assert {round(y, 9) for wall in model.walls for _, y in wall.points} == {-1, -0.99, 0.99, 1}


def test_a_boundary_next_to_blocks_holds_too() -> None:
    model = only("model ( boundary 1 block ( points 3 point[0] [ 0 0 ] point[1] [ 1 0 ] point[2] [ 0 1 ] ) )")

    assert (len(model.polygons), len(model.walls)) == (1, 4)


@pytest.mark.parametrize("name", ["DarkBlue", "darkblue", "dark blue", "DARK BLUE"])
def test_colours_are_named_in_any_case(name: str) -> None:
    colour = only(f'model ( color "{name}" )').colour

    assert (colour.red, colour.green, round(colour.blue * 255), colour.family) == (0, 0, 139, "blue")


@pytest.mark.parametrize(
    ("degrees", "saturation", "value", "family"),
    [
        *((0, 1, 1, "red"), (11.9, 1, 1, "red"), (12.1, 1, 1, "orange"), (47.9, 1, 1, "orange")),
        *((48.1, 1, 1, "yellow"), (69.9, 1, 1, "yellow"), (70.1, 1, 1, "green"), (164.9, 1, 1, "green")),
        *((165.1, 1, 1, "blue"), (269.9, 1, 1, "blue"), (270.1, 1, 1, "pink"), (344.9, 1, 1, "pink")),
        *((345.1, 1, 1, "red"), (359, 1, 1, "red")),
        *((0, 0.4, 0.9, "pink"), (350, 0.4, 0.9, "pink"), (11, 0.4, 0.9, "pink"), (13, 0.4, 0.9, "orange")),
        *((0, 0.4, 0.5, "red"), (350, 0.6, 0.9, "red"), (200, 0.4, 0.9, "blue")),
        *((200, 0.14, 0.9, "gray"), (200, 0.16, 0.9, "blue"), (200, 1, 0.14, "gray"), (200, 1, 0.16, "blue")),
    ],
)
def test_the_word_of_a_colour_depends_on_its_hue(
    degrees: float, saturation: float, value: float, family: str
) -> None:
    colour = colour_of("", *hsv_to_rgb(degrees / 360, saturation, value))

    assert colour.family == family
    assert colour_of("Light Gray", 1, 0, 0).family == colour_of("grey9", 1, 0, 0).family == "gray"
    assert colour_of("HotPink", 0, 0, 1).family == "pink"


@pytest.mark.parametrize(
    ("name", "level"),
    [
        *(("gray0", 0), ("gray1", 3), ("gray10", 26), ("gray 30", 77), ("grey33", 84), ("Gray50", 127)),
        *(
            ("gray51", 130),
            ("gray66", 168),
            ("grey70", 179),
            ("gray90", 229),
            ("gray99", 252),
            ("gray100", 255),
        ),
    ],
)
def test_the_levels_of_gray_are_those_of_x11(name: str, level: int) -> None:
    assert rgb(name) == (level, level, level)


@pytest.mark.parametrize(
    ("name", "levels"),
    [
        ("SteelBlue", (70, 130, 180)),
        ("tomato", (255, 99, 71)),
        ("Light Goldenrod Yellow", (250, 250, 210)),
        ("orange3", (205, 133, 0)),
        ("orange5", None),
        ("", None),
    ],
)
def test_colours_have_the_levels_of_x11(name: str, levels: tuple[int, int, int] | None) -> None:
    assert rgb(name) == levels


def test_a_colour_is_the_same_as_another_of_its_levels_whatever_its_name() -> None:
    middle = colour_of("", 0.5, 0.6, 0.7)

    assert middle.same(colour_of("any", 0.5, 0.6, 0.7, 0.1))
    assert middle.same(colour_of("", 0.503, 0.597, 0.703))
    for levels in ((0.505, 0.6, 0.7), (0.5, 0.595, 0.7), (0.5, 0.6, 0.705)):
        assert not middle.same(colour_of("", *levels))


def test_cameras_distinguish_all_words_or_those_of_their_colours() -> None:
    red, blue, dark = (
        colour_of(each, *levels)
        for each, levels in (
            ("red", (1.0, 0.0, 0.0)),
            ("blue", (0.0, 0.0, 1.0)),
            ("DarkBlue", (0.0, 0.0, 139 / 255)),
        )
    )

    assert families([(red,), (blue, dark)]) == {"red", "blue"}
    assert families([(red,), ()]) == families([()]) == set(FAMILIES)
    assert families([]) == frozenset()
    assert red.same(colour_of("", 1.0, 0.0, 0.0, 0.5))
    for changed in ((253 / 255, 0.0, 0.0), (1.0, 1 / 255, 0.0), (1.0, 0.0, 1 / 255)):
        assert not red.same(colour_of("", *changed))


def test_an_unknown_colour_is_red_and_a_warning_with_the_nearest_name() -> None:
    scene = load('\nmodel ( color "gren" )')

    (note, _) = scene.report.notes
    assert scene.models[0].colour == colour_of("red", 1.0, 0.0, 0.0)
    assert (note.kind, note.code, note.line, note.column) == (NoteKind.WARNING, "unknown-colour", 2, 9)
    assert note.details == {"name": "gren", "nearest": "green"}


@pytest.mark.parametrize(("typed", "meant"), [("rde", "red"), ("bleu", "blue"), ("xyz", "")])
def test_a_misspelt_short_colour_is_reported_with_the_nearest_name_too(typed: str, meant: str) -> None:
    assert load(f'model ( color "{typed}" )').report.notes[0].details["nearest"] == meant


def test_a_random_colour_is_one_of_the_language_is_stable_and_reported_once() -> None:
    text = 'define ball model ( color "random" )\n' + "ball ( ) " * 60 + 'model ( color "Random" )'
    scene, again = load(text), load(text)

    taken = [model.colour for model in scene.models]
    assert taken == [model.colour for model in again.models]
    assert {colour.name for colour in taken} == set(FAMILIES)
    assert all(colour.family == colour.name for colour in taken)
    said = [(note.kind, note.line) for note in scene.report.notes if note.code == "random-colour"]
    assert said == [(NoteKind.WARNING, 1), (NoteKind.WARNING, 2)]


@pytest.mark.parametrize(
    ("name", "family"),
    [
        *((word, word) for word in ("red", "green", "blue", "yellow", "orange", "pink", "gray")),
        ("green3", "green"),
        ("red3", "red"),
        ("OrangeRed", "orange"),
        ("grey50", "gray"),
        ("DeepPink", "pink"),
        ("cyan", "blue"),
        ("gold", "yellow"),
        ("black", "gray"),
        ("white", "gray"),
        ("firebrick", "red"),
        ("SaddleBrown", "orange"),
    ],
)
def test_every_colour_has_a_word_that_learners_know(name: str, family: str) -> None:
    assert only(f'model ( color "{name}" )').colour.family == family


def test_a_macro_gives_its_children_to_every_instance() -> None:
    text = "define eye sensor ( fov 20 ) define eyes ranger ( eye ( ) eye ( pose [ 0 1 0 0 ] ) )"
    scene = load(text + 'position ( name "a" eyes ( ) ) position ( name "b" eyes ( sensor ( ) ) )')

    assert [model.name for model in scene.models] == ["a", "a.ranger:0", "b", "b.ranger:0"]
    assert [len(model.sensors) for model in scene.models] == [0, 2, 0, 3]
    assert scene.models[1].sensors[1].pose.y == 1
    assert scene.models[1].kind == "eyes"


def test_a_macro_may_have_the_name_of_a_type() -> None:
    assert only("define model model ( size [ 1 1 1 ] ) model ( )").size == (1, 1, 1)


def test_a_second_macro_of_a_name_is_warned_about() -> None:
    scene = load("define a model ( )\ndefine a model ( )")

    note = scene.report.notes[0]
    assert (note.code, note.line) == ("second-define", 2)


def test_a_sensor_placed_straight_into_a_robot_becomes_a_ranger() -> None:
    scene = load("position ( sensor ( pose [ 1 0 0 0 ] range [ 0 2 ] ) )")

    assert [model.type for model in scene.models] == ["position", "ranger"]
    assert scene.models[1].sensors[0].maximum == 2
    assert "lone-sensor" in [note.code for note in scene.report.notes]
    assert scene.robots == (0,)


def test_robots_are_the_positions_that_sense_distances_or_colours() -> None:
    scene = load(
        "position ( ) model ( ranger ( ) ) position ( ranger ( ) )"
        " position ( position ( blobfinder ( ) ) ) position ( bumper ( ) )"
    )

    assert [scene.models[robot].name for robot in scene.robots] == ["position:1", "position:2", "position:3"]


def test_any_sensor_makes_a_robot_where_no_position_has_these() -> None:
    assert load("position ( ) position ( bumper ( ) )").robots == (1,)


def test_an_unknown_property_is_ignored_and_reported_with_the_nearest_name() -> None:
    scene = load("model ( obstacle_retrun 0 )")

    note = scene.report.notes[0]
    assert (note.kind, note.code) == (NoteKind.IGNORED, "unknown-property")
    assert note.details == {"name": "obstacle_retrun", "nearest": "obstacle_return"}


def test_an_unsimulated_property_of_a_macro_is_reported_once() -> None:
    scene = load("define f actuator ( axis [ 1 0 0 ] )\n" + "model ( f ( ) )\n" * 50)

    codes = [note.code for note in scene.report.notes]
    assert codes.count("unused-property") == 1
    assert codes.count("not-simulated") == 50  # each stands in a line of its own


def test_walls_that_robots_could_drive_through_are_made_solid() -> None:
    scene = load('model ( name "hall" boundary 1 obstacle_return 0 )')

    assert scene.models[0].solid
    assert "walls-made-solid" in [note.code for note in scene.report.notes]


def test_marks_on_the_floor_are_not_made_solid_and_walls_need_it_not() -> None:
    for world in ('model ( name "mark" obstacle_return 0 )', 'model ( name "hall" boundary 1 )'):
        assert "walls-made-solid" not in [note.code for note in load(world).report.notes]


def test_includes_are_looked_for_next_to_the_file_then_next_to_the_world(tmp_path: Path) -> None:
    (tmp_path / "parts").mkdir()
    (tmp_path / "parts" / "a.inc").write_text('include "near.inc" include "far.inc"')
    (tmp_path / "parts" / "near.inc").write_text('model ( name "near, in parts" )')
    (tmp_path / "near.inc").write_text('model ( name "near, at the top" )')
    (tmp_path / "far.inc").write_text('model ( name "far" )')
    (tmp_path / "top.world").write_text('include "parts/a.inc"')

    scene = load_world(tmp_path / "top.world")

    assert [model.name for model in scene.models] == ["near, in parts", "far"]
    assert len(scene.report.files) == 4


def test_a_file_may_be_included_twice(tmp_path: Path) -> None:
    (tmp_path / "a.inc").write_text("model ( )")

    assert len(load_text('include "a.inc" include "a.inc"', tmp_path / "t.world").models) == 2


def test_a_file_in_an_old_encoding_loads_and_is_reported(tmp_path: Path) -> None:
    (tmp_path / "old.world").write_bytes('model ( name "ch\xe3o" ) # \xe9'.encode("latin-1"))

    scene = load_world(tmp_path / "old.world")

    assert scene.models[0].name == "chão"
    file = str(tmp_path / "old.world")
    assert scene.report.notes[0] == Note(REPAIRED, "not-utf8", file, 1, 1, {"path": file})


def test_a_byte_order_mark_is_ignored(tmp_path: Path) -> None:
    (tmp_path / "marked.world").write_bytes(b"\xef\xbb\xbfmodel ( )")

    assert len(load_world(tmp_path / "marked.world").models) == 1


def test_two_thousand_models_load() -> None:
    scene = load("".join(f"model ( pose [ {i} 0 0 0 ] )\n" for i in range(2000)))

    assert len(scene.models) == 2000
    assert scene.report.loaded == (("model", 2000),)


@pytest.mark.parametrize("depth", [1, 5, 30])
def test_models_may_be_nested(depth: int) -> None:
    assert len(load("model ( " * depth + ")" * depth).models) == depth


def remarked(scene: Scene) -> list[tuple[str, int, dict[str, object]]]:
    return [(note.code, note.column, dict(note.details)) for note in scene.report.notes if note.details]


@pytest.mark.parametrize(
    ("few", "many", "name", "count"),
    [
        ("pose [ 1 2 3 4 ]", "pose [ 1 2 3 4 5 ]", "pose", "4"),
        ("origin [ 1 2 3 4 ]", "origin [ 1 2 3 4 5 6 ]", "origin", "4"),
        ("size [ 1 2 3 ]", "size [ 1 2 3 4 ]", "size", "3"),
        ("color_rgba [ 0 1 0 1 ]", "color_rgba [ 0 1 0 1 1 ]", "color_rgba", "4"),
        ("odom_error [ 1 1 0 2 ]", "odom_error [ 1 1 0 2 7 7 ]", "odom_error", "4"),
        (
            "velocity_bounds [ 0 1 0 1 0 1 0 9 ]",
            "velocity_bounds [ 0 1 0 1 0 1 0 9 9 ]",
            "velocity_bounds",
            "8",
        ),
    ],
)
def test_values_beyond_those_that_a_property_takes_have_no_effect(
    few: str, many: str, name: str, count: str
) -> None:
    """Stage reads as many as it wants. Its users write 5 numbers after pose, 6 after odom_error."""
    scene = load(f"position ( {many} )")

    assert scene.models == load(f"position ( {few} )").models
    assert remarked(scene)[0] == ("first-values", 12, {"name": name, "count": count})


def test_too_many_values_of_sensors_and_blocks_have_no_effect_either() -> None:
    few = (
        "model ( ranger ( sensor ( range [ 0 5 ] noise [ 1 2 3 ] ) ) bumper ( bcount 1 bpose[0] [ 1 2 3 4 ] )"
        " camera ( range [ 0 5 ] fov [ 60 40 ] pantilt [ 1 2 ] ) blobfinder ( image [ 8 6 ] )"
        " gripper ( paddle_size [ 0.5 0.2 0.3 ] )"
        " block ( points 3 point[0] [ 0 0 ] point[1] [ 1 0 ] point[2] [ 1 1 ] z [ 0 1 ] ) )"
    )
    many = few.replace(" ]", " 7 ]")

    assert load(many).models == load(few).models


@pytest.mark.parametrize(
    ("text", "same", "found", "used", "near"),
    [
        ('position ( drive "boat" )', 'position ( drive "diff" )', "boat", "diff", ""),
        ('position ( drive "omini" )', "position ( )", "omini", "diff", "omni"),
        ('position ( localization "map" )', "position ( )", "map", "gps", ""),
        ('unit_length "mile" model ( size [ 1 2 3 ] )', "model ( size [ 1 2 3 ] )", "mile", "m", ""),
        (
            'unit_angle "degree" model ( pose [ 0 0 0 9 ] )',
            "model ( pose [ 0 0 0 9 ] )",
            "degree",
            "degrees",
            "",
        ),
    ],
)
def test_where_a_word_is_not_known_the_usual_one_counts_and_a_warning_says_so(
    text: str, same: str, found: str, used: str, near: str
) -> None:
    scene = load(text)
    (note,) = (note for note in scene.report.notes if note.code == "unknown-word")

    assert scene.models == load(same).models
    assert note.kind is NoteKind.WARNING
    assert (note.details["found"], note.details["used"]) == (found, used)
    assert not near or note.details["nearest"] == near


def test_a_corner_that_is_missing_is_at_0_0_and_a_warning_says_so() -> None:
    scene = load("model ( block ( points 3 point[1] [ 1 0 ] point[2] [ 1 1 ] ) )")

    assert (
        scene.models
        == load("model ( block ( points 3 point[0] [ 0 0 ] point[1] [ 1 0 ] point[2] [ 1 1 ] ) )").models
    )
    assert remarked(scene) == [("missing-point", 9, {"name": "point[0]"})]


IGNORED, REPAIRED, WARNING = NoteKind.IGNORED, NoteKind.REPAIRED, NoteKind.WARNING


@pytest.mark.parametrize(
    ("text", "kind", "code", "line", "column", "details"),
    [
        ('\nposition ( name "it" sensor ( ) )', REPAIRED, "lone-sensor", 2, 22, {"name": "it"}),
        ("model ( window ( ) )", WARNING, "lone-window", 1, 9, {}),
        ("model ( window ( show_data 1 ) )", WARNING, "lone-window", 1, 9, {}),
        *(
            (f'{each} ( name "it" )', IGNORED, "not-simulated", 1, 1, {"type": each, "name": "it"})
            for each in ("camera", "actuator", "lightindicator", "blinkenlight")
        ),
        ("ranger ( sensor ( samples 0 ) )", WARNING, "no-samples", 1, 10, {}),
        ("model ( mas 3 )", IGNORED, "unknown-property", 1, 9, {"name": "mas", "nearest": "mass"}),
        ("window ( siz 3 )", IGNORED, "unknown-property", 1, 10, {"name": "siz", "nearest": "size"}),
        ("model ( friction 1 )", IGNORED, "unused-property", 1, 9, {"name": "friction"}),
        ("model ( scatter [ 1 2 3 4 ] )", IGNORED, "unused-property", 1, 9, {"name": "scatter"}),
        ("define a model ( )\n define a model ( )", WARNING, "second-define", 2, 2, {"name": "a"}),
        ("define a model ( 5 )", WARNING, "broken-define", 1, 18, {"name": "a"}),
        ('model ( color "random" )', WARNING, "random-colour", 1, 9, {}),
        (
            'model ( name "hall" boundary 1 obstacle_return 0 )',
            *(REPAIRED, "walls-made-solid", 0, 0, {"name": "hall"}),
        ),
        (
            'position ( name "it" drive "omini" )',
            *(WARNING, "unknown-word", 1, 22),
            {"name": "drive", "found": "omini", "used": "diff", "nearest": "omni"},
        ),
        (
            'gripper ( paddle_state [ "opn" ] )',
            *(WARNING, "unknown-word", 1, 11),
            {"name": "paddle_state", "found": "opn", "used": "open down", "nearest": "open"},
        ),
    ],
)
def test_a_remark_has_its_kind_its_place_and_its_details(
    text: str, kind: NoteKind, code: str, line: int, column: int, details: dict[str, str]
) -> None:
    file = "" if line == 0 else "test.world"
    notes = [note for note in load(text).report.notes if note.code != "no-robot"]

    assert notes == [Note(kind, code, file, line, column, details)]


def test_a_world_without_a_robot_is_reported_at_its_beginning() -> None:
    assert load("\n model ( )").report.notes == (Note(WARNING, "no-robot", "test.world", 1, 1, {}),)


def test_what_a_window_has_is_checked_and_has_no_effect() -> None:
    assert [note.code for note in load("show_data 1 window ( show_data 1 )").report.notes] == ["no-robot"]
    for text in ("window ( pose 3 )", "model ( window ( pose 3 ) )"):
        with pytest.raises(WorldError) as error:
            load(text)
        assert error.value.code is Code.WRONG_TYPE


LONG = "x" * 300


@pytest.mark.parametrize(
    ("text", "detail", "length"),
    [
        (f'model ( color "{LONG}" )', "name", 60),
        (f"model ( {LONG} 1 )", "name", 60),
        (f'position ( drive "{LONG}" )', "found", 60),
        (f'model ( mass "{LONG}" )', "found", 60),
        (f'model ( color [ "{LONG}" ] )', "used", 60),
        (f"{LONG} ( )", "found", 60),
        (f'"{LONG}"', "found", 60),
        (f"size [ 5{LONG} ]", "found", 40),
        (f"speedup {'9' * 300}", "found", 40),
        (f'include "{LONG}"', "path", 200),
        (f'model ( bitmap "{LONG}" )', "path", 200),
    ],
)
def test_no_more_is_quoted_of_a_long_word_than_can_be_listened_to(
    text: str, detail: str, length: int
) -> None:
    try:
        found = load(text).report.notes[0].details
    except WorldError as error:
        found = error.details

    assert len(str(found[detail])) == length


def test_a_white_picture_has_no_body(tmp_path: Path) -> None:
    """Stage makes the blocks of a model with a picture from its dark pixels alone."""
    (tmp_path / "white.pgm").write_bytes(b"P5 4 4 255 " + b"\xff" * 16)
    file = tmp_path / "white.world"
    file.write_text('model ( bitmap "white.pgm" size [ 9 9 1 ] )')
    (model,) = load_world(file).models

    assert model.polygons == ()


def test_a_model_whose_picture_has_no_name_has_no_body_and_a_warning_says_so() -> None:
    scene = load('model ( bitmap "" size [ 9 9 1 ] )')

    assert scene.models[0].polygons == ()
    assert [note.column for note in scene.report.notes if note.code == "empty-bitmap"] == [9]


def test_a_body_may_include_what_stands_in_it(tmp_path: Path) -> None:
    """Stage puts the words of the other file in place of the line, wherever that is."""
    (tmp_path / "eye.inc").write_text('color "blue"\nranger (\n include "far.inc"\n)\n')
    (tmp_path / "far.inc").write_text("sensor ( range [ 0 3 ] )\nsize [ 0.1 0.1 0.1 ]\n")
    file = tmp_path / "top.world"
    file.write_text('define bot position (\n include "eye.inc"\n)\nbot ( color "green" )\nbot ( )\n')
    scene = load_world(file)

    assert [(each.type, each.colour.name) for each in scene.models] == [
        *(("position", "green"), ("ranger", "")),
        *(("position", "blue"), ("ranger", "")),
    ]
    assert [each.sensors[0].maximum for each in scene.models if each.sensors] == [3, 3]
    assert scene.models[1].size == (0.1, 0.1, 0.1)
    assert [Path(each).name for each in scene.report.files] == ["top.world", "eye.inc", "far.inc"]


@pytest.mark.parametrize(
    ("text", "code", "line", "column"),
    [
        ("size [ 1 1 1 ]\nsize 5", Code.WRONG_TYPE, 2, 6),
        ("define x model ( )", Code.MISPLACED, 1, 1),
        ('include "part.inc"', Code.INCLUDE_CYCLE, 1, 9),
        ("gizmo ( )", Code.UNKNOWN_TYPE, 1, 1),
    ],
)
def test_a_mistake_in_what_a_body_includes_has_the_place_in_that_file(
    tmp_path: Path, text: str, code: Code, line: int, column: int
) -> None:
    (tmp_path / "part.inc").write_text(text)
    (tmp_path / "top.world").write_text('model (\n include "part.inc"\n)\n')
    with pytest.raises(WorldError) as caught:
        load_world(tmp_path / "top.world")

    error = caught.value
    assert (Path(error.file).name, error.code, error.line, error.column) == ("part.inc", code, line, column)
    assert code is not Code.MISPLACED or error.details == {"found": "define"}
