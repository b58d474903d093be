"""The full screen from its first start to the end: through other worlds, and to the linear mode.

However the screen ends, nothing of it keeps running. Exceptions are raised once the terminal is given
back.
"""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING

from textual.events import Event

from donnie_tui.settings.parsing import is_far
from donnie_tui.settings.settings import Settings
from donnie_tui.tui.app import DonnieApp
from donnie_tui.tui.environment import print_last_lines, wants_mouse
from donnie_tui.tui.shutdown import CRASHED

if TYPE_CHECKING:
    from donnie_tui.bootstrap import Donnie
    from donnie_tui.robot.search import Search
    from donnie_tui.tui.controller import ScreenState

SWITCH = 0.0002
"""Seconds that a computing program may keep the interpreter from the screen. A key passes from thread to
thread some five times until it is seen, so Python's own 0.005 would be felt."""


def run_full_screen(
    settings: Settings, file: str | None, *, text: str | None = None, donnie: Donnie | None = None
) -> int:
    """Run the full screen until the learner leaves. Returns the exit code.

    ``text`` is the program that the other mode left, if any, ``donnie`` its session. Raises
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
    restored: ScreenState | None = None
    typed = list[Event]()
    while True:
        app = _shown(settings, file, text, donnie, restored, typed)
        if app.shutdown.left is not None or not app.session.next_world:
            break
        settings, restored = _in_next_world(app)
        typed = app.keys_not_taken()
        file = text = donnie = None
    print_last_lines(app.main_screen.log_rows.lines)
    code = CRASHED if app.return_code == CRASHED else app.return_value or 0
    if app.shutdown.left is not None:  # it may have come after the screen began to leave for a world
        code = 128 + app.shutdown.left[0]
    return app.session.code_at_end(code, print)


def _shown(
    settings: Settings,
    file: Path | None,
    text: str | None,
    donnie: Donnie | None,
    restored: ScreenState | None,
    typed: list[Event],
) -> DonnieApp:
    """Show the screen until the learner leaves it. Raises as ``run_full_screen``."""
    search = _pending_search() if donnie is None and _takes_time(settings) else None
    app = DonnieApp(
        settings,
        file,
        text=text,
        assemble=lambda: donnie or _assembled(settings, search),
        search=search,
        restored=restored,
        typed=typed,
    )
    try:
        app.run(mouse=wants_mouse(settings))
    except BaseException:
        app.session.close()
        raise
    finally:
        app.shutdown.end_watchdog()
    has_failed = app.startup.trouble is not None or app.return_code == CRASHED
    if app.session.left_for_linear and not has_failed:
        _switch(app)
    app.shutdown.close_session()
    if app.startup.trouble is not None:
        raise app.startup.trouble
    return app


def _in_next_world(app: DonnieApp) -> tuple[Settings, ScreenState]:
    """The settings for the next world, and the screen's state to keep."""
    from donnie_tui.commands.world import settings_there

    controller = app.controller
    assert controller is not None  # it asked for that world
    settings = settings_there(controller.donnie, controller.ctx.preferences.settings, app.session.next_world)
    return settings, controller.state


def _takes_time(settings: Settings) -> bool:
    """Whether the start searches for a real robot, which a configuration file may ask for, too."""
    return is_far(settings.robot) or settings.world.endswith(".cfg")


def _pending_search() -> Search:
    from donnie_tui.robot.search import Search

    return Search(is_pending=True)


def _assembled(settings: Settings, search: Search | None) -> Donnie:
    from donnie_tui.bootstrap import assemble

    return assemble(settings, terminal=True, is_linear=False, search=search)


def _switch(app: DonnieApp) -> None:
    from donnie_tui.commands.interaction import SwitchMode

    path = app.controller.workspace.document.path if app.controller is not None else None
    donnie = app.controller.hand_over() if app.controller is not None else None
    raise SwitchMode(app.main_screen.editor.text, str(path) if path else None, donnie)
