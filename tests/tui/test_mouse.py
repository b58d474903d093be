"""What a click does: a key of the bottom line is pressed, a square of the map is described."""

import pytest
from textual import events
from textual.geometry import Offset

pytestmark = pytest.mark.slow


async def test_a_click_on_a_key_of_the_bottom_line_presses_it(open_screen):
    async with open_screen() as screen:
        screen.load("FW 2")
        at = screen.main.keys.words.index("Run") + 1
        before = screen.app.focused

        await screen.pilot.click(screen.main.keys, offset=Offset(at, 0))

        await screen.shows("I walked 2 steps forward.")
        assert screen.app.focused is before


async def test_a_click_next_to_the_keys_presses_none(open_screen):
    async with open_screen() as screen:
        keys = screen.main.keys
        done = []
        screen.app.controller.do = lambda name, argument=None: done.append(name)

        for at in (0, keys.words.index("  "), keys.words.index("  ") + 1):
            await screen.pilot.click(keys, offset=Offset(at, 0))
        await screen.pilot.pause()

        assert done == []


async def test_a_click_on_the_map_describes_the_square(open_screen):
    async with open_screen(world="living_room") as screen:
        shown = screen.main.map
        shown.show_all(False)
        robot = shown.cursor_screen_offset - shown.content_region.offset

        await screen.pilot.click(shown, offset=robot + Offset(2 * shown._extent.columns, -3))
        await screen.until(lambda: shown.is_exploring, "the click")

        assert screen.app.focused is shown
        await screen.until(lambda: screen.status.startswith(" Map, 2, 3: free."), "the words")


async def test_a_click_next_to_the_floor_explores_nothing(open_screen):
    async with open_screen(world="living_room") as screen:
        shown = screen.main.map
        shown.set_zoom(-3)
        await screen.pilot.pause()
        await screen.pilot.click(shown, offset=Offset(shown.size.width - 1, shown.size.height - 1))
        await screen.pilot.pause()

        assert not shown.is_exploring


async def test_the_palette_is_reached_by_a_click_and_its_rows_too(open_screen):
    async with open_screen("FW 2") as screen:
        keys = screen.main.keys
        assert keys.words.endswith("Ctrl+P All")
        await screen.pilot.click(keys, offset=Offset(keys.words.index("All"), 0))
        await screen.until(lambda: screen.app.screen is not screen.main, "the palette")
        await screen.painted()
        row = next(at for at, line in enumerate(screen.text.splitlines()) if " STEP " in line)
        await screen.pilot.click(offset=(screen.text.splitlines()[row].index(" STEP ") + 2, row))
        await screen.shows("Line 1: FW 2")


async def test_a_click_next_to_a_line_sets_a_breakpoint_and_another_one_removes_it(open_screen):
    """In the third line, below one that takes two rows."""
    async with open_screen('FW 1\nSPEAK "' + "word " * 12 + '"\nFW 2') as screen:
        await screen.painted()
        row = next(at for at, line in enumerate(screen.text.splitlines()) if line.startswith("  3  FW 2"))
        for expected in ({3}, set()):
            await screen.pilot.click(offset=(2, row))
            await screen.until(lambda lines=expected: screen.main.editor.breakpoints == lines, str(expected))

        assert screen.main.editor.cursor_location == (0, 0)


async def test_a_click_chooses_a_world(open_screen):
    async with open_screen() as screen:
        await screen.type_line("WORLDS")
        await screen.until(lambda: screen.app.screen is not screen.main, "the list")
        await screen.painted()
        chosen: list[str] = []
        screen.app.screen.dismiss = lambda value: chosen.append(value)
        row = next(at for at, line in enumerate(screen.text.splitlines()) if " Corridor " in line)
        await screen.pilot.click(offset=(screen.text.splitlines()[row].index("Corridor"), row))
        await screen.until(lambda: chosen, "the choice")

        assert chosen == ["corridor"]


async def test_examples_and_challenges_are_a_click_away_from_an_empty_program(open_screen):
    async with open_screen() as screen:
        keys = screen.main.keys
        assert "Challenges" in keys.words
        await screen.pilot.click(keys, offset=Offset(keys.words.index("Examples"), 0))
        await screen.until(lambda: screen.app.screen is not screen.main, "the list")
        await screen.painted()
        await screen.pilot.click(screen.app.screen.rows, offset=(3, 0))
        await screen.shows("Opened A square, 4 lines.")
        await screen.until(lambda: "Examples" not in keys.words, "the keys of a program")


async def test_mistakes_worlds_programs_and_settings_are_a_click_away(open_screen):
    async with open_screen("FWD 3") as screen:
        keys = screen.main.keys
        await screen.until(lambda: "Errors" in keys.words, "the keys of a wrong program")
        for widget, offset, title in (
            (keys, Offset(keys.words.index("Errors"), 0), "1 error."),
            (screen.main.map_pane._heading, Offset(3, 0), "Worlds"),
            (screen.main.status, Offset(2, 0), "Settings"),
        ):
            await screen.pilot.click(widget, offset=offset)
            await screen.until(lambda: screen.app.screen is not screen.main, title)
            assert title in screen.app.screen._title_words
            await screen.press("escape")
            await screen.until(lambda: screen.app.screen is screen.main, "the main screen")

        await screen.pilot.click(screen.main.program_pane._heading, offset=Offset(3, 0))
        await screen.until(lambda: screen.app.screen is not screen.main, "the programs to open")


async def test_the_list_of_worlds_shows_the_chosen_one_with_its_map_and_task(open_screen):
    async with open_screen(size=(120, 40)) as screen:
        await screen.type_line("WORLDS")
        await screen.until(lambda: screen.app.screen is not screen.main, "the list")
        await screen.painted()
        for world, title in (("two_rooms", "Two rooms"), ("maze", "Maze")):
            while screen.app.screen._fitting[screen.app.screen.rows.line].value != world:
                await screen.press("down")
            await screen.painted()
            about = " ".join(screen.app.screen._detail.lines)
            floor = [line for line in screen.app.screen._detail.lines if line.startswith("##")]

            assert title in screen.text
            assert len(floor) >= 10
            assert "Task: " in about
        assert "yellow ball" not in about


async def test_what_a_dialog_says_of_enter_and_esc_can_be_clicked(open_screen):
    async with open_screen("FW 1") as screen:
        for said, name in (("Esc goes", "donnie-dark"), ("Enter takes", "donnie-light")):
            await screen.type_line("THEME")
            await screen.until(lambda: screen.app.screen is not screen.main, "the list")
            await screen.press("down")
            await screen.painted()
            y, row = next((y, row) for y, row in enumerate(screen.text.splitlines()) if said in row)
            await screen.pilot.click(offset=(row.index(said) + 2, y))
            await screen.until(lambda: screen.app.screen is screen.main, "the main screen")
            await screen.until(lambda name=name: screen.app.theme == name, name)


async def test_yes_and_no_can_be_clicked(open_screen):
    """No to whether the program is to be saved."""
    async with open_screen("FW 1") as screen:
        screen.main.editor.insert("FW 2")
        await screen.press("ctrl+n")
        await screen.until(lambda: screen.app.screen is not screen.main, "the question")
        await screen.until(lambda: screen.app.screen._list.lines == ("yes", "no"), "the answers")
        await screen.painted()
        await screen.pilot.click(screen.app.screen._list, offset=(2, 1))
        await screen.shows("This is a new program.")

        assert screen.main.editor.text == ""


async def test_a_small_list_has_one_row_a_world_and_what_is_there_below(open_screen) -> None:  # type: ignore[no-untyped-def]
    async with open_screen(size=(40, 12)) as screen:
        screen.app.do("worlds")
        await screen.until(lambda: "Open floor" in screen.text, "the list")
        await screen.press("home", "down", "down")
        await screen.painted()
        rows = [row.rstrip() for row in screen.text.splitlines()]

        assert rows[:4] == [
            " Worlds",
            " First room             easy",
            " Open floor             easy",
            ">Living room            easy",
        ]
        assert rows[4].endswith(" easy") and rows[5].endswith(" easy")
        assert rows[6] == " A room of 40 by 40 steps with walls"
        assert rows[7].endswith(" ...")
        assert rows[8] == ">"
        assert rows[11] == " Enter takes it, Esc goes back"


PANELS = {
    "list": (("ctrl+l",), "Enter takes it, Esc goes back"),
    "files": (("ctrl+o",), "Enter takes it, Esc goes back"),
    "help": (("f1",), "F1: the manual, Esc goes back"),
    "page": (("ctrl+k", "0"), "Esc goes back, arrows read"),
    "menu": (("ctrl+k",), "Enter takes it, Esc goes back"),
    "question": (("ctrl+f",), "Enter answers, Esc goes back"),
    "words": (("ctrl+@",), "Enter takes it, Esc goes back"),
}


@pytest.mark.parametrize("name", PANELS)
async def test_the_bottom_line_has_the_keys_of_what_is_in_front(open_screen, name) -> None:  # type: ignore[no-untyped-def]
    """Also where it is narrow; and a click there is that key."""
    keys, said = PANELS[name]
    async with open_screen("REPEAT 2 TIMES\nFW 1\nEND REPEAT", size=(40, 12)) as screen:
        screen.main.editor.move_cursor((1, 0))
        before = screen.text.splitlines()[-1]
        await screen.press(*keys)
        await screen.until(lambda: screen.app.screen is not screen.main, name)
        await screen.painted()
        assert screen.text.splitlines()[-1] == f" {said}"
        assert "READY" in screen.text

        await screen.pilot.click(offset=(screen.text.splitlines()[-1].index("Esc") + 1, 11))
        await screen.until(lambda: screen.app.screen is screen.main, "the main screen")
        await screen.painted()
        assert screen.text.splitlines()[-1] == before


async def test_a_click_on_the_keys_that_press_nothing_leaves_a_list_open(open_screen) -> None:  # type: ignore[no-untyped-def]
    async with open_screen() as screen:
        await screen.type_line("THEME")
        await screen.until(lambda: screen.app.screen is not screen.main, "the list")
        listed = screen.app.screen
        await screen.painted()
        for said in ("Up and Down", "typing"):
            await screen.pilot.click(offset=(screen.text.splitlines()[23].index(said) + 1, 23))
            await screen.painted()
            assert screen.app.screen is listed


@pytest.mark.parametrize(
    ("language", "shown", "title"),
    [
        ("en", "EXAMPLES,", "example"),
        ("pt", "EXEMPLOS,", "exemplo"),
        ("es", "RETO,", "reto"),
    ],
)
async def test_a_click_on_a_command_in_an_empty_program_does_it(open_screen, language, shown, title) -> None:  # type: ignore[no-untyped-def]
    async with open_screen(size=(40, 12), language=language) as screen:
        await screen.painted()
        rows = screen.text.splitlines()
        row = next(at for at, each in enumerate(rows) if shown in each)
        await screen.pilot.click(offset=(rows[row].index(shown) + 2, row))
        await screen.until(lambda: screen.app.screen is not screen.main, "the list")
        await screen.painted()
        assert title in screen.text.splitlines()[0].casefold()
        await screen.press("escape")
        await screen.until(lambda: screen.app.screen is screen.main, "the program")
        await screen.pilot.click(offset=(10, 2))  # the example: a click there does nothing
        await screen.press("x")
        await screen.until(lambda: screen.main.editor.text == "x", "typing")


async def test_a_click_on_a_page_of_the_tour_turns_it_where_it_is_no_strip(open_screen) -> None:  # type: ignore[no-untyped-def]
    async with open_screen(size=(40, 12)) as screen:
        await screen.type_line("TOUR")
        await screen.until(lambda: "Tour 1 of" in screen.text, "the first page")
        await screen.painted()
        await screen.pilot.click(offset=(10, 2))
        await screen.until(lambda: "Tour 2 of" in screen.text, "the second page")


@pytest.mark.parametrize("size", [(40, 12), (80, 24), (120, 40)], ids=str)
async def test_a_click_on_a_row_of_the_keys_after_the_menu_key_does_its_command(open_screen, size) -> None:  # type: ignore[no-untyped-def]
    async with open_screen("FW 1", size=size) as screen:
        for clicked, name in (("COORDINATES", "has_rulers"), ("PICTURE", "is_picture")):
            await screen.press("ctrl+k")
            await screen.until(lambda: screen.app.screen is not screen.main, "the keys")
            await screen.painted()
            rows = screen.text.splitlines()
            for _ in range(20):
                if any(clicked in row for row in rows):
                    break
                await screen.pilot._post_mouse_events([events.MouseScrollDown], offset=(20, 5))
                await screen.painted()
                rows = screen.text.splitlines()
            row = next(at for at, each in enumerate(rows) if clicked in each)
            await screen.pilot.click(offset=(rows[row].index(clicked) + 2, row))
            await screen.until(lambda: screen.app.screen is screen.main, "the main screen")
            await screen.until(lambda name=name: getattr(screen.main.map, name), clicked)


async def test_a_click_on_the_words_about_enter_does_the_chosen_command_of_the_menu_key(open_screen) -> None:  # type: ignore[no-untyped-def]
    async with open_screen("FW 1") as screen:
        await screen.press("ctrl+k")
        await screen.until(lambda: screen.app.screen is not screen.main, "the keys")
        menu = screen.app.screen
        menu.rows.read_line(next(at for at, cells in enumerate(menu.cells) if cells[1] == "COORDINATES"))
        await screen.painted()
        at = screen.text.splitlines()[-1].index("Enter takes")
        await screen.pilot.click(offset=(at + 1, 23))
        await screen.until(lambda: screen.app.screen is screen.main, "the main screen")
        await screen.until(lambda: screen.main.map.has_rulers, "the rulers")


async def test_the_wheel_moves_the_chosen_word_to_complete_with_its_list(open_screen) -> None:  # type: ignore[no-untyped-def]
    """The words of the first lesson, by their order on an empty line; one notch is three rows."""
    async with open_screen("") as screen:
        await screen.press("ctrl+@")
        await screen.until(lambda: screen.app.screen is not screen.main, "the words")
        await screen.painted()
        words = screen.app.screen.list
        seen = []
        for turn in (events.MouseScrollDown, events.MouseScrollDown, events.MouseScrollUp):
            await screen.pilot._post_mouse_events([turn], words)
            await screen.painted()
            seen.append((words.highlighted, words.scroll_offset.y))
        assert seen == [(3, 3), (6, 6), (3, 3)]
        await screen.press("enter")
        await screen.until(lambda: screen.main.editor.text == "BW", "the fourth word")


async def test_a_click_next_to_the_words_to_complete_closes_them(open_screen) -> None:  # type: ignore[no-untyped-def]
    async with open_screen("FW 1") as screen:
        await screen.press("ctrl+@")
        await screen.until(lambda: screen.app.screen is not screen.main, "the words")
        await screen.painted()
        await screen.pilot.click(offset=(60, 3))
        await screen.until(lambda: screen.app.screen is screen.main, "the main screen")
        assert screen.main.editor.text == "FW 1"
