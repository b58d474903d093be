"""A world in words: how large it is, where its robots start, and what stands where, nearest first.

Places are told from the robot, in steps: as it sees them (ahead, to the left) or by the compass, which suits
somebody who makes a picture of the world before anything moves. However much stands in a world, what is told
has an end: the nearest things one by one, the others counted by kind.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Sequence
from math import cos, hypot, radians, sin
from typing import TYPE_CHECKING

from devices.ports.robot import Pose
from donnie_tui.core import poses
from donnie_tui.core.naming import coloured, coloured_thing, name_of, told_name_of
from donnie_tui.core.telling import facing
from donnie_tui.core.wall_words import walls_in_words
from donnie_tui.core.wording import Wording

if TYPE_CHECKING:
    from sim.picture import Picture, Thing
    from worlds.words import About

MOST_THINGS = 20
"""Things that are told one by one."""
MOST_KINDS = 5
"""Kinds of the others that are counted."""
MOST_ROBOTS = 10
"""Robots that are named."""
LONG = 8
"""Steps from which the size of a thing is told too."""

_PlaceOf = Callable[[float, float, Pose, Wording], str]


def describe(
    picture: Picture, pose: Pose, wording: Wording, *, robot: str | None = None, about: About | None = None
) -> tuple[str, ...]:
    """A world for somebody who wants it in mind, a sentence a line: all of it, its walls, then its things.

    ``robot``: who starts at ``pose``, None where no robot is. ``about``: what the world's author says of it.
    """
    return (
        *_overview(picture, pose, about, wording),
        *_robots(picture, pose, robot, wording),
        *_things(picture, pose, robot, wording),
        *((wording("world-task", task=about.task),) if about else ()),
    )


def told_world(name: str, about: About | None, in_words: Sequence[str], wording: Wording) -> tuple[str, ...]:
    """A world for somebody who is in it: what its author says, what stands there, and what to try.

    ``in_words``: what stands there, as MAP tells it.
    """
    if about is None:
        return tuple(in_words)
    title = wording("world-title", name=name, title=about.title)
    return (title, *about.sentences, *in_words, wording("world-task", task=about.task))


def _overview(picture: Picture, pose: Pose, about: About | None, wording: Wording) -> tuple[str, ...]:
    """The author's words know what is a room and what a passage; without them there are size and walls."""
    if about is None:
        return (size_in_words(picture, wording), *walls_in_words(picture, pose, wording))
    if not about.difficulty.value:
        return about.sentences
    level = wording(f"difficulty-{about.difficulty.value}")
    return (wording("world-difficulty", difficulty=level), *about.sentences)


def size_in_words(picture: Picture, wording: Wording) -> str:
    """How large the floor is, in steps, or that it has no end."""
    if not picture.has_walls:
        return wording("world-endless")
    return wording("world-size", width=picture.width * picture.cell, height=picture.height * picture.cell)


def _robots(picture: Picture, pose: Pose, robot: str | None, wording: Wording) -> tuple[str, ...]:
    """Who they are, where the first one starts, and where the others are from there."""
    if robot is None:
        return (wording("world-no-robot"),)
    start = {"x": poses.whole(pose.x), "y": poses.whole(pose.y), "facing": facing(pose, wording)}
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
    """What stands around as it is seen from ``pose``, other robots too, the nearest first.

    One sentence for each of the nearest ``MOST_THINGS``, then how many more there are; so the number of
    sentences is not that of the things.
    """
    return _bounded(picture.things, pose, wording, place_of)


def _bounded(things: Sequence[Thing], pose: Pose, wording: Wording, where: _PlaceOf) -> tuple[str, ...]:
    nearest_first = _by_distance(things, pose)
    told, others = nearest_first[:MOST_THINGS], nearest_first[MOST_THINGS:]
    return (*(_thing(each, pose, wording, where) for each in told), *_counted(others, wording))


def _by_distance(things: Iterable[Thing], pose: Pose) -> list[Thing]:
    return sorted(things, key=lambda each: hypot(each.x - pose.x, each.y - pose.y))


def _counted(others: Sequence[Thing], wording: Wording) -> tuple[str, ...]:
    """The things that are not told one by one: how many, and of which kinds most."""
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
    told = told_name_of(thing, wording) if brief else coloured_thing(thing, wording)
    width, depth = round(thing.width), round(thing.depth)
    return wording(
        "world-large-thing" if max(width, depth) >= LONG else "world-thing",
        thing=told,
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
    """Two distances in words; the codes are for negative and for positive ones."""
    pairs = ((first, first_codes), (second, second_codes))
    parts = [wording(codes[steps > 0], steps=abs(steps)) for steps, codes in pairs if steps]
    return ", ".join(parts) or wording("place-here")
