"""The log of what was told: a listener that writes every line into a file of its own, numbered."""

from __future__ import annotations

import re
from pathlib import Path
from typing import TextIO

from donnie_tui.core.events import Stamped
from donnie_tui.core.transcript import told_lines
from donnie_tui.core.wording import Wording


class ToldLog:
    """Writes what is told, a line each. A disk that is full ends the log and nothing else."""

    def __init__(self, out: TextIO, wording: Wording) -> None:
        self._out = out
        self._wording = wording

    def __call__(self, stamped: Stamped) -> None:
        lines = told_lines(stamped, self._wording)
        if not lines or self._out.closed:
            return
        try:
            self._out.write("".join(f"{line}\n" for line in lines))
            self._out.flush()
        except OSError:
            return


def next_log(folder: Path) -> Path:
    """The first name that is free behind all that are taken: ``log_001.txt``, ``log_002.txt``."""
    numbers = [re.fullmatch(r"log_(\d{1,9})\.txt", each.name) for each in folder.iterdir()]
    highest = max((int(each[1]) for each in numbers if each), default=0)
    return folder / f"log_{highest + 1:03}.txt"
