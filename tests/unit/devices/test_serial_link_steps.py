"""The thread of a link to a robot's board, step by step: the test is the thread, the port and the clock."""

from __future__ import annotations

import struct
from typing import Any

import pytest

from devices.board_reset import Pause
from devices.ports.robot import LinkNotice
from devices.serial_ports import PortFault, PortProblem
from devices.serial_robot import link as module
from devices.serial_robot.link import SerialLink
from devices.wire.connection import PortAction, Write
from devices.wire.frames import CONFIGURE, STOP, MotorDrive, drive_frame, encode_frame, head_frame
from devices.wire.link_state import LinkState
from tests.timeouts import TIMEOUT

CONFIG_WANTED = encode_frame(0xC7, b"\x2b")
COUNTS = encode_frame(0x81, struct.pack(">hhHH", 0, 0, 0, 0))


class Port:
    """Gives what arrived, and records what happens to it."""

    def __init__(self) -> None:
        self.arrived: list[bytes | Exception] = []
        self.did: list[object] = []
        self.fault: Exception | None = None

    def read(self) -> bytes:
        self.did.append("read")
        data = self.arrived.pop(0) if self.arrived else b""
        if isinstance(data, Exception):
            raise data
        return data

    def write(self, data: bytes) -> None:
        if self.fault is not None:
            raise self.fault
        self.did.append(data)

    def close(self) -> None:
        self.did.append("closed")


class Stepped:
    """A link whose port is open since second 100."""

    def __init__(self) -> None:
        self.now, self.notices = 100.0, list[tuple[LinkNotice, str]]()
        self.ports: list[Port | Exception] = []
        self.pulled: list[object] = []
        self.port: Any = Port()
        open_port: Any = self._open
        self.link = SerialLink(
            "port", None, lambda *notice: self.notices.append(notice), open_port=open_port, reset=self
        )
        self.link.now = lambda: self.now  # type: ignore[method-assign]
        self.link._port = self.port
        self.link._connection.open()
        self.link._connection.opened(self.now)

    def _open(self, address: str) -> Port:
        assert address == "port"
        opened = self.ports.pop(0)
        if isinstance(opened, Exception):
            raise opened
        return opened

    def pull(self, port: object, pause: Pause) -> bool:
        assert pause is module.pause
        self.pulled.append(port)
        return True

    def polled(self, *arrived: bytes | Exception, at: float) -> list[object]:
        """What one poll does at this second."""
        self.now = at
        self.port.arrived += arrived
        self.port.did.clear()
        self.link._poll()
        return list(self.port.did)

    def noticed(self) -> list[tuple[LinkNotice, str]]:
        self.link._notify()
        self.link._notifier.wait(TIMEOUT)
        notices, self.notices = self.notices, []
        return notices


def streaming() -> Stepped:
    made = Stepped()
    assert made.polled(CONFIG_WANTED, at=101.0) == ["read", CONFIGURE]
    assert made.polled(at=101.1) == ["read", STOP]
    assert made.polled(at=101.2) == ["read", STOP]
    assert made.polled(COUNTS, at=101.3) == ["read"]
    assert made.link.state is LinkState.STREAMING
    assert made.noticed() == [(LinkNotice.CONNECTED, "port")]
    return made


def test_a_stop_is_written_before_what_arrived_is_read() -> None:
    made = streaming()
    made.link.put(head_frame(10))
    made.link.stop()

    assert made.polled(at=101.4) == [STOP, "read"]
    assert made.polled(COUNTS, at=101.45) == [STOP, "read"]
    assert made.polled(COUNTS, at=101.5) == ["read", head_frame(10)]


@pytest.mark.parametrize("error", [OSError(5, "x"), ValueError("Input/output error")])
def test_a_port_that_fails_is_closed_and_the_reason_reported(error: Exception) -> None:
    made = streaming()
    assert made.polled(error, at=101.4) == ["read", "closed"]
    assert (made.link.state, made.link._port) == (LinkState.LOST, None)
    assert made.noticed() == [(LinkNotice.LOST, "Input/output error")]
    made.link._poll()
    made.link._do(Write(STOP))


def test_a_port_that_takes_nothing_is_lost() -> None:
    made = streaming()
    made.port.fault = TimeoutError("Write timeout")
    made.link.stop()

    assert made.polled(at=101.4)[0] == "closed"
    assert made.noticed() == [(LinkNotice.LOST, "Write timeout")]


def test_a_board_is_restarted_by_its_wire_as_long_as_it_has_a_port() -> None:
    made, forced = streaming(), list[float]()
    made.link._connection.forced = forced.append  # type: ignore[method-assign]
    made.link._do(PortAction.RESET)
    made.link._port = None
    made.link._do(PortAction.RESET)

    assert (made.pulled, forced) == ([made.port], [101.3, 101.3])


def test_a_port_is_opened_again_where_its_name_leads() -> None:
    made, again = streaming(), Port()
    made.ports = [PortProblem("port", PortFault.ABSENT, "No such device"), again]
    made.now = 102.0
    made.link._do(PortAction.REOPEN)
    assert made.port.did[-1] == "closed"
    assert (made.link.state, made.link._port) == (LinkState.LOST, None)
    made.now = 103.0
    made.link._do(PortAction.REOPEN)

    assert (made.link.state, made.link._port) == (LinkState.WAITING, again)
    assert again.did == []


def test_the_thread_rests_until_something_is_due_but_a_hundredth_of_a_second_at_most() -> None:
    made, waits = streaming(), list[float]()
    made.link._must_wake.wait = waits.append  # type: ignore[assignment]
    made.link._must_wake.set()
    made.link._wait()
    assert not made.link._must_wake.is_set()
    made.polled(at=101.4)
    made.link._wait()
    made.link.stop()
    made.link._wait()

    assert waits == [0.01, 0.01, 0.001]


def test_only_what_is_new_wakes_the_thread() -> None:
    made = streaming()
    link, woken = made.link, made.link._must_wake
    for do, wakes in (
        (lambda: link.drive(link.permit(), MotorDrive.FORWARD, 500.0), True),
        (lambda: link.drive(link.permit(), MotorDrive.FORWARD, 600.0), False),
        (link.stop, True),
        (lambda: link.put(head_frame(10)), True),
    ):
        woken.clear()
        do()
        assert woken.is_set() is wakes
    assert link.drive(link.permit() - 1, MotorDrive.FORWARD, 500.0) is False
    assert link.drive(link.permit(), MotorDrive.FORWARD, 500.0) is True
    assert made.polled(at=101.5) == ["read", drive_frame(MotorDrive.FORWARD)]


def test_an_error_that_nothing_foresees_is_logged_and_loses_the_link(
    monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    made, states = streaming(), list[LinkState]()

    def wait() -> None:
        states.append(made.link.state)
        made.link._is_closing.set()

    monkeypatch.setattr(made.link, "_wait", wait)
    made.port.arrived = [KeyError("a driver")]
    made.link._run()

    (record,) = [each for each in caplog.records if each.levelname == "WARNING"]
    assert record.getMessage() == "port failed"
    assert record.exc_info is not None
    assert record.exc_info[0] is KeyError
    made.link._notifier.wait(TIMEOUT)
    assert made.notices == [(LinkNotice.LOST, "'a driver'")]
    assert (states, made.link.state) == ([LinkState.LOST], LinkState.CLOSED)
    assert made.port.did[-1] == "closed"


@pytest.mark.parametrize("is_gone", [False, True])
def test_the_last_thing_that_is_written_is_a_stop(is_gone: bool) -> None:
    made = streaming()
    made.port.fault = OSError(5, "gone") if is_gone else None
    made.port.did.clear()
    made.link._finish()

    assert made.port.did == ([] if is_gone else [STOP]) + ["closed"]
    assert (made.link.state, made.link._port) == (LinkState.CLOSED, None)
    made.link._finish()


@pytest.mark.parametrize(("is_driving", "pauses"), [(False, 0), (True, 3)])
def test_a_stop_is_waited_for_as_long_as_all_that_can_be_done_may_take(
    monkeypatch: pytest.MonkeyPatch, is_driving: bool, pauses: int
) -> None:
    """2.2 seconds; each look of this test takes one."""
    made, paused = streaming(), list[float]()

    def pause(seconds: float) -> None:
        paused.append(seconds)
        made.now += 1.0

    monkeypatch.setattr(module, "pause", pause)
    if is_driving:
        made.link.drive(made.link.permit(), MotorDrive.FORWARD, 500.0)
        made.link.stop()
    assert made.link.await_stop() is True
    assert paused == [0.01] * pauses
