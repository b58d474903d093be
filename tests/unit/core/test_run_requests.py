"""What requests to the runs of one or two robots change: what front ends see, and what is answered."""

import threading
import time
from collections.abc import Callable, Iterator
from typing import Any

import pytest

from devices.ports.robot import Pace, Pose, Watcher
from donnie_tui.core import run_controller
from donnie_tui.core.events import (
    Answered,
    CueSounded,
    Error,
    Outcome,
    Reset,
    RunEnded,
    Spoke,
    Stamped,
    event_name,
)
from donnie_tui.core.hub import Stream
from donnie_tui.core.run_controller import RunController
from donnie_tui.core.run_state import NothingRuns, NothingToRun, RunObserver, RunState, hints_for
from donnie_tui.core.runner import Run, RunRequest
from donnie_tui.core.session import Busy, Session, SessionSetup
from donnie_tui.core.team import Team
from donnie_tui.core.timeline import Chronicle
from donnie_tui.i18n.words import Words
from language.control import ControlState, ExecutionControl
from sim.robot import SimulatedRobot
from sim.world import World
from tests.floor import floor
from tests.timeouts import TIMEOUT

ENDLESS = "WHILE 1 == 1 DO\nWAIT 1\nEND WHILE"
COMPUTING = "VAR x = 0\nWHILE 1 == 1 DO\nx = x + 1\nEND WHILE"


class Room(RunObserver):
    """Robots that each have a floor of their own, their runs, and what was published and noticed."""

    def __init__(
        self, *names: str, speed: float | None = None, detail: str = "brief", **options: bool
    ) -> None:
        self.words, stream, self.chronicle = Words("en", detail), Stream(), Chronicle()

        def make_robot(pace: Pace, watcher: Watcher) -> SimulatedRobot:
            return World(floor()).robot(pace=pace, watcher=watcher, speed=speed)

        def make_session(name: str) -> Session:
            setup = SessionSetup("floor", seed=0, terminal=True, name=name if names else None)
            return Session(make_robot, self.words, setup, stream=stream)

        self.team = Team(names or ("donnie",), make_session, stream)
        self.events: list[Stamped] = []
        self.noticed: list[str] = []
        self.changes: list[tuple[bool, bool]] = []
        """At each: whether the program was held, and whether it had ended."""
        self._changed = threading.Condition()
        stream.subscribe(self.chronicle)
        stream.subscribe(self.events.append)
        self.runs = RunController(self.team, self.words, self.chronicle, **options)
        self.runs.observer = self

    def on_change(self) -> None:
        self.changes.append((self.runs.is_held, self.runs.has_ended(self.robot)))
        with self._changed:
            self._changed.notify_all()

    def before_stop(self) -> None:
        self.noticed.append("before")

    def after_stop(self) -> None:
        self.noticed.append("after")

    def until(self, happened: Callable[[], bool]) -> None:
        """Looks again from time to time: not everything that a program does is reported as a change."""
        end = time.monotonic() + TIMEOUT
        with self._changed:
            while not happened():
                assert time.monotonic() < end
                self._changed.wait(0.01)

    @property
    def answers(self) -> list[str]:
        return [each.event.text for each in self.events if isinstance(each.event, Answered)]

    @property
    def robot(self) -> str | None:
        return self.team.chosen.hub.robot

    def start(self, text: str, *, is_whole: bool = True, begin: Any = None, **options: Any) -> Run:
        return self.runs.start(RunRequest(text, "test.gd", is_whole=is_whole), begin=begin, **options)

    def hold(self, text: str, *, is_whole: bool = True) -> Run:
        """Starts a program that is held before its first statement."""
        run = self.start(text, is_whole=is_whole, begin=ExecutionControl.step)
        self.until(lambda: self.runs.is_held)
        return run

    def go_on(self, request: Callable[[], object]) -> None:
        request()
        self.until(lambda: self.runs.is_held)

    def run(self, text: str, *, is_whole: bool = True) -> list[str]:
        """The answers to one more program that runs to its end."""
        before = len(self.answers)
        assert self.start(text, is_whole=is_whole).wait(TIMEOUT)
        self.runs.sum_up(self.robot)
        return self.answers[before:]

    def event_at(self, seq: int) -> str:
        return next(event_name(each.event) for each in self.events if each.seq == seq)


@pytest.fixture
def room() -> Iterator[Callable[..., Room]]:
    made: list[Room] = []

    def make(*names: str, **options: Any) -> Room:
        made.append(Room(*names, **options))
        return made[-1]

    yield make
    for each in made:
        each.team.close()


# --- what front ends see


def test_before_any_run_there_is_nothing_to_see(room: Callable[..., Room]) -> None:
    runs = room().runs

    assert (runs.is_whole, runs.text_on_its_way, runs.frames, runs.past_steps) == (False, None, (), None)
    assert (runs.is_busy, runs.is_steppable, runs.is_held, runs.knows_variables) == (
        False,
        False,
        False,
        True,
    )
    assert (runs.worked_out, runs.has_ended(None), runs.is_verdict_due) == ((), False, False)


@pytest.mark.parametrize("is_whole", [True, False])
def test_a_whole_program_is_on_its_way_until_it_is_stopped(room: Callable[..., Room], is_whole: bool) -> None:
    it = room(speed=1.0)
    runs, text = it.runs, ENDLESS if is_whole else None
    run = it.hold(ENDLESS, is_whole=is_whole)
    assert (runs.is_whole, runs.text_on_its_way) == (is_whole, text)
    assert (runs.is_busy, runs.is_steppable, runs.is_held, runs.has_ended(None)) == (True, True, True, False)
    runs.continue_()
    assert (runs.text_on_its_way, runs.is_held, runs.is_steppable) == (text, False, True)
    runs.stop()
    assert run.wait(TIMEOUT)
    assert (runs.text_on_its_way, runs.state, runs.is_busy) == (None, RunState.STOPPING, True)
    assert (runs.is_steppable, runs.has_ended(None), runs.is_whole) == (False, True, is_whole)
    runs.sum_up(None)
    assert (runs.state, runs.is_busy) == (RunState.READY, False)


def test_a_front_end_is_called_at_a_hold_and_at_the_end(room: Callable[..., Room]) -> None:
    it = room()
    run = it.hold("FW 1")
    it.until(lambda: (True, False) in it.changes)
    assert (False, True) not in it.changes
    it.runs.continue_()
    assert run.wait(TIMEOUT)

    assert (False, True) in it.changes


def test_only_a_held_program_has_expressions_that_are_worked_out(room: Callable[..., Room]) -> None:
    it = room()
    run = it.hold("FW 1 + 2\nFW 3 + 4")
    assert it.runs.worked_out == (("1 + 2", "3"),)
    it.go_on(it.runs.step)
    assert it.runs.worked_out == (("3 + 4", "7"),)
    it.runs.step_back()
    assert (it.runs.worked_out, it.runs.knows_variables) == ((("1 + 2", "3"),), True)
    it.runs.to_present()
    it.runs.continue_()
    assert run.wait(TIMEOUT)
    it.runs.sum_up(None)
    assert it.runs.worked_out == ()
    it.runs.step_back()
    it.runs.step_back()
    assert it.runs.worked_out == (("3 + 4", "7"),)


def test_a_position_of_the_past_is_looked_at_from_either_side(room: Callable[..., Room]) -> None:
    """Start, walk, turn, speech and end are five steps."""
    it = room(detail="normal")
    runs = it.runs
    assert runs.step_back() == (it.words("undone-start"),)
    assert (runs.past, runs.past_steps) == (None, None)
    it.run("FW 1\nTR 90\nSPEAK 7")
    assert runs.look_at(3) == ()  # in the present

    looking = it.words("looking-back")
    assert runs.step_back() == (looking, "Back: end of the program. Position 0, 1.")
    assert runs.past_steps == (4, 5)
    assert runs.look_at(2) == ("Before TR 90: facing north.",)
    assert (runs.past_steps, runs.worked_out) == ((2, 5), ())
    assert runs.look_at(2) == ()
    assert runs.look_at(-5) == (it.words("undone-start"),)
    assert runs.past_steps == (0, 5)
    assert runs.look_at(4)[-1] == "7"
    assert runs.past_steps == (4, 5)
    assert runs.look_at(99)[-1] == it.words("looking-back-ended")
    assert (runs.past, runs.past_steps, runs.to_present()) == (None, None, ())
    runs.step_back()
    assert runs.to_present() == (it.words("looking-back-ended"),)


@pytest.mark.parametrize(
    ("event", "is_past"), [(CueSounded("done", 0.0, None), False), (Spoke("1"), False), (Answered("1"), True)]
)
def test_what_happens_ends_the_way_back_and_an_answer_does_not(
    room: Callable[..., Room], event: Any, is_past: bool
) -> None:
    it = room()
    it.run("FW 1")
    it.runs.step_back()
    it.team.chosen.hub.publish(event)

    assert (it.runs.past is not None) is is_past


def test_a_new_start_a_reset_and_a_request_end_the_way_back(room: Callable[..., Room]) -> None:
    it = room()
    it.run("FW 2")
    it.runs.step_back()
    it.runs.reset()
    assert it.runs.past is None
    assert it.team.chosen.pose == Pose(0, 0, 0)
    assert isinstance(it.events[-1].event, Reset)
    it.hold("FW 1\nFW 2\nFW 3")
    it.go_on(it.runs.step)
    it.runs.step_back()
    it.go_on(lambda: it.runs.run_to(3))
    assert (it.runs.past, it.runs.frames[0].line) == (None, 3)


def test_variables_are_kept_during_the_movements_of_programs_of_several_lines(
    room: Callable[..., Room], monkeypatch: pytest.MonkeyPatch
) -> None:
    it = room()
    it.run("VAR a = 1 FW a")
    assert it.runs.variables_during == {}
    it.run("VAR a = 1\nFW a\nPROCEDURE P: n DO\nTR n\nEND PROCEDURE\nP [90]\na = 2\nWAIT a")

    kept = [(it.event_at(seq), variables) for seq, variables in it.runs.variables_during.items()]
    assert kept == [("moved", (("a", 1),)), ("turned", (("a", 1),)), ("waited", (("a", 2),))]
    monkeypatch.setattr(run_controller, "MOST_KEPT", 2)
    last = list(it.runs.variables_during.items())[-1]
    it.run("FW 1\nVAR b = 1\nTR b")
    assert next(iter(it.runs.variables_during.items())) == last
    assert len(it.runs.variables_during) == 2


@pytest.mark.parametrize("name", [None, "alice"])
def test_a_program_that_the_front_end_did_not_start_runs_too(
    room: Callable[..., Room], name: str | None
) -> None:
    it = room(*([name] if name else []), speed=1.0)
    held = threading.Event()

    def hold(control: ExecutionControl) -> None:
        control.observe(lambda state: held.set() if state is ControlState.PAUSED else None)
        control.step()

    run = it.team.chosen.start(ENDLESS, "a.gd", prepare=hold)
    assert held.wait(TIMEOUT)
    assert (it.runs.state, it.runs.is_held, it.runs.is_steppable) == (RunState.PAUSED, False, False)
    assert it.runs.pause() is True
    it.runs.continue_()
    assert it.runs.state is RunState.RUNNING
    assert it.runs.pause() is True
    it.runs.stop()
    assert run.is_over
    assert it.runs.state is RunState.READY
    assert it.answers[-1].endswith("Stopped.")


def test_the_events_of_a_run_that_the_front_end_did_not_start_leave_no_traces(
    room: Callable[..., Room],
) -> None:
    it = room()
    it.run("VAR a = 1\nFW a")
    kept = dict(it.runs.variables_during)
    assert it.team.chosen.start("VAR b = 1\nTR b", "b.gd").wait(TIMEOUT)

    assert it.runs.variables_during == kept


def test_of_a_program_of_one_line_no_calls_are_kept(room: Callable[..., Room]) -> None:
    it = room()
    for text, line in (("SPEAK 1 SPEAK 2", None), ("SPEAK 1\nSPEAK 2", 2)):
        it.run(text)
        it.runs.step_back()  # the end
        it.runs.step_back()
        assert [each.line for each in it.runs.frames] == ([] if line is None else [line])
        assert it.runs.knows_variables is (line is not None)


# --- starting


@pytest.mark.parametrize(
    ("has_prompt", "is_whole", "is_background", "outcome"),
    [
        (True, True, False, Outcome.QUIT),
        (True, False, False, Outcome.QUIT),
        (True, True, True, Outcome.FAILED),
        (True, False, True, Outcome.QUIT),
        (False, True, False, Outcome.FAILED),
        (False, False, False, Outcome.QUIT),
    ],
)
def test_quit_is_for_a_prompt_and_for_a_typed_line(
    room: Callable[..., Room], has_prompt: bool, is_whole: bool, is_background: bool, outcome: Outcome
) -> None:
    run = room(has_prompt=has_prompt).start("QUIT", is_whole=is_whole, is_background=is_background)

    assert run.wait(TIMEOUT)
    assert run.outcome is outcome


def test_a_whole_program_begins_anew_and_a_typed_line_goes_on(room: Callable[..., Room]) -> None:
    it = room()
    it.run("VAR a = 2\nFW a")
    it.run("FW a", is_whole=False)
    assert it.team.chosen.pose == Pose(0, 4, 0)
    it.run("FW 1")
    assert (it.team.chosen.pose, it.team.chosen.variables) == (Pose(0, 1, 0), {})


def test_a_typed_line_has_its_number_in_the_program(room: Callable[..., Room]) -> None:
    it = room()
    run = it.runs.start(RunRequest("SPEAK q", "a.gd", first_line=7, is_whole=False))

    assert run.wait(TIMEOUT)
    (error,) = [each.event for each in it.events if isinstance(each.event, Error)]
    assert (error.line, run.name) == (7, "a.gd")


def test_what_is_refused_names_the_robot_that_is_busy(room: Callable[..., Room]) -> None:
    it = room("alice", "bob", speed=1.0)
    it.hold(ENDLESS)
    for request in (lambda: it.start("FW 1"), it.runs.reset):
        with pytest.raises(Busy) as busy:
            request()
        assert busy.value.args == ("alice",)
    it.team.choose("bob")
    assert (it.runs.state, it.runs.is_held, it.runs.is_whole) == (RunState.READY, False, False)
    for refused in (it.runs.pause, it.runs.stop, it.runs.continue_, it.runs.step, it.runs.step_over):
        with pytest.raises(NothingRuns):
            refused()


@pytest.mark.parametrize(
    ("options", "begin", "is_held"),
    [
        ({}, None, True),  # a pause can come at any time
        ({"can_hold": True}, None, True),
        ({"can_hold": False}, None, False),
        ({"can_hold": False}, lambda control: control.break_at({9}), True),
    ],
)
def test_a_program_is_held_between_its_statements_only_if_a_request_for_that_can_come(
    room: Callable[..., Room], options: dict[str, bool], begin: Any, is_held: bool
) -> None:
    it = room(**options)

    def set_breakpoint(stamped: Stamped) -> None:
        if isinstance(stamped.event, Spoke):
            it.runs.break_at(frozenset({2}))

    it.team.stream.subscribe(set_breakpoint)
    run = it.start("SPEAK 1\nFW 2", begin=begin)
    if is_held:
        it.until(lambda: it.runs.is_held)
        it.runs.stop()

    assert run.wait(TIMEOUT)
    assert run.outcome is (Outcome.STOPPED if is_held else Outcome.COMPLETED)


def test_a_typed_line_that_is_stepped_through_is_quoted_from_the_whole_program(
    room: Callable[..., Room],
) -> None:
    it = room()
    lines = ("SPEAK 1", "SPEAK 2", "FW 7")
    request = RunRequest("FW 7", first_line=3, is_whole=False, lines=lines)
    it.runs.start(request, begin=ExecutionControl.step)
    it.until(lambda: it.runs.is_held)

    assert it.answers == ["Line 3: FW 7"]


@pytest.mark.parametrize("is_background", [True, False])
def test_breakpoints_hold_every_program_but_one_that_runs_unattended(
    room: Callable[..., Room], is_background: bool
) -> None:
    it = room(can_hold=False, has_prompt=True)
    request = RunRequest("FW 1\nFW 2", breakpoints=frozenset({2}))
    run = it.runs.start(request, is_background=is_background)
    if is_background:
        assert run.wait(TIMEOUT)
        assert run.outcome is Outcome.COMPLETED
    else:
        it.until(lambda: it.runs.is_held)
        assert it.answers == ["Line 2: FW 2"]


def test_a_variable_is_watched_where_no_request_can_come(room: Callable[..., Room]) -> None:
    it = room(can_hold=False)
    it.runs.toggle_watch("n")

    assert it.run("VAR n = 1\nn = 2\nn = 3") == ["n is 1.", "n is 2.", "n is 3.", "The program is done."]


def test_programs_that_were_given_start_together(room: Callable[..., Room]) -> None:
    it = room("alice", "bob", has_prompt=True)
    with pytest.raises(NothingToRun):
        it.runs.start_together()
    it.team.give("bob", RunRequest("FW 2\nQUIT", "b.gd"))
    it.team.give("alice", RunRequest(" \n", "a.gd"))
    runs = it.runs.start_together()

    assert [*runs] == ["bob"]
    assert runs["bob"].wait(TIMEOUT)
    assert (runs["bob"].outcome, it.team.session("bob").pose.y) == (Outcome.FAILED, 2)
    it.team.give("alice", RunRequest("VAR a = 1", "a.gd"))
    it.team.give("bob", RunRequest("VAR a = 1", "b.gd"))
    it.team.choose("bob")
    runs = it.runs.start_together()
    assert [*runs] == ["alice", "bob"]
    for each in runs.values():
        assert each.wait(TIMEOUT)
    assert it.runs.has_ended("alice")
    assert it.runs.has_ended("bob")
    assert sorted(it.answers) == ["alice: Done.", "bob: Done."]
    assert (it.runs.is_steppable, it.runs.is_whole) == (False, True)
    assert it.runs.state is RunState.STOPPING
    it.runs.sum_up("bob")
    assert it.runs.state is RunState.READY


def test_robots_do_not_start_together_while_one_of_them_runs(room: Callable[..., Room]) -> None:
    it = room("alice", "bob", speed=1.0)
    it.team.give("alice", RunRequest(ENDLESS))
    it.team.choose("bob")
    it.start(ENDLESS)
    assert [*it.runs.start_together()] == ["alice"]  # bob was given nothing
    it.team.give("bob", RunRequest("FW 1"))
    with pytest.raises(Busy) as busy:
        it.runs.start_together()
    assert busy.value.args == ("alice",)


@pytest.mark.parametrize("is_together", [True, False])
def test_a_start_waits_for_the_end_of_a_program_that_is_being_stopped(
    room: Callable[..., Room], monkeypatch: pytest.MonkeyPatch, is_together: bool
) -> None:
    it, may_end = room(has_prompt=True), threading.Event()
    session = it.team.chosen

    def hang(stamped: Stamped) -> None:
        if isinstance(stamped.event, RunEnded) and stamped.event.outcome is Outcome.STOPPED:
            assert may_end.wait(TIMEOUT)

    it.team.stream.subscribe(hang)
    wait = session.wait_for_stop

    def let_it_end() -> bool:
        may_end.set()
        return wait()

    run = it.start("WHILE 1 == 1 DO\nEND WHILE", is_background=True)
    it.until(lambda: bool(it.runs.frames))
    monkeypatch.setattr(session, "wait_for_stop", let_it_end)
    session.stop()
    it.team.give("donnie", RunRequest("SPEAK 1"))
    runs = (
        it.runs.start_together()
        if is_together
        else {"donnie": it.runs.start_in_background(RunRequest("SPEAK 1"))}
    )

    assert run.is_over
    assert runs["donnie"].wait(TIMEOUT)


# --- pauses, steps and watched variables


def test_a_program_in_the_background_is_paused_where_it_waits_for_its_robot(
    room: Callable[..., Room],
) -> None:
    it = room(speed=1.0, has_prompt=True)
    it.runs.start_in_background(RunRequest(ENDLESS, "a.gd"))
    it.team.chosen.wait_until_acting(TIMEOUT)

    for _ in range(2):
        assert it.runs.pause() is True
    assert (it.runs.state, it.runs.is_held) == (RunState.PAUSED, False)
    assert it.answers == ["donnie begins.", "Paused at line 2."]


def test_a_program_in_the_background_may_not_pause_in_time(
    room: Callable[..., Room], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(run_controller, "LONGEST_PAUSE", 0.01)
    it, speaks, may_go_on = room(has_prompt=True), threading.Event(), threading.Event()

    def hang(stamped: Stamped) -> None:
        if isinstance(stamped.event, Spoke):
            speaks.set()
            assert may_go_on.wait(TIMEOUT)

    it.team.stream.subscribe(hang)
    run = it.runs.start_in_background(RunRequest("SPEAK 1", "a.gd"))
    assert speaks.wait(TIMEOUT)

    assert it.runs.pause() is False
    may_go_on.set()
    it.runs.stop()
    assert run.wait(TIMEOUT)


def test_a_pause_between_two_statements_names_the_line_of_the_next_one(room: Callable[..., Room]) -> None:
    it = room()

    def pause(stamped: Stamped) -> None:
        if isinstance(stamped.event, Spoke):
            it.runs.pause()

    it.team.stream.subscribe(pause)
    it.start("SPEAK 1\nFW 1\nFW 2")
    it.until(lambda: it.runs.is_held)
    assert it.answers == ["Paused at line 2.", "Line 2: FW 1"]
    it.go_on(it.runs.step)
    assert it.answers[2:] == ["Line 3: FW 2"]


def test_a_step_into_a_call_holds_in_it_and_a_step_over_it_after_it(room: Callable[..., Room]) -> None:
    text = "PROCEDURE P DO\nFW 1\nEND PROCEDURE\nP []\nFW 2"
    for request, line in ((RunController.step, 2), (RunController.step_over, 5)):
        it = room()
        it.hold(text)
        it.go_on(lambda it=it: it.runs.run_to(4))
        it.go_on(lambda it=it, request=request: request(it.runs))
        assert it.runs.frames[0].line == line


def test_after_a_step_over_the_way_back_goes_forward_by_steps(room: Callable[..., Room]) -> None:
    it = room(detail="normal")
    it.run("FW 1\nFW 2")
    it.runs.step_back()
    it.runs.step_back()
    before = len(it.answers)
    it.runs.step_over()
    it.runs.step()

    assert it.answers[before:] == [
        "I walked 2 steps forward.",
        it.words("redone", what=it.words("undone-run-ended")),
        it.words("looking-back-ended"),
    ]


def test_what_ran_on_is_undone_event_by_event(room: Callable[..., Room]) -> None:
    it = room()
    it.hold("FW 1\nFW 1\nFW 1\nFW 1")
    it.go_on(lambda: it.runs.run_to(4))

    assert it.runs.step_back()[-1] == "Before FW 1: position 0, 2."
    assert it.runs.step_back()[-1] == "Before FW 1: position 0, 1."


@pytest.mark.parametrize(
    ("request_", "text", "said"),
    [
        (RunController.continue_, "VAR a = 1", ["Done."]),
        (RunController.continue_, "SPEAK 1", []),
        (RunController.step, "SPEAK 1", ["Done."]),  # the learner waits for what it does
        (lambda runs: runs.run_to(9), "VAR a = 1", ["Done."]),
        (lambda runs: runs.run_to(9), "SPEAK 1", []),
    ],
)
def test_the_end_after_a_request_is_said_if_nothing_was_said_since_or_it_was_a_step(
    room: Callable[..., Room], request_: Callable[[RunController], object], text: str, said: list[str]
) -> None:
    it = room(has_prompt=True)
    run = it.hold(text)
    before = len(it.answers)
    request_(it.runs)
    assert run.wait(TIMEOUT)
    it.runs.sum_up(None)

    assert it.answers[before:] == said


def test_a_variable_is_watched_no_more_in_the_middle_of_a_run(room: Callable[..., Room]) -> None:
    it = room()
    it.runs.toggle_watch("n")
    assert it.runs.toggle_watch("m") == ("I will say when m changes.",)
    both = ("I will say when n changes.", "I will say when m changes.")
    assert it.runs.toggle_watch("") == both
    run = it.hold("VAR n = 1\nVAR m = 1\nn = 2\nm = 2\nSPEAK 1")
    it.go_on(lambda: it.runs.run_to(3))
    before = len(it.answers)
    it.runs.toggle_watch("N")
    it.runs.continue_()
    assert run.wait(TIMEOUT)
    assert it.answers[before:] == ["m is 2."]
    assert it.runs.watched == ["m"]


def test_watched_variables_are_not_looked_at_after_a_refused_run(room: Callable[..., Room]) -> None:
    it = room(has_prompt=True)
    it.runs.toggle_watch("n")
    assert it.run("VAR n = 1") == ["n is 1."]
    before = len(it.answers)
    it.run("FWD 1")
    assert not [each for each in it.answers[before:] if each.startswith("n ")]


def test_breakpoints_are_not_set_in_a_typed_line_without_a_prompt(room: Callable[..., Room]) -> None:
    for options, is_whole, is_held in (
        ({}, False, False),
        ({}, True, True),
        ({"has_prompt": True}, False, True),
    ):
        it = room(**options)
        run = it.hold("FW 1\nFW 2\nFW 3", is_whole=is_whole)
        it.runs.break_at(frozenset({3}))
        it.runs.continue_()
        if is_held:
            it.until(lambda it=it: it.runs.is_held)
            assert it.runs.frames[0].line == 3
        else:
            assert run.wait(TIMEOUT)


# --- stops


@pytest.mark.parametrize("is_background", [True, False])
def test_the_end_of_a_stopped_program_is_answered_once(
    room: Callable[..., Room], is_background: bool
) -> None:
    """At once, if no prompt waits for it."""
    it = room(speed=1.0, has_prompt=True)
    run = it.start("WAIT 1000", is_background=is_background)
    it.team.chosen.wait_until_acting(TIMEOUT)
    it.runs.stop()
    assert it.noticed == ["before", *["after"] * is_background]
    assert run.wait(TIMEOUT)
    for _ in range(2):
        it.runs.sum_up(None)

    started = ["donnie begins."] * is_background
    assert it.answers[: len(started)] == started
    assert it.answers[len(started) :] == ["Stopped at line 1."] * (1 + is_background)


def test_a_program_that_was_stopped_elsewhere_has_no_line(room: Callable[..., Room]) -> None:
    it = room(speed=1.0)
    run = it.start(ENDLESS)
    it.team.stop()
    assert run.wait(TIMEOUT)
    it.runs.sum_up(None)

    assert (it.answers, it.noticed) == (["Stopped."], [])


def test_a_stop_of_all_ends_every_program_and_is_answered_for_all(room: Callable[..., Room]) -> None:
    it = room("alice", "bob", speed=1.0)
    assert it.runs.stop_all() is False
    runs = []
    for name in ("alice", "bob"):
        it.team.choose(name)
        runs.append(it.start(ENDLESS))
    it.noticed.clear()
    assert it.runs.stop_all() is True
    assert it.noticed == ["before"]
    for run in runs:
        assert run.wait(TIMEOUT)
        assert run.outcome is Outcome.STOPPED
    for name in ("alice", "bob"):
        it.runs.sum_up(name)
    assert it.answers == []
    assert it.run("VAR a = 1") == ["bob: The program is done."]  # the next run is not stopped


def test_a_stop_of_all_waits_for_programs_that_no_front_end_follows(room: Callable[..., Room]) -> None:
    it = room("alice", "bob", speed=1.0, has_prompt=True)
    run = it.start(ENDLESS, is_background=True)
    assert it.runs.stop_all() is True
    assert (run.is_over, it.noticed) == (True, ["before", "after"])
    it.runs.sum_up("alice")
    assert it.answers == ["alice begins."]


def test_a_stop_of_all_robots_of_a_world_of_one_is_a_stop(room: Callable[..., Room]) -> None:
    it = room(speed=1.0)
    run = it.hold(ENDLESS)
    assert it.runs.stop_all() is True
    assert run.wait(TIMEOUT)
    it.runs.sum_up(None)
    assert it.answers[-1] == "Stopped at line 1."
    with pytest.raises(NothingRuns):
        it.runs.stop_all()


@pytest.mark.parametrize(
    ("names", "said"), [((), "Stopped at line 1."), (("alice", "bob"), "All robots have stopped.")]
)
def test_programs_are_stopped_and_answered_before_a_front_end_ends(
    room: Callable[..., Room], names: tuple[str, ...], said: str
) -> None:
    it = room(*names, speed=1.0)
    it.runs.stop_to_leave()
    assert (it.answers, it.noticed) == ([], [])
    run = it.hold(ENDLESS)
    before = len(it.answers)
    it.runs.stop_to_leave()

    assert (run.is_over, run.outcome, it.noticed) == (True, Outcome.STOPPED, ["before", "after"])
    it.runs.sum_up(it.robot)
    assert it.answers[before:] == [said]


# --- sums


def test_the_end_of_a_run_is_said_once_or_not_after_another_robot_was_chosen(
    room: Callable[..., Room],
) -> None:
    it = room("alice", "bob", has_prompt=True)
    it.runs.sum_up("alice")
    it.runs.forget_ended()
    assert it.run("VAR a = 1") == ["alice: Done."]
    it.runs.sum_up("alice")
    assert it.answers == ["alice: Done."]
    assert it.start("VAR a = 1").wait(TIMEOUT)
    assert it.runs.state is RunState.STOPPING
    it.runs.forget_ended()
    assert it.runs.state is RunState.READY
    it.runs.sum_up("alice")
    assert it.answers == ["alice: Done."]


@pytest.mark.parametrize(
    ("text", "said"),
    [("VAR a = 1", ["Done."]), ("SPEAK 1", []), ("SPEAK q", []), ("WHILE 1 == 1 DO\nEND WHILE", None)],
)
def test_a_silent_program_in_the_background_is_done_at_its_end_and_not_at_a_stop(
    room: Callable[..., Room], text: str, said: list[str] | None
) -> None:
    it = room(has_prompt=True)
    run = it.runs.start_in_background(RunRequest(text))
    if said is None:
        it.until(lambda: bool(it.runs.frames))
        it.runs.forget_ended()
        assert it.runs.state is RunState.RUNNING  # it has not ended
        it.runs.stop()
    assert run.wait(TIMEOUT)

    assert it.answers == ["donnie begins.", *(["Stopped at line 1."] if said is None else said)]


@pytest.mark.parametrize("is_background", [True, False])
def test_words_of_another_robot_break_only_the_silence_that_the_learner_listens_to(
    room: Callable[..., Room], is_background: bool
) -> None:
    it = room("alice", "bob", has_prompt=True)
    run = it.start("WHILE 1 == 1 DO\nEND WHILE", is_background=is_background)
    it.until(lambda: bool(it.runs.frames))
    it.team.choose("bob")
    assert it.start("SPEAK 1").wait(TIMEOUT)
    assert it.runs._records["alice"].is_silent is is_background
    assert it.runs._records["bob"].is_silent is False
    it.team.stop()
    assert run.wait(TIMEOUT)


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("VAR a = 1", ["Done."]),
        ("FW 1", []),
        ("SPEAK 1", []),
        ('SPEAK ""', ["Done."]),
        ('SPEAK " "', ["Done."]),
        ("FW 1 / 0", []),
        ("SPEAK 1\nVAR a = 1", []),
    ],
)
def test_a_program_that_said_nothing_is_done(room: Callable[..., Room], text: str, said: list[str]) -> None:
    assert room(has_prompt=True).run(text) == said


def test_without_a_prompt_only_the_end_of_a_whole_program_or_a_silent_line_is_said(
    room: Callable[..., Room],
) -> None:
    it = room()
    assert it.run("SPEAK 1", is_whole=False) == []
    assert it.run("VAR a = 1", is_whole=False) == ["Done."]
    assert it.run("SPEAK 1") == ["The program is done."]


def test_three_hints_are_said_of_a_text_of_at_most_fifty_thousand_characters(
    room: Callable[..., Room],
) -> None:
    it = room()
    text = "DISTANCE F\n" * 4
    said = hints_for(text, it.team.chosen, it.words)
    assert said == ("DISTANCE alone does nothing.", "Did you mean SPEAK DISTANCE F?") * 3
    assert it.run(text)[:-1] == [*said]
    longest = text.ljust(50_000)
    assert hints_for(longest, it.team.chosen, it.words) == said
    assert hints_for(f"{longest} ", it.team.chosen, it.words) == ()


# --- verdicts


class Judge:
    """Keeps what it was asked about, and says the same of each."""

    def __init__(self, it: Room) -> None:
        self.asked: list[tuple[bool, bool]] = []
        it.runs.judge = self

    def __call__(self, is_program: bool, is_asked: bool) -> tuple[str, ...]:
        self.asked.append((is_program, is_asked))
        return ("Well.",)


@pytest.mark.parametrize(
    ("text", "is_whole", "asked"),
    [
        ("FW 1", True, [(True, True)]),
        ("FW 1", False, [(False, True)]),
        ("FW 1\n", False, [(False, True)]),
        ("FW 1\nFW 1", False, [(True, True)]),
        ("FW 1 / 0", True, [(True, True)]),
        ("FWD 1", True, []),  # refused
        ("QUIT", False, []),
    ],
)
def test_a_run_that_ended_by_itself_is_judged(
    room: Callable[..., Room], text: str, is_whole: bool, asked: list[tuple[bool, bool]]
) -> None:
    it = room()
    judge = Judge(it)
    answers = it.run(text, is_whole=is_whole)

    assert judge.asked == asked
    assert answers[-1:] == ["Well."] if asked else "Well." not in answers
    it.runs.say_verdict()
    assert judge.asked == asked  # once


@pytest.mark.parametrize(
    ("options", "is_background", "is_asked"),
    [
        ({"has_prompt": True}, False, True),
        ({"has_prompt": True}, True, False),
        ({}, True, True),
        ({"can_hold": False}, False, False),
    ],
)
def test_a_question_follows_a_verdict_where_the_learner_can_answer(
    room: Callable[..., Room], options: dict[str, bool], is_background: bool, is_asked: bool
) -> None:
    it = room(**options)
    judge = Judge(it)
    assert it.start("FW 1", is_background=is_background).wait(TIMEOUT)
    assert it.runs.is_verdict_due is is_background
    it.runs.sum_up(None)

    assert judge.asked == [(True, is_asked)]
    assert it.runs.is_verdict_due is False


def test_a_stopped_run_gets_no_verdict(room: Callable[..., Room]) -> None:
    it = room(speed=1.0)
    judge = Judge(it)
    run = it.hold(ENDLESS)
    it.runs.stop()
    assert run.wait(TIMEOUT)
    it.runs.sum_up(None)

    assert judge.asked == []


def test_programs_in_the_background_get_one_verdict_when_all_have_ended(room: Callable[..., Room]) -> None:
    it = room("alice", "bob", has_prompt=True, speed=1.0)
    judge = Judge(it)
    it.runs.start_in_background(RunRequest("WAIT 1000"))
    it.team.choose("bob")
    assert it.runs.start_in_background(RunRequest("TR 0")).wait(TIMEOUT)
    assert not it.runs.is_verdict_due
    it.runs.sum_up("bob")
    it.runs.say_verdict()
    assert judge.asked == []
    it.team.session("alice").stop()
    it.team.session("alice").wait_for_stop()
    assert it.runs.is_verdict_due
    it.runs.say_verdict()
    assert judge.asked == [(True, False)]


@pytest.mark.parametrize("is_background", [True, False])
def test_the_last_words_of_a_program_are_waited_for_before_it_is_judged(
    room: Callable[..., Room], monkeypatch: pytest.MonkeyPatch, is_background: bool
) -> None:
    it, may_end = room(has_prompt=True), threading.Event()
    judge = Judge(it)

    def hang(stamped: Stamped) -> None:
        if isinstance(stamped.event, RunEnded):
            assert may_end.wait(TIMEOUT)

    it.team.stream.subscribe(hang)
    run = it.start("VAR a = 1", is_background=is_background)
    it.until(lambda: it.runs.has_ended(None))
    wait = run.wait

    def let_it_end(_: float | None = None) -> bool:
        may_end.set()
        return wait(TIMEOUT)

    monkeypatch.setattr(run, "wait", let_it_end)
    if is_background:
        it.runs.say_verdict()
    else:
        it.runs.sum_up(None)
        assert it.answers == ["Done.", "Well."]
    assert judge.asked == [(True, not is_background)]


def test_a_front_end_that_handed_over_follows_no_run(room: Callable[..., Room]) -> None:
    it = room()
    it.runs.close()
    it.run("VAR a = 1\nFW a")

    assert (it.runs.variables_during, it.runs.has_ended(None)) == ({}, False)
