"""``donnie replay``: a recording tells the run again, both ways; running it again gives the same events."""

from __future__ import annotations

import io
import json
import os
import random
import signal
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import pytest

import worlds
from donnie_tui.cli.main import main
from donnie_tui.cli.replay_map import ReplayMap
from donnie_tui.core.recording import NoRecordingError, Recording
from donnie_tui.core.retelling import told_back, told_forward
from donnie_tui.core.timeline import Timeline
from donnie_tui.core.transcript import told_lines
from donnie_tui.i18n.words import Words
from sim.worldfile import load_world
from tests.patience import PATIENCE
from tests.sessions.command import QUIET, donnie, start

PROGRAM = """VAR n = 2
REPEAT n TIMES
FW n TR 90
END REPEAT
SPEAK "olá"
STATE
SCAN
WAIT 1
SPEAK DISTANCE F
"""


@dataclass(slots=True)
class Done:
    returncode: int
    out: list[str]
    err: list[str]


class Here:
    """A folder in which commands run in this process, which is faster than in one of their own."""

    def __init__(
        self, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, folder: Path
    ) -> None:
        self._capsys, self._monkeypatch, self.folder = capsys, monkeypatch, folder

    def donnie(self, *arguments: str, typed: str = "") -> Done:
        self._monkeypatch.setattr(sys, "stdin", io.StringIO(typed))
        code = main([*arguments, *QUIET])
        out, err = self._capsys.readouterr()
        return Done(code, out.splitlines(), err.splitlines())

    def record(self, program: str = PROGRAM, *more: str, code: int = 0) -> list[str]:
        """Record a run into ``a.rec``; what it printed."""
        (self.folder / "a.gd").write_text(program, encoding="utf-8")
        done = self.donnie("run", "a.gd", "--record", "a.rec", *more)
        assert (done.returncode, done.err) == (code, [])
        return done.out

    def replay(self, *arguments: str, typed: str = "", code: int = 0, err: Sequence[str] = ()) -> list[str]:
        done = self.donnie("replay", "a.rec", *arguments, typed=typed)
        assert (done.returncode, done.err) == (code, [*err])
        return done.out

    def spoil(self, change: dict[int, bytes | None]) -> None:
        """Other bytes for some lines (from 1) of the recording, none for None."""
        lines = (self.folder / "a.rec").read_bytes().splitlines(keepends=True)
        kept = [change.get(number, line) for number, line in enumerate(lines, 1)]
        (self.folder / "a.rec").write_bytes(b"".join(line for line in kept if line is not None))


@pytest.fixture
def here(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Here:
    for name in [each for each in os.environ if each.startswith(("DONNIE_", "LC_", "LANG"))]:
        monkeypatch.delenv(name)
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path / "config"))
    monkeypatch.chdir(tmp_path)
    return Here(capsys, monkeypatch, tmp_path)


# --- telling


def test_a_replay_prints_what_the_run_printed(here: Here) -> None:
    printed = here.record()

    assert here.replay() == printed


def test_backwards_each_step_is_told_with_the_place_that_it_leads_to(here: Here) -> None:
    here.record("FW 2\nTR 90\nFW 3")

    assert here.replay("--backwards") == [
        "Back: end of the program. Position 3, 2.",
        "Back: FW 3. Position 0, 2.",
        "Back: TR 90. Facing north.",
        "Back: FW 2. Position 0, 0.",
        "Back: start of a.gd.",
    ]


def test_a_replay_may_begin_in_the_middle(here: Here) -> None:
    here.record("SPEAK 1\nSPEAK 2\nSPEAK 3")

    assert here.replay("--from", "3") == ["2", "3"]
    assert here.replay("--from", "3", "--backwards") == ["Back: 2.", "Back: 1.", "Back: start of a.gd."]


def test_step_by_step_one_goes_both_ways_by_typed_words(here: Here) -> None:
    here.record("FW 2\nTR 90")

    typed = "\nNEXT\nPRÓXIMO\nback\nDÓNDE\nMAP\nnonsense\nGO\nNEXT\nQUIT\n"
    told = here.replay("--step", typed=typed)

    assert told[1:6] == [
        "Start of a.gd.",
        "I walked 2 steps forward.",
        "I turned 90 degrees to the right.",
        "Back: TR 90. Facing north.",
        "Event 5 of 18.",
    ]
    assert told[6] == "Position 0, 2. Facing north."
    assert any("^" in line for line in told[7:])
    assert told[-4:] == [
        "I do not know that word. HELP lists them.",
        "I turned 90 degrees to the right.",
        "This is the end.",
        "This is the end.",
    ]


def test_the_map_is_drawn_as_it_goes(here: Here) -> None:
    here.record("FW 2\nTR 90", "--world", "living_room")

    told = here.replay("--map")

    assert sum("^" in line for line in told) == 1
    assert sum(">" in line for line in told) == 1


def rows_of_things(lines: Sequence[str]) -> list[tuple[int, int]]:
    """How far the cone is north of the robot on each map, in rows and columns."""
    maps, found = "\n".join(lines), []
    for rows in (each.splitlines() for each in maps.split("I walked ")[1:]):
        robot = next((y, row.index("^")) for y, row in enumerate(rows) if "^" in row)
        cones = [(robot[0] - y, row.index("c") - robot[1]) for y, row in enumerate(rows) if "c" in row]
        found.append(min(each for each in cones if each[0] > 0))
    return found


def test_the_map_shows_pushed_things_where_the_step_left_them_in_every_run(here: Here) -> None:
    typed = "FW 20\n\nRESET\nFW 20\n\nRESET\nFW 20\n\n"
    world = ("--world", "object_field")
    donnie(here.folder, "--linear", *QUIET, *world, "--speed", "max", "--record", "a.rec", typed=typed)

    told = here.replay("--map")

    before_it = [each[0] for each in rows_of_things(told)]
    assert len(before_it) == 3
    assert set(before_it) <= {2, 3}
    assert len(set(before_it)) == 1
    assert here.replay("--check")[0].endswith("events alike.")


def record_two(here: Here) -> None:
    (here.folder / "a.gd").write_text("FW 20")
    (here.folder / "b.gd").write_text("WAIT 30 TR 90 FW 2 WAIT 1 FW 1")
    here.donnie("run", "alice=a.gd", "bob=b.gd", "--world", "two_robots", "--record", "a.rec")


def test_the_map_is_that_of_the_robot_that_moved_with_the_others_where_they_are(here: Here) -> None:
    record_two(here)

    told = here.replay("--map", "--speed", "max")

    titles = [line for line in told if line.startswith("Map of ")]
    assert titles == ["Map of alice.", *["Map of bob."] * 3]
    last = told[len(told) - told[::-1].index("Map of bob.") :]
    assert sum("<ooA" in row for row in last) == 1, "bob with its trail"
    (alice,) = (y for y, row in enumerate(last) if "^" in row)
    (bob,) = (y for y, row in enumerate(last) if "<" in row)
    assert alice - bob == 10
    assert not any("r" in row.lower() for row in last), "neither stands at its start"


def test_the_map_of_a_step_is_that_of_the_robot_that_is_told_of(here: Here) -> None:
    record_two(here)

    told = here.replay("--step", typed="END\nMAP\nSTART\nMAP\n")

    assert "Map of bob." in told
    assert told[-1] == "There is no map here."


def test_a_name_in_a_recording_makes_no_line_of_its_own(here: Here) -> None:
    """Nobody trusts a recording: a name with a line's end could say whatever it likes."""
    record_two(here)
    recorded = (here.folder / "a.rec").read_text(encoding="utf-8")
    (here.folder / "a.rec").write_text(recorded.replace('"alice"', '"al\\nice"'), encoding="utf-8")

    told = here.replay("--step", typed="END\nWHERE\n")

    assert [line for line in told if "Position" in line and "ice" in line][-1].startswith("al ice: Position")


def test_a_replay_at_a_speed_keeps_the_order_and_stops_at_a_signal(here: Here) -> None:
    here.record('SPEAK "begun" WAIT 1000')
    running = start(here.folder, "replay", "a.rec", *QUIET, "--speed", "1")
    assert running.stdout is not None
    assert running.stdout.readline() == b"begun\n"

    running.send_signal(signal.SIGINT)

    running.communicate(timeout=PATIENCE)
    assert running.returncode == 130


def test_a_replay_writes_the_events_of_the_run(here: Here) -> None:
    (here.folder / "a.gd").write_text(PROGRAM, encoding="utf-8")
    run = here.donnie("run", "a.gd", "--record", "a.rec", "--events", "-")

    assert here.replay("--events", "-") == run.out
    told = here.replay("--events", "b.jsonl")
    assert "olá" in told
    assert (here.folder / "b.jsonl").read_text(encoding="utf-8").splitlines() == run.out


@pytest.mark.parametrize(
    "option", ["--world=maze", "--robot=double", "--seed=3", "--belt=/dev/null", "--record=b.rec"]
)
def test_an_option_that_can_do_nothing_is_refused(here: Here, option: str) -> None:
    here.record("SPEAK 1")

    name = option.partition("=")[0]
    sentence = f"A replay tells what has happened: {name} does nothing here."
    assert here.replay(option, code=2, err=[sentence]) == []
    assert not (here.folder / "b.rec").exists()


@pytest.mark.parametrize(
    "options",
    [
        ("--check", "--map"),
        ("--check", "--step"),
        ("--check", "--backwards"),
        ("--check", "--speed", "2"),
        ("--check", "--from", "2"),
        ("--check", "--events", "b.jsonl"),
        ("--step", "--events", "-"),
        ("--backwards", "--events", "-"),
    ],
    ids=" ".join,
)
def test_two_ways_at_once_are_refused(here: Here, options: tuple[str, ...]) -> None:
    here.record("SPEAK 1")

    assert here.replay(*options, code=2, err=[f"{options[1]} and {options[0]} do not go together."]) == []


def test_a_replay_never_writes_onto_what_it_reads(here: Here) -> None:
    here.record("SPEAK 1")

    here.replay(
        "--events",
        "a.rec",
        code=2,
        err=["--events would overwrite a.rec, which is read here. Give another name."],
    )


def test_a_recording_of_a_newer_format_is_told_as_far_as_it_is_known(here: Here) -> None:
    here.record("SPEAK 1")
    first = (here.folder / "a.rec").read_bytes().splitlines(keepends=True)[0]
    here.spoil({1: first.replace(b'"donnie_recording":1', b'"donnie_recording":2')})
    newer = "This recording is of a newer Donnie: there is no map, and some of it may be missing."

    assert here.replay(err=[newer]) == ["1"]


# --- running it again


@pytest.mark.parametrize("world", ["open_floor", "living_room", "two_robots"])
def test_running_it_again_gives_the_same_events(here: Here, world: str) -> None:
    here.record(PROGRAM, "--world", world, "--lang", "pt")

    assert here.replay("--check")[0].startswith("Run again: ")
    assert here.replay("--check")[0].endswith("events alike.")


def test_several_robots_are_run_again_together(here: Here) -> None:
    (here.folder / "a.gd").write_text(PROGRAM)
    (here.folder / "b.gd").write_text("WAIT 1 FW 20 SPEAK 1 / 0")
    done = here.donnie("run", "alice=a.gd", "bob=b.gd", "--world", "two_robots", "--record", "a.rec")

    assert done.returncode == 1
    assert here.replay("--check")[0].endswith("events alike.")
    assert here.replay() == done.out


@pytest.mark.parametrize("world", ["object_field", "cave"])
def test_a_recording_has_each_file_of_its_world_once(here: Here, world: str) -> None:
    here.record("SPEAK 1", "--world", world)

    header = json.loads((here.folder / "a.rec").read_text(encoding="utf-8").splitlines()[0])
    contents = [json.dumps({**each, "name": ""}) for each in header["world"]["files"]]
    assert len(contents) > 1
    assert len(contents) == len(set(contents))
    assert here.replay("--check")[0].endswith("events alike.")


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

    assert here.replay("--check")[0].endswith("events alike.")


def test_the_first_event_that_differs_is_told(here: Here) -> None:
    here.record("FW 2\nSPEAK 5")
    lines = (here.folder / "a.rec").read_bytes().splitlines(keepends=True)
    number = next(number for number, line in enumerate(lines, 1) if b'"spoke"' in line)
    here.spoil({number: lines[number - 1].replace(b'"5"', b'"6"')})

    told = here.replay("--check", code=1)

    assert told[0] == f"Run again: line {number} differs."
    assert '"text":"6"' in told[1]
    assert '"text":"5"' in told[2]


def test_what_somebody_stopped_is_compared_up_to_there(here: Here) -> None:
    (here.folder / "a.gd").write_text("FW 3 SPEAK 1 FW 1000")
    running = start(here.folder, "run", "a.gd", *QUIET, "--speed", "50", "--record", "a.rec")
    assert running.stdout is not None
    while running.stdout.readline() != b"1\n":
        pass
    running.send_signal(signal.SIGTERM)
    running.communicate(timeout=PATIENCE)

    told = here.replay("--check")

    assert told[0].endswith("where it was stopped.")


def test_typed_lines_are_recorded_and_run_again_too(here: Here) -> None:
    typed = "VAR a = 2\nFW a\n\nSPEAK a\nRUN\nRESET\nONDE\nFW 1\nRUN\n"
    donnie(here.folder, "--linear", *QUIET, "--speed", "max", "--record", "a.rec", typed=typed)

    assert here.replay("--check")[0].endswith("events alike.")
    assert "2" in here.replay()


# --- damage


def test_a_damaged_line_is_told_and_the_rest_is_replayed(here: Here) -> None:
    here.record("SPEAK 1\nSPEAK 2\nSPEAK 3")
    here.spoil({4: b'{"seq":3,"t":0,"eve\n'})

    assert here.replay(err=["Line 4 is damaged. The rest is told."]) == ["1", "3"]


def test_a_line_that_is_gone_is_missed(here: Here) -> None:
    here.record("SPEAK 1\nSPEAK 2\nSPEAK 3")
    here.spoil({4: None})

    assert here.replay(err=["Before line 4, 1 event is missing."]) == ["1", "3"]


def test_without_its_beginning_a_recording_is_told_all_the_same(here: Here) -> None:
    here.record("SPEAK 1")
    here.spoil({1: b"\xff\xfe{nonsense\n"})
    damage = "Line 1, the beginning, is damaged: there is no map."

    assert here.replay("--map", err=[damage]) == ["1"]
    here.replay("--check", code=2, err=[damage, "The recording is damaged and can't be run again."])


def test_a_recording_cut_anywhere_has_all_that_is_whole(here: Here) -> None:
    here.record("SPEAK 1\nSPEAK 2")
    whole = (here.folder / "a.rec").read_bytes()
    first_event = whole.index(b"\n") + 1
    lines = whole[first_event:].splitlines(keepends=True)

    for length in range(first_event, len(whole)):
        recording = Recording(io.BytesIO(whole[:length]))
        cut = whole[first_event:length]
        rest = cut.rpartition(b"\n")[2]
        is_whole = rest in (line.rstrip(b"\n") for line in lines)
        assert len(recording.events) == cut.count(b"\n") + is_whole
        if 0 < len(recording.events) < len(lines):
            first_missing = len(recording.events) + 2
            assert [(each.code, each.line) for each in recording.damages] == [("end", first_missing)]
        elif len(recording.events) == len(lines) or not rest:
            assert recording.damages == []


def test_a_killed_run_is_told_as_far_as_it_was_recorded_and_that_its_end_is_missing(here: Here) -> None:
    (here.folder / "a.gd").write_text("FW 3 SPEAK 1 WAIT 1000")
    running = start(here.folder, "run", "a.gd", *QUIET, "--speed", "50", "--record", "a.rec")
    assert running.stdout is not None
    while running.stdout.readline() != b"1\n":
        pass
    running.kill()
    running.communicate(timeout=PATIENCE)

    lines = (here.folder / "a.rec").read_bytes().count(b"\n")
    missing = f"The end of the recording is missing, from line {lines + 1} on."
    assert here.replay(err=[missing])[:2] == ["I walked 3 steps forward.", "1"]
    assert here.replay("--backwards", err=[missing])[-1] == "Back: start of a.gd."
    assert here.replay("--check", err=[missing])[0].endswith("where it was stopped.")


def test_a_session_in_which_nothing_runs_any_more_lacks_no_end(here: Here) -> None:
    typed = "FW 1\n\nRESET\nFW 1\n\nRESET\n"
    donnie(here.folder, "--linear", *QUIET, "--speed", "max", "--record", "a.rec", typed=typed)
    with (here.folder / "a.rec").open("rb") as file:
        assert Recording(file).damages == []


@pytest.mark.parametrize(
    "content",
    [b"", b"FW 3\n", b"\x00" * 1000, b"{}\n", b"[" * 200_000, b'{"donnie_recording":1}\n', b'{"a":' * 90_000],
    ids=["nothing", "a program", "zeros", "an object", "deep", "a bare header", "deep objects"],
)
def test_what_is_no_recording_is_refused(content: bytes) -> None:
    with pytest.raises(NoRecordingError):
        Recording(io.BytesIO(content))


def test_what_is_no_recording_is_told_in_one_sentence(here: Here) -> None:
    (here.folder / "a.rec").write_bytes(b"FW 3\n")

    assert here.replay(code=2, err=["a.rec is no recording."]) == []


def test_whatever_is_damaged_the_rest_is_told_both_ways_and_drawn(here: Here) -> None:
    here.record("FW 20\nTR 90\nFW 2\nSCAN", "--world", "object_field")
    whole = (here.folder / "a.rec").read_bytes()
    first_event = whole.index(b"\n") + 1
    rnd = random.Random(7)
    words = Words()
    scene = load_world(worlds.path("object_field"), allowed=(worlds.SCENES,))
    floor = ReplayMap(scene, words)

    for _ in range(60):
        damaged = bytearray(whole)
        for _ in range(rnd.choice((1, 2, 20))):
            at = rnd.randrange(first_event, len(damaged))
            damaged[at : at + rnd.choice((0, 1, 1, 1, 90))] = rnd.choice(
                (b"9", b"-", b"e", b"\xff", b"{", b"")
            )
        timeline = Timeline(Recording(io.BytesIO(bytes(damaged))).events)
        while step := timeline.step():
            assert told_forward(step, words) or any(told_lines(each, words) for each in step)
        for robot in timeline.robots:
            floor.lines(timeline, robot)
        while undone := timeline.step_back():
            assert told_back(undone, timeline, words)


def test_what_is_no_ordinary_file_or_has_no_reasonable_size_is_refused(here: Here) -> None:
    os.mkfifo(here.folder / "a.rec")
    here.replay(code=2, err=["a.rec is no ordinary file."])
    (here.folder / "a.rec").unlink()
    with (here.folder / "a.rec").open("wb") as file:
        file.truncate(5 * 1024**3)
    here.replay(code=2, err=["a.rec is too large for a recording."])


def test_a_recording_that_an_editor_saved_again_is_whole(here: Here) -> None:
    printed = here.record()
    data = (here.folder / "a.rec").read_bytes()
    (here.folder / "a.rec").write_bytes(b"\xef\xbb\xbf" + data.replace(b"\n", b"\r\n"))

    assert here.replay() == printed
    assert here.replay("--check")[0].endswith("events alike.")


@pytest.mark.parametrize(
    "name", ["0/../../evil", "/etc/evil", "0//../evil", "evil", "0/a\\..\\evil", "00x/evil"]
)
def test_a_recording_writes_nowhere_else(here: Here, name: str) -> None:
    here.record("SPEAK 1")
    lines = (here.folder / "a.rec").read_text(encoding="utf-8").splitlines(keepends=True)
    header = json.loads(lines[0])
    header["world"]["files"].append({"name": name, "text": "evil"})
    (here.folder / "a.rec").write_text(json.dumps(header) + "\n" + "".join(lines[1:]), encoding="utf-8")

    here.replay("--check", code=2, err=["The world in the recording is damaged."])
    assert not (here.folder.parent / "evil").exists()


def test_a_full_disk_ends_the_recording_and_not_the_run(here: Here) -> None:
    if not Path("/dev/full").exists():
        pytest.skip("needs a device that is always full")
    (here.folder / "a.gd").write_text("SPEAK 1")

    done = here.donnie("run", "a.gd", "--record", "/dev/full")

    assert done.returncode == 2
    assert done.err == ["I can't write /dev/full: No space left on device."]


def test_no_such_event_or_file_is_one_sentence(here: Here) -> None:
    here.record("SPEAK 1")

    here.replay("--from", "0", code=2, err=["There is no event 0. The last one is 4."])
    assert here.donnie("replay", "b.rec").err[0].startswith("I can't read b.rec: ")
