"""Ties a process's life to its parent's, where the system can (Linux): killed with it, frozen or not.

The tie is to the thread that started the process: that thread must live as long as the process may.
"""

from __future__ import annotations

import ctypes
import signal
import sys

CAN_DIE_WITH_PARENT = sys.platform == "linux"

_PR_SET_PDEATHSIG = 1
_prctl = getattr(ctypes.CDLL(None), "prctl", None) if CAN_DIE_WITH_PARENT else None
"""Looked up early: after a fork nothing may be loaded."""


def die_with_parent() -> None:
    """Ask the system to kill this process when its parent ends. Does nothing where it can't."""
    if _prctl is not None:
        _prctl(_PR_SET_PDEATHSIG, int(signal.SIGKILL), 0, 0, 0)
