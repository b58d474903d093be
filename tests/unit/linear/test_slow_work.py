"""Slow work is reported after one second and every ten seconds. The clock moves during waits."""

from __future__ import annotations

import threading
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from donnie_tui.commands import files, program
from donnie_tui.commands.interaction import GivenUp, drive
from donnie_tui.core.document import Document
from donnie_tui.core.program_files import write_bytes
from donnie_tui.linear.console import Gone, run_in_background
from donnie_tui.linear.conversation import LinearInteraction
from language.formatter import formatted
from tests.timeouts import TIMEOUT


class Console:
    """Time passes during waits. The gate opens at a certain time."""

    def __init__(self, opens_at: float) -> None:
        self.time, self.leaving, self.interrupted = 0.0, None, False
        self.gate = threading.Event()
        self._opens_at = opens_at
        self._is_over = threading.Event()

    def now(self) -> float:
        return self.time

    def take_interrupt(self) -> bool:
        interrupted, self.interrupted = self.interrupted, False
        return interrupted

    def nudge(self) -> None:
        self._is_over.set()

    def wait(self, seconds: float) -> None:
        assert self.leaving is None, "nothing wakes us any more"
        self.time += seconds
        if self.time > self._opens_at:
            self.gate.set()
            self._is_over.wait(TIMEOUT)

    def wait_at_gate(self) -> bool:
        return self.gate.wait(TIMEOUT)


@pytest.mark.parametrize(("takes", "expected"), [(0.5, []), (5, [1.0]), (25, [1.0, 11.0, 21.0])])
def test_slow_work_is_reported_after_a_second_and_every_ten(takes: float, expected: list[float]) -> None:
    console: Any = Console(takes)
    times: list[float] = []
    done = run_in_background(console, console.wait_at_gate, lambda: times.append(console.time))
    assert done is True
    assert times == expected


def test_an_exception_of_the_work_is_raised() -> None:
    console: Any = Console(0)
    with pytest.raises(ZeroDivisionError):
        run_in_background(console, lambda: 1 // 0, lambda: None)


def test_a_signal_to_leave_ends_the_wait() -> None:
    console: Any = Console(100)
    console.leaving = 15
    with pytest.raises(Gone):
        run_in_background(console, console.wait_at_gate, lambda: None)
    console.gate.set()


def test_a_signal_to_leave_during_output_ends_the_wait() -> None:
    """A signal wakes only once, and printing waits too."""
    console: Any = Console(100)

    def show() -> None:
        console.leaving = 15

    with pytest.raises(Gone):
        run_in_background(console, console.wait_at_gate, lambda: None, show=show)
    assert console.time == 1.0
    console.gate.set()


def test_control_c_ends_the_wait_for_work_that_can_be_cancelled() -> None:
    console: Any = Console(100)

    def press_control_c() -> None:
        console.interrupted = True

    with pytest.raises(GivenUp):
        run_in_background(console, console.wait_at_gate, lambda: None, show=press_control_c, may_be_left=True)
    assert console.time == 1.0
    console.gate.set()


def test_work_with_effects_is_waited_for_after_control_c_too() -> None:
    console: Any = Console(5)

    def press_control_c() -> None:
        console.interrupted = True

    assert run_in_background(console, console.wait_at_gate, lambda: None, show=press_control_c)
    assert console.interrupted, "it counts behind"


class Slowly:
    """What is called instead does its work once the gate is open."""

    def __init__(self, console: Any, do: Callable[..., Any]) -> None:
        self._console, self._do = console, do

    def __call__(self, *values: Any) -> Any:
        self._console.gate.wait(TIMEOUT)
        return self._do(*values)


def context(console: Any, answers: list[str]) -> Any:
    text = Document()
    text.add("fw   1")
    conversation: Any = SimpleNamespace(
        console=console,
        printer=SimpleNamespace(show=lambda: None),
        streams=SimpleNamespace(is_attended=False),
        ctx=SimpleNamespace(say=answers.append),
    )
    return SimpleNamespace(
        program=text,
        workspace=SimpleNamespace(files=()),
        donnie=SimpleNamespace(in_use=()),
        interaction=LinearInteraction(conversation),
        words=lambda code, **_: code,
        answer=lambda code, **_: answers.append(code),
    )


def test_a_slow_report_is_reported(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    console, answers = Console(5), list[str]()
    monkeypatch.setattr(files, "write_bytes", Slowly(console, write_bytes))
    drive(files._write_page(context(console, answers), str(tmp_path / "map.html"), lambda: b"a map"))

    assert answers == ["slow-report", "answer-written"]


def test_slow_formatting_is_reported(monkeypatch: pytest.MonkeyPatch) -> None:
    console, answers = Console(5), list[str]()
    monkeypatch.setattr(program, "formatted", Slowly(console, formatted))
    slow = context(console, answers)
    drive(program._lay_out(slow, None))

    assert answers == ["slow-layout", "screen-formatted"]
    assert slow.program.text == "FW 1\n"
