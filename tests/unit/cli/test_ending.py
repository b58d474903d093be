"""A signal interrupts the main thread anywhere. What the signal asks for never waits for that code."""

from __future__ import annotations

import os
import signal
import threading
from collections.abc import Callable

import pytest

from donnie_tui.cli import streams
from donnie_tui.cli.streams import on_signals, stopped_by_signals, stopped_by_suspension
from donnie_tui.linear.console import Console, Gone
from donnie_tui.process.signals import Watchdog
from tests.timeouts import TIMEOUT


class Held:
    """A lock that the main thread holds while the signal comes, and that the stop needs."""

    def __init__(self) -> None:
        self.lock = threading.Lock()
        self.got: list[bool] = []

    def stop(self) -> bool:
        got = self.lock.acquire(timeout=TIMEOUT)
        self.got.append(got)
        if got:
            self.lock.release()
        return got

    def interrupted_by(self, *numbers: signal.Signals) -> None:
        with self.lock:
            for number in numbers:
                signal.raise_signal(number)


def test_a_stop_gets_the_lock_that_the_interrupted_code_held() -> None:
    held = Held()
    with stopped_by_signals(lambda: _nothing(held.stop())) as stopped:
        held.interrupted_by(signal.SIGINT, signal.SIGTERM, signal.SIGINT)
        assert stopped.wait(TIMEOUT)

    assert held.got == [True, True, True], "all is done when it is left"


def test_a_failed_stop_does_not_prevent_the_next_one(caplog: pytest.LogCaptureFixture) -> None:
    done: list[str] = []

    def stop() -> None:
        done.append("stop")
        if len(done) == 1:
            raise OSError

    with stopped_by_signals(stop):
        signal.raise_signal(signal.SIGINT)
        signal.raise_signal(signal.SIGINT)

    assert done == ["stop", "stop"]
    assert "what a signal asked for failed" in caplog.text


@pytest.mark.skipif(not hasattr(signal, "SIGTSTP"), reason="no Ctrl+Z here")
def test_a_suspension_begins_after_the_stop_that_needed_the_held_lock(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    held, rests = Held(), list[list[bool]]()
    monkeypatch.setattr(streams, "can_suspend", lambda: True)
    monkeypatch.setattr(streams, "suspend", lambda **_: rests.append(list(held.got)))
    monkeypatch.setattr(streams, "_LONGEST_REST", 0.01)
    with stopped_by_suspension(held.stop, _never) as rested:
        held.interrupted_by(signal.SIGTSTP)

    assert rests == [[True]]
    assert rested.is_set()


def test_a_stop_gets_the_lock_of_a_writer_that_a_full_terminal_blocks(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    held, console = Held(), Console(None)
    console.stop_at_once = lambda: _nothing(held.stop())

    def full(_number: int, data: memoryview) -> int:
        held.interrupted_by(signal.SIGINT, signal.SIGINT)
        return len(data)

    try:
        monkeypatch.setattr("donnie_tui.linear.console.os.write", _once(full))
        console.write("x")
    finally:
        monkeypatch.undo()
        console.close()

    assert held.got == [True]


@pytest.mark.parametrize(("is_full", "can_suspend", "stops"), [(1, 1, 1), (1, 0, 0), (0, 1, 0)])
@pytest.mark.skipif(not hasattr(signal, "SIGTSTP"), reason="no Ctrl+Z here")
def test_ctrl_z_stops_a_robot_at_once_only_where_a_full_terminal_blocks_the_writer(
    monkeypatch: pytest.MonkeyPatch, is_full: bool, can_suspend: bool, stops: int
) -> None:
    """Where the main thread isn't blocked it suspends the process itself, after the robot has stopped."""
    held, console = Held(), Console(None)
    console.before_suspending = held.stop
    monkeypatch.setattr("donnie_tui.linear.console.can_suspend", lambda: bool(can_suspend))

    def full(_number: int, data: memoryview) -> int:
        if is_full:
            held.interrupted_by(signal.SIGTSTP)
        return len(data)

    try:
        monkeypatch.setattr("donnie_tui.linear.console.os.write", _once(full))
        console.write("x")
        if not is_full:
            held.interrupted_by(signal.SIGTSTP)
    finally:
        monkeypatch.undo()
        console.close()  # after all that was asked for

    assert held.got == [True] * stops


def test_ctrl_c_while_nothing_is_written_is_left_to_the_main_thread() -> None:
    held, console = Held(), Console(None)
    console.stop_at_once = lambda: _nothing(held.stop())
    try:
        held.interrupted_by(signal.SIGINT)
    finally:
        console.close()

    assert held.got == []


def test_a_closed_output_is_written_to_no_more(monkeypatch: pytest.MonkeyPatch) -> None:
    held, console = Held(), Console(None)
    console.stop_at_once = lambda: _nothing(held.stop())

    def closed(_number: int, _data: memoryview) -> int:
        raise BrokenPipeError

    try:
        monkeypatch.setattr("donnie_tui.linear.console.os.write", _once(closed))
        with pytest.raises(Gone):
            console.write("x")
        held.interrupted_by(signal.SIGINT)
    finally:
        monkeypatch.undo()
        console.close()

    assert held.got == [], "nothing is being written"


def _once(full: Callable[[int, memoryview], int]) -> Callable[[int, memoryview], int]:
    write = os.write
    return lambda number, data: full(number, data) if number == 1 else write(number, data)


def _nothing(_: object) -> None:
    return


@pytest.mark.parametrize(
    ("is_possible", "has_stopped", "happens"),
    [
        (True, True, ["stopped", "suspended"]),
        (True, False, ["stopped", "suspended"]),
        (False, True, ["refused"]),
    ],
)
@pytest.mark.skipif(not hasattr(signal, "SIGTSTP"), reason="no Ctrl+Z here")
def test_ctrl_z_stops_first_or_is_refused_and_what_it_stopped_is_known(
    is_possible: bool, has_stopped: bool, happens: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    done, before = list[str](), signal.getsignal(signal.SIGTSTP)
    monkeypatch.setattr(streams, "can_suspend", lambda: is_possible)
    monkeypatch.setattr(streams, "suspend", lambda: done.append("suspended"))
    monkeypatch.setattr(streams, "_LONGEST_REST", float(TIMEOUT))

    def stop() -> bool:
        done.append("stopped")
        return has_stopped

    with stopped_by_suspension(stop, lambda: done.append("refused")) as rested:
        signal.raise_signal(signal.SIGTSTP)
        signal.raise_signal(signal.SIGTSTP)

    assert done == happens * 2
    assert rested.is_set() == (is_possible and has_stopped)
    assert signal.getsignal(signal.SIGTSTP) is before


@pytest.mark.skipif(not hasattr(signal, "SIGTSTP"), reason="no Ctrl+Z here")
def test_a_ctrl_z_that_is_ignored_stays_ignored() -> None:
    before = signal.signal(signal.SIGTSTP, signal.SIG_IGN)
    try:
        with stopped_by_suspension(_never, _never) as rested:
            assert signal.getsignal(signal.SIGTSTP) is signal.SIG_IGN
        assert not rested.is_set()
    finally:
        signal.signal(signal.SIGTSTP, before)


def test_a_command_that_hangs_after_a_signal_does_the_last_things_and_has_its_code(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    ended, made = list[object](), list[Watchdog]()
    monkeypatch.setattr(streams, "end_process", lambda code, last: ended.append((code(), last)))
    monkeypatch.setattr(
        streams, "Watchdog", lambda *given, **how: made.append(Watchdog(*given, **how)) or made[-1]
    )
    last = (_never,)
    with stopped_by_signals(_never, last, lambda: 7), on_signals(lambda: None):
        for each in made:
            each._part(signal.SIGTERM)
    assert ended == [(7, last), (130, ())]


def _never() -> None:
    raise AssertionError("it was refused")


@pytest.mark.skipif(not hasattr(signal, "SIGTSTP"), reason="no Ctrl+Z here")
def test_control_z_without_a_shell_above_stops_nothing_and_is_answered(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    held, refused = Held(), threading.Event()
    monkeypatch.setattr(streams, "can_suspend", lambda: False)
    with stopped_by_suspension(held.stop, refused.set) as rested:
        signal.raise_signal(signal.SIGTSTP)
        assert refused.wait(TIMEOUT)

    assert (held.got, rested.is_set()) == ([], False)
