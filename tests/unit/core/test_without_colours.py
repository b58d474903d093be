"""A robot without a camera: what it meets has no colour, and COLOR says what is missing."""

from __future__ import annotations

from devices.firmware_double.robot import DoubleRobot
from devices.ports.robot import Pace, Watcher
from donnie_tui.core.events import Announced, Error, Stamped
from donnie_tui.core.session import Session
from donnie_tui.i18n.words import Words
from tests.patience import PATIENCE
from tests.unit.devices.robots import wall_ahead


def told(program: str) -> list[str]:
    def make(pace: Pace, watcher: Watcher) -> DoubleRobot:
        return DoubleRobot(wall_ahead(6), pace=pace, watcher=watcher, speed=None)

    session = Session(make, Words("en", "normal"), world="w", seed=0, terminal=False)
    heard: list[str] = []

    def hear(stamped: Stamped) -> None:
        match stamped.event:
            case Announced(text=text) | Error(message=text):
                heard.append(text)

    session.hub.subscribe(hear)
    session.start(program, "p").wait(PATIENCE)
    session.close()
    return heard


def test_a_scan_tells_what_the_head_meets_and_that_its_colour_is_unknown() -> None:
    assert "1 object of color unknown at 6 steps." in "\n".join(told("SCAN"))


def test_colour_says_that_there_is_no_camera_and_invents_no_number() -> None:
    assert told("SPEAK COLOR RED") == ["I have no camera: I see no colors."]
