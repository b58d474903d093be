"""The garbage collector skips what was loaded at the start. Without that start it keeps its thresholds."""

import gc
from collections.abc import Iterator

import pytest

from donnie_tui.process import AFTERWARDS, WHILE_LOADING, load_undisturbed, loaded


@pytest.fixture(autouse=True)
def _as_before() -> Iterator[None]:
    before = gc.get_threshold()
    yield
    gc.unfreeze()
    gc.set_threshold(*before)


def test_loaded_objects_are_not_collected_again() -> None:
    load_undisturbed()
    assert gc.get_threshold()[0] == WHILE_LOADING

    loaded()

    assert gc.get_freeze_count() > 1000
    assert gc.get_threshold()[0] == AFTERWARDS


def test_a_session_without_a_start_keeps_the_thresholds_of_python() -> None:
    before = gc.get_threshold(), gc.get_freeze_count()

    loaded()

    assert (gc.get_threshold(), gc.get_freeze_count()) == before
