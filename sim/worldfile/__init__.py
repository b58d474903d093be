"""World files as Stage has them: text in; a scene, or a mistake with its place, out."""

from sim.worldfile.edit import (
    WrittenModel,
    in_units,
    put_elsewhere,
    scattered,
    self_contained,
    taken_out,
    units_of,
    written_models,
)
from sim.worldfile.floor_plans import rectangles
from sim.worldfile.load import (
    Address,
    Configuration,
    Driver,
    Offer,
    load_configuration,
    load_text,
    load_world,
    standing_inside,
)
from sim.worldfile.mistakes import Code, WorldError

__all__ = [
    "Address",
    "Code",
    "Configuration",
    "Driver",
    "Offer",
    "WorldError",
    "WrittenModel",
    "in_units",
    "load_configuration",
    "load_text",
    "load_world",
    "put_elsewhere",
    "rectangles",
    "scattered",
    "self_contained",
    "standing_inside",
    "taken_out",
    "units_of",
    "written_models",
]
