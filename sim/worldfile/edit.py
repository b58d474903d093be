"""Changes the text of a world: models at the top level are added, put elsewhere or taken out.
All else stays as its author wrote it. A model that stands in an included file can't be changed.

``scatter [ west south east north ]`` is a property of Donnie's at the top level: a seed puts the things in
that rectangle elsewhere in it.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from itertools import accumulate, pairwise
from math import hypot
from pathlib import Path

from msgspec import Struct

from devices.ports.robot import STEP
from sim.geometry import Placement
from sim.scene import Model, Scene
from sim.worldfile.entities import MODEL_TYPES, Expander, FileReader
from sim.worldfile.parser import REST, WorldToken, tokens
from sim.worldfile.values import ANGLES, UNITS


class WrittenModel(Struct, frozen=True):
    """Where a model at the top level stands in the text of its world. Offsets count characters."""

    begin: int
    end: int
    """After its last bracket."""
    inside: int
    """Before its last bracket."""
    pose: tuple[int, int] | None
    """From the bracket of its pose to after the other one; None if it says none."""


def written_models(text: str, path: Path, allowed: tuple[Path, ...] = ()) -> tuple[WrittenModel | None, ...]:
    """The models at the top level, in the scene's order; None for those of included files.

    Raises ``WorldError`` as ``load_text`` does.
    """
    reader = FileReader(path, allowed)
    entities = Expander(folders=reader.folders).expand(reader.statements(text, path, ()))
    here = _models_of(text, str(path))
    return tuple(
        here.get((each.line, each.column)) if each.file == str(path) else None
        for each in entities
        if each.type in MODEL_TYPES
    )


def _models_of(text: str, file: str) -> dict[tuple[int, int], WrittenModel]:
    """The models with a body at the top level, by line and column."""
    offset = _offset_in(text)
    found: dict[tuple[int, int], WrittenModel] = {}
    depth, first, pose, opened = 0, None, None, None
    before: WorldToken | None = None
    for token in tokens(text, file):
        match token.kind:
            case "LPAR":
                if depth == 0:
                    first, pose = before, None
                depth += 1
            case "RPAR":
                depth -= 1
                if depth == 0:
                    assert first is not None  # a world that begins with a bracket is refused before
                    begin, inside = offset(first), offset(token)
                    found[first.line, first.column] = WrittenModel(begin, inside + 1, inside, pose)
            case "LSQB" if depth == 1 and before is not None and before.text == "pose":
                opened = offset(token)
            case "RSQB" if opened is not None:
                pose, opened = (opened, offset(token) + 1), None
        before = token
    return found


def _offset_in(text: str) -> Callable[[WorldToken], int]:
    """How many characters are before a token."""
    starts = [0, *accumulate(len(line) + 1 for line in text.split("\n"))]
    return lambda token: starts[token.line - 1] + token.column - 1


def self_contained(
    text: str, path: Path, target: Path, allowed: tuple[Path, ...], picture: Callable[[Path], str]
) -> str:
    """The text of the world at ``path``, with what the files hold that a world at ``target`` can't include.

    ``picture`` returns the name there of a picture that a world there can't use. Raises ``WorldError``.
    """
    here, there = FileReader(path, allowed), FileReader(target, allowed)

    def written(text: str, file: Path) -> str:
        offset, parts, end = _offset_in(text), list[str](), 0
        for before, token in pairwise(tokens(text, str(file))):
            is_include = before.kind == "INCLUDE"
            if token.kind != "STRING" or not (is_include or before.text == "bitmap"):
                continue
            found, same = here.find(token.text, file), there.find(token.text, target)
            if found is None or (same is not None and there.is_allowed(same)):
                continue
            begin = offset(before if is_include else token)
            new = f"\n{written(here.text_of(found), found)}\n" if is_include else f'"{picture(found)}"'
            parts += [text[end:begin], new]
            end = offset(token) + len(token.text) + 2
            rest = REST.match(text, end)  # after an include: what begins nothing has no effect
            end = rest.end() if rest else end
        return "".join((*parts, text[end:]))

    return written(text, path)


def put_elsewhere(
    text: str, model: WrittenModel, place: Placement, units: tuple[float, float] = (1.0, 1.0)
) -> str:
    """The text with another pose of the model. ``units``: of the text, see ``units_of``."""
    metres, degrees = units
    numbers = (*(each / metres for each in (place.x, place.y, place.z)), place.yaw / degrees)
    pose = f"[ {' '.join(f'{each:.6g}' for each in numbers)} ]"
    if model.pose is not None:
        return text[: model.pose[0]] + pose + text[model.pose[1] :]
    blank = "" if text[model.inside - 1].isspace() else " "
    return f"{text[: model.inside]}{blank}pose {pose} {text[model.inside :]}"


def taken_out(text: str, model: WrittenModel) -> str:
    """The text without the model, and without its line where nothing else is in it."""
    line, rest = text.rfind("\n", 0, model.begin) + 1, text.find("\n", model.end)
    end = len(text) if rest < 0 else rest + 1
    if not text[line : model.begin].strip() and not text[model.end : end].strip():
        return text[:line] + text[end:]
    return text[: model.begin] + text[model.end :]


def units_of(scene: Scene) -> tuple[float, float]:
    """The metres and the degrees that numbers of its files count."""
    length, angle = scene.settings.get("unit_length", "m"), scene.settings.get("unit_angle", "degrees")
    return UNITS.get(str(length), 1.0), ANGLES.get(str(angle), 1.0)


_LENGTHS = ("size", "range", "blength")
_FIRST_ANGLE = {"fov": 0, "pose": 3, "bpose": 3, "velocity_bounds": 6}
"""Properties with angles, and at which of their numbers these begin: the others are lengths."""


def in_units(text: str, metres: float, degrees: float) -> str:
    """A text in metres and degrees, in other units. A property and its numbers stand on one line."""

    def converted(found: re.Match[str]) -> str:
        name, values = found["name"], iter(range(len(found["values"])))
        first_angle = _FIRST_ANGLE.get(name, len(found["values"]))

        def number(each: re.Match[str]) -> str:
            is_angle = next(values) >= first_angle
            return f"{float(each[0]) / (degrees if is_angle else metres):.9g}"

        return found["begin"] + re.sub(r"-?\d+(?:\.\d+)?", number, found["values"])

    names = "|".join({*_LENGTHS, *_FIRST_ANGLE})
    pattern = rf"(?P<begin>\b(?P<name>{names})(?:\[\d+\])?\s+)(?P<values>\[[^\]\n]*\]|-?[\d.]+)"
    return re.sub(pattern, converted, text)


_APART = 0.15
"""Metres between scattered things: three steps, so that Donnie fits between them."""
_AROUND_ROBOTS = 0.3
"""Metres that stay free around a robot's start."""
_TRIES = 500


def scattered(text: str, scene: Scene, path: Path, allowed: tuple[Path, ...], seed: int) -> str:
    """The text with the things in the rectangle of ``scatter`` where the seed puts them."""
    tops = [each.index for each in scene.models if each.parent is None]
    written = dict(zip(tops, written_models(text, path, allowed), strict=True))
    places = _scattered_places(scene, seed)
    found = [(model, places[index]) for index, model in written.items() if model and index in places]
    for model, place in sorted(found, key=lambda each: each[0].begin, reverse=True):
        text = put_elsewhere(text, model, place, units_of(scene))
    return text


def _scattered_places(scene: Scene, seed: int) -> Mapping[int, Placement]:
    """On whole steps, apart from each other and from the robots; what finds no place stays where it is.

    From the first robot a straight way leads to each, with room for its body.
    """
    from random import Random  # loaded where there is chance

    area = scene.settings["scatter"]
    assert isinstance(area, tuple)
    corners = [float(str(each)) for each in area]
    (west, east), (south, north) = sorted(corners[::2]), sorted(corners[1::2])
    chance = Random(f"scatter {seed}")
    robots = [scene.models[each] for each in scene.robots]
    taken = [(each.pose.x, each.pose.y, _half(each) + _AROUND_ROBOTS) for each in robots]
    places = dict[int, Placement]()
    for model in scene.models:
        here = model.pose
        is_thing = model.parent is None and model.index not in scene.robots and model.kind != "wall"
        if not is_thing or not (west <= here.x <= east and south <= here.y <= north):
            continue
        half = _half(model)
        for _ in range(_TRIES):
            x = round(chance.uniform(west + half, east - half) / STEP) * STEP
            y = round(chance.uniform(south + half, north - half) / STEP) * STEP
            others = taken[len(robots) :]
            if all(hypot(x - ax, y - ay) >= half + room + _APART for ax, ay, room in taken) and not (
                robots and any(_one_behind_the_other((x, y, half), each, robots[0]) for each in others)
            ):
                places[model.index] = Placement(x, y, here.z, here.yaw)
                break
        taken.append((x, y, half))
    return places


_Round = tuple[float, float, float]
"""A place, and half the width of what is there."""


def _one_behind_the_other(mine: _Round, other: _Round, robot: Model) -> bool:
    """Whether the nearer one of two things is in the robot's straight way to the other."""
    x, y = robot.pose.x, robot.pose.y
    (ax, ay, half), (bx, by, _) = sorted((mine, other), key=lambda each: hypot(each[0] - x, each[1] - y))
    away = hypot(bx - x, by - y) or 1.0
    along = ((ax - x) * (bx - x) + (ay - y) * (by - y)) / away
    aside = abs((ax - x) * (by - y) - (ay - y) * (bx - x)) / away
    return along > 0 and aside < half + _half(robot) + _APART


def _half(model: Model) -> float:
    return max(model.size[:2]) / 2
