"""A shell with job control above Donnie, as far as Ctrl+Z needs one."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from pathlib import Path

_SHELL = """
import os, signal, sys
signal.signal(signal.SIGTTOU, signal.SIG_IGN)
job = os.fork()
if job == 0:
    os.setpgid(0, 0)
    if os.isatty(0):
        os.tcsetpgrp(0, os.getpid())
    signal.signal(signal.SIGTTOU, signal.SIG_DFL)
    os.execv(sys.argv[1], sys.argv[1:])
status = os.waitpid(job, 0)[1]
sys.exit(os.waitstatus_to_exitcode(status))
"""


def below_shell(command: Sequence[str]) -> list[str]:
    """The command line of a shell that runs that command in the foreground and waits for its end."""
    return [sys.executable, "-c", _SHELL, *command]


def job_of(shell: int) -> int:
    """The process of the command below that shell."""
    return int(Path(f"/proc/{shell}/task/{shell}/children").read_text().split()[0])


def is_stopped(process: int) -> bool:
    """Whether it is suspended now."""
    return Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()[0] == "T"
