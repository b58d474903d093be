"""Furnishes the world of a session by words: its text is changed and loaded again, the session continues.

The text stays its author's but for what was changed, so that saving it loses nothing. What can't be done
raises ``Unusable`` with the reason, and nothing has changed then.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from itertools import chain
from math import hypot
from pathlib import Path, PurePath
from typing import TYPE_CHECKING, TypeAlias

from msgspec.structs import replace

from devices.ports.robot import STEP
from donnie_tui.core.program_files import read_program, write_program
from donnie_tui.core.wording import the_coloured
from donnie_tui.i18n.words import Unusable, Words
from donnie_tui.world.loading import Site, SiteChange, allowed_folders
from donnie_tui.world.things import (
    KINDS,
    WALL,
    WALL_HEIGHT,
    BadDrawing,
    Description,
    description_of,
    means_wall,
    thing_in_words,
    thing_line,
)
from language.source import fold_name
from language.suggestions import nearest
from sim.geometry import Placement, Point, contains, overlapping
from sim.parts import Part, parts_of
from sim.picture import Thing, is_wall, picture
from sim.scene import Model, Scene, moved

if TYPE_CHECKING:
    from sim.world import World
    from sim.worldfile import WrittenModel

Box: TypeAlias = tuple[float, float, float, float]
"""West, south, east, north."""
MOST_STEPS = 1000
_FARTHEST: Box = (-MOST_STEPS, -MOST_STEPS, MOST_STEPS, MOST_STEPS)
"""Where something may stand on a floor without walls."""
_SHRINK, _MOST_SHRUNK = 0.03, 0.005
"""By how much what is put is taken smaller than it is: part of its size, and metres."""
_THIN = 0.01
"""Steps: the width of a look for walls."""
_MOST_NAMES = 8
"""Names that a sentence lists."""


class Building:
    """Changes the world of a session."""

    def __init__(
        self, site: Site, shared: World, folders: tuple[str, ...], words: Words, program: str = ""
    ) -> None:
        """``folders``: those from which the world may include files. ``program``: its text now."""
        self._program = program
        self._site, self._shared, self._words = site, shared, words
        self._allowed = allowed_folders(folders)

    # --- what is there

    def things(self) -> tuple[Thing, ...]:
        """All but robots, where they are now; walls last."""
        scene = self._shared.scene_now()
        seen = tuple(each for each in picture(scene).things if not each.is_robot)
        return (*seen, *(_wall(each) for each in scene.models if each.parent is None and each.kind == WALL))

    def find(self, typed: str) -> Thing:
        """The one thing that a name, or a kind and a colour, means. Raises ``Unusable``."""
        words, folded = self._words, fold_name(typed).strip()
        if any(folded == fold_name(name) for name in self._site.world.scene.robot_names):
            raise Unusable(words("built-robot", name=typed.strip()))
        things, found = self.things(), self._named(typed)
        found = found if len(found) == 1 else [each for each in things if _is_meant(each, typed)] or found
        if len(found) == 1:
            return found[0]
        if found and found[0].kind == WALL:
            raise Unusable(words("built-which-wall", count=len(found)))
        if found:
            places = (f"{each.name or each.kind}: {round(each.x)}, {round(each.y)}" for each in found)
            listed = "; ".join([*places][:_MOST_NAMES])
            raise Unusable(words("built-which", count=len(found), names=listed))
        near = nearest(typed, [each.name for each in things])
        raise Unusable(words("built-unknown-near" if near else "built-unknown", name=typed[:40], near=near))

    def is_named(self, typed: str) -> bool:
        """Whether a thing has exactly that name."""
        return bool(self._named(typed))

    def _named(self, typed: str) -> list[Thing]:
        names = ((each, (each.name, thing_in_words(each, self._words))) for each in self.things())
        return [each for each, known in names if fold_name(typed).strip() in map(fold_name, known)]

    # --- changes; each returns the thing as it is afterwards

    def put(self, described: Description, x: int, y: int) -> Thing | None:
        """A new thing, its middle at a place in steps."""
        kind, colour = described.kind, next(iter(described.colours), "")
        return self._added(kind, described.name, (x * STEP, y * STEP, 0.0), colour=colour)

    def put_wall(self, corners: Sequence[int], name: str) -> Thing | None:
        """A wall on all squares from one to another: east and north of each, in steps."""
        (left, right), (bottom, top) = sorted(corners[::2]), sorted(corners[1::2])
        self._refuse_outside((left, bottom, right, top), _FARTHEST)
        width, depth = (right - left + 1) * STEP, (top - bottom + 1) * STEP
        pose = ((left + right) / 2 * STEP, (bottom + top) / 2 * STEP, 0.0)
        return self._added(WALL, name, pose, f"size [ {width:.6g} {depth:.6g} {WALL_HEIGHT:g} ]")

    def _added(
        self, kind: str, wanted: str, pose: tuple[float, float, float], size: str = "", colour: str = ""
    ) -> Thing | None:
        """With the wanted name, else its kind and a number that is free. Raises ``Unusable``."""
        taken = {fold_name(each.name) for each in self._site.world.scene.models if each.parent is None}
        if wanted and fold_name(wanted) in taken:
            raise Unusable(self._words("built-name-there", name=wanted))
        plain, text = kind.replace("_", " "), self._source().rstrip("\n")
        names = (plain, *(f"{plain} {number}" for number in range(2, len(taken) + 3)))
        name = wanted or next(each for each in names if fold_name(each) not in taken)
        line = thing_line(kind, colour, name, pose, size)
        return self._changed(f"{text}\n{self._include(kind, text)}{line}\n")

    def remove(self, thing: Thing) -> None:
        from sim.worldfile import taken_out

        text = self._source()
        self._changed(taken_out(text, self._written(thing, text)), gone=thing.index)

    def move(self, thing: Thing, east: float = 0, north: float = 0, degrees: int = 0) -> Thing | None:
        """So many steps from where it is, and turned to the right."""
        from sim.worldfile import put_elsewhere

        text, here = self._source(), self._shared.scene_now().models[thing.index].pose
        yaw = (here.yaw - degrees) % 360.0 if degrees else here.yaw
        place = Placement(here.x + east * STEP, here.y + north * STEP, here.z, yaw)
        return self._changed(put_elsewhere(text, self._written(thing, text), place), moved_thing=thing.index)

    # --- the text

    @property
    def _file(self) -> Path:
        return Path(self._site.world.path)

    def _source(self) -> str:
        """The world's text as it is now."""
        return self._site.text or read_program(self._file)

    def _written(self, thing: Thing, text: str) -> WrittenModel:
        from sim.worldfile import written_models

        tops = _tops(self._site.world.scene)
        found = written_models(text, self._file, self._allowed)[tops.index(thing.index)]
        if found is None:
            raise Unusable(self._words("built-included", thing=thing_in_words(thing, self._words)))
        return found

    def _include(self, kind: str, text: str) -> str:
        """The line that a world needs for its first thing of a kind; empty where it knows the kind."""
        file = next((each for each, known in KINDS.items() if kind in known), "things.inc")
        files = {PurePath(each).name for each in self._site.world.scene.report.files}
        is_known = file in files or re.search(rf"^\s*define\s+{kind}\s", text, re.MULTILINE)
        return "" if is_known or f'include "{file}"' in text else f'include "{file}"\n'

    def _changed(self, text: str, *, moved_thing: int | None = None, gone: int | None = None) -> Thing | None:
        """Load the text and go on in its scene if the change has room there. Without an index it is new."""
        before, scene = self._site.world.scene, self._loaded(text, self._file)
        kept, new_tops = [each for each in _tops(before) if each != gone], _tops(scene)
        index_of = dict(zip(kept, new_tops, strict=False))
        is_new = moved_thing is None and gone is None
        if scene.robot_names != before.robot_names or len(new_tops) != len(kept) + is_new:
            raise Unusable(self._words("built-impossible"))
        changed = new_tops[-1] if is_new else None if moved_thing is None else index_of[moved_thing]
        if changed is not None:
            self._check_room(scene, index_of, changed)
        site, back = self._site, {new: old for old, new in index_of.items()}
        thing = gone if moved_thing is None else moved_thing
        site.past.append(SiteChange(site.world, site.text, site.is_saved, back, thing, self._program))
        site.undone.clear()
        self._shared.rebuild(scene, index_of)
        site.world = replace(site.world, scene=scene, is_rebuilt=True)
        site.text, site.is_saved = text, False
        return self._thing_at(changed)

    def _loaded(self, text: str, file: Path) -> Scene:
        """As a world of that file. Raises ``Unusable``."""
        from donnie_tui.i18n.mistakes import world_mistake
        from sim.worldfile import WorldError, load_text

        try:
            return load_text(text, file, allowed=self._allowed)
        except WorldError as error:
            raise Unusable(world_mistake(error, self._words)) from None

    def _thing_at(self, index: int | None) -> Thing | None:
        return next((each for each in self.things() if each.index == index), None)

    def step(self, changes: list[SiteChange], opposite: list[SiteChange]) -> tuple[str, Thing | None]:
        """Undo the last of the changes, so that it is one of ``opposite``: the code of a sentence, the thing.

        Raises ``Unusable`` where something stands at its place now.
        """
        site, change = self._site, changes[-1]
        scene, now = change.world.scene, site.world.scene
        back = {there: here for here, there in change.index_of.items()}
        if change.changed is None:
            code = "built-removed"
            here: int | None = next(each for each in _tops(now) if each not in change.index_of)
            thing = self._thing_at(here)
        else:
            here = back.get(change.changed)
            code = "built-put" if here is None else "built-moved"
            self._check_room(scene, change.index_of, change.changed)
        self._shared.rebuild(scene, change.index_of)
        changes.pop()
        opposite.append(SiteChange(site.world, site.text, site.is_saved, back, here, change.program))
        site.world, site.text, site.is_saved = change.world, change.text, change.is_saved
        return code, thing if change.changed is None else self._thing_at(change.changed)

    def save(self, target: Path) -> None:
        """Write the world. Raises ``Unusable`` where it could not be loaded there, or ``DocumentError``."""
        text = self._source()
        self._loaded(text, target)
        write_program(target, text)
        self._site.path, self._site.is_saved = target, True
        for changes in (self._site.past, self._site.undone):
            changes[:] = [replace(each, is_saved=False) for each in changes]

    # --- room

    def _check_room(self, scene: Scene, index_of: Mapping[int, int], changed: int) -> None:
        """Raises ``Unusable`` where a thing is outside, or overlaps something."""
        robots, words = dict(zip(scene.robot_names, scene.robots, strict=True)), self._words
        standing = {robots[name]: place for name, place in self._shared.poses().items()}
        now = moved(scene, {**self._shared.places_in(scene, index_of), **standing})
        middles = [(now.models[each].pose.x, now.models[each].pose.y) for each in scene.robots]
        solid = [part for part in parts_of(now) if part.root == changed and part.solid]
        self._check_outside(now, solid, changed)
        mine = [_shrunk(part) for part in solid]
        is_new_wall = scene.models[changed].kind == WALL
        for part in parts_of(now):
            is_floor = any(contains(part.points, *middle) for middle in middles)
            is_floor |= is_new_wall and scene.models[part.root].kind == WALL  # walls meet in corners
            is_other = part.root != changed and part.solid and (part.root in scene.robots or not is_floor)
            if is_other and any(overlapping(each, part.points) for each in mine):
                raise Unusable(self._in_the_way(now, part.root))
        for part in parts_of(scene):
            if part.root in scene.robots and any(overlapping(each, part.points) for each in mine):
                name = scene.models[part.root].spoken_name
                raise Unusable(words("built-over-start", name=name))

    def _in_the_way(self, scene: Scene, root: int) -> str:
        model, words = scene.models[root], self._words
        if root in scene.robots:
            return words("built-over-robot", name=model.spoken_name)
        if is_wall(model, scene.models[scene.robots[0]]):
            return words("built-over-wall")
        name = "" if ":" in model.spoken_name else model.spoken_name
        thing = the_coloured(model.kind, name, model.colour.family or "", words)
        return words("built-over-thing", thing=thing)

    def _check_outside(self, scene: Scene, mine: list[Part], changed: int) -> None:
        if scene.models[changed].kind == WALL:
            return
        outlines = picture(scene).walls
        walls = [*chain(*outlines)] if _is_closed(scene, outlines) else []
        points = [(x / STEP, y / STEP) for part in mine for x, y in part.points]
        points = points or [(scene.models[changed].pose.x / STEP, scene.models[changed].pose.y / STEP)]
        self._refuse_outside(_box(points), _box(walls) if walls else _FARTHEST)

    def _refuse_outside(self, mine: Box, limits: Box) -> None:
        (west, south, east, north), (left, bottom, right, top) = mine, limits
        if west < left or south < bottom or east > right or north > top:
            names = ("left", "bottom", "right", "top")
            raise Unusable(self._words("built-outside", **dict(zip(names, map(round, limits), strict=True))))


def _tops(scene: Scene) -> list[int]:
    """The indices of the models that are no part of another one."""
    return [each.index for each in scene.models if each.parent is None]


def _wall(model: Model) -> Thing:
    west, south, east, north = (each / STEP for each in _box(chain(*model.outlines())))
    name, middle = "" if ":" in model.name else model.name, ((west + east) / 2, (south + north) / 2)
    return Thing(name, WALL, "#", "", *middle, east - west, north - south, index=model.index)


def _is_closed(scene: Scene, walls: Iterable[Sequence[Point]]) -> bool:
    """Whether there are walls on all sides of each robot's start; else the floor has no end."""
    for each in scene.robots:
        x, y = scene.models[each].pose.x / STEP, scene.models[each].pose.y / STEP
        for dx, dy in ((0, 1), (1, 0), (0, -1), (-1, 0)):
            far_x, far_y = x + MOST_STEPS * dx, y + MOST_STEPS * dy
            way = ((x, y), (far_x, far_y), (far_x + _THIN * dy, far_y + _THIN * dx))
            if not any(overlapping(way, outline) for outline in walls):
                return False
    return True


def _shrunk(part: Part) -> tuple[Point, ...]:
    """Its outline, a little smaller: what stands on the squares of the floor often has borders in common."""
    x, y = part.middle
    less = (
        (px - x, py - y, 1 - min(_SHRINK, _MOST_SHRUNK / hypot(px - x, py - y))) for px, py in part.points
    )
    return tuple((x + dx * size, y + dy * size) for dx, dy, size in less)


def _is_meant(thing: Thing, typed: str) -> bool:
    """Whether a kind, perhaps with a colour, means it; of a wall also a square: wall 4 6."""
    if thing.kind == WALL:
        word, _, place = typed.strip().partition(" ")
        square = re.fullmatch(r"(-?\d+),? (-?\d+)", place.strip())
        if square is None or not means_wall(word):
            return means_wall(typed)
        return (
            abs(int(square[1]) - thing.x) <= thing.width / 2
            and abs(int(square[2]) - thing.y) <= thing.depth / 2
        )
    try:
        described = description_of(typed)
    except BadDrawing:
        return fold_name(thing.kind) == fold_name(typed).strip()
    is_colour = not described.colours or thing.colour in described.colours
    return thing.kind == described.kind and is_colour and not described.name


def _box(points: Iterable[tuple[float, float]]) -> Box:
    xs, ys = zip(*points, strict=True)
    return min(xs), min(ys), max(xs), max(ys)
