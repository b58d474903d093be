"""No output overwrites an input."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from donnie_tui.cli.main import main
from tests.sessions.command import QUIET, donnie

pytestmark = pytest.mark.slow

WORDS = 'difficulty = "easy"\n[en]\ntitle = "My own"\ndescription = "All of it."\ntask = "Find it."\n'
WORLD = 'include "donnie.inc"\ninclude "own.inc"\ndonnie( pose [ 0 0 0 90 ] )\n'


@pytest.fixture(autouse=True)
def _here(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path / "config"))
    monkeypatch.setenv("DONNIE_LANG", "en")
    monkeypatch.chdir(tmp_path)
    Path("a.gd").write_text("FW 1\n")
    Path("z.world").write_text(WORLD)
    Path("own.inc").write_text("# mine\n")
    Path("z.toml").write_text(WORDS)
    Path("link.gd").symlink_to("a.gd")


@pytest.mark.parametrize(
    "line",
    [
        "run a.gd --record a.gd",
        "run a.gd --record ./a.gd",
        "run a.gd --record link.gd",
        "run donnie=a.gd --events a.gd",
        "-f a.gd --record a.gd",
        "--linear a.gd --record a.gd",
        "--linear new.gd --record new.gd",
        "run a.gd --world z.world --record z.world",
        "run a.gd --world z.world --events own.inc",
        "run a.gd --sound wav:a.gd",
        "replay a.gd --events a.gd",
        "world z.world --svg z.world",
        "world z.world --brf own.inc",
        "run a.gd --world z.world --record z.toml",
        "--linear --record config/donnie/settings.toml",
        "--linear --events config/donnie/settings.toml",
    ],
)
def test_an_input_file_is_not_overwritten(line: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main([*line.split(), "--speech", "off"]) == 2, line

    out, err = capsys.readouterr()
    assert (out, err.count("\n")) == ("", 1)
    assert "would overwrite" in err
    assert Path("a.gd").read_text() == "FW 1\n"
    assert Path("z.world").read_text() == WORLD
    assert Path("own.inc").read_text() == "# mine\n"
    assert Path("z.toml").read_text() == WORDS
    assert not Path("new.gd").exists()
    assert not Path("config/donnie/settings.toml").exists()


@pytest.mark.parametrize(
    "line",
    [
        "run a.gd --record mine.gd",
        "run a.gd --events MINE",
        "run a.gd --sound wav:mine.gd",
        "run a.gd --record my.world",
        "run a.gd --events b.rec",
        "run a.gd --record b.jsonl",
        "--linear --record mine.gd",
        "--linear --events mine.gd",
        "replay b.rec --events mine.gd",
        "world corridor --svg mine.gd",
        "world corridor --brf mine.gd",
        "world corridor --brf MINE",
        "world corridor --svg my.world",
    ],
)
def test_a_file_of_another_kind_is_not_replaced(line: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["run", "a.gd", "--record", "b.rec", "--events", "b.jsonl", *QUIET]) == 0
    for name in ("mine.gd", "MINE", "my.world"):
        Path(name).write_text("FW 3\nTR 90\n")
    kept = {each: each.read_bytes() for each in Path().iterdir() if each.is_file()}
    capsys.readouterr()

    assert main([*line.split(), "--speech", "off"]) == 2, line
    assert "which is another kind of file. Give another name." in capsys.readouterr().err
    assert {each: each.read_bytes() for each in kept} == kept


def test_an_option_may_replace_its_earlier_output() -> None:
    Path("empty.rec").touch()
    run = [
        "run",
        "a.gd",
        "--record",
        "b.rec",
        "--events",
        "b.jsonl",
        "--speech",
        "off",
        "--sound",
        "wav:b.wav",
    ]
    svg, brf = (["world", "corridor", f"--{each}", f"b.{each}"] for each in ("svg", "brf"))

    assert [main(each) for each in (run, run, svg, svg, brf, brf)] == [0] * 6
    assert main(["run", "a.gd", "--record", "empty.rec", *QUIET]) == 0


@pytest.mark.parametrize(
    ("line", "name", "content"),
    [
        ("world corridor --svg {}", "drawing.svg", b"<?xml version='1.0'?>\n<svg width='5'/>\n"),
        ("world corridor --svg {}", "icon.svg", b"<svg xmlns='http://www.w3.org/2000/svg'/>\n"),
        ("world corridor --brf {}", "book.brf", b"ONCE UPON A TIME\r\n\f"),
        (
            "run a.gd --sound wav:{}",
            "song.wav",
            b"RIFF$\0\0\0WAVEfmt \x10\0\0\0\x01\0\x02\0D\xac\0\0" + bytes(40),
        ),
        (
            "run a.gd --sound wav:{}",
            "voice.wav",
            b"RIFF$\0\0\0WAVEfmt \x10\0\0\0\x01\0\x01\0\x22V\0\0" + bytes(40),
        ),
    ],
)
def test_a_file_of_the_same_kind_that_donnie_did_not_write_is_not_replaced(
    line: str, name: str, content: bytes, capsys: pytest.CaptureFixture[str]
) -> None:
    Path(name).write_bytes(content)

    assert main([*line.format(name).split(), "--speech", "off"]) == 2
    assert "which is another kind of file. Give another name." in capsys.readouterr().err
    assert Path(name).read_bytes() == content


@pytest.mark.parametrize("language", ["en", "pt", "es"])
def test_a_page_in_braille_is_replaced_in_every_language(language: str) -> None:
    write = ["world", "corridor", "--brf", "b.brf", "--lang", language]

    assert (main(write), main(["world", "maze", "--brf", "b.brf"])) == (0, 0)


NOTES = "teacher's own notes\n"
CHECK = ["challenge", "check", "first_walk"]


@pytest.fixture
def answers() -> Path:
    """A folder with an answer that Donnie wrote, and the programs of two pupils in another."""
    for name, text in {"one": "FW 5\n", "two": "FW 4\n"}.items():
        Path("progs").mkdir(exist_ok=True)
        Path("progs", f"{name}.gd").write_text(text)
    assert main([*CHECK, "progs/one.gd", "--feedback", "fb"]) == 0
    return Path("fb")


@pytest.mark.parametrize(
    "notes", [NOTES, "Challenge: mine.\n", "Solved, in 1 command. Well done!\n", "Donnie\n"]
)
def test_an_answer_replaces_no_file_of_the_teacher(
    answers: Path, notes: str, capsys: pytest.CaptureFixture[str]
) -> None:
    """The other answer is not written either, and no table."""
    (answers / "two.txt").write_text(notes)
    (answers / "one.txt").unlink()
    capsys.readouterr()

    assert main([*CHECK, "progs", "--feedback", "fb", "--csv", "t.csv"]) == 2

    said = "--feedback would overwrite fb/two.txt, which is another kind of file. Give another name.\n"
    assert capsys.readouterr() == ("", said)
    assert [each.name for each in answers.iterdir()] == ["two.txt"]
    assert (answers / "two.txt").read_text() == notes
    assert not Path("t.csv").exists()


def test_an_answer_replaces_no_folder(answers: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (answers / "two.txt").mkdir()
    kept = (answers / "one.txt").read_text()
    capsys.readouterr()

    assert main([*CHECK, "progs", "--feedback", "fb", "--lang", "es"]) == 2

    out, err = capsys.readouterr()
    assert (out, err.count("\n"), "fb/two.txt" in err) == ("", 1, True)
    assert (answers / "one.txt").read_text() == kept


@pytest.mark.parametrize("language", ["en", "pt", "es"])
def test_an_answer_replaces_one_of_any_language(answers: Path, language: str) -> None:
    first = (answers / "one.txt").read_text()
    Path("progs", "one.gd").write_bytes(b"\0")  # no text: its answer has another sentence
    (answers / "two.txt").touch()

    assert main([*CHECK, "progs", "--feedback", "fb", "--lang", language]) == 2
    unread = (answers / "one.txt").read_text()
    Path("progs", "one.gd").write_text("FW 5\n")
    assert main([*CHECK, "progs", "--feedback", "fb"]) == 1

    assert unread != first == (answers / "one.txt").read_text()


def test_an_answer_replaces_no_program(capsys: pytest.CaptureFixture[str]) -> None:
    Path("ana.txt").touch()

    assert main([*CHECK, "ana.txt", "--feedback", "."]) == 2

    said = "--feedback would overwrite ana.txt, which is read here. Give another name.\n"
    assert capsys.readouterr() == ("", said)
    assert Path("ana.txt").read_bytes() == b""


def test_no_table_is_an_answer_or_a_program(answers: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (answers / "one.txt").unlink()
    Path("empty.gd").touch()
    capsys.readouterr()

    assert main([*CHECK, "progs", "--csv", "fb/one.txt", "--feedback", "fb"]) == 2
    said = "--csv and --feedback can't both write fb/one.txt. Give two names.\n"
    assert capsys.readouterr() == ("", said)
    assert main([*CHECK, "empty.gd", "--csv", "./empty.gd"]) == 2
    assert capsys.readouterr() == ("", "./empty.gd is one of the programs.\n")
    assert list(answers.iterdir()) == []


def test_each_answer_has_a_file_of_its_own(answers: Path) -> None:
    """Also where the number of one makes the name of another."""
    for folder, name in (("a", "one"), ("b", "one"), ("c", "one-2")):
        Path(folder).mkdir()
        Path(folder, f"{name}.gd").write_text("FW 5\n")

    assert main([*CHECK, "a/one.gd", "b/one.gd", "c/one-2.gd", "--feedback", "new"]) == 0

    assert len(list(Path("new").iterdir())) == 3


def test_two_outputs_are_two_files(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["run", "a.gd", "--record", "b", "--events", "./b", *QUIET]) == 2

    assert capsys.readouterr().err == "--record and --events can't both write b. Give two names.\n"
    assert not Path("b").exists()


def test_a_device_may_take_two_outputs() -> None:
    assert main(["run", "a.gd", "--record", "/dev/null", "--events", "/dev/null", *QUIET]) == 0


def test_a_recording_in_a_user_world_may_be_repeated() -> None:
    command = ["run", "a.gd", "--world", "z.world", "--record", "a.rec", *QUIET]

    assert (main(command), main(command)) == (0, 0)


@pytest.mark.parametrize("word", ["SAVE AS", "SAVE LOG", "REPORT MAP"])
@pytest.mark.parametrize("name", ["b.rec", "z.world", "own.inc", "z.toml", "b.jsonl"])
def test_no_word_of_a_session_overwrites_a_file_that_the_session_needs(
    word: str, name: str, tmp_path: Path
) -> None:
    outputs = ("--record", "b.rec", "--events", "b.jsonl")
    typed = f"FW 1\n\n{word} {name}\nFW 2\n\nSAVE AS c.gd\n"

    done = donnie(tmp_path, "--linear", "--world", "z.world", *outputs, *QUIET, "--speed", "max", typed=typed)

    assert f"{name} is in use here. Give another name." in done.stdout.decode()
    assert Path("z.world").read_text() == WORLD
    assert Path("own.inc").read_text() == "# mine\n"
    assert main(["replay", "b.rec", "--check", *QUIET]) == 0
    assert Path("b.jsonl").read_text().count("run_ended") == 2
    assert Path("c.gd").exists()


@pytest.mark.parametrize("word", ["SAVE LOG", "REPORT LIST"])
def test_no_page_replaces_an_open_program(word: str, tmp_path: Path) -> None:
    typed = f"{word} a.gd\n{word} ./link.gd\nROBOT bob\n{word} a.gd\n"

    done = donnie(tmp_path, "--linear", "a.gd", "--world", "two_robots", *QUIET, typed=typed)

    said = done.stdout.decode()
    assert said.count("a.gd is an open program. Give another name.") == 2
    assert "link.gd is an open program. Give another name." in said
    assert Path("a.gd").read_text() == "FW 1\n"


@pytest.mark.parametrize("words", ["SAVE AS mine.gd", "SAVE LOG mine.gd", "REPORT LIST mine.txt"])
def test_lines_of_a_file_replace_no_file_because_no_question_is_possible(words: str, tmp_path: Path) -> None:
    mine = words.split()[-1]
    Path(mine).write_text("BW 1\n")

    done = donnie(tmp_path, "--linear", "a.gd", *QUIET, typed=f"{words}\nREPORT MAP mine.html\n")

    assert f"{mine} exists already. Give another name." in done.stdout.decode()
    assert Path(mine).read_text() == "BW 1\n"
    assert Path("mine.html").exists()


def test_the_words_of_a_world_are_part_of_a_recording(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["run", "a.gd", "--world", "z.world", "--record", "a.rec", *QUIET]) == 0

    header = json.loads(Path("a.rec").read_text().splitlines()[0])
    assert {"name": "0/z.toml", "text": WORDS} in header["world"]["files"]
    Path("z.toml").unlink()
    assert main(["replay", "a.rec", "--check", *QUIET]) == 0
