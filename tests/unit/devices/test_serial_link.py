"""The line on a real device path: a pseudo-terminal with a simulated board behind it, in real time.

Few tests, for each takes a second; what is decided is tested in virtual time. Nothing here measures how fast
this machine is: limits are generous, and a hang is a failure.
"""

from __future__ import annotations

import termios
import threading
from collections.abc import Callable, Iterator

import pytest

from devices.firmware_double.board import SimulatedBoard
from devices.firmware_double.on_pty import DoubleOnPty
from devices.ports.robot import LinkNews, RobotProblem, StoppedBy
from devices.reset_line import DTR_PULSE
from devices.serial_link import SerialLink
from devices.serial_link.port import OpenPort
from devices.serial_robot.config import RobotConfig
from devices.serial_robot.robot import SerialRobot
from devices.wire.commands import PING, STOP, Drive, head
from devices.wire.link_config import LinkConfig
from devices.wire.link_state import LinkState
from tests.patience import PATIENCE

FAR = 1e9
HALF_A_FRAME = bytes.fromhex("aabb3228")
"""A header that announces fifty bytes."""


def started() -> SimulatedBoard:
    """A board whose sketch began nine tenths of a second ago, so that it asks for its configuration soon."""
    return SimulatedBoard(boot_loader=-0.9)


@pytest.fixture
def double() -> Iterator[DoubleOnPty]:
    with DoubleOnPty(started()) as it:
        yield it


class News:
    """What a link told, to be waited for."""

    def __init__(self) -> None:
        self.told: list[LinkNews] = []
        self._more = threading.Condition()

    def __call__(self, news: LinkNews, reason: str) -> None:
        with self._more:
            self.told.append(news)
            self._more.notify_all()

    def wait_for(self, news: LinkNews) -> bool:
        with self._more:
            return self._more.wait_for(lambda: news in self.told, PATIENCE)


class RealPace:
    def __init__(self) -> None:
        self._never = threading.Event()

    def sleep(self, seconds: float) -> bool:
        return not self._never.wait(seconds)


def until(happened: Callable[[], bool]) -> bool:
    """Wait for it. False if it doesn't happen."""
    never = threading.Event()
    return any(happened() or never.wait(0.01) for _ in range(round(PATIENCE / 0.01)))


@pytest.fixture
def link(double: DoubleOnPty) -> Iterator[SerialLink]:
    it = SerialLink(double.path)
    it.connect()
    yield it
    it.close()


def test_a_robot_on_a_port_walks_a_step(double: DoubleOnPty) -> None:
    patient = LinkConfig(silence=10.0, lease=5.0, runaway=10.0)
    robot = SerialRobot(SerialLink(double.path, patient), RobotConfig(stall=10.0), pace=RealPace())
    robot.connect()

    moved = robot.forward(1)
    robot.close()

    assert (moved.walked, moved.stopped_by) == (1, None)
    assert moved.pose.y == pytest.approx(1, abs=0.3)
    assert until(lambda: not double.board.is_driving)


def test_open_a_second_program_cannot_have_the_port(double: DoubleOnPty, link: SerialLink) -> None:
    with pytest.raises(RobotProblem) as told:
        SerialLink(double.path).connect()

    assert (told.value.code, told.value.values["port"]) == ("port-busy", double.path)


def test_a_port_that_is_not_there_is_told_by_its_name() -> None:
    with pytest.raises(RobotProblem) as told:
        SerialLink("/dev/no-such-robot").connect()

    assert (told.value.code, told.value.values["port"]) == ("no-port", "/dev/no-such-robot")


def test_a_port_where_nobody_answers_is_let_go_of() -> None:
    """A loop answers with what it was told, which are no frames of a board."""
    link = SerialLink("loop://", LinkConfig(first_answer=0.2))
    with pytest.raises(RobotProblem) as told:
        link.connect()

    assert (told.value.code, link.state) == ("no-answer", LinkState.CLOSED)


@pytest.mark.parametrize("moment", ["before", "meanwhile"])
def test_connecting_can_be_given_up_and_tried_again(double: DoubleOnPty, moment: str) -> None:
    """A loop never answers as a board does: without that it would take a thousand seconds."""
    link = SerialLink("loop://", LinkConfig(first_answer=1000.0))
    for _ in range(2):
        if moment == "before":
            link.give_up()
        else:
            threading.Timer(0.1, link.give_up).start()
        with pytest.raises(RobotProblem) as told:
            link.connect()

        assert (told.value.code, link.state) == ("given-up", LinkState.CLOSED)
    link.name = double.path
    link.connect()
    assert link.state is LinkState.STREAMING
    link.close()


@pytest.mark.parametrize("where", ["opening", "answer"])
def test_connecting_that_takes_longer_than_a_second_is_told_once_where_it_is_waited(where: str) -> None:
    """Whoever is told gives it up: without that it would take a thousand seconds."""
    told, may_open = list[threading.Thread](), threading.Event()

    def tell() -> None:
        told.append(threading.current_thread())
        link.give_up()

    def open_slowly(url: str) -> OpenPort:
        assert where == "answer" or may_open.wait(PATIENCE)
        return OpenPort(url)

    link = SerialLink("loop://", LinkConfig(first_answer=1000.0), open_port=open_slowly, on_slow=tell)
    with pytest.raises(RobotProblem):
        link.connect()

    may_open.set()
    assert told == [threading.current_thread()]


class SlowPort(OpenPort):
    """One that opens when it is let, as a network's does after some seconds."""

    def __init__(self, url: str, may_open: threading.Event) -> None:
        assert may_open.wait(PATIENCE)
        super().__init__(url)
        self.last = b""
        self.is_closed = threading.Event()

    def write(self, data: bytes) -> None:
        self.last = data

    def close(self) -> None:
        super().close()
        self.is_closed.set()


def test_a_port_that_takes_long_to_open_can_be_given_up_and_is_stopped_once_it_is_open() -> None:
    may_open, opened = threading.Event(), list[SlowPort]()

    def open_slowly(url: str) -> SlowPort:
        opened.append(SlowPort(url, may_open))
        return opened[-1]

    link = SerialLink("loop://", open_port=open_slowly)
    threading.Timer(0.1, link.give_up).start()
    with pytest.raises(RobotProblem) as told:
        link.connect()

    assert (told.value.code, opened) == ("given-up", [])
    may_open.set()
    assert until(lambda: bool(opened))
    assert opened[0].is_closed.wait(PATIENCE)
    assert opened[0].last == STOP


def test_unplug_is_told_and_found_again_where_its_name_leads(double: DoubleOnPty) -> None:
    news = News()
    link = SerialLink(double.path, LinkConfig(reopen=0.1), news)
    link.connect()
    link.drive(link.permit(), Drive.FORWARD, FAR)
    permit = link.permit()

    double.unplug()
    assert news.wait_for(LinkNews.LOST)
    assert link.drive(permit, Drive.FORWARD, FAR) is False
    double.plug()

    assert news.wait_for(LinkNews.RESTORED)
    assert news.told == [LinkNews.CONNECTED, LinkNews.LOST, LinkNews.RESTORED]
    assert not double.board.is_driving
    link.close()


class FailsOnce(OpenPort):
    """A port whose driver raises what nobody expects, when it is told to."""

    fault: Exception | None = None

    def read(self) -> bytes:
        if fault := self.fault:
            FailsOnce.fault = None
            raise fault
        return super().read()


@pytest.mark.parametrize("fault", [termios.error(5, "gone"), KeyError("a driver")], ids=["terminal", "any"])
def test_whatever_a_port_raises_the_line_is_lost_and_found_again(
    double: DoubleOnPty, fault: Exception
) -> None:
    news = News()
    link = SerialLink(double.path, LinkConfig(reopen=0.1), news, open_port=FailsOnce)
    link.connect()
    FailsOnce.fault = fault

    assert news.wait_for(LinkNews.LOST)
    assert news.wait_for(LinkNews.RESTORED) or news.wait_for(LinkNews.RESTARTED)
    link.close()


def test_a_walk_ends_when_the_robot_is_unplugged(double: DoubleOnPty) -> None:
    news = News()
    robot = SerialRobot(SerialLink(double.path, None, news), pace=RealPace())
    robot.connect()
    unplugging = threading.Timer(0.3, double.unplug)
    unplugging.start()

    assert robot.forward(100).stopped_by is StoppedBy.LINK
    robot.close()


def test_a_listener_that_fails_does_not_take_the_line_with_it(double: DoubleOnPty) -> None:
    def fail(news: LinkNews, reason: str) -> None:
        raise KeyError("a listener's own mistake")

    link = SerialLink(double.path, None, fail)
    link.connect()

    assert link.drive(link.permit(), Drive.FORWARD, FAR) is True
    assert until(lambda: double.board.is_driving)
    link.close()
    assert until(lambda: not double.board.is_driving)


def test_a_listener_that_hangs_does_not_hold_the_line(double: DoubleOnPty) -> None:
    """As one that prints on a terminal that takes nothing: the robot is stopped all the same."""
    is_read = threading.Event()
    link = SerialLink(double.path, None, lambda news, reason: is_read.wait() and None)
    link.connect()
    link.drive(link.permit(), Drive.FORWARD, FAR)
    assert until(lambda: double.board.is_driving)

    assert until(lambda: not double.board.is_driving)  # nobody renewed it
    link.close()
    assert link.state is LinkState.CLOSED
    is_read.set()


def test_a_stop_from_any_thread_reaches_the_wire(double: DoubleOnPty, link: SerialLink) -> None:
    link.drive(link.permit(), Drive.FORWARD, FAR)
    assert until(lambda: double.board.is_driving)
    threading.Thread(target=link.stop).start()

    assert until(lambda: not double.board.is_driving)


class HeldPort(OpenPort):
    """A port that can be held behind a certain frame. ``did``: what was written, and each reading."""

    def __init__(self, url: str) -> None:
        super().__init__(url)
        self.did: list[bytes | None] = []
        self.holds_behind: bytes | None = None
        self.is_held, self.goes_on = threading.Event(), threading.Event()

    def read(self) -> bytes:
        self.did.append(None)
        return super().read()

    def write(self, data: bytes) -> None:
        super().write(data)
        self.did.append(data)
        if data == self.holds_behind:
            self.is_held.set()
            assert self.goes_on.wait(PATIENCE)


def test_a_stop_in_the_midst_of_a_burst_of_commands_is_the_next_frame_before_anything_is_read(
    double: DoubleOnPty,
) -> None:
    ports: list[HeldPort] = []

    def open_port(url: str) -> HeldPort:
        ports.append(HeldPort(url))
        return ports[-1]

    link = SerialLink(double.path, open_port=open_port)
    link.connect()
    port = ports[0]
    port.holds_behind = head(10)
    link.put(head(10))
    assert port.is_held.wait(PATIENCE)
    for frame in (head(20), PING):
        link.put(frame)
    link.stop()
    before = len(port.did)
    port.goes_on.set()

    assert until(lambda: STOP in port.did[before:])
    assert port.did[before] == STOP
    link.close()


def test_dtr_a_port_without_that_line_tolerates_its_being_pulled(double: DoubleOnPty) -> None:
    port = OpenPort(double.path)
    port.pull_reset(lambda seconds: None)

    assert port.read() is not None
    port.close()


def test_dtr_falls_and_rises_again_with_a_pause_after_each(monkeypatch: pytest.MonkeyPatch) -> None:
    seen: list[object] = []

    class Wire:
        def __setattr__(self, name: str, level: object) -> None:
            seen.append((name, level))

    monkeypatch.setattr("devices.serial_link.port.open_port", lambda *_: Wire())
    OpenPort("port").pull_reset(seen.append)

    assert seen == [("dtr", False), DTR_PULSE, ("dtr", True), DTR_PULSE]
