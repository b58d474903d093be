"""Long answers as files: SAVE LOG as text, REPORT as a web page or as a table, by the suffix of the name."""

from __future__ import annotations

from pathlib import Path

from donnie_tui.core import use_cases
from donnie_tui.core.describe import name_of, place_of
from donnie_tui.core.documents import DocumentError, program_to_save, write_program
from donnie_tui.core.map_words import map_in_words
from donnie_tui.core.reading import ProgramText
from donnie_tui.core.reports import Section, as_csv, as_html
from donnie_tui.core.use_cases import USE_CASES
from donnie_tui.linear.arguments import Handler
from donnie_tui.linear.desk import Desk
from donnie_tui.linear.files import may_replace, refuse
from donnie_tui.linear.runs import Runs
from language.source import fold_name

_WHAT = {
    "help": ("help", "ajuda", "ayuda"),
    "list": ("list", "listar", "lista"),
    "map": ("map", "mapa"),
    "trail": ("trail", "trilha", "rastro"),
}
_MOST_MOVES = 1000


def _save_log(desk: Desk, _: Runs, rest: str) -> bool:
    """What was said, as plain text."""
    if not rest:
        return False
    if not len(desk.answers):
        desk.answer("answer-nothing-said")
        return True
    _write(desk, _named(rest, ".txt"), desk.answers.text())
    return True


def _report(desk: Desk, _: Runs, rest: str) -> bool:
    """REPORT map map.html; with .csv a table."""
    word, _blank, name = rest.partition(" ")
    what = next((what for what, words in _WHAT.items() if fold_name(word) in words), None)
    if what is None or not name.strip():
        return False
    path = _named(name.strip(), ".html")
    sections = [_SECTIONS[what](desk)]
    if path.lower().endswith(".csv"):
        text = as_csv(sections)
    else:
        heading = sections[0].heading
        title = desk.say("report-title", what=heading[:1].lower() + heading[1:])
        text = as_html(title, desk.say.language, sections)
    _write(desk, path, text)
    return True


def _named(typed: str, suffix: str) -> str:
    return typed if Path(typed).suffix else typed + suffix


def _write(desk: Desk, name: str, text: str) -> None:
    try:
        path = program_to_save(name)
        if not may_replace(desk, path):
            desk.answer("answer-unchanged")
            return
        write_program(path, text)
    except DocumentError as error:
        refuse(desk, error)
    else:
        desk.answer("answer-written", name=path.name)


def _columns(desk: Desk, what: str) -> list[str]:
    return desk.say(f"report-columns-{what}").split(",")


def _help(desk: Desk) -> Section:
    """GoDonnie's words, then ours: how each is typed, and what for."""
    lines = [*desk.say.help(None)[1:]]
    lines += [use_cases.help_line(each, desk.say) for each in USE_CASES if not each.hidden]
    rows = [line.partition(": ")[::2] for line in lines]
    return Section(desk.say("report-words"), rows=[_columns(desk, "help"), *rows])


def _list(desk: Desk) -> Section:
    text = ProgramText(desk.program.lines)
    lines = [text.line(number) for number in range(1, len(text) + 1)]
    rows = [(each.number, each.level, each.text) for each in lines]
    return Section(desk.say("report-program"), rows=[_columns(desk, "list"), *rows])


def _map(desk: Desk) -> Section:
    """What stands where; the first lines tell the floor."""
    pose, picture = desk.session.pose, desk.donnie.picture_now()
    rows = [
        (
            name_of(each, desk.say),
            desk.say(f"colour-{each.colour}"),
            round(each.x),
            round(each.y),
            place_of(each.x, each.y, pose, desk.say),
        )
        for each in picture.things
    ]
    lines = map_in_words(picture, pose, desk.say)[:2]
    return Section(desk.say("report-map"), lines, [_columns(desk, "map"), *rows])


def _trail(desk: Desk) -> Section:
    lines = desk.trail.in_words(_MOST_MOVES, desk.say)
    return Section(desk.say("report-trail"), lines, [_columns(desk, "trail"), *desk.trail.rows()])


_SECTIONS = {"help": _help, "list": _list, "map": _map, "trail": _trail}

HANDLERS: dict[str, Handler] = {"save_log": _save_log, "report": _report}
