"""L7: what a run that tells nothing says of itself, and when; by a clock that only moves when one waits."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest

from donnie_tui.core.events import Outcome
from donnie_tui.core.watching import Watch
from donnie_tui.i18n.words import Words
from donnie_tui.linear import progress
from donnie_tui.linear.runs import Runs
from donnie_tui.linear.told import Told


class Console:
    """Time passes when somebody waits."""

    def __init__(self) -> None:
        self.time = 0.0
        self.interrupted, self.leaving = False, None

    def now(self) -> float:
        return self.time

    def wait(self, seconds: float, *, reading: bool = False) -> bool:
        self.time += seconds
        return False

    def take_interrupt(self) -> bool:
        return False


class Run:
    """Tells nothing, and is over after so many seconds."""

    outcome = Outcome.COMPLETED

    def __init__(self, console: Console, seconds: float) -> None:
        self._console, self._seconds = console, seconds

    @property
    def is_over(self) -> bool:
        return self._console.time >= self._seconds


def signs(seconds: float, interval: float, monkeypatch: pytest.MonkeyPatch) -> list[float]:
    """When a run of so many seconds says that it is still there."""
    console, told_at = Console(), list[float]()
    hub = SimpleNamespace(robot=None, subscribe=lambda _: _nothing, add_gate=lambda _: _nothing)
    desk: Any = SimpleNamespace(
        console=console,
        session=SimpleNamespace(hub=hub),
        donnie=SimpleNamespace(team=SimpleNamespace(settle=_nothing), stop_real_robot=bool),
        ends=SimpleNamespace(habits=SimpleNamespace(progress=interval), can_edit=True, hears_live=False),
        watch=Watch(Words()),
        say=None,
        beside=SimpleNamespace(is_watching=False),
        showing=SimpleNamespace(show_told=_nothing),
    )
    monkeypatch.setattr(progress, "sign_of_life", lambda _: told_at.append(round(console.time, 3)))
    made = Runs(desk, Told(_nothing), lambda _: None, lambda: False)
    run: Any = Run(console, seconds)
    made.watch_together(lambda: (("typed", run),))
    return told_at


def _nothing() -> None:
    return


def test_after_three_seconds_it_says_so_and_then_at_most_every_ten(monkeypatch: pytest.MonkeyPatch) -> None:
    assert signs(35.0, 10.0, monkeypatch) == [3.0, 13.0, 23.0, 33.0]


def test_what_is_over_in_three_seconds_says_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    assert signs(2.9, 10.0, monkeypatch) == []


def test_the_interval_can_be_chosen_and_never_is_never(monkeypatch: pytest.MonkeyPatch) -> None:
    assert signs(60.0, 25.0, monkeypatch) == [3.0, 28.0, 53.0]
    assert signs(1000.0, 0.0, monkeypatch) == []
