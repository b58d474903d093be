"""The sentence that the worker has, the one to be said again, and those that wait.

Rule: the worker has one at a time, so that an alert waits for one sentence and no more.
"""

from __future__ import annotations

from collections.abc import Callable

from devices.ports.audio import Utterance
from devices.ports.values import Frozen
from devices.speech.policy import Offer, SpeechQueue, cuts

MOST_TRIES = 2
"""A sentence that kills two workers is not given to a third."""


class Sentence(Frozen):
    """One that is given to a worker."""

    number: int
    utterance: Utterance
    tries: int
    """This one included."""


class Sentences:
    """What is said, and what is said next. Not thread-safe."""

    def __init__(self, new_number: Callable[[], int]) -> None:
        """``new_number`` tells one try from all others."""
        self._new_number = new_number
        self._queue = SpeechQueue()
        self._present: Sentence | None = None
        self._again: Sentence | None = None

    def __bool__(self) -> bool:
        """Whether something is being said or waits to be said."""
        return self._present is not None or self._again is not None or bool(self._queue)

    @property
    def present(self) -> Sentence | None:
        """The one that the worker has."""
        return self._present

    def is_present(self, number: int) -> bool:
        """Whether the worker has the sentence of this number: what it tells of others came too late."""
        return self._present is not None and self._present.number == number

    def offer(self, utterance: Utterance, now: float) -> Offer:
        return self._queue.offer(utterance, now)

    def are_cut_by(self, utterance: Utterance) -> bool:
        """Whether what is being said ends for ``utterance``."""
        return self._present is not None and cuts(utterance.urgency, self._present.utterance.urgency)

    def take(self) -> Sentence | None:
        """The one to be said now, or None."""
        again, self._again = self._again, None
        if again is not None:
            return again
        utterance = self._queue.next()
        return None if utterance is None else Sentence(self._new_number(), utterance, tries=1)

    def begin(self, sentence: Sentence) -> None:
        """The worker is given it."""
        self._present = sentence

    def end(self) -> None:
        """The worker has none any more."""
        self._present = None

    def save(self) -> None:
        """It is said again from its beginning: heard one and a half times is better than half."""
        present = self._present
        if present is not None and present.tries < MOST_TRIES:
            self._again = Sentence(self._new_number(), present.utterance, present.tries + 1)

    def clear(self) -> None:
        """Nothing waits any more."""
        self._queue.clear()
        self._again = None
