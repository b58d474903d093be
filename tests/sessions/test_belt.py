"""The belt at a real connection: felt, missing, in words, and never at the robot's port."""

from __future__ import annotations

import contextlib
import os
import select
import threading
import tty
from pathlib import Path

import pytest

from devices.serial_ports import PortFault, PortProblem
from donnie_tui.bootstrap import assemble
from donnie_tui.settings.settings import Settings
from tests.board_on_pty import PtyBoard
from tests.sessions.command import QUIET, donnie, start
from tests.sessions.real_robot import program, serial, until
from tests.sessions.test_double import world as near_world
from tests.simulated_belt import SimulatedBelt
from tests.timeouts import TIMEOUT

pytestmark = pytest.mark.slow


def test_a_missing_belt_is_reported_and_the_run_continues(tmp_path: Path) -> None:
    done = donnie(tmp_path, "run", program(tmp_path, "BELT ON\nFW 1\n"), "--belt", "/dev/nothing")

    assert (
        done.stderr.decode()
        == "No belt at /dev/nothing: there is no such file or folder. I go on without it.\n"
    )
    assert done.stdout.decode() == "Belt on.\nI walked 1 step forward.\n"
    assert done.returncode == 0


def test_the_start_does_not_wait_for_a_belt_at_an_address_and_reports_a_missing_one(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    answers, said = threading.Event(), list[str]()

    def no_answer(port: str) -> None:
        assert answers.wait(TIMEOUT)
        raise PortProblem(port, PortFault.UNUSABLE, "timed out")

    monkeypatch.setattr("devices.belt.open_belt_port", no_answer)
    donnie = assemble(Settings(belt="socket://far:1", speech="off", sound=False), terminal=True)
    donnie.session.hub.subscribe(lambda stamped: said.append(getattr(stamped.event, "text", "")))
    answers.set()
    try:
        assert donnie.notices.all == ()
        assert until(lambda: said == ["No belt at socket://far:1: timed out. I go on without it."])
    finally:
        donnie.close()


def test_a_belt_that_is_lost_is_an_event_whether_a_program_runs_or_not(tmp_path: Path) -> None:
    ours, theirs = os.openpty()
    tty.setraw(ours)
    said = list[tuple[str, str]]()
    port = tmp_path / "belt"
    port.symlink_to(os.ttyname(theirs))
    settings = Settings(belt=str(port), speech="off", sound=False)
    donnie = assemble(settings, terminal=True)
    donnie.session.hub.subscribe(
        lambda stamped: said.append((getattr(stamped.event, "code", ""), getattr(stamped.event, "text", "")))
    )
    try:
        assert select.select([ours], [], [], TIMEOUT)[0], "the belt's first frame"
        port.unlink()  # another terminal may get the old one's number
        os.close(theirs)
        os.close(ours)
        assert until(lambda: ("belt-link", "The belt is gone.") in said)
    finally:
        donnie.close()


def test_robot_and_belt_may_not_have_the_same_port(tmp_path: Path, robot: PtyBoard) -> None:
    file = program(tmp_path, "FW 1")
    done = donnie(tmp_path, "run", file, *serial(robot), "--belt", robot.path)

    assert done.stderr.decode() == f"Robot and belt can't both be at {robot.path}.\n"
    assert done.returncode == 2


def test_the_robot_can_not_be_connected_at_the_port_of_the_belt(tmp_path: Path, robot: PtyBoard) -> None:
    donnie = assemble(Settings(belt=robot.path, speech="off", sound=False), terminal=True)
    try:
        said = donnie.connection.connect(f"serial:{robot.path}")
    finally:
        donnie.close()

    assert said == (
        f"Robot and belt can't both be at {robot.path}.",
        "I will use the simulator. CONNECT tries again.",
    )


def test_the_belt_is_felt_during_a_run_and_dark_after_it(tmp_path: Path) -> None:
    ours, theirs = os.openpty()
    tty.setraw(ours)
    os.set_blocking(ours, False)
    program(tmp_path, "BELT ON\nWAIT 1\n")
    options = ("--world", near_world(tmp_path), "--belt", os.ttyname(theirs), "--speed", "5", *QUIET)
    process = start(tmp_path, "run", "program.gd", *options)
    board, felt = SimulatedBelt(), list[tuple[str, ...]]()

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
    ("language", "typed", "said"),
    [
        ("en", "FEEL ON", "Belt: front medium."),
        ("pt", "SENTIR ligado", "Cinto: frente médio."),
        ("es", "sentir encendido", "Cinturón: frente medio."),
    ],
)
def test_a_learner_without_a_belt_gets_its_levels_in_words(
    tmp_path: Path, language: str, typed: str, said: str
) -> None:
    options = ("--linear", "--world", near_world(tmp_path), "--lang", language, "--speed", "max", *QUIET)
    done = donnie(tmp_path, *options, typed=f"{typed}\nBELT ON\nFW 1\nRUN\nQUIT\n")

    lines = done.stdout.decode().splitlines()
    assert lines.index(said) > 0
    assert done.returncode == 0
