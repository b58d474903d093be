"""The models of a world as JSON: what Stage would build from it, metres and degrees. A contract."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from sim.fittings import RangeSensor
    from sim.placement import Placement
    from sim.scene import Model, Scene

_DECIMALS = 6


def records(scene: Scene) -> list[dict[str, object]]:
    """A record a model, a parent before its children."""
    return [_record(model, scene) for model in scene.models]


def _record(model: Model, scene: Scene) -> dict[str, object]:
    parent = None if model.parent is None else scene.models[model.parent].name
    record: dict[str, object] = {
        "type": model.type,
        "name": model.name,
        "parent": parent,
        "global_pose": _placement(model.pose),
        "origin": _placement(model.origin),
        "size": _rounded(model.size),
        "color": _rounded((model.colour.red, model.colour.green, model.colour.blue, model.colour.alpha)),
        "obstacle_return": model.obstacle_return,
        "ranger_return": model.ranger_return,
        "blob_return": model.blob_return,
        "fiducial_return": model.fiducial_return,
        "gripper_return": model.gripper_return,
        "boundary": int(model.boundary),
        "blocks": model.stage_blocks,
        "block_area": round(model.stage_area, _DECIMALS),
    }
    if model.sensors:
        record["sensors"] = [_sensor(each) for each in model.sensors]
    return record


def _sensor(sensor: RangeSensor) -> dict[str, object]:
    return {
        "pose": _placement(sensor.pose),
        "range": _rounded((sensor.minimum, sensor.maximum)),
        "fov_deg": round(sensor.fov, _DECIMALS),
        "samples": sensor.samples,
    }


def _placement(placement: Placement) -> list[float]:
    return _rounded((placement.x, placement.y, placement.z, placement.yaw))


def _rounded(values: Iterable[float]) -> list[float]:
    return [round(value, _DECIMALS) + 0.0 for value in values]
