"""A recording is run again and compared as far as possible. A replay keeps the times of the run."""

import threading

import pytest
from msgspec import structs

from donnie_tui.core.events import (
    BELT_LINK,
    TRANSIENT,
    Announced,
    Answered,
    CueSounded,
    Event,
    Moved,
    Outcome,
    RunEnded,
    RunStarted,
    Spoke,
    Stamped,
    Turned,
    Waited,
)
from donnie_tui.core.recheck import Result, Verdict, recheck
from donnie_tui.core.runner import RunRequest
from donnie_tui.core.session import RunOptions
from donnie_tui.core.timeline import LONGEST_PAUSE, Replay, Timeline, moments_of
from donnie_tui.i18n.words import Words
from language.control import ExecutionControl
from tests.timeouts import TIMEOUT
from tests.unit.core.test_run_controller import Lesson
from tests.unit.core.test_team import Hall


def recorded(hall: Hall) -> list[Stamped]:
    return [each for each in hall.heard if not isinstance(each.event, TRANSIENT)]


def run(hall: Hall, robot: str, text: str, *, fresh: bool = False) -> None:
    assert hall.team.session(robot).start(text, f"{robot}.gd", RunOptions(fresh=fresh)).wait(TIMEOUT)


def test_consecutive_runs_resets_and_questions_give_the_same_again() -> None:
    hall = Hall()
    run(hall, "alice", "VAR a = 2 FW a")
    hall.team.session("alice").sentences.place("position", hall.team.session("alice").pose)
    run(hall, "alice", "SPEAK a FW a")
    hall.team.session("alice").reset()
    run(hall, "Bob", "SPEAK DISTANCE F FWD 3")
    hall.run("FW 3 SPEAK DISTANCE F", "WAIT 1 FW 2")

    events = recorded(hall)
    verdict = recheck(events, Hall().team, Words())

    assert (verdict.result, verdict.index) == (Result.SAME, len(events))


def test_a_refused_program_gives_the_same_again() -> None:
    hall = Hall()
    run(hall, "alice", "VAR a = 2 FW a")
    run(hall, "alice", "FW 1 FWD 2", fresh=True)
    run(hall, "alice", "FW a")

    events = recorded(hall)
    assert recheck(events, Hall().team, Words()).result is Result.SAME
    assert hall.team.session("alice").pose.y == 4.0


def test_the_first_different_event_is_found_and_every_run_is_stopped() -> None:
    hall = Hall()
    run(hall, "alice", "FW 2 SPEAK 1 FW 3")
    events = recorded(hall)
    index = next(index for index, each in enumerate(events) if isinstance(each.event, Spoke))
    events[index] = Stamped(events[index].seq, events[index].t, Spoke("2"), "alice")
    again = Hall()

    verdict = recheck(events, again.team, Words())

    assert (verdict.result, verdict.index) == (Result.DIFFERENT, index)
    assert verdict.now is not None
    assert verdict.now.event == Spoke("1")
    assert again.team.running == ()


def test_a_recording_with_more_events_than_happen_now_differs() -> None:
    hall = Hall()
    run(hall, "alice", "SPEAK 1")
    events = recorded(hall)
    events.insert(2, Stamped(99, 0.0, Spoke("more"), "alice"))

    assert recheck(events, Hall().team, Words()).result is Result.DIFFERENT


def test_robots_started_by_hand_at_the_same_time_are_compared_up_to_there() -> None:
    hall, begun = Hall(speed=50.0), threading.Event()
    hall.team.stream.subscribe(lambda each: begun.set() if isinstance(each.event, Spoke) else None)
    alice = hall.team.session("alice").start("SPEAK 1 WAIT 1000", "a.gd")
    assert begun.wait(TIMEOUT)
    bob = hall.team.session("Bob").start("SPEAK 2", "b.gd")
    assert bob.wait(TIMEOUT)
    hall.team.stop()
    assert alice.wait(TIMEOUT)

    events = recorded(hall)
    verdict = recheck(events, Hall().team, Words())

    assert verdict.result is Result.OVERLAPPING
    started = events[verdict.index]
    assert (type(started.event), started.robot) == (RunStarted, "Bob")


def test_a_recording_that_ends_in_the_middle_of_a_run_is_the_same_up_to_there() -> None:
    hall = Hall()
    run(hall, "alice", "FW 2 SPEAK 1 FW 3")
    events = recorded(hall)
    cut = next(index for index, each in enumerate(events) if isinstance(each.event, Spoke)) + 1

    assert recheck(events[:cut], Hall().team, Words()) == Verdict(Result.STOPPED, cut)
    asked = Stamped(0, 0.0, Announced("position", "Here I am."), "alice")
    assert recheck([*events[:cut], asked], Hall().team, Words()) == Verdict(Result.STOPPED, cut + 1)


ENDLESS = "VAR a = 1 WHILE a > 0 DO a = a + 1 END WHILE"


@pytest.mark.parametrize(
    "other", ["FW 3", 'SPEAK "x" WAIT 3', "FW", ENDLESS], ids=["moves", "speaks", "wrong", "endless"]
)
@pytest.mark.parametrize("before", ["", "SPEAK 1 ", "FW 1 "], ids=["silent", "speaks", "moves"])
def test_a_program_that_kept_its_turn_is_stopped_where_it_was(before: str, other: str) -> None:
    hall = Hall()
    programs = {"alice": RunRequest(before + ENDLESS, "a.gd"), "Bob": RunRequest(other, "b.gd")}
    count, computes = (len(before.split()) and 1) + 1, threading.Event()
    hall.team.stream.subscribe(lambda _: computes.set() if len(recorded(hall)) >= count else None)
    runs = hall.team.start_together(programs)
    assert computes.wait(TIMEOUT)
    hall.team.stop()
    assert all(each.wait(TIMEOUT) for each in runs)
    events, again = recorded(hall), Hall().team

    verdicts = list[Verdict]()
    checking = threading.Thread(target=lambda: verdicts.append(recheck(events, again, Words())), daemon=True)
    checking.start()
    checking.join(TIMEOUT)
    again.stop()

    assert [each.result for each in verdicts] == [Result.STOPPED]
    assert verdicts[0].index >= 1


def test_a_recording_that_ends_before_all_robots_began_can_not_be_run_again() -> None:
    hall = Hall()
    hall.run("SPEAK 1", "SPEAK 2")

    events, again = recorded(hall), Hall()

    assert recheck(events[:1], again.team, Words()) == Verdict(Result.STOPPED, 0)
    assert again.heard == []
    count = index_of(events, Spoke, "Bob") + 1
    assert recheck(events[:count], Hall().team, Words()) == Verdict(Result.STOPPED, count)


# --- how far a recording can be compared


class Solo:
    """A robot alone on a floor, and what is recorded there."""

    def __init__(self) -> None:
        self.team, self.heard = Lesson().team, list[Stamped]()
        self.team.stream.subscribe(self.heard.append)

    def run(self, text: str, *, fresh: bool = True) -> None:
        assert self.team.chosen.start(text, "a.gd", RunOptions(fresh=fresh)).wait(TIMEOUT)


def stopped(events: list[Stamped], robot: str | None) -> list[Stamped]:
    """The events as if the learner had stopped the robot's last run when it ended."""
    at = max(at for at, each in enumerate(events) if isinstance(each.event, RunEnded) and each.robot == robot)
    ended = structs.replace(events[at].event, outcome=Outcome.STOPPED)
    stop = Stamped(0, events[at].t, Announced("stopped", "I stopped."), robot)
    before = [each for each in events[:at] if not isinstance(each.event, CueSounded) or each.t < events[at].t]
    return [*before, stop, structs.replace(events[at], event=ended), *events[at + 1 :]]


def changed(events: list[Stamped], text: str) -> list[Stamped]:
    """The events as if the learner's program had said something else."""
    return [
        structs.replace(each, event=Spoke("changed")) if each.event == Spoke(text) else each
        for each in events
    ]


def index_of(events: list[Stamped], kind: type[Event], robot: str | None, which: int = -1) -> int:
    return [at for at, each in enumerate(events) if isinstance(each.event, kind) and each.robot == robot][
        which
    ]


@pytest.mark.parametrize(
    ("program", "last"),
    [
        ("FW 2 SPEAK 1 FW 3", Moved),
        ("FW 2 SPEAK 1", Moved),
        ("FW 2 TR 90 SPEAK 1", Turned),
        ("FW 2 WAIT 1 SPEAK 1", Waited),
    ],
)
def test_a_stopped_run_is_compared_up_to_the_end_of_its_last_command(program: str, last: type[Event]) -> None:
    hall = Hall()
    run(hall, "alice", program)
    events = stopped(recorded(hall), "alice")

    verdict = recheck(events, Hall().team, Words())

    assert (verdict.result, verdict.index) == (Result.STOPPED, index_of(events, last, "alice"))


def test_a_stopped_run_without_a_command_is_compared_up_to_its_last_event() -> None:
    hall = Hall()
    run(hall, "alice", "SPEAK 1 SPEAK 2")
    events = stopped(recorded(hall), "alice")

    at = index_of(events, Spoke, "alice")
    assert recheck(events, Hall().team, Words()) == Verdict(Result.STOPPED, at + 1)
    assert recheck(changed(events, "2"), Hall().team, Words()).index == at


@pytest.mark.parametrize(
    ("bob", "last"), [("SPEAK 2", RunStarted), ("SPEAK 2 WAIT 1 SPEAK 2", Waited), ("FW 1 FW 1", Moved)]
)
def test_of_robots_together_the_first_that_was_stopped_ends_the_comparison(
    bob: str, last: type[Event]
) -> None:
    """The second one had perhaps no turn before its first command."""
    hall = Hall()
    hall.run("SPEAK 1 WAIT 9 FW 1", bob)
    events = stopped(recorded(hall), "Bob")

    verdict = recheck(events, Hall().team, Words())

    assert (verdict.result, verdict.index) == (Result.STOPPED, index_of(events, last, "Bob"))


@pytest.mark.parametrize("is_fresh", [True, False])
def test_after_a_stop_the_only_robot_is_compared_again_from_its_start(is_fresh: bool) -> None:
    solo = Solo()
    solo.run("FW 1 SPEAK 1")
    first = stopped([each for each in solo.heard if not isinstance(each.event, TRANSIENT)], None)
    count = len(solo.heard)
    solo.run("FW 2 SPEAK 2", fresh=is_fresh)
    then = [each for each in solo.heard[count:] if not isinstance(each.event, TRANSIENT)]

    limit, events = index_of(first, Moved, None), [*first, *changed(then, "2")]
    different = Result.DIFFERENT, index_of(events, Spoke, None)
    verdict = recheck(events, Solo().team, Words())
    assert (verdict.result, verdict.index) == (different if is_fresh else (Result.STOPPED, limit))
    assert recheck([*first, *then], Solo().team, Words()) == Verdict(Result.STOPPED, limit)


@pytest.mark.parametrize("are_together", [True, False])
def test_after_a_stop_several_robots_are_compared_again_if_all_begin_anew(are_together: bool) -> None:
    hall = Hall()
    run(hall, "alice", "FW 1 SPEAK 1")
    first, count = stopped(recorded(hall), "alice"), len(recorded(hall))
    if are_together:
        hall.run("FW 2", "SPEAK 2")
    else:
        run(hall, "Bob", "SPEAK 2", fresh=True)
    events = [*first, *changed(recorded(hall)[count:], "2")]

    verdict = recheck(events, Hall().team, Words())

    different = Result.DIFFERENT, index_of(events, Spoke, "Bob")
    limit = Result.STOPPED, index_of(first, Moved, "alice")
    assert (verdict.result, verdict.index) == (different if are_together else limit)


@pytest.mark.parametrize("was_stopped", [True, False])
def test_a_robot_that_is_started_during_the_run_of_another_ends_the_comparison(was_stopped: bool) -> None:
    """At its start, or before, if the first one was stopped in the command before."""
    hall = Hall()
    run(hall, "alice", "FW 1 SPEAK 1")
    alice = stopped(recorded(hall), "alice") if was_stopped else recorded(hall)
    count = len(recorded(hall))
    run(hall, "Bob", "SPEAK 2")
    events = [*alice[:-1], *recorded(hall)[count:], alice[-1]]

    verdict = recheck(events, Hall().team, Words())

    assert (verdict.result, verdict.index) == (
        (Result.STOPPED, index_of(events, Moved, "alice"))
        if was_stopped
        else (Result.OVERLAPPING, index_of(events, RunStarted, "Bob"))
    )


def test_a_run_is_repeated_with_the_language_and_the_options_of_its_recording() -> None:
    first, again = Hall(), Hall()
    first.words.language, first.words.detail = "pt", "full"
    options = RunOptions(fresh=True, trace=True, first_line=7, terminal=False)
    assert first.team.session("alice").start("FW 1\nSPEAK 1 / 0", "a.gd", options).wait(TIMEOUT)
    programs = {"alice": RunRequest("FW 1", "a.gd"), "Bob": RunRequest("FW 1", "b.gd")}
    for each in first.team.start_together(programs, RunOptions(trace=True, terminal=False)):
        assert each.wait(TIMEOUT)

    events = recorded(first)
    assert recheck(events, again.team, again.words) == Verdict(Result.SAME, len(events))
    assert (again.words.language, again.words.detail) == ("pt", "full")


@pytest.mark.parametrize(
    ("code", "result"),
    [
        ("position", Result.SAME),
        ("help", Result.SAME),
        (BELT_LINK, Result.SAME),
        ("moved", Result.DIFFERENT),
    ],
)
def test_what_no_program_caused_is_left_out(code: str, result: Result) -> None:
    """The learner asked for it, twice, or the belt was lost; what the program asks for itself is compared."""
    hall = Hall()
    run(hall, "alice", "FW 1 STATE FW 1")
    events = recorded(hall)
    at = index_of(events, Moved, "alice", 0)
    more = [Stamped(0, 0.0, Announced(code, "So it is."), "alice")] * 2

    assert recheck([*events[:at], *more, *events[at:]], Hall().team, Words()).result is result


def test_the_help_that_a_program_prints_is_compared() -> None:
    hall = Hall()
    run(hall, "alice", "HELP FW\nSPEAK 1")
    events = recorded(hall)
    assert any(isinstance(each.event, Announced) and each.event.code == "help" for each in events)

    assert recheck(events, Hall().team, Words()) == Verdict(Result.SAME, len(events))


def test_a_recording_that_begins_at_the_start_with_a_reset_gives_the_same_again() -> None:
    hall = Hall()
    hall.team.session("alice").reset()
    run(hall, "alice", "FW 1 SPEAK 1")
    events = recorded(hall)

    assert recheck(events, Hall().team, Words()).result is Result.SAME
    assert recheck(changed(events, "1"), Hall().team, Words()).result is Result.DIFFERENT


def test_a_robot_that_is_started_again_while_another_one_runs_ends_the_comparison() -> None:
    hall = Hall()
    hall.run("WAIT 9 FW 1", "FW 1")
    events, count = recorded(hall), len(recorded(hall))
    run(hall, "Bob", "SPEAK 2")
    end = index_of(events, RunEnded, "alice")
    events = [*events[:end], *events[end + 1 :], *recorded(hall)[count:], events[end]]

    assert recheck(events, Hall().team, Words()) == Verdict(
        Result.OVERLAPPING, index_of(events, RunStarted, "Bob")
    )


def test_a_run_whose_text_is_not_known_is_not_repeated() -> None:
    hall, again = Hall(), Hall()
    run(hall, "alice", "SPEAK 1")
    events = [
        structs.replace(each, event=structs.replace(each.event, how=None))
        if isinstance(each.event, RunStarted)
        else each
        for each in recorded(hall)
    ]

    assert recheck(events, again.team, Words()) == Verdict(Result.SAME, len(events))
    assert again.heard == []


def test_what_is_answered_meanwhile_is_no_difference() -> None:
    hall, again = Hall(), Hall()
    run(hall, "alice", "SPEAK 1 FW 1")

    def answer(stamped: Stamped) -> None:
        if isinstance(stamped.event, Spoke):
            again.team.session("alice").hub.publish(Answered("Yes."))

    again.team.stream.subscribe(answer)
    assert recheck(recorded(hall), again.team, Words()).result is Result.SAME
    assert Answered("Yes.") in [each.event for each in again.heard]


def test_the_times_of_runs_follow_each_other_and_those_of_robots_overlap() -> None:
    hall = Hall()
    run(hall, "alice", "WAIT 2")
    hall.run("WAIT 3", "WAIT 5")

    events = recorded(hall)
    moments = moments_of(events)

    assert list(moments) == sorted(moments)
    assert moments[-1] == pytest.approx(7.0)


def test_a_replay_prints_all_in_order_and_shortens_long_waits() -> None:
    waits: list[float] = []

    class Patient(ExecutionControl):
        def sleep(self, seconds: float) -> bool:
            waits.append(seconds)
            return True

    hall = Hall()
    run(hall, "alice", "WAIT 1000 FW 1")
    events, said = recorded(hall), list[Stamped]()
    replay = Replay(Timeline(events), Patient(), 2.0)

    assert replay.forwards(said.append)
    assert said == events
    assert max(waits) == LONGEST_PAUSE == 5.0
    assert waits[0] == 0.0
    assert waits.count(0.5) == 1

    back: list[tuple[Stamped, ...]] = []
    assert replay.backwards(back.append)
    assert [each for step in reversed(back) for each in step] == events
    assert any(isinstance(each.event, Moved) for step in back for each in step)


def test_a_stopped_replay_stays_where_it_is() -> None:
    hall = Hall()
    run(hall, "alice", "FW 5")
    timeline = Timeline(recorded(hall))
    control = ExecutionControl()
    replay = Replay(timeline, control, None)

    def stop(stamped: Stamped) -> None:
        if stamped.seq == 3:
            control.stop()

    assert not replay.forwards(stop)
    assert timeline.at == 3
