"""Past events: a timeline moves through them, a replay shows them again, and words say what was undone.

A position is the number of events before it. At each position the timeline knows the place and trail of every
robot; variables are known only where a run ended. A step is one command with all announcements about it.
``Chronicle`` is the listener that keeps the newest events for it, ``Trail`` the one that keeps movements.

A replay keeps the program's time, divided by the speed, forwards and backwards. The caller decides how events
are shown. All waiting goes through the control, so that a stop takes effect at once."""

from __future__ import annotations

from array import array
from collections import deque
from collections.abc import Callable, Iterable, Sequence
from copy import copy
from itertools import accumulate, pairwise
from math import hypot
from typing import TypeAlias

from msgspec import Struct
from msgspec.structs import replace

from devices.ports.robot import Pose, StoppedBy
from donnie_tui.core.events import (
    TRANSIENT,
    TYPED,
    Announced,
    BeltShown,
    CueSounded,
    Driven,
    Error,
    Event,
    GripperUsed,
    Link,
    Moved,
    PlacedThing,
    Read,
    Reset,
    RunEnded,
    RunStarted,
    Scanned,
    SoundSwitched,
    Spoke,
    Stamped,
    Statement,
    ThingsMoved,
    Turned,
    Waited,
    begins_anew,
    event_name,
    pose_of,
)
from donnie_tui.core.transcript import printed_lines, with_robot_name
from donnie_tui.core.wording import Wording, compass_heading, facing, whole_steps
from language.control import ExecutionControl
from language.source import quoted
from sim.geometry import nearest_on_edge

_ABOUT_AN_EVENT = ("moved", "turned", "driven", "scan", "sound", "link", "gripper", "pushed")
"""Announcements that follow an event of their own; any other is an event in itself."""
_LEADING_ON = ("step-forward", "step-back", "turn-right", "turn-left", "waiting", "done")
"""Cues that precede the event that they belong to."""


class _Place(Struct, frozen=True):
    """The place of a robot after that many events."""

    at: int
    pose: Pose
    begins: bool
    """Whether its trail begins here."""


class Timeline:
    """A position in a list of events, at its start at first."""

    def __init__(self, events: Sequence[Stamped], forgotten: Trail | None = None) -> None:
        """``events`` must not change during use, and must not contain transient ones.

        ``forgotten``: the movements before the first of them.
        """
        self.events = events
        self._forgotten = forgotten
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
        """The robot's pose here. None if it is not known yet."""
        places = self._places.get(robot)
        return places[-1].pose if places else None

    def trail(self, robot: str | None = None) -> tuple[Pose, ...]:
        """The robot's poses since it was last at its start, oldest first, up to here."""
        places = self._places.get(robot, [])
        first = next((index for index in reversed(range(len(places))) if places[index].begins), 0)
        return tuple(each.pose for each in places[first:])

    def moves(self, of: Callable[[], str | None]) -> Trail:
        """All movements up to here. ``of`` returns the robot's name, as for a trail."""
        moves = Trail() if self._forgotten is None else self._forgotten.copied()
        for index in range(self.at):
            moves.on_event(self.events[index])
        return moves.of(of)

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
        pose = pose_of(event)
        if pose is not None:
            self._places.setdefault(stamped.robot, []).append(_Place(self.at, pose, begins_anew(event)))
        if isinstance(event, ThingsMoved):
            self._things.append((self.at, event.places))


def is_main_event(event: Event) -> bool:
    """Whether it is the main event of a step, not an announcement about it or a cue before it."""
    return not (_leads_on(event) or _belongs_to_the_last(event))


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
        self._most = most
        self._events: deque[Stamped] = deque()
        self._forgotten = Trail()

    def __call__(self, stamped: Stamped) -> None:
        if not isinstance(stamped.event, TRANSIENT):
            self._events.append(stamped)
            if len(self._events) > self._most:
                self._forgotten.on_event(self._events.popleft())

    @property
    def last_seq(self) -> int:
        """The number of the last event; 0 before any."""
        return self._events[-1].seq if self._events else 0

    def timeline(self) -> Timeline:
        """The kept events, at their end."""

        forgotten = self._forgotten.copied()
        timeline = Timeline(tuple(self._events.copy()), forgotten)
        timeline.go_to(len(timeline))
        return timeline


LONGEST_PAUSE = 5.0
"""Seconds of real time that a replay pauses at most, so that a WAIT 1000 is not waited for again."""


class Replay:
    """One pass through a recording. ``speed``: times the robot's own pace; None is as fast as possible."""

    def __init__(self, timeline: Timeline, control: ExecutionControl, speed: float | None) -> None:
        self.timeline = timeline
        self.control = control
        self.speed = speed
        self._moments = moments_of(timeline.events)

    def forwards(self, show: Callable[[Stamped], None]) -> bool:
        """Plays from here to the end. False if it was stopped."""
        while self.timeline.at < len(self.timeline):
            if not self._pause(self.timeline.at, self.timeline.at + 1):
                return False
            stamped = self.timeline.forward()
            assert stamped is not None  # the end is not reached
            show(stamped)
        return True

    def backwards(self, show: Callable[[tuple[Stamped, ...]], None]) -> bool:
        """Plays from here to the start, step by step. False if it was stopped."""
        while self.timeline.at > 0:
            before = self.timeline.at
            undone = self.timeline.step_back()
            show(undone)
            if not self._pause(before, self.timeline.at):
                return False
        return True

    def _pause(self, one: int, other: int) -> bool:
        """Waits as long as the time between two positions."""
        seconds = abs(self._moment(other) - self._moment(one))
        return self.control.sleep(min(LONGEST_PAUSE, seconds / self.speed) if self.speed else 0.0)

    def _moment(self, at: int) -> float:
        return self._moments[at - 1] if at else 0.0


def moments_of(events: Iterable[Stamped]) -> array[float]:
    """The times of the events in seconds from the first: run after run, robots in parallel.

    Each run has its own time from 0; it is added to the time at which the run began.
    """
    moments, now = array("d"), 0.0
    began: dict[str | None, float] = {}
    running: set[str | None] = set()
    together = now
    for stamped in events:
        if isinstance(stamped.event, RunStarted):
            how = stamped.event.how
            if not running:
                together = now
            began[stamped.robot] = together if how and how.together else now
            running.add(stamped.robot)
        now = max(now, began[stamped.robot] + stamped.t) if stamped.robot in running else now
        moments.append(now)
        if isinstance(stamped.event, RunEnded):
            running.discard(stamped.robot)
    return moments


LONGEST_QUOTE = 60
"""Characters of spoken text that are quoted."""

_PARTS = {"step-forward": "walk", "step-back": "walk", "turn-right": "turn", "turn-left": "turn"}
"""Cues during a movement, by its kind."""


def undone_in_words(undone: Iterable[Stamped], timeline: Timeline, wording: Wording) -> str:
    """One sentence for a step that was undone: "Before FW 3: position 0, 2."

    ``undone`` is the result of ``Timeline.step_back``, empty at the start; ``timeline`` is already before the
    step.
    """
    events = tuple(undone)
    if not events:
        return wording("undone-start")
    done = next((each for each in events if is_main_event(each.event)), events[-1])
    return with_robot_name(done.robot, _undone(done.event, timeline.pose(done.robot), wording), wording)


def _undone(event: Event, pose: Pose | None, wording: Wording) -> str:
    what = _what(event, wording)
    match event:
        case Moved() if pose is not None:
            return wording("undone-walk", what=what, x=whole_steps(pose.x), y=whole_steps(pose.y))
        case Turned() if pose is not None:
            return wording("undone-turn", what=what, facing=facing(pose, wording))
        case _:
            place = _place(event, pose, wording)
            return " ".join(filter(None, (wording("undone", what=what), place)))


def redone_in_words(step: Iterable[Stamped], wording: Wording) -> str:
    """One sentence for a step that printed nothing: "Start of a.gd." Else empty."""
    events = tuple(step)
    if not events or any(printed_lines(each, wording) for each in events):
        return ""
    done = next((each for each in events if is_main_event(each.event)), events[-1])
    return with_robot_name(done.robot, wording("redone", what=_what(done.event, wording)), wording)


def _what(event: Event, wording: Wording) -> str:
    match event:
        case Moved(command=command) | Turned(command=command):
            return _quoted(command)
        case Spoke(text=text) | Announced(text=text):
            return _quoted(text)
        case Waited(seconds=seconds):
            return wording("undone-waited", seconds=seconds)
        case GripperUsed(outcome=outcome):
            return wording(f"undone-gripper-{outcome.value}")
        case Error(line=line):
            return wording("undone-error", line=line)
        case RunStarted(program=program):
            is_typed = program == TYPED
            return wording(f"undone-run-{'typed' if is_typed else 'started'}", program=_quoted(program))
        case RunEnded() | Driven() | Scanned() | SoundSwitched() | Link() | Reset():
            return wording(f"undone-{event_name(event).replace('_', '-')}")
        case _:
            return _trifle(event, wording)


def _trifle(event: Event, wording: Wording) -> str:
    """Words for a minor event, which counts as a step only while a program is held within a step."""
    match event:
        case Statement(line=line):
            return wording("undone-statement", line=line)
        case Read(value=value):
            return wording("undone-read", value=value)
        case CueSounded(name=name) if name in _PARTS:
            return wording(f"undone-part-{_PARTS[name]}")
        case BeltShown() | ThingsMoved() | CueSounded():
            return wording(f"undone-{event_name(event).replace('_', '-')}")
        case _:
            return wording("undone-something")


def _place(event: Event, pose: Pose | None, wording: Wording) -> str:
    """The robot's place after the step back, if that changed."""
    part = _PARTS.get(event.name) if isinstance(event, CueSounded) else None
    if pose is None or not (part or isinstance(event, RunStarted | RunEnded | Reset)):
        return ""
    if part == "turn":
        return wording("undone-facing", facing=facing(pose, wording))
    return wording("undone-position", x=whole_steps(pose.x), y=whole_steps(pose.y))


def _quoted(text: str) -> str:
    return quoted(" ".join(text.split()).rstrip("."), LONGEST_QUOTE)


# --- where a robot was

MOVES_KEPT = 10_000
"""Moves that are remembered."""
PLACES_KEPT = 20_000
"""Places of a path that are remembered."""
NEAR = 0.03
"""Steps: the side of a square whose points count as one place, and what a path is simplified by."""


class DrivenPath(Struct, frozen=True):
    """Where a robot was, its start first; ``robot`` is empty in a world of one."""

    robot: str
    poses: tuple[Pose, ...]
    driven: tuple[float, ...] = ()
    """Steps driven until each pose. More than from pose to pose where rounds are left out."""
    has_gap: bool = False
    """Whether the path after its start is forgotten up to the second pose."""

    @property
    def lengths(self) -> tuple[float, ...]:
        """Steps driven until each pose."""
        return self.driven or tuple(accumulate((apart(*each) for each in pairwise(self.poses)), initial=0.0))

    @property
    def pieces(self) -> tuple[tuple[Pose, ...], ...]:
        """The start, and what is known after a gap; without one the whole path."""
        return (self.poses[:1], self.poses[1:]) if self.has_gap else (self.poses,)


_Visit: TypeAlias = tuple[Pose, float]
"""Where a robot was, and the steps that it had driven."""


class _GrowingPath(Struct):
    """The whole path of a robot in bounded memory: what is left out was driven before, or can't be seen.

    Each point that is left out is nearer than a tenth of a step to the path that is kept. Of a path with too
    many places of its own the start is kept, and the newest part.
    """

    visits: list[_Visit]
    simplified: int = 0
    """Visits that were simplified; once more would be further off."""
    has_gap: bool = False

    def as_path(self, robot: str | None) -> DrivenPath:
        """Called in any thread."""
        poses, driven = zip(*tuple(self.visits), strict=True)
        return DrivenPath(robot or "", poses, driven, self.has_gap)

    def shorten(self) -> None:
        """Leaves visits out, so that at most three quarters of those that may be kept are left."""
        start = self.visits[: self.has_gap]
        visits, enough = _without_rounds(self.visits[self.has_gap :]), PLACES_KEPT * 3 // 4
        if len(visits) > enough:
            done, others = visits[: self.simplified], visits[self.simplified :]
            visits = _without_rounds([*done, *_simplified(others)])
            self.simplified = len(visits) - 1
        if len(visits) > enough:
            start = start or visits[:1]
            visits = visits[-enough:]
            self.simplified, self.has_gap = enough - 1, True
        self.visits = [*start, *visits]


def _is_straight_on(first: Pose, before: Pose, now: Pose) -> bool:
    """Whether the way to ``now`` continues the one to ``before``, or the robot turned twice on one spot."""
    far, near = apart(first, before), apart(before, now)
    if far < _ONE_SPOT and near < _ONE_SPOT:
        return True
    is_turned = max(abs(each.heading - now.heading) for each in (first, before)) > SAME_PLACE
    ahead = (before.x - first.x) * (now.x - before.x) + (before.y - first.y) * (now.y - before.y)
    return not is_turned and ahead > 0 and _off(before, first, now) < _ONE_SPOT


_ONE_SPOT = 1e-6
"""Steps."""


def _without_rounds(visits: Sequence[_Visit]) -> list[_Visit]:
    """The visits without rounds all of whose ways were driven before: the robot waits instead."""
    kept: list[tuple[tuple[int, int], _Visit]] = []
    ways = set[frozenset[tuple[int, int]]]()
    since: dict[tuple[int, int], int] = {}
    """Where in ``kept`` the robot came to each square since its last new way."""
    for visit in visits:
        square = round(visit[0].x / NEAR), round(visit[0].y / NEAR)
        way = frozenset((kept[-1][0], square)) if kept else frozenset((square,))
        if way not in ways:
            ways.add(way)
            since = {}
        begin = since.setdefault(square, len(kept))
        for gone, _ in kept[begin + 1 :]:
            if gone != square:
                since.pop(gone, None)
        del kept[begin + 1 :]
        kept.append((square, visit))
    return [visit for _, visit in kept]


_PART = 64
"""Visits that are simplified together: the time grows with their square."""


def _simplified(visits: Sequence[_Visit]) -> list[_Visit]:
    """The visits without those that lie on the way between others, part by part (Ramer, Douglas, Peucker)."""
    kept = [visits[0]]
    for begin in range(0, len(visits) - 1, _PART):
        parts = [visits[begin : begin + _PART + 1]]
        while parts:
            part = parts.pop()
            offs = [_off(pose, part[0][0], part[-1][0]) for pose, _ in part[1:-1]]
            if max(offs, default=0.0) > NEAR:
                farthest = offs.index(max(offs)) + 1
                parts += part[farthest:], part[: farthest + 1]
            else:
                kept.append(part[-1])
    return kept


def _off(pose: Pose, start: Pose, end: Pose) -> float:
    """Steps from a place to a straight way."""
    edge = start.x - pose.x, start.y - pose.y, end.x - pose.x, end.y - pose.y
    return hypot(*nearest_on_edge(edge))


class Trail:
    """The moves of each robot so far. Subscribe ``on_event`` to a hub."""

    def __init__(self, of: Callable[[], str | None] = lambda: None, most_moves: int = MOVES_KEPT) -> None:
        """``of`` returns the robot's name in its events; None in a world of one robot."""
        self._of = of
        self._most_moves = most_moves
        self._moves_of: dict[str | None, deque[Moved | Turned]] = {}
        self._counts: dict[str | None, int] = {}
        self._last_poses: dict[str | None, Pose] = {}
        self._paths: dict[str | None, _GrowingPath] = {}

    @property
    def path(self) -> DrivenPath:
        """Where the robot was, since it was at its start or put elsewhere."""
        robot = self._of()
        path = self._paths.get(robot)
        return path.as_path(robot) if path is not None else DrivenPath(robot or "", ())

    @property
    def paths(self) -> tuple[DrivenPath, ...]:
        """As ``path``, of each robot that drove."""
        paths = [path.as_path(robot) for robot, path in tuple(self._paths.items())]
        return tuple(
            each for each in paths if any(apart(each.poses[0], pose) > SAME_PLACE for pose in each.poses)
        )

    @property
    def last_pose(self) -> Pose | None:
        """The robot's last pose; None before anything ran."""
        return self._last_poses.get(self._of())

    @property
    def moves(self) -> int:
        """How often the robot moved, also what is not remembered."""
        return self._counts.get(self._of(), 0)

    @property
    def _moves(self) -> list[Moved | Turned]:
        return list(self._moves_of.get(self._of(), ()))

    def on_event(self, stamped: Stamped) -> None:
        """Called in any thread."""
        event, robot = stamped.event, stamped.robot
        if isinstance(event, Moved | Turned):
            self._moves_of.setdefault(robot, deque(maxlen=self._most_moves)).append(event)
            self._counts[robot] = self._counts.get(robot, 0) + 1
        if isinstance(event, Moved | Turned | Driven):
            path, pose = self._paths.get(robot), event.pose
            before, driven = path.visits[-1] if path is not None else (pose, 0.0)
            visit = pose, driven + hypot(pose.x - before.x, pose.y - before.y)
            if path is None:
                self._paths[robot] = _GrowingPath([visit])
            elif len(path.visits) > 1 + path.has_gap and _is_straight_on(path.visits[-2][0], before, pose):
                path.visits[-1] = visit
            else:
                path.visits.append(visit)
                if len(path.visits) > PLACES_KEPT:
                    path.shorten()
        if isinstance(event, Moved | Turned | Driven | RunEnded):
            self._last_poses[robot] = event.pose
        elif isinstance(event, Reset):
            self._paths.pop(robot, None)
        elif isinstance(event, RunStarted) and event.how is not None:
            robot = robot if event.how.named else None
            self._last_poses[robot] = event.how.pose
            path = self._paths.get(robot)
            if path is None or apart(path.visits[-1][0], event.how.pose) > SAME_PLACE:
                self._paths[robot] = _GrowingPath([(event.how.pose, 0.0)])

    def of(self, of: Callable[[], str | None]) -> Trail:
        """The same moves and paths for another robot."""
        same = copy(self)
        same._of = of
        return same

    def copied(self) -> Trail:
        """A trail of its own that continues from here."""
        new = Trail(self._of, self._most_moves)
        new._moves_of = {robot: moves.copy() for robot, moves in self._moves_of.items()}
        new._counts, new._last_poses = self._counts.copy(), self._last_poses.copy()
        new._paths = {robot: replace(path, visits=[*path.visits]) for robot, path in self._paths.items()}
        return new

    def in_words(self, count: int, wording: Wording) -> tuple[str, ...]:
        """The last ``count`` moves, a sentence each."""
        moves = self._moves[-count:] if count else []
        return tuple(_move(each, wording) for each in moves) or (wording("trail-none"),)

    def rows(self) -> tuple[tuple[str, int, int, int, int, bool], ...]:
        """The rows of a table: command, steps or degrees done, x, y, heading, whether it was cut short."""
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


SAME_PLACE = 0.01
"""Steps."""


def apart(here: Pose, there: Pose) -> float:
    return hypot(there.x - here.x, there.y - here.y)


_NOT_BLOCKED = (StoppedBy.USER, StoppedBy.LINK, StoppedBy.WRONG_WAY, StoppedBy.RUNAWAY)
"""What ends a movement although nothing is in the way."""


def _move(event: Moved | Turned, wording: Wording) -> str:
    if isinstance(event, Turned):
        return wording("trail-turned", command=event.command, facing=facing(event.pose, wording))
    code = "trail-blocked" if event.stopped_by else "trail-walked"
    if event.stopped_by in _NOT_BLOCKED:
        code = "trail-stopped"
    x, y = whole_steps(event.pose.x), whole_steps(event.pose.y)
    return wording(code, command=event.command, done=event.walked, x=x, y=y)
