"""A world as braille pages of 40 cells by 25 lines: a map to scale, and a legend, which follows if it must.

Made for an embosser (the file is BRF: ASCII braille, a form feed after each page) and for a braille display.
"""

from __future__ import annotations

import textwrap
from collections.abc import Iterator

from donnie_tui.core.braille import FULL_CELL, braille
from donnie_tui.core.chart import Chart, shrunk
from donnie_tui.core.map_grid import FREE, WALL
from donnie_tui.core.wording import Wording

CELLS, LINES = 40, 25
_HEADING = 2
"""Lines above the map: its name, its scale."""
_SLENDER = 5 / 3
"""A braille cell with its gaps is 6 mm wide and 10 mm high."""


def braille_pages(name: str, chart: Chart, wording: Wording) -> str:
    """The pages of the world ``name``, with line ends and form feeds as embossers want them."""
    legend = _legend(chart, wording)
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
    rows = shrunk(chart.rows, across, down, robots)
    return [row.upper().replace(FREE, " ").replace(WALL, FULL_CELL).rstrip() for row in rows]


def _heading(name: str, width: int, height: int, wording: Wording) -> list[str]:
    title = braille(wording("paper-title", name=name), wording.language)
    scale = braille(wording("paper-cell", width=width, height=height), wording.language)
    return [title[:CELLS], scale[:CELLS]]


def _legend(chart: Chart, wording: Wording) -> list[str]:
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
    """Blank lines at the foot of a page say nothing."""
    last = max((number for number, line in enumerate(lines) if line), default=-1)
    yield from lines[: last + 1]
