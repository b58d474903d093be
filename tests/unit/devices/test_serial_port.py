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
    is_named,
    is_same_port,
    named_ports,
    reason_of,
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


class Driver:
    """In place of pyserial's port."""

    def __init__(self) -> None:
        self.baudrate, self.dtr, self.calls = 0, False, list[object]()

    def read(self, most: int) -> bytes:
        self.calls.append(most)
        return b"read"

    def write(self, data: bytes) -> None:
        self.calls.append(data)

    def close(self) -> None:
        self.calls.append("close")
        raise termios.error(5, "whatever")


@pytest.mark.parametrize("is_exclusive", [True, False])
def test_a_port_is_opened_with_its_speed_and_timeouts(
    monkeypatch: pytest.MonkeyPatch, is_exclusive: bool
) -> None:
    """pyserial takes None, and not False, for a port that others may have too."""
    driver, asked = Driver(), dict[str, object]()

    def open_it(address: str, **options: object) -> Driver:
        asked.update(options, address=address)
        return driver

    monkeypatch.setattr("serial.serial_for_url", open_it)
    port = SerialPort("RFC2217://robot:2000", 115200, timeout=0.5, exclusive=is_exclusive)
    port.write(b"FW")
    port.set_baud(9600)
    port.set_dtr(True)
    received = port.read()
    port.close()

    assert asked == {
        **{"address": "RFC2217://robot:2000", "baudrate": 115200, "timeout": 0.5, "write_timeout": 0.2},
        "exclusive": True if is_exclusive else None,
    }
    assert (driver.baudrate, driver.dtr, received) == (9600, True, b"read")
    assert driver.calls == [b"FW", 8192, "close"]


@pytest.mark.parametrize(
    ("number", "fault"),
    [
        *((errno.ENOENT, PortFault.ABSENT), (errno.ENODEV, PortFault.ABSENT)),
        *((errno.ENXIO, PortFault.ABSENT), (errno.EACCES, PortFault.FORBIDDEN)),
        *((errno.EPERM, PortFault.FORBIDDEN), (errno.EAGAIN, PortFault.BUSY)),
        *((errno.EBUSY, PortFault.BUSY), (errno.EIO, PortFault.UNUSABLE)),
    ],
)
@pytest.mark.parametrize("is_hidden", [False, True])
def test_the_systems_number_says_what_is_wrong(
    monkeypatch: pytest.MonkeyPatch, number: int, fault: PortFault, is_hidden: bool
) -> None:
    """pyserial makes an error without a number of some."""

    def fail(*_url: object, **_options: object) -> None:
        try:
            raise OSError(number, "whatever")
        except OSError as error:
            if is_hidden:
                raise serial.SerialException("could not open port") from error
            raise

    monkeypatch.setattr("serial.serial_for_url", fail)
    with pytest.raises(PortProblem) as caught:
        SerialPort("/dev/robot", 9600)
    problem = caught.value
    assert (problem.port, problem.fault, problem.reason) == ("/dev/robot", fault, os.strerror(number))
    assert str(problem) == f"/dev/robot: {os.strerror(number)}"


def test_an_error_without_a_number_says_it_in_its_own_words() -> None:
    assert reason_of(serial.SerialException("no number")) == "no number"
    assert reason_of(ValueError("of no port")) == "of no port"
    assert reason_of(socket.gaierror("an unknown address")) == "an unknown address"


def test_a_process_names_the_ports_to_which_it_is_limited() -> None:
    assert (named_ports(), is_named("/dev/any")) == ((), True)
    allow_only(["/dev/null"])
    try:
        assert (named_ports(), is_named("/dev/null"), is_named("/dev/any")) == (("/dev/null",), True, False)
    finally:
        allow_only(None)


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
    ("taken", "ready", "calls"),
    [
        ([5], [], [(b"12345", 7)]),
        ([3, 2], [True], [(b"12345", 7), ("wait", 7, 0.2), (b"45", 7)]),
        ([None, 5], [True], [(b"12345", 7), ("wait", 7, 0.2), (b"12345", 7)]),
        ([3], [False], [(b"12345", 7), ("wait", 7, 0.2), "timeout"]),
    ],
    ids=["at once", "in two parts", "when it is ready", "not in time"],
)
def test_a_write_waits_a_fifth_of_a_second_for_a_device_that_takes_no_more(
    monkeypatch: pytest.MonkeyPatch, taken: list[int | None], ready: list[bool], calls: list[object]
) -> None:
    made: list[object] = []

    def write(port: int, data: bytes) -> int:
        made.append((data, port))
        count = taken.pop(0)
        if count is None:
            raise BlockingIOError
        return count

    def wait(readers: object, writers: tuple[int], errors: object, seconds: float) -> tuple[object, ...]:
        made.append(("wait", *writers, seconds))
        return (), writers if ready.pop(0) else (), ()

    monkeypatch.setattr("serial.serial_for_url", lambda *_url, **_how: SimpleNamespace(fileno=lambda: 7))
    port = SerialPort("port", 9600)
    with monkeypatch.context() as patched:
        patched.setattr("devices.serial_ports.os.write", write)
        patched.setattr("devices.serial_ports.select.select", wait)
        try:
            port.write(b"12345")
        except TimeoutError:
            made.append("timeout")

    assert made == calls


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


@pytest.mark.parametrize(
    ("mode", "owner", "group"), [(0o660, 7, "robots"), (0o640, 7, None), (0o620, 7, None), (0o660, 0, None)]
)
def test_a_group_is_advised_if_it_may_read_and_write_and_is_not_roots(
    monkeypatch: pytest.MonkeyPatch, mode: int, owner: int, group: str | None
) -> None:
    monkeypatch.setattr(Path, "stat", lambda _: SimpleNamespace(st_mode=mode, st_gid=owner))
    monkeypatch.setattr(Path, "group", lambda _: "robots")

    assert group_of("/dev/robot") == group


def test_the_group_that_may_use_a_port_is_named() -> None:
    assert group_of("/dev/there-is-no-such-robot") == "dialout"
    assert group_of("/dev/null") is None  # root's own group is never advised
