"""The main screen: program, map, inspector, log, command line, status line, keys, in the order of reading.

A view: it shows values and posts messages, and decides nothing about programs. On a small
terminal it shows one pane at a time; the command line and the status line are always visible.
"""

from __future__ import annotations

from collections.abc import Iterable
from contextlib import ExitStack
from typing import TYPE_CHECKING

from textual.app import ComposeResult
from textual.containers import Horizontal, Vertical
from textual.errors import NoWidget
from textual.events import DescendantFocus, Resize, ScreenResume
from textual.geometry import Region, Size
from textual.message import Message
from textual.screen import Screen
from textual.widget import Widget
from textual.widgets import Static

from donnie_tui.tui.terminal import unskipped
from donnie_tui.tui.widgets.command_line import CommandLine, Pane
from donnie_tui.tui.widgets.editor import Editor
from donnie_tui.tui.widgets.log_rows import LogRows
from donnie_tui.tui.widgets.map_view import MapView
from donnie_tui.tui.widgets.rows import (
    FIXED_ROWS,
    LOWEST,
    NARROW,
    KeyLine,
    Slider,
    StatusLine,
    TextRows,
    inspector_look,
)

if TYPE_CHECKING:
    from donnie_tui.core.map_scene import MapScene
    from donnie_tui.tui.screens.pages import TourStrip

WIDE, LOW = 110, 18
"""With WIDE columns there is room for the inspector; below NARROW or LOW for one pane only."""

LONGEST_HELD = 0.15
"""Seconds."""

LEAST_PROGRAM, LEAST_MAP = 39, 20
"""The least columns of a program and of a map."""
LEAST_LOG = 9
"""Rows, with its title."""
_INSPECTOR = 30
"""Columns of the inspector next to the map."""


def _is_small(size: Size) -> bool:
    return size.width < NARROW or size.height < LOW


class MainScreen(Screen[None]):
    """The main screen."""

    HORIZONTAL_BREAKPOINTS = [(0, "-narrow"), (NARROW, "-normal"), (WIDE, "-wide")]  # noqa: RUF012 -- Textual's
    VERTICAL_BREAKPOINTS = [(0, "-lowest"), (LOWEST, "-low"), (LOW, "-high"), (32, "-tall")]  # noqa: RUF012

    class Looked(Message):
        """The focus or the cursor has moved."""

    class Entered(Message):
        """The focus moved from one part of the main screen to another."""

    def __init__(self, size: Size, *, plain: bool = False, focus: str = "", first_row: str = "") -> None:
        """``size`` is the terminal's size: to change a style class later costs a restyling.

        ``focus`` is the ``focus_was`` of the screen before; empty at the start. ``first_row`` is a sentence
        above all; empty for none.
        """
        super().__init__(id="main-screen", classes="-plain" if plain else "")
        self._first_row = first_row
        for breakpoints, cells in (
            (self.HORIZONTAL_BREAKPOINTS, size.width),
            (self.VERTICAL_BREAKPOINTS, size.height),
        ):
            self.add_class([name for least, name in breakpoints if least <= cells][-1])
        self.set_class(_is_small(size), "-one-pane")
        self.editor = Editor(id="editor")
        self.map = MapView(id="map")
        self.inspector = TextRows(id="inspector")
        self.inspector.look_of = inspector_look
        self.log_rows = LogRows(id="log")
        self.command_line = CommandLine(id="command", send=self._await_answer)
        self.status = StatusLine(id="status")
        self.keys = KeyLine(id="keys")
        self.program_pane = Pane(self.editor, id="program-pane")
        self.map_pane = Pane(self.map, id="map-pane")
        self.inspector_pane = Pane(self.inspector, id="inspector-pane")
        self.log_pane = Pane(self.log_rows, id="log-pane")
        self._shown = self.log_pane if plain else self.program_pane
        self.tour: TourStrip | None = None
        """While it is shown."""
        self._before_tour: Widget | None = None
        self._slider: Slider | None = None
        self._holding: ExitStack | None = None
        """While it is set nothing is painted."""
        self._entered: Widget | None = None
        """The last focused part."""
        self._shown.add_class("-shown")  # before they are mounted: afterwards each class costs a restyling
        self._shown.set_class(not plain, "-chosen")
        self._was_seen = False
        self.first_focus: Widget = self._parts.get(focus) or (self.command_line if plain else self.editor)
        """The widget that is focused from the start, since each change of panes costs a restyling."""
        self.AUTO_FOCUS = f"#{self.first_focus.id}"  # type: ignore[misc] # Textual asks the screen, not its class

    def compose(self) -> ComposeResult:
        if self._first_row:
            yield Static(self._first_row, id="first-row", markup=False)
        with Vertical(id="panes"):
            with Horizontal(id="upper", classes="" if self.is_plain else "-shown"):
                yield self.program_pane
                yield self.map_pane
                yield self.inspector_pane
            yield self.log_pane
        with Horizontal(id="command-row"):
            yield Static(">", id="prompt", markup=False)
            yield self.command_line
        yield self.status
        yield self.keys

    def on_screen_suspend(self) -> None:
        self.editor.suggestion = ""  # only typing continues an offered word

    def on_screen_resume(self, event: ScreenResume) -> None:
        """Skip Textual's first restyling, which is slow, since all styles are new."""
        event.refresh_styles = self._was_seen
        self._was_seen = True

    def on_mount(self) -> None:
        if self.is_plain:
            self.set_plain(True)
            self.first_focus.focus()

    @property
    def _parts(self) -> dict[str, Widget]:
        parts = (self.editor, self.map, self.inspector, self.log_rows, self.command_line)
        return {str(part.id): part for part in parts}

    @property
    def focus_was(self) -> str:
        """The last focused part, also after the screen has closed."""
        return str(self._entered.id) if self._entered is not None else ""

    # --- the tour

    def show_tour(self, strip: TourStrip) -> None:
        """Show the tour below the panes, and focus it."""
        self._before_tour = self.focused
        self.tour = strip
        self.mount(strip, before="#command-row")
        strip.focus()

    def close_tour(self) -> None:
        """Close the tour, and restore the focus."""
        strip, self.tour = self.tour, None
        if strip is not None:
            if strip.has_focus:
                (self._before_tour or self.editor).focus()
            strip.remove()

    # --- the run so far

    def show_slider(self, steps: tuple[int, int] | None) -> None:
        """Show the slider below the panes after STEP BACK; None hides it."""
        if steps is None or self.is_plain or self.is_small:
            slider, self._slider = self._slider, None
            if slider is not None:
                slider.remove()
            return
        if self._slider is None:
            self._slider = Slider()
            self.mount(self._slider, before="#command-row")
        self._slider.show(*steps)

    # --- panes

    @property
    def is_plain(self) -> bool:
        """Whether the layout is plain: one column without decoration, map and variables on their own."""
        return self.has_class("-plain")

    @property
    def is_small(self) -> bool:
        """Whether only one pane is visible at a time."""
        return self.has_class("-one-pane")

    def set_plain(self, plain: bool) -> None:
        self.set_class(plain, "-plain")
        self.editor.show_line_numbers = not plain
        self.log_rows.set_paged(plain)
        self._arrange()
        self._give_room()

    @property
    def log_is_seen(self) -> bool:
        try:
            return self.find_widget(self.log_rows).visible_region.height > 0
        except NoWidget:
            return False

    @property
    def focus_chain(self) -> list[Widget]:
        """The widgets in reading order; in the plain layout the command line is first and the map last."""
        tour = () if self.tour is None else (self.tour,)
        reading = (self.editor, self.map, self.inspector, self.log_rows, *tour, self.command_line)
        plain = (self.command_line, self.editor, self.log_rows, self.map, self.inspector)
        chain = super().focus_chain
        return [each for each in (plain if self.is_plain else reading) if each in chain]

    def room_around(self, row: int) -> Region:
        """The rows around that one that a list may cover."""
        fixed = [each.region for each in (self.command_line, self.status, self.keys) if each.region]
        top = max((each.bottom for each in fixed if each.bottom <= row), default=0)
        bottom = min((each.y for each in fixed if each.y > row), default=self.size.height)
        return Region(0, top, self.size.width, bottom - top)

    @property
    def panes(self) -> tuple[Pane, ...]:
        """The panes in reading order."""
        return (self.program_pane, self.map_pane, self.inspector_pane, self.log_pane)

    @property
    def focused_pane(self) -> Pane | None:
        return next((pane for pane in self.panes if pane.content.has_focus), None)

    def go_to(self, pane: Pane) -> None:
        """Show a pane and give it the focus."""
        self._show_pane(pane)
        pane.content.focus()

    def toggle_inspector(self) -> None:
        """Show or hide the inspector, in the map's place if there is no room for both."""
        if self.inspector.has_focus:
            self._inspect(False)
            self.go_to(self.program_pane)
        else:
            self._inspect(True)
            self.go_to(self.inspector_pane)

    def _inspect(self, inspecting: bool) -> None:
        """Show the inspector in the map's place, if there is room for only one."""
        if inspecting != self.has_class("-inspecting"):
            self.set_class(inspecting, "-inspecting")
            self._give_room()

    def on_descendant_focus(self, _event: DescendantFocus) -> None:
        self.hold_nothing()
        pane = self.focused_pane
        if pane is None and self.is_plain:
            pane = self.log_pane  # a reader speaks there what is answered at the command line
        if pane is not None:
            self._show_pane(pane)
        self.post_message(self.Looked())
        before, self._entered = self._entered, self.focused
        if before not in (None, self._entered):  # not at the start, nor after a question
            self.post_message(self.Entered())

    def on_resize(self, event: Resize) -> None:
        self.set_class(_is_small(event.size), "-one-pane")
        if self.map.has_focus or self.inspector.has_focus:
            self._inspect(self.inspector.has_focus)
        self._arrange()
        self._give_room()
        self.post_message(self.Looked())

    def _show_pane(self, pane: Pane) -> None:
        if pane is self.map_pane:
            self._inspect(False)
        if pane is not self._shown:
            self._shown = pane
            self._arrange()

    def _arrange(self) -> None:
        """Lay out the panes. On a small terminal hidden panes have no size, so that Tab reaches them."""
        for pane in self.panes:
            pane.set_class(pane is self._shown, "-shown")
        self.query_one("#upper").set_class(self._shown is not self.log_pane, "-shown")
        self.set_class(self._shown in (self.map_pane, self.inspector_pane), "-alone")

    # --- what it shows

    def show_map(self, scene: MapScene) -> None:
        """Show a whole floor; its pane takes the room that it needs, and leaves the program its own.

        In the plain layout, and on an endless empty floor, a square is a step.
        """
        is_room = scene.picture.has_walls or bool(scene.picture.things)
        self.map.show(scene, whole=is_room and not self.is_plain)
        self._give_room()

    def _give_room(self) -> None:
        """Give the map the floor's whole width if possible; for its whole height the log shrinks.

        The numbers at its edges also take room from the program and the log.
        """
        free = not self.has_class("-one-pane") and not self.has_class("-inspecting") and not self.is_plain
        floor = self.map.grid.bounds if self.map.grid else None
        numbers = self.map.rulers
        is_wide = self.size.width >= WIDE
        columns = self.size.width - (_INSPECTOR + 2 if is_wide else 1)
        rows = self.size.height - FIXED_ROWS
        given = Size(-(-columns // 2), rows * 5 // 7)  # by the style sheet
        wanted = given.width
        if not is_wide and floor and LEAST_MAP <= floor.width <= columns - LEAST_PROGRAM:
            wanted = floor.width
        wanted += numbers.x
        fits = wanted != given.width and wanted <= columns - LEAST_PROGRAM
        self.map_pane.styles.width = wanted if fits and free else None
        wanted = max(given.height, floor.height + 1 if floor else 0) + numbers.y
        fits = wanted > given.height and self.has_class("-tall") and wanted <= rows - LEAST_LOG
        self.query_one("#upper").styles.height = wanted if fits and free else None

    def log_lines(self, lines: Iterable[tuple[str, str]]) -> None:
        before = self.log_rows.row_count
        self.log_rows.append(lines)
        if self.log_rows.row_count != before:  # the typed command is none
            self.hold_nothing()

    def _await_answer(self) -> None:
        """Hold the repaint in the plain layout, so that the answer appears with the cleared command line.

        Some screen readers speak a lone deletion. Waits for a moment at most.
        """
        if self.is_plain and self.log_is_seen and not self.log_rows.begin_answer():
            self.hold_nothing()
            self._holding = ExitStack()
            self._holding.enter_context(self.app.batch_update())
            unskipped(self.set_timer(LONGEST_HELD, self.hold_nothing))

    def hold_nothing(self) -> None:
        """Stop holding, and paint everything."""
        holding, self._holding = self._holding, None
        if holding is not None:
            holding.close()
            self.app.screen.check_idle()

    # --- what was done to it

    def on_map_view_rulers_changed(self) -> None:
        self._give_room()

    def on_text_rows_read(self) -> None:
        self.post_message(self.Looked())
