"""A recording holds a world with all files that it reads. The world loads from there unchanged."""

import errno
import json
import math
import os
from collections.abc import Callable
from pathlib import Path

import pytest
from msgspec import structs

import worlds
from devices.ports.robot import Bearing
from donnie_tui.core.recording import Header
from donnie_tui.i18n.words import Unusable, Words
from donnie_tui.outlets.files import bundle_of
from donnie_tui.process.confinement import Confinement, confine
from donnie_tui.settings.settings import Settings
from donnie_tui.world import recorded
from donnie_tui.world.loading import inhabited_world
from donnie_tui.world.recorded import (
    BundleError,
    WorldBundle,
    from_record,
    pack,
    settings_of,
    unpack,
    unpacked,
)

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
    [
        "0",
        "x.world",
        "a/x.world",
        "1000/x.world",
        "0/../x.world",
        "/0/x.world",
        "0/a\\b",
        "0/c:x",
        "0/a\0",
        f"0/{'x' * 999}",
    ],
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


# --- what a bundle holds, and what its errors say


def failed(attempt: Callable[[], object]) -> tuple[str, dict[str, object]]:
    with pytest.raises(BundleError) as refused:
        attempt()
    return refused.value.code, refused.value.values


def test_a_bundle_as_json_has_texts_as_they_are_and_all_else_in_base64() -> None:
    files = ("0/x.world", "olá".encode()), ("1/p.png", b"\xff\x00")
    bundle = WorldBundle("x", "0/x.world", files, ("donnie", "bob"), ((3, 1.0, 2.0, 0.0, 90.0),))
    record: dict[str, object] = {
        "name": "x",
        "main": "0/x.world",
        "robots": ["donnie", "bob"],
        "files": [{"name": "0/x.world", "text": "olá"}, {"name": "1/p.png", "base64": "/wA="}],
    }

    assert bundle.as_record() == {**record, "moves": [[3, 1.0, 2.0, 0.0, 90.0]]}
    assert structs.replace(bundle, moves=()).as_record() == record
    assert from_record(bundle.as_record()) == bundle
    assert from_record(record) == structs.replace(bundle, moves=())


def test_the_folder_of_the_world_is_the_last_to_include_from(tmp_path: Path) -> None:
    names = ("10/d.inc", "0/x.world", "2/c.inc", "1/b/b.inc", "0/a.inc")
    bundle = WorldBundle("x", "0/x.world", tuple((each, each.encode()) for each in names), ("donnie",))

    main, folders = unpack(bundle, tmp_path)

    assert (main, folders) == (
        tmp_path / "0/x.world",
        tuple(tmp_path / each for each in ("1", "2", "10", "0")),
    )
    assert {each: (tmp_path / each).read_text() for each in names} == {each: each for each in names}


def test_a_name_of_a_thousand_letters_is_unpacked(tmp_path: Path) -> None:
    name = "/".join(("0", *("a" * 249,) * 3, "a" * 248))
    main, _ = unpack(WorldBundle("x", name, ((name, b"x"),), ("donnie",)), tmp_path)

    assert (len(name), main.read_bytes()) == (1000, b"x")


def test_what_fails_is_named(tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    no_folder, none = os.strerror(errno.ENOTDIR), os.strerror(errno.ENOENT)
    bundle = WorldBundle("x", "0/x", (("0/x", b""),), ("donnie",))
    other = structs.replace(bundle, main=f"0/{'y' * 90}")
    missing = tmp_path / "none.world"

    assert failed(lambda: unpack(bundle, tmp_path / "file")) == ("bundle-unwritable", {"reason": no_folder})
    assert failed(lambda: unpack(other, tmp_path)) == ("bundle-incomplete", {"name": f"0/{'y' * 78}"})
    assert failed(lambda: pack("x", missing, (), (), ())) == (
        *("file-unreadable", {"path": str(missing), "reason": none}),
    )


@pytest.mark.parametrize("more", [0, 1])
def test_all_files_together_have_the_limit_at_most(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, more: int
) -> None:
    monkeypatch.setattr(recorded, "LARGEST", 3 * 1024**2)
    files = [tmp_path / "x.world", tmp_path / "y.inc"]
    for each, size in zip(files, (1024**2, 2 * 1024**2 + more), strict=True):
        each.write_bytes(b"x" * size)
    record = {
        "name": "x",
        "main": "0/x.world",
        "robots": [],
        "files": [{"name": f"0/{each.name}", "text": each.read_text()} for each in files],
    }

    def packed() -> WorldBundle:
        return pack("x", files[0], [str(each) for each in files], [], [])

    if more:
        assert failed(packed) == failed(lambda: from_record(record)) == ("bundle-too-large", {"limit": 3})
    else:
        assert packed() == from_record(record)


def test_files_have_their_names_in_the_folders_that_contain_them(tmp_path: Path) -> None:
    """The first folder is above all files of the project, but for those that are included from elsewhere."""
    paths = {
        name: tmp_path / name
        for name in ("own/world/x.world", "own/parts/a.inc", "lib/b.inc", "lib/deep/c.inc")
    }
    for name, path in paths.items():
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(name)
    main, *others = paths.values()

    def names(*folders: str) -> list[str]:
        there = [tmp_path / each for each in folders]
        bundle = pack("x", main, [str(each) for each in (main, *others)], there, ["bob"])
        assert (bundle.name, bundle.robots, bundle.moves) == ("x", ("bob",), ())
        assert bundle.main == bundle.files[0][0]
        for packed, data in bundle.files:
            assert data.decode().endswith(packed.split("/")[-1])
        return [name for name, _ in bundle.files]

    assert names("lib") == ["0/world/x.world", "0/parts/a.inc", "1/b.inc", "1/deep/c.inc"]
    assert names("lib/deep", "lib") == [
        "0/world/x.world",
        "0/parts/a.inc",
        "2/b.inc",
        "1/c.inc",
        "2/deep/c.inc",
    ]
    assert names() == ["0/own/world/x.world", "0/own/parts/a.inc", "0/lib/b.inc", "0/lib/deep/c.inc"]


def test_half_a_sign_in_a_text_of_a_recording_stays_as_it_is() -> None:
    files = [{"name": "0/x", "text": "\ud800"}]

    assert from_record({"name": "x", "main": "0/x", "robots": [], "files": files}).files == (
        ("0/x", b"\xed\xa0\x80"),
    )


BELT: dict[str, object] = {"steps": [3, 6, 12], "columns": {"0": [3, 4], "45": [5]}}


def test_a_recording_has_its_own_seed_and_belt_and_is_repeated_without_a_pace() -> None:
    settings = settings_of(Header("0", 7, "sim", BELT, {}), Settings(seed=1, speed=2.0), Words())

    assert (settings.seed, settings.speed, settings.belt_steps) == (7, None, (3, 6, 12))
    assert settings.belt_columns == {Bearing.FRONT: (3, 4), Bearing.FRONT_RIGHT: (5,)}


@pytest.mark.parametrize(
    "change",
    [
        {"steps": [3, 6]},
        {"steps": [3, 6, 12, 24]},
        {"steps": "abc"},
        {"steps": [3, 6, True]},
        {"steps": [3, 6, 12.0]},
        {"columns": []},
        {"columns": {"1": [3]}},
        {"columns": {"front": [3]}},
        {"columns": {"0": "34"}},
        {"columns": {"0": ["3"]}},
    ],
)
def test_a_damaged_belt_of_a_recording_is_reported(change: dict[str, object]) -> None:
    for belt in ({**BELT, **change}, {key: value for key, value in BELT.items() if key not in change}):
        with pytest.raises(Unusable) as refused:
            settings_of(Header("0", 7, "sim", belt, {}), Settings(), Words())
        assert str(refused.value) == Words()("bundle-damaged")


@pytest.mark.parametrize("is_there", [False, True])
def test_a_confined_session_unpacks_a_recording_in_its_own_folder(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, is_there: bool
) -> None:
    monkeypatch.chdir(tmp_path)  # as a confined session does
    world = 'position( name "bob" )\n'
    bundle = WorldBundle("x", "0/x.world", (("0/x.world", world.encode()),), ("bob",))
    own_folder = tmp_path / ".donnie"
    if is_there:
        own_folder.mkdir()
    confine(Confinement(str(tmp_path)))
    try:
        with unpacked(Header("0", 0, "sim", {}, bundle.as_record()), Words()) as there:
            assert Path(there.path).is_relative_to(own_folder)
            assert Path(there.path).read_text() == world
    finally:
        confine(None)
    assert list(own_folder.iterdir()) == []


def test_only_the_robots_that_were_offered_are_offered_again(tmp_path: Path) -> None:
    world = "".join(
        f'position( name "{name}" pose [ {x} 0 0 90 ] ranger( sensor() ) )\n'
        for x, name in enumerate(("alice", "bob"))
    )
    bundle = WorldBundle("x", "0/x.world", (("0/x.world", world.encode()),), ("bob",))

    def header(bundle: WorldBundle) -> Header:
        return Header("0", 0, "sim", {}, bundle.as_record())

    with unpacked(header(bundle), Words()) as there:
        (bob,) = there.scene.robots
        assert (there.scene.models[bob].spoken_name, there.name, there.ships) == ("bob", "x", False)
        assert Path(there.path).exists()
    assert not Path(there.path).exists()
    with unpacked(header(structs.replace(bundle, name="maze")), Words()) as ours:
        assert ours.ships
    with unpacked(header(structs.replace(bundle, moves=((bob, 4.0, 5.0, 0.0, 0.0),))), Words()) as moved:
        pose = moved.scene.models[bob].pose
        assert (pose.x, pose.y) == (4.0, 5.0)
    with (
        pytest.raises(Unusable) as refused,
        unpacked(header(structs.replace(bundle, robots=("c",))), Words()),
    ):
        pass
    assert str(refused.value) == Words()("world-without-robot", name="x")
