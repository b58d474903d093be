"""The words about the lines of the program: LIST, CHANGE, INSERT, DELETE. They answer with the line."""

from __future__ import annotations

from collections.abc import Callable

from donnie_tui.core.typed_program import ProgramTooLong
from donnie_tui.linear.desk import Desk
from donnie_tui.linear.output import LARGEST_BLOCK


def list_lines(desk: Desk, first: int | None, last: int | None) -> None:
    """Say lines ``first`` to ``last``, all of them without numbers; how many first, if they are many."""
    lines = desk.program.lines
    if not lines:
        desk.answer("linear-no-lines")
        return
    begin = first or 1
    end = min(last or (begin if first else len(lines)), len(lines))
    if not 1 <= begin <= end:
        _no_such_line(desk, begin)
        return
    if end - begin + 1 > LARGEST_BLOCK:
        desk.answer("linear-lines", lines=end - begin + 1)
    for number in range(begin, end + 1):
        desk.answer("linear-listed", line=number, text=lines[number - 1].strip())


def change_line(desk: Desk, number: int, text: str) -> None:
    """Line ``number`` becomes ``text``, or what is typed next."""
    lines = desk.program.lines
    if not 1 <= number <= len(lines):
        _no_such_line(desk, number)
    elif text:
        _change(desk, number, text)
    else:
        desk.offered = lines[number - 1].strip()
        _ask_for_line(desk, number, "linear-edit", lambda typed: _change(desk, number, typed))


def insert_line(desk: Desk, number: int, text: str) -> None:
    """``text``, or what is typed next, becomes line ``number``."""
    if not 1 <= number <= len(desk.program.lines) + 1:
        _no_such_line(desk, number)
    elif text:
        _insert(desk, number, text)
    else:
        _ask_for_line(desk, number, "linear-type-line", lambda typed: _insert(desk, number, typed))


def delete_lines(desk: Desk, first: int | None, last: int | None) -> None:
    """Delete lines ``first`` to ``last``; without numbers, those that have not run."""
    if first is None:
        deleted = desk.program.forget_waiting()
        desk.answer("linear-deleted" if deleted else "linear-nothing-to-delete", lines=deleted)
        return
    end = first if last is None else last
    count = len(desk.program.lines)
    if not 1 <= first <= end <= count:
        _no_such_line(desk, first if not 1 <= first <= count else end)
        return
    waiting = desk.program.waiting
    desk.program.delete(first, end)
    desk.answer("linear-deleted", lines=end - first + 1)
    _warn_of_waiting(desk, waiting)


def _ask_for_line(desk: Desk, number: int, code: str, then: Callable[[str], None]) -> None:
    desk.answer(code if desk.can_edit else "linear-type-line", line=number)
    desk.next_line = then


def _change(desk: Desk, number: int, text: str) -> None:
    if not text.strip() or text.strip() == desk.program.lines[number - 1].strip():
        desk.answer("answer-unchanged")
        return
    _edit(desk, number, text, desk.program.change)


def _insert(desk: Desk, number: int, text: str) -> None:
    if not text.strip():
        desk.answer("answer-unchanged")
        return
    _edit(desk, number, text, desk.program.insert)


def _edit(desk: Desk, number: int, text: str, edit: Callable[[int, str], None]) -> None:
    waiting = desk.program.waiting
    try:
        edit(number, text)
    except ProgramTooLong:
        desk.answer("linear-too-long")
        return
    desk.answer("answer-line", line=number, text=text.strip())
    _warn_of_waiting(desk, waiting)


def _warn_of_waiting(desk: Desk, before: int) -> None:
    """A change to what has run lets everything wait again; nobody may be surprised by that."""
    now = desk.program.waiting
    if now > before + 1:
        desk.answer("linear-waits-again", lines=now)


def _no_such_line(desk: Desk, number: int) -> None:
    desk.answer("answer-no-line", line=number, last=len(desk.program.lines))
