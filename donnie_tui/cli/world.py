"""``donnie worlds`` and ``donnie world NAME``: worlds as words, map, paper, report or JSON.

The JSON, the models that Stage would build in metres and degrees, is a contract.
"""

from __future__ import annotations

import json
import shlex
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from math import ceil
from pathlib import Path, PurePath
from typing import TYPE_CHECKING

import worlds.words
from donnie_tui.cli.options import ExitCode, Order
from donnie_tui.core.chart import colour_marks, shrunk, with_marks
from donnie_tui.core.describe import MOST_ROBOTS, describe
from donnie_tui.core.program_files import (
    STANDARD_OUTPUT,
    FilesInUse,
    exists,
    file_to_save,
    write_program,
)
from donnie_tui.core.wording import colour_initials, name_of, shade
from donnie_tui.i18n.mistakes import world_note
from donnie_tui.i18n.words import Unusable, Words, as_unusable
from donnie_tui.world.loading import (
    WITHOUT_WORLD,
    ChosenWorld,
    allowed_folders,
    choose_world,
    remarks,
    scattered_by,
)

if TYPE_CHECKING:
    from sim.geometry import Placement
    from sim.picture import Picture
    from sim.scene import Model, RangeSensor, Scene


_DECIMALS = 6


def records(scene: Scene) -> list[dict[str, object]]:
    """A record a model, a parent before its children."""
    return [_record(model, scene) for model in scene.models]


def _record(model: Model, scene: Scene) -> dict[str, object]:
    parent = None if model.parent is None else scene.models[model.parent].name
    record: dict[str, object] = {
        "type": model.type,
        "name": model.name,
        "parent": parent,
        "global_pose": _placement(model.pose),
        "origin": _placement(model.origin),
        "size": _rounded(model.size),
        "color": _rounded((model.colour.red, model.colour.green, model.colour.blue, model.colour.alpha)),
        "obstacle_return": model.obstacle_return,
        "ranger_return": model.ranger_return,
        "blob_return": model.blob_return,
        "fiducial_return": model.fiducial_return,
        "gripper_return": model.gripper_return,
        "boundary": int(model.boundary),
        "blocks": model.stage_blocks,
        "block_area": round(model.stage_area, _DECIMALS),
    }
    if model.sensors:
        record["sensors"] = [_sensor(each) for each in model.sensors]
    return record


def _sensor(sensor: RangeSensor) -> dict[str, object]:
    return {
        "pose": _placement(sensor.pose),
        "range": _rounded((sensor.minimum, sensor.maximum)),
        "fov_deg": round(sensor.fov, _DECIMALS),
        "samples": sensor.samples,
    }


def _placement(placement: Placement) -> list[float]:
    return _rounded((placement.x, placement.y, placement.z, placement.yaw))


def _rounded(values: Iterable[float]) -> list[float]:
    return [round(value, _DECIMALS) + 0.0 for value in values]


WIDEST_MAP = 80
"""Letters in a line of ``--map``; in a wider world a letter stands for several steps."""
_ARROWS = "^>v<"
_FLOOR = {"#": "legend-wall", ".": "legend-free"}
MOST_NAMES = 4
"""Names that are listed for one letter of ``--map``."""


def list_worlds(order: Order) -> int:
    """Name, title and difficulty of each world that ships, a line each."""
    for name in worlds.names():
        about = worlds.words.about(name, order.words.language)
        difficulty = order.words(f"difficulty-{about.difficulty.value}")
        order.output.line(order.words("world-listed", name=name, title=about.title, difficulty=difficulty))
    return ExitCode.DONE


def describe_world(order: Order) -> int:
    """Describe a world in the requested form, else in words; ``new`` and a file make a world."""
    arguments, words = order.invocation.arguments, order.words
    match arguments.name:
        case ["new", file]:
            return _new_world(order, file)
        case [name] if name != "new" and arguments.drawing is None:
            pass
        case [] if arguments.drawing is None:
            name = order.settings.world
        case _:
            raise Unusable(words("world-new-usage"))
    folders = order.settings.include_folders
    world = choose_world(name, words, folders)
    world = scattered_by(order.settings.seed, world, words, allowed_folders(folders))
    is_printed = not any(
        getattr(arguments, each) not in (None, False) for each in ("json", "map", "svg", "brf")
    )
    for sentence in _without_world(world, words):
        (order.output.line if is_printed else order.output.complaint)(sentence)
    if arguments.json:
        order.output.text(_json(world) + "\n")
        return ExitCode.DONE
    if STANDARD_OUTPUT in (arguments.svg, arguments.brf):
        page = _raised_picture if arguments.svg == STANDARD_OUTPUT else _braille_pages
        order.output.data(page(world, words).encode())
        return ExitCode.DONE
    for line in _lines(arguments, world, words):
        order.output.line(line)
    if not arguments.report:
        for remark in remarks(world, words):
            (order.output.line if is_printed else order.output.complaint)(remark)
    return ExitCode.DONE


_HALF_ROOM = ("#" * 33, *["#" + "." * 31 + "#"] * 15)
EMPTY_ROOM = "\n".join([*_HALF_ROOM, f"#{'.' * 15}^{'.' * 15}#", *reversed(_HALF_ROOM)])
"""What ``donnie world new`` writes without a drawing: 31 by 31 steps, the robot in the middle."""


def _new_world(order: Order, file: str) -> int:
    """Write the world of a drawing, or an empty room; nothing if the drawing has mistakes."""
    from donnie_tui.cli.programs import read_source
    from donnie_tui.world.drawing import world_of

    words, drawing = order.words, order.invocation.arguments.drawing
    with as_unusable(words):
        target = file_to_save(file, FilesInUse(()), ".world")
        if exists(target):
            raise Unusable(words("world-new-there", path=target))
        text = EMPTY_ROOM if drawing is None else read_source(drawing, words).text
        built, counts = world_of(text, str(drawing), words)
        write_program(target, built)
    command = f"donnie --world {shlex.quote(str(target))}"
    order.output.line(words("world-new", path=target, command=command, **counts))
    return ExitCode.DONE


def _without_world(world: ChosenWorld, words: Words) -> tuple[str, ...]:
    """The sentence that there is only a real robot, and on which floor it is drawn."""
    if not world.stands_in_for:
        return ()
    values = {"name": world.stands_in_for, "port": world.physical_port, "floor": WITHOUT_WORLD}
    return (words("world-real-only", **values),)


def _lines(arguments: object, world: ChosenWorld, words: Words) -> tuple[str, ...]:
    if getattr(arguments, "map", False):
        return _map(world, words)
    if getattr(arguments, "report", False):
        return _report(world.scene, words)
    if (path := getattr(arguments, "svg", None)) is not None:
        return (_written(path, _raised_picture(world, words), words),)
    if (path := getattr(arguments, "brf", None)) is not None:
        return (_written(path, _braille_pages(world, words), words),)
    return _words(world, words)


def _json(world: ChosenWorld) -> str:
    """The JSON of a world, with escapes for characters that a terminal would obey."""
    text = json.dumps(records(world.scene), ensure_ascii=False, indent=1)
    return "".join(each if each == "\n" or each.isprintable() else json.dumps(each)[1:-1] for each in text)


def _words(world: ChosenWorld, words: Words) -> tuple[str, ...]:
    """The description by its author, else what can be measured."""
    from sim.picture import picture

    about = world.about(words.language)
    lines = describe(picture(world.scene), world.start(), words, robot=_robot(world), about=about)
    title = () if about is None else (words("world-title", name=world.name, title=about.title),)
    return (*title, *lines)


def _robots(scene: Scene, words: Words) -> tuple[str, ...]:
    """The names by which the robots are programmed."""
    names = scene.robot_names
    if len(names) < 2:
        return ()
    shown = ", ".join(names[:MOST_ROBOTS]) + (", …" if len(names) > MOST_ROBOTS else "")
    return (words("report-robots", count=len(names), names=shown, first=shlex.quote(names[0])),)


def _robot(world: ChosenWorld) -> str | None:
    scene = world.scene
    return next(iter(scene.robot_names), None)


def _map(world: ChosenWorld, words: Words) -> tuple[str, ...]:
    """The floor in letters, every robot as an arrow; then, after a blank line, what the letters mean."""
    from sim.picture import picture

    seen, pose = picture(world.scene), world.start()
    rows = [list(row) for row in seen.rows]
    robots = [(each.x, each.y, each.heading) for each in seen.things if each.is_robot]
    if world.scene.robots:
        robots.append((pose.x, pose.y, pose.heading))
    for x, y, heading in robots:
        cell = seen.at(x, y)
        if cell is not None:
            rows[cell[0]][cell[1]] = _ARROWS[round(heading / 90) % 4]
    across = ceil(seen.width / WIDEST_MAP)
    steps = across * seen.cell
    scale = (words("map-scale", steps=steps),) if steps > 1 else ()
    shown = shrunk(["".join(row) for row in rows], across, across, _ARROWS)
    marks = colour_marks(seen, colour_initials(words, {each.letter for each in seen.things}))
    marked, letters = with_marks(shown, marks, across, across)
    colours = dict(_colours_by_letter(seen, shown, across, words)) | {each: [] for each in letters}
    for mark in marks:
        named = f"{mark.initial} {shade(mark.thing, words)}"
        if mark.thing.letter in letters and named not in colours[mark.thing.letter]:
            colours[mark.thing.letter].append(named)
    return (*marked, "", *scale, *_legend(world, seen, set("".join(shown)), colours, words))


MOST_COLOURS = 40
"""Colours that are listed for one letter of ``--map``."""


def _colours_by_letter(
    seen: Picture, shown: Sequence[str], across: int, words: Words
) -> Mapping[str, list[str]]:
    """The colours of the things by their letters, in reading order; one where all have the same."""
    from donnie_tui.world.drawing import groups_in

    colours: dict[str, list[str]] = {}
    things = [(each, seen.at(each.x, each.y)) for each in seen.things if not each.is_robot]
    for group in groups_in(shown):
        squares = [
            (row * across - cell[0], column * across - cell[1], thing)
            for thing, cell in things
            if cell is not None and thing.letter == group.letter
            for row, column in group.squares
        ]
        if squares:
            nearest = min(squares, key=lambda each: each[0] ** 2 + each[1] ** 2)[2]
            colours.setdefault(group.letter, []).append(shade(nearest, words))
    return {letter: each[:1] if len(set(each)) == 1 else each for letter, each in colours.items()}


def _legend(
    world: ChosenWorld, seen: Picture, shown: set[str], colours: Mapping[str, Sequence[str]], words: Words
) -> tuple[str, ...]:
    """The legend of the map: walls and floor, then the robots, then the things by their letters."""
    robots = list(world.scene.robot_names)
    names = {" ".join(_ARROWS): robots} if robots else {}
    for thing in sorted(seen.things, key=lambda each: each.letter):
        listed = names.setdefault(thing.letter, []) if thing.letter in shown else []
        name = name_of(thing, words)
        if name not in listed and len(listed) <= MOST_NAMES:
            listed.append(name)
    return (
        *(words(code) for letter, code in _FLOOR.items() if letter in shown),
        *(() if robots else (words("map-no-robot"),)),
        *(
            words("map-legend", letter=letter, name=_named(each, colours.get(letter, ())))
            for letter, each in names.items()
        ),
    )


def _named(names: Sequence[str], colours: Sequence[str]) -> str:
    """The names for one letter; of one name its colours too."""
    if len(names) == 1 and colours:
        return f"{names[0]}: {_bounded(colours, MOST_COLOURS)}"
    return _bounded(names, MOST_NAMES)


def _bounded(names: Sequence[str], most: int) -> str:
    return ", ".join([*names[:most], *(["…"] if len(names) > most else [])])


def _braille_pages(world: ChosenWorld, words: Words) -> str:
    from donnie_tui.core.chart import braille_pages, chart
    from sim.picture import picture

    plan = chart(picture(world.scene), world.start(), _robot(world), words)
    return braille_pages(_title(world, words), plan, words)


def _title(world: ChosenWorld, words: Words) -> str:
    """The title by its author, or the name of the world."""
    return words("paper-title", name=world.title(words.language))


def _raised_picture(world: ChosenWorld, words: Words) -> str:
    from donnie_tui.world.run_picture import on_swell_paper

    return on_swell_paper(world, (), (), words)


def _written(path: str, text: str, words: Words) -> str:
    """Write a file whole or not at all. Raises ``Unusable``."""
    with as_unusable(words):
        write_program(Path(path), text)
    return words("paper-written", path=path)


def _report(scene: Scene, words: Words) -> tuple[str, ...]:
    report = scene.report
    names = ", ".join(PurePath(each).name for each in report.files)
    folder = Path(worlds.SCENES).resolve()
    needed = [each for each in map(Path, (*report.files, *report.pictures)) if each.parent == folder]
    is_outside = bool(needed) and Path(report.files[0]) not in needed
    for_stage = {"files": ", ".join(each.name for each in needed), "folder": folder}
    models = ", ".join(f"{count} {type_}" for type_, count in report.loaded)
    pushable = sum(model.pushable for model in scene.models if model.parent is None)
    remarks = Counter(
        words(f"report-{note.kind.value}", remark=world_note(note, words)) for note in report.notes
    )
    return (
        words("report-files", count=len(report.files), files=names),
        *((words("report-stage", **for_stage),) if is_outside else ()),
        words("report-loaded", models=models or "0"),
        *_robots(scene, words),
        *((words("report-pushable", count=pushable),) if pushable else ()),
        *(remarks or (words("report-clean"),)),
    )
