"""What several sessions need."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from devices.firmware_double.board import SimulatedBoard
from devices.firmware_double.on_pty import DoubleOnPty
from tests.sessions.learner import Learner


@pytest.fixture
def robot() -> Iterator[DoubleOnPty]:
    with DoubleOnPty(SimulatedBoard(boot_loader=0.1)) as double:
        yield double


@pytest.fixture
def learner(tmp_path: Path) -> Learner:
    return Learner(tmp_path)
