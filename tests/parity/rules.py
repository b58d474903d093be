"""Rules for intended differences between the two front ends, so that no case has to list them.

No other difference is allowed.
"""

from __future__ import annotations

import re
from dataclasses import replace

from tests.parity.outcome import Outcome

PANES = ("SHOW PROGRAM", "SHOW MAP", "SHOW LOG", "SHOW VARIABLES", "VARIABLES", "VARIÁVEIS")
"""The screen goes to that part of it, the linear mode reads it out."""
OF_ITSELF = ("HELP", "HELP ME", "TOUR", "MANUAL", "SET", "CONFIGURE", "SETTINGS")
"""Each front end has pages of its own about itself: its keys, its first lesson, its settings."""
CHOSEN_FROM_A_LIST = ("LANGUAGE", "DETAIL", "SET speech")
"""The screen lists what can be chosen; the linear mode says what is chosen, and which choices there are."""
GONE_TO = ("ERRORS", "ERROS", "ERRORES")
"""The screen lists the mistakes to go to one, a row each; the linear mode says them with their lines."""
OF_WAITING_LINES = {
    *(f"{name}: RUN" for name in ("idle", "fresh", "two robots, idle")),
    *(f"{name}: {word}" for name in ("idle", "running", "held") for word in ("DELETE", "REMOVE")),
}
"""In the linear mode RUN runs, and DELETE deletes, the lines that have not run. On the screen none wait."""
OF_WAITING_OR_ALL = ("STEP", "OVER", "UNTIL")
"""In the linear mode these begin with what waits, where the robot stands; on the screen from the start."""

LAST_LINE = ("QUIT", "EXIT")
"""In the linear mode it reports the lines that did not run; both ask about unsaved lines."""
UNANSWERED = ("SAVE LOG", "SALVAR REGISTRO", "REPLACE")
"""Escape at their question takes what the linear mode offers, and the screen leaves it."""
ELSEWHERE = re.compile(r"Only in the (full screen: type VISUAL|linear mode: type LINEAR)\.")
"""The answer to a setting of the other front end."""

_WAITING_LINES = re.compile(
    r"RUN runs (all \d+ lines|the line) again\.|From the start again\."
    r"|\d+ lines? waits?\. DELETE drops (it|them)\."
)
"""What only a mode in which lines wait has to say."""
_COUNT = re.compile(r"\d+ answers so far\.")
"""The greetings of the two differ, so their answers before the first line do."""
_HOLD = re.compile(r"Enter continues\. RUN runs the rest\. STOP ends\.")
"""At the prompt of a held program Enter means something else than elsewhere."""
_END_OF_PROGRAM = ("The program is done.", "O programa terminou.")
"""In the linear mode the prompt says it."""
_NAME = re.compile(r"(?<=<run_started )program=.*?, (?=world=)")
"""What a program is called that has no file: compared once, and not with every run."""
_FRESH = re.compile(r"fresh=\w+, ")
_HOW_TO_ANSWER = re.compile(r"(,? (y or n|yes or no)| Enter means ).*")
"""How a question is answered is another matter at a prompt than in a dialog."""
_NUMBER = re.compile(r"\d+: ")
"""The linear mode numbers the rows from which something is chosen; on the screen one goes to them."""


AT_CURSOR = "held: COMMENT"
"""About the line of the cursor, which on a screen goes to where the program is held."""
_COMMENTED = re.compile(r"Line \d: -- .+")


def is_same(case: str, line: str, linear: Outcome, screen: Outcome) -> bool:
    """Whether the two agree in what the line comes to, as far as the rules want it."""
    if line in PANES:
        return bool(linear.published) and not screen.published and not screen.asked
    if any(ELSEWHERE.fullmatch(each) for each in (*linear.published, *screen.published)):
        return line.startswith("SET ") and linear.published != screen.published
    if line in OF_ITSELF and linear.published != screen.published:
        return bool(linear.published) and bool(screen.listed)
    if line in GONE_TO and screen.listed:
        return bool(linear.published) and not screen.published
    if line in CHOSEN_FROM_A_LIST:
        return bool(linear.published) and bool(screen.listed) and not screen.published
    if case in OF_WAITING_LINES:
        return True
    if case == AT_CURSOR:
        return all(_COMMENTED.fullmatch("\n".join(each.published)) for each in (linear, screen))
    if line in ("LINEAR", "VISUAL"):
        there, here = (screen, linear) if line == "LINEAR" else (linear, screen)
        return there.left_for == "other mode" and not here.left_for and bool(here.published)
    if not case.startswith("name of a program"):
        linear, screen = _without_name(linear), _without_name(screen)
    linear, screen = _plain(linear), _plain(screen)
    if line in LAST_LINE:
        return linear.asked == screen.asked
    if line in UNANSWERED:
        return (linear.asked, linear.published) == (screen.asked, screen.published)
    if line == "STOP ALL":  # the answer may come before the programs have ended
        return sorted(linear.published) == sorted(screen.published)
    if screen.listed and set(screen.listed) <= set(screen.published):
        screen = replace(screen, asked="", listed=())  # a list of the lines that were just published
    if not screen.listed:
        return _as_published(line, linear) == _as_published(line, screen)
    return _is_same_list(line, linear, screen)


def _without_name(outcome: Outcome) -> Outcome:
    """Without the name of the program that began."""
    return replace(outcome, published=tuple(_NAME.sub("", each) for each in outcome.published))


def _plain(outcome: Outcome) -> Outcome:
    """Without what belongs to one front end alone."""
    return replace(
        outcome,
        published=tuple(
            _COUNT.sub("Some answers so far.", each)
            for each in outcome.published
            if not (_WAITING_LINES.fullmatch(each) or _HOLD.fullmatch(each))
        ),
        asked=_HOW_TO_ANSWER.sub("", outcome.asked).rstrip("?:. "),
    )


def _as_published(line: str, outcome: Outcome) -> tuple[str, ...]:
    published = tuple(each for each in outcome.published if each not in _END_OF_PROGRAM)
    if line.startswith(OF_WAITING_OR_ALL):
        published = tuple(_FRESH.sub("", each) for each in published)
    return replace(outcome, published=published).as_text()


def _is_same_list(line: str, linear: Outcome, screen: Outcome) -> bool:
    """Rows on the screen are lines in the linear mode: all of them, in their order, perhaps said shorter."""
    if screen.published:
        return False
    if line.startswith("TYPED"):  # the screen lists the newest first, and the linear mode last
        return {_NUMBER.sub("", each) for each in linear.published} >= set(screen.listed)
    printed = [_NUMBER.sub("", each) for each in linear.published]
    rows = [_NUMBER.sub("", each) for each in screen.listed]
    starts = range(len(printed) - len(rows) + 1)
    return any(all(map(_begins_with, rows, printed[at : at + len(rows)])) for at in starts)


def _begins_with(row: str, line: str) -> bool:
    return row.startswith(line.removesuffix(" You are here.").rstrip("."))
