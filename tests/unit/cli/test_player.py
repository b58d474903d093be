"""``donnie player`` as a command: what it says, and how it ends."""

import signal
import socket
import subprocess
import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from types import FrameType

import pytest

from donnie_tui.cli import front_end
from donnie_tui.cli.main import main
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


def test_a_signal_may_come_while_it_begins_to_wait(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Its handler interrupts the main thread anywhere: it must need no lock that the wait holds."""
    text = CONFIGURATION.replace("7665", str(free_port())).replace("7666", str(free_port()))
    file = write_room(tmp_path, text)
    handlers: list[Callable[[], None]] = []
    are_stuck: list[bool] = []

    @contextmanager
    def taken(handler: Callable[[], None]) -> Iterator[None]:
        """Begins to look at the main thread once the command takes signals."""
        handlers.append(handler)
        later = threading.Timer(0.5, handler)
        later.start()
        before = sys.gettrace()
        sys.settrace(look)
        try:
            yield
        finally:
            sys.settrace(before)
            later.cancel()

    def look(frame: FrameType, _event: str, _argument: object) -> None:
        if frame.f_code is threading.Condition.wait.__code__ and _is_of_the_command(frame):
            handling = threading.Thread(target=handlers[0], daemon=True)
            handling.start()
            handling.join(TIMEOUT)
            are_stuck.append(handling.is_alive())

    monkeypatch.setattr(front_end, "on_signals", taken)

    assert main(["player", str(file), "--lang", "en", "--speech", "off"]) == 0
    assert len(handlers) == 1
    assert not any(are_stuck)


def _is_of_the_command(frame: FrameType | None) -> bool:
    """Whether the command itself waits there, and not what it puts together."""
    names: list[str] = []
    while frame is not None and frame.f_code.co_name != "serve_clients":
        names.append(frame.f_code.co_name)
        frame = frame.f_back
    return set(names) == {"wait"}


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
