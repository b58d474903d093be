"""What is told of a world file of somebody's own when it is loaded: that a robot begins inside of something,
that its author's words can't be read, and how many slips its report has. A learner who never asks for the
report would look for them in the program.
"""

from __future__ import annotations

import shlex
from typing import TYPE_CHECKING

import worlds.words
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
    bad_words = _bad_words(world, words)
    others = len(inside[MOST_TOLD:]) + sum(note.code in _SLIPS for note in notes)
    told = (*bad_words, *(words(f"note-{_TOLD}", **note.details) for note in inside[:MOST_TOLD]))
    if not others:
        return told
    return (*told, words("world-remarks", count=others, path=shlex.quote(world.path)))


def _bad_words(world: ChosenWorld, words: Phrasing) -> tuple[str, ...]:
    """Why the author's words are not told, if there are any."""
    try:
        worlds.words.beside(world.path, words.language)
    except worlds.words.BadWords as problem:
        code = "key" if problem.key else "line" if problem.line else "file"
        code = "difficulty" if problem.key == "difficulty" else code
        values = {"file": problem.file.name, "key": problem.key, "line": problem.line}
        return (words(f"world-words-{code}", **values),)
    return ()
