"""Waits while something sounds, until the learner wants something else."""

from __future__ import annotations

from donnie_tui.linear.desk import Desk


def is_disturbed(desk: Desk, seconds: float) -> bool:
    """Wait so long. Whether somebody wants something else before."""
    console = desk.console
    until = console.now() + seconds
    while (left := until - console.now()) > 0:
        if console.wait(left, reading=desk.is_attended) or console.take_interrupt():
            return True
        if console.leaving is not None:
            return True
    return False
