"""A program fails where its robot's wheels count wrong or don't stop; the sentences say what to do."""

from __future__ import annotations

import pytest

from devices.board_simulator.robot import SimulatedSerialRobot
from devices.ports.robot import Pace, StoppedBy, Watcher
from devices.serial_robot.config import RobotConfig
from donnie_tui.core.events import CueSounded, Error, Moved, Outcome, Stamped, Turned
from tests.floor import Floor


class Miswired:
    """A floor with a robot whose left encoder is swapped."""

    def __init__(self, language: str = "en") -> None:
        self.floor = Floor(language=language)
        self.floor.session.change_robot(self._make)

    def _make(self, pace: Pace, watcher: Watcher) -> SimulatedSerialRobot:
        config = RobotConfig(finds_profile=False)
        self.robot = SimulatedSerialRobot(config=config, pace=pace, watcher=watcher, speed=None)
        self.robot.board.wheels.encoders = (1, -1)
        return self.robot


@pytest.mark.parametrize("program", ["FW 9", "BW 9", "TR 90", "TL 90 SPEAK 1"])
def test_wheels_that_count_wrong_fail_the_program(program: str) -> None:
    there = Miswired()

    assert there.floor.run(program) is Outcome.FAILED
    done = [each for each in there.floor.events if isinstance(each, Moved | Turned)]
    (error,) = [each for each in there.floor.events if isinstance(each, Error)]
    assert [each.stopped_by for each in done] == [StoppedBy.WRONG_WAY]
    assert error.message == "My wheels count the wrong way."
    assert error.hint == "See encoders, motors and profile in the settings."


@pytest.mark.parametrize(
    ("language", "sentence"),
    [
        ("en", "Only 0 steps. My wheels count the wrong way."),
        ("pt", "Só 0 passos. Minhas rodas contam ao contrário."),
        ("es", "Solo 0 pasos. Mis ruedas cuentan al revés."),
    ],
)
def test_the_sentence_is_in_the_learners_language(language: str, sentence: str) -> None:
    there = Miswired(language)
    there.floor.run("FW 9")

    assert sentence in there.floor.printed


@pytest.mark.parametrize(("program", "done"), [("FW 2", "2 steps."), ("TR 90", "90 degrees.")])
def test_a_robot_that_does_not_stop_fails_the_program_even_at_its_last_step(program: str, done: str) -> None:
    there = Miswired()
    there.robot.board.wheels.encoders = (1, 1)
    there.robot.link.has_reset_wire = False

    def be_deaf(stamped: Stamped) -> None:
        if isinstance(stamped.event, CueSounded) and stamped.event.name in ("step-forward", "turn-right"):
            there.robot.board.is_deaf = True

    there.floor.session.hub.subscribe(be_deaf)

    assert there.floor.run(program) is Outcome.FAILED
    assert any(line.startswith(done) and line.endswith("I can't stop.") for line in there.floor.printed)
    assert any("The robot does not stop. Switch it off." in line for line in there.floor.printed)
