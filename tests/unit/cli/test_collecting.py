"""Garbage is looked for after a start and among what came later; elsewhere nothing is changed."""

import gc
from collections.abc import Iterator

import pytest

from donnie_tui.process.collecting import AFTERWARDS, WHILE_LOADING, load_undisturbed, loaded


@pytest.fixture(autouse=True)
def _as_before() -> Iterator[None]:
    before = gc.get_threshold()
    yield
    gc.unfreeze()
    gc.set_threshold(*before)


def test_what_was_loaded_is_not_looked_at_again() -> None:
    load_undisturbed()
    assert gc.get_threshold()[0] == WHILE_LOADING

    loaded()

    assert gc.get_freeze_count() > 1000
    assert gc.get_threshold()[0] == AFTERWARDS


def test_who_only_makes_a_session_keeps_the_own_thresholds() -> None:
    before = gc.get_threshold(), gc.get_freeze_count()

    loaded()

    assert (gc.get_threshold(), gc.get_freeze_count()) == before
