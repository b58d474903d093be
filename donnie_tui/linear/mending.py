"""The words about the program as a whole: FIX, SEARCH, REPLACE, FORMAT, TRANSLATE; and MANUAL."""

from __future__ import annotations

from donnie_tui.core import finding
from donnie_tui.core.mistakes import mended, mistakes
from donnie_tui.core.typed_program import ProgramTooLong
from donnie_tui.core.typed_words import language_named
from donnie_tui.i18n.catalogue.manual import CHAPTERS
from donnie_tui.linear.arguments import Handler, alone
from donnie_tui.linear.desk import Desk
from donnie_tui.linear.lines import offer_again, warning_of_all
from donnie_tui.linear.patience import GivenUp, patiently
from donnie_tui.linear.reading import go_to
from donnie_tui.linear.runs import Runs
from language.formatter import formatted


def _fix(desk: Desk) -> None:
    """What was probably meant takes the place of what stands there.

    At the mistake that ERROR and EXPLAIN speak of, else at the first one that is known. A line that was
    forgotten because of a mistake comes back, mended as far as that is known, to be looked at.
    """
    if desk.program.refused is not None:
        _fix_refused(desk, desk.program.refused)
        return
    found = mistakes(desk.session.check(desk.program.text), desk.say)
    known = [each for _, each in sorted(found.items()) if each.meant]
    now = desk.heard.errors.now
    first = next((each for each in known if now is not None and each.line == now.line), None)
    if not known:
        desk.answer("screen-no-fix" if found else "screen-nothing-to-fix")
    elif _rewrite(desk, mended(desk.program.text, first or known[0])):
        go_to(desk, (first or known[0]).mended_line)


def _fix_refused(desk: Desk, line: str) -> None:
    found = mistakes(desk.session.check(line, whole=False), desk.say)
    known = next((each for each in found.values() if each.meant), None)
    if known is None:
        desk.answer("screen-no-fix")
    if known is not None or desk.ends.can_edit:
        offer_again(desk, line if known is None else mended(line, known))


def _rewrite(desk: Desk, text: str) -> bool:
    try:
        desk.program.rewrite(text)
    except ProgramTooLong:
        desk.answer("linear-too-long")
        return False
    return True


def _search(desk: Desk, _: Runs, rest: str) -> bool:
    """The next line with the word, from the reading place on and once round."""
    desk.searched = rest or desk.searched
    if not desk.searched:
        return False
    place = finding.found_from(desk.program.lines, desk.searched, desk.place)
    if place is None:
        desk.tell(finding.not_found(desk.searched, desk.say))
    else:
        go_to(desk, place.row + 1)
    return True


def _search_again(desk: Desk, runs: Runs, rest: str) -> bool:
    return not rest and _search(desk, runs, "")


def _replace(desk: Desk, _: Runs, rest: str) -> bool:
    """Everywhere in the program, as it is written; asks by what."""
    if not rest:
        return False
    count = desk.program.text.count(rest)
    if not count:
        desk.tell(finding.not_to_replace(desk.program.lines, rest, desk.say))
        return True
    instead = finding.replacement(desk.asking.ask("ask-replace-by", word=finding.told(rest)))
    if instead is None:
        desk.answer("answer-unchanged")
        return True
    if not _rewrite(desk, desk.program.text.replace(rest, instead)):
        return True
    desk.answer("screen-replaced", count=count)
    return True


def _format(desk: Desk) -> None:
    _lay_out(desk, None)


def _translate(desk: Desk, _: Runs, rest: str) -> bool:
    language = language_named(rest)
    if language is not None:
        _lay_out(desk, language)
    return language is not None


def _lay_out(desk: Desk, language: str | None) -> None:
    text = desk.program.text
    if not desk.program.lines:
        desk.answer("linear-no-lines")
        return
    try:
        result = patiently(desk, lambda: formatted(text, language), "slow-layout", may_be_left=True)
    except GivenUp:
        desk.answer("answer-unchanged")
        return
    if result.text is None:
        desk.answer("screen-not-formatted", line=result.diagnostics[0].span.line)
    elif _rewrite(desk, result.text):
        desk.answer("screen-formatted")


def _manual(desk: Desk, _: Runs, rest: str) -> bool:
    """The chapters with their numbers, one of them, or what is said of a word."""
    if not rest:
        desk.answer("linear-chapters", count=len(CHAPTERS))
        for number, chapter in enumerate(CHAPTERS, 1):
            desk.answer("linear-listed", line=number, text=desk.say(f"manual-{chapter}"))
    elif rest.isdecimal() and len(rest) < 3 and 1 <= int(rest) <= len(CHAPTERS):
        from donnie_tui.i18n.manual import chapter_lines

        desk.tell(*chapter_lines(desk.say, CHAPTERS[int(rest) - 1]))
    else:
        desk.tell(*desk.say.help(rest))
    return True


HANDLERS: dict[str, Handler] = {
    "fix": warning_of_all(alone(_fix)),
    "search": _search,
    "search_again": _search_again,
    "replace": warning_of_all(_replace),
    "format": warning_of_all(alone(_format)),
    "translate": warning_of_all(_translate),
    "manual": _manual,
}
