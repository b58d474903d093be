"""A search for a robot can be given up before it begins, while it goes on, and never when there is none."""

from __future__ import annotations

import pytest

from donnie_tui.robot.search import Search


class Robot:
    """Notes what it is told; ``meanwhile`` happens while it connects."""

    def __init__(self, search: Search | None = None) -> None:
        self.told: list[str] = []
        self._search = search

    def connect(self) -> None:
        self.told.append("connect")
        if self._search is not None:
            assert self._search.give_up() is True

    def give_up(self) -> None:
        self.told.append("give up")


def test_without_a_search_there_is_nothing_to_give_up() -> None:
    search, robot = Search(), Robot()
    assert search.give_up() is False

    search.connect(robot)
    search.end()
    assert search.give_up() is False
    assert robot.told == ["connect"]


def test_while_it_goes_on_the_robot_is_told_at_once() -> None:
    search = Search()
    robot = Robot(search)

    search.connect(robot)
    assert robot.told == ["connect", "give up"]


@pytest.mark.parametrize("is_expected_later", [False, True])
def test_one_that_is_about_to_begin_ends_as_it_begins(is_expected_later: bool) -> None:
    search, robot = Search(is_coming=not is_expected_later), Robot()
    if is_expected_later:
        search.expect()
    assert search.give_up() is True

    search.connect(robot)
    assert robot.told == ["give up", "connect"]


def test_what_was_given_up_does_not_concern_the_next_one() -> None:
    search, robot = Search(is_coming=True), Robot()
    search.give_up()
    search.end()

    search.connect(robot)
    assert robot.told == ["connect"]
