"""A robot whose program computes without end is named to those who wait for it, once."""

from pathlib import Path

import pytest

from donnie_tui.core.events import Answered, RunStarted
from donnie_tui.core.holding_up import PATIENCE, HoldingUp
from donnie_tui.core.runner import Run
from donnie_tui.core.team import Assigned
from donnie_tui.i18n.words import Words
from sim.world import World
from sim.worldfile import load_text
from tests.patience import PATIENCE as LONG_ENOUGH
from tests.unit.core.test_team import TWO, Hall

ENDLESS = "VAR i = 0 WHILE 1 > 0 DO i = i + 1 i = i - 1 END WHILE"


class Watched(Hall):
    """A hall whose clock is turned by hand."""

    def __init__(self, language: str = "en") -> None:
        super().__init__()
        self.now = 0.0
        self.turn: tuple[str, float] | None = None
        self.excused = False
        self.holding_up = HoldingUp(
            self.team,
            lambda: self.turn,
            Words(language),
            is_excused=lambda: self.excused,
            now=lambda: self.now,
        )

    def after(self, seconds: float) -> list[str]:
        """What is told in that time, looked at twice."""
        before = len(self.answers)
        self.holding_up.look()
        self.now += seconds
        self.holding_up.look()
        return self.answers[before:]

    @property
    def answers(self) -> list[str]:
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
        ("en", "The others wait for alice: it computes and does not move. Ctrl+C stops all."),
        ("pt", "Os outros esperam por alice: calcula e não anda. Ctrl+C para todos."),
        ("es", "Los demás esperan a alice: calcula y no se mueve. Ctrl+C detiene todo."),
    ],
)
def test_who_holds_the_others_up_is_told_once(language: str, sentence: str) -> None:
    hall = Watched(language)
    run = hall.start_endless()

    assert hall.after(PATIENCE) == [sentence]
    assert hall.after(PATIENCE) == []
    hall.stop(run)


def test_before_three_seconds_nothing_is_told() -> None:
    hall = Watched()
    run = hall.start_endless()

    assert hall.after(PATIENCE - 0.1) == []
    hall.stop(run)


def test_a_robot_that_spends_time_holds_nobody_up() -> None:
    hall = Watched()
    run = hall.start_endless()
    hall.holding_up.look()
    hall.now += PATIENCE
    hall.turn = ("alice", 0.05)

    assert hall.after(PATIENCE - 0.1) == []
    hall.stop(run)


def test_whoever_pauses_a_program_or_waits_for_its_voice_knows_why_nothing_happens() -> None:
    hall = Watched()
    run = hall.start_endless()
    run.control.pause()
    assert hall.after(PATIENCE) == []
    run.control.resume()
    hall.excused = True

    assert hall.after(PATIENCE) == []
    hall.stop(run)


def test_the_world_tells_whose_turn_it_is_only_while_another_robot_waits() -> None:
    hall = Hall()
    world = hall.world = World(load_text(TWO, Path("two.world")))
    assert world.turn() is None
    world.expect(["alice"])
    assert world.turn() is None

    world.expect(["Bob"])
    assert world.turn() == ("alice", 0.0)


def test_looking_on_begins_with_a_run_and_ends_with_it() -> None:
    """The thread publishes by itself; the clock of the test makes three seconds pass at once."""
    hall = Watched()
    ticks = iter(range(0, 10_000_000, 10))
    hall.holding_up = HoldingUp(hall.team, lambda: hall.turn, Words(), now=lambda: float(next(ticks)))
    hall.holding_up.watch()
    hall.turn = ("alice", 0.0)
    import threading

    told = threading.Event()
    hall.stream_of_all.subscribe(lambda each: told.set() if isinstance(each.event, Answered) else None)
    runs = hall.team.start_together({"alice": Assigned(ENDLESS, "a.gd")})

    assert told.wait(LONG_ENOUGH)
    assert any(isinstance(each.event, RunStarted) for each in hall.heard)
    hall.stop(runs[0])
    hall.holding_up.close()
