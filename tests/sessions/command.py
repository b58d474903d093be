"""The real command in its own process and folder, without a learner's settings."""

from __future__ import annotations

import signal
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path

import pexpect

from tests.environment import of_a_process
from tests.timeouts import TIMEOUT

COMMAND = (sys.executable, "-m", "donnie_tui")
QUIET = ("--speech", "off", "--sound", "off")


def environment(folder: Path, changes: Mapping[str, str] | None = None) -> dict[str, str]:
    """English, UTF-8, settings of its own."""
    return of_a_process(folder, **(changes or {}))


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
        timeout=TIMEOUT,
    )


def start(folder: Path, *arguments: str, changes: Mapping[str, str] | None = None) -> subprocess.Popen[bytes]:
    """Start the command and leave it running, in a process group of its own, as a shell would."""
    return subprocess.Popen(
        [*COMMAND, *arguments],
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        cwd=folder,
        env=environment(folder, changes),
        process_group=0,
    )


def end(child: pexpect.spawn) -> None:
    """Whatever it does; pexpect alone gives a busy machine a tenth of a second for it."""
    child.kill(signal.SIGKILL)
    child.wait()
    child.close()
