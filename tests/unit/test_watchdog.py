"""The thread that heeds signals ends the process in time, whatever hangs and whatever is locked."""

from __future__ import annotations

import os
import signal
import threading
from queue import SimpleQueue
from typing import NoReturn

import pytest

from donnie_tui.process import signals
from donnie_tui.process.signals import LEAVING, Deputy, Watchdog, end_process, heeded, timeout_factor
from tests.timeouts import TIMEOUT

TAKEN = dict.fromkeys((signal.SIGINT, *LEAVING), heeded)
FOR_EVER = 1e6


class Ended(Exception):
    """Instead of the end of this process."""


@pytest.fixture
def exit_codes(monkeypatch: pytest.MonkeyPatch) -> SimpleQueue[int]:
    """The codes with which the process would have ended."""
    codes = SimpleQueue[int]()

    def end(code: int) -> NoReturn:
        codes.put(code)
        raise Ended

    monkeypatch.setattr(signals.os, "_exit", end)
    return codes


@pytest.mark.parametrize("number", LEAVING)
def test_a_hanging_stop_does_not_keep_the_process_from_its_end(
    number: int, exit_codes: SimpleQueue[int]
) -> None:
    released = threading.Event()
    watchdog = Watchdog(
        TAKEN,
        part=lambda number: end_process(lambda: 128 + number, ()),
        halt=lambda: _nothing(released.wait(TIMEOUT)),
        leave=0.0,
    )
    with watchdog:
        signal.raise_signal(number)
        assert exit_codes.get(timeout=TIMEOUT) == 128 + number
        released.set()


def test_a_signal_is_heeded_although_the_main_thread_hangs_while_it_heeds_another_one() -> None:
    """It holds what the watchdog's thread needs, to take both in their order."""
    over, heeding = threading.Event(), threading.Event()

    def on_number(number: int) -> None:
        if number == signal.SIGINT and threading.current_thread() is threading.main_thread():
            os.kill(os.getpid(), signal.SIGTERM)
            heeding.set()
            assert over.wait(TIMEOUT)

    watchdog = Watchdog(TAKEN, part=lambda _number: over.set(), on_number=on_number, leave=0.0)
    with watchdog:
        while not heeding.is_set():  # whichever thread is first
            signal.raise_signal(signal.SIGINT)
            watchdog.take()

    assert over.is_set()


def test_a_main_thread_that_leaves_is_not_ended(exit_codes: SimpleQueue[int]) -> None:
    with Watchdog(TAKEN, part=lambda number: end_process(lambda: number, ()), leave=FOR_EVER):
        signal.raise_signal(signal.SIGTERM)

    assert exit_codes.empty()
    assert not any(each.name == "last" and _is_left(each) for each in threading.enumerate())


def test_an_interrupt_ends_nothing(exit_codes: SimpleQueue[int]) -> None:
    heard = SimpleQueue[int]()
    with Watchdog(TAKEN, part=lambda number: end_process(lambda: number, ()), on_number=heard.put, leave=0.0):
        signal.raise_signal(signal.SIGINT)
        assert heard.get(timeout=TIMEOUT) == signal.SIGINT

    assert exit_codes.empty()


def test_all_that_is_last_is_done_although_one_of_it_hangs_and_one_fails(
    monkeypatch: pytest.MonkeyPatch, exit_codes: SimpleQueue[int]
) -> None:
    monkeypatch.setattr(signals, "LAST", 0.005)
    released, kept = threading.Event(), threading.Event()

    def fail() -> None:
        raise OSError

    with pytest.raises(Ended):
        end_process(lambda: 7, (lambda: _nothing(released.wait(TIMEOUT)), fail, kept.set))
    released.set()

    assert kept.wait(TIMEOUT)
    assert exit_codes.get(timeout=TIMEOUT) == 7


def test_the_deadline_is_longer_where_all_timeouts_are(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("DONNIE_ROBOT_TIMEOUTS", raising=False)
    assert timeout_factor() == 1.0
    for text, factor, seconds in (
        *(("", 1.0, 3.0), ("slow", 1.0, 3.0), ("0", 1.0, 3.0), ("-4", 1.0, 3.0)),
        *(("0.5", 0.5, 3.0), ("4", 4.0, 12.0)),
    ):
        monkeypatch.setenv("DONNIE_ROBOT_TIMEOUTS", text)
        assert timeout_factor() == factor
        assert Watchdog({}, part=_nothing)._leave == seconds
        assert Watchdog({}, part=_nothing, leave=6.0)._leave == 2 * seconds


def test_what_is_last_has_more_time_where_all_timeouts_are_longer(
    monkeypatch: pytest.MonkeyPatch, exit_codes: SimpleQueue[int]
) -> None:
    monkeypatch.setenv("DONNIE_ROBOT_TIMEOUTS", f"{TIMEOUT / 0.001}")
    monkeypatch.setattr(signals, "LAST", 0.001)
    kept = threading.Event()

    def keep() -> None:
        threading.Event().wait(0.05)
        kept.set()

    with pytest.raises(Ended):
        end_process(lambda: int(kept.is_set()), (keep,))

    assert exit_codes.get(timeout=TIMEOUT) == 1


def test_only_the_first_signal_that_ends_the_process_counts_and_each_one_stops_the_robots() -> None:
    halted, heard = SimpleQueue[None](), list[int]()
    watchdog = Watchdog(TAKEN, part=_nothing, halt=lambda: halted.put(None), on_number=heard.append)
    with watchdog:
        watchdog.leave(signal.SIGTERM, since=FOR_EVER)
        watchdog.leave(signal.SIGHUP)
        assert watchdog.left == (signal.SIGTERM, FOR_EVER)
        watchdog._signals.nudge()
        watchdog.take()
        deputy, signals_of_it = watchdog.deputy, watchdog._signals
    watchdog.end()

    assert heard == [], "a nudge is no signal"
    assert halted.qsize() == 2
    assert not deputy._thread.is_alive()
    with pytest.raises(OSError):
        os.fstat(signals_of_it.fileno())


def test_a_task_that_fails_is_logged_and_neither_ends_the_deputy_nor_is_waited_for(
    caplog: pytest.LogCaptureFixture,
) -> None:
    def fail() -> None:
        raise OSError("no port")

    deputy, done = Deputy(), list[int]()
    deputy.see_done(fail, FOR_EVER)
    deputy.see_done(lambda: done.append(1), FOR_EVER)
    assert done == [1]
    deputy.do(lambda: done.append(2))
    deputy.close()

    assert done == [1, 2]
    assert [(each.name, each.getMessage()) for each in caplog.records] == [
        ("donnie_tui.process.signals", "what a signal asked for failed")
    ]


def test_a_task_that_hangs_is_waited_for_as_long_as_is_said() -> None:
    released, deputy = threading.Event(), Deputy()
    deputy.see_done(lambda: _nothing(released.wait(TIMEOUT)), 0.0)
    assert not released.is_set()
    released.set()
    deputy.close()


def _is_left(thread: threading.Thread) -> bool:
    thread.join(TIMEOUT)
    return thread.is_alive()


def _nothing(_: object) -> None:
    return
