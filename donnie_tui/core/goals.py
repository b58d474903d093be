"""Whether a run met the goals of a challenge, and what is missing: a pure function of its events.

A distance to a thing is between the robot's body and the thing's box, so that 0 is touching. A distance to a
place is between the robot's middle and the place. All are in steps.
"""

from __future__ import annotations

import unicodedata
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from itertools import pairwise
from math import atan2, ceil, degrees, hypot

from msgspec import Struct

from devices.ports.robot import Grip, Pose, StoppedBy
from donnie_tui.core.events import (
    Error,
    Event,
    GripperUsed,
    Moved,
    Outcome,
    Reset,
    RunEnded,
    RunStarted,
    Scanned,
    Spoke,
    Stamped,
    ThingsMoved,
    Turned,
    Waited,
)
from worlds.challenges import Challenge, Goal, Rules, Target

DEGREES = 10.0
"""What a robot that faces a direction may be off by, for each step of ``within``."""
NEARLY = 0.05
"""Steps that don't count: a wheel's rounding."""


class Item(Struct, frozen=True):
    """A thing of the world at its start: its box, in steps, by its middle and half of its sides."""

    index: int
    name: str
    kind: str
    colour: str
    x: float
    y: float
    half_width: float = 0.0
    half_height: float = 0.0

    def is_called(self, name: str) -> bool:
        """Whether a goal means it: by its name, its kind, or its colour with either."""
        own = (self.name, self.kind, f"{self.colour} {self.name}", f"{self.colour} {self.kind}")
        return _folded(name) in map(_folded, own)


class Inventory(Struct, frozen=True):
    """What goals need to know of a world."""

    items: tuple[Item, ...]
    radius: float
    """Of the robot's body, in steps."""

    def called(self, name: str) -> tuple[Item, ...]:
        """All things that a goal means by that name."""
        return tuple(each for each in self.items if each.is_called(name))


class Shortfall(Struct, frozen=True):
    """Why something isn't met, as the code of a sentence and its values.

    ``thing``, ``target`` and ``direction`` are words of the file and degrees, which the wording translates.
    """

    code: str
    values: Mapping[str, object]


class Judgment(Struct, frozen=True):
    """The outcome of a run for a challenge."""

    goals: int
    met: int
    commands: int
    steps: int
    bumps: int
    shortfalls: tuple[Shortfall, ...]
    """The most important first; empty if the challenge is solved."""
    of_goals: tuple[Shortfall | None, ...] = ()
    """What each goal lacks, in the order of the file; None where it is met."""

    @property
    def is_solved(self) -> bool:
        return not self.shortfalls


class _Track(Struct, frozen=True):
    """What a run did."""

    poses: tuple[Pose, ...]
    """The places at which a movement began or ended; the way between two is straight."""
    items: tuple[Item, ...]
    """The things where they are at the end."""
    said: tuple[str, ...]
    held: str
    events: tuple[Event, ...]
    seconds: float
    variables: Mapping[str, int]

    def count(self, *kinds: type[Event]) -> int:
        return sum(isinstance(each, kinds) for each in self.events)

    @property
    def commands(self) -> int:
        return self.count(Moved, Turned, Waited, Spoke, Scanned, GripperUsed)

    def steps(self) -> int:
        return sum(each.walked for each in self.events if isinstance(each, Moved))

    def error(self) -> Error | None:
        """The first mistake of the last run."""
        return next((each for each in self._last_run() if isinstance(each, Error)), None)

    def is_stopped(self) -> bool:
        """Whether the last run was."""
        return any(
            isinstance(each, RunEnded) and each.outcome is Outcome.STOPPED for each in self._last_run()
        )

    def bumps(self) -> int:
        moves = [each for each in self.events if isinstance(each, Moved | Turned)]
        return sum(each.stopped_by in (StoppedBy.COLLISION, StoppedBy.OBSTACLE) for each in moves)

    def _last_run(self) -> Sequence[Event]:
        starts = [at for at, each in enumerate(self.events) if isinstance(each, RunStarted)]
        return self.events[starts[-1] :] if starts else self.events


def judge(challenge: Challenge, room: Inventory, events: Iterable[Stamped]) -> Judgment:
    """What the runs did for the challenge since the robot was put to its start the last time."""
    track, rules = _track(room, events), challenge.rules
    missing = [_missing(goal, room, track) for goal in rules.goal]
    failed = [each for each in missing if each is not None]
    return Judgment(
        len(missing),
        len(missing) - len(failed),
        track.commands,
        track.steps(),
        track.bumps(),
        (
            *_ended_badly(track),
            *_of_words(rules, track),
            *failed,
            *_forbidden(rules, room, track),
            *_over_limit(rules, track),
        ),
        tuple(missing),
    )


def unknown_things(challenge: Challenge, room: Inventory) -> tuple[str, ...]:
    """The names in goals and rules that no thing of the world has."""
    named = [each for goal in challenge.rules.goal for each in goal.targets]
    named += challenge.rules.never.touch
    named += (name for each in challenge.rules.variant for name in each.things)
    return tuple(each for each in named if isinstance(each, str) and not room.called(each))


# --- what happened


def _track(room: Inventory, events: Iterable[Stamped]) -> _Track:
    happened = _last_try([each.event for each in events])
    poses: list[Pose] = []
    places: dict[int, Pose] = {}
    said, held, seconds, variables = [], "", 0.0, {}
    for event in happened:
        match event:
            case RunStarted(how=how) if how is not None:
                poses.append(how.pose)
            case Moved(pose=pose) | Turned(pose=pose) | Reset(pose=pose):
                poses.append(pose)
            case ThingsMoved():
                places = {each.index: each.pose for each in event.places}
            case Spoke():
                said.append(event.text)
            case GripperUsed():
                held = event.thing or event.kind if event.outcome is Grip.GRIPPED else ""
            case RunEnded():
                poses.append(event.pose)
                seconds, variables = event.seconds, dict(event.variables)
    items = tuple(_moved(each, places.get(each.index)) for each in room.items)
    return _Track(tuple(poses), items, tuple(said), held, tuple(happened), seconds, variables)


def begins_anew(event: Event) -> bool:
    """Whether the robot is put to its start with it."""
    return isinstance(event, Reset) or (
        isinstance(event, RunStarted) and event.how is not None and event.how.fresh
    )


def _last_try(events: Sequence[Event]) -> Sequence[Event]:
    starts = [at for at, each in enumerate(events) if begins_anew(each)]
    return events[starts[-1] :] if starts else events


def _moved(item: Item, pose: Pose | None) -> Item:
    if pose is None:
        return item
    return Item(
        item.index, item.name, item.kind, item.colour, pose.x, pose.y, item.half_width, item.half_height
    )


# --- goals


def _missing(goal: Goal, room: Inventory, track: _Track) -> Shortfall | None:
    """What is missing; None if the goal is met."""
    return _JUDGES[goal.kind](goal, room, track) if track.poses else Shortfall("goal-no-run", {})


def _at(goal: Goal, room: Inventory, track: _Track) -> Shortfall | None:
    assert goal.at is not None
    here = track.poses[-1]
    gap, item = _gap(here, goal.at, room, track.items)
    if gap <= goal.within + NEARLY:
        return None
    if item is None:
        x, y = _middle(goal.at)
        bearing = _bearing(x, y, here.x, here.y)
        values = {"steps": _whole(gap), "direction": bearing, "target": goal.at}
        return Shortfall("goal-at-place", values)
    bearing = _bearing(here.x, here.y, item.x, item.y)
    return Shortfall("goal-at-thing", {"steps": _whole(gap), "direction": bearing, "target": goal.at})


def _facing(goal: Goal, room: Inventory, track: _Track) -> Shortfall | None:  # noqa: ARG001
    assert goal.facing is not None
    heading = track.poses[-1].heading
    off = (heading - goal.facing + 180) % 360 - 180
    if abs(off) <= goal.within * DEGREES:
        return None
    code = "goal-facing-right" if off < 0 else "goal-facing-left"
    return Shortfall(code, {"degrees": round(abs(off))})


def _visited(goal: Goal, room: Inventory, track: _Track) -> Shortfall | None:
    assert goal.visited is not None
    if goal.any_order:
        gaps = ((each, _smallest_gap(each, room, track)) for each in goal.visited)
        missed = [each for each, gap in gaps if gap > goal.within + NEARLY]
    else:
        missed = list(goal.visited)
        for pose in _way(track.poses):
            while missed and _gap(pose, missed[0], room, track.items)[0] <= goal.within + NEARLY:
                missed.pop(0)
    return Shortfall("goal-visited", {"target": missed[0]}) if missed else None


def _near(goal: Goal, room: Inventory, track: _Track) -> Shortfall | None:
    assert goal.near is not None
    gap = _smallest_gap(goal.near, room, track)
    if gap <= goal.within + NEARLY:
        return None
    return Shortfall("goal-near", {"steps": _whole(gap), "target": goal.near})


def _thing(goal: Goal, room: Inventory, track: _Track) -> Shortfall | None:  # noqa: ARG001
    assert goal.thing is not None and goal.at is not None
    x, y = _middle(goal.at) if isinstance(goal.at, tuple) else _middle_of(goal.at, track.items)
    found = [each for each in track.items if each.is_called(goal.thing)]
    best = min(found, key=lambda each: hypot(each.x - x, each.y - y), default=None)
    if best is None:
        return Shortfall("goal-no-thing", {"target": goal.thing})
    gap = hypot(best.x - x, best.y - y)
    if gap <= goal.within + NEARLY:
        return None
    values = {"steps": _whole(gap), "direction": _bearing(x, y, best.x, best.y), "target": goal.thing}
    return Shortfall("goal-thing", values)


def _said(goal: Goal, room: Inventory, track: _Track) -> Shortfall | None:  # noqa: ARG001
    wanted = str(goal.said)
    if any(_same_text(wanted, each) for each in track.said):
        return None
    return Shortfall("goal-said", {"text": wanted})


def _counted(goal: Goal, room: Inventory, track: _Track) -> Shortfall | None:  # noqa: ARG001
    assert goal.counted is not None
    values = {_folded(name): value for name, value in track.variables.items()}
    value = values.get(_folded(goal.counted))
    if value is None:
        return Shortfall("goal-not-counted", {"name": goal.counted})
    if value == goal.value:
        return None
    return Shortfall("goal-counted", {"name": goal.counted, "value": value, "wanted": goal.value})


def _holds(goal: Goal, room: Inventory, track: _Track) -> Shortfall | None:
    assert goal.holds is not None
    wanted = [name for each in room.called(goal.holds) for name in (each.name, each.kind)]
    return None if track.held and track.held in wanted else Shortfall("goal-holds", {"target": goal.holds})


_JUDGES: Mapping[str, Callable[[Goal, Inventory, _Track], Shortfall | None]] = {
    "at": _at,
    "facing": _facing,
    "visited": _visited,
    "near": _near,
    "thing": _thing,
    "said": _said,
    "counted": _counted,
    "holds": _holds,
}


# --- what must not happen


def _ended_badly(track: _Track) -> Iterable[Shortfall]:
    error = track.error()
    if error is not None:
        yield Shortfall("goal-mistake", {"line": error.line, "message": error.message})
    elif track.is_stopped():
        yield Shortfall("goal-endless", {})


def _of_words(rules: Rules, track: _Track) -> Iterable[Shortfall]:
    """Words that belong to another lesson, and words that the lesson is about."""
    if not (rules.words or rules.required):
        return
    from language.keywords import canonical, topic
    from language.lexer import lex

    starts = (each.how for each in track.events if isinstance(each, RunStarted))
    texts = [each.text for each in starts if each is not None and not each.refused]
    named = (token[-1] for text in texts for token in lex(text).tokens)
    used = dict.fromkeys(topic(each) for each in named if canonical(each) is not None)
    for name in (each for each in used if rules.words and each not in map(topic, rules.words)):
        yield Shortfall("word-later", {"word": name})
    for missing in (each for each in map(topic, rules.required) if each not in used):
        yield Shortfall("word-missing", {"word": missing})


def _forbidden(rules: Rules, room: Inventory, track: _Track) -> Iterable[Shortfall]:
    moves = [each for each in track.events if isinstance(each, Moved | Turned)]
    if rules.never.bump and track.bumps():
        yield Shortfall("never-bump", {"times": track.bumps()})
    for name in rules.never.touch:
        wanted = room.called(name)
        touched = [(each.met.kind, each.met.name) for each in moves if each.met is not None]
        touched += [(thing.kind, thing.name) for each in moves for thing in each.pushed]
        if any((each.kind, each.name) in touched for each in wanted):
            yield Shortfall("never-touch", {"target": name})


def _over_limit(rules: Rules, track: _Track) -> Iterable[Shortfall]:
    limit = rules.limit
    for code, most, needed in (
        ("limit-commands", limit.commands, track.commands),
        ("limit-seconds", limit.seconds, ceil(track.seconds - NEARLY)),
        ("limit-steps", limit.steps, track.steps()),
        ("limit-turns", limit.turns, track.count(Turned)),
    ):
        if most is not None and needed > most:
            yield Shortfall(code, {"count": needed, "most": round(most)})


# --- distances


def _gap(pose: Pose, target: Target, room: Inventory, items: Sequence[Item]) -> tuple[float, Item | None]:
    """How far the robot is from a place, or from the nearest thing that is meant."""
    if not isinstance(target, str):
        return hypot(target[0] - pose.x, target[1] - pose.y), None
    gaps = [(_gap_to_item(pose, each, room.radius), each) for each in items if each.is_called(target)]
    return min(gaps, key=lambda each: each[0])


def _gap_to_item(pose: Pose, item: Item, radius: float) -> float:
    dx = max(abs(item.x - pose.x) - item.half_width, 0.0)
    dy = max(abs(item.y - pose.y) - item.half_height, 0.0)
    return max(hypot(dx, dy) - radius, 0.0)


def _smallest_gap(target: Target, room: Inventory, track: _Track) -> float:
    return min(_gap(each, target, room, track.items)[0] for each in _way(track.poses))


def _way(poses: Sequence[Pose]) -> Iterator[Pose]:
    """Where the robot was: straight from pose to pose, a tenth of a step apart at most."""
    yield poses[0]
    for start, end in pairwise(poses):
        points = max(1, ceil(hypot(end.x - start.x, end.y - start.y) * 10))
        yield from (_between(start, end, at / points) for at in range(1, points + 1))


def _between(start: Pose, end: Pose, part: float) -> Pose:
    return Pose(start.x + part * (end.x - start.x), start.y + part * (end.y - start.y), end.heading)


def _middle(target: Target) -> tuple[float, float]:
    assert not isinstance(target, str)
    return target


def _middle_of(name: str, items: Sequence[Item]) -> tuple[float, float]:
    found = next(each for each in items if each.is_called(name))
    return found.x, found.y


def _bearing(x: float, y: float, to_x: float, to_y: float) -> float:
    """Compass degrees from one place to another."""
    return degrees(atan2(to_x - x, to_y - y)) % 360.0


def _whole(steps: float) -> int:
    return max(1, round(steps))


# --- texts


def _folded(text: str) -> str:
    """Without case, accents, punctuation and doubled blanks."""
    plain = unicodedata.normalize("NFKD", text.casefold())
    kept = "".join(each if each.isalnum() else " " for each in plain if not unicodedata.combining(each))
    return " ".join(kept.split())


def _same_text(wanted: str, said: str) -> bool:
    """Numbers count by value, letters without case, accents and punctuation."""
    try:
        return float(wanted) == float(said)
    except ValueError:
        return _folded(wanted) == _folded(said)
