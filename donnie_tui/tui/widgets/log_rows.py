"""The log. In the plain layout a printed row stays in its place, as a screen reader repeats rows that move.

So a page is filled from above. When the next row has no room, or a command is typed on a page that is half
full, a page without a word comes first, and then the rows on it: a reader compares what it sees, and passes
over a sentence that stood on the page before. A page is held for a while. With the keys of the log, and in
the other layout, all rows can be read as in every other list.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import ClassVar

from textual.binding import Binding, BindingType
from textual.timer import Timer

from donnie_tui.tui.terminal import unskipped
from donnie_tui.tui.widgets.rows import TextRows

REST = 0.3
"""Seconds that a full page stays, so that a reader finds it."""
BREATH = 0.1
"""Seconds that a page stays empty, so that a reader notices."""
_FLOOD = 200
"""More rows at once are not spoken line by line."""
_SHORT = 20
"""Digits of a number to which a full stop is added; a longer one may continue in the next row."""


class LogRows(TextRows):
    """The lines of the log, the newest chosen."""

    BINDINGS: ClassVar[list[BindingType]] = [Binding("f", "app.do('filter')")]

    def __init__(self, *, id: str) -> None:  # noqa: A002 -- Textual's own name
        super().__init__(id=id, follows=True)
        self._is_paged = False
        self._page = 0
        """The first row of the page that is being filled."""
        self._paged = 0
        """The number of rows that have been on a page."""
        self._waiting: Timer | None = None
        """The timer of the next page."""

    def set_paged(self, wanted: bool) -> None:
        """Show pages: without kinds, which a reader would speak, and without rows that scroll."""
        if wanted != self._is_paged:
            self._is_paged = wanted
            self._lay_out()

    def begin_answer(self) -> bool:
        """Begin an answer. Returns whether it comes on a new page, as there is little room."""
        room = self._page + self.size.height - self._paged
        turns = self._fills_pages and self._waiting is None and room * 2 < self.size.height
        if turns:
            self._turn()
        return turns

    # --- pages

    @property
    def _fills_pages(self) -> bool:
        """Whether rows come page by page."""
        return self._is_paged and self._row is None and not self.has_focus

    def _follow(self) -> None:
        if not self._fills_pages:
            super()._follow()
        elif self._waiting is None:
            self._fill()

    def _fill(self) -> None:
        """Show the rows that fit on the page; the rest follows on the next one."""
        self._waiting = None
        rows, height = len(self._rows), self.size.height
        if not height:
            self._paged = rows
        elif rows - self._paged > _FLOOD:
            self._paged = rows - height
            self._turn()
        else:
            first, self._paged = self._paged, max(self._paged, min(rows, self._page + height))
            self._extent(range(first, self._paged))
            self._go_to_page()
            if self._paged < rows:
                self._wait(REST, self._turn)

    def _turn(self) -> None:
        """Show an empty page, then its rows."""
        self._page = self._paged
        self._go_to_page()
        self.refresh()
        self._wait(BREATH, self._fill)

    def _go_to_page(self) -> None:
        self._extent(())
        self.scroll_to(y=self._page, animate=False, force=True, immediate=True)

    def _wait(self, seconds: float, do: Callable[[], None]) -> None:
        """Call ``do`` so many seconds after the page is painted, which may be late on a busy machine."""
        self._give_up_waiting()
        self._waiting = unskipped(self.set_timer(seconds, do, pause=True))
        self.call_after_refresh(self._waiting.resume)

    def _give_up_waiting(self) -> None:
        if self._waiting is not None:
            self._waiting.stop()
            self._waiting = None

    def _show_newest(self) -> None:
        """Show as many of the newest rows as fit, without paging."""
        self._give_up_waiting()
        self._paged = len(self._rows)
        self._page = max(0, self._paged - self.size.height)
        self.refresh()

    def on_resize(self) -> None:
        """Note the new size, before the base class lays out the rows."""
        self._show_newest()

    def watch_has_focus(self, has_focus: bool) -> None:
        """Show all rows while focused; without the focus a reader speaks new rows.

        Rows move as little as possible, since moved rows would be spoken again.
        """
        super().watch_has_focus(has_focus)
        if self._is_paged:
            self._give_up_waiting()
            self._row = self._row if has_focus else None
            self._paged, self._page = len(self._rows), self.scroll_offset.y
            if has_focus:
                self._follow()

    # --- as rows

    def search(self, wanted: str) -> bool:
        """Print the found row: without the focus no reader would speak an older row."""
        return (not self._is_paged or self.has_focus) and super().search(wanted)

    def _forget_oldest(self) -> int:
        rows = super()._forget_oldest()
        self._paged, self._page = max(0, self._paged - rows), max(0, self._page - rows)
        return rows

    def _rewrap(self) -> None:
        super()._rewrap()
        self._show_newest()

    @property
    def _shows_kinds(self) -> bool:
        return not self._is_paged and super()._shows_kinds

    @property
    def _begins_with_kinds(self) -> bool:
        return not self._is_paged and super()._begins_with_kinds

    @property
    def _height(self) -> int:
        rows = len(self._rows)
        return max(rows, self._page + self.size.height) if self._is_paged else rows

    @property
    def _painted_rows(self) -> int:
        return self._paged if self._fills_pages else len(self._rows)

    def _words_of(self, row: int) -> str:
        """The words of a row; a lone number gets a full stop, since Orca takes digits for typed ones."""
        words = super()._words_of(row)
        return f"{words}." if self._is_paged and words.isdecimal() and len(words) <= _SHORT else words
