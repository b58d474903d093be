"""The real robot's COLOR and SCAN, without a camera, with one, and with one that fails."""

from __future__ import annotations

from pathlib import Path

from devices.board_simulator.board import SimulatedBoard
from devices.board_simulator.robot import SimulatedSerialRobot
from devices.ports.robot import Pace, Watcher
from donnie_tui.core.events import Announced, Error, Outcome, Spoke, Stamped
from donnie_tui.core.session import Session, SessionSetup
from donnie_tui.i18n.words import Words
from donnie_tui.robot.connection import make_camera
from donnie_tui.settings.settings import Settings
from tests.timeouts import TIMEOUT
from tests.unit.devices.pictures import BLUE, RED, drawn, save
from tests.unit.devices.robots import wall_ahead


def sentences(*programs: str, camera: Path | None = None) -> list[str]:
    """What is announced and spoken by programs that all come to their ends."""

    def make(pace: Pace, watcher: Watcher) -> SimulatedSerialRobot:
        board = SimulatedBoard(wall_ahead(6), boot_loader=0.0)
        robot = SimulatedSerialRobot(board, pace=pace, watcher=watcher, speed=None)
        robot.camera = None if camera is None else make_camera(Settings(camera=str(camera)))
        return robot

    session = Session(make, Words("en", "normal"), SessionSetup("w", seed=0, terminal=False))
    heard: list[str] = []

    def remember(stamped: Stamped) -> None:
        match stamped.event:
            case Announced(text=text) | Error(message=text) | Spoke(text=text):
                heard.append(text)

    session.hub.subscribe(remember)
    for program in programs:
        run = session.start(program, "p")
        assert run.wait(TIMEOUT)
        assert run.outcome is Outcome.COMPLETED
    session.close()
    return heard


NO_CAMERA = "I have no camera: I see no colors."


def test_a_scan_reports_things_with_an_unknown_colour() -> None:
    assert "1 object of color unknown at 6 steps." in "\n".join(sentences("SCAN"))


def test_without_a_camera_color_says_so_counts_0_and_the_program_continues() -> None:
    assert sentences('SPEAK COLOR RED\nSPEAK "on"') == [NO_CAMERA, "0", "on"]


def test_a_loop_does_not_repeat_the_sentence_and_the_next_run_says_it_again() -> None:
    loop = "REPEAT 3 TIMES\nSPEAK COLOR RED + COLOR BLUE\nEND REPEAT"

    assert sentences(loop, "SPEAK COLOR RED") == [NO_CAMERA, "0", "0", "0", NO_CAMERA, "0"]


def test_with_a_camera_color_counts_and_a_scan_names_colours(tmp_path: Path) -> None:
    picture = drawn((100, 200, 160, 260, RED), (290, 200, 350, 260, BLUE), (500, 200, 560, 260, RED))
    save(tmp_path, {"a.png": picture})

    assert sentences("SPEAK COLOR RED\nSPEAK COLOR GREEN\nSCAN", camera=tmp_path) == [
        "2",
        "0",
        "To the 20 degrees in the left: 1 object of color red at 6 steps.",
        "Ahead: 1 object of color blue at 6 steps.",
        "To the 20 degrees in the right: 1 object of color red at 6 steps.",
    ]


def test_a_camera_that_fails_is_one_sentence_and_0(tmp_path: Path) -> None:
    program = 'REPEAT 2 TIMES\nSPEAK COLOR RED\nEND REPEAT\nSPEAK "on"'

    assert sentences(program, camera=tmp_path) == [
        f"There is no picture to see in {tmp_path}.",
        "0",
        "0",
        "on",
    ]
