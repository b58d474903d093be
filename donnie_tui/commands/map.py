"""The MAP commands: the map in words, by squares, as a picture of letters, and how the screen shows it."""

from __future__ import annotations

from functools import partial

from donnie_tui.commands import arguments
from donnie_tui.commands.context import Context
from donnie_tui.commands.dispatch import handles
from donnie_tui.commands.interaction import NotUnderstood, Screen
from donnie_tui.core import map_words
from donnie_tui.core.map_grid import FREE
from donnie_tui.core.pointing import Pointer, legend

# --- in words


@handles("map")
async def whole_map_or_square(ctx: Context, argument: str) -> None:
    """The whole map, or the square at x, y."""
    place, pose = arguments.numbers(argument, most=2), ctx.donnie.session.pose
    if len(place) == 1:
        raise NotUnderstood
    if place:
        x, y = place
        ctx.say_of_robot(map_words.square_in_words(ctx.map_grid(), x, y, pose, ctx.words))
    else:
        _say_map(ctx)


def _say_map(ctx: Context) -> None:
    about, pose = ctx.donnie.world.about(ctx.words.language), ctx.donnie.session.pose
    ctx.say_of_robot(*map_words.map_in_words(ctx.donnie.picture_now(), pose, ctx.words, about))


@handles("map_row")
async def map_row(ctx: Context, argument: str) -> None:
    """The squares of one row."""
    (y,) = arguments.numbers(argument, least=1, most=1)
    ctx.say_of_robot(*map_words.row_in_words(ctx.map_grid(), y, ctx.words))


@handles("map_column")
async def map_column(ctx: Context, argument: str) -> None:
    """The squares of one column."""
    (x,) = arguments.numbers(argument, least=1, most=1)
    ctx.say_of_robot(*map_words.column_in_words(ctx.map_grid(), x, ctx.words))


@handles("map_picture")
async def map_picture(ctx: Context, _: str) -> None:
    """The map as letters, a character a square."""
    letter = ctx.preferences.settings.free
    lines = map_words.picture_in_letters(ctx.map_grid(), ctx.words, FREE if letter == "dot" else letter)
    with_name = ctx.of_robot(*lines)
    await ctx.interaction.show_pages(ctx.words("key-show_map"), lines, with_name)


@handles("show_map")
async def show_map(ctx: Context, _: str) -> None:
    """Go to the map; where there is no screen, say it."""
    if ctx.screen is None:
        _say_map(ctx)
    else:
        ctx.screen.focus("map")


# --- on the screen


def _on_screen(ctx: Context) -> Screen:
    """The screen of a command that the dispatcher runs only where there is one."""
    assert ctx.screen is not None
    return ctx.screen


@handles("next_thing")
async def next_thing(ctx: Context, _: str) -> None:
    """Point to the next thing on the map."""
    _to_thing(ctx, forward=True)


@handles("previous_thing")
async def previous_thing(ctx: Context, _: str) -> None:
    """Point to the thing before."""
    _to_thing(ctx, forward=False)


def _to_thing(ctx: Context, *, forward: bool) -> None:
    screen = _on_screen(ctx)
    pointer = screen.map.pointer
    if pointer is None or not pointer.scene.things:
        ctx.answer("world-bare")
    else:
        screen.explore(lambda pointer: pointer.to_next_thing(forward))


@handles("to_robot")
async def to_robot(ctx: Context, _: str) -> None:
    """Point to the robot."""
    _on_screen(ctx).explore(Pointer.to_robot)


@handles("from_here")
async def from_here(ctx: Context, _: str) -> None:
    """Mark the square from which TO THERE measures the way."""
    screen = _on_screen(ctx)
    screen.explore(Pointer.mark)
    pointer = screen.map.pointer
    if pointer is not None:
        x, y = pointer.scene.place(pointer.here)
        ctx.answer("map-marked", x=x, y=y)


@handles("to_there")
async def to_there(ctx: Context, _: str) -> None:
    """The way from the marked square to the one that is pointed to."""
    pointer = _on_screen(ctx).map.pointer
    if pointer is not None:
        ctx.say(pointer.way(ctx.words))


@handles("zoom_in")
async def zoom_in(ctx: Context, _: str) -> None:
    """Show fewer steps, larger."""
    _zoom(ctx, 1)


@handles("zoom_out")
async def zoom_out(ctx: Context, _: str) -> None:
    """Show more steps, smaller."""
    _zoom(ctx, -1)


def _zoom(ctx: Context, by: int) -> None:
    pane = _on_screen(ctx).map
    pane.set_zoom(pane.zoom + by)
    _say_scale(ctx)


@handles("whole_map")
async def whole_map(ctx: Context, _: str) -> None:
    """Show the whole floor, or follow the robot as before."""
    pane = _on_screen(ctx).map
    pane.show_all(not pane.shows_all)
    _say_scale(ctx)


def _say_scale(ctx: Context) -> None:
    pane = _on_screen(ctx).map
    if pane.scale is not None:
        steps = pane.scale.factor * pane.scale.scene.picture.cell
        ctx.answer("map-shows-all" if pane.shows_all else "map-follows", steps=steps)


@handles("names")
async def names(ctx: Context, _: str) -> None:
    """Show or hide the names of the things."""
    from donnie_tui.core.map_scene import labels

    pane = _on_screen(ctx).map
    pane.show_names(None if pane.has_names else partial(labels, wording=ctx.words))
    ctx.answer(f"screen-names-{'on' if pane.has_names else 'off'}")


@handles("coordinates")
async def coordinates(ctx: Context, _: str) -> None:
    """Show or hide the numbers of the rows and columns."""
    pane = _on_screen(ctx).map
    pane.show_rulers(not pane.has_rulers)
    ctx.answer(f"screen-coordinates-{'on' if pane.has_rulers else 'off'}")


@handles("legend")
async def show_legend(ctx: Context, _: str) -> None:
    """What the letters of the map mean."""
    scale = _on_screen(ctx).map.scale
    if scale is not None:
        lines = legend(scale.scene, ctx.words)
        await ctx.interaction.show_pages(ctx.words("legend-title"), lines)
