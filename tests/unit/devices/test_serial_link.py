"""The link on a real device path: a pseudo-terminal with a simulated board behind it, in real time.

Few tests, because each takes a second; decisions are tested in virtual time. Nothing here measures how fast
the machine is: limits are generous, and a hang is a failure.
"""

from __future__ import annotations

import termios
import threading
from collections.abc import Callable, Iterator

import pytest

import devices.serial_ports
from devices.board_reset import Pause
from devices.board_simulator.board import SimulatedBoard
from devices.ports.robot import LinkNotice, RobotProblem, StoppedBy
from devices.serial_ports import SerialPort
from devices.serial_robot.config import RobotConfig
from devices.serial_robot.link import SerialLink, open_board_port
from devices.serial_robot.robot import SerialRobot
from devices.wire.frames import BAUD, PING, STOP, MotorDrive, head_frame
from devices.wire.link_state import LinkConfig, LinkState
from tests.board_on_pty import PtyBoard
from tests.timeouts import TIMEOUT

FAR = 1e9
HALF_A_FRAME = bytes.fromhex("aabb3228")
"""A header that announces fifty bytes."""

SLOW_MACHINE = LinkConfig(silence=10.0, lease=5.0, runaway=10.0, reopen=0.1)
"""No loss, expired drive or reset because the machine is busy."""


def started() -> SimulatedBoard:
    """A board whose sketch started nine tenths of a second ago, so it asks for its configuration soon."""
    return SimulatedBoard(boot_loader=-0.9)


@pytest.fixture(autouse=True)
def _loops(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(devices.serial_ports, "OTHER_SCHEMES", ("loop",))


@pytest.fixture
def pty_board() -> Iterator[PtyBoard]:
    with PtyBoard(started()) as it:
        yield it


class Notices:
    """The notices of a link, to be waited for."""

    def __init__(self) -> None:
        self.received: list[LinkNotice] = []
        self._more = threading.Condition()

    def __call__(self, notice: LinkNotice, reason: str) -> None:
        with self._more:
            self.received.append(notice)
            self._more.notify_all()

    def wait_for(self, *wanted: LinkNotice) -> bool:
        """Wait for one of them."""
        with self._more:
            return self._more.wait_for(lambda: not {*wanted}.isdisjoint(self.received), TIMEOUT)


class RealPace:
    def __init__(self) -> None:
        self._never = threading.Event()

    def sleep(self, seconds: float) -> bool:
        return not self._never.wait(seconds)


def until(is_so: Callable[[], bool]) -> bool:
    """Wait for it. False if it doesn't become true."""
    never = threading.Event()
    return any(is_so() or never.wait(0.01) for _ in range(round(TIMEOUT / 0.01)))


def has_driven(pty_board: PtyBoard) -> bool:
    """Wait until its wheels have turned; a drive may be over again by then."""
    return until(lambda: pty_board.board.wheels.right != 0.0)


def can_drive(link: SerialLink, pty_board: PtyBoard) -> bool:
    """Drive until its wheels have turned. A drive may end before a busy machine has sent it."""

    def has_turned() -> bool:
        link.drive(link.permit(), MotorDrive.FORWARD, FAR)
        return pty_board.board.wheels.right != 0.0

    return until(has_turned)


@pytest.fixture
def link(pty_board: PtyBoard) -> Iterator[SerialLink]:
    it = SerialLink(pty_board.path)
    it.connect()
    yield it
    it.close()


def test_a_robot_on_a_port_walks_a_step(pty_board: PtyBoard) -> None:
    robot = SerialRobot(SerialLink(pty_board.path, SLOW_MACHINE), RobotConfig(stall=10.0), pace=RealPace())
    robot.connect()

    moved = robot.forward(1)
    robot.close()

    assert (moved.walked, moved.stopped_by) == (1, None)
    assert moved.pose.y > 0.9  # a busy machine stops the wheels late
    assert until(lambda: not pty_board.board.is_driving)


def test_open_a_second_program_can_not_have_the_port(pty_board: PtyBoard, link: SerialLink) -> None:
    with pytest.raises(RobotProblem) as caught:
        SerialLink(pty_board.path).connect()

    assert (caught.value.code, caught.value.values["port"]) == ("port-busy", pty_board.path)


def test_the_problem_of_a_missing_port_names_it() -> None:
    with pytest.raises(RobotProblem) as caught:
        SerialLink("/dev/no-such-robot").connect()

    assert (caught.value.code, caught.value.values["port"]) == ("no-port", "/dev/no-such-robot")


def test_a_port_without_an_answer_is_closed_again() -> None:
    """A loop sends back the bytes that it gets, which are no frames of a board."""
    link = SerialLink("loop://", LinkConfig(first_answer=0.2))
    with pytest.raises(RobotProblem) as caught:
        link.connect()

    assert (caught.value.code, link.state) == ("no-answer", LinkState.CLOSED)


@pytest.mark.parametrize("has_begun", [False, True])
def test_connecting_that_is_interrupted_as_its_thread_begins_can_be_closed(
    pty_board: PtyBoard, monkeypatch: pytest.MonkeyPatch, has_begun: bool
) -> None:
    """A signal's handler may raise at any moment of ``Thread.start``."""
    begin = threading.Thread.start

    def interrupted(thread: threading.Thread) -> None:
        if not thread.name.startswith("link "):
            begin(thread)
            return
        if has_begun:
            begin(thread)
        raise KeyboardInterrupt

    link = SerialLink(pty_board.path, SLOW_MACHINE)
    with monkeypatch.context() as patched:
        patched.setattr(threading.Thread, "start", interrupted)
        with pytest.raises(KeyboardInterrupt):
            link.connect()

    link.close()
    link.close()

    assert not [each for each in threading.enumerate() if each.name == f"link {link.name}"]
    open_board_port(link.name).close()


@pytest.mark.parametrize("moment", ["before", "meanwhile"])
def test_connecting_can_be_given_up_and_tried_again(pty_board: PtyBoard, moment: str) -> None:
    """A loop never answers as a board does: otherwise connecting would take a thousand seconds."""
    link = SerialLink("loop://", LinkConfig(first_answer=1000.0, silence=10.0))
    for _ in range(2):
        if moment == "before":
            link.give_up()
        else:
            threading.Timer(0.1, link.give_up).start()
        with pytest.raises(RobotProblem) as caught:
            link.connect()

        assert (caught.value.code, link.state) == ("given-up", LinkState.CLOSED)
    link.name = pty_board.path
    link.connect()
    assert link.state is LinkState.STREAMING
    link.close()


@pytest.mark.parametrize("where", ["opening", "answer"])
def test_slow_connecting_is_reported_once_in_the_thread_that_connects(where: str) -> None:
    """The listener gives it up: otherwise connecting would take a thousand seconds."""
    reported, may_open = list[threading.Thread](), threading.Event()

    def on_slow() -> None:
        reported.append(threading.current_thread())
        link.give_up()

    def open_slowly(address: str) -> SerialPort:
        assert where == "answer" or may_open.wait(TIMEOUT)
        return open_board_port(address)

    link = SerialLink("loop://", LinkConfig(first_answer=1000.0), open_port=open_slowly, on_slow=on_slow)
    with pytest.raises(RobotProblem):
        link.connect()

    may_open.set()
    assert reported == [threading.current_thread()]


class SlowPort(SerialPort):
    """Opens when a test allows it, as a network address does after some seconds."""

    def __init__(self, address: str, may_open: threading.Event) -> None:
        assert may_open.wait(TIMEOUT)
        super().__init__(address, BAUD)
        self.last = b""
        self.is_closed = threading.Event()

    def write(self, data: bytes) -> None:
        self.last = data

    def close(self) -> None:
        super().close()
        self.is_closed.set()


def test_a_port_that_opens_after_it_was_given_up_gets_a_stop_and_is_closed() -> None:
    may_open, opened = threading.Event(), list[SlowPort]()

    def open_slowly(address: str) -> SlowPort:
        opened.append(SlowPort(address, may_open))
        return opened[-1]

    link = SerialLink("loop://", open_port=open_slowly)
    threading.Timer(0.1, link.give_up).start()
    with pytest.raises(RobotProblem) as caught:
        link.connect()

    assert (caught.value.code, opened) == ("given-up", [])
    may_open.set()
    assert until(lambda: bool(opened))
    assert opened[0].is_closed.wait(TIMEOUT)
    assert opened[0].last == STOP


def test_unplug_is_reported_and_the_port_is_found_again_where_its_name_leads(pty_board: PtyBoard) -> None:
    notices = Notices()
    link = SerialLink(pty_board.path, SLOW_MACHINE, notices)
    link.connect()
    link.drive(link.permit(), MotorDrive.FORWARD, FAR)
    permit = link.permit()

    pty_board.unplug()
    assert notices.wait_for(LinkNotice.LOST)
    assert link.drive(permit, MotorDrive.FORWARD, FAR) is False
    pty_board.plug()

    assert notices.wait_for(LinkNotice.RESTORED)
    assert notices.received == [LinkNotice.CONNECTED, LinkNotice.LOST, LinkNotice.RESTORED]
    assert not pty_board.board.is_driving
    link.close()


class FailsOnce(SerialPort):
    """A port whose driver raises an unexpected error when a test sets one."""

    fault: Exception | None = None

    def __init__(self, address: str) -> None:
        super().__init__(address, BAUD)

    def read(self) -> bytes:
        if fault := self.fault:
            FailsOnce.fault = None
            raise fault
        return super().read()


@pytest.mark.parametrize("fault", [termios.error(5, "gone"), KeyError("a driver")], ids=["terminal", "any"])
def test_any_error_of_the_port_loses_the_link_which_is_found_again(
    pty_board: PtyBoard, fault: Exception
) -> None:
    notices = Notices()
    link = SerialLink(pty_board.path, SLOW_MACHINE, notices, open_port=FailsOnce)
    link.connect()
    FailsOnce.fault = fault

    assert notices.wait_for(LinkNotice.LOST)
    assert notices.wait_for(LinkNotice.RESTORED, LinkNotice.RESTARTED)
    link.close()


def test_a_walk_ends_when_the_robot_is_unplugged(pty_board: PtyBoard) -> None:
    robot = SerialRobot(SerialLink(pty_board.path, SLOW_MACHINE), RobotConfig(stall=10.0), pace=RealPace())
    robot.connect()
    threading.Timer(0.3, pty_board.unplug).start()

    assert robot.forward(100).stopped_by is StoppedBy.LINK
    robot.close()


def test_a_listener_that_fails_does_not_break_the_link(pty_board: PtyBoard) -> None:
    def fail(notice: LinkNotice, reason: str) -> None:
        raise KeyError("a listener's own mistake")

    link = SerialLink(pty_board.path, None, fail)
    link.connect()

    assert can_drive(link, pty_board)
    link.close()
    assert until(lambda: not pty_board.board.is_driving)


def test_a_listener_that_hangs_does_not_hold_up_the_link(pty_board: PtyBoard) -> None:
    """As one that prints on a terminal that takes no output: the robot is stopped all the same."""
    may_return = threading.Event()
    link = SerialLink(pty_board.path, None, lambda notice, reason: may_return.wait() and None)
    link.connect()
    assert can_drive(link, pty_board)

    assert until(lambda: not pty_board.board.is_driving)  # the drive was not renewed
    link.close()
    assert until(lambda: link.state is LinkState.CLOSED)
    may_return.set()


def test_a_stop_from_any_thread_reaches_the_wire(pty_board: PtyBoard, link: SerialLink) -> None:
    assert can_drive(link, pty_board)
    threading.Thread(target=link.stop).start()

    assert until(lambda: not pty_board.board.is_driving)


class PausingPort(SerialPort):
    """A port that pauses after a certain frame. ``calls``: each written frame, and None for a read."""

    def __init__(self, address: str) -> None:
        super().__init__(address, BAUD)
        self.calls: list[bytes | None] = []
        self.pauses_after: bytes | None = None
        self.is_paused, self.may_continue = threading.Event(), threading.Event()

    def read(self) -> bytes:
        self.calls.append(None)
        return super().read()

    def write(self, data: bytes) -> None:
        super().write(data)
        self.calls.append(data)
        if data == self.pauses_after:
            self.is_paused.set()
            assert self.may_continue.wait(TIMEOUT)


def test_a_stop_during_a_burst_of_commands_is_the_next_frame_before_anything_is_read(
    pty_board: PtyBoard,
) -> None:
    ports: list[PausingPort] = []

    def open_port(address: str) -> PausingPort:
        ports.append(PausingPort(address))
        return ports[-1]

    link = SerialLink(pty_board.path, SLOW_MACHINE, open_port=open_port)
    link.connect()
    port = ports[0]
    port.pauses_after = head_frame(10)
    link.put(head_frame(10))
    assert port.is_paused.wait(TIMEOUT)
    for frame in (head_frame(20), PING):
        link.put(frame)
    link.stop()
    before = len(port.calls)
    port.may_continue.set()

    assert until(lambda: STOP in port.calls[before:])
    assert port.calls[before] == STOP
    link.close()


def test_a_board_that_ignores_stops_is_reset_through_its_port(pty_board: PtyBoard) -> None:
    pulled = list[SerialPort | None]()

    class Reset:
        def pull(self, port: SerialPort | None, pause: Pause) -> bool:
            pulled.append(port)
            pty_board.board.reset()
            return True

    class Deaf(SerialPort):
        is_deaf = False

        def write(self, data: bytes) -> None:
            if not self.is_deaf:
                super().write(data)

    port = Deaf(pty_board.path, BAUD)
    link = SerialLink(pty_board.path, open_port=lambda _: port, reset=Reset())
    link.connect()
    assert can_drive(link, pty_board)
    port.is_deaf = True
    link.stop()

    assert until(lambda: bool(pulled))
    assert pulled[0] is port
    port.is_deaf = False
    link.close()
