"""The real command in a process of its own, in a folder of its own, without anybody's settings."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path

import pexpect

from tests.patience import PATIENCE

COMMAND = (sys.executable, "-m", "donnie_tui")
QUIET = ("--speech", "off", "--sound", "off")


def environment(folder: Path, changes: Mapping[str, str] | None = None) -> dict[str, str]:
    """English, UTF-8, no settings of the one who runs the tests."""
    kept = {
        name: value for name, value in os.environ.items() if not name.startswith(("DONNIE_", "LC_", "LANG"))
    }
    own = {
        "XDG_CONFIG_HOME": str(folder / "config"),
        "XDG_STATE_HOME": str(folder / "state"),
        "LC_ALL": "C.UTF-8",
        "DONNIE_TOUR": "off",
        "DONNIE_PLAIN": "off",  # a screen reader of this machine would change the layout
    }
    return {**kept, **own, **(changes or {})}


def donnie(
    folder: Path, *arguments: str, typed: str | bytes = b"", changes: Mapping[str, str] | None = None
) -> subprocess.CompletedProcess[bytes]:
    """Run the command to its end. ``typed`` is its standard input."""
    return subprocess.run(
        [*COMMAND, *arguments],
        input=typed.encode() if isinstance(typed, str) else typed,
        capture_output=True,
        cwd=folder,
        env=environment(folder, changes),
        timeout=PATIENCE,
    )


def start(folder: Path, *arguments: str) -> subprocess.Popen[bytes]:
    """Start the command and leave it running."""
    return subprocess.Popen(
        [*COMMAND, *arguments],
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        cwd=folder,
        env=environment(folder),
    )


def end(child: pexpect.spawn) -> None:
    """Whatever it does; pexpect alone gives a busy machine a tenth of a second for it."""
    child.kill(signal.SIGKILL)
    child.wait()
    child.close()
