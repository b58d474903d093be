"""Runs commands: finds the handler, and answers if a command is not possible now.

Handlers are loaded when they are first used. A handler is ``async def NAME(ctx, argument)``, marked with
``@handles("NAME")`` in the module that its declaration names.
"""

from __future__ import annotations

from collections.abc import Awaitable, Callable
from functools import partial, update_wrapper
from importlib import import_module
from typing import TYPE_CHECKING, TypeAlias, TypeVar

from donnie_tui.commands.context import UNUSABLE, Context
from donnie_tui.commands.declarations import BY_NAME, Command, When
from donnie_tui.commands.interaction import GivenUp, NotUnderstood
from donnie_tui.commands.lookup import not_understood, typed_form, unknown_word, word_of
from donnie_tui.core.run_state import NothingRuns, NothingToRun, RunState
from donnie_tui.core.session import Busy, Taken
from donnie_tui.i18n.words import Unusable

if TYPE_CHECKING:
    from pathlib import Path

    from donnie_tui.core.program_files import DocumentError

Handler: TypeAlias = "Callable[[Context, str], Awaitable[None]]"
AnyHandler = TypeVar("AnyHandler", bound=Callable[..., Awaitable[None]])

_NEEDED = {RunState.READY: When.IDLE, RunState.PAUSED: When.HELD}
"""The least availability that a command needs in each run state; ALWAYS in the others."""

HANDLERS: dict[str, Handler] = {}
"""Handlers by the names of their commands; only of modules that are loaded."""


def handles(name: str, /, **given: object) -> Callable[[AnyHandler], AnyHandler]:
    """Register the handler of a command; a function may handle several commands.

    ``given`` are extra arguments of the handler. Raises ``KeyError`` for a name that is not declared.
    """
    module = BY_NAME[name].module

    def mark(handler: AnyHandler) -> AnyHandler:
        if name in HANDLERS or handler.__module__ != f"donnie_tui.commands.{module}":
            raise ValueError(f"{name} has another handler, or is declared for the module {module}")
        HANDLERS[name] = update_wrapper(partial(handler, **given), handler) if given else handler
        return handler

    return mark


def handler_of(command: Command) -> Handler:
    if command.name not in HANDLERS:
        import_module(f"donnie_tui.commands.{command.module}")
    return HANDLERS[command.name]


async def perform(ctx: Context, command: Command, argument: str | None) -> None:
    """Run a command. ``argument`` is None if a key or the palette asked for it.

    The key of PAUSE is that of CONTINUE too; the word PAUSE never lets the robot move.
    """
    if argument is None and command.name == "pause" and ctx.runs.state is RunState.PAUSED:
        command = BY_NAME["continue_"]
    if ctx.screen is None and command.is_visual:
        say_in_words(ctx, command.in_words)
        return
    if not is_possible(ctx, command):
        refuse_busy(ctx, Busy())
        return
    if command.is_about_now:
        ctx.say(*ctx.runs.to_present())
    try:
        await attempt(ctx, _run(ctx, command, argument))
    except NotUnderstood as slip:
        ctx.refuse()
        ctx.say(not_understood(command, ctx.words, slip.meant))


async def _run(ctx: Context, command: Command, argument: str | None) -> None:
    if argument is None:
        cursor = str(ctx.program.place) if command.at_cursor else ""
        argument = await _asked_for(ctx, command) if command.asked_by_key else cursor
    if argument and not command.argument:
        raise NotUnderstood
    await handler_of(command)(ctx, argument)


async def attempt(ctx: Context, task: Awaitable[None]) -> None:
    """Run a handler, and answer if the learner cancels, a run is not possible now, or something fails."""
    try:
        await task
    except GivenUp:
        ctx.answer("answer-unchanged")
    except NothingRuns:
        ctx.answer("answer-nothing-runs")
    except NothingToRun:
        ctx.answer("answer-nothing-to-run")
    except Busy as busy:
        refuse_busy(ctx, busy)
    except Unusable as unusable:
        ctx.refuse(UNUSABLE)
        ctx.say(*unusable.sentences)
    except _document_error() as error:
        ctx.refuse(UNUSABLE)
        ctx.answer(error.code, path=error.path, reason=error.reason)


def refuse_busy(ctx: Context, busy: Busy) -> None:
    """Answer that a program runs, which STOP stops, or that a client drives a robot."""
    ctx.refuse()
    if isinstance(busy, Taken):
        ctx.answer("robot-taken")
    else:
        ctx.answer_of_robot("screen-busy")


async def confirm_replacing(ctx: Context, code: str, path: Path) -> None:
    """Raises ``GivenUp`` unless the learner agrees, ``DocumentError`` if no learner can be asked."""
    if not ctx.interaction.is_attended:
        raise _document_error()("file-exists", str(path))
    if not await ctx.interaction.confirm(ctx.words(code, name=path.name)):
        raise GivenUp


def _document_error() -> type[DocumentError]:
    """Imported only after an error."""
    from donnie_tui.core.program_files import DocumentError

    return DocumentError


def is_possible(ctx: Context, command: Command) -> bool:
    """Whether the command is possible in this run state."""
    return command.when.value >= _NEEDED.get(ctx.runs.state, When.ALWAYS).value


async def _asked_for(ctx: Context, command: Command) -> str:
    """Ask the learner for the argument, which a key can't give."""
    example = ctx.words(f"help-typed-{command.argument}")
    word = word_of(command, ctx.words.language)
    argument = await ctx.interaction.ask(ctx.words("ask-argument", word=word, example=example))
    if argument is None:
        raise GivenUp
    return argument


def say_in_words(ctx: Context, name: str) -> None:
    """Name the command that says the same in words; without one, answer that it needs the screen."""
    command = BY_NAME.get(name)
    if command is None:
        ctx.answer("only-on-screen")
    else:
        ctx.answer("type-command", word=typed_form(command, ctx.words))


def says_slip(ctx: Context, line: str) -> bool:
    """Answer a misspelt command with the right word. Returns whether the line begins with one."""
    unknown = unknown_word(line, ctx.program.lines, ctx.words.language, ctx.donnie.session.parse)
    if unknown is not None:
        ctx.refuse()
        ctx.answer("help-unknown-near", topic=unknown.word, near=unknown.meant)
    return unknown is not None
