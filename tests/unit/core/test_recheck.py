"""A recording is run again and compared as far as possible. A replay keeps the times of the run."""

import threading

import pytest

from donnie_tui.core.events import TRANSIENT, Moved, RunStarted, Spoke, Stamped
from donnie_tui.core.recheck import Result, Verdict, recheck
from donnie_tui.core.runner import RunRequest
from donnie_tui.core.session import RunOptions
from donnie_tui.core.timeline import LONGEST_PAUSE, Replay, Timeline, moments_of
from donnie_tui.i18n.words import Words
from language.control import ExecutionControl
from tests.timeouts import TIMEOUT
from tests.unit.core.test_team import Hall


def recorded(hall: Hall) -> list[Stamped]:
    return [each for each in hall.heard if not isinstance(each.event, TRANSIENT)]


def run(hall: Hall, robot: str, text: str, *, fresh: bool = False) -> None:
    assert hall.team.session(robot).start(text, f"{robot}.gd", RunOptions(fresh=fresh)).wait(TIMEOUT)


def test_consecutive_runs_resets_and_questions_give_the_same_again() -> None:
    hall = Hall()
    run(hall, "alice", "VAR a = 2 FW a")
    hall.team.session("alice").sentences.position(hall.team.session("alice").pose)
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

    assert recheck(events[:cut], Hall().team, Words()).result is Result.STOPPED


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

    verdict = recheck(recorded(hall)[:1], Hall().team, Words())

    assert (verdict.result, verdict.index) == (Result.STOPPED, 0)


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
