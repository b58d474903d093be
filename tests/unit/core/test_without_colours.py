"""A robot without a camera: things have no colour, and COLOR names the missing camera."""

from __future__ import annotations

from devices.board_simulator.board import SimulatedBoard
from devices.board_simulator.robot import SimulatedSerialRobot
from devices.ports.robot import Pace, Watcher
from donnie_tui.core.events import Announced, Error, Stamped
from donnie_tui.core.session import Session, SessionSetup
from donnie_tui.i18n.words import Words
from tests.timeouts import TIMEOUT
from tests.unit.devices.robots import wall_ahead


def announcements(program: str) -> list[str]:
    def make(pace: Pace, watcher: Watcher) -> SimulatedSerialRobot:
        board = SimulatedBoard(wall_ahead(6), boot_loader=0.0)
        return SimulatedSerialRobot(board, pace=pace, watcher=watcher, speed=None)

    session = Session(make, Words("en", "normal"), SessionSetup("w", seed=0, terminal=False))
    heard: list[str] = []

    def remember(stamped: Stamped) -> None:
        match stamped.event:
            case Announced(text=text) | Error(message=text):
                heard.append(text)

    session.hub.subscribe(remember)
    session.start(program, "p").wait(TIMEOUT)
    session.close()
    return heard


def test_a_scan_reports_things_with_an_unknown_colour() -> None:
    assert "1 object of color unknown at 6 steps." in "\n".join(announcements("SCAN"))


def test_color_names_the_missing_camera_and_invents_no_number() -> None:
    assert announcements("SPEAK COLOR RED") == ["I have no camera: I see no colors."]
