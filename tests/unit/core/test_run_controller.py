"""A run takes the requests that its state allows, and describes its holds and its end."""

import threading
import time
from collections.abc import Callable, Iterator
from itertools import product
from types import SimpleNamespace
from typing import Any

import pytest

from devices.ports.robot import Pace, Watcher
from donnie_tui.core.events import Answered, Spoke, Stamped
from donnie_tui.core.hub import Stream
from donnie_tui.core.run_controller import RunController
from donnie_tui.core.run_state import (
    TRANSITIONS,
    NothingRuns,
    NothingToRun,
    Request,
    RunNarrator,
    RunObserver,
    RunRecord,
    RunState,
)
from donnie_tui.core.runner import Run, RunRequest
from donnie_tui.core.session import Busy, Session, SessionSetup
from donnie_tui.core.team import Team
from donnie_tui.core.timeline import Chronicle, Timeline
from donnie_tui.i18n.words import Words
from language.control import ExecutionControl
from language.runtime import Frame
from sim.robot import SimulatedRobot
from sim.world import World
from tests.floor import floor
from tests.timeouts import TIMEOUT

ENDLESS = "WHILE 1 == 1 DO\nWAIT 1\nEND WHILE"
SQUARE = "REPEAT 2 TIMES\nFW 2\nTR 90\nEND REPEAT"


class Lesson(RunObserver):
    """A robot on a floor, its runs, and what was answered."""

    def __init__(self, *, speed: float | None = None, has_prompt: bool = True) -> None:
        words, stream, chronicle = Words("en", "brief"), Stream(), Chronicle()
        world = World(floor())

        def make_robot(pace: Pace, watcher: Watcher) -> SimulatedRobot:
            return world.robot(pace=pace, watcher=watcher, speed=speed)

        def make_session(_: str) -> Session:
            return Session(make_robot, words, SessionSetup("floor", seed=0, terminal=True), stream=stream)

        self.team = Team(("donnie",), make_session, stream)
        self.answers: list[str] = []
        self.run: Run | None = None
        self._changed = threading.Condition()
        stream.subscribe(chronicle)
        self.runs = RunController(self.team, words, chronicle, has_prompt=has_prompt)
        self.runs.observer = self
        stream.subscribe(self._on_event)

    def _on_event(self, stamped: Stamped) -> None:
        if isinstance(stamped.event, Answered):
            self.answers.append(stamped.event.text)

    def on_change(self) -> None:
        with self._changed:
            self._changed.notify_all()

    def until(self, happened: Callable[[], bool]) -> None:
        """Look again from time to time: not everything that a program does is reported as a change."""
        end = time.monotonic() + TIMEOUT
        with self._changed:
            while not happened():
                assert time.monotonic() < end
                self._changed.wait(0.05)

    def start(
        self, text: str, begin: Callable[[ExecutionControl], None] | None = None, *, is_whole: bool = True
    ) -> None:
        self.run = self.runs.start(RunRequest(text, "test.gd", is_whole=is_whole), begin=begin)

    def held(self) -> None:
        self.until(lambda: self.runs.is_held)

    def ended(self) -> list[str]:
        """The answers so far, once the run is over and summed up."""
        assert self.run is not None
        assert self.run.wait(TIMEOUT)
        self.runs.sum_up(None)
        return self.answers


def in_state(state: RunState) -> Lesson:
    lesson = Lesson(speed=1.0)
    if state is not RunState.READY:
        lesson.start(ENDLESS, begin=ExecutionControl.step if state is RunState.PAUSED else None)
    if state is RunState.PAUSED:
        lesson.held()
    if state is RunState.STOPPING:
        lesson.runs.stop()
    assert lesson.runs.state is state
    return lesson


def held_at_third_line(text: str) -> Lesson:
    lesson = Lesson()
    lesson.start(text, begin=ExecutionControl.step)
    for _ in range(2):
        lesson.held()
        lesson.runs.step()
    lesson.held()
    return lesson


def test_a_run_that_was_started_elsewhere_counts_after_one_that_is_summed_up() -> None:
    lesson = Lesson(speed=1.0)
    lesson.start("FW 1")
    lesson.ended()
    elsewhere = lesson.team.chosen.start(ENDLESS, "other.gd")
    states = [lesson.runs.state]
    elsewhere.control.stop()
    assert elsewhere.wait(TIMEOUT)

    assert [*states, lesson.runs.state] == [RunState.RUNNING, RunState.READY]


ASK: dict[Request, Callable[[RunController], object]] = {
    Request.START: lambda runs: runs.start(RunRequest(ENDLESS)),
    Request.PAUSE: RunController.pause,
    Request.CONTINUE: RunController.continue_,
    Request.STEP: lambda runs: runs.run_to(9),
    Request.STEP_BACK: RunController.step_back,
    Request.STOP: RunController.stop,
}


@pytest.mark.parametrize(("state", "request_"), product(RunState, ASK))
def test_the_table_has_the_result_of_each_request_in_each_state(state: RunState, request_: Request) -> None:
    lesson = in_state(state)
    after = TRANSITIONS.get((state, request_))

    if after is None:
        with pytest.raises(NothingRuns if state is RunState.READY else Busy):
            ASK[request_](lesson.runs)
    else:
        ASK[request_](lesson.runs)

    possible = {after or state}
    if (after, request_) == (RunState.RUNNING, Request.PAUSE):  # the program may have come to a hold already
        possible.add(TRANSITIONS[after, Request.HOLD])
    assert lesson.runs.state in possible
    lesson.team.close()


def test_a_program_without_text_is_not_started() -> None:
    with pytest.raises(NothingToRun):
        Lesson().start(" \n")


def test_a_hold_is_described_and_waits_for_a_request() -> None:
    lesson = Lesson()
    lesson.start(SQUARE, begin=ExecutionControl.step)
    lesson.held()
    lesson.runs.step()
    lesson.held()
    lesson.runs.step()
    lesson.held()

    assert lesson.answers == ["Line 1: REPEAT 2 TIMES", "Round 1 of 2.", "Line 2: FW 2", "Line 3: TR 90"]
    lesson.team.close()


def test_a_pause_within_a_statement_names_its_line() -> None:
    lesson = Lesson(speed=1.0)
    lesson.start("WAIT 1000")
    lesson.until(lambda: bool(lesson.runs.frames))
    lesson.runs.pause()
    lesson.held()

    assert lesson.answers == ["Paused at line 1."]
    lesson.team.close()


def test_the_end_of_the_last_step_says_what_ended_the_loop() -> None:
    lesson = Lesson()
    lesson.start("VAR x = 1\nWHILE x < 2 DO\nx = x + 1\nEND WHILE", begin=lambda control: control.run_to(3))
    lesson.held()
    lesson.runs.step()
    lesson.held()
    lesson.runs.step()

    assert lesson.ended()[-2:] == ["2 is less than 2: false.", "Done."]


def test_a_program_that_ends_while_it_is_stopped_is_answered_once(monkeypatch: pytest.MonkeyPatch) -> None:
    lesson = in_state(RunState.RUNNING)
    session, run = lesson.team.session("donnie"), lesson.run
    stop = session.stop

    def stop_and_wait() -> None:
        stop()
        assert run is not None
        assert run.wait(TIMEOUT)

    monkeypatch.setattr(session, "stop", stop_and_wait)
    lesson.runs.stop()

    assert [each for each in lesson.ended() if each.startswith("Stopped")] == lesson.answers[-1:]


def test_the_run_is_stopping_until_it_is_summed_up() -> None:
    lesson = Lesson()
    lesson.start("FW 1")
    assert lesson.run is not None
    assert lesson.run.wait(TIMEOUT)
    assert lesson.runs.state is RunState.STOPPING
    lesson.ended()

    assert lesson.runs.state is RunState.READY


def test_a_stop_names_the_line_that_was_reached() -> None:
    lesson = Lesson()
    lesson.start("FW 1\nFW 2\nFW 3", begin=lambda control: control.run_to(2))
    lesson.held()
    lesson.runs.stop()

    assert lesson.ended()[-1] == "Stopped at line 2."


@pytest.mark.parametrize(
    ("text", "has_prompt", "end"),
    [
        ('SPEAK "hello"', True, []),
        ("VAR x = 1", True, ["Done."]),
        ('SPEAK "hello"', False, ["The program is done."]),
        ("VAR x = 1", False, ["The program is done."]),
    ],
)
def test_the_end_of_a_program_needs_words_where_nothing_else_shows_it(
    text: str, has_prompt: bool, end: list[str]
) -> None:
    lesson = Lesson(has_prompt=has_prompt)
    lesson.start(text)

    assert lesson.ended() == end


def test_a_program_that_can_not_run_gets_no_hints_and_is_not_done() -> None:
    lesson = Lesson()
    lesson.start("FWD 1\nDISTANCE F")

    assert lesson.ended() == []


def test_a_statement_without_effect_is_a_hint_after_the_run() -> None:
    lesson = Lesson()
    lesson.start("DISTANCE F")

    assert lesson.ended()[0] == "DISTANCE alone does nothing."


def test_a_watched_variable_is_described_at_each_change_and_known_from_before() -> None:
    lesson = Lesson()
    assert lesson.runs.toggle_watch("n") == ("I will say when n changes.",)
    lesson.start("VAR n = 1\nn = 2\nn = 2\nSPEAK n")
    assert lesson.ended() == ["n is 1.", "n is 2."]
    lesson.start("SPEAK n", is_whole=False)
    lesson.ended()

    assert lesson.answers == ["n is 1.", "n is 2."]
    assert lesson.runs.toggle_watch("N") == ("I will no longer say when N changes.",)
    assert lesson.runs.toggle_watch("") == ("I watch no variable.",)


def test_a_variable_can_be_watched_from_the_middle_of_a_run_on() -> None:
    lesson = Lesson()
    lesson.start("VAR n = 1\nSPEAK 1\nn = 2", begin=lambda control: control.run_to(2))
    lesson.held()
    lesson.runs.toggle_watch("n")
    lesson.runs.continue_()

    assert lesson.ended()[1:] == ["n is 1.", "n is 2."]


def test_breakpoints_hold_a_run_also_those_that_are_set_meanwhile() -> None:
    lesson = Lesson()
    lesson.runs.start(RunRequest("FW 1\nFW 2\nFW 3", breakpoints=frozenset({2})))
    lesson.held()
    lesson.runs.break_at(frozenset({3}))
    lesson.runs.continue_()
    lesson.held()

    assert lesson.answers == ["Line 2: FW 2", "Line 3: FW 3"]
    lesson.team.close()


def test_steps_are_undone_in_words_until_something_happens() -> None:
    lesson = held_at_third_line("FW 1\nFW 2\nFW 3")

    assert lesson.runs.step_back()[-1] == "Line 2: FW 2"
    assert lesson.runs.past is not None
    assert lesson.runs.step_back()[-1] == "Line 1: FW 1"
    said = len(lesson.answers)
    lesson.runs.step()
    assert lesson.answers[said:] == ["1 step forward.", "Line 2: FW 2"]
    assert lesson.runs.frames[0].line == 2
    lesson.runs.step()
    assert lesson.answers[said + 2 :] == [
        "2 steps forward.",
        "Line 3: FW 3",
        "You are back in the present.",
    ]
    assert lesson.runs.past is None
    lesson.runs.step()
    lesson.ended()
    assert lesson.runs.step_back() != ()


@pytest.fixture
def looking_back() -> Iterator[RunController]:
    """One step back from the third line."""
    lesson = held_at_third_line("FW 1\nFW 3 - 1\nFW 3")
    lesson.runs.step_back()
    yield lesson.runs
    lesson.team.close()


def end_way_back_after(reads: int, runs: RunController, monkeypatch: pytest.MonkeyPatch) -> None:
    """Let an event of another thread, such as another robot's, come after so many looks at the position."""
    positions = iter([runs.past] * reads)
    fading = property(lambda _: next(positions, None), lambda *_: None)
    monkeypatch.setattr(RunController, "past", fading, raising=False)


@pytest.mark.parametrize(
    ("asked", "answer"),
    [
        (lambda runs: runs.past_steps, (2, 3)),
        (lambda runs: [each.line for each in runs.frames], [2]),
        (lambda runs: runs.worked_out, (("3 - 1", "2"),)),
        (lambda runs: runs.knows_variables, True),
    ],
    ids=["steps", "frames", "worked out", "variables"],
)
def test_an_event_of_another_thread_may_end_the_way_back_while_it_is_shown(
    looking_back: RunController,
    monkeypatch: pytest.MonkeyPatch,
    asked: Callable[[RunController], object],
    answer: object,
) -> None:
    end_way_back_after(1, looking_back, monkeypatch)

    assert asked(looking_back) == answer


@pytest.mark.parametrize("reads", [1, 2, 3])
@pytest.mark.parametrize("request_", [RunController.step, lambda runs: runs.look_at(9)], ids=["step", "look"])
def test_an_event_of_another_thread_may_end_the_way_back_before_a_step(
    looking_back: RunController,
    monkeypatch: pytest.MonkeyPatch,
    request_: Callable[[RunController], object],
    reads: int,
) -> None:
    """What was asked is done from the moment that was last seen, or not at all."""
    end_way_back_after(reads, looking_back, monkeypatch)
    request_(looking_back)

    assert looking_back.is_held


def test_calls_and_variables_go_back_with_the_steps() -> None:
    lesson = held_at_third_line("VAR x = 1\nx = 2\nFW x")

    assert lesson.runs.frames[0].variables == (("x", 2),)
    lesson.runs.step_back()
    assert (lesson.runs.frames[0].line, lesson.runs.frames[0].variables) == (2, (("x", 1),))
    lesson.runs.to_present()
    assert lesson.runs.frames[0].line == 3
    lesson.runs.stop()
    lesson.ended()


def test_the_way_back_through_a_run_without_holds_has_lines_calls_and_variables() -> None:
    lesson = Lesson()
    lesson.start("PROCEDURE GO: n DO\nFW n\nEND PROCEDURE\nVAR x = 1\nGO [x]\nx = 2\nSPEAK x\nTR 90")
    lesson.ended()

    seen = []
    while not lesson.runs.step_back()[-1].startswith("Back: start of"):
        seen.append([(each.procedure, each.line, each.variables) for each in lesson.runs.frames])
    turned, walked = [("", 8, (("x", 2),))], [("GO", 2, (("n", 1),)), ("", 5, (("x", 1),))]
    assert seen == [[], turned, [("", 7, (("x", 2),))], walked]
    assert lesson.runs.knows_variables is False


def test_the_way_back_into_an_earlier_run_has_no_lines_of_it() -> None:
    lesson = Lesson()
    lesson.start("FW 1\nTR 90")
    lesson.ended()
    lesson.start("FW 2\nTL 90")
    lesson.ended()

    lines = {}
    while (said := lesson.runs.step_back()[-1]) not in lines:
        lines[said] = [each.line for each in lesson.runs.frames]
    assert [lines[each] for each in lines if each.startswith(("Before FW 2", "Before TL"))] == [[2], [1]]
    assert [lines[each] for each in lines if each.startswith(("Before FW 1", "Before TR"))] == [[], []]


def test_an_unattended_program_is_announced_not_held_and_its_stop_is_answered_at_once() -> None:
    lesson = Lesson(speed=1.0)
    lesson.runs.start_in_background(RunRequest(ENDLESS))
    assert lesson.answers == ["donnie begins."]
    assert not lesson.runs.is_steppable
    lesson.runs.stop()

    assert lesson.answers[1:] in (["Stopped at line 1."], ["Stopped at line 2."], ["Stopped."])
    assert lesson.runs.state is RunState.READY


def test_reset_is_refused_while_a_program_runs() -> None:
    lesson = in_state(RunState.PAUSED)
    with pytest.raises(Busy):
        lesson.runs.reset()
    lesson.team.close()


def test_quit_ends_the_run_without_a_word() -> None:
    lesson = Lesson()
    lesson.start("QUIT", is_whole=False)
    assert lesson.ended() == []
    assert lesson.runs.state is RunState.READY


# --- one run in words


def narrator(robot: str | None, *, is_whole: bool = True, watched: tuple[str, ...] = ()) -> RunNarrator:
    """Of a run that is held in line 3 of a program, where x is 1, as it was before the run."""
    session: Any = SimpleNamespace(
        frames=(Frame("", 3, (("x", 1),)),), hub=SimpleNamespace(robot=robot), variables={"X": 1}, run=None
    )
    return RunNarrator(session, RunRequest("", is_whole=is_whole), watched, Words("en", "brief"), Chronicle())


@pytest.mark.parametrize(
    ("place", "was_paused", "said"),
    [
        ((3, 1), True, ("Paused at line 3.",)),
        ((0, 0), False, ("Paused at line 3.",)),
        ((3, 1), False, ()),
    ],
)
def test_a_pause_and_a_hold_within_a_statement_say_their_line(
    place: tuple[int, int], was_paused: bool, said: tuple[str, ...]
) -> None:
    held = narrator(None).on_hold(place, was_paused=was_paused, is_steppable=False)
    of_bob = narrator("bob").on_hold(place, was_paused=was_paused, is_steppable=False)

    assert (held, of_bob) == (said, tuple(f"bob: {each}" for each in said))


@pytest.mark.parametrize("is_whole", [True, False])
def test_a_watched_variable_is_new_to_a_whole_program_and_known_to_a_typed_line(is_whole: bool) -> None:
    said = ("x is 1.",) if is_whole else ()

    assert narrator(None, is_whole=is_whole, watched=("x",)).on_statement() == said
    held = narrator(None, is_whole=is_whole, watched=("x",))
    assert held.on_hold((3, 1), was_paused=False, is_steppable=False) == said
    assert held.on_statement() == ()
    assert narrator(None, is_whole=is_whole).on_statement() == ()


def test_the_calls_of_the_newest_events_of_a_run_are_kept() -> None:
    """Those of its robot; of many open calls the innermost ones."""
    session: Any = SimpleNamespace(hub=SimpleNamespace(robot="bob"), run=None)
    record = RunRecord(session, RunRequest(""), narrator("bob"))
    for seq in range(1, 2_001):
        assert record.has_room_for_frames
        record.keep_frames(seq, [Frame("P", seq, ())] * 25)
    assert not record.has_room_for_frames
    record.keep_frames(2_001, [Frame("P", 7, ())])

    def at(*events: tuple[int, str]) -> tuple[Frame, ...] | None:
        return record.frames_at(Timeline([Stamped(seq, 0.0, Spoke("x"), robot) for seq, robot in events]))

    assert at((1, "bob")) is None
    assert at((2, "bob")) == (Frame("P", 2, ()),) * 20
    assert at((5, "alice"), (3, "bob"), (2, "bob")) == (Frame("P", 3, ()),) * 20
    assert at((2_001, "bob")) == (Frame("P", 7, ()),)
    assert at() is None
