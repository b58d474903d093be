"""Loads a world by its name or its file, and watches its things. Raises ``Unusable`` for each failure.

The name of a world that ships wins over a file in the current folder; ``./name`` is always the file. A
configuration file chooses its world, the robots that it offers, and the real robot. For the learner's own
files, remarks name what would be searched for in the program: a robot that starts inside something,
unreadable words, slips.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from msgspec import Struct
from msgspec.structs import replace

import worlds
from devices.ports.robot import STEP, Pose
from donnie_tui.core.events import PlacedThing
from donnie_tui.core.program_files import (
    SUFFIX,
    DocumentError,
    checked_path,
    exists,
    read_program,
    read_to_the_end,
)
from donnie_tui.core.wording import Wording
from donnie_tui.i18n.words import NotAllowed, Unusable, Words, as_unusable
from sim.compiled_scene import read_scene
from sim.geometry import Placement
from sim.scene import Scene, moved

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping, Sequence
    from pathlib import Path

    from donnie_tui.core.goals import Inventory
    from sim.world import World
    from sim.worldfile import Configuration, Driver, Offer, WorldError
    from worlds.challenges import Challenge, ChallengeMistake, Rules, Variant
    from worlds.words import About

CHALLENGE = "challenge:"
"""The prefix of a challenge's name that is given in place of a world's."""
_INSIDE = "starts-inside"
_SLIPS = frozenset(
    {"unknown-property", "unknown-colour", "unknown-model", "unknown-word", "second-define", "missing-point"}
    | {"empty-bitmap", "read-as", "line-block", "no-samples", "lone-window", "include-rest"}
    | {"broken-define"}
)
"""Codes of ignored or repaired parts of a file, which have no effect."""
LONGEST_NAME = 80
"""Characters of a wrong name that a sentence repeats."""
MOST_KNOWN = 8
"""Names that are listed if none is near."""
MOST_REMARKS = 3
"""Remarks that are listed one by one."""


def remarks(world: ChosenWorld, words: Wording) -> tuple[str, ...]:
    """Remarks about a world file, a sentence each; none for a built-in world."""
    if world.ships:
        return ()
    notes = world.scene.report.notes
    inside = [note for note in notes if note.code == _INSIDE]
    bad_words = _bad_words(world, words)
    others = len(inside[MOST_REMARKS:]) + sum(note.code in _SLIPS for note in notes)
    listed = (*bad_words, *(words(f"note-{_INSIDE}", **note.details) for note in inside[:MOST_REMARKS]))
    if not others:
        return listed
    import shlex

    chosen, *_ = *world.scene.report.files, world.path  # a configuration comes before its world
    return (*listed, words("world-remarks", count=others, path=shlex.quote(chosen)))


def _bad_words(world: ChosenWorld, words: Wording) -> tuple[str, ...]:
    """The reason why the author's words can't be used, if there are any."""
    from worlds.words import BadWords, about_file

    try:
        about_file(world.path, words.language)
    except BadWords as problem:
        code = "key" if problem.key else "line" if problem.line else "file"
        code = "difficulty" if problem.key == "difficulty" else "large" if problem.limit else code
        values = {"file": problem.file.name, "key": problem.key, "line": problem.line}
        return (words(f"world-words-{code}", **values, limit=problem.limit),)
    return ()


WITHOUT_WORLD = "open_floor"
"""The world on which a robot is drawn if a configuration file asks for a real robot only."""


class ChosenWorld(Struct, frozen=True):
    """A world that was loaded. ``name`` is what the event stream calls it, whichever folder it came from."""

    name: str
    path: str
    scene: Scene
    ships: bool
    """Whether it is built in, with words about it."""
    offers: tuple[Offer, ...] = ()
    """The robots that a configuration file offers, with their addresses."""
    drivers: tuple[Driver, ...] = ()
    """All its drivers."""
    physical_port: str | None = None
    """The serial port of the real robot that a configuration file asks for."""
    stands_in_for: str = ""
    """The configuration file without a world, whose robot is drawn on another world."""
    challenge: Challenge | None = None
    """The challenge of this world."""
    is_rebuilt: bool = False
    """Whether things were added, moved or removed, so that its author's words no longer apply."""
    before_moves: ChosenWorld | None = None
    """The world of its file, before a challenge moved things in it."""
    moves: Mapping[int, Placement] = {}
    """The places to which a challenge moved models, by index."""
    text: str = ""
    """The changed text of its file, if Donnie put a robot in or scattered things."""
    is_robot_put_in: bool = False
    """Whether its file has no robot."""

    def about(self, language: str) -> About | None:
        """Title, description and task; None for a world file without a file of words."""
        from worlds.words import BadWords, about, about_file

        if self.is_rebuilt:
            return None
        if self.ships:
            return about(self.name, language)
        try:
            return about_file(self.path, language)
        except BadWords:
            return None  # reported when the world was loaded

    def title(self, language: str) -> str:
        """The author's title, else the name of its file."""
        about = self.about(language)
        return about.title if about is not None else self.name

    @property
    def rules(self) -> Rules:
        """Those of its challenge, which it must have."""
        assert self.challenge is not None
        return self.challenge.rules

    def start(self) -> Pose:
        """The pose of its first robot; the middle, facing north, if it has none."""
        if not self.scene.robots:
            return Pose(0.0, 0.0, 0.0)
        place = self.scene.models[self.scene.robots[0]].pose
        return Pose(round(place.x / STEP, 6), round(place.y / STEP, 6), round(90.0 - place.yaw, 6) % 360.0)


class SiteChange(Struct, frozen=True):
    """The values to undo or redo a change of the world."""

    text: str
    """The text of the world to restore."""
    number: int
    """The number of the thing among the top-level models, in the world that has it."""
    program: str
    """The text of the program at that moment."""


class Site:
    """The world of a session, which ``things.Building`` changes."""

    def __init__(self, world: ChosenWorld) -> None:
        self.world = world
        self.text = self.first_text = self.saved_text = world.text
        """The text of the world now, at first and in its file; empty before the first change."""
        self.past: list[SiteChange] = []
        """The changes, the oldest first."""
        self.undone: list[SiteChange] = []
        """The undone changes, the latest last."""
        self.path: Path | None = None
        """The learner's file that it was last read from or written to."""
        if not world.ships:
            from pathlib import Path

            self.path = Path(world.path)

    @property
    def is_saved(self) -> bool:
        return self.text == self.saved_text


def files_of(world: ChosenWorld) -> tuple[str, ...]:
    """All files of the world, also a learner's file of words."""
    report = world.scene.report
    return (world.path, *report.files, *report.pictures, *_own_words(world))


def _own_words(world: ChosenWorld) -> tuple[str, ...]:
    if world.ships:
        return ()
    from worlds.words import words_file

    file = words_file(world.path)
    return (file,) if file else ()


def choose_world(
    name_or_file: str, words: Words, folders: tuple[str, ...] = (), *, unknown: str = "world-unknown"
) -> ChosenWorld:
    """The world of ``--world``. Raises ``Unusable``.

    ``folders``: those from which its files may include others, besides their own. ``unknown``: the code of
    the sentence for a name that is near to none.
    """
    if name_or_file in worlds.names():
        path = worlds.path(name_or_file)
        scene = read_scene(path) or _load(path, words, folders)
        return ChosenWorld(name_or_file, path, scene, ships=True)
    if name_or_file.startswith(CHALLENGE):
        code = "challenge-unknown" if unknown == "world-unknown" else "challenge-unknown-here"
        world = choose_challenge(name_or_file.removeprefix(CHALLENGE), words, folders, unknown=code)
        started = started_at(world, world.rules.variant[0], words, folders)
        return replace(started, challenge=world.challenge)
    return _in_a_file(name_or_file, words, folders, unknown)


def choose_challenge(
    name: str, words: Words, folders: tuple[str, ...] = (), *, unknown: str = "challenge-unknown"
) -> ChosenWorld:
    """The world of the challenge of that name, number, title or file, with it, as the world's file says.

    ``unknown``: the code of the sentence for a name that is near to none.
    Raises ``Unusable`` with the lines of all mistakes in it.
    """
    from donnie_tui.core.goals import Inventory, unknown_names
    from worlds.challenges import BadChallenge, ChallengeMistake, find

    found, world, mistakes, unread = _titled(name), None, list[ChallengeMistake](), tuple[str, ...]()
    try:
        found = found or find(name)
        file = found.path
    except BadChallenge as bad:
        found, file, mistakes = bad.found, bad.file, [*bad.mistakes]
    codes = {each.code for each in mistakes}
    if found is not None:
        try:
            if found.rules.world and not codes & {"challenge-world", "challenge-outside"}:
                world = inhabited_world(found.world, words, folders)
        except Unusable as problem:
            unread = problem.sentences
        mistakes += _unknown(found, world)
        is_unchecked = world is None and any(unknown_names(found.rules, Inventory((), 0.0)))
        if is_unchecked or "challenge-not-toml" in codes:
            unread += (words("challenge-unread"),)
    if mistakes or found is None or world is None:
        raise Unusable(*_in_words(file, mistakes, words, unknown), *unread)
    world = replace(world, challenge=found)
    if not found.rules.goal:
        solution_of(world, words)
    return world


def _unknown(found: Challenge, world: ChosenWorld | None) -> Iterator[ChallengeMistake]:
    """The words of a challenge that GoDonnie doesn't have, and the names that its world doesn't have."""
    from donnie_tui.core.goals import names_of, unknown_names
    from language.keywords import all_words, canonical
    from worlds.challenges import ChallengeMistake, line_of

    rules, known = found.rules, tuple(all_words("en"))
    of_lists = [("", key, each) for key in ("words", "required") for each in getattr(rules, key)]
    unknown = [(*each, "challenge-word", known) for each in of_lists if canonical(each[-1]) is None]
    if world is not None:
        room = inventory_of(world.scene)
        things = sorted(room.items, key=lambda each: max(each.width, each.depth))  # walls last
        named = [[name for name in names_of(each) if name.strip()] for each in things]
        first = (each[0] for each in named if each)
        known = tuple(dict.fromkeys((*first, *room.robots, *(name for each in named for name in each))))
        unknown += [(*each, "challenge-thing", known) for each in unknown_names(rules, room)]
    for table, key, name, code, names in unknown:
        yield ChallengeMistake(code, line_of(found.lines, table, key, name), name, names)


def _titled(title: str) -> Challenge | None:
    """The shipped challenge with that title, in any language."""
    from donnie_tui.core.goals import folded
    from worlds.challenges import find, names

    if title.isdigit() or title in names():  # the others need not be read
        return None
    titled = ((it, folded(text.title)) for it in map(find, names()) for text in it.texts.values())
    return next((it for it, each in titled if title and each == folded(title)), None)


def _in_words(
    file: Path, mistakes: Sequence[ChallengeMistake], words: Words, unknown: str = "challenge-unknown"
) -> Iterator[str]:
    """A sentence for each, in the order of their lines. ``unknown``: as of ``choose_challenge``."""
    from language.suggestions import nearest
    from worlds.challenges import MOST_MISTAKES

    for bad in sorted(mistakes, key=lambda each: each.line)[:MOST_MISTAKES]:
        near = nearest(bad.what, bad.known) if bad.known else None
        code = f"{bad.code}-near" if near else bad.code
        if code == "challenge-unknown" and not bad.line:
            code = unknown
        what, known = bad.what[:LONGEST_NAME], ", ".join(bad.known[:MOST_KNOWN])
        sentence = words(code, file=file.name, what=what, near=near, known=known)
        yield words("challenge-line", line=bad.line, text=sentence) if bad.line else sentence
    if len(mistakes) >= MOST_MISTAKES:
        yield words("more-mistakes", limit=MOST_MISTAKES)


def solution_of(world: ChosenWorld, words: Words) -> dict[str, str]:
    """The solution of its challenge, for each robot that needs one.

    Raises ``Unusable`` if that of the first can't be read.
    """
    assert world.challenge is not None
    solution, names = world.challenge.solution, world.scene.robot_names
    files = {name: solution(name if at else "") for at, name in enumerate(names)}
    there = {name: file for name, file in files.items() if name == names[0] or exists(file)}
    with as_unusable(words):
        return {name: read_to_the_end(checked_path(file)) for name, file in there.items()}


def _in_a_file(name: str, words: Words, folders: tuple[str, ...], unknown: str) -> ChosenWorld:
    from pathlib import Path  # slow to load, and our own are called by text

    path = Path(name)
    _refuse_outside(path, words)
    if not ("/" in name or "\\" in name or path.suffix or exists(path)):
        raise Unusable(_unknown_world(name, words, unknown))
    if path.suffix.lower() == SUFFIX:
        raise Unusable(words("world-is-program", path=path))
    if path.suffix.lower() == ".cfg":
        return _configured(path, words, folders)
    return ChosenWorld(path.name, str(path), _load(str(path), words, folders), ships=False)


def _refuse_outside(path: Path, words: Words) -> None:
    """Raises ``Unusable`` for a world that a confined session must not use."""
    with as_unusable(words):
        checked_path(path)


def _configured(path: Path, words: Words, folders: tuple[str, ...]) -> ChosenWorld:
    found = configuration_of(path, words, folders)
    if found.scene is not None and found.world is not None:
        name, place, scene = found.world.name, str(found.world), found.scene
        instead_of = ""
    else:
        instead_of = path.name
        name, place = path.name, worlds.path(WITHOUT_WORLD)
        scene = _load(place, words, folders)
    return ChosenWorld(
        name, place, scene, False, found.offers, found.drivers, found.physical_port, instead_of
    )


def configuration_of(path: Path, words: Words, folders: tuple[str, ...] = ()) -> Configuration:
    """What a configuration file chose. Raises ``Unusable``."""
    from sim.worldfile import WorldError, load_configuration

    _refuse_outside(path, words)
    try:
        return load_configuration(path, allowed=allowed_folders(folders))
    except WorldError as error:
        raise _refused(error, path, words) from None


def _refused(error: WorldError, path: Path, words: Words) -> Unusable:
    """Why the world at ``path`` can't be used, and the command that would allow what it asks for."""
    from donnie_tui.i18n.mistakes import world_mistake

    sentence, folder = world_mistake(error, words), str(error.details.get("folder", ""))
    return NotAllowed(sentence, words, ("--world", str(path)), folder) if folder else Unusable(sentence)


def _unknown_world(name: str, words: Words, code: str) -> str:
    import difflib
    from pathlib import Path

    if exists(Path(f"{name}.world")):
        return words("world-unknown-near", name=name, near=f"{name}.world")
    near = difflib.get_close_matches(name.lower().replace(" ", "_"), worlds.names(), n=1)
    if near:
        return words("world-unknown-near", name=name, near=near[0])
    return words(code, name=name)


def _load(path: str, words: Words, folders: tuple[str, ...]) -> Scene:
    from pathlib import Path

    return scene_of(None, Path(path), words, allowed_folders(folders))


def scene_of(text: str | None, path: Path, words: Words, allowed: tuple[Path, ...]) -> Scene:
    """The scene of a world file, or of a text in its place. Raises ``Unusable``."""
    from sim.worldfile import WorldError, load_text, load_world

    try:
        return load_world(path, allowed=allowed) if text is None else load_text(text, path, allowed=allowed)
    except WorldError as error:
        raise _refused(error, path, words) from None


def with_robot(world: ChosenWorld, words: Words, folders: tuple[Path, ...]) -> ChosenWorld:
    """The world itself if it has a robot, else with a Donnie in it, facing north. Raises ``Unusable``.

    The same world always gets it in the same place, so that a recording can be run again. ``folders``: those
    from which its files may include others.
    """
    if world.scene.robots:
        return world

    from pathlib import Path

    from sim.parts import free_place
    from sim.worldfile import WorldError, in_units, load_text, units_of

    x, y = free_place(world.scene)
    line = f'donnie( name "donnie" pose [ {x * STEP:.2f} {y * STEP:.2f} 0 90 ] )'
    try:
        include, line = include_for("donnie.inc", world.scene), in_units(line, *units_of(world.scene))
        text = f"{(world.text or read_program(Path(world.path))).rstrip()}\n\n{include}\n{line}\n"
        scene = load_text(text, Path(world.path), allowed=folders)
    except (DocumentError, WorldError):
        scene, text = world.scene, ""
    if not scene.robots:
        raise Unusable(words("world-without-robot", name=world.name))
    return replace(world, scene=scene, text=text, is_robot_put_in=True)


def include_for(file: str, scene: Scene) -> str:
    """What a world includes to know the models of one of our files: in other units all of it, converted."""
    from pathlib import Path

    from sim.worldfile import in_units, units_of

    units = units_of(scene)
    if units == (1.0, 1.0):
        return f'include "{file}"'
    return in_units(read_program(Path(worlds.SCENES, file)), *units)


def scattered_by(seed: int, world: ChosenWorld, words: Words, folders: tuple[Path, ...]) -> ChosenWorld:
    """The world with its things where the seed puts them, if it asks for that. Raises ``Unusable``.

    A challenge has a seed of its own for each start.
    """
    if not seed or "scatter" not in world.scene.settings or world.challenge is not None:
        return world

    from pathlib import Path

    from sim.worldfile import WorldError, load_text, scattered

    path = Path(world.path)
    try:
        with as_unusable(words):
            text = scattered(world.text or read_program(path), world.scene, path, folders, seed)
        scene = replace(load_text(text, path, allowed=folders), robots=world.scene.robots)
    except WorldError as error:
        raise _refused(error, path, words) from None
    return replace(world, scene=scene, text=text)


def inhabited_world(
    name_or_file: str, words: Words, folders: tuple[str, ...] = (), *, seed: int = 0
) -> ChosenWorld:
    """The world of ``--world`` with its seed, and a Donnie if it has no robot. Raises ``Unusable``."""
    world = choose_world(name_or_file, words, folders)
    if (
        world.scene.robots and "scatter" not in world.scene.settings
    ):  # most worlds, and the rest is slow to load
        return world
    allowed = allowed_folders(folders)
    return with_robot(scattered_by(seed, world, words, allowed), words, allowed)


def robot_put_in(world: ChosenWorld, words: Words) -> tuple[str, ...]:
    """The sentence that a Donnie was put in, if it was."""
    place = world.start()
    values = {"name": world.name, "x": round(place.x), "y": round(place.y)}
    return (words("world-robot-put-in", **values),) if world.is_robot_put_in else ()


def allowed_folders(folders: tuple[str, ...]) -> tuple[Path, ...]:
    """The folders from which a world may include files, besides its own."""
    from pathlib import Path

    from donnie_tui.process.confinement import is_allowed

    return tuple(map(Path, (*filter(is_allowed, folders), worlds.SCENES)))


class ThingWatch:
    """Reports the places of a simulated world's things, for the robot that has the turn."""

    def __init__(self, world: World) -> None:
        self._world = world
        self._last: tuple[PlacedThing, ...] = ()

    def __call__(self) -> tuple[PlacedThing, ...] | None:
        """The things that are not at their start; None if nothing has changed since the last call."""
        moved = self._world.moved_things()
        if not moved and not self._last:
            return None
        models = self._world.scene.models
        places = tuple(PlacedThing(models[index].name, _pose(moved[index]), index) for index in sorted(moved))
        if places == self._last:
            return None
        self._last = places
        return places


def _pose(placement: Placement) -> Pose:
    heading = round((90.0 - placement.yaw) % 360.0, 6) % 360.0
    return Pose(round(placement.x / STEP, 6) + 0.0, round(placement.y / STEP, 6) + 0.0, heading)


def moved_to(scene: Scene, places: tuple[PlacedThing, ...]) -> Scene:
    """The scene with its things where events say that they are."""
    now = {
        each.index: Placement(
            each.pose.x * STEP, each.pose.y * STEP, scene.models[each.index].pose.z, 90.0 - each.pose.heading
        )
        for each in places
        if 0 <= each.index < len(scene.models)
    }
    return moved(scene, now)


def started_at(
    world: ChosenWorld, variant: Variant, words: Words, folders: tuple[str, ...] = ()
) -> ChosenWorld:
    """The world with its first robot and its things as the variant and its seed say. Raises ``Unusable``."""
    from worlds.challenges import degrees_of

    plain = replace(world.before_moves or world, challenge=None)
    world = scattered_by(variant.seed, plain, words, allowed_folders(folders))
    scene, room, places = world.scene, inventory_of(world.scene), dict[int, Placement]()
    robots = dict(zip(scene.robot_names, scene.robots, strict=True))
    for name, (x, y) in variant.things.items():
        index = robots[name] if name in robots else room.called(name)[0].index
        places[index] = replace(scene.models[index].pose, x=x * STEP, y=y * STEP)
    if variant.start is not None:
        x, y, heading = variant.start
        z = scene.models[scene.robots[0]].pose.z
        places[scene.robots[0]] = Placement(x * STEP, y * STEP, z, 90.0 - degrees_of(heading))
    return replace(world, scene=moved(scene, places), moves=places, before_moves=plain)


def inventory_of(scene: Scene) -> Inventory:
    """What the goals of a challenge need to know of a world."""
    from donnie_tui.core.goals import Inventory
    from sim.picture import all_things

    everything = all_things(scene)
    width, depth, _ = scene.models[scene.robots[0]].size
    poses = {each.index: Pose(each.x, each.y, each.heading) for each in everything if each.is_robot}
    robots = {name: poses[index] for name, index in zip(scene.robot_names, scene.robots, strict=True)}
    items = tuple(each for each in everything if not each.is_robot)
    return Inventory(items, (width + depth) / 4 / STEP, robots)
