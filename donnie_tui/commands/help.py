"""HELP, MANUAL, TOUR, KEYS, LINEAR, VISUAL, QUIT: help, and the ways out."""

from __future__ import annotations

from functools import partial

from donnie_tui.commands.context import Context
from donnie_tui.commands.declarations import COMMANDS
from donnie_tui.commands.dispatch import handles
from donnie_tui.commands.lookup import find, help_line, help_of
from donnie_tui.core.runner import LAST_WORDS
from donnie_tui.core.wording import meant
from donnie_tui.i18n.help import CHAPTERS, TOUR_PAGES, chapter_lines, tour_page

_KEY_LINES = ("enter", "run", "stop", "past", "line", "word", "clear", "tab", "leave")
_MOST_DIGITS = 2

# --- help


@handles("help")
async def say_help(ctx: Context, argument: str) -> None:
    """All commands; or what is said of a command, of a word of GoDonnie, of a setting, or of the keys."""
    topic = " ".join(argument.split())
    asked = find(topic)
    if not topic and ctx.screen is not None:
        ctx.screen.show_help()
    elif not topic:
        _list_commands(ctx)
    elif meant(topic, "help") == "keys" and ctx.screen is not None:
        ctx.screen.show_keys()
    elif meant(topic, "help") == "keys":
        for line in _KEY_LINES:
            ctx.answer(f"prompt-keys-{line}")
    elif asked is None or asked[0].name != "set" or not _says_setting(ctx, asked[1].partition(" ")[0]):
        ctx.say(*(help_of(topic, ctx.words) or ctx.words.help(topic)))


def _says_setting(ctx: Context, name: str) -> bool:
    """A setting and what it can be; whether there is one of that name."""
    from donnie_tui.commands.preferences import find_preference
    from donnie_tui.commands.settings import say_with_values

    preference = find_preference(name, ctx.words) if name else None
    if preference is not None:
        say_with_values(ctx, preference)
    return preference is not None


def _list_commands(ctx: Context) -> None:
    """GoDonnie's words, then the commands."""
    commands = [each for each in COMMANDS if not (each.is_visual or each.is_godonnie)]
    ctx.say(*ctx.words.help(None))
    ctx.answer("help-commands", count=len(commands))
    ctx.say(*(help_line(each, ctx.words) for each in commands))
    ctx.answer("help-keys-hint")


@handles("keys_here")
async def keys_here(ctx: Context, _: str) -> None:
    """What can be pressed where the focus is."""
    if ctx.screen is not None:
        ctx.screen.show_keys()


@handles("manual")
async def manual(ctx: Context, argument: str) -> None:
    """The chapters of the manual, one of them by its number, or what is said of a word."""
    number = int(argument) if argument.isdecimal() and len(argument) <= _MOST_DIGITS else 0
    if 1 <= number <= len(CHAPTERS):
        chapter = CHAPTERS[number - 1]
        lines = chapter_lines(ctx.words, chapter)
        await ctx.interaction.show_pages(ctx.words(f"manual-{chapter}"), lines)
    elif argument:
        await ctx.interaction.show_pages(argument, ctx.words.help(argument))
    elif ctx.screen is not None:
        ctx.screen.show_manual()
    else:
        ctx.answer("manual-chapters", count=len(CHAPTERS))
        for at, chapter in enumerate(CHAPTERS, 1):
            ctx.answer("numbered-line", line=at, text=ctx.words(f"manual-{chapter}"))


@handles("tour")
async def tour(ctx: Context, _: str) -> None:
    """Donnie in five minutes, from the page that was left to try something."""
    if ctx.screen is not None:
        ctx.screen.show_tour()
        return
    if ctx.donnie.team.has_several:
        ctx.answer("robot-chosen", name=ctx.donnie.session.name)
    await _say_page(ctx, ctx.tour_page)


async def _say_page(ctx: Context, number: int) -> None:
    """One page. An empty line continues; after any other line TOUR does."""
    ctx.say(*tour_page(number, ctx.words))
    ctx.tour_page = number if number < TOUR_PAGES else 1
    if number < TOUR_PAGES:
        ctx.answer("tour-on", page=number, pages=TOUR_PAGES)
        ctx.interaction.continue_on_enter(partial(_say_page, ctx, number + 1))


# --- ways out


@handles("linear")
async def linear(ctx: Context, _: str) -> None:
    """Go on in the linear mode, the robot where it is."""
    if ctx.screen is None:
        ctx.answer("already-linear")
    elif ctx.screen.is_page:
        ctx.answer("page-no-linear")
    else:
        await _switch_mode(ctx)


@handles("visual")
async def visual(ctx: Context, _: str) -> None:
    """Go on in the full screen, the robot where it is."""
    if ctx.screen is not None:
        ctx.answer("screen-is-visual")
    else:
        await _switch_mode(ctx)


async def _switch_mode(ctx: Context) -> None:
    """What runs is stopped first."""
    team = ctx.donnie.team
    runs = [session.run for session in team.running if session.run is not None]
    team.stop()
    for each in runs:
        each.wait(LAST_WORDS)
    await ctx.interaction.switch_mode()


@handles("quit")
async def leave(ctx: Context, _: str) -> None:
    """Leave Donnie."""
    await ctx.interaction.quit()
