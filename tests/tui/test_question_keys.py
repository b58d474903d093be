"""Keys that arrive with the key of a question, or right after it, belong to the question."""

from __future__ import annotations

import asyncio
import gc
import warnings

import pytest
from textual import events

from donnie_tui.tui import keyboard
from tests.tui.conftest import burst

pytestmark = pytest.mark.slow

LINES = "FW 1\nTR 90\nBW 2"


async def until_answered(screen) -> None:  # type: ignore[no-untyped-def]
    await screen.until(lambda: screen.app.screen is screen.main and not screen.app.workers, "the end of it")
    await screen.pilot.pause()


@pytest.mark.parametrize("focus", ["editor", "map"])
async def test_a_name_that_comes_with_the_key_that_asks_for_it_is_the_answer(
    open_screen, tmp_path, focus
) -> None:  # type: ignore[no-untyped-def]
    async with open_screen(LINES) as screen:
        getattr(screen.main, focus).focus()
        await screen.pilot.pause()
        burst(screen, "ctrl+s", *"lesson", "enter")
        await screen.shows("Saved lesson.gd")

        assert screen.main.editor.text == LINES
    assert (tmp_path / "lesson.gd").read_text(encoding="utf-8").splitlines() == LINES.splitlines()


async def test_a_question_answered_at_once_leaves_no_search_for_names_unawaited(open_screen) -> None:  # type: ignore[no-untyped-def]
    with warnings.catch_warnings(record=True) as warned:
        warnings.simplefilter("always")
        async with open_screen(LINES) as screen:
            burst(screen, "ctrl+s", *"lesson", "enter")
            await screen.shows("Saved lesson.gd")
        gc.collect()

    assert not [str(each.message) for each in warned if "never awaited" in str(each.message)]


async def test_what_comes_behind_an_answer_in_the_same_burst_goes_where_it_leads(open_screen) -> None:  # type: ignore[no-untyped-def]
    async with open_screen(LINES) as screen:
        burst(screen, "ctrl+g", "3", "enter", *"12", "ctrl+g", "1", "enter", *"FW")
        await screen.until(lambda: screen.main.editor.text == "FWFW 1\nTR 90\n12BW 2", "all in its place")


async def test_a_word_that_comes_with_the_key_of_search_is_searched(open_screen) -> None:  # type: ignore[no-untyped-def]
    async with open_screen(LINES) as screen:
        burst(screen, "ctrl+f", *"BW", "enter")
        await screen.until(lambda: screen.main.editor.line == 3, "the line that was found")

        assert screen.main.editor.text == LINES


async def test_no_with_the_key_that_leaves_leaves_and_is_not_saved(open_screen, tmp_path) -> None:  # type: ignore[no-untyped-def]
    async with open_screen() as screen:
        burst(screen, *"FW", "ctrl+q", *"no", "enter")
        await screen.until(lambda: screen.app.return_code is not None, "the way out")

        assert screen.main.editor.text == "FW"


async def test_letters_that_come_with_the_key_of_a_list_narrow_it(open_screen) -> None:  # type: ignore[no-untyped-def]
    async with open_screen(LINES) as screen:
        burst(screen, "ctrl+p", *"coordinates", "enter", "X")
        await until_answered(screen)
        await screen.until(lambda: screen.main.editor.text == f"X{LINES}", "the letter behind it")


async def test_a_question_typed_as_a_word_has_the_line_behind_it(open_screen, tmp_path) -> None:  # type: ignore[no-untyped-def]
    async with open_screen(LINES) as screen:
        screen.main.command_line.focus()
        await screen.pilot.pause()
        burst(screen, *"SAVE", "space", *"AS", "enter", *"mine", "enter", *"WHERE", "enter")
        await screen.shows("Position 0, 0")

        assert [line for line in screen.log if line[0] == ">" or "Saved" in line] == [
            "> SAVE AS",
            "Saved mine.gd, 3 lines.",
            "> WHERE",
        ]


async def test_letters_in_front_of_a_page_that_comes_are_not_for_the_program(open_screen) -> None:  # type: ignore[no-untyped-def]
    async with open_screen(LINES) as screen:
        burst(screen, "f1", "q", "1")
        await screen.until(
            lambda: screen.app.screen is screen.main and screen.main.editor.text == f"1{LINES}"
        )


async def test_keys_do_not_wait_for_what_takes_long_without_asking(open_screen, monkeypatch) -> None:  # type: ignore[no-untyped-def]
    """As looking for a robot does: the text is there to be typed in meanwhile."""
    monkeypatch.setattr(keyboard, "SLOW", 0.01)
    async with open_screen() as screen:
        monkeypatch.setattr(screen.app.controller, "do", lambda _name, _argument: asyncio.Event().wait())
        burst(screen, "ctrl+n", *"FW")
        await screen.until(lambda: screen.main.editor.text == "FW", "the letters")


@pytest.mark.parametrize(("language", "printed"), [("en", "RUN"), ("pt", "EXECUTAR"), ("es", "EJECUTAR")])
async def test_esc_after_a_question_that_closed_itself_moves_no_robot(open_screen, language, printed) -> None:  # type: ignore[no-untyped-def]
    async with open_screen("FW 1", language=language) as screen:
        await screen.press("ctrl+g")
        await screen.answer("99")
        await screen.until(lambda: any("99" in line for line in screen.log), "no such line")
        await until_answered(screen)
        await screen.press("escape")
        await screen.until(lambda: screen.log[-1].endswith(f": {printed}."), "what Esc does")
        assert screen.app.controller.donnie.session.pose.y == 0
        await screen.press("escape")
        await screen.until(lambda: screen.app.controller.donnie.session.pose.y == 1, "the run")


async def test_a_second_esc_in_one_burst_moves_no_robot(open_screen) -> None:  # type: ignore[no-untyped-def]
    async with open_screen("FW 1") as screen:
        burst(screen, "ctrl+g", "escape", "escape", "X")
        await screen.shows("Esc again: RUN.")
        await screen.until(lambda: screen.main.editor.text == "XFW 1", "the letter")

        assert screen.app.controller.donnie.session.pose.y == 0


@pytest.mark.parametrize("keys", [("f1",), ("ctrl+k",), ("ctrl+k", "l"), ("ctrl+p",)])
async def test_esc_pressed_twice_leaves_a_page_and_moves_no_robot(open_screen, keys) -> None:  # type: ignore[no-untyped-def]
    async with open_screen("FW 1") as screen:
        await screen.press(*keys)
        await screen.until(lambda: screen.app.screen is not screen.main, "the page")
        await screen.press("escape", "escape")
        await screen.shows("Esc again: RUN.")

        assert screen.app.controller.donnie.session.pose.y == 0


async def test_esc_drives_a_real_robot_only_when_it_is_pressed_again(open_screen, monkeypatch) -> None:  # type: ignore[no-untyped-def]
    async with open_screen("FW 1") as screen:
        controller = screen.app.controller
        monkeypatch.setattr(type(controller.donnie.connection), "is_real", property(lambda _: True))
        done: list[str] = []
        monkeypatch.setattr(controller, "do", lambda name, _argument=None: done.append(name))
        await screen.press("escape")
        await screen.shows("Esc again: RUN.")
        assert done == []
        await screen.press("left", "escape")
        await screen.pilot.pause()
        assert done == []
        await screen.press("escape")
        await screen.until(lambda: done == ["run"], "the run")


async def test_esc_after_any_other_key_runs_the_program(open_screen) -> None:  # type: ignore[no-untyped-def]
    async with open_screen("FW 1") as screen:
        burst(screen, "ctrl+g", "1", "enter", "end", "escape")
        await screen.until(lambda: screen.app.controller.donnie.session.pose.y == 1, "the run")

        assert not any("Esc again: RUN." in line for line in screen.log)


@pytest.mark.parametrize("key", ["f9", "ñ", "f8", "tab", "ctrl+q"])
async def test_a_meaningless_key_after_the_menu_key_closes_the_list_and_is_reported(open_screen, key) -> None:  # type: ignore[no-untyped-def]
    async with open_screen("FW 1") as screen:
        burst(screen, "ctrl+k", key, "m", "a")
        await screen.shows("does nothing.")
        await screen.until(lambda: screen.main.editor.text == "maFW 1", "what was typed behind it")

        assert screen.app.screen is screen.main


async def test_the_keys_behind_the_menu_key_can_be_read_before_one_is_pressed(open_screen) -> None:  # type: ignore[no-untyped-def]
    async with open_screen("FW 1") as screen:
        await screen.press("ctrl+k")
        await screen.until(lambda: screen.app.screen is not screen.main, "the list")
        await screen.press("down", "pagedown", "up", "end", "home")

        assert screen.app.screen is not screen.main
        assert not any("does nothing" in line for line in screen.log)


async def test_letters_behind_the_first_focus_of_a_page_are_written(open_screen):
    """A page of a browser begins without the focus; the click that gives it comes with what is typed."""
    async with open_screen() as screen:
        screen.main.set_focus(None)
        screen.app.app_focus = False
        await screen.pilot.pause()
        screen.app._last_focused_on_app_blur = None
        screen.app.post_message(events.AppFocus())
        burst(screen, *"fwq")
        await screen.until(lambda: screen.main.editor.text == "fwq", "the letters")


async def test_a_question_closes_when_the_program_quits(open_screen):
    """A program that was running says QUIT, and what is not saved is asked about."""
    async with open_screen("FW 1") as screen:
        await screen.type_line("SAVE AS")
        await screen.until(lambda: screen.app.screen is not screen.main, "the name is asked")
        name = screen.app.screen
        screen.app.do("quit")
        await screen.until(lambda: screen.app.screen not in (name, screen.main), "whether to save is asked")
        assert screen.app.screen_stack == [screen.main, screen.app.screen]

        await screen.press("escape")
        await screen.until(lambda: screen.app.screen is screen.main, "no question is left")
