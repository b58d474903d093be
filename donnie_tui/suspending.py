"""Ctrl+Z, for whoever drives a robot: a process that rests can't stop it, and a board drives on by itself.

Rule: what has to stop is stopped first, and the stop gets the time to go out over the line.
"""

from __future__ import annotations

import os
import signal
import threading

GOING_OUT = 0.3
"""Seconds: a few of the looks that the line's own thread takes, and a repeated stop."""


def suspend(*, after_stop: bool) -> None:
    """Rest until somebody brings us back. ``after_stop``: a robot was stopped just now."""
    if after_stop:
        threading.Event().wait(GOING_OUT)
    os.kill(os.getpid(), signal.SIGSTOP)
