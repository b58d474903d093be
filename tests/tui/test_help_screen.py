"""The help, the manual after it, and the lists to read and choose from."""

import pytest
from textual.geometry import Offset

from donnie_tui.commands.declarations import COMMANDS
from donnie_tui.commands.help import first_words
from donnie_tui.commands.lookup import word_of
from donnie_tui.i18n.words import Words
from tests.tui.test_looking import caret


async def test_help_all_shows_every_key_and_word_and_esc_goes_back(open_screen):
    async with open_screen() as screen:
        await screen.type_line("HELP ALL")
        await screen.until(lambda: screen.app.screen is not screen.main, "the help")
        rows = screen.app.screen.rows
        printed = "\n".join(rows.lines)
        assert all(word_of(each, "en") in printed for each in COMMANDS)
        assert "FW" in printed
        await screen.press("escape")
        await screen.until(lambda: screen.app.screen is screen.main, "the main screen")


@pytest.mark.parametrize(
    ("language", "everything"), [("en", "HELP ALL"), ("pt", "AJUDA TUDO"), ("es", "AYUDA TODO")]
)
async def test_f1_shows_the_words_of_the_first_lesson_and_names_the_word_for_all(
    open_screen, language, everything
):
    async with open_screen(language=language) as screen:
        await screen.press("f1")
        await screen.until(lambda: screen.app.screen is not screen.main, "the help")
        lines = screen.app.screen.rows.lines

        assert everything in lines[-1]
        assert tuple(lines[-13:]) == first_words(Words(language))


async def test_f1_reads_from_its_first_line_and_esc_goes_back(open_screen):
    async with open_screen() as screen:
        await screen.press("f1")
        await screen.until(lambda: screen.app.screen is not screen.main, "the help")
        rows = screen.app.screen.rows
        assert caret(screen) == rows.content_region.offset
        await screen.press("down", "down")
        assert caret(screen) == rows.content_region.offset + Offset(0, 2)
        await screen.press("escape")
        await screen.until(lambda: screen.app.screen is screen.main, "the main screen")

        assert screen.main.editor.has_focus


MANUALS = {"en": "the manual", "pt": "o manual", "es": "el manual"}


@pytest.mark.parametrize("language", MANUALS)
async def test_f1_in_the_help_opens_the_manual(open_screen, language):
    async with open_screen(language=language) as screen:
        await screen.press("f1")
        await screen.until(lambda: screen.app.screen is not screen.main, "the help")
        help_screen, title = screen.app.screen, MANUALS[language]
        assert any(line.startswith("F1 ") and title in line for line in help_screen.rows.lines)
        await screen.press("f1")
        await screen.until(lambda: screen.app.screen not in (screen.main, help_screen), "the manual")
        assert title in screen.app.screen._title_words
        await screen.press("escape")
        await screen.until(lambda: screen.app.screen is help_screen, "the help again")
        await screen.press("escape")
        await screen.until(lambda: screen.app.screen is screen.main, "the main screen")


async def test_help_with_a_word_of_the_screen_prints_its_purpose(open_screen):
    async with open_screen() as screen:
        await screen.type_line("HELP stop")

        await screen.shows("Stops the program and Donnie.")


async def test_help_with_a_command_of_godonnie_is_godonnie_s(open_screen):
    async with open_screen() as screen:
        await screen.type_line("HELP FW")

        await screen.until(lambda: any("FW" in line for line in screen.log[3:]), "the help")


async def test_help_with_a_topic_prints_its_words_in_the_log(open_screen):
    async with open_screen() as screen:
        await screen.type_line("HELP MOVING")

        await screen.shows("12 words for moving:")


async def test_the_palette_does_what_is_chosen(open_screen):
    async with open_screen('SPEAK "chosen"') as screen:
        await screen.press("ctrl+p")
        await screen.until(lambda: screen.app.screen is not screen.main, "the palette")
        await screen.press(*"runs the", "enter")
        await screen.shows("chosen")


async def test_the_cursor_stands_on_the_row_that_enter_would_choose(open_screen):
    async with open_screen() as screen:
        await screen.press("ctrl+p")
        await screen.until(lambda: screen.app.screen is not screen.main, "the palette")
        await screen.press("down", "down")
        await screen.pilot.pause()
        x, y = screen.app.cursor_position
        rows = screen.app.screen.rows.region
        lines = screen.text.splitlines()

        assert [at for at in range(rows.y, rows.bottom) if lines[at][x : x + 1] == ">"] == [y]
        assert y == rows.y + 2


async def test_f1_in_the_program_lists_all_its_mistakes_whole(open_screen):
    """Next to a long line there is no room for the sentence."""
    async with open_screen('FWD 3\nSPEAK "' + "a long text " * 5 + '" FWD 2\nTR 90\nBWD 4') as screen:
        await screen.until(lambda: len(screen.main.editor.mistakes) == 3, "the marks")
        await screen.press("f1")
        await screen.until(lambda: screen.app.screen is not screen.main, "the help")
        lines = screen.app.screen.rows.lines[:3]

        assert [each.partition(":")[0] for each in lines] == ["Line 1", "Line 2", "Line 4"]
        assert all("FWD" in each or "BWD" in each for each in lines)


@pytest.mark.parametrize("language", ["en", "pt", "es"])
async def test_on_a_small_screen_the_palette_has_a_row_each_and_the_rest_is_below(open_screen, language):
    async with open_screen(size=(40, 12), language=language) as screen:
        await screen.press("ctrl+p")
        await screen.until(lambda: screen.app.screen is not screen.main, "the palette")
        await screen.painted()
        panel = screen.app.screen
        chosen = panel._fitting[0]
        word, purpose, key = chosen.columns
        rows = [line.strip(" >") for line in screen.text.splitlines()]

        assert rows[1] == word
        assert rows[2:6] == [each.columns[0] for each in panel._fitting[1:5]]
        below = " ".join(panel._detail.lines)
        assert purpose in below and key in below
        await screen.press("down")
        await screen.painted()
        assert panel._fitting[1].columns[1] in " ".join(panel._detail.lines)
