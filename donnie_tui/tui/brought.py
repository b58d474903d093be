"""What goes along to another world at the screen: what was told and typed before, and the breakpoints."""

from __future__ import annotations

from collections.abc import Mapping

from devices.ports.values import Frozen
from donnie_tui.core.answer_log import AnswerLog
from donnie_tui.core.recall import Past


class Brought(Frozen):
    """The program itself goes along as from the other mode."""

    log: tuple[tuple[str, str], ...]
    """The lines of the log, each with the words of its kind."""
    looks: Mapping[str, str]
    answers: AnswerLog
    typed: Past
    """The lines of the command line."""
    breakpoints: frozenset[int]
    watched: tuple[str, ...]
    focus: str
    """Which part of the screen somebody was in."""
    is_silent: bool
    """SOUND OFF was said."""
