"""The main screen without a session: its panes, their room, the focus, what is below them."""

from contextlib import suppress

import pytest
from textual.app import App
from textual.errors import NoWidget
from textual.geometry import Region, Size
from textual.message import Message
from textual.widget import Widget

from devices.ports.robot import Pose
from donnie_tui.core.map_scene import MapScene
from donnie_tui.tui import themes
from donnie_tui.tui.screens.main_screen import MainScreen
from donnie_tui.tui.screens.pages import TourPage, TourStrip
from sim.picture import Picture, Thing
from tests.tui.test_dialogs import Showing

BALL = Thing("ball", "ball", "b", "red", 1, 1, 1, 1, index=1)


def floor(width: int, height: int, *, has_walls: bool = True, has_thing: bool = False) -> MapScene:
    rows = ["." * width] * height
    things = (BALL,) if has_thing else ()
    return MapScene(Picture(0, 0, width, height, 1, tuple(rows), things, has_walls=has_walls), Pose(1, 1, 0))


class Alone(App[None]):
    """The main screen of a size, and what it posted."""

    CSS_PATH = Showing.CSS_PATH

    def __init__(self, width: int, height: int, **given) -> None:
        super().__init__()
        self.main = MainScreen(Size(width, height), **given)
        self.posted: list[type[Message]] = []

    def get_theme_variable_defaults(self) -> dict[str, str]:
        return themes.theme(themes.DARK).variables

    def get_default_screen(self) -> MainScreen:
        return self.main

    def on_main_screen_looked(self, message: Message) -> None:
        self.posted.append(type(message))

    on_main_screen_entered = on_main_screen_looked

    @property
    def seen(self) -> list[str]:
        """The panes that have a size."""
        return [str(each.id).removesuffix("-pane") for each in self.main.panes if is_seen(each.content)]


def is_seen(widget: Widget) -> bool:
    with suppress(NoWidget):
        return bool(widget.screen.find_widget(widget).visible_region.area)
    return False


@pytest.mark.parametrize(
    ("size", "seen", "classes"),
    [
        ((110, 32), ["program", "map", "inspector", "log"], "-wide -tall"),
        ((109, 31), ["program", "map", "log"], "-normal -high"),
        ((60, 18), ["program", "map", "log"], "-normal -high"),
        ((59, 18), ["program"], "-narrow -high -one-pane"),
        ((60, 17), ["program"], "-normal -low -one-pane"),
        ((60, 9), ["program"], "-normal -lowest -one-pane"),
    ],
    ids=str,
)
async def test_as_many_panes_are_seen_as_there_is_room_for(size, seen, classes):
    app = Alone(*size)
    every = {"-wide", "-normal", "-narrow", "-tall", "-high", "-low", "-lowest", "-one-pane"}
    assert app.main.classes & every == set(classes.split())
    async with app.run_test(size=size) as pilot:
        await pilot.pause()
        assert app.seen == seen
        assert app.main.classes & every == set(classes.split())
        assert bool(app.main.keys.region.area) is (size[1] >= 10)
        assert app.main.is_small is ("-one-pane" in classes)
        assert app.focused is app.main.editor
        assert MainScreen.Entered not in app.posted


@pytest.mark.parametrize("size", [(80, 24), (120, 40), (200, 60)], ids=str)
async def test_the_log_with_its_title_has_at_most_a_third_of_the_height(size):
    app = Alone(*size)
    async with app.run_test(size=size) as pilot:
        await pilot.pause()
        for rows in (10, 100):
            app.main.show_map(floor(40, rows))
            await pilot.pause()

            assert 5 <= 1 + app.main.log_rows.region.height <= size[1] // 3


WIDTHS = [(19, None), (20, 20), (30, 30), (60, 60), (61, None), (50, None)]
HEIGHTS = [(25, None), (26, 27), (27, 28), (28, None)]


async def test_the_map_has_the_width_of_the_floor_where_the_program_keeps_39_columns():
    """Of 100 columns it has 50 otherwise, and between both is one; numbers take four more."""
    app = Alone(100, 30)
    async with app.run_test(size=(100, 30)) as pilot:
        pane = app.main.map_pane
        await pilot.pause()
        for columns, width in WIDTHS:
            app.main.show_map(floor(columns, 10))
            await pilot.pause()
            assert (pane.styles.inline.width and pane.content.region.width) == width, columns
        app.main.show_map(floor(30, 10))
        app.main.map.show_rulers(True)
        await pilot.pause()
        assert pane.styles.inline.width.value == 34
        app.main.show_map(floor(60, 10))
        assert pane.styles.inline.width is None
        app.main.show_map(floor(30, 10))
        app.main.toggle_inspector()
        await pilot.pause()
        assert pane.styles.inline.width is None
        app.main.toggle_inspector()
        await pilot.pause()
        assert pane.styles.inline.width.value == 34
        await pilot.resize_terminal(59, 30)
        await pilot.pause()
        assert pane.styles.inline.width is None
        await pilot.resize_terminal(120, 30)
        await pilot.pause()
        assert pane.styles.inline.width.value == 44 + 4


async def test_the_map_has_the_height_of_the_floor_where_the_log_keeps_nine_rows():
    """Of the 37 rows of the panes it has 26 otherwise, with its title."""
    app = Alone(120, 40)
    async with app.run_test(size=(120, 40)) as pilot:
        upper = app.main.query_one("#upper")
        await pilot.pause()
        for rows, height in HEIGHTS:
            app.main.show_map(floor(20, rows))
            await pilot.pause()
            assert (upper.styles.inline.height and app.main.map.region.height + 1) == height, rows
        app.main.show_map(floor(20, 10))
        app.main.map.show_rulers(True)
        await pilot.pause()
        assert upper.styles.inline.height.value == 27
        await pilot.resize_terminal(120, 31)
        await pilot.pause()
        assert upper.styles.inline.height is None


@pytest.mark.parametrize(
    ("has_walls", "has_thing", "plain", "whole"),
    [
        (False, True, False, True),
        (False, False, False, False),
        (True, True, True, False),
    ],
)
async def test_a_room_is_shown_whole_but_not_an_empty_floor_nor_in_the_plain_layout(
    has_walls, has_thing, plain, whole
):
    app = Alone(80, 24, plain=plain)
    async with app.run_test(size=(80, 24)):
        app.main.show_map(floor(20, 10, has_walls=has_walls, has_thing=has_thing))
        assert app.main.map.shows_all is whole


async def test_tab_goes_through_the_parts_in_reading_order_and_the_plain_layout_begins_with_the_command():
    app = Alone(120, 30)
    async with app.run_test(size=(120, 30)) as pilot:
        assert [each.id for each in app.main.focus_chain] == ["editor", "map", "inspector", "log", "command"]
        app.main.show_tour(
            TourStrip([TourPage("One", "Esc leaves", ("x",))], 0, lambda _: None, lambda _: None)
        )
        await pilot.pause()
        assert [each.id for each in app.main.focus_chain][-2:] == ["tour", "command"]
        assert app.focused is app.main.tour
        app.main.close_tour()
        await pilot.pause()
        assert (app.focused, app.main.tour) == (app.main.editor, None)
        assert len(app.main.query(TourStrip)) == 0
        app.main.close_tour()
        app.main.set_plain(True)
        await pilot.pause()
        assert [each.id for each in app.main.focus_chain] == ["command", "editor", "log", "map", "inspector"]
        assert not app.main.editor.show_line_numbers


async def test_the_tour_gives_the_focus_back_only_if_it_has_it():
    app = Alone(80, 24)
    async with app.run_test(size=(80, 24)) as pilot:
        app.main.command_line.focus()
        await pilot.pause()
        for elsewhere in (None, app.main.map):
            app.main.show_tour(
                TourStrip([TourPage("One", "Esc leaves", ("x",))], 0, lambda _: None, lambda _: None)
            )
            await pilot.pause()
            if elsewhere is not None:
                elsewhere.focus()
                await pilot.pause()
            app.main.close_tour()
            await pilot.pause()
            assert app.focused is (elsewhere or app.main.command_line)


async def test_one_pane_is_seen_at_a_time_on_a_small_screen_and_the_focus_shows_it():
    app = Alone(40, 12)
    async with app.run_test(size=(40, 12)) as pilot:
        for pane in (*app.main.panes, app.main.program_pane):
            app.main.go_to(pane)
            await pilot.pause()
            assert app.seen == [str(pane.id).removesuffix("-pane")]
            assert app.main.focused_pane is pane
            assert app.main.focus_was == pane.content.id
            assert app.main.has_class("-alone") is (pane in (app.main.map_pane, app.main.inspector_pane))
            assert app.main.log_is_seen is (pane is app.main.log_pane)
        app.main.command_line.focus()
        await pilot.pause()
        assert (app.main.focused_pane, app.seen) == (None, ["program"])
        assert app.posted.count(MainScreen.Entered) == 5


async def test_the_inspector_takes_the_place_of_the_map_and_leaves_it_again():
    app = Alone(80, 24)
    async with app.run_test(size=(80, 24)) as pilot:
        app.main.toggle_inspector()
        await pilot.pause()
        assert (app.seen, app.focused) == (["program", "inspector", "log"], app.main.inspector)
        app.main.toggle_inspector()
        await pilot.pause()
        assert (app.seen, app.focused) == (["program", "map", "log"], app.main.editor)
        app.main.toggle_inspector()
        app.main.map.focus()
        await pilot.pause()
        assert app.seen == ["program", "map", "log"]


async def test_the_plain_layout_shows_the_program_and_the_log_without_titles():
    app = Alone(80, 24, plain=True, first_row="Screen reader?")
    async with app.run_test(size=(80, 24)) as pilot:
        await pilot.pause()
        assert app.focused is app.main.command_line
        assert app.main.query_one("#first-row").region == Region(0, 0, 80, 1)
        assert not app.main.log_pane._heading.region.area
        app.main.go_to(app.main.map_pane)
        await pilot.pause()
        assert app.seen == ["map"]
        app.main.command_line.focus()
        await pilot.pause()
        assert "log" in app.seen
        assert app.main.log_is_seen


@pytest.mark.parametrize(
    ("focus", "plain", "focused"),
    [("map", False, "map"), ("", True, "command"), ("log", True, "log"), ("x", False, "editor")],
)
async def test_another_screen_begins_where_the_focus_was(focus, plain, focused):
    app = Alone(80, 24, plain=plain, focus=focus)
    async with app.run_test(size=(80, 24)) as pilot:
        await pilot.pause()
        assert app.focused.id == focused


async def test_the_slider_is_below_the_panes_while_there_is_room_for_it():
    app = Alone(80, 24)
    async with app.run_test(size=(80, 24)) as pilot:
        for steps, rows in (((1, 4), 1), ((2, 4), 1), (None, 0), (None, 0), ((1, 4), 1)):
            app.main.show_slider(steps)
            await pilot.pause()
            sliders = app.main.query("#slider")
            assert len(sliders) == rows
            assert not rows or sliders.first().region.y == app.main.command_line.region.y - 1
        await pilot.resize_terminal(59, 24)
        await pilot.pause()
        app.main.show_slider((1, 4))
        await pilot.pause()
        assert len(app.main.query("#slider")) == 0


async def test_a_list_may_cover_the_rows_between_those_that_are_always_seen():
    app = Alone(80, 24)
    async with app.run_test(size=(80, 24)) as pilot:
        await pilot.pause()
        assert app.main.command_line.region.y == 21
        assert app.main.room_around(5) == Region(0, 0, 80, 21)
        assert app.main.room_around(21) == Region(0, 0, 80, 22)
        assert app.main.room_around(22) == Region(0, 22, 80, 1)
