"""A loop that gets nowhere has one hint in a run."""

from functools import partial
from pathlib import Path

import pytest

from donnie_tui.core.events import Announced
from donnie_tui.core.session import Session, SessionSetup
from donnie_tui.i18n.words import Words
from sim.world import World
from sim.worldfile import load_text
from tests.timeouts import TIMEOUT

ROBOT = """
define bob position
( size [ 0.1 0.1 0.1 ] ranger( sensor( range [ 0 3 ] fov 10 samples 1 pose [ 0.05 0 0 0 ] ) ) )
bob( pose [ 0 0 0 90 ] )
"""
WALL = "model( size [ 2 0.05 1 ] pose [ 0 0.5 0 0 ] )\n"
NO_WALL = "There is no wall ahead in this world."


def hints(program: str, world: str) -> list[str]:
    room = World(load_text(world, Path("room.world")))
    session = Session(
        lambda pace, watcher: partial(room.robot, pace=pace, watcher=watcher)(),
        Words(),
        SessionSetup("room", seed=0, terminal=True),
    )
    found: list[str] = []

    def listen(stamped: object) -> None:
        event = getattr(stamped, "event", None)
        if isinstance(event, Announced) and event.code == "hint":
            found.append(event.text)

    session.hub.subscribe(listen)
    assert session.start(program, "a.gd").wait(TIMEOUT)
    return found


def test_three_walks_of_no_steps_say_how_near_the_obstacle_is() -> None:
    # the wall's near side is 0.475 m ahead and the front 0.05 m: 8 steps, of which one stays free
    assert hints("FW 20 REPEAT 5 TIMES FW 1 END REPEAT", ROBOT + WALL) == [
        "I can't get nearer than 1 step here."
    ]


@pytest.mark.parametrize(
    "program",
    [
        "FW 20 FW 1 FW 1",
        "FW 20 FW 1 FW 1 BW 1 FW 2 FW 1",
        "FW 20 REPEAT 3 TIMES FW 0 END REPEAT",
        "PROCEDURE P DO FW 1 END PROCEDURE FW 20 P [] P [] TR 180 P [] TR 180 P [] P []",
        "PROCEDURE P DO FW 1 END PROCEDURE FW 20 P [] P [] FW 2 P []",
    ],
)
def test_fewer_walks_or_walks_of_zero_steps_say_nothing(program: str) -> None:
    assert hints(program, ROBOT + WALL) == []


def test_a_loop_that_waits_for_a_wall_in_an_empty_world_says_so() -> None:
    loop = "VAR n WHILE DISTANCE F > 3 DO n = n + 1 IF n == 300 THEN FW 1 / 0 END IF TR 1 END WHILE"

    assert hints(loop, ROBOT) == [NO_WALL]
    assert hints(loop, ROBOT + WALL) == []
    assert hints(loop.replace("300", "199"), ROBOT) == []
