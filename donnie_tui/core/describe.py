"""Worlds in words: their size, walls, robots, sensors and things, and the list of worlds.

Places are given from the robot, in steps: as it sees them (ahead, to the left), or by the compass, which
suits a learner who studies the world before anything moves. The description is bounded: the nearest things
one by one, the others counted by kind.

Walls are described if the author of a world wrote nothing about them. A search over the free squares of
the map decides whether there are walls all around.

A learner finds a world by its name or title in any language: in any case, without accents, and with blanks or
nothing in place of underscores.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence
from math import cos, hypot, inf, radians, sin
from typing import TYPE_CHECKING, cast

import worlds.words
from devices.ports.robot import Pose
from donnie_tui.core.transcript import with_robot_name
from donnie_tui.core.wording import (
    Wording,
    called,
    coloured,
    coloured_thing,
    compass_point,
    facing,
    name_of,
    own_name,
    specific_name_of,
    whole_steps,
    with_colour,
)
from language import keywords
from language.locales import languages
from language.source import fold_name

if TYPE_CHECKING:
    from donnie_tui.core.goals import Inventory, Judgment, Shortfall
    from sim.picture import Picture, Thing
    from sim.sensors import Mounted
    from worlds.challenges import Area, Challenge, Target
    from worlds.words import About


_SIDES = ("north", "east", "south", "west")
_WALL = "#"


def walls_in_words(picture: Picture, pose: Pose, wording: Wording) -> tuple[str, ...]:
    """One sentence about the walls as seen from ``pose``; none if there are none."""
    if not picture.has_walls:
        return ()
    if not has_way_out(picture, pose):
        return (wording("walls-around"),)
    from sim.picture import Room  # a world without walls needs no geometry

    room = Room(picture, pose)
    gaps = {side: room.ahead(room.walls, 90.0 * quarter) for quarter, side in enumerate(_SIDES)}
    seen = [wording(f"place-{side}", steps=room.whole(gap)) for side, gap in gaps.items() if gap < inf]
    return (wording("walls-seen", sides=", ".join(seen)) if seen else wording("walls-aside"),)


def has_way_out(picture: Picture, pose: Pose) -> bool:
    """Whether free squares lead from there over the edge of the map. Searches by runs of squares."""
    rows, start = picture.rows, picture.at(pose.x, pose.y)
    waiting = [] if start is None else [start]
    seen = set[tuple[int, int]]()
    while waiting:
        row, column = waiting.pop()
        left, right = rows[row].rfind(_WALL, 0, column) + 1, rows[row].find(_WALL, column)
        if left == 0 or right == -1 or row in (0, picture.height - 1):
            return True
        if (row, left) not in seen:
            seen.add((row, left))
            waiting += [
                (beside, at) for beside in (row - 1, row + 1) for at in _runs(rows[beside], left, right)
            ]
    return start is None


def _runs(row: str, left: int, right: int) -> Iterator[int]:
    """The first square of each run of free ones between two columns."""
    for column in range(left, right):
        if row[column] != _WALL and (column == left or row[column - 1] == _WALL):
            yield column


MOST = 20
"""Kinds and directions that are listed one by one."""


def sensors_in_words(devices: Iterable[Mounted], name: str, wording: Wording) -> tuple[str, ...]:
    """A sentence for each kind and direction, with how many there are of it.

    ``name``: the robot's; empty for Donnie.
    """
    name = name or wording("cell-robot")
    counted = Counter(_sensor_phrase(each, wording) for each in devices)
    if not counted:
        return (wording("sensors-none", name=name),)
    described = [
        text if count == 1 else wording("sensors-several", count=count, what=text)
        for text, count in counted.items()
    ]
    more = len(described) - MOST
    return (
        wording("sensors-title", name=name),
        *described[:MOST],
        *((wording("sensors-more", count=more),) if more > 0 else ()),
    )


def sensors_of_board(name: str, wording: Wording, *, has_camera: bool) -> tuple[str, ...]:
    """The sensors of the original robot, which has them in every world."""
    return (
        wording("sensors-title", name=name or wording("cell-robot")),
        wording("sensors-board-around"),
        wording("sensors-board-head", scan=keywords.spelling("SCAN", wording.language)),
        wording("sensors-board-sees" if has_camera else "sensors-board-lacks"),
    )


def _sensor_phrase(device: Mounted, wording: Wording) -> str:
    return wording(
        f"sensors-{device.device.value}" + ("-named" if device.name else ""),
        name=device.name,
        where=_where(device.degrees, wording),
        width=round(device.width),
        metres=f"{round(device.metres, 2):g}",
    )


def _where(degrees: float, wording: Wording) -> str:
    turned = round(degrees)
    if abs(turned) == 180:
        return wording("sensors-behind")
    if turned > 0:
        return wording("sensors-right", degrees=turned)
    if turned < 0:
        return wording("sensors-left", degrees=-turned)
    return wording("sensors-ahead")


MOST_THINGS = 20
"""Things that are described one by one."""
MOST_KINDS = 5
"""Kinds of the remaining things that are counted."""
MOST_ROBOTS = 10
"""Robots that are named."""
LONG = 8
"""Steps from which the size of a thing is given too."""

_PlaceOf = Callable[[float, float, Pose, Wording], str]


def describe(
    picture: Picture, pose: Pose, wording: Wording, *, robot: str | None = None, about: About | None = None
) -> tuple[str, ...]:
    """A world before anything moves: all of it, its walls, then its things. One sentence a line.

    ``robot`` is the name of the robot at ``pose``, None if there is no robot. ``about`` has the author's
    words.
    """
    return (
        *_overview(picture, pose, about, wording),
        *_robots(picture, pose, robot, wording),
        *_things(picture, pose, robot, wording),
        *((wording("world-task", task=about.task),) if about else ()),
    )


def world_introduction(
    name: str, about: About | None, in_words: Sequence[str], wording: Wording
) -> tuple[str, ...]:
    """A world for a learner whose robot is in it: the author's words, the things, and what to try.

    ``in_words`` are the sentences of MAP about the things.
    """
    if about is None:
        return tuple(in_words)
    title = wording("world-title", name=name, title=about.title)
    return (title, *about.sentences, *in_words, wording("world-task", task=about.task))


def _overview(picture: Picture, pose: Pose, about: About | None, wording: Wording) -> tuple[str, ...]:
    """The author's words, which describe rooms and passages; without them the size and the walls."""
    if about is None:
        return (size_in_words(picture, wording), *walls_in_words(picture, pose, wording))
    if not about.difficulty.value:
        return about.sentences
    level = wording(f"difficulty-{about.difficulty.value}")
    return (wording("world-difficulty", difficulty=level), *about.sentences)


def size_in_words(picture: Picture, wording: Wording) -> str:
    """The size of the floor in steps, or that it has no end."""
    if not picture.has_walls:
        return wording("world-endless")
    return wording("world-size", width=picture.width * picture.cell, height=picture.height * picture.cell)


def _robots(picture: Picture, pose: Pose, robot: str | None, wording: Wording) -> tuple[str, ...]:
    """The names of the robots, where the first one starts, and where the others are from there."""
    if robot is None:
        return (wording("world-no-robot"),)
    start = {"x": whole_steps(pose.x), "y": whole_steps(pose.y), "facing": facing(pose, wording)}
    others = _by_distance((each for each in picture.things if each.is_robot), pose)
    if not others:
        return (wording("world-robot-start", name=robot, **start),)
    names = ", ".join([robot, *(each.name for each in others)][:MOST_ROBOTS])
    code = "world-robots" if len(others) < MOST_ROBOTS else "world-robots-many"
    return (
        wording(code, count=len(others) + 1, names=names, more=len(others) + 1 - MOST_ROBOTS),
        wording("world-robot-start", name=robot, **start),
        *(_robot(each, robot, pose, wording) for each in others[: MOST_ROBOTS - 1]),
    )


def _robot(robot: Thing, first: str, pose: Pose, wording: Wording) -> str:
    turned = Pose(robot.x, robot.y, robot.heading)
    return wording(
        "world-robot",
        first=first,
        name=name_of(robot, wording),
        place=compass_place_of(robot.x, robot.y, pose, wording),
        facing=facing(turned, wording),
    )


def _things(picture: Picture, pose: Pose, robot: str | None, wording: Wording) -> tuple[str, ...]:
    things = [each for each in picture.things if not each.is_robot]
    if not things:
        return (wording("world-bare"),)
    code = "world-things-from-start" if robot is None else "world-things-from-robot"
    count = wording(code, count=len(things), name=robot)
    return (count, *_bounded(things, pose, wording, compass_place_of))


def things_in_words(picture: Picture, pose: Pose, wording: Wording) -> tuple[str, ...]:
    """The things and other robots as seen from ``pose``, the nearest first.

    One sentence for each of the nearest ``MOST_THINGS``, then the number of the rest, so that the text is
    bounded.
    """
    return _bounded(picture.things, pose, wording, place_of)


def _bounded(things: Sequence[Thing], pose: Pose, wording: Wording, where: _PlaceOf) -> tuple[str, ...]:
    nearest_first = _by_distance(things, pose)
    described, others = nearest_first[:MOST_THINGS], nearest_first[MOST_THINGS:]
    return (*(_thing(each, pose, wording, where) for each in described), *_counted(others, wording))


def _by_distance(things: Iterable[Thing], pose: Pose) -> list[Thing]:
    return sorted(things, key=lambda each: hypot(each.x - pose.x, each.y - pose.y))


def _counted(others: Sequence[Thing], wording: Wording) -> tuple[str, ...]:
    """The remaining things: their number, and the most frequent kinds."""
    if not others:
        return ()
    kinds = Counter(coloured(each.kind, "", each.colour, wording) for each in others)
    return (
        wording("world-more-things", count=len(others)),
        *(
            wording("world-more-of-kind", count=count, thing=thing)
            for thing, count in kinds.most_common(MOST_KINDS)
        ),
    )


def _thing(thing: Thing, pose: Pose, wording: Wording, where: _PlaceOf) -> str:
    brief = wording.detail == "brief"
    described = specific_name_of(thing, wording) if brief else coloured_thing(thing, wording)
    width, depth = round(thing.width), round(thing.depth)
    return wording(
        "world-large-thing" if max(width, depth) >= LONG else "world-thing",
        thing=described,
        width=width,
        depth=depth,
        place=where(thing.x, thing.y, pose, wording),
    )


def place_of(x: float, y: float, pose: Pose, wording: Wording) -> str:
    """Where something is, seen from ``pose``: "2 left, 5 ahead", nearest step."""
    east, north, turned = x - pose.x, y - pose.y, radians(pose.heading)
    ahead = round(east * sin(turned) + north * cos(turned))
    right = round(east * cos(turned) - north * sin(turned))
    return _both(right, ("place-left", "place-right"), ahead, ("place-behind", "place-ahead"), wording)


def compass_place_of(x: float, y: float, pose: Pose, wording: Wording) -> str:
    """Where something is by the compass, whichever way the robot looks: "2 west, 5 north", nearest step."""
    east, north = round(x - pose.x), round(y - pose.y)
    return _both(east, ("place-west", "place-east"), north, ("place-south", "place-north"), wording)


def _both(
    first: int, first_codes: tuple[str, str], second: int, second_codes: tuple[str, str], wording: Wording
) -> str:
    """Two distances in words. The codes are those for negative and for positive distances."""
    pairs = ((first, first_codes), (second, second_codes))
    parts = [wording(codes[steps > 0], steps=abs(steps)) for steps, codes in pairs if steps]
    return ", ".join(parts) or wording("place-here")


def world_meant(typed: str) -> str | None:
    """The name of the built-in world with that name or title; None for anything else."""
    wanted = _folded(typed)
    by_name = next((name for name in worlds.names() if _folded(name) == wanted), None)
    return by_name or next((name for name in worlds.names() if wanted in _titles(name)), None)


def world_row(name: str, wording: Wording) -> str:
    """A row of the list of worlds: title, difficulty, content, and a task."""
    about = worlds.words.about(name, wording.language)
    return wording(
        "world-row",
        name=name,
        title=about.title,
        difficulty=wording(f"difficulty-{about.difficulty.value}"),
        about=" ".join(about.sentences),
        task=" ".join(about.task.split()),
    )


def world_columns(name: str, wording: Wording) -> tuple[str, str]:
    """The title and the difficulty."""
    about = worlds.words.about(name, wording.language)
    return about.title, wording(f"difficulty-{about.difficulty.value}")


def world_sentences(name: str, wording: Wording) -> tuple[str, ...]:
    """What is there, and a task."""
    about = worlds.words.about(name, wording.language)
    return " ".join(about.sentences), wording("world-task", task=" ".join(about.task.split()))


def worlds_in_words(here: str, wording: Wording) -> tuple[str, ...]:
    """The number of worlds and how to open one, then a line for each; ``here`` is the current one."""
    names = worlds.names()
    return (wording("worlds-count", count=len(names)), *(_listed(each, here, wording) for each in names))


def arrived(
    name: str, about: worlds.words.About | None, picture: Picture, wording: Wording
) -> tuple[str, ...]:
    """The sentences after a world was opened: its name, and briefly its content."""
    title = wording("world-here-titled", name=name, title=about.title) if about else None
    return (
        title or wording("world-here", name=name),
        size_in_words(picture, wording),
        wording("world-has", count=len(picture.things)) if picture.things else wording("world-bare"),
    )


def _listed(name: str, here: str, wording: Wording) -> str:
    about = worlds.words.about(name, wording.language)
    code = "worlds-line-here" if name == here else "worlds-line"
    level = wording(f"difficulty-{about.difficulty.value}")
    return wording(code, name=name, title=about.title, difficulty=level)


def _titles(name: str) -> tuple[str, ...]:
    return tuple(_folded(worlds.words.about(name, language).title) for language in languages())


def _folded(typed: str) -> str:
    return "".join(fold_name(typed).replace("_", " ").split())


# --- challenges

MOST_SENTENCES = 4
"""Of one verdict."""


def verdict_in_words(verdicts: Sequence[Judgment], wording: Wording) -> str:
    """That a challenge is solved, or what the first start that fails lacks. One verdict for each start."""
    failed = next(((at, each) for at, each in enumerate(verdicts, start=1) if not each.is_solved), None)
    if failed is None:
        return wording("challenge-solved", **verdicts[0].counts)
    at, verdict = failed
    said = [wording("challenge-met", **verdict.counts)]
    if at > 1:
        said.append(wording("challenge-start", number=at))
    said += [shortfall_in_words(each, verdict.track.end, wording) for each in verdict.shortfalls]
    return " ".join(list(dict.fromkeys(said))[:MOST_SENTENCES])


def goals_in_words(verdict: Judgment, wording: Wording) -> tuple[str, ...]:
    """Which goals are met, a line each."""
    lines, room = list[str](), verdict.track.end
    for number, each in enumerate(verdict.of_goals, start=1):
        code = "goal-met" if each is None else "goal-to-ask" if each.code == "goal-asked" else "goal-missing"
        text = "" if each is None else shortfall_in_words(each, room, wording)
        lines.append(wording(code, number=number, text=text))
    return tuple(lines)


def shortfall_in_words(shortfall: Shortfall, room: Inventory, wording: Wording) -> str:
    """What is missing, with the distance and the direction in it."""
    values = dict(shortfall.values)
    if "direction" in values:
        values["direction"] = compass_point(cast("float", values["direction"]), wording)
    if "word" in values:
        values["word"] = keywords.spelling(str(values["word"]), wording.language)
    if "target" in values:
        values["target"] = target_in_words(cast("Target", values["target"]), room, wording)
    if "area" in values:
        corners = (f"{each:g}" for corner in cast("Area", values["area"]) for each in corner)
        named = dict(zip(("from_x", "from_y", "x", "y"), corners, strict=True))
        values["area"] = wording("area-corners", **named)
    return with_robot_name(shortfall.robot, wording(shortfall.code, **values), wording)


def target_in_words(target: Target, room: Inventory, wording: Wording) -> str:
    """A thing or a place, without an article."""
    if isinstance(target, str):
        found, *_ = room.called(target)
        kind, name, colour = found.kind, found.name, found.colour
        is_alone = all(each.kind != kind or each.colour == colour for each in room.items)
        plain = called(kind, name, wording) if is_alone else with_colour(kind, name, colour, wording)
        return own_name(kind, name, wording) or plain
    return f"{target[0]:g}, {target[1]:g}"


def task_in_words(challenge: Challenge, wording: Wording, world: str = "") -> tuple[str, ...]:
    """Title, task, and what a solution may need; on arrival also the title of its world."""
    text, limit = challenge.text(wording.language), challenge.rules.limit
    most = {each: getattr(limit, each) for each in limit.__struct_fields__}
    limits = [wording(f"task-limit-{each}", most=round(n)) for each, n in most.items() if n is not None]
    allowed = (keywords.canonical(each) or each for each in challenge.rules.words)
    words = ", ".join(keywords.spelling(each, wording.language) for each in allowed)
    limits += [wording("task-words", words=words)] if words else []
    code = "challenge-arrived" if world else "challenge-here"
    return (wording(code, title=text.title, world=world), *text.sentences, *limits)
