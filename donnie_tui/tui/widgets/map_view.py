"""The map: a window on the floor that follows the robot or shows all of it, and repaints only what changed.

The terminal's own cursor stands on the robot, or on the explored square, while the map has the
focus; only then the window follows that square. A step is two columns wide if the world fits so,
because cells are twice as high as wide, and up to six by three if the learner zooms in. If a step has
several columns, things that differ only in colour have its initial, and robots that of their name. The core
knows places and names; this module lays them out, and ``map_painters`` paint them.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import TYPE_CHECKING, ClassVar

from rich.segment import Segment
from rich.style import Style
from textual.binding import Binding, BindingType
from textual.events import Click
from textual.geometry import Offset, Region, Size
from textual.message import Message
from textual.strip import Strip

from donnie_tui.tui.themes import COLOURS, block_of_sixteen
from donnie_tui.tui.widgets.map_painters import Blocks, Extent, Letters, Painter
from donnie_tui.tui.widgets.rows import PaintedRows

if TYPE_CHECKING:
    from donnie_tui.core.map_grid import Bounds, Cell, MapGrid
    from donnie_tui.core.map_scene import MapScale, MapScene
    from donnie_tui.core.map_words import Pointer

_MARGIN = 3
"""Cells that stay visible between the robot and the border, if there is more floor beyond."""

RULER = 4
"""Columns of the numbers at the left; at the top they take one row."""
_EVERY = 5
"""Steps between two numbers."""

FARTHEST, NEAREST = -5, len(Letters.extents) - 1

OUTSIDE = "+"
"""The mark at the edge for a thing, a robot or a goal outside. No thing has this letter."""
_COVERED = ("free", "trail", "wall", "ray")
"""The kinds that such a mark may cover."""
_ROBOT = Style(bold=True, reverse=True)
_UNDER_NAMES = ("free", "trail", "ray")
"""The kinds that a name may cover."""


class MapView(PaintedRows, can_focus=True):
    """Shows a ``MapScene``. Empty until it is given one."""

    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("up", "explore(0, 1)"),
        Binding("down", "explore(0, -1)"),
        Binding("left", "explore(-1, 0)"),
        Binding("right", "explore(1, 0)"),
        Binding("home", "app.do('to_robot')"),
        Binding("n", "app.do('next_thing')"),
        Binding("p,backspace", "app.do('previous_thing')"),
        Binding("plus,equals_sign", "app.do('zoom_in')"),
        Binding("minus", "app.do('zoom_out')"),
        Binding("a", "app.do('whole_map')"),
        Binding("t", "app.do('names')"),
        Binding("c", "app.do('coordinates')"),
        Binding("l", "app.do('legend')"),
        Binding("f", "app.do('from_here')"),
        Binding("w", "app.do('to_there')"),
    ]

    class Explored(Message):
        """Another square was explored."""

    class EdgesChanged(Message):
        """The sides with floor outside the window have changed."""

    class RulersChanged(Message):
        """The numbers at the edges were shown or hidden, which changes the map's size."""

    def __init__(self, *, id: str) -> None:  # noqa: A002 -- Textual's own name
        super().__init__(id=id)
        self.scale: MapScale | None = None
        self.pointer: Pointer | None = None
        self.shows_all = False
        self.has_rulers = False
        self._labels: Callable[[MapScale, int], dict[Cell, str]] | None = None
        self._written: dict[Cell, str] = {}
        self._zoom = 0
        self._letters = Letters()
        self._painter: Painter = self._letters
        self._extent = self._painter.extents[0]
        self.hidden: tuple[str, ...] = ()
        """The sides with more floor outside."""
        self._marks: frozenset[Offset] = frozenset()
        """The places on the edge with ``OUTSIDE``."""
        self._bounds: Bounds
        """The bounds of the last layout."""

    # --- what is shown

    def show(self, scene: MapScene, *, whole: bool = False) -> None:
        """Show another floor, all of it or as much as fits."""
        from donnie_tui.core.map_scene import MapScale
        from donnie_tui.core.map_words import Pointer

        self.scale, self.pointer = MapScale(scene), Pointer(scene)
        self._zoom, self.shows_all = 0, whole
        self._letters.mixed = scene.letters_of_several_colours
        self._fit()

    def call_colours(self, initials: Mapping[str, str]) -> None:
        """Set the initials of colours, in the learner's language."""
        self._letters.initials = initials

    def restart(self) -> None:
        """Lay out and paint everything again."""
        self._fit()

    def begin(self, cells: Iterable[Cell]) -> None:
        """Paint cells at the beginning of a run, and follow the robot."""
        self.update_cells(cells)
        if self.scale is not None:
            self._follow(self._followed, centre=True)

    def update_cells(self, cells: Iterable[Cell]) -> None:
        """Paint cells that look different, and follow the robot."""
        if self.scale is None:
            return
        squares = self.scale.squares_of(cells)
        if self._bounds != self.scale.bounds:
            self._fit()
        elif squares:
            self.refresh(*map(self._region_of, squares))
            self._write_names(squares)
            if self._followed == self.scale.robot:
                self._follow(self.scale.robot)
            else:
                self._mark_edges()

    @property
    def grid(self) -> MapGrid | None:
        return self.scale.scene.grid if self.scale else None

    @property
    def is_exploring(self) -> bool:
        return self.pointer is not None and self.pointer.cell is not None

    # --- how it is shown

    @property
    def zoom(self) -> int:
        """The zoom: 0 is a square a step, above 0 nearer, below 0 farther."""
        if self.shows_all and self.scale is not None:
            return -(self.scale.factor - 1).bit_length()
        return self._zoom

    @property
    def columns(self) -> int:
        """Columns of a square."""
        return self._extent.columns

    def set_zoom(self, zoom: int) -> bool:
        """Zoom as far as possible; whether that has changed the map."""
        before, size = (self._zoom, self.shows_all), self._square_size
        self._zoom = max(FARTHEST, min(NEAREST, zoom))
        self.shows_all = False
        self._fit()
        if self._square_size == size:
            self._zoom, self.shows_all = before
            self._fit()
            return False
        return True

    @property
    def _square_size(self) -> tuple[int | None, Extent]:
        """The steps of a square, and its size on the screen."""
        return self.scale.factor if self.scale else None, self._extent

    def show_all(self, whole: bool) -> None:
        """Show the whole floor, or follow the robot at the zoom of before."""
        self.shows_all = whole
        self._fit()

    def show_names(self, labels: Callable[[MapScale, int], dict[Cell, str]] | None) -> None:
        """Show names next to the things, placed by ``labels``; None hides them."""
        self._labels = labels
        self._fit()

    @property
    def has_names(self) -> bool:
        return self._labels is not None

    @property
    def is_picture(self) -> bool:
        return self._painter is not self._letters

    @property
    def has_colours(self) -> bool:
        """Whether the terminal has the colours for a picture."""
        return not self.app.no_color

    def show_picture(self, wanted: bool) -> None:
        """Show coloured blocks instead of letters, or letters again."""
        self._painter = Blocks() if wanted and self.has_colours else self._letters
        self._fit()

    def show_rulers(self, shown: bool) -> None:
        """Show or hide numbers at the left and at the top: steps to the north and to the east."""
        self.has_rulers = shown
        self._fit()
        self.post_message(self.RulersChanged())

    # --- size and place

    def on_resize(self) -> None:
        self._fit()

    @property
    def rulers(self) -> Offset:
        """The columns and rows of the numbers."""
        return Offset(RULER, 1) if self.has_rulers else Offset(0, 0)

    def _fit(self) -> None:
        if self.scale is None:
            return
        room = Size(max(1, self.size.width - self.rulers.x), max(1, self.size.height - self.rulers.y))
        self._choose_factor(room)
        bounds = self._bounds = self.scale.bounds
        fitting = self._painter.fitting(Size(bounds.width, bounds.height), room)
        nearer = 0 if self.shows_all else max(0, self._zoom)
        extent = self._extent = self._painter.extents[min(fitting + nearer, NEAREST)]
        floor = Size(extent.columns * bounds.width, extent.rows * -(-bounds.height // extent.stacked))
        self.virtual_size = Size(floor.width + self.rulers.x, floor.height + self.rulers.y)
        self._written = self._labels(self.scale, self._extent.columns) if self._labels else {}
        self._follow(self._followed, centre=True)
        self._note_hidden()
        self.refresh()

    def _note_hidden(self) -> None:
        """Note which sides of the floor are outside the window."""
        (left, top), size, floor = self.scroll_offset, self.size, self.virtual_size
        sides = {
            "north": top > 0,
            "east": left + size.width < floor.width,
            "south": top + size.height < floor.height,
            "west": left > 0,
        }
        hidden = tuple(side for side, is_outside in sides.items() if is_outside and size.area)
        if hidden != self.hidden:
            self.hidden = hidden
            self.post_message(self.EdgesChanged())
        self._mark_edges()

    @property
    def _window(self) -> Region:
        """The part of the widget that shows floor."""
        return self.size.region.shrink((self.rulers.y, 0, 0, self.rulers.x))

    def _mark_edges(self) -> None:
        """Update the marks at the edges."""
        if not self.hidden and not self._marks:
            return
        assert self.scale is not None
        window = self._window
        standing = self.scale.squares_of(self.scale.scene.standing) if self.hidden else frozenset()
        places = (self._region_of(square) for square in standing)
        middles = (
            place.offset + Offset(place.width // 2, place.height // 2)
            for place in places
            if not window.overlaps(place)
        )
        marks = frozenset(
            window.offset + (middle - window.offset).clamp(window.width, window.height) for middle in middles
        )
        if marks != self._marks:
            gone_or_new = marks ^ self._marks
            self._marks = marks
            self.refresh(*(Region(*place, 1, 1) for place in gone_or_new))

    def _choose_factor(self, room: Size) -> None:
        from donnie_tui.core.map_scene import factor_for

        assert self.scale is not None
        if self.shows_all:
            stacked = self._painter.extents[0].stacked
            self.scale.factor = factor_for(self.scale.scene.bounds, room.width, room.height * stacked)
        else:
            self.scale.factor = 2 ** max(0, -self._zoom)

    def _write_names(self, squares: frozenset[Cell]) -> None:
        """Place the names again if one of the squares has changed."""
        if self._labels is None or self.scale is None:
            return
        written = self._labels(self.scale, self._extent.columns)
        changed = {each for each, _ in written.items() ^ self._written.items()}
        self._written = written
        if changed - squares:
            self.refresh(*map(self._region_of, changed - squares))

    @property
    def _square(self) -> Cell:
        """The square under the cursor: the robot's, unless another one is explored."""
        assert self.scale is not None and self.pointer is not None
        return self.scale.square_of(self.pointer.here)

    @property
    def _followed(self) -> Cell:
        """The square to keep visible; without the focus the robot's."""
        assert self.scale is not None
        return self._square if self.has_focus else self.scale.robot

    def on_focus(self) -> None:
        """Keep the cursor on the square that was explored last."""
        if self.scale is not None:
            self._follow(self._square)

    def _follow(self, square: Cell, *, centre: bool = False) -> None:
        """Scroll to the square, no further than needed; on a new floor, put it into the middle."""
        place = self._region_of(square, scrolled=False)
        if not centre:
            place = place.grow((_MARGIN,) * 4)
        self.scroll_to_region(place, animate=False, force=True, center=centre, immediate=True)
        self._note_hidden()

    def _region_of(self, square: Cell, *, scrolled: bool = True) -> Region:
        bounds = self._bounds
        extent = self._extent
        down = (bounds.top - square.y) // extent.stacked * extent.rows
        place = Offset((square.x - bounds.left) * extent.columns, down) + self.rulers
        size = Size(extent.columns, extent.rows)
        return Region.from_offset(place - self.scroll_offset if scrolled else place, size)

    @property
    def cursor_screen_offset(self) -> Offset:
        """The place of the terminal's cursor, which braille displays and console readers follow."""
        if self.scale is None:
            return self.content_region.offset
        return self.content_region.offset + self._region_of(self._square).offset

    # --- exploring

    def action_explore(self, east: int, north: int) -> None:
        """Move the pointer by one square."""
        if self.pointer is not None and self.scale is not None:
            factor = self.scale.factor
            self.explore(lambda pointer: pointer.move(east * factor, north * factor))

    def on_click(self, event: Click) -> None:
        """Explore the clicked square, if there is floor."""
        place, scale = event.get_content_offset(self), self.scale
        if place is None or scale is None:
            return
        square, bounds = self._square_at(place), self._bounds
        if bounds.left <= square.x <= bounds.right and bounds.bottom <= square.y <= bounds.top:
            self.explore(lambda pointer: pointer.go(scale.cell_of(square)))

    def _square_at(self, place: Offset) -> Cell:
        """The square at a place of the widget, also beyond the floor."""
        assert self.scale is not None
        right, down = place - self.rulers + self.scroll_offset
        bounds, extent = self._bounds, self._extent
        return self.scale.robot._replace(
            x=bounds.left + right // extent.columns, y=bounds.top - down // extent.rows * extent.stacked
        )

    def explore(self, change: Callable[[Pointer], object]) -> None:
        """Move the pointer."""
        if self.pointer is None:
            return
        before = self._square
        change(self.pointer)
        self.refresh(self._region_of(before), self._region_of(self._square))
        self._follow(self._square)
        self.post_message(self.Explored())

    # --- painting

    def render_line(self, y: int) -> Strip:
        """A row of the window; equal neighbours are one segment."""
        base = self.painted_as()
        if self.scale is None:
            return Strip.blank(self.size.width, base)
        ruler_x, ruler_y = self.rulers
        if y < ruler_y:
            return self._top_ruler()
        down, row = divmod(y - ruler_y + self.scroll_offset.y, self._extent.rows)
        north = self._bounds.top - down * self._extent.stacked
        floor = self._floor_row(north, row).crop_extend(0, self.size.width - ruler_x, base)
        strip = Strip.join([self._left_ruler(north, row), floor]) if ruler_x else floor
        return self._with_marks(strip, y) if self._marks else strip

    def _with_marks(self, strip: Strip, y: int) -> Strip:
        """The row with its marks, which cover no thing, robot or goal."""
        assert self.scale is not None
        window = self._window
        is_end = y in (window.y, window.bottom - 1)
        for x in range(window.x, window.right) if is_end else (window.x, window.right - 1):
            place = Offset(x, y)
            if place in self._marks and self.scale.shown(self._square_at(place))[1] in _COVERED:
                mark = Strip([Segment(OUTSIDE, self._look("outside"))])
                strip = Strip.join([strip.crop(0, x), mark, strip.crop(x + 1)])
        return strip

    def _floor_row(self, north: int, row: int) -> Strip:
        """A row of the squares at that distance to the north."""
        assert self.scale is not None
        if north < self._bounds.bottom:
            return Strip.blank(self.size.width, self.painted_as())
        first, last = self._visible_columns()
        segments = [self._segment(self.scale.robot._replace(x=x, y=north), row) for x in range(first, last)]
        strip = Strip(Segment.simplify(segments))
        cut = self.scroll_offset.x - (first - self._bounds.left) * self._extent.columns
        return strip.crop_extend(cut, cut + self.size.width, self.painted_as())

    def _visible_columns(self) -> tuple[int, int]:
        first = self._bounds.left + self.scroll_offset.x // self._extent.columns
        return first, min(self._bounds.right + 1, first + self.size.width // self._extent.columns + 2)

    def _segment(self, square: Cell, row: int) -> Segment:
        assert self.scale is not None
        extent = self._extent
        squares = [square._replace(y=square.y - below) for below in range(extent.stacked)]
        label = next((self._written[each] for each in squares if each in self._written), None)
        if label and not row and all(self.scale.shown(each)[1] in _UNDER_NAMES for each in squares):
            painted = Segment(label, self._look("name"))
        else:
            painted = self._painter.paint(self.scale, square, extent, row, self._look)
        if self.has_focus and self.is_exploring and self._square in squares:
            if extent.stacked > 1:  # reversed, half a block would be the other half
                letter, kind = self.scale.shown(self._square)
                painted = Segment(letter, self._look(kind))
            return Segment(painted.text, (painted.style or Style()) + Style(reverse=True))
        return painted

    def _look(self, kind: str) -> Style:
        """The style of a kind. Things of an unknown colour are grey; other robots have their own colour."""
        _other, is_robot, colour = kind.partition("other-")
        if is_robot and colour in COLOURS:
            return self.painted_as(f"thing-{colour}") + _ROBOT
        if is_robot:
            return self.painted_as("other")
        _thing, is_thing, colour = kind.partition("thing-")
        if not is_thing:
            return self.painted_as(kind)
        colour = colour if colour in COLOURS else "gray"
        painted = self.painted_as(f"thing-{colour}")
        if self.is_picture and self.app.console.color_system == "standard":
            painted += block_of_sixteen(self.app.theme, colour)
        return painted

    # --- numbers

    def _left_ruler(self, north: int, row: int) -> Strip:
        places = [self._place(self._bounds.left, north - below)[1] for below in range(self._extent.stacked)]
        number = next((str(each) for each in places if each % _EVERY == 0), "")
        has_room = north >= self._bounds.bottom and not row and len(number) <= RULER
        words = f"{number:>{RULER - 1}}" if has_room else ""
        return Strip([Segment(words.ljust(RULER), self._look("ruler"))])

    def _top_ruler(self) -> Strip:
        first, last = self._visible_columns()
        line = [" "] * self.size.width
        for x in range(first, last):
            place = self._place(x, self._bounds.bottom)[0]
            at = (x - self._bounds.left) * self._extent.columns - self.scroll_offset.x + RULER
            if place % (_EVERY if self._extent.columns > 1 else 2 * _EVERY) == 0 and at >= RULER:
                for column, letter in enumerate(str(place), at):
                    if column < self.size.width:
                        line[column] = letter
        return Strip([Segment("".join(line), self._look("ruler"))])

    def _place(self, x: int, y: int) -> tuple[int, int]:
        assert self.scale is not None
        return self.scale.scene.place(
            self.scale.robot._replace(x=x * self.scale.factor, y=y * self.scale.factor)
        )
