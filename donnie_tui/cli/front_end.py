"""``donnie``: starts the linear mode or the full screen, and changes between them; ``serve`` and ``player``.

The mode is decided once, at the start: by the option, then the environment variables, then the settings file,
then the kind of terminal. The greeting names the cause.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Mapping
from contextlib import closing
from importlib.util import find_spec
from queue import SimpleQueue
from typing import TYPE_CHECKING

from msgspec import Struct
from msgspec.structs import replace

from donnie_tui.cli.options import ExitCode, Order
from donnie_tui.cli.streams import is_terminal, on_signals
from donnie_tui.commands.interaction import SwitchMode
from donnie_tui.i18n.words import Unusable, Words
from donnie_tui.process.confinement import confinement, may_run_programs
from donnie_tui.settings.parsing import read_switch
from donnie_tui.settings.settings import BY_KEY, CONFINED, DEVICES, ServedFile, Settings
from language.source import quoted

if TYPE_CHECKING:
    from devices.audio.channel import DetectedEnvironment
    from donnie_tui.bootstrap import Donnie
    from donnie_tui.core.events import Stamped
    from donnie_tui.linear.greeting import Greeting


class _CarriedOver(Struct):
    """The state that one mode passes to the other."""

    file: str | None
    greeting: Greeting | None
    """The greeting of this process's linear mode."""
    text: str | None = None
    """The program of the other mode; without it ``file`` is read."""
    donnie: Donnie | None = None


def start(order: Order) -> int:
    """Run the front ends until the learner leaves Donnie. Returns the exit code."""
    arguments = order.invocation.arguments
    settings = replace(order.settings, plain=True) if arguments.plain else order.settings
    option = True if arguments.linear else False if arguments.visual else None
    cause = cause_of_linear(option, settings.linear, process_environment(order.environment))
    program = None if order.invocation.command else arguments.file or None
    along = _CarriedOver(program, order.greeting)
    while True:
        try:
            return _run_screen(settings, along) if cause is None else _run_linear(settings, cause, along)
        except SwitchMode as switch:
            cause = None if cause else "word"
            along.file = switch.name or None
            along.text, along.donnie = switch.text, switch.donnie


def _run_screen(settings: Settings, along: _CarriedOver) -> int:
    from donnie_tui.tui.environment import prepare

    prepare(settings)
    from donnie_tui.tui.full_screen import run_full_screen

    return run_full_screen(settings, along.file, text=along.text, donnie=along.donnie)


def _run_linear(settings: Settings, cause: str, along: _CarriedOver) -> int:
    from donnie_tui.linear.app import run_linear
    from donnie_tui.linear.greeting import Greeting

    along.greeting = along.greeting or Greeting()
    return run_linear(settings, along.file, cause, along.greeting, text=along.text, donnie=along.donnie)


class ProcessEnvironment(Struct, frozen=True):
    """The surroundings in which the process was started."""

    stdin_is_terminal: bool
    stdout_is_terminal: bool
    environment: Mapping[str, str]
    stderr_is_terminal: bool = True
    """Whether standard error, on which Textual paints, is a terminal."""

    @property
    def is_terminal(self) -> bool:
        """Whether there is a terminal; a browser, named in TEXTUAL_DRIVER, counts as one."""
        is_browser = bool(self.environment.get("TEXTUAL_DRIVER"))
        return is_browser or (self.stdin_is_terminal and self.stdout_is_terminal and self.stderr_is_terminal)


def process_environment(environment: Mapping[str, str]) -> ProcessEnvironment:
    """The environment of this process."""
    stdin, stdout, stderr = map(is_terminal, (sys.stdin, sys.stdout, sys.stderr))
    return ProcessEnvironment(stdin, stdout, environment, stderr)


def cause_of_linear(option: bool | None, configured: bool | None, around: ProcessEnvironment) -> str | None:
    """Why the mode is linear, for the greeting; None for the full screen.

    ``option``: True for ``--linear``, False for ``--visual``. A full screen without a terminal is
    impossible, even with ``--visual``.
    """
    chosen = _chosen(option, configured, around.environment)
    if chosen and chosen[0]:
        return chosen[1]
    if not around.is_terminal:
        return "no-terminal"
    if chosen is None and around.environment.get("TERM", "") in ("dumb", ""):
        return "simple-terminal"
    return None


def _chosen(
    option: bool | None, configured: bool | None, environment: Mapping[str, str]
) -> tuple[bool, str] | None:
    """The chosen mode and its source; None without a choice."""
    if option is not None:
        return option, "option"
    variable = _by_variable(environment)
    if variable is not None:
        return variable, "variable"
    return None if configured is None else (configured, "settings")


def _by_variable(environment: Mapping[str, str]) -> bool | None:
    """``DONNIE_LINEAR`` switches on and off, ``ACCESSIBLE`` on only."""
    try:
        return read_switch(environment["DONNIE_LINEAR"])
    except (KeyError, ValueError):
        wanted = environment.get("ACCESSIBLE", "").strip().lower() not in ("", "0", "false")
        return True if wanted else None


# --- clients of Player

PORTS = range(1, 65536)


def serve_clients(order: Order) -> int:
    """Let clients of Player drive the robots of a world, until a signal or the learner ends it.

    With ``--linear`` or ``--visual`` a front end shows what they do, else only what robots say is printed.
    Raises ``Unusable``.
    """
    from devices.audio.channel import DetectedEnvironment
    from donnie_tui.bootstrap import assemble
    from donnie_tui.core.events import Announced, Spoke

    words, arguments, output = order.words, order.invocation.arguments, order.output
    port = allowed_number(words, "serve-bad-port", arguments.port, PORTS)
    served = ServedFile(arguments.file, arguments.host, port)
    settings = replace(order.settings, world=arguments.file, served=served)
    if arguments.linear or arguments.visual:
        return start(replace(order, settings=settings))
    signals: SimpleQueue[None] = SimpleQueue()  # its ``put`` takes no lock that ``get`` holds

    def show(stamped: Stamped) -> None:
        match stamped.event:
            case Spoke(text=text):
                name = stamped.robot or donnie.session.name
                output.line(words("player-said", name=name, text=text))
            case Announced(code="clients", text=text):
                output.complaint(text)

    speaks = speaks_for_robots(settings.speech, DetectedEnvironment())
    settings = replace(settings, speech="robot" if speaks else "off")
    with on_signals(lambda: signals.put(None)), closing(assemble(settings, terminal=False)) as donnie:
        donnie.session.hub.subscribe(show)
        for notice in (*donnie.notices.about_devices, words("player-ending")):
            output.line(notice)
        signals.get()
    return ExitCode.DONE


def speaks_for_robots(speech: str, facts: DetectedEnvironment) -> bool:
    """Whether the words of robots are also spoken, as the linear mode would do."""
    from devices.audio.channel import Channel, choose_channel

    return speech == "robot" or choose_channel(speech, facts).channel is not Channel.TEXT


# --- in a browser

SESSIONS = range(1, 101)
IDLE_MINUTES = range(1441)


def serve(order: Order) -> int:
    """Serve until it is stopped. Raises ``Unusable`` without textual-serve, or for an invalid option."""
    words, arguments = order.words, order.invocation.arguments
    if find_spec("textual_serve") is None:
        raise Unusable(words("serve-missing", command=_installing()))
    port = allowed_number(words, "serve-bad-port", arguments.port, PORTS)
    sessions = allowed_number(words, "serve-bad-sessions", arguments.sessions, SESSIONS)
    idle = allowed_number(words, "serve-bad-idle", arguments.idle, IDLE_MINUTES)
    if order.settings.events == "-":
        raise Unusable(words("serve-events"))
    if order.outputs and sessions > 1:
        raise Unusable(words("serve-one-file", option=order.outputs[0][0]))
    import asyncio

    from donnie_tui.cli.page_server import LOCALHOST, PageServer, serve_until_signal
    from donnie_tui.cli.page_session import PageLimits

    address = arguments.listen or LOCALHOST
    limits = PageLimits(sessions=sessions, idle=60.0 * idle)
    command = page_command(order.invocation.options)
    _confine_pages()
    server = PageServer(command, words, order.output.complaint, limits, address=address, port=port)

    def announce() -> None:
        if server.is_open_to_others:
            order.output.line(words("serve-open-to-others"))
        order.output.line(words("serve-address", link=server.gate.link))

    try:
        asyncio.run(serve_until_signal(server, announce))
    except OSError as problem:
        from devices.serial_ports import reason_of

        reason = reason_of(problem)
        code = "serve-failed-at" if arguments.listen else "serve-failed"
        raise Unusable(words(code, address=address, port=port, reason=reason)) from None
    return ExitCode.DONE


def allowed_number(words: Words, complaint: str, typed: str, allowed: range) -> int:
    """Parse a typed number. Raises ``Unusable`` if it is not allowed."""
    number = int(typed) if typed.isdecimal() and len(typed) <= _MOST_DIGITS else -1
    if number not in allowed:
        raise Unusable(words(complaint, value=quoted(typed), least=allowed[0], most=allowed[-1]))
    return number


_MOST_DIGITS = 9


def page_command(options: Mapping[str, str]) -> list[str]:
    """The command for each page: the full screen with the same options.

    ``-P``: a learner's file called ``donnie_tui.py`` must not be imported from the folder of the session.
    """
    given = [
        part
        for key, value in options.items()
        if key != CONFINED.key  # see ``_confine_pages``
        for part in (BY_KEY[key].option, value)
    ]
    safely = [] if may_run_programs() else ["-P"]
    return [sys.executable, *safely, "-m", "donnie_tui", "--visual", *given]


def _confine_pages() -> None:
    """Confine pages to this process's folder, as a relative name may mean another one by then.

    Confine them to its ports as well: a source weaker than the folder's variable can't add any.
    """
    here = confinement()
    if here is not None:
        from devices.serial_ports import named_ports

        os.environ[CONFINED.variable] = here.folder
        if ports := named_ports():
            os.environ[DEVICES.variable] = ",".join(ports)


def _installing() -> str:
    """The command that installs the extra; a checkout is not in a package index."""
    import shlex
    from pathlib import Path

    root = Path(__file__).resolve().parents[2]
    wanted = ["--editable", f"{root}[serve]"] if (root / "pyproject.toml").exists() else ["donnie-tui[serve]"]
    installer = ["uv", "pip", "install", "--python", sys.executable]
    if find_spec("pip") is not None:
        installer = [sys.executable, "-m", "pip", "install"]
    return shlex.join([*installer, *wanted])
