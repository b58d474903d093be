"""News are told in their order, and nobody who has some waits for who listens."""

from __future__ import annotations

import threading

import pytest

from devices.telling import MOST_WAITING, Telling
from tests.patience import PATIENCE


def test_what_is_told_behind_a_listener_that_hangs_comes_in_its_order_once_it_goes_on() -> None:
    goes_on, heard = threading.Event(), list[int]()

    def listen(number: int) -> None:
        assert goes_on.wait(PATIENCE)
        heard.append(number)

    telling = Telling("robot", listen)
    for number in range(5):
        telling.tell(number)
    assert heard == []

    goes_on.set()
    telling.wait(PATIENCE)
    assert heard == [0, 1, 2, 3, 4]


def test_of_a_listener_that_hangs_no_more_is_kept_than_may_wait() -> None:
    begun, goes_on, heard = threading.Event(), threading.Event(), list[int]()

    def listen(number: int) -> None:
        begun.set()
        assert goes_on.wait(PATIENCE)
        heard.append(number)

    telling = Telling("robot", listen)
    telling.tell(0)
    assert begun.wait(PATIENCE)
    for number in range(1, 2 * MOST_WAITING):
        telling.tell(number)
    goes_on.set()
    telling.wait(PATIENCE)

    assert heard == list(range(MOST_WAITING + 1))


def test_a_listener_that_fails_hears_what_comes_next(caplog: pytest.LogCaptureFixture) -> None:
    heard = []

    def listen(number: int) -> None:
        if number == 0:
            raise KeyError(number)
        heard.append(number)

    telling = Telling("robot", listen)
    telling.tell(0)
    telling.tell(1)
    telling.wait(PATIENCE)

    assert heard == [1]
    assert "a listener failed" in caplog.text


def test_who_listens_may_tell_and_wait_and_does_not_wait_for_itself() -> None:
    heard = []

    def listen(number: int) -> None:
        heard.append(number)
        if number == 0:
            telling.tell(1)
            telling.wait(1e6)

    telling = Telling("robot", listen)
    telling.tell(0)
    telling.wait(PATIENCE)

    assert heard == [0, 1]
