"""A world by its name or by its file, loaded; every way in which that can fail is a sentence.

A name of a world that ships wins over a file in the current folder; ``./name`` is always the file.
"""

from __future__ import annotations

import difflib
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import worlds
from donnie_tui.i18n.words import Words
from donnie_tui.i18n.world_mistakes import world_mistake

if TYPE_CHECKING:
    from sim.scene import Scene


class Unusable(Exception):
    """A world, file or device that can't be used. ``sentence`` is in the learner's language."""

    def __init__(self, sentence: str) -> None:
        super().__init__(sentence)
        self.sentence = sentence


@dataclass(frozen=True, slots=True)
class ChosenWorld:
    """A world that was loaded. ``name`` is what the event stream calls it, whichever folder it came from."""

    name: str
    path: Path
    scene: Scene
    ships: bool
    """Whether it is one of ours, with words about it."""

    def about(self, language: str) -> worlds.About | None:
        """Title, description and task; None for a file of the learner's own."""
        return worlds.about(self.name, language) if self.ships else None


def choose_world(name_or_file: str, words: Words) -> ChosenWorld:
    """The world of ``--world``. Raises ``Unusable``."""
    if name_or_file in worlds.names():
        path = worlds.path(name_or_file)
        return ChosenWorld(name_or_file, path, _load(path, words), ships=True)
    path = Path(name_or_file)
    if not _looks_like_a_file(name_or_file) and not path.exists():
        raise Unusable(_unknown_world(name_or_file, words))
    return ChosenWorld(path.name, path, _load(path, words), ships=False)


def _looks_like_a_file(name: str) -> bool:
    return "/" in name or "\\" in name or Path(name).suffix != ""


def _unknown_world(name: str, words: Words) -> str:
    near = difflib.get_close_matches(name.lower().replace(" ", "_"), worlds.names(), n=1)
    if near:
        return words("world-unknown-near", name=name, near=near[0])
    return words("world-unknown", name=name)


def _load(path: Path, words: Words) -> Scene:
    from sim.worldfile import WorldError, load_world

    try:
        scene = load_world(path, allowed=(worlds.SCENES,))
    except WorldError as error:
        raise Unusable(world_mistake(error, words)) from None
    if not scene.robots:
        raise Unusable(words("world-without-robot", name=path.name))
    return scene
