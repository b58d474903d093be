"""Braille for paper and displays: text in six dots, and a world as braille pages.

Text is North American ASCII braille, one sign a cell: uncontracted, without signs for capitals, with the
accents of Portuguese and Spanish braille.

A world becomes pages of 40 cells by 25 lines: a map to scale, and a legend next to or after it. The file is
BRF for an embosser (ASCII braille, a form feed after each page) or a braille display.
"""

from __future__ import annotations

import textwrap
import unicodedata
from collections.abc import Iterator

from donnie_tui.core.chart import Chart, shrunk
from donnie_tui.core.map_grid import FREE, WALL
from donnie_tui.core.wording import Wording
from language.locales import own_words

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
    """The lines without the blank ones at the foot of the page."""
    last = max((number for number, line in enumerate(lines) if line), default=-1)
    yield from lines[: last + 1]
