"""From the command line to the exit code: read the settings, then carry out the command."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING

from msgspec import Struct
from msgspec.structs import replace

from donnie_tui.cli.options import (
    TO_COME,
    ExitCode,
    Invocation,
    Order,
    WrongUsage,
    language_before_parsing,
    understand,
)
from donnie_tui.cli.streams import Output
from donnie_tui.i18n.words import Unusable, Words
from donnie_tui.settings.file import read_settings
from donnie_tui.settings.settings import FRONT_END_SPEED, BadOption, Notice, Settings, resolve

if TYPE_CHECKING:
    from donnie_tui.linear.greeting import Greeting


class _Start(Struct, frozen=True):
    """What there is before a command is understood."""

    output: Output
    file: Mapping[str, object]
    """What the settings file says."""
    troubles: tuple[Notice, ...]
    """What is wrong with it."""
    greeting: Greeting | None


def main(arguments: list[str], greeting: Greeting | None = None) -> int:
    """Do it, and give the exit code. Prints; never raises for what the user did.

    ``greeting``: what the linear mode printed before anything was loaded.
    """
    start = _Start(Output(), *read_settings(os.environ), greeting)
    words = Words(language_before_parsing(arguments, os.environ, start.file))
    try:
        return _obey(arguments, words, start)
    except WrongUsage as wrong:
        complaint = words(wrong.code, what=wrong.what)
    except BadOption as bad:
        option, value = f"--{bad.key.replace('_', '-')}", bad.value[:40]
        complaint = words("bad-option", option=option, value=value, wanted=bad.wanted)
    except Unusable as unusable:
        complaint = unusable.sentence
    except KeyboardInterrupt:
        return ExitCode.STOPPED
    if greeting is not None:
        greeting.withdraw()
    start.output.complaint(complaint)
    return ExitCode.UNUSABLE


def _obey(arguments: list[str], words: Words, start: _Start) -> int:
    invocation = understand(arguments, words)
    if invocation.command in TO_COME:
        raise Unusable(words("command-to-come", command=invocation.command))
    order = _order(invocation, start)
    if order.outputs:
        from donnie_tui.cli.run import refuse_overwriting

        refuse_overwriting(order)
    code = _handler(order)(order)
    start.output.finish()
    if start.output.problem is not None:
        raise Unusable(order.words("output-unwritable", reason=start.output.problem))
    return code


def _order(invocation: Invocation, start: _Start) -> Order:
    """A command reports problems of the settings at once; a front end does so once it listens."""
    is_command = bool(invocation.command or invocation.arguments.run)
    default_speed = None if is_command else FRONT_END_SPEED
    settings, notices = resolve(invocation.options, os.environ, start.file, default_speed=default_speed)
    words = Words(settings.language, settings.verbosity)
    for notice in start.troubles + notices if is_command else ():
        start.output.complaint(words(notice.code, **notice.values))
    settings = replace(settings, notices=() if is_command else start.troubles + notices)
    settings = _with_original_flags(settings, invocation)
    return Order(invocation, settings, words, start.output, os.environ, start.greeting)


def _with_original_flags(settings: Settings, invocation: Invocation) -> Settings:
    """``-m`` and ``-l`` of the original GoDonnie."""
    if getattr(invocation.arguments, "mute", False):
        settings = replace(settings, speech="off", sound=False)
    return replace(settings, log=getattr(invocation.arguments, "log", False))


def _handler(order: Order) -> Callable[[Order], int]:
    """Each command loads no more than it needs."""
    match order.invocation.command:
        case "run":
            from donnie_tui.cli.run import run as command
        case "replay":
            from donnie_tui.cli.replay import replay as command
        case "check":
            from donnie_tui.cli.programs import check as command
        case "format":
            from donnie_tui.cli.programs import format_files as command
        case "worlds":
            from donnie_tui.cli.world import list_worlds as command
        case "world":
            from donnie_tui.cli.world import describe_world as command
        case "doctor":
            from donnie_tui.cli.doctor import doctor as command
        case "devices":
            from donnie_tui.cli.devices import list_devices as command
        case "calibrate":
            from donnie_tui.cli.calibrate import calibrate as command
        case "serve":
            from donnie_tui.cli.front_end import serve as command
        case "stop":
            from donnie_tui.cli.devices import stop as command
        case _ if order.invocation.arguments.run:
            from donnie_tui.cli.run import run_original as command
        case _:
            from donnie_tui.cli.front_end import start as command
    return command
