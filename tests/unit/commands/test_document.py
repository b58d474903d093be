"""The page about the commands is made from their declarations."""

from pathlib import Path

from donnie_tui.commands.declarations import COMMANDS
from donnie_tui.commands.lookup import word_of
from tests.tools.commands_page import FILE, document

ROOT = Path(__file__).parents[3]


def test_the_page_is_what_the_declarations_say():
    """To write it anew: ``python -m tests.tools.commands_page``."""
    assert (ROOT / FILE).read_text(encoding="utf-8") == document()


def test_the_page_has_every_command():
    page = document()

    assert [each.name for each in COMMANDS if f"- **{word_of(each, 'en')}**" not in page] == []
