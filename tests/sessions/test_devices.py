"""The real command and a real line: a pseudo terminal with the simulated board of a robot at its other end.

Whatever ends the program, the board is told to stop.
"""

from __future__ import annotations

import contextlib
import json
import os
import signal
import subprocess
import sys
import termios
import threading
import time
import tty
from collections.abc import Callable, Iterator
from itertools import cycle
from pathlib import Path

import pexpect
import pytest

from devices.belt.board import BeltBoard
from devices.firmware_double.board import SimulatedBoard
from devices.firmware_double.on_pty import DoubleOnPty
from devices.ports.robot import Pose
from devices.serial_port import PortFault, PortProblem
from devices.wire.commands import STOP
from donnie_tui.bootstrap import Donnie, assemble
from donnie_tui.core.events import CueSounded, Link, Moved, Outcome, RunEnded, Stamped
from donnie_tui.robot.connection import Connection
from donnie_tui.settings.chosen import Settings
from tests.patience import PATIENCE
from tests.sessions.command import COMMAND, QUIET, donnie, end, environment, start
from tests.sessions.learner import Learner
from tests.sessions.test_double import world as near_world

LONG_WALK = "FW 100\n"


@pytest.fixture
def robot() -> Iterator[DoubleOnPty]:
    with DoubleOnPty(SimulatedBoard(boot_loader=0.1)) as double:
        yield double


def until(is_met: Callable[[], bool]) -> bool:
    """Wait for it, looking often."""
    ends = time.monotonic() + PATIENCE
    while not is_met() and time.monotonic() < ends:
        time.sleep(0.005)
    return is_met()


def program(folder: Path, text: str) -> str:
    file = folder / "program.gd"
    file.write_text(text, encoding="utf-8")
    return str(file)


def serial(robot: DoubleOnPty) -> tuple[str, ...]:
    return "--robot", f"serial:{robot.path}"


# --- running


def test_a_program_runs_on_the_robot_and_is_told_as_ever(tmp_path: Path, robot: DoubleOnPty) -> None:
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


ENDING = [signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGQUIT]


@pytest.mark.parametrize("number", ENDING, ids=lambda each: each.name)
def test_a_signal_stops_the_robot(tmp_path: Path, robot: DoubleOnPty, number: signal.Signals) -> None:
    process = start(tmp_path, "run", program(tmp_path, LONG_WALK), *serial(robot), *QUIET)
    assert until(lambda: robot.board.is_driving)
    process.send_signal(number)

    assert until(lambda: not robot.board.is_driving)
    assert process.wait(PATIENCE) == 130
    assert robot.heard.endswith(STOP)


@pytest.mark.parametrize("number", ENDING, ids=lambda each: each.name)
def test_a_signal_while_connecting_ends_it_with_a_stop(
    tmp_path: Path, robot: DoubleOnPty, number: signal.Signals
) -> None:
    robot.board.is_mute = True
    process = start(tmp_path, "run", program(tmp_path, LONG_WALK), *serial(robot), *QUIET)
    assert until(lambda: bool(robot.heard))
    process.send_signal(number)

    assert process.communicate(timeout=PATIENCE) == (b"", b"")
    assert process.returncode == 130
    assert until(lambda: robot.heard.endswith(STOP))


def is_suspended(pid: int) -> bool:
    _, status = os.waitpid(pid, os.WUNTRACED)
    return os.WIFSTOPPED(status)


def test_control_z_stops_the_robot_before_the_run_rests(tmp_path: Path, robot: DoubleOnPty) -> None:
    process = start(tmp_path, "run", program(tmp_path, LONG_WALK), *serial(robot), *QUIET)
    assert until(lambda: robot.board.is_driving)
    process.send_signal(signal.SIGTSTP)
    assert is_suspended(process.pid)
    assert until(lambda: not robot.board.is_driving)
    process.send_signal(signal.SIGCONT)

    _, said = process.communicate(timeout=PATIENCE)
    assert process.returncode == 130
    assert "You left with Ctrl+Z, so I stopped the robot." in said.decode().splitlines()


def test_control_z_stops_the_robot_of_the_linear_mode(tmp_path: Path, robot: DoubleOnPty) -> None:
    learner = Learner(tmp_path, *serial(robot), program(tmp_path, LONG_WALK))
    learner.sees("Robot connected.")
    learner.sees_prompt()
    learner.types("RUN\r")
    assert until(lambda: robot.board.is_driving)
    learner.child.kill(signal.SIGTSTP)
    assert is_suspended(learner.child.pid)
    assert until(lambda: not robot.board.is_driving)
    learner.child.kill(signal.SIGCONT)
    learner.sees("You left with Ctrl+Z, so I stopped the robot.")
    learner.sees("Stopped")


def half_a_frame(robot: DoubleOnPty) -> None:
    """The board takes what is said next for the rest of fifty bytes, the stops as well."""
    robot.disturb(bytes.fromhex("aabb3228"))


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM], ids=lambda each: each.name)
def test_a_run_leaves_no_robot_that_half_a_frame_keeps_from_hearing_the_stop(
    tmp_path: Path, robot: DoubleOnPty, number: signal.Signals
) -> None:
    """Nor does an impatient second signal."""
    process = start(tmp_path, "run", program(tmp_path, LONG_WALK), *serial(robot), *QUIET)
    assert until(lambda: robot.board.is_driving)
    half_a_frame(robot)
    process.send_signal(number)
    assert until(lambda: STOP + STOP in robot.heard)
    process.send_signal(number)

    assert process.wait(PATIENCE) == 130
    assert not robot.board.is_driving


def test_a_run_that_rests_leaves_no_robot_that_half_a_frame_keeps_from_hearing_the_stop(
    tmp_path: Path, robot: DoubleOnPty
) -> None:
    process = start(tmp_path, "run", program(tmp_path, LONG_WALK), *serial(robot), *QUIET)
    assert until(lambda: robot.board.is_driving)
    half_a_frame(robot)
    process.send_signal(signal.SIGTSTP)

    assert is_suspended(process.pid)
    assert not robot.board.is_driving
    process.kill()
    process.communicate()


@pytest.mark.parametrize(
    "number", [signal.SIGHUP, signal.SIGTERM, signal.SIGTSTP], ids=lambda each: each.name
)
def test_the_linear_mode_leaves_no_robot_that_half_a_frame_keeps_from_hearing_the_stop(
    tmp_path: Path, robot: DoubleOnPty, number: signal.Signals
) -> None:
    learner = Learner(tmp_path, *serial(robot), program(tmp_path, LONG_WALK))
    learner.sees("Robot connected.")
    learner.sees_prompt()
    learner.types("RUN\r")
    assert until(lambda: robot.board.is_driving)
    half_a_frame(robot)
    learner.child.kill(number)

    if number is signal.SIGTSTP:
        assert is_suspended(learner.child.pid)
        assert not robot.board.is_driving
        learner.child.kill(signal.SIGKILL)
    else:
        learner.leaves()
        assert not robot.board.is_driving


@contextlib.contextmanager
def terminal_that_takes_nothing(child: pexpect.spawn) -> Iterator[None]:
    """As after Ctrl+S, or over a network that hangs."""
    terminal = os.open(Path(f"/proc/{child.pid}/fd/1").readlink(), os.O_RDWR | os.O_NOCTTY)
    termios.tcflow(terminal, termios.TCOOFF)
    try:
        yield
    finally:
        termios.tcflow(terminal, termios.TCOON)
        os.close(terminal)


def is_stuck(child: pexpect.spawn) -> Callable[[], bool]:
    """Whether a thread of it waits for the terminal."""
    waits = ("tty", "wait_woken", "n_tty_write")
    threads = Path(f"/proc/{child.pid}/task")
    return lambda: any(_place(each) in waits for each in threads.iterdir())


def _place(thread: Path) -> str:
    """Where in the kernel a thread waits; nowhere once it has ended."""
    try:
        return (thread / "wchan").read_text()
    except OSError:
        return ""


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM], ids=lambda each: each.name)
def test_a_run_whose_news_nobody_reads_stops_its_robot_and_ends(
    tmp_path: Path, robot: DoubleOnPty, number: signal.Signals
) -> None:
    """Whoever prints the news hangs, the run as well, and the board is in the middle of half a frame."""
    run = pexpect.spawn(
        sys.executable,
        [*COMMAND[1:], "run", program(tmp_path, "FW 300\n"), *serial(robot), *QUIET],
        env=environment(tmp_path),
        cwd=str(tmp_path),
        timeout=PATIENCE,
    )
    assert until(lambda: robot.board.is_driving)
    with terminal_that_takes_nothing(run):
        robot.board.millivolts = 6000
        assert until(is_stuck(run))
        half_a_frame(robot)
        run.kill(number)

        assert until(lambda: not run.isalive())
        assert not robot.board.is_driving
    assert run.exitstatus == 130


def test_control_z_stops_the_robot_of_the_linear_mode_although_its_terminal_takes_nothing(
    tmp_path: Path, robot: DoubleOnPty
) -> None:
    learner = Learner(tmp_path, *serial(robot), program(tmp_path, "FW 300\n"))
    learner.sees("Robot connected.")
    learner.sees_prompt()
    learner.types("RUN\r")
    assert until(lambda: robot.board.is_driving)
    with terminal_that_takes_nothing(learner.child):
        robot.board.millivolts = 6000
        assert until(is_stuck(learner.child))
        learner.child.kill(signal.SIGTSTP)

        assert until(lambda: not robot.board.is_driving)
    assert is_suspended(learner.child.pid)
    learner.child.kill(signal.SIGCONT)
    learner.sees("You left with Ctrl+Z, so I stopped the robot.")


PAINT_ANEW = "\x0b\x1b[15~"
"""The keys for it: all of the screen is more than a terminal keeps; a robot that walks changes few cells."""


def is_full(screen: pexpect.spawn) -> Callable[[], bool]:
    """Whether a thread of it waits for the terminal in most looks, but for what a signal wakes it."""
    is_waiting, looks = is_stuck(screen), list[bool]()

    def look() -> bool:
        if len(looks) % 50 == 0:
            screen.send(PAINT_ANEW)
        looks.append(is_waiting())
        return len(looks) > 50 and sum(looks[-50:]) > 40

    return look


def unread_screen(folder: Path, robot: DoubleOnPty) -> pexpect.spawn:
    """The full screen, its robot driving, at a terminal whose output nobody reads from then on."""
    screen = pexpect.spawn(
        sys.executable,
        [*COMMAND[1:], "--visual", *serial(robot), *QUIET, program(folder, "FW 1000\n")],
        env=environment(folder, {"TERM": "xterm-256color"}),
        cwd=str(folder),
        dimensions=(60, 200),
        timeout=PATIENCE,
    )
    assert until(lambda: robot.board.is_configured)
    screen.expect("onnected")
    screen.send("\x1b[15~")
    assert until(lambda: (read(screen), robot.board.is_driving)[1])
    assert until(is_full(screen))
    return screen


def read(screen: pexpect.spawn) -> bytes:
    """What waits to be read."""
    try:
        return screen.read_nonblocking(65536, timeout=0)
    except pexpect.TIMEOUT:
        return b""


def test_a_screen_that_takes_nothing_stops_the_robot_by_itself(tmp_path: Path, robot: DoubleOnPty) -> None:
    """Although one signal after the other comes."""
    screen = unread_screen(tmp_path, robot)
    widths = cycle((200, 199))

    assert until(lambda: (screen.setwinsize(60, next(widths)), not robot.board.is_driving)[1])
    assert screen.isalive()
    screen.kill(signal.SIGKILL)


@pytest.mark.parametrize(
    "number", [signal.SIGTERM, signal.SIGHUP, signal.SIGQUIT], ids=lambda each: each.name
)
def test_a_signal_ends_a_screen_that_takes_nothing(
    tmp_path: Path, robot: DoubleOnPty, number: signal.Signals
) -> None:
    screen = unread_screen(tmp_path, robot)
    screen.kill(number)

    assert until(lambda: not robot.board.is_driving)
    assert until(lambda: not screen.isalive())
    assert robot.heard.endswith(STOP)


@pytest.mark.parametrize(
    "number", [signal.SIGTERM, signal.SIGHUP, signal.SIGQUIT], ids=lambda each: each.name
)
@pytest.mark.parametrize("mode", ["--linear", "--visual"])
def test_a_signal_to_a_front_end_stops_the_robot(
    tmp_path: Path, robot: DoubleOnPty, mode: str, number: signal.Signals
) -> None:
    front_end = pexpect.spawn(
        sys.executable,
        [*COMMAND[1:], mode, *serial(robot), *QUIET, program(tmp_path, LONG_WALK)],
        env=environment(tmp_path, {"TERM": "xterm-256color"}),
        cwd=str(tmp_path),
        dimensions=(24, 80),
        timeout=PATIENCE,
    )
    drained = threading.Thread(target=front_end.expect, args=(pexpect.EOF,), daemon=True)
    assert until(lambda: robot.board.is_configured)
    front_end.expect("onnected")
    front_end.send("\x1b[15~" if mode == "--visual" else "RUN\r")
    drained.start()
    assert until(lambda: robot.board.is_driving)
    front_end.kill(number)

    assert until(lambda: not robot.board.is_driving)
    drained.join(PATIENCE)
    assert robot.heard.endswith(STOP)


def test_a_killed_program_leaves_a_robot_that_donnie_stop_halts(tmp_path: Path, robot: DoubleOnPty) -> None:
    process = start(tmp_path, "run", program(tmp_path, LONG_WALK), *serial(robot), *QUIET)
    assert until(lambda: robot.board.is_driving)
    process.kill()
    process.wait(PATIENCE)
    assert robot.board.is_driving

    done = donnie(tmp_path, "stop", robot.path)
    assert done.stdout.decode() == f"The robot stands. Port {robot.path}.\n"
    assert done.returncode == 0
    assert not robot.board.is_driving


def assembled(robot: DoubleOnPty) -> Donnie:
    settings = Settings(robot=f"serial:{robot.path}", speech="off", sound=False)
    return assemble(settings, terminal=False)


def test_a_listener_that_fails_in_the_middle_of_a_walk_stops_the_robot(robot: DoubleOnPty) -> None:
    donnie = assembled(robot)

    def fail(stamped: Stamped) -> None:
        if isinstance(stamped.event, CueSounded) and stamped.event.name == "step-forward":
            raise ZeroDivisionError("a fault of ours")

    try:
        donnie.session.hub.subscribe(fail)
        run = donnie.session.start("FW 100", "test.gd", hooked=False)
        assert until(lambda: robot.board.is_driving)
        assert run.wait(PATIENCE)

        assert run.outcome is Outcome.FAILED
        assert until(lambda: not robot.board.is_driving)
    finally:
        donnie.close()


def test_closing_stops_what_runs(robot: DoubleOnPty) -> None:
    donnie = assembled(robot)
    donnie.session.start("FW 100", "test.gd", hooked=False)
    assert until(lambda: robot.board.is_driving)
    donnie.close()

    assert until(lambda: not robot.board.is_driving)
    assert robot.heard.endswith(STOP)


def test_a_line_that_is_lost_ends_the_walk_and_nothing_goes_on_by_itself(robot: DoubleOnPty) -> None:
    donnie, heard = assembled(robot), list[Stamped]()
    donnie.session.hub.subscribe(heard.append)
    run = donnie.session.start("FW 100 FW 1", "test.gd", hooked=False)
    assert until(lambda: robot.board.is_driving)
    robot.unplug()
    assert run.wait(PATIENCE)
    robot.plug()

    codes = lambda: [each.event.text for each in heard if hasattr(each.event, "text")]  # noqa: E731
    assert until(lambda: "Robot is back." in codes())
    assert any(text.startswith("Robot lost.") for text in codes())
    moved = [each.event for each in heard if isinstance(each.event, Moved)]
    assert [each.stopped_by.value for each in moved if each.stopped_by] == ["link"]
    assert not robot.board.is_driving
    donnie.close()


def test_a_robot_that_was_named_by_its_device_is_found_again_under_another_one(robot: DoubleOnPty) -> None:
    """``robot.path`` stays, as a name in by-id does; what it leads to is another one each time."""
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
    taken = os.openpty()  # so that its next device has another name
    robot.plug()

    assert os.path.realpath(robot.path) != device
    assert until(
        lambda: any(isinstance(each.event, Link) and each.event.state == "restored" for each in heard)
    )
    connection.close()
    donnie.close()
    for number in taken:
        os.close(number)


# --- looking for a robot that does not answer


@pytest.fixture
def mute_port() -> Iterator[str]:
    """A port at which nobody ever answers: looking for a robot takes seconds there."""
    ours, theirs = os.openpty()
    tty.setraw(theirs)
    yield os.ttyname(theirs)
    os.close(ours)
    os.close(theirs)


def at_terminal(folder: Path, *arguments: str) -> pexpect.spawn:
    return pexpect.spawn(
        sys.executable,
        [*COMMAND[1:], *arguments],
        env=environment(folder, {"TERM": "xterm-256color"}),
        cwd=str(folder),
        dimensions=(24, 80),
        timeout=PATIENCE,
    )


@pytest.mark.parametrize(
    ("command", "announced"),
    [("devices {}", "I ask 1 port"), ("calibrate --robot serial:{}", "I connect")],
    ids=["devices", "calibrate"],
)
def test_control_c_ends_a_command_that_looks_for_a_robot(
    tmp_path: Path, mute_port: str, command: str, announced: str
) -> None:
    front_end = at_terminal(tmp_path, *command.format(mute_port).split())
    front_end.expect(announced)
    front_end.sendintr()
    front_end.expect(pexpect.EOF)

    assert "answers" not in front_end.before.decode()
    front_end.wait()
    front_end.close()
    assert front_end.exitstatus == 130


@pytest.mark.parametrize("keys", ["\x03", "\x1b[19~"], ids=["ctrl-c", "f8"])
def test_a_stop_key_gives_up_the_search_of_the_full_screen(tmp_path: Path, mute_port: str, keys: str) -> None:
    front_end = at_terminal(tmp_path, "--visual", *QUIET, "--robot", f"serial:{mute_port}")
    front_end.expect("I look for the robot")
    front_end.expect("I wait for the robot. Ctrl\\+C gives up.")
    front_end.send("SPEAK 12")
    front_end.send(keys)
    front_end.expect("I no longer look for the robot")
    front_end.expect("I use the simulator instead")
    front_end.send("\x11")
    front_end.expect("is not saved")  # what was typed meanwhile is there
    end(front_end)


@pytest.mark.parametrize("moment", ["at the start", "by a word"])
def test_control_c_gives_up_the_search_of_the_linear_mode(
    tmp_path: Path, mute_port: str, moment: str
) -> None:
    learner = Learner(tmp_path, "--robot", f"serial:{mute_port}")
    for _ in range(1 if moment == "at the start" else 2):
        learner.sees("I look for the robot, some seconds.")
        learner.sees("I wait for the robot. Ctrl+C gives up.")
        learner.child.sendintr()
        learner.sees("I no longer look for the robot.")
        learner.sees("I use the simulator instead. CONNECT tries again.")
        learner.sees_prompt()
        learner.types("WHERE\r")
        learner.sees("north")
        learner.sees_prompt()
        learner.types("CONNECT 2\r")


def test_a_signal_ends_a_front_end_that_looks_for_a_robot(tmp_path: Path, mute_port: str) -> None:
    for mode, announced in (("--linear", "I look for"), ("--visual", "tarting")):
        front_end = at_terminal(tmp_path, mode, *QUIET, "--robot", f"serial:{mute_port}")
        front_end.expect(announced)
        front_end.kill(signal.SIGTERM)
        front_end.expect(pexpect.EOF)
        front_end.wait()
        front_end.close()

        assert "No robot answers" not in front_end.before.decode()
        assert "Traceback" not in front_end.before.decode()
        assert front_end.exitstatus == 128 + signal.SIGTERM


# --- several programs, one port


def test_a_port_has_one_program_at_a_time(tmp_path: Path, robot: DoubleOnPty) -> None:
    first = start(tmp_path, "run", program(tmp_path, LONG_WALK), *serial(robot), *QUIET)
    assert until(lambda: robot.board.is_driving)

    second = donnie(tmp_path, "run", program(tmp_path, "FW 1"), *serial(robot), *QUIET)
    assert second.returncode == 2
    assert second.stderr.decode() == (
        f"Another program uses {robot.path}. Perhaps another Donnie runs. Leave it first.\n"
    )
    stop = donnie(tmp_path, "stop", robot.path)
    assert stop.returncode == 1
    assert "another program has" in stop.stdout.decode()
    first.send_signal(signal.SIGTERM)
    first.wait(PATIENCE)


# --- devices, and a robot that is not there


def test_devices_tells_what_answers_and_how_to_use_it(tmp_path: Path, robot: DoubleOnPty) -> None:
    done = donnie(tmp_path, "devices", robot.path, "/dev/there-is-nothing")

    assert done.stdout.decode().splitlines() == [
        "I ask 2 ports. A board on USB restarts by that.",
        f"{robot.path}: robot, original firmware, battery 8.0 volts.",
        f"Drive it: donnie --robot serial:{robot.path}",
        "Nothing is plugged in at /dev/there-is-nothing.",
    ]
    assert done.returncode == 2


@pytest.mark.parametrize(
    ("language", "sentence"),
    [
        ("en", "Nothing is plugged in at /dev/nothing."),
        ("pt", "Não há nada ligado em /dev/nothing."),
        ("es", "No hay nada conectado en /dev/nothing."),
    ],
)
def test_a_robot_that_is_not_there_is_told(tmp_path: Path, language: str, sentence: str) -> None:
    file = program(tmp_path, "FW 1")
    done = donnie(tmp_path, "run", file, "--robot", "serial:/dev/nothing", "--lang", language)

    assert done.returncode == 2
    assert done.stderr.decode() == f"{sentence}\n"


def test_a_front_end_goes_on_with_the_simulator(tmp_path: Path) -> None:
    options = ("--linear", "--robot", "serial:/dev/nothing", *QUIET)
    done = donnie(tmp_path, *options, typed="FW 1\nRUN\nQUIT\n")

    lines = done.stdout.decode().splitlines()
    assert "Nothing is plugged in at /dev/nothing." in lines
    assert "I use the simulator instead. CONNECT tries again." in lines
    assert "I walked 1 step forward." in lines


def test_the_learner_changes_to_another_robot_and_finds_it_again_the_next_time(tmp_path: Path) -> None:
    typed = "CONNECT\nCONNECT 2\nFW 1\nRUN\nQUIT\n"
    done = donnie(tmp_path, "--linear", "--speed", "max", *QUIET, typed=typed)

    lines = done.stdout.decode().splitlines()
    assert "1: the simulator, now." in lines
    assert "2: a simulated board, to try without a robot." in lines
    assert "Robot connected." in lines
    assert "I walked 1 step forward." in lines
    settings = next((tmp_path / "config").rglob("*.toml"))
    assert settings.read_text() == 'robot = "double"\n'


# --- calibrate


def test_a_calibration_finds_the_wheels_and_the_axle_that_the_robot_really_has(tmp_path: Path) -> None:
    """The board's wheels have a radius of 21 mm, its axle 68 mm; the settings believe something else."""
    config = tmp_path / "config" / "donnie"
    config.mkdir(parents=True)
    wrong = {"DONNIE_WHEEL_RADIUS": "0.024", "DONNIE_AXLE_LENGTH": "0.080"}
    # What a tape measure shows: 20 steps of 5 cm, by wheels that are smaller than believed.
    centimetres, degrees = 100 * 21 / 24, 720 * (21 / 24) * (80 / 68)

    typed = f"\n{centimetres:.2f}\n\n{degrees:.1f}\n"
    done = donnie(tmp_path, "calibrate", "--robot", "double", typed=typed, changes=wrong)
    assert done.returncode == 0
    settings = next((tmp_path / "config").rglob("*.toml")).read_text()
    found = dict(line.split(" = ") for line in settings.splitlines())
    assert float(found["wheel_radius"]) == pytest.approx(0.021, rel=0.01)
    assert float(found["axle_length"]) == pytest.approx(0.068, rel=0.01)


@pytest.mark.parametrize("typed", ["", "\n\n\n\n", "\nfar\n\n", "\n-3\n0\n\n\n\n"])
def test_where_nothing_is_measured_nothing_changes(tmp_path: Path, typed: str) -> None:
    done = donnie(tmp_path, "calibrate", "--robot", "double", typed=typed)

    assert done.returncode == 1
    assert done.stdout.decode().splitlines()[-1] == "Nothing was measured. Nothing has changed."
    assert not list((tmp_path / "config").rglob("*.toml"))


def calibration(tmp_path: Path, robot: DoubleOnPty) -> subprocess.Popen[bytes]:
    """In the middle of the walk."""
    process = subprocess.Popen(
        [*COMMAND, "calibrate", *serial(robot)],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        cwd=tmp_path,
        env=environment(tmp_path),
    )
    assert process.stdin is not None
    process.stdin.write(b"\n")
    process.stdin.flush()
    assert until(lambda: robot.board.is_driving)
    return process


def test_control_z_in_the_middle_of_a_calibration_stops_the_robot(tmp_path: Path, robot: DoubleOnPty) -> None:
    process = calibration(tmp_path, robot)
    process.send_signal(signal.SIGTSTP)
    assert is_suspended(process.pid)
    assert until(lambda: not robot.board.is_driving)
    process.send_signal(signal.SIGCONT)

    said, _ = process.communicate(b"", timeout=PATIENCE)
    assert "Something stopped it. I leave this out." in said.decode().splitlines()


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGQUIT], ids=lambda each: each.name)
def test_a_signal_in_the_middle_of_a_calibration_stops_the_robot(
    tmp_path: Path, robot: DoubleOnPty, number: signal.Signals
) -> None:
    process = calibration(tmp_path, robot)
    process.send_signal(number)

    assert until(lambda: not robot.board.is_driving)
    assert process.wait(PATIENCE) == 130


# --- the belt


def test_a_belt_that_is_missing_is_told_and_the_run_goes_on(tmp_path: Path) -> None:
    done = donnie(tmp_path, "run", program(tmp_path, "BELT ON\nFW 1\n"), "--belt", "/dev/nothing")

    assert done.stderr.decode() == "No belt at /dev/nothing: No such file or directory. I go on without.\n"
    assert done.stdout.decode() == "Belt on.\nI walked 1 step forward.\n"
    assert done.returncode == 0


def test_the_start_does_not_wait_for_a_belt_at_an_address_and_that_there_is_none_is_told(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    answers, told = threading.Event(), list[str]()

    def no_answer(port: str) -> None:
        assert answers.wait(PATIENCE)
        raise PortProblem(port, PortFault.UNUSABLE, "timed out")

    monkeypatch.setattr("devices.belt.line.open_line", no_answer)
    donnie = assemble(Settings(belt="socket://far:1", speech="off", sound=False), terminal=True)
    donnie.session.hub.subscribe(lambda stamped: told.append(getattr(stamped.event, "text", "")))
    answers.set()
    try:
        assert donnie.notices.all == ()
        assert until(lambda: told == ["No belt at socket://far:1: timed out. I go on without."])
    finally:
        donnie.close()


def test_robot_and_belt_may_not_have_the_same_port(tmp_path: Path, robot: DoubleOnPty) -> None:
    file = program(tmp_path, "FW 1")
    done = donnie(tmp_path, "run", file, *serial(robot), "--belt", robot.path)

    assert done.stderr.decode() == f"Robot and belt can't both be at {robot.path}.\n"
    assert done.returncode == 2


def test_the_robot_can_not_be_connected_at_the_port_of_the_belt(tmp_path: Path, robot: DoubleOnPty) -> None:
    donnie = assemble(Settings(belt=robot.path, speech="off", sound=False), terminal=True)
    try:
        told = donnie.connection.connect(f"serial:{robot.path}")
    finally:
        donnie.close()

    assert told == (
        f"Robot and belt can't both be at {robot.path}.",
        "I use the simulator instead. CONNECT tries again.",
    )


def test_the_belt_is_felt_during_a_run_and_dark_after_it(tmp_path: Path) -> None:
    ours, theirs = os.openpty()
    tty.setraw(ours)
    os.set_blocking(ours, False)
    program(tmp_path, "BELT ON\nWAIT 1\n")
    options = ("--world", near_world(tmp_path), "--belt", os.ttyname(theirs), "--speed", "5", *QUIET)
    process = start(tmp_path, "run", "program.gd", *options)
    board, felt = BeltBoard(), list[tuple[str, ...]]()

    def is_over() -> bool:
        has_ended = process.poll() is not None
        with contextlib.suppress(BlockingIOError):
            os.write(ours, board.feed(os.read(ours, 1000), 0.0))
            felt.append(board.motors(0.0))
            return False
        return has_ended

    assert until(is_over)
    os.close(ours)
    os.close(theirs)
    assert {"".join(motors) for motors in felt} >= {"PPPBPPP" * 2}
    assert felt[-1] == ("P",) * 14
    assert process.returncode == 0


@pytest.mark.parametrize(
    ("language", "typed", "told"),
    [
        ("en", "FEEL ON", "Belt: front medium."),
        ("pt", "SENTIR ligado", "Cinto: frente médio."),
        ("es", "sentir encendido", "Cinturón: frente medio."),
    ],
)
def test_who_has_no_belt_is_told_what_it_shows(tmp_path: Path, language: str, typed: str, told: str) -> None:
    options = ("--linear", "--world", near_world(tmp_path), "--lang", language, "--speed", "max", *QUIET)
    done = donnie(tmp_path, *options, typed=f"{typed}\nBELT ON\nFW 1\nRUN\nQUIT\n")

    lines = done.stdout.decode().splitlines()
    assert lines.index(told) > 0
    assert done.returncode == 0


def test_the_pose_of_a_real_robot_begins_where_its_world_says(robot: DoubleOnPty) -> None:
    settings = Settings(robot=f"serial:{robot.path}", world="living_room", speech="off", sound=False)
    donnie, heard = assemble(settings, terminal=False), list[Stamped]()
    try:
        began = donnie.world.start()
        donnie.session.hub.subscribe(heard.append)
        assert donnie.session.start("FW 0", "test.gd", fresh=True, hooked=False).wait(PATIENCE)
    finally:
        donnie.close()

    ended = [each.event.pose for each in heard if isinstance(each.event, RunEnded)]
    assert ended == [Pose(began.x, began.y, began.heading)]


# --- told at once


def test_what_happens_to_the_robot_is_told_in_the_middle_of_a_typed_line(
    tmp_path: Path, robot: DoubleOnPty
) -> None:
    learner = Learner(tmp_path, *serial(robot))
    learner.sees("Linear mode, from the option.\r\nI look for the robot, some seconds.\r\n")
    learner.sees("Robot connected.")
    learner.sees_prompt()
    learner.types("WHE")
    learner.sees("WHE")
    robot.unplug()
    learner.sees("Robot lost. If it drives, switch it off.\r\n> WHE")
    robot.plug()
    learner.sees("Robot is back.\r\n> WHE")
    learner.types("RE\r")
    learner.sees("Facing north.")
    robot.board.millivolts = 6800
    learner.sees("The robot's battery is low.\r\n> ")
    learner.types("QUIT\r")

    assert learner.leaves() == 0


def test_a_robot_that_is_missing_is_told_before_anything_is_typed(tmp_path: Path) -> None:
    learner = Learner(tmp_path, "--robot", "serial:/dev/nothing")

    learner.sees("Nothing is plugged in at /dev/nothing.\r\n")
    learner.sees("I use the simulator instead. CONNECT tries again.\r\n> ")
