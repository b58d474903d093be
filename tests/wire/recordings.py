"""Recordings of the real firmware: what was sent, in which direction, and when. They are not in the
repository."""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path

ROBOT_TRACES = (
    "robot_bad_input",
    "robot_boot_config_idle",
    "robot_boot_unanswered",
    "robot_corrupted_line",
    "robot_head_dio_beep",
    "robot_moves",
    "robot_no_ping_8s",
    "robot_reset_mid_move",
    "robot_sensors",
)


@dataclass(frozen=True)
class RecordedRow:
    at: float
    direction: str
    """``rx`` board to host, ``tx`` host to board, ``ctl`` what was done to the board."""
    data: bytes
    action: str


def recording(shared: Path, name: str) -> list[RecordedRow]:
    text = (shared / "devices" / "traces" / f"{name}.jsonl").read_text(encoding="utf-8")
    rows = [json.loads(row) for row in text.splitlines()]
    return [
        RecordedRow(row["t"], row["dir"], bytes.fromhex(row.get("hex", "")), row.get("cmd", ""))
        for row in rows
    ]
