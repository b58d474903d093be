"""The work, as far as actions need it: what they may ask for, and whom they may tell."""

from __future__ import annotations

from collections.abc import Awaitable, Callable, Sequence
from typing import Protocol, TypeVar

from textual.geometry import Offset

from devices.ports.robot import Pose
from donnie_tui.bootstrap import Donnie
from donnie_tui.core.answer_log import AnswerLog
from donnie_tui.core.completion import Completion
from donnie_tui.core.events import Error
from donnie_tui.core.trail import Trail
from donnie_tui.i18n.words import Words
from donnie_tui.tui.display import Display
from donnie_tui.tui.files import Files
from donnie_tui.tui.key_table import KeyTable
from donnie_tui.tui.preferences import Preferences
from donnie_tui.tui.running import Answer, Running
from donnie_tui.tui.screens.chooser import Choice
from donnie_tui.tui.screens.workplace import Workplace
from donnie_tui.tui.watch import Watch

T = TypeVar("T")


class WorkHost(Protocol):
    """What ``Work`` is to the deeds."""

    words: Words
    workplace: Workplace
    running: Running
    watch: Watch
    files: Files
    display: Display
    preferences: Preferences
    answers: AnswerLog
    trail: Trail
    errors: tuple[Error, ...]

    @property
    def pose(self) -> Pose: ...

    @property
    def donnie(self) -> Donnie: ...

    def robot_chosen(self) -> None: ...

    def to_present(self) -> None: ...

    # --- telling and asking

    def tell(self, answer: Answer | None) -> None: ...

    def tell_sentences(self, *sentences: str) -> None: ...

    def tell_position(self) -> None: ...

    def tell_world(self) -> None: ...

    def show_lines(self, title: str, lines: Sequence[str]) -> None: ...

    def show_manual(self) -> None: ...

    def show_help(self) -> None: ...

    def show_keys_here(self) -> None: ...

    def show_tour(self) -> None: ...

    def change_world(self, name: str) -> None: ...

    @property
    def world_name(self) -> str: ...

    def ask(
        self, asked: str, value: str = "", accepts: Callable[[str], str | None] | None = None
    ) -> Awaitable[str | None]: ...

    def choose(self, title: str, choices: Sequence[Choice]) -> Awaitable[str | None]: ...

    def patiently(self, do: Callable[[], T], slow: Answer) -> Awaitable[T]: ...

    def press_key(self, asked: str, accepts: Callable[[str], str | None]) -> Awaitable[str | None]: ...

    @property
    def key_table(self) -> KeyTable: ...

    def choose_word(self, words: Sequence[str], below: Offset) -> Awaitable[tuple[str, str]]: ...

    # --- the text, the settings, the log

    def typed(self, text: str) -> Awaitable[None] | None: ...

    def completion(self, text: str, at: int) -> Completion: ...

    def check_now(self) -> None: ...

    def prefer(self, key: str, typed: object) -> None: ...

    def open_log(self) -> None: ...

    def save_log(self, name: str) -> None: ...

    # --- the robot

    def show_pose(self) -> None: ...

    def step_back(self) -> None: ...

    def connect(self, argument: str) -> Awaitable[None]: ...

    def feel(self, argument: str) -> None: ...

    # --- the screen

    def look(self) -> None: ...

    def repaint(self) -> None: ...

    def switch_to_linear(self) -> None: ...

    def leave(self) -> None: ...
