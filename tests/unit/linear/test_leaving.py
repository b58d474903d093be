"""A signal ends the conversation without a question: it stops the robots, then saves the text."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

from donnie_tui.linear.leaving import Leaving


def leaving_of(done: list[str], leaving: int | None = None) -> Leaving:
    """Records its calls, and can ask no question."""
    ctx: Any = SimpleNamespace(
        donnie=SimpleNamespace(team=SimpleNamespace(stop=lambda: done.append("stop"))),
        workspace=SimpleNamespace(write_copies=lambda: done.append("keep"), current_first=()),
    )
    streams: Any = SimpleNamespace(console=SimpleNamespace(leaving=leaving))
    unused: Any = None
    return Leaving(ctx, streams, unused, unused, unused, set())


def test_a_signal_stops_all_robots_and_then_keeps_the_programs() -> None:
    done: list[str] = []
    leaving = leaving_of(done)
    leaving.leave_by_signal(15)

    assert (done, leaving.code) == (["stop", "keep"], 128 + 15)


def test_a_signal_during_leaving_counts() -> None:
    done: list[str] = []
    leaving = leaving_of(done, leaving=1)
    leaving.leave(0)

    assert (done, leaving.code) == (["stop", "keep"], 128 + 1)
