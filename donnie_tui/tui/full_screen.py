"""The full screen from its first start to the end: through other worlds, and to the linear mode.

Rule: whatever the screen ends with, nothing of it is left running, and what it could not do is raised once
the terminal is given back.
"""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING

from donnie_tui.robot.search import Search
from donnie_tui.settings.parsing import SERIAL
from donnie_tui.settings.settings import Settings
from donnie_tui.tui.app import DonnieApp
from donnie_tui.tui.environment import wants_mouse

if TYPE_CHECKING:
    from donnie_tui.bootstrap import Donnie
    from donnie_tui.tui.brought import Brought

SWITCH = 0.0002
"""Seconds that a program which computes may keep the interpreter from the screen. A key passes from thread to
thread some five times until it is seen, so Python's own 0.005 would be felt."""

CRASHED = 1
"""Textual's return code after a fault of ours; the text is kept for the next start."""


def run_full_screen(
    settings: Settings, file: str | None, *, text: str | None = None, donnie: Donnie | None = None
) -> int:
    """Work at the screen until the learner leaves; the exit code.

    ``text`` is the program that the other mode left, where it did, ``donnie`` its session. Raises
    ``SwitchMode`` if the learner goes to the linear mode, ``Unusable`` if the world or a device can't be
    used.
    """
    found = sys.getswitchinterval()
    sys.setswitchinterval(SWITCH)
    try:
        return _through_worlds(settings, Path(file) if file else None, text, donnie)
    finally:
        sys.setswitchinterval(found)


def _through_worlds(settings: Settings, file: Path | None, text: str | None, donnie: Donnie | None) -> int:
    if donnie:
        donnie.outlets.audible.move_to(is_linear=False)
    brought: Brought | None = None
    while True:
        app = _shown(settings, file, text, donnie, brought)
        if not app.next_world:
            break
        settings, brought = _in_next_world(app)
        file = text = donnie = None
    from donnie_tui.tui.outside import leave_behind

    leave_behind(app.workplace.log_rows.lines)
    return CRASHED if app.return_code == CRASHED else app.return_value or 0


def _shown(
    settings: Settings,
    file: Path | None,
    text: str | None,
    donnie: Donnie | None,
    brought: Brought | None,
) -> DonnieApp:
    """The screen until it is left. Raises as ``run_full_screen`` does."""
    search = Search(is_pending=True) if donnie is None and _takes_time(settings) else None
    app = DonnieApp(
        settings,
        file,
        text=text,
        assemble=lambda: donnie or _assembled(settings, search),
        search=search,
        brought=brought,
    )
    try:
        app.run(mouse=wants_mouse(settings))
    except BaseException:
        app.close_session()
        raise
    finally:
        app.ending.end_lifeline()
    has_failed = app.trouble is not None or app.return_code == CRASHED
    if app.left_for_linear and not has_failed:
        _switch(app)
    app.close_session()
    if app.trouble is not None:
        raise app.trouble
    return app


def _in_next_world(app: DonnieApp) -> tuple[Settings, Brought]:
    """The settings as they were chosen, and what is kept on the way there."""
    from donnie_tui.commands.world import settings_there

    assert app.work is not None  # it went there
    settings = settings_there(app.work.donnie, app.work.ctx.preferences.settings, app.next_world)
    return settings, app.work.brought_along()


def _takes_time(settings: Settings) -> bool:
    """Whether a real robot is looked for, as a configuration file may ask for one too."""
    return settings.robot.startswith(SERIAL) or settings.world.endswith(".cfg")


def _assembled(settings: Settings, search: Search | None) -> Donnie:
    from donnie_tui.bootstrap import assemble

    return assemble(settings, terminal=True, is_linear=False, search=search)


def _switch(app: DonnieApp) -> None:
    from donnie_tui.commands.interaction import SwitchMode

    path = app.work.workspace.document.path if app.work is not None else None
    donnie = app.work.hand_over() if app.work is not None else None
    raise SwitchMode(app.workplace.editor.text, str(path) if path else None, donnie)
