"""Panes, focus, the terminal's cursor, sizes: what is seen and how one gets there, by keys alone."""

import pytest
from rich.color import ColorSystem
from rich.segment import Segment
from textual.color import Color
from textual.events import Resize
from textual.geometry import Offset, Size
from textual.strip import Strip

from devices.ports.robot import Pose
from donnie_tui.tui import themes
from tests.tui.conftest import burst

pytestmark = pytest.mark.slow

SIZES = [(40, 12), (80, 24), (100, 30), (120, 40), (200, 60)]


def caret(screen) -> Offset:
    return screen.app.cursor_position


async def test_the_first_row_of_the_log_leads_to_the_linear_mode(open_screen):
    async with open_screen() as screen:
        assert screen.log[0] == "Screen reader? Type LINEAR and Enter."
        assert screen.log[0] in screen.text


async def has_focus(screen, name: str) -> None:
    """A key passes from the widget up to the application: a busy machine has more to do than the press."""
    await screen.until(lambda: screen.app.focused is not None and screen.app.focused.id == name, name)
    await screen.pilot.pause()


async def test_the_order_of_focus_is_the_order_of_reading_and_back(open_screen):
    async with open_screen(size=(120, 40)) as screen:
        order = ["editor", "map", "inspector", "log", "command"]
        for name in [*order[1:], order[0]]:
            await screen.press("tab")
            await has_focus(screen, name)
        for name in [*reversed(order[1:]), order[0]]:
            await screen.press("shift+tab")
            await has_focus(screen, name)


async def test_the_status_line_names_the_focus(open_screen):
    async with open_screen("FW 1\nFW 2") as screen:
        for words in ("Program, line 1 of 2", "Map", "Log, line 2 of 2", "Command line"):
            await screen.until(lambda expected=words: screen.status.split(".")[0].strip() == expected, words)
            await screen.press("tab")


async def test_the_terminal_s_cursor_stands_at_the_focus(open_screen):
    async with open_screen("FW 1") as screen:
        await screen.press("right")
        editor = screen.main.editor
        assert caret(screen) == editor.cursor_screen_offset

        await screen.press("tab")
        await has_focus(screen, "map")
        grid, view = screen.main.map.grid, screen.main.map
        x, y = caret(screen)
        assert view.region.contains(x, y)
        strips = screen.app.screen._compositor.render_strips()
        assert strips[y].text[x] == "^"
        assert grid.letter(grid.robot) == "^"

        await screen.press("tab")
        await has_focus(screen, "log")
        x, y = caret(screen)
        assert (x, strips_text(screen)[y][x]) == (screen.main.log_rows.region.x, ">")

        await screen.press("tab")
        await has_focus(screen, "command")
        assert caret(screen) == screen.main.command_line.cursor_screen_offset


def strips_text(screen) -> list[str]:
    return [strip.text for strip in screen.app.screen._compositor.render_strips()]


async def test_the_cursor_follows_the_robot_while_the_map_has_the_focus(open_screen):
    async with open_screen("FW 4 TR 90 FW 3") as screen:
        await screen.press("tab", "f5")
        await screen.shows("The program is done.")
        await screen.pilot.pause()

        x, y = caret(screen)
        assert strips_text(screen)[y][x] == ">"


async def test_the_map_follows_a_robot_that_leaves_the_picture(open_screen):
    async with open_screen("FW 200\nTR 90\nFW 300") as screen:
        screen.main.map.show_all(False)
        await screen.press("f5")
        await screen.shows("The program is done.")
        await screen.pilot.pause()

        assert "o>" in "\n".join(row[40:] for row in strips_text(screen)[1:14])


async def test_a_map_that_was_explored_follows_the_robot_again_and_keeps_the_square_for_later(open_screen):
    async with open_screen("TR 90\nFW 28") as screen:
        screen.main.map.show_all(False)
        await screen.press("tab", "left")
        await screen.until(lambda: screen.main.map.is_exploring, "exploring")
        square = screen.main.map.pointer.cell
        await screen.press("shift+tab")
        await has_focus(screen, "editor")
        await screen.press("f5")
        await screen.shows("The program is done.")
        await screen.pilot.pause()
        assert "o>" in "\n".join(row[40:] for row in strips_text(screen)[1:14])
        await screen.type_line("FW 30")
        await screen.shows("I walked 30 steps forward.")
        await screen.idle()
        await screen.pilot.pause()
        assert "o>" in "\n".join(row[40:] for row in strips_text(screen)[1:14]), "after a typed command too"

        screen.main.map.focus()
        await has_focus(screen, "map")
        assert screen.main.map.pointer.cell == square
        x, y = caret(screen)
        assert screen.main.map.region.contains(x, y)


async def test_while_a_square_is_explored_the_map_stays_with_it(open_screen):
    async with open_screen("TR 90\nFW 28") as screen:
        screen.main.map.show_all(False)
        await screen.press("tab", "left")
        await screen.until(lambda: screen.main.map.is_exploring, "exploring")
        await screen.press("f5")
        await screen.shows("The program is done.")
        await screen.pilot.pause()

        x, y = caret(screen)
        assert screen.main.map.region.contains(x, y)
        await screen.status_has("Map, -1, 0:")


async def test_exploring_names_the_cell_and_home_goes_back_to_the_robot(open_screen):
    async with open_screen(world="living_room") as screen:
        screen.main.map.show_all(False)
        await screen.press("tab", "right")
        await screen.status_has(" Map, 1, 0: free.")
        burst(screen, *["left"] * 20)
        await screen.until(lambda: "wall." in screen.status, "the wall")

        await screen.press("home")
        await screen.status_has(" Map. Donnie at")


async def test_things_are_named_when_they_are_explored(open_screen):
    async with open_screen(world="living_room", size=(120, 40)) as screen:
        thing = screen.main.map.grid.picture.things[0]
        screen.main.map.pointer.cell = screen.main.map.grid.cell_of(Pose(round(thing.x), round(thing.y), 0.0))
        screen.main.map.focus()
        await screen.press("left", "right")

        await screen.status_has(f": {thing.name}, {thing.colour}. ")


async def test_every_size_shows_the_focus_the_command_line_and_the_status(open_screen):
    async with open_screen("FW 1\nFW 2", size=SIZES[-1]) as screen:
        for size in ((40, 12), (80, 24), (120, 40)):
            await screen.pilot.resize_terminal(*size)
            await screen.painted()
            for _ in range(5):
                focused = screen.app.focused
                assert focused.region.area, f"{focused} at {size}"
                assert screen.main.command_line.region.area
                assert screen.main.status.region.area
                await screen.press("tab")
                await screen.pilot.pause()


async def test_the_size_may_change_while_a_program_is_paused_and_the_focus_stays(open_screen):
    async with open_screen("FW 1\nFW 2\nFW 3") as screen:
        await screen.press("f7")
        await screen.shows("Line 1: FW 1")
        for size in (*SIZES, (1, 1), (20, 5), (80, 24)):
            await screen.pilot.resize_terminal(*size)
            await screen.pilot.pause()
            assert screen.main.editor.has_focus
        await screen.press("f7")
        await screen.shows("Line 2: FW 2")

        assert "> 2  FW 2" in screen.text


async def test_forty_columns_show_one_pane_at_a_time(open_screen):
    async with open_screen("FW 1", size=(40, 12)) as screen:
        assert "Program:" in screen.text
        assert "Map:" not in screen.text
        await screen.press("tab")
        await screen.pilot.pause()

        assert "Map:" in screen.text
        assert "Program:" not in screen.text


async def test_f4_shows_the_inspector_and_goes_back(open_screen):
    async with open_screen("VAR a = 5\nFW 1\nFW 2") as screen:
        await screen.press("f7", "f4")
        await screen.pilot.pause()
        assert screen.app.focused.id == "inspector"
        assert "Variables" in screen.text
        await screen.press("f4")
        await screen.pilot.pause()

        assert screen.main.editor.has_focus
        assert "Map:" in screen.text


async def the_map_is_seen(screen) -> None:
    await has_focus(screen, "map")
    await screen.until(lambda: screen.main.map.region.width >= 20 and "Map:" in screen.text, "the map")
    x, y = caret(screen)
    assert screen.main.map.region.contains(x, y)


async def test_the_map_comes_back_when_it_is_asked_for_in_the_inspector_s_place(open_screen):
    async with open_screen("FW 1", world="living_room") as screen:
        for size in ((80, 15), (100, 30)):
            await screen.pilot.resize_terminal(*size)
            await screen.painted()
            for way in ("SHOW MAP", "shift+tab"):
                await screen.press("f4")
                await has_focus(screen, "inspector")
                if way == "SHOW MAP":
                    await screen.type_line(way)
                else:
                    await screen.press(way)

                await the_map_is_seen(screen)


async def test_a_focus_on_the_map_or_the_inspector_is_seen_in_a_smaller_terminal_too(open_screen):
    async with open_screen("FW 1", size=(120, 40)) as screen:
        await screen.press("f4", "shift+tab")
        await has_focus(screen, "map")
        await screen.pilot.resize_terminal(80, 24)
        await the_map_is_seen(screen)

        await screen.pilot.resize_terminal(120, 40)
        await screen.press("tab")
        await has_focus(screen, "inspector")
        await screen.pilot.resize_terminal(80, 24)
        await screen.until(lambda: "Variables" in screen.text or "variables" in screen.text, "the inspector")
        await has_focus(screen, "inspector")


async def test_sizes_that_come_in_reversed_order_do_not_count(open_screen):
    """A signal that interrupts the handler of the one before is answered first."""
    async with open_screen(size=(80, 24)) as screen:
        await screen.pilot.resize_terminal(120, 40)
        late = Size(40, 12)
        screen.app.post_message(Resize(late, late))
        await screen.pilot.pause()
        await screen.until(lambda: "No variables." in screen.text, "the inspector of a large terminal")
        assert screen.app.size == Size(120, 40)


async def test_words_go_to_the_panes(open_screen):
    async with open_screen() as screen:
        for typed, focused in (("show map", "map"), ("SHOW LOG", "log"), ("Show Program", "editor")):
            await screen.type_line(typed)
            await screen.until(lambda focused=focused: screen.app.focused.id == focused, focused)


async def test_up_and_down_restore_typed_lines(open_screen):
    async with open_screen() as screen:
        await screen.type_line("FW 1")
        await screen.idle()
        await screen.type_line("FW 2")
        await screen.idle()
        await screen.press("up", "up")
        assert screen.main.command_line.value == "FW 1"
        await screen.press("down", "down")

        assert screen.main.command_line.value == ""


async def test_the_log_is_read_by_rows_and_follows_its_end_again(open_screen):
    async with open_screen() as screen:
        await screen.run("FOR VAR i = 0; i < 40; i = i + 1 DO SPEAK i END FOR")
        screen.main.log_rows.focus()
        await screen.press("home")
        await screen.status_has(f" Log, line 1 of {screen.main.log_rows.row_count}.")
        await screen.type_line("SPEAK 99")
        await screen.shows("99")
        assert screen.main.log_rows.row == 0

        screen.main.log_rows.focus()
        await screen.press("end")
        await screen.type_line("SPEAK 100")
        await screen.shows("100")
        assert screen.main.log_rows.row_text == "100"


async def test_without_colours_the_screen_says_the_same(open_screen, monkeypatch, tmp_path):
    async with open_screen("FW 1") as screen:
        await screen.press("f7")
        await screen.shows("Line 1: FW 1")
        await screen.pilot.pause()
        with_colours = screen.text
    monkeypatch.setenv("NO_COLOR", "1")
    for each in tmp_path.rglob("unsaved-*.gd"):  # the first screen ended without a question
        each.unlink()
    async with open_screen("FW 1") as screen:
        await screen.press("f7")
        await screen.shows("Line 1: FW 1")
        await screen.pilot.pause()

        assert screen.app.theme == "donnie-terminal"
        assert screen.text == with_colours


async def test_a_thing_that_is_pushed_in_every_run_is_shown_where_it_is(open_screen):
    async with open_screen("FW 20", world="object_field") as screen:

        def cone() -> int:
            (it,) = (each for each in screen.main.map.scale.scene.things if each.colour == "green")
            return round(it.y)

        for run in range(1, 4):
            await screen.press("f5")
            await screen.until(lambda run=run: screen.log.count("The program is done.") == run)
            await screen.until(lambda: cone() == 23, "the cone is where it was pushed to")

        await screen.type_line("RESET")
        await screen.until(lambda: cone() == 12, "the cone is back")


# --- the first start


async def test_the_tour_is_offered_at_the_first_start_in_a_sentence_that_is_spoken_too(open_screen):
    async with open_screen(tour=True) as screen:
        await screen.shows("New here? TOUR shows you around.")
        assert screen.main.editor.has_focus, "nothing is in the way"
    async with open_screen(tour=True) as screen:
        await screen.pilot.pause()
        assert "New here? TOUR shows you around." not in screen.log


async def test_a_file_of_the_command_line_comes_before_the_tour(open_screen, tmp_path):
    path = tmp_path / "walk.gd"
    path.write_text("FW 1\n", encoding="utf-8")
    async with open_screen(file=path, tour=True) as screen:
        await screen.shows("Opened walk.gd")
        assert "New here? TOUR shows you around." not in screen.log
    async with open_screen(tour=True) as screen:
        await screen.shows("New here? TOUR shows you around.")


# --- the belt


async def test_the_belt_is_shown_next_to_the_variables_in_words_and_by_motor(open_screen):
    async with open_screen(
        "BELT ON\nFW 9\nWAIT 1000", size=(120, 40), world="corridor", speed=1000.0
    ) as screen:
        assert "Upper row" not in screen.text
        await screen.press("f5")
        await screen.until(lambda: "Belt: " in screen.text and "Upper row: " in screen.text, "the belt")
        levels = screen.app.controller.donnie.outlets.belt.rows()
        await screen.until(lambda: all(each in screen.main.inspector.lines for each in levels), "the rows")
        assert any(digit in levels[2] for digit in "123")

        await screen.type_line("FEEL ROWS")
        await screen.shows("Lower row: ")
        await screen.press("f8")
        await screen.idle()
        await screen.until(lambda: "Belt: nothing near." in screen.main.inspector.lines, "the end of the run")


@pytest.mark.parametrize("size", [(40, 12), (80, 24), (120, 40), (200, 60)])
@pytest.mark.parametrize("world", ["living_room", "corridor", "maze"])
async def test_the_whole_room_is_seen_at_the_start(open_screen, world, size):
    async with open_screen(world=world, size=size) as screen:
        screen.main.go_to(screen.main.map_pane)
        await screen.painted()
        view = screen.main.map

        assert not view.hidden
        assert view.virtual_size.width <= view.size.width
        assert view.virtual_size.height <= view.size.height


async def test_at_two_hundred_columns_a_step_of_the_living_room_is_a_square(open_screen):
    async with open_screen(world="living_room", size=(200, 60)) as screen:
        await screen.painted()

        assert screen.main.map.scale.factor == 1
        assert screen.main.map._extent.columns == 2
        assert screen.main.log_rows.size.height >= 8


@pytest.mark.parametrize("size", [(80, 24), (110, 40), (120, 40), (140, 50), (200, 60)])
@pytest.mark.parametrize("world", ["living_room", "first_room", "corridor"])
async def test_coordinates_leave_the_map_as_large_as_it_was(open_screen, world, size):
    """Their column and row are taken from the program and the log, not from the squares."""
    async with open_screen("FW 1", world=world, size=size) as screen:
        await screen.painted()
        view = screen.main.map
        before = (view.scale.factor, view._extent, view.size)
        await screen.type_line("COORDINATES")
        await screen.shows("Coordinates")
        await screen.until(lambda: view.has_rulers, "the numbers")
        await screen.painted()

        assert (view.scale.factor, view._extent) == before[:2]
        assert not view.hidden
        assert screen.main.editor.size.width >= 39
        assert screen.main.log_pane.size.height <= size[1] / 3

        await screen.type_line("COORDINATES")
        await screen.until(lambda: not view.has_rulers, "no numbers")
        await screen.painted()
        assert view.size == before[2]


async def test_on_an_endless_floor_a_square_is_a_step(open_screen):
    async with open_screen(world="open_floor") as screen:
        assert screen.main.map.scale.factor == 1


async def test_the_plain_layout_shows_a_square_a_step(open_screen):
    async with open_screen(world="living_room", plain=True) as screen:
        assert screen.main.map.scale.factor == 1


async def test_plus_comes_nearer_and_minus_goes_further_away(open_screen):
    async with open_screen(world="living_room") as screen:
        view = screen.main.map
        view.focus()
        view.set_zoom(0)
        widths = {0: view.virtual_size.width}
        for key, zoom in (("plus", 1), ("minus", 0), ("minus", -1)):
            await screen.press(key)
            await screen.until(lambda zoom=zoom: view.zoom == zoom, key)
            widths[zoom] = view.virtual_size.width

        assert widths[1] > widths[0] > widths[-1]


NEAREST, FARTHEST = "The nearest: 6 columns a square.", "The farthest: 32 steps a square."
"""The limits that the documents name: a step has up to six columns; five times half the size."""


@pytest.mark.parametrize("size", [(40, 12), (80, 24), (120, 40)], ids=str)
async def test_the_limits_of_the_zoom_are_said_once_and_the_way_back_begins_at_once(open_screen, size):
    async with open_screen(world="living_room", size=size) as screen:
        view = screen.main.map
        screen.main.go_to(screen.main.map_pane)
        await screen.pilot.pause()
        for key, back, limit in (("plus", "minus", NEAREST), ("minus", "plus", FARTHEST)):
            await screen.press(*[key] * 15)
            await screen.shows(limit)
            await screen.painted()
            assert screen.log.count(limit) == 1
            assert screen.log[-1] == limit
            assert limit.rstrip(".") in " ".join(screen.text.split()), "in sight"
            said = len(screen.log)
            wide = view.virtual_size
            await screen.press(back)
            await screen.until(lambda wide=wide: view.virtual_size != wide, "another size")
            await screen.until(lambda said=said: len(screen.log) == said + 1, "an answer")
            await screen.press(key, key)
            await screen.until(lambda limit=limit: screen.log.count(limit) == 2, "the limit again")


async def test_the_limits_of_the_zoom_are_said_to_typed_words_too(open_screen):
    async with open_screen() as screen:
        for _ in range(6):
            await screen.type_line("ZOOM IN")
        await screen.shows(NEAREST)
        await screen.type_line("WHERE")
        await screen.type_line("ZOOM IN")
        await screen.until(lambda: screen.log.count(NEAREST) == 2, "once more after another answer")


async def test_a_square_grows_to_six_columns_by_three_rows_and_a_click_still_finds_it(open_screen):
    """The robot is a block of that size, which low vision and a projector need."""
    async with open_screen(world="living_room", size=(120, 40)) as screen:
        view = screen.main.map
        sizes = []
        for zoom in (0, 1, 2, 3):
            view.set_zoom(zoom)
            sizes.append((view._extent.columns, view._extent.rows))
        await screen.painted()
        robot = view._region_of(view.scale.robot)
        rows = [view.render_line(y).crop(robot.x, robot.right) for y in range(robot.y, robot.bottom)]

        assert sizes == [(1, 1), (2, 1), (4, 2), (6, 3)]
        assert rows[0].text == "^     "
        assert all(each.style.reverse for row in rows for each in row)
        await screen.pilot.click("#map", offset=(robot.x + 5 + 6, robot.y + 2))
        await screen.until(lambda: screen.status.startswith(" Map, 1, 0: free."), screen.status)


async def test_things_that_differ_in_colour_differ_in_letters(open_screen):
    async with open_screen(world="colour_garden", size=(160, 50)) as screen:
        view = screen.main.map
        view.set_zoom(1)
        await screen.painted()
        scene = view.scale.scene
        shown = {
            thing.colour: "".join(
                each.text
                for each in [view._segment(view.scale.square_of(scene.cell_at(thing.x, thing.y)), 0)]
            )[:2]
            for thing in scene.things
            if thing.letter == "f"
        }

        assert len(shown) > 1
        assert len(set(shown.values())) == len(shown)
        assert shown["red"] == "fR"


@pytest.mark.parametrize("size", [(80, 24), (120, 40)])
async def test_each_robot_has_its_heading_from_the_start_and_the_titles_name_the_chosen_one(
    open_screen, size
):
    async with open_screen("FW 1", world="two_robots", size=size) as screen:
        await screen.painted()
        view = screen.main.map
        bob = next(each for each in view.scale.scene.things if each.is_robot)
        square = view.scale.square_of(view.scale.scene.cell_at(bob.x, bob.y))

        assert view._segment(square, 0).text in ("v", "vb")
        titles = screen.text.splitlines()[0]
        assert "alice: Program" in titles and "alice: Map" in titles


async def test_another_robot_has_its_own_colour_wherever_it_is(open_screen):
    """Bob is blue in the world's file; the chosen robot has the colour of what is chosen."""
    async with open_screen("FW 1", world="two_robots", size=(120, 40)) as screen:
        await screen.painted()
        view = screen.main.map
        scene = view.scale.scene
        bob = next(each for each in scene.things if each.is_robot)
        for north in (0, 4):
            scene.move_other("bob", Pose(bob.x, bob.y + north, 180.0))
            square = view.scale.square_of(scene.cell_at(bob.x, bob.y + north))
            painted = view._segment(square, 0)

            assert painted.text in ("v", "vb")
            assert painted.style.color == view._look("thing-blue").color
            assert painted.style.bold and painted.style.reverse
        assert view._segment(view.scale.robot, 0).style.color == view._look("robot").color


async def test_a_picture_shows_all_of_a_room_that_letters_do_not_and_a_click_finds_a_square(open_screen):
    """Its 42 rows of squares, the walls among them, in half as many rows of the map, which has 26."""
    async with open_screen(world="living_room", size=(120, 40)) as screen:
        view = screen.main.map
        view.show_all(False)
        await screen.until(lambda: view.hidden, "the floor outside")
        await screen.until(lambda: screen.main.map_pane._titles[0].startswith("Map: more N"), "the title")

        await screen.type_line("PICTURE")
        await screen.shows("The map is a picture.")
        await screen.until(lambda: not view.hidden, "the whole floor")
        await screen.painted()

        assert screen.main.map_pane._titles[0] == "Map: Living room, 40 by 40"
        assert view.scale.bounds.height == 42
        rows = [view.render_line(y).text for y in range(21)]
        assert rows[0].startswith("█▀▀▀")
        assert rows[20].startswith("█▄▄▄")
        robot = view._region_of(view.scale.robot)
        assert rows[robot.y][robot.x] == "^"
        await screen.pilot.click("#map", offset=(robot.x + 2, robot.y))
        await screen.until(lambda: screen.status.startswith(" Map, 2, "), screen.status)

        await screen.type_line("PICTURE")
        await screen.shows("The map is in letters.")
        assert view.render_line(1).text.startswith("#...")


async def test_a_picture_paints_two_squares_in_their_own_colours(open_screen):
    """The blue thing above a free square is an upper half in blue, and nothing below it."""
    async with open_screen(world="colour_garden", size=(120, 40)) as screen:
        await screen.type_line("PICTURE")
        await screen.shows("The map is a picture.")
        view = screen.main.map
        view.set_zoom(0)
        await screen.painted()
        scale = view.scale
        painted = {
            kind: view._segment(cell, 0)
            for thing in scale.scene.things
            for cell in [scale.square_of(scale.scene.cell_at(thing.x, thing.y))]
            for kind in [scale.shown(cell)[1]]
            if kind.startswith("thing-") and kind != "thing-gray"
        }

        assert len(painted) > 2
        for kind, segment in painted.items():
            assert segment.text.strip() in "▀▄█"
            assert view._look(kind).color in (segment.style.color, segment.style.bgcolor)


@pytest.mark.parametrize("theme", themes.NAMES)
async def test_in_a_picture_of_sixteen_colours_all_things_differ(open_screen, theme):
    """Also where a console shows a dark colour in bold as the bright one."""
    async with open_screen(world="colour_garden", size=(120, 40)) as screen:
        screen.app.theme = theme
        screen.app.console._color_system = ColorSystem.STANDARD
        await screen.type_line("PICTURE")
        await screen.shows("The map is a picture.")
        strip = Strip([Segment("█", screen.main.map._look(f"thing-{each}")) for each in themes.COLOURS])
        for each in screen.app._filters:
            if each.enabled:
                strip = strip.apply_filter(each, Color.parse("black"))
        sent, seen = set(), set()
        for segment in strip:
            sent.add(segment.style.render("█", color_system=ColorSystem.STANDARD))
            number = segment.style.color.downgrade(ColorSystem.STANDARD).number
            seen.add(number + 8 if segment.style.bold and number is not None and number < 8 else number)

        assert len(sent) == len(seen) == len(themes.COLOURS) == 7


async def test_without_colours_there_is_no_picture(open_screen, monkeypatch):
    monkeypatch.setenv("NO_COLOR", "1")
    async with open_screen(world="living_room") as screen:
        await screen.type_line("PICTURE")
        await screen.shows("There are no colors here.")
        assert not screen.main.map.is_picture


async def test_the_path_is_shown_on_a_page_in_words_and_as_a_picture(open_screen) -> None:  # type: ignore[no-untyped-def]
    async with open_screen(world="first_room") as screen:
        await screen.run("FW 3\nTR 90\nFW 2")
        await screen.type_line("SHOW PATH")
        await screen.until(lambda: "East: 2 steps, to 2, 3." in screen.text, "the legs")
        await screen.press("end")
        await screen.until(lambda: "oo>" in screen.text, "the picture")


@pytest.mark.parametrize("size", [(40, 12), (80, 24), (120, 40)])
async def test_a_sign_on_the_edge_says_where_things_are_outside(open_screen, size):
    """Found by looking through the whole floor: a thing's row or column of the window leads to it."""
    async with open_screen(world="living_room", size=size) as screen:
        screen.main.go_to(screen.main.map_pane)
        view = screen.main.map
        view.set_zoom(2)
        await screen.until(lambda: view.hidden, "floor outside")
        await screen.painted()
        window = [view.render_line(y).text for y in range(view.size.height)]
        (right, down), (width, height) = view.scroll_offset, view.size
        scene, bounds, extent = view.scale.scene, view.scale.bounds, view._extent
        wanted = set()
        for x in range(bounds.left, bounds.right + 1):
            for y in range(bounds.bottom, bounds.top + 1):
                cell = scene.robot._replace(x=x, y=y)
                if scene.kind(cell).value != "thing":
                    continue
                left, top = (x - bounds.left) * extent.columns - right, (bounds.top - y) * extent.rows - down
                is_seen = -extent.columns < left < width and -extent.rows < top < height
                if not is_seen:
                    column = max(0, min(width - 1, left + extent.columns // 2))
                    wanted.add((column, max(0, min(height - 1, top + extent.rows // 2))))

        signs = {(x, y) for y, row in enumerate(window) for x, letter in enumerate(row) if letter == "+"}
        covering = {(x, y) for x, y in wanted if window[y][x] != "+"}
        assert wanted and signs == wanted - covering
        assert all(window[y][x].isalpha() or window[y][x] in "^A" for x, y in covering)

        view.show_all(True)
        await screen.until(lambda: not view.hidden, "the whole floor")
        await screen.painted()
        assert "+" not in "".join(view.render_line(y).text for y in range(view.size.height))


async def test_a_robot_that_walks_outside_moves_its_sign_and_paints_nothing_else(open_screen, monkeypatch):
    async with open_screen("FW 1", world="two_robots", size=(80, 24)) as screen:
        screen.main.go_to(screen.main.map_pane)
        view = screen.main.map
        view.set_zoom(3)
        await screen.until(lambda: view.hidden, "floor outside")
        await screen.painted()
        scene = view.scale.scene
        bob = next(each for each in scene.things if each.is_robot)
        before = view._marks
        painted = []
        monkeypatch.setattr(view, "refresh", lambda *regions, **_: painted.extend(regions))
        view.update_cells(scene.move_other("bob", Pose(bob.x, bob.y + 4, 180.0)))

        gone_or_new = {region.offset for region in painted if region.area == 1}
        assert view._marks != before
        assert gone_or_new == before ^ view._marks


async def test_the_legend_names_the_sign_of_the_edge(open_screen):
    async with open_screen(world="living_room") as screen:
        await screen.press("ctrl+k", "l")
        await screen.until(lambda: "A plus at the edge: more lies outside." in screen.text, "the legend")


async def test_a_short_list_is_seen_whole_in_forty_columns(open_screen):
    """The keys below it take two rows there; it had one too few."""
    async with open_screen(world="two_robots", size=(40, 12)) as screen:
        await screen.type_line("ROBOT")
        await screen.until(lambda: "Robots of this world" in screen.text, "the list")
        await screen.painted()

        assert "alice: 0, 0" in screen.text
        assert "bob: 0, 30" in screen.text
        assert "Esc goes back" in screen.text


@pytest.mark.parametrize("row", [0, 2, 5])
async def test_words_to_complete_never_cover_the_line_that_they_complete(open_screen, row):
    """Eight rows of 40 by 12 are the pane's: on one side of any row of it are four."""
    async with open_screen("\n" * 7, size=(40, 12)) as screen:
        screen.main.editor.move_cursor((row, 0))
        await screen.painted()
        cursor = screen.app.cursor_position.y
        await screen.press("ctrl+@")
        await screen.until(lambda: screen.app.screen is not screen.main, "the list")
        await screen.painted()
        region = screen.app.screen.list.region

        assert region.height >= 4
        assert not region.y <= cursor < region.bottom


@pytest.mark.parametrize("plain", [False, True])
@pytest.mark.parametrize("size", [(40, 12), (20, 5), (80, 24)])
@pytest.mark.parametrize("row", [0, 3, 6])
async def test_words_to_complete_cover_neither_the_command_line_nor_the_status(open_screen, size, row, plain):
    async with open_screen("\n" * 7, size=size, plain=plain) as screen:
        screen.main.go_to(screen.main.program_pane)
        screen.main.editor.move_cursor((row, 0))
        await screen.painted()
        await screen.press("ctrl+@")
        await screen.until(lambda: screen.app.screen is not screen.main, "the list")
        await screen.painted()
        listed = screen.app.screen.list.region

        assert listed.height >= 1
        for fixed in (screen.main.command_line, screen.main.status, screen.main.keys):
            assert not listed.overlaps(fixed.region)
