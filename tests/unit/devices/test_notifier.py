"""Notices are delivered in their order, and the device never waits for its listener."""

from __future__ import annotations

import threading

import pytest

from devices.serial_ports import Notifier
from tests.timeouts import TIMEOUT


def test_notices_wait_in_order_while_the_listener_hangs() -> None:
    may_return, received = threading.Event(), list[int]()

    def listen(number: int) -> None:
        assert may_return.wait(TIMEOUT)
        received.append(number)

    notifier = Notifier("robot", listen)
    for number in range(5):
        notifier.notify(number)
    assert received == []

    may_return.set()
    notifier.wait(TIMEOUT)
    assert received == [0, 1, 2, 3, 4]


def test_for_a_listener_that_hangs_a_limited_number_of_notices_is_kept() -> None:
    has_begun, may_return, received = threading.Event(), threading.Event(), list[int]()

    def listen(number: int) -> None:
        has_begun.set()
        assert may_return.wait(TIMEOUT)
        received.append(number)

    notifier = Notifier("robot", listen)
    notifier.notify(0)
    assert has_begun.wait(TIMEOUT)
    for number in range(1, 512):
        notifier.notify(number)
    may_return.set()
    notifier.wait(TIMEOUT)

    assert received == list(range(257))


def test_a_listener_that_fails_receives_the_next_notice(caplog: pytest.LogCaptureFixture) -> None:
    received = []

    def listen(number: int) -> None:
        if number == 0:
            raise KeyError(number)
        received.append(number)

    notifier = Notifier("robot", listen)
    notifier.notify(0)
    notifier.notify(1)
    notifier.wait(TIMEOUT)

    assert received == [1]
    assert "a listener failed" in caplog.text


def test_a_listener_may_notify_and_wait_without_waiting_for_itself() -> None:
    received = []

    def listen(number: int) -> None:
        received.append(number)
        if number == 0:
            notifier.notify(1)
            notifier.wait(1e6)

    notifier = Notifier("robot", listen)
    notifier.notify(0)
    notifier.wait(TIMEOUT)

    assert received == [0, 1]
