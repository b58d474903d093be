"""Without a terminal no signal reports a lost connection. Unread output counts as a loss."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest

from tests.board_on_pty import PtyBoard
from tests.sessions.command import COMMAND, QUIET, environment, start
from tests.sessions.real_robot import LONG_WALK, program, serial, until
from tests.timeouts import TIMEOUT

pytestmark = pytest.mark.slow


@pytest.mark.parametrize("lost", ["stdout", "stderr"])
def test_a_run_with_closed_output_stops_its_robot(tmp_path: Path, robot: PtyBoard, lost: str) -> None:
    """In the middle of a walk, before the next line would find out."""
    process = start(tmp_path, "run", program(tmp_path, LONG_WALK), *serial(robot), *QUIET)
    assert until(lambda: robot.board.is_driving)

    getattr(process, lost).close()

    assert until(lambda: not robot.board.is_driving)
    assert process.wait(TIMEOUT) == 130


def test_the_linear_mode_with_closed_output_stops_its_robot(tmp_path: Path, robot: PtyBoard) -> None:
    process = subprocess.Popen(
        [*COMMAND, "--linear", program(tmp_path, LONG_WALK), *serial(robot), *QUIET],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        cwd=tmp_path,
        env=environment(tmp_path),
    )
    assert process.stdin is not None
    assert process.stdout is not None
    process.stdin.write(b"RUN\n")
    process.stdin.flush()
    assert until(lambda: robot.board.is_driving)

    process.stdout.close()

    assert until(lambda: not robot.board.is_driving)
    assert process.wait(TIMEOUT) == 129
