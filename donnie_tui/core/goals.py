"""Whether a run met the goals of a challenge, and what is missing: a pure function of its events.

A distance to a thing is between the robot's body and the thing's box, so that 0 is touching. A distance to a
place is between the robot's middle and the place. All are in steps.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from itertools import combinations, pairwise
from math import atan2, ceil, degrees, hypot
from typing import Any, TypeAlias

from msgspec import Struct
from msgspec.structs import replace

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
from worlds import challenges
from worlds.challenges import Area, Avoided, Challenge, Goal, Heading, Place, Rules, Target, Unsensed

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

    @property
    def names(self) -> tuple[str, ...]:
        """What a goal can call it: its name, its kind, or its colour with either."""
        own = tuple(filter(None, (self.name, self.kind)))
        return (*own, *(f"{self.colour} {each}" for each in own if self.colour))

    def is_called(self, name: str) -> bool:
        return folded(name) in map(folded, self.names)


class Inventory(Struct, frozen=True):
    """What goals need to know of a world."""

    items: tuple[Item, ...]
    radius: float
    """Of the robot's body, in steps."""
    robots: Mapping[str, Pose] = {}
    """Where the robots start, by name; the first one is meant where a goal names none."""

    def called(self, name: str) -> tuple[Item, ...]:
        """All things that a goal means by that name."""
        return tuple(each for each in self.items if each.is_called(name))

    def robot_called(self, name: str) -> str | None:
        """The robot that a goal means; the first one where it names none."""
        if not name:
            return next(iter(self.robots), "")
        return next((each for each in self.robots if folded(each) == folded(name)), None)


class Moment(Struct, frozen=True):
    """Where a robot is, and the things while it came there."""

    pose: Pose
    items: tuple[Item, ...]


class Track(Struct, frozen=True):
    """What was done since the robots were put to their starts."""

    room: Inventory
    """As it was then."""
    ways: Mapping[str, tuple[Moment, ...]]
    """By robot: where a movement began or ended, and where things changed; straight in between."""
    meetings: Sequence[Mapping[str, Pose]]
    """Where the robots were at the same moment, whenever one had moved."""
    items: tuple[Item, ...]
    """The things where they are at the end."""
    said: tuple[str, ...]
    held: Mapping[str, str]
    """By robot; empty if the gripper holds nothing."""
    events: tuple[Event, ...]
    seconds: float
    """Of robot time, of the robot that took longest."""
    variables: Mapping[str, Mapping[str, int]]
    """By robot."""
    errors: Mapping[str, Error]
    """The first mistake of each robot's last run."""
    is_stopped: bool
    """Whether a robot's last run was."""

    @property
    def has_run(self) -> bool:
        return any(isinstance(each, RunStarted | Reset) for each in self.events)

    def count(self, *kinds: type[Event]) -> int:
        return sum(isinstance(each, kinds) for each in self.events)

    @property
    def commands(self) -> int:
        return self.count(Moved, Turned, Waited, Spoke, Scanned, GripperUsed)

    @property
    def steps(self) -> int:
        return sum(each.walked for each in self.events if isinstance(each, Moved))

    @property
    def bumps(self) -> int:
        moves = [each for each in self.events if isinstance(each, Moved | Turned)]
        return sum(each.stopped_by in (StoppedBy.COLLISION, StoppedBy.OBSTACLE) for each in moves)


class Shortfall(Struct, frozen=True):
    """Why something isn't met, as the code of a sentence and its values.

    ``thing``, ``target`` and ``direction`` are words of the file and degrees, which the wording translates.
    """

    code: str
    values: Mapping[str, object]


class Judgment(Struct, frozen=True):
    """The outcome of a run for a challenge."""

    track: Track
    of_goals: tuple[Shortfall | None, ...]
    """What each goal lacks, in the order of the file; None if it is met."""
    shortfalls: tuple[Shortfall, ...]
    """The most important first; empty if the challenge is solved."""

    @property
    def goals(self) -> int:
        return len(self.of_goals)

    @property
    def met(self) -> int:
        return self.of_goals.count(None)

    @property
    def is_solved(self) -> bool:
        return not self.shortfalls


def judge(
    challenge: Challenge,
    room: Inventory,
    events: Iterable[Stamped],
    answers: Mapping[Unsensed, bool] | None = None,
) -> Judgment:
    """What the runs did for the challenge since the robots were put to their starts the last time.

    ``answers``: of a real robot, what the learner said about what it can't sense.
    """
    track, rules = track_of(room, events), challenge.rules
    missing = tuple(
        _missing(goal, track)
        if answers is None or goal.is_sensed or not track.has_run
        else _answered(answers.get(goal), number)
        for number, goal in enumerate(rules.goal, start=1)
    )
    shortfalls = (
        *_ended_badly(track),
        *_of_words(challenge, track),
        *(each for each in missing if each is not None),
        *_forbidden(rules, track, answers),
        *_over_limit(rules, track),
    )
    return Judgment(track, missing, shortfalls)


GoalPlace: TypeAlias = tuple[int, float, float, float, float]
"""The number of a goal, and west, south, east and north of its place."""


def places_of(rules: Rules) -> tuple[GoalPlace, ...]:
    """The goals with a place or an area, for the map."""
    found: list[GoalPlace] = []
    for number, goal in enumerate(rules.goal, start=1):
        for target in (goal.at, goal.near, *(goal.visited or ())):
            if target is not None and not isinstance(target, str):
                found.append((number, *target, *target))
        if goal.area is not None:
            (west, east), (south, north) = (sorted(each) for each in zip(*goal.area, strict=True))
            found.append((number, west, south, east, north))
    return tuple(found)


def goals_of_end(room: Inventory, events: Iterable[Stamped]) -> tuple[Goal, ...]:
    """The end of a solution as goals: where the robots and the things that it moved are, and what it said."""
    track = track_of(room, events)
    names = track.ways if len(room.robots) > 1 else ("",)
    ends = ((name, _end(name, track)) for name in names)
    goals = [Goal(at=(round(end.x, 1), round(end.y, 1)), robot=name, within=0.5) for name, end in ends]
    for start, end in zip(room.items, track.items, strict=True):
        if hypot(end.x - start.x, end.y - start.y) > NEARLY and end.name not in track.held.values():
            goals.append(Goal(thing=start.name or start.kind, at=(round(end.x, 1), round(end.y, 1))))
    goals += [Goal(holds=thing) for thing in track.held.values() if thing]
    return (*goals, Goal(said=track.said)) if track.said else tuple(goals)


_NAMING = {
    "goal": ("at", "visited", "near", "thing", "holds", "robot", "robots"),
    "never": ("touch", "near"),
    "variant": ("things",),
    "question": ("of", "origin"),
}
"""What names things and robots, by table."""


def unknown_names(rules: Rules, room: Inventory) -> Iterator[tuple[str, str, str]]:
    """The names that no thing or robot of the world has: the table of the file, the key, and the name."""
    for table, keys in _NAMING.items():
        found = getattr(rules, table)
        several = ((f"{table}[{at}]", each) for at, each in enumerate(found)) if table != "never" else ()
        for place, one in several or ((table, found),):
            for key, named in ((key, getattr(one, key)) for key in keys):
                for name in (named,) if isinstance(named, str) else named or ():
                    if isinstance(name, str) and not _is_known(name, key, room):
                        yield place, "from" if key == "origin" else key, name


def _is_known(name: str, key: str, room: Inventory) -> bool:
    if key in ("robot", "robots"):
        return room.robot_called(name) is not None
    is_no_thing = (key == "things" and name in room.robots) or (key == "origin" and name in ("start", "end"))
    return is_no_thing or bool(room.called(name))


# --- what happened


def track_of(room: Inventory, events: Iterable[Stamped]) -> Track:
    """What the runs did since the robots were put to their starts the last time."""
    happened = last_try(tuple(events))
    first = room.robot_called("") or ""
    here, meetings = dict(room.robots), list[Mapping[str, Pose]]()
    items = room.items
    ways = {name: [Moment(pose, items)] for name, pose in room.robots.items()}
    said, held, variables = list[str](), dict[str, str](), dict[str, Mapping[str, int]]()
    errors, outcomes, seconds = dict[str, Error](), dict[str, Outcome](), dict[str, float]()
    for stamped in happened:
        robot, event = stamped.robot or first, stamped.event
        pose = None
        match event:
            case RunStarted():
                errors.pop(robot, None)
                outcomes.pop(robot, None)
                pose = event.how.pose if event.how is not None else None
                if begins_anew(event):
                    ways[robot] = []
            case Reset():
                pose, ways[robot] = event.pose, []
            case Moved() | Turned():
                pose = event.pose
            case ThingsMoved():
                places = {each.index: each.pose for each in event.places}
                items = tuple(_moved(each, places.get(each.index)) for each in room.items)
                for way in filter(None, ways.values()):
                    way.append(Moment(way[-1].pose, items))
            case Spoke():
                said.append(event.text)
            case GripperUsed():
                held[robot] = event.thing or event.kind if event.outcome is Grip.GRIPPED else ""
            case Error():
                errors.setdefault(robot, event)
            case RunEnded():
                pose, outcomes[robot] = event.pose, event.outcome
                variables[robot] = dict(event.variables)
                seconds[robot] = seconds.get(robot, 0.0) + event.seconds
        if pose is not None:
            ways.setdefault(robot, []).append(Moment(pose, items))
            here[robot] = pose
            meetings.append(dict(here))
    return Track(
        room,
        {name: tuple(way) for name, way in ways.items()},
        meetings,
        items,
        tuple(said),
        held,
        tuple(each.event for each in happened),
        max(seconds.values(), default=0.0),
        variables,
        errors,
        Outcome.STOPPED in outcomes.values(),
    )


def begins_anew(event: Event) -> bool:
    """Whether the robot is put to its start with it."""
    return isinstance(event, Reset) or (
        isinstance(event, RunStarted) and event.how is not None and event.how.fresh
    )


def last_try(events: Sequence[Stamped]) -> tuple[Stamped, ...]:
    """What happened since each robot was put to its start."""
    starts = {each.robot: at for at, each in enumerate(events) if begins_anew(each.event)}
    return tuple(each for at, each in enumerate(events) if at >= starts.get(each.robot, 0))


def _moved(item: Item, pose: Pose | None) -> Item:
    return item if pose is None else replace(item, x=pose.x, y=pose.y)


# --- goals


def _missing(goal: Goal, track: Track) -> Shortfall | None:
    """What is missing; None if the goal is met."""
    if not track.has_run:
        return Shortfall("goal-no-run", {})
    found = _JUDGES[goal.kind](goal, getattr(goal, goal.kind), track)
    return found if found is None or not goal.robot else _of_robot(found, goal.robot)


def _of_robot(found: Shortfall, name: str) -> Shortfall:
    return Shortfall(found.code, {**found.values, "robot": name})


def _answered(answer: bool | None, number: int) -> Shortfall | None:
    """What the learner said about a goal."""
    code = "goal-asked" if answer is None else "goal-answered-no"
    return None if answer else Shortfall(code, {"number": number})


def _way(robot: str, track: Track) -> Sequence[Moment]:
    """Where the robot of that name was, at least its start."""
    ways = track.ways
    return ways.get(track.room.robot_called(robot) or "") or next(iter(ways.values()))


def _end(robot: str, track: Track) -> Pose:
    return _way(robot, track)[-1].pose


def _at(goal: Goal, target: Target, track: Track, robot: str | None = None) -> Shortfall | None:
    """``robot``: one of several that are meant, in place of the goal's."""
    here = _end(goal.robot if robot is None else robot, track)
    gap, item = gap_to(here, target, track.room, track.items)
    if gap <= goal.within + NEARLY:
        return None
    if item is not None:
        code, direction = "goal-at-thing", bearing(here.x, here.y, item.x, item.y)
    else:
        code, direction = "goal-at-place", bearing(*_middle(target, track), here.x, here.y)
    return Shortfall(code, {"steps": in_steps(gap), "direction": direction, "target": target})


def _facing(goal: Goal, wanted: Heading, track: Track) -> Shortfall | None:
    off = (_end(goal.robot, track).heading - challenges.degrees_of(wanted) + 180) % 360 - 180
    if abs(off) <= goal.within * DEGREES:
        return None
    code = "goal-facing-right" if off < 0 else "goal-facing-left"
    return Shortfall(code, {"degrees": round(abs(off))})


def _visited(goal: Goal, targets: Sequence[Target], track: Track) -> Shortfall | None:
    way, room = _way(goal.robot, track), track.room
    if goal.any_order:
        gaps = ((each, smallest_gap(each, room, way)) for each in targets)
        missed = [each for each, gap in gaps if gap > goal.within + NEARLY]
    else:
        missed = [*targets]
        for pose, items in every_tenth(way):
            while missed and gap_to(pose, missed[0], room, items)[0] <= goal.within + NEARLY:
                missed.pop(0)
    return Shortfall("goal-visited", {"target": missed[0]}) if missed else None


def _near(goal: Goal, target: Target, track: Track) -> Shortfall | None:
    gap = smallest_gap(target, track.room, _way(goal.robot, track))
    if gap <= goal.within + NEARLY:
        return None
    return Shortfall("goal-near", {"steps": in_steps(gap), "target": target})


def _area(goal: Goal, area: Area, track: Track) -> Shortfall | None:
    """Reached at any time; with ``stay`` not left afterwards."""
    is_inside = False
    for pose, _ in every_tenth(_way(goal.robot, track)):
        gap, direction = way_out(pose.x, pose.y, area)
        if is_inside and goal.stay and gap > NEARLY:
            return Shortfall("goal-area-left", {"direction": direction, "area": area})
        is_inside = is_inside or gap <= NEARLY
    if is_inside:
        return None
    return Shortfall("goal-area", {"steps": in_steps(gap), "direction": direction, "area": area})


def _thing(goal: Goal, name: str, track: Track) -> Shortfall | None:
    found = [each for each in track.items if each.is_called(name)]
    if not found:
        return Shortfall("goal-no-thing", {"target": name})
    if goal.area is not None:
        code, within, area = "goal-thing-area", 0.0, goal.area
    else:
        assert goal.at is not None
        code, within, area = "goal-thing", goal.within, (_middle(goal.at, track),) * 2
    gap, direction = min(way_out(each.x, each.y, area) for each in found)
    if gap <= within + NEARLY:
        return None
    return Shortfall(code, {"steps": in_steps(gap), "direction": direction, "target": name})


def _middle(target: Target, track: Track) -> Place:
    if not isinstance(target, str):
        return target
    found = next(each for each in track.items if each.is_called(target))
    return found.x, found.y


def _said(_: Goal, wanted: object, track: Track) -> Shortfall | None:
    """A text, or several in this order; other sentences may come between."""
    said, before = iter(track.said), ""
    for each in map(str, wanted if isinstance(wanted, tuple) else (wanted,)):
        if not any(_is_same_text(each, one) for one in said):
            is_said = before and any(_is_same_text(each, one) for one in track.said)
            return Shortfall("goal-said-order" if is_said else "goal-said", {"text": each, "before": before})
        before = each
    return None


def _counted(goal: Goal, name: str, track: Track) -> Shortfall | None:
    variables = track.variables.get(track.room.robot_called(goal.robot) or "", {})
    value = {folded(each): value for each, value in variables.items()}.get(folded(name))
    if value is None:
        return Shortfall("goal-not-counted", {"name": name})
    if value == goal.value:
        return None
    return Shortfall("goal-counted", {"name": name, "value": value, "wanted": goal.value})


def _holds(goal: Goal, thing: str, track: Track) -> Shortfall | None:
    wanted = [name for each in track.room.called(thing) for name in (each.name, each.kind)]
    held = track.held.get(track.room.robot_called(goal.robot) or "", "")
    return None if held and held in wanted else Shortfall("goal-holds", {"target": thing})


def _robots(goal: Goal, robots: Sequence[str], track: Track) -> Shortfall | None:
    """All at their place at the end; without a place, side by side at some moment."""
    names = [track.room.robot_called(each) or "" for each in robots]
    if goal.at is not None:
        missing = ((_at(goal, goal.at, track, name), name) for name in names)
        return next((_of_robot(found, name) for found, name in missing if found is not None), None)
    for one, other in combinations(names, 2):
        ways = ((each[one], each[other]) for each in track.meetings)
        gaps = [hypot(a.x - b.x, a.y - b.y) - 2 * track.room.radius for a, b in ways]
        gap = max(min(gaps, default=0.0), 0.0)
        if gap > goal.within + NEARLY:
            return Shortfall("goal-not-together", {"first": one, "second": other, "steps": in_steps(gap)})
    return None


_JUDGES: Mapping[str, Callable[[Goal, Any, Track], Shortfall | None]] = {
    "at": _at,
    "facing": _facing,
    "visited": _visited,
    "near": _near,
    "area": _area,
    "thing": _thing,
    "said": _said,
    "counted": _counted,
    "holds": _holds,
    "robots": _robots,
}
"""By the key that says what a goal is; with the value of that key."""


# --- what must not happen


def _ended_badly(track: Track) -> Iterable[Shortfall]:
    for error in list(track.errors.values())[:1]:
        yield Shortfall("goal-mistake", {"line": error.line, "message": error.message})
    if track.is_stopped and not track.errors:
        yield Shortfall("goal-endless", {})


def _of_words(challenge: Challenge, track: Track) -> Iterable[Shortfall]:
    """Words that belong to another lesson, and words that the lesson is about."""
    rules = challenge.rules
    if not (rules.words or rules.required):
        return
    from language.keywords import topic

    starts = (each.how for each in track.events if isinstance(each, RunStarted))
    used = _words_in("\n".join(each.text for each in starts if each is not None and not each.refused))
    for name in (each for each in used if rules.words and each not in map(topic, rules.words)):
        number = _lesson_of(name, challenge.name)
        yield Shortfall("word-in-lesson" if number else "word-later", {"word": name, "number": number})
    for missing in (each for each in map(topic, rules.required) if each not in used):
        yield Shortfall("word-missing", {"word": missing})


def _words_in(program: str) -> tuple[str | None, ...]:
    """The first words of its commands, in no language."""
    from language.keywords import canonical, topic
    from language.lexer import lex

    named = (token[-1] for token in lex(program).tokens)
    return tuple(dict.fromkeys(topic(each) for each in named if canonical(each) is not None))


def _lesson_of(word: str | None, now: str) -> int:
    """The number of the first challenge after this one whose solution needs the word; 0 if none does."""
    from donnie_tui.core.program_files import read_to_the_end

    shipped = challenges.names()
    passed = shipped.index(now) + 1 if now in shipped else 0
    for number, name in enumerate(shipped, start=1):
        if word in _words_in(read_to_the_end(challenges.find(name).solution())):
            return number if number > passed else 0
    return 0


def _forbidden(rules: Rules, track: Track, answers: Mapping[Unsensed, bool] | None) -> Iterable[Shortfall]:
    if rules.never.bump and track.bumps:
        yield Shortfall("never-bump", {"times": track.bumps})
    for each in rules.never.avoided if track.has_run else ():
        is_broken = _is_broken(each, track) if answers is None else answers.get(each)
        if is_broken is not False:
            code = "never-asked" if is_broken is None else f"never-{each.how}"
            yield Shortfall(code, {"target": each.target, "most": in_steps(each.within)})


def _is_broken(rule: Avoided, track: Track) -> bool:
    if rule.how == "near":
        ways = track.ways.values()
        return min(smallest_gap(rule.target, track.room, way) for way in ways) < rule.within
    moves = [each for each in track.events if isinstance(each, Moved | Turned)]
    touched = [(each.met.kind, each.met.name) for each in moves if each.met is not None]
    touched += [(thing.kind, thing.name) for each in moves for thing in each.pushed]
    return any((each.kind, each.name) in touched for each in track.room.called(rule.target))


def _over_limit(rules: Rules, track: Track) -> Iterable[Shortfall]:
    limit = rules.limit
    for code, most, needed in (
        ("limit-commands", limit.commands, track.commands),
        ("limit-seconds", limit.seconds, ceil(track.seconds - NEARLY)),
        ("limit-steps", limit.steps, track.steps),
        ("limit-turns", limit.turns, track.count(Turned)),
    ):
        if most is not None and needed > most:
            yield Shortfall(code, {"count": needed, "most": round(most)})


# --- distances


def gap_to(pose: Pose, target: Target, room: Inventory, items: Sequence[Item]) -> tuple[float, Item | None]:
    """How far the robot is from a place, or from the nearest thing that is meant."""
    if not isinstance(target, str):
        return hypot(target[0] - pose.x, target[1] - pose.y), None
    gaps = [(_gap_to_item(pose, each, room.radius), each) for each in items if each.is_called(target)]
    return min(gaps, key=lambda each: each[0])


def _gap_to_item(pose: Pose, item: Item, radius: float) -> float:
    dx = max(abs(item.x - pose.x) - item.half_width, 0.0)
    dy = max(abs(item.y - pose.y) - item.half_height, 0.0)
    return max(hypot(dx, dy) - radius, 0.0)


def smallest_gap(target: Target, room: Inventory, way: Sequence[Moment]) -> float:
    """To the nearest that the robot came."""
    return min(gap_to(pose, target, room, items)[0] for pose, items in every_tenth(way))


def every_tenth(way: Sequence[Moment]) -> Iterator[tuple[Pose, tuple[Item, ...]]]:
    """Where the robot and the things were: straight from pose to pose, a tenth of a step apart at most."""
    yield way[0].pose, way[0].items
    for before, after in pairwise(way):
        start, end = before.pose, after.pose
        points = max(1, ceil(hypot(end.x - start.x, end.y - start.y) * 10))
        yield from ((_between(start, end, at / points), after.items) for at in range(1, points + 1))


def _between(start: Pose, end: Pose, part: float) -> Pose:
    return Pose(start.x + part * (end.x - start.x), start.y + part * (end.y - start.y), end.heading)


def way_out(x: float, y: float, area: Area) -> tuple[float, float]:
    """How far a place is from an area, 0 within it, and in which direction from there."""
    (west, east), (south, north) = (sorted(each) for each in zip(*area, strict=True))
    nearest_x, nearest_y = min(max(x, west), east), min(max(y, south), north)
    return hypot(x - nearest_x, y - nearest_y), bearing(nearest_x, nearest_y, x, y)


def bearing(x: float, y: float, to_x: float, to_y: float) -> float:
    """Compass degrees from one place to another."""
    return degrees(atan2(to_x - x, to_y - y)) % 360.0


# --- numbers and texts


def in_steps(steps: float) -> int:
    """A distance for a sentence: whole steps, at least 1."""
    return max(1, round(steps))


_NUMBER = re.compile(r"[-−]?\d+(?:[.,]\d+)?")


def _is_same_text(wanted: str, said: str) -> bool:
    """Numbers count by value, letters without case, accents and punctuation."""
    return _parts(wanted) == _parts(said)


def _parts(text: str) -> list[str | float]:
    """The words and numbers of a text."""
    parts: list[str | float] = []
    at = 0
    for found in _NUMBER.finditer(text):
        parts += folded(text[at : found.start()]).split()
        parts.append(float(found[0].replace("−", "-").replace(",", ".")))
        at = found.end()
    return parts + folded(text[at:]).split()


def folded(text: str) -> str:
    """The text without case, accents, punctuation and doubled blanks."""
    plain = unicodedata.normalize("NFKD", text.casefold())
    kept = "".join(each if each.isalnum() else " " for each in plain if not unicodedata.combining(each))
    return " ".join(kept.split())
