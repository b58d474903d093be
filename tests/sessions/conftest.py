"""What several sessions need."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from devices.board_simulator.board import SimulatedBoard
from tests.sessions.here import Here

if TYPE_CHECKING:
    from tests.board_on_pty import PtyBoard
    from tests.sessions.learner import Learner


@pytest.fixture(autouse=True)
def _guards() -> Iterator[None]:
    """No guard of a robot that this process had outlives its test."""
    yield
    connection = sys.modules.get("donnie_tui.robot.connection")
    for guard in connection._ENDING if connection is not None else ():
        guard.kill()
        guard.wait()


@pytest.fixture
def robot() -> Iterator[PtyBoard]:
    """A simulated board at the other end of a line; not every system has such lines."""
    from tests.board_on_pty import PtyBoard

    with PtyBoard(SimulatedBoard(boot_loader=0.1)) as double:
        yield double


@pytest.fixture
def learner(tmp_path: Path) -> Learner:
    """On a terminal, which not every system has."""
    from tests.sessions.learner import Learner

    return Learner(tmp_path)


@pytest.fixture
def here(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Here:
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path / "config"))
    monkeypatch.chdir(tmp_path)
    return Here(capsys, monkeypatch, tmp_path)
