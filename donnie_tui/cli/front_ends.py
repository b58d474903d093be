"""``donnie``: starts the linear mode or the full screen, and changes between them as often as wanted."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from devices.ports.values import mutable, replace
from donnie_tui.cli.mode import cause_of_linear, surroundings
from donnie_tui.cli.order import Order
from donnie_tui.settings.chosen import Settings
from donnie_tui.words.switching import SwitchMode

if TYPE_CHECKING:
    from donnie_tui.bootstrap import Donnie
    from donnie_tui.linear.greeting import Greeting


@mutable
class _Luggage:
    """What goes along from one mode to the other."""

    file: Path | None
    greeting: Greeting | None
    """The linear mode's, of this process."""
    text: str | None = None
    """The program that was left; without it ``file`` is read."""
    donnie: Donnie | None = None


def start(order: Order) -> int:
    """Stay until the learner leaves for good; the exit code is the front end's."""
    arguments = order.invocation.arguments
    settings = replace(order.settings, plain=True) if arguments.plain else order.settings
    option = True if arguments.linear else False if arguments.visual else None
    cause = cause_of_linear(option, settings.linear, surroundings(order.environment))
    along = _Luggage(Path(arguments.file) if arguments.file else None, order.greeting)
    while True:
        try:
            return _see(settings, along) if cause is None else _talk(settings, cause, along)
        except SwitchMode as switch:
            cause = None if cause else "word"
            along.file = Path(switch.name) if switch.name else None
            along.text, along.donnie = switch.text, switch.donnie


def _see(settings: Settings, along: _Luggage) -> int:
    from donnie_tui.tui.terminal import prepare

    prepare(settings)
    from donnie_tui.tui.full_screen import run_full_screen

    return run_full_screen(settings, along.file, text=along.text, donnie=along.donnie)


def _talk(settings: Settings, cause: str, along: _Luggage) -> int:
    from donnie_tui.linear.app import run_linear
    from donnie_tui.linear.greeting import Greeting

    along.greeting = along.greeting or Greeting()
    return run_linear(settings, along.file, cause, along.greeting, text=along.text, donnie=along.donnie)
