"""Ports are recognised by their USB numbers, and get names that stay."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import pytest

from devices.serial_ports import FoundPort, allow_only, list_ports, stable_name


@dataclass
class Plugged:
    device: str
    vid: int | None = None
    pid: int | None = None
    serial_number: str | None = None
    location: str | None = None


def test_boards_come_first_and_are_recognised_by_vendor_and_product(tmp_path: Path) -> None:
    plugged = [
        Plugged("/dev/ttyS0"),
        Plugged("/dev/ttyUSB0", 0x0403, 0x6001),
        Plugged("/dev/ttyACM1", 0x2341, 0x0010),
        Plugged("/dev/ttyACM0", 0x2341, 0x0042),
        Plugged("/dev/ttyACM2", 0x2341, 0x8036),
        Plugged("/dev/ttyACM3", 0x2342, 0x0042),
    ]

    found = list_ports(lambda: plugged, tmp_path / "none")
    assert [(each.device, each.is_board) for each in found] == [
        ("/dev/ttyACM0", True),
        ("/dev/ttyACM1", True),
        ("/dev/ttyACM2", False),
        ("/dev/ttyACM3", False),
        ("/dev/ttyS0", False),
        ("/dev/ttyUSB0", False),
    ]


def test_a_stable_name_has_the_make_and_serial_number(tmp_path: Path) -> None:
    device, link = tmp_path / "ttyACM0", tmp_path / "by-id" / "usb-Arduino_7543"
    device.touch()
    link.parent.mkdir()
    link.symlink_to("../ttyACM0")

    found = list_ports(lambda: [Plugged(str(device), 0x2341, 0x0042)], link.parent)
    assert found == (FoundPort(str(device), str(link), is_board=True),)


def test_a_port_that_was_named_by_hand_has_a_stable_name(tmp_path: Path) -> None:
    device, link = tmp_path / "ttyACM0", tmp_path / "by-id" / "usb-Arduino_7543"
    device.touch()
    link.parent.mkdir()
    link.symlink_to("../ttyACM0")
    beside = link.parent / "usb-Arduino_7543-again"
    beside.symlink_to("../ttyACM0")

    assert Path(stable_name(str(device), link.parent)).resolve() == device
    assert Path(stable_name(str(device), link.parent)).parent == link.parent
    assert stable_name(str(link), link.parent) == str(link)
    for unknown in ("/dev/null", "socket://there:2000", str(tmp_path / "gone")):
        assert stable_name(unknown, link.parent) == unknown
    assert stable_name(str(device), tmp_path / "none") == str(device)


def test_only_the_named_ports_are_listed(tmp_path: Path) -> None:
    plugged = [Plugged("/dev/ttyS0"), Plugged("/dev/ttyS1")]
    allow_only(["/dev/ttyS1"])
    try:
        found = list_ports(lambda: plugged, tmp_path)
    finally:
        allow_only(None)

    assert [each.device for each in found] == ["/dev/ttyS1"]


def test_the_ports_of_this_machine_are_those_that_pyserial_finds(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(
        "serial.tools.list_ports.comports", lambda: [Plugged("/dev/no-such-port", 0x2341, 0x42)]
    )

    assert list_ports() == (FoundPort("/dev/no-such-port", "/dev/no-such-port", is_board=True),)
