"""DISTANCE with the name that a world gives to a distance sensor of its robot."""

from functools import partial
from pathlib import Path

import pytest

from donnie_tui.core.events import Error, Read
from donnie_tui.core.session import Session, SessionSetup
from donnie_tui.i18n.words import Words
from sim.world import World
from sim.worldfile import load_text
from tests.timeouts import TIMEOUT

EYE = "define eye ranger ( sensor( range [ 0 3 ] fov 10 samples 1 ) )"
NAMED = """
define bob position
(
  size [ 0.1 0.1 0.1 ]
  eye( name "left eye" pose [ 0 0.05 0 90 ] )
  eye( name "nose" pose [ 0.05 0 0 0 ] )
)
"""
UNNAMED = NAMED.replace('name "left eye"', "").replace('name "nose"', "")
ROOM = """
bob( pose [ 0 0 0 90 ] )
model( size [ 2 0.05 1 ] pose [ 0 0.575 0 0 ] )
"""


def outcome(program: str, robot: str) -> tuple[list[Read], list[str]]:
    """The readings, and the sentences about mistakes."""
    room, words = World(load_text(EYE + robot + ROOM, Path("room.world"))), Words()
    session = Session(
        lambda pace, watcher: partial(room.robot, pace=pace, watcher=watcher)(),
        words,
        SessionSetup("room", seed=0, terminal=True),
    )
    read: list[Read] = []
    mistakes: list[str] = []

    def listen(stamped: object) -> None:
        event = getattr(stamped, "event", None)
        if isinstance(event, Read):
            read.append(event)
        elif isinstance(event, Error):
            mistakes.append(event.message)

    session.hub.subscribe(listen)
    assert session.start(program, "a.gd").wait(TIMEOUT)
    return read, mistakes


def test_a_named_sensor_reads_what_lies_in_its_direction() -> None:
    # The wall's near side is 0.55 m to the north, the nose 0.05 m: 10 steps. To the west is nothing.
    read, mistakes = outcome('SPEAK DISTANCE "NOSE" SPEAK 1 + DISTANCE "left eye"', NAMED)

    assert read == [Read("distance", "nose", 10), Read("distance", "left eye", 60)]
    assert mistakes == []


@pytest.mark.parametrize(
    ("robot", "sentence"),
    [
        (NAMED, "I have no sensor tail. I have: left eye, nose."),
        (UNNAMED, "My sensors have no names."),
    ],
)
def test_an_unknown_name_is_one_mistake_with_the_names_there_are(robot: str, sentence: str) -> None:
    assert outcome('WHILE DISTANCE "tail" > 3 DO FW 1 END WHILE', robot) == ([], [sentence])
