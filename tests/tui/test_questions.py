"""The text in the field of a question, and its fate."""

from __future__ import annotations

from textual.widgets import Input


async def field(desk, proposed):  # type: ignore[no-untyped-def]
    await desk.until(lambda: desk.app.screen is not desk.place, "the question")
    await desk.pilot.pause()
    found = desk.app.screen.query_one(Input)
    assert found.value == proposed
    return found


async def test_the_first_key_replaces_the_proposed_answer_and_moving_in_it_edits_it(work) -> None:  # type: ignore[no-untyped-def]
    async with work() as desk:
        for keys, changed in (("my", "my"), (("end", "x"), "log.txtx"), (("home", "x"), "xlog.txt")):
            await desk.type_line("SAVE LOG")
            answer = await field(desk, "log.txt")
            await desk.press(*keys)
            assert answer.value == changed
            await desk.press("escape")
            await desk.until(lambda: desk.app.screen is desk.place, "the main screen")


async def test_the_first_key_replaces_a_wrong_answer_too(work) -> None:  # type: ignore[no-untyped-def]
    async with work("FW 1") as desk:
        desk.load("FW 2")
        await desk.press("x", "ctrl+n")
        answer = await field(desk, "")
        await desk.press(*"maybe", "enter")
        await desk.pilot.pause()
        assert answer.value == "maybe"
        await desk.press("n")
        assert answer.value == "n"


async def test_enter_alone_leaves_a_question_as_it_says(work) -> None:  # type: ignore[no-untyped-def]
    async with work("FW 1") as desk:
        await desk.type_line("REPLACE FW")
        await desk.until(lambda: desk.app.screen is not desk.place, "the question")
        await desk.press("enter")
        await desk.shows("Nothing was changed.")

        assert desk.place.editor.text == "FW 1"
        assert desk.app.screen is desk.place


async def test_enter_alone_means_no_and_recover_restores_the_program(work) -> None:  # type: ignore[no-untyped-def]
    async with work("FW 1") as desk:
        await desk.press("ctrl+n")
        await desk.until(lambda: "Enter means no." in desk.screen, "the question")
        await desk.press("enter")
        await desk.until(lambda: desk.place.editor.text == "", "the new program")

        await desk.type_line("RECOVER")
        await desk.until(lambda: desk.place.editor.text == "FW 1", "the program")


async def test_a_cancelled_question_reports_once_that_nothing_changed(work) -> None:  # type: ignore[no-untyped-def]
    async with work("FW 1") as desk:
        for count, typed in enumerate(("SAVE", "NEW", "QUIT"), 1):
            await desk.type_line(typed)
            await desk.until(lambda: desk.app.screen is not desk.place, "the question")
            await desk.press("escape")
            await desk.until(lambda n=count: desk.log.count("Nothing was changed.") == n, typed)
        await desk.type_line("WHERE")
        await desk.shows("Position 0, 0.")

        assert desk.place.editor.text == "FW 1"
        assert desk.log.count("Nothing was changed.") == 3
