"""``donnie replay --check``: the same programs give the same events, or the first difference is reported."""

from __future__ import annotations

import json
import re
import signal

import pytest

from donnie_tui import __version__
from tests.sessions.command import QUIET, donnie, start
from tests.sessions.here import PROGRAM, Here
from tests.timeouts import TIMEOUT


@pytest.mark.parametrize("world", ["open_floor", "living_room", "two_robots"])
def test_running_it_again_gives_the_same_events(here: Here, world: str) -> None:
    here.record(PROGRAM, "--world", world, "--lang", "pt")

    assert here.replay("--check")[0].startswith("Run again: ")
    assert here.replay("--check")[0].endswith("events are the same.")


def test_several_robots_are_run_again_together(here: Here) -> None:
    (here.folder / "a.gd").write_text(PROGRAM)
    (here.folder / "b.gd").write_text("WAIT 1 FW 20 SPEAK 1 / 0")
    done = here.donnie("run", "alice=a.gd", "bob=b.gd", "--world", "two_robots", "--record", "a.rec")

    assert done.returncode == 1
    assert here.replay("--check")[0].endswith("events are the same.")
    assert here.replay() == done.out


@pytest.mark.parametrize("world", ["object_field", "cave"])
def test_a_recording_has_each_file_of_its_world_once(here: Here, world: str) -> None:
    here.record("SPEAK 1", "--world", world)

    header = json.loads((here.folder / "a.rec").read_text(encoding="utf-8").splitlines()[0])
    contents = [json.dumps({**each, "name": ""}) for each in header["world"]["files"]]
    assert len(contents) > 1
    assert len(contents) == len(set(contents))
    assert here.replay("--check")[0].endswith("events are the same.")


def test_a_recording_needs_nothing_but_itself(here: Here) -> None:
    (here.folder / "sub").mkdir()
    (here.folder / "sub" / "own.inc").write_text(
        'include "donnie.inc"\ndefine box model ( size [ 0.2 0.2 0.2 ] )\n'
    )
    (here.folder / "own.world").write_text(
        'include "sub/own.inc"\nbox( pose [ 0 0.5 0 0 ] color "red" )\ndonnie( pose [ 0 0 0 90 ] )\n'
    )
    here.record("FW 30 SCAN", "--world", "own.world")
    for file in ("own.world", "sub/own.inc", "a.gd"):
        (here.folder / file).unlink()

    assert here.replay("--check")[0].endswith("events are the same.")


def test_the_first_different_event_is_reported(here: Here) -> None:
    here.record("FW 2\nSPEAK 5")
    lines = (here.folder / "a.rec").read_bytes().splitlines(keepends=True)
    number = next(number for number, line in enumerate(lines, 1) if b'"spoke"' in line)
    here.spoil({number: lines[number - 1].replace(b'"5"', b'"6"')})

    assert len(here.replay("--check", code=1)) == 3, "the version is the same"
    (version,) = re.findall(rb'"version":"[^"]*"', lines[0])
    here.spoil({1: lines[0].replace(version, b'"version":"0.0.1"')})
    said = here.replay("--check", code=1)

    assert said[0] == f"Run again: line {number} differs."
    assert '"text":"6"' in said[1]
    assert '"text":"5"' in said[2]
    assert said[3:] == [f"It was recorded with version 0.0.1; this is {__version__}."]


def test_a_missing_end_is_no_difference(here: Here) -> None:
    here.record("FW 2\nSPEAK 5")
    lines = (here.folder / "a.rec").read_bytes().splitlines(keepends=True)
    here.spoil({len(lines): None})

    done = here.donnie("replay", "a.rec", "--check")
    assert (done.returncode, done.out) == (
        0,
        [f"Run again: the same up to line {len(lines)}, where it was stopped."],
    )


@pytest.mark.parametrize("length", [0, 1])
def test_an_event_is_shown_up_to_a_hundred_and_sixty_characters(here: Here, length: int) -> None:
    here.record('SPEAK "x"')
    lines = (here.folder / "a.rec").read_bytes().splitlines(keepends=True)
    number = next(number for number, line in enumerate(lines, 1) if b'"spoke"' in line)
    line = lines[number - 1].decode()
    filled = line.replace('"x"', f'"{"y" * (161 - len(line.strip()) + length)}"')
    here.spoil({number: filled.encode()})

    shown = here.replay("--check", code=1)[1].removeprefix("Then: ")
    assert shown == (f"{filled[:159]}…" if length else filled.strip())


def test_a_recording_of_nothing_and_one_of_a_real_robot_are_not_run_again(here: Here) -> None:
    here.record("SPEAK 1")
    header, *_ = (here.folder / "a.rec").read_bytes().splitlines(keepends=True)
    (here.folder / "a.rec").write_bytes(header)
    assert here.replay("--check") == ["Run again: 0 events are the same."]
    (here.folder / "a.rec").write_bytes(header.replace(b'"robot":"sim"', b'"robot":"serial:x"'))
    real = "It was made with the robot serial:x and can't be run again."
    assert here.replay("--check", code=2, err=[real]) == []


def test_a_stopped_run_is_compared_up_to_the_stop(here: Here) -> None:
    (here.folder / "a.gd").write_text("FW 3 SPEAK 1 FW 1000")
    running = start(here.folder, "run", "a.gd", *QUIET, "--speed", "50", "--record", "a.rec")
    assert running.stdout is not None
    while running.stdout.readline() != b"1\n":
        pass
    running.send_signal(signal.SIGTERM)
    running.communicate(timeout=TIMEOUT)

    said = here.replay("--check")

    assert said[0].endswith("where it was stopped.")


def test_typed_lines_are_recorded_and_run_again_too(here: Here) -> None:
    typed = "VAR a = 2\nFW a\n\nSPEAK a\nRUN\nRESET\nONDE\nFW 1\nRUN\n"
    donnie(here.folder, "--linear", *QUIET, "--speed", "max", "--record", "a.rec", typed=typed)

    assert here.replay("--check")[0].endswith("events are the same.")
    assert "2" in here.replay()
