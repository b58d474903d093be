"""A window on rows that are painted one by one, in the looks of the theme.

The fixed rows at the bottom: the status line and the keys. Written only when their words change.

Rows of text to read: the log, the inspector, the help. Each line may have its kind in words before it, in a
column of its own where there is room.

Made for programs that speak without end: lines are kept as texts, wrapped only where they are too long, and
painted only where they are seen. One row is being read: the terminal's own cursor stands on it while the
rows have the focus, and ``>`` before it. Rows that follow read their newest one, whatever comes, unless
the learner reads further up. ``LogRows`` is for screen readers too.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Iterable, Sequence
from itertools import zip_longest
from typing import ClassVar

from msgspec import Struct
from rich.cells import cell_len, chop_cells
from rich.segment import Segment
from rich.style import Style
from textual.binding import Binding, BindingType
from textual.content import Content
from textual.events import Click, MouseEvent, MouseScrollDown, MouseScrollUp
from textual.geometry import Offset, Region, Size
from textual.message import Message
from textual.scroll_view import ScrollView
from textual.strip import Strip
from textual.widgets import Static

from donnie_tui.tui import themes
from language.source import fold_name


class PaintedRows(ScrollView):
    """A widget that paints rows, with a cache of its looks."""

    def __init__(self, *, id: str) -> None:  # noqa: A002 -- Textual's own name
        super().__init__(id=id)
        self._looks: dict[str, Style] = {}

    def notify_style_update(self) -> None:
        self._looks = {}
        super().notify_style_update()

    def painted_as(self, name: str = "") -> Style:
        """The style of a look (see ``themes``) on the widget's background; plain text for an empty name."""
        if name not in self._looks:
            base = self.rich_style
            self._looks[name] = base + themes.looks(self.app.theme)[name] if name else base
        return self._looks[name]


NARROW, LOWEST, FIXED_ROWS = 60, 10, 3
"""Columns below which the status line has two rows; rows below which there are no keys. Then the command
line, the status line and the keys, in rows."""


def rows_always_seen(size: Size) -> int:
    """The rows of the command line, the state and the keys; 0 on a screen lower than these."""
    return 0 if size.height < LOWEST else FIXED_ROWS + (size.width < NARROW)


_GAP = "  "


class FixedLine(Static):
    """A sentence of plain text, perhaps after a badge in reverse video."""

    def __init__(self, *, id: str) -> None:  # noqa: A002 -- Textual's own name
        super().__init__(id=id, markup=False)
        self.words = ""
        self._choices: tuple[str, ...] = ("",)
        self.badge = self._colour = ""
        self._shown = ("", "")

    def say(self, *choices: str, badge: str = "", colour: str = "") -> None:
        """Show the first of the choices that fits, or the last."""
        self._choices, self.badge, self._colour = choices, badge, colour
        self._write()

    def on_resize(self) -> None:
        self._write()

    def _write(self) -> None:
        badge = f" {self.badge} " if self.badge else ""
        words = next((each for each in self._choices if self._has_room(f"{badge}{each}")), self._choices[-1])
        if (badge, words) != self._shown:
            self._shown, self.words = (badge, words), words
            self.update(self._painted(badge, words), layout=False)

    def _has_room(self, text: str) -> bool:
        """Whether the text fits into the rows, broken at words."""
        width, rows = self.size.width, max(1, self.size.height)
        for _ in range(rows - 1):
            if cell_len(text) > width:
                text = text[max(text.rfind(" ", 0, width + 1), 0) :].lstrip()
        return cell_len(text) <= width

    def _painted(self, badge: str, words: str) -> Content | str:
        return Content.assemble((badge, f"{self._colour} reverse".strip()), words) if badge else words


_CHART = re.compile(r" *-?\d* *\|")
TYPED_MARK = "> "
"""The beginning of each line that the learner typed."""


class StatusLine(FixedLine):
    """The run state, the focus and the robot's place."""

    class Clicked(Message):
        """The status line was clicked."""

    def on_click(self, _event: Click) -> None:
        self.post_message(self.Clicked())


class KeyEntry(Struct, frozen=True):
    """An entry of the bottom line."""

    action: str
    key: str
    words: str

    @property
    def text(self) -> str:
        return f"{self.key} {self.words}"


class KeyLine(FixedLine):
    """The keys of the current state: the entries that fit, the most important first."""

    class Clicked(Message):
        """An entry was clicked: the same as its key."""

        def __init__(self, action: str) -> None:
            super().__init__()
            self.action = action

    def __init__(self, *, id: str) -> None:  # noqa: A002 -- Textual's own name
        super().__init__(id=id)
        self._entries: tuple[KeyEntry, ...] = ()
        self._seen: tuple[KeyEntry, ...] = ()

    def offer(self, entries: Sequence[KeyEntry]) -> None:
        """Show entries; the last one is shown whenever it fits."""
        self._entries = tuple(entries)
        self._fit()

    def on_click(self, event: Click) -> None:
        place = event.get_content_offset(self)
        begin = 1
        for each in self._seen:
            if place is not None and begin <= place.x < begin + len(each.text):
                self.post_message(self.Clicked(each.action))
            begin += len(each.text) + len(_GAP)

    def on_resize(self) -> None:
        self._fit()

    def _fit(self) -> None:
        if not self._entries:
            return
        *entries, last = self._entries
        room = self.size.width - 1 - len(last.text)
        seen: list[KeyEntry] = []
        for each in entries:
            needed = len(each.text) + len(_GAP)
            if needed <= room:
                room -= needed
                seen.append(each)
        self._seen = (*seen, last)
        self.say(f" {_GAP.join(each.text for each in self._seen)}")

    def _painted(self, badge: str, words: str) -> Content:  # noqa: ARG002 -- it has no badge
        """Paint the keys in their own style."""
        parts: list[str | tuple[str, str]] = []
        for each in self._seen:
            parts += [_GAP if parts else " ", (each.key, "reverse"), f" {each.words}"]
        return Content.assemble(*parts)


class Slider(FixedLine):
    """The position of STEP BACK in the run. A click goes there; at the ends it goes a step."""

    class Moved(Message):
        """The learner moved the slider to the moment after that many steps."""

        def __init__(self, step: int) -> None:
            super().__init__()
            self.step = step

    def __init__(self) -> None:
        super().__init__(id="slider")
        self._at = (0, 0)

    def show(self, step: int, steps: int) -> None:
        self._at = step, steps
        self._draw()

    def on_resize(self) -> None:
        self._draw()

    @property
    def _cells(self) -> int:
        return max(1, self.size.width - 2 * len(_BACK))

    def _draw(self) -> None:
        step, steps = self._at
        before = round(step * (self._cells - 1) / max(1, steps))
        self.say(f"{_BACK}{'=' * before}O{'-' * (self._cells - 1 - before)}{_FORWARD}")

    def on_click(self, event: Click) -> None:
        place, (step, steps) = event.get_content_offset(self), self._at
        if place is None:
            return
        cell = place.x - len(_BACK)
        if cell < 0:
            wanted = step - 1
        elif cell >= self._cells:
            wanted = step + 1
        else:
            wanted = round(cell * steps / max(1, self._cells - 1))
        self.post_message(self.Moved(min(max(0, wanted), steps)))


_BACK, _FORWARD = " < |", "| > "


_CLICKABLE = {"Esc": "escape", "Enter": "enter", "F1": "f1", "Tab": "tab"}
"""Keys whose names in a dialog can be clicked; without room, the last goes first."""
_KEY_NAME = re.compile(rf"\b({'|'.join(_CLICKABLE)})\b")


class DialogKeys(Static):
    """The keys of a dialog in words. A click on the words about a key presses it."""

    def __init__(self, words: str, *, classes: str = "screen-keys") -> None:
        super().__init__(classes=classes, markup=False)
        self.say(words)

    def say(self, words: str) -> None:
        """Set the words. Key names are reversed, except in the plain layout."""
        self.words = words
        self.update(self._painted(f" {words}"), layout=False)

    def _painted(self, text: str) -> Content:
        if self.is_attached and self.app.screen_stack[0].has_class("-plain"):
            return Content(text)
        return Content.assemble(
            *((each, "reverse") if each in _CLICKABLE else each for each in _KEY_NAME.split(text))
        )

    def on_click(self, event: Click) -> None:
        """Press the key of the clicked clause; in a wrapped row, of the nearest one before it."""
        place = event.get_content_offset(self)
        if place is None:
            return
        at, begin = place.y * self.size.width + place.x, 1
        clause = ""
        for each in self.words.split(", "):
            if begin <= at:
                clause = each
            begin += cell_len(each) + 2
        key = _key_of(clause)
        if key:
            event.stop()
            self.app.simulate_key(key)


class BottomKeys(DialogKeys):
    """The keys of a dialog in the bottom line, in place of those of the main screen."""

    def __init__(self, words: str) -> None:
        self._all = words
        super().__init__(words, classes="bottom-keys")

    def on_resize(self) -> None:
        """Show as many as fit. Rows and folders can be clicked without their keys; Esc stays."""
        clauses = self._all.split(", ")
        for key in ("", *reversed(_CLICKABLE.values())):
            for each in [each for each in reversed(clauses) if _key_of(each) == key]:
                if cell_len(", ".join(clauses)) + 1 > self.size.width and len(clauses) > 1:
                    clauses.remove(each)
        self.say(", ".join(clauses))


def _key_of(clause: str) -> str:
    """The key that a click on the clause presses, or an empty text."""
    found = _KEY_NAME.search(clause)
    return _CLICKABLE[found[1]] if found else ""


MOST_LINES = 100_000
"""Lines that are kept; when there are more, the oldest tenth is dropped."""

_NOT_KNOWN = 1 << 16
"""The width before the first layout: each line is a row."""
_KIND_WIDTH = 10
_WHEEL = 3
"""Rows of a step of the mouse wheel."""
_NARROW = 56
"""Columns below which the kinds have no column of their own."""

LOOKS = {
    "error": "error",
    "obstacle": "warning",
    "collision": "warning",
    "stopped": "warning",
    "spoke": "says",
    "typed": "typed",
}
"""The looks of kinds with a look of their own; others have ``kind``. The words say the same."""


class WheelRows(ScrollView):
    """Rows of which one is chosen. The wheel moves the window with it, so that Enter takes a visible row.

    A second base, because Textual takes the looks of a widget from its first one.
    """

    def choose_further(self, rows: int) -> None:
        """Choose the row that many further down, or up, as far as there are rows."""
        raise NotImplementedError

    def on_mouse_scroll_up(self, event: MouseScrollUp) -> None:
        self._roll(event, -_WHEEL)

    def on_mouse_scroll_down(self, event: MouseScrollDown) -> None:
        self._roll(event, _WHEEL)

    def _roll(self, event: MouseEvent, rows: int) -> None:
        event.stop()
        event.prevent_default()  # Textual would scroll two rows more
        self.scroll_to(y=self.scroll_offset.y + rows, animate=False, force=True, immediate=True)
        self.choose_further(rows)


class TextRows(PaintedRows, WheelRows, can_focus=True):
    """Rows of text, each with the name of its kind. ``follows``: a log, which scrolls to new rows."""

    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("up", "row(-1)"),
        Binding("down", "row(1)"),
        Binding("pageup", "page(-1)"),
        Binding("pagedown", "page(1)"),
        Binding("home", "oldest"),
        Binding("end", "newest"),
    ]

    class Read(Message):
        """Another row was chosen, by a key here or by a command."""

        def __init__(self, text: str, *, has_focus: bool) -> None:
            super().__init__()
            self.text, self.has_focus = text, has_focus

    def __init__(self, *, id: str, follows: bool = False) -> None:  # noqa: A002 -- Textual's own name
        super().__init__(id=id)
        self._follows = follows
        self._lines: list[str] = []
        self._kinds: list[str] = []
        self._rows: list[str] = []
        self._row_kinds: list[str] = []
        """The kind of each row; only the first row of a line has one."""
        self._heights: list[int] = []
        """The number of rows of each line."""
        self._has_kinds = follows
        """Whether kinds have a column, if there is room."""
        self._marked = ""
        """The text of the last search. Rows with it begin with ``*``."""
        self._searched = self._marked_rows = 0
        """The number of lines and rows at the search."""
        self.only = ""
        """The kind of the lines that are shown; empty for all."""
        self.looks: dict[str, str] = {}
        """Looks by the name of a kind."""
        self.look_of: Callable[[str], str] = lambda _text: ""
        """Returns the look of a row that is not chosen."""
        self._wrapped_at = (0, True, False)
        self._row: int | None = None if follows else 0
        """The chosen row; None follows the newest one."""

    # --- what is shown

    def append(self, lines: Iterable[tuple[str, str]]) -> None:
        """Add lines: (text, kind) each."""
        before, first = len(self._rows), len(self._lines)
        for text, kind in lines:
            self._lines.append(text)
            self._kinds.append(kind)
            self._has_kinds = self._has_kinds or bool(kind)
        self._wrap_from(first)
        if len(self._rows) == before:
            return
        if self._forget_oldest():
            before = 0
        changed = before - 1 if self.is_read else before  # which is read no longer
        self._extent(range(max(0, changed), len(self._rows)))
        if self._row is None:
            self._follow()

    def show(self, lines: Iterable[str]) -> None:
        """Show other lines; the chosen row stays if possible."""
        texts = list(lines)
        if texts == self._lines:
            return
        before = self._rows
        self._lines, self._kinds = texts, [""] * len(texts)
        self._rewrap()
        both = enumerate(zip_longest(before, self._rows))
        self._extent({self.row, *(row for row, (old, new) in both if old != new)})
        self._follow()

    @property
    def lines(self) -> tuple[str, ...]:
        """All texts, oldest first."""
        return tuple(self._lines)

    @property
    def with_kinds(self) -> tuple[tuple[str, str], ...]:
        """All texts, each with its kind."""
        return tuple(zip(self._lines, self._kinds, strict=True))

    @property
    def row(self) -> int:
        """The chosen row, from 0."""
        return max(0, len(self._rows) - 1) if self._row is None else self._row

    @property
    def line(self) -> int:
        """The line of the chosen row, from 0."""
        rows = 0
        for line, height in enumerate(self._heights):
            rows += height
            if rows > self.row:
                return line
        return max(0, len(self._lines) - 1)

    def read_line(self, line: int) -> None:
        """Choose the first row of a line, and show its other rows if there is room."""
        first = sum(self._heights[:line])
        self._read(first)
        if line < len(self._heights):
            self._scroll_to_rows(first, min(self._heights[line], self.size.height))

    @property
    def is_read(self) -> bool:
        """Whether the chosen row is marked."""
        return self.has_focus

    @property
    def row_count(self) -> int:
        return len(self._rows)

    @property
    def row_text(self) -> str:
        return self._rows[self.row] if self._rows else ""

    def _forget_oldest(self) -> int:
        """Drop the oldest lines; return the number of rows."""
        rows = 0
        if len(self._lines) > MOST_LINES:
            lines = max(len(self._lines) - MOST_LINES, MOST_LINES // 10)
            rows = sum(self._heights[:lines])
            for column, count in (
                (self._lines, lines),
                (self._kinds, lines),
                (self._heights, lines),
                (self._rows, rows),
                (self._row_kinds, rows),
            ):
                del column[:count]
            self._searched, self._marked_rows = (
                max(0, self._searched - lines),
                max(0, self._marked_rows - rows),
            )
            if self._row is not None:
                self._row = max(0, self._row - rows)
        return rows

    # --- rows

    @property
    def _shows_kinds(self) -> bool:
        return self._has_kinds and self.size.width >= _NARROW

    @property
    def _begins_with_kinds(self) -> bool:
        return self.size.width < _NARROW

    @property
    def _look_of_rows(self) -> tuple[int, bool, bool]:
        return self._text_width, self._shows_kinds, self._begins_with_kinds

    @property
    def _text_width(self) -> int:
        if self._follows and not self.size.width:
            return _NOT_KNOWN
        width = self.size.width - 1
        return max(1, width - _KIND_WIDTH - 1 if self._shows_kinds else width)

    def _wrap_from(self, first: int) -> None:
        """Wrap the lines from there on."""
        width, begins_with_kind = self._text_width, self._begins_with_kinds
        for text, kind in zip(self._lines[first:], self._kinds[first:], strict=True):
            if self.only and kind != self.only:
                self._heights.append(0)
                continue
            rows = _wrapped(_with_kind(text, kind) if begins_with_kind else text, width)
            self._rows.extend(rows)
            self._row_kinds.append(kind)
            self._row_kinds.extend([""] * (len(rows) - 1))
            self._heights.append(len(rows))

    def _rewrap(self) -> None:
        self._rows, self._row_kinds, self._heights = [], [], []
        self._wrap_from(0)
        self._marked_rows = sum(self._heights[: self._searched])
        if self._row is not None:
            self._row = min(self._row, max(0, len(self._rows) - 1))

    def on_resize(self) -> None:
        self._lay_out()

    def _lay_out(self) -> None:
        """Wrap all lines again if the size or the kinds have changed."""
        self._fit_rows()
        self._extent(())
        self.refresh()
        self._follow()

    def _fit_rows(self) -> None:
        """Wrap the rows to the current width."""
        if self._wrapped_at != self._look_of_rows:
            self._wrapped_at = self._look_of_rows
            line = self.line
            self._rewrap()
            if self._row is not None:
                self._row = sum(self._heights[:line])

    def _extent(self, changed: Collection[int]) -> None:
        """Set the number of rows, and paint only the changed ones, since each costs bytes."""
        size = self.size  # slow to answer
        extent = Size(size.width, self._height)
        if (
            extent != self.virtual_size
        ):  # set by its name it would paint all rows and lay out the whole screen
            self.set_reactive(ScrollView.virtual_size, extent)
            self._scroll_update(extent)
        top = self.scroll_offset.y
        seen = [row - top for row in changed if top <= row < top + size.height]
        if seen:
            self.refresh(*(Region(0, y, size.width, 1) for y in seen))

    def _follow(self) -> None:
        """Scroll to the chosen row, or to the newest one."""
        if self._row is None and not self.size.height:
            return
        self._scroll_to_rows(self.row, 1)

    def _scroll_to_rows(self, row: int, rows: int) -> None:
        place = Region(0, row, 1, rows)
        self.scroll_to_region(place, animate=False, force=True, immediate=True)

    @property
    def _height(self) -> int:
        """The number of rows that the cursor can visit."""
        return len(self._rows)

    @property
    def _painted_rows(self) -> int:
        """The number of rows, from the oldest on, that may be visible."""
        return len(self._rows)

    @property
    def cursor_screen_offset(self) -> Offset:
        """The place of the terminal's cursor: the chosen row."""
        return self.content_region.offset + Offset(0, self.row - self.scroll_offset.y)

    # --- reading

    def action_row(self, down: int) -> None:
        self._read(self.row + down)

    def action_page(self, down: int) -> None:
        self._read(self.row + down * max(1, self.size.height - 1))

    def choose_further(self, rows: int) -> None:
        self._read(self.row + rows)

    def action_oldest(self) -> None:
        self._read(0)

    def action_newest(self) -> None:
        self._read(len(self._rows))

    def _read(self, row: int) -> None:
        newest = len(self._rows) - 1
        self._row = None if row >= newest and self._follows else max(0, min(row, newest))
        self._follow()
        self.refresh()
        self.post_message(self.Read(self._said, has_focus=self.has_focus))

    @property
    def _said(self) -> str:
        """The words to speak: in the first row of a line the whole line, else the row."""
        line = self.line
        begins = self.row == sum(self._heights[:line])
        return self._lines[line] if begins and self._lines else self.row_text

    def filter(self, kind: str) -> None:
        """Show only the lines of a kind, all for an empty one; the newest is chosen."""
        self.only = kind
        self._rewrap()
        self._lay_out()
        self.action_newest()

    def search(self, wanted: str) -> bool:
        """Choose the nearest older line with the text, else the newest; False if there is none.

        What a filter hides is shown again.
        """
        if self.only:
            self.filter("")
        self._marked = fold_name(wanted)
        self._searched, self._marked_rows = len(self._lines), len(self._rows)
        self.refresh()
        hits = [at for at, line in enumerate(self._lines) if self._is_found(line)]
        if not hits:
            return False
        older = [at for at in hits if at < self.line]
        self.read_line((older or hits)[-1])
        return True

    def _is_found(self, text: str) -> bool:
        """Whether the line has the searched text. A line that the learner typed is not marked."""
        return bool(self._marked) and self._marked in fold_name(text) and not text.startswith(TYPED_MARK)

    # --- painting

    def render_lines(self, crop: Region) -> list[Strip]:
        """The rows; the first frame is painted before the size is known."""
        self._fit_rows()
        return super().render_lines(crop)

    def render_line(self, y: int) -> Strip:
        row = y + self.scroll_offset.y
        if row >= self._painted_rows:
            return Strip.blank(self.size.width, self.painted_as())
        return Strip(self._segments(row)).adjust_cell_length(self.size.width, self._style(row))

    def _segments(self, row: int) -> list[Segment]:
        style, text = self._style(row), self._words_of(row)
        here = self.is_read and row == self.row
        kind = self._row_kinds[row][:_KIND_WIDTH]
        look = style if here else self.painted_as(self.looks.get(self._row_kinds[row], "kind"))
        is_found = row < self._marked_rows and self._is_found(text.removeprefix(f"{kind}: "))
        before = Segment(">" if here else "*" if is_found else " ", style)
        if kind and self._begins_with_kinds:
            return [before, Segment(text[: len(kind)], look), Segment(text[len(kind) :], style)]
        if not self._shows_kinds:
            return [before, Segment(text, style if here else self.painted_as(self.look_of(text)))]
        gap = " " * (_KIND_WIDTH + 1 - cell_len(kind))
        return [before, Segment(kind, look), Segment(gap + text, style)]

    def _words_of(self, row: int) -> str:
        return self._rows[row]

    def _style(self, row: int) -> Style:
        here = self.is_read and row == self.row
        return self.painted_as("row" if here else "")


def _with_kind(text: str, kind: str) -> str:
    """The sentence with its kind before it, unless it begins with the kind."""
    short = kind[:_KIND_WIDTH]
    return text if text.casefold().startswith(short.casefold()) else f"{short}: {text}"


def _wrapped(text: str, width: int) -> tuple[str, ...]:
    """The text in rows of at most ``width`` columns, broken at blanks where there are any."""
    if (text.isascii() and len(text) <= width) or cell_len(text) <= width:
        return (text,)
    rows, row = [], ""
    for word in _pieces(text, width):
        longer = f"{row} {word}" if row else word
        if cell_len(longer) > width:
            rows.append(row)
            row = word
        else:
            row = longer
    return (*rows, row)


def _pieces(text: str, width: int) -> Iterable[str]:
    """The words; a word wider than a row is cut."""
    for word in text.split():
        yield from chop_cells(word, width) if cell_len(word) > width else (word,)


def inspector_look(text: str) -> str:
    """The look of an inspector line by its sign: heading, changed variable or chart."""
    if text.endswith(":"):
        return "heading"
    if text.startswith("*"):
        return "changed"
    return "chart" if _CHART.match(text) else ""
