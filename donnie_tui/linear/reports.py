"""Long answers as files: SAVE LOG as text, REPORT as a web page or as a table, by the suffix of the name."""

from __future__ import annotations

from donnie_tui.core.documents import DocumentError, page_to_save, write_program
from donnie_tui.core.report_text import Subject, asked, report, with_suffix
from donnie_tui.i18n.manual import sections
from donnie_tui.linear.arguments import Handler
from donnie_tui.linear.desk import Desk
from donnie_tui.linear.files import may_replace, refuse
from donnie_tui.linear.patience import patiently
from donnie_tui.linear.runs import Runs


def _save_log(desk: Desk, _: Runs, rest: str) -> bool:
    """What was said, as plain text."""
    if not rest:
        return False
    if not len(desk.answers):
        desk.answer("answer-nothing-said")
        return True
    _write(desk, with_suffix(rest, ".txt"), desk.answers.text())
    return True


def _report(desk: Desk, _: Runs, rest: str) -> bool:
    """REPORT map map.html; with .csv a table."""
    wanted = asked(rest)
    if wanted is not None:
        _write(desk, wanted[1], report(*wanted, _subject(desk), desk.say))
    return wanted is not None


def _subject(desk: Desk) -> Subject:
    words, chapters = desk.say.help(None)[1:], sections(desk.say)
    floor, trail = desk.donnie.picture_now(), desk.heard.trail
    return Subject(desk.program.lines, desk.session.pose, floor, trail, words, chapters)


def _write(desk: Desk, name: str, text: str) -> None:
    try:
        path = page_to_save(name, desk.programs.files, desk.donnie.in_use)
        if not may_replace(desk, path):
            desk.answer("answer-unchanged")
            return
        patiently(desk, lambda: write_program(path, text), "slow-report", name=path.name)
    except DocumentError as error:
        refuse(desk, error)
    else:
        desk.answer("answer-written", name=path.name)


HANDLERS: dict[str, Handler] = {"save_log": _save_log, "report": _report}
