"""The help, the manual after it, and the lists to read and choose from."""

import pytest
from textual.geometry import Offset

from donnie_tui.commands.declarations import COMMANDS
from donnie_tui.commands.lookup import word_of
from tests.tui.test_looking import caret


async def test_f1_shows_every_key_and_word_and_esc_goes_back(work):
    async with work() as desk:
        await desk.press("f1")
        await desk.until(lambda: desk.app.screen is not desk.place, "the help")
        rows = desk.app.screen.rows
        printed = "\n".join(rows.lines)
        assert all(word_of(each, "en") in printed for each in COMMANDS)
        assert "FW" in printed
        assert caret(desk) == rows.content_region.offset
        await desk.press("down", "down")
        assert caret(desk) == rows.content_region.offset + Offset(0, 2)
        await desk.press("escape")
        await desk.until(lambda: desk.app.screen is desk.place, "the main screen")

        assert desk.place.editor.has_focus


MANUALS = {"en": "the manual", "pt": "o manual", "es": "el manual"}


@pytest.mark.parametrize("language", MANUALS)
async def test_f1_in_the_help_opens_the_manual(work, language):
    async with work(language=language) as desk:
        await desk.press("f1")
        await desk.until(lambda: desk.app.screen is not desk.place, "the help")
        help_screen, title = desk.app.screen, MANUALS[language]
        assert any(line.startswith("F1 ") and title in line for line in help_screen.rows.lines)
        await desk.press("f1")
        await desk.until(lambda: desk.app.screen not in (desk.place, help_screen), "the manual")
        assert title in desk.app.screen._title_words
        await desk.press("escape")
        await desk.until(lambda: desk.app.screen is help_screen, "the help again")
        await desk.press("escape")
        await desk.until(lambda: desk.app.screen is desk.place, "the main screen")


async def test_help_with_a_word_of_the_screen_prints_its_purpose(work):
    async with work() as desk:
        await desk.type_line("HELP stop")

        await desk.shows("Stops the program and Donnie.")


async def test_help_with_a_command_of_godonnie_is_godonnie_s(work):
    async with work() as desk:
        await desk.type_line("HELP FW")

        await desk.until(lambda: any("FW" in line for line in desk.log[3:]), "the help")


async def test_the_palette_does_what_is_chosen(work):
    async with work('SPEAK "chosen"') as desk:
        await desk.press("ctrl+p")
        await desk.until(lambda: desk.app.screen is not desk.place, "the palette")
        await desk.press(*"runs the", "enter")
        await desk.shows("chosen")


async def test_the_cursor_stands_on_the_row_that_enter_would_choose(work):
    async with work() as desk:
        await desk.press("ctrl+p")
        await desk.until(lambda: desk.app.screen is not desk.place, "the palette")
        await desk.press("down", "down")
        await desk.pilot.pause()
        row = desk.screen.splitlines()[desk.app.cursor_position.y]

        assert row.startswith(">")
        assert [line for line in desk.screen.splitlines() if line.startswith(">")] == [row]
