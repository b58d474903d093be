"""The answers to questions: STATE, HISTORY, POS and HELP in words, published as announcements.

``History`` is every movement of a robot, in the words that STATE and HISTORY need.
"""

from __future__ import annotations

from collections.abc import Iterable

from devices.ports.robot import Pose, StoppedBy
from devices.ports.values import Frozen
from donnie_tui.core import poses
from donnie_tui.core.events import Announced, Moved, Turned
from donnie_tui.core.hub import Hub
from donnie_tui.core.poses import COMPASS
from donnie_tui.core.wording import Wording


class Movement(Frozen):
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


class Teller:
    """Makes sentences through the wording and publishes them."""

    def __init__(self, hub: Hub, wording: Wording) -> None:
        self._hub = hub
        self._say = wording

    def announce(self, code: str, sentence: str | None = None, **values: object) -> None:
        """One sentence: ``sentence`` is its code in the catalogue where that is not ``code`` itself."""
        self._hub.publish(Announced(code, self._say(sentence or code, **values)))

    def state(self, last: Movement | None, pose: Pose) -> None:
        if last is None:
            self._no_movement("state", pose)
        else:
            self._movement("state", last)

    def history(self, movements: Iterable[Movement]) -> None:
        for movement in movements:
            self._movement("history", movement)

    def no_history(self, pose: Pose) -> None:
        self._no_movement("history", pose)

    def position(self, pose: Pose) -> None:
        self.place("position", pose)

    def place(self, code: str, pose: Pose) -> None:
        """Where the robot is, as what is announced with ``code``."""
        self._hub.publish(Announced(code, position_in_words(pose, self._say)))

    def help(self, topic: str | None) -> None:
        for line in self._say.help(topic):
            self._hub.publish(Announced("help", line))

    def overwritten(self, name: str) -> None:
        self.announce("hint", "overwritten", name=name)

    def waiting(self, seconds: int) -> None:
        if seconds:
            self.announce("waiting", seconds=seconds)

    def belt(self, on: bool) -> None:
        self.announce("belt", "belt-on" if on else "belt-off")

    def _no_movement(self, code: str, pose: Pose) -> None:
        self.announce(code, "no-movement", **_whole(pose))

    def _movement(self, code: str, movement: Movement) -> None:
        self.announce(
            code,
            "movement-turned" if movement.turned else "movement-walked",
            number=movement.number,
            command=movement.command,
            done=movement.done,
            crashed=self._say("crashed" if movement.crashed else "not-crashed"),
            **_whole(movement.pose),
        )


def facing(pose: Pose, wording: Wording) -> str:
    """The heading in words: "north", or "40 degrees, near northeast"."""
    degrees = poses.heading(pose)
    point = wording(f"compass-{COMPASS[round(degrees / 45) % 8]}")
    return point if degrees % 45 == 0 else wording("facing-between", degrees=degrees, point=point)


def position_in_words(pose: Pose, wording: Wording) -> str:
    """Where a robot is, and how it looks."""
    x, y = poses.whole(pose.x), poses.whole(pose.y)
    return wording("position", facing=facing(pose, wording), x=x, y=y)


def _whole(pose: Pose) -> dict[str, int]:
    return {"x": poses.whole(pose.x), "y": poses.whole(pose.y), "heading": poses.heading(pose)}
