"""What the linear mode does for each use case. Words, arguments and purposes are the use cases' own."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeAlias

from donnie_tui import robot_words
from donnie_tui.bootstrap import SwitchMode
from donnie_tui.core import use_cases
from donnie_tui.core.session import Busy
from donnie_tui.core.use_cases import UseCase
from donnie_tui.linear import choices, files, lines, surroundings
from donnie_tui.linear.desk import Desk
from donnie_tui.linear.runs import Runs

LARGEST_NUMBER = 10_000_000
"""No program has so many lines, and no session so many answers."""

Handler: TypeAlias = Callable[[Desk, Runs, str], bool | None]
"""Does the word with what stands behind it. False if that can't be understood."""


# --- what the words do


def _open(desk: Desk, _: Runs, rest: str) -> bool:
    if rest:
        files.open_named(desk, rest)
    return bool(rest)


def _save(desk: Desk, _: Runs, rest: str) -> None:
    files.save_named(desk, rest)


def _new(desk: Desk, _: Runs, rest: str) -> bool:
    if not rest:
        files.new_program(desk)
    return not rest


def _recover(desk: Desk, _: Runs, rest: str) -> bool:
    if not rest:
        files.recover(desk)
    return not rest


def _list(desk: Desk, _: Runs, rest: str) -> bool:
    given = _numbers(rest, most=2)
    if given is not None:
        lines.list_lines(desk, *_pair(given))
    return given is not None


def _delete(desk: Desk, _: Runs, rest: str) -> bool:
    given = _numbers(rest, most=2)
    if given is not None:
        lines.delete_lines(desk, *_pair(given))
    return given is not None


def _change(desk: Desk, _: Runs, rest: str) -> bool:
    number, text = _number_and_text(rest)
    if number is not None:
        lines.change_line(desk, number, text)
    return number is not None


def _insert(desk: Desk, _: Runs, rest: str) -> bool:
    number, text = _number_and_text(rest)
    if number is not None:
        lines.insert_line(desk, number, text)
    return number is not None


def _again(_: Desk, runs: Runs, rest: str) -> bool:
    if not rest:
        runs.run_all()
    return not rest


def _step(_: Desk, runs: Runs, rest: str) -> bool:
    if not rest:
        runs.run_waiting(stepping=True)
    return not rest


def _stop(desk: Desk, _: Runs, rest: str) -> bool:
    if not rest:
        desk.answer("linear-nothing-to-stop")
    return not rest


def _reset(desk: Desk, _: Runs, rest: str) -> bool:
    if not rest:
        try:
            desk.session.reset()
        except Busy:
            return False
        desk.answer("answer-reset")
    return not rest


def _where(desk: Desk, _: Runs, rest: str) -> bool:
    if not rest:
        surroundings.say_where(desk)
    return not rest


def _map(desk: Desk, _: Runs, rest: str) -> bool:
    if not rest:
        surroundings.say_map(desk)
    return not rest


def _map_picture(desk: Desk, _: Runs, rest: str) -> bool:
    if not rest:
        surroundings.draw_map(desk)
    return not rest


def _world(desk: Desk, _: Runs, rest: str) -> bool:
    if not rest:
        surroundings.say_world(desk)
    return not rest


def _speed(desk: Desk, _: Runs, rest: str) -> bool:
    return choices.set_speed(desk, rest)


def _language(desk: Desk, _: Runs, rest: str) -> bool:
    return choices.set_language(desk, rest)


def _detail(desk: Desk, _: Runs, rest: str) -> bool:
    return choices.set_detail(desk, rest)


def _last(desk: Desk, _: Runs, rest: str) -> bool:
    given = _numbers(rest, most=1)
    if given is not None:
        choices.say_again(desk, given[0] if given else 1)
    return given is not None


def _errors(desk: Desk, _: Runs, rest: str) -> bool:
    if not rest:
        choices.say_errors(desk)
    return not rest


def _visual(desk: Desk, _: Runs, rest: str) -> bool:
    if rest:
        return False
    if desk.can_edit:
        desk.show_told()
        raise SwitchMode(desk.program.text, desk.program.name)
    desk.answer("linear-no-screen")
    return True


def _linear(desk: Desk, _: Runs, rest: str) -> bool:
    if not rest:
        desk.answer("linear-linear")
    return not rest


def _connect(desk: Desk, _: Runs, rest: str) -> None:
    robot_words.connect(desk.donnie, rest, desk.show_told)


def _feel(desk: Desk, _: Runs, rest: str) -> None:
    robot_words.feel(desk.donnie, rest)


HANDLERS: dict[str, Handler] = {
    "open": _open,
    "save": _save,
    "save_as": _save,
    "new": _new,
    "recover": _recover,
    "list": _list,
    "change": _change,
    "insert": _insert,
    "delete": _delete,
    "again": _again,
    "step": _step,
    "stop": _stop,
    "reset": _reset,
    "where": _where,
    "map": _map,
    "map_picture": _map_picture,
    "connect": _connect,
    "feel": _feel,
    "world": _world,
    "speed": _speed,
    "language": _language,
    "detail": _detail,
    "last": _last,
    "errors": _errors,
    "visual": _visual,
    "linear": _linear,
}
"""What each use case does here. RUN, HELP and QUIT are the conversation's own."""

OF_CONVERSATION = ("run", "help", "quit")


def find(line: str) -> tuple[UseCase, str] | None:
    """What a line asks for, and what stands behind the word; None if the line is GoDonnie."""
    found = use_cases.find(line)
    return found if found and found[0].name in HANDLERS else None


def do(case: UseCase, rest: str, desk: Desk, runs: Runs) -> None:
    """Do it; if what stands behind the word can't be understood, show how it is said."""
    if HANDLERS[case.name](desk, runs, rest) is False:
        desk.answer("linear-like-this", example=use_cases.typed_form(case, desk.say))


def listed() -> tuple[UseCase, ...]:
    """What HELP tells of."""
    done = (*HANDLERS, *OF_CONVERSATION)
    return tuple(each for each in use_cases.USE_CASES if each.name in done and not each.hidden)


# --- what stands behind a word


def _numbers(rest: str, *, most: int) -> list[int] | None:
    """At most so many whole numbers, or None if there is anything else."""
    words = rest.replace(",", " ").split()
    if len(words) > most or not all(each.isdecimal() and len(each) < 9 for each in words):
        return None
    found = [int(each) for each in words]
    return found if all(each <= LARGEST_NUMBER for each in found) else None


def _pair(given: list[int]) -> tuple[int | None, int | None]:
    return (given[0] if given else None), (given[1] if len(given) > 1 else None)


def _number_and_text(rest: str) -> tuple[int | None, str]:
    word, _, text = rest.partition(" ")
    number = _numbers(word, most=1)
    return (number[0] if number else None), text.strip()
