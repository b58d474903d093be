"""The way from a command line to an exit code: settings first, then the command that was asked for."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping

from devices.ports.hints import TYPE_CHECKING
from devices.ports.values import Frozen, replace
from donnie_tui.cli import codes
from donnie_tui.cli.arguments import TO_COME, Invocation, WrongUsage
from donnie_tui.cli.order import Order
from donnie_tui.cli.output import Output
from donnie_tui.cli.understanding import language_before_parsing, understand
from donnie_tui.i18n.words import Unusable, Words
from donnie_tui.settings.chosen import FRONT_END_SPEED, BadOption, Notice, Settings, resolve
from donnie_tui.settings.file import read_settings

if TYPE_CHECKING:
    from donnie_tui.linear.greeting import Greeting


class _Start(Frozen):
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
        option, value = f"--{bad.key}", bad.value[:40]
        complaint = words("bad-option", option=option, value=value, wanted=bad.wanted)
    except Unusable as unusable:
        complaint = unusable.sentence
    except KeyboardInterrupt:
        return codes.STOPPED
    if greeting is not None:
        greeting.withdraw()
    start.output.complaint(complaint)
    return codes.UNUSABLE


def _obey(arguments: list[str], words: Words, start: _Start) -> int:
    invocation = understand(arguments, words)
    if invocation.command in TO_COME:
        raise Unusable(words("command-to-come", command=invocation.command))
    order = _order(invocation, start)
    if order.outputs:
        from donnie_tui.cli.overwriting import refuse_overwriting

        refuse_overwriting(order)
    code = _handler(order)(order)
    if start.output.problem is not None:
        raise Unusable(order.words("output-unwritable", reason=start.output.problem))
    return code


def _order(invocation: Invocation, start: _Start) -> Order:
    """What is odd about the settings is told at once by a command, and by a front end once it listens."""
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
            from donnie_tui.cli.running import run as command
        case "replay":
            from donnie_tui.cli.replaying import replay as command
        case "check":
            from donnie_tui.cli.checking import check as command
        case "format":
            from donnie_tui.cli.formatting import format_files as command
        case "worlds":
            from donnie_tui.cli.worlds import list_worlds as command
        case "world":
            from donnie_tui.cli.worlds import tell_world as command
        case "doctor":
            from donnie_tui.cli.doctor import doctor as command
        case "devices":
            from donnie_tui.cli.devices import list_devices as command
        case "calibrate":
            from donnie_tui.cli.calibrating import calibrate as command
        case "serve":
            from donnie_tui.cli.serving import serve as command
        case "stop":
            from donnie_tui.cli.stopping import stop as command
        case _ if order.invocation.arguments.run:
            from donnie_tui.cli.running import run_original as command
        case _:
            from donnie_tui.cli.front_ends import start as command
    return command
