"""One line to type in, as the command line and the questions have it."""

from __future__ import annotations

from typing import Self

from rich.cells import cell_len
from textual import events
from textual.geometry import Offset, Region
from textual.strip import Strip
from textual.widgets import Input

from donnie_tui.core.harmless import cleaned


class InputLine(Input):
    """Textual's, with a steady cursor where the terminal's own is, and nothing but text."""

    def __init__(self, value: str = "", *, id: str) -> None:  # noqa: A002 -- Textual's own name
        self._painted: tuple[str, int] | None = None
        """Value and cursor as they were painted last, from the first column on."""
        super().__init__(value, id=id, compact=True, select_on_focus=False)
        self.cursor_blink = False

    def refresh(
        self, *regions: Region, repaint: bool = True, layout: bool = False, recompose: bool = False
    ) -> Self:
        """Only what a key changed: over a slow line each byte counts, and a reader reads what is painted."""
        changed = self._changed if repaint and not (regions or recompose) else None
        if changed is not None:
            regions, layout = (changed,), False  # the line keeps its size, whatever is typed
        return super().refresh(*regions, repaint=repaint, layout=layout, recompose=recompose)

    @property
    def _changed(self) -> Region | None:
        """The columns that look different; None where that may be all of them."""
        if not self.is_mounted or self._painted is None:
            return None
        value, cursor = self._painted
        typed, now = self.value, self.cursor_position
        if (typed, now) == (value, cursor) or self.scroll_offset.x or not (value + typed).isascii():
            return None
        same = next(
            (at for at, (one, other) in enumerate(zip(value, typed, strict=False)) if one != other), None
        )
        first = min(cursor, now, min(len(value), len(typed)) if same is None else same)
        last = max(cursor, now, *((len(value), len(typed)) if value != typed else ()))
        return Region(first, 0, last - first + 1, 1)

    def render_line(self, y: int) -> Strip:
        self._painted = None if self.scroll_offset.x else (self.value, self.cursor_position)
        return super().render_line(y)

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
