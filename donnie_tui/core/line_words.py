"""LIST, CHANGE, INSERT, DELETE and MOVE: what they do to a program's lines, and what is told of it.

Both front ends do them on a ``TypedProgram``. Rule: a number that is no line's changes nothing and is told.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from devices.ports.values import Frozen
from donnie_tui.core.typed_program import ProgramTooLong, TypedProgram
from donnie_tui.core.wording import Wording


class Edited(Frozen):
    """What is told of an edit, and the line that it is about."""

    sentences: tuple[str, ...]
    line: int | None = None
    """From 1; None where no line is to be read now."""


def listed(
    lines: Sequence[str], first: int | None, last: int | None, wording: Wording, *, many: int
) -> list[str]:
    """Lines ``first`` to ``last``, all of them without numbers; how many first, if more than ``many``."""
    if not lines:
        return [wording("linear-no-lines")]
    begin = first or 1
    end = min(last or (begin if first else len(lines)), len(lines))
    if not 1 <= begin <= end:
        return [no_such_line(len(lines), begin, wording)]
    count = end - begin + 1
    told = [wording("linear-lines", lines=count)] if count > many else []
    return told + [
        wording("linear-listed", line=number, text=lines[number - 1].strip())
        for number in range(begin, end + 1)
    ]


def changed(program: TypedProgram, number: int, text: str, wording: Wording) -> Edited:
    """Line ``number`` is ``text`` from now on."""
    if not 1 <= number <= len(program.lines):
        return Edited((no_such_line(len(program.lines), number, wording),))
    if not text.strip() or text.strip() == program.lines[number - 1].strip():
        return Edited((wording("answer-unchanged"),))
    return _edited(program, number, text, program.change, wording)


def inserted(program: TypedProgram, number: int, text: str, wording: Wording) -> Edited:
    """``text`` becomes line ``number``; the ones from there on move down."""
    if not 1 <= number <= len(program.lines) + 1:
        return Edited((no_such_line(len(program.lines), number, wording),))
    if not text.strip():
        return Edited((wording("answer-unchanged"),))
    return _edited(program, number, text, program.insert, wording)


def deleted(program: TypedProgram, first: int, last: int | None, wording: Wording) -> Edited:
    """Lines ``first`` to ``last``, or ``first`` alone, are gone; what stands there now is told."""
    end, count = first if last is None else last, len(program.lines)
    if not 1 <= first <= end <= count:
        return Edited((no_such_line(count, first if not 1 <= first <= count else end, wording),))
    waiting = program.waiting
    program.delete(first, end)
    told = [gone(first, end, wording)]
    is_followed = first <= len(program.lines)
    if is_followed:
        told.append(line_told(program, first, wording))
    return Edited((*told, *waits_again(program, waiting, wording)), first if is_followed else None)


def gone(first: int, last: int, wording: Wording) -> str:
    """That lines ``first`` to ``last`` are no more."""
    if first == last:
        return wording("linear-deleted", line=first)
    return wording("linear-deleted-lines", first=first, last=last)


def moved(program: TypedProgram, first: int, last: int, to: int, wording: Wording) -> Edited:
    """Lines ``first`` to ``last`` stand before line ``to`` from now on."""
    waiting, count = program.waiting, len(program.lines)
    try:
        at = program.move(first, last, to)
    except IndexError:
        wrong = next((each for each in (first, last, to) if not 1 <= each <= count), None)
        told = wording("answer-unchanged") if wrong is None else no_such_line(count, wrong, wording)
        return Edited((told,))
    end = at + last - first
    lines = tuple(line_told(program, number, wording) for number in range(at, end + 1))
    return Edited((*lines, *waits_again(program, waiting, wording)), end)


def line_told(program: TypedProgram, number: int, wording: Wording) -> str:
    """The line with its number."""
    text = program.lines[number - 1].strip()
    return wording("answer-line", line=number, text=text or wording("line-empty"))


def no_such_line(count: int, number: int, wording: Wording) -> str:
    """That there is no such line, of so many."""
    if not count:
        return wording("linear-no-lines")
    return wording("answer-no-line", line=number, last=count)


def _edited(
    program: TypedProgram, number: int, text: str, edit: Callable[[int, str], None], wording: Wording
) -> Edited:
    waiting = program.waiting
    try:
        edit(number, text)
    except ProgramTooLong:
        return Edited((wording("linear-too-long"),))
    told = line_told(program, number, wording)
    return Edited((told, *waits_again(program, waiting, wording)), number)


def waits_again(program: TypedProgram, before: int, wording: Wording) -> tuple[str, ...]:
    """A change to what has run lets everything wait again; nobody may be surprised by that."""
    now = program.waiting
    return (wording("linear-waits-again", lines=now),) if now > before + 1 else ()
