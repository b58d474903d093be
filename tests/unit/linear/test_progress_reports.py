"""The progress reports of a silent run, by a clock that only moves during waits."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest

from donnie_tui.core.events import Outcome
from donnie_tui.linear.output import OutputQueue
from donnie_tui.linear.typed_lines import RunLoop
from donnie_tui.settings.settings import Settings


class Console:
    """Time passes during waits."""

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
    """Prints nothing, and ends after so many seconds."""

    outcome = Outcome.COMPLETED

    def __init__(self, console: Console, seconds: float) -> None:
        self._console, self._seconds = console, seconds

    @property
    def is_over(self) -> bool:
        return self._console.time >= self._seconds


def signs(seconds: float, interval: int, monkeypatch: pytest.MonkeyPatch) -> list[float]:
    """When a run of so many seconds says that it is still there."""
    console, reported_at = Console(), list[float]()
    hub = SimpleNamespace(add_gate=lambda _: _nothing)
    runs = SimpleNamespace(has_ended=lambda _: False, is_held=False, sum_up=lambda _: None)
    team, session = SimpleNamespace(wait_for_stop=_nothing), SimpleNamespace(hub=hub)
    donnie = SimpleNamespace(team=team, session=session, stop_real_robot=bool)
    ctx: Any = SimpleNamespace(runs=runs, donnie=donnie)
    streams: Any = SimpleNamespace(
        console=console,
        editing=None,
        queue=OutputQueue(_nothing),
        settings=lambda: Settings(progress=str(int(interval))),
        can_edit=True,
        takes_live_commands=False,
    )
    printer: Any = SimpleNamespace(show=_nothing)
    some: Any = SimpleNamespace()
    loop = RunLoop(ctx, streams, printer, some, some, some)
    monkeypatch.setattr(loop, "_report_progress", lambda: reported_at.append(round(console.time, 3)))
    run: Any = Run(console, seconds)
    loop.follow([(None, run)])
    return reported_at


def _nothing() -> None:
    return


def test_a_silent_run_is_reported_after_three_seconds_and_then_every_ten(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    assert signs(35.0, 10, monkeypatch) == [3.0, 13.0, 23.0, 33.0]


def test_a_run_of_less_than_three_seconds_has_no_report(monkeypatch: pytest.MonkeyPatch) -> None:
    assert signs(2.9, 10, monkeypatch) == []


def test_the_interval_can_be_chosen_or_switched_off(monkeypatch: pytest.MonkeyPatch) -> None:
    assert signs(60.0, 25, monkeypatch) == [3.0, 28.0, 53.0]
    assert signs(1000.0, 0, monkeypatch) == []
