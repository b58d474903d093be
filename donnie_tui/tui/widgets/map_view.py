"""The map: a window on the floor that follows the robot, and repaints only what changed.

The terminal's own cursor stands on the robot, or on the cell that is being explored, while the map has the
focus. A step is two columns wide where the world fits so, because cells are twice as high as wide.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, ClassVar

from rich.segment import Segment
from rich.style import Style
from textual.binding import Binding, BindingType
from textual.geometry import Offset, Region, Size
from textual.message import Message
from textual.scroll_view import ScrollView
from textual.strip import Strip

if TYPE_CHECKING:
    from devices.ports.robot import Pose
    from donnie_tui.core.map_grid import Cell, MapGrid

_MARGIN = 3
"""Cells that stay visible between the robot and the border, where there is more floor beyond."""

_KINDS = ("robot", "start", "trail", "wall", "free", "thing")
"""As ``map_grid.Kind`` has them; it is loaded later than this."""
_SOLID = ("wall", "thing")


class MapView(ScrollView, can_focus=True):
    """Shows a ``MapGrid``. Empty until it is given one."""

    COMPONENT_CLASSES: ClassVar[set[str]] = {f"map-view--{kind}" for kind in _KINDS}

    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("up", "explore(0, 1)", show=False),
        Binding("down", "explore(0, -1)", show=False),
        Binding("left", "explore(-1, 0)", show=False),
        Binding("right", "explore(1, 0)", show=False),
        Binding("home", "robot", show=False),
    ]

    class Explored(Message):
        """Another cell is being explored."""

    def __init__(self, *, id: str) -> None:  # noqa: A002 -- Textual's own name
        super().__init__(id=id)
        self._grid: MapGrid | None = None
        self._columns = 1
        self._explored: Cell | None = None
        self._looks: dict[str, Style] = {}

    # --- what is shown

    def show(self, grid: MapGrid) -> None:
        """Another floor."""
        self._grid = grid
        self._explored = None
        self._fit()

    def begin(self, pose: Pose) -> None:
        """A run begins here: the trail is gone."""
        if self._grid:
            self._grid.begin(pose)
            self._fit()

    def move(self, poses: tuple[Pose, ...]) -> None:
        """The robot went through these places, one after the other."""
        if self._grid is None:
            return
        bounds = self._grid.bounds
        changed = set().union(*map(self._grid.move, poses))
        if self._grid.bounds != bounds:
            self._fit()
        elif changed:
            self.refresh(*map(self._region_of, changed))
            self._follow(self._grid.robot)

    @property
    def cell(self) -> Cell:
        """The cell under the cursor: the robot's, unless another one is being explored."""
        assert self._grid is not None
        return self._explored or self._grid.robot

    @property
    def grid(self) -> MapGrid | None:
        return self._grid

    @property
    def is_exploring(self) -> bool:
        return self._explored is not None

    # --- size and place

    def on_resize(self) -> None:
        self._fit()

    def _fit(self) -> None:
        if self._grid is None:
            return
        bounds = self._grid.bounds
        self._columns = 2 if 2 * bounds.width <= self.size.width else 1
        self.virtual_size = Size(self._columns * bounds.width, bounds.height)
        self._follow(self.cell, centre=True)
        self.refresh()

    def _follow(self, cell: Cell, *, centre: bool = False) -> None:
        """Scroll no further than needed while it moves; on a new floor, put it into the middle."""
        place = self._region_of(cell, scrolled=False)
        if not centre:
            place = place.grow((_MARGIN,) * 4)
        self.scroll_to_region(place, animate=False, force=True, center=centre, immediate=True)

    def _region_of(self, cell: Cell, *, scrolled: bool = True) -> Region:
        assert self._grid is not None
        bounds = self._grid.bounds
        place = Offset((cell.x - bounds.left) * self._columns, bounds.top - cell.y)
        return Region.from_offset(place - self.scroll_offset if scrolled else place, Size(self._columns, 1))

    @property
    def cursor_screen_offset(self) -> Offset:
        """Braille displays and console readers look where the terminal's cursor is: here."""
        if self._grid is None:
            return self.content_region.offset
        return self.content_region.offset + self._region_of(self.cell).offset

    # --- exploring

    def action_explore(self, east: int, north: int) -> None:
        if self._grid is None:
            return
        bounds, cell = self._grid.bounds, self.cell
        x = min(max(cell.x + east, bounds.left), bounds.right)
        y = min(max(cell.y + north, bounds.bottom), bounds.top)
        self._explore(cell._replace(x=x, y=y))

    def action_robot(self) -> None:
        if self._grid is not None:
            self._explore(None)

    def _explore(self, cell: Cell | None) -> None:
        before = self.cell
        self._explored = cell
        self.refresh(self._region_of(before), self._region_of(self.cell))
        self._follow(self.cell)
        self.post_message(self.Explored())

    # --- painting

    def notify_style_update(self) -> None:
        self._looks = {}
        super().notify_style_update()

    def render_line(self, y: int) -> Strip:
        """One row of the window, equal neighbours joined into one segment."""
        base = self.rich_style
        if self._grid is None:
            return Strip.blank(self.size.width, base)
        bounds = self._grid.bounds
        north = bounds.top - y - self.scroll_offset.y
        if north < bounds.bottom:
            return Strip.blank(self.size.width, base)
        first, last = self._visible_columns()
        segments = [self._segment(self._grid.robot._replace(x=x, y=north)) for x in range(first, last)]
        strip = Strip(Segment.simplify(segments))
        cut = self.scroll_offset.x - (first - bounds.left) * self._columns
        return strip.crop_extend(cut, cut + self.size.width, base)

    def _visible_columns(self) -> tuple[int, int]:
        assert self._grid is not None
        bounds = self._grid.bounds
        first = bounds.left + self.scroll_offset.x // self._columns
        return first, min(bounds.right + 1, first + self.size.width // self._columns + 2)

    def _segment(self, cell: Cell) -> Segment:
        assert self._grid is not None
        kind = self._grid.kind(cell).value
        look = self._look(kind)
        if cell == self._explored and self.has_focus:
            look += Style(reverse=True)
        letter = self._grid.letter(cell)
        return Segment(letter + self._filling(kind, letter) if self._columns == 2 else letter, look)

    def _filling(self, kind: str, letter: str) -> str:
        """The second column of a wide cell: walls and things are solid, all else is a letter and a blank."""
        return letter if kind in _SOLID else " "

    def _look(self, kind: str) -> Style:
        if kind not in self._looks:
            self._looks[kind] = self.get_component_rich_style(f"map-view--{kind}")
        return self._looks[kind]
