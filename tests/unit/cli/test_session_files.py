"""The files that a session writes as it goes."""

from __future__ import annotations

import json
import os
import re
import wave
from array import array
from collections.abc import Callable
from contextlib import ExitStack
from io import StringIO
from pathlib import Path
from typing import BinaryIO

import pytest

from devices.ports.audio import Cue
from devices.ports.robot import Bearing, Pose
from donnie_tui import __version__
from donnie_tui.cli.streams import Guarded, Output, is_terminal
from donnie_tui.core import transcript
from donnie_tui.core.belt import BeltSettings
from donnie_tui.core.chart import braille
from donnie_tui.core.events import (
    CueSounded,
    HowStarted,
    Outcome,
    RunEnded,
    RunStarted,
    Spoke,
    Stamped,
)
from donnie_tui.core.hub import Hub
from donnie_tui.core.reports import as_html
from donnie_tui.core.session import RunOptions
from donnie_tui.core.transcript import printed_lines
from donnie_tui.i18n.words import Unusable, Words
from donnie_tui.outlets import files
from donnie_tui.outlets.files import (
    SessionFiles,
    SoundFile,
    heading_of_answer,
    is_named_pipe,
    may_be_replaced,
)
from donnie_tui.settings.settings import Settings
from donnie_tui.world.loading import inhabited_world
from language.locales import languages
from tests.floor import Floor
from tests.timeouts import TIMEOUT

FULL = Path("/dev/full")


@pytest.mark.skipif(not FULL.exists(), reason="needs a device that is always full")
def test_a_full_log_is_reported_once_and_counts_as_lost(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(transcript, "next_log", lambda folder: FULL)
    hub, words, said = Hub(lambda: 0.0), Words(), list[str]()
    hub.subscribe(lambda stamped: said.extend(printed_lines(stamped, words)))
    with ExitStack() as closing:
        written = SessionFiles(Settings(log=True), hub, words, closing)
        written.log()
        hub.publish(Spoke("a"))
        hub.publish(Spoke("b"))

    assert said == ["a", "I can't write /dev/full: the disk is full.", "b"]
    assert written.lost == ["/dev/full"]


@pytest.mark.parametrize("files", [{"record": "a"}, {"events": "a"}, {"sound": "a"}])
def test_another_session_would_overwrite_a_file_of_this_session(files: dict[str, str]) -> None:
    with ExitStack() as closing:
        assert SessionFiles(Settings(**files), Hub(lambda: 0.0), Words(), closing).of_this_session == "a"


def test_cues_of_a_run_are_written_into_a_file_the_same_every_time(tmp_path: Path) -> None:
    """The file has the same bytes after each run."""

    def bytes_of(name: str) -> bytes:
        floor, path = Floor(), tmp_path / name
        with ExitStack() as closing:
            SessionFiles(Settings(sound=str(path)), floor.session.hub, Words(), closing).sounds()
            assert floor.session.start("FW 3 TR 90", "a.gd", RunOptions(fresh=True)).wait(TIMEOUT)
        return path.read_bytes()

    first = bytes_of("a.wav")
    assert first == bytes_of("b.wav")
    assert len(first) > 4 * 22_050 * 5  # three steps and a right angle: five seconds, in stereo


def test_a_sound_file_that_can_not_be_written_prevents_the_start(tmp_path: Path) -> None:
    wrong = str(tmp_path / "none" / "a.wav")
    with ExitStack() as closing, pytest.raises(Unusable):
        SessionFiles(Settings(sound=wrong), Floor().session.hub, Words(), closing).sounds()


def loud_seconds(path: Path) -> list[float]:
    """At which tenths of seconds something sounds."""
    with wave.open(str(path)) as file:
        tenth = file.getframerate() // 10
        chunks = [array("h", file.readframes(tenth)) for _ in range(file.getnframes() // tenth)]
    return [number / 10 for number, chunk in enumerate(chunks) if max(chunk) > 1_000]


def test_a_second_run_sounds_after_the_first_and_sound_off_writes_nothing(
    tmp_path: Path,
) -> None:
    floor, path = Floor(), tmp_path / "a.wav"
    with ExitStack() as closing:
        SessionFiles(Settings(sound=str(path)), floor.session.hub, Words(), closing).sounds()
        for program in ("FW 1 WAIT 4", "SOUND OFF FW 1 WAIT 4", "SOUND ON FW 1 WAIT 4"):
            assert floor.session.start(program, "a.gd", RunOptions(fresh=True)).wait(TIMEOUT)

    heard = {int(each) for each in loud_seconds(path)}
    assert heard == {1, 5, 11, 15}  # a step and an end; nothing; a step and an end


class FailingCues:
    """A WAV file that can't be written at some time."""

    def __init__(self, *failing: str) -> None:
        self._failing = failing
        self.added: list[tuple[str, float]] = []

    def _do(self, name: str) -> None:
        if name in self._failing:
            raise OSError(28, "No space left on device")

    def add(self, cue: Cue, at: float) -> None:
        self.added.append((cue.name, at))
        self._do("add")

    def write_until(self, at: float) -> None:
        self._do("write")

    def close(self) -> None:
        self._do("close")


@pytest.mark.parametrize(
    ("failing", "added", "failures"),
    [
        ([], [("bump", 1.0), ("scan", 5.5)], 0),
        (["add", "close"], [("bump", 1.0)], 1),
        (["write"], [("bump", 1.0)], 1),
        (["close"], [("bump", 1.0), ("scan", 5.5)], 1),
    ],
)
def test_a_sound_file_that_fails_takes_no_more_cues_and_is_reported_once(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    failing: list[str],
    added: list[tuple[str, float]],
    failures: int,
) -> None:
    cues = FailingCues(*failing)
    monkeypatch.setattr("devices.audio.mixer.WavCueWriter", lambda out: out.close() or cues)
    problems = list[OSError]()
    sounds = SoundFile(str(tmp_path / "a.wav"), problems.append)
    ended = RunEnded(Outcome.COMPLETED, Pose(0, 0, 0), {}, 4.0)
    for at, event in ((1.0, CueSounded("bump", 0.0, None)), (4.0, ended), (1.5, CueSounded("scan", 0.0, 3))):
        sounds(Stamped(1, at, event))
    sounds.close()

    assert cues.added == added
    assert [str(each) for each in problems] == ["[Errno 28] No space left on device"] * failures


@pytest.mark.skipif(not FULL.exists(), reason="needs a device that is always full")
@pytest.mark.parametrize("name", ["record", "events", "sound"])
def test_a_full_file_is_reported_once_and_counts_as_lost(name: str) -> None:
    """A recording says so before the session begins: its first line is how it was made."""
    floor = Floor()
    hub, words = floor.session.hub, Words()
    closing = ExitStack()
    written = SessionFiles(Settings(**{name: str(FULL)}), hub, words, closing)
    sentence = "I can't write /dev/full: the disk is full."
    if name == "record":
        with pytest.raises(Unusable, match=re.escape(sentence)):
            written.recording(inhabited_world("corridor", words))
        assert written.paths == [str(FULL)]
        return

    written.events(None)
    written.sounds()
    assert written.paths == [str(FULL)]
    hub.publish(Spoke("a"))
    hub.publish(CueSounded("bump", 0.0, None))
    closing.close()
    assert floor.printed == ["a", sentence]
    assert written.lost == [str(FULL)]


def test_what_is_not_asked_for_is_not_written(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    hub, out = Hub(lambda: 0.0), StringIO()
    with ExitStack() as closing:
        written = SessionFiles(Settings(), hub, Words(), closing)
        written.events(out)
        written.recording(inhabited_world("corridor", Words()))
        written.sounds()
        written.log()
        hub.publish(Spoke("a"))

    assert (out.getvalue(), written.paths, written.of_this_session) == ("", [], None)
    assert list(tmp_path.iterdir()) == []


def test_events_are_written_to_standard_output_which_a_prompt_has_not() -> None:
    hub, out = Hub(lambda: 0.0), StringIO()
    with ExitStack() as closing:
        written = SessionFiles(Settings(events="-"), hub, Words(), closing)
        with pytest.raises(Unusable, match="is for donnie run"):
            written.events(None)
        written.events(out)
        hub.publish(Spoke("a"))

        hub.publish(STARTED)

    said, started = map(json.loads, out.getvalue().splitlines())
    assert said["text"] == "a"
    assert "how" not in started  # only a recording can be run again
    assert written.paths == []


STARTED = RunStarted("p", "w", "sim", 0, "0", HowStarted("FW 1", 1, True, False, False, Pose(0, 0, 0)))


def test_a_named_pipe_is_written_by_a_slow_reader_until_the_end(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    did = list[str]()

    class Reader(StringIO):
        def __init__(self, number: int) -> None:
            super().__init__()
            assert number == opened.fileno()

        def write(self, text: str) -> int:
            did.append(json.loads(text)["text"])
            return len(text)

        def close(self) -> None:
            did.append("closed")

    here, there = os.pipe()
    monkeypatch.setattr(files, "SlowReader", Reader)
    with os.fdopen(here), os.fdopen(there, "w") as opened:
        monkeypatch.setattr(files, "open_text", lambda *_, **__: opened)
        hub = Hub(lambda: 0.0)
        with ExitStack() as closing:
            SessionFiles(Settings(events="a.pipe"), hub, Words(), closing).events(None)
            hub.publish(Spoke("a"))
        assert did == ["a", "closed"]
        assert opened.closed


def test_a_name_that_no_file_can_have_says_why() -> None:
    with ExitStack() as closing, pytest.raises(Unusable, match="embedded null byte"):
        SessionFiles(Settings(events="a\0b"), Hub(lambda: 0.0), Words(), closing).events(None)


def test_a_recording_begins_with_how_it_was_made(tmp_path: Path) -> None:
    """The belt's steps and columns, those of the settings in place of the original ones."""
    file = tmp_path / "a.rec"
    settings = Settings(record=str(file), seed=7, belt_steps=(1, 2, 3), belt_columns={Bearing.FRONT: (0, 6)})
    hub = Hub(lambda: 0.0)
    with ExitStack() as closing:
        SessionFiles(settings, hub, Words(), closing).recording(inhabited_world("corridor", Words()))
        hub.publish(Spoke("a\udc80"))
        hub.publish(STARTED)
    header, said, started = map(json.loads, file.read_text(encoding="utf-8").splitlines())

    assert [header[each] for each in ("version", "seed", "robot")] == [__version__, 7, "sim"]
    assert header["belt"]["steps"] == [1, 2, 3]
    assert header["belt"]["columns"] == {
        **{str(each.value): list(columns) for each, columns in BeltSettings().columns.items()},
        str(Bearing.FRONT.value): [0, 6],
    }
    assert header["world"]["name"] == "corridor"
    assert said["text"] == "a\udc80"
    assert started["how"]["text"] == "FW 1"


def test_a_folder_of_logs_that_can_not_be_made_prevents_the_start(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "Log").touch()
    with ExitStack() as closing, pytest.raises(Unusable, match="I can't write Log: "):
        SessionFiles(Settings(log=True), Hub(lambda: 0.0), Words(), closing).log()


def test_a_log_is_named_after_those_before(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    for _ in range(2):
        with ExitStack() as closing:
            hub = Hub(lambda: 0.0)
            written = SessionFiles(Settings(log=True), hub, Words(), closing)
            written.log()
            hub.publish(Spoke("olá"))

    assert written.paths == ["Log/log_002.txt"]
    assert (tmp_path / "Log" / "log_002.txt").read_text(encoding="utf-8") == "olá\n"


def test_only_a_pipe_that_was_opened_by_its_name_may_be_left_behind(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    here, there = os.pipe()
    with os.fdopen(here), os.fdopen(there, "w") as pipe, (tmp_path / "a").open("w") as file:
        assert is_named_pipe(pipe)
        assert not is_named_pipe(file)
        monkeypatch.setattr(files, "HIGHEST_STANDARD", there)
        assert not is_named_pipe(pipe)
        monkeypatch.setattr(files, "HIGHEST_STANDARD", there - 1)
        assert is_named_pipe(pipe)
    assert not is_named_pipe(pipe)  # it is closed
    assert is_named_pipe(StringIO()) is False


# --- the output of a command


class Failing(StringIO):
    """A stream whose every write fails so."""

    def __init__(self, problem: Exception) -> None:
        super().__init__()
        self._problem = problem

    def write(self, text: str) -> int:
        raise self._problem

    def flush(self) -> None:
        raise self._problem


@pytest.mark.parametrize(
    ("problem", "reason"),
    [
        (BrokenPipeError(32, "Broken pipe"), None),  # the reader just went away
        (OSError(28, "No space left on device"), "No space left on device"),
        (ValueError("closed"), "closed"),
    ],
)
def test_what_cannot_be_printed_ends_the_output_once(problem: Exception, reason: str | None) -> None:
    broken: list[bool] = []
    output = Output(Failing(problem), StringIO())
    output.on_broken = lambda: broken.append(True)
    guarded = Guarded(output)
    assert not guarded.closed
    output.line("one")
    output.text("two")

    assert (output.is_broken, output.problem, broken) == (True, reason, [True])
    assert guarded.closed
    assert guarded.write("three") == 5


def test_lines_and_complaints_are_printed_without_what_a_terminal_obeys() -> None:
    out, err = StringIO(), StringIO()
    output = Output(out, err)
    output.line("olá \x1b[2J")
    output.text("as it is\n")
    output.complaint("no \x07 file")
    output.finish()

    assert out.getvalue().startswith("olá ")
    assert "\x1b" not in out.getvalue()
    assert out.getvalue().endswith("\nas it is\n")
    assert err.getvalue().startswith("no ")
    assert err.getvalue().endswith(" file\n")
    assert "\x07" not in err.getvalue()


def test_a_complaint_that_cannot_be_printed_ends_nothing() -> None:
    output = Output(StringIO(), Failing(OSError(28, "full")))
    output.complaint("no file")
    output.finish()

    assert not output.is_broken


@pytest.mark.parametrize(("stream", "is_one"), [(None, False), (StringIO(), False)])
def test_no_stream_and_no_terminal_are_no_terminal(stream: object, is_one: bool) -> None:
    assert is_terminal(stream) is is_one
    closed = StringIO()
    closed.close()
    assert not is_terminal(closed)


@pytest.mark.parametrize(
    ("option", "name", "content", "may_be"),
    [
        ("--brf", "notes.brf", b"ABC DEF\r\n", False),
        ("--brf", "notes.brf", b" \r\n", True),
        ("--png", "photo.png", b"\x89PNG\r\n\x1a\n0000", False),
        ("--gif", "photo.gif", b"GIF89a0000", False),
        ("--png", "far.png", b"\x89PNG" + b"0" * 78 + b"tEXtSoftware\0donnie", False),
        ("--png", "ours.png", b"\x89PNG" + b"0" * 77 + b"tEXtSoftware\0donnie", True),
        ("--png", "text.png", b"tEXtSoftware\0donnie", False),
        ("--gif", "text.gif", b"\x06donnie\0", False),
        ("--gif", "ours.gif", b"GIF89a0000\x06donnie\0", True),
        ("--sound", "song.wav", b"RIFF0000WAVEfmt ", False),
        ("--record", "bom.rec", b'\xef\xbb\xbf\n {"donnie_recording":1', True),
        ("--record", "events.rec", b'{"seq":1', False),
        ("--report", "table.CSV", b"file,solved,score", True),
        ("--report", "table.html", b"file,solved,score", False),
        ("--csv", "table.csv", b"file;solved", False),
        ("--html", "page.html", b"<!doctype html>", False),
        ("--csv", "table.csv", b"file,solved,score", True),
        ("--csv", "table.csv", b"my file,solved,score", False),
        ("--events", "a.events", b'{"seq":1', True),
        ("--events", "a.rec", b'{"donnie_recording":1', False),
        ("--svg", "ours.svg", b'<svg xmlns="http://www.w3.org/2000/svg" role="img" width="9"', True),
        ("--swell", "ours.svg", b'\n<svg xmlns="http://www.w3.org/2000/svg" role="img" width="9"', True),
        ("--svg", "drawn.svg", b'<svg xmlns="http://www.w3.org/2000/svg" viewBox="', False),
        ("--swell", "drawn.svg", b'<?xml version="1.0"?><svg', False),
        ("--feedback", "a.txt", b"Donnie. A letter", False),
        ("--unknown", "a.txt", b"a", False),
        ("--unknown", "a.txt", b" \n", True),
    ],
)
def test_a_file_of_a_kind_is_replaced_only_if_donnie_may_have_written_it(
    tmp_path: Path, option: str, name: str, content: bytes, may_be: bool
) -> None:
    (tmp_path / name).write_bytes(content)

    assert may_be_replaced(option, tmp_path / name) is may_be


@pytest.mark.parametrize("language", languages())
def test_what_donnie_writes_may_be_replaced_in_each_language(tmp_path: Path, language: str) -> None:
    words = Words(language)
    page = as_html(words("report-title", what="room"), language, ())
    title = braille(words("paper-title", name="room"), language)
    answer = heading_of_answer("Reach the wall", words)
    for option, name, content, may_be in (
        ("--html", "a.html", page, True), ("--htm", "a.htm", page, True), ("--report", "a.HTML", page, True),
        ("--report", "a.txt", page, False), ("--html", "a.html", page[1:], False),
        ("--csv", "a.csv", words("report-column-seconds") + ",x", True),
        ("--csv", "a.csv", words("report-column-robot") + "," + words("report-column-seconds") + ",x", True),
        ("--feedback", "a.txt", answer, True), ("--feedback", "a.txt", answer[1:], False),
        ("--brf", "a.brf", title, True), ("--brf", "a.BRL", title, True), ("--brf", "a.txt", title, False),
        ("--brf", "a.brf", title + "~", False), ("--brf", "a.brf", title + "\r\n\f", True),
        ("--brf", "a.brf", title + " _", True), ("--brf", "a.brf", title + "`", False),
        ("--brf", "a.brf", title + "\x1f", False), ("--brf", "a.brf", title + "\t", False),
    ):  # fmt: skip
        (tmp_path / name).write_text(content, encoding="utf-8", newline="")
        assert may_be_replaced(option, tmp_path / name) is may_be, (option, name)


@pytest.mark.parametrize(
    ("channels", "rate", "width", "is_ours"),
    [(2, 22_050, 2, True), (1, 22_050, 2, False), (2, 44_100, 2, False)],
)
def test_only_sounds_in_the_format_of_donnies_may_be_replaced(
    tmp_path: Path, channels: int, rate: int, width: int, is_ours: bool
) -> None:
    path = tmp_path / "a.wav"
    with wave.open(str(path), "wb") as file:
        file.setparams((channels, width, rate, 0, "NONE", ""))
        file.writeframes(bytes(400))

    assert may_be_replaced("--sound", path) is is_ours
    path.write_bytes(b"RIFX" + path.read_bytes()[4:])
    assert not may_be_replaced("--sound", path)


def test_what_is_no_file_may_be_replaced_and_what_can_not_be_read_may_not(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A pipe or a device takes what is written; a folder is refused when it is opened."""
    (tmp_path / "mine").write_text("mine")
    assert may_be_replaced("--events", tmp_path)
    assert may_be_replaced("--events", tmp_path / "none")
    for problem, may_be in ((FileNotFoundError(), True), (PermissionError(), False), (ValueError(), False)):
        monkeypatch.setattr(files, "open_bytes", raising(problem))
        assert may_be_replaced("--events", tmp_path / "mine") is may_be


def raising(problem: Exception) -> Callable[[Path], BinaryIO]:
    def fail(_: Path) -> BinaryIO:
        raise problem

    return fail
