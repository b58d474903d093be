"""The text in the field of a question, and its fate."""

from __future__ import annotations

import pytest
from textual.widgets import Input


async def field(desk, proposed):  # type: ignore[no-untyped-def]
    await desk.until(lambda: desk.app.screen is not desk.place, "the question")
    await desk.pilot.pause()
    found = desk.app.screen.query_one(Input)
    assert found.value == proposed
    return found


async def test_the_first_key_replaces_the_proposed_answer(work) -> None:  # type: ignore[no-untyped-def]
    async with work() as desk:
        await desk.type_line("SAVE LOG")
        answer = await field(desk, "log.txt")
        await desk.press("m")
        assert answer.value == "m"
        await desk.press("y")
        assert answer.value == "my"


@pytest.mark.parametrize(("key", "changed"), [("end", "log.txtx"), ("home", "xlog.txt")])
async def test_moving_in_the_proposed_answer_edits_it(work, key, changed) -> None:  # type: ignore[no-untyped-def]
    async with work() as desk:
        await desk.type_line("SAVE LOG")
        answer = await field(desk, "log.txt")
        await desk.press(key, "x")

        assert answer.value == changed


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


@pytest.mark.parametrize("typed", ["SAVE", "SAVE AS", "NEW", "OPEN", "QUIT", "SAVE LOG"])
async def test_a_cancelled_question_reports_that_nothing_changed(work, typed) -> None:  # type: ignore[no-untyped-def]
    async with work("FW 1") as desk:
        await desk.type_line(typed)
        await desk.until(lambda: desk.app.screen is not desk.place, "the question")
        await desk.press("escape")
        await desk.shows("Nothing was changed.")
        await desk.type_line("WHERE")
        await desk.shows("Position 0, 0.")

        assert desk.place.editor.text == "FW 1"
        assert desk.log.count("Nothing was changed.") == 1


async def test_a_missing_name_for_saving_first_is_reported_once(work) -> None:  # type: ignore[no-untyped-def]
    async with work("FW 1") as desk:
        await desk.press("ctrl+n")
        await desk.answer("yes")
        await desk.until(lambda: "Which file name?" in desk.screen, "the question for the name")
        await desk.press("enter")
        await desk.shows("Nothing was changed.")
        await desk.type_line("WHERE")
        await desk.shows("Position 0, 0.")

        assert desk.place.editor.text == "FW 1"
        assert desk.log.count("Nothing was changed.") == 1
