"""LIST, CHANGE, INSERT, DELETE, MOVE, UNDO, REDO: the lines of the program, by their numbers."""

from __future__ import annotations

from typing import TYPE_CHECKING

from donnie_tui.commands import arguments
from donnie_tui.commands.arguments import number_and_text
from donnie_tui.commands.dispatch import handles
from donnie_tui.commands.interaction import GivenUp, NotUnderstood
from donnie_tui.core.document import ANOTHER_PROGRAM, ProgramTooLong
from donnie_tui.core.program_text import no_such_line

if TYPE_CHECKING:
    from collections.abc import Callable

    from donnie_tui.commands.context import Context

MOST_AT_ONCE = 20
"""Lines that LIST says one after the other; more are shown as a page, where there are pages."""


# --- listing


@handles("list")
async def list_lines(ctx: Context, argument: str) -> None:
    """All lines, one line, or the lines from one to another."""
    given, lines = arguments.numbers(argument, most=2), ctx.program.lines
    begin = given[0] if given else 1
    end = min(given[-1] if given else len(lines), len(lines))
    if not 1 <= begin <= end:
        _refuse(ctx, begin)
        return
    rows = [
        ctx.words("linear-listed", line=number, text=lines[number - 1].strip())
        for number in range(begin, end + 1)
    ]
    if len(rows) <= MOST_AT_ONCE:
        ctx.say(*rows)
        return
    page = (ctx.words("linear-lines", lines=len(rows)), *rows)
    if ctx.screen is not None:
        ctx.say(page[0])
    await ctx.interaction.show_pages(ctx.words("key-show_program"), page)


@handles("show_program")
async def show_program(ctx: Context, _: str) -> None:
    """Go to the program; where there is no screen, list it."""
    if ctx.screen is None:
        await list_lines(ctx, "")
    else:
        ctx.screen.focus("program")


def _refuse(ctx: Context, number: int) -> None:
    """The program has no such line."""
    ctx.say(no_such_line(len(ctx.program.lines), number, ctx.words))


def line_in_words(ctx: Context, number: int) -> str:
    """The line with its number."""
    text = ctx.program.lines[number - 1].strip()
    return ctx.words("answer-line", line=number, text=text or ctx.words("line-empty"))


# --- changing


@handles("change")
async def change(ctx: Context, argument: str) -> None:
    """CHANGE 3 FW 2. Without a text the line is offered for editing."""
    document, (number, text) = ctx.program, _number_and_text(argument)
    lines, rejected = document.lines, document.rejected
    if rejected is not None and number == len(lines) + 1 and (text or ctx.interaction.can_edit):
        await offer_again(ctx, text or rejected)
        return
    if not 1 <= number <= len(lines):
        _refuse(ctx, number)
        return
    present = lines[number - 1].strip()
    if not text:
        code = "linear-edit" if ctx.interaction.can_edit else "linear-type-line"
        text = await _typed_line(ctx, code, number, present)
    if text.strip() in ("", present):
        raise GivenUp
    _edit(ctx, lambda: document.change(number, text), number)


@handles("insert")
async def insert(ctx: Context, argument: str) -> None:
    """INSERT 3 FW 2: the lines from there on move down. Without a text the line is asked for."""
    document, (number, text) = ctx.program, _number_and_text(argument)
    if not 1 <= number <= len(document.lines) + 1:
        _refuse(ctx, number)
        return
    text = text or await _typed_line(ctx, "linear-type-line", number)
    if not text.strip():
        raise GivenUp
    _edit(ctx, lambda: document.insert(number, text), number)


async def _typed_line(ctx: Context, code: str, number: int, present: str = "") -> str:
    typed = await ctx.interaction.edit_line(ctx.words(code, line=number), present)
    if typed is None:
        raise GivenUp
    return typed


def _number_and_text(argument: str) -> tuple[int, str]:
    found = number_and_text(argument)
    if found is None:
        raise NotUnderstood
    return found


def _edit(ctx: Context, edit: Callable[[], None], number: int) -> None:
    state = ran_and_waiting(ctx)
    try:
        edit()
    except ProgramTooLong:
        ctx.answer("linear-too-long")
        return
    ctx.program.place = number
    ctx.say(line_in_words(ctx, number))
    say_if_all_waits(ctx, state)


async def offer_again(ctx: Context, line: str) -> None:
    """A line that was rejected because of a mistake: the learner corrects it, and enters it again.

    A front end that can't offer a line adds it to the program, where it waits.
    """
    if ctx.interaction.can_edit:
        number = len(ctx.program.lines) + 1
        typed = await _typed_line(ctx, "linear-edit", number, line.strip())
        await ctx.interaction.type_again(typed)
    else:
        ctx.program.add(line)
        number = ctx.program.place = len(ctx.program.lines)
        ctx.say(line_in_words(ctx, number))


@handles("delete")
async def delete(ctx: Context, argument: str) -> None:
    """One line, or the lines from one to another.

    Without a number the line of the cursor; where there is no cursor, the lines that have not run.
    """
    given, document = arguments.numbers(argument, most=2), ctx.program
    if not given and not document.is_in_editor:
        count, kept = document.delete_waiting(), len(document.lines)
        ctx.say(_deleted(ctx, kept + 1, kept + count) if count else ctx.words("linear-nothing-to-delete"))
        return
    first, end = (given[0], given[-1]) if given else (document.place,) * 2
    last = len(document.lines)
    if not 1 <= first <= end <= last:
        _refuse(ctx, first if not 1 <= first <= last else end)
        return
    state = ran_and_waiting(ctx)
    document.delete(first, end)
    ctx.say(_deleted(ctx, first, end))
    if first <= len(document.lines):
        document.place = first
        ctx.say(line_in_words(ctx, first))
    say_if_all_waits(ctx, state)


def _deleted(ctx: Context, first: int, last: int) -> str:
    if first == last:
        return ctx.words("linear-deleted", line=first)
    return ctx.words("linear-deleted-lines", first=first, last=last)


@handles("move")
async def move(ctx: Context, argument: str) -> None:
    """MOVE 5 2: line 5 before line 2. MOVE 5 7 2: lines 5 to 7."""
    given, document = arguments.numbers(argument, least=2, most=3), ctx.program
    first, last, to = given[0], given[-2], given[-1]
    state, count = ran_and_waiting(ctx), len(document.lines)
    try:
        at = document.move(first, last, to)
    except IndexError:
        wrong = next((each for each in (first, last, to) if not 1 <= each <= count), None)
        if wrong is None:
            raise GivenUp from None
        _refuse(ctx, wrong)
        return
    end = at + last - first
    document.place = end
    ctx.say(*(line_in_words(ctx, number) for number in range(at, end + 1)))
    say_if_all_waits(ctx, state)


# --- undoing


@handles("undo")
async def undo(ctx: Context, _: str) -> None:
    """Undo the last change, and say the first line that differs now."""
    state = ran_and_waiting(ctx)
    _say_changed(ctx, ctx.program.undo())
    say_if_all_waits(ctx, state)


@handles("redo")
async def redo(ctx: Context, _: str) -> None:
    """The same, for the change that was undone last."""
    state = ran_and_waiting(ctx)
    _say_changed(ctx, ctx.program.redo())
    say_if_all_waits(ctx, state)


def _say_changed(ctx: Context, changed: int | None) -> None:
    document = ctx.program
    if changed is None:
        raise GivenUp
    if changed == ANOTHER_PROGRAM:
        say_restored(ctx)
    elif changed <= len(document.lines):
        if not document.is_in_editor:  # an editor has its cursor where the change was
            document.place = changed
        ctx.say(line_in_words(ctx, changed))
    elif document.lines:
        ctx.answer("linear-lines", lines=len(document.lines))
    else:
        ctx.answer("linear-no-lines")


def say_restored(ctx: Context) -> None:
    """Another program is the current one again; its name, where it has a file."""
    document, lines = ctx.program, len(ctx.program.lines)
    if document.path is None:
        ctx.answer("answer-recovered" if lines else "answer-new", lines=lines)
    else:
        code = "answer-opened" if document.is_saved else "answer-recovered-file"
        ctx.answer(code, name=document.path.name, lines=lines)


# --- what has run


def ran_and_waiting(ctx: Context) -> tuple[int, int]:
    """How many lines have run and how many wait, before a change."""
    return ctx.program.ran, ctx.program.waiting


def say_if_all_waits(ctx: Context, before: tuple[int, int]) -> None:
    """A change to lines that had run makes the whole program wait again: the learner must know."""
    (ran, waiting), now = before, ctx.program.waiting
    if ran and now > waiting + 1:
        ctx.answer("linear-waits-again", lines=now)
