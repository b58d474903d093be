"""A board is restarted by force through its DTR wire or a GPIO pin; a pin that can't be driven makes nothing
fail.

The pins belong to a fake gpiod: no test has driven a real Raspberry Pi.
"""

from __future__ import annotations

import errno
import logging
import os
import sys
from enum import Enum
from pathlib import Path
from types import SimpleNamespace
from typing import Self

import pytest

from devices.board_reset import (
    DtrReset,
    GpioReset,
    NoReset,
    PinFault,
    reset_of,
)
from devices.serial_ports import SerialPort


class Value(Enum):
    INACTIVE = 0
    ACTIVE = 1


class Direction(Enum):
    OUTPUT = 1


class FakeGpiod:
    """The part of libgpiod's Python package, version 2, that is used; ``seen`` is what happened, in order."""

    line = SimpleNamespace(Value=Value, Direction=Direction)

    def __init__(self, names: dict[str, str], refused: dict[str, OSError] | None = None) -> None:
        self.names, self.refused = names, refused or {}
        self.seen: list[object] = []
        self.open = 0

    def LineSettings(self, **settings: object) -> dict[str, object]:
        return settings

    def Chip(self, path: str) -> FakeChip:
        if error := self.refused.get(Path(path).name):
            raise error
        return FakeChip(self, self.names.get(Path(path).name, ""))

    def pause(self, seconds: float) -> None:
        self.seen.append(seconds)


class Held:
    def __init__(self, gpiod: FakeGpiod) -> None:
        self._gpiod = gpiod

    def __enter__(self) -> Self:
        self._gpiod.open += 1
        return self

    def __exit__(self, *_error: object) -> None:
        self._gpiod.open -= 1


class FakeChip(Held):
    def __init__(self, gpiod: FakeGpiod, name: str) -> None:
        super().__init__(gpiod)
        self._name = name

    def line_offset_from_id(self, name: str) -> int:
        if name != self._name:
            raise FileNotFoundError(errno.ENOENT, "no such line")
        return 22

    def request_lines(self, *, config: dict[str, dict[str, object]], consumer: str) -> FakeLine:
        if error := self._gpiod.refused.get(consumer):
            raise error
        ((name, settings),) = config.items()
        assert settings["direction"] is Direction.OUTPUT
        self._gpiod.seen.append((name, settings["output_value"]))
        return FakeLine(self._gpiod)


class FakeLine(Held):
    def set_value(self, name: str, value: Value) -> None:
        self._gpiod.seen.append((name, value))


@pytest.fixture
def chips(tmp_path: Path) -> Path:
    for number in range(2):
        (tmp_path / f"gpiochip{number}").touch()
    return tmp_path


@pytest.fixture
def gpiod(monkeypatch: pytest.MonkeyPatch) -> FakeGpiod:
    fake = FakeGpiod({"gpiochip1": "GPIO22"})
    monkeypatch.setitem(sys.modules, "gpiod", fake)
    return fake


def test_the_pin_is_low_for_half_a_second_then_high_and_released(chips: Path, gpiod: FakeGpiod) -> None:
    assert GpioReset(22, chips).pull(None, gpiod.pause) is True
    assert gpiod.seen == [
        ("GPIO22", Value.INACTIVE),
        0.5,
        ("GPIO22", Value.ACTIVE),
        0.05,
    ]
    assert gpiod.open == 0


def test_a_pulse_that_is_interrupted_leaves_the_pin_high(chips: Path, gpiod: FakeGpiod) -> None:
    def interrupted(_seconds: float) -> None:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        GpioReset(22, chips).pull(None, interrupted)
    assert gpiod.seen[-1] == ("GPIO22", Value.ACTIVE)
    assert gpiod.open == 0


@pytest.mark.parametrize(
    ("refused", "fault"),
    [
        (
            {"gpiochip0": PermissionError(13, "Permission denied"), "gpiochip1": PermissionError(13, "no")},
            "forbidden",
        ),
        ({"gpiochip1": OSError(5, "Input/output error")}, "failed"),
    ],
    ids=["forbidden", "failed"],
)
def test_a_pin_that_can_not_be_driven_is_logged_once_and_fails_nothing(
    chips: Path, gpiod: FakeGpiod, refused: dict[str, OSError], fault: str, caplog: pytest.LogCaptureFixture
) -> None:
    gpiod.refused = refused
    reset = GpioReset(22, chips)

    with caplog.at_level(logging.WARNING):
        assert [reset.pull(None, gpiod.pause), reset.pull(None, gpiod.pause)] == [False, False]
    assert len(caplog.records) == 1
    assert reset.fault() is PinFault(fault)
    assert gpiod.seen == []


def test_a_pin_that_another_program_drives_fails_nothing(chips: Path, gpiod: FakeGpiod) -> None:
    gpiod.refused = {"donnie": OSError(errno.EBUSY, "Device or resource busy")}

    assert GpioReset(22, chips).pull(None, gpiod.pause) is False


def test_a_machine_without_that_pin_says_so(chips: Path, gpiod: FakeGpiod) -> None:
    assert GpioReset(22, chips).fault() is None
    assert GpioReset(23, chips).fault() is PinFault.ABSENT
    assert GpioReset(22, chips / "none").fault() is PinFault.ABSENT


@pytest.mark.parametrize("package", [None, SimpleNamespace()], ids=["missing", "first version"])
def test_a_missing_or_old_package_is_reported_and_nothing_fails(
    chips: Path, monkeypatch: pytest.MonkeyPatch, package: object
) -> None:
    monkeypatch.setitem(sys.modules, "gpiod", package)
    reset = GpioReset(22, chips)

    assert reset.pull(None, lambda seconds: None) is False
    assert reset.fault() is PinFault.PACKAGE


@pytest.mark.parametrize(
    ("setting", "port", "kind"),
    [
        ("auto", "/dev/ttyACM0", DtrReset),
        ("auto", "/dev/ttyAMA0", GpioReset),
        ("auto", "/dev/ttyAMA10", GpioReset),
        ("auto", "/dev/serial0", GpioReset),
        ("auto", "/dev/ttyS0", GpioReset),
        ("auto", "socket://there:2000", DtrReset),
        ("dtr", "/dev/ttyAMA0", DtrReset),
        ("none", "/dev/ttyACM0", NoReset),
        ("gpio:17", "/dev/ttyACM0", GpioReset),
    ],
)
def test_the_reset_fits_the_port_unless_a_setting_names_another(
    tmp_path: Path, setting: str, port: str, kind: type
) -> None:
    model = tmp_path / "model"
    model.write_bytes(b"Raspberry Pi 4 Model B Rev 1.4\0")

    assert type(reset_of(setting, port, model)) is kind


def test_on_a_raspberry_pi_the_pin_is_the_originals(tmp_path: Path) -> None:
    """GPIO22, as docs/wire-protocol.md says."""
    model = tmp_path / "model"
    model.write_text("Raspberry Pi 3")
    reset = reset_of("auto", "/dev/ttyAMA0", model)

    assert isinstance(reset, GpioReset)
    assert reset.pin == 22


def test_only_on_a_raspberry_pi_a_pin_is_the_automatic_reset(tmp_path: Path) -> None:
    model = tmp_path / "model"
    assert type(reset_of("auto", "/dev/ttyAMA0", model)) is DtrReset
    model.write_text("Another Board")
    assert type(reset_of("auto", "/dev/ttyS0", model)) is DtrReset


def test_a_setting_names_the_pin(tmp_path: Path) -> None:
    reset = reset_of("gpio:17", "/dev/ttyACM0", tmp_path)
    assert isinstance(reset, GpioReset)
    assert reset.pin == 17


def test_without_a_wire_nothing_is_reset() -> None:
    assert NoReset().pull(None, lambda seconds: None) is False
    assert DtrReset().pull(None, lambda seconds: None) is False


def test_dtr_is_lowered_and_raised_with_a_pause_after_each(monkeypatch: pytest.MonkeyPatch) -> None:
    seen: list[object] = []

    class Wire:
        def __setattr__(self, name: str, level: object) -> None:
            seen.append((name, level))

    monkeypatch.setattr("serial.serial_for_url", lambda *_url, **_options: Wire())

    assert DtrReset().pull(SerialPort("port", 9600), seen.append) is True
    assert seen == [("dtr", False), 0.05, ("dtr", True), 0.05]


def test_a_terminal_without_a_dtr_wire_is_not_reset_and_stays_usable() -> None:
    ours, theirs = os.openpty()
    port = SerialPort(os.ttyname(theirs), 9600)

    assert DtrReset().pull(port, lambda seconds: None) is False
    assert port.read() == b""
    port.close()
    os.close(theirs)
    os.close(ours)
