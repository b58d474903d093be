"""``donnie world NAME`` as a map, a braille page, a picture: of our worlds and of very large ones."""

import os
import re
from pathlib import Path
from xml.etree import ElementTree

import pytest

import worlds.words
from donnie_tui.cli.main import main
from tests.conftest import ROOT

pytestmark = pytest.mark.slow

CROWD = """
define sonar sensor ( range [ 0 3 ] )
define bot position ( size [ 0.1 0.1 0.1 ] ranger( sonar( ) ) )
define crate model ( size [ 0.15 0.15 0.15 ] color "blue" )
"""


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path / "config"))
    monkeypatch.setenv("DONNIE_LANG", "en")
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.fixture
def crowd(folder: Path) -> str:
    """A world of 1000 robots and 1000 other things."""
    places = [(0.5 * (each % 40), 0.5 * (each // 40)) for each in range(1000)]
    robots = [f'bot( name "r{each}" pose [ {x} {y} 0 90 ] )' for each, (x, y) in enumerate(places)]
    crates = [f"crate( pose [ {x + 0.25} {y + 0.25} 0 0 ] )" for x, y in places]
    (folder / "crowd.world").write_text(CROWD + "\n".join((*robots, *crates)))
    return "crowd.world"


@pytest.mark.parametrize("name", worlds.names())
def test_the_map_of_every_world_fits_eighty_columns(name: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["world", name, "--map"]) == 0

    lines = capsys.readouterr().out.splitlines()
    rows = lines[: lines.index("")]
    assert max(map(len, lines)) <= 80
    assert len(set(map(len, rows))) == 1
    robots = sum(row.count(arrow) for row in rows for arrow in "^>v<")
    assert robots == {"two_robots": 2, "bigbob_yaws": 4, "empty": 0, "helloworld": 0}.get(name, 1)


def test_a_line_below_the_map_gives_the_steps_of_a_letter(capsys: pytest.CaptureFixture[str]) -> None:
    main(["world", "factory", "--map"])

    lines = capsys.readouterr().out.splitlines()
    assert lines[lines.index("") + 1] == "Each letter is 4 by 4 steps."


@pytest.mark.parametrize("name", worlds.names())
def test_below_the_map_every_letter_of_it_is_explained(name: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["world", name, "--map"]) == 0

    lines = capsys.readouterr().out.splitlines()
    blank = lines.index("")
    general = ("Each letter", "There is no robot")
    legend = [line for line in lines[blank + 1 :] if not line.startswith(general)]
    explained = [letter for line in legend for letter in line.partition(" is ")[0].split(" ")]
    explained += sorted({each for line in legend for each in re.findall(r"[:,] ([A-Z]) ", line)})
    letters = set("".join(lines[:blank]))
    assert letters <= set(explained)
    assert set(explained) <= letters | set("^>v<")
    assert len(explained) == len(set(explained))


def test_the_legend_of_a_map_says_what_things_are_in_every_language(
    capsys: pytest.CaptureFixture[str],
) -> None:
    main(["world", "living_room", "--map", "--lang", "es"])
    lines = capsys.readouterr().out.splitlines()

    assert lines[lines.index("") + 1 :][:3] == ["# es pared.", ". es suelo libre.", "^ > v < es donnie."]
    assert "c es silla: verde." in lines


def test_the_legend_of_a_map_gives_the_colours_in_reading_order(capsys: pytest.CaptureFixture[str]) -> None:
    main(["world", "object_field", "--map"])
    lines = capsys.readouterr().out.splitlines()

    assert "b is ball: Y yellow, R red." in lines
    assert "c is cone: G green, O orange." in lines
    assert "x is box: L blue, P pink." in lines


def test_the_legend_of_a_crowd_is_short(crowd: str, capsys: pytest.CaptureFixture[str]) -> None:
    main(["world", crowd, "--map"])
    lines = capsys.readouterr().out.splitlines()

    assert "^ > v < is r0, r1, r2, r3, …." in lines
    assert len(lines) - lines.index("") < 8


def test_no_text_of_a_world_file_reaches_the_terminal_as_a_command(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    evil = "\x1b[31m\x9b2J\x07\u202e"
    (folder / "evil.world").write_text(
        f'include "donnie.inc"\n'
        f"define box model ( size [ 0.2 0.2 0.2 ] )\n"
        f'box( name "b{evil}" pose [ 1 0 0 0 ] color "re{evil}d" )\n'
        f'model( name "<b>&{evil}" pose [ 1 1 0 0 ] )\n'
        f'donnie( name "d{evil}" pose [ 0 0 0 90 ] )\ndonnie( name "e{evil}" pose [ -1 0 0 90 ] )\n',
        encoding="utf-8",
    )
    (folder / "a.gd").write_text("FW 1")
    said = ""
    for more in ((), ("--map",), ("--report",), ("--json",), ("--svg", "e.svg"), ("--brf", "e.brf")):
        assert main(["world", "evil.world", *more]) == 0
        out, err = capsys.readouterr()
        said += out + err
    assert main(["run", "nobody=a.gd", "--world", "evil.world", "--speech", "off", "--sound", "off"]) == 2
    said += "".join(capsys.readouterr())

    assert all(each == "\n" or each.isprintable() for each in said)
    written = (folder / "e.svg").read_text(encoding="utf-8")
    assert all(each == "\n" or each.isprintable() for each in written)
    assert "&lt;b&gt;&amp;" in written
    ElementTree.fromstring(written)
    assert (folder / "e.brf").read_bytes().translate(None, b"\r\n\f").decode("ascii").isprintable()


def test_a_braille_page_is_written_as_embossers_want_it(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["world", "corridor", "--brf", "page.brf"]) == 0

    assert capsys.readouterr().out == "I wrote page.brf.\n"
    written = (folder / "page.brf").read_bytes()
    assert written.isascii()
    assert written.startswith(b"MAP OF CORRIDOR\r\nA CELL IS #")
    assert written.endswith(b"\r\n\f")


def test_a_picture_is_written_and_replaces_the_one_that_was_there(folder: Path) -> None:
    assert main(["world", "corridor", "--svg", "a.svg"]) == 0

    assert main(["world", "cave", "--svg", "a.svg", "--lang", "pt"]) == 0
    root = ElementTree.parse(folder / "a.svg").getroot()
    assert root.findtext("{http://www.w3.org/2000/svg}title") == "Mapa de Caverna"


def test_a_world_of_a_thousand_robots_is_described_in_few_lines(
    crowd: str, folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["world", crowd]) == 0

    lines = capsys.readouterr().out.splitlines()
    assert len(lines) < 40
    assert lines[1].startswith("1000 robots: r0, ")
    assert "1000 things, in steps from r0, the nearest first." in lines
    assert lines[-1] == "980 of them: crate, blue."


def test_a_world_of_a_thousand_robots_fits_on_paper(crowd: str, folder: Path) -> None:
    assert main(["world", crowd, "--brf", "a.brf"]) == 0
    assert main(["world", crowd, "--svg", "a.svg"]) == 0

    assert (folder / "a.brf").read_text().count("\f") <= 2
    assert ElementTree.parse(folder / "a.svg").getroot().get("role") == "img"


@pytest.mark.parametrize("form", ["--svg", "--brf"])
def test_a_pipe_is_reported_and_left_unchanged(
    form: str, folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    os.mkfifo(folder / "pipe")

    assert main(["world", "open_floor", form, "pipe"]) == 2

    assert capsys.readouterr().err == "pipe is not an ordinary file.\n"
    assert (folder / "pipe").is_fifo()


def test_every_world_has_its_place_in_the_documents() -> None:
    scenarios = (ROOT / "docs" / "scenarios.md").read_text(encoding="utf-8")
    manual = (ROOT / "docs" / "manual-worlds.md").read_text(encoding="utf-8")

    for name in worlds.names():
        if name in worlds.scenarios():
            level = worlds.words.about(name, "en").difficulty.value
            assert f"\n## {name}, {level}\n" in scenarios
        else:
            assert f": `{name}`\n" in manual


def test_every_file_next_to_the_worlds_is_used_by_one_of_them() -> None:
    for folder in map(Path, (worlds.SCENES, worlds.MANUAL)):
        files = [*folder.glob("*.world"), *folder.glob("*.inc")]
        text = "\n".join(file.read_text(encoding="utf-8") for file in files)
        for file in (*folder.glob("*.inc"), *folder.glob("bitmaps/*")):
            assert f'"{file.relative_to(folder).as_posix()}"' in text
        for file in folder.glob("*.cfg"):
            (named,) = re.findall(r'worldfile "(.*)"', file.read_text(encoding="utf-8"))
            assert (folder / named).is_file()


@pytest.mark.parametrize(("option", "name"), [("--svg", "a.svg"), ("--brf", "a.brf")])
def test_a_page_called_minus_is_written_to_standard_output(
    option: str, name: str, folder: Path, capfdbinary: pytest.CaptureFixture[bytes]
) -> None:
    assert main(["world", "living_room", option, name]) == 0
    capfdbinary.readouterr()

    assert main(["world", "living_room", option, "-"]) == 0

    assert capfdbinary.readouterr() == ((folder / name).read_bytes(), b"")
    assert not (folder / "-").exists()
