"""A world in words: how large it is, where the robot starts, and what stands where, nearest first.

Places are told from the robot: how far ahead or behind, how far to the left or the right, in steps.
"""

from __future__ import annotations

from math import cos, hypot, radians, sin
from typing import TYPE_CHECKING

from devices.ports.robot import Pose
from donnie_tui.core import numbers
from donnie_tui.core.telling import facing
from donnie_tui.core.wording import Wording

if TYPE_CHECKING:
    from sim.picture import Picture, Thing


def describe(picture: Picture, pose: Pose, wording: Wording) -> tuple[str, ...]:
    """The world as it looks from ``pose``, a sentence a line."""
    start = wording(
        "world-start", x=numbers.whole(pose.x), y=numbers.whole(pose.y), facing=facing(pose, wording)
    )
    count = wording("world-things", count=len(picture.things)) if picture.things else wording("world-bare")
    return (_size(picture, wording), start, count, *things_in_words(picture, pose, wording))


def things_in_words(picture: Picture, pose: Pose, wording: Wording) -> tuple[str, ...]:
    """One sentence for each thing, the nearest first."""
    nearest_first = sorted(picture.things, key=lambda each: hypot(each.x - pose.x, each.y - pose.y))
    return tuple(_thing(each, pose, wording) for each in nearest_first)


def _size(picture: Picture, wording: Wording) -> str:
    if not picture.has_walls:
        return wording("world-endless")
    return wording("world-size", width=picture.width * picture.cell, height=picture.height * picture.cell)


def _thing(thing: Thing, pose: Pose, wording: Wording) -> str:
    name = name_of(thing, wording)
    return wording(
        "world-thing",
        name=name[:1].upper() + name[1:],
        colour=wording(f"colour-{thing.colour}"),
        place=place_of(thing.x, thing.y, pose, wording),
    )


def name_of(thing: Thing, wording: Wording) -> str:
    """In the learner's language where the kind is one of our worlds', else as its world's file has it."""
    try:
        return wording(f"thing-{thing.kind}")
    except KeyError:
        return thing.name or thing.kind


def place_of(x: float, y: float, pose: Pose, wording: Wording) -> str:
    """Where something is, seen from ``pose``: "2 left, 5 ahead", nearest step."""
    east, north, turned = x - pose.x, y - pose.y, radians(pose.heading)
    ahead = round(east * sin(turned) + north * cos(turned))
    right = round(east * cos(turned) - north * sin(turned))
    parts = []
    if right:
        parts.append(wording("place-right" if right > 0 else "place-left", steps=abs(right)))
    if ahead:
        parts.append(wording("place-ahead" if ahead > 0 else "place-behind", steps=abs(ahead)))
    return ", ".join(parts) or wording("place-here")
