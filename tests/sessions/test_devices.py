"""The real command and a real connection: a pseudo terminal with a simulated board at its other end."""

from __future__ import annotations

import json
import os
import signal
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from devices.ports.robot import Pose
from donnie_tui.bootstrap import assemble
from donnie_tui.core.events import Link, Moved, RunEnded, Stamped
from donnie_tui.core.session import RunOptions
from donnie_tui.robot.connection import Connection
from donnie_tui.robot.search import Search
from donnie_tui.settings.settings import Settings
from tests.board_on_pty import PtyBoard
from tests.sessions.command import QUIET, donnie, start
from tests.sessions.learner import Learner
from tests.sessions.real_robot import LONG_WALK, assembled, program, serial, until
from tests.timeouts import TIMEOUT

if TYPE_CHECKING:
    from donnie_tui.robot.search import Connectable

pytestmark = pytest.mark.slow

# --- running


def test_a_program_runs_on_the_robot_and_prints_the_usual_lines(tmp_path: Path, robot: PtyBoard) -> None:
    file = program(tmp_path, "FW 2\nTR 45\nSPEAK DISTANCE F\n")

    done = donnie(tmp_path, "run", file, *serial(robot), *QUIET, "--events", "events.jsonl")
    assert done.stdout.decode().splitlines() == [
        "I walked 2 steps forward.",
        "I turned 45 degrees to the right.",
        "60",
    ]
    assert done.returncode == 0
    assert not robot.board.is_driving
    events = [json.loads(line) for line in (tmp_path / "events.jsonl").read_text().splitlines()]
    assert [each["state"] for each in events if each["event"] == "link"] == ["connected"]
    assert [each["event"] for each in events[:3]] == ["link", "announced", "run_started"]
    assert [each["t"] for each in events[:2]] == [0.0, 0.0]
    times = [each["t"] for each in events[2:]]
    assert times == sorted(times)


def test_a_lost_connection_ends_the_walk_and_nothing_continues_by_itself(robot: PtyBoard) -> None:
    donnie, heard = assembled(robot), list[Stamped]()
    donnie.session.hub.subscribe(heard.append)
    run = donnie.session.start("FW 100 FW 1", "test.gd", RunOptions(hooked=False))
    assert until(lambda: robot.board.is_driving)
    robot.unplug()
    assert run.wait(TIMEOUT)
    robot.plug()

    codes = lambda: [each.event.text for each in heard if hasattr(each.event, "text")]  # noqa: E731
    assert until(lambda: "The robot is back." in codes())
    assert any(text.startswith("Robot lost.") for text in codes())
    moved = [each.event for each in heard if isinstance(each.event, Moved)]
    assert [each.stopped_by.value for each in moved if each.stopped_by] == ["link"]
    assert not robot.board.is_driving
    donnie.close()


def test_a_robot_that_was_named_by_its_device_is_found_again_under_another_one(robot: PtyBoard) -> None:
    """``robot.path`` stays, as a name in by-id does. The device that it leads to differs each time."""
    device, names = os.path.realpath(robot.path), list[str]()
    settings = Settings(speech="off", sound=False)
    donnie, heard = assemble(settings, terminal=True), list[Stamped]()
    donnie.session.hub.subscribe(heard.append)
    connection = Connection(
        settings,
        donnie.words,
        donnie.world,
        donnie.session,
        stable=lambda port: names.append(port) or robot.path,
    )
    assert connection.connect(f"serial:{device}") == ()
    assert (names, connection.robot) == ([device], f"serial:{robot.path}")
    robot.unplug()
    assert until(lambda: any(isinstance(each.event, Link) and each.event.state == "lost" for each in heard))
    taken = [
        *os.openpty()
    ]  # so that its next device has another name; others on this machine take and leave names too
    while device not in map(os.ttyname, taken[1::2]) and len(taken) < 100:
        taken += os.openpty()
    robot.plug()

    assert os.path.realpath(robot.path) != device
    assert until(
        lambda: any(isinstance(each.event, Link) and each.event.state == "restored" for each in heard)
    )
    connection.close()
    donnie.close()
    for number in taken:
        os.close(number)


def test_a_program_started_during_the_search_for_a_robot_stops_where_there_is_none() -> None:
    """The full screen allows that. Afterwards the simulator is back, and not a robot without a connection."""

    class Meanwhile(Search):
        def connect(self, robot: Connectable) -> None:
            donnie.session.start("WHILE 1 == 1 DO\nVAR a = 1\nEND WHILE", "test.gd", RunOptions(fresh=True))
            super().connect(robot)

    settings = Settings(speech="off", sound=False, speed=None)
    donnie = assemble(settings, terminal=True)
    connection = Connection(settings, donnie.words, donnie.world, donnie.session, search=Meanwhile())
    said = connection.connect("serial:/dev/nothing")
    assert said[0].startswith("Nothing is plugged in at /dev/nothing.")
    assert connection.robot == "sim"

    run = donnie.session.start("FW 1", "test.gd")
    assert run.wait(TIMEOUT)
    assert donnie.session.pose.y == 1.0
    connection.close()
    donnie.close()


# --- several programs, one port


def test_a_port_has_one_program_at_a_time(tmp_path: Path, robot: PtyBoard) -> None:
    first = start(tmp_path, "run", program(tmp_path, LONG_WALK), *serial(robot), *QUIET)
    assert until(lambda: robot.board.is_driving)

    second = donnie(tmp_path, "run", program(tmp_path, "FW 1"), *serial(robot), *QUIET)
    assert second.returncode == 2
    assert second.stderr.decode() == (
        f"Another program uses {robot.path}. Perhaps another Donnie uses it. Leave that one first.\n"
    )
    stop = donnie(tmp_path, "stop", robot.path)
    assert stop.returncode == 1
    assert "another program uses" in stop.stdout.decode()
    first.send_signal(signal.SIGTERM)
    first.wait(TIMEOUT)


# --- devices, and a robot that is not there


def test_devices_lists_the_answering_devices_and_how_to_use_them(tmp_path: Path, robot: PtyBoard) -> None:
    done = donnie(tmp_path, "devices", robot.path, "/dev/there-is-nothing")

    assert done.stdout.decode().splitlines() == [
        "I ask 2 ports. That restarts a board on USB.",
        f"{robot.path}: robot, original firmware, battery 8.0 volts.",
        f"Drive it: donnie --robot serial:{robot.path}",
        "Nothing is plugged in at /dev/there-is-nothing.",
    ]
    assert done.returncode == 2


@pytest.mark.parametrize(
    ("language", "sentence"),
    [
        ("en", "Nothing is plugged in at /dev/nothing."),
        ("pt", "Não há nada conectado em /dev/nothing."),
        ("es", "No hay nada conectado en /dev/nothing."),
    ],
)
def test_a_missing_robot_is_reported(tmp_path: Path, language: str, sentence: str) -> None:
    file = program(tmp_path, "FW 1")
    done = donnie(tmp_path, "run", file, "--robot", "serial:/dev/nothing", "--lang", language)

    assert done.returncode == 2
    assert done.stderr.decode() == f"{sentence}\n"


def test_a_front_end_continues_with_the_simulator(tmp_path: Path) -> None:
    options = ("--linear", "--robot", "serial:/dev/nothing", *QUIET)
    done = donnie(tmp_path, *options, typed="FW 1\nRUN\nQUIT\n")

    lines = done.stdout.decode().splitlines()
    assert "Nothing is plugged in at /dev/nothing." in lines
    assert "I will use the simulator. CONNECT tries again." in lines
    assert "I walked 1 step forward." in lines


def test_the_learner_changes_to_another_robot_and_finds_it_again_the_next_time(tmp_path: Path) -> None:
    typed = "CONNECT\nCONNECT 2\nFW 1\nRUN\nQUIT\n"
    done = donnie(tmp_path, "--linear", "--speed", "max", *QUIET, typed=typed)

    lines = done.stdout.decode().splitlines()
    assert "1: the simulator, in use now." in lines
    assert "2: a simulated board, to try without a robot." in lines
    assert "Robot connected." in lines
    assert "I walked 1 step forward." in lines
    settings = next((tmp_path / "config").rglob("*.toml"))
    assert settings.read_text() == 'robot = "double"\n'


def test_the_pose_of_a_real_robot_begins_where_its_world_says(robot: PtyBoard) -> None:
    settings = Settings(robot=f"serial:{robot.path}", world="living_room", speech="off", sound=False)
    donnie, heard = assemble(settings, terminal=False), list[Stamped]()
    try:
        began = donnie.world.start()
        donnie.session.hub.subscribe(heard.append)
        assert donnie.session.start("FW 0", "test.gd", RunOptions(fresh=True, hooked=False)).wait(TIMEOUT)
    finally:
        donnie.close()

    ended = [each.event.pose for each in heard if isinstance(each.event, RunEnded)]
    assert ended == [Pose(began.x, began.y, began.heading)]


# --- reported at once


def test_events_of_the_robot_are_printed_in_the_middle_of_a_typed_line(
    tmp_path: Path, robot: PtyBoard
) -> None:
    learner = Learner(tmp_path, *serial(robot))
    learner.sees("Linear mode, from the option.\r\nI am looking for the robot. Please wait.\r\n")
    learner.sees("Robot connected.")
    learner.sees_prompt()
    learner.types("WHE")
    learner.sees("WHE")
    robot.unplug()
    learner.sees("Robot lost. If it moves, switch it off.\r\n> WHE")
    robot.plug()
    learner.sees("The robot is back.\r\n> WHE")
    learner.types("RE\r")
    learner.sees("Facing north.")
    robot.board.millivolts = 6800
    learner.sees("The robot's battery is low.\r\n> ")
    learner.types("QUIT\r")

    assert learner.leaves() == 0


def test_a_missing_robot_is_reported_before_any_line_is_typed(tmp_path: Path) -> None:
    learner = Learner(tmp_path, "--robot", "serial:/dev/nothing")

    learner.sees("Nothing is plugged in at /dev/nothing.\r\n")
    learner.sees("I will use the simulator. CONNECT tries again.\r\n> ")
