"""Writes scenes as world files, for tests: the loaded file must equal the scene."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from sim.geometry import Placement, normal, seen_from
from sim.scene import Limits, Model, Polygon, RangeSensor, Scene, Wheels


def written(scene: Scene) -> str:
    """A world file from which the same models are loaded."""
    return "\n".join(_model(scene, model) for model in scene.models if model.parent is None)


def numbers(values: Iterable[float]) -> str:
    return "[ " + " ".join(repr(float(value)) for value in values) + " ]"


def place(it: Placement) -> str:
    return numbers((it.x, it.y, it.z, it.yaw))


def _model(scene: Scene, model: Model) -> str:
    lines = [*_common(scene, model), *_equipment(model)]
    if model.gripper is None:
        lines += [_block(polygon) for polygon in model.polygons]
    lines += [_model(scene, child) for child in scene.models if child.parent == model.index]
    return f"{model.type} (\n" + "\n".join(lines) + "\n)"


def _common(scene: Scene, model: Model) -> Iterator[str]:
    colour = model.colour
    yield f'name "{model.name}"'
    yield f"pose {place(_inner(scene, model))}"
    yield f"origin {place(model.origin)}"
    yield f"size {numbers(model.size)}"
    yield f"color_rgba {numbers((colour.red, colour.green, colour.blue, colour.alpha))}"
    for name in ("obstacle", "ranger", "blob", "fiducial", "gripper"):
        yield f"{name}_return {getattr(model, f'{name}_return')!r}"
    yield f"fiducial_key {model.fiducial_key} pushable {int(model.pushable)} mass {model.mass!r}"
    yield f"ignore_zloc {int(model.ignore_zloc)} boundary {int(model.boundary)}"


def _inner(scene: Scene, model: Model) -> Placement:
    """The pose in the parent's frame; a child stands on top of it."""
    if model.parent is None:
        return model.pose
    parent, pose = scene.models[model.parent], model.pose
    ((x, y),) = seen_from(((pose.x, pose.y),), parent.pose.x, parent.pose.y, parent.pose.yaw)
    return Placement(x, y, pose.z - parent.pose.z - parent.size[2], normal(pose.yaw - parent.pose.yaw))


def _block(polygon: Polygon) -> str:
    points = " ".join(f"point[{i}] {numbers(point)}" for i, point in enumerate(polygon.points))
    return f"block ( points {len(polygon.points)} {points} z {numbers((polygon.bottom, polygon.top))} )"


def _equipment(model: Model) -> Iterator[str]:
    yield from (_sensor(sensor) for sensor in model.sensors)
    if (eyes := model.blobfinder) is not None:
        yield f"range {eyes.maximum!r} fov {eyes.fov!r} pan {eyes.pan!r} image {numbers(eyes.image)}"
    if (finder := model.fiducial_finder) is not None:
        yield f"range_min {finder.minimum!r} range_max {finder.maximum!r}"
        yield f"range_max_id {finder.maximum_id!r} fov {finder.fov!r}"
    if model.type == "bumper":
        yield f"bcount {len(model.bumpers)}"
        for i, bumper in enumerate(model.bumpers):
            yield f"bpose[{i}] {place(bumper.pose)} blength[{i}] {bumper.length!r}"
    if (hand := model.gripper) is not None:
        yield f"paddle_size {numbers((hand.paddle_length, hand.paddle_width, hand.paddle_height))}"
        states = ("closed" if hand.closed else "open", "up" if hand.lifted else "down")
        yield f'paddle_state [ "{states[0]}" "{states[1]}" ] autosnatch {int(hand.autosnatch)}'
    if model.wheels is not None:
        yield from _wheels(model.wheels)


def _sensor(it: RangeSensor) -> str:
    noise = it.noise
    return (
        f"sensor ( pose {place(it.pose)} range {numbers((it.minimum, it.maximum))} fov {it.fov!r}"
        f" samples {it.samples} size {numbers(it.size)}"
        f" noise {numbers((noise.proportional, noise.constant, noise.angle))} )"
    )


def _wheels(it: Wheels) -> Iterator[str]:
    yield f'drive "{it.drive.value}" localization "{it.localization.value}" wheelbase {it.wheelbase!r}'
    yield f"odom_error {numbers((it.odom_error.x, it.odom_error.y, 0, it.odom_error.yaw))}"
    if it.localization_origin is not None:
        yield f"localization_origin {place(it.localization_origin)}"
    for name in ("velocity_bounds", "acceleration_bounds"):
        limits: Limits | None = getattr(it, name)
        if limits is not None:
            yield f"{name} {numbers((*limits.x, *limits.y, 0, 0, *limits.yaw))}"
