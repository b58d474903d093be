"""The variables that somebody watches at the screen: told at each change, while a program runs too."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from donnie_tui.core.events import Answered
from donnie_tui.core.session import Session
from donnie_tui.core.watching import Watching, toggle_watch
from donnie_tui.core.wording import Wording


class Watch:
    """What is watched, in one run after the other."""

    def __init__(self, words: Wording) -> None:
        self._words = words
        self._names: list[str] = []
        self._last: Watching | None = None
        self._heed: Callable[[], None] = _nothing
        """Let the run that began last know whether anything is watched."""

    def toggle(self, typed: str) -> tuple[str, ...]:
        """WATCH with what stands behind it; what is told of it."""
        told = toggle_watch(self._names, typed, self._words)
        self._heed()
        return told

    def begin(self, session: Session, *, fresh: bool) -> Callable[[], None] | None:
        """A run begins, a fresh one without variables. What is to be called before each statement.

        None where nothing is watched: it costs a program that computes dearly.
        """
        watching = self._last = Watching(self._names, self._words)
        watching.begin(() if fresh else session.variables.items())

        def look() -> None:
            frames = session.frames if self._names else ()
            if frames:
                _tell(session, watching.look(frames[0].variables))

        def heed() -> None:
            if session.run is not None:
                session.run.control.look_before_each(look if self._names else None)

        self._heed = heed
        return look if self._names else None

    def end(self, session: Session, variables: Mapping[str, int]) -> None:
        """The run is over, and left these."""
        if self._last is not None:
            _tell(session, self._last.look(variables.items()))


def _nothing() -> None:
    return


def _tell(session: Session, sentences: tuple[str, ...]) -> None:
    for each in sentences:
        session.hub.publish(Answered(each))
