"""REPORT: help, manual, program, map or trail as a file.

A web page has headings for screen readers that jump by them; a name that ends in ``.csv`` gives a table for
spreadsheets.
"""

from __future__ import annotations

import csv
import io
from collections.abc import Iterable, Sequence
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING

from msgspec import Struct

from devices.ports.robot import Pose
from donnie_tui.core.describe import place_of
from donnie_tui.core.map_grid import Trail
from donnie_tui.core.map_words import floor_in_words
from donnie_tui.core.program_files import unquoted
from donnie_tui.core.program_text import ProgramText
from donnie_tui.core.wording import Wording, meant, shade, specific_name_of
from language.source import cleaned

if TYPE_CHECKING:
    from sim.picture import Picture


_COLUMNS = {
    "help": ("how", "purpose"),
    "list": ("line", "level", "text"),
    "map": ("name", "color", "x", "y", "place"),
    "trail": ("command", "done", "x", "y", "heading", "blocked"),
}
_MOST_MOVES = 1000


class Subject(Struct, frozen=True):
    """What a report may be about."""

    lines: tuple[str, ...]
    """The program's lines."""
    pose: Pose
    picture: Picture
    trail: Trail
    help: Sequence[str]
    """The lines about GoDonnie's words and the commands: usage, a colon, purpose."""
    manual: Sequence[Section]
    """Its chapters."""


def asked(typed: str) -> tuple[str, str] | None:
    """What the report is about, and the name of its file, of ``map map.html``; None if that is not clear."""
    word, _blank, name = typed.strip().partition(" ")
    what = meant(word, "reports")
    return None if what is None or not name.strip() else (what, with_suffix(name.strip(), ".html"))


def with_suffix(typed: str, suffix: str) -> str:
    """The name, with the suffix where it has none."""
    name = unquoted(typed)
    return name + suffix if name and not Path(name).suffix else name


def report(what: str, name: str, subject: Subject, wording: Wording) -> str:
    """The text of the file ``name``."""
    sections = subject.manual if what == "manual" else (_SECTIONS[what](subject, wording),)
    if name.lower().endswith(".csv"):
        return as_csv(sections)
    heading = wording("report-manual") if what == "manual" else sections[0].heading
    return as_html(wording("report-title", what=heading), wording.language, sections)


def _columns(wording: Wording, what: str) -> list[str]:
    return [wording(f"report-column-{each}") for each in _COLUMNS[what]]


def _help(subject: Subject, wording: Wording) -> Section:
    rows = [line.partition(": ")[::2] for line in subject.help]
    return Section(wording("report-words"), rows=[_columns(wording, "help"), *rows])


def _list(subject: Subject, wording: Wording) -> Section:
    text = ProgramText(subject.lines)
    lines = [text.line(number) for number in range(1, len(text) + 1)]
    rows = [(each.number, each.level, each.text) for each in lines]
    return Section(wording("report-program"), rows=[_columns(wording, "list"), *rows])


def _map(subject: Subject, wording: Wording) -> Section:
    """The things and their places; the first lines describe the floor."""
    rows = [
        (
            specific_name_of(each, wording),
            shade(each, wording),
            round(each.x),
            round(each.y),
            place_of(each.x, each.y, subject.pose, wording),
        )
        for each in subject.picture.things
    ]
    lines = floor_in_words(subject.picture, subject.pose, wording)
    return Section(wording("report-map"), lines, [_columns(wording, "map"), *rows])


def _trail(subject: Subject, wording: Wording) -> Section:
    lines = subject.trail.in_words(_MOST_MOVES, wording)
    rows = [
        (*rest, wording("report-yes" if is_blocked else "report-no"))
        for *rest, is_blocked in subject.trail.rows()
    ]
    return Section(wording("report-trail"), lines, [_columns(wording, "trail"), *rows])


_SECTIONS = {"help": _help, "list": _list, "map": _map, "trail": _trail}


class Section(Struct, frozen=True):
    """A heading with its lines, or with a table whose first row names the columns."""

    heading: str
    lines: Sequence[str] = ()
    rows: Sequence[Sequence[object]] = ()


def _shown(text: object) -> str:
    """For a page: what could be a tag, or hide or turn round other text, is only shown."""
    return escape(cleaned(str(text)))


def as_html(title: str, language: str, sections: Iterable[Section]) -> str:
    """A page of its own: no scripts, no styles, tables with column headings."""
    body = "\n".join(_section(each) for each in sections)
    head = f'<meta charset="utf-8">\n<title>{_shown(title)}</title>'
    return (
        f'<!DOCTYPE html>\n<html lang="{language}">\n<head>\n{head}\n</head>\n'
        f"<body>\n<h1>{_shown(title)}</h1>\n{body}\n</body>\n</html>\n"
    )


def as_csv(sections: Iterable[Section]) -> str:
    """The tables one after the other; a section of lines is a table of one column."""
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    for section in sections:
        writer.writerows(section.rows or [[section.heading], *([line] for line in section.lines)])
    return out.getvalue()


def _section(section: Section) -> str:
    lines = "\n".join(f"<p>{_shown(line)}</p>" for line in section.lines)
    return f"<h2>{_shown(section.heading)}</h2>\n{lines}{_table(section.rows)}"


def _table(rows: Sequence[Sequence[object]]) -> str:
    if not rows:
        return ""
    head = "".join(f'<th scope="col">{_shown(cell)}</th>' for cell in rows[0])
    body = "\n".join(f"<tr>{''.join(f'<td>{_shown(cell)}</td>' for cell in row)}</tr>" for row in rows[1:])
    return f"<table>\n<thead><tr>{head}</tr></thead>\n<tbody>\n{body}\n</tbody>\n</table>"
