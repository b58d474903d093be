"""Distances that are told because somebody looks: nothing else happens for it."""

from __future__ import annotations

import sys
import threading
from collections.abc import Iterator

import pytest

from devices.ports.robot import Bearing
from donnie_tui.core.events import CueSounded, Moved, Sensed
from tests.floor import Floor

STEP_CUE = CueSounded("step-forward", 0.0, None)


def told(floor: Floor) -> list[Sensed]:
    return [each for each in floor.events if isinstance(each, Sensed)]


def looked_at(floor: Floor) -> Floor:
    """Somebody looks at every step."""
    floor.session.hub.subscribe(lambda it: floor.session.tell_distances() if it.event == STEP_CUE else None)
    return floor


def test_what_is_known_of_the_distances_is_told_without_noise() -> None:
    floor = Floor(("red", 0, 30), noise=0.5, seed=7)
    for _ in range(3):
        floor.session.tell_distances()

    exactly = {bearing: 30 if bearing is Bearing.FRONT else 60 for bearing in Bearing}
    assert told(floor) == [Sensed(exactly)] * 3


def test_in_the_midst_of_a_walk_it_is_what_is_known_there() -> None:
    floor = looked_at(Floor(("red", 0, 30)))
    floor.run("FW 4")

    assert [each.distances[Bearing.FRONT] for each in told(floor)] == [29, 28, 27, 26]


def test_a_run_is_the_same_to_the_last_byte_whoever_looks() -> None:
    program = "REPEAT 4 TIMES FW 2 TR 30 SPEAK DISTANCE F SPEAK DISTANCE FR END REPEAT"
    floors = [Floor(("red", 0, 30), ("blue", 25, 9), noise=0.5, seed=7) for _ in range(2)]
    looked_at(floors[0])
    for floor in floors:
        floor.run(program)

    assert told(floors[0])
    assert floors[0].json == floors[1].json


@pytest.fixture
def quick_to_switch() -> Iterator[None]:
    """Threads take turns after each few steps."""
    before = sys.getswitchinterval()
    sys.setswitchinterval(1e-5)
    yield
    sys.setswitchinterval(before)


@pytest.mark.usefixtures("quick_to_switch")
def test_a_run_is_the_same_whenever_somebody_looks(monkeypatch: pytest.MonkeyPatch) -> None:
    """From another thread, as a screen does."""
    monkeypatch.setattr("donnie_tui.core.hub.LONGEST_TURN", 20.0, raising=False)
    program = "REPEAT 60 TIMES FW 1 TR 30 SPEAK 1 END REPEAT"
    quiet, looked_at = Floor(("red", 0, 30)), Floor(("red", 0, 30))
    quiet.run(program)
    is_over = threading.Event()

    def look() -> None:
        while not is_over.wait(0.001):  # who looks without a pause leaves the program no turn at its locks
            looked_at.session.tell_distances()

    looking = threading.Thread(target=look)
    looking.start()
    looked_at.run(program)
    is_over.set()
    looking.join()

    assert told(looked_at)
    assert looked_at.json == quiet.json


def test_who_looks_takes_no_stop_back() -> None:
    floor = Floor(("red", 0, 900))

    def stop_and_look() -> None:
        floor.session.stop()
        floor.session.tell_distances()

    floor.session.hub.subscribe(lambda it: stop_and_look() if it.event == STEP_CUE else None)
    floor.run("FW 500")

    assert [each.walked for each in floor.events if isinstance(each, Moved)] == [1]
