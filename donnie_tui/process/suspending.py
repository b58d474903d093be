"""Ctrl+Z, for whoever drives a robot: a process that rests can't stop it, and a board drives on by itself.

Rule: what has to stop is stopped first, and stands, before ``suspend`` is called.
"""

from __future__ import annotations

import os
import select
import signal
from stat import S_ISCHR

_STANDARD = (0, 1, 2)


def suspend() -> None:
    """Rest until somebody brings us back; not where the terminal was closed: nobody ever would."""
    if not any(map(is_hung_up, _STANDARD)):
        os.kill(os.getpid(), signal.SIGSTOP)


def is_hung_up(number: int) -> bool:
    """Whether that file is a terminal that is gone; a pipe whose writer is done is none."""
    poll = select.poll()
    poll.register(number, 0)
    is_gone = any(told & select.POLLHUP for _, told in poll.poll(0))
    return is_gone and S_ISCHR(os.fstat(number).st_mode)
