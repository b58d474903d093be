"""What the linear mode does for each use case. Words, arguments and purposes are the use cases' own."""

from __future__ import annotations

from donnie_tui import robot_words
from donnie_tui.core import use_cases
from donnie_tui.core.use_cases import UseCase
from donnie_tui.core.view_cases import IN_WORDS, VIEW_CASES
from donnie_tui.linear import (
    choices,
    files,
    lines,
    mending,
    modes,
    reading,
    reports,
    robots,
    running,
    said,
    sounding,
    surroundings,
    tour,
)
from donnie_tui.linear.arguments import Handler
from donnie_tui.linear.desk import Desk
from donnie_tui.linear.runs import Runs


def _connect(desk: Desk, _: Runs, rest: str) -> None:
    robot_words.connect(desk.donnie, rest, desk.show_told)


def _feel(desk: Desk, _: Runs, rest: str) -> None:
    robot_words.feel(desk.donnie, rest)


HANDLERS: dict[str, Handler] = {
    **running.HANDLERS,
    **files.HANDLERS,
    **reports.HANDLERS,
    **lines.HANDLERS,
    **mending.HANDLERS,
    **reading.HANDLERS,
    **said.HANDLERS,
    **sounding.HANDLERS,
    **surroundings.HANDLERS,
    **robots.HANDLERS,
    "connect": _connect,
    "feel": _feel,
    **choices.HANDLERS,
    **tour.HANDLERS,
    **modes.HANDLERS,
}
"""What each use case does here. RUN, HELP and QUIT are the conversation's own."""

_ALL = (*use_cases.USE_CASES, *VIEW_CASES)
"""Of two words that begin alike the longer one counts: MAPA INTEIRO is no MAPA."""

OF_CONVERSATION = ("run", "help", "quit")


def find(line: str) -> tuple[UseCase, str] | None:
    """What a line asks for, and what stands behind the word; None if the line is GoDonnie."""
    found = use_cases.find(line)
    return found if found and found[0].name in HANDLERS else None


def answer_of_screen(line: str, desk: Desk) -> bool:
    """A word of the full screen is answered: what is typed here in its place. False if it is none."""
    found = use_cases.find(line, _ALL)
    is_of_screen = found is not None and found[0] in VIEW_CASES
    if found is not None and is_of_screen:
        choices.point_to(desk, IN_WORDS.get(found[0].name))
    return is_of_screen


def do(case: UseCase, rest: str, desk: Desk, runs: Runs) -> None:
    """Do it; if what stands behind the word can't be understood, show how it is said."""
    if HANDLERS[case.name](desk, runs, rest) is False:
        desk.answer("linear-like-this", example=use_cases.typed_form(case, desk.say))


def listed() -> tuple[UseCase, ...]:
    """What HELP tells of."""
    done = (*HANDLERS, *OF_CONVERSATION)
    return tuple(each for each in use_cases.USE_CASES if each.name in done and not each.hidden)
