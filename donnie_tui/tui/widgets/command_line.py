"""The line in which commands and words are typed. Enter does them, Up and Down bring back earlier ones."""

from __future__ import annotations

from collections.abc import Callable
from typing import ClassVar

from textual.binding import Binding, BindingType
from textual.message import Message
from textual.widgets import Input

from donnie_tui.tui.widgets.input_line import InputLine

MOST_REMEMBERED = 500


class CommandLine(InputLine):
    """One line of input with its past."""

    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("up", "earlier", show=False),
        Binding("down", "later", show=False),
    ]

    class Typed(Message):
        """A line was finished."""

        def __init__(self, text: str) -> None:
            super().__init__()
            self.text = text

    def __init__(self, *, id: str, send: Callable[[], None] = lambda: None) -> None:  # noqa: A002 -- Textual's
        """``send`` is told before a line leaves the screen."""
        super().__init__(id=id)
        self._send = send
        self._past: list[str] = []
        self._place = 0

    @property
    def past(self) -> tuple[str, ...]:
        """The lines that were typed, the last one last."""
        return tuple(self._past)

    def finish(self) -> None:
        """Hand over what is typed, and begin anew."""
        text = self.value.strip()
        if text:
            self._send()
        self.value = ""
        if not text:
            return
        if self._past[-1:] != [text]:
            self._past.append(text)
            del self._past[:-MOST_REMEMBERED]
        self._place = len(self._past)
        self.post_message(self.Typed(text))

    def on_input_submitted(self, event: Input.Submitted) -> None:
        event.stop()
        self.finish()

    def action_earlier(self) -> None:
        self._recall(max(0, self._place - 1))

    def action_later(self) -> None:
        self._recall(min(len(self._past), self._place + 1))

    def _recall(self, place: int) -> None:
        self._place = place
        self.value = self._past[place] if place < len(self._past) else ""
        self.cursor_position = len(self.value)
