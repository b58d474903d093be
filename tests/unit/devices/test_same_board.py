"""A board that is plugged in again is found under another name, too, and no other board is taken for it."""

from __future__ import annotations

import errno
import os
import threading
from collections.abc import Iterator

import pytest

from devices.board_simulator.board import SimulatedBoard
from devices.ports.robot import LinkNotice
from devices.serial_ports import PortFault, PortProblem, SameBoard
from devices.serial_robot.link import SerialLink, open_board_port
from devices.wire.link_state import LinkConfig
from tests.board_on_pty import PtyBoard
from tests.timeouts import TIMEOUT
from tests.unit.devices.test_port_listing import Plugged

MEGA = (0x2341, 0x0042)
CLONE = (0x1A86, 0x7523)


def reopened(before: list[Plugged], after: list[Plugged], port: str = "/dev/ttyACM0") -> str:
    """What is opened once ``after`` is plugged in, by one that opened ``port`` while ``before`` was."""
    plugged = [before, after]
    same = SameBoard(str, lambda: plugged[0])
    assert same(port) == port
    plugged.pop(0)
    return same(port)


ROBOT = Plugged("/dev/ttyACM0", *MEGA, "7543", "1-1")
BELT = Plugged("/dev/ttyACM1", *MEGA, "9999", "1-2")


def test_a_board_is_recognised_by_its_serial_number_in_any_socket() -> None:
    moved = Plugged("/dev/ttyACM2", *MEGA, "7543", "1-7")
    assert reopened([ROBOT, BELT], [BELT, moved]) == "/dev/ttyACM2"


def test_a_board_without_a_serial_number_is_recognised_by_its_socket() -> None:
    before = Plugged("/dev/ttyUSB0", *CLONE, None, "1-1")
    after = Plugged("/dev/ttyUSB3", *CLONE, None, "1-1")
    twin = Plugged("/dev/ttyUSB1", *CLONE, None, "1-2")
    assert reopened([before, twin], [twin, after], "/dev/ttyUSB0") == "/dev/ttyUSB3"


@pytest.mark.parametrize(
    "after",
    [
        [],
        [BELT],
        [Plugged("/dev/ttyACM1", *MEGA, None, "1-1")],
        [Plugged("/dev/ttyACM1", *CLONE, "7543", "1-1")],
        [Plugged("/dev/ttyACM1", *MEGA, "7543", "1-1"), Plugged("/dev/ttyACM2", *MEGA, "7543", "1-2")],
    ],
    ids=["nothing", "another number", "no number", "another make", "two alike"],
)
def test_no_other_board_is_taken_for_it(after: list[Plugged]) -> None:
    assert reopened([ROBOT], after) == "/dev/ttyACM0"


def test_another_board_that_has_the_name_now_is_not_opened() -> None:
    with pytest.raises(PortProblem) as caught:
        reopened([ROBOT, BELT], [Plugged("/dev/ttyACM0", *MEGA, "9999", "1-2")])

    assert caught.value.fault is PortFault.ABSENT
    assert caught.value.reason == os.strerror(errno.ENOENT)


@pytest.mark.parametrize("port", ["socket://there:2000", "/dev/ttyS0"], ids=["network", "pins"])
def test_a_port_that_is_not_on_usb_is_reopened_by_its_name(port: str) -> None:
    assert reopened([ROBOT, Plugged("/dev/ttyS0")], [BELT], port) == port


def test_a_failing_list_of_ports_changes_nothing() -> None:
    def fails() -> list[Plugged]:
        raise OSError

    same = SameBoard(str, fails)
    assert [same("/dev/ttyACM0") for _ in range(2)] == ["/dev/ttyACM0"] * 2


@pytest.fixture
def pty_board() -> Iterator[PtyBoard]:
    with PtyBoard(SimulatedBoard(boot_loader=-0.9)) as it:
        yield it


def test_a_link_is_restored_under_the_new_name_of_its_device(pty_board: PtyBoard) -> None:
    restored = threading.Event()

    def listen(notice: LinkNotice, _reason: str) -> None:
        if notice is LinkNotice.RESTORED:
            restored.set()

    def plugged() -> list[Plugged]:
        device = os.path.realpath(pty_board.path)
        return [Plugged(device, *MEGA, "7543")] if device != pty_board.path else []

    device = os.path.realpath(pty_board.path)
    link = SerialLink(device, LinkConfig(reopen=0.1), listen, open_port=SameBoard(open_board_port, plugged))
    link.connect()
    pty_board.unplug()
    taken = name_taken_by_another(device)
    pty_board.plug()

    assert restored.wait(TIMEOUT)
    assert os.path.realpath(pty_board.path) != device
    link.close()
    for descriptor in taken:
        os.close(descriptor)


def name_taken_by_another(device: str) -> list[int]:
    """Opens terminals until one has that name, or as many as other processes may have freed meanwhile."""
    taken = list[int]()
    for _ in range(32):
        taken += os.openpty()
        if os.ttyname(taken[-1]) == device:
            break
    return taken
