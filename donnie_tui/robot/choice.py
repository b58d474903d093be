"""Which robot is meant, where it is plugged in, and what to say and to do when it can't be used."""

from __future__ import annotations

from collections.abc import Callable

from devices.port_listing import FoundPort, list_ports
from devices.ports.robot import RobotProblem
from devices.ports.values import Frozen
from devices.serial_port import PortFault, PortProblem, group_of, is_same_port
from donnie_tui.i18n.words import Unusable, Words
from donnie_tui.settings.chosen import Settings
from donnie_tui.settings.devices import DOUBLE, SERIAL, SIMULATED

Lister = Callable[[], tuple[FoundPort, ...]]


class Choice(Frozen):
    """One robot that a learner may choose."""

    robot: str
    """As ``--robot`` takes it."""
    sentence: str


def choices(settings: Settings, words: Words, found: Lister = list_ports) -> tuple[Choice, ...]:
    """The simulator, the boards that are plugged in and the one of the settings, and the simulated board."""
    ports = dict.fromkeys(each.stable for each in _boards(settings, found))
    may_be_belt = len(ports) > 1 and not settings.belt
    configured = settings.robot.partition(":")[2]
    if configured and not any(is_same_port(configured, port) for port in ports):
        ports[configured] = None
    return (
        Choice(SIMULATED, words("connect-choice-simulator")),
        *(
            Choice(f"{SERIAL}:{port}", words(_kind(port, configured, may_be_belt), port=port))
            for port in ports
        ),
        Choice(DOUBLE, words("connect-choice-double")),
    )


def _kind(port: str, configured: str, may_be_belt: bool) -> str:
    """Of several boards only the one that was chosen before is known to be a robot; none is asked."""
    is_known = bool(configured) and is_same_port(port, configured)
    return "connect-choice-board" if may_be_belt and not is_known else "connect-choice-port"


def find_port(
    settings: Settings, words: Words, found: Lister = list_ports, *, remedy: str = "remedy-simulator"
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
    """What is wrong, and what can be done about it where that is known."""
    if isinstance(problem, PortProblem):
        code, values = problem.fault.value, {"port": problem.port, "reason": problem.reason}
    else:
        code, values = problem.code, {name: str(value) for name, value in problem.values.items()}
    told = words(f"problem-{code}", **values)
    if not words.knows(f"remedy-{code}"):
        return (told,)
    if code != PortFault.FORBIDDEN.value:
        return told, words(f"remedy-{code}")
    group = group_of(values.get("port", ""))
    return told, words("remedy-no-group") if group is None else words(f"remedy-{code}", group=group)


def _boards(settings: Settings, found: Lister) -> tuple[FoundPort, ...]:
    belt = settings.belt
    return tuple(each for each in found() if each.is_board and not (belt and is_same_port(each.device, belt)))
