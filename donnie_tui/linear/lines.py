"""The words about the lines of the program: LIST, CHANGE, INSERT, DELETE, MOVE, UNDO. All answer with it."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path

from donnie_tui.core import line_words
from donnie_tui.core.typed_program import ANOTHER_PROGRAM
from donnie_tui.core.typed_words import number_and_text, numbers_in
from donnie_tui.linear.arguments import Handler, alone
from donnie_tui.linear.desk import Desk
from donnie_tui.linear.output import LARGEST_BLOCK
from donnie_tui.linear.runs import Runs


def list_lines(desk: Desk, first: int | None, last: int | None) -> None:
    """Say lines ``first`` to ``last``, all of them without numbers; how many first, if they are many."""
    desk.tell(*line_words.listed(desk.program.lines, first, last, desk.say, many=LARGEST_BLOCK))


def change_line(desk: Desk, number: int, text: str) -> None:
    """Line ``number`` becomes ``text``, or what is typed next."""
    lines, refused = desk.program.lines, desk.program.refused
    if refused is not None and number == len(lines) + 1 and (text or desk.ends.can_edit):
        offer_again(desk, text or refused)
    elif text or not 1 <= number <= len(lines):
        _change(desk, number, text)
    else:
        desk.asking.offered = lines[number - 1].strip()
        _ask_for_line(desk, number, "linear-edit", lambda typed: _change(desk, number, typed))


def offer_again(desk: Desk, line: str) -> None:
    """A line that was forgotten because of a mistake: at the prompt again, to be looked at and entered.

    Where nothing can be offered it is a line of the program again, which waits.
    """
    if desk.ends.can_edit:
        desk.asking.offered = line.strip()
        desk.answer("linear-edit", line=len(desk.program.lines) + 1)
    else:
        desk.program.add(line)
        _say_line(desk, len(desk.program.lines))


def insert_line(desk: Desk, number: int, text: str) -> None:
    """``text``, or what is typed next, becomes line ``number``."""
    if text or not 1 <= number <= len(desk.program.lines) + 1:
        _insert(desk, number, text)
    else:
        _ask_for_line(desk, number, "linear-type-line", lambda typed: _insert(desk, number, typed))


def delete_lines(desk: Desk, first: int | None, last: int | None) -> None:
    """Delete lines ``first`` to ``last``; without numbers, those that have not run."""
    if first is None:
        deleted, left = desk.program.forget_waiting(), len(desk.program.lines)
        if deleted:
            desk.tell(line_words.gone(left + 1, left + deleted, desk.say))
        else:
            desk.answer("linear-nothing-to-delete")
    else:
        _tell_edit(desk, line_words.deleted(desk.program, first, last, desk.say))


def move_lines(desk: Desk, first: int, last: int, to: int) -> None:
    """Lines ``first`` to ``last`` stand before line ``to`` from now on."""
    _tell_edit(desk, line_words.moved(desk.program, first, last, to, desk.say))


def undo(desk: Desk) -> None:
    """The last change is taken back; the first line that is another one now."""
    _tell_changed(desk, desk.program.undo())


def redo(desk: Desk) -> None:
    """The same, for the change that was taken back last."""
    _tell_changed(desk, desk.program.redo())


def _tell_changed(desk: Desk, changed: int | None) -> None:
    if changed is None:
        desk.answer("answer-unchanged")
    elif changed == ANOTHER_PROGRAM:
        tell_back_again(desk)
    elif changed <= len(desk.program.lines):
        _say_line(desk, changed)
    elif desk.program.lines:
        desk.answer("linear-lines", lines=len(desk.program.lines))
    else:
        desk.answer("linear-no-lines")


def tell_back_again(desk: Desk) -> None:
    """Another program is the current one, which was there before; its name, where it has one."""
    name, lines = desk.program.name, len(desk.program.lines)
    desk.place = 0
    if name is None:
        desk.answer("answer-recovered" if lines else "answer-new", lines=lines)
    elif desk.program.saved:
        desk.answer("answer-opened", name=Path(name).name, lines=lines)
    else:
        desk.answer("answer-recovered-file", name=Path(name).name, lines=lines)


def _say_line(desk: Desk, number: int) -> None:
    desk.place = number
    desk.tell(line_words.line_told(desk.program, number, desk.say))


def _tell_edit(desk: Desk, edit: line_words.Edited) -> None:
    desk.place = desk.place if edit.line is None else edit.line
    desk.tell(*edit.sentences)


def _ask_for_line(desk: Desk, number: int, code: str, then: Callable[[str], None]) -> None:
    desk.answer(code if desk.ends.can_edit else "linear-type-line", line=number)
    desk.next_line = partial(_take, then)


def _take(then: Callable[[str], None], typed: str) -> bool:
    then(typed)
    return True


def _change(desk: Desk, number: int, text: str) -> None:
    _tell_edit(desk, line_words.changed(desk.program, number, text, desk.say))


def _insert(desk: Desk, number: int, text: str) -> None:
    _tell_edit(desk, line_words.inserted(desk.program, number, text, desk.say))


# --- the words


def warning_of_all(handler: Handler) -> Handler:
    """The word, and behind its answer that all lines wait again, where its change had that effect."""

    def warn(desk: Desk, runs: Runs, rest: str) -> bool | None:
        waiting = desk.program.waiting
        understood = handler(desk, runs, rest)
        desk.tell(*line_words.waits_again(desk.program, waiting, desk.say))
        return understood

    return warn


def _list(desk: Desk, _: Runs, rest: str) -> bool:
    given = numbers_in(rest, most=2)
    if given is not None:
        list_lines(desk, *_pair(given))
    return given is not None


def _pair(given: tuple[int, ...]) -> tuple[int | None, int | None]:
    first, last = (*given, None, None)[:2]
    return first, last


def _delete(desk: Desk, _: Runs, rest: str) -> bool:
    given = numbers_in(rest, most=2)
    if given is not None:
        delete_lines(desk, *_pair(given))
    return given is not None


def _change_word(desk: Desk, _: Runs, rest: str) -> bool:
    given = number_and_text(rest)
    if given is not None:
        change_line(desk, *given)
    return given is not None


def _insert_word(desk: Desk, _: Runs, rest: str) -> bool:
    given = number_and_text(rest)
    if given is not None:
        insert_line(desk, *given)
    return given is not None


def _move(desk: Desk, _: Runs, rest: str) -> bool:
    """MOVE 5 2: line 5 before line 2. MOVE 5 7 2: lines 5 to 7."""
    given = numbers_in(rest, most=3)
    if given is None or len(given) < 2:
        return False
    move_lines(desk, given[0], given[-2], given[-1])
    return True


HANDLERS: dict[str, Handler] = {
    "list": _list,
    "show_program": alone(lambda desk: list_lines(desk, None, None)),
    "change": _change_word,
    "insert": _insert_word,
    "delete": _delete,
    "move": _move,
    "undo": warning_of_all(alone(undo)),
    "redo": warning_of_all(alone(redo)),
}
