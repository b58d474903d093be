"""The robot's last moves in words, for TRAIL.

Collects them from the stream; the newest is the last.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable

from devices.ports.robot import Pose, StoppedBy
from donnie_tui.core.events import Moved, RunEnded, RunStarted, Stamped, Turned
from donnie_tui.core.transcript import facing, position_in_words
from donnie_tui.core.wording import Wording, compass_heading, whole_steps

USUALLY_TOLD = 5
"""Moves that TRAIL gives without a number."""

KEPT = 1000
"""Moves that are remembered."""


class Trail:
    """The moves of each robot so far. Subscribe ``hear`` to a hub."""

    def __init__(self, of: Callable[[], str | None] = lambda: None) -> None:
        """``of`` returns the robot's name in its events; None in a world of one robot."""
        self._of = of
        self._moves_of: dict[str | None, deque[Moved | Turned]] = {}
        self._last_poses: dict[str | None, Pose] = {}

    @property
    def last_pose(self) -> Pose | None:
        """The robot's last pose; None before anything ran."""
        return self._last_poses.get(self._of())

    @property
    def _moves(self) -> list[Moved | Turned]:
        return list(self._moves_of.get(self._of(), ()))

    def hear(self, stamped: Stamped) -> None:
        """Called in any thread."""
        event = stamped.event
        if isinstance(event, Moved | Turned):
            self._moves_of.setdefault(stamped.robot, deque(maxlen=KEPT)).append(event)
        if isinstance(event, Moved | Turned | RunEnded):
            self._last_poses[stamped.robot] = event.pose
        elif isinstance(event, RunStarted) and event.how is not None:
            robot = stamped.robot if event.how.named else None
            self._last_poses[robot] = event.how.pose

    def in_words(self, count: int, wording: Wording) -> tuple[str, ...]:
        """The last ``count`` moves, a sentence each."""
        moves = self._moves[-count:] if count else []
        return tuple(_move(each, wording) for each in moves) or (wording("trail-none"),)

    def rows(self) -> tuple[tuple[str, int, int, int, int, bool], ...]:
        """For a table: command, steps or degrees done, x, y, heading, whether it was cut short."""
        return tuple(
            (
                each.command,
                each.walked if isinstance(each, Moved) else each.turned,
                whole_steps(each.pose.x),
                whole_steps(each.pose.y),
                compass_heading(each.pose),
                each.stopped_by is not None,
            )
            for each in self._moves
        )


def place_in_words(pose: Pose, trail: Trail, wording: Wording, *, is_full: bool) -> tuple[str, ...]:
    """The answer to WHERE: the robot's place, and at full its last move."""
    place = position_in_words(pose, wording)
    return (place, *trail.in_words(1, wording)) if is_full else (place,)


def _move(event: Moved | Turned, wording: Wording) -> str:
    if isinstance(event, Turned):
        return wording("trail-turned", command=event.command, facing=facing(event.pose, wording))
    code = "trail-blocked" if event.stopped_by else "trail-walked"
    if event.stopped_by in (StoppedBy.USER, StoppedBy.LINK):
        code = "trail-stopped"
    x, y = whole_steps(event.pose.x), whole_steps(event.pose.y)
    return wording(code, command=event.command, done=event.walked, x=x, y=y)
