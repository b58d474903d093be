"""A question at the bottom of the screen, answered by typing. Esc goes back.

A list to choose from: the palette, worlds, robots, recent programs, the outline, settings.

Typing narrows it, Up and Down, Home and End move, Enter chooses, Esc goes back. The terminal's own cursor
stands on the row that Enter would choose, and ``>`` before it.

The words that may stand at the cursor, in a list below it. Enter takes one, Esc or a letter continues.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Sequence
from typing import ClassVar, TypeVar

from rich.cells import cell_len
from textual import events
from textual.app import ComposeResult
from textual.await_complete import AwaitComplete
from textual.binding import Binding, BindingType
from textual.containers import Horizontal, Vertical
from textual.geometry import Offset, Region, Size
from textual.message import Message
from textual.screen import ModalScreen
from textual.widget import Widget
from textual.widgets import Input, OptionList, Static

from donnie_tui.commands.interaction import Option
from donnie_tui.tui.widgets.command_line import InputLine
from donnie_tui.tui.widgets.rows import (
    LOWEST,
    BottomKeys,
    TextRows,
    WheelRows,
    rows_always_seen,
)

MOST_SEEN = 8
"""Rows of a list of proposed answers."""


_HIGH = 20
"""With that many rows, the titles of the panes stay visible above a panel."""

T = TypeVar("T")


class Dialog(ModalScreen[T]):
    """A screen in front of the main one. Only its first answer counts."""

    def dismiss(self, result: T | None = None) -> AwaitComplete:
        """Close only this dialog: after a second answer Textual would close another screen."""
        return super().dismiss(result) if self.is_active else AwaitComplete()

    def fit(self, panel: Widget, *, covers_command_line: bool = False) -> Size:
        """Keep a panel where the panes of the main screen are, and return the room for it.

        The state stays in sight below, and on a high screen a title above. The dialog's own keys are where
        those of the main screen are. In the plain layout there is one thing at a time.
        """
        size = self.app.size
        above, below = (0, 0) if self.is_alone else (int(size.height >= _HIGH), rows_always_seen(size))
        keys = len(self.query(BottomKeys))
        below = max(0, below - keys - covers_command_line)
        panel.styles.margin = (above, 0, below, 0)
        return Size(size.width, size.height - above - below - keys)

    @property
    def is_alone(self) -> bool:
        """Whether nothing else is seen, as in the plain layout."""
        return self.app.screen_stack[0].has_class("-plain")


class Panel(Dialog[T]):
    """A panel in front of the panes. A click next to it goes back, as in other programs.

    The second half of a double click that opened it does not.
    """

    _was_pressed = False
    """Whether the mouse was pressed since the panel opened."""

    def on_mouse_down(self) -> None:
        self._was_pressed = True

    def on_click(self, event: events.Click) -> None:
        is_new = self._was_pressed and event.chain == 1
        if is_new and self.get_widget_at(*event.screen_offset)[0] is self:
            self.dismiss(None)


class Question(Dialog[str | None]):
    """Asks for one line; None after Esc. ``accepts`` returns what is wrong with an answer, or None.

    ``answers`` are a list above the line: Up, Down or a click chooses one, Tab writes it.
    """

    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("escape", "dismiss", priority=True),
        Binding("up", "choose_row(-1)", priority=True),
        Binding("down", "choose_row(1)", priority=True),
        Binding("tab", "write_row", priority=True),
    ]
    AUTO_FOCUS = "#answer"

    def __init__(
        self,
        asked: str,
        keys: str,
        point: Callable[[str], object],
        *,
        value: str = "",
        accepts: Callable[[str], str | None] | None = None,
        answers: Sequence[str] = (),
    ) -> None:
        """``point`` says what is asked."""
        super().__init__()
        self._point = point
        self._asked = asked
        self._keys = keys
        self._value = value
        self._accepts = accepts
        self._list = _Answers(answers) if answers else None
        self._line = InputLine(value, id="answer")
        self._panel = Vertical(id="question")

    def compose(self) -> ComposeResult:
        with self._panel:
            yield Static(self._asked, id="asked", markup=False)
            if self._list is not None:
                yield self._list
            yield self._line
        yield BottomKeys(self._keys)

    def on_mount(self) -> None:
        self._line.select_all()  # what is proposed is typed over
        self._point(f"{self._asked} {self._value}".strip())
        self.on_resize()

    def on_resize(self) -> None:
        room = self.fit(self._panel, covers_command_line=True)
        if self._list is not None:
            self._list.offer(max(0, room.height - 4))

    def on_input_changed(self, event: Input.Changed) -> None:
        if self._list is not None and event.value != self._value:
            self._list.leave()

    def action_choose_row(self, down: int) -> None:
        if self._list is not None:
            self._list.choose(down)
            self._point(self._list.row_text)

    def action_write_row(self) -> None:
        """Write the chosen row, or the first one, into the line."""
        if self._list is not None:
            line = self._line
            line.value = self._list.row_text
            line.cursor_position = len(line.value)

    def on_clickable_rows_clicked(self, event: ClickableRows.Clicked) -> None:
        assert self._list is not None
        self._list.choose_line(event.line)
        self._answer(self._list.row_text)

    def on_input_submitted(self, event: Input.Submitted) -> None:
        event.stop()
        is_listed = self._list is not None and self._list.is_chosen
        self._answer(self._list.row_text if self._list is not None and is_listed else event.value.strip())

    def _answer(self, answer: str) -> None:
        wrong = self._accepts(answer) if self._accepts else None
        if wrong:
            self.query_one("#asked", Static).update(wrong)
            self._line.select_all()
            self._point(wrong)
        else:
            self.dismiss(answer)


FAR = 10**6
"""More rows than any list has."""


def _rank(text: str, typed: str) -> int:
    """The rank of an option for the typed letters; ``text`` has its name, and below its other words.

    The exact name comes first, then another word for it, the beginning of a name, a word, a part of one.
    """
    if text.startswith(typed) and text[len(typed) :].strip()[:1] in ("", "(", ":", ","):
        return 0
    if re.search(rf"\n.*\b{re.escape(typed)}\b", text):
        return 1
    if text.startswith(typed):
        return 2
    return 3 if re.search(rf"\b{re.escape(typed)}\b", text) else 4


class ClickableRows(TextRows):
    """Rows of which a click takes one."""

    class Clicked(Message):
        """A line was clicked."""

        def __init__(self, line: int) -> None:
            super().__init__()
            self.line = line

    def on_click(self, event: events.Click) -> None:
        """Post the clicked line, if there is one."""
        place = event.get_content_offset(self)
        row = self.scroll_offset.y + place.y if place is not None else self.row_count
        if row < self.row_count:
            self._read(row)
            self.post_message(self.Clicked(self.line))


class _Rows(ClickableRows, can_focus=False):
    """Rows with one chosen row; the focus stays in the input line."""

    @property
    def is_read(self) -> bool:
        return True


class _Answers(_Rows):
    """Proposed answers to a question. None is chosen at first: Enter takes the typed text."""

    def __init__(self, answers: Sequence[str]) -> None:
        super().__init__(id="answers")
        self._answers = answers
        self.is_chosen = False
        self.styles.height = 0

    @property
    def is_read(self) -> bool:
        return self.is_chosen

    def offer(self, most: int) -> None:
        """Show at most that many rows."""
        self.show(self._answers)
        self.styles.height = min(len(self._answers), most)

    def leave(self) -> None:
        """Choose no row."""
        self.is_chosen = False
        self._read(0)

    def choose(self, down: int) -> None:
        """Choose the next or previous row, at first the first one."""
        self.choose_line(min(max(0, self.line + down), len(self.lines) - 1) if self.is_chosen else 0)

    def choose_line(self, line: int) -> None:
        self.is_chosen = True
        self.read_line(line)


class _Narrowing(InputLine):
    """The line whose text narrows the list; the cursor is on the chosen row."""

    def __init__(self, rows: _Rows) -> None:
        super().__init__(id="narrowing")
        self._rows = rows
        self.points_at_row = True

    @property
    def cursor_screen_offset(self) -> Offset:
        return self._rows.cursor_screen_offset if self.points_at_row else super().cursor_screen_offset


class _Detail(TextRows, can_focus=False):
    """Details of the chosen row."""

    class Resized(Message):
        """The size for the details has changed."""

    def on_resize(self) -> None:
        super().on_resize()
        self.post_message(self.Resized())


_LEAST_PANEL, _DETAIL, _MOST_DETAIL = 56, 40, 90
"""Columns: the least of a panel, the least and the most of the details next to a list."""
LEAST_REST = 8
"""Columns left next to a panel, if any are."""
_LEAST_BOTH = 6
"""With that many rows, the details may be below the list, if there is no room next to it."""
_DETAIL_ROWS, _LOW, _LEAST_TYPED = 16, 12, 12
"""The least rows of the details; the rows below which the input line is next to the title, and the least
columns of it there."""


_COLUMN_GAP, _FEW = 2, 4
"""Blanks between columns; one choice in that many may have a name longer than its column."""


def _columns(choices: Sequence[Option]) -> tuple[int, ...]:
    """The widths of columns, with the gap between them; empty if a choice has none."""
    rows = [each.columns or ((each.text,) if each.detail is not None else ()) for each in choices]
    if not rows or not all(rows):
        return ()
    cells = [[row[at] for row in rows if at < len(row)] for at in range(max(map(len, rows)))]
    return tuple(max(map(cell_len, column)) + _COLUMN_GAP for column in cells)


class Chooser(Panel[str | None]):
    """Answers the value of the chosen row, None if the learner went back."""

    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("escape,ctrl+q", "dismiss", priority=True),
        Binding("up", "choose_row(-1)", priority=True),
        Binding("down", "choose_row(1)", priority=True),
        Binding("pageup", "choose_row(-10)", priority=True),
        Binding("pagedown", "choose_row(10)", priority=True),
        Binding("home", f"choose_row({-FAR})", priority=True),
        Binding("end", f"choose_row({FAR})", priority=True),
    ]
    AUTO_FOCUS = "#narrowing"

    def __init__(
        self,
        title: str,
        keys: str,
        nothing: str,
        choices: Sequence[Option],
        point: Callable[[str], object],
        *,
        is_plain: bool = False,
    ) -> None:
        """``nothing`` is shown if no row fits the typed text; ``point`` speaks the chosen row.

        A plain list has the whole screen, and rows of text.
        """
        super().__init__(classes="-plain" if is_plain else "")
        self._title_words, self._nothing = title, nothing
        self._choices = tuple(choices)
        self._fitting = self._choices
        self._point = point
        self.rows = _Rows(id="choices")
        self._typed = _Narrowing(self.rows)
        self._panel, self._listing = Vertical(id="panel"), Horizontal(id="listing")
        self._heading = Vertical(id="heading")
        self._keys = BottomKeys(keys)
        self._has_details = not is_plain and any(each.detail is not None for each in choices)
        may_drop = not is_plain and any(len(each.columns) > 1 for each in choices)
        self._detail = _Detail(id="detail") if self._has_details or may_drop else None
        self._columns: tuple[int, ...] = ()
        """The widths of the columns in the list, the others are in the details; empty if rows are texts."""

    def compose(self) -> ComposeResult:
        with self._panel:
            with self._heading:
                yield Static(f" {self._title_words} ", classes="screen-title", markup=False)
                yield self._typed
            with self._listing:
                yield self.rows
                if self._detail is not None:
                    yield self._detail
        yield self._keys

    def on_mount(self) -> None:
        self._lay_out()
        current = next((at for at, each in enumerate(self._choices) if each.is_current), 0)
        self.rows.read_line(current)
        self._say_row(f"{self._title_words} ")

    def on_resize(self) -> None:
        line = self.rows.line
        self._lay_out()
        self.rows.read_line(line)
        self._show_detail()

    def _lay_out(self) -> None:
        """Make the panel as large as its list; it keeps this size while the list is narrowed."""
        width, height = self.fit(self._panel)
        is_low = height < _LOW and cell_len(self._title_words) + _LEAST_TYPED <= width
        self._heading.set_class(is_low and not self.has_class("-plain"), "-low")
        height -= 1 if is_low else 2
        columns = () if self.has_class("-plain") else _columns(self._choices)
        if self._has_details:
            room = width - (_DETAIL + 1)
            is_below = room < sum(columns) <= width - 1 and height >= _LEAST_BOTH
            self._columns = columns if is_below or sum(columns) <= room else ()
        else:
            self._columns = self._columns_in(width - 1, columns, may_drop=height >= _LEAST_BOTH)
            is_below = 0 < len(self._columns) < len(columns)
        self._listing.set_class(is_below, "-below")
        self._show()
        has_detail = bool(self._columns) and (self._has_details or is_below)
        if self._detail is not None:
            self._detail.display = has_detail
        if self.has_class("-plain"):
            return
        row_widths = [cell_len(self._row(each)) for each in self._choices]
        listing = max(cell_len(self._title_words) + 2, _LEAST_PANEL)
        rows = len(self._choices)
        if self._detail is not None:
            self._detail.styles.height = self._rows_below(width, height) if is_below else None
        if is_below:
            self.rows.styles.width, listing, rows = None, width, height
        elif has_detail:
            self.rows.styles.width = sum(self._columns) + 1
            listing = max(listing, sum(self._columns) + 1 + max(_DETAIL, min(_MOST_DETAIL, width // 2)))
            rows = max(rows, _DETAIL_ROWS)
        else:
            listing = max(listing, max(row_widths, default=0) + 2)
            rows = sum(-(-each // max(1, min(width, listing) - 1)) for each in row_widths)
        panel = self._panel
        listing = listing + 2 if listing + 2 <= width - LEAST_REST else width
        panel.styles.width = listing
        panel.set_class(listing >= width, "-wide-as-all")
        panel.set_class(rows >= height, "-high-as-all")
        panel.styles.height = min(height, max(rows, 2) + 1) + (1 if is_low else 2)

    def _columns_in(self, room: int, columns: tuple[int, ...], *, may_drop: bool) -> tuple[int, ...]:
        """The widths of as many columns as fit. A few long names may exceed their column."""
        for count in range(len(columns), 0 if may_drop else max(0, len(columns) - 1), -1):
            others = sum(columns[1:count]) - _COLUMN_GAP
            if columns[0] + others <= room:
                return columns[:count]
            names = room - others
            if count > 1 and self._are_few(
                _COLUMN_GAP + cell_len(each.columns[0]) > names for each in self._choices
            ):
                return (names, *columns[1:count])
        is_text_long = not self._are_few(cell_len(each.text) > room for each in self._choices)
        return columns[:1] if may_drop and is_text_long else ()

    def _are_few(self, choices: Iterable[bool]) -> bool:
        return _FEW * sum(choices) <= len(self._choices)

    def _rows_below(self, width: int, height: int) -> int:
        """The rows of the details below the list: less than half, or as many as the dropped columns need."""
        most = height * 2 // 5
        if self._has_details:
            return most
        needed = (
            sum(-(-cell_len(cell) // max(1, width - 2)) for cell in self._dropped(each))
            for each in self._choices
        )
        return min(most, max(needed, default=1))

    def _dropped(self, choice: Option) -> tuple[str, ...]:
        """The columns without room in the list."""
        return tuple(filter(None, choice.columns[len(self._columns) :]))

    def _row(self, choice: Option) -> str:
        if not self._columns or not choice.columns:
            return choice.text
        row, begin = "", 0
        for cell, width in zip(choice.columns, self._columns, strict=False):
            row += " " * (max(_COLUMN_GAP, begin - cell_len(row)) if row else 0) + cell
            begin += width
        return row

    def _show_detail(self) -> None:
        """Show the details of the chosen row."""
        if self._detail is None or not self._detail.display or not self._detail.size.area:
            return
        chosen = self._fitting[min(self.rows.line, len(self._fitting) - 1)] if self._fitting else None
        size = self._detail.size
        about: list[str] = []
        if chosen is not None:
            about += chosen.detail(size.width - 2, size.height) if chosen.detail else self._dropped(chosen)
        if len(about) > size.height:  # all of it is said once the row is taken
            last = about[size.height - 1][: size.width - 6]
            about[size.height - 1 :] = [f"{last.rpartition(' ')[0] or last} ..."]
        self._detail.show(about)

    def on_input_changed(self, event: Input.Changed) -> None:
        from language.source import fold_name

        event.stop()
        words = fold_name(event.value).split()
        folded = ((each, fold_name(f"{each.text}\n{each.also}")) for each in self._choices)
        fitting = [(each, text) for each, text in folded if all(word in text for word in words)]
        fitting.sort(key=lambda pair: _rank(pair[1], " ".join(words)))
        self._fitting = tuple(each for each, _text in fitting)
        self._typed.points_at_row = not words
        self._show()
        self.rows.read_line(0)
        self._say_row()

    def _show(self) -> None:
        self.rows.show([self._row(each) for each in self._fitting] or [self._nothing])

    def action_choose_row(self, down: int) -> None:
        self._typed.points_at_row = True
        self.rows.read_line(min(max(0, self.rows.line + down), max(0, len(self._fitting) - 1)))
        self._say_row()

    def _say_row(self, before: str = "") -> None:
        self._point(before + (self._fitting[self.rows.line].text if self._fitting else self._nothing))

    def on_input_submitted(self, event: Input.Submitted) -> None:
        event.stop()
        self._take(self.rows.line)

    def _take(self, line: int) -> None:
        if self._fitting:
            self.dismiss(self._fitting[min(line, len(self._fitting) - 1)].value)

    def on_text_rows_read(self) -> None:
        """Speak the row that a key or the wheel has chosen."""
        self._show_detail()

    def on__detail_resized(self) -> None:
        self._show_detail()

    def on_clickable_rows_clicked(self, event: ClickableRows.Clicked) -> None:
        """Answer the clicked row, as Enter does."""
        self._take(event.line)


class _Words(OptionList, WheelRows):
    """Textual's list, with the terminal's own cursor on the row."""

    @property
    def cursor_screen_offset(self) -> Offset:
        row = (self.highlighted or 0) - self.scroll_offset.y
        return self.content_region.offset + Offset(0, max(0, row))

    def choose_further(self, rows: int) -> None:
        self.highlighted = min(max(0, (self.highlighted or 0) + rows), self.option_count - 1)


class Completions(Panel[tuple[str, str]]):
    """Answers the chosen word and the letter that was typed instead, one of them; None for neither."""

    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("escape", "dismiss", priority=True),
        Binding("tab", "take", priority=True),
    ]

    def __init__(
        self, words: Sequence[str], keys: str, below: Offset, room: Region, point: Callable[[str], object]
    ) -> None:
        """``below``: the cursor's place on the screen. The list stays in ``room`` if a row is left there.

        ``point`` speaks the chosen word.
        """
        super().__init__()
        self._keys = keys
        self._point = point
        self._below, self._room = below, room
        self.list = _Words(*words, id="completions", markup=False, compact=True)
        self._width = max(map(cell_len, words)) + 2
        self._count = len(words)

    def compose(self) -> ComposeResult:
        yield self.list
        if not self.is_alone and self.app.size.height >= LOWEST:
            yield BottomKeys(self._keys)

    def on_mount(self) -> None:
        room, row = self._room, self._below.y
        above, below = row - room.y, room.bottom - row - 1
        height = max(1, min(self._count, MOST_SEEN, max(above, below)))  # the line itself stays in sight
        y = row + 1 if below >= max(1, min(height, above)) else max(room.y, row - height)
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

    def on_key(self, event: events.Key) -> None:
        if event.is_printable and event.character:
            event.stop()
            self.dismiss(("", event.character))
