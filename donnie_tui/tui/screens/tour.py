"""The tour, a page at a time: Enter turns the page, Backspace turns back, Esc lets one try what it says.

A page is said whole; it is short.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import ClassVar

from textual.binding import Binding, BindingType
from textual.widgets import Static

from devices.ports.values import Frozen
from donnie_tui.tui.screens.help import Help


class Page(Frozen):
    """What stands above it, and its lines."""

    title: str
    lines: tuple[str, ...]


class Tour(Help):
    """Begins at one of ``pages`` and tells ``turned`` where it is, from 0; behind the last one it closes."""

    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("enter,pagedown", "turn(1)", show=False, priority=True),
        Binding("backspace,pageup", "turn(-1)", show=False, priority=True),
    ]

    def __init__(
        self,
        pages: Sequence[Page],
        at: int,
        turned: Callable[[int], None],
        point: Callable[[str], object],
    ) -> None:
        super().__init__(pages[at].title, pages[at].lines, point)
        self._pages, self._at, self._turned = pages, at, turned

    def on_mount(self) -> None:
        self._show()

    def _show(self) -> None:
        page = self._pages[self._at]
        self.query_one("#help-title", Static).update(f" {page.title}")
        self.rows.show(page.lines)
        self.rows.read_line(0)
        self._point(" ".join((f"{page.title}.", *page.lines)))

    def action_turn(self, pages: int) -> None:
        self._at = max(0, self._at + pages)
        self._turned(self._at % len(self._pages))
        if self._at < len(self._pages):
            self._show()
        else:
            self.dismiss(None)
