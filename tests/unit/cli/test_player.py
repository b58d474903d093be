"""``donnie player`` as a command: what it says, and how it ends."""

import signal
import socket
import subprocess
import sys
from pathlib import Path

import pytest

from tests.free_ports import free_port
from tests.player.room import CONFIGURATION, WORLD, write_room
from tests.timeouts import TIMEOUT


def command(*arguments: str) -> list[str]:
    return [sys.executable, "-m", "donnie_tui", "player", *arguments, "--lang", "en"]


def test_it_says_where_it_listens_and_a_signal_ends_it(tmp_path: Path) -> None:
    one, other = free_port(), free_port()
    text = CONFIGURATION.replace("7665", str(one)).replace("7666", str(other))
    file = write_room(tmp_path, text)
    with subprocess.Popen(command(str(file)), stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        line = process.stdout.readline()
        with socket.create_connection(("127.0.0.1", one), TIMEOUT) as client:
            assert client.recv(32).startswith(b"Player v.")
        process.send_signal(signal.SIGTERM)
        code = process.wait(TIMEOUT)

    assert line == f"Programs can connect to 127.0.0.1, port {one}, {other}.\n"
    assert code == 0


def test_a_taken_port_is_named(tmp_path: Path) -> None:
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        taken.listen()
        port = taken.getsockname()[1]
        file = write_room(
            tmp_path,
            CONFIGURATION.replace("7665:", "")
            .replace("7666:", "")
            .replace('driver ( name "stage" model "bob" provides [ "position2d:0" "ranger:0" ] )', ""),
        )
        done = subprocess.run(
            command(str(file), "--port", str(port)),
            capture_output=True,
            text=True,
            check=False,
            timeout=TIMEOUT,
        )

    assert done.returncode == 2
    assert f"Port {port} can't be used: another program uses it." in done.stderr.splitlines()


@pytest.mark.parametrize(
    ("name", "text", "said"),
    [
        ("a.cfg", 'driver ( name "stage" model "alice" provides [ "position2d:0" ] )', "world"),
        (
            "b.cfg",
            CONFIGURATION.replace("ranger:1", "ranger:0"),
            "Two devices have the address 7665:ranger:0.",
        ),
    ],
)
def test_a_file_that_does_not_fit_is_refused(tmp_path: Path, name: str, text: str, said: str) -> None:
    (tmp_path / "room.world").write_text(WORLD, encoding="utf-8")
    (tmp_path / name).write_text(text, encoding="utf-8")
    done = subprocess.run(
        command(str(tmp_path / name)), capture_output=True, text=True, check=False, timeout=TIMEOUT
    )

    assert done.returncode == 2
    assert said in done.stderr


def test_another_address_than_that_of_this_machine_is_said_to_be_open(tmp_path: Path) -> None:
    one, other = free_port(), free_port()
    text = CONFIGURATION.replace("7665", str(one)).replace("7666", str(other))
    arguments = command(str(write_room(tmp_path, text)), "--host", "0.0.0.0")
    with subprocess.Popen(arguments, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        lines = [process.stdout.readline() for _ in range(2)]
        process.send_signal(signal.SIGINT)
        code = process.wait(TIMEOUT)

    assert lines == [
        "Every program that reaches this address can drive the robots. No password protects it.\n",
        f"Programs can connect to 0.0.0.0, port {one}, {other}.\n",
    ]
    assert code == 0
