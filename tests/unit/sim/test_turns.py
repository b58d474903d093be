"""At equal times the robot that is first in the world has the turn, whichever robot asked first."""

import os
import threading
from math import inf
from pathlib import Path
from unittest.mock import patch

import pytest

from sim.clock import MOST_EVENTS, Clock, Glide, Landing, LockGate, Seat, Turns, new_gate
from sim.geometry import Placement
from tests.timeouts import TIMEOUT
from tests.unit.sim.floors import Unpaced


def test_the_first_robot_of_the_world_gets_the_turn_at_equal_times() -> None:
    turns = Turns()
    alice, bob = Seat(turns, 0), Seat(turns, 1)

    turns.expect([bob, alice])

    assert turns.holder is alice


def test_an_earlier_robot_gives_way_to_the_first_of_the_world_at_equal_times() -> None:
    turns = Turns()
    alice, bob = Seat(turns, 0), Seat(turns, 1)
    turns.expect([bob])
    turns.expect([alice])
    assert turns.holder is bob, "it was alone"

    assert not bob.is_next(0.0)
    assert not bob.take(0.0, halted=lambda: True)
    assert turns.holder is alice


def test_the_first_robot_of_the_world_keeps_its_turn_at_equal_times() -> None:
    turns = Turns()
    alice, bob = Seat(turns, 0), Seat(turns, 1)
    turns.expect([alice, bob])

    assert alice.is_next(0.0)
    assert not alice.is_next(0.1)


def test_a_robot_that_joins_begins_at_the_time_to_which_another_has_leapt() -> None:
    turns = Turns()
    bob = Seat(turns, 1)
    alice = Clock(Unpaced(), None, Seat(turns, 0))
    alice.join()
    assert alice.may_leap()

    alice.leap(2.5)
    alice.reset()
    alice.leap(1.5)
    turns.expect([bob])

    assert (alice.seconds, bob.time) == (1.5, 4.0)
    assert alice.undisturbed() == 0.0
    assert not alice.may_leap(), "the other one may act first"


def test_a_robot_that_takes_no_part_leaps_and_the_time_of_the_world_stays() -> None:
    turns = Turns()
    bob = Seat(turns, 1)
    alice = Clock(Unpaced(), None, Seat(turns, 0))
    turns.expect([bob])
    assert alice.may_leap()

    alice.leap(2.0)

    assert (alice.seconds, turns.present) == (2.0, 0.0)
    assert alice.undisturbed() == inf


def test_a_robot_with_a_speed_does_not_leap() -> None:
    clock = Clock(Unpaced(), 2.0)
    assert not clock.may_leap()

    clock.speed = None
    assert clock.may_leap()


def test_a_leap_ends_an_earlier_halt() -> None:
    clock = Clock(Unpaced(), None)
    clock.halt()
    assert not clock.is_active()

    clock.leap(1.0)

    assert clock.is_active()


def test_the_world_knows_which_robot_has_the_turn_while_others_wait() -> None:
    turns = Turns()
    alice, bob, eve = (Seat(turns, rank) for rank in range(3))
    assert (turns.has_others(alice), turns.held_by(), alice.waits) == (False, None, False)
    turns.present = 1.5
    assert turns.now() == (1.5, inf)

    turns.expect([alice])
    turns.expect([alice])
    assert (turns.has_others(alice), turns.has_others(bob), turns.held_by()) == (False, True, None)
    assert alice.free_until() == bob.free_until() == inf

    turns.expect([eve, bob])
    turns.present = 2.5
    assert [turns.has_others(each) for each in (alice, bob, eve)] == [True] * 3
    assert (turns.held_by(), alice.waits, bob.waits) == ((0, 2.5), False, True)
    assert turns.now() == (1.5, 0)

    turns.dismiss(bob)
    turns.dismiss(bob)
    assert (turns.holder, turns.has_others(alice), bob.waits) == (alice, True, False)
    turns.dismiss(alice)
    assert (turns.holder, turns.held_by(), turns.has_others(eve)) == (eve, None, False)
    turns.dismiss(eve)
    assert (turns.holder, turns.queue) == (None, [])


def test_a_robot_is_undisturbed_until_the_next_one_can_act() -> None:
    turns = Turns()
    turns.present = 3.0
    alice, bob = Clock(Unpaced(), None, Seat(turns, 0)), Seat(turns, 1)
    alice.join()
    assert (alice.undisturbed(), alice.has_company, alice.others_glide) == (inf, False, False)
    assert list(alice.in_the_world([1.0, 2.0])) == [4.0, 5.0]

    turns.present = 7.0
    turns.expect([bob])
    assert (alice.undisturbed(), alice.has_company, alice.others_glide) == (4.0, True, False)

    turns.glides[bob] = glide(Clock(Unpaced(), None, bob))
    assert (alice.undisturbed(), alice.others_glide) == (0.0, True)
    alice.leave()
    assert (alice.takes_part, alice.has_company, alice.others_glide) == (False, True, False)
    assert alice.undisturbed() == inf


def test_a_clock_that_never_joined_has_the_times_of_the_world() -> None:
    assert list(Clock(Unpaced(), None).in_the_world([1.0, 2.0])) == [1.0, 2.0]


def test_time_is_spent_in_slices_and_the_marks_on_the_way_are_reported() -> None:
    """At twice the speed a slice of 1/20 s is 0.1 s of the robot."""
    pace, slices, marks = Unpaced(), list[float](), list[tuple[str, float]]()
    clock = Clock(pace, 2.0)

    def mark(name: str) -> None:
        marks.append((name, round(clock.seconds, 9)))

    spent = clock.spend(0.25, [(0.15, lambda: mark("a")), (0.25, lambda: mark("b"))], slices.append, end=0.5)

    assert (spent, clock.seconds) == (0.25, 0.5)
    assert slices == pytest.approx([0.1, 0.15, 0.25])
    assert pace.slept == pytest.approx([0.05, 0.025, 0.05])
    assert marks == [("a", 0.15), ("b", 0.5)]


@pytest.mark.parametrize(("speed", "slept"), [(None, 0), (1.0, 20)])
def test_a_mark_may_end_what_is_spent(speed: float | None, slept: int) -> None:
    pace, marks = Unpaced(), list[str]()
    clock = Clock(pace, speed)

    spent = clock.spend(5.0, [(1.0, clock.halt), (2.0, lambda: marks.append("late"))])

    assert (spent, clock.seconds, clock.was_halted()) == (pytest.approx(1.0), pytest.approx(1.0), True)
    assert (marks, len([each for each in pace.slept if each])) == ([], slept)


@pytest.mark.parametrize("takes_part", [False, True])
def test_a_stop_ends_what_elapses_and_the_next_command_begins_anew(takes_part: bool) -> None:
    pace = Unpaced(stop_after=0.5)
    clock = Clock(pace, 1.0)
    if takes_part:
        clock.join()

    assert not clock.elapse(2.0)
    assert (clock.seconds, clock.was_halted()) == (pytest.approx(0.5), True)
    assert not clock.elapse(1.0)
    assert not clock.elapse_until(9.0)
    assert clock.seconds == pytest.approx(0.5)

    pace.stop_after = inf
    assert clock.begin()
    assert clock.elapse(2.0)
    assert clock.elapse_until(4.0)
    assert clock.seconds == 4.0
    assert sum(pace.slept) == pytest.approx(4.0)


def glide(clock: Clock) -> Glide:
    """A metre to the east, in three ticks that end at 1, 2 and 3 seconds; 0.25 m around it are free."""
    return Glide(
        *(7, clock, lambda: [1.0, 2.0, 3.0], lambda count: Placement(count / 3)),
        *((0.0, 0.0, 1.0, 0.0), 0.25),
    )


@pytest.mark.parametrize(
    ("time", "rank", "ticks"),
    [(0.0, 9, 0), (0.5, 9, 0), (1.0, 1, 0), (1.0, 2, 1), (1.5, 0, 1), (3.0, 1, 2), (3.0, 2, 3), (9.0, 0, 3)],
)
def test_a_tick_is_past_for_robots_that_act_after_it(time: float, rank: int, ticks: int) -> None:
    """At equal times the robot with the lower rank acts first; the one that glides has rank 1."""
    it = glide(Clock(Unpaced(), None, Seat(Turns(), 1)))

    assert it.ticks((time, rank)) == ticks
    assert it.new_place((time, rank)) == (Placement(ticks / 3) if ticks else None)
    assert it.new_place((time, rank)) is None


@pytest.mark.parametrize(
    ("time", "end", "count"), [(0.5, 1.0, 1), (1.5, 2.0, 2), (2.5, 3.0, 3), (9.0, 3.0, 3)]
)
def test_a_cut_glide_ends_with_its_current_tick(time: float, end: float, count: int) -> None:
    it = glide(Clock(Unpaced(), None, Seat(Turns(), 1)))

    assert (it.cut((time, 0)), it.count) == (end, count)


def test_a_glide_is_cut_once_while_its_robot_waits_and_the_order_changes() -> None:
    turns = Turns()
    alice, bob, eve = (Clock(Unpaced(), None, Seat(turns, rank)) for rank in range(3))
    turns.expect([alice.seat, bob.seat, eve.seat])
    glides = {each.seat: glide(each) for each in (alice, bob)}
    turns.glides |= glides
    assert [each for *_, each in turns.queue] == [bob.seat, eve.seat]

    turns.cut(glides.values())

    assert [each.count for each in glides.values()] == [None, 1], "the first one has its turn"
    assert (bob.seconds, bob.seat.time) == (1.0, 1.0)
    assert [each for *_, each in turns.queue] == [eve.seat, bob.seat]

    alice.seat.time = 1.5
    turns.cut(glides.values())
    del turns.glides[bob.seat]
    assert (glides[bob.seat].count, bob.seconds) == (1, 1.0)


def test_a_glide_that_is_over_is_not_cut() -> None:
    turns = Turns()
    alice, bob = (Clock(Unpaced(), None, Seat(turns, rank)) for rank in range(2))
    turns.expect([alice.seat, bob.seat])
    over = glide(bob)

    turns.cut([over])

    assert (over.count, bob.seconds) == (None, 0.0)


@pytest.mark.parametrize(
    ("x", "y", "is_near"),
    [
        (0.5, 0.49, True),
        (0.5, -0.49, True),
        (0.5, 0.5, False),
        (1.49, 0, True),
        (1.5, 0, False),
        (-0.5, 0, False),
    ],
)
def test_what_comes_nearer_than_the_guard_to_a_way_is_near(x: float, y: float, is_near: bool) -> None:
    """The thing itself reaches 0.25 m around its place, or around its way to the north."""
    it = glide(Clock(Unpaced(), None))

    assert it.is_near(x, y, 0.25) is is_near
    assert it.is_near_way((x, y, x, y + (0.1 if y >= 0 else -0.1)), 0.25) is is_near
    assert (it.x, it.y, it.half) == (0.5, 0.0, 0.5)


@pytest.mark.parametrize("rank", [0, MOST_EVENTS])
def test_an_opening_of_a_gate_lets_one_wait_pass_before_it_or_after_it(rank: int) -> None:
    gate, passed = new_gate(rank), threading.Semaphore(0)

    def wait() -> None:
        gate.wait()
        passed.release()

    for _ in range(2):  # the second wait must not pass by the openings of the first one
        gate.open()
        gate.open()
        gate.wait()
        thread = threading.Thread(target=wait, daemon=True)
        thread.start()
        assert not passed.acquire(blocking=False)
        gate.open()
        assert passed.acquire(timeout=TIMEOUT)
        thread.join(TIMEOUT)


@pytest.mark.skipif(not hasattr(os, "eventfd"), reason="the system has no eventfd")
def test_only_so_many_robots_of_a_world_have_an_event_and_close_its_file() -> None:
    def events() -> int:
        files = (each.readlink() for each in Path("/proc/self/fd").iterdir() if each.is_symlink())
        return sum("eventfd" in each.name for each in files)

    before = events()
    gates = [new_gate(rank) for rank in range(MOST_EVENTS + 10)]
    assert events() == before + MOST_EVENTS

    gates.clear()
    assert events() == before


def test_a_gate_is_a_lock_if_no_more_files_can_be_opened() -> None:
    with patch("os.eventfd", side_effect=OSError("too many open files"), create=True):
        assert isinstance(new_gate(0), LockGate)


@pytest.mark.parametrize("leaves", ["alice", "bob"])
def test_the_turn_passes_to_the_least_time_whichever_robot_leaves(leaves: str) -> None:
    """The queue is a heap: without its first entry the rest is none."""
    turns, seats = Turns(), {}
    for rank, (name, time) in enumerate((("alice", 0.0), ("bob", 0.5), ("late", 10.0), ("early", 1.0))):
        turns.present = time
        seats[name] = Seat(turns, rank)
        turns.expect([seats[name]])

    turns.dismiss(seats[leaves])
    turns.dismiss(seats["bob" if leaves == "alice" else "alice"])

    assert turns.holder is seats["early"]
    assert (seats[leaves].takes_part, seats["early"].waits, seats["late"].waits) == (False, False, True)


def test_a_robot_that_is_dismissed_while_it_waits_waits_no_longer() -> None:
    turns = Turns()
    alice, bob = Seat(turns, 0), Seat(turns, 1)
    turns.expect([alice, bob])
    done, asked = list[bool](), threading.Event()

    def halted() -> bool:
        asked.set()
        return False

    thread = threading.Thread(target=lambda: done.append(bob.take(0.0, halted)), daemon=True)
    thread.start()
    assert asked.wait(TIMEOUT)
    turns.dismiss(bob)
    thread.join(TIMEOUT)

    assert done == [True]
    assert turns.holder is alice


def test_a_robot_hands_its_turn_over_and_gets_it_back() -> None:
    turns = Turns()
    alice, bob = Seat(turns, 0), Seat(turns, 1)
    turns.expect([alice, bob])
    turns.holder = alice
    alice.time = 2.0

    assert turns.hand_over() is bob
    assert (turns.holder, alice.waits, turns.queue) == (bob, True, [(2.0, 0, alice)])
    assert (bob.is_next(1.5), bob.is_next(2.5), bob.time) == (True, False, 2.5)


def joined(pace: Unpaced, speed: float | None = None) -> Clock:
    """A clock that was at 2 s when it joined a world at 5 s."""
    clock = Clock(pace, None, Seat(Turns(), 1))
    clock.spend(2.0, ())
    clock.seat.turns.present = 5.0
    clock.join()
    clock.speed = speed
    return clock


def test_the_time_of_a_robot_and_of_its_world_pass_together() -> None:
    clock = joined(Unpaced())
    turns, other = clock.seat.turns, Seat(clock.seat.turns, 2)
    assert (list(clock.in_the_world([2.0, 3.5])), clock.undisturbed()) == ([5.0, 6.5], inf)

    assert clock.spend(1.0, ()) == 1.0
    assert (clock.seconds, turns.present, turns.now()) == (3.0, 6.0, (6.0, 1))
    assert clock.elapse(0.5)
    assert (clock.seconds, turns.present) == (3.5, 6.5)
    assert clock.elapse_until(4.0)
    assert (clock.seconds, turns.present) == (4.0, 7.0)
    turns.present = 9.0
    turns.expect([other])
    assert clock.undisturbed() == 2.0
    clock.reset()
    assert (clock.seconds, clock.undisturbed(), list(clock.in_the_world([1.0]))) == (0.0, 2.0, [8.0])
    clock.cut(0.5)
    assert (clock.seconds, clock.seat.time) == (0.5, 7.5)


def test_a_robot_that_takes_part_sleeps_in_slices_until_its_time() -> None:
    """At twice the speed a slice of 1/20 s is 0.1 s of the world."""
    pace = Unpaced()
    clock = joined(pace, 2.0)

    assert clock.elapse(0.25)

    assert [each for each in pace.slept if each] == pytest.approx([0.05, 0.05, 0.025])
    assert clock.seat.turns.present == 5.25


def test_a_stop_leaves_a_robot_at_the_time_of_its_world() -> None:
    """At 20 times the speed a slice is a second; two of three pass."""
    clock = joined(Unpaced(stop_after=0.1), 20.0)

    assert not clock.elapse(3.0)

    assert (clock.seconds, clock.seat.turns.present, clock.was_halted()) == (4.0, 7.0, True)
    assert not clock.is_active()
    assert not clock.elapse(1.0)
    assert clock.seconds == 4.0


def test_a_halt_while_it_sleeps_ends_what_elapses() -> None:
    """It is asked for no time first, then for slices of a second of the world; it halts in the third one."""

    class Halting(Unpaced):
        def sleep(self, seconds: float) -> bool:
            if len(self.slept) == 3:
                clock.halt()
            return super().sleep(seconds)

    clock = joined(Halting(), 20.0)

    assert not clock.elapse(9.0)

    assert (clock.seconds, clock.was_halted()) == (4.0, True)


@pytest.mark.parametrize(
    ("stop_after", "count", "landing", "seconds", "ticks"),
    [
        (inf, None, Landing.WHOLE, 5.0, None),
        (inf, 2, Landing.CUT, 5.0, 2),
        (0.1, None, Landing.HALTED, 4.0, 2),
        (0.05, None, Landing.HALTED, 3.0, 1),
        (0.0, None, Landing.HALTED, 2.0, 0),
    ],
)
def test_a_robot_follows_a_glide_to_its_end_or_to_a_stop(
    stop_after: float, count: int | None, landing: Landing, seconds: float, ticks: int | None
) -> None:
    """Three ticks of a second, each a slice of real time at 20 times the speed, from 2 s on."""
    clock = joined(Unpaced(stop_after), 20.0)
    it = Glide(
        *(7, clock, lambda: [3.0, 4.0, 5.0], lambda count: Placement(count / 3)),
        *((0.0, 0.0, 1.0, 0.0), 0.25),
    )
    it.count = count

    assert clock.follow(it, 5.0) is landing

    assert (clock.seconds, it.count, clock.seat.turns.glides) == (seconds, ticks, {})


def test_a_glide_has_the_times_of_the_world() -> None:
    clock = joined(Unpaced())
    it = Glide(
        *(7, clock, lambda: [3.0, 4.0, 5.0], lambda count: Placement(count / 3)),
        *((0.0, 0.0, 3.0, 4.0), 0.25),
    )

    assert [it.ticks((time, 0)) for time in (4.0, 5.0, 6.5, 7.5, 8.5)] == [0, 0, 1, 2, 3]
    assert it.cut((6.5, 0)) == 4.0
    assert (it.x, it.y, it.half) == (1.5, 2.0, 2.5)


def test_a_robot_that_is_refused_a_rest_neither_waits_for_its_turn_nor_spends_on() -> None:
    """Another one has an earlier time; the pace answers with a stop at once."""
    turns = Turns()
    alice, bob = Clock(Unpaced(stop_after=-1), None, Seat(turns, 0)), Seat(turns, 1)
    turns.expect([alice.seat, bob])
    marks = list[str]()

    spent = alice.spend(2.0, [(1.0, lambda: marks.append("a")), (1.5, lambda: marks.append("b"))])

    assert (spent, alice.seconds, turns.present, marks) == (1.0, 1.0, 1.0, [])
    assert alice.was_halted()
    assert not alice.begin()
    assert alice.was_halted()
    assert not alice.elapse(1.0)


def test_another_robot_that_acts_first_ends_a_slice() -> None:
    """It may act at 0.15 s; the slices of the first one end at 0.1 and 0.2."""
    turns, passed = Turns(), list[float]()
    alice, bob = Clock(Unpaced(), 2.0, Seat(turns, 0)), Seat(turns, 1)
    alice.join()
    turns.present = 0.15
    turns.expect([bob])
    turns.present = 0.0

    assert alice.spend(1.0, [], passed.append) == pytest.approx(0.2)

    assert passed == pytest.approx([0.1, 0.2])
    assert turns.present == alice.seconds == pytest.approx(0.2)
    assert not alice.was_halted()


def test_a_halt_at_a_mark_ends_the_marks_of_the_same_moment_too() -> None:
    clock, marks = Clock(Unpaced(), None), list[str]()

    spent = clock.spend(1.0, [(1.0, clock.halt), (1.0, lambda: marks.append("late"))])

    assert (spent, marks, clock.was_halted()) == (1.0, [], True)


def test_a_nudge_lets_a_waiting_robot_see_that_it_was_halted() -> None:
    turns = Turns()
    alice, bob = Seat(turns, 0), Seat(turns, 1)
    turns.expect([alice, bob])
    asked, halted, done = threading.Event(), threading.Event(), list[bool]()

    def is_halted() -> bool:
        asked.set()
        return halted.is_set()

    thread = threading.Thread(target=lambda: done.append(bob.take(0.0, is_halted)), daemon=True)
    thread.start()
    assert asked.wait(TIMEOUT)
    halted.set()
    bob.nudge()
    thread.join(TIMEOUT)

    assert done == [False]


def test_a_robot_that_waits_wakes_up_when_another_one_hands_over() -> None:
    turns = Turns()
    alice, bob = Seat(turns, 0), Seat(turns, 1)
    turns.expect([alice, bob])
    asked, done = threading.Event(), list[bool]()

    def is_halted() -> bool:
        asked.set()
        return False

    thread = threading.Thread(target=lambda: done.append(bob.take(1.0, is_halted)), daemon=True)
    thread.start()
    assert asked.wait(TIMEOUT)
    assert not alice.take(2.0, halted=lambda: True)
    thread.join(TIMEOUT)

    assert done == [True]
    assert turns.holder is bob
