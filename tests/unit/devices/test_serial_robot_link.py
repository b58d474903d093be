"""Stops, pauses and exceptions leave no motor on; a lost link ends the program."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from devices.ports.robot import STEP, Bearing, LinkNotice, Robot, RobotProblem, StoppedBy
from tests.unit.devices.robots import NEAR, Real

# --- the learner's stop, a pause, an exception


def test_the_learners_stop_ends_a_walk_and_the_finished_steps_count() -> None:
    real = Real(stops_at=2.5)

    moved = real.robot.forward(9)

    assert (moved.walked, moved.stopped_by) == (2, StoppedBy.USER)
    assert real.stands


def test_a_halt_from_another_thread_ends_a_walk_at_once() -> None:
    real = Real()
    real.pace.due = [(1.5, real.robot.halt)]

    moved = real.robot.forward(9)

    assert (moved.walked, moved.stopped_by) == (1, StoppedBy.USER)
    assert real.robot.time() < 2.0


def test_a_halt_before_a_command_does_not_end_it() -> None:
    real = Real()
    real.robot.halt()

    assert real.robot.forward(1).stopped_by is None


def test_a_pause_in_the_middle_of_a_walk_stops_the_wheels_and_the_walk_continues_after_it() -> None:
    """While the pace blocks, the drive is not renewed; the link's time passes."""
    stood: list[bool] = []
    real = Real()

    def pause() -> None:
        real.link.advance(2.0)
        stood.append(not real.board.is_driving)

    real.pace.due = [(1.5, pause)]
    moved = real.robot.forward(3)

    assert (moved.walked, moved.stopped_by, stood) == (3, None, [True])
    assert real.board.wheels.place.y / STEP == pytest.approx(3, abs=NEAR)


def test_an_exception_of_the_watcher_leaves_no_motor_on() -> None:
    real = Real()

    def fail() -> None:
        raise KeyError("a listener's own mistake")

    real.pace.due = [(1.5, fail)]
    with pytest.raises(KeyError):
        real.robot.forward(9)

    assert real.stands


# --- the link


def test_an_unplugged_robot_ends_the_walk_and_the_next_command_says_so() -> None:
    real = Real()
    real.pace.due = [(1.5, lambda: setattr(real.link, "is_plugged", False))]

    moved = real.robot.forward(9)

    assert (moved.walked, moved.stopped_by) == (1, StoppedBy.LINK)
    assert real.notices == [LinkNotice.CONNECTED, LinkNotice.LOST]
    with pytest.raises(RobotProblem) as caught:
        real.robot.forward(1)
    assert caught.value.code == "link-lost"


def test_silence_ends_the_walk_within_half_a_second() -> None:
    real = Real()
    real.pace.due = [(1.0, lambda: setattr(real.board, "is_mute", True))]

    assert real.robot.forward(9).stopped_by is StoppedBy.LINK
    assert real.robot.time() == pytest.approx(1.5, abs=0.1)
    assert real.stands


def test_a_board_that_restarts_ends_the_walk_and_nothing_resumes_by_itself() -> None:
    real = Real()
    real.pace.due = [(1.5, real.board.reset)]

    assert real.robot.forward(9).stopped_by is StoppedBy.LINK
    real.link.advance(5.0)
    with pytest.raises(RobotProblem):
        real.robot.forward(1)
    assert real.stands


def test_after_a_halt_a_restored_link_can_be_used() -> None:
    real = Real()
    real.pace.due = [(1.5, real.board.reset)]
    real.robot.forward(9)
    real.link.advance(5.0)
    before = real.robot.pose()
    real.robot.halt()

    moved = real.robot.forward(2)

    assert (moved.walked, moved.stopped_by) == (2, None)
    assert moved.pose.y - before.y == pytest.approx(2, abs=0.2)


def unplug(real: Real) -> None:
    real.link.is_plugged = False


def restart(real: Real) -> None:
    real.board.reset()


def unplug_and_plug_in(real: Real) -> None:
    unplug(real)
    real.link.advance(1.0)
    real.link.is_plugged = True
    real.link.advance(5.0)


@pytest.mark.parametrize(
    "fault", [unplug, unplug_and_plug_in, restart], ids=["unplugged", "back", "restarted"]
)
@pytest.mark.parametrize("waits", [lambda it: it.wait(30), lambda it: it.scan()], ids=["wait", "scan"])
def test_a_link_lost_in_a_wait_or_a_scan_ends_the_program(
    fault: Callable[[Real], None], waits: Callable[[Robot], object]
) -> None:
    """It raises at once, and so does the next command: otherwise the program would drive on."""
    real = Real()
    real.pace.due = [(1.5, lambda: fault(real))]

    with pytest.raises(RobotProblem) as caught:
        waits(real.robot)
    assert caught.value.code == "link-lost"
    real.link.is_plugged = True
    real.link.advance(6.0)
    with pytest.raises(RobotProblem):
        real.robot.forward(1)
    assert real.stands
    real.robot.halt()
    assert real.robot.wait(1) is True


COMMANDS: dict[str, Callable[[Robot], object]] = {
    "forward": lambda it: it.forward(1),
    "turn": lambda it: it.turn(90),
    "scan": lambda it: it.scan(),
    "wait": lambda it: it.wait(1),
    "distance": lambda it: it.distance(Bearing.FRONT),
}


@pytest.mark.parametrize("command", COMMANDS)
def test_after_a_movement_that_lost_the_link_only_the_next_command_fails_once_it_is_back(
    command: str,
) -> None:
    real = Real()
    real.pace.due = [(0.5, lambda: unplug(real))]
    assert real.robot.forward(9).stopped_by is StoppedBy.LINK
    real.link.is_plugged = True
    real.link.advance(5.0)
    assert real.notices[-1] is LinkNotice.RESTORED

    with pytest.raises(RobotProblem) as caught:
        COMMANDS[command](real.robot)
    assert (caught.value.code, caught.value.values) == ("link-lost", {"port": "double"})
    assert real.robot.wait(0.1) is True


def test_a_link_that_is_lost_and_back_during_a_pause_ends_the_walk() -> None:
    """All of it happens between two polls of the movement: the link's state is the same before and after."""
    real = Real()
    real.pace.due = [(1.5, lambda: unplug_and_plug_in(real))]

    moved = real.robot.forward(9)
    assert (moved.walked, moved.stopped_by) == (1, StoppedBy.LINK)
    assert real.stands


def test_a_link_that_is_lost_while_a_distance_waits_for_its_sonar_ends_the_program() -> None:
    """Right after its start not every sonar has measured."""
    real = Real()
    assert real.robot.telemetry.ranges[-1].centimetres[0] == 0
    real.pace.due = [(0.0, lambda: unplug(real))]

    with pytest.raises(RobotProblem) as caught:
        real.robot.distance(Bearing.FRONT_RIGHT)
    assert caught.value.code == "link-lost"


def test_a_wait_after_a_long_loss_is_as_long_as_it_says() -> None:
    """However often the port was tried in vain meanwhile."""
    real = Real()
    real.pace.due = [(0.5, lambda: unplug(real))]
    real.robot.forward(9)
    real.link.advance(20.0)
    real.link.is_plugged = True
    real.link.advance(5.0)
    real.robot.halt()
    before = real.robot.time()

    assert real.robot.wait(7) is True
    assert real.robot.time() - before == pytest.approx(7, abs=0.1)


@pytest.mark.parametrize("command", ["turn", "scan", "distance", "wait"])
def test_without_a_link_no_command_begins(command: str) -> None:
    real = Real()
    real.link.is_plugged = False
    real.link.advance(0.1)
    commands: dict[str, Callable[[], object]] = {
        "turn": lambda: real.robot.turn(90),
        "scan": real.robot.scan,
        "wait": lambda: real.robot.wait(1),
        "distance": lambda: real.robot.distance(Bearing.FRONT),
    }

    with pytest.raises(RobotProblem) as caught:
        commands[command]()
    assert caught.value.code == "link-lost"


def test_connecting_to_a_mute_board_fails() -> None:
    real = Real()
    real.robot.close()
    real.board.is_mute = True

    with pytest.raises(RobotProblem) as caught:
        real.robot.connect()
    assert caught.value.code == "no-answer"
