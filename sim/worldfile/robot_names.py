"""What each robot of a world is called by those who program it: unique, and to be typed and said.

Stage numbers what has no name and lets two robots have the same one. Here somebody has to type which robot
is meant, so such a robot gets another name; ``Model.name`` stays what Stage has.
"""

from __future__ import annotations

from collections.abc import Iterable
from unicodedata import combining, normalize

from devices.ports.values import replace
from sim.notes import Note, NoteKind
from sim.scene import Model

_UNSPEAKABLE = frozenset(':="\\')
"""Of Stage's numbering, of ``NAME=FILE``, of quoting."""


def with_names(
    models: tuple[Model, ...], robots: Iterable[int]
) -> tuple[tuple[Model, ...], tuple[Note, ...]]:
    """The models, with aliases for those on wheels that need one, ``robots`` first; and what to tell."""
    indices = set(robots)
    wheeled = [model for model in models if model.type == "position" and model.parent is None]
    order = sorted(wheeled, key=lambda model: model.index not in indices)
    numbering = _Numbering({_folded(model.name) for model in order if _is_speakable(model.name)})
    kept, aliases, notes = set[str](), dict[int, str](), list[Note]()
    for model in order:
        speakable = _is_speakable(model.name)
        folded = _folded(model.name)
        if speakable and folded not in kept:
            kept.add(folded)
            continue
        alias = numbering.free(_stem(model), 2 if speakable else 1)
        aliases[model.index] = alias
        if model.index in indices:
            code = "robot-renamed" if speakable else "robot-without-name"
            notes.append(Note(NoteKind.REPAIRED, code, "", 0, 0, {"name": model.name[:60], "alias": alias}))
    named = tuple(
        replace(model, alias=aliases[model.index]) if model.index in aliases else model for model in models
    )
    return named, tuple(notes)


def _is_speakable(name: str) -> bool:
    return bool(name.strip()) and name == name.strip() and name.isprintable() and not _UNSPEAKABLE & set(name)


def _stem(model: Model) -> str:
    if _is_speakable(model.name):
        return model.name
    return model.kind if model.kind != model.type else "robot"


class _Numbering:
    """Names that nobody has yet. It goes on where it was with each stem: a file may have many robots."""

    def __init__(self, taken: set[str]) -> None:
        """``taken`` are folded."""
        self._taken = taken
        self._next: dict[tuple[str, int], int] = {}

    def free(self, stem: str, first: int) -> str:
        """The stem with the lowest number from ``first`` on that is free, which is taken from now on."""
        folded = _folded(stem)
        number = self._next.get((folded, first), first)
        while f"{folded}{number}" in self._taken:
            number += 1
        self._taken.add(f"{folded}{number}")
        self._next[folded, first] = number + 1
        return f"{stem}{number}"


def _folded(name: str) -> str:
    """Equal for names that differ in case and accents only."""
    return "".join(each for each in normalize("NFKD", name.casefold()) if not combining(each))
