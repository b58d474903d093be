"""A program that is stepped through, hold by hold, and backwards: each with what it told and its variables.

Both front ends tell from here what a step did and what is next. Where the program ran on by itself between
two holds, what happened is undone event by event, as ``retelling`` tells it. Bounded: the newest holds are
remembered, and of a step that did much its last deeds are told.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Mapping, Sequence

from devices.ports.hints import TYPE_CHECKING
from devices.ports.values import Frozen
from donnie_tui.core.events import Event, Read
from donnie_tui.core.wording import Wording
from language.runtime import Frame
from language.source import fold_name

if TYPE_CHECKING:
    from donnie_tui.core.session import Session
    from donnie_tui.core.step_words import StepWords
    from donnie_tui.core.timeline import Timeline

MOST_HOLDS = 1000
MOST_DEEDS = 5
"""What is told of one step, a procedure that was stepped over say."""


class _Hold(Frozen):
    """The program was held before a statement."""

    seq: int
    """The number of the last event before it."""
    sentences: tuple[str, ...]
    variables: Mapping[str, int]
    is_next: bool
    """Whether it was stepped to from the hold before it."""


class Stepped:
    """The holds of one run after the other, of one robot at a time."""

    def __init__(self, last_seq: Callable[[], int], wording: Wording) -> None:
        """``last_seq`` tells the number of the last event."""
        self._last_seq = last_seq
        self._say = wording
        self._holds: deque[_Hold] = deque(maxlen=MOST_HOLDS)
        self._goes_on = False
        self._at: int | None = None
        """The hold to which somebody has gone back; None now."""
        self._session: Session | None = None
        self._text, self._first_line = "", 1
        self._lines: Callable[[], Sequence[str]] = tuple
        self._words: StepWords | None = None

    def begin(
        self,
        session: Session,
        text: str,
        first_line: int = 1,
        lines: Callable[[], Sequence[str]] | None = None,
    ) -> None:
        """Another run, of ``text``; ``lines`` are those of the whole program, where it is but a part."""
        self.forget()
        self._session, self._text, self._first_line = session, text, first_line
        self._lines = lines or (lambda: text.split("\n"))

    def forget(self) -> None:
        """Another run, of which nothing is told."""
        self._holds.clear()
        self._goes_on, self._at, self._words, self._session = False, None, None, None

    def hear(self, event: Event) -> None:
        """In the program's thread: what its sensors say."""
        if self._words is not None and isinstance(event, Read):
            self._words.heard(event)

    def ended(self) -> tuple[str, ...]:
        """It came to its end: what came out of the last statement before which it was held."""
        words, self._words = self._words, None
        return words.ended() if words is not None else ()

    def held(self, place: tuple[int, int], frames: Sequence[Frame], *, was_paused: bool) -> tuple[str, ...]:
        """It is held before the statement in that line and column: what came out of the last one, and what is
        next. Nothing is told where it is held within one, at line 0.

        ``was_paused``: somebody asked for it, wherever it was.
        """
        self._words = self._words or self._beginning(is_first=not was_paused)
        if not place[0]:
            return ()
        told = self._words.held(*place, frames)
        variables = dict(frames[0].variables) if frames else {}
        self._holds.append(_Hold(self._last_seq(), told, variables, is_next=not self._goes_on))
        self._goes_on, self._at = False, None
        return told

    def line_of(self, frame: Frame) -> str:
        """Where it is held within a statement."""
        lines = self._lines()
        text = lines[frame.line - 1].strip() if 0 < frame.line <= len(lines) else ""
        return self._say("answer-line", line=frame.line, text=text)

    def _beginning(self, *, is_first: bool) -> StepWords:
        from donnie_tui.core.step_words import StepWords  # a program that is held

        program = self._session.parse(self._text, self._first_line).program if self._session else None
        return StepWords(program, self._lines(), self._say, is_first=is_first)

    def goes_on(self) -> None:
        """It does more than a step from here."""
        if self._words is not None:
            self._words.lose_count()
            self._goes_on = True

    def back(self, timeline: Timeline, *, is_now: bool) -> tuple[str, ...]:
        """What is undone by one step back, ``timeline`` standing where somebody has come to.

        ``is_now``: whether nobody has gone back yet.
        """
        wording, now = self._say, self._session.variables if self._session is not None else {}
        if is_now or self._at is None:
            is_held = bool(self._holds) and self._holds[-1].seq >= _seq(timeline)
            self._at = len(self._holds) - 1 if is_held else len(self._holds)
        if self._at <= 0:
            return (_one_back(timeline, wording),)
        before = self._holds[self._at - 1]
        was_stepped = self._holds[self._at].is_next if self._at < len(self._holds) else not self._goes_on
        undone = self._undone(before.seq, timeline, wording, most=None if was_stepped else 1)
        if _seq(timeline) > before.seq:
            return undone
        later = self._holds[self._at].variables if self._at < len(self._holds) else now
        self._at -= 1
        return (*undone, *_changed_back(before.variables, later, wording), *before.sentences)

    def _undone(self, seq: int, timeline: Timeline, wording: Wording, *, most: int | None) -> tuple[str, ...]:
        """All events behind ``seq``, or the last step of them; a sentence each, the first ones told."""
        told: list[str] = []
        while _seq(timeline) > seq and (most is None or len(told) < most):
            told.append(_one_back(timeline, wording))
        if len(told) > MOST_DEEDS:
            told[MOST_DEEDS:] = [wording("undone-more", count=len(told) - MOST_DEEDS)]
        return tuple(told) or (wording("undone-step"),)


def _one_back(timeline: Timeline, wording: Wording) -> str:
    from donnie_tui.core.retelling import told_back  # for who goes back

    return told_back(timeline.step_back(), timeline, wording)


def _seq(timeline: Timeline) -> int:
    return timeline.now.seq if timeline.now is not None else 0


def _changed_back(then: Mapping[str, int], later: Mapping[str, int], wording: Wording) -> tuple[str, ...]:
    """What the variables are again that the step changed; those that it made are not there."""
    values, known = {fold_name(name): value for name, value in later.items()}, set(map(fold_name, then))
    again = tuple(
        wording("variable-is", name=name, value=value)
        for name, value in then.items()
        if values.get(fold_name(name), value) != value
    )
    made = (name for name in later if fold_name(name) not in known)
    return again + tuple(wording("variable-not-yet", name=name) for name in made)
