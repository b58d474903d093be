"""The program being written: Textual's own editor, with GoDonnie's looks and marks beside the line numbers.

Esc and Tab are left to the screen: Esc runs, Tab goes on to the next pane. ``>`` marks the line that is
being run, ``*`` the lines that called it.
"""

from __future__ import annotations

from typing import ClassVar

from rich.segment import Segment
from rich.style import Style
from textual import events
from textual.binding import Binding, BindingType
from textual.geometry import Offset, Region
from textual.message import Message
from textual.strip import Strip
from textual.widgets import TextArea
from textual.widgets.text_area import TextAreaTheme

from donnie_tui.i18n.sentence import LANGUAGES
from donnie_tui.tui import themes
from donnie_tui.tui.actions import BY_NAME

HERE, CALLER = ">", "*"

LINEAR_WORDS = frozenset(BY_NAME["linear"].word(each).casefold() for each in LANGUAGES)


class Editor(TextArea):
    """The text and its marks."""

    BINDINGS: ClassVar[list[BindingType]] = [Binding("ctrl+a", "select_all", show=False)]

    class LinearTyped(Message):
        """LINEAR and Enter, and nothing else: what the first line of the log asks for."""

    def __init__(self, *, id: str) -> None:  # noqa: A002 -- Textual's own name
        super().__init__(id=id, soft_wrap=True, tab_behavior="focus", show_line_numbers=True)
        self.cursor_blink = False
        self.is_nobodys = True
        """Whether the text is no file's: only there LINEAR and Enter is no text."""
        self._marks: dict[int, str] = {}

    def on_mount(self) -> None:
        self.app.theme_changed_signal.subscribe(self, lambda _: self._wear())
        self._wear()

    def _wear(self) -> None:
        """The looks of the application's theme."""
        name = self.app.theme
        self.register_theme(TextAreaTheme(name=name, syntax_styles=dict(themes.syntax_styles(name))))
        self.theme = name

    # --- typing

    async def _on_key(self, event: events.Key) -> None:
        if event.key == "enter" and self._is_way_to_linear():
            event.stop()
            event.prevent_default()
            self.post_message(self.LinearTyped())

    def _is_way_to_linear(self) -> bool:
        return self.is_nobodys and len(self.text) < 20 and self.text.strip().casefold() in LINEAR_WORDS

    async def _on_paste(self, event: events.Paste) -> None:
        from donnie_tui.core.documents import cleaned  # not for the first frame

        event.prevent_default()
        await super()._on_paste(events.Paste(cleaned(event.text)))

    # --- marks

    def mark(self, line: int | None, callers: frozenset[int] = frozenset()) -> None:
        """Mark the line being run (from 1; None: nothing is run) and those that called it."""
        marks = dict.fromkeys(callers, CALLER)
        if line is not None:
            marks[line] = HERE
        changed = {each for each, _ in self._marks.items() ^ marks.items()}
        self._marks = marks
        self.refresh(*(self._gutter_of(each) for each in changed if each <= self.document.line_count))

    def _gutter_of(self, line: int) -> Region:
        place = self.wrapped_document.location_to_offset((line - 1, 0))
        return Region(0, place.y - self.scroll_offset.y, 1, 1)

    def go_to(self, line: int, column: int = 1) -> None:
        """Put the cursor there, both from 1, as near as there is text."""
        row = min(max(line, 1), self.document.line_count) - 1
        self.move_cursor((row, min(max(column, 1) - 1, len(self.document.get_line(row)))))

    @property
    def line(self) -> int:
        """The cursor's line, from 1."""
        return self.cursor_location[0] + 1

    @property
    def line_count(self) -> int:
        return self.document.line_count

    # --- painting

    @property
    def gutter_width(self) -> int:
        """One column more than Textual's, for the marks."""
        return super().gutter_width + 1

    def render_line(self, y: int) -> Strip:
        strip = super().render_line(y)
        mark = self._mark_at(y)
        if not mark:
            return strip
        style = next(iter(strip)).style or Style()
        return Strip.join([Strip([Segment(mark, style + Style(bold=True))]), strip.crop(1)])

    def _mark_at(self, y: int) -> str:
        row = y + self.scroll_offset.y
        if not self._marks or row >= self.wrapped_document.height:
            return ""
        line, column = self.wrapped_document.offset_to_location(Offset(0, row))
        return self._marks.get(line + 1, "") if column == 0 else ""

    def _build_highlight_map(self) -> None:
        """Textual fills ``_highlights`` from tree-sitter here; a test guards both names."""
        self._line_cache.clear()
        self._highlights.clear()
        text = self.document.text
        if text:
            from donnie_tui.tui.highlighting import highlights  # the lexer: not for the first frame

            self._highlights.update(highlights(text))
