"""The words that may stand at the cursor, in a list below it. Enter takes one, Esc or a letter goes on."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import ClassVar

from rich.cells import cell_len
from textual import events
from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.geometry import Offset
from textual.screen import ModalScreen
from textual.widgets import OptionList

MOST_SEEN = 8


class _Words(OptionList):
    """Textual's, with the terminal's own cursor on the row."""

    @property
    def cursor_screen_offset(self) -> Offset:
        row = (self.highlighted or 0) - self.scroll_offset.y
        return self.content_region.offset + Offset(0, max(0, row))


class Completions(ModalScreen[tuple[str, str]]):
    """Answers the chosen word, empty for none, and the letter that was typed instead."""

    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("escape", "leave", show=False, priority=True),
        Binding("tab", "take", show=False, priority=True),
    ]

    def __init__(self, words: Sequence[str], below: Offset, point: Callable[[str], object]) -> None:
        """``below``: where the cursor is, on the screen; ``point`` says the word that is chosen."""
        super().__init__()
        self._point = point
        self._below = below
        self.list = _Words(*words, id="completions", markup=False, compact=True)
        self._width = max(map(cell_len, words)) + 2
        self._count = len(words)

    def compose(self) -> ComposeResult:
        yield self.list

    def on_mount(self) -> None:
        height = min(self._count, MOST_SEEN, max(1, self.size.height - 2))
        has_room = self._below.y + 1 + height <= self.size.height
        y = self._below.y + 1 if has_room else max(0, self._below.y - height)
        width = min(self._width, self.size.width)
        self.list.styles.width, self.list.styles.height = width, height
        self.list.styles.offset = (max(0, min(self._below.x, self.size.width - width)), y)
        self.list.highlighted = 0
        self.list.focus()

    def on_option_list_option_highlighted(self, event: OptionList.OptionHighlighted) -> None:
        self._point(str(event.option.prompt))

    def on_option_list_option_selected(self, event: OptionList.OptionSelected) -> None:
        self.dismiss((str(event.option.prompt), ""))

    def action_take(self) -> None:
        self.list.action_select()

    def action_leave(self) -> None:
        self.dismiss(("", ""))

    def on_key(self, event: events.Key) -> None:
        if event.is_printable and event.character:
            event.stop()
            self.dismiss(("", event.character))
