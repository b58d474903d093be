"""A scene with things elsewhere than its file has them: pushed, carried, or driven there."""

from __future__ import annotations

from collections.abc import Mapping

from devices.ports.values import replace
from sim.geometry import direction
from sim.placement import Placement
from sim.scene import Model, Scene


def moved(scene: Scene, places: Mapping[int, Placement]) -> Scene:
    """The scene with these top-level models, by index, and all that is attached to them, at other places."""
    if not places:
        return scene
    models = tuple(
        _carried(model, scene.models[model.root].pose, places[model.root]) if model.root in places else model
        for model in scene.models
    )
    return replace(scene, models=models)


def _carried(model: Model, before: Placement, now: Placement) -> Model:
    c, s = direction(-before.yaw)
    dx, dy = model.pose.x - before.x, model.pose.y - before.y
    inner = Placement(c * dx - s * dy, s * dx + c * dy, model.pose.z - now.z, model.pose.yaw - before.yaw)
    return replace(model, pose=now.then(inner))
