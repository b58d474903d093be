"""The one reason for which Donnie does not start what it was asked for."""

from __future__ import annotations


class Unusable(Exception):
    """A world, file or device that can't be used. ``sentence`` is in the learner's language."""

    def __init__(self, sentence: str) -> None:
        super().__init__(sentence)
        self.sentence = sentence
