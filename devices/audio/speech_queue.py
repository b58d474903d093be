"""What is said next, and what became of the sentence before. No I/O; times come in as parameters.

Alerts precede answers and SPEAK, which share one queue in the order they came; then progress, then hints.
SPEAK is never reordered or dropped for something newer. Of progress, only the newest is kept. The same text
within half a second is said once, except by SPEAK. The unit is a sentence: an alert that comes in the middle
of a long answer follows the sentence that is being said.

Every queue has a limit. The one for answers and SPEAK is some hours of speech. What exceeds it is refused,
and the refusal is reported: a program that speaks for ever must not use up the memory.
"""

from __future__ import annotations

import re
from collections import deque
from collections.abc import Callable
from enum import Enum, auto

from msgspec import Struct
from msgspec.structs import replace

from devices.ports.audio import Urgency, Utterance

REPEAT_WINDOW = 0.5
"""Seconds within which the same text is said once."""

SENTENCE_LIMIT = 300
"""Characters; longer sentences are cut between words, so silence and alerts never wait for long."""

TEXT_LIMIT = 100_000
"""Characters of one utterance that are spoken at most, almost two hours."""

MOST_TRIES = 2
"""A sentence that kills two workers is not given to a third."""

_RANKS = {Urgency.ALERT: 0, Urgency.ANSWER: 1, Urgency.PROGRAM: 1, Urgency.PROGRESS: 2, Urgency.HINT: 3}
_UTTERANCE_LIMITS = (32, 5_000, 1, 8)
_CHARACTER_LIMIT = 2_000_000
_REMEMBERED_TEXTS = 64
_REMEMBERED_CHARACTERS = 500
_SENTENCE_END = re.compile(r"(?<![.!?…])[.!?…]++[\"'”’)\]]*+\s++|(?<![^\S\r\n])[^\S\r\n]*+[\r\n]\s*+")
"""Each run of signs or blanks is tried once, from its beginning: a text may have thousands in a row."""


class QueueResult(Enum):
    """What became of an utterance."""

    QUEUED = auto()
    REPEATED = auto()
    REFUSED = auto()


class SpeechQueue:
    """The utterances that wait. Not thread-safe: its owner holds a lock."""

    def __init__(self) -> None:
        self._waiting: tuple[deque[Utterance], ...] = tuple(deque() for _ in _UTTERANCE_LIMITS)
        self._characters = 0
        self._recent = _RecentTexts()

    def __len__(self) -> int:
        return sum(len(queue) for queue in self._waiting)

    def offer(self, utterance: Utterance, now: float) -> QueueResult:
        """Queue ``utterance``. It takes the same time whatever its length."""
        if utterance.urgency is not Urgency.PROGRAM and self._recent.contains(utterance, now):
            return QueueResult.REPEATED
        rank = _RANKS[utterance.urgency]
        if not self._make_room(rank):
            return QueueResult.REFUSED
        self._characters += len(utterance.text)
        self._waiting[rank].append(utterance)
        return QueueResult.QUEUED

    def next(self) -> Utterance | None:
        """Take the sentence to be said now, or None."""
        for queue in self._waiting:
            while queue:
                utterance = queue.popleft()
                self._characters -= len(utterance.text)
                sentence, rest = first_sentence(utterance.text[:TEXT_LIMIT])
                if rest:
                    self.put_back(replace(utterance, text=rest))
                if sentence:
                    return replace(utterance, text=sentence)
        return None

    def put_back(self, utterance: Utterance) -> None:
        """Make ``utterance``, which was taken but not finished, the next of its rank."""
        self._characters += len(utterance.text)
        self._waiting[_RANKS[utterance.urgency]].appendleft(utterance)

    def clear(self) -> None:
        """Drop all that wait, and forget the recent texts: after a silence a repetition is wanted."""
        for queue in self._waiting:
            queue.clear()
        self._characters = 0
        self._recent = _RecentTexts()

    def _make_room(self, rank: int) -> bool:
        queue = self._waiting[rank]
        if rank != _RANKS[Urgency.PROGRAM]:
            while len(queue) >= _UTTERANCE_LIMITS[rank]:
                self._characters -= len(queue.popleft().text)
            return True
        return len(queue) < _UTTERANCE_LIMITS[rank] and self._characters < _CHARACTER_LIMIT


def interrupts(incoming: Urgency, speaking: Urgency) -> bool:
    """Whether ``incoming`` ends the sentence being said: an alert does not wait for outdated progress."""
    return incoming is Urgency.ALERT and speaking in (Urgency.PROGRESS, Urgency.HINT)


def first_sentence(text: str) -> tuple[str, str]:
    """The first sentence of ``text``, and the rest; without blanks around the sentence."""
    text = text.lstrip()
    end = _SENTENCE_END.search(text, 0, SENTENCE_LIMIT)
    if end:
        return text[: end.end()].rstrip(), text[end.end() :]
    if len(text) <= SENTENCE_LIMIT:
        return text.rstrip(), ""
    blank = text.rfind(" ", 1, SENTENCE_LIMIT)
    cut = blank if blank > 0 else SENTENCE_LIMIT
    return text[:cut].rstrip(), text[cut:]


class _RecentTexts:
    """The texts of the last half second, a limited number of them, by their beginnings."""

    def __init__(self) -> None:
        self._said: dict[tuple[str, int, str], float] = {}

    def contains(self, utterance: Utterance, now: float) -> bool:
        """Whether the text was said lately; if not, it is remembered."""
        text = utterance.text
        key = (text[:_REMEMBERED_CHARACTERS], len(text), utterance.language)
        last = self._said.get(key)
        if last is not None and now - last < REPEAT_WINDOW:
            return True
        self._said.pop(key, None)
        self._said[key] = now
        while len(self._said) > _REMEMBERED_TEXTS:
            del self._said[next(iter(self._said))]
        return False


class SpokenSentence(Struct, frozen=True):
    """A sentence that is given to a worker."""

    number: int
    utterance: Utterance
    tries: int
    """This one included."""


class SentenceTracker:
    """The sentence that the worker has, the one to be said again, and the queue. Not thread-safe.

    The worker has one sentence at a time, so an alert waits for one sentence at most.
    """

    def __init__(self, new_number: Callable[[], int]) -> None:
        """``new_number`` returns a different number for each try."""
        self._new_number = new_number
        self._queue = SpeechQueue()
        self.current: SpokenSentence | None = None
        """The sentence that the worker has."""
        self._again: SpokenSentence | None = None

    def __bool__(self) -> bool:
        """Whether a sentence is being said or waits."""
        return self.current is not None or self._again is not None or bool(self._queue)

    def is_current(self, number: int) -> bool:
        """Whether the worker has the sentence of this number: responses about others come too late."""
        return self.current is not None and self.current.number == number

    def offer(self, utterance: Utterance, now: float) -> QueueResult:
        return self._queue.offer(utterance, now)

    def is_interrupted_by(self, utterance: Utterance) -> bool:
        """Whether the current sentence must end for ``utterance``."""
        return self.current is not None and interrupts(utterance.urgency, self.current.utterance.urgency)

    def take(self) -> SpokenSentence | None:
        """The sentence to be said now, or None."""
        again, self._again = self._again, None
        if again is not None:
            return again
        utterance = self._queue.next()
        return None if utterance is None else SpokenSentence(self._new_number(), utterance, tries=1)

    def retry(self) -> None:
        """Say the current sentence again from its beginning: hearing it one and a half times is better than
        half."""
        current = self.current
        if current is not None and current.tries < MOST_TRIES:
            self._again = SpokenSentence(self._new_number(), current.utterance, current.tries + 1)

    def clear(self) -> None:
        """Drop all sentences that wait."""
        self._queue.clear()
        self._again = None
