"""``donnie stop``: halts a robot whose program is gone. Made to be called by a service manager too."""

from __future__ import annotations

from collections.abc import Callable
from threading import Event

from devices.port_talk.halting import Halted, halt
from devices.reset_line import GpioReset, reset_of
from devices.serial_port import PortProblem
from donnie_tui.cli import codes
from donnie_tui.cli.order import Order
from donnie_tui.i18n.words import Unusable
from donnie_tui.robot.choice import find_port, sentences_of
from donnie_tui.settings.chosen import Settings

_CODE_OF = {Halted.STANDS: codes.DONE, Halted.UNCONFIRMED: codes.FAILED, Halted.IN_USE: codes.FAILED}
"""Only a robot that is known to stand is one that was stopped."""


def stop(order: Order, halted: Callable[..., Halted] = halt) -> int:
    """Stop it, and say what is known of it."""
    port = order.invocation.arguments.port or find_port(
        order.settings, order.words, remedy="remedy-switch-off"
    )
    try:
        outcome = halted(port, by_force=lambda: _pull_pin(order.settings, port))
    except PortProblem as problem:
        raise Unusable(" ".join(sentences_of(problem, order.words))) from None
    order.output.line(order.words(f"stop-{outcome.value}", port=port))
    return _CODE_OF[outcome]


def _pull_pin(settings: Settings, port: str) -> bool:
    """DTR has done what it can when the port was opened."""
    reset = reset_of(settings.reset_line, port)
    return isinstance(reset, GpioReset) and reset.pull(None, Event().wait)
