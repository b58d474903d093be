"""REPORT: help, manual, program, map, trail, run, distances or a sheet for swell paper as a file.

A web page has headings for screen readers that jump by them; a name that ends in ``.csv`` gives a table for
spreadsheets, ``.txt`` the sentences. A report with a picture is the picture alone if the name
ends as pictures do: the driven run, and the distances, the speed and the variables over time.
"""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from itertools import pairwise
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, TypeAlias

from msgspec import Struct
from msgspec.structs import replace

from devices.ports.robot import Bearing, Pose
from donnie_tui.core.describe import place_of
from donnie_tui.core.events import Moved, Read, RunEnded, RunStarted, Stamped, Turned, Waited, begins_anew
from donnie_tui.core.map_grid import LEGS_SAID, path_in_words
from donnie_tui.core.map_words import floor_in_words
from donnie_tui.core.program_files import STANDARD_OUTPUT, unquoted
from donnie_tui.core.program_text import ProgramText
from donnie_tui.core.timeline import Trail
from donnie_tui.core.transcript import lines_with_robot_name, with_robot_name
from donnie_tui.core.wording import Wording, keys_of, meant, shade, specific_name_of, spelled
from language.keywords import argument_spelling
from language.source import cleaned, printable

if TYPE_CHECKING:
    from sim.picture import Picture


Variables: TypeAlias = Sequence[tuple[str, int]]

_COLUMNS = {
    "help": ("how", "purpose"),
    "list": ("line", "level", "text"),
    "map": ("name", "color", "x", "y", "place"),
    "trail": ("command", "done", "x", "y", "heading", "blocked"),
}
_PAGES = (".html", ".htm", ".csv", ".txt")
_PICTURES = {"run": (".svg", ".png", ".gif"), "distances": (".svg", ".png")}
_PAPER = "paper"


class Subject(Struct, frozen=True):
    """The subject of a report."""

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
    variables: Mapping[int, Variables] = {}
    """Their values during movements, by the number of the event."""
    run_picture: Callable[[str], bytes] = lambda _suffix: b""
    """The run as a picture, for the end of a file's name."""
    plot_as_png: Callable[[Plot], bytes] = lambda _plot: b""
    paper: Callable[[], str] = str
    """The world with the driven path for swell paper, as SVG."""
    robot: str | None = None
    """The robot's name, if the report is about several."""


def asked(typed: str) -> tuple[str, str] | None:
    """Parse ``map map.html``: the subject of the report and the name of its file; None if it is unclear.

    A report that fits in some sentences needs no file: its name is empty then. A file alone, such as
    ``map.html``, is about what its name means, else about the run.
    """
    word, _blank, name = (each.strip() for each in typed.strip().partition(" "))
    what = meant(word, "reports")
    file = unquoted(typed.strip())
    if (file == word or file != typed.strip()) and (suffix := Path(file).suffix.lower()):
        about = meant(Path(file).stem, "reports")
        what, name = about if about is not None and suffix in suffixes_of(about) else "run", file
    if what is None or not (name or what in _PICTURES):
        return None
    if name == STANDARD_OUTPUT:
        return what, name
    return what, with_suffix(name, ".svg" if what == _PAPER else ".html")


def refusal(typed: str, wording: Wording) -> str:
    """Why there is no such report; empty if there is one."""
    word = typed.split()[0] if typed.split() else ""
    found = asked(typed)
    if found is not None:
        what, name = found
        suffix, suffixes = Path(name).suffix.lower(), suffixes_of(what)
        if not suffix or suffix in suffixes:
            return ""
        values = {"suffix": suffix, "suffixes": ", ".join(suffixes)}
        return wording("report-suffix", what=spelled(what, wording.language, "reports"), **values)
    if meant(word, "reports") is not None:
        shown = printable(word.lower())
        suffix = ".svg" if meant(word, "reports") == _PAPER else ".html"
        return wording("report-without-file", what=shown, file=shown + suffix)
    kinds = ", ".join(spelled(each, wording.language, "reports") for each in keys_of("reports"))
    return wording("report-unknown", what=printable(word), kinds=kinds)


def suffixes_of(what: str) -> tuple[str, ...]:
    """How the name of its file may end."""
    return (".svg",) if what == _PAPER else (*_PAGES, *_PICTURES.get(what, ()))


def with_suffix(typed: str, suffix: str) -> str:
    """The name, with the suffix where it has none."""
    name = unquoted(typed)
    return name + suffix if name and not Path(name).suffix else name


def report(what: str, name: str, subject: Subject, wording: Wording, others: Sequence[Subject] = ()) -> bytes:
    """The content of the file ``name``. ``others``: the other robots that it is about."""
    suffix = Path(name).suffix.lower()
    if what == _PAPER:
        return subject.paper().encode()
    if suffix in _PICTURES.get(what, ()):
        if what == "run":
            return subject.run_picture(suffix)
        plot = _plot((subject, *others), wording)
        return subject.plot_as_png(plot) if suffix == ".png" else plot_as_svg(plot).encode()
    sections = subject.manual if what == "manual" else (_SECTIONS[what](subject, wording),)
    if others and what in _OF_ROBOTS:
        more = (_SECTIONS[what](each, wording) for each in others)
        sections = _of_robots((subject, *others), (*sections, *more), wording)
        if suffix == ".csv":
            sections = (_joined(sections),)
    if suffix == ".csv":
        return as_csv(sections).encode()
    if suffix == ".txt":
        return as_text(sections).encode()
    heading = wording("report-manual") if what == "manual" else sections[0].heading
    page = as_html(wording("report-title", what=heading), wording.language, sections)
    return page.encode()


def beginnings(wording: Wording) -> tuple[str, ...]:
    """How its tables and pages begin."""
    tables = [f"{','.join(_columns(wording, what))}\n" for what in _COLUMNS]
    page = as_html(wording("report-title", what=""), wording.language, ())
    seconds = wording("report-column-seconds")
    tables += f"{seconds},", f"{seconds}\n"
    robot = wording("report-column-robot")
    return *tables, *(f"{robot},{each}" for each in tables), page.partition("</title>")[0]


def in_sentences(what: str, subject: Subject, wording: Wording) -> Sequence[str]:
    """The sentences of a report without a file."""
    if what == "run":
        return path_in_words(subject.trail.path, wording, LEGS_SAID)
    return _SECTIONS[what](subject, wording).lines


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
    trail = subject.trail
    rows = [
        (*rest, wording("report-yes" if is_blocked else "report-no")) for *rest, is_blocked in trail.rows()
    ]
    lines = trail.in_words(len(rows), wording)
    if trail.moves > len(rows):
        lines = (wording("trail-newest", count=len(rows), moves=trail.moves), *lines)
    return Section(wording("report-trail"), lines, [_columns(wording, "trail"), *rows])


def _run(subject: Subject, wording: Wording) -> Section:
    """The path leg by leg, the picture, and the moves as a table."""
    lines = path_in_words(subject.trail.path, wording)
    rows = _trail(subject, wording).rows
    return Section(wording("report-run"), lines, rows, subject.run_picture(".svg").decode())


def _distances(subject: Subject, wording: Wording) -> Section:
    series = _measured(subject, wording)
    times = sorted({t for each in series for t, _ in each.points})
    at = [dict(each.points) for each in series]
    rows = [(_number(t), *(_number(each[t]) if t in each else "" for each in at)) for t in times]
    columns = [wording("report-column-seconds"), *(each.name for each in series)]
    drawing = plot_as_svg(_plot((subject,), wording))
    lines = measured_in_words(series, wording)
    return Section(wording("report-distances"), lines, [columns, *rows], drawing)


def _measured(subject: Subject, wording: Wording) -> tuple[Series, ...]:
    return measured(subject.events, wording, subject.variables)


def _plot(subjects: Sequence[Subject], wording: Wording) -> Plot:
    series, said = list[Series](), list[str]()
    for subject in subjects:
        measured_of_it = _measured(subject, wording)
        said += lines_with_robot_name(subject.robot, measured_in_words(measured_of_it, wording), wording)
        series += (
            replace(each, name=with_robot_name(subject.robot, each.name, wording)) for each in measured_of_it
        )
    about = " ".join(said)
    return plotted(wording("report-distances"), series, about, wording("report-column-seconds"))


_SECTIONS = {
    **{"help": _help, "list": _list, "map": _map},
    **{"trail": _trail, "run": _run, "distances": _distances},
}

_OF_ROBOTS = ("list", "trail", "run", "distances")
"""The reports about one robot each."""


def _of_robots(
    subjects: Sequence[Subject], sections: Sequence[Section], wording: Wording
) -> tuple[Section, ...]:
    """The sections with the names of their robots, which are the first column of the tables.

    A picture of the run has all robots, and is there once.
    """
    named = list[Section]()
    for subject, each in zip(subjects, sections, strict=True):
        heading = with_robot_name(subject.robot, each.heading, wording)
        names = (wording("report-column-robot"), *[subject.robot or ""] * (len(each.rows) - 1))
        rows = [(name, *row) for name, row in zip(names, each.rows, strict=True)]
        is_again = any(each.drawing == other.drawing for other in named)
        named.append(Section(heading, each.lines, rows, "" if is_again else each.drawing))
    return tuple(named)


def _joined(sections: Sequence[Section]) -> Section:
    """One table with all rows and columns."""
    columns = list(dict.fromkeys(name for each in sections for name in each.rows[0]))
    rows = [dict(zip(each.rows[0], row, strict=True)) for each in sections for row in each.rows[1:]]
    return Section("", rows=[columns, *([row.get(name, "") for name in columns] for row in rows)])


# --- what was measured, over the time


class Series(Struct, frozen=True):
    """A measured value over time."""

    name: str
    points: tuple[tuple[float, float], ...]
    """Seconds of the robot, and the value then."""
    kind: str
    """``distance``, ``speed`` or ``variable``."""
    spoken: str = ""
    """Its name in sentences, if it differs."""
    steps: int = 0
    """How far the robot walked between the first and the last reading."""
    jumps: tuple[int, ...] = ()
    """The number of these steps in which a distance changed by more than the robot walked."""


JUMP = 3
"""Steps."""
_BEARINGS = {each.words: each for each in Bearing}


def measured(
    events: Iterable[Stamped], wording: Wording, during: Mapping[int, Variables] = MappingProxyType({})
) -> tuple[Series, ...]:
    """The distances that the program read, the speed, and the variables.

    ``during``: the variables during movements, by the event; at the end of a run its event has them. Of all
    runs since the robot was put to its start last.
    """
    distances: dict[str, list[tuple[float, float, float]]] = {}
    speed: list[tuple[float, float]] = []
    variables: dict[str, list[tuple[float, float]]] = {}
    since = walked = before = 0.0
    for stamped in events:
        event = stamped.event
        if begins_anew(event):
            since = walked = before = 0.0
            for each in (distances, speed, variables):
                each.clear()
        elif isinstance(event, RunStarted) and before + stamped.t < since:
            before = since - stamped.t  # its clock begins at 0 again
        t = before + stamped.t
        if isinstance(event, Read) and event.sensor == "distance":
            distances.setdefault(event.argument, []).append((t, event.value, walked))
        if isinstance(event, Moved | Turned | Waited) and t > since:
            pace = event.walked / (t - since) if isinstance(event, Moved) else 0.0
            speed += (since, pace), (t, pace)
            for name, value in during.get(stamped.seq, ()):
                variables.setdefault(name, []).extend(((since, value), (t, value)))
        if isinstance(event, Moved):
            walked += event.walked
        if isinstance(event, RunEnded):
            for name, value in event.variables.items():
                variables.setdefault(name, []).append((t, value))
        if isinstance(event, Moved | Turned | Waited | RunStarted | RunEnded):
            since = t
    found = [_distance(where, readings, wording) for where, readings in distances.items()]
    if speed:
        found.append(Series(wording("measured-speed-name"), tuple(speed), "speed"))
    found += (Series(name, tuple(dict.fromkeys(points)), "variable") for name, points in variables.items())
    return tuple(found)


def _distance(where: str, readings: Sequence[tuple[float, float, float]], wording: Wording) -> Series:
    short, spoken = where, where
    if where in _BEARINGS:
        short = argument_spelling(_BEARINGS[where], wording.language)
        spoken = wording(f"around-{where.replace(' ', '-')}")
    begin = readings[0][2]
    jumps = tuple(
        round(there - begin)
        for (_, before, here), (_, after, there) in pairwise(readings)
        if abs(after - before) > there - here + JUMP
    )
    return Series(
        wording("reading-distance", where=short),
        tuple((t, value) for t, value, _ in readings),
        "distance",
        wording("reading-distance", where=spoken),
        round(readings[-1][2] - begin),
        jumps,
    )


def measured_in_words(series: Sequence[Series], wording: Wording) -> tuple[str, ...]:
    """A sentence each about the distance that was read most, the speed, and the variables."""
    said = list[str]()
    of_kind = {
        kind: [each for each in series if each.kind == kind] for kind in ("distance", "speed", "variable")
    }
    for each in sorted(of_kind["distance"], key=lambda each: -len(each.points))[:1]:
        first, last = each.points[0][1], each.points[-1][1]
        change = "falls" if last < first else "rises" if last > first else "same"
        values = {"name": each.spoken, "first": _number(first), "last": _number(last), "steps": each.steps}
        jumps = len(each.jumps)
        code = f"measured-{change}" + ("-jumps" if jumps > 1 else "-jump" if jumps else "")
        said.append(wording(code, **values, count=jumps, at=each.jumps[0] if jumps else 0))
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


_Point: TypeAlias = tuple[float, float]


class PlotText(Struct, frozen=True):
    """A text of a plot, with the place of its base line."""

    x: float
    y: float
    text: str
    anchor: str
    """What is at ``x``: its ``start``, its ``middle`` or its ``end``."""


class Plot(Struct, frozen=True):
    """A drawing of what was measured. Places are pixels from the top left corner."""

    title: str
    about: str
    width: float
    height: float
    axes: tuple[tuple[_Point, ...], ...]
    curves: tuple[tuple[_Point, ...], ...]
    dots: tuple[_Point, ...]
    texts: tuple[PlotText, ...]


PLOT_LETTER = 14.0
"""The height of its letters."""
_WIDTH, _PANEL, _LEFT, _RIGHT, _ROW = 720.0, 130.0, 96.0, 40.0, 20.0
"""Pixels: the plot, the height of one thing's part of it, what is left and right of it, a line of text."""
_LONGEST_NUMBER = 9


def plotted(title: str, series: Sequence[Series], about: str, seconds: str) -> Plot:
    """Draws each series in its own panel, all with the same time axis."""
    height = _ROW * 3 + _PANEL * len(series)
    times = [t for each in series for t, _ in each.points] or [0.0]
    first, last = min(times), max(max(times), min(times) + 1)
    span = last - first or 1.0  # a damaged recording may have times that a second doesn't change
    width = _WIDTH - _LEFT - _RIGHT
    axes, curves, dots, texts = list[tuple[_Point, ...]](), list[tuple[_Point, ...]](), list[_Point](), []
    for number, each in enumerate(series):
        top, bottom = _PANEL * number + 1.7 * _ROW, _PANEL * (number + 1)
        values = [value for _, value in each.points]
        low, high = min(*values, 0), max(*values, min(*values, 0) + 1)
        curve = tuple(
            (
                round(_LEFT + (t - first) / span * width, 1),
                round(bottom - (value - low) / (high - low) * (bottom - top), 1),
            )
            for t, value in each.points
        )
        axes.append(((_LEFT, top), (_LEFT, bottom), (_LEFT + width, bottom)))
        curves.append(curve)
        dots += curve if each.kind == "distance" or len(curve) == 1 else ()
        texts += [
            PlotText(_LEFT, top - 0.5 * _ROW, each.name, "start"),
            PlotText(_LEFT - 8, bottom + 5, _on_axis(low), "end"),
            PlotText(_LEFT - 8, top + 5, _on_axis(high), "end"),
        ]
    texts += [
        PlotText(_LEFT + width * part, height - 1.6 * _ROW, _number(round(t, 1)), "middle")
        for part, t in ((0.0, first), (0.5, (first + last) / 2), (1.0, last))
    ]
    texts.append(PlotText(_LEFT + width / 2, height - 0.6 * _ROW, seconds, "middle"))
    return Plot(title, about, _WIDTH, height, tuple(axes), tuple(curves), tuple(dots), tuple(texts))


_MOST_DIGITS = 300
"""Digits of a number that is a float, too; a variable may have thousands."""


def _on_axis(value: float) -> str:
    text = _number(round(value, 1))
    if len(text) <= _LONGEST_NUMBER:
        return text
    sign, digits = text[: -len(text.lstrip("-"))], text.lstrip("-")
    if len(digits) < _MOST_DIGITS:
        return f"{value:.2e}"
    return f"{sign}{digits[0]}.{digits[1:3]}e+{len(digits) - 1}"


def plot_as_svg(plot: Plot) -> str:
    """The plot as SVG, for a page or a file of its own."""
    size = f'width="{plot.width:g}" height="{plot.height:g}" viewBox="0 0 {plot.width:g} {plot.height:g}"'
    font = f'font-family="sans-serif" font-size="{PLOT_LETTER:g}"'
    return "\n".join(
        (
            f'<svg xmlns="http://www.w3.org/2000/svg" role="img" {size} {font}>',
            f"<title>{_shown(plot.title)}</title>",
            f"<desc>{_shown(plot.about)}</desc>",
            f'<rect width="{plot.width:g}" height="{plot.height:g}" fill="white"/>',
            *(
                f'<path d="M{"L".join(f"{x:g} {y:g}" for x, y in each)}" fill="none" stroke="black"/>'
                for each in plot.axes
            ),
            *(
                f'<polyline points="{" ".join(f"{x:g},{y:g}" for x, y in each)}" fill="none"'
                ' stroke="black" stroke-width="2"/>'
                for each in plot.curves
            ),
            *(f'<circle cx="{x:g}" cy="{y:g}" r="3"/>' for x, y in plot.dots),
            *(
                f'<text x="{each.x:g}" y="{each.y:g}" text-anchor="{each.anchor}">{_shown(each.text)}</text>'
                for each in plot.texts
            ),
            "</svg>\n",
        )
    )


# --- files


class Section(Struct, frozen=True):
    """A heading with its lines, or with a table whose first row names the columns."""

    heading: str
    lines: Sequence[str] = ()
    rows: Sequence[Sequence[object]] = ()
    drawing: str = ""
    """As SVG."""


def _shown(text: object) -> str:
    """The text for a page: characters that could be a tag, or hide or reverse other text, are escaped."""
    from html import escape  # loads thousands of names of signs, and few sessions write a report

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
        rows = section.rows or [[section.heading], *([line] for line in section.lines)]
        writer.writerows([as_cell(each) for each in row] for row in rows)
    return out.getvalue()


def as_cell(value: object) -> object:
    """Text is text for a spreadsheet too, and never a formula: a program may come from anyone."""
    if not isinstance(value, str):
        return value
    text = cleaned(value)
    is_formula = text.lstrip().startswith(("=", "+", "-", "@")) and not re.fullmatch(_NUMBER, text)
    return f"'{text}" if is_formula else text


_NUMBER = r"[-+]?\d+(?:[.,]\d+)?"


def as_text(sections: Iterable[Section]) -> str:
    """The sentences under their headings; where there are none, the rows of the table."""
    blocks = (
        [each.heading, *(each.lines or (", ".join(map(str, row)) for row in each.rows))] for each in sections
    )
    return "".join(f"{cleaned(line)}\n" for block in blocks for line in block)


def _section(section: Section) -> str:
    lines = "\n".join(f"<p>{_shown(line)}</p>" for line in section.lines)
    return f"<h2>{_shown(section.heading)}</h2>\n{lines}{section.drawing}{_table(section.rows)}"


def _table(rows: Sequence[Sequence[object]]) -> str:
    if not rows:
        return ""
    head = "".join(f'<th scope="col">{_shown(cell)}</th>' for cell in rows[0])
    body = "\n".join(f"<tr>{''.join(f'<td>{_shown(cell)}</td>' for cell in row)}</tr>" for row in rows[1:])
    return f"<table>\n<thead><tr>{head}</tr></thead>\n<tbody>\n{body}\n</tbody>\n</table>"
