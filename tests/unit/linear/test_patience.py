"""What takes long says so after a second and each ten; by a clock that moves when one waits."""

from __future__ import annotations

import threading
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from donnie_tui.core.documents import write_program
from donnie_tui.core.typed_program import TypedProgram
from donnie_tui.linear import mending, reports
from donnie_tui.linear.console import Gone
from donnie_tui.linear.patience import GivenUp, aside
from language.formatter import formatted
from tests.patience import PATIENCE


class Console:
    """Time passes when somebody waits; the gate opens at a certain time."""

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
            self._is_over.wait(PATIENCE)

    def wait_at_gate(self) -> bool:
        return self.gate.wait(PATIENCE)


@pytest.mark.parametrize(("takes", "told"), [(0.5, []), (5, [1.0]), (25, [1.0, 11.0, 21.0])])
def test_it_is_told_after_a_second_and_each_ten(takes: float, told: list[float]) -> None:
    console: Any = Console(takes)
    times: list[float] = []
    done = aside(console, console.wait_at_gate, lambda: times.append(console.time))
    assert done is True
    assert times == told


def test_what_it_raises_is_raised() -> None:
    console: Any = Console(0)
    with pytest.raises(ZeroDivisionError):
        aside(console, lambda: 1 // 0, lambda: None)


def test_whoever_has_to_leave_waits_no_longer() -> None:
    console: Any = Console(100)
    console.leaving = 15
    with pytest.raises(Gone):
        aside(console, console.wait_at_gate, lambda: None)
    console.gate.set()


def test_whoever_has_to_leave_while_something_is_shown_waits_no_longer() -> None:
    """A signal wakes but once, and whoever prints waits too."""
    console: Any = Console(100)

    def show() -> None:
        console.leaving = 15

    with pytest.raises(Gone):
        aside(console, console.wait_at_gate, lambda: None, show=show)
    assert console.time == 1.0
    console.gate.set()


def test_whoever_gives_up_what_may_be_left_waits_no_longer() -> None:
    console: Any = Console(100)

    def press_control_c() -> None:
        console.interrupted = True

    with pytest.raises(GivenUp):
        aside(console, console.wait_at_gate, lambda: None, show=press_control_c, may_be_left=True)
    assert console.time == 1.0
    console.gate.set()


def test_what_changes_something_is_waited_for_after_control_c_too() -> None:
    console: Any = Console(5)

    def press_control_c() -> None:
        console.interrupted = True

    assert aside(console, console.wait_at_gate, lambda: None, show=press_control_c)
    assert console.interrupted, "it counts behind"


class Slowly:
    """What is called instead does its work once the gate is open."""

    def __init__(self, console: Any, do: Callable[..., Any]) -> None:
        self._console, self._do = console, do

    def __call__(self, *values: Any) -> Any:
        self._console.gate.wait(PATIENCE)
        return self._do(*values)


def desk(console: Any, answers: list[str]) -> Any:
    program = TypedProgram()
    program.add("fw   1")
    return SimpleNamespace(
        console=console,
        showing=SimpleNamespace(show_told=lambda: None),
        program=program,
        programs=SimpleNamespace(files=()),
        donnie=SimpleNamespace(in_use=()),
        is_attended=False,
        answer=lambda code, **_: answers.append(code),
    )


def test_a_report_that_takes_long_says_so(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    console, answers = Console(5), list[str]()
    monkeypatch.setattr(reports, "write_program", Slowly(console, write_program))
    reports._write(desk(console, answers), str(tmp_path / "map.html"), "a map")

    assert answers == ["slow-report", "answer-written"]


def test_a_layout_that_takes_long_says_so(monkeypatch: pytest.MonkeyPatch) -> None:
    console, answers = Console(5), list[str]()
    monkeypatch.setattr(mending, "formatted", Slowly(console, formatted))
    slow = desk(console, answers)
    mending._lay_out(slow, None)

    assert answers == ["slow-layout", "screen-formatted"]
    assert slow.program.text == "FW 1\n"
