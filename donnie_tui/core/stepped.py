"""A program that was stepped through, backwards: each hold with what it told, and the variables of then.

Where it ran on by itself between two holds, what happened is undone event by event, as ``retelling`` tells
it. Bounded: the newest holds are remembered, and of a step that did much its last deeds are told.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Mapping
from typing import TYPE_CHECKING

from devices.ports.values import frozen
from donnie_tui.core.wording import Wording
from language.source import fold_name

if TYPE_CHECKING:
    from donnie_tui.core.timeline import Timeline

MOST_HOLDS = 1000
MOST_DEEDS = 5
"""What is told of one step, a procedure that was stepped over say."""


@frozen
class _Hold:
    """The program was held before a statement."""

    seq: int
    """The number of the last event before it."""
    sentences: tuple[str, ...]
    variables: Mapping[str, int]
    is_next: bool
    """Whether it was stepped to from the hold before it."""


class Stepped:
    """The holds of one run."""

    def __init__(self) -> None:
        self._holds: deque[_Hold] = deque(maxlen=MOST_HOLDS)
        self._goes_on = False
        self._at: int | None = None
        """The hold to which somebody has gone back; None now."""

    def begin(self) -> None:
        """Another run."""
        self._holds.clear()
        self._goes_on, self._at = False, None

    def held(self, seq: int, sentences: tuple[str, ...], variables: Mapping[str, int]) -> None:
        """It is held, after the event ``seq``, and that was told."""
        self._holds.append(_Hold(seq, sentences, variables, is_next=not self._goes_on))
        self._goes_on, self._at = False, None

    def goes_on(self) -> None:
        """It does more than a step from here."""
        self._goes_on = True

    def back(
        self, timeline: Timeline, now: Mapping[str, int], wording: Wording, *, is_now: bool
    ) -> tuple[str, ...]:
        """What is undone by one step back, ``timeline`` standing where somebody has come to.

        ``now`` are the variables at the end, ``is_now`` whether nobody has gone back yet.
        """
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
