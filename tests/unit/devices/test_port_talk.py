"""What is at a port, and how a robot without a program is stopped: simulated boards in virtual time."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path

import pytest

from devices.firmware_double.board import SimulatedBoard
from devices.port_talk.asking import Answer, Found, ask
from devices.port_talk.halting import Halted, halt
from devices.port_talk.line import Line, PortLine
from devices.serial_port import PortFault, PortProblem, group_of, is_same_port
from devices.wire.commands import FILLER, STOP, Drive, motors
from tests.unit.devices.board_line import BeltOnly, BoardLine, opening, running

FORWARD = motors(Drive.FORWARD)
HALF_A_FRAME = b"\xaa\xbb\x32"
"""It announces fifty bytes, which swallow whatever comes."""


# --- what is there


def test_a_robot_that_was_restarted_tells_its_battery() -> None:
    assert ask("port", opening(BoardLine(SimulatedBoard()))) == Found(Answer.ROBOT, 8000, restarted=True)


def test_a_robot_that_goes_on_tells_its_battery() -> None:
    line = BoardLine(running(SimulatedBoard()))

    assert ask("port", opening(line)) == Found(Answer.ROBOT, 8000)
    assert line.written == []
    assert line.is_closed


@pytest.mark.parametrize("is_restarted", [True, False])
def test_asking_moves_nothing(is_restarted: bool) -> None:
    board = SimulatedBoard() if is_restarted else running(SimulatedBoard())
    ask("port", opening(BoardLine(board)))
    board.advance(2.0)

    assert not board.is_driving
    assert (board.wheels.right, board.wheels.left) == (0.0, 0.0)


def test_a_belt_is_known_by_its_complaint() -> None:
    line = BeltOnly()

    assert ask("port", opening(line)) == Found(Answer.BELT)
    assert line.written == [b"Z!"]


def test_silence_is_nothing_after_a_time() -> None:
    line = BoardLine(None)

    assert ask("port", opening(line)) == Found(Answer.NOTHING)
    assert line.now() < 7.0


def test_rubbish_is_nothing() -> None:
    class Rubbish(BoardLine):
        def read(self) -> bytes:
            return super().read() + b"\xaa\xbb\x05hello E3\r\n"

    assert ask("port", opening(Rubbish(None))) == Found(Answer.NOTHING)


# --- stop


def driving() -> SimulatedBoard:
    board = running(SimulatedBoard(), FORWARD)
    assert board.is_driving
    return board


def test_a_robot_whose_program_is_gone_is_stopped() -> None:
    board = driving()

    assert halt("port", opening(BoardLine(board))) is Halted.STANDS
    assert not board.is_driving


def test_a_half_frame_does_not_swallow_the_stop() -> None:
    board = running(SimulatedBoard(), FORWARD + HALF_A_FRAME)
    assert board.is_driving

    assert halt("port", opening(BoardLine(board))) is Halted.STANDS
    assert not board.is_driving


def test_a_board_that_was_restarted_stands_and_is_not_disturbed_in_its_boot_loader() -> None:
    board = driving()
    board.reset()
    line = BoardLine(board)

    assert halt("port", opening(line)) is Halted.STANDS
    assert line.now() > 1.5
    assert line.written[0] == FILLER


def test_a_mute_board_is_stopped_although_nobody_knows() -> None:
    board = driving()
    board.is_mute = True

    assert halt("port", opening(BoardLine(board))) is Halted.UNCONFIRMED
    assert not board.is_driving


class SilentLater(BoardLine):
    """A board that tells nothing soon after it was told to stop, and drives all the same."""

    def __init__(self, board: SimulatedBoard) -> None:
        super().__init__(board)
        self._stops = 0
        self._frames_left = 3

    def write(self, data: bytes) -> None:
        self.written.append(data)
        self._stops += data == STOP

    def read(self) -> bytes:
        told = super().read()
        self._frames_left -= self._stops > 1
        return told if self._frames_left > 0 else b""


class Deaf(BoardLine):
    """A board that drives on whatever it is told."""

    def write(self, data: bytes) -> None:
        self.written.append(data)


def test_a_robot_that_words_do_not_stop_is_stopped_by_force_where_there_is_a_way() -> None:
    board, forced = driving(), list[float]()
    line = Deaf(board)

    def pin() -> bool:
        forced.append(line.now())
        board.reset()
        return True

    assert halt("port", opening(line), by_force=pin) is Halted.STANDS
    assert len(forced) == 1
    assert not board.is_driving


def test_a_robot_that_heeds_is_not_stopped_by_force() -> None:
    def pin() -> bool:
        raise AssertionError

    assert halt("port", opening(BoardLine(driving())), by_force=pin) is Halted.STANDS


def test_without_a_way_to_force_it_nothing_is_claimed() -> None:
    assert halt("port", opening(Deaf(driving()))) is Halted.UNCONFIRMED


def test_a_board_that_falls_silent_is_not_known_to_stand() -> None:
    board = driving()

    assert halt("port", opening(SilentLater(board))) is Halted.UNCONFIRMED
    assert board.is_driving


def test_a_port_in_use_that_can_not_be_written_to_is_a_problem() -> None:
    class Full(BoardLine):
        def write(self, data: bytes) -> None:
            raise OSError(5, "Input/output error")

    line = Full(None)

    def opened(port: str, baud: int, *, exclusive: bool = True) -> Line:
        if exclusive:
            raise PortProblem(port, PortFault.BUSY, "busy")
        return line

    with pytest.raises(PortProblem) as caught:
        halt("port", opened)
    assert caught.value.fault is PortFault.BUSY
    assert line.is_closed


def test_where_nothing_is_nothing_is_known() -> None:
    line = BoardLine(None)

    assert halt("port", opening(line)) is Halted.UNCONFIRMED
    assert line.written == [FILLER, STOP, STOP]
    assert line.now() < 4.1


def test_a_port_in_use_is_told_to_stop_all_the_same() -> None:
    board, asked = driving(), list[bool]()

    def opened(port: str, baud: int, *, exclusive: bool = True) -> Line:
        asked.append(exclusive)
        if exclusive:
            raise PortProblem(port, PortFault.BUSY, "busy")
        return BoardLine(board)

    assert halt("port", opened) is Halted.IN_USE
    board.advance(0.1)
    assert asked == [True, False]
    assert not board.is_driving


def test_a_port_that_goes_away_meanwhile_is_a_problem() -> None:
    class Pulled(BoardLine):
        def read(self) -> bytes:
            raise OSError(5, "Input/output error")

    for talk in (ask, halt):
        line = Pulled(None)
        with pytest.raises(PortProblem):
            talk("port", opening(line))
        assert line.is_closed


# --- real ports


@pytest.mark.parametrize("talk", [ask, halt])
def test_a_port_that_is_not_there_is_absent(talk: Callable[[str], object]) -> None:
    with pytest.raises(PortProblem) as caught:
        talk("/dev/there-is-no-such-robot")

    assert caught.value.fault is PortFault.ABSENT


def test_a_file_is_no_port(tmp_path: Path) -> None:
    file = tmp_path / "file"
    file.touch()

    with pytest.raises(PortProblem) as caught:
        PortLine(str(file), 9600)
    assert caught.value.fault is PortFault.UNUSABLE


def test_only_one_program_has_a_port_at_a_time() -> None:
    ours, theirs = os.openpty()
    first = PortLine(os.ttyname(theirs), 9600)
    with pytest.raises(PortProblem) as caught:
        PortLine(os.ttyname(theirs), 9600)
    first.close()
    PortLine(os.ttyname(theirs), 9600).close()

    assert caught.value.fault is PortFault.BUSY
    os.close(ours)
    os.close(theirs)


def test_two_names_of_one_device_are_the_same_port(tmp_path: Path) -> None:
    link = tmp_path / "by-id"
    link.symlink_to("/dev/null")

    assert is_same_port(str(link), "/dev/null")
    assert not is_same_port(str(link), "/dev/zero")


def test_the_group_that_may_use_a_port_is_named() -> None:
    assert group_of("/dev/there-is-no-such-robot") == "dialout"
    assert group_of("/dev/null") is None  # nobody is to join root
