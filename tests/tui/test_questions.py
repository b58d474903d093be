"""The text in the field of a question, and its fate."""

from __future__ import annotations

from textual.widgets import Input


async def field(screen, proposed):  # type: ignore[no-untyped-def]
    await screen.until(lambda: screen.app.screen is not screen.main, "the question")
    await screen.pilot.pause()
    found = screen.app.screen.query_one(Input)
    assert found.value == proposed
    return found


async def test_the_first_key_replaces_the_proposed_answer_and_moving_in_it_edits_it(open_screen) -> None:  # type: ignore[no-untyped-def]
    async with open_screen() as screen:
        for keys, changed in (("my", "my"), (("end", "x"), "log.txtx"), (("home", "x"), "xlog.txt")):
            await screen.type_line("SAVE LOG")
            answer = await field(screen, "log.txt")
            await screen.press(*keys)
            assert answer.value == changed
            await screen.press("escape")
            await screen.until(lambda: screen.app.screen is screen.main, "the main screen")


async def test_the_first_key_replaces_a_wrong_answer_too(open_screen) -> None:  # type: ignore[no-untyped-def]
    async with open_screen("FW 1") as screen:
        screen.load("FW 2")
        await screen.press("x", "ctrl+n")
        answer = await field(screen, "")
        await screen.press(*"maybe", "enter")
        await screen.pilot.pause()
        assert answer.value == "maybe"
        await screen.press("n")
        assert answer.value == "n"


async def test_enter_alone_leaves_a_question_as_it_says(open_screen) -> None:  # type: ignore[no-untyped-def]
    async with open_screen("FW 1") as screen:
        await screen.type_line("REPLACE FW")
        await screen.until(lambda: screen.app.screen is not screen.main, "the question")
        await screen.press("enter")
        await screen.shows("Nothing was changed.")

        assert screen.main.editor.text == "FW 1"
        assert screen.app.screen is screen.main


async def test_enter_alone_means_no_and_recover_restores_the_program(open_screen) -> None:  # type: ignore[no-untyped-def]
    async with open_screen("FW 1") as screen:
        await screen.press("ctrl+n")
        await screen.until(lambda: "Enter means no." in screen.text, "the question")
        await screen.press("enter")
        await screen.until(lambda: screen.main.editor.text == "", "the new program")

        await screen.type_line("RECOVER")
        await screen.until(lambda: screen.main.editor.text == "FW 1", "the program")


async def test_a_cancelled_question_reports_once_that_nothing_changed(open_screen) -> None:  # type: ignore[no-untyped-def]
    async with open_screen("FW 1") as screen:
        for count, typed in enumerate(("SAVE", "NEW", "QUIT"), 1):
            await screen.type_line(typed)
            await screen.until(lambda: screen.app.screen is not screen.main, "the question")
            await screen.press("escape")
            await screen.until(lambda n=count: screen.log.count("Nothing was changed.") == n, typed)
        await screen.type_line("WHERE")
        await screen.shows("Position 0, 0.")

        assert screen.main.editor.text == "FW 1"
        assert screen.log.count("Nothing was changed.") == 3
