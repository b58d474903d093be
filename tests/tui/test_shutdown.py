"""The thread that waits for signals and watches the output, without a screen."""

import signal
import threading
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from queue import Queue
from types import SimpleNamespace
from typing import Any

import pytest

from donnie_tui.tui import shutdown
from donnie_tui.tui.shutdown import ScreenWatchdog, Shutdown
from tests.timeouts import TIMEOUT


class Recorder:
    """Records its calls, and fails each time if it has to."""

    def __init__(self, failing: bool = False, times: int = 1) -> None:
        self.all: list[int] = []
        self.enough = threading.Event()
        self._failing, self._times = failing, times

    def __call__(self, number: int = 0) -> None:
        self.all.append(number)
        if len(self.all) == self._times:
            self.enough.set()
        if self._failing:
            raise RuntimeError("it was meant to fail")


def made(
    *,
    halt: Callable[[], object] = lambda: None,
    before_rest: Callable[[], object] = lambda: None,
    notify: Callable[[int], object] = lambda number: None,
    on_stuck: Callable[[], object] = lambda: None,
    part: Callable[[int], object] = lambda number: None,
    writer: Callable[[], Any] = lambda: None,
) -> ScreenWatchdog:
    return ScreenWatchdog(
        halt=halt, before_rest=before_rest, notify=notify, on_stuck=on_stuck, part=part, writer=writer
    )


@pytest.mark.parametrize("failing", [False, True])
def test_stuck_output_is_reported_repeatedly(monkeypatch, failing):
    """A key may have started a robot since the first report, or the first report may have failed."""
    monkeypatch.setattr(shutdown, "LOOK", 0.001)
    stuck, waiting = Recorder(failing, times=2), Queue[str]()
    waiting.put("what the terminal does not take")
    line = made(on_stuck=stuck, writer=lambda: SimpleNamespace(_queue=waiting, is_alive=lambda: True))
    line.begin()
    try:
        assert stuck.enough.wait(TIMEOUT)
    finally:
        line.end()


@pytest.mark.parametrize("failing", ["halt", "notify", "part"])
def test_a_signal_ends_the_process_whatever_fails(monkeypatch, failing):
    monkeypatch.setattr(shutdown, "LOOK", 0.001)
    monkeypatch.setattr(shutdown, "LEAVE", 0.01)
    halt, notify, part = (
        Recorder(failing == "halt"),
        Recorder(failing == "notify"),
        Recorder(failing == "part", times=2),
    )
    line = made(halt=halt, notify=notify, part=part)
    line.begin()
    try:
        signal.raise_signal(signal.SIGTERM)
        assert part.enough.wait(TIMEOUT)
    finally:
        line.end()

    assert halt.all == [0]
    assert notify.all == [signal.SIGTERM]
    assert set(part.all) == {signal.SIGTERM}


def test_the_robot_is_halted_where_the_screen_can_not_be_notified(monkeypatch):
    monkeypatch.setattr(shutdown, "ANSWER", 0.0)
    halt = Recorder(times=2)
    line = made(halt=halt, notify=Recorder(failing=True))
    line.begin()
    try:
        signal.raise_signal(signal.SIGINT)
        signal.raise_signal(signal.SIGINT)
        assert halt.enough.wait(TIMEOUT)
    finally:
        line.end()


@pytest.fixture
def rested(monkeypatch: pytest.MonkeyPatch) -> Iterator[list[str]]:
    """A suspension is recorded here instead."""
    order = list[str]()
    monkeypatch.setattr(shutdown, "can_suspend", lambda: True)
    found = signal.signal(signal.SIGTSTP, lambda *_: order.append("rest"))
    yield order
    signal.signal(signal.SIGTSTP, found)


def test_control_z_suspends_the_process_after_the_robot_has_stopped(rested):
    line = made(before_rest=lambda: rested.append("stop"))
    line.begin()
    try:
        signal.raise_signal(signal.SIGTSTP)
    finally:
        line.end()

    assert rested == ["stop", "rest"]


def test_control_z_without_a_shell_above_stops_no_robot_and_is_passed_to_the_screen(monkeypatch, rested):
    monkeypatch.setattr(shutdown, "can_suspend", lambda: False)
    passed = Recorder()
    line = made(before_rest=lambda: rested.append("stop"), notify=passed)
    line.begin()
    try:
        signal.raise_signal(signal.SIGTSTP)
    finally:
        line.end()

    assert (rested, passed.all) == ([], [signal.SIGTSTP])


def test_control_z_suspends_although_the_main_thread_holds_the_lock_of_the_stop(monkeypatch, rested):
    """The handler interrupts the main thread anywhere."""
    monkeypatch.setattr(shutdown, "LONGEST_REST", 0.01)
    held, stopped = threading.Lock(), threading.Event()

    def stop() -> None:
        with held:
            stopped.set()

    line = made(before_rest=stop)
    line.begin()
    try:
        with held:
            signal.raise_signal(signal.SIGTSTP)
        assert stopped.wait(TIMEOUT)
    finally:
        line.end()

    assert rested == ["rest"]


# --- the session


def closing(left) -> tuple[list[str], Shutdown]:
    """A shutdown whose watchdog was left so, and what is done then."""
    done: list[str] = []
    session = SimpleNamespace(
        close=lambda: done.append("close"), stop_real_robot=lambda: True, keep_text=lambda: None
    )
    it = Shutdown(
        SimpleNamespace(_driver=None), session, Path(), stop_all=int, repaint=int, after_keys=lambda it: it()
    )
    it._watchdog = SimpleNamespace(left=left, end=lambda: done.append("end"))
    return done, it


class Watched:
    """In place of the watchdog of the end."""

    def __init__(self, done: list[str], *_given, **_named) -> None:
        self._done = done

    def __enter__(self) -> "Watched":
        self._done.append("watched")
        return self

    def leave(self, *given: object) -> None:
        self._done.append(f"leave {given}")

    def __exit__(self, *_given: object) -> None:
        self._done.append("over")


@pytest.mark.parametrize(
    ("left", "expected"),
    [(None, ["close"]), ((15, 1.5), ["watched", "leave (15, 1.5)", "close", "over"])],
    ids=["quit", "signal"],
)
def test_the_session_is_closed_and_after_a_signal_in_time(monkeypatch, left, expected):
    done, it = closing(left)
    monkeypatch.setattr(shutdown, "Watchdog", partial(Watched, done))
    it.close_session()
    assert done == expected


def test_a_screen_that_never_began_to_watch_closes_its_session():
    done, it = closing(None)
    it._watchdog = None
    it.end_watchdog()
    it.close_session()
    assert done == ["close"]


def test_the_readers_of_a_page_are_no_longer_watched_at_the_end():
    done, it = closing(None)
    it._readers = SimpleNamespace(close=lambda: done.append("readers"))
    it.end_watchdog()
    assert done == ["readers", "end"]
