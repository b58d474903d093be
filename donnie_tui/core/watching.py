"""Variables that somebody watches: told whenever one of them has become something else.

Asked before each statement of a run, while it is held, and at its end; each change is told once.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence

from devices.ports.hints import TYPE_CHECKING
from donnie_tui.core.events import Answered
from donnie_tui.core.wording import Wording
from language.source import fold_name

if TYPE_CHECKING:
    from donnie_tui.core.session import Session


class Watch:
    """What somebody watches, in one run after the other."""

    def __init__(self, words: Wording) -> None:
        self.names: list[str] = []
        """As they were typed."""
        self._words = words
        self._last = Watching(self.names, words)
        self._heed: Callable[[], None] = _nothing
        """Let the run that began last know whether anything is watched."""

    def toggle(self, typed: str) -> tuple[str, ...]:
        """WATCH with what stands behind it; what is told of it. A run heeds it from here on."""
        told = toggle_watch(self.names, typed, self._words)
        self._heed()
        return told

    def begin(self, session: Session, *, fresh: bool) -> Callable[[], None] | None:
        """A run is to begin, a fresh one without variables. What is to be called before each statement.

        None where nothing is watched: it costs a program that computes dearly.
        """
        watching = self._last = Watching(self.names, self._words)
        watching.begin(() if fresh else session.variables.items())

        def look() -> None:
            frames = session.frames if self.names else ()
            if frames:
                _tell(session, watching.look(frames[0].variables))

        def heed() -> None:
            if session.run is not None:
                session.run.control.look_before_each(look if self.names else None)

        self._heed = heed
        return look if self.names else None

    def look(self, session: Session, variables: Iterable[tuple[str, int]]) -> None:
        """The run that began last is held, or over, and has these."""
        _tell(session, self._last.look(variables))


def _tell(session: Session, sentences: tuple[str, ...]) -> None:
    for each in sentences:
        session.hub.publish(Answered(each))


def _nothing() -> None:
    return


class Watching:
    """What was told of one run. Only one thread looks at a time: the program's, or another while it holds."""

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
        from donnie_tui.core.step_words import changes  # few watch anything

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
