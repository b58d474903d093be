"""Furnishes the world of a session by words: its text is changed and loaded again, the session continues.

The text stays its author's but for what was changed, so that saving it loses nothing. What can't be done
raises ``Unusable`` with the reason, and nothing has changed then.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from itertools import chain
from pathlib import Path, PurePath
from typing import TYPE_CHECKING, TypeAlias

from msgspec.structs import replace

from devices.ports.robot import STEP, Pose
from donnie_tui.core.describe import has_way_out
from donnie_tui.core.program_files import read_program, write_program
from donnie_tui.core.wording import the_coloured
from donnie_tui.i18n.words import Unusable, Words
from donnie_tui.world import things
from donnie_tui.world.loading import Site, SiteChange, allowed_folders, scene_of
from language.source import fold_name
from language.suggestions import nearest
from sim.geometry import Placement, Point, contains, overlapping
from sim.parts import Part, parts_of
from sim.picture import Thing, is_wall, picture
from sim.scene import Model, Scene, moved

if TYPE_CHECKING:
    from sim.world import World
    from sim.worldfile import WrittenModel

Changed: TypeAlias = tuple[str, Thing]
"""What happened, as the code of a sentence, and the thing as it is afterwards; or was, if it is gone."""
MOST_STEPS = 1000
"""From 0 0: where something may stand on a floor without end."""
_SHRINK, _MOST_SHRUNK = 0.03, 0.005
"""By how much what is put is taken smaller than it is: part of its size, and metres."""
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

    def everything(self) -> tuple[Thing, ...]:
        """All but robots, where they are now; walls last."""
        scene = self._shared.scene_now()
        seen = tuple(each for each in picture(scene).things if not each.is_robot)
        return (
            *seen,
            *(_boxed(each) for each in scene.models if each.parent is None and each.kind == things.WALL),
        )

    def find(self, typed: str) -> Thing:
        """The one thing that a name, or a kind and a colour, means. Raises ``Unusable``."""
        words = self._words
        if any(fold_name(typed) == fold_name(name) for name in self._site.world.scene.robot_names):
            raise Unusable(words("built-robot", name=typed))
        named = self.named(typed)
        found = named if len(named) == 1 else self._meant(typed) or named
        if len(found) == 1:
            return found[0]
        if found and found[0].kind == things.WALL:
            raise Unusable(words("built-which-wall", count=len(found)))
        if found:
            places = [f"{each.name or each.kind}: {round(each.x)}, {round(each.y)}" for each in found]
            raise Unusable(words("built-which", count=len(found), names="; ".join(places[:_MOST_NAMES])))
        near = nearest(typed, [each.name for each in self.everything()]) or things.near_word(typed, words)
        raise Unusable(words("built-unknown-near" if near else "built-unknown", name=typed[:40], near=near))

    def named(self, typed: str) -> list[Thing]:
        """Those with exactly that name, or called so where they are listed."""
        names = ((each, (each.name, things.thing_in_words(each, self._words))) for each in self.everything())
        return [each for each, known in names if fold_name(typed) in map(fold_name, known)]

    def _meant(self, typed: str) -> list[Thing]:
        """Those of a kind, perhaps of a colour, perhaps on a square: red box, wall 4 6."""
        square = re.search(r"\s(-?\d{1,9}),?\s+(-?\d{1,9})$", typed)
        what = typed[: square.start()] if square else typed
        try:
            described = things.description_of(what, self._words)
        except things.BadDescription:  # of a kind of the author's
            described = things.Description(fold_name(what))
        found = [each for each in self.everything() if fold_name(each.kind) == described.kind]
        if described.colours:
            found = [each for each in found if each.colour in described.colours]
        return [each for each in found if _covers(each, *map(int, square.groups()))] if square else found

    # --- changes

    def put(self, described: things.Description, name: str, place: Sequence[int]) -> Changed:
        """A new thing, its middle at a place in steps; a wall on all squares from one place to another."""
        kind, text = described.kind, self._source().rstrip("\n")
        (x, width), (y, depth) = (
            ((min(each) + max(each)) / 2 * STEP, (max(each) - min(each) + 1) * STEP)
            for each in (place[::2], place[1::2])
        )
        size = (width, depth, things.WALL_HEIGHT) if kind == things.WALL else ()
        self._check_outside([(x, y)], kind == things.WALL)
        taken = {fold_name(each.name) for each in self._site.world.scene.models if each.parent is None}
        if name and fold_name(name) in taken:
            raise Unusable(self._words("built-name-there", name=name))
        plain = kind.replace("_", " ")
        names = (name or plain, *(f"{plain} {number}" for number in range(2, len(taken) + 3)))
        name = next(each for each in names if fold_name(each) not in taken)
        colour = next(iter(described.colours), "")
        line = things.model_line(kind, (x, y, 0), name, size, colour)
        return self._changed(f"{text}\n{self._include(kind, text)}{line}\n", None)

    def remove(self, thing: Thing) -> Changed:
        from sim.worldfile import taken_out

        text = self._source()
        return self._changed(taken_out(text, self._written(thing, text)), thing.index, is_gone=True)

    def move(self, thing: Thing, east: float = 0, north: float = 0, degrees: int = 0) -> Changed:
        """So many steps from where it is, and turned to the right."""
        from sim.worldfile import put_elsewhere

        text, here = self._source(), self._shared.scene_now().models[thing.index].pose
        yaw = (here.yaw - degrees) % 360.0 if degrees else here.yaw
        place = Placement(here.x + east * STEP, here.y + north * STEP, here.z, yaw)
        self._check_outside([(place.x, place.y)], thing.kind == things.WALL)
        return self._changed(put_elsewhere(text, self._written(thing, text), place), thing.index)

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
            raise Unusable(self._words("built-included", thing=things.thing_in_words(thing, self._words)))
        return found

    def _include(self, kind: str, text: str) -> str:
        """The line that a world needs for its first thing of a kind; empty if it knows the kind."""
        file = things.KINDS[kind]
        files = {PurePath(each).name for each in self._site.world.scene.report.files}
        is_known = file in files or re.search(rf"^\s*define\s+{kind}\s", text, re.MULTILINE)
        return "" if is_known or f'include "{file}"' in text else f'include "{file}"\n'

    def _changed(self, text: str, index: int | None, *, is_gone: bool = False) -> Changed:
        """Load the text and go on in its scene. ``index``: of the thing that changed; None if it is new."""
        site, scene = self._site, scene_of(text, self._file, self._words, self._allowed)
        kept = [each for each in _tops(site.world.scene) if each != index or not is_gone]
        now = _tops(scene)
        index_of = dict(zip(kept, now, strict=False))
        if scene.robot_names != site.world.scene.robot_names or len(now) != len(kept) + (index is None):
            raise Unusable(self._words("built-impossible"))
        changed = now[-1] if index is None else index_of.get(index)
        world = replace(site.world, scene=scene, is_rebuilt=True)
        done = self._go_to(SiteChange(world, text, False, index_of, changed, self._program), site.past)
        site.undone.clear()
        return done

    def step(self, changes: list[SiteChange], opposite: list[SiteChange]) -> Changed:
        """Undo the last of the changes, so that it is one of ``opposite``. Raises ``Unusable``."""
        done = self._go_to(changes[-1], opposite)
        changes.pop()
        return done

    def _go_to(self, change: SiteChange, opposite: list[SiteChange]) -> Changed:
        """Go on in the world of a change if the thing has room there; ``opposite`` gets the way back."""
        site, scene = self._site, change.world.scene
        back = {there: here for here, there in change.index_of.items()}
        if change.changed is None:
            here = next((each for each in _tops(site.world.scene) if each not in change.index_of), None)
        else:
            here = back.get(change.changed)
            self._check_room(change, change.changed)
        before = None if here is None else self._thing_at(here)
        opposite.append(SiteChange(site.world, site.text, site.is_saved, back, here, change.program))
        self._shared.rebuild(scene, change.index_of)
        site.world, site.text, site.is_saved = change.world, change.text, change.is_saved
        if change.changed is None and before is not None:
            return "built-removed", before
        return ("built-moved" if before else "built-put"), self._thing_at(change.changed or 0)

    def save(self, target: Path) -> None:
        """Write the world. Raises ``Unusable`` where it could not be loaded there, or ``DocumentError``."""
        text = self._source()
        scene_of(text, target, self._words, self._allowed)
        write_program(target, text)
        self._site.path, self._site.is_saved = target, True
        for changes in (self._site.past, self._site.undone):
            changes[:] = [replace(each, is_saved=False) for each in changes]

    # --- room

    def _check_room(self, change: SiteChange, index: int) -> None:
        """Raises ``Unusable`` where the thing would be outside, or overlap something."""
        scene = change.world.scene
        robots = dict(zip(scene.robot_names, scene.robots, strict=True))
        standing = {robots[name]: place for name, place in self._shared.poses().items()}
        now = moved(scene, {**self._shared.places_in(scene, change.index_of), **standing})
        parts, is_new_wall = [*parts_of(now)], scene.models[index].kind == things.WALL
        mine = [part for part in parts if part.root == index]
        self._check_outside([point for part in mine for point in part.points], is_new_wall)
        middles = [(now.models[each].pose.x, now.models[each].pose.y) for each in scene.robots]

        def is_floor(part: Part) -> bool:
            """What robots stand on, and where walls meet in corners."""
            is_corner = is_new_wall and scene.models[part.root].kind == things.WALL
            return is_corner or any(contains(part.points, *middle) for middle in middles)

        starts = [part for part in parts_of(scene) if part.root in scene.robots]
        solid = (part for part in parts if part.solid and part.root != index)
        others = [part for part in solid if part.root in scene.robots or not is_floor(part)]
        small = [_shrunk(part) for part in mine if part.solid]
        for part in (*others, *starts):
            if any(overlapping(each, part.points) for each in small):
                raise Unusable(self._in_the_way(now, part.root, is_start=part in starts))

    def _in_the_way(self, scene: Scene, root: int, *, is_start: bool) -> str:
        model, words = scene.models[root], self._words
        if root in scene.robots:
            return words("built-over-start" if is_start else "built-over-robot", name=model.spoken_name)
        if is_wall(model, scene.models[scene.robots[0]]):
            return words("built-over-wall")
        name = "" if ":" in model.spoken_name else model.spoken_name
        thing = the_coloured(model.kind, name, model.colour.family or "", words)
        return words("built-over-thing", thing=thing)

    def _check_outside(self, points: Iterable[Point], is_wall: bool) -> None:
        """Raises ``Unusable`` outside of walls that no robot can leave, and where it is too far."""
        floor = picture(self._shared.scene_now())
        robots = [Pose(each.x / STEP, each.y / STEP, 0.0) for each in self._shared.poses().values()]
        left, bottom, right, top = -MOST_STEPS, -MOST_STEPS, MOST_STEPS, MOST_STEPS
        if not is_wall and not any(has_way_out(floor, each) for each in robots):
            left, bottom = floor.left, floor.bottom
            right, top = left + (floor.width - 1) * floor.cell, bottom + (floor.height - 1) * floor.cell
        border = floor.cell / 2 + 0.01
        xs, ys = zip(*((x / STEP, y / STEP) for x, y in points), strict=True)
        is_inside = left - border <= min(xs) and max(xs) <= right + border
        if not is_inside or min(ys) < bottom - border or max(ys) > top + border:
            raise Unusable(self._words("built-outside", left=left, right=right, bottom=bottom, top=top))

    def _thing_at(self, index: int) -> Thing:
        seen = (each for each in self.everything() if each.index == index)
        return next(seen, None) or _boxed(self._shared.scene_now().models[index])


def _tops(scene: Scene) -> list[int]:
    """The indices of the models that are no part of another one."""
    return [each.index for each in scene.models if each.parent is None]


def _covers(thing: Thing, x: int, y: int) -> bool:
    return abs(x - thing.x) <= thing.width / 2 and abs(y - thing.y) <= thing.depth / 2


def _boxed(model: Model) -> Thing:
    """What maps show as a wall, as a thing; walls have no colour."""
    xs, ys = ([each / STEP for each in side] for side in zip(*chain(*model.outlines()), strict=True))
    name = "" if ":" in model.name else model.name
    colour = "" if model.kind == things.WALL else model.colour.family
    middle, sides = ((min(xs) + max(xs)) / 2, (min(ys) + max(ys)) / 2), (max(xs) - min(xs), max(ys) - min(ys))
    return Thing(name, model.kind, "#", colour, *middle, *sides, index=model.index)


def _shrunk(part: Part) -> tuple[Point, ...]:
    """Its outline, a little smaller: what stands on the squares of the floor often has borders in common."""
    (x, y), size = part.middle, 1 - min(_SHRINK, _MOST_SHRUNK / part.reach)
    return tuple((x + (px - x) * size, y + (py - y) * size) for px, py in part.points)
