"""Moves through past events: by event or by step, forwards and backwards.

A position is the number of events before it. At each position the timeline knows the place and trail of every
robot; variables are known only where a run ended. A step is one command with all announcements about it.

``Chronicle`` is the listener that keeps the newest events for it.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Sequence

from msgspec import Struct

from devices.ports.robot import Pose
from donnie_tui.core.events import (
    TRANSIENT,
    Announced,
    BeltShown,
    CueSounded,
    Driven,
    Event,
    Moved,
    PlacedThing,
    Read,
    Reset,
    RunEnded,
    RunStarted,
    Stamped,
    Statement,
    ThingsMoved,
    Turned,
)

_ABOUT_AN_EVENT = ("moved", "turned", "driven", "scan", "sound", "link", "gripper", "pushed")
"""Announcements that follow an event of their own; any other is an event in itself."""
_LEADING_ON = ("step-forward", "step-back", "turn-right", "turn-left", "waiting", "done")
"""Cues that precede the event that they belong to."""


class _Place(Struct, frozen=True):
    """A robot was here after so many events."""

    at: int
    pose: Pose
    begins: bool
    """Whether its trail begins here."""


class Timeline:
    """A position in a list of events, at its start at first."""

    def __init__(self, events: Sequence[Stamped]) -> None:
        """``events`` must not change during use, and must not contain transient ones."""
        self.events = events
        self.at = 0
        self._places: dict[str | None, list[_Place]] = {}
        self._things: list[tuple[int, tuple[PlacedThing, ...]]] = []

    # --- moving

    def forward(self) -> Stamped | None:
        """Moves over the next event. None at the end."""
        if self.at == len(self.events):
            return None
        stamped = self.events[self.at]
        self.at += 1
        self._happen(stamped)
        return stamped

    def back(self) -> Stamped | None:
        """Undoes the last event and returns it. None at the start."""
        if self.at == 0:
            return None
        self.at -= 1
        stamped = self.events[self.at]
        places = self._places.get(stamped.robot)
        if places and places[-1].at > self.at:
            places.pop()
        if self._things and self._things[-1][0] > self.at:
            self._things.pop()
        return stamped

    def go_to(self, at: int) -> None:
        """Moves to a position, or to the nearest one that exists."""
        while self.at < at and self.forward():
            pass
        while self.at > max(at, 0):
            self.back()

    def step(self) -> tuple[Stamped, ...]:
        """Moves over the next step. Returns its events, none at the end."""
        first = self.at
        while self.forward() and not self.is_between_steps:
            pass
        return tuple(self.events[index] for index in range(first, self.at))

    def step_back(self) -> tuple[Stamped, ...]:
        """Undoes the last step. Returns its events in their order, none at the start."""
        last = self.at
        while self.back() and not self.is_between_steps:
            pass
        return tuple(self.events[index] for index in range(self.at, last))

    # --- looking

    def __len__(self) -> int:
        return len(self.events)

    @property
    def now(self) -> Stamped | None:
        """The last event; None at the start."""
        return self.events[self.at - 1] if self.at else None

    @property
    def robots(self) -> tuple[str | None, ...]:
        """The robots so far; None is the only one of its world."""
        return tuple(robot for robot, places in self._places.items() if places)

    def pose(self, robot: str | None = None) -> Pose | None:
        """The robot's pose here. None where it is not known yet."""
        places = self._places.get(robot)
        return places[-1].pose if places else None

    def trail(self, robot: str | None = None) -> tuple[Pose, ...]:
        """The robot's poses since it was last at its start, oldest first, up to here."""
        places = self._places.get(robot, [])
        first = next((index for index in reversed(range(len(places))) if places[index].begins), 0)
        return tuple(each.pose for each in places[first:])

    @property
    def things(self) -> tuple[PlacedThing, ...]:
        """The things of the world that are not where they were at its start."""
        return self._things[-1][1] if self._things else ()

    @property
    def steps(self) -> tuple[int, int]:
        """How many steps are before this position, and how many there are."""
        main = [is_main_event(each.event) for each in self.events]
        return sum(main[: self.at]), sum(main)

    @property
    def is_between_steps(self) -> bool:
        """Whether a step ended just before this position."""
        if self.at in (0, len(self.events)):
            return True
        if _belongs_to_the_last(self.events[self.at].event):
            return False
        before = self.at - 1
        while before > 0 and isinstance(self.events[before].event, BeltShown | ThingsMoved):
            before -= 1
        return not _leads_on(self.events[before].event)

    # --- inside

    def _happen(self, stamped: Stamped) -> None:
        event = stamped.event
        pose = _pose_of(event)
        if pose is not None:
            begins = isinstance(event, Reset) or (isinstance(event, RunStarted) and _begins_anew(event))
            self._places.setdefault(stamped.robot, []).append(_Place(self.at, pose, begins))
        if isinstance(event, ThingsMoved):
            self._things.append((self.at, event.places))


def is_main_event(event: Event) -> bool:
    """Whether it is the main event of a step, not an announcement about it or a cue before it."""
    return not (_leads_on(event) or _belongs_to_the_last(event))


def _pose_of(event: Event) -> Pose | None:
    match event:
        case RunStarted(how=how):
            return how.pose if how is not None else None
        case Moved(pose=pose) | Turned(pose=pose) | Driven(pose=pose):
            return pose
        case RunEnded(pose=pose) | Reset(pose=pose):
            return pose
        case _:
            return None


def _begins_anew(event: RunStarted) -> bool:
    return event.how is not None and event.how.begins_anew


def _belongs_to_the_last(event: Event) -> bool:
    match event:
        case Announced(code=code):
            return code in _ABOUT_AN_EVENT
        case CueSounded(name=name):
            return name not in _LEADING_ON
        case BeltShown() | ThingsMoved():
            return True
        case _:
            return False


def _leads_on(event: Event) -> bool:
    match event:
        case CueSounded(name=name):
            return name in _LEADING_ON
        case Statement() | Read() | Announced(code="waiting"):
            return True
        case _:
            return False


MOST = 50_000
"""Events that are kept, the newest ones: a lesson has some thousands."""


class Chronicle:
    """Keeps the newest events that are not transient. Safe in any thread."""

    def __init__(self, most: int = MOST) -> None:
        self._events: deque[Stamped] = deque(maxlen=most)

    def __call__(self, stamped: Stamped) -> None:
        if not isinstance(stamped.event, TRANSIENT):
            self._events.append(stamped)

    @property
    def last_seq(self) -> int:
        """The number of the last event; 0 before any."""
        return self._events[-1].seq if self._events else 0

    def timeline(self) -> Timeline:
        """The kept events, at their end."""

        timeline = Timeline(tuple(self._events.copy()))
        timeline.go_to(len(timeline))
        return timeline
