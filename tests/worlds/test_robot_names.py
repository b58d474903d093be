"""Every robot of a world has a unique name that can be spoken and typed."""

from pathlib import Path
from typing import Literal
from unicodedata import normalize

import pytest

from donnie_tui.bootstrap import make_team
from donnie_tui.cli.main import main
from donnie_tui.i18n.words import Words
from donnie_tui.settings.settings import Settings
from donnie_tui.world.loading import ChosenWorld
from sim.picture import picture
from sim.scene import Note, NoteKind, Scene
from sim.worldfile import load, load_text

SENSOR = "ranger( sensor( range [ 0 2 ] fov 20 ) )"
ROBOT = "position( {name} size [ 0.1 0.1 0.2 ] {more} pose [ {x} 0 0 90 ] " + SENSOR + " )\n"


def scene(*names: str, more: str = "") -> Scene:
    text = "".join(ROBOT.format(name=name, x=i, more=more) for i, name in enumerate(names))
    return load_text(text, Path("foreign.world"))


def test_robots_without_a_name_are_numbered() -> None:
    assert scene("", "").robot_names == ("robot1", "robot2")


def test_a_robot_without_a_name_is_called_by_its_kind() -> None:
    text = "define pioneer " + ROBOT.format(name="", x=0, more="") + "pioneer( pose [ 1 0 0 0 ] )"

    assert load_text(text, Path("foreign.world")).robot_names == ("pioneer1",)


def test_the_second_robot_of_a_name_gets_another_name() -> None:
    assert scene('name "bob"', 'name "bob"', 'name "bob2"').robot_names == ("bob", "bob3", "bob2")


def test_names_that_differ_only_in_case_or_accents_become_different_names() -> None:
    assert scene('name "zé"', 'name "ZE"').robot_names == ("zé", "ZE2")


def test_a_name_that_can_not_be_typed_is_replaced() -> None:
    assert scene('name "a=b"', 'name "c:0"', 'name "  "').robot_names == ("robot1", "robot2", "robot3")


@pytest.mark.parametrize("name", ["a=b", "a:b", "a\\b", " a", "a ", "", "  ", "a\u200bb"])
def test_a_name_with_signs_of_commands_or_blanks_around_it_is_replaced(name: str) -> None:
    it = scene(f'name "{name}"', 'name "a b"')

    assert it.robot_names == ("robot1", "a b")
    assert it.models[0].name == name
    (note,) = it.report.notes
    assert (note.kind.value, note.code) == ("repaired", "robot-without-name")
    assert note.details == {"name": name, "alias": "robot1"}


def test_a_robot_keeps_its_name_before_what_is_none_and_only_robots_are_reported() -> None:
    blind = 'position( name "bob" pose [ 9 9 0 0 ] )\n'
    text = blind + "".join(ROBOT.format(name='name "bob"', x=at, more="") for at in range(2)) + blind
    it = load_text(text, Path("foreign.world"))
    wheeled = [model for model in it.models if model.type == "position"]

    assert [model.spoken_name for model in wheeled] == ["bob3", "bob", "bob2", "bob4"]
    assert [note.details["alias"] for note in it.report.notes if note.code == "robot-renamed"] == ["bob2"]


def test_a_part_of_a_robot_keeps_its_name() -> None:
    it = load_text('position( name "bob" ranger( ) position( name "bob" ) )', Path("f.world"))

    assert [model.alias for model in it.models] == ["", "", ""]
    assert it.robot_names == ("bob",)


def test_a_long_name_is_repeated_up_to_sixty_letters() -> None:
    long = "b" * 70
    (note,) = scene(f'name "{long}"', f'name "{long}"').report.notes

    assert (note.code, note.details) == ("robot-renamed", {"name": "b" * 60, "alias": f"{long}2"})


def test_robots_are_in_the_order_of_the_file_those_that_see_first() -> None:
    def bot(name: str, x: int, *senses: str) -> str:
        parts = " ".join(f"{each}( )" for each in senses)
        return f'position( name "{name}" pose [ {x} 0 0 0 ] {parts} )\n'

    text = bot("a", 0) + bot("b", 1, "bumper") + bot("c", 2, "blobfinder", "bumper") + bot("d", 3, "ranger")
    seeing = load_text(text + "model( pose [ 9 0 0 0 ] ranger( ) )", Path("f.world"))
    blind = load_text(bot("a", 0) + "position( pose [ 9 0 0 0 ] position( ) )", Path("f.world"))

    assert seeing.robot_names == ("c", "d", "b")
    assert blind.robot_names == ("a", "robot1")
    assert seeing.report.loaded[0] == ("position", 4)
    for sense in ("fiducial", "camera", "gripper"):
        assert load_text(bot("a", 0) + bot("b", 1, sense), Path("f.world")).robot_names == ("b",)


def test_numbering_many_robots_of_one_name_takes_linear_time(monkeypatch: pytest.MonkeyPatch) -> None:
    looked_at: list[str] = []

    def normalized(form: Literal["NFKD"], text: str) -> str:
        looked_at.append(text)
        return normalize(form, text)

    monkeypatch.setattr(load, "normalize", normalized)
    assert scene(*['name "r"'] * 300).robot_names[-1] == "r300"
    assert len(looked_at) <= 4 * 300


def test_each_robot_is_found_by_its_name() -> None:
    world = scene('name "bob"', 'name "bob"')

    assert [world.robot(name).index for name in world.robot_names] == list(world.robots)
    assert world.robot("bob2").name == "bob", "Stage's own name stays"


def test_every_robot_can_be_talked_to_and_is_on_the_map_by_its_name() -> None:
    world = ChosenWorld("foreign.world", "foreign.world", scene("", "", 'name "r"', 'name "r"'), False)
    team = make_team(Settings(), Words(), world, terminal=False)

    assert team.names == ("robot1", "robot2", "r", "r2")
    assert [team.session(name).name for name in team.names] == list(team.names)
    assert [each.name for each in picture(world.scene, "robot1").things] == ["robot2", "r", "r2"]


def test_the_place_of_a_robot_is_its_pose_and_not_the_middle_of_its_shape() -> None:
    world = scene('name "a"', 'name "b"', more="origin [ 0.2 0 0 0 ]")

    (other,) = picture(world, "a").things
    assert (other.x, other.y) == (20.0, 0.0)


def test_the_report_lists_the_names_and_how_to_run_one(tmp_path: Path, capsys) -> None:  # type: ignore[no-untyped-def]
    file = tmp_path / "foreign.world"
    file.write_text("".join(ROBOT.format(name=name, x=i, more="") for i, name in enumerate(("", 'name "r"'))))

    assert main(["world", str(file), "--report", "--lang", "en"]) == 0

    said = capsys.readouterr().out
    assert "2 robots: robot1, r. The command donnie run robot1=FILE runs the first." in said
    assert "Repaired: A robot without a usable name is called robot1." in said


def test_a_place_names_the_robot_that_it_is_counted_from(tmp_path: Path, capsys) -> None:  # type: ignore[no-untyped-def]
    file = tmp_path / "foreign.world"
    thing = 'model( name "puck" size [ 0.1 0.1 0.1 ] pose [ 0.5 0.5 0 0 ] )'
    file.write_text(
        "".join(ROBOT.format(name=f'name "{name}"', x=1 + i, more="") for i, name in enumerate("ab")) + thing
    )

    assert main(["world", str(file), "--lang", "en"]) == 0

    assert capsys.readouterr().out.splitlines()[1:] == [
        "2 robots: a, b.",
        "The robot a starts at 20, 0, facing north.",
        "Robot b, from a: 20 east, facing north.",
        "1 thing, in steps from a, the nearest first.",
        "Puck, red: 10 west, 10 north.",
    ]


# --- robots that start inside something

INSIDE = "position( name {} size [ 0.2 0.2 0.2 ] pose [ 5 -3 0 {} ] ranger( sensor( ) ) )\n"


@pytest.mark.parametrize(("right", "up"), [(x, y) for x in (-1, 0, 1) for y in (-1, 0, 1)])
@pytest.mark.parametrize(("away", "is_inside"), [(0.14, True), (0.16, False)])
def test_a_robot_that_overlaps_a_thing_is_reported_on_every_side(
    right: int, up: int, away: float, is_inside: bool
) -> None:
    """Their halves are 10 and 5 cm."""
    thing = f'model( name "crate" size [ 0.1 0.1 0.1 ] pose [ {5 + right * away} {-3 + up * away} 0 0 ] )'
    it = load_text(INSIDE.format('"bob"', 0) + thing, Path("f.world"))

    note = Note(NoteKind.WARNING, "starts-inside", "", 0, 0, {"name": "bob", "thing": "crate"})
    assert it.report.notes == ((note,) if is_inside or not (right or up) else ())


def test_two_robots_in_each_other_are_reported_once_and_each_thing_once() -> None:
    bots = INSIDE.format('"a"', 0) + INSIDE.format('"b"', 45)
    parts = 'model( name "pile" pose [ 5 -3 0 0 ] model( ) model( ) )\n'
    parts += "model( size [ 1 1 1 ] obstacle_return 0 pose [ 5 -3 0 0 ] )"
    notes = load_text(bots + parts, Path("f.world")).report.notes

    assert [(note.details["name"], note.details["thing"]) for note in notes] == [
        *(("a", "b"), ("a", "pile"), ("b", "pile")),
    ]


@pytest.mark.parametrize(
    ("kind", "name", "called"),
    [
        ("model", "", "model"),
        ("model", "crate", "crate"),
        ("box", "", "box"),
        ("box", "red box", "red box"),
        ("box", "treasure", "box treasure"),
        ("box", "b" * 70, f"box {'b' * 56}"),
    ],
)
def test_what_a_robot_starts_in_is_called_by_its_kind_and_its_name(kind: str, name: str, called: str) -> None:
    named = f'name "{name}"' if name else ""
    text = f"define box model( ) {kind}( {named} pose [ 5 -3 0 0 ] )"
    (note,) = load_text(INSIDE.format('"bob"', 0) + text, Path("f.world")).report.notes

    assert note.details["thing"] == called
