"""Every movement of a robot, in the words that STATE and HISTORY need."""

from __future__ import annotations

from devices.ports.robot import Pose, StoppedBy
from devices.ports.values import frozen
from donnie_tui.core.events import Moved, Turned


@frozen
class Movement:
    """One movement: its number from 1, the command as typed, how far it came, and where that was."""

    number: int
    command: str
    turned: bool
    done: int
    crashed: bool
    pose: Pose


class History:
    """The movements so far, oldest first."""

    def __init__(self) -> None:
        self._movements: list[Movement] = []

    def remember(self, event: Moved | Turned) -> None:
        done = event.walked if isinstance(event, Moved) else event.turned
        crashed = event.stopped_by not in (None, StoppedBy.LINK)
        number = len(self._movements) + 1
        turned = isinstance(event, Turned)
        self._movements.append(Movement(number, event.command, turned, done, crashed, event.pose))

    def forget(self) -> None:
        self._movements.clear()

    @property
    def last(self) -> Movement | None:
        return self._movements[-1] if self._movements else None

    @property
    def movements(self) -> tuple[Movement, ...]:
        return tuple(self._movements)
