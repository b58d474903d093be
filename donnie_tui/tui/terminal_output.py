"""The output to the terminal: sends only changed cells, since an SSH connection may be slow.

A row that scrolls, or a letter in a line, costs only the cells that differ from what was there. In the
plain layout screen readers speak what is written, so a row that differs is
written whole, except for letters that are typed in it.

This module alone uses the private names of Textual for its updates. ``diff_output`` in ``terminal`` checks
with ``fits`` whether they are as this module needs them; otherwise Textual's own output is sent.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import lru_cache
from itertools import groupby
from typing import cast

from rich.cells import cell_len
from rich.color import ColorSystem
from rich.console import Console, RenderableType
from rich.control import Control
from rich.segment import Segment
from rich.style import Style
from textual._compositor import (  # Textual's only names for what it paints
    ChopsUpdate,
    CompositorUpdate,
    LayoutUpdate,
)
from textual.geometry import Offset, Region
from textual.strip import Strip

_GAP = 16
"""Writing that many equal cells between two changed ones costs less than moving the cursor."""
_MOST_TYPED = 2
"""Rows that a typed letter may change: its own, and the status line."""
_FIRST_COMBINING = "\u0300"
_SOFT_HYPHEN = "\xad"

Update = ChopsUpdate | LayoutUpdate
"""Parts of the screen, or all of it."""
Cell = tuple[str, Style]
Piece = tuple[Style, str]
"""A style, and a text with the way to its place."""


def fits(console: Console) -> bool:
    """Whether the updates of this version of Textual have the expected form.

    Renders two small ones: the first must equal Textual's output, the second must leave one letter.
    """
    try:
        first, second = (Strip([Segment(text, Style.null())]) for text in ("ab", "ac"))
        whole = LayoutUpdate([[first]], Region(0, 0, 2, 1))
        part = ChopsUpdate([{0: second}], [(0, 0, 2)], [[2]])
        painted = Painted()
        given = FullRepaint(whole, painted).render_segments(console)
        sent = ChangedCells(part, painted).render_segments(console)
        return given == whole.render_segments(console) and "c" in sent and "a" not in sent
    except (AttributeError, LookupError, TypeError, ValueError):
        return False


class Painted:
    """The cells that the terminal shows, as far as they are known."""

    def __init__(self) -> None:
        self._cells: dict[tuple[int, int], Cell] = {}
        self._first: LayoutUpdate | None = None
        """The update that was painted on an unknown screen; read before the next one."""

    def forget(self) -> None:
        """Assume nothing about the terminal, so that the next update is painted whole."""
        self._cells.clear()
        self._first = None

    def less(
        self, update: RenderableType | None, *, rows: bool = False, typing: Offset | None = None
    ) -> RenderableType | None:
        """The update without the cells that are shown already. ``rows``: a row that differs is written whole.

        ``typing``: the cursor in a typed text; new letters there are written alone.
        """
        if isinstance(update, LayoutUpdate) and not self._knows_something:
            return cast(RenderableType, FullRepaint(update, self))
        if isinstance(update, Update):
            return cast(RenderableType, ChangedCells(update, self, rows=rows, typing=typing))
        if update is not None:
            self.forget()
        return update

    def begin_with(self, update: LayoutUpdate) -> None:
        """Note an update that was painted on an unknown screen."""
        self._first = update

    @property
    def _knows_something(self) -> bool:
        return self._first is not None or bool(self._cells)

    def learn(self) -> None:
        """Read the cells of the first update, before another one is compared with it."""
        first, self._first = self._first, None
        if first is not None:
            for x, y, strip in _strips_of(first):
                cells = _cells_of(strip) or ()
                self._cells.update({(at, y): cell for at, cell in enumerate(cells, x)})

    def differs(self, x: int, y: int, strip: Strip, *, letters: bool = False) -> int | None:
        """The first column whose style or text (with ``letters`` the text alone) differs, or None."""
        cells = _cells_of(strip)
        if cells is None:
            return x
        for at, cell in enumerate(cells, x):
            shown = self._cells.get((at, y))
            if shown is None or (shown[0] != cell[0] if letters else shown != cell):
                return at
        return None

    def changes(self, x: int, y: int, strip: Strip, *, rows: bool) -> Iterator[Piece]:
        """The pieces that make the terminal show the strip, which counts as shown then."""
        cells = _cells_of(strip)
        if cells is None:
            for at in range(x, x + strip.cell_length):
                self._cells.pop((at, y), None)
            yield from _as_it_is(x, y, strip)
            return
        changed = [at for at, cell in enumerate(cells) if self._cells.get((x + at, y)) != cell]
        self._cells.update({(x + at, y): cells[at] for at in changed})
        if rows and changed:
            end = max((changed[-1], *(at for at, (letter, _) in enumerate(cells) if letter != " "))) + 1
            yield from _pieces_of(x, y, cells[:end])
            return
        for begin, end in _runs(changed):
            yield from _pieces_of(x + begin, y, cells[begin:end])


class FullRepaint(CompositorUpdate):
    """A whole screen, noted only when it is written, as Textual drops some updates."""

    def __init__(self, update: LayoutUpdate, painted: Painted) -> None:
        self._update, self._painted = update, painted

    def render_segments(self, console: Console) -> str:
        self._painted.begin_with(self._update)
        return self._update.render_segments(console)


class ChangedCells(CompositorUpdate):
    """Textual's update without the cells that are shown already. Each style is written once."""

    def __init__(
        self, update: Update, painted: Painted, *, rows: bool = False, typing: Offset | None = None
    ) -> None:
        self._update, self._painted, self._rows, self._typing = update, painted, rows, typing

    def render_segments(self, console: Console) -> str:
        self._painted.learn()
        by_style: dict[Style, list[str]] = {}
        pieces = list(_strips_of(self._update))
        typed = self._typed_row(pieces, self._typing) if self._rows and self._typing else None
        for x, y, strip in pieces:
            for style, text in self._painted.changes(x, y, strip, rows=self._rows and y != typed):
                by_style.setdefault(style, []).append(text)
        colours = console._color_system or ColorSystem.TRUECOLOR  # as Textual's strips ask for it
        return "".join(
            Strip.render_style(style, "".join(texts), colours) for style, texts in by_style.items()
        )

    def _typed_row(self, pieces: Sequence[tuple[int, int, Strip]], cursor: Offset) -> int | None:
        """The row of the cursor, if only letters there differ; None if other rows change, too."""
        differing = {
            y: (x, strip) for x, y, strip in pieces if self._painted.differs(x, y, strip) is not None
        }
        if cursor.y not in differing or len(differing) > _MOST_TYPED:
            return None
        x, strip = differing[cursor.y]
        first = self._painted.differs(x, cursor.y, strip, letters=True)
        return cursor.y if first is not None and first >= cursor.x - 2 else None


def _strips_of(update: Update) -> Iterator[tuple[int, int, Strip]]:
    """Column, row and cells of each painted strip, from the beginning of its widget's row."""
    return _strips_of_all(update) if isinstance(update, LayoutUpdate) else _strips_of_parts(update)


def _strips_of_all(update: LayoutUpdate) -> Iterator[tuple[int, int, Strip]]:
    for y, strips in enumerate(update.strips, update.region.y):
        x = update.region.x
        for strip in strips:
            yield x, y, strip
            x += strip.cell_length


def _strips_of_parts(update: ChopsUpdate) -> Iterator[tuple[int, int, Strip]]:
    for y, first, last in update.spans:
        for end, (x, strip) in zip(update.chop_ends[y], update.chops[y].items(), strict=False):
            if strip is not None and x <= last and end > first:
                yield x, y, strip.crop(0, last - x)


def _runs(changed: Sequence[int]) -> Iterator[tuple[int, int]]:
    """The runs of changed columns, end excluded, near ones joined."""
    begin = 0
    for at in range(len(changed)):
        is_last = at + 1 == len(changed)
        if is_last or changed[at + 1] - changed[at] > _GAP:
            yield changed[begin], changed[at] + 1
            begin = at + 1


def _cells_of(strip: Strip) -> list[Cell] | None:
    """The cells of a strip; None if a letter may be wider than a cell, or have none."""
    cells: list[Cell] = []
    for text, style, control in strip:
        if control or not _is_simple(text):
            return None
        look = style or Style.null()
        blank = _of_blank(look)
        cells.extend((letter, blank if letter == " " else look) for letter in text)
    return cells


def _is_simple(text: str) -> bool:
    return text.isascii() or (max(text) < _FIRST_COMBINING and _SOFT_HYPHEN not in text)


@lru_cache(1024)
def _of_blank(style: Style) -> Style:
    """The part of a style that is visible on a blank."""
    if style.underline or style.underline2 or style.reverse or style.strike or style.overline or style.link:
        return style
    return Style(bgcolor=style.bgcolor)


def _pieces_of(x: int, y: int, cells: Sequence[Cell]) -> Iterator[Piece]:
    """A piece for each style; blanks take the style before them if that looks the same."""
    worn: list[Cell] = []
    for letter, look in cells:
        before = worn[-1][1] if worn else look
        worn.append((letter, before if letter == " " and _of_blank(before) == look else look))
    for look, run in groupby(worn, lambda cell: cell[1]):
        text = "".join(letter for letter, _ in run)
        yield look, _at(x, y) + text
        x += len(text)


def _as_it_is(x: int, y: int, strip: Strip) -> Iterator[Piece]:
    for text, style, _control in strip:
        yield style or Style.null(), _at(x, y) + text
        x += cell_len(text)


def _at(x: int, y: int) -> str:
    return Control.move_to(x, y).segment.text
