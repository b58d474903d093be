"""A run on the screen: what is shown, said and scrolled at its beginning, at its pauses and at its end."""

from __future__ import annotations

from collections.abc import Callable
from types import SimpleNamespace as Part
from typing import Any

import pytest

from devices.ports.robot import Pose
from donnie_tui.core.events import Error, Outcome, RunEnded
from donnie_tui.core.run_state import RunState
from donnie_tui.i18n.words import Words
from donnie_tui.tui import run_view
from donnie_tui.tui.event_queue import RunBegan, RunFinished
from donnie_tui.tui.run_view import RunStateChanged, RunView

HERE = Pose(1, 2, 90)


class Recorded:
    """A part of the screen that writes down each call, with all that it was given."""

    def __init__(self, name: str, done: list[Any], **fields: Any) -> None:
        self._name, self._done = name, done
        self.__dict__.update(fields)

    def __getattr__(self, called: str) -> Callable[..., None]:
        return lambda *given, **named: self._done.append((f"{self._name} {called}", *given, *named.items()))


class Timers:
    """Timers that were set, with their seconds, until they are stopped."""

    def __init__(self) -> None:
        self.set: list[tuple[str, float, Callable[[], None]]] = []

    def timer(self, kind: str) -> Callable[[float, Callable[[], None]], Part]:
        def set_one(seconds: float, call: Callable[[], None]) -> Part:
            entry = (kind, seconds, call)
            self.set.append(entry)
            return Part(stop=lambda: self.set.remove(entry) if entry in self.set else None)

        return set_one


class Past(list[int]):
    """A timeline of so many events."""

    def __init__(self, done: list[Any], events: int) -> None:
        super().__init__(range(events))
        self._done = done

    def go_to(self, at: int) -> None:
        self._done.append(("past go_to", at))


class View:
    """The view of a run, and what it did."""

    def __init__(self, **of_runs: Any) -> None:
        self.done: list[Any] = []
        self.timers = Timers()
        self.posted: list[Any] = []
        self.app = Part(
            post_message=self.posted.append,
            set_timer=self.timers.timer("once"),
            set_interval=self.timers.timer("again"),
        )
        runs = {"is_whole": True, "is_held": False, "frames": (), "past": None, "state": RunState.READY}
        self.runs = Recorded("runs", self.done, **(runs | of_runs))
        self.session = Part(name="alice", pose=HERE)
        self.donnie = Part(session=self.session, chronicle=Part(timeline=lambda: "timeline"))
        self.ctx = Recorded("ctx", self.done, runs=self.runs, donnie=self.donnie, words=Words("en"))
        self.editor = Recorded("editor", self.done, line_count=7)
        events, display = Recorded("events", self.done), Recorded("display", self.done)
        self.view = RunView(self.app, self.ctx, events, display, self.editor)

    def does(self, call: Callable[[], object]) -> list[Any]:
        self.done.clear()
        call()
        return self.done

    @property
    def reminders(self) -> list[tuple[str, float]]:
        """The kind and the seconds of each timer that reports a slow start."""
        return [(kind, each) for kind, each, call in self.timers.set if call == self.view._report_reading]


@pytest.fixture(autouse=True)
def slow(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(run_view, "SLOW", 1.0)
    monkeypatch.setattr(run_view, "SLOW_AGAIN", 10.0)


BEGIN = RunBegan(HERE, fresh=True)


def test_a_change_of_the_run_is_posted_to_the_screen() -> None:
    it = View()
    assert it.runs.observer is it.view
    it.view.on_change()
    assert [type(each) for each in it.posted] == [RunStateChanged]


@pytest.mark.parametrize("is_whole", [True, False])
def test_a_run_begins_with_the_robot_in_its_place_and_its_own_events_follow(is_whole: bool) -> None:
    it = View(is_whole=is_whole)
    assert it.does(lambda: it.view.on_began(BEGIN)) == [
        *([("editor begin_following",)] if is_whole else []),
        ("display begin", HERE, ("fresh", True)),
        ("events begun",),
        ("display update",),
    ]
    assert it.view.polling.is_on
    assert it.reminders == ([("once", 1.0), ("again", 10.0)] if is_whole else [])
    it.runs.is_whole = False
    it.view.on_began(BEGIN)
    assert it.reminders == []


@pytest.mark.parametrize(
    ("state", "frames", "is_said"),
    [
        (RunState.RUNNING, (), True),
        (RunState.RUNNING, (Part(line=3),), False),
        (RunState.PAUSED, (), False),
        (RunState.READY, (), False),
    ],
)
def test_a_program_is_said_to_be_read_while_it_runs_and_nothing_of_it_has_begun(
    state: RunState, frames: tuple[Any, ...], is_said: bool
) -> None:
    it = View(state=state, frames=frames)
    it.view.on_began(BEGIN)
    said = it.does(it.timers.set[0][2])
    assert said == ([("ctx answer", "slow-reading", ("lines", 7))] if is_said else [])
    assert len(it.reminders) == (2 if is_said else 0)


@pytest.mark.parametrize(
    ("is_held", "frames", "is_whole", "done"),
    [
        (
            True,
            (Part(line=3), Part(line=5)),
            True,
            ["display ask_distances", ("editor go_to", 3), "editor begin_following", "events flush"],
        ),
        (True, (Part(line=3),), False, ["display ask_distances", "events flush"]),
        (True, (), True, []),
        (False, (Part(line=3),), True, []),
    ],
)
def test_a_described_pause_puts_the_cursor_to_its_line(
    is_held: bool, frames: tuple[Any, ...], is_whole: bool, done: list[Any]
) -> None:
    it = View(is_held=is_held, frames=frames, is_whole=is_whole)
    it.editor.is_edited = False
    assert it.does(it.view.on_state_changed) == [
        *(each if isinstance(each, tuple) else (each,) for each in done),
        ("display update",),
    ]


MISTAKES = (Error("syntax", 2, 5, "What?", None), Error("syntax", 4, 1, "And?", None))
ENDED = RunEnded(Outcome.FAILED, HERE, {}, 0.0)


@pytest.mark.parametrize("robot", [None, "alice"])
@pytest.mark.parametrize(
    ("errors", "is_whole", "cursor", "status"),
    [
        ((), True, [], []),
        ((), False, [], []),
        (MISTAKES, True, [("editor go_to", 2, 5)], [("display acted",), ("display looked",)]),
        (MISTAKES, False, [], [("display keep", "Error, line 2, column 5: What?")]),
    ],
)
def test_the_end_of_a_run_is_summed_up_and_its_first_mistake_is_in_the_status_line(
    robot: str | None, errors: tuple[Error, ...], is_whole: bool, cursor: list[Any], status: list[Any]
) -> None:
    it = View(is_whole=is_whole)
    it.view.on_began(BEGIN)
    assert it.does(lambda: it.view.on_finished(RunFinished(ENDED, errors, robot))) == [
        ("display ask_distances",),
        ("events take",),
        ("display end", ENDED),
        ("editor end_following",),
        *cursor,
        ("runs sum_up", robot),
        ("events flush",),
        *status,
        ("display update",),
    ]
    assert (it.view.polling.is_on, it.reminders) == (False, [])


def test_the_end_of_another_robots_run_is_judged_and_changes_nothing_else() -> None:
    it = View()
    it.view.on_began(BEGIN)
    ended = RunFinished(ENDED, MISTAKES, "bob")
    assert it.does(lambda: it.view.on_finished(ended)) == [("runs say_verdict",), ("events flush",)]
    assert (it.view.polling.is_on, len(it.reminders)) == (True, 2)


@pytest.mark.parametrize(
    ("state", "is_polled"), [(RunState.READY, False), (RunState.RUNNING, True), (RunState.PAUSED, True)]
)
def test_another_robot_has_its_own_map_with_the_way_that_it_went(state: RunState, is_polled: bool) -> None:
    it = View(state=state)
    it.view.on_began(BEGIN)
    if is_polled:
        it.view.polling.end()
    assert it.does(it.view.robot_changed) == [
        ("runs forget_ended",),
        ("display show_world",),
        ("display begin", HERE, ("fresh", True)),
        ("runs to_present",),
        ("display show_past", "timeline"),
        ("display update",),
    ]
    assert (it.view.polling.is_on, it.reminders) == (is_polled, [])


@pytest.mark.parametrize(
    ("is_whole", "frames", "cursor"),
    [(True, (Part(line=3),), [("editor go_to", 3)]), (False, (Part(line=3),), []), (True, (), [])],
)
def test_the_map_goes_back_with_step_back_and_to_the_end_of_the_way_after_it(
    is_whole: bool, frames: tuple[Any, ...], cursor: list[Any]
) -> None:
    it = View(is_whole=is_whole, frames=frames)
    assert it.does(it.view.show_past) == []
    past = it.runs.past = Past(it.done, 4)
    for _ in range(2):
        shown = it.does(it.view.show_past)
        assert shown == [("display show_slider",), ("display show_past", past), *cursor]
    it.runs.past = None
    assert it.does(it.view.show_past) == [
        ("display show_slider",),
        ("past go_to", 4),
        ("display show_past", past),
    ]
    assert it.does(it.view.show_past) == []


@pytest.mark.parametrize("name", ["on_began", "on_state_changed", "on_finished"])
def test_a_run_that_goes_on_is_shown_in_the_present(name: str) -> None:
    it = View(is_held=True, frames=(Part(line=3),))
    it.runs.past = Past(it.done, 4)
    it.view.show_past()
    it.runs.past = None
    event = {"on_began": (BEGIN,), "on_state_changed": (), "on_finished": (RunFinished(ENDED, ()),)}[name]
    assert it.does(lambda: getattr(it.view, name)(*event))[:2] == [
        ("display show_slider",),
        ("past go_to", 4),
    ]


def test_after_the_robot_has_changed_the_past_of_the_other_one_is_left() -> None:
    it = View()
    it.runs.past = Past(it.done, 4)
    it.view.show_past()
    it.view.robot_changed()
    it.runs.past = None
    assert it.does(it.view.show_past) == []
