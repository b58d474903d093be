"""A pane: a title and what it is about. The title of the pane with the focus begins with ``>``.

One line to type in, as the command line and the questions have it.

The line in which commands and words are typed. Enter does them, Up and Down recall earlier ones.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import ClassVar, Self

from rich.cells import cell_len, set_cell_size
from textual import events
from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Vertical
from textual.events import Click, DescendantBlur, DescendantFocus
from textual.geometry import Offset, Region
from textual.message import Message
from textual.strip import Strip
from textual.widget import Widget
from textual.widgets import Input, Static

from donnie_tui.core.session_log import LineHistory, Recall
from language.source import cleaned


class Heading(Static):
    """A title, and a mark at the right end that stays visible with a long title."""

    _titles: tuple[str, ...] = ("",)
    _corner = ""

    def write(self, titles: tuple[str, ...], corner: str) -> None:
        """Show the first title that fits, or the beginning of the last, with ``corner`` at the right."""
        self._titles, self._corner = titles, corner
        room = self.size.width - cell_len(corner) - 1
        title = titles[0]
        if corner and room > 1:
            title = next((each for each in titles if cell_len(each) < room), "")
            title = title or f"{set_cell_size(titles[-1], room - 2)}… "
            title = f"{set_cell_size(title, room)}{corner}"
        self.update(title, layout=False)

    def on_resize(self) -> None:
        if self._corner:
            self.write(self._titles, self._corner)


class Pane(Vertical):
    """A titled part of the main screen."""

    class TitleClicked(Message):
        """A click on the title."""

        def __init__(self, pane: Pane) -> None:
            super().__init__()
            self.pane = pane

    def __init__(self, content: Widget, *, id: str) -> None:  # noqa: A002 -- Textual's own name
        super().__init__(id=id)
        self.content = content
        self._titles: tuple[str, ...] = ("",)
        self._corner = ""
        self._heading = Heading(classes="title", markup=False)

    def compose(self) -> ComposeResult:
        yield self._heading
        yield self.content

    def entitle(self, *titles: str, corner: str = "") -> None:
        """Set the title, plain text: the first that fits next to ``corner``, which is at the right."""
        if (titles, corner) != (self._titles, self._corner):
            self._titles, self._corner = titles, corner
            self._write()

    def on_click(self, event: Click) -> None:
        if event.widget is self._heading:
            self.post_message(self.TitleClicked(self))

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
        self._heading.write(tuple(f"{mark}{each}" for each in self._titles), self._corner)


class InputLine(Input):
    """Textual's input line, with a steady cursor at the terminal's own, and plain text."""

    def __init__(self, value: str = "", *, id: str) -> None:  # noqa: A002 -- Textual's own name
        self._painted: tuple[str, int] | None = None
        """The last painted value and cursor, from the first visible column on."""
        super().__init__(value, id=id, compact=True, select_on_focus=False)
        self.cursor_blink = False

    def refresh(
        self, *regions: Region, repaint: bool = True, layout: bool = False, recompose: bool = False
    ) -> Self:
        """Paint only what a key changed: a connection may be slow, and a reader speaks what is painted."""
        changed = self._changed if repaint and not (regions or recompose) else None
        if changed is not None:
            regions, layout = (changed,), False  # the line keeps its size, whatever is typed
        return super().refresh(*regions, repaint=repaint, layout=layout, recompose=recompose)

    @property
    def _changed(self) -> Region | None:
        """The columns that look different; None if all may."""
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
        """The cursor's column, which Textual reports one too far at the end of the text."""
        before = cell_len(self.value[: self.cursor_position].expandtabs(4))
        x, y, _width, _height = self.content_region
        return Offset(x + before - self.scroll_offset.x, y)

    def _on_paste(self, event: events.Paste) -> None:
        super()._on_paste(events.Paste(cleaned(event.text)))
        event.stop()
        event.prevent_default()


class CommandLine(InputLine):
    """A line of input with its history."""

    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("up", "earlier"),
        Binding("down", "later"),
    ]

    class Typed(Message):
        """Posted when a line is finished."""

        def __init__(self, text: str) -> None:
            super().__init__()
            self.text = text

    def __init__(self, *, id: str, send: Callable[[], None] = lambda: None) -> None:  # noqa: A002 -- Textual's
        """``send`` is called before a line leaves the screen."""
        super().__init__(id=id)
        self._send = send
        self.have_typed(LineHistory())

    def have_typed(self, past: LineHistory) -> None:
        """Set the lines that can be recalled."""
        self.past = past
        self._recall = Recall(past)

    def finish(self) -> None:
        """Post the typed line, and clear it."""
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
