"""A world, and the way that a robot drove in it, as a picture for swell paper.

A sheet of 210 by 297 millimetres as SVG: heat raises everything black on it. Lines are at least a millimetre
thick. Walls are black bars, or outlines where they are thick on paper; the colours of things are textures
with a key. Braille names the things by letters with a legend; it is made of dots, so that no font is needed.
Between a label and everything else are 3 mm. Next to all braille is the same in print for a sighted helper,
in a grey that does not swell. The title and description of the SVG give screen readers the same in text.
"""

from __future__ import annotations

import textwrap
from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import chain, pairwise
from math import cos, floor, hypot, radians, sin
from typing import TYPE_CHECKING
from xml.sax.saxutils import escape

from msgspec import Struct

from devices.ports.robot import STEP, Pose
from donnie_tui.core.chart import Chart, braille, dots, wrapped
from donnie_tui.core.map_grid import WALL
from donnie_tui.core.wording import Wording
from sim.geometry import contains, edges, edges_apart

if TYPE_CHECKING:
    from sim.picture import Drawing, Picture

A4 = (210.0, 297.0)
"""Millimetres, upright; so are all lengths here."""
MARGIN = 12.0
LINE = 1.2
"""The thickness of every line. Thinner ones do not rise well."""
GAP = 3.0
"""Between a label and everything else: nearer than that fingers take them for one. Twice between labels."""
THICKEST_WALL = 6.0
"""A wall that is thinner on paper is one black line, a thicker one an outline."""
SMALLEST = 5.0
"""What is smaller on paper is a ring of this width."""
LEAST_TEXTURED = 8.0
"""A texture on less can't be felt."""
DOT, DOT_GAP, CELL, ROW = 1.6, 2.5, 6.2, 10.0
"""Braille: a dot, from dot to dot, from cell to cell, from line to line."""
HEAD = 2 * ROW
"""The title, and to its right the arrow to the north."""
SWATCH = (12.0, 9.0)
"""A sample in the key."""
WORD = SWATCH[0] + LINE / 2 + GAP + DOT / 2
"""From the left end of a sample to the first dot of its word."""
KEY_ROW = 13.0
MOST_LEGEND = 10
"""Lines of the legend; a map needs the rest of the sheet."""
MOST_TITLE = 2
"""Lines of the title."""
MOST_LABELS = 60
"""Things that get a letter; more letters would cover each other."""
PRINT = 3.2
"""The height of printed letters."""
MOST_SPREAD = 2.0
"""Half of it separates print from its braille; where there is no room, a quarter of a millimetre does."""
PALE = "#b4b4b4"
"""A grey that heat does not raise."""
DASHES = "4 3"
"""Of a driven path."""

TEXTURES = {
    "red": (3.4, "M1 0V3.4"),
    "green": (3.4, "M0 1H3.4"),
    "blue": (3.6, ""),
    "yellow": (4.6, "M-1 1L1 -1M0 4.6L4.6 0M3.6 5.6L5.6 3.6"),
    "orange": (5.0, "M1 0V5M0 1H5"),
    "pink": (5.0, "M0 1H3M2.5 3.5H5M0 3.5H.5"),
    "rock": (3.2, "M-1 2.2L1 4.2M0 0L3.2 3.2M2.2 -1L4.2 1"),
}
"""The side of a tile, and its lines; of blue a dot. Gray things are empty, rock is a wall that is no line."""

_Point = tuple[float, float]
Box = tuple[float, float, float, float]
_Segment = tuple[_Point, _Point]


class _Sheet(Struct, frozen=True):
    """Where the map lies on the paper, from the top left corner; the world's places in steps."""

    width: float
    height: float
    left: float
    top: float
    scale: float
    """For a step."""
    west: float
    north: float
    spread: float = 0.0
    """More from line to line at its foot, where the map leaves room."""

    def point(self, x: float, y: float) -> _Point:
        return self.left + (x - self.west) * self.scale, self.top + (self.north - y) * self.scale


class _Item(Struct, frozen=True):
    """A word of the key with the name of its sample."""

    sample: str
    word: str


def raised_picture(
    title: str,
    chart: Chart,
    picture: Picture,
    drawings: Sequence[Drawing],
    wording: Wording,
    paths: Sequence[Sequence[Pose]] = (),
) -> str:
    """The sheet. ``drawings``: what stands in the world; its letters and their meanings are the chart's.

    ``paths``: where robots drove from their starts.
    """
    sheet, legend = _laid_out(chart, picture, drawings, _key(drawings, None, wording, paths), wording)
    items = _key(drawings, sheet, wording, paths)
    meanings = "; ".join(f"{letter}: {meaning}" for letter, meaning in chart.legend.items())
    cells = _cells(sheet.width - 3 * ROW)
    return "\n".join(
        (
            f'<svg xmlns="http://www.w3.org/2000/svg" role="img" width="{sheet.width:g}mm"'
            f' height="{sheet.height:g}mm" viewBox="0 0 {sheet.width:g} {sheet.height:g}">',
            f"<title>{escape(_printable(title))}</title>",
            f"<desc>{escape(_printable(meanings))}</desc>",
            *_patterns(items),
            f'<rect width="{sheet.width:g}" height="{sheet.height:g}" fill="white"/>',
            f'<g id="map" fill="none" stroke="black" stroke-width="{LINE}" stroke-linejoin="round">',
            *(_shape(each, sheet) for each in drawings),
            *(_line(each) for each in _noses(chart, sheet)),
            *(f'<g stroke-dasharray="{DASHES}">{_line(_on_paper(each, sheet))}</g>' for each in paths),
            *(_line(each) for path in paths for each in _head(path, sheet)),
            "</g>",
            *_titled(_printable(title), cells, wording),
            *_north(sheet, wording),
            *_labels(chart, drawings, sheet, paths),
            *_legend_block(legend, items, sheet, wording),
            "</svg>\n",
        )
    )


def _laid_out(
    chart: Chart, picture: Picture, drawings: Sequence[Drawing], items: Sequence[_Item], wording: Wording
) -> tuple[_Sheet, list[str]]:
    """The sheet upright or on its side, whichever makes the map larger."""
    box = _extent(picture, drawings)
    sheets = []
    for width, height in (A4, A4[::-1]):
        legend = _sheet_legend(chart, _cells(width))
        key = KEY_ROW * len(_key_rows(items, width, wording))
        room = height - 2 * MARGIN - HEAD - ROW * (len(legend) + 3) - key
        sheets.append((_fitted(box, width, height, room, len(legend) + 2), legend))
    return max(sheets, key=lambda each: each[0].scale)


def _cells(width: float) -> int:
    """Braille cells in a line of a sheet."""
    return int((width - 2 * MARGIN) / CELL)


def _extent(picture: Picture, drawings: Sequence[Drawing]) -> Box:
    """West, south, east and north end in steps: what stands there; without walls the floor of the map."""
    half = picture.cell / 2
    xs = [picture.left - half, picture.left + picture.width * picture.cell - half]
    ys = [picture.bottom - half, picture.bottom + picture.height * picture.cell - half]
    points = [point for each in drawings for outline in each.outlines for point in outline]
    if picture.has_walls and points:
        xs, ys = [x for x, _ in points], [y for _, y in points]
    return min(xs), min(ys), max(xs), max(ys)


def _fitted(box: Box, width: float, height: float, room: float, lines: int) -> _Sheet:
    """``lines``: those at the foot, which share the room that the map does not need."""
    west, south, east, north = box
    scale = min((width - 2 * MARGIN) / max(east - west, 1.0), room / max(north - south, 1.0))
    left = (width - scale * (east - west)) / 2
    spread = min(MOST_SPREAD, (room - scale * (north - south)) / lines)
    return _Sheet(width, height, left, MARGIN + HEAD, scale, west, north, spread)


# --- what stands in the world


def _shape(drawing: Drawing, sheet: _Sheet) -> str:
    outlines = [[sheet.point(x, y) for x, y in outline] for outline in drawing.outlines]
    box = box_of(point for outline in outlines for point in outline)
    if drawing.thing is not None and max(box[2] - box[0], box[3] - box[1]) < SMALLEST:
        return _ring((box[0] + box[2]) / 2, (box[1] + box[3]) / 2)
    lines = [each for each in outlines if _is_line(drawing, each)]
    areas = [each for each in outlines if not _is_line(drawing, each)]
    return "".join((_path(lines, ' fill="black"'), _outlined(areas, _texture(drawing, box))))


def _texture(drawing: Drawing, box: Box) -> str:
    """The name of its texture; empty for a robot and for what is too small."""
    thing = drawing.thing
    if thing is None:
        return "rock"
    is_large = min(box[2] - box[0], box[3] - box[1]) >= LEAST_TEXTURED
    return thing.colour if not thing.is_robot and is_large else ""


def _is_line(drawing: Drawing, points: Sequence[_Point]) -> bool:
    """Whether it is a wall that is thin on paper."""
    if drawing.thing is not None or drawing.from_bitmap:
        return False
    left, top, right, bottom = box_of(points)
    area = abs(sum(ax * by - bx * ay for (ax, ay), (bx, by) in pairwise([*points, points[0]]))) / 2
    return area < THICKEST_WALL * hypot(right - left, bottom - top)


def _outlined(areas: Sequence[Sequence[_Point]], texture: str) -> str:
    """The outline of all pieces together: what lies inside of another piece is wiped out by white."""
    twice = f' stroke-width="{2 * LINE}"'  # the inner half is wiped out too
    outline = (
        _path(areas) if len(areas) < 2 else _path(areas, twice) + _path(areas, ' fill="white" stroke="none"')
    )
    filled = f' fill="url(#{texture})" stroke="none"'
    return outline + (_path(areas, filled) if texture in TEXTURES else "")


def _path(polygons: Iterable[Sequence[_Point]], style: str = "") -> str:
    pieces = ["M" + "L".join(f"{x:.2f} {y:.2f}" for x, y in points) + "Z" for points in polygons]
    return f'<path d="{"".join(pieces)}"{style}/>' if pieces else ""


def _line(points: Sequence[_Point]) -> str:
    return f'<path d="M{"L".join(f"{x:.2f} {y:.2f}" for x, y in points)}"/>'


def _ring(x: float, y: float) -> str:
    return f'<circle cx="{x:.2f}" cy="{y:.2f}" r="{SMALLEST / 2 - LINE / 2:.2f}"/>'


def _noses(chart: Chart, sheet: _Sheet) -> Iterator[_Segment]:
    """A line from each robot's middle towards what it looks at."""
    for robot in chart.robots:
        x, y = sheet.point(robot.pose.x, robot.pose.y)
        turned = radians(robot.pose.heading)
        yield (x, y), (x + SMALLEST * 1.6 * sin(turned), y - SMALLEST * 1.6 * cos(turned))


def _on_paper(path: Iterable[Pose], sheet: _Sheet) -> list[_Point]:
    return [sheet.point(each.x, each.y) for each in path]


def _head(path: Sequence[Pose], sheet: _Sheet) -> Iterator[_Segment]:
    """The head of an arrow where the robot stopped, in its direction."""
    end = path[-1]
    x, y = sheet.point(end.x, end.y)
    for turned in (radians(end.heading + 150), radians(end.heading - 150)):
        yield (x, y), (x + SMALLEST * sin(turned), y - SMALLEST * cos(turned))


# --- labels


def _labels(
    chart: Chart, drawings: Sequence[Drawing], sheet: _Sheet, paths: Sequence[Sequence[Pose]]
) -> Iterator[str]:
    """The letters of things and robots, where everything else is far enough; others have none."""
    things = [(each.thing, _box_on(each, sheet)) for each in drawings if each.thing is not None]
    if len(things) > MOST_LABELS:
        return
    letters = {each.name: each.letter for each in chart.robots}
    initials = {each.thing.index: each.initial for each in chart.marks}
    driven = [leg for path in paths for leg in (*pairwise(_on_paper(path, sheet)), *_head(path, sheet))]
    lines = [*_edges(drawings, sheet), *_noses(chart, sheet), *driven]
    walls = [each for each in drawings if each.thing is None]
    solid = ([sheet.point(x, y) for x, y in outline] for each in walls for outline in each.outlines)
    near_lines, near_walls = Nearby(lines), Nearby(solid)
    taken = list[Box]()
    for thing, box in things:
        letter = letters.get(thing.name, thing.letter) if thing.is_robot else thing.letter
        text = letter.upper() + initials.get(thing.index, "")
        others = [each for _, each in things if each != box]
        places = (
            each
            for each in _clear_places(box, len(text), near_lines, taken, sheet)
            if all(boxes_apart(each, other) > boxes_apart(each, box) + LINE for other in others)
            and not any(is_between(leg, each, box) for leg in driven)
        )
        middles = ((each, ((each[0] + each[2]) / 2, (each[1] + each[3]) / 2)) for each in places)
        label = next(
            (each for each, at in middles if not any(contains(wall, *at) for wall in near_walls.of(each))),
            None,
        )
        if label is not None:
            taken.append(label)
            yield f'<g class="label">{_braille(text, label[0] + DOT / 2, label[1] + DOT / 2)}</g>'
            yield _print(text, label[0], label[1] - 0.6)


def _edges(drawings: Iterable[Drawing], sheet: _Sheet) -> Iterator[_Segment]:
    """The lines on paper."""
    for each in drawings:
        left, top, right, bottom = _box_on(each, sheet)
        if each.thing is not None and right - left <= SMALLEST and bottom - top <= SMALLEST:
            corners = (left, top), (right, top), (right, bottom), (left, bottom)
            yield from pairwise((*corners, corners[0]))
            continue
        for outline in each.outlines:
            yield from pairwise([sheet.point(x, y) for x, y in (*outline, outline[0])])


_DIRECTIONS = ((1, 0), (-1, 0), (0, 1), (0, -1), (1, -1), (1, 1), (-1, 1), (-1, -1))
_AWAY = (0.1, 1.0, 2.0, 3.5, 5.0, 7.5)
"""How much further away than the gap a label may be."""


def _clear_places(box: Box, cells: int, lines: Nearby, taken: Sequence[Box], sheet: _Sheet) -> Iterator[Box]:
    """The places of a label near a thing with nothing else within the gap; inside of it comes last."""
    width, height = (cells - 1) * CELL + DOT_GAP + DOT, 2 * DOT_GAP + DOT
    reach = GAP + LINE / 2
    x, y = (box[0] + box[2] - width) / 2, (box[1] + box[3] - height) / 2
    half = (box[2] - box[0] + width) / 2, (box[3] - box[1] + height) / 2
    places = [
        (x + right * (half[0] + reach + away), y + down * (half[1] + reach + away))
        for away in _AWAY
        for right, down in _DIRECTIONS
    ]
    for left, top in (*places, (x, y)):
        label = left, top, left + width, top + height
        is_on_sheet = left >= MARGIN / 2 and left + width <= sheet.width - MARGIN / 2
        if (
            is_on_sheet
            and all(boxes_apart(label, each) >= 2 * GAP for each in taken)
            and all(from_segment(label, each) >= reach for each in lines.of(label, reach))
        ):
            yield label


class Nearby:
    """Which lines or outlines are near a box: in squares of the sheet, because a plan may have thousands."""

    _SIDE = 8.0

    def __init__(self, shapes: Iterable[Sequence[_Point]]) -> None:
        self._squares: dict[tuple[int, int], list[Sequence[_Point]]] = {}
        for shape in shapes:
            for square in self._of_box(box_of(shape), 0.0):
                self._squares.setdefault(square, []).append(shape)

    def of(self, box: Box, away: float = 0.0) -> Iterator[Sequence[_Point]]:
        """Some of them more than once."""
        for square in self._of_box(box, away):
            yield from self._squares.get(square, ())

    def _of_box(self, box: Box, away: float) -> Iterator[tuple[int, int]]:
        left, top, right, bottom = (
            floor(each / self._SIDE) for each in (box[0] - away, box[1] - away, box[2] + away, box[3] + away)
        )
        for column in range(left, right + 1):
            for row in range(top, bottom + 1):
                yield column, row


def boxes_apart(mine: Box, other: Box) -> float:
    """Between two boxes; 0 if they touch."""
    return hypot(
        max(mine[0] - other[2], other[0] - mine[2], 0.0), max(mine[1] - other[3], other[1] - mine[3], 0.0)
    )


def from_segment(box: Box, segment: Sequence[_Point]) -> float:
    """The shortest way from a box to a line; 0 if the line crosses it."""
    left, top, right, bottom = box
    corners = ((left, top), (right, top), (right, bottom), (left, bottom))
    start, end = segment
    if contains(corners, *start):
        return 0.0
    return min(edges_apart((*start, *end), each) for each in edges(corners))


def is_between(line: _Segment, label: Box, box: Box) -> bool:
    """Whether a line crosses the shortest way from the middle of a label to a box."""
    x, y = (label[0] + label[2]) / 2, (label[1] + label[3]) / 2
    nearest = min(max(x, box[0]), box[2]), min(max(y, box[1]), box[3])
    return edges_apart((x, y, *nearest), (*line[0], *line[1])) == 0.0


def _box_on(drawing: Drawing, sheet: _Sheet) -> Box:
    box = box_of(sheet.point(x, y) for outline in drawing.outlines for x, y in outline)
    small = drawing.thing is not None and max(box[2] - box[0], box[3] - box[1]) < SMALLEST
    return _around((box[0] + box[2]) / 2, (box[1] + box[3]) / 2) if small else box


def _around(x: float, y: float) -> Box:
    return x - SMALLEST / 2, y - SMALLEST / 2, x + SMALLEST / 2, y + SMALLEST / 2


def box_of(points: Iterable[_Point]) -> Box:
    xs, ys = zip(*points, strict=True)
    return min(xs), min(ys), max(xs), max(ys)


# --- around the map


def _north(sheet: _Sheet, wording: Wording) -> Iterator[str]:
    """An arrow in the top right corner with the first letter of north."""
    x, top = sheet.width - MARGIN - 3, MARGIN
    yield (
        f'<path id="north" d="M{x} {top + 14}L{x} {top}M{x - 3} {top + 4}L{x} {top}L{x + 3} {top + 4}"'
        f' fill="none" stroke="black" stroke-width="{LINE}" stroke-linejoin="round"/>'
    )
    north = wording("compass-north")[:1].upper()
    yield from _written(north, 1, x - 3 - GAP - 2 * DOT_GAP, top + 6, wording, MOST_SPREAD / 2)


def _titled(title: str, cells: int, wording: Wording) -> Iterator[str]:
    """The title, in two lines where one is too short for it."""
    lines = textwrap.wrap(title, cells - 1)[:MOST_TITLE]  # a number needs a sign before it
    gap = MOST_SPREAD / 2 if len(lines) == 1 else 0.0
    for number, line in enumerate(lines):
        yield from _written(line, cells, MARGIN, MARGIN + number * ROW, wording, gap)


def _sheet_legend(chart: Chart, cells: int) -> list[str]:
    """The letters and what they mean, as they are printed; walls are in the key."""
    lines = [f"{letter}  {meaning}" for letter, meaning in chart.legend.items() if letter != WALL]
    return list(chain.from_iterable(wrapped(_printable(line), cells - 3) for line in lines))[:MOST_LEGEND]


def _key(
    drawings: Iterable[Drawing], sheet: _Sheet | None, wording: Wording, paths: Sequence[object]
) -> list[_Item]:
    """The samples on a sheet: walls, the textures of the colours, the path; without one all that may be."""
    samples = set[str]()
    for each in drawings:
        if sheet is None:
            samples |= {"wall", "rock"} if each.thing is None else {each.thing.colour}
            continue
        outlines = [[sheet.point(x, y) for x, y in outline] for outline in each.outlines]
        lines = [_is_line(each, outline) for outline in outlines]
        samples |= {"wall"} if any(lines) else set()
        samples |= {_texture(each, _box_on(each, sheet))} if not all(lines) else set()
    word = {"wall": "paper-legend-wall", "rock": "paper-legend-wall", "path": "cell-trail"}
    textures = [each for each in TEXTURES if each != "rock"]
    order = ["wall", "rock", *textures, *(["gray"] if samples & {*textures} else [])]
    named = [each for each in order if each in samples] + (["path"] if paths else [])
    return [_Item(each, wording(word.get(each, f"colour-{each}"))) for each in named]


def _key_rows(items: Iterable[_Item], width: float, wording: Wording) -> list[list[tuple[_Item, float]]]:
    """The items in rows, each with its left end."""
    rows, left = list[list[tuple[_Item, float]]](), width
    for each in items:
        wide = WORD + CELL * (len(braille(each.word, wording.language)) + 1)
        if left + wide > width - MARGIN:
            rows.append([])
            left = MARGIN
        rows[-1].append((each, left))
        left += wide + GAP
    return rows


def _legend_block(
    legend: Sequence[str], items: Sequence[_Item], sheet: _Sheet, wording: Wording
) -> Iterator[str]:
    """The legend and the key at the foot of the sheet, and a line that shows how long that many steps are."""
    rows = _key_rows(items, sheet.width, wording)
    row_height, gap = ROW + sheet.spread, sheet.spread / 2
    top = sheet.height - MARGIN - row_height * (len(legend) + 2) - KEY_ROW * len(rows)
    steps = _round_number((sheet.width - 2 * MARGIN) / sheet.scale)
    words = wording("paper-scale", steps=steps, centimetres=round(steps * STEP * 100))
    for number, line in enumerate(legend):
        yield from _written(line, _cells(sheet.width), MARGIN, top + number * row_height, wording, gap)
    top += row_height * len(legend)
    for row in rows:
        for item, left in row:
            yield _sample(item.sample, left, top - 1)
            yield from _written(item.word, len(item.word) + 2, left + WORD, top, wording, MOST_SPREAD / 2)
        top += KEY_ROW
    yield from _written(words, _cells(sheet.width), MARGIN, top, wording, gap)
    bar = f"M{MARGIN} {top + row_height + 5:.2f}v-4m0 2h{steps * sheet.scale:.2f}m0 -2v4"
    yield f'<path id="scale" d="{bar}" fill="none" stroke="black" stroke-width="{LINE}"/>'


def _sample(name: str, left: float, top: float) -> str:
    """A sample of what the key explains, in a box of its size."""
    width, height = SWATCH
    line = f'stroke="black" stroke-width="{LINE}"'
    if name == "path":
        way = f"M{left} {top + height / 2:.2f}H{left + width}"
        return f'<path d="{way}" fill="none" {line} stroke-dasharray="{DASHES}"/>'
    if name == "wall":
        return f'<rect x="{left:.2f}" y="{top + 2:.2f}" width="{width}" height="{height - 4}" fill="black"/>'
    box = f'<rect x="{left:.2f}" y="{top:.2f}" width="{width}" height="{height}"'
    filled = f'{box} fill="url(#{name})"/>' if name in TEXTURES else ""
    return f'{box} fill="none" {line}/>{filled}'


def _patterns(items: Iterable[_Item]) -> Iterator[str]:
    tiles: Mapping[str, tuple[float, str]] = TEXTURES
    for each in items:
        if each.sample in tiles:
            side, lines = tiles[each.sample]
            dot = f'<circle cx="{side / 2}" cy="{side / 2}" r="{DOT / 2}"/>'
            drawn = f'<path d="{lines}" fill="none" stroke="black"/>' if lines else dot
            yield (
                f'<pattern id="{each.sample}" patternUnits="userSpaceOnUse" width="{side}" height="{side}">'
                f"{drawn}</pattern>"
            )


def _round_number(most: float) -> int:
    """The largest of 1, 2, 5, 10, 20, 50 and so on that is not above ``most``, at least 1."""
    digits = str(max(int(most), 1))
    first = max(each for each in ("1", "2", "5") if each <= digits[0])
    return int(first.ljust(len(digits), "0"))


def _written(text: str, cells: int, x: float, y: float, wording: Wording, gap: float = 0.0) -> Iterator[str]:
    """Braille from a place on, and the same in print under it, by so much further away."""
    yield _braille(braille(text, wording.language)[:cells], x, y)
    yield _print(text, x - DOT / 2, y + 2 * DOT_GAP + DOT / 2 + PRINT * 0.8 + gap)


def _braille(cells: str, x: float, y: float) -> str:
    """Cells as dots; ``x`` and ``y`` are the middle of the first cell's first dot."""
    centres = [
        (x + number * CELL + (dot > 3) * DOT_GAP, y + (dot - 1) % 3 * DOT_GAP)
        for number, cell in enumerate(cells)
        for dot in dots(cell)
    ]
    circles = "".join(f'<circle cx="{cx:.2f}" cy="{cy:.2f}" r="{DOT / 2}"/>' for cx, cy in centres)
    return f'<g fill="black">{circles}</g>'


def _print(text: str, x: float, y: float) -> str:
    font = f'font-family="sans-serif" font-size="{PRINT}"'
    return f'<text x="{x:.2f}" y="{y:.2f}" {font} fill="{PALE}">{escape(text)}</text>'


def _printable(text: str) -> str:
    """The text without characters that XML forbids."""
    return "".join(letter if letter.isprintable() else " " for letter in text)
