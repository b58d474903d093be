"""READ, NEXT, UP, OUTLINE, ERROR, EXPLAIN; LAST, SPELL, FIND, TYPED: the program, and what was said.

The reading place is the line that was read last, or the line of the cursor. An impossible move says
so and stays.
"""

from __future__ import annotations

from collections.abc import Callable

from donnie_tui.commands.context import Context
from donnie_tui.commands.dispatch import handles
from donnie_tui.commands.interaction import NotUnderstood, Option, read_count, read_numbers
from donnie_tui.commands.lookup import find
from donnie_tui.commands.program import say_line
from donnie_tui.core.events import Error
from donnie_tui.core.program_text import (
    ProgramText,
    mistakes,
    outline_in_words,
    place_in_words,
)
from donnie_tui.core.run_state import line_of
from donnie_tui.core.session_log import found_in_words, letter_by_letter, none_so_far
from donnie_tui.core.transcript import lines_of

MOST_SHOWN = 10
"""Answers that SHOW LOG repeats."""
MOST_TYPED = 10
"""Lines that TYPED prints."""


def go_to(ctx: Context, number: int) -> None:
    """Read line ``number`` and stay there, with its level where that has changed."""
    if not 1 <= number <= len(ctx.program.lines):
        ctx.answer_no_line(number)
        return
    before, ctx.program.place = ctx.program.place, number
    if ctx.screen is not None:
        ctx.screen.focus("program")
    say_line(ctx, number, before)


@handles("read")
async def read(ctx: Context, argument: str) -> None:
    """Read a line, or the one of the reading place again."""
    given = read_numbers(argument, most=1)
    go_to(ctx, given[0] if given else max(1, ctx.program.place))


@handles("go_to")
async def go_to_line(ctx: Context, argument: str) -> None:
    """Go to a line by its number; without one, ask for it."""
    typed = argument or await ctx.interaction.ask(ctx.words("ask-line"))
    if typed:
        (number,) = read_numbers(typed, least=1, most=1)
        go_to(ctx, number)


@handles("next", otherwise="read-no-next", by=1)
@handles("back", otherwise="read-no-back", by=-1)
async def next_line(ctx: Context, _: str, otherwise: str, by: int) -> None:
    """Read the next or the previous line."""
    number, last = ctx.program.place + by, len(ctx.program.lines)
    if last and not 1 <= number <= last:
        ctx.answer(otherwise)
    else:
        go_to(ctx, number)


@handles("first")
async def first_line(ctx: Context, _: str) -> None:
    """Read the first line."""
    go_to(ctx, 1)


@handles("last_line")
async def last_line(ctx: Context, _: str) -> None:
    """Read the last line."""
    go_to(ctx, len(ctx.program.structure))


@handles("up", otherwise="read-no-up", find=ProgramText.up)
@handles("down", otherwise="read-no-down", find=ProgramText.down)
@handles("next_same", otherwise="read-no-next_same", find=ProgramText.next_same)
@handles("back_same", otherwise="read-no-back_same", find=ProgramText.back_same)
async def move(ctx: Context, _: str, otherwise: str, find: Callable[[ProgramText, int], int | None]) -> None:
    """Read the line that opens the block, the first line in the block, or the next line of the same level."""
    text = ctx.program.structure
    if not text:
        ctx.answer("no-lines")
        return
    number = find(text, _line_within(ctx, text))
    if number is None:
        ctx.answer(otherwise)
    else:
        go_to(ctx, number)


def _line_within(ctx: Context, text: ProgramText) -> int:
    return min(max(1, ctx.program.place), len(text))


@handles("place")
async def place(ctx: Context, _: str) -> None:
    """Say in which blocks the line is."""
    text = ctx.program.structure
    if text:
        ctx.say(*place_in_words(text, _line_within(ctx, text), ctx.words))
    else:
        ctx.answer("no-lines")


@handles("outline")
async def outline(ctx: Context, _: str) -> None:
    """Offer the lines that open blocks and procedures, to go to one."""
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


@handles("error", by=0)
@handles("error_next", by=1)
@handles("error_previous", by=-1)
async def error(ctx: Context, _: str, by: int) -> None:
    """Say the current, the next or the previous mistake, and move the reading place there."""
    found, lines = ctx.errors.go(by, ctx.words)
    if found is not None:
        _show(ctx, found)
    ctx.say(*lines)


def _show(ctx: Context, error: Error) -> None:
    """Move the reading place to a mistake; the focus stays."""
    if ctx.screen is not None:
        ctx.screen.place_cursor(error.line, error.column)
    else:
        ctx.program.place = error.line


@handles("errors")
async def errors(ctx: Context, _: str) -> None:
    """Say all mistakes of the last run; on a screen also those of the current text, to go to one."""
    screen = ctx.screen
    options = [] if screen is None else _mistakes_to_choose(ctx)
    if screen is None or screen.is_plain or not options:
        of_text = [each.text for each in options] if not ctx.errors.all else []
        ctx.say(*ctx.counted(of_text or ctx.errors.in_words(ctx.words)))
        return
    chosen = await ctx.interaction.choose(ctx.words("errors-count", count=len(options)), options)
    if chosen is not None:
        line, _, column = chosen.partition(" ")
        screen.focus("program")
        screen.place_cursor(int(line), int(column))


def _mistakes_to_choose(ctx: Context) -> list[Option]:
    """The mistakes of the current text, then those of the last run in other lines, with their places."""
    lines, words, now = ctx.program.lines, ctx.words, ctx.errors.now
    found = {
        (each.line, 1): each.message
        for each in sorted(
            mistakes(ctx.donnie.session.check(ctx.program.text), words).values(), key=lambda each: each.line
        )
    }
    known = {line for line, _ in found}
    for each in ctx.errors.all:
        if each.line not in known and tuple(lines[each.line - 1 : each.line]) == (each.source_line,):
            found[each.line, each.column] = " ".join(lines_of(each, words)[:1])
    return [
        Option(
            f"{line} {column}",
            message
            if line not in known
            else words("error-row", line=line, text=lines[line - 1].strip(), message=message),
            is_current=now is not None and now.line == line,
        )
        for (line, column), message in found.items()
    ]


@handles("explain")
async def explain(ctx: Context, _: str) -> None:
    """Explain the mistake: what to do, an example, and the line at that time."""
    found = ctx.errors.now
    ctx.say(*ctx.errors.explained(ctx.donnie.session.hub.robot, ctx.words))
    if found is None:
        return
    if tuple(ctx.program.lines[found.line - 1 : found.line]) == (found.source_line,):
        go_to(ctx, found.line)
    else:
        _show(ctx, found)
        ctx.say(*line_of(found, ctx.words))


# --- what was said and typed


@handles("last")
async def last(ctx: Context, argument: str) -> None:
    """Repeat the last answer, or one before it."""
    answer = ctx.answers.last(read_count(argument, 1))
    if answer:
        ctx.say(*ctx.counted(answer), is_repeated=True)
    else:
        ctx.say(none_so_far(ctx.answers, ctx.words))


@handles("spell")
async def spell(ctx: Context, argument: str) -> None:
    """Spell the last line of an earlier answer."""
    _spell(ctx, ctx.answers.last_line(read_count(argument, 1)))


@handles("last_word")
async def last_word(ctx: Context, _: str) -> None:
    """Spell the last word of the last answer."""
    _spell(ctx, ctx.answers.last_word())


def _spell(ctx: Context, text: str) -> None:
    ctx.say(*letter_by_letter(text, ctx.words), is_repeated=bool(text))


@handles("find")
async def find_answers(ctx: Context, argument: str) -> None:
    """Say the lines of the log with a word; on a screen the log scrolls to it."""
    if not argument:
        raise NotUnderstood
    found = len(ctx.answers.found(argument))
    ctx.say(*found_in_words(ctx.answers, argument, ctx.words), is_repeated=found > 0)
    if ctx.screen is not None:
        ctx.screen.search_log(argument, found)


@handles("filter")
async def filter_log(ctx: Context, _: str) -> None:
    """Offer the kinds of lines in the log with their numbers, and show only one kind, or all again."""
    assert ctx.screen is not None
    kinds, words = ctx.screen.log_kinds, ctx.words
    everything = Option("", words("log-all", lines=sum(kinds.values())), is_current=not ctx.screen.log_filter)
    rows = [
        Option(kind, words("log-kind", kind=kind, lines=count), is_current=kind == ctx.screen.log_filter)
        for kind, count in kinds.items()
        if kind
    ]
    chosen = await ctx.interaction.choose(words("ask-filter"), [everything, *rows])
    if chosen is not None:
        ctx.screen.filter_log(chosen)
        if chosen:
            ctx.answer("log-filtered", kind=chosen, lines=kinds[chosen])
        else:
            ctx.answer("log-unfiltered")


@handles("show_log")
async def show_log(ctx: Context, _: str) -> None:
    """Focus the log; without a screen, repeat the last answers, the newest last."""
    if ctx.screen is not None:
        ctx.screen.focus("log")
        return
    answers = [ctx.answers.last(which) for which in range(min(MOST_SHOWN, len(ctx.answers)), 0, -1)]
    if answers:
        lines = [line for answer in answers for line in answer]
        ctx.say(*ctx.counted(lines), is_repeated=True)
    else:
        ctx.answer("answer-nothing-said")


@handles("open_log")
async def open_log(ctx: Context, _: str) -> None:
    """Open the log in the pager, where the terminal's own search and scrolling work."""
    if ctx.screen is not None:
        ctx.screen.show_in_pager(ctx.screen.log_text)


@handles("typed")
async def typed(ctx: Context, argument: str) -> None:
    """Offer the lines that were typed last, to type one again."""
    lines = [each for each in enumerate(ctx.past.lines, 1) if not _is_typed(each[1])]
    count = read_count(argument, MOST_TYPED if ctx.screen is None else max(1, len(lines)))
    if not lines:
        ctx.answer("nothing-typed")
        return
    shown = lines[-count:]
    options = [Option(line, line, number=number) for number, line in reversed(shown)]
    printed = [ctx.words("numbered-line", line=number, text=line) for number, line in shown]
    chosen = await ctx.interaction.choose(ctx.words("key-typed"), options, ctx.counted(printed))
    if chosen is not None:
        await ctx.interaction.type_again(chosen)


def _is_typed(line: str) -> bool:
    """Whether the line is the command TYPED."""
    found = find(line)
    return found is not None and found[0].name == "typed"
