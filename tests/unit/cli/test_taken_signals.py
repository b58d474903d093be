"""Signals are handled for a while, wake the waiting thread, and are then restored."""

from __future__ import annotations

import fcntl
import os
import select
import signal
import threading
from collections.abc import Callable

import pytest

from donnie_tui.process.signals import LEAVING, Nudges, TakenSignals, WakingSignals

NUMBERS = (signal.SIGINT, *LEAVING)


def handled() -> list[object]:
    return [signal.getsignal(number) for number in NUMBERS]


@pytest.mark.parametrize("kind", [TakenSignals, WakingSignals])
def test_each_signal_handler_is_restored(kind: type[TakenSignals]) -> None:
    before, heard = handled(), list[int]()
    signal.signal(signal.SIGHUP, signal.SIG_IGN)
    with kind(dict.fromkeys(NUMBERS, lambda number, _: heard.append(number))) as taken:
        assert taken.handler_before(signal.SIGINT) is before[0]
        assert taken.handler_before(signal.SIGHUP) is None
        signal.raise_signal(signal.SIGTERM)
    if isinstance(taken, WakingSignals):
        taken.close()
    later, nudges = signal.signal(signal.SIGTERM, signal.SIG_IGN), Nudges()
    signal.set_wakeup_fd(nudges._writing)
    taken.give_back()
    assert signal.signal(signal.SIGTERM, later) is signal.SIG_IGN, "it restores once"
    assert signal.set_wakeup_fd(-1) == nudges._writing
    nudges.close()

    assert heard == [signal.SIGTERM]
    assert signal.getsignal(signal.SIGHUP) is signal.SIG_IGN
    signal.signal(signal.SIGHUP, before[NUMBERS.index(signal.SIGHUP)])  # type: ignore[arg-type] -- as it was
    assert handled() == before


def test_signals_and_nudges_wake_the_waiting_thread_and_the_wakeup_is_restored() -> None:
    outer = WakingSignals({})
    inner = WakingSignals({signal.SIGTERM: lambda *_: None})
    signal.raise_signal(signal.SIGTERM)
    inner.nudge()

    assert select.select([inner], [], [], 20)[0] == [inner]
    assert inner.numbers() == bytes([signal.SIGTERM, 0])
    assert inner.numbers() == b"", "and no thread waits for more"
    for each in (inner, outer):
        each.give_back()
    signal.raise_signal(signal.SIGCONT)
    assert outer.numbers() == b"", "a handler that was given back is not woken"
    for each in (inner, outer):
        each.close()


def test_no_signal_is_lost_while_the_signals_are_taken(monkeypatch: pytest.MonkeyPatch) -> None:
    """Else Donnie would not end with its reader, if that ends while Donnie begins."""
    heard, sent = list[int](), 0

    def then_signal(task: Callable[..., object]) -> Callable[..., object]:
        def do(*values: object, **named: object) -> object:
            nonlocal sent
            done = task(*values, **named)
            signal.raise_signal(signal.SIGUSR1)
            sent += 1
            return done

        return do

    before = signal.signal(signal.SIGUSR1, lambda number, _: heard.append(number))
    with monkeypatch.context() as patched:
        for module, name in ((os, "pipe"), (signal, "set_wakeup_fd"), (signal, "signal")):
            patched.setattr(module, name, then_signal(getattr(module, name)))
        taken = WakingSignals({signal.SIGUSR1: lambda *_: None})

    assert sent >= 3
    assert len(heard) + len(taken.numbers()) >= sent
    taken.give_back()
    taken.close()
    signal.signal(signal.SIGUSR1, before)


def test_nothing_is_left_open_where_signals_cannot_be_taken() -> None:
    opened: list[set[str]] = []

    def take() -> None:
        before = set(os.listdir("/dev/fd"))  # noqa: PTH208 -- numbers, not files
        with pytest.raises(ValueError, match="main thread"):
            WakingSignals({signal.SIGTERM: lambda *_: None})
        opened.append(set(os.listdir("/dev/fd")) - before)  # noqa: PTH208 -- as above

    thread = threading.Thread(target=take)
    thread.start()
    thread.join()

    assert opened == [set()]


@pytest.mark.skipif(not hasattr(fcntl, "F_SETPIPE_SZ"), reason="only Linux changes the size of a pipe")
def test_a_nudge_of_a_thread_that_takes_none_is_lost_and_not_waited_for() -> None:
    nudges = Nudges()
    size = fcntl.fcntl(nudges.fileno(), fcntl.F_SETPIPE_SZ, 4096)
    for _ in range(size + 1):
        nudges.nudge()

    assert nudges.numbers() == bytes(4096)
    nudges.close()
    for each in (nudges._reading, nudges._writing):
        with pytest.raises(OSError):
            os.fstat(each)


def test_another_thread_handles_no_signal() -> None:
    refused: list[ValueError] = []

    def take() -> None:
        try:
            TakenSignals({signal.SIGTERM: lambda *_: None})
        except ValueError as problem:
            refused.append(problem)

    before = handled()
    thread = threading.Thread(target=take)
    thread.start()
    thread.join()

    assert len(refused) == 1
    assert handled() == before


def test_a_wakeup_that_is_closed_by_now_is_forgotten() -> None:
    """An event loop may have ended first."""
    outer = WakingSignals({})
    inner = WakingSignals({})
    outer.close()

    inner.give_back()

    assert signal.set_wakeup_fd(-1) == -1
    inner.close()
    outer.give_back()
