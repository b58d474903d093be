"""From the command line to the exit code: read the settings, then carry out the command."""

from __future__ import annotations

import os
import signal
import sys
from collections.abc import Callable, Mapping
from contextlib import suppress
from importlib import import_module
from typing import TYPE_CHECKING

from msgspec import Struct
from msgspec.structs import replace

import donnie_tui
from donnie_tui.cli.options import (
    RUN_ORIGINAL,
    SUBCOMMANDS,
    ExitCode,
    Invocation,
    Order,
    language_before_parsing,
    understand,
)
from donnie_tui.cli.streams import Output
from donnie_tui.i18n.words import Unusable, Words
from donnie_tui.process.confinement import IS_POSSIBLE, Confinement, confine, part_below, real_path
from donnie_tui.process.signals import numbers_of
from donnie_tui.settings.folders import account_settings_file, keep_in, machine_settings_file, settings_file
from donnie_tui.settings.parsing import Notice, read_file
from donnie_tui.settings.settings import (
    CONFINED,
    DEVICES,
    FRONT_END_SPEED,
    Refusal,
    Settings,
    SettingSource,
    limits_of,
    resolve,
)

if TYPE_CHECKING:
    from donnie_tui.linear.greeting import Greeting


class _Start(Struct, frozen=True):
    """The facts that are known before the command line is parsed."""

    output: Output
    machine: Mapping[str, object]
    """The settings of the machine."""
    account: Mapping[str, object]
    """The settings of the account."""
    troubles: tuple[Notice, ...]
    """The problems of the account's settings."""
    greeting: Greeting | None
    joins_server: bool


class _OwnSettings(Struct, frozen=True):
    """The learner's own settings in a confined session."""

    settings: Mapping[str, object]
    troubles: tuple[Notice, ...]
    """The problems of all settings."""


TEACHERS = (CONFINED.key, DEVICES.key)
"""Settings that a learner can't make: ``limits_of`` doesn't read the learner's own."""


def main(arguments: list[str], greeting: Greeting | None = None, *, joins_server: bool = False) -> int:
    """Run a command line. Returns the exit code; never raises for a mistake of the user.

    ``greeting``: what the linear mode printed before anything was loaded. ``joins_server``: a Player server
    that runs on this machine has the robot, if no other one is chosen.
    """
    _lift_limits()
    machine, damages = read_file(machine_settings_file())
    start = _Start(Output(), machine, *read_file(account_settings_file(os.environ)), greeting, joins_server)
    words = Words(language_before_parsing(arguments, os.environ, {**machine, **start.account}))
    try:
        for damage in damages:  # it may be the line that limits the learner
            code = "damaged" if "line" in damage.values else "unreadable"
            values = {**damage.values, "path": machine_settings_file()}
            raise Unusable(words(f"machine-settings-file-{code}", **values))
        return _obey(arguments, words, start)
    except Refusal as refusal:
        complaint = words(refusal.code, **refusal.values)
    except Unusable as unusable:
        *before, complaint = unusable.sentences_after(arguments)
        start.output.complaint(*before)
    except KeyboardInterrupt:
        return ExitCode.STOPPED
    if greeting is not None:
        greeting.withdraw()
    start.output.complaint(complaint)
    return ExitCode.UNUSABLE


def _obey(arguments: list[str], words: Words, start: _Start) -> int:
    invocation = understand(arguments, words)
    own = _limit(invocation, words, start)
    order = _order(invocation, own, start)
    if order.outputs:
        from donnie_tui.cli.run import refuse_overwriting

        refuse_overwriting(order)
    code = handler_of(order.invocation)(order)
    start.output.finish()
    if start.output.problem is not None:
        raise Unusable(order.words("output-unwritable", reason=start.output.problem))
    return code


def _limit(invocation: Invocation, words: Words, start: _Start) -> _OwnSettings:
    """Apply the limits that a teacher has set. Returns the learner's settings under them.

    Raises ``BadLimitsError`` or ``Unusable``.
    """
    limits = limits_of(start.machine, os.environ, start.account, invocation.options)
    if limits.devices is not None:
        from devices.serial_ports import allow_only

        allow_only(limits.devices)
    if limits.folder is None:
        return _OwnSettings({}, start.troubles)
    if not IS_POSSIBLE:
        raise Unusable(words("confined-impossible"))
    import worlds
    from worlds.challenges import LADDERS

    confinement = Confinement(limits.folder, readable=(worlds.SCENES, worlds.MANUAL, LADDERS))
    confine(confinement)
    if CONFINED.key in invocation.options:  # the way from here may be another one
        invocation.options[CONFINED.key] = confinement.folder
    keep_in(confinement.own_folder)
    _import_nothing_from(confinement.folder)
    _ignore_suspension(words)
    own, troubles = read_file(settings_file(os.environ))
    refused = tuple(Notice("setting-of-teacher", {"name": each}) for each in TEACHERS if each in own)
    return _OwnSettings(own, start.troubles + troubles + refused)


def _import_nothing_from(folder: str) -> None:
    """Remove a folder from the module path: ``python -m`` adds the one in which a learner may have files."""
    from pathlib import Path  # slow to load, and few sessions are confined

    root = os.path.realpath(Path(donnie_tui.__file__).parents[1])
    places = [(each, real_path(each)) for each in sys.path]
    sys.path[:] = [each for each, real in places if part_below(folder, real) is None or real == root]


def _ignore_suspension(words: Words) -> None:
    """Ignore Ctrl+Z, which would lead to the shell above."""

    def refuse(*_: object) -> None:
        with suppress(OSError):
            os.write(2, f"{words('suspend-impossible')}\n".encode())

    for number in numbers_of("SIGTSTP"):
        with suppress(ValueError):  # not in the main thread, as in a test
            signal.signal(number, refuse)


def _lift_limits() -> None:
    """Lift the limits of an earlier command in the same process."""
    confine(None)
    keep_in(None)
    port = sys.modules.get("devices.serial_ports")
    if port is not None:
        port.allow_only(None)


def _order(invocation: Invocation, own: _OwnSettings, start: _Start) -> Order:
    """Make the order. A command reports problems of the settings at once, a front end once it listens."""
    is_command = bool(invocation.command or invocation.arguments.run)
    default_speed = None if is_command else FRONT_END_SPEED
    if invocation.command == "player":
        default_speed = 1.0  # its clients measure time by their own clocks
    file = {**start.machine, **start.account, **own.settings}
    settings, notices = resolve(invocation.options, os.environ, file, default_speed=default_speed)
    words = Words(settings.language, settings.verbosity)
    for notice in own.troubles + notices if is_command else ():
        start.output.complaint(words(notice.code, **notice.values))
    settings = replace(settings, notices=() if is_command else own.troubles + notices)
    settings = _with_original_flags(settings, invocation)
    if start.joins_server and not invocation.command:
        settings = _at_server(settings)
    return Order(invocation, settings, words, start.output, os.environ, start.greeting)


def _at_server(settings: Settings) -> Settings:
    """The settings with the robot of the server that runs, in the world that ``donnie_player`` serves."""
    import worlds
    from donnie_tui.robot.search import running_server

    is_open = settings.source_of("robot") is SettingSource.DEFAULT
    server = running_server(os.environ) if is_open else None
    if server is None:
        return settings
    has_world = settings.source_of("world") is not SettingSource.DEFAULT
    return replace(settings, robot=server, world=settings.world if has_world else worlds.PLAYED)


def _with_original_flags(settings: Settings, invocation: Invocation) -> Settings:
    """``-m`` and ``-l`` of the original GoDonnie."""
    if getattr(invocation.arguments, "mute", False):
        settings = replace(settings, speech="off", sound=False)
    return replace(settings, log=getattr(invocation.arguments, "log", False))


def handler_of(invocation: Invocation) -> Callable[[Order], int]:
    """Import the handler of a command, so that each command loads no more than it needs."""
    is_original = not invocation.command and invocation.arguments.run
    place = RUN_ORIGINAL if is_original else SUBCOMMANDS[invocation.command].handler
    module, _, function = place.partition(".")
    handler: Callable[[Order], int] = getattr(import_module(f"donnie_tui.cli.{module}"), function)
    return handler
