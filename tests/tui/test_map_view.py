"""The map of a small room, as it is painted, scrolled and explored."""

import pytest
from textual.app import App, ComposeResult
from textual.geometry import Offset
from textual.message import Message
from textual.widgets import Input

from devices.ports.robot import Pose
from donnie_tui.core.events import PlacedThing
from donnie_tui.core.map_grid import Cell
from donnie_tui.core.map_scene import MapScene
from donnie_tui.tui import themes
from donnie_tui.tui.widgets.map_view import MapView
from sim.picture import Picture, Thing

CHAIR = Thing("chair", "chair", "c", "red", 2, 6, 2, 1, index=3)
RED_BALL = Thing("one", "ball", "b", "red", 6, 5, 1, 1, index=4)
BLUE_BALL = Thing("two", "ball", "b", "blue", 9, 3, 1, 1, index=5)
FLOOR = (
    "############",
    "#..........#",
    "#..........#",
    "#..cc......#",
    "#......b...#",
    "#..........#",
    "#.........b#",
    "#..........#",
    "#..........#",
    "############",
)
WIDE = [
    "########################",
    "##. . . . . . . . . . ##",
    "##. . . . . . . . . . ##",
    "##. . cccc. . . . . . ##",
    "##. . . . . . bR. . . ##",
    "##. . . . . . . . . . ##",
    "##. . . . . . . . . bB##",
    "##. . . . . . . . . . ##",
    "##^ . . . . . . . . . ##",
    "########################",
]


def room(*others: Thing) -> MapScene:
    """12 by 10 squares, the corner at -1, 0; the robot at 0, 1 faces north."""
    picture = Picture(-1, 0, 12, 10, 1, FLOOR, (CHAIR, RED_BALL, BLUE_BALL, *others), has_walls=True)
    return MapScene(picture, Pose(0, 1, 0))


class Mapped(App[None]):
    """A map of a size, which shows the room, and something else that can have the focus."""

    AUTO_FOCUS = None
    CSS = "MapView { scrollbar-size: 0 0; }"

    def __init__(self, width: int, height: int, scene: MapScene | None = None) -> None:
        super().__init__()
        self.view = MapView(id="map")
        self.view.styles.width, self.view.styles.height = width, height
        self.view.call_colours({"red": "R", "blue": "B"})
        self.scene = scene or room()
        self.posted: list[Message] = []

    def compose(self) -> ComposeResult:
        yield self.view
        yield Input()

    def on_mount(self) -> None:
        for name in (themes.DARK, themes.TERMINAL):
            self.register_theme(themes.theme(name))
        self.theme = themes.DARK
        self.view.show(self.scene)

    def on_map_view_explored(self, message: Message) -> None:
        self.posted.append(message)

    on_map_view_edges_changed = on_map_view_rulers_changed = on_map_view_explored

    @property
    def rows(self) -> list[str]:
        return [self.view.render_line(y).text.rstrip() for y in range(self.view.size.height)]


@pytest.mark.parametrize(("width", "expected"), [(24, WIDE), (23, [*FLOOR[:8], "#^.........#", FLOOR[9]])])
async def test_a_square_has_two_columns_where_the_floor_fits_so(width, expected):
    """Where it has one there is no room for the colours of the balls."""
    async with Mapped(width, 12).run_test(size=(60, 30)) as pilot:
        await pilot.pause()

        assert pilot.app.rows == [*expected, "", ""]
        assert pilot.app.view.hidden == ()
        assert not [each for each in pilot.app.posted if isinstance(each, MapView.EdgesChanged)]


async def test_a_square_is_two_or_four_steps_wide_further_away():
    async with Mapped(40, 12).run_test(size=(60, 30)) as pilot:
        view = pilot.app.view
        view.set_zoom(-1)
        await pilot.pause()
        assert pilot.app.rows[:5] == [
            "#" * 12,
            "##cccc. . ##",
            "##. . bR. ##",
            "##. . . . bB",
            "^ ##########",
        ]
        factors = []
        for zoom in (-2, -5, -6, 0, 1, 4, 3):
            view.set_zoom(zoom)
            factors.append((view.zoom, view.scale.factor, view._extent.columns, view._extent.rows))
        near, far = [(0, 1, 2, 1), (1, 1, 4, 2), (3, 1, 6, 3), (3, 1, 6, 3)], (-5, 32, 2, 1)
        assert factors == [(-2, 4, 2, 1), far, far, *near]


@pytest.mark.parametrize(
    ("size", "factor", "zoom"), [((12, 10), 1, 0), ((12, 9), 2, -1), ((11, 10), 2, -1), ((3, 10), 4, -2)]
)
async def test_the_whole_floor_is_shown_as_near_as_it_fits(size, factor, zoom):
    async with Mapped(*size).run_test(size=(60, 30)) as pilot:
        view = pilot.app.view
        view.set_zoom(2)
        view.show_all(True)
        await pilot.pause()
        assert (view.scale.factor, view.zoom, view.hidden) == (factor, zoom, ())
        view.show_all(False)
        assert (view.scale.factor, view.zoom) == (1, 2)
        view.show_all(True)
        view.set_zoom(1)
        assert (view.shows_all, view.zoom) == (False, 1)
        view.show(pilot.app.scene, whole=True)
        assert (view.shows_all, view.zoom) == (True, zoom)


async def test_a_zoom_says_whether_it_has_changed_the_map_and_else_leaves_it():
    async with Mapped(40, 12).run_test(size=(60, 30)) as pilot:
        view = pilot.app.view
        assert view.grid is pilot.app.scene.grid
        for zoom, has_changed, after in (
            *((0, False, 0), (1, True, 1), (9, True, 3), (9, False, 3), (3, False, 3)),
            *((-9, True, -5), (-6, False, -5), (2, True, 2)),
        ):
            assert (view.set_zoom(zoom), view.zoom, view.shows_all) == (has_changed, after, False)
        view.set_zoom(0)
        view.show_all(True)
        assert (view.set_zoom(0), view.shows_all) == (False, True), "all of it is as near"
        assert (view.set_zoom(1), view.shows_all) == (True, False)


@pytest.mark.parametrize(
    ("size", "places", "hidden"),
    [
        ((12, 10), [(0, 1), (10, 8)], [(), ()]),
        ((11, 10), [(0, 1), (10, 1)], [("east",), ("west",)]),
        ((12, 9), [(0, 1), (0, 8)], [("north",), ("south",)]),
        ((11, 9), [(0, 8), (10, 1)], [("east", "south"), ("north", "west")]),
    ],
)
async def test_a_side_is_hidden_where_a_column_or_a_row_is(size, places, hidden):
    async with Mapped(*size).run_test(size=(60, 30)) as pilot:
        view, scene = pilot.app.view, pilot.app.scene
        await pilot.pause()
        for place, sides in zip(places, hidden, strict=True):
            view.update_cells(scene.move(Pose(*place, 0)))
            await pilot.pause()
            assert view.hidden == sides
        posted = sum(isinstance(each, MapView.EdgesChanged) for each in pilot.app.posted)
        assert posted >= len([each for each in hidden if each])


async def test_at_the_beginning_of_a_run_its_cells_are_painted_and_no_change_paints_nothing(monkeypatch):
    async with Mapped(40, 12).run_test(size=(60, 30)) as pilot:
        view, painted = pilot.app.view, []
        await pilot.pause()
        monkeypatch.setattr(view, "refresh", lambda *regions, **_: painted.append([*map(tuple, regions)]))
        view.begin([Cell(3, 3)])
        assert painted == [[(6, 6, 2, 1)]]
        view.update_cells(())
        assert len(painted) == 1


async def test_the_explored_square_is_scrolled_into_sight_when_it_is_reached_and_with_the_focus():
    """In squares of six by three the room takes 72 by 30 cells, and 40 by 12 are seen of it."""
    async with Mapped(40, 12).run_test(size=(60, 30)) as pilot:
        view = pilot.app.view
        view.set_zoom(2)
        view.focus()
        await pilot.pause()

        def is_in_sight() -> bool:
            return view._window.contains_region(view._region_of(view._square))

        for cell in (Cell(10, 8), Cell(0, 8), Cell(10, 0), Cell(10, 8)):
            view.explore(lambda pointer, cell=cell: pointer.go(cell))
            assert (is_in_sight(), view.pointer.cell) == (True, cell)
        view.blur()
        await pilot.pause()
        view.restart()
        assert (is_in_sight(), view.hidden) == (False, ("north", "east")), "where the robot is"
        view.focus()
        await pilot.pause()
        assert is_in_sight()


async def test_a_sign_at_the_edge_covers_no_thing_robot_or_goal():
    """Of a thing at the same edge the letter stays."""
    things = (
        Thing("near", "box", "x", "blue", 6, 2, 1, 1, index=7),
        Thing("far", "box", "x", "blue", 9, 2, 1, 1),
    )
    rows = [*FLOOR]
    rows[7] = "#......x..x#"
    picture = Picture(-1, 0, 12, 10, 1, tuple(rows), things, has_walls=True)
    async with Mapped(8, 10, MapScene(picture, Pose(0, 2, 0))).run_test(size=(60, 30)) as pilot:
        view = pilot.app.view
        await pilot.pause()
        assert view._marks == {(7, 7)}
        assert pilot.app.rows[7] == "#^.....x"
        view.update_cells(pilot.app.scene.place_things((PlacedThing("near", Pose(5, 3, 0), 7),)))
        assert pilot.app.rows[7] == "#^.....+"


TOP = "      0         5         10"


async def test_every_fifth_step_is_numbered_and_every_tenth_where_a_square_is_a_column():
    async with Mapped(40, 12).run_test(size=(60, 30)) as pilot:
        view = pilot.app.view
        view.show_rulers(True)
        await pilot.pause()
        left = ["", "", "", "", "  5", "", "", "", "", "  0"]
        assert pilot.app.rows == [
            TOP,
            *(f"{number:4}{row}" for number, row in zip(left, WIDE, strict=True)),
            "",
        ]
        assert any(isinstance(each, MapView.RulersChanged) for each in pilot.app.posted)
        for width, top in ((28, TOP), (27, "     0         10")):
            view.styles.width = width
            await pilot.pause()
            assert pilot.app.rows[0] == top
        view.styles.width = 40
        await pilot.pause()
        view.set_zoom(1)
        await pilot.pause()
        assert [row[:4] for row in pilot.app.rows[2:12]] == [*[" " * 4] * 8, "  0 ", " " * 4]
        view.show_rulers(False)
        assert not view.has_rulers
        assert view.rulers == (0, 0)


async def test_numbers_of_a_far_view_are_steps_and_negative_ones_have_their_sign():
    async with Mapped(40, 12).run_test(size=(60, 30)) as pilot:
        view = pilot.app.view
        view.update_cells(pilot.app.scene.move(Pose(-11, 1, 0)))
        view.show_rulers(True)
        await pilot.pause()
        assert pilot.app.rows[0].split() == ["-10", "0", "10"]
        assert pilot.app.rows[0].index("-10") == 4 + 1
        view.set_zoom(-2)
        await pilot.pause()
        assert pilot.app.rows[0].split() == ["-5"]


async def test_a_number_at_the_left_has_its_sign_and_all_its_digits_or_is_left_out():
    """Four columns: the number to the right before a blank, or as long as all of them."""
    async with Mapped(40, 12).run_test(size=(60, 30)) as pilot:
        view = pilot.app.view
        view.show_rulers(True)
        for south, number in ((95, "-95 "), (100, "-100"), (995, "-995"), (1000, "    ")):
            view.update_cells(pilot.app.scene.move(Pose(0, -south, 0)))
            assert view._left_ruler(-south, 0).text == number


async def test_the_signs_at_the_edges_change_while_another_square_than_the_robot_s_is_explored():
    """Of 72 by 30 cells 40 by 12 are seen, from row 18 on: the chair is above them, both balls to the right.

    The blue ball is six squares below the corner: its middle is in row 6 x 3 + 1, the second one seen.
    """
    async with Mapped(40, 12).run_test(size=(60, 30)) as pilot:
        view = pilot.app.view
        view.set_zoom(2)
        view.focus()
        await pilot.press("right", "right")
        assert view._marks == {(21, 0), (27, 0), (39, 0), (39, 1)}
        view.update_cells(pilot.app.scene.place_things((PlacedThing("chair", Pose(2, 2, 0), 3),)))
        assert view._marks == {(39, 0), (39, 1)}


async def test_what_lies_outside_has_a_sign_at_the_edge_and_the_sides_are_known():
    """In squares of six by three the room takes 72 by 30, and 40 by 12 are seen of it."""
    async with Mapped(40, 12).run_test(size=(60, 30)) as pilot:
        view, scene = pilot.app.view, pilot.app.scene
        view.set_zoom(2)
        await pilot.pause()
        assert view.hidden == ("north", "east")
        assert pilot.app.rows[:3] == [
            "######.     .     .  +  .  +  .     .  +",
            "######" + " " * 33 + "+",
            "######",
        ]
        assert pilot.app.rows[6:10] == ["######^     .     .     .     .     .", "######", "######", "#" * 40]

        view.update_cells(scene.place_things((PlacedThing("chair", Pose(2, 2, 0), 3),)))
        assert pilot.app.rows[0] == "######.     .     .     .     .     .  +"
        view.update_cells(scene.move(Pose(0, 8, 0)))
        await pilot.pause()
        assert view.hidden == ("east", "south")
        below = [f"{'#' * 6:21}+", f"{'':5}+", f"{'':11}+"]
        assert [row for row in pilot.app.rows if "+" in row] == ["".join(below)] == pilot.app.rows[11:]
        view.show_all(True)
        assert (view.hidden, "+" in "".join(pilot.app.rows)) == ((), False)
        view.set_zoom(3)
        await pilot.pause()
        view.show_rulers(True)
        await pilot.pause()
        below[2] = below[2][4:]
        assert (
            [row for row in pilot.app.rows if "+" in row] == [f"    {''.join(below)}"] == pilot.app.rows[11:]
        )


async def test_the_map_follows_the_robot_with_three_squares_around_it_and_begins_with_it_in_the_middle():
    async with Mapped(40, 12).run_test(size=(60, 30)) as pilot:
        view, scene = pilot.app.view, pilot.app.scene
        view.set_zoom(2)
        await pilot.pause()
        places = []
        for pose in (Pose(0, 4, 0), Pose(1, 4, 0), Pose(5, 4, 0), Pose(5, 3, 0), Pose(5, 1, 0)):
            view.update_cells(scene.move(pose))
            places.append(tuple(view.scroll_offset))
        assert places == [(0, 12), (0, 12), (5, 12), (5, 12), (5, 18)]
        view.begin(scene.begin(Pose(5, 5, 0)))
        assert tuple(view.scroll_offset) == (36 + 3 - 20, 12 + 1 - 5)
        assert "A" not in "".join(pilot.app.rows)


async def test_the_cursor_of_the_terminal_stands_on_the_robot_or_on_the_square_that_is_explored():
    async with Mapped(40, 12).run_test(size=(60, 30)) as pilot:
        view = pilot.app.view
        assert view.cursor_screen_offset == (2, 8)
        view.show_rulers(True)
        assert view.cursor_screen_offset == (6, 9)
        view.focus()
        await pilot.press("right", "right", "up", "left")
        assert view.is_exploring
        assert view.cursor_screen_offset == (8, 8)
        assert sum(isinstance(each, MapView.Explored) for each in pilot.app.posted) == 4
        reversed_ = [each.text for each in view.render_line(8) if each.style.reverse]
        assert reversed_ == [". "]
        view.set_zoom(-1)
        await pilot.press("right", "up")
        assert pilot.app.view.pointer.cell == Cell(4, 4)
        await pilot.press("down", "left", "left", "left")
        assert pilot.app.view.pointer.cell == Cell(0, 2)
        view.blur()
        await pilot.pause()
        assert not any(each.style.reverse for each in view.render_line(4))
        assert view.cursor_screen_offset == (4, 4)


async def test_a_map_of_nothing_takes_all_its_keys_and_shows_blanks():
    app = Mapped(40, 12)
    app.view.show = lambda *_: None
    async with app.run_test(size=(60, 30)) as pilot:
        view = app.view
        view.focus()
        await pilot.press("up")
        view.update_cells([Cell(1, 1)])
        view.begin([Cell(1, 1)])
        view.restart()
        view.explore(lambda _: 1 / 0)
        await pilot.click(view, offset=(3, 3))
        assert (view.grid, view.is_exploring, view.hidden, view.zoom) == (None, False, (), 0)
        assert view.cursor_screen_offset == (0, 0)
        assert (app.rows, app.posted) == ([""] * 12, [])


async def test_a_click_explores_the_square_that_is_there_and_none_outside_the_floor():
    async with Mapped(40, 12).run_test(size=(60, 30)) as pilot:
        view = pilot.app.view
        for rulers in (False, True):
            view.show_rulers(rulers)
            for place, cell in (
                ((0, 0), (0, 9)), ((23, 9), (11, 0)), ((24, 9), None), ((23, 10), None), ((3, 7), (1, 2)),
                ((4, 7), (2, 2)),
            ):  # fmt: skip
                view.pointer.to_robot()
                await pilot.click(view, offset=Offset(*place) + view.rulers)
                assert view.pointer.cell == cell
        view.pointer.to_robot()
        await pilot.click(view, offset=Offset(3, 1))
        assert view.pointer.cell is None, "the numbers are no floor"


async def test_a_click_on_a_large_square_is_meant_for_all_of_it_wherever_the_map_is_scrolled():
    async with Mapped(40, 12).run_test(size=(60, 30)) as pilot:
        view = pilot.app.view
        view.set_zoom(2)
        await pilot.pause()
        for x, y, cell in ((6, 6, (1, 1)), (11, 8, (1, 1)), (12, 8, (2, 1)), (11, 9, (1, 0)), (6, 5, (1, 2))):
            await pilot.click(view, offset=Offset(x, y))
            assert view.pointer.cell == cell
        view.set_zoom(-1)
        await pilot.click(view, offset=Offset(2, 1))
        assert view.pointer.cell == Cell(3, 6), "of a square that is several steps wide, what is shown"


async def test_names_stand_on_free_floor_only_and_move_with_their_things():
    async with Mapped(24, 12).run_test(size=(60, 30)) as pilot:
        view, scene = pilot.app.view, pilot.app.scene
        names = {Cell(8, 5): "re", Cell(9, 5): "d ", Cell(4, 6): "no", Cell(1, 1): "no"}
        asked = []

        def labels(scale, columns):
            asked.append((scale.factor, columns))
            return dict(names)

        view.show_names(labels)
        await pilot.pause()
        assert (view.has_names, asked[-1]) == (True, (1, 2))
        assert pilot.app.rows[4] == "##. . . . . . bRred . ##"
        assert (pilot.app.rows[3], pilot.app.rows[8]) == (WIDE[3], WIDE[8])
        assert [each.style for each in view.render_line(4) if "red" in each.text] == [view.painted_as("name")]

        names[Cell(8, 4)] = names.pop(Cell(8, 5))
        view.update_cells(scene.place_things((PlacedThing("one", Pose(6, 4, 0), 4),)))
        assert pilot.app.rows[5] == "##. . . . . . bRre. . ##"
        view.set_zoom(1)
        await pilot.pause()
        assert asked[-1] == (1, 4)
        view.show_names(None)
        assert not view.has_names
        assert "re" not in "".join(pilot.app.rows)


async def test_a_name_is_in_the_first_row_of_its_square():
    async with Mapped(48, 20).run_test(size=(60, 30)) as pilot:
        view = pilot.app.view
        view.set_zoom(1)
        view.show_names(lambda *_: {Cell(2, 8): "abcd"})
        await pilot.pause()
        assert [row[4:16] for row in pilot.app.rows[2:4]] == [".   abcd.   ", " " * 12]


async def test_only_the_squares_that_changed_are_painted(monkeypatch):
    async with Mapped(40, 12).run_test(size=(60, 30)) as pilot:
        view, scene = pilot.app.view, pilot.app.scene
        names = {}
        view.show_names(lambda *_: dict(names))
        await pilot.pause()
        painted = []
        monkeypatch.setattr(view, "refresh", lambda *regions, **_: painted.extend(regions))
        names[Cell(5, 5)] = "x "
        view.update_cells(scene.move(Pose(0, 2, 0)))
        assert sorted(painted) == [(2, 7, 2, 1), (2, 8, 2, 1), (10, 4, 2, 1)]
        painted.clear()
        view.explore(lambda pointer: pointer.move(1, 1))
        assert sorted(painted) == [(2, 7, 2, 1), (4, 6, 2, 1)]
        painted.clear()
        view.update_cells(())
        assert painted == []


# --- as a picture

BLOCKS = ["█▀▀▀▀▀▀▀▀▀▀█", "█  ▄▄      █", "█      ▀   █", "█         ▀█", "█^▄▄▄▄▄▄▄▄▄█"]


async def test_a_picture_has_two_squares_in_a_row_and_blocks_for_walls_and_things():
    async with Mapped(23, 12).run_test(size=(60, 30)) as pilot:
        view, scene = pilot.app.view, pilot.app.scene
        view.show_picture(True)
        await pilot.pause()
        assert (view.is_picture, pilot.app.rows) == (True, [*BLOCKS, *[""] * 7])
        view.show_rulers(True)
        await pilot.pause()
        assert [row[:4] for row in pilot.app.rows[:7]] == [
            "    ", "    ", "    ", "  5 ", "    ", "  0 ", ""
        ]  # fmt: skip
        view.show_rulers(False)
        view.update_cells(scene.move(Pose(0, 10, 0)))
        await pilot.pause()
        assert pilot.app.rows[:6] == [
            "▄^▄▄▄▄▄▄▄▄▄▄", "█oooooooooo█".replace("o" * 10, "o" + " " * 9 + ""), "█o ▀▀  ▄   █",
            "█o        ▄█", "█o         █", "▀▀▀▀▀▀▀▀▀▀▀▀",
        ]  # fmt: skip
        view.show_picture(False)
        assert not view.is_picture


@pytest.mark.parametrize(("size", "is_near"), [((24, 10), True), ((24, 9), False), ((23, 10), False)])
async def test_a_picture_has_squares_of_two_columns_where_all_of_it_fits_so(size, is_near):
    async with Mapped(*size).run_test(size=(60, 30)) as pilot:
        pilot.app.view.show_picture(True)
        await pilot.pause()
        if not is_near:
            assert pilot.app.rows[:5] == BLOCKS
            return
        assert pilot.app.rows[0] == "█" * 24
        assert pilot.app.rows[3] == "██" + " " * 4 + "████" + " " * 12 + "██"
        assert pilot.app.rows[6] == "██" + " " * 18 + "████"
        assert pilot.app.rows[8] == "██^ " + " " * 18 + "██"


async def test_two_blocks_in_a_row_have_a_colour_each_and_equal_ones_are_whole():
    async with Mapped(23, 12).run_test(size=(60, 30)) as pilot:
        view, scene = pilot.app.view, pilot.app.scene
        view.show_picture(True)
        things = (PlacedThing("one", Pose(2, 7, 0), 4), PlacedThing("two", Pose(3, 7, 0), 5))
        view.update_cells(scene.place_things(things))
        await pilot.pause()
        red, blue, wall = (view._look(each).color for each in ("thing-red", "thing-blue", "wall"))
        same, other, corner = (
            view._segment(Cell(3, 7), 0),
            view._segment(Cell(4, 7), 0),
            view._segment(Cell(0, 9), 0),
        )

        assert (same.text, same.style.color) == ("█", red)
        assert (other.text, other.style.color, other.style.bgcolor) == ("▀", blue, red)
        assert (corner.text, corner.style.color) == ("█", wall)
        assert view._segment(Cell(5, 9), 0).style.color == wall


async def test_without_colours_there_are_letters():
    async with Mapped(23, 12).run_test(size=(60, 30)) as pilot:
        view = pilot.app.view
        assert view.has_colours
        pilot.app.no_color = True
        view.show_picture(True)
        assert (view.has_colours, view.is_picture) == (False, False)


async def test_things_and_robots_have_their_colours_and_unknown_ones_the_colour_of_all():
    async with Mapped(23, 12).run_test(size=(60, 30)) as pilot:
        view = pilot.app.view
        assert view._look("thing-red") == view.painted_as("thing-red")
        assert view._look("thing-mauve") == view._look("thing-") == view.painted_as("thing-gray")
        assert view._look("other-mauve") == view.painted_as("other")
        robot = view._look("other-red")
        assert (robot.color, robot.bold, robot.reverse) == (view._look("thing-red").color, True, True)
        assert view._look("wall") == view.painted_as("wall")


async def test_other_robots_have_arrows_and_the_initials_of_their_names():
    bob = Thing("bob", "robot", "r", "green", 4, 2, 1, 1, is_robot=True, heading=90, index=6)
    rows = [*FLOOR]
    rows[7] = "#....r.....#"
    picture = Picture(-1, 0, 12, 10, 1, tuple(rows), (CHAIR, bob), has_walls=True)
    async with Mapped(24, 12, MapScene(picture, Pose(0, 1, 0), "alice")).run_test(size=(60, 30)) as pilot:
        await pilot.pause()
        assert pilot.app.rows[7:9] == ["##. . . . >b. . . . . ##", "##^a. . . . . . . . . ##"]
        painted = pilot.app.view._segment(Cell(5, 2), 0)
        assert painted.style == pilot.app.view._look("other-green")
