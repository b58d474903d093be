"""World files as Stage has them: text in, a scene or a mistake with its place out."""

from sim.worldfile.load import load_text, load_world
from sim.worldfile.mistakes import Code, WorldError

__all__ = ["Code", "WorldError", "load_text", "load_world"]
