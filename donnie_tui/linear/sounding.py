"""QUIET and CUES in the linear mode: what sounds is waited for, and every key goes on."""

from __future__ import annotations

from donnie_tui.linear.arguments import Handler, alone
from donnie_tui.linear.desk import Desk
from donnie_tui.linear.runs import Runs
from donnie_tui.words import sound_words


def _quiet(desk: Desk) -> None:
    """LAST still means what was being said."""
    if desk.session.run is None:
        sound_words.quiet(desk.donnie)
        desk.showing.is_repeating = True
    else:
        desk.donnie.outlets.audible.hush_all()
        desk.showing.print_now("quiet")


def _cues(desk: Desk, _: Runs, rest: str) -> None:
    for seconds in sound_words.play_cues(desk.donnie, rest):
        desk.showing.show_told()
        if is_disturbed(desk, seconds):
            break


def is_disturbed(desk: Desk, seconds: float) -> bool:
    """Wait so long. Whether somebody wants something else before."""
    console = desk.console
    until = console.now() + seconds
    while (left := until - console.now()) > 0:
        if console.wait(left, reading=desk.is_attended) or console.take_interrupt():
            return True
        if console.leaving is not None:
            return True
    return False


HANDLERS: dict[str, Handler] = {"quiet": alone(_quiet), "cues": _cues}
