"""Compiles the scenes of the worlds that ship: ``python -m tests.tools.compile_scenes``.

Run it after any change of a world, of ``sim.scene`` or of the reading of world files; a test fails until
then.
"""

from __future__ import annotations

from pathlib import Path

import worlds
from sim.compiled_scene import compile_scene, path_of
from sim.scene import Scene


def parsed(name: str) -> Scene:
    """The scene as the world file gives it."""
    from sim.worldfile import load_world

    return load_world(Path(worlds.path(name)), allowed=(Path(worlds.SCENES),))


def main() -> None:
    """Write them all, each into the folder of its world."""
    for name in worlds.names():
        path = worlds.path(name)
        Path(path_of(path)).write_bytes(compile_scene(path, parsed(name)))


if __name__ == "__main__":
    main()
