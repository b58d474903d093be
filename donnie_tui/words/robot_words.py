"""What the words about robot and belt do, for both front ends: CONNECT and FEEL. Answers go to the hub."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path

from donnie_tui.bootstrap import Donnie
from donnie_tui.core.documents import DocumentError, exists
from donnie_tui.core.session import Busy
from donnie_tui.core.typed_words import switched
from donnie_tui.robot.choice import Choice
from donnie_tui.settings.devices import SIMULATED
from donnie_tui.settings.file import remember
from language.source import fold_name

_ROWS = {"rows", "motors", "fileiras", "motores", "filas"}
_MOST_DIGITS = 4


def connect(donnie: Donnie, typed: str, show: Callable[[], object] = lambda: None) -> None:
    """Take the robot of that number, or for anything else tell which may be chosen.

    Connecting takes some seconds: ``show`` is called before, so that what was told so far is not late.
    """
    if typed.isdecimal() and len(typed) <= _MOST_DIGITS:
        _choose(donnie, int(typed), show)
    else:
        _tell_choices(donnie)


def feel(donnie: Donnie, typed: str) -> None:
    """Tell what the belt shows, with ROWS each motor; with ON and OFF from now on every change, or none."""
    telling, is_on = donnie.outlets.belt, switched(typed)
    if is_on is not None:
        telling.is_on = is_on
        donnie.say("belt-words-on" if is_on else "belt-words-off")
    elif fold_name(typed) in _ROWS:
        donnie.tell(*telling.rows())
    else:
        donnie.tell(telling.now())


def choices_in_words(donnie: Donnie) -> tuple[tuple[str, bool], ...]:
    """What may be chosen, in the order of the numbers: what it is and its state, and whether it is there now.

    Looks for devices: not to be asked in a hurry.
    """
    now = donnie.connection.robot
    return tuple(
        (_choice_in_words(donnie, number, choice), choice.robot == now)
        for number, choice in enumerate(donnie.connection.choices(), 1)
    )


def _choice_in_words(donnie: Donnie, number: int, choice: Choice) -> str:
    port = choice.robot.partition(":")[2]
    if choice.robot == donnie.connection.robot:
        code = "connect-choice-now"
    elif port and not exists(Path(port)):
        code = "connect-choice-missing"
    elif port and not os.access(port, os.R_OK | os.W_OK):
        code = "connect-choice-forbidden"
    else:
        code = "connect-choice"
    return donnie.words(code, number=number, what=choice.sentence)


def _tell_choices(donnie: Donnie) -> None:
    donnie.tell(*(sentence for sentence, _is_now in choices_in_words(donnie)))
    donnie.say("connect-how")


def _choose(donnie: Donnie, number: int, show: Callable[[], object]) -> None:
    choices = donnie.connection.choices()
    if not 1 <= number <= len(choices):
        donnie.say("connect-unknown", number=number)
        return
    robot = choices[number - 1].robot
    if robot != SIMULATED:
        donnie.connection.search.expect()
        donnie.connection.search.on_slow = lambda: _tell_slow(donnie, show)
        donnie.say("connect-trying")
        show()
    try:
        missing = donnie.connection.connect(robot)
    except Busy:
        donnie.say("connect-busy")
        return
    donnie.tell(*missing)
    if not missing:
        _connected(donnie)


def _tell_slow(donnie: Donnie, show: Callable[[], object]) -> None:
    donnie.say("connect-waiting")
    show()


def _connected(donnie: Donnie) -> None:
    """That a real one is there, its link has told."""
    if donnie.connection.robot == SIMULATED:
        donnie.say("connect-simulator")
    try:
        remember("robot", donnie.connection.robot, os.environ)
    except DocumentError as problem:
        donnie.say(problem.code, path=problem.path, reason=problem.reason)
