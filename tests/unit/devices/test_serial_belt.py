"""The belt on its port: off at the end, reported once when it is lost, and no caller ever waits for it."""

from __future__ import annotations

import os
import threading
import tty
from collections import deque
from collections.abc import Callable, Iterator
from time import monotonic

import pytest

from devices.belt import MOTORS, OFF, RESYNC, BeltNotice, SerialBelt, encode_frame
from devices.serial_ports import PortFault, PortProblem
from tests.simulated_belt import SimulatedBelt
from tests.timeouts import TIMEOUT


@pytest.fixture(autouse=True)
def _no_belt_is_reported_missing(monkeypatch: pytest.MonkeyPatch) -> None:
    """These ports answer nothing, and a test may take its time on a busy machine."""
    monkeypatch.setattr("devices.belt.ASKED_AGAIN", 1e9)


FRONT = (0, 0, 0, 3, 0, 0, 0) * 2
ANSWER = 0.008
"""Seconds that a board takes to complain, including the transmission at 9600 baud."""


class FakePort:
    """A port that can fail. ``written``: what was written until then."""

    unsent = 0

    def __init__(self) -> None:
        self.written: list[bytes] = []
        self.fault: Exception | None = None
        self.is_closed = False
        self._changed = threading.Condition()

    def write(self, data: bytes) -> None:
        if self.fault:
            raise self.fault
        with self._changed:
            self.written.append(data)
            self._changed.notify_all()

    def read(self) -> bytes:
        if self.fault:
            raise self.fault
        return b""

    def close(self) -> None:
        with self._changed:
            self.is_closed = True
            self._changed.notify_all()

    def wait_for(self, is_met: Callable[[], bool]) -> bool:
        with self._changed:
            return self._changed.wait_for(is_met, TIMEOUT)


class CloggedPort(FakePort):
    """A port whose bytes don't leave the system. ``polls``: how often the belt asked for that."""

    clogged = 36
    polls = 0

    @property
    def unsent(self) -> int:  # type: ignore[override] # what is fixed in others
        with self._changed:
            self.polls += 1
            self._changed.notify_all()
        return self.clogged


class SlowPort(FakePort):
    """A port at its real pace: the board answers some time after the bytes were written."""

    def __init__(self) -> None:
        super().__init__()
        self._board = SimulatedBelt()
        self._answers: deque[tuple[float, bytes]] = deque()

    def write(self, data: bytes) -> None:
        if answer := self._board.feed(data, monotonic()):
            self._answers.append((monotonic() + ANSWER, answer))
        super().write(data)

    def read(self) -> bytes:
        is_there = bool(self._answers) and monotonic() >= self._answers[0][0]
        return self._answers.popleft()[1] if is_there else b""

    def frames(self) -> int:
        return self.written.count(encode_frame(FRONT))


class Notices:
    """The notices of a belt, to be waited for."""

    def __init__(self) -> None:
        self.received: list[BeltNotice] = []
        self.reason = ""
        self._changed = threading.Condition()

    def __call__(self, notice: BeltNotice, reason: str) -> None:
        with self._changed:
            self.reason = reason
            self.received.append(notice)
            self._changed.notify_all()

    def wait_for(self, *wanted: BeltNotice) -> bool:
        with self._changed:
            return self._changed.wait_for(lambda: self.received == list(wanted), TIMEOUT)


@pytest.fixture
def port() -> FakePort:
    return FakePort()


@pytest.fixture
def notices() -> Notices:
    return Notices()


@pytest.fixture
def belt(port: FakePort, notices: Notices) -> Iterator[SerialBelt]:
    made = SerialBelt("nowhere", notices, lambda _: port)
    yield made
    made.close()


def test_levels_reach_the_port_and_closing_turns_them_off(belt: SerialBelt, port: FakePort) -> None:
    belt.show(FRONT)
    assert port.wait_for(lambda: encode_frame(FRONT) in port.written)
    belt.close()

    assert port.written[-1] == encode_frame(OFF)
    assert port.is_closed


def test_the_last_pulse_is_felt_before_the_port_is_closed(belt: SerialBelt, port: FakePort) -> None:
    belt.show(FRONT)
    belt.show(OFF)
    belt.close()

    assert encode_frame(FRONT) in port.written
    assert port.written[-1] == encode_frame(OFF)


@pytest.mark.parametrize("fault", [OSError(5, "gone"), ValueError("closed")], ids=["pulled", "closed"])
def test_a_lost_belt_is_reported_once_and_once_when_it_is_back(
    port: FakePort, notices: Notices, fault: Exception, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("devices.belt.RETRY", 0.001)
    ports, is_back = [port], threading.Event()

    def open_port(address: str) -> FakePort:
        if len(ports) > 1 and not is_back.is_set():
            raise PortProblem(address, PortFault.ABSENT, "not there")
        ports.append(FakePort())
        return ports[-2]

    belt = SerialBelt("nowhere", notices, open_port)
    port.fault = fault
    belt.show(FRONT)
    assert notices.wait_for(BeltNotice.LOST)
    is_back.set()
    assert notices.wait_for(BeltNotice.LOST, BeltNotice.RESTORED)

    second = ports[1]
    assert second.wait_for(lambda: encode_frame(FRONT) in second.written)
    assert second.written[0] == b"Z!"
    belt.close()


@pytest.mark.parametrize("is_idle", [False, True])
def test_a_board_that_answers_late_gets_one_resync_and_then_frames(notices: Notices, is_idle: bool) -> None:
    port = SlowPort()
    belt = SerialBelt("nowhere", notices, lambda _: port)
    if is_idle:
        assert port.wait_for(lambda: port.written == [RESYNC])
    belt.show(FRONT)

    assert port.wait_for(lambda: port.frames() >= 3 or port.written.count(RESYNC) >= 3)
    belt.close()
    assert port.written.count(RESYNC) == 1


def test_an_idle_belt_that_is_unplugged_is_reported_and_found_again(
    port: FakePort, notices: Notices, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("devices.belt.RETRY", 0.001)
    ports = [FakePort(), port]
    belt = SerialBelt("nowhere", notices, lambda _: ports.pop())
    assert port.wait_for(lambda: port.written == [RESYNC])
    port.fault = OSError(5, "gone")

    assert notices.wait_for(BeltNotice.LOST, BeltNotice.RESTORED)
    assert port.is_closed
    belt.close()


def test_a_listener_that_hangs_does_not_hold_up_the_belt(
    port: FakePort, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("devices.belt.RETRY", 0.001)
    may_return, second = threading.Event(), FakePort()
    ports = [second, port]
    belt = SerialBelt("nowhere", lambda *notice: may_return.wait() and None, lambda _: ports.pop())
    port.fault = OSError(5, "gone")
    belt.show(FRONT)

    assert second.wait_for(lambda: encode_frame(FRONT) in second.written)
    belt.close()
    assert second.written[-1] == encode_frame(OFF)
    may_return.set()


def test_a_belt_that_showed_nothing_is_turned_off_all_the_same(belt: SerialBelt, port: FakePort) -> None:
    """Another program may have left its motors on."""
    belt.close()

    assert port.written[-1] == encode_frame(OFF)


def test_while_an_earlier_frame_waits_in_the_system_only_the_newest_is_kept(notices: Notices) -> None:
    port = CloggedPort()
    belt = SerialBelt("nowhere", notices, lambda _: port)
    for levels in [(1,) * MOTORS, (2,) * MOTORS, (3,) * MOTORS]:
        port.polls = 0
        belt.show(levels)
        assert port.wait_for(lambda: port.polls >= 3)
    assert port.written == []

    port.clogged = 0
    assert port.wait_for(lambda: len(port.written) >= 2)
    belt.close()
    assert port.written[:2] == [RESYNC, encode_frame((3,) * MOTORS)]


def test_a_missing_belt_is_a_problem_with_the_systems_reason() -> None:
    with pytest.raises(PortProblem) as caught:
        SerialBelt("/dev/there-is-no-such-belt", Notices())

    assert caught.value.fault is PortFault.ABSENT
    assert caught.value.reason == "No such file or directory"


SLOW = "socket://there.is.no.answer:7000"


class SlowNetwork:
    """Opens a port only once ``answer`` is set."""

    def __init__(self, port: FakePort | None) -> None:
        self._port = port
        self.answer = threading.Event()

    def __call__(self, address: str) -> FakePort:
        assert self.answer.wait(TIMEOUT)
        if self._port is None:
            raise PortProblem(address, PortFault.UNUSABLE, "timed out")
        return self._port


def test_no_caller_waits_for_a_network_address_and_a_belt_that_opens_later_is_reported(
    port: FakePort, notices: Notices
) -> None:
    network = SlowNetwork(port)
    belt = SerialBelt(SLOW, notices, network)
    belt.show(FRONT)
    assert notices.received == []
    network.answer.set()

    assert notices.wait_for(BeltNotice.FOUND)
    assert port.wait_for(lambda: encode_frame(FRONT) in port.written)
    belt.close()
    assert port.written[-1] == encode_frame(OFF)


def test_a_network_address_without_a_belt_is_reported_once_with_the_reason(notices: Notices) -> None:
    network = SlowNetwork(None)
    belt = SerialBelt(SLOW, notices, network)
    belt.show(FRONT)
    network.answer.set()

    assert notices.wait_for(BeltNotice.MISSING)
    assert notices.reason == "timed out"
    belt.close()
    assert notices.received == [BeltNotice.MISSING]


def test_a_belt_that_opens_after_closing_is_turned_off_and_closed_in_silence(
    port: FakePort, notices: Notices
) -> None:
    network = SlowNetwork(port)
    belt = SerialBelt(SLOW, notices, network)
    belt.show(FRONT)
    belt.close()
    network.answer.set()

    assert port.wait_for(lambda: port.is_closed)
    assert port.written[-1] == encode_frame(OFF)
    assert notices.received == []


def test_a_real_port_carries_frames_to_a_board(notices: Notices) -> None:
    """Over a pseudo-terminal, with the system's own buffers between."""
    ours, theirs = os.openpty()
    tty.setraw(ours)
    belt = SerialBelt(os.ttyname(theirs), notices)
    belt.show((3,) * MOTORS)
    board, seconds = SimulatedBelt(), 0.0
    while board.frames < 3:
        os.write(ours, board.feed(os.read(ours, 100), seconds))
    assert board.motors(seconds) == ("A",) * MOTORS
    belt.close()
    while set(board.motors(seconds)) != {"P"}:
        board.feed(os.read(ours, 100), seconds)

    os.close(ours)
    os.close(theirs)
    assert notices.received == []


def test_a_port_on_which_no_belt_answers_is_reported(
    monkeypatch: pytest.MonkeyPatch, notices: Notices
) -> None:
    monkeypatch.setattr("devices.belt.ASKED_AGAIN", 0.0)
    monkeypatch.setattr("devices.belt.GIVEN_UP", 0.0)
    belt = SerialBelt("belt", notices, lambda _: FakePort())
    try:
        assert notices.wait_for(BeltNotice.UNANSWERED)
    finally:
        belt.close()
