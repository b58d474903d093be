"""Scenes of the worlds that ship, made beforehand: to read one needs neither the parser nor pictures.

Beside ``maze.world`` lies ``maze.scene``. It is used only as long as every file that it was made from is what
it was then; whoever edits a world sees the edited one. A scene is a pickle and so as trusted as code: only
those of our own folders may be read.
"""

from __future__ import annotations

import io
import os
import pickle
from collections.abc import Callable, Iterable
from typing import Any
from zlib import crc32

from devices.ports.values import replace
from sim.scene import Scene

SUFFIX = ".scene"


def read(world: str) -> Scene | None:
    """The scene that was made of our world file; None if there is none, or none that fits any more."""
    folder = _folder_of(world)
    try:
        sources, scene = pickle.loads(_bytes_of(beside(world)))
        is_fresh = all(crc32(_bytes_of(f"{folder}/{name}")) == sum_ for name, sum_ in sources)
    except OSError:
        return None
    except (pickle.UnpicklingError, EOFError, TypeError, AttributeError, ImportError):
        return None  # damaged, or made with other classes than ours are now
    return _placed(scene, lambda name: os.path.normpath(f"{folder}/{name}")) if is_fresh else None


def made(world: str, scene: Scene) -> bytes:
    """What ``maze.scene`` must hold for the world that was read from ``maze.world``."""
    folder = _folder_of(world)
    relative = _placed(scene, lambda file: os.path.relpath(file, folder).replace(os.sep, "/"))
    report = relative.report
    sources = tuple(
        (name, crc32(_bytes_of(f"{folder}/{name}"))) for name in _sources(report.files, report.pictures)
    )
    written = io.BytesIO()
    _Pickler(written, protocol=4).dump((sources, relative))
    return written.getvalue()


def _sources(files: Iterable[str], pictures: Iterable[str]) -> tuple[str, ...]:
    return tuple(dict.fromkeys((*files, *pictures)))


def beside(world: str) -> str:
    """The file of its scene."""
    return world.removesuffix(".world") + SUFFIX


def _folder_of(world: str) -> str:
    return os.path.split(world)[0]


def _bytes_of(path: str) -> bytes:
    with open(path, "rb") as file:  # noqa: PTH123 -- pathlib is slow to load
        return file.read()


def _placed(scene: Scene, place: Callable[[str], str]) -> Scene:
    """The scene, its files called by other paths."""
    report = scene.report
    return replace(
        scene,
        report=replace(
            report,
            files=tuple(map(place, report.files)),
            pictures=tuple(map(place, report.pictures)),
            notes=tuple(replace(each, file=each.file and place(each.file)) for each in report.notes),
        ),
    )


class _Pickler(pickle.Pickler):
    """Values become calls of their classes, so that a class of another shape is noticed."""

    def reducer_override(self, value: Any) -> Any:
        from dataclasses import fields, is_dataclass  # as a scene is made only, not as it is read

        if is_dataclass(value) and not isinstance(value, type):
            return type(value), tuple(getattr(value, each.name) for each in fields(value))
        return NotImplemented
