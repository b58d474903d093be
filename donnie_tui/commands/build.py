"""PUT, MOVE, TURN, REMOVE, SAVE WORLD: build the world by words while no program runs.

Each answer says where the thing is afterwards, or why nothing changed.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from donnie_tui.commands.context import Context
from donnie_tui.commands.declarations import BY_NAME
from donnie_tui.commands.dispatch import attempt, confirm_replacing, handler_of, handles
from donnie_tui.commands.interaction import GivenUp, NotUnderstood, numbers_in
from donnie_tui.core.transcript import with_robot_name
from donnie_tui.i18n.words import Unusable
from donnie_tui.world import things
from language import keywords

if TYPE_CHECKING:
    from donnie_tui.world.things import Building
    from sim.picture import Thing


@handles("put")
async def put(ctx: Context, argument: str) -> None:
    """PUT box red 4 6 AS treasure adds a thing. PUT treasure 4 6 moves an existing thing to that place.

    PUT wall -5 8 5 8 adds a wall between two squares.
    """
    what, place = _with_numbers(argument, 4, 2)
    building = _building(ctx)
    described, mistakes = things.description_of(what, ctx.words)
    is_wall, is_square = described.kind == things.WALL, len(place) == 2
    if mistakes and is_square and building.named(what):
        thing, (x, y) = building.find(what), place
        _say_place(ctx, *building.move(thing, x - thing.x, y - thing.y))
        return
    has_more_numbers = bool(mistakes and things.with_numbers(what, 1)[1]) or not (is_square or is_wall)
    if has_more_numbers or len(described.colours) > 1:
        raise NotUnderstood
    if mistakes:
        raise Unusable(*mistakes.values())
    code, thing = building.put(described, place)
    (x, to_x), (y, to_y) = (sorted((each[0], each[-1])) for each in (place[::2], place[1::2]))
    _say_place(ctx, "built-wall" if is_wall else code, thing, x=x, y=y, to_x=to_x, to_y=to_y)


async def move_thing(ctx: Context, argument: str) -> None:
    """MOVE treasure 2 0: move a thing two steps to the east."""
    what, (east, north) = _with_numbers(argument, 2, form="thing-and-steps")
    building = _building(ctx)
    _say_place(ctx, *building.move(building.find(what), east, north))


@handles("turn")
async def turn(ctx: Context, argument: str) -> None:
    """TURN treasure 90: turn a thing to the right in its place."""
    if not argument:
        ctx.answer("built-turn-robot", example=f"{keywords.spelling('TR', ctx.words.language)} 90")
    what, (degrees,) = _with_numbers(argument, 1)
    building = _building(ctx)
    _, turned = building.move(building.find(what), degrees=degrees)
    _say_place(ctx, "built-turned", turned, degrees=degrees)


@handles("remove")
async def remove(ctx: Context, argument: str) -> None:
    """REMOVE treasure: remove a thing. Alone or with line numbers, it acts as DELETE."""
    if not argument or numbers_in(argument, most=2) is not None:
        await handler_of(BY_NAME["delete"])(ctx, argument)
        return
    building = _building(ctx)
    _say_place(ctx, *building.remove(building.find(argument)))


def _with_numbers(argument: str, *counts: int, form: str = "") -> tuple[str, tuple[int, ...]]:
    """As ``things.with_numbers``. Raises ``NotUnderstood`` if the thing or the numbers are missing."""
    what, numbers = things.with_numbers(argument, *counts)
    if not what or not numbers:
        raise NotUnderstood(form)
    return what, numbers


def _say_place(ctx: Context, code: str, thing: Thing, **values: object) -> None:
    """Answer where the thing is now, and update what is shown of the world."""
    from donnie_tui.core.describe import place_of

    place = place_of(thing.x, thing.y, ctx.donnie.session.pose, ctx.words)
    sides = {"width": round(thing.width), "depth": round(thing.depth)}
    found = {"x": round(thing.x), "y": round(thing.y), "place": place, **sides, **values}
    ctx.answer(code, thing=things.thing_in_words(thing, ctx.words), **found)
    ctx.donnie.session.publish_things()
    if ctx.screen is not None:
        ctx.screen.robot_changed()


def _building(ctx: Context) -> Building:
    """Return the world for a change. Raises ``Unusable`` if it can't be changed."""
    donnie, words, world = ctx.donnie, ctx.words, ctx.donnie.world
    recording = donnie.outlets.written.of_this_session
    if donnie.team.running:
        raise Unusable(with_robot_name(donnie.session.hub.robot, words("screen-busy"), words))
    reasons = {
        "built-real": donnie.connection.is_real or donnie.connection.is_board,
        "built-challenge": world.challenge,
        "built-configuration": world.offers or world.stands_in_for,
        "built-recorded": recording,
        "built-holding": donnie.holds_something,
    }
    for code in (code for code, holds in reasons.items() if holds):
        raise Unusable(words(code, path=recording))
    return donnie.building(ctx.program.text)


def step_building(ctx: Context, *, is_undo: bool) -> bool:
    """Undo or redo the last change of the world, unless the learner has opened another program since.

    Returns whether it was tried.
    """
    site = ctx.donnie.site
    changes, opposite = (site.past, site.undone) if is_undo else (site.undone, site.past)
    if not changes or changes[-1].program != ctx.program.text:
        return False
    _say_place(ctx, *_building(ctx).step(changes, opposite))
    return True


# --- saving


@handles("save_world")
async def save_world(ctx: Context, argument: str) -> None:
    """Write the built world to a file; asks before it replaces another file."""
    from donnie_tui.core.program_files import exists, file_to_save

    donnie, own = ctx.donnie, ctx.donnie.site.path
    name = argument or str(own or "")
    if not name and not ctx.interaction.is_attended:
        raise NotUnderstood
    name = name or await ctx.interaction.ask(ctx.words("ask-world-name")) or ""
    if not name:
        raise GivenUp
    path = file_to_save(name, donnie.in_use, ".world", own)
    if path != own and exists(path):
        await confirm_replacing(ctx, "ask-replace", path)
    donnie.building().save(path)
    ctx.answer("built-saved", name=path)


async def may_leave_built(ctx: Context) -> bool:
    """Offer to save a built world before leaving it. Returns False, after an answer, to stay.

    Where no question is possible, a copy is kept.
    """
    site = ctx.donnie.site
    if site.is_saved or not ctx.interaction.is_attended:
        keep_built(ctx)
        return True
    wants_to_save = await ctx.interaction.confirm(ctx.words("ask-save-world"))
    if wants_to_save:
        await attempt(ctx, save_world(ctx, ""))
    if wants_to_save is not False and not site.is_saved:
        ctx.answer("stays-unsaved")
    return wants_to_save is False or site.is_saved


def keep_built(ctx: Context) -> None:
    """Keep a copy of a built world that is not saved, and say in which file."""
    kept = ctx.donnie.rescue_world()
    if kept is not None:
        ctx.answer("built-rescued", path=kept)
