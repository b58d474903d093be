"""A run as a picture: walls, things at their last places, goals, and the path of each robot.

As SVG and as GIF a ring whose stroke looks ahead drives along each path at the pace of the run. Things that
were pushed or carried move with it. Title and description of the SVG say the path in words, and letters stand
in for colours. As PNG the same picture stands still. Lengths are pixels, places in the world steps; the
northern edge is up. A plot of what was measured is drawn as PNG, too.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from io import BytesIO
from itertools import accumulate, pairwise
from math import cos, radians, sin
from textwrap import wrap
from typing import TYPE_CHECKING
from xml.sax.saxutils import escape

from msgspec import Struct
from msgspec.structs import replace

from devices.ports.robot import Pose
from donnie_tui.core import PAINTED
from donnie_tui.core.map_grid import LEGS_AT_PICTURES, path_in_words
from donnie_tui.core.paper import Box, Nearby, box_of, boxes_apart, from_segment
from donnie_tui.core.timeline import DrivenPath, apart
from donnie_tui.core.wording import (
    Wording,
    colour_initials,
    coloured_thing,
    letters_of_several_colours,
)
from language.source import printable
from sim.geometry import contains, pose_of

if TYPE_CHECKING:
    from PIL.Image import Image
    from PIL.ImageDraw import ImageDraw

    from donnie_tui.core.events import PlacedThing, Stamped
    from donnie_tui.core.reports import Plot
    from donnie_tui.world.loading import ChosenWorld
    from sim.picture import Drawing, Thing
    from sim.scene import Scene
    from worlds.challenges import GoalPlace

_Point = tuple[float, float]

LARGEST = 900.0
"""Pixels that the map is wide or high."""
MARGIN, LETTER, LINE = 24.0, 14.0, 20.0
"""Pixels: around everything, the height of a letter, from line to line of the legend."""
LEAST_GOAL = 10.0
"""Half the width and height of the place of a goal on the picture."""
STEPS_A_SECOND = 10.0
"""The pace of the dot: ten times the robot's."""
MOST_FRAMES = 60
"""Pictures of a GIF."""
FRAME = 0.1
"""Seconds that each is shown, at least."""
LONGEST_FRAME = 655_350
"""Milliseconds that a GIF can show a picture."""
_WALL, _OTHER, _INK = "#444444", "#bbbbbb", "#000000"
_PATHS = ("#7b2cbf", "#006d5b", "#9d0208", "#003049")
"""Dark enough on white for lines (at least 4.5 to 1)."""


def on_swell_paper(
    world: ChosenWorld, things: tuple[PlacedThing, ...], paths: Sequence[Sequence[Pose]], wording: Wording
) -> str:
    """A sheet for swell paper: the world with these things moved, and where robots drove from their starts.

    ``things`` that are not named stand where they did at the start.
    """
    from donnie_tui.core.chart import chart
    from donnie_tui.core.paper import raised_picture
    from donnie_tui.world.loading import moved_to
    from sim.picture import drawings, picture

    scene = moved_to(world.scene, things)
    seen = picture(scene)
    plan = chart(seen, world.start(), next(iter(scene.robot_names), None), wording)
    title = wording("paper-title", name=world.title(wording.language))
    return raised_picture(title, plan, seen, drawings(scene), wording, paths)


class MovedThing(Struct, frozen=True):
    """A thing that was pushed or carried: its number among the world's models, and its timed places.

    Seconds of the moving dots; its start first.
    """

    index: int
    moments: tuple[tuple[float, Pose], ...]

    @property
    def end(self) -> Pose:
        return self.moments[-1][1]

    @property
    def seconds(self) -> float:
        return max(0.1, self.moments[-1][0])

    def at(self, seconds: float) -> Pose:
        """Its pose after that time."""
        for (begin, here), (end, there) in pairwise(self.moments):
            if seconds < end:
                part = max(0.0, seconds - begin) / (end - begin)
                turned = _turned(here, there) * part
                x, y = here.x + (there.x - here.x) * part, here.y + (there.y - here.y) * part
                return Pose(x, y, here.heading + turned)
        return self.end


def _turned(here: Pose, there: Pose) -> float:
    """Degrees to the right, the shorter way round."""
    return (there.heading - here.heading + 180.0) % 360.0 - 180.0


def moved_things(events: Iterable[Stamped], scene: Scene) -> tuple[MovedThing, ...]:
    """The things that have moved. A push moves a thing in the last part of a walk."""
    from donnie_tui.core.events import Driven, Moved, Reset, RunStarted, ThingsMoved, Turned

    poses: dict[str | None, Pose] = {}
    lengths: dict[str | None, tuple[float, float]] = {}
    """Steps that each robot drove since its start, and those of its last movement."""
    now: dict[int, Pose] = {}
    moments: dict[int, list[tuple[float, Pose]]] = {}
    for stamped in events:
        robot = stamped.robot
        match stamped.event:
            case Moved(pose=pose) | Turned(pose=pose) | Driven(pose=pose):
                length = apart(poses.get(robot, pose), pose)
                poses[robot], lengths[robot] = pose, (lengths.get(robot, (0.0, 0.0))[0] + length, length)
            case Reset(pose=pose):
                poses[robot], lengths[robot] = pose, (0.0, 0.0)
            case RunStarted(how=how) if how is not None and (how.begins_anew or robot not in poses):
                poses[robot], lengths[robot] = how.pose, (0.0, 0.0)
            case ThingsMoved(places=places):
                there = {each.index: each.pose for each in places if 0 <= each.index < len(scene.models)}
                end, length = lengths.get(robot, (0.0, 0.0))
                for index in sorted(there.keys() | now.keys()):
                    start = pose_of(scene.models[index].pose)
                    here, after = now.get(index, start), there.get(index, start)
                    if index not in there:
                        moments.pop(index, None)
                    elif here != after:
                        begin = (end - min(length, apart(here, after))) / STEPS_A_SECOND
                        those = moments.setdefault(index, [(0.0, start)])
                        begin = max(begin, those[-1][0])
                        those += [(begin, here), (max(begin, end / STEPS_A_SECOND), after)]
                now = there
    return tuple(MovedThing(index, tuple(those)) for index, those in moments.items())


class ShownGoal(Struct, frozen=True):
    """A place: the numbers of its goals, its middle, and half its width and height."""

    numbers: str
    x: float
    y: float
    across: float
    down: float


class RunPicture(Struct, frozen=True):
    """The content of the picture, its scale, and the edges of the shown part of the world."""

    title: str
    drawings: tuple[Drawing, ...]
    paths: tuple[DrivenPath, ...]
    west: float
    north: float
    scale: float
    """Pixels for a step."""
    width: float
    height: float
    legend: tuple[str, ...]
    """Its lines, as wide as the picture at most."""
    letters: Mapping[int, str]
    """The letters of each thing by its index; a second one is the initial of its colour, if needed."""
    title_lines: tuple[str, ...] = ()
    labels: Mapping[int, _Point] = {}
    """Left end and base line of the letters that have a place, by the index of the thing."""
    marks: tuple[tuple[float, float, str], ...] = ()
    """The names of robots and the numbers of goals that have a place: left end, base line, text."""
    goals: tuple[GoalPlace, ...] = ()
    moved: tuple[MovedThing, ...] = ()
    sentences: tuple[str, ...] = ()
    """Those of the legend."""

    @property
    def moving(self) -> tuple[tuple[Drawing, MovedThing], ...]:
        """The drawings of things that were moved."""
        found = {each.index: each for each in self.moved}
        return tuple(
            (each, found[each.thing.index])
            for each in self.drawings
            if each.thing is not None and each.thing.index in found
        )

    @property
    def standing(self) -> tuple[Drawing, ...]:
        moving = [each for each, _ in self.moving]
        return tuple(each for each in self.drawings if each not in moving)

    @property
    def top(self) -> float:
        """The upper edge of the map."""
        return 2 * MARGIN + LINE * max(0, len(self.title_lines) - 1)

    def at(self, x: float, y: float) -> _Point:
        return (
            round(MARGIN + (x - self.west) * self.scale, 1),
            round(self.top + (self.north - y) * self.scale, 1),
        )


def run_picture(
    title: str,
    drawings: Sequence[Drawing],
    paths: Sequence[DrivenPath],
    wording: Wording,
    goals: Sequence[GoalPlace] = (),
    moved: Sequence[MovedThing] = (),
) -> RunPicture:
    """``drawings``: what stands there at the end. A robot that drove is the arrow of its path."""
    driven = {path.robot for path in paths}
    shown = tuple(
        each
        for each in drawings
        if each.thing is None or not each.thing.is_robot or not {"", each.thing.name} & driven
    )
    points = [point for each in shown for outline in each.outlines for point in outline]
    points += [(pose.x, pose.y) for path in paths for pose in path.poses] or [(0.0, 0.0)]
    points += [(pose.x, pose.y) for each in moved for _, pose in each.moments]
    points += [point for _, west, south, east, north in goals for point in ((west, south), (east, north))]
    xs, ys = zip(*points, strict=True)
    west, east, south, north = min(xs) - 2, max(xs) + 2, min(ys) - 2, max(ys) + 2
    scale = min(LARGEST / (east - west), LARGEST / (north - south), 24.0)
    width = round(max((east - west) * scale, 320) + 2 * MARGIN)
    room = width - 2 * MARGIN
    things = [each.thing for each in shown if each.thing is not None]
    letters = _letters(things, wording)
    bare = RunPicture(
        printable(title),
        shown,
        tuple(paths),
        west,
        north,
        scale,
        width=width,
        height=(north - south) * scale + 3 * MARGIN,
        legend=(),
        letters=letters,
        title_lines=_wrapped(printable(title), room),
        goals=tuple(goals),
        moved=tuple(moved),
    )
    marks, labels = _placed(bare)
    said = list(_legend(things, letters, goals, paths, wording))
    bare_things = sum(each.index not in labels for each in things)
    if bare_things:
        said.append(wording("picture-without-letters", count=bare_things))
    legend = tuple(part for line in said for part in _wrapped(line, room))
    height = round(bare.height + bare.top - 2 * MARGIN + LINE * len(legend))
    return replace(bare, height=height, legend=legend, sentences=tuple(said), labels=labels, marks=marks)


_WIDER = 1.15
"""How much wider a text is at most in the letters of other programs than in those that measure it here."""


def _wide(text: str) -> float:
    from PIL import ImageFont  # slow to load

    return _WIDER * ImageFont.load_default(LETTER).getlength(text)


def _wrapped(text: str, room: float) -> tuple[str, ...]:
    """The text in lines that are at most so wide."""
    most = max(1, int(room / (LETTER * 0.4)))
    while True:
        lines = wrap(text, most)
        widest = max(map(_wide, lines), default=0.0)
        if widest <= room or most == 1:
            return tuple(lines)
        most = max(1, min(most - 1, int(most * room / widest)))


# --- where names and letters have room

_CLEAR = 3.0
"""Pixels between a text and everything else."""
_AWAY = (0.0, 5.0, 11.0)
"""How much further away from its thing a letter may be."""


def _placed(it: RunPicture) -> tuple[tuple[tuple[float, float, str], ...], dict[int, _Point]]:
    """The marks, and the places of the letters of things: those that touch nothing."""
    space = _Space(it)
    marks = list[tuple[float, float, str]]()
    for goal in goals_on(it):
        west, east, wide = goal.x - goal.across, goal.x + goal.across, _wide(goal.numbers)
        away = _CLEAR + 2
        above, below = goal.y - goal.down - away - 0.25 * LETTER, goal.y + goal.down + away + 0.8 * LETTER
        lefts = (west, east - wide, west - wide - away, east + away)
        corners = [(x, y) for y in (above, below) for x in lefts]
        marks += space.put(goal.numbers, corners)
    for path in it.paths:
        x, y = it.at(path.poses[0].x, path.poses[0].y)
        name = printable(path.robot)
        sides = (x + 8, x - 8 - _wide(name), x - _wide(name) / 2)
        places = [
            (side, y + LETTER / 3 + down) for down in (0, -LETTER, LETTER, -2 * LETTER) for side in sides
        ]
        marks += space.put(name, places) if name else ()
    labels = dict[int, _Point]()
    for each in it.drawings:
        if each.thing is not None:
            letters = it.letters[each.thing.index]
            for x, y, _ in space.put(letters, _letter_places(it, each, _wide(letters)), each):
                labels[each.thing.index] = x, y
    return tuple(marks), labels


def _letter_places(it: RunPicture, drawing: Drawing, wide: float) -> Iterable[_Point]:
    """Within the thing, if it is large enough, then around it."""
    west, north, east, south = _pixels(it, drawing)
    x, y = (west + east) / 2, (north + south) / 2
    base = LETTER / 3
    if east - west >= wide + 2 * _CLEAR and south - north >= 1.5 * LETTER:
        yield x - wide / _WIDER / 2, y + base
    for away in _AWAY:
        right, left = east + _CLEAR + 1 + away, west - _CLEAR - 1 - away - wide
        up, down = north - _CLEAR - 1 - away - 0.25 * LETTER, south + _CLEAR + 1 + away + 0.8 * LETTER
        middle = x - wide / _WIDER / 2
        yield from ((right, y + base), (left, y + base), (middle, up), (middle, down))
        yield from ((right, up), (right, down), (left, up), (left, down))


def _pixels(it: RunPicture, drawing: Drawing) -> Box:
    return box_of(it.at(*point) for outline in drawing.outlines for point in outline)


class _Space:
    """What is on the picture already."""

    def __init__(self, it: RunPicture) -> None:
        self._it = it
        self._taken = list[Box]()
        driven = [[it.at(pose.x, pose.y) for pose in piece] for path in it.paths for piece in path.pieces]
        lines = [*driven, *(_closed(arrow(it, path)) for path in it.paths)]
        for goal in goals_on(it):
            west, east = goal.x - goal.across, goal.x + goal.across
            north, south = goal.y - goal.down, goal.y + goal.down
            lines.append(_closed([(west, north), (east, north), (east, south), (west, south)]))
        walls = [
            [it.at(*point) for point in outline]
            for each in it.drawings
            if each.thing is None
            for outline in each.outlines
        ]
        self._lines = Nearby(pair for each in (*lines, *map(_closed, walls)) for pair in pairwise(each))
        self._walls = Nearby(walls)
        self._things = [(each, _pixels(it, each)) for each in it.drawings if each.thing is not None]
        self._starts = [_around(*it.at(path.poses[0].x, path.poses[0].y), 5.0) for path in it.paths]

    def put(
        self, text: str, places: Iterable[_Point], own: Drawing | None = None
    ) -> tuple[tuple[float, float, str], ...]:
        """The text at the first free place; nothing if there is none. ``own``: the thing that it names."""
        wide = _wide(text)
        for left, base in places:
            box = left, base - 0.8 * LETTER, left + wide, base + 0.25 * LETTER
            if self._is_free(box, own):
                self._taken.append(box)
                return ((round(left, 1), round(base, 1), text),)
        return ()

    def _is_free(self, box: Box, own: Drawing | None) -> bool:
        it, middle = self._it, ((box[0] + box[2]) / 2, (box[1] + box[3]) / 2)
        if box[0] < 2 or box[2] > it.width - 2 or box[1] < it.top - MARGIN + 4 or box[3] > self._bottom:
            return False
        if any(boxes_apart(box, each) < _CLEAR for each in (*self._taken, *self._starts)):
            return False
        if own is not None:
            mine = _pixels(it, own)
            nearest = max(boxes_apart(box, mine), 1.0)
            others = (each for drawing, each in self._things if drawing is not own and not _is_on(mine, each))
            if any(boxes_apart(box, each) <= nearest for each in others):
                return False
        reach = _CLEAR + 1.5
        return all(from_segment(box, each) >= reach for each in self._lines.of(box, reach)) and not any(
            contains(wall, *middle) for wall in self._walls.of(box)
        )

    @property
    def _bottom(self) -> float:
        return self._it.top + self._it.height - 3 * MARGIN + MARGIN / 2


def _is_on(mine: Box, other: Box) -> bool:
    """Whether a thing lies on another, such as a carpet."""
    return other[0] <= mine[0] and other[1] <= mine[1] and mine[2] <= other[2] and mine[3] <= other[3]


def _closed(points: Sequence[_Point]) -> list[_Point]:
    return [*points, points[0]]


def _around(x: float, y: float, half: float) -> Box:
    return x - half, y - half, x + half, y + half


def _letters(things: Sequence[Thing], wording: Wording) -> dict[int, str]:
    mixed = letters_of_several_colours(things)
    initials = colour_initials(wording, {each.letter for each in things})
    return {
        each.index: each.letter + (initials.get(each.colour, "") if each.letter in mixed else "")
        for each in things
    }


def _legend(
    things: Iterable[Thing],
    letters: Mapping[int, str],
    goals: Iterable[GoalPlace],
    paths: Iterable[DrivenPath],
    wording: Wording,
) -> Iterable[str]:
    yield wording("paper-north")
    named: dict[str, list[str]] = {}
    for each in things:
        named.setdefault(letters[each.index], []).append(coloured_thing(each, wording))
    for letter, names in sorted(named.items()):
        yield printable(f"{letter}: {'; '.join(dict.fromkeys(names))}")
    yield from (wording("cell-goal", number=number) for number in dict.fromkeys(each[0] for each in goals))
    for path in paths:
        words = " ".join(path_in_words(path, wording, LEGS_AT_PICTURES))
        yield printable(f"{path.robot}: {words}" if path.robot else words)


def as_picture(it: RunPicture, suffix: str) -> bytes:
    """The picture as the file that ends so: ``.svg``, ``.png`` or ``.gif``."""
    if suffix == ".svg":
        return as_svg(it).encode()
    return as_png(it) if suffix == ".png" else as_gif(it)


def goals_on(it: RunPicture) -> Iterable[ShownGoal]:
    """The places of goals on the picture; a place may be that of several."""
    numbers: dict[tuple[float, ...], list[str]] = {}
    for number, *place in it.goals:
        numbers.setdefault(tuple(place), []).append(str(number))
    for (west, south, east, north), those in numbers.items():
        x, y = it.at((west + east) / 2, (south + north) / 2)
        across, down = (east - west) * it.scale / 2, (north - south) * it.scale / 2
        yield ShownGoal(", ".join(those), x, y, max(across, LEAST_GOAL), max(down, LEAST_GOAL))


def as_svg(it: RunPicture) -> str:
    """The picture as SVG; the dots drive once and stop at the end."""
    size = f'width="{it.width:g}" height="{it.height:g}" viewBox="0 0 {it.width:g} {it.height:g}"'
    return "\n".join(
        (
            f'<svg xmlns="http://www.w3.org/2000/svg" role="img" {size}>',
            f"<title>{escape(it.title)}</title>",
            f"<desc>{escape(' '.join(it.legend))}</desc>",
            f'<rect width="{it.width:g}" height="{it.height:g}" fill="white"/>',
            *(_svg_shape(it, each) for each in it.standing),
            *(_svg_goal(each) for each in goals_on(it)),
            *(line for number, path in enumerate(it.paths) for line in _svg_path(it, path, number)),
            *(line for each in it.moving for line in _svg_moving(it, *each)),
            *(_svg_text(*each) for each in texts(it, it.standing)),
            "</svg>\n",
        )
    )


def _svg_moving(it: RunPicture, drawing: Drawing, moved: MovedThing) -> Iterable[str]:
    """The thing with its letter, which slides; the thing alone turns."""
    end, turned, degrees = moved.end, 0.0, [0.0]
    for (_, there), (_, here) in pairwise(reversed(moved.moments)):
        turned += _turned(there, here)
        degrees.append(turned)
    slides = [((pose.x - end.x) * it.scale, (end.y - pose.y) * it.scale) for _, pose in moved.moments]
    x, y = it.at(end.x, end.y)
    yield "<g>"
    times = [at / moved.seconds for at, _ in moved.moments]
    yield _svg_animation("translate", [f"{dx:g} {dy:g}" for dx, dy in slides], times, moved.seconds)
    turns = [f"{each:g} {x:g} {y:g}" for each in reversed(degrees)]
    turning = _svg_animation("rotate", turns, times, moved.seconds) if any(degrees) else ""
    yield _svg_shape(it, drawing, turning)
    yield from (_svg_text(*each) for each in _letter(it, drawing))
    yield "</g>"


def _svg_animation(
    kind: str, values: Sequence[str], times: Sequence[float], seconds: float, more: str = ""
) -> str:
    """``times``: from 0 to 1; the last value is that of the end."""
    moments = ";".join(f"{min(1.0, each):.4f}" for each in times[:-1])
    return (
        f'<animateTransform attributeName="transform" type="{kind}" values="{";".join(values)}"'
        f' keyTimes="{moments};1.0000" dur="{seconds:.1f}s" fill="freeze"{more}/>'
    )


def _svg_shape(it: RunPicture, drawing: Drawing, inside: str = "") -> str:
    fill = _fill(drawing)
    d = " ".join(
        "M " + " L ".join(f"{x:g} {y:g}" for x, y in (it.at(*point) for point in outline)) + " Z"
        for outline in drawing.outlines
    )
    style = f'fill="{fill}" stroke="{_INK}" stroke-width="1"'
    return f'<path d="{d}" {style}>{inside}</path>'


def _svg_goal(goal: ShownGoal) -> str:
    left, top = goal.x - goal.across, goal.y - goal.down
    size = f'width="{2 * goal.across:g}" height="{2 * goal.down:g}"'
    style = f'fill="none" stroke="{_INK}" stroke-width="2" stroke-dasharray="6 3"'
    return f'<rect class="goal" x="{left:g}" y="{top:g}" {size} {style}/>'


def _svg_path(it: RunPicture, path: DrivenPath, number: int) -> Iterable[str]:
    colour = _PATHS[number % len(_PATHS)]
    places = [it.at(pose.x, pose.y) for pose in path.poses]
    (x, y), radius = places[0], max(3.0, 1.3 * it.scale)
    style = f'fill="none" stroke="{colour}" stroke-width="3"'
    for piece in path.pieces:
        points = _svg_points(it.at(pose.x, pose.y) for pose in piece)
        yield from [f'<polyline points="{points}" {style}/>'] if len(piece) > 1 else ()
    yield f'<circle cx="{x:g}" cy="{y:g}" r="4" fill="white" stroke="{colour}" stroke-width="2"/>'
    yield f'<polygon points="{_svg_points(arrow(it, path))}" fill="{colour}"/>'
    lengths = path.lengths
    if lengths[-1] > 0:
        times = [each / lengths[-1] for each in lengths]
        turned = (_turned(*each) for each in pairwise(path.poses))
        headings = [*accumulate(turned, initial=path.poses[0].heading)]
        start = f"translate({x:g} {y:g}) rotate({headings[0]:g})"
        yield f'<g transform="{start}" fill="none" stroke="{colour}" stroke-width="2">'
        yield _svg_animation("translate", [f"{x:g} {y:g}" for x, y in places], times, _seconds(path))
        turns = [f"{each:g}" for each in headings]
        yield _svg_animation("rotate", turns, times, _seconds(path), ' additive="sum"')
        yield f'<circle r="{radius:g}"/><path d="M 0 0 V {-radius:g}"/>'
        yield "</g>"


def _svg_points(points: Iterable[_Point]) -> str:
    return " ".join(f"{x:g},{y:g}" for x, y in points)


def _svg_text(x: float, y: float, text: str) -> str:
    font = f'font-family="sans-serif" font-size="{LETTER:g}"'
    return f'<text x="{x:g}" y="{y:g}" {font} fill="{_INK}">{escape(text)}</text>'


def as_png(it: RunPicture) -> bytes:
    """The picture as PNG, drawn by Pillow."""
    image, draw = _canvas(it.width, it.height)
    _draw_run(it, draw, it.drawings)
    return _png(image, " ".join(it.legend))


def as_gif(it: RunPicture) -> bytes:
    """The picture as GIF: dots drive along the paths once, all beginning together, with what they moved."""
    from PIL.Image import Dither
    from PIL.ImageDraw import Draw  # slow to load

    whole, draw = _canvas(it.width, it.height)
    _draw_run(it, draw, it.drawings)
    image, draw = _canvas(it.width, it.height)
    _draw_run(it, draw, it.standing)
    base = image.quantize(palette=whole.quantize(64), dither=Dither.NONE)
    fills = {_fill(each): _nearest_colour(base, _fill(each)) for each, _ in it.moving}
    seconds = max((*map(_seconds, it.paths), *(each.seconds for each in it.moved)), default=FRAME)
    count = max(2, min(MOST_FRAMES, round(seconds / FRAME) + 1))
    frames = []
    for number in range(count):
        frame = base.copy()
        pen = Draw(frame)
        for each, moved in it.moving:
            there, end = moved.at(seconds * number / (count - 1)), moved.end
            for outline in moved_outlines(each, end, there):
                pen.polygon(
                    [it.at(*point) for point in outline], fill=fills[_fill(each)], outline=_darkest(base)
                )
            for x, y, text in _letter(it, each):
                right, down = (there.x - end.x) * it.scale, (end.y - there.y) * it.scale
                _write(pen, (x + right, y + down), text, "ls", _darkest(base))
        for (x, y), heading in driven_to(it, seconds * number / (count - 1)):
            radius = max(3.0, 1.3 * it.scale)
            pen.ellipse((x - radius, y - radius, x + radius, y + radius), outline=_darkest(base), width=3)
            ahead = x + radius * sin(radians(heading)), y - radius * cos(radians(heading))
            pen.line((x, y, *ahead), fill=_darkest(base), width=3)
        frames.append(frame)
    out = BytesIO()
    pause = min(LONGEST_FRAME, round(1000 * seconds / (count - 1)))
    frames[0].save(out, "GIF", save_all=True, append_images=frames[1:], duration=pause, comment=b"donnie")
    return out.getvalue()


def moved_outlines(drawing: Drawing, end: Pose, there: Pose) -> Iterable[list[_Point]]:
    """The outlines of what stands at ``end``, where it stood ``there``."""
    angle = radians(end.heading - there.heading)
    c, s = cos(angle), sin(angle)
    for outline in drawing.outlines:
        seen = [(x - end.x, y - end.y) for x, y in outline]
        yield [(there.x + c * x - s * y, there.y + s * x + c * y) for x, y in seen]


def _seconds(path: DrivenPath) -> float:
    """The time of the moving dot."""
    return max(0.1, path.lengths[-1] / STEPS_A_SECOND)


def driven_to(it: RunPicture, seconds: float) -> Iterable[tuple[_Point, float]]:
    """Where each robot is on the picture after that time, and its heading."""
    for path in it.paths:
        driven = seconds * STEPS_A_SECOND
        x, y, heading = path.poses[0].x, path.poses[0].y, path.poses[0].heading
        for (begin, here), (end, there) in pairwise(zip(path.lengths, path.poses, strict=True)):
            part = min(1.0, (driven - begin) / (end - begin)) if end > begin else 1.0
            x, y = here.x + (there.x - here.x) * part, here.y + (there.y - here.y) * part
            heading = here.heading + _turned(here, there) * part
            if driven <= end:
                break
        yield it.at(x, y), heading


def _darkest(image: Image) -> int:
    """The number of the darkest colour in the palette."""
    return _nearest_colour(image, _INK)


def _nearest_colour(image: Image, colour: str) -> int:
    """The number of the colour in the palette that is most like this one, which is written ``#rrggbb``."""
    palette, wanted = image.getpalette() or [0, 0, 0], bytes.fromhex(colour[1:])
    apart = [
        sum(abs(a - b) for a, b in zip(palette[at : at + 3], wanted, strict=True))
        for at in range(0, len(palette), 3)
    ]
    return apart.index(min(apart))


def _canvas(width: float, height: float) -> tuple[Image, ImageDraw]:
    from PIL import Image, ImageDraw  # slow to load

    image = Image.new("RGB", (round(width), round(height)), "white")
    return image, ImageDraw.Draw(image)


def _draw_run(it: RunPicture, draw: ImageDraw, shown: Sequence[Drawing]) -> None:
    for each in shown:
        for outline in each.outlines:
            draw.polygon([it.at(*point) for point in outline], fill=_fill(each), outline=_INK)
    for goal in goals_on(it):
        box = (goal.x - goal.across, goal.y - goal.down, goal.x + goal.across, goal.y + goal.down)
        draw.rectangle(box, outline=_INK, width=2)
    for number, path in enumerate(it.paths):
        colour = _PATHS[number % len(_PATHS)]
        for piece in path.pieces:
            if len(piece) > 1:
                draw.line([it.at(pose.x, pose.y) for pose in piece], fill=colour, width=3, joint="curve")
        x, y = it.at(path.poses[0].x, path.poses[0].y)
        draw.ellipse((x - 4, y - 4, x + 4, y + 4), fill="white", outline=colour, width=2)
        draw.polygon(arrow(it, path), fill=colour)
    for x, y, text in texts(it, shown):
        _write(draw, (x, y), text, "ls")


def _write(draw: ImageDraw, place: _Point, text: str, anchor: str, ink: str | int = _INK) -> None:
    from PIL import ImageFont  # slow to load

    draw.text(place, text, fill=ink, font=ImageFont.load_default(LETTER), anchor=anchor)


def _png(image: Image, about: str) -> bytes:
    from PIL import PngImagePlugin  # slow to load

    out, info = BytesIO(), PngImagePlugin.PngInfo()
    info.add_text("Software", "donnie")  # so that only a picture of Donnie's is replaced
    info.add_text("Description", about.encode("latin-1", "replace").decode("latin-1"))
    image.save(out, "PNG", pnginfo=info)
    return out.getvalue()


def plot_as_png(plot: Plot) -> bytes:
    """A plot of what was measured."""
    image, draw = _canvas(plot.width, plot.height)
    for each in plot.axes:
        draw.line(each, fill=_INK, width=1)
    for each in plot.curves:
        draw.line(each, fill=_INK, width=2)
    for x, y in plot.dots:
        draw.ellipse((x - 3, y - 3, x + 3, y + 3), fill=_INK)
    for text in plot.texts:
        _write(draw, (text.x, text.y), text.text, {"start": "ls", "middle": "ms", "end": "rs"}[text.anchor])
    return _png(image, plot.about)


def texts(it: RunPicture, shown: Sequence[Drawing]) -> Iterable[tuple[float, float, str]]:
    """The title, a letter on each thing or next to a small one, robots, the numbers of goals, and the legend.

    Left end and base line of each.
    """
    for number, line in enumerate(it.title_lines):
        yield MARGIN, MARGIN + LINE * number, line
    for each in shown:
        yield from _letter(it, each)
    yield from it.marks
    below = it.height - LINE * len(it.legend)
    for number, line in enumerate(it.legend):
        yield MARGIN, below + LINE * number, line


def _letter(it: RunPicture, drawing: Drawing) -> Iterable[tuple[float, float, str]]:
    """The letter of a thing that has room for one; none of a wall."""
    thing = drawing.thing
    if thing is not None and thing.index in it.labels:
        yield *it.labels[thing.index], it.letters[thing.index]


def arrow(it: RunPicture, path: DrivenPath) -> list[_Point]:
    """A triangle where the robot stopped, in its direction."""
    pose = path.poses[-1]
    x, y = it.at(pose.x, pose.y)
    size = max(6.0, 1.3 * it.scale)
    turns = ((0.0, size), (140.0, size), (220.0, size))
    return [
        (
            round(x + length * sin(radians(pose.heading + angle)), 1),
            round(y - length * cos(radians(pose.heading + angle)), 1),
        )
        for angle, length in turns
    ]


def _fill(drawing: Drawing) -> str:
    return _WALL if drawing.thing is None else PAINTED.get(drawing.thing.colour, _OTHER)
