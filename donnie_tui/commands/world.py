"""WHERE, TRAIL, SHOW PATH, SENSORS, MAP, WORLD, WORLDS: the surroundings, the map, other worlds."""

from __future__ import annotations

from functools import partial

from msgspec.structs import replace

from devices.ports.robot import Pose
from donnie_tui.bootstrap import Donnie, task_on_arrival
from donnie_tui.commands.context import UNUSABLE, Context
from donnie_tui.commands.declarations import BY_NAME
from donnie_tui.commands.dispatch import handles
from donnie_tui.commands.interaction import MapPane, NotUnderstood, Option, Screen, read_count, read_numbers
from donnie_tui.commands.lookup import word_of
from donnie_tui.core import map_words
from donnie_tui.core.events import SoundSwitched
from donnie_tui.core.map_grid import DEFAULT_MOVES, FREE, LEGS_SAID, MapGrid, path_in_words, place_in_words
from donnie_tui.core.map_words import Pointer, legend
from donnie_tui.core.timeline import Trail
from donnie_tui.core.wording import shown_name
from donnie_tui.i18n.words import Words
from donnie_tui.settings.settings import Settings, SettingSource
from language.source import printable, quoted

LEAST_MAP_ROWS = 5
"""The least number of rows for a map in a list."""


@handles("where")
async def where(ctx: Context, _: str) -> None:
    """Say where the robot is, or was at the moment of STEP BACK; at full detail its last move too."""
    is_full = ctx.words.detail == "full"
    pose, moves = _moment(ctx)
    ctx.say_of_robot(*place_in_words(pose, moves, ctx.words, is_full=is_full))


def _moment(ctx: Context) -> tuple[Pose, Trail]:
    """The robot's place and moves now, or at the moment of STEP BACK."""
    past, robot = ctx.runs.past, ctx.donnie.session.hub.robot
    if past is None:
        return ctx.donnie.session.pose, ctx.trail
    at, moves = past.at, past.moves(lambda: robot)
    past.go_to(max(1, at))  # where the robot was at first is known from the beginning of the run
    pose = past.pose(robot)
    past.go_to(at)
    return pose or ctx.donnie.session.pose, moves


@handles("around")
async def around(ctx: Context, argument: str) -> None:
    """Say what is around the robot, by the robot's directions or from a point of the compass."""
    from donnie_tui.core.map_words import around_in_words, compass_point

    point = compass_point(argument)
    if argument and point is None:
        raise NotUnderstood
    has_clock = ctx.preferences.settings.clock == "on" and not argument
    donnie, grid = ctx.donnie, ctx.map_grid()
    pose, held = donnie.session.pose, donnie.held_thing
    ctx.say_of_robot(*around_in_words(grid, pose, ctx.words, compass=point, clock=has_clock, held=held))


@handles("trail")
async def trail(ctx: Context, argument: str) -> None:
    """Say the robot's last moves."""
    count = read_count(argument, DEFAULT_MOVES)
    _, moves = _moment(ctx)
    ctx.say_of_robot(*ctx.counted(moves.in_words(count, ctx.words)))


@handles("show_path")
async def show_path(ctx: Context, _: str) -> None:
    """Say the driven path since the start leg by leg, and print it on the map in letters."""
    pose, moves = _moment(ctx)
    path = moves.path
    lines = ctx.counted(path_in_words(path, ctx.words, LEGS_SAID))
    if len(lines) > 1:
        donnie = ctx.donnie
        grid = MapGrid(donnie.picture_now(), path.poses[0], shown_name(donnie.session.name))
        for piece in path.pieces:
            grid.robot = grid.cell_of(piece[0])
            for each in piece:
                grid.move(each)
        grid.move(pose)
        lines = (*lines, *map_words.picture_in_letters(grid, ctx.words, _free(ctx)))
    await ctx.interaction.show_pages(ctx.words("path-title"), lines, ctx.of_robot(*lines))


def _free(ctx: Context) -> str:
    """The sign of a free square."""
    letter = ctx.preferences.settings.free
    return FREE if letter == "dot" else letter


@handles("sensors")
async def sensors(ctx: Context, _: str) -> None:
    """Say the robot's sensors; on the screen show their reach, until the robot moves."""
    from donnie_tui.core.describe import sensors_in_words, sensors_of_board

    name = shown_name(ctx.donnie.session.name)
    if ctx.donnie.connection.is_board and ctx.donnie.connection.mounted is None:
        ctx.say(*sensors_of_board(name, ctx.words, has_camera=ctx.donnie.connection.has_camera))
        return
    devices = ctx.donnie.mounted()
    if ctx.screen is not None:
        ctx.screen.show_sensor_ranges([line for each in devices for line in each.lines])
    ctx.say(*sensors_in_words(devices, name, ctx.words))


# --- the map in words


@handles("map")
async def whole_map_or_square(ctx: Context, argument: str) -> None:
    """Say the whole map, or the square at x, y."""
    place, pose = read_numbers(argument, most=2), ctx.donnie.session.pose
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
    """Say the squares of one row."""
    (y,) = read_numbers(argument, least=1, most=1)
    ctx.say_of_robot(*map_words.row_in_words(ctx.map_grid(), y, ctx.words))


@handles("map_column")
async def map_column(ctx: Context, argument: str) -> None:
    """Say the squares of one column."""
    (x,) = read_numbers(argument, least=1, most=1)
    ctx.say_of_robot(*map_words.column_in_words(ctx.map_grid(), x, ctx.words))


@handles("map_picture")
async def map_picture(ctx: Context, _: str) -> None:
    """Print the map in letters, a character a square."""
    lines = map_words.picture_in_letters(ctx.map_grid(), ctx.words, _free(ctx))
    with_name = ctx.of_robot(*lines)
    await ctx.interaction.show_pages(ctx.words("key-show_map"), lines, with_name)


@handles("show_map")
async def show_map(ctx: Context, _: str) -> None:
    """Focus the map; without a screen, say it."""
    if ctx.screen is None:
        _say_map(ctx)
    else:
        ctx.screen.focus("map")


# --- the map on the screen


def _on_screen(ctx: Context) -> Screen:
    """The screen of a command that the dispatcher runs only where there is one."""
    assert ctx.screen is not None
    return ctx.screen


@handles("next_thing", forward=True)
@handles("previous_thing", forward=False)
async def next_thing(ctx: Context, _: str, forward: bool) -> None:
    """Point to the next or the previous thing on the map."""
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
    """Say the way from the marked square to the pointer."""
    pointer = _on_screen(ctx).map.pointer
    if pointer is not None:
        ctx.say(pointer.way(ctx.words))


@handles("zoom_in", by=1, limit="map-nearest")
@handles("zoom_out", by=-1, limit="map-farthest")
async def zoom(ctx: Context, _: str, by: int, limit: str) -> None:
    """Zoom in or out, and say where that ends."""
    pane = _on_screen(ctx).map
    if pane.set_zoom(pane.zoom + by):
        _say_scale(ctx)
    else:
        ctx.answer_once(limit, steps=_steps_of_square(pane), columns=pane.columns)


@handles("whole_map")
async def whole_map(ctx: Context, _: str) -> None:
    """Show the whole floor, or follow the robot as before."""
    pane = _on_screen(ctx).map
    pane.show_all(not pane.shows_all)
    _say_scale(ctx)


def _say_scale(ctx: Context) -> None:
    pane = _on_screen(ctx).map
    code = "map-shows-all" if pane.shows_all else "map-nearer" if pane.zoom > 0 else "map-follows"
    ctx.answer(code, steps=_steps_of_square(pane), columns=pane.columns)


def _steps_of_square(pane: MapPane) -> int:
    return pane.scale.factor * pane.scale.scene.picture.cell if pane.scale is not None else 1


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


@handles("picture")
async def picture(ctx: Context, _: str) -> None:
    """Show the map in coloured blocks, or in letters again."""
    pane = _on_screen(ctx).map
    if not pane.has_colours:
        ctx.answer("screen-no-colours")
        return
    pane.show_picture(not pane.is_picture)
    ctx.answer(f"screen-picture-{'on' if pane.is_picture else 'off'}")


@handles("legend")
async def show_legend(ctx: Context, _: str) -> None:
    """Say what the letters of the map mean."""
    scale = _on_screen(ctx).map.scale
    if scale is not None:
        lines = legend(scale.scene, ctx.words)
        await ctx.interaction.show_pages(ctx.words("legend-title"), lines)


# --- worlds


@handles("world")
async def world(ctx: Context, argument: str) -> None:
    """Say the author's description, the things and the task of the world, or enter another one."""
    from donnie_tui.core.describe import world_introduction
    from donnie_tui.core.map_words import map_in_words
    from donnie_tui.core.transcript import lines_with_robot_name

    if argument:
        await enter_world(ctx, argument)
        return
    donnie = ctx.donnie
    about = donnie.world.about(ctx.words.language)
    floor = map_in_words(donnie.picture_now(), donnie.session.pose, ctx.words, about)
    of_robot = lines_with_robot_name(donnie.session.hub.robot, floor, ctx.words)
    ctx.say(*world_introduction(donnie.world.name, about, of_robot, ctx.words))


@handles("worlds")
async def worlds(ctx: Context, argument: str) -> None:
    """Offer the built-in worlds with titles and tasks, or enter one by its name."""
    import worlds as shipped
    from donnie_tui.core.describe import world_columns, world_row, worlds_in_words

    if argument:
        await enter_world(ctx, argument)
        return
    here = ctx.donnie.world.name
    if ctx.screen is not None and not may_leave_world(ctx):
        return
    options = [
        Option(
            name,
            world_row(name, ctx.words),
            name == here,
            columns=world_columns(name, ctx.words),
            detail=partial(_world_detail, name, ctx.words),
        )
        for name in shipped.names()
    ]
    printed = worlds_in_words(here, ctx.words)
    chosen = await ctx.interaction.choose(ctx.words("ask-worlds"), options, printed)
    if chosen:
        await enter_world(ctx, chosen)


def _world_detail(name: str, words: Words, columns: int, rows: int) -> tuple[str, ...]:
    """The things, a task, and the map if there is room."""
    from textwrap import wrap

    from donnie_tui.core.describe import world_sentences
    from donnie_tui.core.map_scene import MapScene, floor_rows
    from donnie_tui.world.loading import choose_world
    from sim.picture import picture

    found = choose_world(name, words)
    about = [row for each in world_sentences(name, words) for row in wrap(each, columns)]
    room = rows - len(about) - 1
    if room < LEAST_MAP_ROWS:
        return tuple(about)
    return (*floor_rows(MapScene(picture(found.scene), found.start()), columns, room), "", *about)


async def enter_world(ctx: Context, typed: str) -> None:
    """Enter another world with the same programs. Reading a learner's file may take long."""
    from donnie_tui.commands.build import may_leave_built

    slow = ctx.words("slow-world", name=quoted(typed))
    name = await ctx.interaction.background(lambda: world_to_enter(ctx, typed), slow)
    if name is not None and await may_leave_built(ctx):
        if ctx.donnie.world.challenge is not None:
            ctx.workspace.challenge = ctx.donnie.world.challenge.name
        await ctx.interaction.enter_world(name)


def may_leave_world(ctx: Context) -> bool:
    """False, after an answer, while the session is recorded: the recording would be lost."""
    recording = ctx.donnie.outlets.written.of_this_session
    if recording is not None:
        ctx.answer("world-kept", path=recording)
    return recording is None


def world_to_enter(ctx: Context, typed: str) -> str | None:
    """The name or file of a world that can be loaded; None after an answer that says why not."""
    from os.path import expanduser

    from donnie_tui.core.describe import world_meant
    from donnie_tui.core.program_files import unquoted
    from donnie_tui.i18n.words import Unusable
    from donnie_tui.world.loading import allowed_folders, choose_world, with_robot

    if not may_leave_world(ctx):
        return None
    file = expanduser(unquoted(typed))  # noqa: PTH111 -- a path would make ./maze the name of a world
    donnie, name = ctx.donnie, world_meant(typed) or file
    if name == donnie.world.name and donnie.world.ships:
        ctx.answer("world-here-already", name=name)
        return None
    try:
        folders = donnie.outlets.audible.settings.include_folders
        found = choose_world(name, ctx.words, folders, unknown="world-unknown-here")
        with_robot(found, ctx.words, allowed_folders(folders))
    except Unusable as unusable:
        ctx.refuse(UNUSABLE)
        ctx.say(*map(printable, unusable.sentences))
        return None
    return name


# --- on the way to another world


def settings_there(donnie: Donnie, settings: Settings, name: str) -> Settings:
    """``settings`` for that world, with the changes by commands meanwhile."""
    words, robot = donnie.words, donnie.connection.robot
    found = replace(
        settings,
        world=name,
        language=words.language,
        verbosity=words.detail,
        speed=donnie.session.speed,
        notices=(),
    )
    if robot == settings.robot:
        return found
    return replace(found, robot=robot, sources={**settings.sources, "robot": SettingSource.OPTION})


def arrive(ctx: Context, *, is_silent: bool) -> None:
    """Describe the entered world. ``is_silent``: the learner typed SOUND OFF in the one before.

    Another challenge begins with an empty program.
    """
    from donnie_tui.core.describe import arrived
    from donnie_tui.world.loading import robot_put_in

    donnie = ctx.donnie
    if is_silent:
        donnie.session.hub.publish(SoundSwitched(False))
    about = donnie.world.about(donnie.words.language)
    if donnie.world.challenge is not None:
        donnie.publish_answers(*task_on_arrival(donnie.world, donnie.words))
    else:
        donnie.publish_answers(*arrived(donnie.world.name, about, donnie.picture(), donnie.words))
    donnie.publish_answers(*robot_put_in(donnie.world, donnie.words))
    challenge = donnie.world.challenge
    if challenge is not None and challenge.name != ctx.workspace.challenge:
        lines = ctx.workspace.put_away()
        if lines:
            ctx.answer("challenge-put-away", lines=lines, word=word_of(BY_NAME["undo"], ctx.words.language))
