"""What takes long says so after a second and each ten; by a clock that moves when one waits."""

from __future__ import annotations

import threading
from typing import Any

import pytest

from donnie_tui.linear.console import Gone
from donnie_tui.linear.patience import GivenUp, aside


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
            self._is_over.wait(20)


@pytest.mark.parametrize(("takes", "told"), [(0.5, []), (5, [1.0]), (25, [1.0, 11.0, 21.0])])
def test_it_is_told_after_a_second_and_each_ten(takes: float, told: list[float]) -> None:
    console: Any = Console(takes)
    times: list[float] = []
    done = aside(console, lambda: console.gate.wait(20), lambda: times.append(console.time))
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
        aside(console, lambda: console.gate.wait(20), lambda: None)
    console.gate.set()


def test_whoever_has_to_leave_while_something_is_shown_waits_no_longer() -> None:
    """A signal wakes but once, and whoever prints waits too."""
    console: Any = Console(100)

    def show() -> None:
        console.leaving = 15

    with pytest.raises(Gone):
        aside(console, lambda: console.gate.wait(20), lambda: None, show=show)
    assert console.time == 1.0
    console.gate.set()


def test_whoever_gives_up_what_may_be_left_waits_no_longer() -> None:
    console: Any = Console(100)

    def press_control_c() -> None:
        console.interrupted = True

    with pytest.raises(GivenUp):
        aside(console, lambda: console.gate.wait(20), lambda: None, show=press_control_c, may_be_left=True)
    assert console.time == 1.0
    console.gate.set()


def test_what_changes_something_is_waited_for_after_control_c_too() -> None:
    console: Any = Console(5)

    def press_control_c() -> None:
        console.interrupted = True

    assert aside(console, lambda: console.gate.wait(20), lambda: None, show=press_control_c)
    assert console.interrupted, "it counts behind"
