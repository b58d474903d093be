"""A signal ends the conversation without a question: it stops the robots, then saves the text."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest

from donnie_tui.linear.leaving import Leaving


def leaving_of(done: list[str], leaving: int | None = None) -> Leaving:
    """Records its calls, and can ask no question."""
    ctx: Any = SimpleNamespace(
        donnie=SimpleNamespace(
            team=SimpleNamespace(stop=lambda: done.append("stop")),
            site=SimpleNamespace(is_saved=True),
            rescue_world=lambda: None,
            session=SimpleNamespace(
                hub=SimpleNamespace(wait_until_delivered=lambda: done.append("delivered"))
            ),
        ),
        workspace=SimpleNamespace(
            write_copies=lambda: done.append("keep"),
            leave_copies=lambda everything: done.append("drop copies"),
            current_first=(),
        ),
        answer=done.append,
    )
    streams: Any = SimpleNamespace(console=SimpleNamespace(leaving=leaving), is_attended=True)
    printer: Any = SimpleNamespace(show=lambda: None)
    prompter: Any = SimpleNamespace(copying=SimpleNamespace(cancel=lambda: None))
    unused: Any = None
    return Leaving(ctx, streams, printer, prompter, unused, set())


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


@pytest.mark.parametrize(
    ("code", "happens"),
    [(0, ["goodbye", "delivered", "drop copies", "keep", "speak"]), (143, ["delivered"]), (2, ["delivered"])],
)
def test_a_goodbye_and_the_end_of_the_copies_come_with_code_0_only(code: int, happens: list[str]) -> None:
    done: list[str] = []
    leaving = leaving_of(done)
    leaving.code = code
    leaving.let_speak = lambda: done.append("speak")  # type: ignore[method-assign]
    leaving.say_goodbye()

    assert done == happens
