"""Long reports as files: a web page with headings for readers that jump by them, a table for spreadsheets."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterable, Sequence
from html import escape

from devices.ports.values import Frozen


class Section(Frozen):
    """A heading with its lines, or with a table whose first row names the columns."""

    heading: str
    lines: Sequence[str] = ()
    rows: Sequence[Sequence[object]] = ()


def as_html(title: str, language: str, sections: Iterable[Section]) -> str:
    """A page of its own: no scripts, no styles, tables with column headings."""
    body = "\n".join(_section(each) for each in sections)
    head = f'<meta charset="utf-8">\n<title>{escape(title)}</title>'
    return (
        f'<!DOCTYPE html>\n<html lang="{language}">\n<head>\n{head}\n</head>\n'
        f"<body>\n<h1>{escape(title)}</h1>\n{body}\n</body>\n</html>\n"
    )


def as_csv(sections: Iterable[Section]) -> str:
    """The tables one after the other; a section of lines is a table of one column."""
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    for section in sections:
        writer.writerows(section.rows or [[section.heading], *([line] for line in section.lines)])
    return out.getvalue()


def _section(section: Section) -> str:
    lines = "\n".join(f"<p>{escape(line)}</p>" for line in section.lines)
    return f"<h2>{escape(section.heading)}</h2>\n{lines}{_table(section.rows)}"


def _table(rows: Sequence[Sequence[object]]) -> str:
    if not rows:
        return ""
    head = "".join(f'<th scope="col">{escape(str(cell))}</th>' for cell in rows[0])
    body = "\n".join(
        f"<tr>{''.join(f'<td>{escape(str(cell))}</td>' for cell in row)}</tr>" for row in rows[1:]
    )
    return f"<table>\n<thead><tr>{head}</tr></thead>\n<tbody>\n{body}\n</tbody>\n</table>"
