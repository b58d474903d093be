"""REPORT: help, manual, program, map, trail, run or distances as a file.

A web page has headings for screen readers that jump by them; a name that ends in ``.csv`` gives a table for
spreadsheets. What has a picture is the picture alone where the name ends in ``.svg``: the run as it was
driven, and the distances, the speed and the variables over the time.
"""

from __future__ import annotations

import csv
import io
from collections.abc import Callable, Iterable, Iterator, Sequence
from html import escape
from itertools import pairwise
from pathlib import Path
from typing import TYPE_CHECKING

from msgspec import Struct

from devices.ports.robot import Bearing, Pose
from donnie_tui.core.describe import place_of
from donnie_tui.core.events import Moved, Read, RunEnded, RunStarted, Stamped, Turned, Waited
from donnie_tui.core.map_grid import Trail, path_in_words
from donnie_tui.core.map_words import floor_in_words
from donnie_tui.core.program_files import unquoted
from donnie_tui.core.program_text import ProgramText
from donnie_tui.core.wording import Wording, meant, shade, specific_name_of
from language.keywords import argument_spelling
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
_WITH_PICTURE = ("run", "distances")


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
    events: Sequence[Stamped] = ()
    """What the robot did and read."""
    run_picture: Callable[[], str] = str
    """The run as SVG."""


def asked(typed: str) -> tuple[str, str] | None:
    """What the report is about, and the name of its file, of ``map map.html``; None if that is not clear."""
    word, _blank, name = typed.strip().partition(" ")
    what = meant(word, "reports")
    if what is None or not name.strip():
        return None
    file = with_suffix(name.strip(), ".html")
    return None if file.lower().endswith(".svg") and what not in _WITH_PICTURE else (what, file)


def with_suffix(typed: str, suffix: str) -> str:
    """The name, with the suffix where it has none."""
    name = unquoted(typed)
    return name + suffix if name and not Path(name).suffix else name


def report(what: str, name: str, subject: Subject, wording: Wording) -> str:
    """The text of the file ``name``."""
    sections = subject.manual if what == "manual" else (_SECTIONS[what](subject, wording),)
    if name.lower().endswith(".csv"):
        return as_csv(sections)
    if name.lower().endswith(".svg"):
        return "".join(each.drawing for each in sections)
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


def _run(subject: Subject, wording: Wording) -> Section:
    """The path leg by leg, the picture, and the moves as a table."""
    lines = path_in_words(subject.trail.path, wording)
    rows = _trail(subject, wording).rows
    return Section(wording("report-run"), lines, rows, subject.run_picture())


def _distances(subject: Subject, wording: Wording) -> Section:
    series = measured(subject.events, wording)
    lines = measured_in_words(series, wording)
    times = sorted({t for each in series for t, _ in each.points})
    at = [dict(each.points) for each in series]
    rows = [(_number(t), *(_number(each[t]) if t in each else "" for each in at)) for t in times]
    columns = [wording("report-column-seconds"), *(each.name for each in series)]
    heading = wording("report-distances")
    return Section(heading, lines, [columns, *rows], as_plot(heading, series, lines, wording))


_SECTIONS = {
    **{"help": _help, "list": _list, "map": _map},
    **{"trail": _trail, "run": _run, "distances": _distances},
}


# --- what was measured, over the time


class Series(Struct, frozen=True):
    """One thing over the time."""

    name: str
    points: tuple[tuple[float, float], ...]
    """Seconds of the robot, and the value then."""
    kind: str
    """``distance``, ``speed`` or ``variable``."""
    jumps: tuple[float, ...] = ()
    """When a distance changed by more than the robot walked meanwhile."""


JUMP = 3
"""Steps."""
_BEARINGS = {each.words: each for each in Bearing}


def measured(events: Iterable[Stamped], wording: Wording) -> tuple[Series, ...]:
    """The distances that the program read, the speed, and the variables at the end of each run.

    Of all runs since the robot was put to its start last.
    """
    distances: dict[str, list[tuple[float, float, float]]] = {}
    speed: list[tuple[float, float]] = []
    variables: dict[str, list[tuple[float, float]]] = {}
    since = walked = 0.0
    for stamped in events:
        t, event = stamped.t, stamped.event
        if isinstance(event, RunStarted) and ((event.how and event.how.fresh) or t < since):
            for each in (distances, speed, variables):
                each.clear()
        if isinstance(event, Read) and event.sensor == "distance":
            distances.setdefault(event.argument, []).append((t, event.value, walked))
        if isinstance(event, Moved | Turned | Waited) and t > since:
            pace = event.walked / (t - since) if isinstance(event, Moved) else 0.0
            speed += (since, pace), (t, pace)
        if isinstance(event, Moved):
            walked += event.walked
        if isinstance(event, RunEnded):
            for name, value in event.variables.items():
                variables.setdefault(name, []).append((t, value))
        if isinstance(event, Moved | Turned | Waited | RunStarted):
            since = t
    found = [_distance(where, readings, wording) for where, readings in distances.items()]
    if speed:
        found.append(Series(wording("measured-speed-name"), tuple(speed), "speed"))
    found += (Series(name, tuple(points), "variable") for name, points in variables.items())
    return tuple(found)


def _distance(where: str, readings: Sequence[tuple[float, float, float]], wording: Wording) -> Series:
    short = argument_spelling(_BEARINGS[where], wording.language) if where in _BEARINGS else where
    jumps = tuple(
        later
        for (_, before, here), (later, after, there) in pairwise(readings)
        if abs(after - before) > there - here + JUMP
    )
    points = tuple((t, value) for t, value, _ in readings)
    return Series(wording("reading-distance", where=short), points, "distance", jumps)


def measured_in_words(series: Sequence[Series], wording: Wording) -> tuple[str, ...]:
    """A sentence each about the distance that was read most, the speed, and the variables."""
    said = list[str]()
    of_kind = {
        kind: [each for each in series if each.kind == kind] for kind in ("distance", "speed", "variable")
    }
    for each in sorted(of_kind["distance"], key=lambda each: -len(each.points))[:1]:
        (begin, first), (end, last) = each.points[0], each.points[-1]
        change = "falls" if last < first else "rises" if last > first else "same"
        values = {"name": each.name, "first": _number(first), "last": _number(last)}
        jumps = len(each.jumps)
        code = f"measured-{change}" + ("-jumps" if jumps else "")
        at = round(each.jumps[0]) if jumps else 0
        said.append(wording(code, **values, seconds=round(end - begin), count=jumps, at=at))
    for each in of_kind["speed"]:
        legs = list(zip(each.points[::2], each.points[1::2], strict=True))
        moving = sum(end - begin for (begin, pace), (end, _) in legs if pace)
        most = max(pace for _, pace in each.points)
        total = each.points[-1][0] - each.points[0][0]
        shown = {"most": round(most, 1), "pace": _number(round(most, 1))}
        said.append(wording("measured-speed", moving=round(moving), seconds=round(total), **shown))
    if of_kind["variable"]:
        ends = ", ".join(f"{each.name} = {_number(each.points[-1][1])}" for each in of_kind["variable"])
        said.append(wording("measured-variables", values=ends))
    return tuple(said) or (wording("measured-none"),)


def _number(value: float) -> str:
    return f"{round(value, 3):g}" if value % 1 else str(int(value))


_WIDTH, _PANEL, _LEFT, _ROW = 720.0, 130.0, 60.0, 20.0
"""Pixels: the plot, the height of one thing's part of it, the numbers to its left, a line of text."""


def as_plot(title: str, series: Sequence[Series], lines: Sequence[str], wording: Wording) -> str:
    """Each series in a part of its own, all over the same time, as SVG."""
    height = _ROW * 3 + _PANEL * len(series)
    size = f'width="{_WIDTH:g}" height="{height:g}" viewBox="0 0 {_WIDTH:g} {height:g}"'
    times = [t for each in series for t, _ in each.points] or [0.0]
    span = min(times), max(max(times), min(times) + 1)
    panels = (line for number, each in enumerate(series) for line in _panel(each, number, span))
    return "\n".join(
        (
            f'<svg xmlns="http://www.w3.org/2000/svg" role="img" {size}',
            ' font-family="sans-serif" font-size="14">',
            f"<title>{_shown(title)}</title>",
            f"<desc>{_shown(' '.join(lines))}</desc>",
            f'<rect width="{_WIDTH:g}" height="{height:g}" fill="white"/>',
            *panels,
            *(
                _text(
                    _LEFT + (_WIDTH - 2 * _LEFT) * part, height - 1.6 * _ROW, _number(round(t, 1)), "middle"
                )
                for part, t in ((0.0, span[0]), (0.5, sum(span) / 2), (1.0, span[1]))
            ),
            _text(_WIDTH / 2, height - 0.6 * _ROW, wording("report-column-seconds"), "middle"),
            "</svg>\n",
        )
    )


def _panel(series: Series, number: int, span: tuple[float, float]) -> Iterator[str]:
    top, bottom = _PANEL * number + 1.5 * _ROW, _PANEL * (number + 1)
    right, values = _WIDTH - _LEFT, [value for _, value in series.points]
    low, high = min(*values, 0), max(*values, min(*values, 0) + 1)
    places = [
        (
            round(_LEFT + (t - span[0]) / (span[1] - span[0]) * (right - _LEFT), 1),
            round(bottom - (value - low) / (high - low) * (bottom - top), 1),
        )
        for t, value in series.points
    ]
    yield _text(_LEFT, top - 0.4 * _ROW, series.name, "start")
    yield _text(_LEFT - 8, bottom + 5, _number(low), "end")
    yield _text(_LEFT - 8, top + 5, _number(round(high, 1)), "end")
    yield f'<path d="M{_LEFT:g} {top:g}V{bottom:g}H{right:g}" fill="none" stroke="black"/>'
    line = " ".join(f"{x:g},{y:g}" for x, y in places)
    yield f'<polyline points="{line}" fill="none" stroke="black" stroke-width="2"/>'
    if series.kind != "speed":
        yield from (f'<circle cx="{x:g}" cy="{y:g}" r="3"/>' for x, y in places)


def _text(x: float, y: float, text: str, anchor: str) -> str:
    return f'<text x="{x:g}" y="{y:g}" text-anchor="{anchor}">{_shown(text)}</text>'


# --- files


class Section(Struct, frozen=True):
    """A heading with its lines, or with a table whose first row names the columns."""

    heading: str
    lines: Sequence[str] = ()
    rows: Sequence[Sequence[object]] = ()
    drawing: str = ""
    """As SVG."""


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
    return f"<h2>{_shown(section.heading)}</h2>\n{lines}{section.drawing}{_table(section.rows)}"


def _table(rows: Sequence[Sequence[object]]) -> str:
    if not rows:
        return ""
    head = "".join(f'<th scope="col">{_shown(cell)}</th>' for cell in rows[0])
    body = "\n".join(f"<tr>{''.join(f'<td>{_shown(cell)}</td>' for cell in row)}</tr>" for row in rows[1:])
    return f"<table>\n<thead><tr>{head}</tr></thead>\n<tbody>\n{body}\n</tbody>\n</table>"
