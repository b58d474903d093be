"""LINEAR and VISUAL: the change to the full screen takes everything along, the robot where it stands."""

from __future__ import annotations

import os

from donnie_tui.core.documents import DocumentError
from donnie_tui.linear.arguments import Handler, alone
from donnie_tui.linear.desk import Desk
from donnie_tui.linear.files import refuse
from donnie_tui.settings.file import remember
from donnie_tui.words.switching import SwitchMode


def _linear(desk: Desk) -> None:
    desk.answer("linear-linear")


def _visual(desk: Desk) -> None:
    if not desk.ends.has_terminal:
        desk.answer("linear-no-screen")
        return
    offer_to_remember(desk, linear=False)
    if desk.console.leaving is not None:
        return
    desk.showing.show_told()
    raise SwitchMode(desk.program.text, desk.program.name, desk.donnie)


def offer_to_remember(desk: Desk, *, linear: bool) -> None:
    """Ask, once in a session, whether Donnie is to begin in this mode from now on."""
    offered = desk.ends.offered
    was_asked = linear in offered
    offered.add(linear)
    if was_asked or not desk.is_attended:
        return
    if not desk.asking.ask_yes("mode-ask-linear" if linear else "mode-ask-visual"):
        return
    try:
        remember("linear", linear, os.environ)
    except DocumentError as error:
        refuse(desk, error)
    else:
        desk.answer("mode-remembered")


HANDLERS: dict[str, Handler] = {"linear": alone(_linear), "visual": alone(_visual)}
