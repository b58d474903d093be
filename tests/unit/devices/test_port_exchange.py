"""What is at a port, and how a robot whose program is gone is stopped: simulated boards in virtual time."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from devices.board_simulator.board import SimulatedBoard
from devices.port_exchange import (
    READ_TIMEOUT,
    DeviceKind,
    HaltOutcome,
    IdentifiedDevice,
    halt,
    halt_when_back,
    identify,
)
from devices.serial_ports import PortFault, PortProblem
from devices.wire.frames import FILLER, STOP, MotorDrive, drive_frame
from tests.unit.devices.board_ports import BeltOnly, BoardPort, opener, running

FORWARD = drive_frame(MotorDrive.FORWARD)
HALF_A_FRAME = b"\xaa\xbb\x32"
"""It announces fifty bytes: the board takes the next fifty for its data."""


def identified(port: BoardPort) -> IdentifiedDevice:
    return identify("port", opener(port), now=port.now)


def halted(port: BoardPort, by_force: Callable[[], bool] = lambda: False) -> HaltOutcome:
    return halt("port", opener(port), by_force=by_force, now=port.now)


# --- identify


def test_a_robot_that_opening_restarted_reports_its_battery() -> None:
    found = identified(BoardPort(SimulatedBoard()))

    assert found == IdentifiedDevice(DeviceKind.ROBOT, 8000, restarted=True)


def test_a_robot_that_is_running_reports_its_battery_and_gets_no_bytes() -> None:
    port = BoardPort(running(SimulatedBoard()))

    assert identified(port) == IdentifiedDevice(DeviceKind.ROBOT, 8000)
    assert port.written == []
    assert port.is_closed


@pytest.mark.parametrize("drive", [MotorDrive.FORWARD, MotorDrive.LEFT])
def test_a_robot_that_drives_is_identified_as_driving_and_is_not_stopped_by_that(drive: MotorDrive) -> None:
    board = running(SimulatedBoard(), drive_frame(drive))

    assert identified(BoardPort(board)) == IdentifiedDevice(DeviceKind.ROBOT, 8000, is_driving=True)
    assert board.is_driving


class SlowPort(BoardPort):
    """Of a board whose time passes ten times as slowly as the computer's."""

    def read(self) -> bytes:
        self._now += READ_TIMEOUT
        return self.board.advance(READ_TIMEOUT / 10) if self.board else b""


def test_a_slow_board_is_waited_for_longer_where_all_timeouts_are() -> None:
    """Its start of two seconds takes twenty here."""
    port = SlowPort(SimulatedBoard())
    assert identify("port", opener(port), now=port.now).kind is DeviceKind.NOTHING

    port = SlowPort(SimulatedBoard())
    assert identify("port", opener(port), now=port.now, factor=20) == IdentifiedDevice(
        DeviceKind.ROBOT, 8000, restarted=True
    )


def test_a_slow_board_is_stopped_where_all_timeouts_are_longer() -> None:
    port = SlowPort(SimulatedBoard())
    assert halt("port", opener(port), now=port.now) is HaltOutcome.UNCONFIRMED

    port = SlowPort(SimulatedBoard())
    assert halt("port", opener(port), now=port.now, factor=20) is HaltOutcome.STANDS


def test_a_torn_count_is_no_drive() -> None:
    board = running(SimulatedBoard())

    class Torn(BoardPort):
        def read(self) -> bytes:
            received = super().read()
            board.is_torn = True
            return received

    assert not identified(Torn(board)).is_driving


@pytest.mark.parametrize("is_restarted", [True, False])
def test_identifying_moves_nothing(is_restarted: bool) -> None:
    board = SimulatedBoard() if is_restarted else running(SimulatedBoard())
    identified(BoardPort(board))
    board.advance(2.0)

    assert not board.is_driving
    assert (board.wheels.right, board.wheels.left) == (0.0, 0.0)


def test_a_belt_is_identified_by_its_complaint() -> None:
    port = BeltOnly()

    assert identified(port) == IdentifiedDevice(DeviceKind.BELT)
    assert port.written == [b"Z!"]


def test_a_belt_is_identified_however_much_noise_comes_with_its_complaint() -> None:
    class Noisy(BeltOnly):
        def read(self) -> bytes:
            return super().read() + bytes(80)

    assert identified(Noisy()) == IdentifiedDevice(DeviceKind.BELT)


def test_a_silent_port_is_given_up_within_seven_seconds() -> None:
    port = BoardPort(None)

    assert identified(port) == IdentifiedDevice(DeviceKind.NOTHING)
    assert port.now() < 7.0


def test_garbage_is_no_device() -> None:
    class Garbage(BoardPort):
        def read(self) -> bytes:
            return super().read() + b"\xaa\xbb\x05hello E3\r\n"

    assert identified(Garbage(None)) == IdentifiedDevice(DeviceKind.NOTHING)


# --- stop


def driving() -> SimulatedBoard:
    board = running(SimulatedBoard(), FORWARD)
    assert board.is_driving
    return board


def test_a_robot_whose_program_is_gone_is_stopped() -> None:
    board = driving()

    assert halted(BoardPort(board)) is HaltOutcome.STANDS
    assert not board.is_driving


def test_a_half_frame_does_not_swallow_the_stop() -> None:
    board = running(SimulatedBoard(), FORWARD + HALF_A_FRAME)
    assert board.is_driving

    assert halted(BoardPort(board)) is HaltOutcome.STANDS
    assert not board.is_driving


def test_a_board_that_was_restarted_stands_and_is_not_disturbed_in_its_boot_loader() -> None:
    board = driving()
    board.reset()
    port = BoardPort(board)

    assert halted(port) is HaltOutcome.STANDS
    assert port.now() > 1.5
    assert port.written[0] == FILLER


def test_a_mute_board_is_stopped_although_that_is_not_confirmed() -> None:
    board = driving()
    board.is_mute = True

    assert halted(BoardPort(board)) is HaltOutcome.UNCONFIRMED
    assert not board.is_driving


class SilentAfterStops(BoardPort):
    """A board that sends nothing soon after the stops, and drives on."""

    def __init__(self, board: SimulatedBoard) -> None:
        super().__init__(board)
        self._stops = 0
        self._frames_left = 3

    def write(self, data: bytes) -> None:
        self.written.append(data)
        self._stops += data == STOP

    def read(self) -> bytes:
        received = super().read()
        self._frames_left -= self._stops > 1
        return received if self._frames_left > 0 else b""


class Deaf(BoardPort):
    """A board that receives nothing."""

    def write(self, data: bytes) -> None:
        self.written.append(data)


def test_a_robot_that_ignores_stops_is_stopped_by_force_where_that_is_possible() -> None:
    board, forced = driving(), list[float]()
    port = Deaf(board)

    def pin() -> bool:
        forced.append(port.now())
        board.reset()
        return True

    assert halted(port, by_force=pin) is HaltOutcome.STANDS
    assert len(forced) == 1
    assert not board.is_driving


def test_a_robot_that_obeys_is_not_stopped_by_force() -> None:
    def pin() -> bool:
        raise AssertionError

    assert halted(BoardPort(driving()), by_force=pin) is HaltOutcome.STANDS


def test_without_force_a_robot_that_ignores_stops_is_reported_to_drive() -> None:
    board = driving()
    board.is_deaf = True

    assert halted(BoardPort(board)) is HaltOutcome.DRIVES
    assert board.is_driving


# --- a robot whose port is gone


class Replugged:
    """Ports that open from a time on. It is their clock, and each pause lets it run."""

    def __init__(self, port: BoardPort, back_at: float, fault: PortFault = PortFault.ABSENT) -> None:
        self._port, self._back_at, self._fault = port, back_at, fault
        self.time = 0.0
        self.reports = 0

    def now(self) -> float:
        return self.time

    def pause(self, seconds: float) -> None:
        self.time += seconds

    def stop(self) -> HaltOutcome:
        if self.time < self._back_at:
            raise PortProblem("port", self._fault, "gone")
        return halted(self._port)

    def report(self) -> None:
        self.reports += 1

    def halt_when_back(self) -> HaltOutcome:
        return halt_when_back(self.stop, now=self.now, pause=self.pause, on_absent=self.report)


@pytest.mark.parametrize("fault", [PortFault.ABSENT, PortFault.FORBIDDEN])
def test_a_robot_is_stopped_when_its_port_returns(fault: PortFault) -> None:
    board = driving()
    gone = Replugged(BoardPort(board), 40.0, fault)

    assert gone.halt_when_back() is HaltOutcome.STANDS
    assert not board.is_driving
    assert gone.reports == 1


def test_a_port_that_is_there_is_not_waited_for() -> None:
    there = Replugged(BoardPort(driving()), 0.0)

    assert there.halt_when_back() is HaltOutcome.STANDS
    assert (there.time, there.reports) == (0.0, 0)


def test_a_port_that_stays_away_is_given_up_after_a_minute() -> None:
    gone = Replugged(BoardPort(driving()), 90.0)

    with pytest.raises(PortProblem):
        gone.halt_when_back()
    assert gone.time == pytest.approx(60, abs=1)


def test_a_port_that_another_program_has_is_left_to_it() -> None:
    busy = Replugged(BoardPort(driving()), 90.0, PortFault.BUSY)

    with pytest.raises(PortProblem):
        busy.halt_when_back()
    assert busy.time == pytest.approx(2, abs=0.1)
    assert busy.reports == 0


def test_a_port_that_the_system_has_not_closed_yet_for_a_killed_program_is_waited_for() -> None:
    """It closes the files of a process one after the other, and the guard's line may be before the port."""
    board = driving()

    assert Replugged(BoardPort(board), 0.3, PortFault.BUSY).halt_when_back() is HaltOutcome.STANDS
    assert not board.is_driving


def test_a_board_that_falls_silent_is_not_reported_to_stand() -> None:
    board = driving()

    assert halted(SilentAfterStops(board)) is HaltOutcome.UNCONFIRMED
    assert board.is_driving


def test_a_busy_port_that_can_not_be_written_to_is_a_problem() -> None:
    class Full(BoardPort):
        def write(self, data: bytes) -> None:
            raise OSError(5, "Input/output error")

    port = Full(None)

    def open_port(address: str, baud: int, *, exclusive: bool = True) -> BoardPort:
        if exclusive:
            raise PortProblem(address, PortFault.BUSY, "busy")
        return port

    with pytest.raises(PortProblem) as caught:
        halt("port", open_port)
    assert caught.value.fault is PortFault.BUSY
    assert port.is_closed


def test_a_port_without_a_device_gets_a_stop_and_is_given_up_after_four_seconds() -> None:
    port = BoardPort(None)

    assert halted(port) is HaltOutcome.UNCONFIRMED
    assert port.written == [FILLER, STOP, STOP]
    assert port.now() < 4.1


def test_a_busy_port_is_sent_a_stop_all_the_same() -> None:
    board, asked = driving(), list[bool]()

    def open_port(address: str, baud: int, *, exclusive: bool = True) -> BoardPort:
        asked.append(exclusive)
        if exclusive:
            raise PortProblem(address, PortFault.BUSY, "busy")
        return BoardPort(board)

    assert halt("port", open_port) is HaltOutcome.IN_USE
    board.advance(0.1)
    assert asked == [True, False]
    assert not board.is_driving


@pytest.mark.parametrize("exchange", [identify, halt])
def test_a_port_that_disappears_during_an_exchange_is_a_problem(exchange: Callable[..., object]) -> None:
    class Pulled(BoardPort):
        def read(self) -> bytes:
            raise OSError(5, "Input/output error")

    port = Pulled(None)
    with pytest.raises(PortProblem):
        exchange("port", opener(port))
    assert port.is_closed


@pytest.mark.parametrize("exchange", [identify, halt])
def test_a_port_that_does_not_exist_is_absent(exchange: Callable[[str], object]) -> None:
    with pytest.raises(PortProblem) as caught:
        exchange("/dev/there-is-no-such-robot")

    assert caught.value.fault is PortFault.ABSENT
