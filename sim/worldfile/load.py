"""A world file becomes a scene. The way in: ``load_world`` for a file, ``load_text`` for a text."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping
from pathlib import Path

from devices.ports.values import replace
from sim.notes import Note, NoteKind
from sim.scene import LoadReport, Model, Scene
from sim.worldfile.beginnings import standing_inside
from sim.worldfile.build import Builder
from sim.worldfile.entities import Expander, Setting
from sim.worldfile.plans import Plans
from sim.worldfile.reader import FileReader, Placed
from sim.worldfile.robot_names import with_names
from sim.worldfile.values import ValueReader, plain

_SENSES = frozenset({"ranger", "blobfinder"})
_LESSER_SENSES = frozenset({"bumper", "fiducial", "camera", "gripper"})


def load_world(path: Path, *, allowed: tuple[Path, ...] = ()) -> Scene:
    """The scene of the world at ``path``.

    Includes and bitmaps are looked for beside the file that names them, then beside the world, then in
    the folders ``allowed``; nothing outside these is read. WorldError if the world can't be used.
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
    builder = Builder(values, Plans(reader, values).plan, expander.settings)
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


def _plain(settings: Mapping[str, Setting]) -> Mapping[str, object]:
    return {name: plain(setting.property.value) for name, setting in settings.items()}
