"""Outside the full screen: the log in the pager, and its last lines on the normal screen at the end."""

from __future__ import annotations

import os
import shlex
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Mapping, Sequence
from pathlib import Path

from donnie_tui.tui.answer import Answer

LEFT_BEHIND = 20
"""Lines of the log that stay on the normal screen."""


def leave_behind(lines: Sequence[str]) -> None:
    """What was told last, where the shell goes on: it can be read again there."""
    from language.source import printable

    if os.environ.get("TEXTUAL_DRIVER"):
        return  # a browser has no such screen
    try:
        for line in lines[-LEFT_BEHIND:]:
            sys.stdout.write(f"{printable(line)}\n")
        sys.stdout.flush()
    except (OSError, ValueError):
        return


def pager(environment: Mapping[str, str]) -> list[str] | None:
    """The command that shows a text: what the person chose, else less or more; None where there is none."""
    try:
        wanted = [shlex.split(environment.get("PAGER", "")), ["less"], ["more"]]
    except ValueError:
        wanted = [["less"], ["more"]]
    return next((each for each in wanted if each and shutil.which(each[0])), None)


NO_PAGER = Answer("screen-no-pager")


def show_in_pager(text: str) -> Answer | None:
    """Wait until it was read. Otherwise why it can't be: no pager, one that can't be run, a full disk."""
    command = pager(os.environ)
    if command is None:
        return NO_PAGER
    try:
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "log.txt"
            file.write_text(text, encoding="utf-8", errors="replace")
            subprocess.run([*command, str(file)], check=False)
    except OSError as problem:
        return Answer("screen-pager-failed", {"reason": problem.strerror or str(problem)})
    return None
