"""One line to type in, as the command line and the questions have it."""

from __future__ import annotations

from rich.cells import cell_len
from textual import events
from textual.geometry import Offset
from textual.widgets import Input

from donnie_tui.core.documents import cleaned


class InputLine(Input):
    """Textual's, with a steady cursor where the terminal's own is, and nothing but text."""

    def __init__(self, value: str = "", *, id: str) -> None:  # noqa: A002 -- Textual's own name
        super().__init__(value, id=id, compact=True, select_on_focus=False)
        self.cursor_blink = False

    @property
    def cursor_screen_offset(self) -> Offset:
        """Textual tells one column more at the end of the text; braille displays follow this one."""
        before = cell_len(self.value[: self.cursor_position].expandtabs(4))
        x, y, _width, _height = self.content_region
        return Offset(x + before - self.scroll_offset.x, y)

    def _on_paste(self, event: events.Paste) -> None:
        super()._on_paste(events.Paste(cleaned(event.text)))
        event.stop()
        event.prevent_default()
