"""CHALLENGE, TASK, GOALS, HINT, NEXT CHALLENGE, QUESTIONS, RESULTS: what a learner does with challenges."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

from msgspec.structs import asdict

from donnie_tui.bootstrap import progress
from donnie_tui.commands.context import Context
from donnie_tui.commands.dispatch import handles
from donnie_tui.commands.interaction import Option
from donnie_tui.commands.lookup import find
from donnie_tui.core.describe import goals_in_words, task_in_words
from donnie_tui.core.wording import Wording
from donnie_tui.i18n.words import Unusable
from donnie_tui.world.loading import CHALLENGE
from worlds import challenges

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from donnie_tui.commands.context import Attempt
    from donnie_tui.core.program_files import Attempted
    from worlds.challenges import Challenge, Unsensed


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
        await enter_challenge(ctx, argument)


async def enter_challenge(ctx: Context, typed: str) -> None:
    """Enter the challenge with that number, name or file."""
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
        await enter_challenge(ctx, following)


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
