"""What is said next (speech specification, S4 and S7). Pure: time comes in as a parameter.

Alerts go before answers and SPEAK, which share one line in the order they came, before progress, before
hints. SPEAK is never reordered nor thrown out for something newer; of progress only the newest is kept;
the same text within half a second is said once, SPEAK excepted. The unit is a sentence: an alert that
comes in the middle of a long answer is heard after the sentence that is being said.

Everything has a bound. The one for answers and SPEAK is some hours of speech; what comes beyond it is
refused and the refusal is told, because a program that speaks for ever must not eat the memory.
"""

from __future__ import annotations

import re
from collections import deque
from enum import Enum, auto

from devices.ports.audio import Urgency, Utterance
from devices.ports.values import replace

REPEAT_WINDOW = 0.5
"""Seconds within which the same text is said once (S7)."""

SENTENCE_LIMIT = 300
"""Characters; longer ones are cut between words so that silence and alerts never wait for long."""

TEXT_LIMIT = 100_000
"""Characters of one utterance that are spoken at most, almost two hours."""

_RANKS = {Urgency.ALERT: 0, Urgency.ANSWER: 1, Urgency.PROGRAM: 1, Urgency.PROGRESS: 2, Urgency.HINT: 3}
_UTTERANCE_LIMITS = (32, 5_000, 1, 8)
_CHARACTER_LIMIT = 2_000_000
_REMEMBERED_TEXTS = 64
_REMEMBERED_CHARACTERS = 500
_SENTENCE_END = re.compile(r"[.!?…]+[\"'”’)\]]*\s+|\s*[\r\n]+\s*")


class Offer(Enum):
    """What became of an utterance."""

    QUEUED = auto()
    REPEATED = auto()
    REFUSED = auto()


class SpeechQueue:
    """What waits to be said. Not thread-safe: its owner holds a lock."""

    def __init__(self) -> None:
        self._waiting: tuple[deque[Utterance], ...] = tuple(deque() for _ in _UTTERANCE_LIMITS)
        self._characters = 0
        self._recent = _RecentTexts()

    def __len__(self) -> int:
        return sum(len(line) for line in self._waiting)

    def offer(self, utterance: Utterance, now: float) -> Offer:
        """Put ``utterance`` in its place at ``now`` seconds; its length does not matter for how long."""
        if utterance.urgency is not Urgency.PROGRAM and self._recent.seen(utterance, now):
            return Offer.REPEATED
        rank = _RANKS[utterance.urgency]
        if not self._make_room(rank):
            return Offer.REFUSED
        self._append(rank, utterance)
        return Offer.QUEUED

    def next(self) -> Utterance | None:
        """Take the sentence to be said now, or None."""
        for line in self._waiting:
            while line:
                utterance = line.popleft()
                self._characters -= len(utterance.text)
                sentence, rest = first_sentence(utterance.text[:TEXT_LIMIT])
                if rest:
                    self.put_back(replace(utterance, text=rest))
                if sentence:
                    return replace(utterance, text=sentence)
        return None

    def put_back(self, utterance: Utterance) -> None:
        """Let ``utterance``, taken but not heard to its end, be the next of its rank."""
        self._characters += len(utterance.text)
        self._waiting[_RANKS[utterance.urgency]].appendleft(utterance)

    def clear(self) -> None:
        """Forget everything that waits, and what was said lately: after a silence, again means again."""
        for line in self._waiting:
            line.clear()
        self._characters = 0
        self._recent = _RecentTexts()

    def _make_room(self, rank: int) -> bool:
        line = self._waiting[rank]
        if rank != _RANKS[Urgency.PROGRAM]:
            while len(line) >= _UTTERANCE_LIMITS[rank]:
                self._characters -= len(line.popleft().text)
            return True
        return len(line) < _UTTERANCE_LIMITS[rank] and self._characters < _CHARACTER_LIMIT

    def _append(self, rank: int, utterance: Utterance) -> None:
        self._characters += len(utterance.text)
        self._waiting[rank].append(utterance)


def cuts(incoming: Urgency, speaking: Urgency) -> bool:
    """Whether ``incoming`` ends the sentence being said: an alert does not wait for stale progress."""
    return incoming is Urgency.ALERT and speaking in (Urgency.PROGRESS, Urgency.HINT)


def first_sentence(text: str) -> tuple[str, str]:
    """The first sentence of ``text`` and the rest, both without blanks around them."""
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
    """The texts of the last half second, a few of them, by their beginnings."""

    def __init__(self) -> None:
        self._said: dict[tuple[str, int, str], float] = {}

    def seen(self, utterance: Utterance, now: float) -> bool:
        text = utterance.text
        key = (text[:_REMEMBERED_CHARACTERS], len(text), utterance.language)
        last = self._said.get(key)
        if last is not None and now - last < REPEAT_WINDOW:
            return True
        self._remember(key, now)
        return False

    def _remember(self, key: tuple[str, int, str], now: float) -> None:
        self._said.pop(key, None)
        self._said[key] = now
        while len(self._said) > _REMEMBERED_TEXTS:
            del self._said[next(iter(self._said))]
