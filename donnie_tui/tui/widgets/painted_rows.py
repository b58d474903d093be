"""A window on rows that are painted one by one, in the looks of the theme."""

from __future__ import annotations

from rich.style import Style
from textual.scroll_view import ScrollView

from donnie_tui.tui import themes


class PaintedRows(ScrollView):
    """Knows what its looks are: worked out once, until the styles are others. Each row asks for them."""

    def __init__(self, *, id: str) -> None:  # noqa: A002 -- Textual's own name
        super().__init__(id=id)
        self._looks: dict[str, Style] = {}

    def notify_style_update(self) -> None:
        self._looks = {}
        super().notify_style_update()

    def painted_as(self, name: str = "") -> Style:
        """A look of that name (see ``themes``) on the background that there is; without one, plain text."""
        if name not in self._looks:
            base = self.rich_style
            self._looks[name] = base + themes.looks(self.app.theme)[name] if name else base
        return self._looks[name]
