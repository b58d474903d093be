"""Donnie at the other end of a real ssh: as at a local terminal, and safe when the connection is lost."""

from __future__ import annotations

import os
import signal
import subprocess
import threading
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path

import pexpect
import pytest

from devices.wire.frames import STOP
from tests.board_on_pty import PtyBoard
from tests.sessions.real_robot import LONG_WALK, program, serial, until
from tests.sessions.ssh_line import MISSING, SshLine
from tests.timeouts import TIMEOUT
from tests.unit.ssip.server import Server

pytestmark = [pytest.mark.slow, pytest.mark.skipif(MISSING is not None, reason=f"needs {MISSING}")]


@pytest.fixture
def line(tmp_path: Path) -> Iterator[SshLine]:
    made = SshLine(tmp_path)
    if refusal := made.refusal():
        pytest.skip(refusal)
    yield made
    for pid in made.donnies():
        with suppress(ProcessLookupError):
            os.kill(pid, signal.SIGKILL)


def over_ssh(line: SshLine, *arguments: str, typed: str = "") -> subprocess.CompletedProcess[bytes]:
    command = line.command(*arguments, terminal=False)
    return subprocess.run(command, input=typed.encode(), capture_output=True, timeout=TIMEOUT)


# --- the full screen


def test_the_first_row_of_the_full_screen_names_the_words_that_work_at_any_time(tmp_path: Path) -> None:
    """Nothing says whether the learner at the other end has a screen reader."""
    line = SshLine(tmp_path, reader="")
    if refusal := line.refusal():
        pytest.skip(refusal)
    learner = line.at_terminal("--plain")
    learner.expect_exact("Screen reader? Type LINEAR and Enter.")
    learner.expect_exact("Also: HELP, TOUR, RECOVER, QUIT.")  # what a first picture may not know yet
    learner.send("LINEAR\r")
    learner.expect_exact("Linear mode, from the word LINEAR.")
    learner.expect_exact("Always begin in linear mode, y or n? Enter means no.")
    learner.send("\r")
    learner.expect_exact("> ")
    learner.send("QUIT\r")
    learner.expect(pexpect.EOF)


# --- without a terminal


def test_a_program_from_home_runs_and_its_words_and_exit_code_come_home(line: SshLine) -> None:
    done = over_ssh(line, "run", "-", "--speed", "max", typed='FW 2\nSPEAK "olá"\nFX 1\n')
    assert done.stdout.decode().splitlines()[0] == "Error, line 3, column 1: I do not know FX."
    assert done.returncode == 1

    done = over_ssh(line, "run", "-", "--speed", "max", typed='FW 2\nSPEAK "olá"\n')
    assert done.stdout.decode() == "I walked 2 steps forward.\nolá\n"
    assert done.returncode == 0


def test_typed_lines_are_answered_without_a_terminal(line: SshLine) -> None:
    done = over_ssh(line, "--linear", "--speed", "max", typed="FW 2\nRUN\nWHERE\nQUIT\n")

    assert done.stdout.decode().splitlines()[2:] == [
        "I walked 2 steps forward.",
        "Position 0, 2. Facing north.",
        "Goodbye.",
    ]
    assert done.returncode == 0


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGKILL], ids=lambda each: each.name)
def test_the_end_of_ssh_stops_the_robot_of_a_run_without_a_terminal(
    line: SshLine, robot: PtyBoard, number: signal.Signals
) -> None:
    """Ctrl+C at home stays there: no signal reaches the robot's side."""
    command = line.command("run", program(line.folder, LONG_WALK), *serial(robot), terminal=False)
    ssh = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, start_new_session=True)
    assert until(lambda: robot.board.is_driving)
    ssh.send_signal(number)

    assert until(lambda: not robot.board.is_driving)
    assert until(lambda: not line.donnies())
    ssh.communicate(timeout=TIMEOUT)


# --- at a terminal


def test_a_program_is_typed_and_run_in_the_linear_mode(line: SshLine) -> None:
    learner = line.at_terminal("--linear", "--speed", "max")
    for typed in ("FW 2", "TR 45", "RUN"):
        learner.expect("> ")
        learner.send(f"{typed}\r")
    learner.expect_exact("I walked 2 steps forward.\r\nI turned 45 degrees to the right.\r\n> ")
    learner.send("QUIT\r")
    learner.expect(pexpect.EOF)
    learner.close()

    assert learner.exitstatus == 0


def test_control_c_goes_through_and_the_exit_code_comes_back(line: SshLine, robot: PtyBoard) -> None:
    learner = line.at_terminal("run", program(line.folder, LONG_WALK), *serial(robot))
    assert until(lambda: robot.board.is_driving)
    learner.send("\x03")
    learner.expect("I was stopped.")
    learner.expect(pexpect.EOF)
    learner.close()

    assert not robot.board.is_driving
    assert learner.exitstatus == 130


RUN = {"--linear": "RUN\r", "--visual": "\x1b[15~"}
"""How the typed program is started."""


@pytest.mark.parametrize("lost", ["ssh", "sshd"])
@pytest.mark.parametrize("mode", ["--linear", "--visual"])
def test_a_lost_connection_stops_the_robot_and_keeps_the_typed_program(
    line: SshLine, robot: PtyBoard, mode: str, lost: str
) -> None:
    learner = line.at_terminal(mode, *serial(robot))
    learner.expect("onnected")
    if mode == "--linear":
        learner.expect("> ")
    learner.send("FW 29\r")
    learner.expect("29")
    learner.send(RUN[mode])
    threading.Thread(target=learner.expect, args=(pexpect.EOF,), daemon=True).start()
    assert until(lambda: robot.board.is_driving)
    os.kill(learner.pid if lost == "ssh" else server_of(line), signal.SIGKILL)

    assert until(lambda: not robot.board.is_driving)
    assert until(lambda: not line.donnies())
    assert until(lambda: robot.received.endswith(STOP))

    again = line.at_terminal(mode, "--plain", "--speed", "max")
    again.expect("> |Command line")
    for typed, answer in (
        ("RECOVER", "Your program is back, 1 line."),
        ("RUN", "I walked 29 steps forward."),
    ):
        again.send(f"{typed}\r")
        again.expect_exact(answer)
    again.kill(signal.SIGKILL)


def server_of(line: SshLine) -> int:
    """The sshd that has the terminal's other end: the process that started Donnie.

    A process that Donnie is about to start looks like another Donnie for a moment.
    """
    donnie = min(line.donnies())
    return int(Path(f"/proc/{donnie}/stat").read_text().rpartition(")")[2].split()[1])


# --- speech forwarded home


@pytest.mark.parametrize("mode", ["--linear", "--visual"])
def test_speech_is_forwarded_home(line: SshLine, tmp_path: Path, mode: str) -> None:
    """The speech-dispatcher at home says the answers. Its loss is reported once and ends nothing."""
    server = Server(tmp_path)
    learner = line.at_terminal(mode, "--plain", "--speech", "ssip", speech_from=server.address.path)
    learner.expect("> |Command line")
    learner.send("WHERE\r")
    learner.expect("Facing north")
    assert until(lambda: "Position 0, 0." in server.texts)
    server.kill()

    def is_reported() -> bool:
        learner.send("WHERE\r")
        return learner.expect_exact(["speech-dispatcher is gone. All is in print.", pexpect.TIMEOUT], 1) == 0

    assert any(is_reported() for _ in range(TIMEOUT))
    for typed in ("AROUND", "QUIT"):
        learner.send(f"{typed}\r")
    learner.expect(pexpect.EOF)
    learner.close()
    left_behind = learner.before.rpartition(b"\x1b[?1049l")[2]
    assert left_behind.count(b"is gone") == (1 if mode == "--visual" else 0), "its log stays on the screen"
    assert learner.exitstatus == 0


# --- a class on one host


@pytest.fixture
def pupil(tmp_path: Path) -> Iterator[tuple[SshLine, Path]]:
    """A login whose only command is Donnie in the folder of a pupil, as docs/ssh.md says."""
    folder = tmp_path / "class" / "ana"
    folder.mkdir(parents=True)
    (folder.parent / "secret.gd").write_text("SPEAK 4711\n")
    (folder / "mine.gd").write_text("FW 2\n")
    (folder / "link.gd").symlink_to("../secret.gd")
    line = SshLine(tmp_path, forced=("--confined", str(folder)), by_key=True)
    if refusal := line.refusal():
        pytest.skip(refusal)
    yield line, folder
    for pid in line.donnies():
        with suppress(ProcessLookupError):
            os.kill(pid, signal.SIGKILL)


@pytest.mark.parametrize("asked", ["sh", "cat /etc/passwd", "donnie --confined /", "run ../secret.gd", ""])
def test_whatever_a_pupil_asks_of_ssh_is_donnie_in_the_folder(
    pupil: tuple[SshLine, Path], asked: str
) -> None:
    line, folder = pupil
    typed = f"OPEN {folder.parent}/secret.gd\nOPEN link.gd\nSAVE LOG /tmp/x\nOPEN mine.gd\nRUN\nQUIT\n"
    done = line.asked(asked, typed)

    said = done.stdout.decode().splitlines()
    assert said.count("I walked 2 steps forward.") == 1
    assert sum("is not in your folder." in each for each in said) == 3
    assert "4711" not in done.stdout.decode()
    assert done.returncode == 2  # of a file that could not be opened


@pytest.mark.parametrize("mode", ["--linear", "--visual"])
def test_a_pupil_at_a_terminal_gets_no_shell(tmp_path: Path, mode: str) -> None:
    folder = tmp_path / "class" / "ana"
    folder.mkdir(parents=True)
    (folder.parent / "secret.gd").write_text("SPEAK 4711\n")
    line = SshLine(tmp_path, forced=("--confined", str(folder), mode, "--plain"))
    if refusal := line.refusal():
        pytest.skip(refusal)
    learner = line.at_forced_terminal()
    learner.expect("> |Command line")
    learner.send("WHERE\r")
    learner.expect("Facing north")
    for typed, answer in (
        ("OPEN ../secret.gd", "is not in your folder"),
        ("SAVE LOG ../log.txt", "is not in your folder"),
        ("REPORT MAP /tmp/map.html", "is not in your folder"),
        ("WORLD /etc/passwd", "is not in your folder"),
    ):
        learner.send(f"{typed}\r")
        learner.expect_exact(answer)
    if mode == "--visual":
        learner.send("LOG\r")
        learner.expect_exact("Facing north")
        learner.send("!id > escaped\r")
        learner.send("q")
        learner.expect("Command line")
    else:
        learner.send("\x1a")
        learner.expect_exact("Ctrl+Z has no effect here.")
    learner.send("QUIT\r")
    learner.expect(pexpect.EOF)
    learner.close()

    assert learner.exitstatus == 0
    assert not list(tmp_path.rglob("escaped"))
    assert {each.name for each in folder.parent.iterdir()} == {"ana", "secret.gd"}


def test_control_z_over_ssh_is_answered_and_the_session_continues(line: SshLine) -> None:
    """There is no shell at the other end that could continue a suspended process."""
    learner = line.at_terminal("--linear", "--speed", "max")
    learner.expect("> ")
    learner.send("WHERE\r")
    learner.expect("Facing north")
    learner.expect("> ")
    learner.send("\x1a")
    learner.expect_exact("Ctrl+Z has no effect here.")
    learner.send("FW 2\r\rQUIT\r")
    learner.expect_exact("I walked 2 steps forward.")
    learner.expect(pexpect.EOF)
    learner.close()

    assert learner.exitstatus == 0
