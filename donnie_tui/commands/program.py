"""LIST, CHANGE, MOVE, COPY, COMMENT, UNDO, FIX, SEARCH, REPLACE, FORMAT: the program, its lines, its text."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager

from donnie_tui.commands.context import Context
from donnie_tui.commands.declarations import BY_NAME
from donnie_tui.commands.dispatch import handles
from donnie_tui.commands.interaction import (
    GivenUp,
    NotUnderstood,
    Option,
    number_and_text,
    read_numbers,
    replacement,
)
from donnie_tui.commands.lookup import word_of
from donnie_tui.core.document import ANOTHER_PROGRAM, Document, ProgramTooLong
from donnie_tui.core.editing import joined
from donnie_tui.core.program_text import (
    LineMistake,
    fixed,
    line_in_words,
    mistakes,
    not_found,
    not_replaceable,
)
from donnie_tui.core.wording import language_named, name_of_language
from language.formatter import formatted
from language.keywords import spelling
from language.locales import languages
from language.source import quoted

MOST_AT_ONCE = 20
"""Lines that LIST says one after the other; more are shown as a page, where there are pages."""

_COMMENT = "--"

# --- listing


@handles("list")
async def list_lines(ctx: Context, argument: str) -> None:
    """All lines, one line, or the lines from one to another."""
    given, lines = read_numbers(argument, most=2), ctx.program.lines
    begin = given[0] if given else 1
    end = min(given[-1] if given else len(lines), len(lines))
    if not _has_lines(ctx, begin, end):
        return
    rows = [
        ctx.words("numbered-line", line=number, text=lines[number - 1].strip())
        for number in range(begin, end + 1)
    ]
    if len(rows) <= MOST_AT_ONCE:
        ctx.say(*rows)
        return
    page = (ctx.words("number-of-lines", lines=len(rows)), *rows)
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


def _numbered(ctx: Context, number: int) -> str:
    """The line with its number."""
    text = ctx.program.lines[number - 1].strip()
    return ctx.words("answer-line", line=number, text=text or ctx.words("line-empty"))


def say_line(ctx: Context, number: int, before: int) -> None:
    """Say the line; its level only if it differs from that of the line ``before``."""
    text = ctx.program.structure
    level_of = text.line(before) if 1 <= before <= len(text) else None
    ctx.say(line_in_words(text.line(number), level_of, ctx.words))


# --- changing


@contextmanager
def _changing(ctx: Context) -> Iterator[None]:
    """Wraps a change; answers if the text gets too long, or if all lines wait to be run again."""
    ran, waiting = ctx.program.ran, ctx.program.waiting
    try:
        yield
    except ProgramTooLong:
        ctx.answer("change-too-long")
        return
    now = ctx.program.waiting
    if ran and now > waiting + 1:
        ctx.answer("lines-wait-again", lines=now)


@handles("change")
async def change(ctx: Context, argument: str) -> None:
    """CHANGE 3 FW 2: replace line 3. Without a text, offer the line for editing."""
    document, (number, text) = ctx.program, _number_and_text(argument)
    lines, rejected = document.lines, document.rejected
    if rejected is not None and number == len(lines) + 1 and (text or ctx.interaction.can_edit):
        await offer_again(ctx, text or rejected)
        return
    if not 1 <= number <= len(lines):
        ctx.answer_no_line(number)
        return
    present = lines[number - 1].strip()
    if not text:
        code = "edit-line" if ctx.interaction.can_edit else "type-line"
        text = await _typed_line(ctx, code, number, present)
    if text.strip() in ("", present):
        raise GivenUp
    with _changing(ctx):
        document.change(number, text)
        document.place = number
        ctx.say(_numbered(ctx, number))


@handles("insert")
async def insert(ctx: Context, argument: str) -> None:
    """INSERT 3 FW 2: insert a line before line 3. Without a text, ask for it."""
    document, (number, text) = ctx.program, _number_and_text(argument)
    if not 1 <= number <= len(document.lines) + 1:
        ctx.answer_no_line(number)
        return
    text = text or await _typed_line(ctx, "type-line", number)
    if not text.strip():
        raise GivenUp
    with _changing(ctx):
        document.insert(number, text)
        document.place = number
        ctx.say(_numbered(ctx, number))


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


async def offer_again(ctx: Context, line: str) -> None:
    """Offer a line that was rejected because of a mistake, to be corrected and entered again.

    A front end that can't offer a line adds it to the program, where it waits.
    """
    if ctx.interaction.can_edit:
        number = len(ctx.program.lines) + 1
        typed = await _typed_line(ctx, "edit-line", number, line.strip())
        await ctx.interaction.type_again(typed)
    else:
        ctx.program.add(line)
        number = ctx.program.place = len(ctx.program.lines)
        ctx.say(_numbered(ctx, number))


@handles("delete")
async def delete(ctx: Context, argument: str) -> None:
    """Delete one line, or the lines from one to another.

    Without a number, delete the line of the cursor; without a cursor, the lines that have not run.
    """
    given, document = read_numbers(argument, most=2), ctx.program
    if not given and not document.is_in_editor:
        count, kept = document.delete_waiting(), len(document.lines)
        ctx.say(_deleted(ctx, kept + 1, kept + count) if count else ctx.words("nothing-to-delete"))
        return
    first, end = (given[0], given[-1]) if given else (document.place,) * 2
    if not _has_lines(ctx, first, end):
        return
    with _changing(ctx):
        document.delete(first, end)
        ctx.say(_deleted(ctx, first, end))
        if first <= len(document.lines):
            document.place = first
            ctx.say(_numbered(ctx, first))


def _deleted(ctx: Context, first: int, last: int) -> str:
    if first == last:
        return ctx.words("line-deleted", line=first)
    return ctx.words("lines-deleted", first=first, last=last)


@handles("move")
async def move(ctx: Context, argument: str) -> None:
    """MOVE 5 2: line 5 before line 2. MOVE 5 7 2: lines 5 to 7. MOVE treasure 2 0: a thing of the world.

    MOVE 5 is what a beginner says for FW 5.
    """
    if argument[:1].isalpha():
        from donnie_tui.commands.build import move_thing

        await move_thing(ctx, argument)
        return
    given, document = read_numbers(argument, least=1, most=3), ctx.program
    if len(given) == 1:
        ctx.refuse()
        word, walk = word_of(BY_NAME["move"], ctx.words.language), spelling("FW", ctx.words.language)
        ctx.answer("help-unknown-near", topic=f"{word} {argument}", near=f"{walk} {given[0]}")
        return
    first, last, to = given[0], given[-2], given[-1]
    if not _has_lines(ctx, first, last, to):
        return
    if first <= to <= last + 1:
        raise GivenUp
    with _changing(ctx):
        at = document.move(first, last, to)
        document.place = end = at + last - first
        ctx.say(*(_numbered(ctx, number) for number in range(at, end + 1)))


@handles("copy")
async def copy(ctx: Context, argument: str) -> None:
    """COPY 5: line 5 once more below it. COPY 5 2: before line 2. COPY 5 7 2: lines 5 to 7."""
    given, lines = read_numbers(argument, most=3), list(ctx.program.lines)
    first = given[0] if given else max(1, ctx.program.place)
    last = given[1] if len(given) > 2 else first
    to = given[-1] if len(given) > 1 else last + 1
    if not _has_lines(ctx, first, last, to):
        return
    copied = lines[first - 1 : last]
    with _changing(ctx):
        ctx.program.rewrite(joined([*lines[: to - 1], *copied, *lines[to - 1 :]]))
        ctx.program.place = to + len(copied) - 1
        ctx.say(*(_numbered(ctx, number) for number in range(to, to + len(copied))))


@handles("comment")
async def comment(ctx: Context, argument: str) -> None:
    """Turn lines into comments, or comments back into lines."""
    given, lines = read_numbers(argument, most=2), list(ctx.program.lines)
    first, last = (given[0], given[-1]) if given else (max(1, ctx.program.place),) * 2
    if not _has_lines(ctx, first, last):
        return
    chosen = lines[first - 1 : last]
    written = [each for each in chosen if each.strip()]
    if not written:
        raise GivenUp
    change = _uncommented if all(each.lstrip().startswith(_COMMENT) for each in written) else _commented
    with _changing(ctx):
        ctx.program.rewrite(joined([*lines[: first - 1], *(change(each) for each in chosen), *lines[last:]]))
        ctx.program.place = last
        ctx.say(*ctx.counted([_numbered(ctx, number) for number in range(first, last + 1)]))


def _has_lines(ctx: Context, first: int, last: int, to: int = 1) -> bool:
    """Whether the program has these lines, and ``to`` is a line or the place after all; answers if not."""
    count = len(ctx.program.lines)
    wrong = next((each for each in (first, last) if not 1 <= each <= count), None)
    if wrong is None and first <= last and not 1 <= to <= count + 1:
        wrong = to
    if wrong is not None:
        ctx.answer_no_line(wrong)
        return False
    if first > last:
        raise NotUnderstood
    return True


def _commented(line: str) -> str:
    words = line.lstrip()
    return f"{line[: len(line) - len(words)]}{_COMMENT} {words}" if words else line


def _uncommented(line: str) -> str:
    indent, _mark, words = line.partition(_COMMENT)
    return f"{indent}{words.removeprefix(' ')}"


# --- undoing


@handles("undo", change=Document.undo)
@handles("redo", change=Document.redo)
async def undo(ctx: Context, _: str, change: Callable[[Document], int | None]) -> None:
    """Undo or redo the last change, and say the first line that differs.

    Changes of the world since the last change of the program are undone first and redone last.
    """
    is_undo = change == Document.undo
    if ctx.donnie.site.past if is_undo else ctx.donnie.site.undone:
        from donnie_tui.commands.build import step_building  # few worlds are built

        if step_building(ctx, is_undo=is_undo):
            return
    with _changing(ctx):
        _say_changed(ctx, change(ctx.program))


def _say_changed(ctx: Context, changed: int | None) -> None:
    document = ctx.program
    if changed is None:
        raise GivenUp
    if changed == ANOTHER_PROGRAM:
        say_restored(ctx)
    elif changed <= len(document.lines):
        if not document.is_in_editor:  # an editor has its cursor where the change was
            document.place = changed
        ctx.say(_numbered(ctx, changed))
    elif document.lines:
        ctx.answer("program-has-lines", lines=len(document.lines))
    else:
        ctx.answer("no-lines")


def say_restored(ctx: Context) -> None:
    """Say that an earlier program is current again, with its name if it has a file."""
    document, lines = ctx.program, len(ctx.program.lines)
    if document.path is None:
        ctx.answer("answer-recovered" if lines else "answer-new", lines=lines)
    else:
        code = "answer-opened" if document.is_saved else "answer-recovered-file"
        ctx.answer(code, name=document.path.name, lines=lines)


# --- mistakes


@handles("fix")
async def fix(ctx: Context, _: str) -> None:
    """Replace a mistake by what was probably meant, and say the line.

    Fixes the mistake in the line that was read last, else the one that ERROR said, else the next one. A line
    that was rejected is offered again with the fix. A line that has run stays as it is:
    otherwise the robot would repeat what it has done. The line at which the program failed waits again.
    """
    document, session = ctx.program, ctx.donnie.session
    if document.rejected is not None:
        await _fix_rejected(ctx, document.rejected)
        return
    found = [each for _, each in sorted(mistakes(session.check(document.text), ctx.words).items())]
    waiting = [each for each in found if each.fixed_line > document.ran]
    known = [each for each in waiting if each.meant]
    if not known and (failed := document.failed_line) is not None:
        known = [each for each in found if each.fixed_line == failed and each.meant]
    if not known:
        if found and not waiting and document.failed_line is None:
            now = ctx.errors.now
            has_failed = now is not None and 0 < now.line <= document.ran
            ctx.answer("fix-has-run", line=now.line if now and has_failed else found[0].fixed_line)
        else:
            ctx.answer("screen-no-fix" if found else "screen-nothing-to-fix")
        return
    mistake = _next_mistake(ctx, known)
    before, has_failed = document.place, mistake.fixed_line <= document.ran
    with _changing(ctx):
        document.replace_range(mistake.start, mistake.end, mistake.replacement)
        if has_failed:
            document.wait_from(mistake.fixed_line)
        if not document.is_in_editor:  # an editor keeps its cursor at its letter
            document.place = mistake.fixed_line
        say_line(ctx, mistake.fixed_line, before)
        if ctx.screen is not None:
            ctx.screen.mark_mistakes()


def _next_mistake(ctx: Context, known: list[LineMistake]) -> LineMistake:
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


# --- searching


@handles("search")
async def search(ctx: Context, argument: str) -> None:
    """Go to the next line with the word, from the reading place on and once around."""
    _search(ctx, argument or await _asked_for_word(ctx))


@handles("search_again")
async def search_again(ctx: Context, _: str) -> None:
    """Go to the next line with the last searched word."""
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
        say_line(ctx, line, before)


async def _asked_for_word(ctx: Context) -> str:
    if not ctx.interaction.is_attended:
        raise NotUnderstood
    wanted = await ctx.interaction.ask(ctx.words("ask-search"), ctx.workspace.searched)
    if not wanted:
        raise GivenUp
    return wanted


@handles("replace")
async def replace(ctx: Context, argument: str) -> None:
    """Replace a word, in this spelling, everywhere in the program; ask for the replacement."""
    document, wanted = ctx.program, argument or await _asked_for_word(ctx)
    count = document.text.count(wanted)
    if not count:
        ctx.say(not_replaceable(document.lines, wanted, ctx.words))
        return
    question = ctx.words("ask-replace-by", word=quoted(wanted))
    instead = replacement(await ctx.interaction.ask(question))
    if instead is None:
        raise GivenUp
    with _changing(ctx):
        document.rewrite(document.text.replace(wanted, instead))
        ctx.answer("screen-replaced", count=count)


# --- layout


@handles("format")
async def format_program(ctx: Context, _: str) -> None:
    """Format the program canonically."""
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
        printed = [ctx.words("numbered-line", line=number, text=name) for number, name in enumerate(names, 1)]
        language = await ctx.interaction.choose(ctx.words("ask-translate"), options, printed)
        if language is None:
            return
    if language is None:
        raise NotUnderstood
    await _lay_out(ctx, language)


async def _lay_out(ctx: Context, language: str | None) -> None:
    document, text = ctx.program, ctx.program.text
    if not document.lines:
        ctx.answer("no-lines")
        return
    result = await ctx.interaction.background(
        lambda: formatted(text, language), ctx.words("slow-layout"), may_be_left=True
    )
    if document is not ctx.program or document.text != text:
        ctx.answer("text-changed-meanwhile")
    elif result.text is None:
        ctx.answer("screen-not-formatted", line=result.diagnostics[0].span.line)
    else:
        line = document.place
        with _changing(ctx):
            if result.text != text:  # else UNDO would undo nothing
                document.rewrite(result.text)
            ctx.answer("screen-formatted")
        document.place = min(line, len(document.lines))


# --- the cursor


@handles("complete")
async def complete(ctx: Context, _: str) -> None:
    """Offer the words that may continue what was typed."""
    if ctx.screen is not None:
        await ctx.screen.complete()
