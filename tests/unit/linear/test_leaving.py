"""A signal ends the conversation: the robots first, then the text, and nobody is asked."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

from donnie_tui.linear.leaving import Leaving


def desk_of(done: list[str], leaving: int | None = None) -> Any:
    """Notes what is asked of it; it can ask nobody."""
    return SimpleNamespace(
        donnie=SimpleNamespace(team=SimpleNamespace(stop=lambda: done.append("stop"))),
        programs=SimpleNamespace(keep_for_later=lambda: done.append("keep"), all=tuple),
        console=SimpleNamespace(leaving=leaving),
        leaving=None,
    )


def test_a_signal_stops_all_robots_and_then_keeps_the_programs() -> None:
    done: list[str] = []
    desk = desk_of(done)
    Leaving(desk).leave_by_signal(15)

    assert (done, desk.leaving) == (["stop", "keep"], 128 + 15)


def test_a_signal_that_came_while_somebody_was_leaving_counts() -> None:
    done: list[str] = []
    desk = desk_of(done, leaving=1)
    Leaving(desk).leave(0)

    assert (done, desk.leaving) == (["stop", "keep"], 128 + 1)
