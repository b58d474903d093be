"""The shipped compiled scenes equal the world files. A scene is used only while its files are unchanged."""

import pickle
import shutil
import subprocess
import sys
from pathlib import Path
from zlib import crc32

import msgspec
import pytest
from msgspec import Struct

import worlds
from sim import compiled_scene
from sim.compiled_scene import compile_scene, path_of, read_scene
from sim.worldfile import load_world
from tests.conftest import ROOT
from tests.timeouts import TIMEOUT
from tests.tools.compile_scenes import parsed

RECOMPILE = "python -m tests.tools.compile_scenes compiles them again"


@pytest.fixture
def copied(tmp_path: Path) -> Path:
    """A copy of the folder of scenarios."""
    return Path(shutil.copytree(worlds.SCENES, tmp_path / "scenes"))


@pytest.mark.parametrize("name", worlds.names())
def test_a_shipped_scene_equals_its_world_file(name: str) -> None:
    assert read_scene(worlds.path(name)) == parsed(name), RECOMPILE


def test_a_scene_names_the_current_paths_of_its_files(copied: Path) -> None:
    scene = read_scene(str(copied / "cave.world"))

    assert scene is not None
    assert scene.report.files[0] == str(copied / "cave.world")
    assert scene.report.pictures == (str(copied / "bitmaps" / "cave.png"),)


@pytest.mark.parametrize("changed", ["cave.world", "donnie.inc", "bitmaps/cave.png"])
def test_a_scene_is_not_used_after_one_of_its_files_changed(copied: Path, changed: str) -> None:
    with (copied / changed).open("ab") as file:
        file.write(b"\n")

    assert read_scene(str(copied / "cave.world")) is None


def test_a_scene_is_not_used_after_one_of_its_files_disappeared(copied: Path) -> None:
    (copied / "donnie.inc").unlink()

    assert read_scene(str(copied / "cave.world")) is None


def test_a_world_without_a_scene_has_none(copied: Path) -> None:
    (copied / "cave.scene").unlink()

    assert read_scene(str(copied / "cave.world")) is None


def test_a_scene_of_another_version_of_the_classes_is_not_used(
    copied: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    class OtherScene(Struct, frozen=True):
        name: str
        models: tuple[int, ...]

    class OtherCompiledScene(Struct, frozen=True):
        sources: tuple[tuple[str, int], ...]
        scene: OtherScene

    monkeypatch.setattr(compiled_scene, "_CompiledScene", OtherCompiledScene)

    assert read_scene(str(copied / "cave.world")) is None


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
        assert read_scene(str(copied / "cave.world")) is None


@pytest.mark.parametrize(
    "content", [7, [[], []], {"sources": [], "scene": {}}, {"sources": [["x", 0]]}, {"scene": None}]
)
def test_an_intact_file_without_a_scene_is_not_used(copied: Path, content: object) -> None:
    """A file of another version may look like this."""
    encoded = msgspec.msgpack.encode(content)
    (copied / "cave.scene").write_bytes(crc32(encoded).to_bytes(4) + encoded)

    assert read_scene(str(copied / "cave.world")) is None


def test_a_remark_without_a_file_is_stored_without_a_file(tmp_path: Path) -> None:
    world = tmp_path / "hall.world"
    world.write_text('model(name "hall" boundary 1 obstacle_return 0 gui_nose 0)')
    scene = load_world(world)

    Path(path_of(str(world))).write_bytes(compile_scene(str(world), scene))

    assert "" in {note.file for note in scene.report.notes}
    assert read_scene(str(world)) == scene


def test_a_shipped_world_loads_without_the_parser() -> None:
    code = (
        "import sys\n"
        "from donnie_tui.i18n.words import Words\n"
        "from donnie_tui.world.loading import choose_world\n"
        "choose_world('living_room', Words())\n"
        "print('lark' in sys.modules, 'PIL' in sys.modules)"
    )

    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, cwd=ROOT, timeout=TIMEOUT
    )

    assert done.stdout == "False False\n", done.stderr
