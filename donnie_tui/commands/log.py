"""LAST, SPELL, FIND, TYPED, SHOW LOG, LOG: what was said and typed before."""

from __future__ import annotations

from donnie_tui.commands import arguments
from donnie_tui.commands.context import Context
from donnie_tui.commands.dispatch import handles
from donnie_tui.commands.interaction import NotUnderstood, Option
from donnie_tui.commands.lookup import find
from donnie_tui.core.answer_log import found_in_words, none_so_far, spelled
from donnie_tui.i18n.messages import SPELLING_OF_SIGN

MOST_SHOWN = 10
"""Answers that SHOW LOG repeats."""
MOST_TYPED = 10
"""Lines that TYPED prints."""


@handles("last")
async def last(ctx: Context, argument: str) -> None:
    """Repeat the last answer, or one before it."""
    answer = ctx.answers.last(arguments.count(argument, 1))
    if answer:
        ctx.say(*ctx.counted(answer), is_repeated=True)
    else:
        ctx.say(none_so_far(ctx.answers, ctx.words))


@handles("spell")
async def spell(ctx: Context, argument: str) -> None:
    """Spell the last line of an answer."""
    _say_spelled(ctx, ctx.answers.last_line(arguments.count(argument, 1)))


@handles("last_word")
async def last_word(ctx: Context, _: str) -> None:
    """Spell the last word of the last answer."""
    _say_spelled(ctx, ctx.answers.last_word())


def _say_spelled(ctx: Context, text: str) -> None:
    ctx.say(*spelled(text, SPELLING_OF_SIGN, ctx.words), is_repeated=bool(text))


@handles("find")
async def find_answers(ctx: Context, argument: str) -> None:
    """The lines that have a word; the log on the screen goes to it."""
    if not argument:
        raise NotUnderstood
    is_found = bool(ctx.answers.found(argument))
    ctx.say(*found_in_words(ctx.answers, argument, ctx.words), is_repeated=is_found)
    if ctx.screen is not None:
        ctx.screen.search_log(argument)


@handles("show_log")
async def show_log(ctx: Context, _: str) -> None:
    """Go to the log; where there is no screen, repeat the last answers, the newest last."""
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
    """Open the log in the pager, where the terminal's own ways of reading work."""
    if ctx.screen is not None:
        ctx.screen.show_in_pager(ctx.screen.log_text)


@handles("typed")
async def typed(ctx: Context, argument: str) -> None:
    """The lines that were typed last; the one that is chosen is typed again."""
    lines = [each for each in enumerate(ctx.past.lines, 1) if not _is_typed(each[1])]
    count = arguments.count(argument, MOST_TYPED if ctx.screen is None else max(1, len(lines)))
    if not lines:
        ctx.answer("linear-nothing-typed")
        return
    shown = lines[-count:]
    options = [Option(line, line, number=number) for number, line in reversed(shown)]
    printed = [ctx.words("linear-listed", line=number, text=line) for number, line in shown]
    chosen = await ctx.interaction.choose(ctx.words("key-typed"), options, ctx.counted(printed))
    if chosen is not None:
        await ctx.interaction.type_again(chosen)


def _is_typed(line: str) -> bool:
    """Whether the line asks for the lines that were typed."""
    found = find(line)
    return found is not None and found[0].name == "typed"
