"""A board that is plugged in again is found under another name too, and no other is taken for it."""

from __future__ import annotations

import errno
import os
import threading
from collections.abc import Iterator

import pytest

from devices.firmware_double.board import SimulatedBoard
from devices.firmware_double.on_pty import DoubleOnPty
from devices.ports.robot import LinkNews
from devices.same_board import SameBoard
from devices.serial_link import SerialLink
from devices.serial_link.port import OpenPort
from devices.serial_port import PortFault, PortProblem
from devices.wire.link_config import LinkConfig
from tests.patience import PATIENCE
from tests.unit.devices.test_port_listing import Plugged

MEGA = (0x2341, 0x0042)
CLONE = (0x1A86, 0x7523)


class Port(OpenPort):
    """Opens nothing, and knows what it would have opened."""

    def __init__(self, url: str) -> None:
        self.url = url


def opened_again(before: list[Plugged], after: list[Plugged], port: str = "/dev/ttyACM0") -> str:
    """The robot is at the first of ``before``; what is opened once ``after`` is plugged in."""
    now = [before, after]
    same = SameBoard(Port, lambda: now[0])
    assert same(port).url == port
    now.pop(0)
    again = same(port)
    assert isinstance(again, Port)
    return again.url


ROBOT = Plugged("/dev/ttyACM0", *MEGA, "7543", "1-1")
BELT = Plugged("/dev/ttyACM1", *MEGA, "9999", "1-2")


def test_a_board_is_known_by_its_number_in_any_socket() -> None:
    moved = Plugged("/dev/ttyACM2", *MEGA, "7543", "1-7")
    assert opened_again([ROBOT, BELT], [BELT, moved]) == "/dev/ttyACM2"


def test_a_board_without_a_number_is_known_by_its_socket() -> None:
    before = Plugged("/dev/ttyUSB0", *CLONE, None, "1-1")
    after = Plugged("/dev/ttyUSB3", *CLONE, None, "1-1")
    twin = Plugged("/dev/ttyUSB1", *CLONE, None, "1-2")
    assert opened_again([before, twin], [twin, after], "/dev/ttyUSB0") == "/dev/ttyUSB3"


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
    assert opened_again([ROBOT], after) == "/dev/ttyACM0"


def test_another_board_that_has_the_name_now_is_not_opened() -> None:
    with pytest.raises(PortProblem) as told:
        opened_again([ROBOT, BELT], [Plugged("/dev/ttyACM0", *MEGA, "9999", "1-2")])

    assert told.value.fault is PortFault.ABSENT
    assert told.value.reason == os.strerror(errno.ENOENT)


@pytest.mark.parametrize("port", ["socket://there:2000", "/dev/ttyS0"], ids=["network", "pins"])
def test_what_hangs_on_no_usb_is_opened_as_it_was_named(port: str) -> None:
    assert opened_again([ROBOT, Plugged("/dev/ttyS0")], [BELT], port) == port


def test_a_list_that_cannot_be_read_changes_nothing() -> None:
    def fails() -> list[Plugged]:
        raise OSError

    same = SameBoard(Port, fails)
    assert [same("/dev/ttyACM0").url for _ in range(2)] == ["/dev/ttyACM0"] * 2  # type: ignore[attr-defined]


@pytest.fixture
def double() -> Iterator[DoubleOnPty]:
    with DoubleOnPty(SimulatedBoard(boot_loader=-0.9)) as it:
        yield it


def test_a_link_is_restored_under_the_new_name_of_its_device(double: DoubleOnPty) -> None:
    told, restored = list[LinkNews](), threading.Event()

    def hear(news: LinkNews, _reason: str) -> None:
        told.append(news)
        if news is LinkNews.RESTORED:
            restored.set()

    def plugged() -> list[Plugged]:
        device = os.path.realpath(double.path)
        return [Plugged(device, *MEGA, "7543")] if device != double.path else []

    device = os.path.realpath(double.path)
    link = SerialLink(device, LinkConfig(reopen=0.1), hear, open_port=SameBoard(OpenPort, plugged))
    link.connect()
    double.unplug()
    master, slave = os.openpty()  # somebody else takes the name
    double.plug()

    assert restored.wait(PATIENCE)
    assert os.path.realpath(double.path) != device
    link.close()
    os.close(master)
    os.close(slave)
