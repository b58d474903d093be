"""Things in words, as a legend or PUT has them: ``chair green AS throne``; and worlds furnished by them.

Words of all languages are understood. A world is furnished by changing its text, which is loaded again while
the session continues. The text stays its author's but for what was changed, so that saving it loses nothing.
What can't be done raises ``Unusable`` with the reason, and nothing has changed then. Lengths in world files
are metres, angles degrees counter-clockwise.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from functools import cache
from pathlib import Path, PurePath
from typing import TYPE_CHECKING, TypeAlias
from unicodedata import normalize

from msgspec import Struct
from msgspec.structs import replace

from devices.ports.robot import STEP
from donnie_tui.core.describe import has_way_out
from donnie_tui.core.program_files import read_program, write_companion, write_program
from donnie_tui.core.wording import Wording, coloured_thing, meant, noun, the_coloured
from donnie_tui.i18n.words import Unusable, Words
from donnie_tui.process.confinement import open_bytes
from donnie_tui.world.loading import MOST_KNOWN, Site, SiteChange, allowed_folders, include_for, scene_of
from language.keywords import COLOURS
from language.locales import languages
from language.source import fold, fold_name, quoted
from language.suggestions import nearest
from sim.geometry import Placement, Point, contains, overlapping, pose_of
from sim.parts import Part, parts_of
from sim.picture import WALL as WALL_LETTER
from sim.picture import Thing, all_things, is_wall, picture
from sim.scene import Scene, moved

if TYPE_CHECKING:
    from sim.world import World

WALL, WALL_HEIGHT = "wall", 0.24
"""The height is in metres."""
KINDS = {
    **dict.fromkeys(("chair", "table", "small_sofa", "large_sofa"), "furniture.inc"),
    **dict.fromkeys(("box", "ball", "cone", "post", "flower", "stone", "crystal"), "things.inc"),
    **dict.fromkeys(("orange", "carton", "belt"), "juice.inc"),
    WALL: "things.inc",
}
"""What there is, by the words of world files, with the files that define it."""
MOST_STEPS = 1000
"""From 0 0: where something may stand on a floor without end."""
_SHRINK, _MOST_SHRUNK = 0.03, 0.005
"""How much a thing is shrunk to see whether it overlaps others: part of its size, and at most metres."""
Changed: TypeAlias = tuple[str, Thing]
"""What happened, as the code of a sentence, and the thing as it is afterwards; or was, if it is gone."""


class Description(Struct, frozen=True):
    """A thing in words: ``chair green AS throne``."""

    kind: str
    colours: tuple[str, ...] = ()
    marks: Mapping[str, str] = {}
    """The colours by the letters in the midst of things that have them, if they have some."""
    name: str = ""


@cache
def _meanings() -> tuple[Mapping[str, str], Mapping[str, str], re.Pattern[str]]:
    """Kinds and colours by the folded words of all languages, and what finds these and other words."""
    every = [*map(Words, reversed(languages()))]
    kinds = {fold_name(word_for(kind, words)): kind for words in every for kind in reversed(KINDS)}
    kinds |= {kind.replace("_", " "): kind for kind in KINDS}
    ends = [(words, colour, end) for words in every for colour in COLOURS for end in ("", "-f")]
    colours = {fold_name(words(f"colour-{colour}{end}")): colour for words, colour, end in ends}
    known = "|".join(re.escape(each).replace(r"\ ", r"\s+") for each in sorted(kinds, key=len, reverse=True))
    return kinds, colours, re.compile(rf"(?<![^\s,:;.])(?:{known})(?![^\s,:;.])|[^\s,:;.…]+")


def word_for(kind: str, wording: Wording) -> str:
    """A kind in the learner's language; of another author's world its own word."""
    return wording("cell-wall") if kind == WALL else noun(kind, wording) or kind


def thing_in_words(thing: Thing, wording: Wording) -> str:
    """A thing in a list."""
    return name_in_words(thing, wording) if thing.kind == WALL else coloured_thing(thing, wording)


def name_in_words(thing: Thing, wording: Wording) -> str:
    """Its name; without one of its own its kind with its number: "parede 2"."""
    kind = thing.kind.replace("_", " ")
    return re.sub(rf"^{re.escape(kind)}(?=$| \d+$)", word_for(thing.kind, wording), thing.name or kind)


def _as_in(text: str) -> re.Match[str] | None:
    """The word AS, in any language, which a name follows."""
    return next((each for each in re.finditer(r"\S+", text) if meant(each[0], "building") == "as"), None)


def with_numbers(text: str, *counts: int) -> tuple[str, tuple[int, ...]]:
    """The text without the last numbers before AS, and these: as many as the first of ``counts`` there is.

    Numbers before them are part of a name: box 2 1 0.
    """
    as_ = _as_in(text)
    places = [*re.finditer(r"(?<![^\s,])(-?\d{1,7})(?:,\s*|(?!\S))", text[: as_.start()] if as_ else text)]
    count = next((each for each in counts if each <= len(places)), 0)
    numbers = places[len(places) - count :]
    for each in reversed(numbers):
        text = text[: each.start()] + text[each.end() :]
    return " ".join(text.split()), tuple(int(each[1]) for each in numbers)


def name_in(text: str) -> str:
    """A name as world files have it, which know no escapes."""
    return "".join(each for each in text if each.isprintable() and each not in '"\\')[:60].strip(" .")


def description_of(text: str, wording: Wording) -> tuple[Description, Mapping[int, str]]:
    """What a thing is, or, by their places in the text, the sentences about all words that mean nothing.

    A word that is a colour too, such as orange, is the kind only if nothing else is.
    """
    kinds, colours, pattern = _meanings()
    text = normalize("NFC", text)
    as_ = _as_in(text)
    what, name = (text[: as_.start()], name_in(text[as_.end() :])) if as_ else (text, "")
    found = [*pattern.finditer(fold(what).replace("_", " "))]
    phrases = [fold_name(" ".join(each[0].split())) for each in found] + [""]
    of_kinds = sorted((phrase in colours, at) for at, phrase in enumerate(phrases) if phrase in kinds)
    kind = of_kinds[0][1] if of_kinds else len(found)
    shades, marks, mistakes = list[str](), list[str](), dict[int, str]()
    for at, each in ((at, each) for at, each in enumerate(found) if at != kind):
        typed, phrase = what[each.start() : each.end()], phrases[at]
        if phrase in colours:
            shades.append(colours[phrase])
        elif len(typed) == 1 and typed.isalpha() and at > kind and phrases[at + 1] in colours:
            marks.append(typed)
        else:
            near = near_word(typed, wording)
            code = "drawing-second" if phrase in kinds else "drawing-word-near" if near else "drawing-word"
            mistakes[each.start()] = wording(code, word=quoted(typed), near=near)
    if as_ and not name[:1].isalpha():
        mistakes[as_.start()] = wording("built-bad-name")
    if not of_kinds and not mistakes:
        known = ", ".join(word_for(each, wording) for each in KINDS if each != WALL)
        mistakes[0] = wording("drawing-no-kind", known=known)
    if mistakes:
        return Description(""), mistakes
    marked = dict(zip(marks, shades, strict=True)) if len(marks) == len(shades) else {}
    return Description(kinds[phrases[kind]], () if "…" in what else tuple(shades), marked, name), {}


def near_word(word: str, wording: Wording) -> str | None:
    """The kind or colour that was probably meant, in the learner's language; a part of its words is near."""
    kinds = [word_for(each, wording) for each in KINDS]
    colours = [wording(f"colour-{each}{end}") for each in COLOURS for end in ("", "-f")]
    meant = {part: each for each in (*colours, *kinds[::-1]) for part in (*each.split(), each)}
    return meant.get(nearest(word, meant) or "")


# --- a world file


def model_line(
    kind: str, pose: tuple[float, float, float], name: str = "", size: Sequence[float] = (), colour: str = ""
) -> str:
    """A thing, wall or robot as a world file has it."""
    x, y, angle = pose
    sides = " ".join(f"{each:.6g}" for each in size)
    parts = (f'name "{name}"', f"pose [ {x:g} {y:g} 0 {angle:g} ]", f"size [ {sides} ]", f'color "{colour}"')
    given = (part for part, is_given in zip(parts, (name, True, size, colour), strict=True) if is_given)
    return f"{kind}( {' '.join(given)} )"


def world_text(*sections: Sequence[str]) -> str:
    """A world file of these lines, which knows all kinds of things."""
    includes = "\n".join(f'include "{each}"' for each in dict.fromkeys(("donnie.inc", *KINDS.values())))
    parts = ("# A step is 0.05 m.", includes, "resolution 0.02", *map("\n".join, sections))
    return "\n\n".join(filter(None, parts)) + "\n"


# --- a world of a session


class Building:
    """Changes the world of a session."""

    def __init__(
        self, site: Site, shared: World, folders: tuple[str, ...], words: Words, program: str = ""
    ) -> None:
        """``folders``: those from which the world may include files. ``program``: its text now."""
        self._program = program
        self._site, self._shared, self._words = site, shared, words
        self._file, self._allowed = Path(site.world.path), allowed_folders(folders)
        if not site.text:
            site.text = site.first_text = site.saved_text = read_program(self._file)

    # --- what is there

    def _everything(self) -> list[Thing]:
        """All things where they are now, except robots, and what only the map shows as walls."""
        shown = all_things(self._shared.scene_now())
        return [it for it in shown if not it.is_robot and (it.letter != WALL_LETTER or it.kind == WALL)]

    def find(self, typed: str) -> Thing:
        """The one thing that a name, or a kind and a colour, means. Raises ``Unusable``."""
        words = self._words
        if fold_name(typed) in map(fold_name, self._site.world.scene.robot_names):
            raise Unusable(words("built-robot", name=typed))
        named = self.named(typed)
        found = named if len(named) == 1 else self._meant(typed) or named
        if len(found) == 1:
            return found[0]
        names = [name_in_words(each, words) for each in self._everything()]
        near = nearest(typed, names) or near_word(typed, words)
        code = "which" if found else "unknown-near" if near else "unknown"
        code = "which-wall" if found and found[0].kind == WALL else code
        places = [f"{name_in_words(it, words)}: {round(it.x)}, {round(it.y)}" for it in found]
        values = {"name": quoted(typed), "near": near, "names": "; ".join(places[:MOST_KNOWN])}
        raise Unusable(words(f"built-{code}", count=len(found), **values))

    def named(self, typed: str) -> list[Thing]:
        """Those with exactly that name, or called so where they are listed."""
        in_words = (lambda it, _: it.name, name_in_words, thing_in_words)
        names = ((each, [name(each, self._words) for name in in_words]) for each in self._everything())
        return [each for each, known in names if fold_name(typed) in map(fold_name, known)]

    def _meant(self, typed: str) -> list[Thing]:
        """Those of a kind, perhaps of a colour, perhaps on a square: red box, wall 4 6."""
        what, square = with_numbers(typed, 2)
        described, mistakes = description_of(what, self._words)
        if mistakes:  # of a kind of the author's
            described = Description(fold_name(what))
        found = [each for each in self._everything() if fold_name(each.kind) == described.kind]
        found = [each for each in found if not described.colours or each.colour in described.colours]
        return [each for each in found if not square or _covers(each, *square)]

    # --- changes

    def put(self, described: Description, place: Sequence[int]) -> Changed:
        """A new thing, its middle at a place in steps; a wall on all squares from one place to another."""
        kind, scene, is_wall = described.kind, self._site.world.scene, described.kind == WALL
        sides = [(min(each), max(each) + 1) for each in (place[::2], place[1::2])]
        x, y = ((low + high - 1) / 2 * STEP for low, high in sides)
        self._check_outside([(x, y)], is_wall)
        size = (*((high - low) * STEP for low, high in sides), WALL_HEIGHT) if is_wall else ()
        taken = {fold_name(each.name) for each in scene.models if each.parent is None}
        plain = kind.replace("_", " ")
        numbered = (plain, *(f"{plain} {number}" for number in range(2, len(taken) + 3)))
        names = (described.name,) if described.name else numbered
        name = next((each for each in names if fold_name(each) not in taken), "")
        if not name:
            raise Unusable(self._words("built-name-there", name=described.name))
        from sim.worldfile import in_units, units_of  # loads the parser

        line = model_line(kind, (x, y, 0), name, size, next(iter(described.colours), ""))
        text, line = self._site.text.rstrip("\n"), in_units(line, *units_of(scene))
        return self._changed(f"{text}\n{self._include(kind)}{line}\n", len(_tops(scene)))

    def remove(self, thing: Thing) -> Changed:
        return self._edit(thing, None)

    def move(self, thing: Thing, east: float = 0, north: float = 0, degrees: int = 0) -> Changed:
        """So many steps from where it is, and turned to the right."""
        here = self._shared.scene_now().models[thing.index].pose
        yaw = (here.yaw - degrees) % 360.0 if degrees else here.yaw
        place = Placement(here.x + east * STEP, here.y + north * STEP, here.z, yaw)
        self._check_outside([(place.x, place.y)], thing.kind == WALL)
        return self._edit(thing, place)

    # --- the text

    def _edit(self, thing: Thing, place: Placement | None) -> Changed:
        """Put it there, or take it out."""
        from sim.worldfile import put_elsewhere, taken_out, units_of, written_models  # loads the parser

        text, scene = self._site.text, self._site.world.scene
        number = _tops(scene).index(thing.index)
        written = written_models(text, self._file, self._allowed)[number]
        if written is None:
            raise Unusable(self._words("built-included", thing=thing_in_words(thing, self._words)))
        if place is None:
            return self._changed(taken_out(text, written), number)
        return self._changed(put_elsewhere(text, written, place, units_of(scene)), number)

    def _include(self, kind: str) -> str:
        """The line that a world needs for its first thing of a kind; empty if it knows the kind."""
        file, scene = KINDS[kind], self._site.world.scene
        is_defined = re.search(rf"(?m)^\s*define\s+{kind}\s", self._site.text)
        is_included = file in {PurePath(each).name for each in scene.report.files}
        return "" if is_defined or is_included else f"{include_for(file, scene)}\n"

    def _changed(self, text: str, number: int) -> Changed:
        """Go on in the world of that text. ``number``: of the thing."""
        done = self._go_to(SiteChange(text, number, self._program), self._site.past)
        self._site.undone.clear()
        return done

    def step(self, changes: list[SiteChange], opposite: list[SiteChange]) -> Changed:
        """Undo the last of the changes, so that it is one of ``opposite``. Raises ``Unusable``."""
        done = self._go_to(changes[-1], opposite)
        changes.pop()
        return done

    def _go_to(self, change: SiteChange, opposite: list[SiteChange]) -> Changed:
        """Go on in the world of a change if the thing has room there; ``opposite`` gets the way back."""
        site, at = self._site, change.number
        scene = scene_of(change.text, self._file, self._words, self._allowed)
        here, there = _tops(site.world.scene), _tops(scene)
        is_gone, is_new = len(here) > len(there), len(here) < len(there)
        kept, now = here[:at] + here[at + is_gone :], there[:at] + there[at + is_new :]
        is_other = scene.robot_names != site.world.scene.robot_names or len(kept) != len(now)
        if is_other or at >= max(len(here), len(there)):
            raise Unusable(self._words("built-impossible"))
        index_of = dict(zip(kept, now, strict=True))
        gone = self._thing(here[at]) if is_gone else None
        if gone is None:
            self._check_room(scene, index_of, there[at])
        opposite.append(replace(change, text=self._site.text))
        self._shared.rebuild(scene, index_of)
        site.world = replace(site.world, scene=scene, is_rebuilt=change.text != site.first_text)
        site.text = change.text
        if gone is not None:
            return "built-removed", gone
        return ("built-put" if is_new else "built-moved"), self._thing(there[at])

    def text_at(self, target: Path) -> str:
        """The text of the world in that file. Pictures it could not use there are copied to its folder."""
        from sim.worldfile import WorldError, self_contained

        def copied(picture: Path) -> str:
            with open_bytes(picture) as stream:
                return write_companion(target, picture.suffix, stream.read())

        try:
            return self_contained(self._site.text, self._file, target, self._allowed, copied)
        except (WorldError, OSError):  # of a file that is gone by now
            return self._site.text

    def save(self, target: Path) -> None:
        """Write the world. Raises ``Unusable`` where it could not be loaded there, or ``DocumentError``."""
        text = self.text_at(target)
        scene_of(text, target, self._words, self._allowed)
        write_program(target, text)
        self._site.path, self._site.saved_text = target, self._site.text

    # --- room

    def _check_room(self, scene: Scene, index_of: Mapping[int, int], index: int) -> None:
        """Raises ``Unusable`` where the thing would be outside, or overlap something.

        What robots stand on is not in its way, nor are the other walls in that of a wall.
        """
        standing = {scene.robot(name).index: place for name, place in self._shared.poses().items()}
        now = moved(scene, {**self._shared.places_in(scene, index_of), **standing})
        mine = [part for part in parts_of(now) if part.root == index]
        is_new_wall = scene.models[index].kind == WALL
        self._check_outside([point for part in mine for point in part.points], is_new_wall)
        small = [_shrunk(part) for part in mine if part.solid]
        middles = [(now.models[each].pose.x, now.models[each].pose.y) for each in scene.robots]
        starts = [part for part in parts_of(scene) if part.root in scene.robots]
        for part in (*parts_of(now), *starts):
            model, is_robot = now.models[part.root], part.root in scene.robots
            is_floor = not is_robot and any(contains(part.points, *middle) for middle in middles)
            is_corner = is_new_wall and model.kind == WALL
            is_free = part.root == index or is_floor or is_corner or not part.solid
            if is_free or not any(overlapping(each, part.points) for each in small):
                continue
            kind = "wall" if is_wall(model, now.models[scene.robots[0]]) else "thing"
            kind = "start" if part in starts else "robot" if is_robot else kind
            name = model.called
            thing = the_coloured(model.kind, name, model.colour.family or "", self._words)
            raise Unusable(self._words(f"built-over-{kind}", name=name, thing=thing))

    def _check_outside(self, points: Iterable[Point], is_wall: bool) -> None:
        """Raises ``Unusable`` outside of walls that no robot can leave, and where it is too far."""
        floor, robots = picture(self._shared.scene_now()), map(pose_of, self._shared.poses().values())
        left, bottom, right, top = -MOST_STEPS, -MOST_STEPS, MOST_STEPS, MOST_STEPS
        if not is_wall and not any(has_way_out(floor, each) for each in robots):
            left, bottom = floor.left, floor.bottom
            right, top = left + (floor.width - 1) * floor.cell, bottom + (floor.height - 1) * floor.cell
        xs, ys = zip(*((x / STEP, y / STEP) for x, y in points), strict=True)
        if max(left - min(xs), max(xs) - right, bottom - min(ys), max(ys) - top) > floor.cell / 2 + 0.01:
            raise Unusable(self._words("built-outside", left=left, right=right, bottom=bottom, top=top))

    def _thing(self, index: int) -> Thing:
        return next(each for each in all_things(self._shared.scene_now()) if each.index == index)


def _tops(scene: Scene) -> list[int]:
    """The indices of the models that are no part of another one."""
    return [each.index for each in scene.models if each.parent is None]


def _covers(thing: Thing, x: int, y: int) -> bool:
    return abs(x - thing.x) <= thing.width / 2 and abs(y - thing.y) <= thing.depth / 2


def _shrunk(part: Part) -> tuple[Point, ...]:
    """Its outline, a little smaller: what stands on the squares of the floor often has borders in common."""
    (x, y), size = part.middle, 1 - min(_SHRINK, _MOST_SHRUNK / part.reach)
    return tuple((x + (px - x) * size, y + (py - y) * size) for px, py in part.points)
