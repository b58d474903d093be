"""Between whom the work stands: the application, as far as the work needs it, and the work, as far as its
parts need it. What they may ask for, and whom they may tell.
"""

from __future__ import annotations

from collections.abc import Awaitable, Callable, Coroutine, Sequence
from typing import Protocol, TypeVar

from textual.geometry import Offset
from textual.message import Message
from textual.timer import Timer

from devices.ports.robot import Pose
from donnie_tui.bootstrap import Donnie
from donnie_tui.core.answer_log import AnswerLog
from donnie_tui.core.trail import Trail
from donnie_tui.core.watching import Watch
from donnie_tui.i18n.words import Words
from donnie_tui.settings.chosen import Settings
from donnie_tui.tui.display import Display
from donnie_tui.tui.files import Files
from donnie_tui.tui.key_table import KeyTable
from donnie_tui.tui.preferences import Preferences
from donnie_tui.tui.running import Answer, Running
from donnie_tui.tui.screens.chooser import Choice
from donnie_tui.tui.screens.tour import Page
from donnie_tui.tui.screens.workplace import Workplace

T = TypeVar("T")


class Host(Protocol):
    """The application, as far as the work needs it."""

    @property
    def workplace(self) -> Workplace: ...

    @property
    def key_table(self) -> KeyTable: ...

    def post_message(self, message: Message) -> bool: ...

    def later(self, seconds: float, do: Callable[[], None]) -> Timer: ...

    def every(self, seconds: float, do: Callable[[], None]) -> Timer: ...

    def ask(
        self, asked: str, keys: str, value: str, accepts: Callable[[str], str | None] | None
    ) -> Awaitable[str | None]: ...

    def choose(
        self, title: str, keys: str, nothing: str, choices: Sequence[Choice]
    ) -> Awaitable[str | None]: ...

    def press_key(
        self, asked: str, keys: str, behind: str, accepts: Callable[[str], str | None]
    ) -> Awaitable[str | None]: ...

    def choose_word(self, words: Sequence[str], below: Offset) -> Awaitable[tuple[str, str]]: ...

    def show_help(
        self, title: str, lines: tuple[str, ...], further: Callable[[], None] | None = None
    ) -> None: ...

    def show_tour(self, pages: Sequence[Page], at: int, turned: Callable[[int], None]) -> None: ...

    def show_outside(self, text: str) -> Answer | None: ...

    def begin_with(self, opening: Coroutine[None, None, None]) -> None: ...

    def wear(self, settings: Settings) -> None: ...

    def enter_world(self, name: str) -> None: ...

    def repaint(self) -> None: ...

    def leave(self, code: int = 0, *, for_linear: bool = False) -> None: ...


class Workbench(Protocol):
    """What ``Work`` is to its parts."""

    words: Words
    workplace: Workplace
    running: Running
    watch: Watch
    files: Files
    display: Display
    preferences: Preferences
    answers: AnswerLog
    trail: Trail

    @property
    def pose(self) -> Pose: ...

    @property
    def donnie(self) -> Donnie: ...

    # --- telling and asking

    def tell(self, answer: Answer | None) -> None: ...

    def tell_sentences(self, *sentences: str) -> None: ...

    def change_world(self, name: str) -> None: ...

    def ask(
        self, asked: str, value: str = "", accepts: Callable[[str], str | None] | None = None
    ) -> Awaitable[str | None]: ...

    def choose(self, title: str, choices: Sequence[Choice]) -> Awaitable[str | None]: ...

    def patiently(self, do: Callable[[], T], slow: Answer) -> Awaitable[T]: ...

    def press_key(self, asked: str, accepts: Callable[[str], str | None]) -> Awaitable[str | None]: ...

    @property
    def key_table(self) -> KeyTable: ...

    def choose_word(self, words: Sequence[str], below: Offset) -> Awaitable[tuple[str, str]]: ...

    # --- typing and choosing

    def typed(self, text: str) -> Awaitable[None] | None: ...

    def prefer(self, key: str, typed: object) -> None: ...

    # --- the screen

    def look(self) -> None: ...

    def ask_distances(self) -> None: ...

    def repaint(self) -> None: ...

    def switch_to_linear(self) -> None: ...

    def leave(self) -> None: ...
