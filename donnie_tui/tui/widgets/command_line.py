"""The line in which commands and words are typed. Enter does them, Up and Down bring back earlier ones."""

from __future__ import annotations

from collections.abc import Callable
from typing import ClassVar

from textual.binding import Binding, BindingType
from textual.message import Message
from textual.widgets import Input

from donnie_tui.core.recall import Past, Recall
from donnie_tui.tui.widgets.input_line import InputLine


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
        self.have_typed(Past())

    def have_typed(self, past: Past) -> None:
        """These lines can be brought back."""
        self.past = past
        self._recall = Recall(past)

    def finish(self) -> None:
        """Hand over what is typed, and begin anew."""
        text = self.value.strip()
        if text:
            self._send()
        self.value = ""
        if not text:
            return
        self.past.remember(text)
        self._recall = Recall(self.past)
        self.post_message(self.Typed(text))

    def on_input_submitted(self, event: Input.Submitted) -> None:
        event.stop()
        self.finish()

    def action_earlier(self) -> None:
        self._show(self._recall.older(self.value))

    def action_later(self) -> None:
        self._show(self._recall.newer(self.value))

    def _show(self, line: str | None) -> None:
        if line is not None:
            self.value = line
            self.cursor_position = len(line)
