"""The worlds to go to, in words: the list of those that ship, which one somebody means, and being there.

Both front ends take them from here. A world is meant by its name or by its title in any language, in any
case, without accents, and with blanks or nothing where the name has underscores.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import worlds.words
from donnie_tui import LANGUAGES
from donnie_tui.core.describe import size_in_words
from donnie_tui.core.wording import Wording
from language.source import fold_name

if TYPE_CHECKING:
    from sim.picture import Picture


def world_meant(typed: str) -> str | None:
    """The name of the world that ships and is called so; None for anything else."""
    wanted = _folded(typed)
    by_name = next((name for name in worlds.names() if _folded(name) == wanted), None)
    return by_name or next((name for name in worlds.names() if wanted in _titles(name)), None)


def world_row(name: str, wording: Wording) -> str:
    """A world to choose: its title, how hard it is, what is there, and a task."""
    about = worlds.words.about(name, wording.language)
    return wording(
        "world-row",
        name=name,
        title=about.title,
        difficulty=wording(f"difficulty-{about.difficulty.value}"),
        about=" ".join(about.sentences),
        task=" ".join(about.task.split()),
    )


def worlds_in_words(here: str, wording: Wording) -> tuple[str, ...]:
    """How many there are and how to go to one, then a line each; ``here`` is the one that somebody is in."""
    names = worlds.names()
    return (wording("worlds-count", count=len(names)), *(_listed(each, here, wording) for each in names))


def arrived(
    name: str, about: worlds.words.About | None, picture: Picture, wording: Wording
) -> tuple[str, ...]:
    """That this world is there now, and what it has, in few sentences."""
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
    return tuple(_folded(worlds.words.about(name, language).title) for language in LANGUAGES)


def _folded(typed: str) -> str:
    return "".join(fold_name(typed).replace("_", " ").split())
