"""Whether a run met the goals of a challenge, and what is missing: the same events have the same verdict.

A distance to a thing is between the robot's body and the thing's box, so that 0 is touching. A distance to a
place is between the robot's middle and the place. All are in steps.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import lru_cache
from itertools import combinations
from math import ceil, hypot
from typing import TYPE_CHECKING, TypeVar
from unicodedata import normalize

from msgspec import Struct
from msgspec.structs import replace

from devices.ports.robot import Grip, Pose, StoppedBy
from donnie_tui.core import events
from donnie_tui.core.events import Event, Moved, RunEnded, RunStarted, Stamped, Turned, begins_anew, pose_of
from donnie_tui.core.program_files import read_to_the_end
from donnie_tui.core.wording import bearing
from language.keywords import canonical, topic
from language.lexer import lex
from language.source import fold_name
from worlds import challenges
from worlds.challenges import Answers, Area, Avoided, Challenge, Goal, Heading, Limit, Rules, Target

if TYPE_CHECKING:
    from sim.picture import Thing

DEGREES = 10.0
"""What a robot that faces a direction may be off by, for each step of ``within``."""
NEARLY = 0.05
"""Steps that don't count: a wheel's rounding."""


class Inventory(Struct, frozen=True):
    """What goals need to know of a world at a moment."""

    items: tuple[Thing, ...]
    radius: float
    """Of the robot's body, in steps."""
    robots: Mapping[str, Pose] = {}
    """Where the robots are, by name; the first one is meant if a goal names none."""

    def called(self, name: str) -> tuple[Thing, ...]:
        """All things that a goal means by that name."""
        return tuple(each for each in self.items if folded(name) in map(folded, names_of(each)))

    def robot_called(self, name: str) -> str | None:
        """The robot that a goal means; the first one where it names none."""
        if not name:
            return next(iter(self.robots), "")
        return next((each for each in self.robots if folded(each) == folded(name)), None)


def names_of(thing: Thing) -> tuple[str, ...]:
    """What a goal can call it: its name, its kind, or its colour with either."""
    own = tuple(filter(None, (thing.name, thing.kind)))
    return (*own, *(f"{thing.colour} {each}" for each in own if thing.colour))


_E = TypeVar("_E", bound=Struct)


class Track(Struct, frozen=True):
    """What was done since the robots were put to their starts."""

    happened: Sequence[tuple[str, Event]]
    """What happened, with the name of the robot."""
    moments: Sequence[Inventory]
    """The start, and whenever a movement began or ended, or things changed."""

    @property
    def end(self) -> Inventory:
        return self.moments[-1]

    @property
    def has_run(self) -> bool:
        return bool(self.of(RunStarted, events.Reset))

    def of(self, *kinds: type[_E]) -> list[_E]:
        """The events of some kinds."""
        return [each for _, each in self.happened if isinstance(each, kinds)]

    def last(self, kind: type[_E]) -> Mapping[str, _E]:
        """The last event of a kind, by robot."""
        return {robot: each for robot, each in self.happened if isinstance(each, kind)}

    @property
    def counts(self) -> Mapping[str, float]:
        """What there is of everything that can be limited or is kept. The robot that takes longest counts."""
        spent = [(robot, each.seconds) for robot, each in self.happened if isinstance(each, RunEnded)]
        each_one = (sum(time for robot, time in spent if robot == name) for name in self.end.robots)
        walks, turns = self.of(Moved), self.of(Turned)
        stopped = [*(each.stopped_by for each in walks), *(each.stopped_by for each in turns)]
        acts = self.of(Moved, Turned, events.Waited, events.Spoke, events.Scanned, events.GripperUsed)
        return {
            "commands": len(acts),
            "seconds": max(each_one),
            "steps": sum(each.walked for each in walks),
            "turns": len(turns),
            "bumps": stopped.count(StoppedBy.COLLISION) + stopped.count(StoppedBy.OBSTACLE),
        }

    @property
    def rounds(self) -> list[dict[str, events.HowStarted]]:
        """The programs and lines that ran, by robot, one after the other; those of one round overlapped."""
        rounds, running = list[dict[str, events.HowStarted]](), set[str]()
        for robot, each in self.happened:
            if isinstance(each, RunStarted) and each.how is not None and not each.how.refused:
                if not running or robot in rounds[-1]:
                    rounds.append({})
                rounds[-1][robot] = each.how
                running.add(robot)
            elif isinstance(each, RunEnded):
                running.discard(robot)
        return rounds

    @property
    def held(self) -> Mapping[str, str]:
        """By robot; empty if the gripper holds nothing."""
        used = self.last(events.GripperUsed).items()
        return {name: "" if it.outcome is Grip.RELEASED else it.thing or it.kind for name, it in used}

    def way(self, robot: str) -> Iterator[tuple[Pose, Inventory]]:
        """Where a robot and the things were: straight from pose to pose, a tenth of a step apart at most."""
        start = self.moments[0].robots[robot]
        yield start, self.moments[0]
        for each in self.moments[1:]:
            end = each.robots[robot]
            x, y = end.x - start.x, end.y - start.y
            points = max(1, ceil(hypot(x, y) * 10))
            parts = (at / points for at in range(1, points + 1))
            yield from ((Pose(start.x + it * x, start.y + it * y, end.heading), each) for it in parts)
            start = end

    def smallest_gap(self, target: Target, robot: str) -> float:
        """How near a robot came."""
        return min(gap_to(pose, target, room)[0] for pose, room in self.way(robot))


class Shortfall(Struct, frozen=True):
    """Why something isn't met, as the code of a sentence and its values.

    ``thing``, ``target`` and ``direction`` are words of the file and degrees, which the wording translates.
    """

    code: str
    values: Mapping[str, object]
    robot: str | None = None
    """Whose goal it is, if that names a robot."""


class Judgment(Struct, frozen=True):
    """The outcome of a run for a challenge."""

    track: Track
    of_goals: tuple[Shortfall | None, ...]
    """What each goal lacks, in the order of the file; None if it is met."""
    shortfalls: tuple[Shortfall, ...]
    """The most important first; empty if the challenge is solved."""

    @property
    def counts(self) -> dict[str, int]:
        """What is counted for a table."""
        kept = {name: round(self.track.counts[name]) for name in ("commands", "steps", "bumps")}
        return {"goals": len(self.of_goals), "met": self.of_goals.count(None), **kept}

    @property
    def is_solved(self) -> bool:
        return not self.shortfalls


def judge(
    challenge: Challenge, room: Inventory, happened: Iterable[Stamped], answers: Answers = None
) -> Judgment:
    """What the runs did for the challenge since the robots were put to their starts the last time."""
    track, rules = track_of(room, happened), challenge.rules
    numbered = enumerate(rules.goal, start=1)
    missing = tuple(next(_missing(goal, number, track, answers), None) for number, goal in numbered)
    shortfalls = [*_ended_badly(track), *_of_words(challenge, track), *filter(None, missing)]
    shortfalls += [*_forbidden(rules, track, answers), *_over_limit(rules, track)]
    return Judgment(track, missing, tuple(shortfalls))


def goals_of_end(room: Inventory, happened: Iterable[Stamped]) -> tuple[Goal, ...]:
    """The end of a solution as goals: where the robots and the things that it moved are, and what it said."""
    track = track_of(room, happened)
    said = tuple(each.text for each in track.of(events.Spoke))
    ends = ((name if len(room.robots) > 1 else "", end) for name, end in track.end.robots.items())
    goals = [Goal(at=(round(end.x, 1), round(end.y, 1)), robot=name, within=0.5) for name, end in ends]
    for start, end in zip(room.items, track.end.items, strict=True):
        if hypot(end.x - start.x, end.y - start.y) > NEARLY and names_of(end)[0] not in track.held.values():
            goals.append(Goal(thing=start.name or start.kind, at=(round(end.x, 1), round(end.y, 1))))
    goals += [Goal(holds=thing) for thing in track.held.values() if thing]
    return (*goals, Goal(said=said)) if said else tuple(goals)


_NAMING = ("at", "visited", "near", "thing", "holds", "robot", "robots", "touch", "things", "of", "origin")
"""The fields that name things and robots."""


def unknown_names(rules: Rules, room: Inventory) -> Iterator[tuple[str, str, str]]:
    """The names that no thing or robot of the world has: the table of the file, the key, and the name."""
    for table, part in rules.parts:
        for key in (each for each in part.__struct_fields__ if each in _NAMING):
            named = getattr(part, key)
            for name in (named,) if isinstance(named, str) else named or ():
                if isinstance(name, str) and not _is_known(name, key, room):
                    yield table, "from" if key == "origin" else key, name


def _is_known(name: str, key: str, room: Inventory) -> bool:
    if key in ("robot", "robots"):
        return room.robot_called(name) is not None
    is_no_thing = (key == "things" and name in room.robots) or (key == "origin" and name in ("start", "end"))
    return is_no_thing or bool(room.called(name))


# --- what happened


def track_of(room: Inventory, stamped: Iterable[Stamped]) -> Track:
    """What the runs did since the robots were put to their starts the last time."""
    first, given = room.robot_called("") or "", tuple((each.robot, each.event) for each in stamped)
    begun = {robot: at for at, (robot, each) in enumerate(given) if begins_anew(each)}
    happened = [(robot or first, each) for at, (robot, each) in enumerate(given) if at >= begun.get(robot, 0)]
    starts = {robot: pose_of(each) for robot, each in happened if begins_anew(each)}
    robots = dict(room.robots) | {robot: pose for robot, pose in starts.items() if pose is not None}
    moments = [replace(room, robots=robots)]
    for robot, event in happened:
        now, pose = moments[-1], pose_of(event)
        if isinstance(event, events.ThingsMoved):
            places = {each.index: each.pose for each in event.places}
            moved = ((each, places.get(each.index)) for each in room.items)
            items = tuple(each if it is None else replace(each, x=it.x, y=it.y) for each, it in moved)
            moments.append(replace(now, items=items))
        elif pose is not None:
            moments.append(replace(now, robots={**now.robots, robot: pose}))
    return Track(happened, moments)


# --- goals


def _missing(goal: Goal, number: int, track: Track, answers: Answers) -> Iterator[Shortfall]:
    """What is missing first; nothing if the goal is met."""
    if not track.has_run:
        yield Shortfall("goal-no-run", {})
    elif answers is None or goal.is_sensed:
        yield from _lacking(goal, track)
    elif not answers.get(goal):
        yield Shortfall("goal-answered-no" if goal in answers else "goal-asked", {"number": number})


def _lacking(goal: Goal, track: Track) -> Iterator[Shortfall]:
    """What a goal lacks, with the robot that it names."""
    for found in getattr(_Lacking(goal, track), goal.kind)(getattr(goal, goal.kind)):
        yield replace(found, robot=goal.robot or found.robot)


class _Lacking:
    """What a goal lacks, by a method for each key that says what a goal is, with the value of that key."""

    def __init__(self, goal: Goal, track: Track) -> None:
        self._goal, self._track = goal, track
        self._robot = track.end.robot_called(goal.robot) or ""
        self._most = goal.within + NEARLY

    def at(self, target: Target) -> Iterator[Shortfall]:
        end = self._track.end
        gap, direction = gap_to(end.robots[self._robot], target, end)
        if gap > self._most:
            code = "goal-at-thing" if isinstance(target, str) else "goal-at-place"
            yield Shortfall(code, {"steps": in_steps(gap), "direction": direction, "target": target})

    def facing(self, wanted: Heading) -> Iterator[Shortfall]:
        heading = self._track.end.robots[self._robot].heading
        off = (heading - challenges.degrees_of(wanted) + 180) % 360 - 180
        if abs(off) > self._goal.within * DEGREES:
            code = "goal-facing-right" if off < 0 else "goal-facing-left"
            yield Shortfall(code, {"degrees": round(abs(off))})

    def visited(self, targets: Sequence[Target]) -> Iterator[Shortfall]:
        missed, track = [*targets], self._track
        if self._goal.any_order:
            missed = [each for each in targets if track.smallest_gap(each, self._robot) > self._most]
        else:
            for pose, room in track.way(self._robot):
                while missed and gap_to(pose, missed[0], room)[0] <= self._most:
                    missed.pop(0)
        yield from (Shortfall("goal-visited", {"target": each}) for each in missed)

    def near(self, target: Target) -> Iterator[Shortfall]:
        gap = self._track.smallest_gap(target, self._robot)
        if gap > self._most:
            yield Shortfall("goal-near", {"steps": in_steps(gap), "target": target})

    def area(self, area: Area) -> Iterator[Shortfall]:
        """Reached at any time; with ``stay`` not left afterwards."""
        is_inside = False
        for pose, _ in self._track.way(self._robot):
            gap, direction = way_out(pose.x, pose.y, area)
            if is_inside and self._goal.stay and gap > NEARLY:
                yield Shortfall("goal-area-left", {"direction": direction, "area": area})
            is_inside = is_inside or gap <= NEARLY
        if not is_inside:
            yield Shortfall("goal-area", {"steps": in_steps(gap), "direction": direction, "area": area})

    def thing(self, name: str) -> Iterator[Shortfall]:
        end, at = self._track.end, self._goal.at
        of_thing = [((each.x, each.y),) * 2 for each in end.called(at)] if isinstance(at, str) else []
        area = (*self._goal.areas, *of_thing)[0]
        gap, direction = min(way_out(each.x, each.y, area) for each in end.called(name))
        code, most = ("goal-thing", self._most) if self._goal.area is None else ("goal-thing-area", NEARLY)
        if gap > most:
            yield Shortfall(code, {"steps": in_steps(gap), "direction": direction, "target": name})

    def said(self, wanted: object) -> Iterator[Shortfall]:
        """A text, or several in this order; other sentences may come between."""
        all_said = [_parts(each.text) for each in self._track.of(events.Spoke)]
        following, before = iter(all_said), ""
        for each in map(str, wanted if isinstance(wanted, tuple) else (wanted,)):
            if _parts(each) not in following:
                code = "goal-said-order" if before and _parts(each) in all_said else "goal-said"
                yield Shortfall(code, {"text": each, "before": before})
            before = each

    def counted(self, name: str) -> Iterator[Shortfall]:
        ended = self._track.last(RunEnded).get(self._robot)
        variables = {folded(each): value for each, value in (ended.variables.items() if ended else ())}
        value, wanted = variables.get(folded(name)), self._goal.value
        if value is None:
            yield Shortfall("goal-not-counted", {"name": name})
        elif value != wanted:
            yield Shortfall("goal-counted", {"name": name, "value": value, "wanted": wanted})

    def holds(self, thing: str) -> Iterator[Shortfall]:
        wanted = [name for each in self._track.end.called(thing) for name in (each.name, each.kind) if name]
        if self._track.held.get(self._robot) not in wanted:
            yield Shortfall("goal-holds", {"target": thing})

    def robots(self, robots: Sequence[str]) -> Iterator[Shortfall]:
        """All at their place at the end; without a place, side by side at some moment."""
        end = self._track.end
        names = [end.robot_called(each) or "" for each in robots]
        if self._goal.at is not None:
            alone = (replace(self._goal, robots=None, robot=each) for each in names)
            yield from (found for each in alone for found in _lacking(each, self._track))
            return
        for one, other in combinations(names, 2):
            ways = ((each.robots[one], each.robots[other]) for each in self._track.moments)
            gap = max(min(hypot(a.x - b.x, a.y - b.y) for a, b in ways) - 2 * end.radius, 0.0)
            if gap > self._most:
                yield Shortfall("goal-not-together", {"first": one, "second": other, "steps": in_steps(gap)})


# --- what must not happen


def _ended_badly(track: Track) -> Iterator[Shortfall]:
    """The first mistake of the last run of a robot, or that one was stopped."""
    errors = dict[str, events.Error]()
    for robot, event in track.happened:
        if isinstance(event, RunStarted):
            errors.pop(robot, None)
        elif isinstance(event, events.Error):
            errors.setdefault(robot, event)
    for error in list(errors.values())[:1]:
        yield Shortfall("goal-mistake", {"line": error.line, "message": error.message})
    if not errors and events.Outcome.STOPPED in (each.outcome for each in track.last(RunEnded).values()):
        yield Shortfall("goal-endless", {})


def _of_words(challenge: Challenge, track: Track) -> Iterable[Shortfall]:
    """Words that belong to another lesson, and words that the lesson is about."""
    rules = challenge.rules
    if not (rules.words or rules.required):
        return
    used = _words_in("\n".join(how.text for each in track.rounds for how in each.values()))
    for name in (each for each in used if rules.words and each not in map(topic, rules.words)):
        number = _lesson_of(name, challenge.name)
        yield Shortfall("word-in-lesson" if number else "word-later", {"word": name, "number": number})
    for missing in (each for each in map(topic, rules.required) if each not in used):
        yield Shortfall("word-missing", {"word": missing})


def _words_in(program: str) -> tuple[str | None, ...]:
    """The first words of its commands, in no language."""
    named = (token[-1] for token in lex(program).tokens)
    return tuple(dict.fromkeys(topic(each) for each in named if canonical(each) is not None))


def _lesson_of(word: str | None, now: str) -> int:
    """The number of the first challenge after this one whose solution needs the word; 0 if none does."""
    shipped = challenges.names()
    passed = shipped.index(now) + 1 if now in shipped else 0
    for number, name in enumerate(shipped, start=1):
        if word in _words_in(read_to_the_end(challenges.find(name).solution())):
            return number if number > passed else 0
    return 0


def _forbidden(rules: Rules, track: Track, answers: Answers) -> Iterable[Shortfall]:
    bumps = track.counts["bumps"]
    if rules.never.bump and bumps:
        yield Shortfall("never-bump", {"times": bumps})
    for each in rules.never.avoided if track.has_run else ():
        is_broken = _is_broken(each, track) if answers is None else answers.get(each)
        if is_broken is not False:
            code = "never-asked" if is_broken is None else f"never-{each.how}"
            yield Shortfall(code, {"target": each.target, "most": in_steps(each.within)})


def _is_broken(rule: Avoided, track: Track) -> bool:
    if rule.how == "near":
        return any(track.smallest_gap(rule.target, each) < rule.within for each in track.end.robots)
    moves: list[Moved | Turned] = [*track.of(Moved), *track.of(Turned)]
    touched = [(each.met.kind, each.met.name) for each in moves if each.met is not None]
    touched += [(thing.kind, thing.name) for each in moves for thing in each.pushed]
    return any((each.kind, each.name) in touched for each in track.end.called(rule.target))


def _over_limit(rules: Rules, track: Track) -> Iterator[Shortfall]:
    counts = track.counts
    for name in Limit.__struct_fields__:
        most, needed = getattr(rules.limit, name), ceil(counts[name] - NEARLY)
        if most is not None and needed > most:
            yield Shortfall(f"limit-{name}", {"count": needed, "most": round(most)})


# --- distances


def gap_to(pose: Pose, target: Target, room: Inventory) -> tuple[float, float]:
    """How far the robot is from a place and where from there, or how far and where the nearest thing is."""
    if not isinstance(target, str):
        return way_out(pose.x, pose.y, (target, target))
    gaps = [(way_out(pose.x, pose.y, box_of(it))[0] - room.radius, it) for it in room.called(target)]
    gap, nearest = min(gaps, key=lambda each: max(each[0], 0.0))
    return max(gap, 0.0), bearing(pose.x, pose.y, nearest.x, nearest.y)


def box_of(thing: Thing) -> Area:
    """Two opposite corners."""
    half_width, half_depth = thing.width / 2, thing.depth / 2
    return (thing.x - half_width, thing.y - half_depth), (thing.x + half_width, thing.y + half_depth)


def way_out(x: float, y: float, area: Area) -> tuple[float, float]:
    """How far a place is from an area, 0 within it, and in which direction from there."""
    west, south, east, north = challenges.sides_of(area)
    nearest = min(max(x, west), east), min(max(y, south), north)
    return hypot(x - nearest[0], y - nearest[1]), bearing(*nearest, x, y)


# --- numbers and texts


def in_steps(steps: float) -> int:
    """A distance for a sentence: whole steps, at least 1."""
    return max(1, round(steps))


_NUMBER = re.compile(r"([-−]?\d+(?:[.,]\d+)?)")


def _parts(text: str) -> list[str | float]:
    """The words and numbers of a text: numbers count by value, letters without case, accents, punctuation."""
    parts: list[str | float] = []
    for at, piece in enumerate(_NUMBER.split(text)):
        parts += [float(piece.replace("−", "-").replace(",", "."))] if at % 2 else folded(piece).split()
    return parts


@lru_cache(1000)
def folded(text: str) -> str:
    """The text without case, accents, punctuation and doubled blanks."""
    return " ".join(re.findall(r"[^\W_]+", fold_name(normalize("NFKC", text))))
