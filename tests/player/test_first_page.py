"""The first page of the manual: ``donnie_player`` in one terminal, ``GoDonnie -t`` in another."""

import os
import signal
import socket
import subprocess
import sys
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from pathlib import Path

import pytest

from donnie_tui.robot.search import running_server
from tests.free_ports import free_port
from tests.player.room import HOST, ServedRoom
from tests.player.test_player_robot import SCENE, SERVED
from tests.timeouts import TIMEOUT


def command(name: str, *arguments: str) -> list[str]:
    code = f"import sys; from donnie_tui.__main__ import {name}; sys.exit({name}())"
    return [sys.executable, "-c", code, *arguments, "--lang", "en"]


@contextmanager
def donnie_player(port: int) -> Iterator[list[str]]:
    """What it printed, once it has ended."""
    arguments, printed = command("donnie_player", "--port", str(port)), list[str]()
    process = subprocess.Popen(arguments, stdout=subprocess.PIPE, text=True)
    assert process.stdout is not None
    assert process.stdout.readline() == f"Programs can connect to {HOST}, port {port}.\n"
    try:
        yield printed
    finally:
        process.send_signal(signal.SIGTERM)
        printed += process.stdout.read().splitlines()
        process.wait(TIMEOUT)
    assert process.returncode == 0


def godonnie(environment: dict[str, str], *arguments: str, typed: str = "") -> list[str]:
    """What it prints."""
    done = subprocess.run(
        command("godonnie", *arguments),
        input=typed,
        env={**os.environ, **environment},
        capture_output=True,
        text=True,
        check=False,
        timeout=TIMEOUT,
    )
    assert done.returncode == 0, done.stderr
    return done.stdout.splitlines()


@pytest.mark.slow
def test_godonnie_drives_the_robot_of_donnie_player(tmp_path: Path) -> None:
    program = tmp_path / "turn.gd"
    program.write_text('TR 90 SPEAK POS A SPEAK "adeus"', encoding="utf-8")
    port = free_port()
    here = {"DONNIE_PORT": str(port)}
    with donnie_player(port) as said:
        typed = godonnie(here, "-t", "-m", typed='FW 2\nSPEAK "olá"\nrun\nwhere\nquit\n')
        run = godonnie(here, "-f", str(program), "-m")

    assert "Robot connected." in typed
    assert typed[-4:] == ["I walked 2 steps forward.", "olá", "Position 0, 2. Facing north.", "Goodbye."]
    assert run[-3:] == ["I turned 90 degrees to the right.", "90", "adeus"]
    assert said == ["Ctrl+C ends it.", "donnie says: olá", "donnie says: 90", "donnie says: adeus"]


@pytest.mark.slow
def test_without_a_server_godonnie_has_the_simulator() -> None:
    typed = godonnie({"DONNIE_PORT": str(free_port())}, "-t", "-m", typed="FW 1\nrun\nquit\n")

    assert typed[-2:] == ["I walked 1 step forward.", "Goodbye."]
    assert "Robot connected." not in typed


@pytest.mark.slow
def test_a_server_that_was_named_and_is_not_there_is_said_to_be_missing() -> None:
    port = free_port()
    typed = godonnie({"DONNIE_IP": HOST, "DONNIE_PORT": str(port)}, "-t", typed="quit\n")

    assert any(f"No robot answers at player://{HOST}:{port}" in line for line in typed)
    assert "I will use the simulator. CONNECT tries again." in typed


def test_a_server_that_runs_is_found_and_another_program_is_none(tmp_path: Path) -> None:
    with socket.create_server((HOST, 0)) as other, ThreadPoolExecutor(1) as thread:
        greeting = thread.submit(lambda: other.accept()[0].sendall(b"SSH-2.0-x\r\n"))
        assert running_server({"DONNIE_PORT": str(other.getsockname()[1])}) is None
        greeting.result(10)
    assert running_server({"DONNIE_PORT": str(free_port())}) is None
    room = ServedRoom(tmp_path, SERVED, SCENE)
    try:
        assert running_server({"DONNIE_PORT": str(room.port)}) == f"player://{HOST}:{room.port}"
    finally:
        room.close()
    assert running_server({"DONNIE_IP": "robot.local"}) == "player://robot.local:6665"
    assert running_server({"DONNIE_IP": "no such name", "DONNIE_PORT": "x"}) is None
