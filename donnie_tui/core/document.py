"""A document: one program with its file, its history and its breakpoints, edited line by line or key by key.

In the linear mode commands add and change single lines. In the full screen a ``TextEditor`` shows the
document: then the text and the breakpoints are the editor's, and its own history comes before the one here.

Rules: lines keep their numbers from the first to the last, so that mistakes and listings agree. Typed lines
wait until they run; afterwards they stay, so that the whole program can be saved or run again. After a
mistake of form nothing has run: a single line is dropped, several lines are kept for correction. Every
change can be undone, also one that replaces the whole program.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import TYPE_CHECKING

import msgspec

from donnie_tui.core.editing import (
    Origin,
    TextEditor,
    UndoHistory,
    Version,
    common_lines,
    followed,
    joined,
    shifted,
)
from donnie_tui.core.program_files import LARGEST
from language.outline import OutlineItem, block_depth, open_block
from language.source import cleaned, lines_in

if TYPE_CHECKING:
    from pathlib import Path

    from donnie_tui.core.program_text import ProgramText
    from language.parser import Parsed

WORTH_SAVING = 5
"""Unsaved typed lines from which on the learner is asked before they are lost."""
ANOTHER_PROGRAM = 0
"""In the place of a line: UNDO or REDO exchanged the whole program."""
NONE_WRONG: Mapping[int, str] = {}
LONGEST_PARSED = 100_000
"""Characters of a program that is parsed to find the lines where statements begin."""


class ProgramTooLong(Exception):
    """The change would give the program more characters than its file may have bytes."""


class Batch(msgspec.Struct, frozen=True):
    """What is to run now: its text and the number of its first line."""

    text: str
    first_line: int
    lines: int


class Document:
    """The lines so far, and how many of them have run."""

    def __init__(self) -> None:
        self.path: Path | None = None
        """The file that it was opened from or saved to."""
        self.rejected: str | None = None
        """The line that was dropped after a mistake, until another line is added."""
        self.refusals = 0
        """How often in a row the waiting lines were refused because of a mistake of form."""
        self.was_opened = False
        """Whether the waiting lines came from a file or from an earlier start and never ran here."""
        self._wrong: dict[int, tuple[str, str]] = {}
        """The lines that the last run reported as wrong, as they were, and what was probably meant."""
        self._refused_text: str | None = None
        """The waiting lines that were refused last, until they run or are dropped."""
        self._is_just_reported = False
        """Whether no line was typed since then."""
        self._lines: list[str] = []
        self._saved_lines: list[str] = []
        self._breakpoints: frozenset[int] = frozenset()
        self._place = 0
        self._ran = 0
        self._runs = 0
        """How many runs there were."""
        self._running: list[str] | None = None
        """The lines when a batch was taken that has not run yet."""
        self._size = 0
        """Of the lines, kept so that a line that is added costs no count of all; no editor keeps it."""
        self.versions = UndoHistory()
        self._editor: TextEditor | None = None
        self._is_edited_as_text = False
        """Whether an editor showed it: there even a first line is worth keeping."""
        self._text: ProgramText | None = None

    # --- the editor

    @property
    def is_in_editor(self) -> bool:
        return self._editor is not None

    def attach(self, editor: TextEditor) -> None:
        """Shows the document in an editor, which edits it from now on."""
        place, self._ran = self._place, 0
        self._editor, self._is_edited_as_text = editor, True
        self._show()
        editor.go_to(place or 1)

    def detach(self) -> None:
        """Takes over the text of the editor, which will show another document."""
        if self._editor is not None:
            self._read_editor()
            self._breakpoints, self._place = self._editor.breakpoints, self._editor.line
            self._editor, self._size = None, _size(self._lines)

    def _show(self) -> None:
        if self._editor is not None:
            ending = "\n" if self._lines and not self._lines[-1] else ""
            self._editor.show("\n".join(self._lines) + ending, self._breakpoints)

    def _read_editor(self) -> None:
        """Reads the editor's text again; if the learner has typed, REDO has nothing left."""
        if self._editor is not None:
            lines = lines_in(self._editor.text)
            if lines != self._lines:
                self._lines = lines
                self.versions.forget_undone()

    # --- the text

    @property
    def lines(self) -> tuple[str, ...]:
        self._read_editor()
        return tuple(self._lines)

    @property
    def text(self) -> str:
        self._read_editor()
        return joined(self._lines)

    @property
    def structure(self) -> ProgramText:
        """The lines with their levels and blocks; worked out again only after a change."""
        from donnie_tui.core.program_text import ProgramText  # for the first command that reads the program

        lines = self.lines
        if self._text is None or self._text.lines != lines:
            self._text = ProgramText(lines)
        return self._text

    @property
    def breakpoints(self) -> frozenset[int]:
        """Lines, from 1; they move with the text."""
        return self._breakpoints if self._editor is None else self._editor.breakpoints

    @breakpoints.setter
    def breakpoints(self, lines: frozenset[int]) -> None:
        if self._editor is None:
            self._breakpoints = lines
        else:
            self._editor.breakpoints = lines

    def toggle_breakpoint(self, line: int, parse: Callable[[str], Parsed]) -> int | None:
        """Clears the breakpoint of a line, else sets one where a run can pause; the line that was changed."""
        if line in self.breakpoints:
            self.breakpoints -= {line}
            return line
        at = self.pausing_line(line, parse)
        if at is not None:
            self.breakpoints |= {at}
        return at

    def pausing_line(self, line: int, parse: Callable[[str], Parsed]) -> int | None:
        """The first line from ``line`` on where a run can pause; None after the last statement.

        A run never pauses at an END or at a comment. ``parse`` reads GoDonnie. In a program that has
        mistakes, or is long, every line counts.
        """
        text = self.text
        program = parse(text).program if len(text) <= LONGEST_PARSED else None
        if program is None:
            return line
        from language.syntax import walk

        lines = {each.span.line for each in walk(program.body)}
        return min((each for each in lines if each >= line), default=None)

    @property
    def place(self) -> int:
        """The line that was read last, or the line of the cursor; 0 before any."""
        return self._place if self._editor is None else self._editor.line

    @place.setter
    def place(self, line: int) -> None:
        self._place = line
        if self._editor is not None and line:
            self._editor.go_to(line)

    def find_next(self, wanted: str) -> int | None:
        """The line of the next place with a word, from the reading place on and once round.

        That becomes the reading place; an editor selects the word.
        """
        from donnie_tui.core.program_text import find_word

        start = (self._place, 0) if self._editor is None else self._editor.cursor_location
        found = find_word(self.lines, wanted, *start)
        if found is None:
            return None
        if self._editor is None:
            self._place = found.row + 1
        else:
            self._editor.select(found.row, found.start, found.end)
        return found.row + 1

    # --- the file

    @property
    def is_saved(self) -> bool:
        """Whether the lines are the same as in the file, or as in a new program."""
        self._read_editor()
        return self._lines == self._saved_lines

    def mark_saved(self, path: Path | None = None, text: str | None = None) -> None:
        """Notes that the file ``path`` has the lines, or ``text``, now."""
        self._saved_lines = list(self.lines) if text is None else lines_in(text)
        self.path = path or self.path

    @property
    def saved_text(self) -> str:
        """The text of the file, as it was last read or written."""
        return joined(self._saved_lines)

    @property
    def is_worth_saving(self) -> bool:
        """Whether the learner is asked before the text is lost.

        Single lines that were typed at the prompt are not worth a question; UNDO and RECOVER restore them.
        """
        is_long = len(self.lines) >= WORTH_SAVING
        is_program = self.path is not None or self._is_edited_as_text or is_long
        return is_program and not self.is_saved and bool(self.text.strip())

    @property
    def is_kept_unasked(self) -> bool:
        """Whether the text is kept without a question when the learner leaves: a few lines that ran."""
        is_asked_about = self.is_worth_saving or self.is_waiting
        return not self.is_saved and not is_asked_about and bool(self.text.strip())

    # --- running

    @property
    def is_waiting(self) -> bool:
        """Whether some line has not run yet."""
        return any(line.strip() for line in self._unrun)

    @property
    def ran(self) -> int:
        """How many lines have run."""
        return self._ran

    @property
    def waiting(self) -> int:
        """How many lines have not run yet."""
        return len(self._unrun)

    @property
    def depth(self) -> int:
        """How many blocks are open at the end of the waiting lines."""
        return block_depth(self.waiting_text)

    @property
    def open_block(self) -> OutlineItem | None:
        """The innermost block that is open at the end of the waiting lines."""
        return open_block(self.waiting_text, first_line=self._ran + 1)

    @property
    def _unrun(self) -> list[str]:
        self._read_editor()
        return self._lines[self._ran :]

    @property
    def waiting_text(self) -> str:
        return "\n".join(self._unrun)

    def take_batch(self) -> Batch:
        """All waiting lines."""
        waiting = self._unrun
        self._running = self._lines.copy()
        return Batch("\n".join(waiting), self._ran + 1, len(waiting))

    def batch_ran(self) -> None:
        """Notes that the batch, or all lines, have run. If they were changed meanwhile, all wait again."""
        ran, self._running = self._running or self._lines, None
        self._ran = len(ran) if self._lines[: len(ran)] == ran else 0
        self.was_opened = False
        self._forget_refusal()
        self._runs += 1

    def batch_was_refused(
        self, wrong: Mapping[int, str] = NONE_WRONG, *, is_unfinished: bool = False
    ) -> bool:
        """Takes note of mistakes of form in the lines ``wrong``, each with what was probably meant.

        True if the lines were kept, False if there was one, which is dropped unless it ``is_unfinished``.
        """
        self._running = None
        if is_unfinished or sum(bool(line.strip()) for line in self._unrun) > 1:
            self.refusals += 1
            self._refused_text = self.waiting_text
            self._report_wrong(wrong)
            return True
        self._forget_refusal()
        self.rejected = next((line for line in self._unrun if line.strip()), None)
        self._size -= _size(self._unrun)
        del self._lines[self._ran :]
        self.versions.forget_lines(self._ran)
        return False

    @property
    def is_still_refused(self) -> bool:
        """Whether the waiting lines are those that were refused."""
        return self.is_waiting and self.waiting_text == self._refused_text

    def batch_failed(self, line: int) -> None:
        """Notes that the lines have run up to ``line``, where a statement failed."""
        text = self.structure
        if 0 < line <= len(text) and text.line(line).level == 0 and text.down(line) is None:
            self._report_wrong({line: ""})

    @property
    def failed_line(self) -> int | None:
        """The line at which the last batch failed, as long as nothing has changed it."""
        failed = (at for at, (line, _) in self._wrong.items() if self._lines[at - 1 : at] == [line])
        return next((at for at in failed if at <= self._ran), None)

    def wait_from(self, number: int) -> None:
        """Line ``number``, which had failed and is corrected, waits with the lines after it."""
        self._ran = number - 1

    def _report_wrong(self, wrong: Mapping[int, str]) -> None:
        lines = self._lines
        self._wrong = {at: (lines[at - 1], meant) for at, meant in wrong.items() if 0 < at <= len(lines)}
        self._is_just_reported = True

    def _forget_refusal(self) -> None:
        self.refusals, self._refused_text, self._wrong = 0, None, {}

    # --- changing

    def add(self, line: str) -> int | None:
        """Append a line, or replace the wrong line that it corrects, whose number is returned.

        Raises ``ProgramTooLong``.
        """
        self.rejected = None
        if self._wrong and (corrected := self._retype(line)) is not None:
            return corrected
        if self._editor is not None:
            self.insert(len(self.lines) + 1, line)
            return None
        line = cleaned(line)
        if self._size + len(line) + 1 > LARGEST:
            raise ProgramTooLong
        self._size += len(line) + 1
        self.versions.add_line(len(self._lines))
        self._lines.append(line)
        return None

    def _retype(self, line: str) -> int | None:
        """Replace the wrong line which ``line`` is meant to correct, if there is one; its number.

        It waits then, with the lines after it. Raises ``ProgramTooLong``.
        """
        is_next, self._is_just_reported = self._is_just_reported, False
        wrong = {at: each for at, each in self._wrong.items() if self._lines[at - 1 : at] == [each[0]]}
        if self._editor is not None or not wrong:
            return None
        from donnie_tui.core.program_text import corrected_line

        number = corrected_line(line, wrong, len(self._lines), is_next=is_next, is_refused=self.refusals > 0)
        if number is None:
            if not self.refusals:
                self._wrong = {}
            return None
        ran = min(self._ran, number - 1)
        self.change(number, line)
        self._ran = ran
        self._wrong.pop(number)
        return number

    def change(self, number: int, line: str) -> None:
        """Replace line ``number`` (from 1). Raises ``IndexError``, ``ProgramTooLong``."""
        lines = self._checked(number)
        lines[number - 1] = cleaned(line)
        self._edit(lines, self.breakpoints, number)

    def insert(self, number: int, line: str) -> None:
        """``line`` becomes line ``number``; the lines from there on move down. Raises as ``change``."""
        lines = self._checked()
        if not 1 <= number <= len(lines) + 1:
            raise IndexError(number)
        lines.insert(number - 1, cleaned(line))
        self._edit(lines, shifted(self.breakpoints, number - 1, number - 1, 1), number)

    def delete(self, first: int, last: int) -> None:
        """Delete lines ``first`` to ``last``. Raises ``IndexError`` unless both exist."""
        lines = self._checked(first, last)
        del lines[first - 1 : last]
        self._edit(lines, shifted(self.breakpoints, first - 1, last, first - 1 - last), first)

    def delete_waiting(self) -> int:
        """Delete the lines that have not run. Returns how many there were."""
        waiting = self.waiting
        if waiting:
            lines = self._checked()
            del lines[self._ran :]
            self._edit(lines, self.breakpoints, self._ran + 1)
        self.was_opened = False
        self._forget_refusal()
        return waiting

    def move(self, first: int, last: int, to: int) -> int:
        """Move lines ``first`` to ``last`` before line ``to``. Returns the new number of the first.

        Raises ``IndexError`` unless all exist; ``to`` may be the line after the last one.
        """
        lines = self._checked(first, last)
        if not 1 <= to <= len(lines) + 1 or first <= to <= last + 1:
            raise IndexError(to)
        moved = lines[first - 1 : last]
        del lines[first - 1 : last]
        at = to - 1 if to < first else to - 1 - len(moved)
        lines[at:at] = moved
        self._edit(lines, self.breakpoints, min(first, to))
        return at + 1

    def rewrite(self, text: str) -> None:
        """Replace the whole text, as one change. Raises ``ProgramTooLong``."""
        before, lines = self._checked(), lines_in(cleaned(text))
        breakpoints = followed(self.breakpoints, before, lines)
        self._edit(lines, breakpoints, common_lines(before, lines)[0] + 1)

    def replace_range(self, start: int, end: int, text: str) -> None:
        """Replace the characters between two offsets, as one change. Raises ``ProgramTooLong``."""
        if self._editor is None:
            before = self.text
            self.rewrite(before[:start] + text + before[end:])
        else:
            text, before = cleaned(text), self._editor.text
            if len(before) - (end - start) + len(text) > max(LARGEST, len(before)):
                raise ProgramTooLong
            self.versions.forget_undone()
            self._editor.replace_range(start, end, text)

    def replace(
        self, text: str, path: Path | None, *, in_file: str | None = None, keeps_empty: bool = False
    ) -> None:
        """Replace the program by another one, which waits. ``in_file``: the text of its file, if it differs.

        UNDO restores the old program, with ``keeps_empty`` also one without lines.
        """
        self.rejected = None
        self._forget_refusal()
        self.versions.forget_undone()
        if self.lines or keeps_empty:
            self.versions.add(self._version(self._origin))
        self._lines = lines_in(text)
        self._ran = self._place = 0
        self.was_opened = bool(self._lines)
        self._size = _size(self._lines)
        self._breakpoints = frozenset()
        self.path = path
        self._saved_lines = lines_in(text if in_file is None else in_file)
        self._show()

    def _checked(self, *numbers: int) -> list[str]:
        """A copy of the lines, for a change. Raises ``IndexError`` for a line that does not exist."""
        lines = list(self.lines)
        for number in numbers:
            if not 1 <= number <= len(lines):
                raise IndexError(number)
        return lines

    def _edit(self, lines: list[str], breakpoints: frozenset[int], touched: int) -> None:
        """Make a change from line ``touched`` on. If that line had run, the whole program waits again.

        Raises ``ProgramTooLong``.
        """
        size = _size(lines)
        if size > max(LARGEST, _size(self._lines)):
            raise ProgramTooLong
        self._size = size
        if self._editor is not None:
            self.versions.forget_undone()
            self._editor.change_lines(lines)
            self._lines = lines
            return
        self.versions.add(self._version(None))
        self._lines, self._breakpoints = lines, breakpoints
        if touched <= self._ran:
            self._ran = 0

    # --- undoing

    def undo(self) -> int | None:
        """Undo the last change. Returns the first line that differs now, or None without a change.

        ``ANOTHER_PROGRAM`` where the change had replaced the whole program. Lines that had run before the
        change have run again, unless there was a run in between.
        """
        if self._editor is not None and (changed := self._step_in_editor(self._editor.undo)) is not None:
            return changed
        before = self.versions.undo(self._version_now)
        if isinstance(before, int):  # a line that was added last is removed, whether it has run or not
            before = Version(self._lines[:before], min(self._ran, before), self._runs)
        return None if before is None else self._become(before)

    def redo(self) -> int | None:
        """Redo the change that was undone last; as ``undo``."""
        if self._editor is not None and (changed := self._step_in_editor(self._editor.redo)) is not None:
            return changed
        after = self.versions.redo(self._version_now)
        return None if after is None else self._become(after)

    def _step_in_editor(self, step: Callable[[], None]) -> int | None:
        """A step in the editor's own history; None if it changed nothing."""
        assert self._editor is not None
        self._read_editor()
        text, lines = self._editor.text, self._lines
        step()
        if self._editor.text == text:
            return None
        self._lines = lines_in(self._editor.text)
        return common_lines(lines, self._lines)[0] + 1

    def _become(self, other: Version) -> int:
        same = common_lines(other.lines, self._lines)[0]
        self._breakpoints = followed(self.breakpoints, self._lines, other.lines)
        if same < self._ran:
            self._ran = 0
        self._lines = other.lines
        self._size = _size(self._lines)
        if other.runs == self._runs and self._editor is None:
            self._ran = other.ran
        if other.origin is not None:
            self.path, self._saved_lines = other.origin.path, other.origin.saved_lines
            self._breakpoints = other.origin.breakpoints
            self.was_opened = bool(self._lines)
            self._place = 0
        self._show()
        return same + 1 if other.origin is None else ANOTHER_PROGRAM

    def _version(self, origin: Origin | None) -> Version:
        return Version(self._lines.copy(), self._ran, self._runs, origin)

    def _version_now(self, is_another: bool) -> Version:
        """The current version, with its file if another program replaces it."""
        self._read_editor()
        return self._version(self._origin if is_another else None)

    @property
    def _origin(self) -> Origin:
        return Origin(self.path, self._saved_lines, self.breakpoints)


def _size(lines: Iterable[str]) -> int:
    """Characters, with the ends of the lines."""
    return sum(len(line) + 1 for line in lines)
