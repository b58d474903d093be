"""Variables that somebody watches: told whenever one of them has become something else.

Asked before each statement of a run, while it is held, and at its end; each change is told once.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from donnie_tui.core.step_words import changes
from donnie_tui.core.wording import Wording
from language.source import fold_name


class Watching:
    """One run after the other. Only one thread looks at a time: the program's, or another while it holds."""

    def __init__(self, names: Sequence[str], wording: Wording) -> None:
        """``names``, as they were typed, may grow and shrink meanwhile."""
        self._names = names
        self._say = wording
        self._known: dict[str, int] = {}

    def begin(self, variables: Iterable[tuple[str, int]]) -> None:
        """A run begins with these."""
        self._known = _folded(variables)

    def look(self, variables: Iterable[tuple[str, int]]) -> tuple[str, ...]:
        """What has changed, where the program is now, a sentence each."""
        if not self._names:
            return ()
        now = _folded(variables)
        told = tuple(changes(self._names, self._known, now, self._say))
        self._known |= now
        return told


def _folded(variables: Iterable[tuple[str, int]]) -> dict[str, int]:
    return {fold_name(name): value for name, value in variables}


def may_be_watched(typed: str) -> bool:
    """Whether a variable can be called that."""
    return typed.isidentifier()


def toggle_watch(watched: list[str], typed: str, wording: Wording) -> tuple[str, ...]:
    """Watch the variable from now on, or no more; without a name, which are watched. What is told of it."""
    known = next((each for each in watched if fold_name(each) == fold_name(typed)), None)
    if known is not None:
        watched.remove(known)
        return (wording("watch-gone", name=typed),)
    if typed:
        watched.append(typed)
        return (wording("watch-set", name=typed),)
    told = tuple(wording("watch-set", name=each) for each in watched)
    return told or (wording("watch-none"),)
