"""What several sessions need."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from devices.firmware_double.board import SimulatedBoard
from devices.firmware_double.on_pty import DoubleOnPty


@pytest.fixture
def robot() -> Iterator[DoubleOnPty]:
    with DoubleOnPty(SimulatedBoard(boot_loader=0.1)) as double:
        yield double
