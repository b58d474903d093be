"""The other commands: what they print, where, and with which exit code."""

from __future__ import annotations

import io
import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

import worlds.words
from donnie_tui.cli import programs
from donnie_tui.cli.main import main
from donnie_tui.core.program_files import DocumentError
from donnie_tui.i18n.words import Words
from tests.conftest import ROOT
from tests.environment import of_a_process
from tests.sessions.command import QUIET, donnie
from tests.timeouts import TIMEOUT


class Printed:
    """Runs a command line in this process and keeps what it printed."""

    def __init__(self, capsys: pytest.CaptureFixture[str]) -> None:
        self._capsys = capsys
        self.out = self.err = ""

    def by(self, *arguments: str) -> int:
        code = main(list(arguments))
        self.out, self.err = self._capsys.readouterr()
        return code


@pytest.fixture
def printed(capsys: pytest.CaptureFixture[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Printed:
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path / "config"))
    monkeypatch.chdir(tmp_path)
    return Printed(capsys)


def write(name: str, text: str) -> None:
    Path(name).write_text(text, encoding="utf-8")


def test_a_challenge_that_can_not_be_written_leaves_nothing(tmp_path: Path) -> None:
    """A folder that stays would keep its name from the next try."""
    command = f"ulimit -f 0; exec {sys.executable} -B -m donnie_tui challenge new lap"
    done = subprocess.run(
        ["sh", "-c", command],
        cwd=tmp_path,
        env=of_a_process(tmp_path),
        capture_output=True,
        timeout=TIMEOUT,
    )

    assert (done.returncode, done.stderr.decode()) == (
        2,
        "I can't write lap/lap.toml: the file would be too large.\n",
    )
    assert list(tmp_path.iterdir()) == []


def test_a_challenge_that_can_not_be_written_takes_no_other_file_with_it(
    printed: Printed, monkeypatch: pytest.MonkeyPatch
) -> None:
    def write_and_fail(path: Path, text: str) -> None:
        (path.parent / "of another.txt").write_text("kept")
        raise DocumentError("file-unwritable", str(path), "disk full")

    monkeypatch.setattr(programs, "write_program", write_and_fail)

    assert printed.by("challenge", "new", "lap") == 2
    assert Path("lap/of another.txt").read_text() == "kept"


# --- serve


@pytest.mark.parametrize("port", ["none", "0", "70000", "-1", "1" * 50])
def test_an_invalid_port_is_one_sentence(printed: Printed, port: str) -> None:
    assert printed.by("serve", f"--port={port}") == 2
    assert "is not a port" in printed.err
    assert printed.err.count("\n") == 1


# --- check


def test_check_prints_one_line_for_every_mistake(printed: Printed) -> None:
    write("a.gd", "FWD 3\nREPEAT 2\nFW 1\nEND REPEAT\n")

    assert printed.by("check", "a.gd") == 1
    assert printed.out.splitlines() == [
        "a.gd:1:1: unknown-command: I do not know FWD. Did you mean FW?",
        "a.gd:3:1: syntax: I expected TIMES, not FW. TIMES belongs at the end of line 2.",
    ]


@pytest.mark.parametrize(
    ("wrong_lines", "said"),
    [(99, ""), *((number, "Only the first 100 mistakes are listed.\n") for number in (100, 120))],
)
def test_check_says_that_only_the_first_mistakes_are_listed(
    printed: Printed, wrong_lines: int, said: str
) -> None:
    write("a.gd", "JUMP\n" * wrong_lines)

    assert printed.by("check", "a.gd") == 1
    assert len(printed.out.splitlines()) == min(wrong_lines, 100)
    assert printed.err == said


def test_check_prints_hints_which_are_no_failure(printed: Printed) -> None:
    write("a.gd", "DISTANCE F")

    assert printed.by("check", "a.gd") == 0
    assert printed.out == "a.gd:1:1: hint: DISTANCE alone does nothing. Did you mean SPEAK DISTANCE F?\n"


def test_check_prints_nothing_about_a_program_without_mistakes_but_says_so(printed: Printed) -> None:
    write("a.gd", "FW 1 SPEAK COLOR yellow")

    assert printed.by("check", "a.gd", "--lang", "pt") == 0
    assert (printed.out, printed.err) == ("", "a.gd: sem erros.\n")


def test_check_of_a_folder_checks_the_programs_in_it(printed: Printed, tmp_path: Path) -> None:
    (tmp_path / "class" / "more.gd").mkdir(parents=True)
    assert printed.by("check", "class") == 2
    assert printed.out == "There are no programs in class. The name of a program ends in .gd.\n"
    for name, text in (("bob.gd", "FWD 1"), ("ana.GD", "FW 1"), ("notes.txt", "FWD 2")):
        (tmp_path / "class" / name).write_text(text)
    place = Path("class")

    assert printed.by("check", "class") == 1
    assert printed.err == ""
    ana, bob, totals = printed.out.splitlines()
    assert ana == f"{place / 'ana.GD'}: no mistakes."
    assert bob.startswith(f"{place / 'bob.gd'}:1:1: ")
    assert totals == "2 programs. 1 with mistakes, 1 without."


def test_check_of_one_program_says_no_totals_and_of_hints_no_more_than_they_are(printed: Printed) -> None:
    write("a.gd", "DISTANCE F\n" * 120)
    assert printed.by("check", "a.gd") == 0
    assert printed.err == ""
    assert "programs." not in printed.out
    assert printed.by("check", "a.gd", "a.gd") == 0
    write("b.gd", "FW 1")
    assert printed.by("check", "b.gd", "a.gd") == 0
    assert printed.out.splitlines()[0] == "b.gd: no mistakes."
    assert printed.out.splitlines()[-1] == "2 programs. 0 with mistakes, 2 without."


def test_a_program_may_come_from_standard_input_or_from_nowhere(
    printed: Printed, monkeypatch: pytest.MonkeyPatch
) -> None:
    for stream, code, out, err in (
        (io.TextIOWrapper(io.BytesIO(b"fwd 1\n")), 1, "-:1:1: unknown-command: ", ""),
        (io.TextIOWrapper(io.BytesIO("fw 1 -- é\n".encode())), 0, "", "-: no mistakes.\n"),
        (None, 0, "", "-: no mistakes.\n"),
    ):
        monkeypatch.setattr(sys, "stdin", stream)
        assert (printed.by("check", "-"), printed.out[: len(out or " ")], printed.err) == (code, out, err)
    monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(b"fw   1")))
    assert (printed.by("format", "-w", "-"), printed.out) == (0, "FW 1\n")
    assert not Path("-").exists()


def test_check_knows_the_colours_of_the_world_that_is_named(printed: Printed, tmp_path: Path) -> None:
    write("a.gd", "SPEAK COLOR yellow")
    write(
        "b.world",
        'position( name "d" blobfinder( colors_count 1 colors [ "red" ] ) ranger( sensor( range [0 3] ) ) )',
    )

    assert printed.by("check", "a.gd", "--world", "b.world") == 1
    assert printed.out == "a.gd:1:13: bad-argument: The robot does not see yellow. Use RED.\n"


def test_the_worst_of_several_files_counts(printed: Printed) -> None:
    write("good.gd", "FW 1")
    write("bad.gd", "FWD 1")

    assert printed.by("check", "good.gd", "bad.gd") == 1
    assert printed.by("check", "good.gd", "none.gd", "bad.gd") == 2
    assert "There is no file none.gd." in printed.out
    assert "bad.gd:1:1:" in printed.out
    assert printed.out.endswith("\n3 programs. 1 with mistakes, 1 without, 1 unreadable.\n")


# --- a misspelt command


@pytest.mark.parametrize("arguments", [("chek", "a.gd"), ("chek",), ("--lang", "en", "chek", "a.gd")])
def test_a_misspelt_command_is_answered_with_the_command(
    printed: Printed, arguments: tuple[str, ...]
) -> None:
    write("a.gd", "FW 1")

    assert printed.by(*arguments) == 2
    assert printed.err == "I do not know the command chek. Did you mean check?\n"


def test_a_short_command_with_one_letter_wrong_is_known(printed: Printed) -> None:
    assert printed.by("rn", "a.gd") == 2
    assert printed.err == "I do not know the command rn. Did you mean run?\n"


# --- format


def test_format_prints_the_canonical_layout_and_leaves_the_file(printed: Printed) -> None:
    write("a.gd", "repeat 2 times fw 1 end repeat")

    assert printed.by("format", "a.gd") == 0
    assert printed.out == "REPEAT 2 TIMES\n  FW 1\nEND REPEAT\n"
    assert Path("a.gd").read_text() == "repeat 2 times fw 1 end repeat"


def test_format_translates_and_writes_in_place(printed: Printed) -> None:
    write("a.gd", "repeat 2 times fw 1 end repeat")

    assert printed.by("format", "a.gd", "--to", "es", "-w") == 0
    assert printed.out == ""
    assert Path("a.gd").read_text(encoding="utf-8") == "REPETIR 2 VECES\n  AV 1\nFIN REPETIR\n"


def test_the_worst_of_several_formatted_files_counts_and_one_in_its_layout_is_not_written(
    printed: Printed,
) -> None:
    write("a.gd", "FW 1\n")
    before = Path("a.gd").stat().st_ino
    assert printed.by("format", "-w", "a.gd", "none.gd", "a.gd") == 2
    assert (printed.out, printed.err) == ("", "There is no file none.gd.\n")
    assert Path("a.gd").stat().st_ino == before, "it was not replaced"
    write("a.gd", "FW 1")
    assert printed.by("format", "-w", "a.gd") == 0
    assert Path("a.gd").read_bytes() == b"FW 1\n"


@pytest.mark.parametrize(
    "words", [("check",), ("check", "first_walk"), ("test",), ("new",), ("new", "a", "b")]
)
def test_an_order_about_challenges_without_its_names_is_answered_with_its_forms(
    printed: Printed, words: tuple[str, ...]
) -> None:
    assert printed.by("challenge", *words, "--lang", "en") == 2
    assert printed.out == ""
    assert "Type donnie challenge, donnie challenge NAME, or donnie challenge check NAME FILE." in printed.err


@pytest.mark.parametrize(
    ("program", "world", "challenge", "code", "said"),
    [
        ("FW 5", "challenge:first_walk", "first_walk", 0, "Solved, in 1 command."),
        ("FW 4", "challenge:first_walk", "1", 1, "0 of 1 goal. You stopped 1 step south of 0, 5."),
    ],
)
def test_a_recording_is_judged_in_the_world_of_its_challenge(
    printed: Printed, program: str, world: str, challenge: str, code: int, said: str
) -> None:
    write("a.gd", program)
    quiet = ("--lang", "en", "--speech", "off", "--sound", "off")
    printed.by("run", "a.gd", "--world", world, "--record", "a.rec", *quiet)

    assert printed.by("replay", "a.rec", "--challenge", challenge, *quiet) == code
    assert printed.out == f"{said}\n"
    assert printed.by("replay", "a.rec", "--challenge", "one_lap", *quiet) == 2
    assert printed.err.startswith("a.rec was recorded in ")


@pytest.mark.parametrize(
    ("programs", "said"),
    [
        (("alice=a.gd", "ALICE=a.gd"), "The robot alice has two programs. One is enough."),
        (("alice=a.gd", "a.gd"), "Which robot runs a.gd? Write ROBOT=a.gd."),
    ],
)
def test_a_robot_has_one_program(printed: Printed, programs: tuple[str, ...], said: str) -> None:
    write("a.gd", "FW 1")
    assert printed.by("run", *programs, "--world", "two_robots", "--lang", "en") == 2
    assert printed.err.splitlines()[-1] == said


def test_format_leaves_a_program_with_mistakes_as_it_is(printed: Printed) -> None:
    write("a.gd", "fw 1\nfwd 2")

    assert printed.by("format", "a.gd", "--write") == 1
    assert printed.out == ""
    assert printed.err == "a.gd:2:1: unknown-command: I do not know fwd. Did you mean FW?\n"
    assert Path("a.gd").read_text() == "fw 1\nfwd 2"


# --- worlds


@pytest.mark.parametrize("language", ["en", "pt", "es"])
def test_worlds_lists_each_with_its_title_and_difficulty(printed: Printed, language: str) -> None:
    assert printed.by("worlds", "--lang", language) == 0
    assert printed.out.splitlines() == [
        f"{name}: {about.title}, {Words(language)(f'difficulty-{about.difficulty.value}')}."
        for name, about in ((each, worlds.words.about(each, language)) for each in worlds.names())
    ]


@pytest.mark.parametrize("name", worlds.names())
@pytest.mark.parametrize("language", ["en", "pt", "es"])
def test_a_world_is_described_in_words(printed: Printed, name: str, language: str) -> None:
    assert printed.by("world", name, "--lang", language) == 0

    about = worlds.words.about(name, language)
    first, *middle, last = printed.out.splitlines()
    assert first == f"{name}: {about.title}."
    assert set(about.sentences) <= set(middle)
    assert about.task in last


def test_a_world_as_a_map_has_the_robot_in_it(printed: Printed) -> None:
    assert printed.by("world", "living_room", "--map") == 0

    rows = printed.out.partition("\n\n")[0].splitlines()
    assert len({len(row) for row in rows}) == 1
    assert "".join(rows).count("^") == 1
    assert set(rows[0]) == {"#"}


@pytest.mark.parametrize(("option", "most"), [("--map", 4), ("--report", 10)])
def test_of_many_robots_the_first_are_named(printed: Printed, option: str, most: int) -> None:
    for number, rest in ((most, ""), (most + 1, ", …")):
        robots = [f'donnie( name "r{each}" pose [ {each / 2 - 3} 0 0 90 ] )\n' for each in range(number)]
        write("many.world", f'include "donnie.inc"\n{"".join(robots)}')
        assert printed.by("world", "many.world", option, "--lang", "en") == 0
        assert f" r0, {', '.join(f'r{each}' for each in range(1, most))}{rest}." in printed.out
    assert option == "--map" or f"{most + 1} robots: " in printed.out
    assert option == "--map" or "run r0=FILE" in printed.out


@pytest.mark.parametrize(("columns", "letters"), [(80, 80), (81, 41)])
def test_a_line_of_a_map_has_at_most_eighty_letters(printed: Printed, columns: int, letters: int) -> None:
    wall, floor = "#" * columns, "#" + "." * (columns - 2) + "#"
    middle = f"{floor[:20]}^{floor[21:]}"
    write("map.txt", "\n".join([wall, *[floor] * 4, middle, *[floor] * 4, wall]))
    assert printed.by("world", "new", "wide.world", "--from", "map.txt") == 0
    assert printed.by("world", "wide.world", "--map", "--lang", "en") == 0
    drawn, _, legend = printed.out.partition("\n\n")
    assert {len(row) for row in drawn.splitlines()} == {letters}
    assert ("2 steps" in legend) == (letters < columns)


def test_a_world_as_json_has_its_models_as_stage_would_build_them(printed: Printed) -> None:
    assert printed.by("world", "living_room", "--json") == 0

    models = json.loads(printed.out)
    robot = next(each for each in models if each["name"] == "donnie")
    assert (robot["type"], robot["parent"]) == ("position", None)
    assert robot["global_pose"] == [0.0, 0.0, 0.0, 90.0]
    assert set(robot) == {
        *("type", "name", "parent", "global_pose", "origin", "size", "color"),
        *("boundary", "blocks", "block_area"),
        *("obstacle_return", "ranger_return", "blob_return", "fiducial_return", "gripper_return"),
    }  # fmt: skip


MODELS = """
model( name "crate" pose [ 1 2 0 90 ] size [ 1 0.5 0.25 ]
  origin [ 0.1 0.2 0 45 ] color_rgba [ 0.1 0.2 0.3 0.5 ]
  ranger_return 0.5 blob_return 0 fiducial_return 7 gripper_return 1 )
model( name "room" size [ 4 4 1 ] boundary 1 )
position( name "robo" pose [ 0 0 0 0 ] size [ 0.2 0.2 0.2 ]
  ranger( pose [ 0.1 0 0 0 ] sensor( pose [ 0.05 0 0 30 ] range [ 0.5 5 ] fov 15 samples 3 ) ) )
"""


def test_the_json_of_a_model_has_what_the_world_file_says(printed: Printed) -> None:
    write("m.world", MODELS)
    assert printed.by("world", "m.world", "--json") == 0
    crate, room, robot, ranger = json.loads(printed.out)

    assert crate == {
        "type": "model",
        "name": "crate",
        "parent": None,
        "global_pose": [1, 2, 0, 90],
        "origin": [0.1, 0.2, 0, 45],
        "size": [1, 0.5, 0.25],
        "color": [0.1, 0.2, 0.3, 0.5],
        "obstacle_return": 1,
        "ranger_return": 0.5,
        "blob_return": 0,
        "fiducial_return": 7,
        "gripper_return": 1,
        "boundary": 0,
        "blocks": 1,
        "block_area": 0.5,
    }
    assert (room["boundary"], room["size"]) == (1, [4, 4, 1])
    assert (robot["size"], robot["block_area"], robot["parent"]) == ([0.2, 0.2, 0.2], 0.04, None)
    assert (ranger["parent"], ranger["global_pose"]) == ("robo", [0.1, 0, 0.2, 0])
    assert ranger["sensors"] == [
        {"pose": [0.05, 0, 0, 30], "range": [0.5, 5], "fov_deg": 15, "samples": 3},
    ]


def robots_facing(*degrees: float) -> str:
    robots = (f'donnie( name "r{at}" pose [ {at} 0 0 {each} ] )' for at, each in enumerate(degrees))
    return "\n".join(('include "donnie.inc"', *robots))


def test_the_robots_of_a_map_are_arrows_in_the_direction_that_is_nearest(printed: Printed) -> None:
    write("r.world", robots_facing(0, 90, 180, 270, 44, 46))
    assert printed.by("world", "r.world", "--map", "--lang", "en") == 0
    drawn, _, legend = printed.out.partition("\n\n")

    assert "".join(each for row in drawn.splitlines() for each in row if each in "^>v<") == ">^<v>^"
    assert "^ > v < is r0, r1, r2, r3, …." in legend
    assert "Each letter is 2 by 2 steps." in legend


def test_a_report_says_what_was_read_and_what_stage_needs_besides(printed: Printed) -> None:
    write("r.world", robots_facing(0, 90))
    folder = Path(worlds.SCENES).resolve()
    assert printed.by("world", "r.world", "--report", "--lang", "en") == 0
    assert printed.out.splitlines() == [
        "2 files: r.world, donnie.inc.",
        f"Stage also needs donnie.inc, from the folder {folder}.",
        "Loaded: 4 position, 4 ranger, 2 bumper, 2 blobfinder.",
        "2 robots: r0, r1. The command donnie run r0=FILE runs the first.",
        "Nothing was ignored or repaired.",
    ]
    assert printed.by("world", "maze", "--report", "--lang", "en") == 0
    assert printed.out.splitlines() == [
        "3 files: maze.world, donnie.inc, things.inc.",
        "Loaded: 19 model, 2 position, 2 ranger, 1 bumper, 1 blobfinder.",
        "1 thing can be pushed: always straight on, without turning.",
        "Nothing was ignored or repaired.",
    ]
    write("empty.world", "")
    assert printed.by("world", "empty.world", "--report", "--lang", "en") == 0
    assert printed.out.splitlines()[1] == "Loaded: 0."


def test_without_a_drawing_a_new_world_is_an_empty_room_around_the_robot(printed: Printed) -> None:
    assert printed.by("world", "new", "my room", "--lang", "en") == 0
    assert printed.out == (
        "my room.world: a floor of 33 by 33 steps, 1 robot, 0 things. "
        "Go there: donnie --world 'my room.world'\n"
    )
    assert printed.by("world", "my room.world", "--lang", "en") == 0
    assert printed.out.splitlines() == [
        *("33 by 33 steps, walls included.", "Walls are all around."),
        *("The robot donnie starts at 0, 0, facing north.", "There are no things."),
    ]
    assert printed.by("world", "my room.world", "--map", "--lang", "en") == 0
    rows = printed.out.partition("\n\n")[0].splitlines()
    assert rows == ["#" * 33, *["#" + "." * 31 + "#"] * 15, "#" + "." * 15 + "^" + "." * 15 + "#",
                    *["#" + "." * 31 + "#"] * 15, "#" * 33]  # fmt: skip


@pytest.mark.parametrize(
    "arguments",
    [
        *(("new",), ("new", "a", "b"), ("a", "b")),
        *(("open_floor", "--from", "d.txt"), ("--from", "d.txt")),
    ],
    ids=" ".join,
)
def test_a_new_world_needs_a_file_and_perhaps_a_drawing(printed: Printed, arguments: tuple[str, ...]) -> None:
    write("d.txt", "^")
    assert printed.by("world", *arguments, "--lang", "en") == 2
    assert (printed.out, printed.err) == (
        "",
        "Type donnie world new FILE --from DRAWING, or without --from for an empty room.\n",
    )
    assert [each.name for each in Path().iterdir() if each.is_file()] == ["d.txt"]


def test_a_new_world_replaces_no_file(printed: Printed) -> None:
    write("room.world", "FW 1")
    assert printed.by("world", "new", "room", "--lang", "en") == 2
    assert (Path("room.world").read_text(), "room.world" in printed.err) == ("FW 1", True)


def test_without_a_name_the_world_of_the_settings_is_described(printed: Printed) -> None:
    assert printed.by("world", "--world", "open_floor", "--lang", "en") == 0
    assert printed.out.splitlines()[0] == "open_floor: Open floor."


def test_a_page_of_a_world_may_be_standard_output(printed: Printed) -> None:
    assert printed.by("world", "open_floor", "--brf", "-", "--lang", "en") == 0
    assert printed.out.startswith("MAP OF OPEN FLOOR\r\n")
    assert printed.by("world", "open_floor", "--svg", "-", "--lang", "en") == 0
    assert printed.out.startswith("<svg ")
    assert "<title>Map of Open floor</title>" in printed.out
    for option, file in (("--svg", "a.svg"), ("--brf", "a.brf")):
        assert printed.by("world", "open_floor", option, file, "--lang", "en") == 0
        assert (printed.out, Path(file).exists()) == (f"I wrote {file}.\n", True)


def test_a_configuration_of_a_real_robot_says_that_it_has_no_world(printed: Printed) -> None:
    write("serial.cfg", 'driver ( name "donnie" provides [ "position2d:0" ] port "/dev/ttyS0" )')
    sentence = "serial.cfg asks for the robot at /dev/ttyS0 and has no world. "

    for way in ((), ("--report",)):
        assert printed.by("world", "serial.cfg", *way) == 0
        assert printed.out.startswith(sentence)
    for way in (("--map",), ("--json",)):
        assert printed.by("world", "serial.cfg", *way) == 0
        assert sentence not in printed.out
        assert printed.err.startswith(sentence)


def test_a_report_lists_ignored_properties(printed: Printed) -> None:
    write("b.world", 'model( name "x" colr "red" )')

    assert printed.by("world", "b.world", "--report") == 0
    assert (
        "Ignored: Line 1, column 17, of b.world: the property colr is not known. Did you mean color?"
        in printed.out
    )


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (("world", "living_rom"), "There is no world living_rom. Did you mean living_room?"),
        (("world", "xyz"), "There is no world xyz. The command donnie worlds lists them."),
        (("world", "no.world"), "There is no file no.world."),
        (
            ("world", "open_floor", "--svg", "no/x.svg"),
            "I can't write no/x.svg: there is no such folder.",
        ),
        (("world", "open_floor", "--brf", "."), ". is a folder."),
        (
            ("world", "open_floor", "--svg", ""),
            "The option --svg needs a value. The option --help says more.",
        ),
        (("run", "no.gd"), "There is no file no.gd."),
        (("run", "."), ". is a folder."),
        (("run", "a.gd", "--robot", "serial:/dev/x"), "Nothing is plugged in at /dev/x."),
        (
            ("run", "a.gd", "--robot", "bogus"),
            "The option --robot can't be bogus. It takes sim, serial, serial:DEVICE, "
            "serial:socket://HOST:PORT, serial:rfc2217://HOST:PORT, double, player://HOST:PORT/INDEX.",
        ),
        (("run", "a.gd", "--speed", "fast"), "The option --speed can't be fast. It takes 0.1-1000, max."),
        (("run", "a.gd", "--events", "no/such"), "I can't write no/such: there is no such folder."),
        (("run", "a.gd", "--foo"), "I do not understand --foo. The option --help says more."),
        (("run", "--lang", "pt"), "Falta: FILE. A opção --help diz mais."),
        (
            ("format", "a.gd", "--to", "fr"),
            "The option --to can't be fr. It takes en, pt, es.",
        ),
        (("replay", "a.gd", "--from", "abc"), "The option --from takes a whole number, such as 12."),
        (("run", "a.gd", "--lang"), "The option --lang needs a value. The option --help says more."),
        (("--linear", "--visual"), "Give only one of these options: --visual, --linear."),
        (("challenge", "no_such"), "There is no challenge no_such. donnie challenge lists them."),
    ],
)
def test_an_unusable_argument_is_one_sentence_and_exit_code_2(
    printed: Printed, arguments: tuple[str, ...], sentence: str
) -> None:
    write("a.gd", "FW 1")

    assert printed.by(*arguments) == 2
    assert (printed.out, printed.err) == ("", f"{sentence}\n")


def test_a_mistake_in_a_world_has_its_place(printed: Printed) -> None:
    write("b.world", "model(\n  size [ 1 2\n)")

    assert printed.by("world", "b.world") == 2
    assert printed.err.startswith("Error, b.world, line ")


# --- settings


def test_variables_and_the_settings_file_count_and_their_mistakes_are_reported(
    printed: Printed, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "config/donnie").mkdir(parents=True)
    (tmp_path / "config/donnie/settings.toml").write_text('lang = "es"\nspeed = "fast"\n')
    write("a.gd", "FW 1")

    assert printed.by("run", "a.gd") == 0
    assert printed.out == "Caminé 1 paso hacia adelante.\n"
    assert printed.err == "El ajuste speed no puede ser fast. Acepta 0.1-1000, max.\n"

    monkeypatch.setenv("DONNIE_LANG", "pt")
    assert printed.by("run", "a.gd") == 0
    assert printed.out == "Andei 1 passo para frente.\n"


def test_detail_is_chosen_by_verbosity(printed: Printed) -> None:
    write("a.gd", "FW 1")

    assert printed.by("run", "a.gd", "--verbosity", "brief") == 0
    assert printed.out == "1 step forward.\n"


# --- the original's flags, and files that are called like a command


def test_the_original_flags_run_a_file_mute_and_log_the_printed_lines(printed: Printed) -> None:
    write("a.gd", "FW 1 SPEAK 5")

    assert printed.by("-f", "a.gd", "-m", "-l") == 0
    assert printed.by("-F", "a.gd", "-M", "-L") == 0
    assert printed.out == "I walked 1 step forward.\n5\n"
    logs = sorted(Path("Log").iterdir())
    assert [each.name for each in logs] == ["log_001.txt", "log_002.txt"]
    assert logs[1].read_text() == "I walked 1 step forward.\n5\n"


def test_a_file_that_is_called_like_a_command_is_run_by_its_path(printed: Printed) -> None:
    write("run", "SPEAK 7")

    assert printed.by("run", "./run") == 0
    assert printed.out == "7\n"


def test_without_a_terminal_donnie_says_so_and_is_linear(tmp_path: Path) -> None:
    done = donnie(tmp_path, *QUIET, "--speed", "max", typed="FW 2\n\nQUIT\n")

    lines = done.stdout.decode().splitlines()
    assert done.returncode == 0
    assert lines[0] == "Linear mode: there is no terminal."
    assert "I walked 2 steps forward." in lines


def test_check_and_help_load_neither_simulator_nor_screen(tmp_path: Path) -> None:
    (tmp_path / "a.gd").write_text("FW 1")
    code = (
        "import sys; sys.argv = ['donnie', 'check', 'a.gd']\n"
        "from donnie_tui.__main__ import main\n"
        "main(); print(*[m for m in ('lark', 'pymunk', 'textual', 'pyttsx3') if m in sys.modules])"
    )

    done = subprocess.run(
        [sys.executable, "-c", code],
        capture_output=True,
        text=True,
        cwd=tmp_path,
        env={**os.environ, "PYTHONPATH": str(ROOT)},
        timeout=TIMEOUT,
    )

    assert done.stdout.strip() == "", done.stderr
