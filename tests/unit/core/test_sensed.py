"""Distances that are published for a display. Publishing them has no other effect."""

from __future__ import annotations

import sys
import threading
from collections.abc import Iterator

import pytest

from devices.ports.robot import Bearing
from donnie_tui.core.events import CueSounded, Moved, Sensed
from tests.floor import Floor

STEP_CUE = CueSounded("step-forward", 0.0, None)


def sensed(floor: Floor) -> list[Sensed]:
    return [each for each in floor.events if isinstance(each, Sensed)]


def with_published_distances(floor: Floor) -> Floor:
    """The distances are published at every step."""
    floor.session.hub.subscribe(
        lambda it: floor.session.publish_distances() if it.event == STEP_CUE else None
    )
    return floor


def test_known_distances_are_published_without_noise() -> None:
    floor = Floor(("red", 0, 30), noise=0.5, seed=7)
    for _ in range(3):
        floor.session.publish_distances()

    exactly = {bearing: 30 if bearing is Bearing.FRONT else 60 for bearing in Bearing}
    assert sensed(floor) == [Sensed(exactly)] * 3


def test_distances_during_a_walk_are_those_of_the_current_place() -> None:
    floor = with_published_distances(Floor(("red", 0, 30)))
    floor.run("FW 4")

    assert [each.distances[Bearing.FRONT] for each in sensed(floor)] == [29, 28, 27, 26]


def test_publishing_distances_changes_no_byte_of_a_run() -> None:
    program = "REPEAT 4 TIMES FW 2 TR 30 SPEAK DISTANCE F SPEAK DISTANCE FR END REPEAT"
    floors = [Floor(("red", 0, 30), ("blue", 25, 9), noise=0.5, seed=7) for _ in range(2)]
    with_published_distances(floors[0])
    for floor in floors:
        floor.run(program)

    assert sensed(floors[0])
    assert floors[0].json == floors[1].json


@pytest.fixture
def quick_to_switch() -> Iterator[None]:
    """Threads take turns after each few steps."""
    before = sys.getswitchinterval()
    sys.setswitchinterval(1e-5)
    yield
    sys.setswitchinterval(before)


@pytest.mark.usefixtures("quick_to_switch")
def test_publishing_distances_from_a_thread_changes_no_byte_of_a_run(monkeypatch: pytest.MonkeyPatch) -> None:
    """From another thread, as a screen does."""
    monkeypatch.setattr("donnie_tui.core.hub.LONGEST_TURN", 20.0, raising=False)
    program = "REPEAT 60 TIMES FW 1 TR 30 SPEAK 1 END REPEAT"
    quiet, with_published_distances = Floor(("red", 0, 30)), Floor(("red", 0, 30))
    quiet.run(program)
    is_over = threading.Event()

    def look() -> None:
        while not is_over.wait(0.001):  # looks without a pause would leave the program no turn at its locks
            with_published_distances.session.publish_distances()

    looking = threading.Thread(target=look)
    looking.start()
    with_published_distances.run(program)
    is_over.set()
    looking.join()

    assert sensed(with_published_distances)
    assert with_published_distances.json == quiet.json


def test_publishing_distances_does_not_cancel_a_stop() -> None:
    floor = Floor(("red", 0, 900))

    def stop_and_look() -> None:
        floor.session.stop()
        floor.session.publish_distances()

    floor.session.hub.subscribe(lambda it: stop_and_look() if it.event == STEP_CUE else None)
    floor.run("FW 500")

    assert [each.walked for each in floor.events if isinstance(each, Moved)] == [1]
