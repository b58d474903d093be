"""Panes, focus, the terminal's cursor, sizes: what is seen and how one gets there, by keys alone."""

from textual.geometry import Offset

from devices.ports.robot import Pose
from tests.tui.conftest import burst

SIZES = [(40, 12), (80, 24), (100, 30), (120, 40), (200, 60)]


def caret(desk) -> Offset:
    return desk.app.cursor_position


async def test_the_first_row_of_the_log_leads_to_the_linear_mode(work):
    async with work() as desk:
        assert desk.log[0] == "Screen reader? Type LINEAR and Enter."
        assert desk.log[0] in desk.screen


async def has_focus(desk, name: str) -> None:
    """A key passes from the widget up to the application: a busy machine has more to do than the press."""
    await desk.until(lambda: desk.app.focused is not None and desk.app.focused.id == name, name)
    await desk.pilot.pause()


async def test_the_order_of_focus_is_the_order_of_reading_and_back(work):
    async with work(size=(120, 40)) as desk:
        order = ["editor", "map", "inspector", "log", "command"]
        for name in [*order[1:], order[0]]:
            await desk.press("tab")
            await has_focus(desk, name)
        for name in [*reversed(order[1:]), order[0]]:
            await desk.press("shift+tab")
            await has_focus(desk, name)


async def test_the_status_line_names_the_focus(work):
    async with work("FW 1\nFW 2") as desk:
        for words in ("Program, line 1 of 2", "Map", "Log, line 2 of 2", "Command line"):
            await desk.until(lambda expected=words: desk.status.split(".")[0].strip() == expected, words)
            await desk.press("tab")


async def test_the_terminal_s_cursor_stands_at_the_focus(work):
    async with work("FW 1") as desk:
        await desk.press("right")
        editor = desk.place.editor
        assert caret(desk) == editor.cursor_screen_offset

        await desk.press("tab")
        await has_focus(desk, "map")
        grid, view = desk.place.map.grid, desk.place.map
        x, y = caret(desk)
        assert view.region.contains(x, y)
        strips = desk.app.screen._compositor.render_strips()
        assert strips[y].text[x] == "^"
        assert grid.letter(grid.robot) == "^"

        await desk.press("tab")
        await has_focus(desk, "log")
        x, y = caret(desk)
        assert (x, strips_text(desk)[y][x]) == (desk.place.log_rows.region.x, ">")

        await desk.press("tab")
        await has_focus(desk, "command")
        assert caret(desk) == desk.place.command_line.cursor_screen_offset


def strips_text(desk) -> list[str]:
    return [strip.text for strip in desk.app.screen._compositor.render_strips()]


async def test_the_cursor_follows_the_robot_while_the_map_has_the_focus(work):
    async with work("FW 4 TR 90 FW 3") as desk:
        await desk.press("tab", "f5")
        await desk.shows("The program is done.")
        await desk.pilot.pause()

        x, y = caret(desk)
        assert strips_text(desk)[y][x] == ">"


async def test_the_map_follows_a_robot_that_leaves_the_picture(work):
    async with work("FW 200\nTR 90\nFW 300") as desk:
        await desk.press("f5")
        await desk.shows("The program is done.")
        await desk.pilot.pause()

        assert "o>" in "\n".join(row[40:] for row in strips_text(desk)[1:14])


async def test_a_map_that_was_explored_follows_the_robot_again_and_keeps_the_square_for_later(work):
    async with work("TR 90\nFW 28") as desk:
        await desk.press("tab", "left")
        await desk.until(lambda: desk.place.map.is_exploring, "exploring")
        square = desk.place.map.pointer.cell
        await desk.press("shift+tab")
        await has_focus(desk, "editor")
        await desk.press("f5")
        await desk.shows("The program is done.")
        await desk.pilot.pause()
        assert "o>" in "\n".join(row[40:] for row in strips_text(desk)[1:14])
        await desk.type_line("FW 30")
        await desk.shows("I walked 30 steps forward.")
        await desk.idle()
        await desk.pilot.pause()
        assert "o>" in "\n".join(row[40:] for row in strips_text(desk)[1:14]), "after a typed command too"

        desk.place.map.focus()
        await has_focus(desk, "map")
        assert desk.place.map.pointer.cell == square
        x, y = caret(desk)
        assert desk.place.map.region.contains(x, y)


async def test_while_a_square_is_explored_the_map_stays_with_it(work):
    async with work("TR 90\nFW 28") as desk:
        await desk.press("tab", "left")
        await desk.until(lambda: desk.place.map.is_exploring, "exploring")
        await desk.press("f5")
        await desk.shows("The program is done.")
        await desk.pilot.pause()

        x, y = caret(desk)
        assert desk.place.map.region.contains(x, y)
        assert "Map, -1, 0:" in desk.status


async def test_exploring_names_the_cell_and_home_goes_back_to_the_robot(work):
    async with work(world="living_room") as desk:
        await desk.press("tab", "right")
        await desk.pilot.pause()
        assert desk.status.startswith(" Map, 1, 0: free.")
        burst(desk, *["left"] * 20)
        await desk.until(lambda: "wall." in desk.status, "the wall")

        await desk.press("home")
        await desk.pilot.pause()
        assert desk.status.startswith(" Map. Donnie at")


async def test_things_are_named_when_they_are_explored(work):
    async with work(world="living_room", size=(120, 40)) as desk:
        thing = desk.place.map.grid.picture.things[0]
        desk.place.map.pointer.cell = desk.place.map.grid.cell_of(Pose(round(thing.x), round(thing.y), 0.0))
        desk.place.map.focus()
        await desk.press("left", "right")
        await desk.pilot.pause()

        assert f": {thing.name}, {thing.colour}. " in desk.status


async def test_every_size_shows_the_focus_the_command_line_and_the_status(work):
    async with work("FW 1\nFW 2", size=SIZES[-1]) as desk:
        for size in ((40, 12), (80, 24), (120, 40)):
            await desk.pilot.resize_terminal(*size)
            await desk.painted()
            for _ in range(5):
                focused = desk.app.focused
                assert focused.region.area, f"{focused} at {size}"
                assert desk.place.command_line.region.area
                assert desk.place.status.region.area
                await desk.press("tab")
                await desk.pilot.pause()


async def test_the_size_may_change_while_a_program_is_paused_and_the_focus_stays(work):
    async with work("FW 1\nFW 2\nFW 3") as desk:
        await desk.press("f7")
        await desk.shows("Line 1: FW 1")
        for size in (*SIZES, (1, 1), (20, 5), (80, 24)):
            await desk.pilot.resize_terminal(*size)
            await desk.pilot.pause()
            assert desk.place.editor.has_focus
        await desk.press("f7")
        await desk.shows("Line 2: FW 2")

        assert "> 2  FW 2" in desk.screen


async def test_forty_columns_show_one_pane_at_a_time(work):
    async with work("FW 1", size=(40, 12)) as desk:
        assert "Program:" in desk.screen
        assert "Map:" not in desk.screen
        await desk.press("tab")
        await desk.pilot.pause()

        assert "Map:" in desk.screen
        assert "Program:" not in desk.screen


async def test_f4_shows_the_inspector_and_goes_back(work):
    async with work("VAR a = 5\nFW 1\nFW 2") as desk:
        await desk.press("f7", "f4")
        await desk.pilot.pause()
        assert desk.app.focused.id == "inspector"
        assert "Variables" in desk.screen
        await desk.press("f4")
        await desk.pilot.pause()

        assert desk.place.editor.has_focus
        assert "Map:" in desk.screen


async def the_map_is_seen(desk) -> None:
    await has_focus(desk, "map")
    await desk.until(lambda: desk.place.map.region.width >= 20 and "Map:" in desk.screen, "the map")
    x, y = caret(desk)
    assert desk.place.map.region.contains(x, y)


async def test_the_map_comes_back_when_it_is_asked_for_in_the_inspector_s_place(work):
    async with work("FW 1", world="living_room") as desk:
        for size in ((80, 15), (100, 30)):
            await desk.pilot.resize_terminal(*size)
            await desk.painted()
            for way in ("SHOW MAP", "shift+tab"):
                await desk.press("f4")
                await has_focus(desk, "inspector")
                if way == "SHOW MAP":
                    await desk.type_line(way)
                else:
                    await desk.press(way)

                await the_map_is_seen(desk)


async def test_a_focus_on_the_map_or_the_inspector_is_seen_in_a_smaller_terminal_too(work):
    async with work("FW 1", size=(120, 40)) as desk:
        await desk.press("f4", "shift+tab")
        await has_focus(desk, "map")
        await desk.pilot.resize_terminal(80, 24)
        await the_map_is_seen(desk)

        await desk.pilot.resize_terminal(120, 40)
        await desk.press("tab")
        await has_focus(desk, "inspector")
        await desk.pilot.resize_terminal(80, 24)
        await desk.until(lambda: "Variables" in desk.screen or "variables" in desk.screen, "the inspector")
        await has_focus(desk, "inspector")


async def test_words_go_to_the_panes(work):
    async with work() as desk:
        for typed, focused in (("show map", "map"), ("SHOW LOG", "log"), ("Show Program", "editor")):
            await desk.type_line(typed)
            await desk.until(lambda focused=focused: desk.app.focused.id == focused, focused)


async def test_up_and_down_restore_typed_lines(work):
    async with work() as desk:
        await desk.type_line("FW 1")
        await desk.idle()
        await desk.type_line("FW 2")
        await desk.idle()
        await desk.press("up", "up")
        assert desk.place.command_line.value == "FW 1"
        await desk.press("down", "down")

        assert desk.place.command_line.value == ""


async def test_the_log_is_read_by_rows_and_follows_its_end_again(work):
    async with work() as desk:
        await desk.run("FOR VAR i = 0; i < 40; i = i + 1 DO SPEAK i END FOR")
        desk.place.log_rows.focus()
        await desk.press("home")
        await desk.pilot.pause()
        assert desk.status.startswith(f" Log, line 1 of {desk.place.log_rows.row_count}.")
        await desk.type_line("SPEAK 99")
        await desk.shows("99")
        assert desk.place.log_rows.row == 0

        desk.place.log_rows.focus()
        await desk.press("end")
        await desk.type_line("SPEAK 100")
        await desk.shows("100")
        assert desk.place.log_rows.row_text == "100"


async def test_without_colours_the_screen_says_the_same(work, monkeypatch, tmp_path):
    async with work("FW 1") as desk:
        await desk.press("f7")
        await desk.shows("Line 1: FW 1")
        await desk.pilot.pause()
        with_colours = desk.screen
    monkeypatch.setenv("NO_COLOR", "1")
    for each in tmp_path.rglob("unsaved-*.gd"):  # the first screen ended without a question
        each.unlink()
    async with work("FW 1") as desk:
        await desk.press("f7")
        await desk.shows("Line 1: FW 1")
        await desk.pilot.pause()

        assert desk.app.theme == "donnie-terminal"
        assert desk.screen == with_colours


async def test_a_thing_that_is_pushed_in_every_run_is_shown_where_it_is(work):
    async with work("FW 20", world="object_field") as desk:

        def cone() -> int:
            (it,) = (each for each in desk.place.map.scale.scene.things if each.colour == "green")
            return round(it.y)

        for run in range(1, 4):
            await desk.press("f5")
            await desk.until(lambda run=run: desk.log.count("The program is done.") == run)
            await desk.until(lambda: cone() == 23, "the cone is where it was pushed to")

        await desk.type_line("RESET")
        await desk.until(lambda: cone() == 12, "the cone is back")


# --- the first start


async def test_the_tour_is_offered_at_the_first_start_in_a_sentence_that_is_spoken_too(work):
    async with work(tour=True) as desk:
        await desk.shows("New here? TOUR shows you around.")
        assert desk.place.editor.has_focus, "nothing is in the way"
    async with work(tour=True) as desk:
        await desk.pilot.pause()
        assert "New here? TOUR shows you around." not in desk.log


async def test_a_file_of_the_command_line_comes_before_the_tour(work, tmp_path):
    path = tmp_path / "walk.gd"
    path.write_text("FW 1\n", encoding="utf-8")
    async with work(file=path, tour=True) as desk:
        await desk.shows("Opened walk.gd")
        assert "New here? TOUR shows you around." not in desk.log
    async with work(tour=True) as desk:
        await desk.shows("New here? TOUR shows you around.")


# --- the belt


async def test_the_belt_is_shown_next_to_the_variables_in_words_and_by_motor(work):
    async with work("BELT ON\nFW 9\nWAIT 1000", size=(120, 40), world="corridor", speed=1000.0) as desk:
        assert "Upper row" not in desk.screen
        await desk.press("f5")
        await desk.until(lambda: "Belt: " in desk.screen and "Upper row: " in desk.screen, "the belt")
        levels = desk.app.controller.donnie.outlets.belt.rows()
        await desk.until(lambda: all(each in desk.place.inspector.lines for each in levels), "the rows")
        assert any(digit in levels[2] for digit in "123")

        await desk.type_line("FEEL ROWS")
        await desk.shows("Lower row: ")
        await desk.press("f8")
        await desk.idle()
        await desk.until(lambda: "Belt: nothing near." in desk.place.inspector.lines, "the end of the run")


async def test_plus_comes_nearer_and_minus_goes_further_away(work):
    async with work(world="living_room") as desk:
        view = desk.place.map
        view.focus()
        widths = {0: view.virtual_size.width}
        for key, zoom in (("plus", 1), ("minus", 0), ("minus", -1)):
            await desk.press(key)
            await desk.until(lambda zoom=zoom: view.zoom == zoom, key)
            widths[zoom] = view.virtual_size.width

        assert widths[1] > widths[0] > widths[-1]
