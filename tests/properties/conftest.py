"""Hypothesis watches Python's recursion limit, which a program that runs raises: it is raised before."""

import pytest

from language.levels import make_room


@pytest.fixture(scope="session", autouse=True)
def room_for_recursion() -> None:
    make_room()
