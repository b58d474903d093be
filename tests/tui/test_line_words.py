"""The editor, the cursor and the log follow what is typed in the command line."""

import pytest

from donnie_tui.core.run_state import RunState

PROGRAM = "FW 1\nFW 2\nFW 3\nFW 4"


@pytest.fixture(autouse=True)
def own_folders(tmp_path, monkeypatch):
    """Settings and files of a test stay its own."""
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path / "config"))
    monkeypatch.chdir(tmp_path)


async def test_the_editor_follows_the_words_and_undo_takes_each_back(work):
    async with work(PROGRAM) as desk:
        for typed, text in (
            ("CHANGE 2 BK 2", "FW 1\nBK 2\nFW 3\nFW 4"),
            ("INSERT 5 TR 90", "FW 1\nFW 2\nFW 3\nFW 4\nTR 90"),
            ("DELETE 2 3", "FW 1\nFW 4"),
            ("DELETE 1 4", ""),
            ("MOVE 1 2 5", "FW 3\nFW 4\nFW 1\nFW 2"),
        ):
            await desk.type_line(typed)
            await desk.until(lambda text=text: desk.place.editor.text == text, typed)
            await desk.type_line("UNDO")
            await desk.until(lambda: desk.place.editor.text == PROGRAM, "the text as it was")


async def test_delete_alone_deletes_the_line_of_the_cursor_and_undo_prints_it(work):
    async with work(PROGRAM) as desk:
        desk.place.editor.go_to(2)
        await desk.type_line("DELETE")
        await desk.shows("Line 2 deleted.")
        assert desk.place.editor.text == "FW 1\nFW 3\nFW 4"

        await desk.type_line("UNDO")
        await desk.shows("Line 2: FW 2")
        assert desk.place.editor.text == PROGRAM


async def test_an_end_of_line_behind_the_last_line_stays(work):
    async with work() as desk:
        desk.load("FW 1\nFW 2\n")
        await desk.type_line("DELETE 2")
        await desk.shows("Line 2 deleted.")
        assert desk.place.editor.text == "FW 1\n"

        await desk.type_line("INSERT 2 BK 1")
        await desk.shows("Line 2: BK 1")
        assert desk.place.editor.text == "FW 1\nBK 1\n"


async def test_breakpoints_go_with_their_lines_when_lines_are_inserted_deleted_and_that_is_undone(work):
    async with work(PROGRAM) as desk:
        await desk.type_line("BREAK 3")
        await desk.shows("Breakpoint at line 3.")
        await desk.type_line("INSERT 1 TR 90")
        await desk.until(lambda: desk.place.editor.breakpoints == {4}, "line 4")
        await desk.type_line("DELETE 2")
        await desk.until(lambda: desk.place.editor.breakpoints == {3}, "line 3")
        await desk.type_line("UNDO")
        await desk.until(lambda: desk.place.editor.breakpoints == {4}, "line 4 again")
        await desk.type_line("INSERT 4 TR 90")
        await desk.until(lambda: desk.place.editor.breakpoints == {5}, "line 5")
        await desk.type_line("DELETE 4")
        await desk.until(lambda: desk.place.editor.breakpoints == {4}, "line 4, the line above being gone")


async def test_a_typed_line_is_chosen_and_repeated(work):
    async with work() as desk:
        await desk.type_line("FW 1")
        await desk.idle()
        await desk.type_line("WHERE")
        await desk.press("ctrl+k", "Y")
        await desk.until(lambda: desk.app.screen is not desk.place, "the list")
        assert desk.app.screen.rows.lines == ("WHERE", "FW 1")
        await desk.press("down", "enter")
        await desk.until(lambda: desk.log.count("I walked 1 step forward.") == 2, "the second step")
        await desk.doing(RunState.READY)


async def test_mistakes_are_visited_and_explained_as_in_the_linear_mode(work):
    """After each run the cursor stands at the first one, whichever one was selected before."""
    async with work("FWD 1\nTRN 90") as desk:

        async def run():
            await desk.press("f5")
            await desk.until(lambda: desk.place.editor.line == 1 and desk.app.controller.ctx.errors.all)
            await desk.idle()

        await run()
        await desk.type_line("ERROR NEXT")
        await desk.until(lambda: desk.place.editor.line == 2, "the second mistake")
        await desk.type_line("ERROR NEXT")
        await desk.shows("No more errors. That is 2 of 2.")
        await desk.type_line("EXPLAIN")
        await desk.until(lambda: desk.log[-1] == "Line 2: TRN 90", "the line of the mistake")

        await run()
        before = len(desk.log)
        await desk.type_line("ERROR")
        await desk.until(lambda: any("Error, line 1" in line for line in desk.log[before:]), "the first one")
        assert desk.place.editor.line == 1


async def test_last_says_the_whole_answer_again_and_the_one_before_it(work):
    async with work() as desk:
        await desk.type_line("SPELL 9")
        await desk.shows("Nothing was said yet.")
        await desk.type_line("FW 1 SPEAK 7")
        await desk.shows("7")
        await desk.idle()
        await desk.type_line("BREAK 99")
        await desk.shows("No lines yet.")

        for _ in range(2):
            before = len(desk.log)
            await desk.type_line("LAST 2")
            await desk.until(
                lambda before=before: desk.log[before + 1 :] == ("I walked 1 step forward.", "7"),
                "both lines",
            )
        await desk.type_line("LAST WORD")
        await desk.shows("y, e, t.")
