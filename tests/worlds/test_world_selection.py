"""A world is chosen by its name, its file or a configuration file. It includes from allowed folders only."""

from pathlib import Path

import pytest

import worlds
from devices.ports.robot import Pose
from donnie_tui.i18n.words import Unusable, Words
from donnie_tui.world.loading import choose_world

WORDS = Words("en", "normal")
WORLD = 'define bob position ( ranger ( sensor ( ) ) ) bob ( name "ann" ) bob ( name "bea" pose [ 2 0 0 0 ] )'


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "w.world").write_text(WORLD, encoding="utf-8")
    return tmp_path


def test_a_configuration_file_chooses_the_world_and_the_first_robot(folder: Path) -> None:
    offer = 'driver ( name "stage" provides [ "position2d:0" ] model "bea" )'
    (folder / "w.cfg").write_text('driver ( name "stage" worldfile "w.world" )' + offer, encoding="utf-8")

    chosen = choose_world(str(folder / "w.cfg"), WORDS)

    assert (chosen.name, chosen.path, chosen.ships) == ("w.world", str(folder / "w.world"), False)
    assert chosen.start().x == 40
    assert [each.model for each in chosen.offers] == ["bea"]
    assert chosen.physical_port is None


def test_a_configuration_of_a_real_robot_has_an_empty_floor(folder: Path) -> None:
    (folder / "real.cfg").write_text('driver ( name "donnie" port "/dev/ttyACM0" )', encoding="utf-8")

    chosen = choose_world(str(folder / "real.cfg"), WORDS)

    assert chosen.physical_port == "/dev/ttyACM0"
    assert chosen.path == worlds.path("open_floor")
    assert chosen.scene.robots


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        ("", "Error, {file}, line 1, column 1: This file names no worldfile and no real robot."),
        (
            'driver ( name "stage" worldfile "no.world" )',
            "Error, {file}, line 1, column 33: There is no file no.world.",
        ),
        (
            'driver ( name "stage" model "ann" provides [ "ranger" ] )',
            "Error, {file}, line 1, column 1: This file names no worldfile and no real robot.",
        ),
    ],
)
def test_a_mistake_in_a_configuration_is_a_sentence_with_its_place(
    folder: Path, text: str, sentence: str
) -> None:
    file = folder / "w.cfg"
    file.write_text(text, encoding="utf-8")

    with pytest.raises(Unusable) as problem:
        choose_world(str(file), WORDS)
    assert str(problem.value) == sentence.format(file=file)


def test_a_world_includes_only_from_the_allowed_folders(tmp_path: Path) -> None:
    (tmp_path / "lib").mkdir()
    (tmp_path / "mine").mkdir()
    (tmp_path / "lib" / "bob.inc").write_text(WORLD, encoding="utf-8")
    file = tmp_path / "mine" / "w.world"
    for include in ("bob.inc", "../lib/bob.inc"):
        file.write_text(f'include "{include}"', encoding="utf-8")

        with pytest.raises(Unusable):
            choose_world(str(file), WORDS)
        assert len(choose_world(str(file), WORDS, (str(tmp_path / "lib"),)).scene.robots) == 2


@pytest.mark.parametrize(
    ("robot", "start"),
    [
        ("", Pose(0.0, 0.0, 0.0)),
        ("position ( pose [ 1 -0.5 0 0 ] )", Pose(20.0, -10.0, 90.0)),
    ],
)
def test_a_world_says_where_its_first_robot_starts(tmp_path: Path, robot: str, start: Pose) -> None:
    world = tmp_path / "some.world"
    world.write_text(f"model ( size [ 1 1 1 ] pose [ 3 3 0 0 ] )\n{robot}\n")

    assert choose_world(str(world), Words("en")).start() == start
