"""OPEN, EXAMPLES, SAVE, SAVE AS, NEW, RECOVER, RECENT, PROGRAMS, SAVE LOG, REPORT: programs, files, pages.

No typed line is lost without a question. Files are read and written in the background, so a slow disk delays
nothing else, and a save always completes, whatever the learner asks for meanwhile.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from donnie_tui.commands.context import Context
from donnie_tui.commands.dispatch import confirm_replacing, handles
from donnie_tui.commands.interaction import GivenUp, NotUnderstood, Option, read_count
from donnie_tui.commands.lookup import words_in_lines
from donnie_tui.commands.program import say_restored
from donnie_tui.core import reports
from donnie_tui.core.program_files import (
    DocumentError,
    as_lines,
    checked_path,
    exists,
    page_to_save,
    program_meant,
    program_to_open,
    program_to_save,
    read_program,
    save_question,
    saved_text,
    write_bytes,
)
from donnie_tui.i18n.words import Unusable

if TYPE_CHECKING:
    from donnie_tui.core.document import Document
    from donnie_tui.world.run_picture import RunPicture


# --- opening


@handles("open")
async def open_named(ctx: Context, argument: str) -> None:
    """Open the file with this name; without a name, ask for one."""
    if argument:
        await _open_text(ctx, *await _read(ctx, argument, may_begin=ctx.interaction.is_attended))
    elif not ctx.interaction.is_attended:
        raise NotUnderstood
    else:
        await _open_text(ctx, *await _read_asked(ctx))


async def open_file(ctx: Context, name: str) -> None:
    """Open the file with a name that was not typed at this prompt."""
    await _open_text(ctx, *await _read(ctx, name))


async def _read_asked(ctx: Context) -> tuple[Path, str]:
    """Read the file of a typed name; if the name is wrong, say why and ask again."""
    question, name = ctx.words("ask-open"), ""
    while answer := await ctx.interaction.ask_file(question, name, ctx.workspace.recent.paths):
        try:
            return await _read(ctx, answer, may_begin=True)
        except DocumentError as error:
            question, name = ctx.words(error.code, path=error.path, reason=error.reason), str(answer)
    raise GivenUp


async def _read(ctx: Context, name: str | Path, *, may_begin: bool = False) -> tuple[Path, str]:
    """Raises ``DocumentError``. ``may_begin``: the name may be the beginning of the only matching one."""

    def read() -> tuple[Path, str]:
        path = checked_path(name) if isinstance(name, Path) else program_to_open(name)
        if may_begin and isinstance(name, str) and not exists(path):
            path = program_meant(name)
        return path, as_lines(read_program(path))

    slow = ctx.words("slow-opening", name=Path(name).name or name)
    return await ctx.interaction.background(read, slow, may_be_left=True)


async def _open_text(ctx: Context, path: Path, text: str) -> None:
    """Replace the current program by the text of a file."""
    was_saved = ctx.program.is_saved
    if not await may_lose_text(ctx):
        return
    if ctx.program.is_saved and not was_saved:  # perhaps into this very file
        path, text = await _read(ctx, path)
    ctx.workspace.open(path, text)
    program = ctx.program
    ctx.answer("answer-opened", name=path.name, lines=len(program.lines))
    if program.breakpoints:  # a run will pause there, and the learner may not remember it
        ctx.answer("break-lines", lines=", ".join(map(str, sorted(program.breakpoints))))


async def compare_with_file(ctx: Context) -> None:
    """Compare a program that came from the other front end with its file; until then it counts as changed."""
    document = ctx.program
    path = document.path
    if path is not None:
        slow = ctx.words("slow-opening", name=path.name)
        saved = await ctx.interaction.background(lambda: saved_text(path), slow)
        if document.path == path:
            document.mark_saved(path, saved)


@handles("examples")
async def examples(ctx: Context, argument: str) -> None:
    """Offer the example programs in the learner's words, or open one by its number."""
    from worlds import EXAMPLES

    words, chosen = ctx.words, ""
    titles = {name: words(f"example-{name}") for name in EXAMPLES}
    if argument:
        number = read_count(argument, 1)
        chosen = dict(enumerate(titles, 1)).get(number, "")
        if not chosen:
            raise NotUnderstood
    else:
        numbered = list(enumerate(titles.items(), 1))
        options = [
            Option(name, title, number=number, detail=partial(_example_lines, name, words.language))
            for number, (name, title) in numbered
        ]
        printed = [words("numbered-line", line=number, text=title) for number, (_, title) in numbered]
        chosen = await ctx.interaction.choose(words("ask-examples"), options, printed) or ""
    if chosen and await may_lose_text(ctx):
        ctx.workspace.replace("\n".join(_example_lines(chosen, words.language)), None)
        ctx.answer("answer-opened", name=titles[chosen], lines=len(ctx.program.lines))


def _example_lines(name: str, language: str, *_room: int) -> tuple[str, ...]:
    """An example program with the keywords of a language."""
    from language.formatter import formatted
    from worlds import example

    return tuple((formatted(example(name), language).text or "").split("\n"))


@handles("new")
async def new(ctx: Context, _: str) -> None:
    """Begin an empty program."""
    if await may_lose_text(ctx):
        ctx.workspace.replace("", None)
        ctx.answer("answer-new")


@handles("recover")
async def recover(ctx: Context, _: str) -> None:
    """Open the newest unsaved program; repeated, open the next one."""
    workspace = ctx.workspace
    found = workspace.recoverable()
    if found is None:
        ctx.answer("answer-nothing-to-recover")
        return
    slow = ctx.words("slow-opening", name=found.name if isinstance(found, Path) else "")
    program, in_file = await ctx.interaction.background(lambda: workspace.read_recoverable(found), slow)
    if await may_lose_text(ctx):
        workspace.recover(found, program, in_file)
        say_restored(ctx)
        if workspace.rescued():
            ctx.answer("answer-rescued-more")


@handles("recent")
async def recent(ctx: Context, _: str) -> None:
    """Offer the programs that were opened and saved lately."""
    paths = ctx.workspace.recent.paths()
    if not paths:
        ctx.answer("screen-no-recent")
        return
    options = [Option(str(path), f"{path.name}, {path.parent}") for path in paths]
    chosen = await ctx.interaction.choose(ctx.words("ask-recent"), options)
    if chosen is not None:
        await open_file(ctx, chosen)


# --- several programs


@handles("programs")
async def programs(ctx: Context, _: str) -> None:
    """Offer the open programs and a new, empty one. No text is lost."""
    documents = ctx.workspace.documents
    options = [
        Option(str(at), _title(ctx, each), is_current=each is ctx.program)
        for at, each in enumerate(documents)
    ]
    options.append(Option("new", ctx.words("another-program")))
    chosen = await ctx.interaction.choose(ctx.words("ask-programs"), options)
    if chosen is not None:
        _turn_to(ctx, ctx.workspace.add_document() if chosen == "new" else documents[int(chosen)])


def _turn_to(ctx: Context, document: Document) -> None:
    ctx.workspace.keep_copies()
    ctx.workspace.turn_to(document)
    ctx.answer("screen-turned-to", name=_name_of(ctx, document))


def _name_of(ctx: Context, document: Document) -> str:
    return document.path.name if document.path else ctx.words("new-program")


def _title(ctx: Context, document: Document) -> str:
    code = "program-kept" if document.is_saved else "program-changed"
    return ctx.words(code, name=_name_of(ctx, document), lines=max(1, len(document.lines)))


# --- saving


@handles("save")
async def save(ctx: Context, argument: str) -> None:
    """Save to the file with this name, or to the program's own file; ask for a name if there is neither."""
    await save_document(ctx, argument or str(ctx.program.path or ""))


@handles("save_as")
async def save_as(ctx: Context, argument: str) -> None:
    """Save to the file with this name, which becomes the program's own file."""
    await save_document(ctx, argument)


async def save_document(ctx: Context, name: str) -> bool:
    """Save the current program. Returns whether it was saved; if not, an answer gave the reason."""
    if not ctx.program.lines:
        ctx.answer("nothing-to-save")
        return False
    if not name and not ctx.interaction.is_attended:
        raise NotUnderstood
    try:
        return await _save(ctx, name)
    except GivenUp:
        ctx.answer("answer-unchanged")
    except DocumentError as error:
        ctx.answer(error.code, path=error.path, reason=error.reason)
    return False


async def _save(ctx: Context, name: str) -> bool:
    """Asks first if the file was changed by another program."""
    document, own = ctx.program, str(ctx.program.path or "")
    has_tree = ctx.screen is not None and not ctx.screen.is_plain
    question, proposed = ctx.words("ask-save-as" if has_tree else "ask-file-name"), own
    if has_tree and not own:
        proposed = _free_name(ctx)
    recent = ctx.workspace.recent.paths
    answer = name or await ctx.interaction.ask_file(question, proposed, recent, is_new=True)
    if not answer:
        raise GivenUp
    if isinstance(answer, Path) or answer == own:
        path = checked_path(Path(answer))
    else:
        path = program_to_save(answer, ctx.donnie.in_use)
    if str(path) in ctx.donnie.in_use:
        raise DocumentError("file-in-use", str(path))
    slow = ctx.words("slow-saving", name=path.name)
    asked = await ctx.interaction.background(
        lambda: save_question(path, document.path, document.saved_text), slow
    )
    if asked:
        await confirm_replacing(ctx, asked, path)
    return await ctx.interaction.finish(_write(ctx, document, path))


def _free_name(ctx: Context) -> str:
    """A free name to offer, which Enter or a click accepts."""
    names = (ctx.words("proposed-name", number=number) for number in range(1, 100))
    return next((each for each in names if not exists(program_to_save(each, ctx.donnie.in_use))), "")


async def _write(ctx: Context, document: Document, path: Path) -> bool:
    """Write the program; text that is typed during the write is not saved."""
    text, slow = document.text, ctx.words("slow-saving", name=path.name)
    try:
        await ctx.interaction.background(lambda: ctx.workspace.save(document, path, text), slow)
    except DocumentError as error:  # whatever the learner asked for meanwhile
        ctx.answer(error.code, path=error.path, reason=error.reason)
        return False
    ctx.workspace.keep_copies()
    ctx.answer("answer-saved", name=path.name, lines=text.count("\n"))
    return True


# --- before a text is lost


async def may_lose_text(ctx: Context) -> bool:
    """Offer to save the current program before it is replaced. Returns False, after an answer, to keep it."""
    document = ctx.program
    while True:
        await ctx.interaction.finished()  # what is being saved just now is not asked about
        if not (ctx.interaction.is_attended and document.is_worth_saving):
            return True
        question = ctx.words("ask-save", lines=len(document.lines))
        wants_to_save = await ctx.interaction.confirm(question)
        if wants_to_save is None:
            ctx.answer("answer-unchanged")
            return False
        if not wants_to_save:
            return True
        if not await save_document(ctx, str(document.path or "")):
            return False


async def may_lose_all(ctx: Context) -> bool:
    """As ``may_lose_text`` for every open program, the current one first, and for a built world."""
    from donnie_tui.commands.build import may_leave_built

    await ctx.interaction.finished()
    for document in ctx.workspace.current_first:
        if document.is_worth_saving:
            if document is not ctx.program:
                _turn_to(ctx, document)
            if not await may_lose_text(ctx):
                return False
    return await may_leave_built(ctx)


# --- pages


@handles("save_log")
async def save_log(ctx: Context, argument: str) -> None:
    """Write the log to a file as plain text."""
    if not argument and not ctx.interaction.is_attended:
        raise NotUnderstood
    if ctx.screen is None and not len(ctx.answers):
        ctx.answer("answer-nothing-said")
        return
    text = ctx.answers.text() if ctx.screen is None else ctx.screen.log_text
    name = argument or await ctx.interaction.ask(ctx.words("ask-save-log"), "log.txt")
    if not name:
        raise GivenUp
    await _write_page(ctx, reports.with_suffix(name, ".txt"), partial(text.encode, "utf-8", "replace"))


@handles("report")
async def report(ctx: Context, argument: str) -> None:
    """REPORT map map.html writes a page, .csv a table, .txt sentences. Without a file name, say the run."""
    from donnie_tui.i18n.help import sections
    from donnie_tui.world.run_picture import as_picture, on_swell_paper, plot_as_png

    if not argument:
        raise NotUnderstood
    words = ctx.words
    what, name = reports.asked(argument) or ("", "")
    name = reports.with_suffix(name, ".html")
    if name:
        page_to_save(name, ctx.workspace.files, ctx.donnie.in_use)  # a file in use is refused as such
    if sentence := reports.refusal(argument, words):
        raise Unusable(sentence)
    robot, timeline = ctx.donnie.session.hub.robot, ctx.donnie.chronicle.timeline()
    subject = reports.Subject(
        ctx.program.lines,
        ctx.donnie.session.pose,
        ctx.donnie.picture_now(),
        ctx.trail,
        words_in_lines(words),
        sections(words),
        [each for each in timeline.events if each.robot == robot],
        dict(ctx.runs.variables_during),
        partial(as_picture, _run_picture(ctx)),
        plot_as_png,
        partial(
            on_swell_paper,
            ctx.donnie.world,
            timeline.things,
            [each.pieces[-1] for each in ctx.trail.paths],
            words,
        ),
    )
    if not name:
        ctx.say(*ctx.counted(reports.in_sentences(what, subject, words)))
        return
    await _write_page(ctx, name, partial(reports.report, what, name, subject, words))


def _run_picture(ctx: Context) -> RunPicture:
    """Where the robots drove, what stands there now, and the places of goals."""
    from donnie_tui.world.run_picture import moved_things, run_picture

    donnie = ctx.donnie
    title = ctx.words("paper-title", name=donnie.world.title(ctx.words.language))
    goals = ctx.attempt.challenge.rules.goal_places if ctx.attempt is not None else ()
    moved = moved_things(donnie.chronicle.timeline().events, donnie.world.scene)
    return run_picture(title, donnie.drawings_now(), ctx.trail.paths, ctx.words, goals, moved)


async def _write_page(ctx: Context, name: str, content: Callable[[], bytes]) -> None:
    """Asks before it replaces a file. Raises ``DocumentError``."""
    path = page_to_save(name, ctx.workspace.files, ctx.donnie.in_use)
    if exists(path):
        await confirm_replacing(ctx, "ask-replace", path)
    await ctx.interaction.finish(_finish_page(ctx, path, content))


async def _finish_page(ctx: Context, path: Path, content: Callable[[], bytes]) -> None:
    slow = ctx.words("slow-report", name=path.name)
    try:
        await ctx.interaction.background(lambda: write_bytes(path, content()), slow)
    except DocumentError as error:  # whatever the learner asked for meanwhile
        ctx.answer(error.code, path=error.path, reason=error.reason)
    else:
        ctx.answer("answer-written", name=path.name)
