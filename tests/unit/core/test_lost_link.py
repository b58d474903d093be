"""A program fails when the connection to its robot is lost, even in the last statement."""

import pytest

from devices.board_simulator.robot import SimulatedSerialRobot
from devices.ports.robot import Pace, StoppedBy, Watcher
from donnie_tui.core.events import CueSounded, Error, Moved, Outcome, Stamped, Turned
from tests.floor import Floor


class Unplugged:
    """A floor whose robot is unplugged at the first step, or the first ten degrees, of a movement."""

    def __init__(self) -> None:
        self.floor = Floor()
        self.floor.session.change_robot(self._make)
        self.robot.connect()
        self.floor.session.hub.subscribe(self._unplug)

    def _make(self, pace: Pace, watcher: Watcher) -> SimulatedSerialRobot:
        self.robot = SimulatedSerialRobot(pace=pace, watcher=watcher, speed=None)
        return self.robot

    def _unplug(self, stamped: Stamped) -> None:
        if isinstance(stamped.event, CueSounded) and stamped.event.name in ("step-forward", "turn-right"):
            self.robot.link.is_plugged = False


@pytest.mark.parametrize("program", ["FW 9", "TR 90", "FW 9 SPEAK 1"])
def test_a_lost_connection_is_reported_with_its_movement_and_fails_the_program(program: str) -> None:
    there = Unplugged()

    outcome = there.floor.run(program)

    done = [each for each in there.floor.events if isinstance(each, Moved | Turned)]
    mistakes = [each for each in there.floor.events if isinstance(each, Error)]
    assert outcome is Outcome.FAILED
    assert [each.stopped_by for each in done] == [StoppedBy.LINK]
    assert len(mistakes) == 1
    assert any("The connection to the robot is lost." in line for line in there.floor.printed)
    there.robot.close()
