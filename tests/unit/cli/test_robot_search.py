"""A search for a robot can be cancelled before it begins and while it runs."""

from __future__ import annotations

import pytest

from donnie_tui.robot.search import Search


class Robot:
    """Records its calls; ``meanwhile`` runs while it connects."""

    def __init__(self, search: Search | None = None) -> None:
        self.calls: list[str] = []
        self._search = search

    def connect(self) -> None:
        self.calls.append("connect")
        if self._search is not None:
            assert self._search.give_up() is True

    def give_up(self) -> None:
        self.calls.append("give up")


def test_without_a_search_there_is_nothing_to_cancel() -> None:
    search, robot = Search(), Robot()
    assert search.give_up() is False

    search.connect(robot)
    search.end()
    assert search.give_up() is False
    assert robot.calls == ["connect"]


def test_a_running_search_is_cancelled_at_once() -> None:
    search = Search()
    robot = Robot(search)

    search.connect(robot)
    assert robot.calls == ["connect", "give up"]


@pytest.mark.parametrize("is_expected_later", [False, True])
def test_a_search_that_is_about_to_begin_ends_as_it_begins(is_expected_later: bool) -> None:
    search, robot = Search(is_pending=not is_expected_later), Robot()
    if is_expected_later:
        search.expect()
    assert search.give_up() is True

    search.connect(robot)
    assert robot.calls == ["give up", "connect"]


def test_a_cancelled_search_does_not_cancel_the_next_one() -> None:
    search, robot = Search(is_pending=True), Robot()
    search.give_up()
    search.end()

    search.connect(robot)
    assert robot.calls == ["connect"]
