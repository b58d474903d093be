"""REPORT: words, manual, program, map or trail as a web page, or as a table where the name ends so."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from devices.ports.robot import Pose
from devices.ports.values import Frozen
from donnie_tui.core import use_cases
from donnie_tui.core.describe import place_of
from donnie_tui.core.documents import unquoted
from donnie_tui.core.map_words import floor_in_words
from donnie_tui.core.naming import shade, told_name_of
from donnie_tui.core.reading import ProgramText
from donnie_tui.core.reports import Section, as_csv, as_html
from donnie_tui.core.trail import Trail
from donnie_tui.core.use_cases import USE_CASES
from donnie_tui.core.wording import Wording
from language.source import fold_name

if TYPE_CHECKING:
    from sim.picture import Picture

_WHAT = {
    "help": ("help", "ajuda", "ayuda"),
    "list": ("list", "listar", "lista"),
    "manual": ("manual",),
    "map": ("map", "mapa"),
    "trail": ("trail", "trilha", "rastro"),
}
_COLUMNS = {
    "help": ("how", "purpose"),
    "list": ("line", "level", "text"),
    "map": ("name", "color", "x", "y", "place"),
    "trail": ("command", "done", "x", "y", "heading", "blocked"),
}
_MOST_MOVES = 1000


class Subject(Frozen):
    """What a report may be about."""

    lines: tuple[str, ...]
    """The program's."""
    pose: Pose
    picture: Picture
    trail: Trail
    help: Sequence[str]
    """The lines about GoDonnie's words: each how it is typed, a colon, what it is for."""
    manual: Sequence[Section]
    """Its chapters."""


def asked(typed: str) -> tuple[str, str] | None:
    """What the report is about, and the name of its file, of ``map map.html``; None if that is not clear."""
    word, _blank, name = typed.strip().partition(" ")
    what = next((what for what, words in _WHAT.items() if fold_name(word) in words), None)
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
    """GoDonnie's words, then ours: how each is typed, and what for."""
    ours = (use_cases.help_line(each, wording) for each in USE_CASES if not each.hidden)
    rows = [line.partition(": ")[::2] for line in (*subject.help, *ours)]
    return Section(wording("report-words"), rows=[_columns(wording, "help"), *rows])


def _list(subject: Subject, wording: Wording) -> Section:
    text = ProgramText(subject.lines)
    lines = [text.line(number) for number in range(1, len(text) + 1)]
    rows = [(each.number, each.level, each.text) for each in lines]
    return Section(wording("report-program"), rows=[_columns(wording, "list"), *rows])


def _map(subject: Subject, wording: Wording) -> Section:
    """What stands where; the first lines tell the floor."""
    rows = [
        (
            told_name_of(each, wording),
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
