"""A world on paper: braille pages for an embosser, and a picture for swell paper.

Text is North American ASCII braille, one sign a cell: uncontracted, without signs for capitals, with the
accents of Portuguese and Spanish braille.

The braille pages have 40 cells by 25 lines: a map to scale, and a legend next to or after it. The file is BRF
(ASCII braille, a form feed after each page) for an embosser or a braille display.

The picture is a sheet of 210 by 297 millimetres as SVG: heat raises everything black on it. Lines only, at
least a millimetre thick. Nothing is filled but thin walls, which are lines themselves. Braille names the
things; it is made of dots, so that no font is needed. No print is raised. The title and description of the
SVG give screen readers the same in text.
"""

from __future__ import annotations

import textwrap
import unicodedata
from collections.abc import Iterable, Iterator, Sequence
from itertools import chain, islice, pairwise
from math import cos, hypot, radians, sin
from typing import TYPE_CHECKING
from xml.sax.saxutils import escape

from msgspec import Struct

from donnie_tui.core.chart import Chart, ChartedRobot, shrunk, with_marks
from donnie_tui.core.map_grid import FREE, WALL
from donnie_tui.core.wording import Wording
from language.locales import own_words

if TYPE_CHECKING:
    from sim.picture import Drawing, Picture

# --- braille pages

ASCII = " A1B'K2L@CIF/MSP\"E3H9O6R^DJG>NTQ,*5<-U8V.%[$+X!&;:4\\0Z7(_?W]#Y)="
"""The 64 cells in the order of their dots: dot 1 counts 1, dot 2 counts 2, dot 3 counts 4 and so on."""
FULL_CELL = "="
NUMBER = "#"

_SIGNS = {",": "1", ";": "2", ":": "3", ".": "'", "-": "-", "'": "'", "_": "-", "/": "-"}


def braille(text: str, language: str) -> str:
    """The text in a language; what has no sign there becomes a blank."""
    cells: list[str] = []
    in_number = False
    for letter in unicodedata.normalize("NFC", text).lower():
        is_digit = "0" <= letter <= "9"
        if is_digit and not in_number:
            cells.append(NUMBER)
        cells.append(_cell(letter, language))
        in_number = is_digit
    return "".join(cells)


def _cell(letter: str, language: str) -> str:
    if "0" <= letter <= "9":
        return "JABCDEFGHI"[int(letter)]
    special = own_words(language, "words", "braille", letter)
    if special or letter in _SIGNS:
        return special[0] if special else _SIGNS[letter]
    plain = unicodedata.normalize("NFD", letter)[0]
    return plain.upper() if "a" <= plain <= "z" else " "


def dots(cell: str) -> tuple[int, ...]:
    """The raised dots of a cell: 1, 2, 3 down the left column, 4, 5, 6 down the right one."""
    pattern = ASCII.index(cell)
    return tuple(dot for dot in range(1, 7) if pattern & 1 << (dot - 1))


CELLS, LINES = 40, 25
_HEADING = 2
"""Lines above the map: its name, its scale."""
_SLENDER = 5 / 3
"""A braille cell with its gaps is 6 mm wide and 10 mm high."""


def braille_pages(name: str, chart: Chart, wording: Wording) -> str:
    """The pages of the world ``name``, with line ends and form feeds as embossers want them."""
    legend = _page_legend(chart, wording)
    page = LINES - _HEADING
    across = _scale(chart, page)
    beside = _scale(chart, page - len(legend)) if len(legend) < page else 0
    down = _down(across)
    rows = _map(chart, across, down)
    heading = _heading(name, across * chart.cell, down * chart.cell, wording)
    lines = [*heading, *rows]
    if beside != across:  # the legend would make the map smaller: it has pages of its own
        lines += [""] * (LINES - len(lines))
    return _paged([*lines, *legend])


def _scale(chart: Chart, most_lines: int) -> int:
    """How many letters of the chart a cell is wide, so that all of it has its place."""
    across = 1
    while len(chart.rows[0]) > CELLS * across or len(chart.rows) > most_lines * _down(across):
        across += 1
    return across


def _down(across: int) -> int:
    return max(1, round(across * _SLENDER))


def _map(chart: Chart, across: int, down: int) -> list[str]:
    robots = "".join({each.letter for each in chart.robots})
    rows, _ = with_marks(shrunk(chart.rows, across, down, robots), chart.marks, across, down)
    return [row.upper().replace(FREE, " ").replace(WALL, FULL_CELL).rstrip() for row in rows]


def _heading(name: str, width: int, height: int, wording: Wording) -> list[str]:
    title = braille(wording("paper-title", name=name), wording.language)
    scale = braille(wording("paper-cell", width=width, height=height), wording.language)
    return [title[:CELLS], scale[:CELLS]]


def _page_legend(chart: Chart, wording: Wording) -> list[str]:
    lines = [braille(wording("paper-north"), wording.language)]
    for letter, meaning in chart.legend.items():
        sign = FULL_CELL if letter == WALL else letter.upper()
        lines.append(f"{sign}  {braille(meaning, wording.language)}")
    return [part for line in lines for part in textwrap.wrap(line, CELLS, subsequent_indent="   ")]


def _paged(lines: list[str]) -> str:
    return "".join(_page(lines[start : start + LINES]) for start in range(0, len(lines), LINES))


def _page(lines: list[str]) -> str:
    return "".join(f"{line}\r\n" for line in _without_end(lines)) + "\f"


def _without_end(lines: list[str]) -> Iterator[str]:
    """The lines without the blank ones at the foot of the page."""
    last = max((number for number, line in enumerate(lines) if line), default=-1)
    yield from lines[: last + 1]


# --- the picture for swell paper

A4 = (210.0, 297.0)
"""Millimetres, upright."""
MARGIN = 12.0
LINE = 1.2
"""Millimetres: the thickness of every line. Thinner ones do not rise well."""
THICKEST_WALL = 6.0
"""Millimetres: a wall that is thinner on paper is one black line, a thicker one an outline."""
SMALLEST = 5.0
"""Millimetres: what is smaller on paper is a ring of this width."""
DOT, DOT_GAP, CELL, ROW = 1.6, 2.5, 6.2, 10.0
"""Millimetres of braille: a dot, from dot to dot, from cell to cell, from line to line."""
MOST_LEGEND = 9
"""Lines of the legend; a map needs the rest of the sheet."""
MOST_WALLS = 500
MOST_LABELS = 60
"""Things that get a letter; more letters would cover each other."""

_Point = tuple[float, float]
_Box = tuple[float, float, float, float]


class _Sheet(Struct, frozen=True):
    """Where the map lies on the paper. Millimetres from the top left corner; the world's places in steps."""

    width: float
    height: float
    left: float
    top: float
    scale: float
    """Millimetres for a step."""
    west: float
    north: float

    def point(self, x: float, y: float) -> _Point:
        return self.left + (x - self.west) * self.scale, self.top + (self.north - y) * self.scale


def raised_picture(
    name: str, chart: Chart, picture: Picture, drawings: Sequence[Drawing], wording: Wording
) -> str:
    """The sheet. ``drawings``: what stands in the world; its letters and their meanings are the chart's."""
    sheet, legend = _laid_out(chart, picture, drawings, wording)
    title = wording("paper-title", name=name)
    meanings = "; ".join(f"{letter}: {meaning}" for letter, meaning in chart.legend.items())
    return "\n".join(
        (
            f'<svg xmlns="http://www.w3.org/2000/svg" role="img" width="{sheet.width:g}mm"'
            f' height="{sheet.height:g}mm" viewBox="0 0 {sheet.width:g} {sheet.height:g}">',
            f"<title>{escape(_printable(title))}</title>",
            f"<desc>{escape(_printable(meanings))}</desc>",
            f'<rect width="{sheet.width:g}" height="{sheet.height:g}" fill="white"/>',
            f'<g fill="none" stroke="black" stroke-width="{LINE}" stroke-linejoin="round">',
            *(_shape(each, sheet) for each in drawings),
            *(_nose(each, sheet) for each in chart.robots),
            "</g>",
            *_written(braille(title, wording.language)[: _cells(sheet.width)], MARGIN, MARGIN),
            *_labels(chart, drawings, sheet),
            *_legend_block(legend, sheet, wording),
            "</svg>\n",
        )
    )


def _laid_out(
    chart: Chart, picture: Picture, drawings: Sequence[Drawing], wording: Wording
) -> tuple[_Sheet, list[str]]:
    """The sheet upright or on its side, whichever makes the map larger."""
    box = _extent(picture, drawings)
    sheets = []
    for width, height in (A4, A4[::-1]):
        legend = _sheet_legend(chart, _cells(width), wording)
        room = height - 2 * MARGIN - ROW * (len(legend) + 4)
        sheets.append((_fitted(box, width, height, room), legend))
    return max(sheets, key=lambda each: each[0].scale)


def _cells(width: float) -> int:
    """Braille cells in a line of a sheet."""
    return int((width - 2 * MARGIN) / CELL)


def _extent(picture: Picture, drawings: Sequence[Drawing]) -> _Box:
    """West, south, east and north end in steps: what stands there; without walls the floor of the map."""
    half = picture.cell / 2
    xs = [picture.left - half, picture.left + picture.width * picture.cell - half]
    ys = [picture.bottom - half, picture.bottom + picture.height * picture.cell - half]
    points = [point for each in drawings for outline in each.outlines for point in outline]
    if picture.has_walls and points:
        xs, ys = [x for x, _ in points], [y for _, y in points]
    return min(xs), min(ys), max(xs), max(ys)


def _fitted(box: _Box, width: float, height: float, room: float) -> _Sheet:
    west, south, east, north = box
    scale = min((width - 2 * MARGIN) / max(east - west, 1.0), room / max(north - south, 1.0))
    left = (width - scale * (east - west)) / 2
    return _Sheet(width, height, left, MARGIN + 1.5 * ROW, scale, west, north)


def _shape(drawing: Drawing, sheet: _Sheet) -> str:
    outlines = [[sheet.point(x, y) for x, y in outline] for outline in drawing.outlines]
    box = _box_of(point for outline in outlines for point in outline)
    if drawing.thing is not None and max(box[2] - box[0], box[3] - box[1]) < SMALLEST:
        return _ring((box[0] + box[2]) / 2, (box[1] + box[3]) / 2)
    lines = [each for each in outlines if _is_line(drawing, each)]
    areas = [each for each in outlines if not _is_line(drawing, each)]
    return "".join((_path(lines, ' fill="black"'), _outlined(areas)))


def _is_line(drawing: Drawing, points: Sequence[_Point]) -> bool:
    """Whether it is a wall that is thin on paper."""
    if drawing.thing is not None or drawing.from_bitmap:
        return False
    left, top, right, bottom = _box_of(points)
    area = abs(sum(ax * by - bx * ay for (ax, ay), (bx, by) in pairwise([*points, points[0]]))) / 2
    return area < THICKEST_WALL * hypot(right - left, bottom - top)


def _outlined(areas: Sequence[Sequence[_Point]]) -> str:
    """The outline of all pieces together: what lies inside of another piece is wiped out by white."""
    if len(areas) < 2:
        return _path(areas)
    twice = f' stroke-width="{2 * LINE}"'  # the inner half is wiped out too
    return _path(areas, twice) + _path(areas, ' fill="white" stroke="none"')


def _path(polygons: Iterable[Sequence[_Point]], style: str = "") -> str:
    pieces = ["M" + "L".join(f"{x:.2f} {y:.2f}" for x, y in points) + "Z" for points in polygons]
    return f'<path d="{"".join(pieces)}"{style}/>' if pieces else ""


def _ring(x: float, y: float) -> str:
    return f'<circle cx="{x:.2f}" cy="{y:.2f}" r="{SMALLEST / 2 - LINE / 2:.2f}"/>'


def _nose(robot: ChartedRobot, sheet: _Sheet) -> str:
    """A line from the robot's middle towards what it looks at."""
    x, y = sheet.point(robot.pose.x, robot.pose.y)
    turned = radians(robot.pose.heading)
    return (
        f'<path d="M{x:.2f} {y:.2f}l{SMALLEST * 1.6 * sin(turned):.2f} {-SMALLEST * 1.6 * cos(turned):.2f}"/>'
    )


def _labels(chart: Chart, drawings: Sequence[Drawing], sheet: _Sheet) -> Iterator[str]:
    """The letters of things and robots, inside or next to them, where they cover as little as possible."""
    things = [(each.thing, _box_on(each, sheet)) for each in drawings if each.thing is not None]
    letters = {each.name: each.letter for each in chart.robots}
    if len(things) > MOST_LABELS:
        return
    taken = [box for _, box in things] + list(_wall_boxes(drawings, sheet))
    for thing, box in things:
        letter = letters.get(thing.name, thing.letter) if thing.is_robot else thing.letter
        x, y = _quietest(box, taken, may_be_inside=not thing.is_robot)
        taken.append(_cell_box(x, y))
        yield from _written(letter.upper(), x, y)


def _wall_boxes(drawings: Sequence[Drawing], sheet: _Sheet) -> Iterator[_Box]:
    """The boxes of the first walls; where there are very many, a covered one is no harm."""
    walls = (each for each in drawings if each.thing is None and not each.from_bitmap)
    outlines = (outline for each in walls for outline in each.outlines)
    for outline in islice(outlines, MOST_WALLS):
        yield _box_of(sheet.point(x, y) for x, y in outline)


def _quietest(box: _Box, taken: Sequence[_Box], *, may_be_inside: bool) -> _Point:
    """Where the top left dot of a letter covers the least: inside, right, left, below or above."""
    left, top, right, bottom = box
    x, y = (left + right - DOT_GAP) / 2, (top + bottom) / 2 - DOT_GAP
    gap = DOT + LINE
    if may_be_inside and right - left > 2 * CELL and bottom - top > 1.5 * ROW:
        return x, y
    beside = ((right + gap, y), (left - gap - DOT_GAP, y), (x, bottom + gap), (x, top - gap - 2 * DOT_GAP))
    return min(beside, key=lambda place: sum(_common(_cell_box(*place), each) for each in taken))


def _cell_box(x: float, y: float) -> _Box:
    return x - DOT, y - DOT, x + DOT_GAP + DOT, y + 2 * DOT_GAP + DOT


def _common(mine: _Box, other: _Box) -> float:
    """Square millimetres that two boxes share."""
    width = min(mine[2], other[2]) - max(mine[0], other[0])
    height = min(mine[3], other[3]) - max(mine[1], other[1])
    return width * height if width > 0 and height > 0 else 0.0


def _box_on(drawing: Drawing, sheet: _Sheet) -> _Box:
    box = _box_of(sheet.point(x, y) for outline in drawing.outlines for x, y in outline)
    small = drawing.thing is not None and max(box[2] - box[0], box[3] - box[1]) < SMALLEST
    return _around((box[0] + box[2]) / 2, (box[1] + box[3]) / 2) if small else box


def _around(x: float, y: float) -> _Box:
    return x - SMALLEST / 2, y - SMALLEST / 2, x + SMALLEST / 2, y + SMALLEST / 2


def _box_of(points: Iterable[_Point]) -> _Box:
    xs, ys = zip(*points, strict=True)
    return min(xs), min(ys), max(xs), max(ys)


def _sheet_legend(chart: Chart, cells: int, wording: Wording) -> list[str]:
    lines = [braille(wording("paper-north"), wording.language)]
    for letter, meaning in chart.legend.items():
        if letter != WALL:  # a wall is the line that it is
            lines.append(f"{letter.upper()}  {braille(meaning, wording.language)}")
    wrapped = (textwrap.wrap(line, cells, subsequent_indent="   ") for line in lines)
    return list(chain.from_iterable(wrapped))[:MOST_LEGEND]


def _legend_block(legend: Sequence[str], sheet: _Sheet, wording: Wording) -> Iterator[str]:
    """The legend at the foot of the sheet, and under it a line that shows how long so many steps are."""
    top = sheet.height - MARGIN - ROW * (len(legend) + 2)
    steps = _round_number((sheet.width - 2 * MARGIN) / sheet.scale)
    words = braille(wording("paper-scale", steps=steps), wording.language)
    for number, line in enumerate([*legend, words]):
        yield from _written(line, MARGIN, top + number * ROW)
    bar = f"M{MARGIN} {top + ROW * (len(legend) + 1) + 2:.2f}v-4m0 2h{steps * sheet.scale:.2f}m0 -2v4"
    yield f'<path d="{bar}" fill="none" stroke="black" stroke-width="{LINE}"/>'


def _round_number(most: float) -> int:
    """The largest of 1, 2, 5, 10, 20, 50 and so on that is not above ``most``, at least 1."""
    numbers = (digit * 10**zeros for zeros in range(7) for digit in (1, 2, 5))
    return max((each for each in numbers if each <= most), default=1)


def _written(cells: str, x: float, y: float) -> Iterator[str]:
    """Braille from a place on, as dots; ``x`` and ``y`` are the middle of the first cell's first dot."""
    centres = [
        (x + number * CELL + (dot > 3) * DOT_GAP, y + (dot - 1) % 3 * DOT_GAP)
        for number, cell in enumerate(cells)
        for dot in dots(cell)
    ]
    if centres:
        circles = "".join(f'<circle cx="{cx:.2f}" cy="{cy:.2f}" r="{DOT / 2}"/>' for cx, cy in centres)
        yield f'<g fill="black">{circles}</g>'


def _printable(text: str) -> str:
    """The text without characters that XML forbids."""
    return "".join(letter if letter.isprintable() else " " for letter in text)
