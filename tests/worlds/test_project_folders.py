"""A world includes files of its project, of the current folder, and of folders that are allowed."""

import shlex
from pathlib import Path

import pytest

from donnie_tui.cli.main import main
from donnie_tui.i18n.words import Unusable, Words
from donnie_tui.world.loading import choose_world
from donnie_tui.world.recorded import pack, unpack
from sim.worldfile import Code, WorldError, load_configuration, load_world

ROBOT = "position ( sensor ( samples 1 ) )\n"


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A world that includes a file by ``../..``; there is no sign of a project around it."""
    monkeypatch.chdir(tmp_path)
    inner = tmp_path / "site" / "worlds" / "benchmark"
    inner.mkdir(parents=True)
    (tmp_path / "site" / "chair.inc").write_text("define chair model ( size [ 0.5 0.5 1 ] )\n")
    (inner / "room.world").write_text(f'include "../../chair.inc"\n{ROBOT}chair ( )\n')
    (inner / "room.cfg").write_text(
        'driver ( name "stage" plugin "stageplugin" provides [ "simulation:0" ] worldfile "room.world" )\n'
    )
    elsewhere = tmp_path / "elsewhere"
    elsewhere.mkdir()
    monkeypatch.chdir(elsewhere)
    return tmp_path / "site"


def world(folder: Path) -> Path:
    return folder / "worlds" / "benchmark" / "room.world"


def models(path: Path, *allowed: Path) -> list[str]:
    return [each.kind for each in load_world(path, allowed=allowed).models]


def refusal(path: Path) -> WorldError:
    with pytest.raises(WorldError) as caught:
        load_world(path)
    return caught.value


def test_without_a_project_only_the_folder_of_the_world_is_read(folder: Path) -> None:
    refused = refusal(world(folder))

    assert (refused.code, refused.line, refused.column) == (Code.INCLUDE_OUTSIDE, 1, 9)
    assert refused.details["folder"] == str(folder)


@pytest.mark.parametrize("marker", [".git", ".hg", ".svn", ".bzr"])
def test_a_world_reads_all_files_of_its_repository(folder: Path, marker: str) -> None:
    (folder / marker).mkdir()

    assert "chair" in models(world(folder))


BUILD_FILES = "CMakeLists.txt Makefile package.xml manifest.xml stack.xml pyproject.toml setup.py"
TEXTS = "README README.txt README.md README.rst LICENSE LICENSE.txt LICENSE.md COPYING"


def test_a_world_reads_all_files_of_its_project(folder: Path) -> None:
    for marker in (*BUILD_FILES.split(), *TEXTS.split()):
        (folder / marker).touch()
        assert "chair" in models(world(folder)), marker
        (folder / marker).unlink()
    assert refusal(world(folder)).code is Code.INCLUDE_OUTSIDE


def test_folders_of_a_project_have_build_files_too(folder: Path) -> None:
    for each in (folder, folder / "worlds", folder / "worlds" / "benchmark"):
        (each / "CMakeLists.txt").touch()

    assert "chair" in models(world(folder))


def test_a_project_ends_where_its_files_end(folder: Path) -> None:
    (folder / "worlds" / "README").touch()
    (folder.parent / "README").touch()

    assert refusal(world(folder)).code is Code.INCLUDE_OUTSIDE


def test_the_nearest_repository_is_the_limit(folder: Path) -> None:
    (folder / ".git").mkdir()
    (folder / "worlds" / ".git").mkdir()

    assert refusal(world(folder)).code is Code.INCLUDE_OUTSIDE


def test_a_link_does_not_lead_out_of_the_repository(folder: Path) -> None:
    (folder / "worlds" / ".git").mkdir()
    (folder / "worlds" / "linked.inc").symlink_to(folder / "chair.inc")
    world(folder).write_text('include "../linked.inc"\nchair ( )\n')

    assert refusal(world(folder)).code is Code.INCLUDE_OUTSIDE


def test_a_world_below_the_current_folder_reads_from_there(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(folder)

    assert "chair" in models(Path("worlds/benchmark/room.world"))


def test_the_root_of_the_file_system_allows_nothing(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir("/")

    assert refusal(world(folder)).code is Code.INCLUDE_OUTSIDE


def test_a_configuration_and_its_world_have_the_same_limit(folder: Path) -> None:
    configuration = world(folder).with_suffix(".cfg")
    with pytest.raises(WorldError) as caught:
        load_configuration(configuration)
    assert caught.value.code is Code.INCLUDE_OUTSIDE

    (folder / ".git").mkdir()

    assert load_configuration(configuration).scene


def test_pictures_have_the_same_limit(folder: Path) -> None:
    (folder / "plan.pgm").write_text("P2 3 1 255 0 255 0")
    world(folder).write_text('model ( bitmap "../../plan.pgm" )\n')
    refused = refusal(world(folder))
    assert (refused.code, refused.details["folder"]) == (Code.BITMAP_OUTSIDE, str(folder))

    (folder / ".git").mkdir()

    assert len(load_world(world(folder)).models[0].polygons) == 2


@pytest.mark.parametrize(
    "before",
    [("world",), ("world", "--report"), ("run", "my program.gd", "--world"), ("--linear", "--world")],
)
def test_a_refusal_says_the_command_that_allows_the_folder(
    folder: Path, before: tuple[str, ...], capsys: pytest.CaptureFixture[str]
) -> None:
    """It repeats what was typed, and works where it is copied."""
    Path("my program.gd").write_text("SPEAK 1")
    code = main([*before, str(world(folder)), "--speech", "off"])
    mistake, remedy = capsys.readouterr().err.splitlines()

    assert code == 2
    assert f"{world(folder)}, line 1" in mistake or f"{world(folder)}:1:9" in mistake
    assert mistake.endswith("../../chair.inc is outside the project of the world.")
    name, *typed = shlex.split(remedy.removeprefix("To allow its folder: "))
    assert [name, *typed] == [
        "donnie",
        *before,
        str(world(folder)),
        "--speech",
        "off",
        "--allow",
        str(folder),
    ]
    if "--linear" not in before:
        assert main(typed) == 0


def test_a_refusal_within_a_session_says_the_command_that_begins_in_that_world(folder: Path) -> None:
    with pytest.raises(Unusable) as refused:
        choose_world(str(world(folder)), Words("pt"))

    assert refused.value.sentences[1:] == (
        f"Para permitir a pasta: donnie --world {world(folder)} --allow {folder}",
    )


@pytest.mark.parametrize("separator", ["=", " "])
def test_allow_may_be_given_several_times(
    folder: Path, separator: str, capsys: pytest.CaptureFixture[str]
) -> None:
    other = folder.parent / "elsewhere"
    options = f"--allow{separator}{folder} --allow{separator}{other}".split(" ")

    assert main(["world", str(world(folder)), *options]) == 0
    assert "chair" in capsys.readouterr().out


def test_a_recording_has_the_files_of_the_project(folder: Path, tmp_path: Path) -> None:
    (folder / ".git").mkdir()
    scene = load_world(world(folder))
    bundle = pack("room", world(folder), scene.report.files, (), scene.robot_names)
    assert {name for name, _ in bundle.files} == {"0/chair.inc", "0/worlds/benchmark/room.world"}

    place = tmp_path / "unpacked"
    place.mkdir()
    main_file, allowed = unpack(bundle, place)

    assert models(main_file, *allowed) == models(world(folder))


@pytest.mark.parametrize("name", ["/home/ana/stage/chair.inc", "../../lost/chair.inc", "chair.inc"])
def test_an_allowed_folder_has_a_file_by_its_bare_name(tmp_path: Path, name: str) -> None:
    """Stage looks so in the folders of STAGEPATH: others keep their files elsewhere."""
    (tmp_path / "mine").mkdir()
    (tmp_path / "theirs").mkdir()
    (tmp_path / "theirs" / "chair.inc").write_text("define chair model ( )")
    (tmp_path / "mine" / "room.world").write_text(f'include "{name}"\nchair ( )')

    scene = load_world(tmp_path / "mine" / "room.world", allowed=(tmp_path / "theirs",))
    assert [each.kind for each in scene.models] == ["chair"]
    with pytest.raises(WorldError):
        load_world(tmp_path / "mine" / "room.world")


def test_a_file_outside_is_refused_though_a_folder_without_it_is_allowed(tmp_path: Path) -> None:
    (tmp_path / "mine").mkdir()
    (tmp_path / "theirs").mkdir()
    (tmp_path / "mine" / "room.world").write_text('include "/home/ana/stage/chair.inc"')
    with pytest.raises(WorldError) as caught:
        load_world(tmp_path / "mine" / "room.world", allowed=(tmp_path / "theirs",))

    assert caught.value.code is Code.INCLUDE_OUTSIDE
