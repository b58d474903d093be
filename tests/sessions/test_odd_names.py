"""Names that no file can have, and links that lead to themselves: one sentence, and no session ends."""

from __future__ import annotations

from pathlib import Path

import pytest

from donnie_tui.cli.main import main
from tests.sessions.command import QUIET, donnie

LOOPS = ("loop", "loop.world", "loop.inc", "loop.png", "loop.cfg")
WALL = 'model ( name "wall" size [ 1 1 1 ] )\n'


def make_loops(folder: Path) -> None:
    """Links to themselves, with a program and a world."""
    for name in LOOPS:
        (folder / name).symlink_to(name)
    (folder / "a.gd").write_text("FW 1\n")
    (folder / "wall.world").write_text(WALL)


@pytest.fixture
def looping(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path / "config"))
    folder = tmp_path / "work"
    folder.mkdir()
    make_loops(folder)
    monkeypatch.chdir(folder)
    return folder


@pytest.mark.parametrize(
    ("command", "sentence"),
    [
        ("world loop.world", "I can't read loop.world: its link leads back to itself."),
        ("world loop/x.world", "I can't read loop/x.world: its link leads back to itself."),
        ("run a.gd --world loop.world", "I can't read loop.world: its link leads back to itself."),
        ("--linear --world loop.world", "I can't read loop.world: its link leads back to itself."),
        ("player loop.world", "I can't read loop.world: its link leads back to itself."),
        ("player loop.cfg", "I can't read loop.cfg: its link leads back to itself."),
        ("world new loop.world", "I can't write loop.world: its link leads back to itself."),
        ("world maze --svg loop", "I can't write loop: its link leads back to itself."),
        ("challenge check first_walk loop", "I can't read loop: its link leads back to itself."),
        (
            "challenge check first_walk a.gd --csv loop",
            "I can't write loop: its link leads back to itself.",
        ),
    ],
)
def test_a_link_to_itself_is_one_sentence(
    looping: Path, capsys: pytest.CaptureFixture[str], command: str, sentence: str
) -> None:
    assert main(command.split()) == 2
    out, err = capsys.readouterr()
    assert sentence in (out + err).splitlines()
    assert sorted(each.name for each in looping.iterdir() if each.is_symlink()) == sorted(LOOPS)


def test_a_link_to_itself_allows_no_more_than_a_folder_that_is_not_there(
    looping: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    printed = []
    for folder in ("loop", "none"):
        code = main(["world", "wall.world", "--allow", folder])
        printed.append((code, *capsys.readouterr()))

    assert printed[0] == printed[1]
    assert printed[0][0] == 0


def _driver(world: str) -> str:
    return f'driver ( name "stage" provides [ "simulation:0" ] worldfile "{world}" )'


@pytest.mark.parametrize(
    ("file", "text", "sentence"),
    [
        ("top.world", 'include "loop.inc"', "I can't read loop.inc: its link leads back to itself."),
        ("top.world", 'include "loop/x.inc"', "I can't read loop/x.inc: its link leads back to itself."),
        ("top.world", 'include "a\0b.inc"', "There is no file a b.inc."),
        ("top.world", 'model ( bitmap "loop.png" )', "I can't read loop.png: its link leads back to itself."),
        (
            "top.world",
            'model ( bitmap "loop/x.png" )',
            "I can't read loop/x.png: its link leads back to itself.",
        ),
        ("top.world", 'model ( bitmap "a\0b.png" )', "There is no picture a b.png."),
        ("top.cfg", _driver("loop.world"), "I can't read loop.world: its link leads back to itself."),
        ("top.cfg", _driver("loop/x.world"), "I can't read loop/x.world: its link leads back to itself."),
        ("top.cfg", _driver("a\0b.world"), "There is no file a b.world."),
    ],
)
def test_a_world_may_name_them(
    looping: Path, capsys: pytest.CaptureFixture[str], file: str, text: str, sentence: str
) -> None:
    (looping / file).write_text(text)

    assert main(["world", file]) == 2
    out, err = capsys.readouterr()
    assert (out + err).replace(f"{looping}/", "").endswith(f"{sentence}\n")


@pytest.mark.slow
def test_none_of_them_ends_a_session(tmp_path: Path) -> None:
    make_loops(tmp_path)
    typed = {
        "WORLD loop.world": "I can't read loop.world: its link leads back to itself.",
        "WORLDS loop.world": "I can't read loop.world: its link leads back to itself.",
        "SAVE WORLD loop.world": "I can't write loop.world: its link leads back to itself.",
        "WORLD a\0b.world": "There is no file a b.world.",
        "WORLDS a\0b": "There is no world a b. WORLDS lists them.",
        "SAVE WORLD a\0b": "World saved as a b.world. WORLD a b.world goes there.",
        "OPEN a\0b.gd": "I can't read a b.gd: it is not understood.",
        "FW 1\n": "I walked 1 step forward.",
        "SAVE AS c\0d": "Saved c d.gd, 1 line.",
        "REPORT map e\0f": "Wrote e f.html.",
    }

    done = donnie(tmp_path, "--linear", *QUIET, "--speed", "max", typed="\n".join((*typed, "")))

    assert done.stderr == b""
    lines = [each for each in done.stdout.decode().splitlines() if not each.startswith("Loading the world ")]
    assert lines[2:] == [*typed.values(), "Goodbye."]
    assert done.returncode == 2
    assert {"a b.world", "c d.gd", "e f.html"} < {each.name for each in tmp_path.iterdir()}
    assert (tmp_path / "loop.world").is_symlink()


# --- a working folder that was removed


@pytest.fixture
def removed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The folder above the working folder, which is gone; with a program and a world."""
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path / "config"))
    (tmp_path / "a.gd").write_text("FW 1\n")
    (tmp_path / "wall.world").write_text(WALL)
    gone = tmp_path / "gone"
    gone.mkdir()
    monkeypatch.chdir(gone)
    gone.rmdir()
    return tmp_path


@pytest.mark.parametrize(
    ("command", "code", "sentence"),
    [
        ("run {above}/a.gd", 0, "I walked 1 step forward."),
        ("run {above}/a.gd --world {above}/wall.world", 0, "I walked 1 step forward."),
        ("run {above}/a.gd --world wall.world", 2, "There is no file wall.world."),
        ("run {above}/a.gd --record r", 2, "I can't write r: there is no such folder."),
        ("run {above}/a.gd --confined {above}", 0, "I walked 1 step forward."),
        ("run {above}/a.gd --confined .", 2, "There is no folder .: make it first."),
        ("check a.gd", 2, "There is no file a.gd."),
        ("challenge check first_walk {above}/a.gd --csv c", 2, "I can't write c: there is no such folder."),
        ("world new x.world", 2, "I can't write x.world: there is no such folder."),
        ("player x.cfg", 2, "There is no file x.cfg."),
    ],
)
def test_a_working_folder_that_was_removed_is_one_sentence(
    removed: Path, capsys: pytest.CaptureFixture[str], command: str, code: int, sentence: str
) -> None:
    assert main(command.format(above=removed).split()) == code
    out, err = capsys.readouterr()
    assert sentence in (out + err).splitlines()
