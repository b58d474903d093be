"""What is at a port, and how a robot whose program is gone is stopped: simulated boards in virtual time."""

from __future__ import annotations

import runpy
import struct
from collections.abc import Callable
from io import BytesIO
from types import SimpleNamespace

import pytest

from devices import port_exchange
from devices.belt import COMPLAINTS
from devices.board_simulator.board import SimulatedBoard
from devices.port_exchange import (
    READ_TIMEOUT,
    BeltIdentification,
    DeviceKind,
    EmergencyStop,
    HaltOutcome,
    IdentifiedDevice,
    RobotIdentification,
    guard,
    halt,
    halt_when_back,
    identify,
)
from devices.serial_ports import PortFault, PortProblem
from devices.wire.frames import (
    CONFIGURE,
    FILLER,
    STOP,
    MotorDrive,
    ReportKind,
    drive_frame,
    encode_frame,
)
from tests.unit.devices.board_ports import BeltOnly, BoardPort, opener, running

FORWARD = drive_frame(MotorDrive.FORWARD)
HALF_A_FRAME = b"\xaa\xbb\x32"
"""It announces fifty bytes: the board takes the next fifty for its data."""


CONFIG_WANTED = encode_frame(ReportKind.CONFIG_WANTED.value, b"\x2b")
PINGED = encode_frame(ReportKind.PING.value, b"\x42")
POWER = encode_frame(ReportKind.POWER.value, struct.pack("<h", 7400))


def wheels_at(right: int, left: int) -> bytes:
    return encode_frame(ReportKind.ENCODERS.value, struct.pack(">hhHH", right, left, 0, 0))


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


def test_a_board_is_given_its_configuration_when_it_asks_for_it() -> None:
    robot = RobotIdentification()

    assert robot.next(b"", 0.0) == b""
    assert robot.next(CONFIG_WANTED + PINGED, 1.0) == CONFIGURE
    assert robot.next(POWER, 1.1) == b""
    assert (robot.is_robot, robot.restarted, robot.millivolts, robot.is_driving) == (True, True, 7400, False)
    assert robot.is_over(1.1)


@pytest.mark.parametrize(("factor", "first", "battery"), [(1.0, 6.0, 2.0), (2.0, 12.0, 4.0)])
def test_a_robot_has_six_seconds_for_its_first_answer_and_then_two_for_its_battery(
    factor: float, first: float, battery: float
) -> None:
    robot = RobotIdentification(factor)
    assert not robot.is_over(99.0)
    robot.next(b"", 100.0)
    robot.next(b"", 101.0)
    assert not robot.is_over(100.0 + first - 0.1)
    assert robot.is_over(100.0 + first)

    robot.next(PINGED, 105.0)
    robot.next(PINGED, 106.0)
    assert not robot.is_over(105.0 + battery - 0.1)
    assert robot.is_over(105.0 + battery)


def test_the_wheels_of_a_board_that_was_not_restarted_are_watched_for_a_third_of_a_second() -> None:
    robot = RobotIdentification()
    robot.next(POWER, -1.0)
    assert not robot.is_over(0.0)
    robot.next(wheels_at(0, 0), 0.0)
    robot.next(wheels_at(0, 0), 0.2)
    assert not robot.is_over(0.29)
    assert robot.is_over(0.3)


@pytest.mark.parametrize(
    ("wheels", "is_driving"),
    [
        ([(0, 0), (21, 0), (21, 0)], True),
        ([(0, 0), (0, -21), (0, -21)], True),
        ([(0, 0), (20, -20), (20, -20)], False),
        ([(40, -40), (60, -20), (20, -60)], False),
        ([(40, -40), (40, -61), (40, -61)], True),
        ([(0, 0), (21, 0), (0, 0), (21, 0)], False),
        ([(0, 0), (21, 0), (21, 0), (0, 0)], True),
        ([(32760, 0), (-32760, 0), (-32760, 0)], False),
        ([(32760, 0), (-32755, 0), (-32755, 0)], True),
    ],
)
def test_a_robot_drives_if_a_wheel_has_turned_by_more_than_twenty_counts_in_two_frames(
    wheels: list[tuple[int, int]], is_driving: bool
) -> None:
    robot = RobotIdentification()
    robot.next(b"".join(wheels_at(*each) for each in wheels), 0.0)

    assert robot.is_driving is is_driving


def test_a_belt_has_half_a_second_for_its_complaint_and_is_asked_once() -> None:
    belt = BeltIdentification()
    assert not belt.is_over(99.0)
    assert [belt.next(b"", now) for now in (100.0, 100.1)] == [b"Z!", b""]
    assert not belt.is_over(100.4)
    assert belt.is_over(100.5)

    for complaint in COMPLAINTS:
        belt = BeltIdentification()
        belt.next(b"x" * 100 + complaint[:1], 0.0)
        assert not belt.is_over(0.1)
        belt.next(complaint[1:] + b"x" * 100, 0.1)
        assert (belt.is_belt, belt.is_over(0.1)) == (True, True)
    slow = BeltIdentification(2.0)
    slow.next(b"", 0.0)
    assert (slow.is_over(0.9), slow.is_over(1.0)) == (False, True)


def test_an_exchange_that_is_given_up_ends_at_once() -> None:
    port = BoardPort(None)
    identify("port", opener(port), is_given_up=lambda: True, now=port.now)

    assert (port.now(), port.written, port.is_closed) == (0.0, [], True)


def test_a_port_that_disappears_before_it_can_be_asked_for_a_belt_is_a_problem() -> None:
    class Pulled(BoardPort):
        def set_baud(self, baud: int) -> None:
            raise OSError(6, "No such device or address")

    port = Pulled(None)
    with pytest.raises(PortProblem) as caught:
        identified(port)
    assert (caught.value.port, caught.value.fault) == ("port", PortFault.ABSENT)
    assert port.is_closed


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


def test_a_silent_board_gets_zeros_after_its_start_and_then_two_stops() -> None:
    stop = EmergencyStop()
    times = (10.0, 11.49, 11.5, 11.59, 11.61, 11.65, 11.67, 11.8, 13.9)

    assert [stop.next(b"", now) for now in times] == [*(b"", b"", FILLER, b"", STOP, b"", STOP, b"", b"")]
    assert stop.outcome(13.9) is HaltOutcome.UNCONFIRMED
    assert (stop.is_over(13.9), stop.is_over(14.0)) == (False, True)


def test_a_board_that_streams_gets_zeros_at_once_and_then_stops_until_it_stands() -> None:
    stop = EmergencyStop()
    assert not stop.is_over(99.0)
    sent = [stop.next(wheels_at(tick, 0), 10.0 + tick * 0.03) for tick in range(11)]

    assert sent == [FILLER, b"", b"", b"", *[STOP, b""] * 3, STOP]
    assert stop.outcome(10.3) is HaltOutcome.DRIVES


@pytest.mark.parametrize(
    ("wheels", "now", "outcome"),
    [
        ([(7, 1.0), (7, 1.31)], 1.31, HaltOutcome.STANDS),
        ([(7, 1.0), (7, 1.31)], 1.6, HaltOutcome.STANDS),
        ([(7, 1.0), (7, 1.31)], 1.62, HaltOutcome.DRIVES),
        ([(7, 1.0), (7, 1.29)], 1.29, HaltOutcome.DRIVES),
        ([(7, 1.0), (8, 1.31)], 1.31, HaltOutcome.DRIVES),
        ([(7, 1.0), (8, 1.31)], 2.3, HaltOutcome.DRIVES),
        ([(7, 1.0), (8, 1.31)], 2.32, HaltOutcome.UNCONFIRMED),
        ([], 1.0, HaltOutcome.UNCONFIRMED),
    ],
)
def test_wheels_stand_whose_fresh_counts_have_not_changed_for_a_third_of_a_second(
    wheels: list[tuple[int, float]], now: float, outcome: HaltOutcome
) -> None:
    stop = EmergencyStop()
    for at in (0.0, 0.2, 0.3):  # zeros and two stops
        assert stop.next(wheels_at(3, 3), at)
    for count, at in wheels:
        stop.next(wheels_at(count, 0), at)

    assert stop.outcome(now) is outcome
    assert stop.is_over(now) is (outcome is HaltOutcome.STANDS)


def test_counts_from_before_the_stops_prove_nothing() -> None:
    stop = EmergencyStop()
    for at in (0.0, 0.2, 0.5):
        stop.next(wheels_at(3, 3), at)

    assert not stop.is_over(0.5)
    assert stop.outcome(0.5) is HaltOutcome.UNCONFIRMED


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


def test_a_mute_board_is_restarted_by_force_and_then_known_to_stand() -> None:
    board = driving()
    board.is_mute = True

    def pin() -> bool:
        board.is_mute = False
        board.reset()
        return True

    assert halted(BoardPort(board), by_force=pin) is HaltOutcome.STANDS


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
        self.pauses = self.reports = 0

    def now(self) -> float:
        return self.time

    def pause(self, seconds: float) -> None:
        self.time += seconds
        self.pauses += 1

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
    assert (gone.time, gone.pauses, gone.reports) == (60, 120, 1)


def test_a_port_that_another_program_has_is_left_to_it() -> None:
    busy = Replugged(BoardPort(driving()), 90.0, PortFault.BUSY)

    with pytest.raises(PortProblem):
        busy.halt_when_back()
    assert (busy.time, busy.pauses, busy.reports) == (pytest.approx(2), 40, 0)


@pytest.mark.parametrize("fault", [PortFault.UNUSABLE, PortFault.NO_PORT, PortFault.NOT_NAMED])
def test_a_port_that_can_not_come_back_is_not_waited_for(fault: PortFault) -> None:
    wrong = Replugged(BoardPort(driving()), 90.0, fault)

    with pytest.raises(PortProblem):
        wrong.halt_when_back()
    assert (wrong.time, wrong.reports) == (0.0, 0)


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
    port = BoardPort(board)

    def open_port(address: str, baud: int, *, exclusive: bool = True) -> BoardPort:
        asked.append(exclusive)
        if exclusive:
            raise PortProblem(address, PortFault.BUSY, "busy")
        return port

    assert halt("port", open_port) is HaltOutcome.IN_USE
    board.advance(0.1)
    assert asked == [True, False]
    assert not board.is_driving
    assert (port.written, port.is_closed) == ([STOP, STOP], True)


def test_a_port_that_can_not_be_opened_is_tried_once() -> None:
    asked = list[str]()

    def open_port(address: str, baud: int, *, exclusive: bool = True) -> BoardPort:
        asked.append(address)
        raise PortProblem(address, PortFault.FORBIDDEN, "forbidden")

    with pytest.raises(PortProblem):
        halt("port", open_port)
    assert asked == ["port"]


def test_a_guard_stops_its_robot_and_leaves_the_port(monkeypatch: pytest.MonkeyPatch) -> None:
    board = driving()
    port = BoardPort(board)
    monkeypatch.setattr("devices.port_exchange.monotonic", port.now)
    guard("port", opener(port))

    assert not board.is_driving
    assert port.is_closed


def test_a_guard_whose_port_can_not_be_used_ends() -> None:
    def open_port(address: str, baud: int) -> BoardPort:
        raise PortProblem(address, PortFault.UNUSABLE, "no")

    guard("port", open_port)


@pytest.mark.parametrize("exchange", [identify, halt])
def test_a_port_that_disappears_during_an_exchange_is_a_problem(exchange: Callable[..., object]) -> None:
    class Pulled(BoardPort):
        def read(self) -> bytes:
            raise OSError(5, "Input/output error")

    port = Pulled(None)
    with pytest.raises(PortProblem):
        exchange("port", opener(port))
    assert port.is_closed


@pytest.mark.parametrize(
    ("read", "opened"),
    [(b"", [("/dev/robot", 115200, {"timeout": 0.02, "exclusive": True})]), (b"not needed", [])],
)
def test_the_program_stops_its_robot_at_the_end_of_its_input_unless_it_is_not_needed(
    monkeypatch: pytest.MonkeyPatch, read: bytes, opened: list[object]
) -> None:
    asked: list[object] = []

    def open_port(address: str, baud: int, **how: object) -> None:
        asked.append((address, baud, how))
        raise PortProblem(address, PortFault.UNUSABLE, "no")

    monkeypatch.setattr("devices.serial_ports.SerialPort", open_port)
    monkeypatch.setattr("sys.stdin", SimpleNamespace(buffer=BytesIO(read)))
    monkeypatch.setattr("sys.argv", ["devices.port_exchange", "/dev/robot"])
    runpy.run_path(port_exchange.__file__, run_name="__main__")

    assert asked == opened


@pytest.mark.parametrize("exchange", [identify, halt])
def test_a_port_that_does_not_exist_is_absent(exchange: Callable[[str], object]) -> None:
    with pytest.raises(PortProblem) as caught:
        exchange("/dev/there-is-no-such-robot")

    assert caught.value.fault is PortFault.ABSENT
