"""``donnie``: starts the linear mode or the full screen, and changes between them as often as wanted."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from devices.ports.values import replace
from donnie_tui.cli.mode import cause_of_linear, surroundings
from donnie_tui.cli.order import Order
from donnie_tui.settings.chosen import Settings
from donnie_tui.words.switching import SwitchMode

if TYPE_CHECKING:
    from donnie_tui.bootstrap import Donnie


def start(order: Order) -> int:
    """Stay until the learner leaves for good; the exit code is the front end's."""
    arguments = order.invocation.arguments
    settings = replace(order.settings, plain=True) if arguments.plain else order.settings
    option = True if arguments.linear else False if arguments.visual else None
    cause = cause_of_linear(option, settings.linear, surroundings(order.environment))
    file = Path(arguments.file) if arguments.file else None
    text: str | None = None
    donnie: Donnie | None = None
    while True:
        try:
            return _work(settings, file, cause, text, donnie)
        except SwitchMode as switch:
            cause = None if cause else "word"
            file, text = Path(switch.name) if switch.name else None, switch.text
            donnie = switch.donnie


def _work(
    settings: Settings, file: Path | None, cause: str | None, text: str | None, donnie: Donnie | None
) -> int:
    """``text`` and ``donnie`` are what the other mode left; without them ``file`` is read."""
    if cause is None:
        from donnie_tui.tui.terminal import prepare

        prepare(settings)
        from donnie_tui.tui.full_screen import run_full_screen

        return run_full_screen(settings, file, text=text, donnie=donnie)
    from donnie_tui.linear.app import run_linear

    return run_linear(settings, file, cause, text=text, donnie=donnie)
