"""A robot that computes without end is reported once to the robots that wait for it."""

import threading
from pathlib import Path

import pytest

from donnie_tui.core.events import Answered, RunStarted
from donnie_tui.core.runner import Run, RunRequest
from donnie_tui.core.team import LONGEST_TURN, TurnMonitor
from donnie_tui.i18n.words import Words
from sim.world import World
from sim.worldfile import load_text
from tests.timeouts import TIMEOUT as LONG_ENOUGH
from tests.unit.core.test_team import TWO, Hall

ENDLESS = "VAR i = 0 WHILE 1 > 0 DO i = i + 1 i = i - 1 END WHILE"


class Watched(Hall):
    """A hall with a clock that the test moves."""

    def __init__(self, language: str = "en") -> None:
        super().__init__()
        self.now = 0.0
        self.turn: tuple[str, float] | None = None
        self.excused = False
        self.turn_monitor = TurnMonitor(
            self.team,
            lambda: self.turn,
            Words(language),
            is_excused=lambda: self.excused,
            now=lambda: self.now,
        )

    def after(self, seconds: float) -> list[str]:
        """The answers in that time, after two looks."""
        before = len(self.answers)
        self.turn_monitor.check()
        self.now += seconds
        self.turn_monitor.check()
        return self.answers[before:]

    @property
    def answers(self) -> list[str]:
        self.stream_of_all.wait_until_delivered(LONG_ENOUGH)  # the program's thread may deliver them
        return [each.event.text for each in self.heard if isinstance(each.event, Answered)]

    def start_endless(self) -> Run:
        begun = self.team.session("alice").start(ENDLESS, "a.gd")
        self.turn = ("alice", 0.0)
        return begun

    def stop(self, run: Run) -> None:
        self.team.stop()
        assert run.wait(LONG_ENOUGH)


@pytest.mark.parametrize(
    ("language", "sentence"),
    [
        ("en", "The others wait for alice: it calculates and does not move. Ctrl+C stops all."),
        ("pt", "Os outros esperam por alice, que calcula e não anda. Ctrl+C faz todos pararem."),
        ("es", "Los demás esperan a alice: calcula y no se mueve. Ctrl+C detiene todo."),
    ],
)
def test_a_robot_that_holds_up_the_others_is_reported_once(language: str, sentence: str) -> None:
    hall = Watched(language)
    run = hall.start_endless()

    assert hall.after(LONGEST_TURN) == [sentence]
    assert hall.after(LONGEST_TURN) == []
    hall.stop(run)


def test_nothing_is_reported_before_three_seconds() -> None:
    hall = Watched()
    run = hall.start_endless()

    assert hall.after(LONGEST_TURN - 0.1) == []
    hall.stop(run)


def test_a_robot_that_spends_time_does_not_hold_up_the_others() -> None:
    hall = Watched()
    run = hall.start_endless()
    hall.turn_monitor.check()
    hall.now += LONGEST_TURN
    hall.turn = ("alice", 0.05)

    assert hall.after(LONGEST_TURN - 0.1) == []
    hall.stop(run)


def test_nothing_is_reported_while_a_pause_or_the_voice_explains_the_wait() -> None:
    hall = Watched()
    run = hall.start_endless()
    run.control.pause()
    assert hall.after(LONGEST_TURN) == []
    run.control.resume()
    hall.excused = True

    assert hall.after(LONGEST_TURN) == []
    hall.stop(run)


def test_the_world_names_the_robot_in_turn_only_while_another_one_waits() -> None:
    hall = Hall()
    world = hall.world = World(load_text(TWO, Path("two.world")))
    assert world.turn() is None
    world.expect(["alice"])
    assert world.turn() is None

    world.expect(["Bob"])
    assert world.turn() == ("alice", 0.0)


def test_the_watching_thread_starts_and_ends_with_a_run() -> None:
    """The thread publishes by itself; the clock of the test makes three seconds pass at once."""
    hall = Watched()
    ticks = iter(range(0, 10_000_000, 10))
    hall.turn_monitor = TurnMonitor(hall.team, lambda: hall.turn, Words(), now=lambda: float(next(ticks)))
    hall.turn_monitor.watch()
    hall.turn = ("alice", 0.0)
    said = threading.Event()
    hall.stream_of_all.subscribe(lambda each: said.set() if isinstance(each.event, Answered) else None)
    runs = hall.team.start_together({"alice": RunRequest(ENDLESS, "a.gd")})

    assert said.wait(LONG_ENOUGH)
    assert any(isinstance(each.event, RunStarted) for each in hall.heard)
    hall.stop(runs[0])
    hall.turn_monitor.close()


def test_one_thread_watches_all_runs_and_none_begins_after_the_end(monkeypatch: pytest.MonkeyPatch) -> None:
    begun, real = list[threading.Thread](), threading.Thread.start
    monkeypatch.setattr(
        threading.Thread,
        "start",
        lambda thread: begun.append(thread) if thread.name == "turn monitor" else real(thread),
    )

    def begin(hall: Watched, robot: str) -> int:
        hall.team.session(robot).hub.publish(RunStarted("a.gd", "hall", robot, 1, "0"))
        hall.stream_of_all.wait_until_delivered(LONG_ENOUGH)
        return len(begun)

    one, other = Watched(), Watched()
    one.turn_monitor.watch()
    assert [begin(one, "alice"), begin(one, "Bob")] == [1, 1]

    other.turn_monitor.watch()
    other.turn_monitor.close()
    assert begin(other, "alice") == 1
