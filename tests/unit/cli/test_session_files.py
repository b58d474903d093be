"""The files that a session writes as it goes."""

from __future__ import annotations

import wave
from array import array
from contextlib import ExitStack
from io import StringIO
from pathlib import Path

import pytest

from donnie_tui.cli.streams import Guarded, Output, is_terminal
from donnie_tui.core import answer_log
from donnie_tui.core.events import Spoke
from donnie_tui.core.hub import Hub
from donnie_tui.core.session import RunOptions
from donnie_tui.core.transcript import printed_lines
from donnie_tui.i18n.words import Unusable, Words
from donnie_tui.outlets.files import SessionFiles, may_be_replaced
from donnie_tui.settings.settings import Settings
from tests.floor import Floor
from tests.timeouts import TIMEOUT

FULL = Path("/dev/full")


@pytest.mark.skipif(not FULL.exists(), reason="needs a device that is always full")
def test_a_full_log_is_reported_once_and_counts_as_lost(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(answer_log, "next_log", lambda folder: FULL)
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
        ("--sound", "song.wav", b"RIFF0000WAVEfmt ", False),
    ],
)
def test_a_file_of_that_kind_that_donnie_did_not_write_is_not_replaced(
    tmp_path: Path, option: str, name: str, content: bytes, may_be: bool
) -> None:
    (tmp_path / name).write_bytes(content)

    assert may_be_replaced(option, tmp_path / name) is may_be
