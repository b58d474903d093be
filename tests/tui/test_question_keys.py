"""Keys that arrive with the key of a question, or right after it, belong to the question."""

from __future__ import annotations

import asyncio

import pytest
from textual import events

from donnie_tui.tui import key_queue
from tests.tui.conftest import burst

LINES = "FW 1\nTR 90\nBW 2"


@pytest.fixture(autouse=True)
def own_folder(tmp_path, monkeypatch) -> None:  # type: ignore[no-untyped-def]
    monkeypatch.chdir(tmp_path)


async def until_answered(desk) -> None:  # type: ignore[no-untyped-def]
    await desk.until(lambda: desk.app.screen is desk.place and not desk.app.workers, "the end of it")
    await desk.pilot.pause()


@pytest.mark.parametrize("focus", ["editor", "map"])
async def test_a_name_that_comes_with_the_key_that_asks_for_it_is_the_answer(work, tmp_path, focus) -> None:  # type: ignore[no-untyped-def]
    async with work(LINES) as desk:
        getattr(desk.place, focus).focus()
        await desk.pilot.pause()
        burst(desk, "ctrl+s", *"lesson", "enter")
        await desk.shows("Saved lesson.gd")

        assert desk.place.editor.text == LINES
    assert (tmp_path / "lesson.gd").read_text(encoding="utf-8").splitlines() == LINES.splitlines()


async def test_what_comes_behind_an_answer_in_the_same_burst_goes_where_it_leads(work) -> None:  # type: ignore[no-untyped-def]
    async with work(LINES) as desk:
        burst(desk, "ctrl+g", "3", "enter", *"12", "ctrl+g", "1", "enter", *"FW")
        await desk.until(lambda: desk.place.editor.text == "FWFW 1\nTR 90\n12BW 2", "all in its place")


async def test_a_word_that_comes_with_the_key_of_search_is_searched(work) -> None:  # type: ignore[no-untyped-def]
    async with work(LINES) as desk:
        burst(desk, "ctrl+f", *"BW", "enter")
        await desk.until(lambda: desk.place.editor.line == 3, "the line that was found")

        assert desk.place.editor.text == LINES


async def test_no_with_the_key_that_leaves_leaves_and_is_not_saved(work, tmp_path) -> None:  # type: ignore[no-untyped-def]
    async with work() as desk:
        burst(desk, *"FW", "ctrl+q", *"no", "enter")
        await desk.until(lambda: desk.app.return_code is not None, "the way out")

        assert desk.place.editor.text == "FW"


async def test_letters_that_come_with_the_key_of_a_list_narrow_it(work) -> None:  # type: ignore[no-untyped-def]
    async with work(LINES) as desk:
        burst(desk, "ctrl+p", *"coordinates", "enter", "X")
        await until_answered(desk)
        await desk.until(lambda: desk.place.editor.text == f"X{LINES}", "the letter behind it")


async def test_a_question_typed_as_a_word_has_the_line_behind_it(work, tmp_path) -> None:  # type: ignore[no-untyped-def]
    async with work(LINES) as desk:
        desk.place.command_line.focus()
        await desk.pilot.pause()
        burst(desk, *"SAVE", "space", *"AS", "enter", *"mine", "enter", *"WHERE", "enter")
        await desk.shows("Position 0, 0")

        assert [line for line in desk.log if line[0] == ">" or "Saved" in line] == [
            "> SAVE AS",
            "Saved mine.gd, 3 lines.",
            "> WHERE",
        ]


async def test_letters_in_front_of_a_page_that_comes_are_not_for_the_program(work) -> None:  # type: ignore[no-untyped-def]
    async with work(LINES) as desk:
        burst(desk, "f1", "q", "1")
        await desk.until(lambda: desk.app.screen is desk.place and desk.place.editor.text == f"1{LINES}")


async def test_keys_do_not_wait_for_what_takes_long_without_asking(work, monkeypatch) -> None:  # type: ignore[no-untyped-def]
    """As looking for a robot does: the text is there to be typed in meanwhile."""
    monkeypatch.setattr(key_queue, "SLOW", 0.01)
    async with work() as desk:
        monkeypatch.setattr(desk.app.controller, "do", lambda _name: asyncio.Event().wait())
        burst(desk, "ctrl+n", *"FW")
        await desk.until(lambda: desk.place.editor.text == "FW", "the letters")


@pytest.mark.parametrize(("language", "printed"), [("en", "RUN"), ("pt", "EXECUTAR"), ("es", "EJECUTAR")])
async def test_esc_after_a_question_that_closed_itself_moves_no_robot(work, language, printed) -> None:  # type: ignore[no-untyped-def]
    async with work("FW 1", language=language) as desk:
        await desk.press("ctrl+g")
        await desk.answer("99")
        await desk.until(lambda: any("99" in line for line in desk.log), "no such line")
        await until_answered(desk)
        await desk.press("escape")
        await desk.until(lambda: desk.log[-1].endswith(f": {printed}."), "what Esc does")
        assert desk.app.controller.donnie.session.pose.y == 0
        await desk.press("escape")
        await desk.until(lambda: desk.app.controller.donnie.session.pose.y == 1, "the run")


async def test_a_second_esc_in_one_burst_moves_no_robot(work) -> None:  # type: ignore[no-untyped-def]
    async with work("FW 1") as desk:
        burst(desk, "ctrl+g", "escape", "escape", "X")
        await desk.shows("Esc again: RUN.")
        await desk.until(lambda: desk.place.editor.text == "XFW 1", "the letter")

        assert desk.app.controller.donnie.session.pose.y == 0


async def test_esc_after_any_other_key_runs_the_program(work) -> None:  # type: ignore[no-untyped-def]
    async with work("FW 1") as desk:
        burst(desk, "ctrl+g", "1", "enter", "end", "escape")
        await desk.until(lambda: desk.app.controller.donnie.session.pose.y == 1, "the run")

        assert not any("Esc again: RUN." in line for line in desk.log)


@pytest.mark.parametrize("key", ["7", "ñ", "f8", "tab", "ctrl+q"])
async def test_a_meaningless_key_after_the_menu_key_closes_the_list_and_is_reported(work, key) -> None:  # type: ignore[no-untyped-def]
    async with work("FW 1") as desk:
        burst(desk, "ctrl+k", key, "m", "a")
        await desk.shows("does nothing.")
        await desk.until(lambda: desk.place.editor.text == "maFW 1", "what was typed behind it")

        assert desk.app.screen is desk.place


async def test_the_keys_behind_the_menu_key_can_be_read_before_one_is_pressed(work) -> None:  # type: ignore[no-untyped-def]
    async with work("FW 1") as desk:
        await desk.press("ctrl+k")
        await desk.until(lambda: desk.app.screen is not desk.place, "the list")
        await desk.press("down", "pagedown", "up", "end", "home")

        assert desk.app.screen is not desk.place
        assert not any("does nothing" in line for line in desk.log)


async def test_letters_behind_the_first_focus_of_a_page_are_written(work):
    """A page of a browser begins without the focus; the click that gives it comes with what is typed."""
    async with work() as desk:
        desk.place.set_focus(None)
        desk.app.app_focus = False
        await desk.pilot.pause()
        desk.app._last_focused_on_app_blur = None
        desk.app.post_message(events.AppFocus())
        burst(desk, *"fwq")
        await desk.until(lambda: desk.place.editor.text == "fwq", "the letters")


async def test_a_question_closes_when_the_program_quits(work):
    """A program that was running says QUIT, and what is not saved is asked about."""
    async with work("FW 1") as desk:
        await desk.type_line("SAVE AS")
        await desk.until(lambda: desk.app.screen is not desk.place, "the name is asked")
        name = desk.app.screen
        desk.app.do("quit")
        await desk.until(lambda: desk.app.screen not in (name, desk.place), "whether to save is asked")
        assert desk.app.screen_stack == [desk.place, desk.app.screen]

        await desk.press("escape")
        await desk.until(lambda: desk.app.screen is desk.place, "no question is left")
