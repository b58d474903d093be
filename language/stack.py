"""How deep calls may go, and the room that Python needs for it.

The running program is Python calling Python, which since 3.11 takes no C stack: any thread will do, and
only the interpreter's own limit has to be out of the way. That limit belongs to the whole process, so it
is raised once and never lowered: another thread may be deep in it.
"""

from __future__ import annotations

import sys
from functools import cache
from typing import TypeAlias

DEEPEST_CALL = 20_000
"""Procedures that may be running inside each other."""

Link: TypeAlias = "tuple[int] | tuple[int, Link]"
"""How many calls are open, and the link for one call more; the deepest has none."""

_PYTHON_FRAMES = 1_000_000
"""More than a program can use: a call in deeply nested loops takes several frames of Python."""


@cache
def first_link(deepest: int = DEEPEST_CALL) -> Link:
    """The link of a program without open calls.

    Handing on a link is cheaper than counting, and asking the deepest for the next one fails by itself.
    """
    link: Link = (deepest,)
    for depth in range(deepest - 1, -1, -1):
        link = (depth, link)
    return link


def make_room() -> None:
    """Let Python call as deep as GoDonnie may."""
    if sys.getrecursionlimit() < _PYTHON_FRAMES:
        sys.setrecursionlimit(_PYTHON_FRAMES)
