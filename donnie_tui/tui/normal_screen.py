"""The terminal's normal screen: the log in a pager, and its last lines after the end."""

from __future__ import annotations

import os
import shlex
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Mapping, Sequence
from pathlib import Path

from donnie_tui.tui.environment import is_page

LAST_LINES = 20
"""Lines of the log that stay on the normal screen."""


class PagerError(Exception):
    """Why the pager shows nothing: the code of a sentence, and its values."""

    def __init__(self, code: str, **values: str) -> None:
        super().__init__(code)
        self.code, self.values = code, values


def print_last_lines(lines: Sequence[str]) -> None:
    """The end of the log, where the shell continues: it can be read again there."""
    from language.source import printable

    if is_page():
        return  # a browser has no such screen
    try:
        for line in lines[-LAST_LINES:]:
            sys.stdout.write(f"{printable(line)}\n")
        sys.stdout.flush()
    except (OSError, ValueError):
        return


def pager(environment: Mapping[str, str]) -> list[str] | None:
    """The command that shows a text: the one of PAGER, else less or more; None where there is none."""
    try:
        wanted = [shlex.split(environment.get("PAGER", "")), ["less"], ["more"]]
    except ValueError:
        wanted = [["less"], ["more"]]
    return next((each for each in wanted if each and shutil.which(each[0])), None)


def show_in_pager(text: str) -> None:
    """Wait until it was read. Raises ``PagerError``: no pager, one that can't be run, a full disk."""
    command = pager(os.environ)
    if command is None:
        raise PagerError("screen-no-pager")
    try:
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "log.txt"
            file.write_text(text, encoding="utf-8", errors="replace")
            subprocess.run([*command, str(file)], check=False)
    except OSError as problem:
        raise PagerError("screen-pager-failed", reason=problem.strerror or str(problem)) from None
