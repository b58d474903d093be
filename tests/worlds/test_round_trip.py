"""Random worlds: a written world loads as it was, and so does a loaded world that is written again."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from math import cos, radians, sin
from pathlib import Path
from random import Random

from hypothesis import given, settings
from hypothesis import strategies as st
from msgspec import Struct

from sim.scene import Scene
from sim.worldfile import load_text
from tests.effort import examples
from tests.worlds.writer import numbers, written

TYPES = ("model", "position", "ranger", "blobfinder", "fiducial", "bumper", "gripper")
COLOURS = ("red", "DarkBlue", "orange", "gray30")


RETURNS = ("obstacle_return", "ranger_return", "blob_return", "fiducial_return", "gripper_return")


@dataclass(frozen=True)
class Drawn:
    """A random model before it is written to a file."""

    type: str
    pose: tuple[float, float, float, float]
    size: tuple[float, float, float]
    colour: str
    returns: dict[str, int]
    extra: str
    blocks: list[list[tuple[int, int]]]
    children: list[Drawn]
    through_macro: bool


class Lots:
    """Random numbers, rounded to a thousandth: the file has few decimals."""

    def __init__(self, seed: int) -> None:
        self.chance = Random(seed)

    def world(self) -> list[Drawn]:
        return [self._model(2) for _ in range(self.chance.randint(1, 4))]

    def _model(self, depth: int) -> Drawn:
        kind = self.chance.choice(TYPES)
        shaped = kind in ("model", "position")
        return Drawn(
            kind,
            self._place(),
            (self._between(0.01, 3), self._between(0.01, 3), self._between(0.01, 2)),
            self.chance.choice(COLOURS),
            {name: self.chance.randint(-1, 3) for name in RETURNS if self._now_and_then()},
            self._extra(kind),
            [self._corners() for _ in range(self.chance.randint(0, 2))] if shaped else [],
            [self._model(depth - 1) for _ in range(self.chance.randint(0, 2))] if depth else [],
            self._now_and_then(),
        )

    def _extra(self, kind: str) -> str:
        """Some of the properties that only this type has."""
        low, high, fov = self._between(0, 2), self._between(2, 9), self._between(1, 360)
        match kind:
            case "position":
                drive, knows = (
                    self.chance.choice(("diff", "omni", "car")),
                    self.chance.choice(("gps", "odom")),
                )
                bounds = f"velocity_bounds [ {-low} {high} -0.5 0.5 0 0 -90 45 ]"
                return f'drive "{drive}" localization "{knows}" odom_error [ {low} 0.02 0.1 ] {bounds}'
            case "ranger":
                return " ".join(self._sensor() for _ in range(self.chance.randint(0, 3)))
            case "blobfinder":
                return f"range {high} fov {fov} pan {low}"
            case "fiducial":
                return f"range_min {low} range_max {high} fov {fov}"
            case "bumper":
                return f"bcount 2 bpose[0] {numbers(self._place())} blength {low}"
            case "gripper":
                states = ('[ "open" "up" ]', '[ "closed" "down" ]', '"closed"')
                return f"paddle_state {self.chance.choice(states)} paddle_size [ 0.5 0.2 0.4 ]"
        return self.chance.choice(("", "pushable 1 mass 2.5", "boundary 1", "ignore_zloc 0"))

    def _sensor(self) -> str:
        bounds = numbers((self._between(0, 2), self._between(2, 9)))
        samples, noise = self.chance.randint(1, 9), self._between(0, 1)
        view = f"fov {self._between(1, 360)} samples {samples} range_noise {noise}"
        return f"sensor ( range {bounds} {view} pose {numbers(self._place())} )"

    def _corners(self) -> list[tuple[int, int]]:
        count, corners = self.chance.randint(3, 7), [(x, y) for x in range(20) for y in range(20)]
        return self.chance.sample(corners, count)

    def _place(self) -> tuple[float, float, float, float]:
        x, y, z = self._between(-9, 9), self._between(-9, 9), self._between(0, 2)
        return x, y, z, self._between(-180, 180)

    def _between(self, low: float, high: float) -> float:
        return self.chance.randint(round(low * 1000), round(high * 1000)) / 1000

    def _now_and_then(self) -> bool:
        return self.chance.random() < 0.5


def text_of(models: list[Drawn]) -> str:
    """The models as a world file; some by a macro that has a part of their properties."""
    lines: list[str] = []
    bodies = [_text(model, lines) for model in models]
    return "\n".join((*lines, *bodies))


def _text(model: Drawn, macros: list[str]) -> str:
    first = [f"size {numbers(model.size)}", model.extra]
    second = [f"pose {numbers(model.pose)}", f'color "{model.colour}"']
    second += [f"{name} {value}" for name, value in model.returns.items()]
    second += [_block(points) for points in model.blocks]
    second += [_text(child, macros) for child in model.children]
    if not model.through_macro:
        return f"{model.type} ( {' '.join(first + second)} )"
    name = f"made{len(macros)}"
    macros.append(f'define {name} {model.type} ( {" ".join(first)} color "green" )')
    return f"{name}\n( {' '.join(second)} )  # a macro\n"


def _block(points: list[tuple[int, int]]) -> str:
    corners = " ".join(f"point[{i}] {numbers(point)}" for i, point in enumerate(points))
    return f"block ( points {len(points)} {corners} )"


def in_order(models: list[Drawn]) -> Iterator[tuple[Drawn, Drawn | None]]:
    """Every model with its parent, as they are numbered."""

    def below(model: Drawn, parent: Drawn | None) -> Iterator[tuple[Drawn, Drawn | None]]:
        yield model, parent
        for child in model.children:
            yield from below(child, model)

    for model in models:
        yield from below(model, None)


def outside(
    model: Drawn, parents: dict[int, tuple[float, float, float, float]], parent: Drawn | None
) -> None:
    """Work out where a model lies in the world."""
    x, y, z, yaw = model.pose
    if parent is not None:
        px, py, pz, turn = parents[id(parent)]
        c, s = cos(radians(turn)), sin(radians(turn))
        x, y, z, yaw = px + c * x - s * y, py + s * x + c * y, pz + parent.size[2] + z, turn + yaw
    parents[id(model)] = (x, y, z, yaw)


def comparable(value: object, decimals: int = 6) -> object:
    """A value with rounded floats, for comparing, without the fields that only say how it was written."""
    if isinstance(value, float):
        return round(value, decimals) + 0.0
    if isinstance(value, tuple):
        return tuple(comparable(item, decimals) for item in value)
    if isinstance(value, Struct):
        names = [name for name in value.__struct_fields__ if name not in ("kind", "name", "alias")]
        return {name: _turned(name, getattr(value, name), decimals) for name in names}
    return value


def _turned(name: str, value: object, decimals: int) -> object:
    """Angles that are a full turn apart are the same."""
    if name == "yaw" and isinstance(value, float):
        return round(value % 360.0, decimals) % 360.0
    return comparable(value, decimals)


def models_of(scene: Scene) -> list[object]:
    return [comparable(model) for model in scene.models]


@settings(max_examples=examples(100))
@given(st.integers(0, 2**32))
def test_a_written_world_loads_as_it_was(seed: int) -> None:
    models = Lots(seed).world()
    scene = load_text(text_of(models), Path("drawn.world"))

    wanted = list(in_order(models))
    where: dict[int, tuple[float, float, float, float]] = {}
    assert [model.type for model in scene.models] == [model.type for model, _ in wanted]
    for found, (model, parent) in zip(scene.models, wanted, strict=True):
        outside(model, where, parent)
        pose = (found.pose.x, found.pose.y, found.pose.z, found.pose.yaw)
        assert comparable(pose) == comparable(where[id(model)])
        assert (found.size, found.colour.name) == (model.size, model.colour)
        assert {name: getattr(found, name) for name in model.returns} == model.returns
        if model.blocks:
            assert len(found.polygons) == len(model.blocks)
            _fills(found.polygons, model)


def _fills(polygons: object, model: Drawn) -> None:
    """All blocks together are as large as the size says."""
    points = [point for polygon in polygons for point in polygon.points]  # type: ignore[attr-defined]
    drawn_points = [point for block in model.blocks for point in block]
    for axis in (0, 1):
        low, high = min(p[axis] for p in points), max(p[axis] for p in points)
        flat = len({p[axis] for p in drawn_points}) == 1
        assert round(high - low, 6) == (0 if flat else round(model.size[axis], 6))
        assert round(high + low, 6) == 0


@settings(max_examples=examples(100))
@given(st.integers(0, 2**32))
def test_a_loaded_world_that_is_written_again_loads_the_same(seed: int) -> None:
    models = Lots(seed).world()
    scene = load_text(text_of(models), Path("drawn.world"))

    again = load_text(written(scene), Path("written.world"))

    assert models_of(again) == models_of(scene)
    assert again.robots == scene.robots
