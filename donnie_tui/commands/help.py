"""HELP, MANUAL, TOUR, CHALLENGE, KEYS, LINEAR, VISUAL, QUIT: help, challenges, changing the mode, leaving."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

from msgspec.structs import asdict

from donnie_tui.bootstrap import progress
from donnie_tui.commands.context import Context
from donnie_tui.commands.declarations import BY_NAME, COMMANDS
from donnie_tui.commands.dispatch import handles
from donnie_tui.commands.interaction import Option, count_in
from donnie_tui.commands.lookup import find, help_line, help_of
from donnie_tui.core.describe import goals_in_words, task_in_words
from donnie_tui.core.runner import LAST_WORDS
from donnie_tui.core.wording import Wording, meant
from donnie_tui.i18n.help import CHAPTERS, TOUR_PAGES, chapter_lines, said_for, tour_page
from donnie_tui.i18n.words import Unusable
from donnie_tui.world.loading import CHALLENGE
from language.locales import first_page
from worlds import challenges

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Sequence

    from donnie_tui.commands.context import Attempt
    from donnie_tui.core.program_files import Attempted
    from worlds.challenges import Challenge, Unsensed

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
        ctx.interaction.continue_on_enter(partial(_enter_challenge, ctx, "1"))


# --- challenges


def _attempt(ctx: Context) -> Attempt:
    """What was done for the challenge. Raises ``Unusable`` where the world has none."""
    if ctx.attempt is None:
        raise Unusable(ctx.words("challenge-none"))
    return ctx.attempt


@handles("challenge")
async def challenge(ctx: Context, argument: str) -> None:
    """Offer the challenges in their order, or enter one by its number, name or file."""
    if not argument:
        options = _challenge_options(ctx)
        printed = tuple(each.text for each in options)
        argument = await ctx.interaction.choose(ctx.words("ask-challenge"), options, printed) or ""
    if argument:
        await _enter_challenge(ctx, argument)


async def _enter_challenge(ctx: Context, typed: str) -> None:
    from donnie_tui.commands.world import enter_world  # most that load this enter no world

    await enter_world(ctx, f"{CHALLENGE}{typed}")


def _challenge_options(ctx: Context) -> list[Option]:
    solved, current, options = progress().solved, ctx.donnie.world.challenge, list[Option]()
    for number, found in enumerate(map(challenges.find, challenges.names()), start=1):
        code = "challenge-row-solved" if found.name in solved else "challenge-row"
        text = ctx.words(code, number=number, title=found.text(ctx.words.language).title)
        is_current = current is not None and current.name == found.name
        options.append(Option(found.name, text, is_current, detail=partial(_task, found, ctx.words)))
    return options


def _task(found: Challenge, words: Wording, *_room: int) -> tuple[str, ...]:
    return task_in_words(found, words)


@handles("next_challenge")
async def next_challenge(ctx: Context, _: str) -> None:
    """Enter the challenge after this one, or the first unsolved one."""
    current, solved = ctx.donnie.world.challenge, progress().solved
    unsolved = (each for each in challenges.names() if each not in solved)
    following = next(unsolved, None) if current is None else challenges.after(current.name)
    if following is None:
        ctx.answer("challenge-last")
    else:
        await _enter_challenge(ctx, following)


@handles("task")
async def task(ctx: Context, _: str) -> None:
    """Say the task of the challenge, else the one that the world's author proposes."""
    about = ctx.donnie.world.about(ctx.words.language)
    if ctx.attempt is None and about is not None and about.task:
        ctx.answer("world-task", task=about.task)
    else:
        ctx.say(*task_in_words(_attempt(ctx).challenge, ctx.words))


@handles("goals")
async def goals(ctx: Context, _: str) -> None:
    """Say which goals are met now, and what the others lack."""
    ctx.say(*goals_in_words(_attempt(ctx).judgment(), ctx.words))


@handles("hint")
async def hint(ctx: Context, _: str) -> None:
    """Say the next hint."""
    attempt = _attempt(ctx)
    hints = attempt.challenge.text(ctx.words.language).hint
    is_left = attempt.hints < len(hints)
    ctx.say(hints[attempt.hints].text if is_left else ctx.words("challenge-no-hint"))
    attempt.hints += is_left


@handles("questions")
async def questions(ctx: Context, _: str) -> None:
    """Ask the questions of the challenge about its world. An empty answer leaves them, and so does a command,
    which is carried out."""
    attempt = _attempt(ctx)
    if attempt.unsensed:
        await _ask_about_goals(ctx, attempt)
        if attempt.unsensed or not attempt.has_questions:
            return
    asked, right = attempt.questions(), 0
    if not asked:
        ctx.answer("questions-none")
        return
    attempt.has_questions = False
    command = ""
    try:
        for each in asked:
            typed = await ctx.interaction.ask(each.text(ctx.words))
            if typed is None:
                break
            is_right = each.is_right(typed)
            if not is_right and find(typed) is not None:
                command = typed
                break
            right += is_right
            ctx.answer("question-right" if is_right else "question-wrong", text=each.right_answer(ctx.words))
        else:
            attempt.is_answered = True
        ctx.answer("questions-done", right=right, questions=len(asked))
    finally:
        attempt.keep_try(len(asked), right)
    if command:
        await ctx.interaction.type_again(command)


async def _ask_about_goals(ctx: Context, attempt: Attempt) -> None:
    """Ask about the goals and rules that a real robot can't sense, then say the verdict."""
    from donnie_tui.core.questions import unsensed_question

    answers: dict[Unsensed, bool] = {}
    for each in attempt.unsensed:
        answer = await ctx.interaction.confirm(unsensed_question(each, attempt.room, ctx.words))
        if answer is None:
            break
        answers[each] = answer
    ctx.say(*attempt.judge_answered(answers))


@handles("results")
async def results(ctx: Context, _: str) -> None:
    """List the challenges that the learner tried and solved. Compares no learners."""
    kept: dict[str, list[Attempted]] = {}
    waiting = ctx.attempt.tried if ctx.attempt is not None else None
    for each in (*progress().attempts(), *filter(None, (waiting,))):
        kept.setdefault(each.name, []).append(each)
    if not kept:
        ctx.answer("results-none")
        return
    solved = sum(any(each.solved for each in tries) for tries in kept.values())
    ctx.answer("results-total", solved=solved, tried=len(kept))
    hints = {ctx.attempt.challenge.name: ctx.attempt.hints} if ctx.attempt is not None else {}
    for name, tries in kept.items():
        ctx.say(*_tries_in_words(name, tries, hints.get(name, 0), ctx.words))


def _tries_in_words(name: str, tries: Sequence[Attempted], hints: int, words: Wording) -> Iterator[str]:
    """One challenge in the results. ``hints``: those that were given in this session."""
    best = min((each for each in tries if each.solved), key=lambda each: each.steps, default=None)
    asked = max((each for each in tries if each.questions), key=lambda each: each.right, default=None)
    one = best or tries[-1]
    title = challenges.find(name).text(words.language).title if name in challenges.names() else name
    hints, bumps = max(hints, *(each.hints for each in tries)), sum(each.bumps for each in tries)
    code = "results-open" if best is None else "results-solved"
    yield words(code, title=title, tries=len(tries), hints=hints, bumps=bumps)
    if one.seconds:
        yield words("results-way" if one.shortest else "results-time", **asdict(one))
    if asked is not None:
        yield words("questions-done", right=asked.right, questions=asked.questions)


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
