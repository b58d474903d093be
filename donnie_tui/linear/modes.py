"""The way to the full screen, which takes everything along, the robot where it stands."""

from __future__ import annotations

import os

from donnie_tui.commands.interaction import SwitchMode
from donnie_tui.core.program_files import DocumentError
from donnie_tui.linear.desk import Desk
from donnie_tui.settings.file import remember


def switch_to_screen(desk: Desk) -> None:
    """Raises ``SwitchMode``, unless there is no screen."""
    if not desk.ends.has_terminal:
        desk.answer("linear-no-screen")
        return
    offer_to_remember(desk, linear=False)
    if desk.console.leaving is not None:
        return
    desk.ctx.runs.stop_to_leave()
    desk.showing.show_told()
    raise SwitchMode(desk.program.text, str(desk.program.path or "") or None, desk.donnie)


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
        desk.answer(error.code, path=error.path, reason=error.reason)
    else:
        desk.answer("mode-remembered")
