"""Compiled scenes: what was read from a world file, so that reading it again needs neither lark nor Pillow.

``maze.scene`` lies in the folder of ``maze.world``. It is used as long as every file that it was made from is
unchanged; after an edit of the world the world file itself is read.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from zlib import crc32

import msgspec
from msgspec import Struct
from msgspec.structs import replace

from sim.scene import Scene

SUFFIX = ".scene"
_CHECKSUM_SIZE = 4
"""Bytes at the start of the file: the checksum of the rest."""


class _CompiledScene(Struct, frozen=True, forbid_unknown_fields=True):
    sources: tuple[tuple[str, int], ...]
    """Each file that the scene was made from, relative to its folder, with the checksum of its content."""
    scene: Scene
    """Its paths are relative to its folder."""


def read_scene(world: str) -> Scene | None:
    """The compiled scene of the world file at ``world``; None if it is missing, damaged or outdated."""
    folder = os.path.split(world)[0]
    try:
        content = _read_bytes(path_of(world))
        checksum, encoded = content[:_CHECKSUM_SIZE], content[_CHECKSUM_SIZE:]
        if int.from_bytes(checksum) != crc32(encoded):
            return None
        compiled = msgspec.msgpack.decode(encoded, type=_CompiledScene)
        if any(crc32(_read_bytes(f"{folder}/{name}")) != expected for name, expected in compiled.sources):
            return None
    except (OSError, msgspec.MsgspecError):
        return None
    return _with_paths(compiled.scene, lambda name: os.path.normpath(f"{folder}/{name}"))


def compile_scene(world: str, scene: Scene) -> bytes:
    """The content of ``maze.scene`` for ``scene``, which was read from ``maze.world``."""
    folder = os.path.split(world)[0]
    relative = _with_paths(scene, lambda file: os.path.relpath(file, folder).replace(os.sep, "/"))
    names = dict.fromkeys((*relative.report.files, *relative.report.pictures))
    sources = tuple((name, crc32(_read_bytes(f"{folder}/{name}"))) for name in names)
    encoded = msgspec.msgpack.encode(_CompiledScene(sources, relative))
    return crc32(encoded).to_bytes(_CHECKSUM_SIZE) + encoded


def path_of(world: str) -> str:
    """The path of the compiled scene of the world file at ``world``."""
    return world.removesuffix(".world") + SUFFIX


def _read_bytes(path: str) -> bytes:
    with open(path, "rb") as file:  # noqa: PTH123 -- pathlib is slow to load
        return file.read()


def _with_paths(scene: Scene, change: Callable[[str], str]) -> Scene:
    """The scene with each path in its report changed."""
    report = scene.report
    return replace(
        scene,
        report=replace(
            report,
            files=tuple(map(change, report.files)),
            pictures=tuple(map(change, report.pictures)),
            notes=tuple(replace(note, file=note.file and change(note.file)) for note in report.notes),
        ),
    )
