"""QUIET, CUES, FEEL: sound and belt. A cue is always said in words too."""

from __future__ import annotations

from devices.ports.audio import CUES
from donnie_tui.bootstrap import Donnie
from donnie_tui.commands.context import Context
from donnie_tui.commands.dispatch import handles
from donnie_tui.commands.interaction import NotUnderstood, switched
from donnie_tui.core.events import Answered, Chimed
from donnie_tui.core.wording import meant, spelled
from donnie_tui.settings.parsing import read_percent
from language.source import quoted

LOUD, SILENT = 100, 0
BETWEEN = 0.7
"""Seconds from the end of a cue and of its name to the next one."""
FOR_READERS = 2.0
"""Seconds for its name where a screen reader says it."""
_CHECK_INTERVAL = 0.05
_LONGEST_UTTERANCE = 100
"""Number of checks."""


@handles("quiet")
async def quiet(ctx: Context, _: str) -> None:
    """Stop the speech. The answer is only printed, and LAST repeats the answer before it."""
    ctx.donnie.outlets.audible.hush_all()
    answer = Answered(ctx.words("quiet"), in_print_only=True, at_once=ctx.is_urgent, is_repeated=True)
    ctx.donnie.session.hub.publish(answer)


@handles("cues")
async def cues(ctx: Context, argument: str) -> None:
    """Play each cue, or one by its name, and say its name and meaning. A key ends it."""
    audible, name = ctx.donnie.outlets.audible, cue_meant(argument)
    if argument and name is None:
        ctx.refuse()
        ctx.answer("cues-unknown", name=quoted(argument))
        return
    hushed = audible.hushed
    if not audible.has_cues:
        ctx.answer(audible.why_no_cues)
    elif name is None:
        ctx.answer("cues-count", count=len(CUES))
        if await _is_disturbed_until_spoken(ctx, hushed):
            return
    for each in CUES if name is None else (name,):
        if await _is_disturbed_by_cue(ctx, each, hushed):
            return


async def _is_disturbed_by_cue(ctx: Context, cue: str, hushed: int) -> bool:
    """Play the cue, then say it. Returns whether the learner interrupted."""
    has_cues = ctx.donnie.outlets.audible.has_cues
    if has_cues:
        chime(ctx.donnie, cue)
    ctx.answer("cues-line", name=cue_word(cue, ctx.words.language), meaning=ctx.words(f"cue-{cue}"))
    return has_cues and await _is_disturbed_until_spoken(ctx, hushed)


async def _is_disturbed_until_spoken(ctx: Context, hushed: int) -> bool:
    """Wait until the speech has ended. Returns whether the learner interrupted; ``hushed``: hushes before."""
    audible = ctx.donnie.outlets.audible

    async def is_disturbed(seconds: float) -> bool:
        return await ctx.interaction.wait(seconds) or audible.hushed != hushed

    if not audible.speaks:
        return await is_disturbed(FOR_READERS)
    for _ in range(_LONGEST_UTTERANCE):
        if await is_disturbed(_CHECK_INTERVAL):
            return True
        if audible.is_quiet_within(0):
            break
    return await is_disturbed(BETWEEN)


@handles("feel")
async def feel(ctx: Context, argument: str) -> None:
    """Say what the belt shows, with ROWS each motor; ON reports every change from now on, OFF none."""
    belt, is_on = ctx.donnie.outlets.belt, switched(argument)
    if is_on is not None:
        belt.is_on = is_on
        ctx.answer("belt-words-on" if is_on else "belt-words-off")
    elif meant(argument, "belt") == "rows":
        ctx.say(*belt.rows())
    elif argument:
        raise NotUnderstood
    else:
        ctx.say(belt.now())


# --- for other commands and the front ends


def cue_meant(typed: str) -> str | None:
    """The cue that ``typed`` names in any language."""
    return typed if typed in CUES else meant(typed, "cues")


def cue_word(cue: str, language: str) -> str:
    """The name of a cue."""
    return spelled(cue, language, "cues")


def chime(donnie: Donnie, cue: str) -> None:
    """Play a cue at its volume."""
    donnie.session.hub.publish(Chimed(cue))


def chime_block(donnie: Donnie, before: int, after: int) -> None:
    """Play the cue of an opened or closed block; the deeper the block, the higher the tone."""
    if before == after or not donnie.outlets.audible.has_cues:
        return
    from devices.audio.cues import pitch_of_level

    cue = "block-opened" if after > before else "block-closed"
    donnie.session.hub.publish(Chimed(cue, steps=pitch_of_level(max(before, after))))


def cue_volume_typed(typed: str) -> int | None:
    """A typed volume in percent: a number, or on and off in any language; None for anything else."""
    is_on = switched(typed)
    if is_on is not None:
        return LOUD if is_on else SILENT
    try:
        return read_percent(typed)
    except (ValueError, OverflowError):
        return None
