"""Finds the robot of the settings and its port, and says what to do if it can't be used.

A search takes some seconds, and the learner may cancel it. ``Search`` takes no lock, because a signal handler
calls it.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from contextlib import suppress
from typing import TYPE_CHECKING, TypeAlias

from msgspec import Struct

from devices.ports.robot import RobotProblem
from donnie_tui.i18n.words import Unusable, Words
from donnie_tui.settings.parsing import (
    DOUBLE,
    PLAYER,
    PLAYER_PORT,
    SERIAL,
    SIMULATED,
    address_of,
    read_server,
    socket_of,
)
from donnie_tui.settings.settings import Settings

if TYPE_CHECKING:
    from devices.serial_ports import FoundPort, PortProblem
    from devices.serial_robot.robot import SerialRobot
    from donnie_tui.robot.player_robot import PlayerRobot

    Connectable: TypeAlias = SerialRobot | PlayerRobot
    """A robot on a connection."""


class Search:
    """Looks for the robot of a session, each time that it changes."""

    def __init__(self, *, is_pending: bool = False) -> None:
        """``is_pending``: as after ``expect``."""
        self._is_pending = is_pending
        self._is_given_up = False
        self._robot: Connectable | None = None
        self.on_slow: Callable[[], object] = _nothing
        """Reports that it continues, if it takes longer than a second; in the thread that connects."""

    def expect(self) -> None:
        """Announce a search, which can be given up even before it begins. Call ``end`` later."""
        self._is_pending = True

    def give_up(self) -> bool:
        """Give up the search. Returns whether there was one. Any thread."""
        robot = self._robot
        if robot is None and not self._is_pending:
            return False
        self._is_given_up = True
        if robot is not None:
            robot.give_up()
        return True

    def connect(self, robot: Connectable) -> None:
        """Raises ``RobotProblem``, ``given-up`` among them."""
        self._robot = robot
        if self._is_given_up:
            robot.give_up()
        robot.connect()

    def end(self) -> None:
        """Ends the search, whatever its result."""
        self._is_pending, self._robot = False, None
        self._is_given_up = False


def _nothing() -> None: ...


Lister = Callable[[], "tuple[FoundPort, ...]"]


def running_server(environment: Mapping[str, str]) -> str | None:
    """The Player server that the original's variables name, or one that runs on this machine."""
    from devices.serial_ports import is_named

    host, port = environment.get("DONNIE_IP", ""), environment.get("DONNIE_PORT", "")
    try:
        server = read_server(f"{host or LOCAL_SERVER}:{port or PLAYER_PORT}")
    except ValueError:
        return None
    if host:
        return server
    with suppress(OSError):
        if is_named(socket_of(server)):
            import socket

            with socket.create_connection(address_of(server)[:2], HERE) as connected:
                return server if connected.recv(len(_BANNER)) == _BANNER else None
    return None


LOCAL_SERVER = "127.0.0.1"
HERE = 1.0
"""Seconds that a server on this machine may take."""
_BANNER = b"Player v."


class RobotOption(Struct, frozen=True):
    """One robot that a learner may choose."""

    robot: str
    """As ``--robot`` takes it."""
    sentence: str


def robot_options(settings: Settings, words: Words, found: Lister | None = None) -> tuple[RobotOption, ...]:
    """The simulator, the boards that are plugged in and the one of the settings, and the simulated board."""
    from devices.serial_ports import is_same_port

    ports = dict.fromkeys(each.stable for each in _boards(settings, found))
    may_be_belt = len(ports) > 1 and not settings.belt
    server = settings.robot if settings.robot.startswith(PLAYER) else ""
    configured = "" if server else settings.robot.partition(":")[2]
    if configured and not any(is_same_port(configured, port) for port in ports):
        ports[configured] = None
    return (
        RobotOption(SIMULATED, words("connect-option-simulator")),
        *(
            RobotOption(f"{SERIAL}:{port}", words(_kind(port, configured, may_be_belt), port=port))
            for port in ports
        ),
        *((RobotOption(server, words("connect-option-port", port=server)),) if server else ()),
        RobotOption(DOUBLE, words("connect-option-double")),
    )


def _kind(port: str, configured: str, may_be_belt: bool) -> str:
    """The kind of a board as far as it is known without a question to it."""
    from devices.serial_ports import is_same_port

    is_known = bool(configured) and is_same_port(port, configured)
    return "connect-option-board" if may_be_belt and not is_known else "connect-option-port"


def find_port(
    settings: Settings, words: Words, found: Lister | None = None, *, remedy: str = "remedy-simulator"
) -> str:
    """The port of the robot that the settings name, or of the one board that is plugged in and is no belt.

    Raises ``Unusable`` if there is none, with that ``remedy``, or more than one.
    """
    kind, _, port = settings.robot.partition(":")
    if kind == SERIAL and port:
        return port
    boards = _boards(settings, found)
    if not boards:
        raise Unusable(f"{words('problem-no-board')} {words(remedy)}")
    if len(boards) > 1:
        ports = ", ".join(each.stable for each in boards)
        raise Unusable(f"{words('problem-many-boards', ports=ports)} {words('remedy-many-boards')}")
    return boards[0].stable


def sentences_of(problem: PortProblem | RobotProblem, words: Words) -> tuple[str, ...]:
    """The sentences about a problem and its remedy, if one is known."""
    from devices.serial_ports import PortFault, PortProblem, group_of

    if isinstance(problem, PortProblem):
        code, values = problem.fault.value, {"port": problem.port, "reason": problem.reason}
    else:
        code, values = problem.code, {name: str(value) for name, value in problem.values.items()}
    problem_line = words(f"problem-{code}", **values)
    if not words.knows(f"remedy-{code}"):
        return (problem_line,)
    if code != PortFault.FORBIDDEN.value:
        return problem_line, words(f"remedy-{code}")
    group = group_of(values.get("port", ""))
    return problem_line, words("remedy-no-group") if group is None else words(f"remedy-{code}", group=group)


def _boards(settings: Settings, found: Lister | None) -> tuple[FoundPort, ...]:
    """Those of the machine, unless ``found`` lists others."""
    from devices.serial_ports import is_same_port, list_ports

    belt = settings.belt
    return tuple(
        each
        for each in (found or list_ports)()
        if each.is_board and not (belt and is_same_port(each.device, belt))
    )
