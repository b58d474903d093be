"""WHERE, AROUND, MAP, TRAIL, SENSORS, WORLD: about the robot and its world. All sentences are the core's."""

from __future__ import annotations

from donnie_tui.core import map_words
from donnie_tui.core.around import around_in_words, compass_point
from donnie_tui.core.describe import told_world
from donnie_tui.core.map_grid import FREE, MapGrid
from donnie_tui.core.naming import shown_name
from donnie_tui.core.sensor_words import sensors_in_words, sensors_of_board
from donnie_tui.core.trail import USUALLY_TOLD, place_in_words
from donnie_tui.core.transcript import lines_said_by
from donnie_tui.core.typed_words import numbers_in
from donnie_tui.linear.arguments import Handler, alone, counted
from donnie_tui.linear.desk import Desk
from donnie_tui.linear.runs import Runs


def _grid(desk: Desk) -> MapGrid:
    return MapGrid(desk.donnie.picture_now(), desk.session.pose, shown_name(desk.session.name))


def _where(desk: Desk) -> None:
    """Where the robot is; at full its last move too."""
    is_full = desk.say.detail == "full"
    desk.tell_of_robot(*place_in_words(desk.session.pose, desk.heard.trail, desk.say, is_full=is_full))


def _around(desk: Desk, _: Runs, rest: str) -> bool:
    """As the robot looks, or by the compass from the point that is named on."""
    point = compass_point(rest)
    if rest and point is None:
        return False
    clock = desk.ends.habits.clock and not rest
    desk.tell_of_robot(*around_in_words(_grid(desk), desk.session.pose, desk.say, compass=point, clock=clock))
    return True


def _map(desk: Desk, _: Runs, rest: str) -> bool:
    """The whole, or the square at x, y."""
    given = numbers_in(rest, most=2)
    if given is None or len(given) == 1:
        return False
    if given:
        x, y = given
        desk.tell_of_robot(map_words.square_in_words(_grid(desk), x, y, desk.session.pose, desk.say))
    else:
        say_map(desk)
    return True


def say_map(desk: Desk) -> None:
    desk.tell_of_robot(*_map_in_words(desk))


def _map_in_words(desk: Desk) -> tuple[str, ...]:
    about = desk.donnie.world.about(desk.say.language)
    return map_words.map_in_words(desk.donnie.picture_now(), desk.session.pose, desk.say, about)


def _row(desk: Desk, _: Runs, rest: str) -> bool:
    given = numbers_in(rest, most=1)
    if given:
        desk.tell_of_robot(*map_words.row_in_words(_grid(desk), given[0], desk.say))
    return bool(given)


def _column(desk: Desk, _: Runs, rest: str) -> bool:
    given = numbers_in(rest, most=1)
    if given:
        desk.tell_of_robot(*map_words.column_in_words(_grid(desk), given[0], desk.say))
    return bool(given)


def _picture(desk: Desk) -> None:
    desk.tell_of_robot(*map_words.picture_in_letters(_grid(desk), desk.say, desk.ends.habits.free or FREE))


def _trail(desk: Desk, count: int) -> None:
    desk.tell_of_robot(*desk.with_number(desk.heard.trail.in_words(count, desk.say)))


def _sensors(desk: Desk) -> None:
    if desk.donnie.connection.is_board:
        desk.tell(*sensors_of_board(shown_name(desk.session.name), desk.say))
    else:
        desk.tell(*sensors_in_words(desk.donnie.mounted(), shown_name(desk.session.name), desk.say))


def say_world(desk: Desk) -> None:
    """What its author says of the world, what stands in it, and what to try there."""
    world = desk.donnie.world
    floor = lines_said_by(desk.session.hub.robot, _map_in_words(desk), desk.say)
    desk.tell(*told_world(world.name, world.about(desk.say.language), floor, desk.say))


HANDLERS: dict[str, Handler] = {
    "where": alone(_where),
    "around": _around,
    "map": _map,
    "show_map": alone(say_map),
    "map_row": _row,
    "map_column": _column,
    "map_picture": alone(_picture),
    "sensors": alone(_sensors),
    "trail": counted(_trail, USUALLY_TOLD),
}
