"""What is typed to a command that asks may be any bytes, or there may be no standard input at all."""

from __future__ import annotations

import io
import sys
from collections.abc import Callable

import pytest

from donnie_tui.cli.main import main
from tests.sessions.command import QUIET
from tests.sessions.here import Here

Typed = Callable[[bytes | None], None]


@pytest.fixture
def typed(monkeypatch: pytest.MonkeyPatch) -> Typed:
    """Standard input as Python opens it for most learners: in UTF-8, and strict about it."""

    def set_input(data: bytes | None) -> None:
        stream = None if data is None else io.TextIOWrapper(io.BytesIO(data), encoding="utf-8")
        monkeypatch.setattr(sys, "stdin", stream)

    return set_input


def test_a_step_through_a_recording_takes_any_bytes(
    here: Here, typed: Typed, capsys: pytest.CaptureFixture[str]
) -> None:
    here.record("FW 2")
    typed(b"pr\xf3ximo\nEND\nNEXT\n")

    assert main(["replay", "a.rec", "--step", *QUIET]) == 0
    said = capsys.readouterr().out.splitlines()
    assert (said[1], said[-1]) == ("I do not know that word. HELP lists them.", "This is the end.")


@pytest.mark.parametrize("data", [b"\xff\n", b"", None], ids=["bytes", "empty", "none"])
def test_a_calibration_without_words_measures_nothing(
    here: Here, typed: Typed, capsys: pytest.CaptureFixture[str], data: bytes | None
) -> None:
    typed(data)

    assert main(["calibrate", "--robot", "double", "--speed", "max"]) == 1
    assert capsys.readouterr().out.splitlines()[-1] == "Nothing was measured. Nothing has changed."
