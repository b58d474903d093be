"""A recording holds a world with all files that it reads. The world loads from there unchanged."""

import json
import math
from pathlib import Path

import pytest

import worlds
from donnie_tui.core.recording import Header
from donnie_tui.i18n.words import Words
from donnie_tui.outlets.files import bundle_of
from donnie_tui.settings.settings import Settings
from donnie_tui.world import recorded
from donnie_tui.world.loading import inhabited_world
from donnie_tui.world.recorded import BundleError, WorldBundle, from_record, pack, unpack, unpacked

ROBOT = "position( pose [ 0 0 0 90 ] ranger( sensor() ) )\n"


def again(name: str, folders: tuple[str, ...] = ()) -> bool:
    """Whether the models of a world are the same after a journey through JSON."""
    world = inhabited_world(name, Words(), folders)
    record = json.loads(json.dumps(bundle_of(world, Settings(world_folders=folders)).as_record()))
    with unpacked(Header("0", 0, "sim", {}, record), Words()) as there:
        return there.scene.models == world.scene.models and there.scene.robots == world.scene.robots


@pytest.mark.parametrize("name", worlds.names())
def test_every_shipped_world_comes_out_equal(name: str) -> None:
    assert again(name)


def test_a_user_world_comes_out_equal_with_its_includes_from_everywhere(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "lib" / "deep").mkdir(parents=True)
    (tmp_path / "own" / "sub").mkdir(parents=True)
    (tmp_path / "lib" / "deep" / "a.inc").write_text('include "b.inc"\n')
    (tmp_path / "lib" / "deep" / "b.inc").write_text("define box model ( size [ 0.2 0.2 0.2 ] )\n")
    (tmp_path / "own" / "sub" / "c.inc").write_text('include "deep/a.inc"\ninclude "donnie.inc"\n')
    (tmp_path / "own" / "x.world").write_text(
        f'include "sub/c.inc"\nbox( pose [ 0 1 0 0 ] )\ndonnie( pose [ 1 1 0 0 ] )\n{ROBOT}'
    )
    monkeypatch.chdir(tmp_path / "own")

    assert again("x.world", (str(tmp_path / "lib"),))
    assert again(str(tmp_path / "own" / "x.world"), (str(tmp_path), str(tmp_path / "lib")))


def test_a_world_may_lie_above_the_folders_that_it_includes_from(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "lib").mkdir()
    (tmp_path / "lib" / "a.inc").write_text("define box model ( size [ 0.2 0.2 0.2 ] )\n")
    (tmp_path / "x.world").write_text(f'include "a.inc"\nbox( pose [ 0 1 0 0 ] )\n{ROBOT}')
    monkeypatch.chdir(tmp_path)

    assert again("x.world", (str(tmp_path / "lib"),))


def test_a_binary_file_is_kept_byte_by_byte(tmp_path: Path) -> None:
    data = bytes(range(256))
    (tmp_path / "x.world").write_bytes(data)
    bundle = pack("x", tmp_path / "x.world", (), (), ("donnie",))

    there = from_record(json.loads(json.dumps(bundle.as_record())))
    main, _ = unpack(there, tmp_path / "out")

    assert main.read_bytes() == data


@pytest.mark.parametrize(
    "record",
    [
        {},
        [],
        {"name": "x", "main": "0/x", "robots": [], "files": [{"name": "0/x", "base64": "!"}]},
        {"name": "x", "main": "0/x", "robots": [], "files": [{"name": "0/x"}]},
        {"name": 1, "main": "0/x", "robots": [], "files": []},
        {"name": "x", "main": "0/x", "robots": [1], "files": []},
        {"name": "x", "main": "0/x", "robots": [], "files": [["0/x", "text"]]},
        {"name": "x", "main": "0/x", "robots": [], "files": [], "moves": [[0, 0.0, math.inf, 0.0, 0.0]]},
    ],
    ids=range(8),
)
def test_a_value_that_is_no_bundle_is_refused(record: object) -> None:
    with pytest.raises(BundleError) as refused:
        from_record(record)
    assert refused.value.code == "bundle-damaged"


@pytest.mark.parametrize(
    "name",
    ["x.world", "a/x.world", "0/../x.world", "/0/x.world", "0/a\\b", "0/c:x", "0/a\0", f"0/{'x' * 999}"],
)
def test_a_bundle_with_a_name_that_leads_elsewhere_is_refused(name: str, tmp_path: Path) -> None:
    with pytest.raises(BundleError) as refused:
        unpack(WorldBundle("x", name, ((name, b""),), ("donnie",)), tmp_path)

    assert refused.value.code == "bundle-damaged"
    assert list(tmp_path.iterdir()) == []


def test_a_bundle_beyond_its_limit_is_refused_by_its_reader_and_its_writer(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(recorded, "LARGEST", 20)
    file = tmp_path / "x.world"
    file.write_text("x" * 21)
    two = [{"name": f"0/{each}", "text": "x" * 11} for each in "ab"]

    with pytest.raises(BundleError) as read:
        from_record({"name": "x", "main": "0/a", "robots": [], "files": two})
    with pytest.raises(BundleError) as written:
        pack("x", file, (str(file),), [tmp_path], ["donnie"])
    assert read.value.code == written.value.code == "bundle-too-large"


def test_a_bundle_without_its_world_is_refused_and_nothing_is_written(tmp_path: Path) -> None:
    bundle = WorldBundle("x", "0/x.world", (("0/y.world", b""),), ("donnie",))

    with pytest.raises(BundleError):
        unpack(bundle, tmp_path)
    assert list(tmp_path.iterdir()) == []
