"""The page about the commands is made from their declarations."""

import re
from pathlib import Path

import pytest

from donnie_tui.commands.declarations import COMMANDS
from donnie_tui.commands.lookup import word_of
from language.keywords import ARGUMENTS, WORDS
from language.locales import languages
from tests.tools.commands_page import FILE, LANGUAGE_FILE, document, with_words, words_section

ROOT = Path(__file__).parents[3]


def test_the_page_is_what_the_declarations_say():
    """To write it anew: ``python -m tests.tools.commands_page``."""
    assert (ROOT / FILE).read_text(encoding="utf-8") == document()


def test_the_words_of_the_language_are_what_the_declarations_say():
    """To write them anew: ``python -m tests.tools.commands_page``."""
    page = (ROOT / LANGUAGE_FILE).read_text(encoding="utf-8")

    assert page == with_words(page)


@pytest.mark.parametrize("language", languages())
def test_the_page_about_the_language_has_every_keyword(language: str):
    section = words_section()
    keywords = {each.spellings[language][0] for each in (*WORDS, *ARGUMENTS)}

    assert {each for each in keywords if not re.search(rf"\b{each}\b", section)} == set()


def test_the_page_has_every_command():
    page = document()

    assert [each.name for each in COMMANDS if f"- **{word_of(each, 'en')}**" not in page] == []
