"""Copies are written while the learner thinks, and soon when lines come without a pause."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from typing import Any

import pytest

from donnie_tui.linear.console import Console
from donnie_tui.linear.prompter import SOON, CopySchedule


class Typing:
    """A console at which more is typed already, or not."""

    def __init__(self) -> None:
        self.when_idle: Callable[[], None] | None = None
        self.time, self.types_on = 0.0, False

    def now(self) -> float:
        return self.time

    def has_input(self) -> bool:
        return self.types_on


class Typist:
    """Types lines; ``copies`` are what was written down."""

    def __init__(self) -> None:
        self.console: Any = Typing()
        self.lines: list[str] = []
        self.copies: list[tuple[str, ...]] = []
        self.schedule = CopySchedule(self.console, self.keep_copies)

    def keep_copies(self) -> bool:
        self.copies.append(tuple(self.lines))
        return True

    def types(self, line: str, *, more: bool) -> None:
        self.lines.append(line)
        self.console.types_on = more
        self.schedule.at_prompt()


def test_what_was_typed_before_a_pause_is_written_down_at_the_prompt() -> None:
    typist = Typist()
    typist.types("FW 1", more=False)
    typist.types("TR 90", more=False)

    assert typist.copies == [("FW 1",), ("FW 1", "TR 90")]


def test_in_a_burst_what_was_typed_is_written_down_once_nothing_more_comes() -> None:
    typist = Typist()
    for line in ("FW 1", "TR 90", "FW 2"):
        typist.types(line, more=True)
    assert typist.copies == [("FW 1",)]

    assert typist.console.when_idle is not None
    typist.console.when_idle()
    assert typist.copies == [("FW 1",), ("FW 1", "TR 90", "FW 2")]
    assert typist.console.when_idle is None


def test_a_burst_without_end_is_written_down_now_and_then() -> None:
    typist = Typist()
    for _ in range(10):
        typist.types("FW 1", more=True)
        typist.console.time += SOON / 4

    assert [len(each) for each in typist.copies] == [1, 5, 9]


def test_nothing_is_written_after_the_end() -> None:
    typist = Typist()
    typist.types("FW 1", more=True)
    typist.types("FW 2", more=True)
    typist.schedule.cancel()

    assert typist.console.when_idle is None


# --- the real console


@pytest.fixture
def keyboard() -> Iterator[int]:
    """Where to write what is typed."""
    found, (reading, writing) = os.dup(0), os.pipe()
    os.dup2(reading, 0)
    yield writing
    os.dup2(found, 0)
    for each in (found, reading, writing):
        os.close(each)


def test_a_wait_for_keys_that_were_not_typed_yet_is_idle(keyboard: int) -> None:
    console, done = Console(None), list[str]()
    console.when_idle = lambda: done.append("written")
    try:
        os.write(keyboard, b"HABL")
        assert console.wait(reading=True)
        console.wait(0)
        assert done == []

        assert console.read() == b"HABL"
        console.nudge()
        assert not console.wait(reading=True)
        assert done == ["written"]
    finally:
        console.close()


def test_a_wait_for_a_program_is_idle_too(keyboard: int) -> None:
    console, done = Console(None), list[str]()
    console.when_idle = lambda: done.append("written")
    try:
        console.nudge()
        console.wait(1.0)
        assert done == ["written"]
    finally:
        console.close()


def test_what_runs_once_idle_waits_for_a_read_and_does_not_delay_a_program(keyboard: int) -> None:
    console, done = Console(None), list[str]()
    console.once_idle.append(lambda: done.append("loaded"))
    try:
        console.nudge()
        console.wait(1.0)
        assert done == []

        for _ in range(2):
            console.nudge()
            assert not console.wait(reading=True)
        assert done == ["loaded"]
    finally:
        console.close()
