"""The belt on its line: off at the end, told once when it is lost, never in anybody's way."""

from __future__ import annotations

import os
import threading
import tty
from collections import deque
from collections.abc import Callable, Iterator
from time import monotonic

import pytest

from devices.belt.board import BeltBoard
from devices.belt.frame import MOTORS, OFF, RESYNC, frame
from devices.belt.line import BeltNews, Line, SerialBelt
from devices.serial_port import PortFault, PortProblem
from tests.patience import PATIENCE


@pytest.fixture(autouse=True)
def _is_taken_for_a_belt(monkeypatch: pytest.MonkeyPatch) -> None:
    """These lines answer nothing, and a busy machine takes its time."""
    monkeypatch.setattr("devices.belt.doubt.ASKED_AGAIN", 1e9)


FRONT = (0, 0, 0, 3, 0, 0, 0) * 2
ANSWER = 0.008
"""Seconds that a board takes to complain, with the way there and back at 9600 baud."""


class FakeLine:
    """A line that can be pulled out. ``written`` is what came through."""

    def __init__(self) -> None:
        self.written: list[bytes] = []
        self.answers: list[bytes] = []
        self.fault: Exception | None = None
        self.is_closed = False
        self._changed = threading.Condition()

    def write(self, data: bytes) -> int:
        if self.fault:
            raise self.fault
        with self._changed:
            self.written.append(data)
            self._changed.notify_all()
        return len(data)

    def read(self, size: int = 1) -> bytes:
        if self.fault:
            raise self.fault
        return self.answers.pop(0) if self.answers else b""

    def close(self) -> None:
        with self._changed:
            self.is_closed = True
            self._changed.notify_all()

    def wait_for(self, is_met: Callable[[], bool]) -> bool:
        with self._changed:
            return self._changed.wait_for(is_met, PATIENCE)


class CloggedLine(FakeLine):
    """A line whose bytes don't leave the system. ``looks``: how often the belt saw that."""

    clogged = 36
    looks = 0

    @property
    def out_waiting(self) -> int:
        with self._changed:
            self.looks += 1
            self._changed.notify_all()
        return self.clogged


class SlowLine(FakeLine):
    """A line at its true pace: the board answers some time after the bytes were written."""

    def __init__(self) -> None:
        super().__init__()
        self._board = BeltBoard()
        self._coming: deque[tuple[float, bytes]] = deque()

    def write(self, data: bytes) -> int:
        if answer := self._board.feed(data, monotonic()):
            self._coming.append((monotonic() + ANSWER, answer))
        return super().write(data)

    def read(self, size: int = 1) -> bytes:
        is_there = bool(self._coming) and monotonic() >= self._coming[0][0]
        return self._coming.popleft()[1] if is_there else b""

    def frames(self) -> int:
        return self.written.count(frame(FRONT))


class News:
    """What was told, and a way to wait for it."""

    def __init__(self) -> None:
        self.told: list[BeltNews] = []
        self.reason = ""
        self._changed = threading.Condition()

    def __call__(self, news: BeltNews, reason: str) -> None:
        with self._changed:
            self.reason = reason
            self.told.append(news)
            self._changed.notify_all()

    def wait_for(self, *wanted: BeltNews) -> bool:
        with self._changed:
            return self._changed.wait_for(lambda: self.told == list(wanted), PATIENCE)


@pytest.fixture
def line() -> FakeLine:
    return FakeLine()


@pytest.fixture
def news() -> News:
    return News()


@pytest.fixture
def belt(line: FakeLine, news: News) -> Iterator[SerialBelt]:
    made = SerialBelt("nowhere", news, lambda _: line)
    yield made
    made.close()


def test_levels_reach_the_line_and_closing_turns_them_off(belt: SerialBelt, line: FakeLine) -> None:
    belt.show(FRONT)
    assert line.wait_for(lambda: frame(FRONT) in line.written)
    belt.close()

    assert line.written[-1] == frame(OFF)
    assert line.is_closed


def test_the_last_pulse_is_felt_before_the_line_is_closed(belt: SerialBelt, line: FakeLine) -> None:
    belt.show(FRONT)
    belt.show(OFF)
    belt.close()

    assert frame(FRONT) in line.written
    assert line.written[-1] == frame(OFF)


@pytest.mark.parametrize("fault", [OSError(5, "gone"), ValueError("closed")], ids=["pulled", "closed"])
def test_a_lost_belt_is_told_once_and_once_when_it_is_back(
    line: FakeLine, news: News, fault: Exception, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("devices.belt.line.RETRY", 0.001)
    lines, is_back = [line], threading.Event()

    def opened(port: str) -> Line:
        if len(lines) > 1 and not is_back.is_set():
            raise PortProblem(port, PortFault.ABSENT, "not there")
        lines.append(FakeLine())
        return lines[-2]

    belt = SerialBelt("nowhere", news, opened)
    line.fault = fault
    belt.show(FRONT)
    assert news.wait_for(BeltNews.LOST)
    is_back.set()
    assert news.wait_for(BeltNews.LOST, BeltNews.RESTORED)

    second = lines[1]
    assert second.wait_for(lambda: frame(FRONT) in second.written)
    assert second.written[0] == b"Z!"
    belt.close()


@pytest.mark.parametrize("is_idle", [False, True])
def test_a_board_that_answers_late_gets_one_resync_and_then_frames(news: News, is_idle: bool) -> None:
    line = SlowLine()
    belt = SerialBelt("nowhere", news, lambda _: line)
    if is_idle:
        assert line.wait_for(lambda: line.written == [RESYNC])
    belt.show(FRONT)

    assert line.wait_for(lambda: line.frames() >= 3 or line.written.count(RESYNC) >= 3)
    belt.close()
    assert line.written.count(RESYNC) == 1


def test_an_idle_belt_that_is_unplugged_is_told_and_found_again(
    line: FakeLine, news: News, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Nobody shows anything meanwhile."""
    monkeypatch.setattr("devices.belt.line.RETRY", 0.001)
    lines = [FakeLine(), line]
    belt = SerialBelt("nowhere", news, lambda _: lines.pop())
    assert line.wait_for(lambda: line.written == [RESYNC])
    line.fault = OSError(5, "gone")

    assert news.wait_for(BeltNews.LOST, BeltNews.RESTORED)
    assert line.is_closed
    belt.close()


def test_a_listener_that_hangs_does_not_hold_the_belt(
    line: FakeLine, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("devices.belt.line.RETRY", 0.001)
    is_read, second = threading.Event(), FakeLine()
    lines = [second, line]
    belt = SerialBelt("nowhere", lambda *news: is_read.wait() and None, lambda _: lines.pop())
    line.fault = OSError(5, "gone")
    belt.show(FRONT)

    assert second.wait_for(lambda: frame(FRONT) in second.written)
    belt.close()
    assert second.written[-1] == frame(OFF)
    is_read.set()


def test_a_belt_that_showed_nothing_is_turned_off_all_the_same(belt: SerialBelt, line: FakeLine) -> None:
    """Another program may have left its motors on."""
    belt.close()

    assert line.written[-1] == frame(OFF)


def test_while_an_earlier_frame_waits_in_the_system_only_the_newest_is_kept(news: News) -> None:
    line = CloggedLine()
    belt = SerialBelt("nowhere", news, lambda _: line)
    for levels in [(1,) * MOTORS, (2,) * MOTORS, (3,) * MOTORS]:
        line.looks = 0
        belt.show(levels)
        assert line.wait_for(lambda: line.looks >= 3)
    assert line.written == []

    line.clogged = 0
    assert line.wait_for(lambda: len(line.written) >= 2)
    belt.close()
    assert line.written[:2] == [RESYNC, frame((3,) * MOTORS)]


def test_a_belt_that_is_not_there_is_a_problem_with_the_systems_reason() -> None:
    with pytest.raises(PortProblem) as caught:
        SerialBelt("/dev/there-is-no-such-belt", News())

    assert caught.value.fault is PortFault.ABSENT
    assert caught.value.reason == "No such file or directory"


SLOW = "socket://there.is.no.answer:7000"


class SlowNetwork:
    """Opening lasts until it is answered."""

    def __init__(self, line: Line | None) -> None:
        self._line = line
        self.answer = threading.Event()

    def __call__(self, port: str) -> Line:
        assert self.answer.wait(PATIENCE)
        if self._line is None:
            raise PortProblem(port, PortFault.UNUSABLE, "timed out")
        return self._line


def test_nobody_waits_for_a_belt_at_an_address_and_that_it_is_there_is_told(
    line: FakeLine, news: News
) -> None:
    network = SlowNetwork(line)
    belt = SerialBelt(SLOW, news, network)
    belt.show(FRONT)
    assert news.told == []
    network.answer.set()

    assert news.wait_for(BeltNews.FOUND)
    assert line.wait_for(lambda: frame(FRONT) in line.written)
    belt.close()
    assert line.written[-1] == frame(OFF)


def test_that_no_belt_is_at_an_address_is_told_once_with_the_reason(news: News) -> None:
    network = SlowNetwork(None)
    belt = SerialBelt(SLOW, news, network)
    belt.show(FRONT)
    network.answer.set()

    assert news.wait_for(BeltNews.MISSING)
    assert news.reason == "timed out"
    belt.close()
    assert news.told == [BeltNews.MISSING]


def test_a_belt_that_opens_behind_the_end_is_made_dark_and_let_go_of_in_silence(
    line: FakeLine, news: News
) -> None:
    network = SlowNetwork(line)
    belt = SerialBelt(SLOW, news, network)
    belt.show(FRONT)
    belt.close()
    network.answer.set()

    assert line.wait_for(lambda: line.is_closed)
    assert line.written[-1] == frame(OFF)
    assert news.told == []


def test_the_real_line_carries_frames_to_a_board(news: News) -> None:
    """Over a pseudo terminal, with the system's own buffers between."""
    ours, theirs = os.openpty()
    tty.setraw(ours)
    belt = SerialBelt(os.ttyname(theirs), news)
    belt.show((3,) * MOTORS)
    board, seconds = BeltBoard(), 0.0
    while board.frames < 3:
        os.write(ours, board.feed(os.read(ours, 100), seconds))
    assert board.motors(seconds) == ("A",) * MOTORS
    belt.close()
    while set(board.motors(seconds)) != {"P"}:
        board.feed(os.read(ours, 100), seconds)

    os.close(ours)
    os.close(theirs)
    assert news.told == []


def test_a_line_on_which_no_belt_answers_is_told(monkeypatch: pytest.MonkeyPatch, news: News) -> None:
    monkeypatch.setattr("devices.belt.doubt.ASKED_AGAIN", 0.0)
    monkeypatch.setattr("devices.belt.doubt.GIVEN_UP", 0.0)
    belt = SerialBelt("belt", news, lambda _: FakeLine())
    try:
        assert news.wait_for(BeltNews.UNANSWERED)
    finally:
        belt.close()
