"""The editor, the cursor and the log follow what is typed in the command line."""

from donnie_tui.core.run_state import RunState

PROGRAM = "FW 1\nFW 2\nFW 3\nFW 4"


async def test_the_editor_follows_the_words_and_undo_takes_each_back(open_screen):
    async with open_screen(PROGRAM) as screen:
        for typed, text in (
            ("CHANGE 2 BK 2", "FW 1\nBK 2\nFW 3\nFW 4"),
            ("INSERT 5 TR 90", "FW 1\nFW 2\nFW 3\nFW 4\nTR 90"),
            ("DELETE 2 3", "FW 1\nFW 4"),
            ("DELETE 1 4", ""),
            ("MOVE 1 2 5", "FW 3\nFW 4\nFW 1\nFW 2"),
        ):
            await screen.type_line(typed)
            await screen.until(lambda text=text: screen.main.editor.text == text, typed)
            await screen.type_line("UNDO")
            await screen.until(lambda: screen.main.editor.text == PROGRAM, "the text as it was")


async def test_delete_alone_deletes_the_line_of_the_cursor_and_undo_prints_it(open_screen):
    async with open_screen(PROGRAM) as screen:
        screen.main.editor.go_to(2)
        await screen.type_line("DELETE")
        await screen.shows("Line 2 is deleted.")
        assert screen.main.editor.text == "FW 1\nFW 3\nFW 4"

        await screen.type_line("UNDO")
        await screen.shows("Line 2: FW 2")
        assert screen.main.editor.text == PROGRAM


async def test_an_end_of_line_behind_the_last_line_stays(open_screen):
    async with open_screen() as screen:
        screen.load("FW 1\nFW 2\n")
        await screen.type_line("DELETE 2")
        await screen.shows("Line 2 is deleted.")
        assert screen.main.editor.text == "FW 1\n"

        await screen.type_line("INSERT 2 BK 1")
        await screen.shows("Line 2: BK 1")
        assert screen.main.editor.text == "FW 1\nBK 1\n"


async def test_breakpoints_go_with_their_lines_when_lines_are_inserted_deleted_and_that_is_undone(
    open_screen,
):
    async with open_screen(PROGRAM) as screen:
        await screen.type_line("BREAK 3")
        await screen.shows("Breakpoint at line 3.")
        await screen.type_line("INSERT 1 TR 90")
        await screen.until(lambda: screen.main.editor.breakpoints == {4}, "line 4")
        await screen.type_line("DELETE 2")
        await screen.until(lambda: screen.main.editor.breakpoints == {3}, "line 3")
        await screen.type_line("UNDO")
        await screen.until(lambda: screen.main.editor.breakpoints == {4}, "line 4 again")
        await screen.type_line("INSERT 4 TR 90")
        await screen.until(lambda: screen.main.editor.breakpoints == {5}, "line 5")
        await screen.type_line("DELETE 4")
        await screen.until(lambda: screen.main.editor.breakpoints == {4}, "line 4, the line above being gone")


async def test_a_typed_line_is_chosen_and_repeated(open_screen):
    async with open_screen() as screen:
        await screen.type_line("FW 1")
        await screen.idle()
        await screen.type_line("WHERE")
        await screen.press("ctrl+k", "Y")
        await screen.until(lambda: screen.app.screen is not screen.main, "the list")
        assert screen.app.screen.rows.lines == ("WHERE", "FW 1")
        await screen.press("down", "enter")
        await screen.until(lambda: screen.log.count("I walked 1 step forward.") == 2, "the second step")
        await screen.reaches(RunState.READY)


async def test_mistakes_are_visited_and_explained_as_in_the_linear_mode(open_screen):
    """After each run the cursor stands at the first one, whichever one was selected before."""
    async with open_screen("FWD 1\nTRN 90") as screen:

        async def run():
            await screen.press("f5")
            await screen.until(lambda: screen.main.editor.line == 1 and screen.app.controller.ctx.errors.all)
            await screen.idle()

        await run()
        await screen.type_line("ERROR NEXT")
        await screen.until(lambda: screen.main.editor.line == 2, "the second mistake")
        await screen.type_line("ERROR NEXT")
        await screen.shows("No more errors. That is 2 of 2.")
        await screen.type_line("EXPLAIN")
        await screen.until(lambda: screen.log[-1] == "Line 2: TRN 90", "the line of the mistake")

        await run()
        before = len(screen.log)
        await screen.type_line("ERROR")
        await screen.until(
            lambda: any("Error, line 1" in line for line in screen.log[before:]), "the first one"
        )
        assert screen.main.editor.line == 1


async def test_last_says_the_whole_answer_again_and_the_one_before_it(open_screen):
    async with open_screen() as screen:
        await screen.type_line("SPELL 9")
        await screen.shows("Nothing has been said yet.")
        await screen.type_line("FW 1 SPEAK 7")
        await screen.shows("7")
        await screen.idle()
        await screen.type_line("BREAK 99")
        await screen.shows("There are no lines yet.")

        for _ in range(2):
            before = len(screen.log)
            await screen.type_line("LAST 2")
            await screen.until(
                lambda before=before: screen.log[before + 1 :] == ("I walked 1 step forward.", "7"),
                "both lines",
            )
        await screen.type_line("LAST WORD")
        await screen.shows("y, e, t.")


async def test_an_empty_program_says_how_to_begin_until_something_is_typed(open_screen):
    async with open_screen(size=(40, 12)) as screen:
        await screen.painted()
        first = screen.text.splitlines()
        assert first[0] == ">F5 runs. F1 helps. LINEAR: text only"
        assert first[2] == "     For example: FW 3 TR 90 FW 2"

        await screen.press("f")
        await screen.until(lambda: "new program" in screen.text, "the title")
        assert "For example" not in screen.text
        await screen.press("backspace")
        await screen.until(lambda: "For example" in screen.text, "how to begin")


async def test_the_plain_layout_shows_nothing_in_an_empty_program(open_screen):
    async with open_screen(plain=True) as screen:
        await screen.painted()
        assert "For example" not in screen.text


async def test_an_example_is_opened_from_the_empty_program_by_its_word(open_screen):
    async with open_screen() as screen:
        await screen.press(*"examples", "enter")
        await screen.until(lambda: screen.app.screen is not screen.main, "the list")
        await screen.press("down", "enter")
        await screen.shows("Opened Up to the wall, 4 lines.")
        assert screen.main.editor.text.startswith("WHILE DISTANCE F > 3 DO")


WRONG = "FW 1\nFWD 3\nREPEAT 2 TIMES\nFW 1\nEND REPEET\nSPEAK a"


async def test_all_mistakes_are_a_list_to_go_to_one_before_anything_runs(open_screen):
    async with open_screen(WRONG) as screen:
        await screen.type_line("ERRORS")
        await screen.until(lambda: screen.app.screen is not screen.main, "the list")
        rows = screen.app.screen.rows.lines
        assert [row.split(":")[0] for row in rows] == ["Line 2, FWD 3", "Line 5, END REPEET"]

        await screen.press("down", "enter")
        await screen.until(lambda: screen.app.screen is screen.main, "the program")
        await screen.until(lambda: screen.main.editor.line == 5, "line 5")
        assert screen.app.focused is screen.main.editor


async def test_what_went_wrong_in_a_run_is_in_the_list_too(open_screen):
    async with open_screen("VAR a = 0\nSPEAK 1 / a") as screen:
        await screen.press("f5")
        await screen.shows("Error, line 2")
        await screen.idle()
        await screen.type_line("ERRORS")
        await screen.until(lambda: screen.app.screen is not screen.main, "the list")
        (row,) = screen.app.screen.rows.lines
        assert row.startswith("Error, line 2")
        await screen.press("enter")
        await screen.until(lambda: screen.main.editor.line == 2, "line 2")


async def test_the_plain_layout_says_the_mistakes_and_opens_no_list(open_screen):
    async with open_screen("FWD 3", plain=True) as screen:
        await screen.type_line("ERRORS")
        await screen.shows("Line 1, FWD 3:")
        assert screen.app.screen is screen.main
