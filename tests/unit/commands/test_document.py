"""The page about the commands is made from their declarations."""

from pathlib import Path

from donnie_tui.commands.declarations import COMMANDS
from donnie_tui.commands.document import FILE, document
from donnie_tui.commands.lookup import word_of

ROOT = Path(__file__).parents[3]


def test_the_page_is_what_the_declarations_say():
    """To write it anew: ``python -m donnie_tui.commands.document``."""
    assert (ROOT / FILE).read_text(encoding="utf-8") == document()


def test_the_page_has_every_command():
    page = document()

    assert [each.name for each in COMMANDS if f"- **{word_of(each, 'en')}** (" not in page] == []
