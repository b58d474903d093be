"""Reports as files: a page with headings and tables for screen readers, and a spreadsheet."""

import csv
from html.parser import HTMLParser

from donnie_tui.core.reports import Section, as_csv, as_html

TABLE = Section("The <map>", ["Two & two."], [("name", "x"), ("a, b", -3)])


class Tags(HTMLParser):
    def __init__(self, page: str) -> None:
        super().__init__()
        self.opened: list[str] = []
        self.texts: list[str] = []
        self.feed(page)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.opened.append(tag)

    def handle_data(self, data: str) -> None:
        self.texts += [data] if data.strip() else []


def test_a_page_has_its_language_headings_and_column_headings() -> None:
    page = as_html("Donnie", "pt", [TABLE])
    tags = Tags(page)

    assert page.startswith('<!DOCTYPE html>\n<html lang="pt">')
    assert [each for each in tags.opened if each in ("h1", "h2", "th", "td", "p")] == [
        *("h1", "h2", "p", "th", "th", "td", "td")
    ]
    assert tags.texts[1:] == ["Donnie", "The <map>", "Two & two.", "name", "x", "a, b", "-3"]


def test_a_page_shows_text_that_could_be_more_than_text() -> None:
    evil = "</td><script>alert(1)</script>\x1b]0;x\x07\u202eabc\x9b2J"
    page = as_html(evil, "en", [Section(evil, [evil], [(evil,), (evil,)])])

    assert "script" not in Tags(page).opened
    assert not set("\x1b\x07\u202e\x9b") & set(page)
    assert len([each for each in Tags(page).texts if "<script>alert(1)</script>" in each]) == 6


def test_a_table_is_valid_csv() -> None:
    assert list(csv.reader(as_csv([TABLE]).splitlines())) == [["name", "x"], ["a, b", "-3"]]


def test_lines_are_a_table_of_one_column() -> None:
    assert as_csv([Section("Help", ["FW: walks", "TR: turns"])]) == "Help\nFW: walks\nTR: turns\n"
