"""``donnie run``: a program has the same outcome from any source, at any speed, every time."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import threading
from pathlib import Path
from typing import Any

import pytest

from tests.conftest import ROOT
from tests.floor import Floor
from tests.sessions.command import QUIET, donnie, environment, start
from tests.sessions.here import PROGRAM
from tests.timeouts import TIMEOUT

pytestmark = pytest.mark.slow


def records(stream: bytes) -> list[dict[str, Any]]:
    return [json.loads(line) for line in stream.decode().split("\n") if line]


def nameless(stream: bytes) -> list[dict[str, Any]]:
    """The events without the name of the program."""
    return [{key: value for key, value in each.items() if key != "program"} for each in records(stream)]


# --- the same outcome


def test_a_file_standard_input_and_typed_lines_have_the_same_outcome(tmp_path: Path) -> None:
    (tmp_path / "a.gd").write_text(PROGRAM, encoding="utf-8")

    from_file = donnie(tmp_path, "run", "a.gd", *QUIET, "--events", "-")
    from_input = donnie(tmp_path, "run", "-", *QUIET, "--events", "-", typed=PROGRAM)
    donnie(tmp_path, "--linear", *QUIET, "--speed", "max", "--events", "typed.jsonl", typed=f"{PROGRAM}RUN\n")

    assert from_file.returncode == 0
    assert nameless(from_file.stdout) == nameless(from_input.stdout)
    assert nameless(from_file.stdout) == nameless((tmp_path / "typed.jsonl").read_bytes())


def test_a_hundred_runs_at_different_speeds_write_the_same_bytes() -> None:
    streams = set()
    for number in range(100):
        floor = Floor(("red", 1, 5), ("blue", -2, 3), speed=(None, 1000.0, 400.0)[number % 3])
        floor.run(PROGRAM, hooked=number % 2 == 0)
        streams.add(floor.json)

    assert len(streams) == 1


def test_the_command_writes_the_same_bytes_again(tmp_path: Path) -> None:
    (tmp_path / "a.gd").write_text(PROGRAM, encoding="utf-8")
    common = ("run", "a.gd", "--world", "living_room", *QUIET, "--events", "-")

    streams = {donnie(tmp_path, *common, "--speed", speed).stdout for speed in ("max", "max", "500")}

    assert len(streams) == 1
    assert len(records(streams.pop())) > 20


# --- what is printed


def test_a_run_prints_words_and_optionally_events(tmp_path: Path) -> None:
    done = donnie(tmp_path, "run", "-", *QUIET, "--events", "e.jsonl", typed='FW 2 SPEAK "olá"')

    assert done.stdout.decode() == "I walked 2 steps forward.\nolá\n"
    assert done.stderr == b""
    assert [each["event"] for each in records((tmp_path / "e.jsonl").read_bytes())] == [
        "run_started",
        "cue",
        "cue",
        "moved",
        "announced",
        "spoke",
        "cue",
        "run_ended",
    ]


def test_a_trace_prints_each_statement(tmp_path: Path) -> None:
    done = donnie(tmp_path, "run", "-", *QUIET, "--events", "-", "--trace", typed="FW 1\nSPEAK 1")

    lines = [each["line"] for each in records(done.stdout) if each["event"] == "statement"]
    assert lines == [1, 2]


@pytest.mark.parametrize("changes", [{"LC_ALL": "C", "PYTHONUTF8": "0"}, {"PYTHONIOENCODING": "ascii"}])
def test_output_is_utf8_whatever_the_locale_says(tmp_path: Path, changes: dict[str, str]) -> None:
    done = donnie(tmp_path, "run", "-", *QUIET, typed='SPEAK "olá 日本"', changes=changes)

    assert done.stdout.decode() == "olá 日本\n"


def test_input_in_the_old_code_page_is_understood(tmp_path: Path) -> None:
    done = donnie(tmp_path, "run", "-", *QUIET, typed='FALAR "ação"'.encode("cp1252"))

    assert done.stdout.decode() == "ação\n"


def test_a_name_of_invalid_bytes_crashes_nothing(tmp_path: Path) -> None:
    name = "a\udcff.gd"
    (tmp_path / name).write_text("FW 1")

    done = donnie(tmp_path, "run", name, *QUIET, "--events", "-")

    assert done.returncode == 0
    assert records(done.stdout)[0]["program"] == name


# --- exit codes


@pytest.mark.parametrize(
    ("program", "code"), [("FW 1", 0), ("", 0), ("FWD 1", 1), ("SPEAK q", 1), ("QUIT", 1), ("SPEAK 1/0", 1)]
)
def test_the_exit_code_shows_whether_the_program_had_a_mistake(
    tmp_path: Path, program: str, code: int
) -> None:
    assert donnie(tmp_path, "run", "-", *QUIET, typed=program).returncode == code


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM, signal.SIGHUP])
def test_a_signal_stops_the_robot_and_the_run_still_ends_in_order(
    tmp_path: Path, number: signal.Signals
) -> None:
    (tmp_path / "a.gd").write_text("FW 1000 SPEAK 1")
    running = start(tmp_path, "run", "a.gd", *QUIET, "--speed", "20", "--events", "-")
    assert running.stdout is not None
    seen = [running.stdout.readline() for _ in range(3)]

    running.send_signal(number)
    rest, complaints = running.communicate(timeout=TIMEOUT)

    *_, moved, announced, ended = records(b"".join(seen) + rest)
    assert running.returncode == 130
    assert complaints == b""
    assert (moved["event"], moved["stopped_by"]) == ("moved", "stopped")
    assert announced["text"].endswith("I was stopped.")
    assert (ended["event"], ended["outcome"]) == ("run_ended", "stopped")
    assert ended["pose"]["y"] < 1000


def test_a_program_that_computes_for_ever_stops_too(tmp_path: Path) -> None:
    (tmp_path / "a.gd").write_text('SPEAK "begun" WHILE 1 == 1 DO END WHILE')
    running = start(tmp_path, "run", "a.gd", *QUIET)
    assert running.stdout is not None
    assert running.stdout.readline() == b"begun\n"

    running.send_signal(signal.SIGINT)

    assert running.communicate(timeout=TIMEOUT) == (b"", b"")
    assert running.returncode == 130


def test_a_closed_pipe_ends_the_run_quietly(tmp_path: Path) -> None:
    (tmp_path / "a.gd").write_text("WHILE 1 == 1 DO SPEAK 1 END WHILE")
    running = start(tmp_path, "run", "a.gd", *QUIET)
    assert running.stdout is not None
    assert running.stderr is not None
    running.stdout.readline()

    running.stdout.close()

    assert running.stderr.read() == b""
    assert running.wait(TIMEOUT) == 130


@pytest.mark.parametrize("option", [("--events", "/dev/full"), ("--sound", "wav:/dev/full")])
def test_a_full_disk_is_reported(tmp_path: Path, option: tuple[str, str]) -> None:
    if not Path("/dev/full").exists():
        pytest.skip("needs a device that is always full")
    (tmp_path / "a.gd").write_text("FW 1 SPEAK 1")

    done = donnie(tmp_path, "run", "a.gd", *QUIET, *option)

    assert done.stdout.decode() == "I walked 1 step forward.\n1\n"
    assert done.stderr.decode() == "I can't write /dev/full: the disk is full.\n"
    assert done.returncode == 2


def test_a_sound_file_without_a_folder_is_reported_in_one_line(tmp_path: Path) -> None:
    (tmp_path / "a.gd").write_text("FW 1")

    done = donnie(tmp_path, "run", "a.gd", *QUIET, "--sound", "wav:none/b.wav")

    assert done.stderr.decode() == "I can't write none/b.wav: there is no such folder.\n"
    assert (done.stdout, done.returncode) == (b"", 2)


def test_a_signal_ends_a_run_with_unread_output(tmp_path: Path) -> None:
    (tmp_path / "a.gd").write_text(
        'WHILE 1 == 1 DO SPEAK "a line that fills the pipe sooner or later" END WHILE'
    )
    running = start(tmp_path, "run", "a.gd", *QUIET)
    assert running.stdout is not None
    running.stdout.readline()

    running.send_signal(signal.SIGTERM)

    assert running.wait(TIMEOUT) == 130
    running.communicate()


# --- several robots

TWO = """include "donnie.inc"
donnie( name "alice" pose [ 0 0 0 90 ] )
donnie( name "bob" pose [ 0 2 0 -90 ] )
"""


def two(folder: Path, **programs: str) -> tuple[str, ...]:
    """A world with alice and bob, and a program for each that is named."""
    (folder / "two.world").write_text(TWO)
    for robot, program in programs.items():
        (folder / f"{robot}.gd").write_text(program, encoding="utf-8")
    return ("--world", "two.world", *QUIET)


def test_several_robots_run_their_programs_and_print_their_names(tmp_path: Path) -> None:
    world = two(tmp_path, alice="FW 2", bob='WAIT 1 SPEAK "olá"')

    done = donnie(tmp_path, "run", "alice=alice.gd", "bob=bob.gd", *world)

    assert done.returncode == 0
    assert done.stdout.decode().splitlines() == [
        "bob: Waiting 1 second.",
        "bob: olá",
        "alice: I walked 2 steps forward.",
    ]


def test_several_robots_write_the_same_bytes_again(tmp_path: Path) -> None:
    world = two(tmp_path, alice=PROGRAM, bob=PROGRAM)
    common = ("run", "bob=bob.gd", "alice=alice.gd", *world, "--events", "-")

    streams = {donnie(tmp_path, *common, "--speed", speed).stdout for speed in ("max", "max", "500")}

    assert len(streams) == 1
    assert {each["robot"] for each in records(streams.pop())} == {"alice", "bob"}


def test_the_exit_code_of_several_is_the_worst(tmp_path: Path) -> None:
    world = two(tmp_path, alice="FW 1", bob="SPEAK q")

    assert donnie(tmp_path, "run", "alice=alice.gd", "bob=bob.gd", *world).returncode == 1


def test_without_a_name_the_first_robot_of_the_world_runs(tmp_path: Path) -> None:
    world = two(tmp_path, alice="FW 1")

    done = donnie(tmp_path, "run", "alice.gd", *world)

    assert done.stdout.decode() == "alice: I walked 1 step forward.\n"


def test_a_file_with_a_sign_of_equality_in_its_name_is_a_file(tmp_path: Path) -> None:
    world = two(tmp_path)
    (tmp_path / "bob=alice.gd").write_text("SPEAK 1")

    assert donnie(tmp_path, "run", "bob=alice.gd", *world).stdout.decode() == "alice: 1\n"


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (("alice=alice.gd", "carol=alice.gd"), "There is no robot carol here. There are alice and bob."),
        (("alice=alice.gd", "Alice=alice.gd"), "The robot alice has two programs. One is enough."),
        (("alice.gd", "alice.gd"), "Which robot runs alice.gd? Write ROBOT=alice.gd."),
        (("alice=-", "bob=-"), "Only one robot can take its program from standard input."),
        (("alice=alice.gd", "bob=nowhere.gd"), "There is no file nowhere.gd."),
    ],
)
def test_each_program_needs_a_clear_robot(tmp_path: Path, arguments: tuple[str, ...], sentence: str) -> None:
    world = two(tmp_path, alice="FW 1")

    done = donnie(tmp_path, "run", *arguments, *world)

    assert (done.returncode, done.stdout) == (2, b"")
    assert done.stderr.decode() == f"{sentence}\n"


def test_a_signal_stops_every_robot(tmp_path: Path) -> None:
    world = two(tmp_path, alice="FW 1000", bob="WHILE 1 == 1 DO WAIT 1 END WHILE")
    running = start(tmp_path, "run", "alice=alice.gd", "bob=bob.gd", *world, "--speed", "20", "--events", "-")
    assert running.stdout is not None
    seen = [running.stdout.readline() for _ in range(5)]

    running.send_signal(signal.SIGTERM)
    rest, complaints = running.communicate(timeout=TIMEOUT)

    ended = [each for each in records(b"".join(seen) + rest) if each["event"] == "run_ended"]
    assert (running.returncode, complaints) == (130, b"")
    assert {(each["robot"], each["outcome"]) for each in ended} == {("alice", "stopped"), ("bob", "stopped")}


MEASURED = """
import re, runpy, sys
try:
    runpy.run_module("donnie_tui", run_name="__main__")
finally:
    print(re.search(r"VmHWM:\\s+(\\d+)", open("/proc/self/status").read())[1], file=sys.stderr)
"""


def most_memory(folder: Path, movements: int) -> float:
    """MB that a run of so many movements took at most."""
    (folder / "a.gd").write_text(f"REPEAT {movements} TIMES TR 1 END REPEAT")
    done = subprocess.run(
        [sys.executable, "-c", MEASURED, "run", "a.gd", *QUIET, "--speed", "max"],
        cwd=folder,
        env=environment(folder, {"PYTHONPATH": str(ROOT)}),
        stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE,
    )
    assert done.returncode == 0
    return int(done.stderr) / 1024


@pytest.mark.skipif(sys.platform != "linux", reason="/proc says how much memory was used")
def test_a_program_that_turns_and_turns_takes_bounded_memory(tmp_path: Path) -> None:
    """Before HISTORY had a bound, a movement took 275 bytes: 11 MB more. By 40,000 all is full."""
    assert most_memory(tmp_path, 80_000) < most_memory(tmp_path, 40_000) + 3


@pytest.mark.parametrize("is_read", [True, False])
def test_an_unread_pipe_of_events_does_not_delay_the_program(is_read: bool, tmp_path: Path) -> None:
    """A reader gets every line. 4,000 lines are more than a pipe holds."""
    os.mkfifo(tmp_path / "events")
    end = os.open(tmp_path / "events", os.O_RDWR)  # so that it opens at once
    (tmp_path / "a.gd").write_text("REPEAT 4000 TIMES\nSPEAK 1\nEND REPEAT\nSPEAK 2")
    read = bytearray()

    def take() -> None:
        while b'"run_ended"' not in read or not read.endswith(b"\n"):
            read.extend(os.read(end, 4_096))

    taking = threading.Thread(target=take, daemon=True)
    if is_read:
        taking.start()
    ended = donnie(tmp_path, "run", *QUIET, "--events", "events", "a.gd")
    if is_read:
        taking.join(TIMEOUT)
        assert len([each for each in records(bytes(read)) if each["event"] == "spoke"]) == 4_001
    os.close(end)

    assert ended.returncode == 0
    assert ended.stdout.decode().split() == ["1"] * 4_000 + ["2"]
