"""Loads a world file into a scene: ``load_world`` for a file, ``load_text`` for a text.

A robot that starts inside something is reported as a slip; Stage lets it stand there, and so does Donnie. A
thing without a pose is at 0 0, where the robot usually is. What surrounds a robot without touching it is no
slip.

Every robot gets a unique name that can be typed and spoken. Stage numbers robots without a name and lets two
robots have the same one; here such a robot gets an alias, and ``Model.name`` stays what Stage has.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from unicodedata import combining, normalize

from msgspec.structs import replace

from sim.geometry import overlapping, placed
from sim.parts import Body, Part, body_of, parts_of
from sim.scene import LoadReport, Model, Note, NoteKind, Scene
from sim.worldfile.build import Builder
from sim.worldfile.entities import Expander, FileReader, Placed, Setting
from sim.worldfile.floor_plans import USUAL_RESOLUTION, Plans
from sim.worldfile.values import ValueReader, plain

MOST = 50
"""Robots that are looked at."""


def standing_inside(scene: Scene) -> Iterator[Note]:
    """A remark for each robot and thing of which one begins inside the other."""
    if not scene.robots:
        return
    parts = tuple(part for part in parts_of(scene) if part.solid)
    reported = set[int]()
    for index in scene.robots[:MOST]:
        robot, body = scene.models[index], body_of(scene, index)
        others = (part for part in parts if part.root not in (index, *reported))
        for root in dict.fromkeys(part.root for part in others if _is_in(robot, body, part)):
            details = {"name": robot.spoken_name[:60], "thing": _called(scene.models[root])}
            yield Note(NoteKind.WARNING, "starts-inside", "", 0, 0, details)
        reported.add(index)


def _is_in(robot: Model, body: Body, part: Part) -> bool:
    here, (x, y), reach = robot.pose, part.middle, part.reach + body.radius
    if (x - here.x) ** 2 + (y - here.y) ** 2 > reach * reach:
        return False
    mine = (placed(points, here.x, here.y, here.yaw) for points in body.polygons)
    return any(overlapping(points, part.points) for points in mine)


def _called(model: Model) -> str:
    """In the words of the file: the one that made it, and its name if it has one."""
    name = "" if ":" in model.spoken_name else model.spoken_name
    return (name if name and model.kind in (model.type, *name.split()) else f"{model.kind} {name}").strip()[
        :60
    ]


_UNSPEAKABLE = frozenset(':="\\')
"""Of Stage's numbering, of ``NAME=FILE``, of quoting."""


def with_names(
    models: tuple[Model, ...], robots: Iterable[int]
) -> tuple[tuple[Model, ...], tuple[Note, ...]]:
    """The models with aliases for the robots that need one (``robots`` first), and the notes on them."""
    indices = set(robots)
    wheeled = [model for model in models if model.type == "position" and model.parent is None]
    order = sorted(wheeled, key=lambda model: model.index not in indices)
    numbering = _Numbering({_folded(model.name) for model in order if _is_speakable(model.name)})
    kept, aliases, notes = set[str](), dict[int, str](), list[Note]()
    for model in order:
        speakable = _is_speakable(model.name)
        folded = _folded(model.name)
        if speakable and folded not in kept:
            kept.add(folded)
            continue
        alias = numbering.free(_stem(model), 2 if speakable else 1)
        aliases[model.index] = alias
        if model.index in indices:
            code = "robot-renamed" if speakable else "robot-without-name"
            notes.append(Note(NoteKind.REPAIRED, code, "", 0, 0, {"name": model.name[:60], "alias": alias}))
    named = tuple(
        replace(model, alias=aliases[model.index]) if model.index in aliases else model for model in models
    )
    return named, tuple(notes)


def _is_speakable(name: str) -> bool:
    return bool(name.strip()) and name == name.strip() and name.isprintable() and not _UNSPEAKABLE & set(name)


def _stem(model: Model) -> str:
    if _is_speakable(model.name):
        return model.name
    return model.kind if model.kind != model.type else "robot"


class _Numbering:
    """Unused names. Each stem continues at its last number: a file may have many robots."""

    def __init__(self, taken: set[str]) -> None:
        """``taken`` are folded."""
        self._taken = taken
        self._next: dict[tuple[str, int], int] = {}

    def free(self, stem: str, first: int) -> str:
        """The stem with the lowest number from ``first`` on that is free, which is taken from now on."""
        folded = _folded(stem)
        number = self._next.get((folded, first), first)
        while f"{folded}{number}" in self._taken:
            number += 1
        self._taken.add(f"{folded}{number}")
        self._next[folded, first] = number + 1
        return f"{stem}{number}"


def _folded(name: str) -> str:
    """Equal for names that differ in case and accents only."""
    return "".join(each for each in normalize("NFKD", name.casefold()) if not combining(each))


_SENSES = frozenset({"ranger", "blobfinder"})
_LESSER_SENSES = frozenset({"bumper", "fiducial", "camera", "gripper"})


def load_world(path: Path, *, allowed: tuple[Path, ...] = ()) -> Scene:
    """The scene of the world at ``path``.

    Includes and bitmaps are searched in the folder of the file that names them, then in the world's folder,
    then in the folders ``allowed``; nothing else is read. Raises ``WorldError`` if the world can't be used.
    """
    reader = FileReader(path, allowed)
    return _scene(path.stem, reader, reader.read(path))


def load_text(text: str, path: Path, *, allowed: tuple[Path, ...] = ()) -> Scene:
    """The scene of a world that is not in a file; ``path`` names it in mistakes and is where it would lie."""
    reader = FileReader(path, allowed)
    return _scene(path.stem, reader, reader.statements(text, path, ()))


def _scene(name: str, reader: FileReader, statements: Iterable[Placed]) -> Scene:
    expander, values = Expander(folders=reader.folders), ValueReader()
    entities = expander.expand(statements)
    values.use_units(expander.settings)
    values.check(expander.settings, quiet=True)
    resolution = values.length(expander.settings, "resolution", USUAL_RESOLUTION)
    builder = Builder(values, Plans(reader, values, resolution).plan, expander.settings)
    builder.build(entities)
    robots = _robots(tuple(builder.models))
    models, named = with_names(tuple(builder.models), robots)
    notes = (
        *reader.notes,
        *expander.notes,
        *values.notes,
        *_walls(models),
        *named,
        *_no_robot(reader, robots),
    )
    report = LoadReport(tuple(dict.fromkeys(reader.files)), _counts(models), notes, tuple(reader.pictures))
    scene = Scene(name, models, robots, _plain(expander.settings), report)
    inside = tuple(standing_inside(scene))
    return replace(scene, report=replace(report, notes=(*notes, *inside))) if inside else scene


def _robots(models: tuple[Model, ...]) -> tuple[int, ...]:
    """Position models that see, then those that feel only; those without any sense where no other is."""
    robots: list[int] = []
    for senses in (_SENSES, _LESSER_SENSES):
        sensing = {model.root for model in models if model.type in senses}
        robots += [root for root in sorted(sensing) if models[root].type == "position"]
    bare = (model.index for model in models if model.type == "position" and model.parent is None)
    return tuple(dict.fromkeys(robots or bare))


def _walls(models: tuple[Model, ...]) -> Iterable[Note]:
    for model in models:
        if model.solid and model.obstacle_return == 0:
            yield Note(NoteKind.REPAIRED, "walls-made-solid", "", 0, 0, {"name": model.name})


def _no_robot(reader: FileReader, robots: tuple[int, ...]) -> Iterable[Note]:
    if not robots:
        yield Note(NoteKind.WARNING, "no-robot", next(iter(reader.files), ""), 1, 1)


def _counts(models: tuple[Model, ...]) -> tuple[tuple[str, int], ...]:
    return tuple(Counter(model.type for model in models).most_common())


def _plain(settings: Mapping[str, Setting]) -> Mapping[str, float | str | tuple[object, ...]]:
    return {name: plain(setting.property.value) for name, setting in settings.items()}
