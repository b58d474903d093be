"""What a page in a browser can't do is not offered there: the linear mode, and the pager of a terminal."""

import pytest

from donnie_tui.commands.declarations import COMMANDS
from donnie_tui.commands.keys import KeyTable
from donnie_tui.commands.preferences import Preferences
from donnie_tui.i18n.words import Words
from donnie_tui.settings.settings import Settings
from donnie_tui.tui.pane_text import help_text, palette
from language.locales import languages

NEED_A_TERMINAL = {"linear", "open_log"}


@pytest.fixture
def page(monkeypatch, open_screen):
    """A screen that takes itself for a page."""
    monkeypatch.setenv("TEXTUAL_DRIVER", "textual.drivers.web_driver:WebDriver")
    return open_screen


@pytest.mark.parametrize("language", languages())
def test_the_palette_and_the_help_leave_out_what_needs_a_terminal(language):
    words = Words(language)
    of_terminal, of_page = KeyTable(), KeyTable(has_terminal=False)
    offered, of_page_offered = (
        {each.value for each in palette(words, table, Preferences(Settings(), {}))}
        for table in (of_terminal, of_page)
    )
    missing = offered - of_page_offered

    assert missing == NEED_A_TERMINAL
    assert len(help_text(words, of_terminal)) - len(help_text(words, of_page)) == len(NEED_A_TERMINAL)


def test_no_key_means_what_needs_a_terminal():
    table = KeyTable("open_log f9", has_terminal=False)

    assert {each.name for each in COMMANDS} - set(table.all) == NEED_A_TERMINAL
    assert table.command_of("ctrl+k q") is None
    assert table.command_of("f9") is None


async def test_a_page_names_the_command_for_a_screen_reader(page):
    async with page() as screen:
        assert screen.log[0] == "Screen reader? In a terminal: donnie --linear"


@pytest.mark.parametrize("line", ["LINEAR", "SET PROMPT none"])
async def test_what_is_typed_for_the_linear_mode_is_answered_and_ends_nothing(page, line):
    async with page() as screen:
        await screen.type_line(line)
        await screen.shows("In a terminal only: donnie --linear")
        assert screen.app.is_running


async def test_the_list_of_keys_leaves_out_what_needs_a_terminal(page):
    async with page() as screen:
        await screen.type_line("CHANGE KEYS")
        await screen.until(lambda: screen.app.screen is not screen.main, "the list")
        await screen.painted()
        assert "OPEN LOG" not in screen.text
