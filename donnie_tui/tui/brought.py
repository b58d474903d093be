"""What is kept on the way to another world: the open programs, what was said and what was typed."""

from __future__ import annotations

from collections.abc import Mapping

from msgspec import Struct

from donnie_tui.core.answer_log import AnswerLog
from donnie_tui.core.line_history import LineHistory
from donnie_tui.core.workspace import Workspace


class Brought(Struct, frozen=True):
    log: tuple[tuple[str, str], ...]
    """The lines of the log, each with the words of its kind."""
    looks: Mapping[str, str]
    answers: AnswerLog
    typed: LineHistory
    """The lines of the command line."""
    workspace: Workspace
    watched: tuple[str, ...]
    focus: str
    """Which part of the screen somebody was in."""
    is_silent: bool
    """SOUND OFF was said."""
