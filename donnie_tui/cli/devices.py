"""``donnie devices``: the serial ports, what answers there, and what to do about those that can't be used."""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import ThreadPoolExecutor
from functools import partial

from devices.port_listing import FoundPort, list_ports
from devices.port_talk.asking import Answer, Found, ask
from devices.serial_port import PortProblem
from devices.wire.link_config import LinkConfig
from donnie_tui.cli import codes
from donnie_tui.cli.order import Order
from donnie_tui.i18n.words import Words
from donnie_tui.robot.choice import sentences_of

MOST_AT_ONCE = 8
"""Ports that are asked at the same time; each takes some seconds."""


def list_devices(
    order: Order,
    found: Callable[[], tuple[FoundPort, ...]] = list_ports,
    asked: Callable[..., Found] = ask,
) -> int:
    """A line a port. The exit code is 2 if a port that was named can't be used."""
    named: list[str] = order.invocation.arguments.port
    plugged = () if named else found()
    ports = named or [each.stable for each in plugged if each.is_board]
    if ports:
        order.output.line(order.words("devices-asking", count=len(ports)))
    problems = list(_tell_all(ports, asked, order))
    for each in plugged:
        if not each.is_board:
            order.output.line(order.words("device-other", port=each.stable))
    if not (ports or plugged):
        order.output.line(order.words("devices-none"))
    return codes.UNUSABLE if named and any(problems) else codes.DONE


def _tell_all(ports: Iterable[str], asked: Callable[..., Found], order: Order) -> Iterator[bool]:
    """Whether each can't be used, in their order. Ctrl+C gives all of them up."""
    ended = threading.Event()
    asking = partial(asked, is_given_up=ended.is_set)
    with ThreadPoolExecutor(MOST_AT_ONCE) as pool:
        try:
            for lines, is_problem in pool.map(partial(_answer, asking, order.words), ports):
                for line in lines:
                    order.output.line(line)
                yield is_problem
        finally:
            ended.set()


def _answer(asked: Callable[[str], Found], words: Words, port: str) -> tuple[tuple[str, ...], bool]:
    try:
        return _lines(port, asked(port), words), False
    except PortProblem as problem:
        return sentences_of(problem, words), True


def _lines(port: str, found: Found, words: Words) -> tuple[str, ...]:
    match found:
        case Found(Answer.ROBOT, None):
            told = words("device-robot-unknown", port=port)
        case Found(Answer.ROBOT, int(millivolts)):
            low = "-low" if millivolts < LinkConfig().battery_low else ""
            told = words(f"device-robot{low}", port=port, volts=millivolts / 1000)
        case Found(Answer.BELT):
            return words("device-belt", port=port), words("devices-use-belt", port=port)
        case _:
            return (words(f"device-{found.answer.value}", port=port),)
    return told, words("devices-use", port=port)
