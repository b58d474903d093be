"""The mistakes of the last run: gone through one by one, repeated, explained.

Of several mistakes the first one counts until the learner asks for another: it is the one to correct first.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING

from donnie_tui.core.events import Error, RunStarted, Stamped
from donnie_tui.core.transcript import lines_of, lines_said_by
from donnie_tui.core.wording import Wording

if TYPE_CHECKING:
    from donnie_tui.core.session import Session

MOST_KEPT = 200
"""Mistakes that are remembered, the newest ones."""
MOST_HINTS = 3
LARGEST = 50_000
"""Characters of a text that is searched for hints without a delay."""


class RunErrors:
    """The mistakes of one robot's last run, and the one that the learner is at. Subscribe ``on_event``."""

    def __init__(self, errors: Iterable[Error] = (), of: Callable[[], str | None] = lambda: None) -> None:
        """``of``: the robot, by the name in its events; None in a world of one robot."""
        self._of = of
        self.all = tuple(errors)
        self._at = 0

    def on_event(self, stamped: Stamped) -> None:
        """Called in any thread. A run begins without mistakes."""
        event = stamped.event
        if stamped.robot != self._of():
            return
        if isinstance(event, RunStarted):
            self.all, self._at = (), 0
        elif isinstance(event, Error):
            self.add(event)

    def add(self, error: Error) -> None:
        self.all = (*self.all[-MOST_KEPT + 1 :], error)

    @property
    def now(self) -> Error | None:
        """The mistake that the learner is at."""
        return self.all[self._at] if self.all else None

    def go(self, by: int, wording: Wording) -> tuple[Error | None, tuple[str, ...]]:
        """Moves by so many mistakes; returns the mistake and the sentences, or None and a sentence."""
        if not self.all:
            return None, self._none(wording)
        wanted = self._at + by
        if not 0 <= wanted < len(self.all):
            return None, (wording("answer-no-more-errors", number=self._at + 1, count=len(self.all)),)
        self._at = wanted
        return self.all[wanted], lines_of(self.all[wanted], wording)

    def in_words(self, wording: Wording) -> tuple[str, ...]:
        """All mistakes again."""
        return tuple(line for each in self.all for line in lines_of(each, wording)) or self._none(wording)

    def explained(self, robot: str | None, wording: Wording) -> tuple[str, ...]:
        """The current mistake in plain words, and what to do. ``robot`` has made it."""
        if self.now is None:
            return self._none(wording)
        return lines_said_by(robot, wording.explanation(self.now), wording)

    def _none(self, wording: Wording) -> tuple[str, ...]:
        return (wording("answer-no-errors"),)


def line_of(error: Error, wording: Wording) -> tuple[str, ...]:
    """The line as it was when the mistake was made, none where it is not known."""
    return lines_of(error, wording)[1:2] if error.source_line else ()


def hints_of(text: str, session: Session, wording: Wording) -> tuple[str, ...]:
    """What had no effect as that text ran, and what was probably meant."""
    found = session.check(text, whole=False)[:MOST_HINTS] if len(text) <= LARGEST else ()
    pairs = ((wording.mistake(each), wording.hint(each)) for each in found)
    return tuple(sentence for both in pairs for sentence in both if sentence)
