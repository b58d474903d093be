"""Serial ports: what is wrong with one is a fault and the system's reason, wherever it is noticed."""

from __future__ import annotations

import errno
import os
import socket
import termios
import threading
from contextlib import suppress
from itertools import count
from pathlib import Path
from types import SimpleNamespace

import pytest
import serial

from devices.port_exchange import identify
from devices.serial_ports import (
    GONE,
    PortFault,
    PortProblem,
    SerialPort,
    allow_only,
    group_of,
    is_same_port,
)
from donnie_tui.i18n.words import Words
from donnie_tui.robot.search import sentences_of
from tests.timeouts import TIMEOUT
from tests.unit.devices.board_ports import BoardPort, opener


def test_a_port_that_disappears_while_its_speed_is_set_is_a_problem_with_the_systems_reason() -> None:
    class Stuck(BoardPort):
        def set_baud(self, baud: int) -> None:
            raise termios.error(5, "whatever")

    port = Stuck(None)
    with pytest.raises(PortProblem) as caught:
        identify("port", opener(port), now=port.now)
    assert (caught.value.fault, caught.value.reason) == (PortFault.ABSENT, "Input/output error")
    assert port.is_closed


def test_a_terminals_error_while_opening_is_a_problem(monkeypatch: pytest.MonkeyPatch) -> None:
    def fail(*_url: object, **_options: object) -> None:
        raise termios.error(5, "whatever")

    monkeypatch.setattr("serial.serial_for_url", fail)
    with pytest.raises(PortProblem) as caught:
        SerialPort("port", 9600)
    assert (caught.value.fault, caught.value.reason) == (PortFault.UNUSABLE, "Input/output error")


@pytest.mark.parametrize(
    "address",
    [
        *("hwgrep://[", "loop://?logging=loud", "socket://robot", "rfc2217://robot", "loop://", "LOOP://"),
        *(
            "alt:///dev/null?class=VTIMESerial",
            "hwgrep://.",
            "spy://",
            "cp2110://",
            "file:///dev/null",
            "x://y:1",
            "socket://127.0.0.1:9?logging=debug",
        ),
    ],
)
def test_an_address_that_can_not_be_parsed_is_a_problem_with_a_translated_sentence(address: str) -> None:
    with pytest.raises(PortProblem) as caught:
        SerialPort(address, 9600)
    assert (caught.value.fault, caught.value.reason) == (PortFault.NO_PORT, "Invalid argument")
    wanted = "não é uma porta. Pode ser: DEVICE, socket://HOST:PORT, rfc2217://HOST:PORT."
    assert sentences_of(caught.value, Words("pt")) == (f"{address} {wanted}",)


def test_an_address_whose_machine_is_not_found_has_the_reason_of_the_resolver(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def unknown(*_: object, **__: object) -> None:
        raise socket.gaierror(socket.EAI_NONAME, "Name or service not known")

    monkeypatch.setattr("socket.getaddrinfo", unknown)
    monkeypatch.setattr("socket.create_connection", unknown)
    with pytest.raises(PortProblem) as caught:
        SerialPort("socket://robot.example:1", 9600)
    assert caught.value.reason == "Name or service not known"


@pytest.mark.parametrize("scheme", ["spy", "SPY", "Spy"])
def test_an_address_that_writes_a_file_is_refused_before_it_writes(scheme: str, tmp_path: Path) -> None:
    with pytest.raises(PortProblem) as caught:
        SerialPort(f"{scheme}:///dev/null?file={tmp_path}/spied", 9600)

    assert caught.value.fault is PortFault.NO_PORT
    assert not (tmp_path / "spied").exists()


def test_only_the_named_ports_can_be_opened(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A link to a named port is that port, and the name that was given is the one that is opened."""
    other_end, terminal = os.openpty()
    device = os.ttyname(terminal)
    (tmp_path / "robot").symlink_to(device)
    (tmp_path / "other").symlink_to("/dev/ptmx")
    opened: list[str] = []
    serial_for_url = serial.serial_for_url

    def watched(address: str, **how: object) -> object:
        opened.append(address)
        return serial_for_url(address, **how)

    monkeypatch.setattr("serial.serial_for_url", watched)
    allow_only([device])
    try:
        for name in (device, f"{tmp_path}/robot"):
            SerialPort(name, 9600).close()
        for name in ("/dev/ptmx", f"{tmp_path}/other", "socket://localhost:1", "", "/dev/null"):
            with pytest.raises(PortProblem) as caught:
                SerialPort(name, 9600)
            assert caught.value.fault is PortFault.NOT_NAMED
        allow_only([])
        with pytest.raises(PortProblem):
            SerialPort(device, 9600)
    finally:
        allow_only(None)
        os.close(terminal)
        os.close(other_end)
    assert opened == [device] * 2


def test_a_file_is_not_a_port(tmp_path: Path) -> None:
    file = tmp_path / "file"
    file.touch()

    with pytest.raises(PortProblem) as caught:
        SerialPort(str(file), 9600)
    assert caught.value.fault is PortFault.UNUSABLE
    assert caught.value.reason == os.strerror(errno.ENOTTY), "and nothing of how pyserial names it"


def test_one_program_has_a_port_at_a_time() -> None:
    ours, theirs = os.openpty()
    first = SerialPort(os.ttyname(theirs), 9600)
    with pytest.raises(PortProblem) as caught:
        SerialPort(os.ttyname(theirs), 9600)
    first.close()
    SerialPort(os.ttyname(theirs), 9600).close()

    assert caught.value.fault is PortFault.BUSY
    os.close(ours)
    os.close(theirs)


def test_a_write_to_a_device_that_reads_nothing_times_out() -> None:
    ours, theirs = os.openpty()
    port = SerialPort(os.ttyname(theirs), 9600)
    timed_out = threading.Event()

    def write() -> None:
        with suppress(*GONE):
            port.write(bytes(1_000_000))
        timed_out.set()

    threading.Thread(target=write, daemon=True).start()
    assert timed_out.wait(TIMEOUT)
    port.close()
    os.close(theirs)
    os.close(ours)


def test_a_write_that_the_device_takes_is_done_however_long_its_thread_had_to_wait_for_its_turn(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Between any two looks at the clock the thread may have waited for a second."""
    ours, theirs = os.openpty()
    port = SerialPort(os.ttyname(theirs), 9600)
    clock = count()
    monkeypatch.setattr("serial.serialutil.Timeout.TIME", lambda *_: float(next(clock)))
    monkeypatch.setattr("time.monotonic", lambda: float(next(clock)))

    port.write(b"FW")

    assert os.read(ours, 2) == b"FW"
    port.close()
    os.close(theirs)
    os.close(ours)


@pytest.mark.parametrize(
    ("driver", "unsent"),
    [(SimpleNamespace(out_waiting=36), 36), (SimpleNamespace(), 0)],
    ids=["known", "unknown"],
)
def test_the_bytes_that_still_wait_in_the_system_are_counted_where_the_driver_can(
    monkeypatch: pytest.MonkeyPatch, driver: SimpleNamespace, unsent: int
) -> None:
    monkeypatch.setattr("serial.serial_for_url", lambda *_url, **_options: driver)

    assert SerialPort("port", 9600).unsent == unsent


def test_two_names_of_one_device_are_the_same_port(tmp_path: Path) -> None:
    link = tmp_path / "by-id"
    link.symlink_to("/dev/null")

    assert is_same_port(str(link), "/dev/null")
    assert not is_same_port(str(link), "/dev/zero")


def test_the_group_that_may_use_a_port_is_named() -> None:
    assert group_of("/dev/there-is-no-such-robot") == "dialout"
    assert group_of("/dev/null") is None  # root's own group is never advised
