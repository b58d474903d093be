"""FIX, SEARCH, REPLACE, FORMAT, TRANSLATE, COMPLETE: the program as a text."""

from __future__ import annotations

from typing import TYPE_CHECKING

from donnie_tui.commands.arguments import replacement
from donnie_tui.commands.dispatch import handles
from donnie_tui.commands.interaction import GivenUp, NotUnderstood, Option
from donnie_tui.commands.program import offer_again, ran_and_waiting, say_if_all_waits
from donnie_tui.core.document import ProgramTooLong
from donnie_tui.core.program_text import (
    Mistake,
    fixed,
    line_in_words,
    mistakes,
    not_found,
    not_replaceable,
    quoted_word,
)
from donnie_tui.core.wording import language_named, name_of_language
from language.formatter import formatted
from language.locales import languages

if TYPE_CHECKING:
    from collections.abc import Callable

    from donnie_tui.commands.context import Context


# --- mistakes


@handles("fix")
async def fix(ctx: Context, _: str) -> None:
    """Replace a mistake by what was probably meant, and say the line.

    The mistake in the line that was read last, else the one that ERROR speaks of, else the next one. A line
    that was rejected is offered again, fixed as far as that is known.
    """
    document, session = ctx.program, ctx.donnie.session
    if document.rejected is not None:
        await _fix_rejected(ctx, document.rejected)
        return
    found = mistakes(session.check(document.text), ctx.words)
    known = [each for _, each in sorted(found.items()) if each.meant]
    if not known:
        ctx.answer("screen-no-fix" if found else "screen-nothing-to-fix")
        return
    mistake = _next_mistake(ctx, known)
    before = document.place

    def answer() -> None:
        if not document.is_in_editor:  # an editor keeps its cursor at its letter
            document.place = mistake.fixed_line
        _say_line(ctx, mistake.fixed_line, before)
        if ctx.screen is not None:
            ctx.screen.mark_mistakes()

    _change(ctx, lambda: document.replace_range(mistake.start, mistake.end, mistake.replacement), answer)


def _next_mistake(ctx: Context, known: list[Mistake]) -> Mistake:
    place, now = ctx.program.place, ctx.errors.now
    here = (each for each in known if each.line == place)
    reported = (each for each in known if now is not None and each.line == now.line)
    following = (each for each in known if each.line > place)
    return (*here, *reported, *following, *known)[0]


async def _fix_rejected(ctx: Context, line: str) -> None:
    found = mistakes(ctx.donnie.session.check(line, whole=False), ctx.words)
    known = next((each for each in found.values() if each.meant), None)
    if known is None:
        ctx.answer("screen-no-fix")
    if known is not None or ctx.interaction.can_edit:
        await offer_again(ctx, line if known is None else fixed(line, known))


def _change(ctx: Context, change: Callable[[], None], answer: Callable[[], None]) -> None:
    """Change the text, and answer; or say that it would be too long."""
    state = ran_and_waiting(ctx)
    try:
        change()
    except ProgramTooLong:
        ctx.answer("linear-too-long")
    else:
        answer()
        say_if_all_waits(ctx, state)


# --- searching


@handles("search")
async def search(ctx: Context, argument: str) -> None:
    """The next line with the word, from the reading place on and once round."""
    _search(ctx, argument or await _asked_for_word(ctx))


@handles("search_again")
async def search_again(ctx: Context, _: str) -> None:
    """The next line with the word that was searched last."""
    _search(ctx, ctx.workspace.searched or await _asked_for_word(ctx))


def _search(ctx: Context, wanted: str) -> None:
    document = ctx.program
    ctx.workspace.searched = wanted
    before = document.place
    line = document.find_next(wanted)
    if line is None:
        ctx.say(not_found(wanted, ctx.words))
    else:
        if ctx.screen is not None:
            ctx.screen.focus("program")
        _say_line(ctx, line, before)


async def _asked_for_word(ctx: Context) -> str:
    if not ctx.interaction.is_attended:
        raise NotUnderstood
    wanted = await ctx.interaction.ask(ctx.words("ask-search"), ctx.workspace.searched)
    if not wanted:
        raise GivenUp
    return wanted


@handles("replace")
async def replace(ctx: Context, argument: str) -> None:
    """Replace a word everywhere in the program, as it is written; asks by what."""
    document, wanted = ctx.program, argument or await _asked_for_word(ctx)
    count = document.text.count(wanted)
    if not count:
        ctx.say(not_replaceable(document.lines, wanted, ctx.words))
        return
    question = ctx.words("ask-replace-by", word=quoted_word(wanted))
    instead = replacement(await ctx.interaction.ask(question))
    if instead is None:
        raise GivenUp
    text = document.text.replace(wanted, instead)
    _change(ctx, lambda: document.rewrite(text), lambda: ctx.answer("screen-replaced", count=count))


# --- layout


@handles("format")
async def format_program(ctx: Context, _: str) -> None:
    """Lay the program out in its canonical form."""
    await _lay_out(ctx, None)


@handles("translate")
async def translate(ctx: Context, argument: str) -> None:
    """Write the keywords in another language."""
    language = language_named(argument)
    if not argument and ctx.interaction.is_attended:
        codes = languages()
        names = [name_of_language(each, ctx.words.language) for each in codes]
        options = [
            Option(each, name, number=number)
            for number, (each, name) in enumerate(zip(codes, names, strict=True), 1)
        ]
        printed = [ctx.words("linear-listed", line=number, text=name) for number, name in enumerate(names, 1)]
        language = await ctx.interaction.choose(ctx.words("ask-translate"), options, printed)
        if language is None:
            return
    if language is None:
        raise NotUnderstood
    await _lay_out(ctx, language)


async def _lay_out(ctx: Context, language: str | None) -> None:
    document, text = ctx.program, ctx.program.text
    if not document.lines:
        ctx.answer("linear-no-lines")
        return
    result = await ctx.interaction.background(
        lambda: formatted(text, language), ctx.words("slow-layout"), may_be_left=True
    )
    if document is not ctx.program or document.text != text:
        ctx.answer("text-changed-meanwhile")
    elif result.text is None:
        ctx.answer("screen-not-formatted", line=result.diagnostics[0].span.line)
    else:
        line, laid_out = document.place, result.text
        _change(ctx, lambda: document.rewrite(laid_out), lambda: ctx.answer("screen-formatted"))
        document.place = min(line, len(document.lines))


# --- the cursor


@handles("complete")
async def complete(ctx: Context, _: str) -> None:
    """Offer the words that may continue what was typed."""
    if ctx.screen is not None:
        await ctx.screen.complete()


def _say_line(ctx: Context, line: int, before: int) -> None:
    """The line; its level, where it differs from that of the line ``before``."""
    text = ctx.program.structure
    ctx.say(
        line_in_words(text.line(line), text.line(before) if 1 <= before <= len(text) else None, ctx.words)
    )
