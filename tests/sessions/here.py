"""A folder in which programs are run, recorded and replayed in this process."""

from __future__ import annotations

import io
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import pytest

from donnie_tui.cli.main import main
from tests.sessions.command import QUIET

PROGRAM = """VAR n = 2
REPEAT n TIMES
FW n TR 90
END REPEAT
SPEAK "olá"
STATE
SCAN
WAIT 1
SPEAK DISTANCE F
"""


@dataclass(slots=True)
class Done:
    returncode: int
    out: list[str]
    err: list[str]


class Here:
    """A folder in which commands run in this process, which is faster than in one of their own."""

    def __init__(
        self, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, folder: Path
    ) -> None:
        self._capsys, self._monkeypatch, self.folder = capsys, monkeypatch, folder

    def donnie(self, *arguments: str, typed: str = "") -> Done:
        self._monkeypatch.setattr(sys, "stdin", io.StringIO(typed))
        code = main([*arguments, *QUIET])
        out, err = self._capsys.readouterr()
        return Done(code, out.splitlines(), err.splitlines())

    def record(self, program: str = PROGRAM, *more: str, code: int = 0) -> list[str]:
        """Record a run into ``a.rec``; what it printed."""
        (self.folder / "a.gd").write_text(program, encoding="utf-8")
        done = self.donnie("run", "a.gd", "--record", "a.rec", *more)
        assert (done.returncode, done.err) == (code, [])
        return done.out

    def replay(self, *arguments: str, typed: str = "", code: int = 0, err: Sequence[str] = ()) -> list[str]:
        done = self.donnie("replay", "a.rec", *arguments, typed=typed)
        assert (done.returncode, done.err) == (code, [*err])
        return done.out

    def spoil(self, change: dict[int, bytes | None]) -> None:
        """Replace lines of the recording, counted from 1; None deletes one."""
        lines = (self.folder / "a.rec").read_bytes().splitlines(keepends=True)
        kept = [change.get(number, line) for number, line in enumerate(lines, 1)]
        (self.folder / "a.rec").write_bytes(b"".join(line for line in kept if line is not None))
