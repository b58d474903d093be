"""HELP, MANUAL, TOUR, KEYS, LINEAR, VISUAL, QUIT: help, changing the mode, leaving."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

from donnie_tui.commands.challenges import enter_challenge
from donnie_tui.commands.context import Context
from donnie_tui.commands.declarations import BY_NAME, COMMANDS
from donnie_tui.commands.dispatch import handles
from donnie_tui.commands.interaction import count_in
from donnie_tui.commands.lookup import find, help_line, help_of
from donnie_tui.core.runner import LAST_WORDS
from donnie_tui.core.wording import Wording, meant
from donnie_tui.i18n.help import CHAPTERS, TOUR_PAGES, chapter_lines, said_for, tour_page
from language.locales import first_page

if TYPE_CHECKING:
    from collections.abc import Iterable


_KEY_LINES = ("enter", "run", "stop", "past", "line", "word", "clear", "tab", "leave")
FIRST_LESSON = ("FW", "BW", "TR", "TL", "SPEAK", "SCAN", "RUN")
_FIRST_COMMANDS = ("where", "around", "tour")
TOPICS = {
    "moving": (
        ("FW", "BW", "TR", "TL", "GRIP", "RELEASE", "WAIT"),
        ("slower", "faster", "speed", "stop", "reset"),
    ),
    "looking": (
        ("SCAN", "DISTANCE", "COLOR", "POS", "STATE", "HISTORY"),
        ("where", "around", "map", "trail", "show_path", "sensors", "world"),
    ),
    "editing": (
        (),
        ("list", "read", "change", "insert", "delete", "undo", "fix", "search", "new", "save", "open"),
    ),
    "sound": (
        ("SPEAK", "SOUND", "BELT", "VIBRATE"),
        ("quiet", "last", "spell", "cues", "detail", "feel"),
    ),
}
"""Words of GoDonnie and commands, grouped by purpose."""

# --- help


@handles("help")
async def say_help(ctx: Context, argument: str) -> None:
    """Answer HELP: the first words, a topic, all words, or the help of a word, a setting or the keys."""
    topic = " ".join(argument.split())
    asked, listed = find(topic), meant(topic, "help")
    if ctx.screen is not None and (not topic or listed == "all"):
        ctx.screen.show_help(is_everything=bool(topic))
    elif not topic:
        ctx.say(*first_words(ctx.words))
    elif listed == "all":
        _list_commands(ctx)
    elif listed == "keys" and ctx.screen is not None:
        ctx.screen.show_keys()
    elif listed == "keys":
        for line in _KEY_LINES:
            ctx.answer(f"prompt-keys-{line}")
    elif listed is not None:
        ctx.say(*_topic_lines(listed, topic, ctx.words))
    elif asked is None or asked[0].name != "set" or not _says_setting(ctx, asked[1].partition(" ")[0]):
        ctx.say(*(_command_lines(topic, ctx.words) or ctx.words.help(topic)))


def _says_setting(ctx: Context, name: str) -> bool:
    """Say a setting and its values. Returns whether there is a setting of that name."""
    from donnie_tui.commands.preferences import find_preference
    from donnie_tui.commands.settings import say_with_values

    preference = find_preference(name, ctx.words) if name else None
    if preference is not None:
        say_with_values(ctx, preference)
    return preference is not None


def first_words(words: Wording) -> tuple[str, ...]:
    """The words that the first lesson needs, and how to ask for more."""
    lines = _lines_of(FIRST_LESSON, _FIRST_COMMANDS, words)
    return (words("help-first", count=len(lines)), *lines, words("help-topics"), words("help-all-hint"))


def _lines_of(godonnie: Iterable[str], commands: Iterable[str], words: Wording) -> list[str]:
    lines = [words.help(each)[0] for each in godonnie]
    return [*lines, *(help_line(BY_NAME[each], words) for each in commands)]


def _topic_lines(topic: str, typed: str, words: Wording) -> tuple[str, ...]:
    """The words of a topic, after the help of the topic's own word if it is also a command."""
    about = help_of(typed, words) or (words.help(typed) if said_for(typed, words) else ())
    lines = [each for each in _lines_of(*TOPICS[topic], words) if each not in about]
    return (*about, words(f"topic-{topic}", count=len(lines)), *lines)


def _command_lines(typed: str, words: Wording) -> tuple[str, ...]:
    """The help of a command, then the GoDonnie word that a beginner may mean, as for MOVE and BACK."""
    lines, meant_word = help_of(typed, words), said_for(typed, words)
    return (*lines, words.help(meant_word)[0]) if lines and meant_word else lines


def _list_commands(ctx: Context) -> None:
    """List GoDonnie's words, then the commands."""
    commands = [each for each in COMMANDS if not (each.is_visual or each.is_godonnie)]
    ctx.say(*ctx.words.help(None))
    ctx.answer("help-commands", count=len(commands))
    ctx.say(*(help_line(each, ctx.words) for each in commands))
    ctx.answer("help-keys-hint")


@handles("keys_here")
async def keys_here(ctx: Context, _: str) -> None:
    """List the keys that work in the focused pane."""
    if ctx.screen is not None:
        ctx.screen.show_keys()


@handles("manual")
async def manual(ctx: Context, argument: str) -> None:
    """List the chapters of the manual, show one by its number, or say what it says of a word."""
    number = count_in(argument, 0)
    if number and number <= len(CHAPTERS):
        chapter = CHAPTERS[number - 1]
        lines = chapter_lines(ctx.words, chapter)
        await ctx.interaction.show_pages(ctx.words(f"manual-{chapter}"), lines)
    elif argument.isdecimal():
        ctx.refuse()
        ctx.answer("manual-chapters", count=len(CHAPTERS))
    elif argument:
        await ctx.interaction.show_pages(argument, ctx.words.help(argument))
    elif ctx.screen is not None:
        ctx.screen.show_manual()
    else:
        ctx.answer("manual-chapters", count=len(CHAPTERS))
        for at, chapter in enumerate(CHAPTERS, 1):
            ctx.answer("numbered-line", line=at, text=ctx.words(f"manual-{chapter}"))
        page = first_page(ctx.words.language)
        if page and ctx.words.detail != "brief":  # a path is too wide for a braille display
            ctx.answer("first-page", file=page)


@handles("tour")
async def tour(ctx: Context, _: str) -> None:
    """Show the tour, beginning with the page on which the learner left it."""
    if ctx.screen is not None:
        ctx.screen.show_tour()
        return
    if ctx.donnie.team.has_several:
        ctx.answer("robot-chosen", name=ctx.donnie.session.name)
    await _say_page(ctx, ctx.tour_page)


async def _say_page(ctx: Context, number: int) -> None:
    """Say a page of the tour. Enter or TOUR continues; after the last page a challenge begins."""
    ctx.say(*tour_page(number, ctx.words))
    ctx.tour_page = number if number < TOUR_PAGES else 1
    if number < TOUR_PAGES:
        ctx.answer("tour-on", page=number, pages=TOUR_PAGES)
        ctx.interaction.continue_on_enter(partial(_say_page, ctx, number + 1))
    else:
        ctx.interaction.continue_on_enter(partial(enter_challenge, ctx, "1"))


# --- ways out


@handles("linear")
async def linear(ctx: Context, _: str) -> None:
    """Continue in the linear mode; the robot stays where it is."""
    if ctx.screen is None:
        ctx.answer("already-linear")
    elif ctx.screen.is_page:
        ctx.answer("page-no-linear")
    else:
        await _switch_mode(ctx)


@handles("visual")
async def visual(ctx: Context, _: str) -> None:
    """Continue in the full screen; the robot stays where it is."""
    if ctx.screen is not None:
        ctx.answer("screen-is-visual")
    else:
        await _switch_mode(ctx)


async def _switch_mode(ctx: Context) -> None:
    """Stop the programs, then change the mode."""
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
