"""The real console of the linear mode: signals, keys that are typed too early, and what is written."""

from __future__ import annotations

import os
import select
import signal
from collections.abc import Callable, Iterator
from types import SimpleNamespace
from typing import Any

import pytest

from donnie_tui.linear import console as console_module
from donnie_tui.linear.console import MOST_AHEAD, Console, Gone
from donnie_tui.process import signals


class Terminal:
    def __init__(self, did: list[str]) -> None:
        self.take, self.give_back = (lambda: did.append("taken")), (lambda: did.append("given back"))


@pytest.fixture
def did() -> list[str]:
    return []


@pytest.fixture
def keyboard() -> Iterator[int]:
    """Where to write what is typed."""
    found, (reading, writing) = os.dup(0), os.pipe()
    os.dup2(reading, 0)
    os.close(reading)
    yield writing
    os.dup2(found, 0)
    os.close(found)


@pytest.fixture
def console(keyboard: int, did: list[str], monkeypatch: pytest.MonkeyPatch) -> Iterator[Console]:
    monkeypatch.setattr(
        signals, "LEAVE", 1e6
    )  # a slow machine doesn't end the process in the middle of a test
    terminal: Any = Terminal(did)
    it = Console(terminal)
    it.on_key = lambda: did.append("key")
    did.clear()
    yield it
    monkeypatch.undo()
    it.close()


def after(console: Console, *numbers: int) -> None:
    for number in numbers:
        signal.raise_signal(number)
    console.wait(0)


def test_control_c_is_taken_once_and_is_a_key(console: Console, did: list[str]) -> None:
    assert not console.take_interrupt()
    after(console, signal.SIGINT)
    assert [console.take_interrupt(), console.take_interrupt()] == [True, False]
    assert did == ["key"]
    signal.raise_signal(signal.SIGINT)
    assert [console.pressed_interrupt(), console.pressed_interrupt()] == [True, False]


def test_a_control_c_that_ended_a_search_has_had_its_effect(console: Console) -> None:
    console.give_up = lambda: True
    after(console, signal.SIGINT)
    assert not console.interrupted
    after(console, signal.SIGINT)
    assert not console.interrupted
    console.give_up = lambda: False
    after(console, signal.SIGINT)
    assert console.interrupted


def test_the_first_signal_that_ends_donnie_gives_its_exit_code(console: Console) -> None:
    assert (console.leaving, console.code_when_gone) == (None, 128 + signal.SIGHUP)
    console.give_up = lambda: True
    after(console, signal.SIGTERM)
    console.give_up = lambda: False
    after(console, signal.SIGHUP, signal.SIGINT)
    assert console.interrupted
    assert (console.leaving, console.code_when_gone) == (signal.SIGTERM, 128 + signal.SIGTERM)


@pytest.mark.parametrize("is_possible", [False, True])
def test_control_z_suspends_where_that_is_possible_and_says_so_elsewhere(
    is_possible: bool, console: Console, did: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(console_module, "can_suspend", lambda: is_possible)
    monkeypatch.setattr(console_module, "suspend", lambda: did.append("suspended"))
    monkeypatch.setattr(console, "write", did.append)
    console.before_suspending = lambda: did.append("robot stopped")
    console.on_not_suspended = lambda: did.append("said so")
    console.repaint = lambda: "> FW 1"
    after(console, signal.SIGTSTP)

    suspended = ["robot stopped", "given back", "suspended", "taken", "> FW 1"]
    assert did == (suspended if is_possible else ["said so"])
    assert [console.take_news(), console.take_news()] == [not is_possible, False]


@pytest.mark.parametrize("is_possible", [False, True])
@pytest.mark.parametrize("is_writing", [False, True])
def test_while_a_terminal_takes_no_output_a_signal_stops_the_robot_at_once(
    is_writing: bool, is_possible: bool, console: Console, did: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(console_module, "can_suspend", lambda: is_possible)
    monkeypatch.setattr(console._watchdog.deputy, "do", lambda task: task())
    monkeypatch.setattr(console, "give_up", lambda: False)
    console.before_suspending = lambda: did.append("robot stopped")
    console.stop_at_once = lambda: did.append("program stopped")
    console._is_writing = is_writing
    console._on_signal(signal.SIGTSTP, None)
    assert did == (["robot stopped"] if is_writing and is_possible else [])

    did.clear()
    for _ in range(2):
        console._on_signal(signal.SIGINT, None)
    assert did == (["program stopped"] if is_writing else []), "once"


def test_keys_are_noticed_while_no_line_is_read_and_kept_for_it(
    console: Console, did: list[str], keyboard: int
) -> None:
    assert not console.has_input()
    os.write(keyboard, b"FW")
    assert not console.wait(1e6), "it waits for no key"
    assert did == ["key"]
    assert console.has_input()
    os.write(keyboard, b" 1\n")
    assert console.wait(1e6, reading=True)
    assert [console.read(), console.read()] == [b"FW", b" 1\n"]
    assert did == ["key", "key"]
    os.close(keyboard)
    assert not console.wait(1e6)
    assert console.on_key is None, "the input has ended, and would wake every wait"
    assert console.wait(reading=True)
    assert console.read() == b""


def test_no_more_keys_are_kept_than_a_few(console: Console, keyboard: int) -> None:
    console._ahead = b"x" * MOST_AHEAD
    os.write(keyboard, b"y")
    console.wait(0)
    assert len(console._ahead) == MOST_AHEAD
    console._ahead = b"x" * (MOST_AHEAD - 1)
    console.wait(0)
    assert console._ahead.endswith(b"xy")


def test_a_key_that_is_not_watched_for_stays_where_it_is(console: Console, keyboard: int) -> None:
    console.on_key = None
    os.write(keyboard, b"x")
    console.nudge()
    assert not console.wait(1e6)
    assert not select.select([console._nudges], [], [], 0)[0], "it woke one wait"
    assert console._ahead == b""
    assert console.has_input()


@pytest.mark.parametrize(
    ("happens", "reading", "is_disturbed"),
    [
        ("", True, False),
        ("key", True, True),
        ("key", False, False),
        ("nudge", True, False),
        ("SIGINT", False, True),
        ("SIGTERM", False, True),
    ],
)
def test_a_rest_is_disturbed_by_a_signal_or_a_key_that_is_waited_for(
    happens: str, reading: bool, is_disturbed: bool, console: Console, keyboard: int
) -> None:
    moments = iter([0.0, 0.0, 0.5, 1.0])
    console.now = lambda: next(moments)  # type: ignore[method-assign] # the time of this test
    waited = list[float | None]()
    wait = console.wait

    def wait_once(seconds: float | None = None, *, reading: bool = False) -> bool:
        waited.append(seconds)
        return wait(0, reading=reading)

    console.wait = wait_once  # type: ignore[method-assign] # as above
    if happens == "key":
        os.write(keyboard, b"x")
    elif happens == "nudge":
        console.nudge()
    elif happens:
        signal.raise_signal(getattr(signal, happens))

    assert console.is_disturbed_within(1.0, reading=reading) is is_disturbed
    assert waited == ([1.0] if is_disturbed else [1.0, 0.5])


def test_a_rest_goes_on_whatever_happens_meanwhile(console: Console) -> None:
    moments = iter([0.0, 0.0, 0.25, 1.0])
    console.now = lambda: next(moments)  # type: ignore[method-assign] # the time of this test
    waited = list[float | None]()
    console.wait = lambda seconds=None, **_: bool(waited.append(seconds))  # type: ignore[method-assign,func-returns-value]
    console.rest(1.0)
    assert waited == [1.0, 0.75]


def test_all_is_written_in_as_many_pieces_as_the_terminal_takes(
    console: Console, monkeypatch: pytest.MonkeyPatch
) -> None:
    written = list[bytes]()

    def write(number: int, data: memoryview) -> int:
        written.append(bytes(data[:3]))
        assert number == 1
        return min(3, len(data))

    monkeypatch.setattr(console_module.os, "write", write)
    console.write("olá\udc00!")
    assert b"".join(written) == "olá?!".encode()
    console.write("")
    monkeypatch.setattr(console_module.os, "write", _fails)
    with pytest.raises(Gone):
        console.write("x")


def _fails(*_: object) -> int:
    raise OSError


@pytest.mark.parametrize(
    ("found", "size"), [(None, (80, 24)), ((0, 0), (80, 24)), ((40, 0), (40, 24)), ((132, 50), (132, 50))]
)
def test_a_terminal_of_unknown_size_has_eighty_columns_and_twenty_four_rows(
    found: tuple[int, int] | None,
    size: tuple[int, int],
    console: Console,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def asked(number: int) -> tuple[int, int]:
        if found is None or number != 1:
            raise OSError
        return found

    monkeypatch.setattr(console_module.os, "get_terminal_size", asked)
    assert (console.columns(), console.rows()) == size


@pytest.mark.parametrize(("has_run_away", "code"), [(False, 143), (True, 1)])
def test_a_hanging_main_thread_leaves_the_terminal_and_the_robot_behind_in_order(
    has_run_away: bool, code: int, console: Console, did: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    ended = list[int]()

    def end(its_code: Callable[[], int], last: tuple[Callable[[], object], ...]) -> None:
        ended.append(its_code())
        for each in last:
            each()

    monkeypatch.setattr(console_module, "end_process", end)
    console.last = (lambda: did.append("robot stopped"),)
    console.has_run_away = lambda: has_run_away
    console._part(signal.SIGTERM)
    assert (ended, did) == ([code], ["robot stopped", "given back"])


def test_the_terminal_is_taken_while_lines_are_edited_and_given_back_at_the_end(
    keyboard: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    watch: Any = SimpleNamespace(close=lambda: did.append("unwatched"))
    monkeypatch.setattr(console_module, "ReaderWatch", lambda: watch)
    did, before = list[str](), signal.getsignal(signal.SIGINT)
    terminal: Any = Terminal(did)
    console = Console(terminal)
    console.edit(False)
    console.edit(True)
    console.close()
    assert did == ["taken", "given back", "taken", "unwatched", "given back"]
    assert signal.getsignal(signal.SIGINT) is before
    console = Console(None)
    console.edit(True)
    console.close()
