"""The work, as far as its parts need it: what they may ask for, and whom they may tell."""

from __future__ import annotations

from collections.abc import Awaitable
from typing import Protocol

from devices.ports.robot import Pose
from donnie_tui.bootstrap import Donnie
from donnie_tui.commands.context import Context
from donnie_tui.commands.keys import KeyTable
from donnie_tui.core.answer_log import AnswerLog
from donnie_tui.core.workspace import Workspace
from donnie_tui.i18n.words import Words
from donnie_tui.tui.display import Display
from donnie_tui.tui.screens.workplace import Workplace
from donnie_tui.tui.talk import Talk


class Workbench(Protocol):
    """What ``Work`` is to its parts."""

    words: Words
    workplace: Workplace
    talk: Talk
    workspace: Workspace
    display: Display
    answers: AnswerLog
    ctx: Context

    @property
    def program_name(self) -> str: ...

    @property
    def pose(self) -> Pose: ...

    @property
    def donnie(self) -> Donnie: ...

    @property
    def key_table(self) -> KeyTable: ...

    # --- typing and choosing

    def typed(self, text: str) -> Awaitable[None] | None: ...

    def apply_setting(self, key: str) -> None: ...

    # --- the screen

    def look(self) -> None: ...

    def ask_distances(self) -> None: ...

    def repaint(self) -> None: ...

    # --- ways out

    def change_world(self, name: str) -> None: ...

    def switch_to_linear(self) -> None: ...

    def leave(self) -> None: ...
