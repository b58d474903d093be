"""The log of what was told: a listener that writes every line into a file of its own, numbered."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path
from typing import TextIO

from donnie_tui.core.events import Stamped
from donnie_tui.core.line_file import LineFile
from donnie_tui.core.transcript import told_lines
from donnie_tui.core.wording import Wording


class ToldLog:
    """Writes what is told, a line each.

    A disk that is full ends the log and nothing else; ``on_failure`` is told once.
    """

    def __init__(
        self, out: TextIO, wording: Wording, on_failure: Callable[[OSError], None] | None = None
    ) -> None:
        self._file = LineFile(out, on_failure)
        self._wording = wording

    def __call__(self, stamped: Stamped) -> None:
        lines = told_lines(stamped, self._wording)
        if lines and self._file.takes_more:
            self._file.write("".join(f"{line}\n" for line in lines))


def next_log(folder: Path) -> Path:
    """The first name that is free behind all that are taken: ``log_001.txt``, ``log_002.txt``."""
    numbers = [re.fullmatch(r"log_(\d{1,9})\.txt", each.name) for each in folder.iterdir()]
    highest = max((int(each[1]) for each in numbers if each), default=0)
    return folder / f"log_{highest + 1:03}.txt"
