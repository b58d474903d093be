"""The belt on its port: off at the end, reported once when it is lost, and no caller ever waits for it."""

from __future__ import annotations

import os
import threading
import tty
from collections import deque
from collections.abc import Callable, Iterator
from time import monotonic
from types import SimpleNamespace
from typing import Any

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
        self.arrived: list[bytes] = []
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
        return self.arrived.pop(0) if self.arrived else b""

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


def test_closing_does_not_wait_for_a_lost_belt_that_is_just_being_opened_again(
    port: FakePort, notices: Notices, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("devices.belt.RETRY", 0.001)
    second, is_asked, joined = FakePort(), threading.Event(), list[float]()
    network, at_once = SlowNetwork(second), [port]

    def open_port(address: str) -> FakePort:
        if at_once:
            return at_once.pop()
        is_asked.set()
        return network(address)

    belt = SerialBelt("nowhere", notices, open_port)
    monkeypatch.setattr(belt._thread, "join", joined.append)
    port.fault = OSError(5, "gone")
    assert notices.wait_for(BeltNotice.LOST)
    assert is_asked.wait(TIMEOUT)
    belt.close()
    assert joined == []

    network.answer.set()
    assert second.wait_for(lambda: second.is_closed)
    assert second.written[-1] == encode_frame(OFF)


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


# --- its thread, step by step


class Waits:
    """In place of a condition: records the waits and does not wait."""

    def __init__(self) -> None:
        self.waits: list[float] = []
        self.notified = 0

    def __enter__(self) -> None: ...

    def __exit__(self, *_: object) -> None: ...

    def wait(self, seconds: float) -> None:
        self.waits.append(seconds)

    def wait_for(self, _: object, seconds: float) -> None:
        self.waits.append(seconds)

    def notify(self) -> None:
        self.notified += 1

    def notify_all(self) -> None: ...


class Stepped:
    """A belt whose thread the test is; ``now`` is the time."""

    def __init__(self, patch: pytest.MonkeyPatch, address: str = "belt") -> None:
        self.now, self.joined = 100.0, list[float]()
        self.opened: list[FakePort | Exception] = [FakePort()]
        self.knew: list[bool] = []
        """Whether it knew at each opening that it was opening its port."""
        self.notices = Notices()
        thread = SimpleNamespace(start=lambda: None, join=self.joined.append)
        fake = SimpleNamespace(Thread=lambda **_: thread, Condition=Waits)
        patch.setattr("devices.belt.threading", fake)
        patch.setattr("devices.belt.monotonic", lambda: self.now)
        self.belt = SerialBelt(address, self.notices, self._open)
        self.condition: Any = self.belt._changed

    def _open(self, address: str) -> Any:
        self.knew.append(self.belt._is_opening)
        opened = self.opened.pop(0)
        if isinstance(opened, Exception):
            raise opened
        return opened

    @property
    def port(self) -> Any:
        return self.belt._port

    def waits(self) -> list[float]:
        waits, self.condition.waits = self.condition.waits, []
        return list(waits)

    def polled(self) -> tuple[list[bytes], list[float]]:
        """What one poll writes, and how long it rests then."""
        written = len(self.port.written)
        self.belt._poll()
        return self.port.written[written:], self.waits()


@pytest.mark.parametrize(("address", "seconds"), [("/dev/belt", 2.0), ("socket://belt:1", 0.0)])
def test_only_a_device_of_this_machine_is_waited_for_two_seconds(
    monkeypatch: pytest.MonkeyPatch, address: str, seconds: float
) -> None:
    assert Stepped(monkeypatch, address).waits() == [seconds]


def test_a_belt_rests_until_something_is_due_and_half_a_second_at_most(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    made = Stepped(monkeypatch)
    made.waits()
    assert made.belt._open_first() is True
    assert made.notices.wait_for(BeltNotice.FOUND)
    assert made.polled() == ([b"Z!"], [])
    made.now += 0.03
    assert made.polled() == ([], [0.5])
    made.belt.show(FRONT)
    assert made.polled() == ([encode_frame(FRONT)], [])
    made.now += 0.01
    written, waits = made.polled()
    assert (written, waits) == ([], [pytest.approx(0.03)])
    made.port.unsent = 36
    made.now += 1.0
    assert made.polled() == ([], [0.01])  # it asks again soon, and writes no frame behind another


def test_a_lost_belt_is_tried_again_every_second_and_begins_with_a_resync(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    made = Stepped(monkeypatch)
    made.belt._open_first()
    made.polled()
    lost = made.port
    made.belt._lose(OSError(5, "Input/output error"))
    assert (lost.is_closed, made.port, made.belt._detector) == (True, None, None)
    absent = PortProblem("belt", PortFault.ABSENT, "No such file or directory")
    made.opened = [absent, OSError(5, "x"), FakePort()]
    made.waits()
    for _ in range(3):
        made.belt._poll()
    assert made.waits() == [1.0, 1.0, 1.0]
    assert made.notices.wait_for(BeltNotice.FOUND, BeltNotice.LOST, BeltNotice.RESTORED)
    assert (made.knew, made.belt._is_opening) == ([True] * 4, False)
    made.now += 1.0
    assert made.polled() == ([b"Z!"], [])


def test_what_is_shown_and_the_end_wake_the_thread(monkeypatch: pytest.MonkeyPatch) -> None:
    made = Stepped(monkeypatch)
    woken = []
    for do in (lambda: made.belt.show(FRONT), made.belt.close):
        do()
        woken.append(made.condition.notified)

    assert woken == [1, 2]


@pytest.mark.parametrize(
    ("arrived", "written", "noticed"),
    [
        ([], {100.0: b"Z!", 103.0: b"Z!"}, {104.0: BeltNotice.UNANSWERED}),
        ([b"E1\r", b"\n"], {100.0: b"Z!"}, {}),
        ([b"\xaa\xbb\x34\x02"], {100.0: b"Z!", 103.0: b"Z!"}, {104.0: BeltNotice.UNANSWERED}),
    ],
    ids=["mute", "a belt", "a robot"],
)
def test_a_device_that_does_not_answer_is_asked_after_three_seconds_and_reported_after_four(
    monkeypatch: pytest.MonkeyPatch,
    arrived: list[bytes],
    written: dict[float, bytes],
    noticed: dict[float, BeltNotice],
) -> None:
    """The same after its port was lost and opened again."""
    monkeypatch.setattr("devices.belt.ASKED_AGAIN", 3.0)
    made = Stepped(monkeypatch)
    notices: dict[float, BeltNotice] = {}
    made.belt._notifier = SimpleNamespace(  # type: ignore[assignment]
        notify=lambda notice, _: notices.update({made.now - later: notice})
    )
    later = 0.0
    made.belt._open_first()
    for later in (0.0, 100.0):
        made.port.arrived = list(arrived)
        notices.clear()
        sent = {}
        for moment in (100.0, 100.5, 102.0, 102.99, 103.0, 103.5, 104.0, 105.0):
            made.now = moment + later
            for data in made.polled()[0]:
                sent[moment] = data
        assert (sent, notices) == (written, noticed)
        made.opened = [FakePort()]
        made.belt._lose(OSError(5, "Input/output error"))
        made.belt._poll()


def test_a_closed_belt_is_done_after_its_last_pulse_and_ends_dark(monkeypatch: pytest.MonkeyPatch) -> None:
    made = Stepped(monkeypatch)
    made.belt._open_first()
    made.polled()
    made.now += 0.03
    made.belt.show(FRONT)
    made.polled()
    port = made.port
    made.belt.close()
    assert made.joined == [1.0]
    assert not made.belt._is_done()
    made.now += 0.26
    made.polled()
    assert made.belt._is_done()
    made.waits()
    made.belt._rest()
    assert made.waits() == []
    made.belt._turn_off()
    assert (port.written[-1], port.is_closed) == (encode_frame((0,) * 14), True)
    made.belt._reopen()
    assert made.waits() == []


@pytest.mark.parametrize("problem", [PortProblem("belt", PortFault.ABSENT, "gone"), ValueError("odd")])
def test_a_belt_that_opens_late_or_never_is_reported_with_the_reason(
    monkeypatch: pytest.MonkeyPatch, problem: Exception
) -> None:
    made = Stepped(monkeypatch)
    made.opened = [problem]

    assert made.belt._open_first() is False
    assert made.notices.wait_for(BeltNotice.MISSING)
    assert made.notices.reason == ("gone" if isinstance(problem, PortProblem) else "odd")
