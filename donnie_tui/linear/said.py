"""The words about what was said and typed: LAST, SPELL, FIND, TYPED, ERROR, EXPLAIN, SAVE LOG, SHOW LOG."""

from __future__ import annotations

from donnie_tui.core.answer_log import found_in_words, none_so_far, spelled
from donnie_tui.core.told_errors import line_of
from donnie_tui.i18n.catalogue.signs import SPELLED_OF
from donnie_tui.linear.arguments import Handler, alone, counted
from donnie_tui.linear.desk import Desk
from donnie_tui.linear.reading import go_to

SHOWN = 10
"""Answers that SHOW LOG says again."""
_TYPED_AT_ONCE = 10


def _last(desk: Desk, which: int) -> None:
    """The answer before this one, or the ``which``-th last."""
    answer = desk.answers.last(which)
    if answer:
        desk.showing.is_repeating = True
        desk.tell_list(answer)
    else:
        desk.tell(none_so_far(desk.answers, desk.say))


def _spell(desk: Desk, which: int) -> None:
    _say_spelled(desk, desk.answers.last_line(which))


def _last_word(desk: Desk) -> None:
    _say_spelled(desk, desk.answers.last_word())


def _say_spelled(desk: Desk, text: str) -> None:
    desk.showing.is_repeating = bool(text)
    desk.tell(*spelled(text, SPELLED_OF, desk.say))


def _find(desk: Desk, word: str) -> bool:
    if not word:
        return False
    desk.showing.is_repeating = bool(desk.answers.found(word))
    desk.tell(*found_in_words(desk.answers, word, desk.say))
    return True


def _show_log(desk: Desk) -> None:
    """The last answers again, the newest last."""
    answers = [desk.answers.last(which) for which in range(min(SHOWN, len(desk.answers)), 0, -1)]
    if not answers:
        desk.answer("answer-nothing-said")
    desk.showing.is_repeating = bool(answers)
    desk.tell_list([line for answer in answers for line in answer])


def _typed(desk: Desk, count: int) -> None:
    """The lines typed last, numbered; the number of one, typed next, does it again."""
    lines = desk.past[:-1]  # without this one
    first = max(0, len(lines) - count)
    if not lines:
        desk.answer("linear-nothing-typed")
        return
    typed = enumerate(lines[first:], first + 1)
    desk.tell_list([desk.say("linear-listed", line=number, text=line) for number, line in typed])
    desk.answer("linear-type-number")
    desk.next_line = lambda chosen: _do_again(desk, lines, chosen)


def _do_again(desk: Desk, lines: list[str], chosen: str) -> bool:
    """Shown first, so that it is clear what is done; any other line is none of this."""
    if not chosen.strip().isdecimal() or len(chosen) > 8:
        return False
    number = int(chosen)
    if 1 <= number <= len(lines):
        desk.answer("linear-listed", line=number, text=lines[number - 1])
        desk.take_again(lines[number - 1])
    else:
        desk.answer("answer-no-line", line=number, last=len(lines))
    return True


# --- mistakes


def _error(desk: Desk, move: int = 0) -> None:
    """The error told last, or one before or after it; the reading place goes along."""
    error, told = desk.heard.errors.go(move, desk.say)
    desk.place = desk.place if error is None else error.line
    desk.tell(*told)


def _errors(desk: Desk) -> None:
    desk.tell_list(desk.heard.errors.in_words(desk.say))


def _explain(desk: Desk) -> None:
    """The error again in plain words, and what to do, with an example."""
    error = desk.heard.errors.now
    desk.tell(*desk.heard.errors.explained(desk.session.hub.robot, desk.say))
    if error is None:
        return
    if desk.program.lines[error.line - 1 : error.line] == (error.source_line,):
        go_to(desk, error.line)
    else:
        desk.tell(*line_of(error, desk.say))


HANDLERS: dict[str, Handler] = {
    "last": counted(_last, 1),
    "last_word": alone(_last_word),
    "spell": counted(_spell, 1),
    "find": lambda desk, _, rest: _find(desk, rest),
    "show_log": alone(_show_log),
    "typed": counted(_typed, _TYPED_AT_ONCE),
    "error": alone(_error),
    "error_next": alone(lambda desk: _error(desk, 1)),
    "error_previous": alone(lambda desk: _error(desk, -1)),
    "errors": alone(_errors),
    "explain": alone(_explain),
}
