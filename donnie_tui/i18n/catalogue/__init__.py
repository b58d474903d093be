"""The one catalogue of sentences, a module a topic. A code is unique over all of them (a test holds it).

A session needs a few topics, and to load all thirty took a tenth of its start: each is loaded with the first
of its sentences that is wanted.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from importlib import import_module

from donnie_tui.i18n.sentence import Sentence

TOPICS = (
    "movement",
    "linear",
    "answers",
    "cli",
    "robot_line",
    "surroundings",
    "mistakes",
    "summing",
    "stepping",
    "robots",
    "things",
    "worlds",
    "note",
    "tui",
    "screen",
    "setting",
    "choosing",
    "keys",
    "slow",
    "use_cases",
    "help",
    "sounding",
    "cues",
    "belt",
    "devices",
    "files",
    "reasons",
    "scenarios",
    "sensors",
    "signs",
    "recordings",
    "explain",
    "tour",
    "screen_tour",
    "manual",
    "doctor",
    "doctor_speech",
)
"""What is wanted most comes first: they are looked through in this order."""


class _Catalogue(Mapping[str, Sentence]):
    """All sentences by code."""

    def __init__(self) -> None:
        self._found: dict[str, Sentence] = {}
        self._topics = dict.fromkeys(TOPICS)
        """Those that were not loaded yet."""

    def __getitem__(self, code: str) -> Sentence:
        if code not in self._found:
            self._look_for(code)
        return self._found[code]

    def __iter__(self) -> Iterator[str]:
        for topic in TOPICS:
            yield from self._load(topic)

    def __len__(self) -> int:
        return sum(len(self._load(topic)) for topic in TOPICS)

    def _look_for(self, code: str) -> None:
        """Most codes begin with the name of their topic."""
        likely, _, _ = code.partition("-")
        waiting = list(self._topics)
        for topic in sorted(waiting, key=lambda topic: not topic.startswith(likely)):
            if code in self._load(topic):
                return

    def _load(self, topic: str) -> dict[str, Sentence]:
        sentences: dict[str, Sentence] = import_module(f"{__name__}.{topic}").SENTENCES
        self._found |= sentences
        self._topics.pop(topic, None)
        return sentences


SENTENCES: Mapping[str, Sentence] = _Catalogue()
