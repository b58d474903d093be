"""A wait is woken only once. Events that arrived during another look are not waited for again."""

from __future__ import annotations

from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import pytest

from donnie_tui.core.events import Outcome
from donnie_tui.core.session_log import LineHistory
from donnie_tui.linear.output import OutputQueue
from donnie_tui.linear.reader import EditingReader, How, PlainReader
from donnie_tui.linear.typed_lines import RunLoop
from donnie_tui.settings.settings import Settings

FOR_EVER = 1e9


class Console:
    """No event wakes a wait. Each wait that is not a mere poll is recorded."""

    def __init__(self, typed: bytes = b"") -> None:
        self.interrupted = self.has_news = False
        self.leaving: int | None = None
        self.waits: list[float] = []
        self.written = ""
        self.repaint: Callable[[], str] = str
        self.stop_at_once: Callable[[], None] = _nothing
        self.before_suspending: Callable[[], bool] = bool
        self.lines_wait: Callable[[], bool] = bool
        self._typed = typed
        self._time = 0.0

    def now(self) -> float:
        return self._time

    def columns(self) -> int:
        return 80

    def wait(self, seconds: float | None = None, *, reading: bool = False) -> bool:
        has_input = reading and bool(self._typed)
        if seconds != 0 and not has_input:
            self.waits.append(FOR_EVER if seconds is None else seconds)
            self._time += self.waits[-1]
            assert seconds is not None, "nothing wakes us any more"
        return has_input

    def read(self) -> bytes:
        typed, self._typed = self._typed, b""
        return typed

    def type(self, typed: bytes) -> None:
        self._typed = typed

    def write(self, text: str) -> None:
        self.written += text

    def take_interrupt(self) -> bool:
        interrupted, self.interrupted = self.interrupted, False
        return interrupted

    pressed_interrupt = take_interrupt

    def take_news(self) -> bool:
        has_news, self.has_news = self.has_news, False
        return has_news


def _nothing() -> None:
    return


def editor(console: Any) -> EditingReader:
    return EditingReader(console, LineHistory(None))


# --- keys that are typed while Donnie still loads


@pytest.mark.parametrize("typed", [b"\x03", b"FW 1\r\x03", b"PAUSE\r\x03", b"SPE\x03\x03"])
def test_ctrl_c_that_comes_as_a_key_counts_like_the_signal(typed: bytes) -> None:
    console: Any = Console(typed)
    assert editor(console).take_ahead(lambda _: True) is None
    assert console.interrupted


def test_what_is_typed_after_ctrl_c_stays_and_what_was_typed_before_goes() -> None:
    console: Any = Console(b"FW 1\r\x03FW 2\r")
    reader = editor(console)
    assert reader.take_ahead(lambda _: False) is None
    console.take_interrupt()
    assert reader.read("> ").text == "FW 2"


# --- runs


class Watched:
    """A run, and an event that arrives while keys are polled: it wakes no later wait."""

    def __init__(self, happens: str, monkeypatch: pytest.MonkeyPatch) -> None:
        self.console = Console()
        self.stops: list[str] = []
        self.last_words: list[str] = []
        """The last lines of a program that is being stopped."""
        self._is_over = False
        self._happens = happens
        hub = SimpleNamespace(add_gate=lambda _: _nothing)
        self.runs = SimpleNamespace(
            has_ended=lambda _: self.has_ended,
            is_held=False,
            note_stop=lambda: self.loop.before_stop(),
            sum_up=_ignored,
            close=_nothing,
        )
        session = SimpleNamespace(hub=hub, stop=self._stop)
        team = SimpleNamespace(stop=self._stop, wait_for_stop=lambda: None, running=())
        self.left_out = 0
        self.queue = OutputQueue(_nothing)
        self.has_ended = False
        ctx: Any = SimpleNamespace(
            runs=self.runs,
            donnie=SimpleNamespace(team=team, session=session, stop_real_robot=bool),
            answer=self._answer,
        )
        streams: Any = SimpleNamespace(
            console=self.console,
            queue=self.queue,
            settings=lambda: Settings(progress="0"),
            is_attended=True,
            can_edit=True,
            takes_live_commands=False,
        )
        some: Any = SimpleNamespace()
        self.loop = RunLoop(ctx, streams, some, some, some, some)
        monkeypatch.setattr(self.loop, "_take_live", self._live)

    def _answer(self, code: str, **values: int) -> None:
        self.left_out += values["lines"] if code == "answer-left-out" else 0

    def _live(self) -> bool:
        match self._happens:
            case "Ctrl+C":
                self.console.interrupted = not self.stops
            case "SIGTERM":
                self.console.leaving = 15
            case "end":
                self.has_ended = True
        return False

    def _stop(self) -> None:
        self.stops.append(self._happens)
        self.queue.put(self.last_words if not self._is_over else ())
        self._is_over = True

    def wait(self, _: float) -> bool:
        self._is_over = True
        return True

    @property
    def run(self) -> Any:
        watched = self

        class Run:
            outcome = Outcome.STOPPED
            wait = staticmethod(watched.wait)
            is_over = property(lambda _: watched._is_over)

        return Run()


def _ignored(*_: object, **__: object) -> None:
    return


@pytest.mark.parametrize("happens", ["Ctrl+C", "SIGTERM", "end"])
def test_a_watched_run_handles_at_once_an_event_during_the_poll_for_keys(
    happens: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    watched = Watched(happens, monkeypatch)
    watched.loop.follow([(None, watched.run)])

    assert watched.console.waits == []
    assert bool(watched.stops) == (happens != "end")


def test_a_stop_prints_three_waiting_lines_and_the_number_of_the_others(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    watched = Watched("Ctrl+C", monkeypatch)
    watched.console.interrupted = True
    watched.last_words = ["on and on"] * 97 + ["one", "two", "I was stopped."]
    watched.loop.follow([(None, watched.run)])

    assert watched.queue.take() == ["one", "two", "I was stopped."]
    assert watched.left_out == 97


# --- at the prompt


@pytest.mark.parametrize("make", [editor, PlainReader])
def test_a_reader_handles_at_once_an_event_during_an_answer(make: Callable[[Any], Any]) -> None:
    console = Console()
    console.interrupted = True
    assert make(console).read("> ").how is How.INTERRUPTED
    console.has_news = True
    assert make(console).read("> ").how is How.NEWS
    assert console.waits == []


def test_a_background_line_during_an_answer_is_printed_before_the_next_key() -> None:
    console = Console()
    console.lines_wait = lambda: True
    assert editor(console).read("> ").how is How.NEWS
    assert console.waits == []


def test_an_escape_waits_for_its_arrow_although_lines_arrive() -> None:
    console = Console(b"FW\x1b")
    console.has_news = True
    typed = editor(console).read("> ")
    assert (typed.text, typed.how) == ("FW", How.NEWS)


# --- what is read


def test_a_line_is_painted_again_only_while_it_is_read() -> None:
    console = Console(b"ab\r")
    reader = editor(console)
    painted = []
    reader.on_key = lambda _key, _before: painted.append(console.repaint())

    assert reader.read("> ").text == "ab"
    assert painted[0].startswith("\n> ")
    assert console.repaint() == ""


def test_a_reader_knows_that_a_part_of_the_next_line_was_typed() -> None:
    reader = editor(Console(b"ab\rc"))
    assert not reader.has_typed

    assert reader.read("> ").text == "ab"
    assert reader.has_typed


@pytest.mark.parametrize("encoding", ["utf-8-sig", "utf-16"])
def test_a_mark_of_the_encoding_is_dropped_at_the_very_beginning_only(encoding: str) -> None:
    reader = PlainReader(Console("FW 1\n\ufeffFW 2\n".encode(encoding)))  # type: ignore[arg-type]

    assert [reader.read("").text for _ in range(2)] == ["FW 1", "\ufeffFW 2"]
    assert not reader.has_typed


def test_a_line_before_the_mark_of_utf_16_is_no_utf_16() -> None:
    console = Console(b"FW 1\n")
    reader = PlainReader(console)  # type: ignore[arg-type]
    assert reader.read("").text == "FW 1"

    console.type(b"\xff\xfe\n")
    assert reader.read("").text == "ÿþ"


def test_after_a_run_the_signals_mean_what_they_did_and_a_quit_ends_donnie(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    watched = Watched("end", monkeypatch)
    console, run = watched.console, watched.run
    leaving: Any = SimpleNamespace(code=None)
    monkeypatch.setattr(watched.loop, "_leaving", leaving)
    seen = list[object]()
    monkeypatch.setattr(watched.loop, "_sum_up", lambda _: seen.append("summed up"))
    monkeypatch.setattr(
        watched.loop,
        "_print_pending",
        lambda: seen.extend([console.stop_at_once, console.before_suspending]) or watched.wait(0),
    )
    type(run).outcome = Outcome.QUIT
    watched.loop._was_suspended = True
    watched.loop.follow([(None, run)])

    assert seen == [watched.loop._stop_at_once, watched.loop._stop_real_robot, "summed up"]
    assert not watched.loop._was_suspended, "that was another run"
    assert console.before_suspending is bool, "as the session does it"
    assert leaving.code == 0
    assert console.stop_at_once() is None
    assert watched.stops == []
    console.leaving = 15
    type(run).outcome = Outcome.STOPPED
    watched._is_over, leaving.code = False, None
    watched.loop.follow([(None, run)])
    assert (seen[3:], leaving.code, len(watched.stops)) == ([], None, 1)


@pytest.mark.parametrize(
    ("is_held", "is_stopping", "leaving", "did"),
    [
        (False, False, None, ["print", "print"]),
        (True, False, None, ["ask", "ask"]),
        (True, True, None, ["print", "print"]),
        (True, False, 15, ["stop"]),
    ],
)
def test_a_run_is_followed_until_it_is_over_and_left_at_once_by_a_signal(
    monkeypatch: pytest.MonkeyPatch, is_held: bool, is_stopping: bool, leaving: int | None, did: list[str]
) -> None:
    watched, happened, waited = Watched("", monkeypatch), list[str](), list[float]()
    loop, console, runs = watched.loop, watched.console, watched.runs
    runs.is_held, runs.has_ended, console.leaving = is_held, lambda _: True, leaving

    def wait(seconds: float) -> bool:
        """The third wait finds the end."""
        waited.append(seconds)
        return len(waited) == 3

    for name, what in (("_print_pending", "print"), ("_take_while_held", "ask"), ("_stop", "stop")):
        monkeypatch.setattr(loop, name, lambda what=what: happened.append(what))
    monkeypatch.setattr(loop, "_sum_up", _ignored)
    loop._stopping = is_stopping
    run: Any = SimpleNamespace(is_over=False, wait=wait, outcome=Outcome.COMPLETED)
    if leaving is not None:
        waited.extend([0.0])  # the wait after the stop is not the end either
    loop._follow(run)

    assert happened == did
    assert len(waited) == 3
