"""``donnie devices`` and ``donnie stop``.

``devices`` lists the serial ports, the devices that answer, and remedies for unusable ports. It offers
to stop a robot that drives. ``stop`` halts a robot whose program is gone; a service manager can call it too.
"""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from time import monotonic
from typing import Any

from devices.board_reset import GpioReset, reset_of
from devices.port_exchange import (
    RETURNS,
    TRIES,
    DeviceKind,
    HaltOutcome,
    IdentifiedDevice,
    halt,
    halt_when_back,
    identify,
)
from devices.serial_ports import FoundPort, PortProblem, list_ports, pause
from devices.wire.link_state import LinkConfig
from donnie_tui.cli.options import ExitCode, Order
from donnie_tui.cli.streams import Input
from donnie_tui.commands.interaction import answered
from donnie_tui.i18n.words import Unusable, Words
from donnie_tui.process.signals import timeout_factor
from donnie_tui.robot.search import find_port, sentences_of
from donnie_tui.settings.settings import Settings

MOST_AT_ONCE = 8
"""Ports that are asked at the same time; each takes some seconds."""


def list_devices(
    order: Order,
    found: Callable[[], tuple[FoundPort, ...]] = list_ports,
    asked: Callable[..., IdentifiedDevice] = identify,
    halted: Callable[..., HaltOutcome] = halt,
) -> int:
    """Print a line a port. The exit code is 2 if a named port can't be used, 1 if a robot drives on."""
    named: list[str] = order.invocation.arguments.port
    plugged = () if named else found()
    ports = named or [each.stable for each in plugged if each.is_board]
    if ports:
        order.output.line(order.words("devices-asking", count=len(ports)))
    driving: list[str] = []

    def ask(port: str, **how: Any) -> IdentifiedDevice:
        found = asked(port, factor=timeout_factor(), **how)
        if found.is_driving:
            driving.append(port)
        return found

    problems = list(_describe_all(ports, ask, order))
    for each in plugged:
        if not each.is_board:
            order.output.line(order.words("device-other", port=each.stable))
    if not (ports or plugged):
        order.output.line(order.words("devices-none"))
    driving_on = [each for each in ports if each in driving and not _is_stopped(each, order, halted)]
    if named and any(problems):
        return ExitCode.UNUSABLE
    return ExitCode.FAILED if driving_on else ExitCode.DONE


def _is_stopped(port: str, order: Order, halted: Callable[..., HaltOutcome]) -> bool:
    """Offer to stop the robot that drives there; without a person, say how to do it."""
    typed = Input()
    if typed.is_terminal:
        order.output.line(order.words("devices-ask-stop", port=port))
        if answered(typed.line() or ""):
            return _halt_and_report(port, order, halted) is ExitCode.DONE
    order.output.line(order.words("devices-stop", port=port))
    return False


def _describe_all(ports: Iterable[str], ask: Callable[..., IdentifiedDevice], order: Order) -> Iterator[bool]:
    """Describe each port in order; yields whether it is unusable. Ctrl+C gives up all of them."""
    ended = threading.Event()
    asking = partial(ask, is_given_up=ended.is_set)
    with ThreadPoolExecutor(MOST_AT_ONCE) as pool:
        try:
            for lines, is_problem in pool.map(partial(_answer, asking, order.words), ports):
                for line in lines:
                    order.output.line(line)
                yield is_problem
        finally:
            ended.set()


def _answer(
    asked: Callable[[str], IdentifiedDevice], words: Words, port: str
) -> tuple[tuple[str, ...], bool]:
    try:
        return _lines(port, asked(port), words), False
    except PortProblem as problem:
        return sentences_of(problem, words), True


def _lines(port: str, found: IdentifiedDevice, words: Words) -> tuple[str, ...]:
    match found:
        case IdentifiedDevice(DeviceKind.ROBOT, is_driving=True):
            return (words("device-robot-drives", port=port),)
        case IdentifiedDevice(DeviceKind.ROBOT, None):
            sentence = words("device-robot-unknown", port=port)
        case IdentifiedDevice(DeviceKind.ROBOT, int(millivolts)):
            low = "-low" if millivolts < LinkConfig().battery_low else ""
            sentence = words(f"device-robot{low}", port=port, volts=millivolts / 1000)
        case IdentifiedDevice(DeviceKind.BELT):
            return words("device-belt", port=port), words("devices-use-belt", port=port)
        case _:
            return (words("device-nothing", port=port),)
    return sentence, words("devices-use", port=port)


_CODE_OF = {
    HaltOutcome.STANDS: ExitCode.DONE,
    HaltOutcome.DRIVES: ExitCode.FAILED,
    HaltOutcome.UNCONFIRMED: ExitCode.FAILED,
    HaltOutcome.IN_USE: ExitCode.FAILED,
}
"""The exit codes; only a robot that certainly stands counts as stopped."""


def stop(
    order: Order,
    halted: Callable[..., HaltOutcome] = halt,
    pause: Callable[[float], object] = pause,
) -> int:
    """Stop the robot, and report its state. ``--wait`` waits for its port."""
    waits = order.invocation.arguments.wait
    port = order.invocation.arguments.port or _found(order, pause)
    return _halt_and_report(port, order, halted, pause=pause if waits else None)


def _found(order: Order, pause: Callable[[float], object]) -> str:
    """The robot's port; with ``--wait``, once there is one."""
    ends = monotonic() + RETURNS if order.invocation.arguments.wait else 0.0
    is_reported = False
    while True:
        try:
            return find_port(order.settings, order.words, remedy="remedy-switch-off")
        except Unusable:
            if monotonic() >= ends:
                raise
        if not is_reported:
            order.output.line(order.words("stop-waiting-any"))
        is_reported = True
        pause(TRIES)


def _halt_and_report(
    port: str,
    order: Order,
    halted: Callable[..., HaltOutcome],
    *,
    pause: Callable[[float], object] | None = None,
) -> ExitCode:
    """Stop the robot at a port. ``pause`` waits between attempts. Raises ``Unusable``."""

    def stop_now() -> HaltOutcome:
        by_force = partial(_pull_pin, order.settings, port)
        return halted(port, by_force=by_force, factor=timeout_factor())

    def report() -> None:
        order.output.line(order.words("stop-waiting", port=port))

    try:
        outcome = halt_when_back(stop_now, pause=pause, on_absent=report) if pause else stop_now()
    except PortProblem as problem:
        raise Unusable(" ".join(sentences_of(problem, order.words))) from None
    order.output.line(order.words(f"stop-{outcome.value}", port=port))
    return _CODE_OF[outcome]


def _pull_pin(settings: Settings, port: str) -> bool:
    """Reset the board by the pin; a reset by DTR was done when the port was opened."""
    reset = reset_of(settings.reset_line, port)
    return isinstance(reset, GpioReset) and reset.pull(None, pause)
