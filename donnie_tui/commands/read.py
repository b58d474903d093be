"""READ, NEXT, BACK, PLACE, UP, OUTLINE and the mistakes: the program line by line.

The reading place is the line that was read last, or the line of the cursor. A move that is not possible says
so and stays.
"""

from __future__ import annotations

from collections.abc import Callable

from donnie_tui.commands import arguments
from donnie_tui.commands.context import Context
from donnie_tui.commands.dispatch import handles
from donnie_tui.commands.interaction import Option
from donnie_tui.core.events import Error
from donnie_tui.core.program_text import (
    ProgramText,
    line_in_words,
    no_such_line,
    outline_in_words,
    place_in_words,
)
from donnie_tui.core.run_state import line_of


def go_to(ctx: Context, number: int) -> None:
    """Read line ``number`` and stay there, with its level where that has changed."""
    text = ctx.program.structure
    try:
        line = text.line(number)
    except IndexError:
        ctx.say(no_such_line(len(text), number, ctx.words))
        return
    here = ctx.program.place
    before = text.line(here) if 1 <= here <= len(text) else None
    ctx.program.place = number
    if ctx.screen is not None:
        ctx.screen.focus("program")
    ctx.say(line_in_words(line, before, ctx.words))


@handles("read")
async def read(ctx: Context, argument: str) -> None:
    """Read a line, or once more the one of the reading place."""
    given = arguments.numbers(argument, most=1)
    go_to(ctx, given[0] if given else max(1, ctx.program.place))


@handles("go_to")
async def go_to_line(ctx: Context, argument: str) -> None:
    """Go to a line by its number, which is asked for."""
    typed = argument or await ctx.interaction.ask(ctx.words("ask-line"))
    if typed:
        (number,) = arguments.numbers(typed, least=1, most=1)
        go_to(ctx, number)


@handles("next")
async def next_line(ctx: Context, _: str) -> None:
    """The next line."""
    _step(ctx, "next", ctx.program.place + 1)


@handles("back")
async def line_before(ctx: Context, _: str) -> None:
    """The line before."""
    _step(ctx, "back", ctx.program.place - 1)


def _step(ctx: Context, name: str, number: int) -> None:
    last = len(ctx.program.structure)
    if last and not 1 <= number <= last:
        ctx.answer(f"read-no-{name}")
    else:
        go_to(ctx, number)


@handles("first")
async def first_line(ctx: Context, _: str) -> None:
    """The first line."""
    go_to(ctx, 1)


@handles("last_line")
async def last_line(ctx: Context, _: str) -> None:
    """The last line."""
    go_to(ctx, len(ctx.program.structure))


@handles("up")
async def up(ctx: Context, _: str) -> None:
    """The line that opens the block."""
    _move(ctx, "up", ProgramText.up)


@handles("down")
async def down(ctx: Context, _: str) -> None:
    """The first line inside the block."""
    _move(ctx, "down", ProgramText.down)


@handles("next_same")
async def next_same(ctx: Context, _: str) -> None:
    """The next line of the same level in the same block."""
    _move(ctx, "next_same", ProgramText.next_same)


@handles("back_same")
async def back_same(ctx: Context, _: str) -> None:
    """The line of the same level before, in the same block."""
    _move(ctx, "back_same", ProgramText.back_same)


def _move(ctx: Context, name: str, find: Callable[[ProgramText, int], int | None]) -> None:
    text = ctx.program.structure
    if not text:
        ctx.answer("linear-no-lines")
        return
    number = find(text, _line_within(ctx, text))
    if number is None:
        ctx.answer(f"read-no-{name}")
    else:
        go_to(ctx, number)


def _line_within(ctx: Context, text: ProgramText) -> int:
    return min(max(1, ctx.program.place), len(text))


@handles("place")
async def place(ctx: Context, _: str) -> None:
    """In which blocks the line is."""
    text = ctx.program.structure
    if text:
        ctx.say(*place_in_words(text, _line_within(ctx, text), ctx.words))
    else:
        ctx.answer("linear-no-lines")


@handles("outline")
async def outline(ctx: Context, _: str) -> None:
    """The lines that open blocks and procedures, to choose one."""
    text, words = ctx.program.structure, ctx.words
    lines = text.outline_lines
    printed = outline_in_words(text, words)
    if not lines:
        ctx.say(*printed)
        return
    rows = zip(lines, printed[1:], strict=True)
    options = [Option(str(each.number), row) for each, row in rows]
    chosen = await ctx.interaction.choose(words("outline-count", count=len(lines)), options, printed)
    if chosen:
        go_to(ctx, int(chosen))


# --- mistakes


@handles("error")
async def latest_error(ctx: Context, _: str) -> None:
    """The mistake that was said last; the reading place goes to its line."""
    _go_to_error(ctx, 0)


@handles("error_next")
async def error_next(ctx: Context, _: str) -> None:
    """The next mistake of the run."""
    _go_to_error(ctx, 1)


@handles("error_previous")
async def error_previous(ctx: Context, _: str) -> None:
    """The mistake before."""
    _go_to_error(ctx, -1)


def _go_to_error(ctx: Context, by: int) -> None:
    found, lines = ctx.errors.go(by, ctx.words)
    if found is not None:
        _show(ctx, found)
    ctx.say(*lines)


def _show(ctx: Context, error: Error) -> None:
    """The reading place goes to a mistake, the focus stays."""
    if ctx.screen is not None:
        ctx.screen.place_cursor(error.line, error.column)
    else:
        ctx.program.place = error.line


@handles("errors")
async def errors(ctx: Context, _: str) -> None:
    """All mistakes of the last run."""
    ctx.say(*ctx.counted(ctx.errors.in_words(ctx.words)))


@handles("explain")
async def explain(ctx: Context, _: str) -> None:
    """The mistake in plain words and what to do, with an example and the line as it was then."""
    found = ctx.errors.now
    ctx.say(*ctx.errors.explained(ctx.donnie.session.hub.robot, ctx.words))
    if found is None:
        return
    if tuple(ctx.program.lines[found.line - 1 : found.line]) == (found.source_line,):
        go_to(ctx, found.line)
    else:
        _show(ctx, found)
        ctx.say(*line_of(found, ctx.words))
