"""What is told of a world file of somebody's own when it is loaded: that a robot begins inside of something,
and how many slips its report has. A learner who never asks for the report would look for them in the program.
"""

from __future__ import annotations

import shlex
from typing import TYPE_CHECKING

from donnie_tui.i18n.phrasing import Phrasing

if TYPE_CHECKING:
    from donnie_tui.world.choice import ChosenWorld

_TOLD = "starts-inside"
_SLIPS = frozenset({"unknown-property", "unknown-colour", "unknown-model", "second-define"})
"""Of what is ignored or repaired, what somebody wrote and did not get."""
MOST_TOLD = 3
"""Remarks that are told one by one."""


def remarks(world: ChosenWorld, words: Phrasing) -> tuple[str, ...]:
    """A sentence each; none of a world that ships."""
    if world.ships:
        return ()
    notes = world.scene.report.notes
    inside = [note for note in notes if note.code == _TOLD]
    others = len(inside[MOST_TOLD:]) + sum(note.code in _SLIPS for note in notes)
    told = tuple(words(f"note-{_TOLD}", **note.details) for note in inside[:MOST_TOLD])
    if not others:
        return told
    return (*told, words("world-remarks", count=others, path=shlex.quote(str(world.path))))
