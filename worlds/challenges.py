"""Challenges as files: a world, a task in words, and goals that a run meets or doesn't.

A challenge is ``NAME.toml`` with its solution ``NAME.solution.gd`` next to it. Only these two and its
world are read; nothing in the file names a place outside its folder. A mistake is a
``BadChallenge``: a code, the line and the names that could have been meant.
"""

from __future__ import annotations

import os
import re
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from functools import cache
from itertools import pairwise
from pathlib import Path
from typing import Annotated, Any, Literal, TypeAlias, TypeVar, get_args

import msgspec
from msgspec import Meta, Struct, field
from msgspec.structs import fields

from donnie_tui.process.confinement import is_allowed, open_bytes
from worlds import names as world_names
from worlds.words import ENGLISH, LARGEST, Difficulty, parsed

LADDERS = str(Path(__file__).resolve().parent / "ladders")
"""The folder of the challenges that come with Donnie; ``order.txt`` there names those of each ladder."""
SUFFIX, SOLUTION = ".toml", ".solution.gd"
LARGEST_NUMBER = 1_000_000
MOST_MISTAKES = 20
"""Those of a file that are listed."""
MOST = 50
"""Goals, variants or questions of one challenge."""
Whole: TypeAlias = Annotated[int, Meta(ge=-LARGEST_NUMBER, le=LARGEST_NUMBER)]
Number: TypeAlias = Annotated[float, Meta(ge=-LARGEST_NUMBER, le=LARGEST_NUMBER)]
Amount: TypeAlias = Annotated[float, Meta(ge=0, le=LARGEST_NUMBER)]
Count: TypeAlias = Annotated[int, Meta(ge=0, le=LARGEST_NUMBER)]
Text: TypeAlias = Annotated[str, Meta(min_length=1)]
Place: TypeAlias = tuple[Number, Number]
"""Steps to the east and to the north."""
Target: TypeAlias = str | Place
"""A thing by its name, or a place."""
Area: TypeAlias = tuple[Place, Place]
"""Two opposite corners of a rectangle."""
GoalPlace: TypeAlias = tuple[int, float, float, float, float]
"""The number of a goal, and west, south, east and north of its place."""
COMPASS = {"north": 0.0, "east": 90.0, "south": 180.0, "west": 270.0}
"""Headings by their names in a file."""
Heading: TypeAlias = Number | Literal["north", "east", "south", "west"]
"""Compass degrees, or a name."""


def sides_of(area: Area) -> tuple[float, float, float, float]:
    """West, south, east and north."""
    (west, east), (south, north) = (sorted(each) for each in zip(*area, strict=True))
    return west, south, east, north


class Goal(Struct, frozen=True, forbid_unknown_fields=True):
    """One thing that a run must reach. Exactly one of the fields without a default says what."""

    at: Target | None = None
    """Where the robot stops; with ``thing`` the place of that thing."""
    facing: Heading | None = None
    """Where it looks at the end."""
    visited: Annotated[tuple[Target, ...], Meta(min_length=1)] | None = None
    """What the robot comes to, in this order."""
    near: Target | None = None
    """What the robot passes."""
    area: Area | None = None
    """Where the robot comes; with ``thing`` where that thing is at the end."""
    thing: str | None = None
    said: Text | Whole | Annotated[tuple[Text | Whole, ...], Meta(min_length=1)] | None = None
    """A text, a number, or several in this order."""
    counted: str | None = None
    """A variable, with its ``value`` at the end."""
    holds: str | None = None
    """What the gripper holds at the end."""
    robots: Annotated[tuple[Text, ...], Meta(min_length=1)] | None = None
    """Robots that meet; with ``at`` they are all there at the end."""
    robot: str = ""
    """Whose goal it is; empty for the world's first robot."""
    value: Whole = 0
    within: Amount = 1.0
    """Steps, and for ``facing`` ten degrees each."""
    any_order: bool = False
    stay: bool = False
    """Whether the robot must not leave the area again."""

    @property
    def kind(self) -> str:
        """Which goal it is; empty if none or several are named."""
        return _KIND_OF.get(tuple(each for each in KINDS if getattr(self, each) is not None), "")

    @property
    def is_sensed(self) -> bool:
        """Whether a real robot can know it, which counts its steps and knows no things around it."""
        return not (self.robots or any(isinstance(each, str) for each in self.targets))

    @property
    def targets(self) -> tuple[Target, ...]:
        """The things and places that it names."""
        named = (self.at, self.near, self.thing, self.holds, *(self.visited or ()))
        return tuple(each for each in named if each is not None)

    @property
    def areas(self) -> tuple[Area, ...]:
        """The places that it names, and its area."""
        places = ((each, each) for each in self.targets if not isinstance(each, str))
        return (*places, *filter(None, (self.area,)))


KINDS = ("at", "facing", "visited", "near", "area", "thing", "said", "counted", "holds", "robots")
_KIND_OF: dict[tuple[str, ...], str] = {
    **{(each,): each for each in KINDS if each != "thing"},
    **{("at", "thing"): "thing", ("area", "thing"): "thing", ("at", "robots"): "robots"},
}
"""By the keys that say what a goal is."""


class Avoided(Struct, frozen=True):
    """A thing that the robot must not touch, or not come near to."""

    how: str
    """``touch`` or ``near``."""
    target: str
    within: float


class Never(Struct, frozen=True, forbid_unknown_fields=True):
    """The events that a challenge forbids."""

    bump: bool = False
    touch: tuple[str, ...] = ()
    near: tuple[str, ...] = ()
    """What the robot keeps away from, more than ``within`` steps."""
    within: Amount = 2.0

    @property
    def avoided(self) -> tuple[Avoided, ...]:
        """The things to keep away from; a real robot knows none."""
        named = (*(("touch", each) for each in self.touch), *(("near", each) for each in self.near))
        return tuple(Avoided(how, target, self.within) for how, target in named)


class Limit(Struct, frozen=True, forbid_unknown_fields=True):
    """The most that a solution may need; None for no limit."""

    commands: Count | None = None
    """Movements, turns, waits, sentences and scans that are carried out."""
    seconds: Amount | None = None
    """Of robot time."""
    steps: Count | None = None
    turns: Count | None = None


class Variant(Struct, frozen=True, forbid_unknown_fields=True):
    """A start of the world's first robot, and of things."""

    start: tuple[Number, Number, Heading] | None = None
    """Steps to the east, steps to the north, and the heading; None for the world's own."""
    things: dict[str, Place] = {}
    """Where things and other robots stand, by name, that stand elsewhere than in the world."""
    seed: Whole = 0


def degrees_of(heading: Heading) -> float:
    """Compass degrees."""
    return COMPASS[heading] if isinstance(heading, str) else heading


Ask: TypeAlias = Literal["direction", "distance", "count", "colour", "order"]
"""What a question is about; ``order``: which things are nearer."""


class ChallengeQuestion(Struct, frozen=True, forbid_unknown_fields=True):
    """What is asked after a run."""

    ask: Ask
    of: str | tuple[str, ...]
    """A thing; several for ``order``."""
    origin: Target = field(name="from", default="start")
    """``start``, ``end`` for where the robot is now, a place, or a thing."""
    tolerance: Amount | None = None
    """Degrees or steps; None for what is usual."""

    @property
    def things(self) -> tuple[str, ...]:
        return (self.of,) if isinstance(self.of, str) else self.of

    @property
    def is_complete(self) -> bool:
        """Whether as many things are named as it takes."""
        return 1 < len(self.things) < 10 if self.ask == "order" else len(self.things) == 1


class ChallengeHint(Struct, frozen=True, forbid_unknown_fields=True):
    """A hint on request."""

    text: str


class ChallengeText(Struct, frozen=True, forbid_unknown_fields=True):
    """What a challenge says in one language."""

    title: str
    task: str
    """Short sentences, a line each. The title and they, with limits and words, are at most five lines."""
    hint: tuple[ChallengeHint, ...] = ()

    @property
    def sentences(self) -> tuple[str, ...]:
        """The task, sentence by sentence."""
        return tuple(self.task.strip().split("\n"))


class Rules(Struct, frozen=True, forbid_unknown_fields=True):
    """A challenge without its words."""

    format: Literal[1]
    world: str
    goal: Annotated[tuple[Goal, ...], Meta(max_length=MOST)] = ()
    """Empty if the end of the solution is the goal."""
    difficulty: Difficulty = Difficulty.UNSTATED
    after: tuple[str, ...] = ()
    """The challenges that should be solved before; only advice."""
    words: tuple[str, ...] = ()
    """The words of GoDonnie that a program may have; empty for all."""
    required: tuple[str, ...] = ()
    """The words that a program must have."""
    never: Never = Never()
    limit: Limit = Limit()
    variant: Annotated[tuple[Variant, ...], Meta(min_length=1, max_length=MOST)] = (Variant(),)
    question: Annotated[tuple[ChallengeQuestion, ...], Meta(max_length=MOST)] = ()
    """Asked after a run."""

    @property
    def parts(self) -> Iterator[tuple[str, Goal | Never | Variant | ChallengeQuestion]]:
        """Its tables that name things, each with its name as in ``line_of``."""
        yield "never", self.never
        for name in ("goal", "variant", "question"):
            yield from ((f"{name}[{at}]", each) for at, each in enumerate(getattr(self, name)))

    @property
    def goal_places(self) -> tuple[GoalPlace, ...]:
        """The goals with a place or an area, for the map."""
        numbered = ((number, each) for number, goal in enumerate(self.goal, start=1) for each in goal.areas)
        return tuple((number, *sides_of(area)) for number, area in numbered)

    @property
    def unsensed(self) -> tuple[Unsensed, ...]:
        """What a real robot can't know of all that a challenge asks for; the learner is asked about it."""
        return (*(each for each in self.goal if not each.is_sensed), *self.never.avoided)


Unsensed: TypeAlias = Goal | Avoided
Answers: TypeAlias = Mapping[Unsensed, bool] | None
"""What the learner of a real robot said about what it can't sense; None for a simulated one."""


class Challenge(Struct, frozen=True):
    """A challenge that was read."""

    name: str
    path: Path
    rules: Rules
    texts: dict[str, ChallengeText]
    lines: tuple[str, ...] = ()
    """Of its file."""

    def text(self, language: str) -> ChallengeText:
        """The text in that language, in English where it is missing."""
        return self.texts.get(language, self.texts[ENGLISH])

    def title_of(self, name: str, language: str) -> str:
        """The title of another challenge, shipped or next to this one; its name if it can't be read."""
        beside = str(self.path.with_name(f"{name}{SUFFIX}"))
        with suppress(BadChallenge):
            return find(name if name in names() else beside).text(language).title
        return name

    @property
    def world(self) -> str:
        """The name of a built-in world, or the path of a file in the folder."""
        name = self.rules.world
        return name if name in world_names() else str(self.path.parent / name)

    def solution(self, robot: str = "") -> Path:
        """The solution of the first robot, or that of another one, which may have none."""
        return self.path.with_name(f"{self.name}{robot and f'.{robot}'}{SOLUTION}")


class ChallengeMistake(Struct, frozen=True):
    """What is wrong in a file: the code of a sentence and its values."""

    code: str
    line: int = 0
    """0 for the whole file."""
    what: str = ""
    known: tuple[str, ...] = ()
    """The names that could have been meant."""


class BadChallenge(Exception):
    """A challenge that can't be used, with all mistakes in its file. ``found``: as far as it was read."""

    def __init__(self, file: Path, *mistakes: ChallengeMistake, found: Challenge | None = None) -> None:
        super().__init__(f"{file}: {mistakes}")
        self.file, self.mistakes, self.found = file, mistakes, found


@cache
def ladders() -> Mapping[str, str]:
    """The ladder of each challenge that ships, in the order in which to solve them."""
    with open_bytes(Path(LADDERS, "order.txt")) as stream:
        parts = (line.partition(":") for line in stream.read(LARGEST).decode().splitlines())
        return {name: ladder for ladder, _, steps in parts for name in steps.split()}


def names() -> tuple[str, ...]:
    """The challenges that ship, in the order in which to solve them."""
    return tuple(ladders())


def after(name: str) -> str | None:
    """The one to solve next, among those that ship."""
    return dict(pairwise(names())).get(name)


def find(name: str) -> Challenge:
    """The challenge of that name, number or file, or the only one of that folder. Raises ``BadChallenge``."""
    ours = names()
    name = {str(number): each for number, each in enumerate(ours, start=1)}.get(name, name)
    path = Path(LADDERS, f"{name}{SUFFIX}") if name in ours else Path(name)
    if path.suffix == SUFFIX:
        return read(path)
    beside = (each for each in files_in(str(path.parent)) if each == path.parent / f"{path.name}{SUFFIX}")
    found = files_in(name) or tuple(beside)
    if len(found) == 1:
        return read(found[0])
    code, known = ("challenge-several", tuple(map(str, found))) if found else ("challenge-unknown", ours)
    raise BadChallenge(path, ChallengeMistake(code, what=name, known=known))


def files_in(folder: str) -> tuple[Path, ...]:
    """The challenges of a folder, and of the folders in it; none if the name is of no folder."""
    path = Path(folder)
    return _files(path, f"*{SUFFIX}", f"*/*{SUFFIX}") if folder and is_allowed(path) else ()


def _files(folder: Path, *patterns: str) -> tuple[Path, ...]:
    try:
        return tuple(each for pattern in patterns for each in sorted(folder.glob(pattern)))
    except (OSError, ValueError):
        return ()


def read(path: Path) -> Challenge:
    """A challenge of a file. Raises ``BadChallenge``."""
    try:
        with open_bytes(path) as stream:
            data = stream.read(LARGEST + 1)
    except (OSError, ValueError):
        raise BadChallenge(path, ChallengeMistake("challenge-unreadable")) from None
    if len(data) > LARGEST:
        most = f"{LARGEST:,}".replace(",", " ")
        raise BadChallenge(path, ChallengeMistake("challenge-too-large", what=most))
    reader = _Reader(data)
    found = Challenge(path.name.removesuffix(SUFFIX), path, reader.rules, reader.texts, tuple(reader.lines))
    reader.check(found)
    if reader.mistakes:
        raise BadChallenge(path, *reader.mistakes, found=found)
    return found


_Table = TypeVar("_Table", bound=Struct)
_TABLES: dict[str, type[Struct]] = {
    **{"goal": Goal, "never": Never, "limit": Limit, "variant": Variant},
    **{"question": ChallengeQuestion, "hint": ChallengeHint},
}
_LEVELS = tuple(each.value for each in Difficulty if each is not Difficulty.UNSTATED)
_CHOICES = {"difficulty": _LEVELS, "ask": get_args(Ask)}
"""What can be written in place of a word that is none of these, by the key; else it is a heading."""
_STAND_INS = {"format": 1, "world": "", "title": "", "task": "", "text": "", "ask": "count", "of": ()}
"""In place of what is required and wrong."""


class _Reader:
    """Reads a file, and notes all mistakes: without what is wrong it reads on."""

    def __init__(self, data: bytes) -> None:
        self.mistakes, self.lines = list[ChallengeMistake](), list[str]()
        self._wrong, content = set[str](), dict[str, Any]()
        """The tables with mistakes."""
        try:
            self.lines = data.decode("utf-8-sig").replace("\r\n", "\n").split("\n")
            content = self._parsed()
        except ValueError:
            self._note("challenge-not-toml")
        self._is_whole = not self.mistakes
        languages = [
            key for key in content if re.fullmatch("[a-z]{2,3}", key) and isinstance(content[key], dict)
        ]
        if ENGLISH not in languages and self._is_whole:
            self._note("challenge-missing", ENGLISH, what=f"{ENGLISH}.title")
        self.texts = {each: self._table(ChallengeText, content.pop(each), each) for each in languages}
        self.rules = self._table(Rules, content, "")

    def _parsed(self) -> dict[str, Any]:
        """The file without the statements and tables that can't be read. Raises ``ValueError``."""
        while len(self.mistakes) < MOST_MISTAKES:
            try:
                return parsed("\n".join(self.lines).encode())
            except (ValueError, RecursionError) as problem:
                place = re.search(r"line (\d+)", str(problem))
                if place is None:
                    raise ValueError from None
                line = int(place[1])
            first, end = _statement_at(self.lines, line)
            self.mistakes.append(ChallengeMistake("challenge-not-toml", first + 1 if end < line else line))
            self.lines[first:end] = [""] * (end - first)
        return {}

    def _note(self, code: str, table: str = "", key: str = "", *, text: str = "", **details: Any) -> None:
        """Note a mistake, with the line of that key, else of that table."""
        self._wrong.add(table)
        if len(self.mistakes) < MOST_MISTAKES:
            line = line_of(self.lines, table, key, text)
            self.mistakes.append(ChallengeMistake(code, line, **details))

    def _table(self, kind: type[_Table], content: Mapping[str, Any], name: str) -> _Table:
        """A table without what is wrong in it, with something in place of what it lacks."""
        known = {each.encode_name: each for each in fields(kind)}
        given = dict[str, Any]()
        for key, value in content.items():
            if key not in known:
                self._note("challenge-key", name, key, what=key, known=tuple(known))
                continue
            try:
                inner = self._inner(_TABLES.get(key), value, f"{name}.{key}".lstrip("."))
                given[known[key].name] = msgspec.convert(inner, known[key].type)
            except msgspec.ValidationError as problem:
                word = re.match("Invalid enum value '(.*)'", str(problem), re.DOTALL)
                code, what = ("challenge-choice", word[1]) if word else ("challenge-value", key)
                choices = _CHOICES.get(key, tuple(COMPASS)) if word else ()
                self._note(code, name, key, what=what, known=choices)
        is_sure = self._is_whole and known.keys() >= content.keys()
        for key, each in known.items():
            if each.required and each.name not in given:
                if is_sure and key not in content:  # else an unknown key may be meant as it
                    self._note("challenge-missing", name, what=f"{name}.{key}".lstrip("."))
                given[each.name] = _STAND_INS[each.name]
        return kind(**given)

    def _inner(self, kind: type[Struct] | None, value: Any, name: str) -> Any:
        """The tables in a table; any other value as it is."""
        if kind is not None and isinstance(value, list):
            return [self._inner(kind, each, f"{name}[{at}]") for at, each in enumerate(value)]
        return value if kind is None or not isinstance(value, dict) else self._table(kind, value, name)

    def check(self, found: Challenge) -> None:
        """Check what the types don't say."""
        rules, folder = found.rules, found.path.parent
        known = (*names(), *(each.stem for each in _files(folder, f"*{SUFFIX}")))
        worlds = (*world_names(), *(each.name for each in _files(folder, "*.world", "*.cfg")))
        links = [each.name for each in _files(folder, f"*{SOLUTION}") if each.is_symlink()]
        if Path(rules.world).name != rules.world or (rules.world and (folder / rules.world).is_symlink()):
            self._note("challenge-outside", "", "world", what=rules.world)
        elif rules.world and rules.world not in worlds:
            self._note("challenge-world", "", "world", what=rules.world, known=worlds)
        for link in (each for each in links if each.partition(".")[0] == found.name):
            self.mistakes.append(ChallengeMistake("challenge-outside", what=link))
        for each in (name for name in rules.after if name not in known):
            self._note("challenge-unknown", "", "after", text=each, what=each, known=known)
        for table, part in rules.parts:
            if table in self._wrong:
                continue
            if isinstance(part, ChallengeQuestion) and not part.is_complete:
                self._note("challenge-value", table, "of", what="of")
            if isinstance(part, Goal) and not part.kind and self._is_whole:
                is_thing_alone = [each for each in KINDS if getattr(part, each) is not None] == ["thing"]
                code, what = ("missing", "goal.at") if is_thing_alone else ("goal", ", ".join(KINDS))
                self._note(f"challenge-{code}", table, what=what)
        if not (rules.goal or self.mistakes or os.path.lexists(found.solution())):
            self._note("challenge-solution", what=found.solution().name)


_HEAD = re.compile(r"\s*(\[\[?)\s*([\w.]+)\s*\]")
_KEY = re.compile(r"\s*[\"']?([^\s\"'=]+)[\"']?\s*=")
_BEGINNING = re.compile(r"\s*(\[\[?\s*[A-Za-z]|[\w\"'.-]+\s*=)")
"""Of a table or a value."""


def _statement_at(lines: list[str], line: int) -> tuple[int, int]:
    """What can't be read at a line: from which line to which, counted from 0.

    Of the head of a table it is the whole table. A bracket that is not closed is found at the next value.
    """
    at = line - 1
    begins = [each for each, text in enumerate(lines) if _BEGINNING.match(text)]
    *before, first = [0, *(each for each in begins if each <= at)]
    opened = "".join(lines[before[-1] : at]) if before and first == at else ""
    if opened.count("[") > opened.count("]"):
        return before[-1], at
    is_head = lines[first].lstrip().startswith("[")
    following = (each for each in begins if each > at and (not is_head or lines[each].lstrip()[0] == "["))
    return first, next(following, len(lines))


def line_of(lines: Sequence[str], table: str, key: str, text: str = "") -> int:
    """The line of a key, else of its table's head; 0 if neither is found.

    ``table`` is as msgspec names it: ``goal[1]``, ``en.hint[0]``, or empty for what stands before all tables.
    ``text``: what the key has in quotes, perhaps on a later line.
    """
    found, counted, current = {("", ""): 0}, Counter[str](), ""
    for number, line in enumerate(lines, start=1):
        if head := _HEAD.match(line):
            current = head[2] if head[1] == "[" else f"{head[2]}[{counted[head[2]]}]"
            counted[head[2]] += 1
            found.setdefault(("", head[2]), number)
        value = _KEY.match(line)
        found.setdefault((current, value[1] if value else ""), number)
    first = found.get((table, key), found.get((table, ""), 0))
    following = enumerate(lines[first - 1 :] if text else (), start=first)
    return next((at for at, each in following if f'"{text}"' in each or f"'{text}'" in each), first)
