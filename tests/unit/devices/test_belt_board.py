"""The simulated belt's board does what the real firmware was recorded to do."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from devices.belt import encode_frame
from tests.simulated_belt import SimulatedBelt

ONE = encode_frame((0, 0, 0, 3) + (0,) * 10)
ALL = encode_frame((3,) * 14)


def test_the_recording_of_a_real_board_is_answered_byte_for_byte(shared: Path) -> None:
    rows = (shared / "devices" / "traces" / "belt.jsonl").read_text(encoding="utf-8").splitlines()
    recorded = [json.loads(row) for row in rows]
    board = SimulatedBelt()
    said = b"".join(
        board.feed(bytes.fromhex(each["hex"]), each["t"]) for each in recorded if each["dir"] == "tx"
    )

    assert said == b"".join(bytes.fromhex(each["hex"]) for each in recorded if each["dir"] == "rx")
    assert board.frames == 4


def test_every_byte_outside_a_frame_causes_a_complaint() -> None:
    assert SimulatedBelt().feed(b"xy", 0.0) == b"E1\r\nE1\r\n"


def test_a_frame_may_come_in_any_chunks() -> None:
    board = SimulatedBelt()
    answers = [board.feed(bytes([each]), 0.0) for each in ALL]

    assert b"".join(answers) == b""
    assert board.motors(0.0) == ("A",) * 14


@pytest.mark.parametrize(("shown", "seconds"), [(ONE, 0.025), (ALL, 0.0744)], ids=["one", "all"])
def test_without_frames_the_motors_go_off_by_themselves(shown: bytes, seconds: float) -> None:
    board = SimulatedBelt()
    board.feed(shown, 0.0)

    assert "A" in board.motors(seconds - 0.001)
    assert set(board.motors(seconds + 0.001)) == {"P"}
