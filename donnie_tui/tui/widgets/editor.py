"""The program being written: Textual's own editor, with GoDonnie's looks and marks next to the line numbers.

Esc and Tab are left to the screen: Esc runs, Tab leads to the next pane. Two columns before the numbers
are for marks: ``>`` the line that is being run, ``*`` the lines that called it; ``B`` a breakpoint, ``!`` a
mistake and ``?`` a hint, whose sentence follows the line where there is room.
"""

from __future__ import annotations

import re
import time
from collections.abc import Callable, Mapping, Sequence
from textwrap import wrap
from typing import TYPE_CHECKING, ClassVar, Self

from rich.cells import cell_len
from rich.segment import Segment
from rich.style import Style
from textual import events
from textual.binding import Binding, BindingType
from textual.document._document import EditResult
from textual.document._edit import Edit
from textual.geometry import Offset, Region, Size
from textual.message import Message
from textual.scroll_view import ScrollView
from textual.strip import Strip
from textual.widgets import TextArea
from textual.widgets.text_area import Selection, TextAreaTheme

from donnie_tui.core.editing import common_lines, followed, shifted
from donnie_tui.tui import themes

if TYPE_CHECKING:
    from donnie_tui.core.completion import Completion, NextLine
    from donnie_tui.core.program_text import LineMistake

HERE, CALLER, BREAK, MISTAKE, HINT = ">", "*", "B", "!", "?"
MARKS = 2
"""Columns of the marks."""

_EMPTY_LINE = "▌"
"""Textual's sign in a selected empty line, whose colour may be the background's."""

_LONGEST_WORD = 80
"""A longer line is no command."""

LONGEST_WRAPPED = 20_000
"""A longer line is one row that scrolls sideways, since each key wraps its whole line again."""

LEAST_TYPED = 2
"""Letters before a word is suggested, if more than one fits."""
_SCROLL_AFTER = 1.0
"""Seconds between two scrolls to the line that runs."""
LEAST_NOTE = 12
"""Columns that the sentence of a mistake needs."""


class Editor(TextArea):
    """The text and its marks."""

    BINDINGS: ClassVar[list[BindingType]] = [Binding("ctrl+a", "select_all")]

    _is_editing = False  # asked before the constructor has ended
    _has_looks = False
    """Whether the colours were looked up since the last full repaint."""

    class LineWordTyped(Message):
        """Enter on a line that holds only a command; the line is taken out."""

        def __init__(self, name: str, argument: str | None) -> None:
            super().__init__()
            self.name, self.argument = name, argument

    class GutterClicked(Message):
        """A click next to that line (from 1), where its marks and its number are."""

        def __init__(self, line: int) -> None:
            super().__init__()
            self.line = line

    class Edited(Message, bubble=False):
        """The text has changed."""

    class Looked(Message, bubble=False):
        """The cursor was placed, perhaps at the same place."""

    class LineFinished(Message):
        """Enter was pressed in that row (from 0)."""

        def __init__(self, row: int) -> None:
            super().__init__()
            self.row = row

    def __init__(self, *, id: str) -> None:  # noqa: A002 -- Textual's own name
        super().__init__(id=id, soft_wrap=True, tab_behavior="focus", show_line_numbers=True)
        self.cursor_blink = False
        self.is_typed = False
        """Whether a key, and no command, made the last change of the text."""
        self.is_edited = False
        """Whether the text has changed since the program last began, paused or continued."""
        self._chosen_painted: tuple[Offset, Offset] | None = None
        """The place of the selection, while rows are painted."""
        self._marks: dict[int, str] = {}
        self._working: tuple[str, ...] = ()
        self._notes: dict[int, LineMistake] = {}
        self._breakpoints: frozenset[int] = frozenset()
        self._followed: tuple[Size, Offset, Selection] | None = None
        """The window and the cursor as they were when the line that runs was last in sight; None at rest."""
        self._next_scroll = 0.0
        self.complete: Callable[[str, int], Completion] | None = None
        """Returns the possible words at an offset of the text; None for no suggestions."""
        self.first_steps: tuple[str, ...] = ()
        """Faint lines of an empty program, below the first line, which stays free for typing."""
        self.next_line: Callable[[Sequence[str], int], NextLine] | None = None
        """Returns what Enter writes at the end of a row. None, or no line numbers: a plain new line."""

    def on_mount(self) -> None:
        self.app.theme_changed_signal.subscribe(self, lambda _: self._wear())
        self._wear()

    def _wear(self) -> None:
        """Take the looks of the application's theme."""
        name = self.app.theme
        self.register_theme(TextAreaTheme(name=name, syntax_styles=dict(themes.syntax_styles(name))))
        self.theme = name

    # --- typing

    def on_text_area_changed(self, event: TextArea.Changed) -> None:
        """Post straight to the application, since each of five containers on the way costs time."""
        event.stop()
        self.app.post_message(self.Edited())

    def on_text_area_selection_changed(self, event: TextArea.SelectionChanged) -> None:
        event.stop()
        self.app.post_message(self.Looked())

    def on_blur(self) -> None:
        self.suggestion = ""

    async def _on_key(self, event: events.Key) -> None:
        self.is_typed = True
        command = self._line_command if event.key == "enter" else None
        if command is not None:
            event.stop()
            event.prevent_default()
            if command[0] == "undo":
                self._untype_line(self.cursor_location[0])
            else:
                self._take_line_out(self.cursor_location[0])
            self.post_message(self.LineWordTyped(*command))
        elif event.key == "enter":
            self.post_message(self.LineFinished(self.cursor_location[0]))
            if self.next_line is not None and self.show_line_numbers and self.selection.is_empty:
                event.stop()
                event.prevent_default()
                self._begin_line(self.next_line)

    def _begin_line(self, next_line: Callable[[Sequence[str], int], NextLine]) -> None:
        """Begin the next line with its indentation, and add the END of its block if that is missing."""
        row, column = self.cursor_location
        line = self.document.get_line(row)
        if column < len(line.rstrip()):
            indent = line[: len(line) - len(line.lstrip())][:column]
            self.insert(f"\n{indent}")
            return
        found = next_line(self.document.lines, row)
        self._finish_line(row, found)
        end = (row, len(self.document.get_line(row)))
        self.insert(f"\n{found.indent}" + (f"\n{found.end}" if found.end else ""), end)
        self.move_cursor((row + 1, len(found.indent)))

    def _finish_line(self, row: int, found: NextLine) -> None:
        """Remove the END that the learner has typed a second time, and indent the line."""
        line = self.document.get_line(row)
        if found.doubled:
            self.delete((row, len(line)), (row + 1, len(self.document.get_line(row + 1))))
        if not line.startswith(found.before) or line[len(found.before) :][:1].isspace():
            self.replace(found.before + line.lstrip(), (row, 0), (row, len(line)))

    def finish_typed_end(self) -> None:
        """Remove the doubled END of a typed one before a command, as Enter does."""
        if self.next_line is not None and self.is_typed:
            row, _ = self.cursor_location
            found = self.next_line(self.document.lines, row)
            if found.doubled:
                self.is_typed = False
                self._finish_line(row, found)

    @property
    def _line_command(self) -> tuple[str, str | None] | None:
        """The command and argument, if they are the whole line, with the cursor at its end."""
        row, column = self.cursor_location
        line = self.document.get_line(row)
        if len(line) >= _LONGEST_WORD or column < len(line.rstrip()) or not self.selection.is_empty:
            return None
        from donnie_tui.commands.lookup import line_command  # not for the first frame

        found = line_command(line, "\n".join(self.document.lines[:row]))
        return (found[0].name, found[1] or None) if found is not None else None

    def _take_line_out(self, row: int) -> None:
        """Remove a line; the last one stays, empty, so that typing continues there."""
        is_last = row == self.document.line_count - 1
        end = (row, len(self.document.get_line(row))) if is_last else (row + 1, 0)
        self.delete((row, 0), end, maintain_selection_offset=False)
        self.move_cursor((row, 0))
        self.is_edited = False

    def _untype_line(self, row: int) -> None:
        """Undo the typing of a line, so that UNDO on it undoes what was before."""
        typed = self.document.get_line(row)
        for _ in typed:
            rest = self.document.get_line(row) if row < self.document.line_count else ""
            if not rest or not typed.startswith(rest):
                break
            self.undo()

    async def _on_mouse_down(self, event: events.MouseDown) -> None:
        """Post a click in the gutter, which moves no cursor, and one on a command among the first steps."""
        place, wrapped = event.get_content_offset(self), self.wrapped_document
        named = self._first_command(place.y - 1) if place is not None else None
        if named is not None:
            event.stop()
            event.prevent_default()
            self.post_message(self.LineWordTyped(named, None))
            return
        row = self.scroll_offset.y + place.y if place is not None else wrapped.height
        if place is not None and place.x < self.gutter_width and row < wrapped.height:
            event.stop()
            event.prevent_default()
            self.post_message(self.GutterClicked(wrapped.offset_to_location(Offset(0, row))[0] + 1))

    async def _on_paste(self, event: events.Paste) -> None:
        from language.source import cleaned  # not for the first frame

        event.prevent_default()
        await super()._on_paste(events.Paste(cleaned(event.text)))

    # --- marks

    def mark(
        self, line: int | None, callers: frozenset[int] = frozenset(), working: tuple[str, ...] = ()
    ) -> None:
        """Mark the line being run (from 1; None: nothing is run) and those that called it.

        ``working`` is the line's evaluation in a few lengths, the longest first.
        """
        marks = dict.fromkeys(callers, CALLER)
        if line is not None:
            marks[line] = HERE
        changed = {each for each, _ in self._marks.items() ^ marks.items()}
        if working != self._working:
            self._working = working
            self.refresh()
        self._marks = marks
        gutters = [self._gutter_of(each) for each in changed if each <= self.document.line_count]
        if gutters:  # none would mean all of the text
            self.refresh(*gutters)

    # --- the line that runs

    def begin_following(self) -> None:
        """Keep the line that runs in sight from now on, as long as the learner moves nothing."""
        self._followed, self._next_scroll = self._window, 0.0
        self.is_edited = False

    def follow(self, line: int) -> None:
        """Scroll to the line that runs, from 1, if it is out of sight; seldom, so that it can be read.

        The cursor stays. After the learner has scrolled, edited or moved the cursor nothing is scrolled.
        """
        before, window = self._followed, self._window
        is_untouched = before is not None and (before == window or before[0] != window[0])
        if not is_untouched or line > self.document.line_count or time.monotonic() < self._next_scroll:
            return
        rows = self._rows_of(line - 1)
        if rows.y < 0 or rows.bottom > self.size.height:
            self._next_scroll = time.monotonic() + _SCROLL_AFTER
            top = self.scroll_offset.y + rows.y - self.size.height // 3
            self.scroll_to(y=top, animate=False, force=True, immediate=True)
        self._followed = self._window

    def end_following(self) -> None:
        """Show the cursor again if ``follow`` has scrolled, unless the learner has moved anything."""
        if self._followed is not None and self._followed == self._window and self._next_scroll:
            self.scroll_cursor_visible()
        self._followed = None

    @property
    def _window(self) -> tuple[Size, Offset, Selection]:
        """The size, the place in the text, and the cursor."""
        return self.size, self.scroll_offset, self.selection

    def note(self, mistakes: Mapping[int, LineMistake]) -> None:
        """Mark the mistakes of the current text, by line."""
        last = self.document.line_count
        changed = {
            each
            for each in self._notes.keys() | mistakes.keys()
            if self._notes.get(each) != mistakes.get(each)
        }
        self._notes = dict(mistakes)
        if changed:
            self.refresh(*(self._rows_of(each - 1) for each in changed if each <= last))

    @property
    def mistake(self) -> LineMistake | None:
        """The mistake of the cursor's line."""
        return self._notes.get(self.line)

    @property
    def mistakes(self) -> tuple[LineMistake, ...]:
        """The mistakes of all lines, from the first one."""
        return tuple(self._notes[line] for line in sorted(self._notes))

    @property
    def breakpoints(self) -> frozenset[int]:
        """Lines, from 1; they move with the text."""
        return self._breakpoints

    @breakpoints.setter
    def breakpoints(self, lines: frozenset[int]) -> None:
        if lines != self._breakpoints:
            self._breakpoints = lines
            self.refresh()

    def show(self, text: str, breakpoints: frozenset[int]) -> None:
        """Show another program, from its first line; the history begins again."""
        self.is_typed = False
        self.load_text(text)
        self._choose_wrapping()
        self.breakpoints = breakpoints
        self.move_cursor((0, 0))

    def edit(self, edit: Edit) -> EditResult:
        """Edit the text; breakpoints move with their lines. A letter repaints only the rows of its line."""
        start, end = sorted((edit.from_location, edit.to_location))
        whole_lines = start[1] == end[1] == 0
        first, last = (start[0], end[0]) if whole_lines else (start[0] + 1, end[0] + 1)
        before, was_empty = self.document.line_count, not self.text
        others = self._beyond(start[0]) if start[0] == end[0] else ()
        self._is_editing = self.is_edited = True
        try:
            result = super().edit(edit)
            self._choose_wrapping()
        finally:
            self._is_editing = False
        self.refresh(*([self._rows_of(start[0])] if others == self._beyond(start[0]) else []))
        if was_empty != (not self.text):
            self._refresh_first_steps()
        self._shift_breakpoints(first, last, self.document.line_count - before)
        return result

    def refresh(
        self, *regions: Region, repaint: bool = True, layout: bool = False, recompose: bool = False
    ) -> Self:
        """Ignore Textual's request for all rows at each letter; ``edit`` repaints the changed ones."""
        if self._is_editing and not (regions or layout or recompose):
            return self
        self._has_looks = self._has_looks and bool(regions)
        return super().refresh(*regions, repaint=repaint, layout=layout, recompose=recompose)

    def _beyond(self, row: int) -> tuple[object, ...]:
        """A key of what an edit of that line may change in other rows."""
        looks = {line: each for line, each in self._highlights.items() if each and line != row}
        places = self.wrapped_document.height, self.document.line_count, self.gutter_width, self.soft_wrap
        return looks, places, self.scroll_offset, self._others_marked(row)

    def _others_marked(self, row: int) -> tuple[object, ...]:
        """The rows of the selection and of a bracket pair, unless they are all in that line."""
        bracket = self._matching_bracket_location
        marked = {*(each[0] for each in self.selection), *([bracket[0]] if bracket else [])}
        return () if marked == {row} else (self.selection, bracket)

    def _rows_of(self, row: int) -> Region:
        """The place of a line in the window."""
        line = self.document.get_line(row)
        first, last = (self.wrapped_document.location_to_offset((row, at)).y for at in (0, len(line)))
        return Region(0, first - self.scroll_offset.y, self.size.width, last + 1 - first)

    def undo(self) -> None:
        """Undo the last edit; breakpoints move with their lines."""
        self._travel(super().undo)

    def redo(self) -> None:
        self._travel(super().redo)

    def _travel(self, change: Callable[[], None]) -> None:
        """Undo or redo an edit."""
        self.is_typed = False
        before = list(self.document.lines) if self.breakpoints else []
        change()
        self._choose_wrapping()
        self._follow(before)

    def _choose_wrapping(self) -> None:
        """Wrap lines at the window's width, unless a line is so long that each key would be slow."""
        self.soft_wrap = max(map(len, self.document.lines)) <= LONGEST_WRAPPED

    def _follow(self, before: Sequence[str]) -> None:
        """Move breakpoints after the text has changed from ``before``, found by the difference."""
        if before:
            self.breakpoints = followed(self.breakpoints, before, self.document.lines)

    def _shift_breakpoints(self, first: int, last: int, added: int) -> None:
        """Move breakpoints of lines after ``last``, and drop those after ``first`` up to there."""
        if added and self.breakpoints:
            self.breakpoints = shifted(self.breakpoints, first, last, added)

    def show_first_steps(self, lines: tuple[str, ...]) -> None:
        """Show these lines in an empty program."""
        if lines != self.first_steps:
            self.first_steps = lines
            self._refresh_first_steps()

    def _refresh_first_steps(self) -> None:
        self.refresh(Region(0, 1, self.size.width, max(1, self.size.height - 1)))

    def change_lines(self, lines: Sequence[str]) -> None:
        """Change the text into these lines, as one edit of no more than what differs."""
        self.is_typed = False
        before = self.document.lines
        ends_open = len(before) > 1 and not before[-1]
        after = [*lines, ""] if ends_open or not lines or not lines[-1] else list(lines)
        top, end = common_lines(before, after)
        if before != after:
            self._replace_lines(top, len(before) - end, after[top : len(after) - end])

    def select(self, row: int, start: int, end: int) -> None:
        """Select the columns of a row, with the cursor at their end."""
        self.selection = Selection((row, start), (row, end))

    def replace_range(self, start: int, end: int, text: str) -> None:
        """Replace the characters between two offsets. The cursor stays at its letter.

        If it was in the replaced text, or in another line, it moves after the new text.
        """
        self.is_typed = False
        here, new_end = self.offset_of_cursor, start + len(text)
        first, last = self.location_of(start), self.location_of(end)
        is_near = first[0] <= self.cursor_location[0] <= last[0] and not start < here < end
        self.replace(text, first, last)
        cursor = new_end if not is_near else here if here <= start else here + new_end - end
        self.move_cursor(self.location_of(cursor))

    def _replace_lines(self, first: int, end: int, lines: Sequence[str]) -> None:
        """Replace the rows ``first`` up to ``end`` by ``lines``, with their line ends."""
        last = self.document.line_count
        if end < last:
            self.replace("".join(f"{each}\n" for each in lines), (first, 0), (end, 0))
        elif first:
            start = (first - 1, len(self.document.get_line(first - 1)))
            self.replace("".join(f"\n{each}" for each in lines), start, self.document.end)
        else:
            self.replace("\n".join(lines), (0, 0), self.document.end)

    def _gutter_of(self, line: int) -> Region:
        place = self.wrapped_document.location_to_offset((line - 1, 0))
        return Region(0, place.y - self.scroll_offset.y, MARKS, 1)

    # --- completing

    @property
    def offset_of_cursor(self) -> int:
        """Characters before the cursor."""
        return self.offset_of(self.cursor_location)

    def offset_of(self, location: tuple[int, int]) -> int:
        row, column = location
        return sum(len(line) + 1 for line in self.document.lines[:row]) + column

    def location_of(self, offset: int) -> tuple[int, int]:
        """The row and column of an offset, or the nearest in the text."""
        for row, line in enumerate(self.document.lines):
            if offset <= len(line):
                return row, offset
            offset -= len(line) + 1
        return self.document.end

    def update_suggestion(self) -> None:
        """Show the likeliest next word faintly after the cursor; the right arrow accepts it."""
        self.suggestion = ""
        row, column = self.cursor_location
        if self.complete is None or column < len(self.document.get_line(row)):
            return
        found = self.complete(self.text, self.offset_of_cursor)
        is_enough = len(found.typed) >= (1 if len(found.words) == 1 else LEAST_TYPED)
        if found.words and is_enough:
            self.suggestion = found.words[0][len(found.typed) :]

    def _watch_selection(self, previous_selection: Selection, selection: Selection) -> None:
        """Drop the suggestion when the cursor moves; after an edit make a new one."""
        super()._watch_selection(previous_selection, selection)
        self.suggestion = ""

    def put_in_place_of(self, typed: str, word: str) -> None:
        """Replace the letters before the cursor by the chosen word."""
        row, column = self.cursor_location
        self.replace(word, (row, column - len(typed)), (row, column), maintain_selection_offset=False)

    def go_to(self, line: int, column: int = 1) -> None:
        """Put the cursor there, both from 1, or to the nearest place in the text."""
        row = min(max(line, 1), self.document.line_count) - 1
        self.move_cursor((row, min(max(column, 1) - 1, len(self.document.get_line(row)))))

    @property
    def word(self) -> str:
        """The word at the cursor, or right before it."""
        row, column = self.cursor_location
        text = self.document.get_line(row)
        return next(
            (each[0] for each in re.finditer(r"\w+", text) if each.start() <= column <= each.end()), ""
        )

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
        """The width of the line numbers and the marks."""
        return super().gutter_width + MARKS

    def render_lines(self, crop: Region) -> list[Strip]:
        """The rows; the selection's place in a long line is computed once and not for each row.

        Textual looks up the colours at each letter.
        """
        self._chosen_painted = None if self.selection.is_empty else self._chosen
        paint = ScrollView.render_lines if self._has_looks else TextArea.render_lines
        self._has_looks = True
        try:
            return paint(self, crop)
        finally:
            self._chosen_painted = None

    def render_line(self, y: int) -> Strip:
        painted = super().render_line(y)
        if not self.soft_wrap:
            painted = painted.crop(0, self.size.width)
        strip = self._with_selection(self._with_gutter(painted), y)
        if y and self.first_steps and self.show_line_numbers and not self.text:
            return self._with_first_step(strip, y - 1)
        line, is_first, is_last = self._line_at(y)
        if line and is_last and self._working and self._marks.get(line) == HERE:
            strip = self._with_note(strip, "kind", *(f"{HERE} {each}" for each in self._working))
        elif line and is_last and line in self._notes:
            note = self._notes[line]
            strip = self._with_note(strip, "note", f"{HINT if note.is_hint else MISTAKE} {note.message}")
        marks = self._marks_of(line) if line and is_first else ""
        if not marks.strip():
            return strip
        style = next(iter(strip)).style or Style()
        return Strip.join([Strip([Segment(marks, style + Style(bold=True))]), strip.crop(MARKS)])

    def _with_first_step(self, strip: Strip, row: int) -> Strip:
        """Add a first step, also in italics, as no whole line of a program is."""
        rows = self._first_rows
        if row >= len(rows):
            return strip
        style = self.rich_style + themes.looks(self.app.theme)["kind"]
        words = f"{' ' * self.gutter_width}{rows[row]}"
        return Strip([Segment(words, style)]).crop_extend(0, self.size.width, self.rich_style)

    def _first_command(self, row: int) -> str | None:
        """The command at the beginning of a first step, as in ``EXAMPLES, Enter: programs to try``."""
        rows = self._first_rows if self.show_line_numbers and not self.text else []
        word, comma, _ = rows[row].partition(",") if 0 <= row < len(rows) else ("", "", "")
        if not comma or not word.isupper():
            return None
        from donnie_tui.commands.lookup import line_command  # not for the first frame

        found = line_command(word)
        return found[0].name if found is not None else None

    @property
    def _first_rows(self) -> list[str]:
        """The first steps, wrapped."""
        width = max(1, self.size.width - self.gutter_width)
        return [row for line in self.first_steps for row in wrap(line, width)]

    def _with_gutter(self, strip: Strip) -> Strip:
        """Add the gutter to every row; Textual has it only in rows with a line number."""
        if self.show_line_numbers:
            return strip
        first = next(iter(strip), None)
        gutter = Strip([Segment(" " * MARKS, (first and first.style) or self.rich_style)])
        return Strip.join([gutter, strip]).crop(0, self.size.width)

    def _with_selection(self, strip: Strip, y: int) -> Strip:
        """Paint the selected columns in the selection's colours, over those of the syntax."""
        if self.selection.is_empty:
            return strip
        row, (first, last) = y + self.scroll_offset.y, self._chosen_painted or self._chosen
        if first == last or not first.y <= row <= last.y:
            return strip
        text_end = max(cell_len(strip.text.rstrip()), self.gutter_width + 1)
        shift = self.gutter_width - self.scroll_offset.x
        begin = max(self.gutter_width, shift + (first.x if row == first.y else 0))
        end = max(begin, shift + last.x if row == last.y else text_end)
        look = themes.looks(self.app.theme)["selected"]
        chosen = strip.crop(begin, end)
        painted = Strip([Segment(each.text, (each.style or Style()) + look) for each in chosen])
        if painted.text == _EMPTY_LINE:
            painted = Strip([Segment(" ", each.style) for each in painted])
        return Strip.join([strip.crop(0, begin), painted, strip.crop(end)])

    @property
    def _chosen(self) -> tuple[Offset, Offset]:
        """The beginning and end of the selection in the wrapped text, in cells."""
        first, last = sorted(self.selection)
        wrapped = self.wrapped_document
        return wrapped.location_to_offset(first), wrapped.location_to_offset(last)

    def _marks_of(self, line: int) -> str:
        note = self._notes.get(line)
        second = BREAK if line in self.breakpoints else (HINT if note.is_hint else MISTAKE) if note else " "
        return self._marks.get(line, " ") + second

    def _line_at(self, y: int) -> tuple[int, bool, bool]:
        """The line of a window's row, from 1 or 0 for none; whether the row is its first and its last."""
        row = y + self.scroll_offset.y
        wrapped = self.wrapped_document
        if not (self._marks or self._notes or self.breakpoints) or row >= wrapped.height:
            return 0, False, False
        line, column = wrapped.offset_to_location(Offset(0, row))
        is_last = row + 1 >= wrapped.height or wrapped.offset_to_location(Offset(0, row + 1))[0] != line
        return line + 1, column == 0, is_last

    def _with_note(self, strip: Strip, look: str, *choices: str) -> Strip:
        """Add the first note that fits after the line, else the last one cut, if more than a word fits."""
        used = len(strip.text.rstrip()) + 2
        room = strip.cell_length - used
        words = next((each for each in choices if len(each) <= room), choices[-1])
        if room < min(LEAST_NOTE, len(words)) or not strip.text.isascii():
            return strip
        shown = words if len(words) <= room else f"{words[: room - 3]}..."
        style = self.rich_style + themes.looks(self.app.theme)[look]
        segment = Segment(shown.ljust(room), style)
        return Strip.join([strip.crop(0, used), Strip([segment])])

    def _build_highlight_map(self) -> None:
        """Textual fills ``_highlights`` from tree-sitter here; a test guards both names."""
        self._line_cache.clear()
        self._highlights.clear()
        text = self.document.text
        if text:
            from donnie_tui.tui.highlighting import highlights  # the lexer: not for the first frame

            self._highlights.update(highlights(text))
