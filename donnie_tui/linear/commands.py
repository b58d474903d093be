"""What the linear mode does for each use case. Words, arguments and purposes are the use cases' own."""

from __future__ import annotations

from importlib import import_module

from devices.ports.hints import TYPE_CHECKING
from donnie_tui.core import use_cases
from donnie_tui.core.use_cases import UseCase
from donnie_tui.core.view_cases import IN_WORDS, VIEW_CASES

if TYPE_CHECKING:
    from donnie_tui.linear.arguments import Handler
    from donnie_tui.linear.desk import Desk
    from donnie_tui.linear.runs import Runs

_WORDS_OF = {
    "running": "again stop pause continue_ step step_over step_back run_to break_ watch show_variables "
    "slower faster speed reset",
    "files": "open save save_as new recover",
    "reports": "save_log report",
    "lines": "list show_program change insert delete move undo redo",
    "mending": "fix search search_again replace format translate manual",
    "reading": "read next back first last_line place up down next_same back_same outline",
    "said": "last last_word spell find show_log typed error error_next error_previous errors explain",
    "sounding": "quiet cues",
    "surroundings": "where around map show_map map_row map_column map_picture trail sensors",
    "going": "world worlds",
    "robots": "robots robot start together stop_all grip release connect feel",
    "choices": "language detail set",
    "tour": "tour",
    "modes": "linear visual",
}
"""By module, which is loaded with the first of its words: most conversations need two or three of them."""

HANDLED_IN = {name: module for module, names in _WORDS_OF.items() for name in names.split()}
"""What each use case does here, by module. RUN, HELP and QUIT are the conversation's own."""

_ALL = (*use_cases.USE_CASES, *VIEW_CASES)
"""Of two words that begin alike the longer one counts: MAPA INTEIRO is no MAPA."""

_SAME = {"settings": "set"}
"""What shows a list on the screen, and here is the word that says it."""

OF_CONVERSATION = ("run", "help", "quit")


def find(line: str) -> tuple[UseCase, str] | None:
    """What a line asks for, and what stands behind the word; None if the line is GoDonnie."""
    found = _same(line) or use_cases.find(line)
    return found if found and found[0].name in HANDLED_IN else None


def _same(line: str) -> tuple[UseCase, str] | None:
    view = use_cases.find(line, VIEW_CASES)
    same = _SAME.get(view[0].name) if view else None
    return (use_cases.BY_NAME[same], view[1]) if view and same else None


def is_probably_ours(line: str, desk: Desk) -> bool:
    """A line with a slip in a word of the terminal is answered with that word. False: it may be GoDonnie."""
    from donnie_tui.core.unknown_words import unknown_word

    language = desk.say.language
    unknown = unknown_word(line, desk.program.lines, use_cases.USE_CASES, language, desk.session.parse)
    if unknown is not None:
        desk.answer("help-unknown-near", topic=unknown.word, near=unknown.meant)
    return unknown is not None


def answer_of_screen(line: str, desk: Desk) -> bool:
    """A word of the full screen is answered: what is typed here in its place. False if it is none."""
    found = None if _same(line) else use_cases.find(line, _ALL)
    is_of_screen = found is not None and found[0] in VIEW_CASES
    if found is not None and is_of_screen:
        from donnie_tui.linear import choices

        choices.point_to(desk, IN_WORDS.get(found[0].name))
    return is_of_screen


def do(case: UseCase, rest: str, desk: Desk, runs: Runs) -> None:
    """Do it; if what stands behind the word can't be understood, show how it is said."""
    if _handler(case.name)(desk, runs, rest) is False:
        desk.tell(use_cases.not_understood(case, desk.say))


def say_help(desk: Desk, topic: str) -> None:
    """HELP with what stands behind it."""
    from donnie_tui.linear import choices

    choices.say_help(desk, topic, listed())


def _handler(name: str) -> Handler:
    handlers: dict[str, Handler] = import_module(f"donnie_tui.linear.{HANDLED_IN[name]}").HANDLERS
    return handlers[name]


def listed() -> tuple[UseCase, ...]:
    """What HELP tells of."""
    done = (*HANDLED_IN, *OF_CONVERSATION)
    return tuple(each for each in use_cases.USE_CASES if each.name in done and not each.hidden)
