"""The scenes beside the worlds are those of the world files, and are used only as long as they fit."""

import marshal
import pickle
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

import worlds
from donnie_tui.make_scenes import parsed
from sim import ready
from sim.placement import Placement
from sim.worldfile import load_world
from tests.conftest import ROOT

REMADE = "python -m donnie_tui.make_scenes makes them anew"


@pytest.fixture
def copied(tmp_path: Path) -> Path:
    """Our folder of scenarios, where it may be changed."""
    return Path(shutil.copytree(worlds.SCENES, tmp_path / "scenes"))


@pytest.mark.parametrize("name", worlds.names())
def test_the_scene_that_ships_is_the_one_of_the_world_file(name: str) -> None:
    assert ready.read(worlds.path(name)) == parsed(name), REMADE


def test_a_scene_names_its_files_where_they_are_now(copied: Path) -> None:
    scene = ready.read(str(copied / "cave.world"))

    assert scene is not None
    assert scene.report.files[0] == str(copied / "cave.world")
    assert scene.report.pictures == (str(copied / "bitmaps" / "cave.png"),)


@pytest.mark.parametrize("changed", ["cave.world", "donnie.inc", "bitmaps/cave.png"])
def test_once_any_of_its_files_changed_a_scene_is_not_used(copied: Path, changed: str) -> None:
    with (copied / changed).open("ab") as file:
        file.write(b"\n")

    assert ready.read(str(copied / "cave.world")) is None


def test_once_one_of_its_files_is_gone_a_scene_is_not_used(copied: Path) -> None:
    (copied / "donnie.inc").unlink()

    assert ready.read(str(copied / "cave.world")) is None


def test_a_world_without_a_scene_has_none(copied: Path) -> None:
    (copied / "cave.scene").unlink()

    assert ready.read(str(copied / "cave.world")) is None


def test_a_scene_made_with_other_classes_is_not_used(copied: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(ready._KINDS, "Polygon", Placement)
    assert ready.read(str(copied / "cave.world")) is None

    monkeypatch.delitem(ready._KINDS, "Polygon")
    assert ready.read(str(copied / "cave.world")) is None


def test_a_damaged_or_a_foreign_scene_is_not_used(copied: Path) -> None:
    file = copied / "cave.scene"
    whole = file.read_bytes()
    damaged = [whole[:at] + bytes([whole[at] ^ 4]) + whole[at + 1 :] for at in range(0, len(whole), 997)]
    foreign = [
        pickle.dumps(((), "scene")),
        b"",
        b"\0" * 9,
        whole[:500],
        whole + b"\0",
        whole[:4] + b"\0" + whole[4:],
    ]

    for content in damaged + foreign:
        file.write_bytes(content)
        assert ready.read(str(copied / "cave.world")) is None


def test_what_is_whole_but_no_scene_is_not_used(copied: Path) -> None:
    """As one of another version may be, which kept its scenes in another way."""
    for content in (
        7,
        ((), (), ()),
        ((), (), ((0, [], ()),)),
        ((), (("Scene", ()),), ()),
        ((("x", 0),), (), ()),
    ):
        kept = marshal.dumps(content, 2)
        (copied / "cave.scene").write_bytes(ready._sum(kept).to_bytes(4) + kept)
        assert ready.read(str(copied / "cave.world")) is None


def test_a_remark_without_a_file_keeps_none(tmp_path: Path) -> None:
    world = tmp_path / "hall.world"
    world.write_text('model(name "hall" boundary 1 obstacle_return 0 gui_nose 0)')
    scene = load_world(world)

    Path(ready.beside(str(world))).write_bytes(ready.made(str(world), scene))

    assert "" in {note.file for note in scene.report.notes}
    assert ready.read(str(world)) == scene


def test_a_world_that_ships_is_chosen_without_the_parser() -> None:
    code = (
        "import sys\n"
        "from donnie_tui.i18n.words import Words\n"
        "from donnie_tui.world.choice import choose_world\n"
        "choose_world('living_room', Words())\n"
        "print('lark' in sys.modules, 'PIL' in sys.modules)"
    )

    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, cwd=ROOT, timeout=60)

    assert done.stdout == "False False\n", done.stderr
