"""The application, as far as the work needs it."""

from __future__ import annotations

from collections.abc import Awaitable, Callable, Coroutine, Sequence
from typing import Protocol

from textual.geometry import Offset
from textual.message import Message
from textual.timer import Timer

from donnie_tui.commands.interaction import Option
from donnie_tui.commands.keys import KeyTable
from donnie_tui.settings.settings import Settings
from donnie_tui.tui.answer import Answer
from donnie_tui.tui.screens.pages import Page
from donnie_tui.tui.screens.workplace import Workplace


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
        self, title: str, keys: str, nothing: str, choices: Sequence[Option]
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
