"""L41: whoever waits is woken but once; what came while somebody else looked is not waited for again."""

from __future__ import annotations

from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import pytest

from donnie_tui.core.events import Outcome
from donnie_tui.core.recall import Past
from donnie_tui.core.watching import Watch
from donnie_tui.i18n.words import Words
from donnie_tui.linear.reader import EditingReader, How, PlainReader
from donnie_tui.linear.runs import Runs
from donnie_tui.linear.told import Told

FOR_EVER = 1e9


class Console:
    """Nothing ever wakes anybody; each wait that is no mere look is remembered."""

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
    return EditingReader(console, Past(None), lambda _: ())


# --- the keys of whoever types while Donnie still loads


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
    """A run, and what is found while keys are looked for: it happens then and wakes nobody after."""

    def __init__(self, happens: str) -> None:
        self.console = Console()
        self.stops: list[str] = []
        self.last_words: list[str] = []
        """What the program still tells while it is being stopped."""
        self._is_over = False
        self._happens = happens
        self._hub = SimpleNamespace(robot=None, subscribe=lambda _: _nothing, add_gate=lambda _: _nothing)
        session = SimpleNamespace(hub=self._hub, stop=self._stop, frames=())
        team = SimpleNamespace(stop=self._stop, settle=lambda: None, running=())
        self.desk: Any = SimpleNamespace(
            console=self.console,
            session=session,
            donnie=SimpleNamespace(team=team, stop_real_robot=bool),
            ends=SimpleNamespace(habits=SimpleNamespace(progress=0), can_edit=True, hears_live=False),
            showing=SimpleNamespace(),
            beside=SimpleNamespace(),
            watch=Watch(Words()),
            say=None,
            leaving=None,
            answer_of=_ignored,
            answer=self._answer,
        )
        self.left_out = 0
        self.told = Told(_nothing)
        self.runs = Runs(self.desk, self.told, lambda _: None, self._live)

    def _answer(self, code: str, **values: int) -> None:
        self.left_out += values["lines"] if code == "answer-left-out" else 0

    def _live(self) -> bool:
        match self._happens:
            case "Ctrl+C":
                self.console.interrupted = not self.stops
            case "SIGTERM":
                self.console.leaving = 15
            case "end":
                self.runs._ended = True  # as an event would have it
        return False

    def _stop(self) -> None:
        self.stops.append(self._happens)
        self.told.put(self.last_words if not self._is_over else ())
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
def test_a_watched_run_heeds_at_once_what_came_while_keys_were_looked_for(happens: str) -> None:
    watched = Watched(happens)
    watched.runs.watch_together(lambda: (("typed", watched.run),))

    assert watched.console.waits == []
    assert bool(watched.stops) == (happens != "end")


def test_of_a_program_that_talks_without_end_three_lines_are_told_at_a_stop_and_how_many_are_not() -> None:
    watched = Watched("Ctrl+C")
    watched.console.interrupted = True
    watched.last_words = ["on and on"] * 97 + ["one", "two", "I was stopped."]
    watched.runs.watch_together(lambda: (("typed", watched.run),))

    assert watched.told.take() == ["one", "two", "I was stopped."]
    assert watched.left_out == 97


# --- at the prompt


@pytest.mark.parametrize("make", [editor, PlainReader])
def test_a_reader_heeds_at_once_what_came_while_an_answer_was_printed(make: Callable[[Any], Any]) -> None:
    console = Console()
    console.interrupted = True
    assert make(console).read("> ").how is How.INTERRUPTED
    console.has_news = True
    assert make(console).read("> ").how is How.NEWS
    assert console.waits == []


def test_a_line_told_beside_while_an_answer_was_printed_comes_before_anything_is_typed() -> None:
    console = Console()
    console.lines_wait = lambda: True
    assert editor(console).read("> ").how is How.NEWS
    assert console.waits == []


def test_an_escape_that_may_begin_an_arrow_is_waited_for_though_news_come() -> None:
    console = Console(b"FW\x1b")
    console.has_news = True
    typed = editor(console).read("> ")
    assert (typed.text, typed.how) == ("FW", How.NEWS)
