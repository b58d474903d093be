"""The only place that names concrete classes: a session with its world, its robot and its outlets."""

from __future__ import annotations

import sys
from contextlib import ExitStack
from dataclasses import dataclass
from pathlib import Path
from typing import TextIO

import worlds
from devices.ports.robot import Pace, Watcher
from donnie_tui.core.event_stream import JsonLines
from donnie_tui.core.outlets import Cues, Voice
from donnie_tui.core.session import ResettableRobot, Session
from donnie_tui.i18n.words import Words
from donnie_tui.settings import Settings


class Unusable(Exception):
    """A world, file or device that can't be used. ``sentence`` is in the learner's language."""

    def __init__(self, sentence: str) -> None:
        super().__init__(sentence)
        self.sentence = sentence


@dataclass(slots=True)
class Donnie:
    """Everything that a front end works with. ``close`` leaves nothing running."""

    session: Session
    words: Words
    notices: tuple[str, ...]
    """What had to be done without, a sentence each, to be told once."""
    _closing: ExitStack

    def close(self) -> None:
        self._closing.close()
