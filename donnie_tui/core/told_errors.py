"""The mistakes of a run after they were told: gone through one by one, told again, explained.

The same for both front ends; where the cursor or the reading place goes is theirs. Rule: of several mistakes
the first one is meant until somebody goes on to another, for it is the one to be mended first.
"""

from __future__ import annotations

from collections.abc import Iterable

from devices.ports.hints import TYPE_CHECKING
from donnie_tui.core.events import Error
from donnie_tui.core.transcript import lines_of, lines_said_by
from donnie_tui.core.wording import Wording

if TYPE_CHECKING:
    from donnie_tui.core.session import Session

MOST_KEPT = 200
"""Mistakes that are remembered, the newest ones."""
MOST_HINTS = 3
LARGEST = 50_000
"""Characters of a text that is looked through for hints: nobody is to wait for them."""


class ToldErrors:
    """Those of one run, and at which of them somebody is."""

    def __init__(self, errors: Iterable[Error] = ()) -> None:
        self.all = tuple(errors)
        self._at = 0

    def add(self, error: Error) -> None:
        self.all = (*self.all[-MOST_KEPT + 1 :], error)

    @property
    def now(self) -> Error | None:
        """The one somebody is at."""
        return self.all[self._at] if self.all else None

    def go(self, by: int, wording: Wording) -> tuple[Error | None, tuple[str, ...]]:
        """To the one so many further on, and what is told; to none where there is none."""
        if not self.all:
            return None, self._none(wording)
        wanted = self._at + by
        if not 0 <= wanted < len(self.all):
            return None, (wording("answer-no-more-errors", number=self._at + 1, count=len(self.all)),)
        self._at = wanted
        return self.all[wanted], lines_of(self.all[wanted], wording)

    def in_words(self, wording: Wording) -> tuple[str, ...]:
        """All of them once more."""
        return tuple(line for each in self.all for line in lines_of(each, wording)) or self._none(wording)

    def explained(self, robot: str | None, wording: Wording) -> tuple[str, ...]:
        """The one of ``now`` in plain words, and what to do. ``robot`` is whose it is."""
        if self.now is None:
            return self._none(wording)
        return lines_said_by(robot, wording.explanation(self.now), wording)

    def _none(self, wording: Wording) -> tuple[str, ...]:
        return (wording("answer-no-errors"),)


def line_of(error: Error, wording: Wording) -> tuple[str, ...]:
    """The line as it was when the mistake was made, none where it is not known."""
    return lines_of(error, wording)[1:2] if error.source_line else ()


def told_hints(text: str, session: Session, wording: Wording) -> tuple[str, ...]:
    """What had no effect as that text ran, and what was probably meant."""
    found = session.check(text, whole=False)[:MOST_HINTS] if len(text) <= LARGEST else ()
    told = ((wording.mistake(each), wording.hint(each)) for each in found)
    return tuple(sentence for both in told for sentence in both if sentence)
