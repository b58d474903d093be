"""Damaged, cut, foreign or malicious recordings: the rest is replayed, and no other file is written."""

from __future__ import annotations

import io
import json
import os
import random
from pathlib import Path

import pytest

import worlds
from donnie_tui.cli.replay import ReplayMap
from donnie_tui.core.recording import NoRecordingError, Recording
from donnie_tui.core.timeline import Timeline, redone_in_words, undone_in_words
from donnie_tui.core.transcript import printed_lines
from donnie_tui.i18n.words import Words
from sim.worldfile import load_world
from tests.sessions.command import QUIET, donnie, start
from tests.sessions.here import Here
from tests.timeouts import TIMEOUT


def test_a_damaged_line_is_reported_and_the_rest_is_replayed(here: Here) -> None:
    here.record("SPEAK 1\nSPEAK 2\nSPEAK 3")
    here.spoil({4: b'{"seq":3,"t":0,"eve\n'})

    assert here.replay(err=["Line 4 is damaged. The rest is shown."]) == ["1", "3"]


def test_a_missing_line_is_reported(here: Here) -> None:
    here.record("SPEAK 1\nSPEAK 2\nSPEAK 3")
    here.spoil({4: None})

    assert here.replay(err=["Before line 4, 1 event is missing."]) == ["1", "3"]


def test_a_recording_without_its_beginning_is_replayed_anyway(here: Here) -> None:
    here.record("SPEAK 1")
    here.spoil({1: b"\xff\xfe{nonsense\n"})
    damage = "Line 1, the beginning, is damaged: there is no map."

    assert here.replay("--map", err=[damage]) == ["1"]
    here.replay("--check", code=2, err=[damage, "The recording is damaged and can't be run again."])


def test_a_recording_with_more_events_than_allowed_is_read_up_to_there(
    here: Here, monkeypatch: pytest.MonkeyPatch
) -> None:
    here.record("SPEAK 1\nSPEAK 2\nSPEAK 3")
    monkeypatch.setattr("donnie_tui.core.recording.MOST_EVENTS", 2)
    content = (here.folder / "a.rec").read_bytes()

    recording = Recording(io.BytesIO(content))

    assert len(recording.events) == 2
    assert "too-many" in [each.code for each in recording.damages]


def test_a_recording_cut_anywhere_keeps_every_whole_line(here: Here) -> None:
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


def test_a_killed_run_is_replayed_to_its_last_event_and_its_missing_end_is_reported(here: Here) -> None:
    (here.folder / "a.gd").write_text("FW 3 SPEAK 1 WAIT 1000")
    running = start(here.folder, "run", "a.gd", *QUIET, "--speed", "50", "--record", "a.rec")
    assert running.stdout is not None
    while running.stdout.readline() != b"1\n":
        pass
    running.kill()
    running.communicate(timeout=TIMEOUT)

    lines = (here.folder / "a.rec").read_bytes().count(b"\n")
    missing = f"The end of the recording is missing, from line {lines + 1} on."
    assert here.replay(err=[missing])[:2] == ["I walked 3 steps forward.", "1"]
    assert here.replay("--backwards", err=[missing])[-1] == "Back: start of a.gd."
    assert here.replay("--check", err=[missing])[0].endswith("where it was stopped.")


def test_a_session_without_a_running_program_has_no_missing_end(here: Here) -> None:
    typed = "FW 1\n\nRESET\nFW 1\n\nRESET\n"
    donnie(here.folder, "--linear", *QUIET, "--speed", "max", "--record", "a.rec", typed=typed)
    with (here.folder / "a.rec").open("rb") as file:
        assert Recording(file).damages == []


@pytest.mark.parametrize(
    "content",
    [b"", b"FW 3\n", b"\x00" * 1000, b"{}\n", b"[" * 200_000, b'{"donnie_recording":1}\n', b'{"a":' * 90_000],
    ids=["nothing", "a program", "zeros", "an object", "deep", "a bare header", "deep objects"],
)
def test_a_file_that_is_no_recording_is_refused(content: bytes) -> None:
    with pytest.raises(NoRecordingError):
        Recording(io.BytesIO(content))


def test_a_text_of_escapes_without_an_end_is_looked_through_once() -> None:
    line = b'{"seq":1,"t":0,"event":"spoke","text":"' + b'\\"' * 1_000_000
    with pytest.raises(NoRecordingError):
        Recording(io.BytesIO(line + b"\n"))


def test_a_file_that_is_no_recording_is_reported_in_one_sentence(here: Here) -> None:
    (here.folder / "a.rec").write_bytes(b"FW 3\n")

    assert here.replay(code=2, err=["a.rec is not a recording. The option --record makes one."]) == []


def test_the_rest_of_any_damaged_recording_is_replayed_both_ways_and_drawn(here: Here) -> None:
    here.record("FW 20\nTR 90\nFW 2\nSCAN", "--world", "object_field")
    whole = (here.folder / "a.rec").read_bytes()
    first_event = whole.index(b"\n") + 1
    rnd = random.Random(7)
    words = Words()
    scene = load_world(Path(worlds.path("object_field")), allowed=(Path(worlds.SCENES),))
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
            assert redone_in_words(step, words) or any(printed_lines(each, words) for each in step)
        for robot in timeline.robots:
            floor.lines(timeline, robot)
        while undone := timeline.step_back():
            assert undone_in_words(undone, timeline, words)


def test_a_special_or_huge_file_is_refused(here: Here) -> None:
    os.mkfifo(here.folder / "a.rec")
    here.replay(code=2, err=["a.rec is not an ordinary file."])
    (here.folder / "a.rec").unlink()
    with (here.folder / "a.rec").open("wb") as file:
        file.truncate(5 * 1024**3)
    here.replay(code=2, err=["a.rec is too large for a recording, at most 4 gigabytes."])


def test_a_recording_saved_again_by_an_editor_is_whole(here: Here) -> None:
    printed = here.record()
    data = (here.folder / "a.rec").read_bytes()
    (here.folder / "a.rec").write_bytes(b"\xef\xbb\xbf" + data.replace(b"\n", b"\r\n"))

    assert here.replay() == printed
    assert here.replay("--check")[0].endswith("events are the same.")


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
    assert done.err == ["I can't write /dev/full: the disk is full."]


def test_no_such_event_or_file_is_one_sentence(here: Here) -> None:
    here.record("SPEAK 1")

    here.replay("--from", "0", code=2, err=["There is no event 0. The last one is 4."])
    assert here.donnie("replay", "b.rec").err[0].startswith("I can't read b.rec: ")
