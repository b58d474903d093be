"""A pane: a title and what it is about. The title of the pane with the focus begins with ``>``."""

from __future__ import annotations

from textual.app import ComposeResult
from textual.containers import Vertical
from textual.events import DescendantBlur, DescendantFocus
from textual.widget import Widget
from textual.widgets import Static


class Pane(Vertical):
    """One titled part of the workplace."""

    def __init__(self, content: Widget, *, id: str) -> None:  # noqa: A002 -- Textual's own name
        super().__init__(id=id)
        self.content = content
        self._title = ""
        self._heading = Static(classes="title", markup=False)

    def compose(self) -> ComposeResult:
        yield self._heading
        yield self.content

    def entitle(self, title: str) -> None:
        """Another title, plain text."""
        if title != self._title:
            self._title = title
            self._write()

    def on_descendant_focus(self, _event: DescendantFocus) -> None:
        self._choose()

    def on_descendant_blur(self, _event: DescendantBlur) -> None:
        self._choose()

    def _choose(self) -> None:
        # Textual's focus-within stays behind when a list was open between
        self.set_class(self.content.has_focus, "-chosen")
        self._write()

    def _write(self) -> None:
        mark = ">" if self.content.has_focus else " "
        self._heading.update(f"{mark}{self._title}", layout=False)
