"""The worlds that come with Donnie: files that Stage can load too, each with words in several languages.

Data only: reading a world's file is the simulator's business. ``scenes`` holds the scenarios, ``manual`` the
worlds of the manual's chapter on world files, step by step. The words are read in ``worlds.words``.
``examples`` holds programs to begin with, in English words and without a sentence in any language.
"""

from __future__ import annotations

import os

_HERE = os.path.realpath(__path__[0])
SCENES = f"{_HERE}/scenes"
"""The folder with the world files of the scenarios and what they include."""
MANUAL = f"{_HERE}/manual"
"""The folder with the worlds of the manual."""

PLAYER = f"{SCENES}/donnie.cfg"
"""Donnie for programs of the Player server, in the world PLAYED."""
PLAYED = "living_room"

EXAMPLES = ("square", "until_the_wall", "countdown", "turn_or_walk", "spiral", "rectangle", "blue_things")
"""The names of the example programs, easy ones first."""

WORLD = ".world"
_ORDER = (
    *("first_room", "open_floor", "living_room", "corridor", "two_rooms", "street"),
    *("colour_garden", "object_field", "two_robots", "store_room", "storehouse"),
    *("race_track", "cave", "factory", "wild_garden", "maze"),
    *("empty", "helloworld", "bigbob1", "bigbob2", "bigbob_yaws", "bigbob3", "bigbob_drive"),
    *("bigbob4", "bigbob5", "bigbob6", "bigbob_oranges", "bigbob7"),
)
"""Easy scenarios first, the manual's steps as they come there; what is not named here follows by name."""


def names() -> tuple[str, ...]:
    """The names of the worlds, in the order in which to offer them: scenarios first, then the manual's."""
    return (*scenarios(), *_names_in(MANUAL))


def scenarios() -> tuple[str, ...]:
    """The names of the worlds that are no step of the manual."""
    return _names_in(SCENES)


def _names_in(folder: str) -> tuple[str, ...]:
    found = {file.name.removesuffix(WORLD) for file in os.scandir(folder) if file.name.endswith(WORLD)}
    return tuple(name for name in _ORDER if name in found) + tuple(sorted(found.difference(_ORDER)))


def path(name: str) -> str:
    """The world file. KeyError if there is no such world."""
    for folder in (SCENES, MANUAL):
        if name in _names_in(folder):
            return f"{folder}/{name}{WORLD}"
    raise KeyError(name)


def example(name: str) -> str:
    """The text of an example program."""
    with open(f"{_HERE}/examples/{name}.gd", encoding="utf-8") as file:  # noqa: PTH123 -- as above
        return file.read()
