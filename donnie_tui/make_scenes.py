"""Makes the scenes of the worlds that ship: ``python -m donnie_tui.make_scenes``.

Needed after any change of a world, of ``sim.scene`` or of how world files are read; a test says when.
"""

from __future__ import annotations

from pathlib import Path

import worlds
from sim import ready
from sim.scene import Scene


def parsed(name: str) -> Scene:
    """The scene as the world file gives it."""
    from sim.worldfile import load_world

    return load_world(Path(worlds.path(name)), allowed=(Path(worlds.SCENES),))


def main() -> None:
    """Write them all, each beside its world."""
    for name in worlds.names():
        path = worlds.path(name)
        Path(ready.beside(path)).write_bytes(ready.made(path, parsed(name)))


if __name__ == "__main__":
    main()
