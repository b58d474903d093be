"""``donnie worlds`` and ``donnie world NAME``: worlds in words, as a map, as a report, as JSON."""

from __future__ import annotations

import json
from collections import Counter
from pathlib import PurePath
from typing import TYPE_CHECKING

import worlds
from donnie_tui.cli import codes
from donnie_tui.cli.order import Order
from donnie_tui.cli.world_models import records
from donnie_tui.core.describe import describe, things_in_words
from donnie_tui.i18n.words import Words
from donnie_tui.i18n.world_mistakes import world_note
from donnie_tui.unusable import Unusable
from donnie_tui.world_choice import ChosenWorld, choose_world

if TYPE_CHECKING:
    from sim.report import LoadReport


def list_worlds(order: Order) -> int:
    """Name and title of each world that ships, a line each."""
    for name in worlds.names():
        title = worlds.about(name, order.words.language).title
        order.output.line(order.words("world-title", name=name, title=title))
    return codes.DONE


def tell_world(order: Order) -> int:
    """In the form that was asked for, in words if none was."""
    arguments, words = order.invocation.arguments, order.words
    for form in ("svg", "brf"):
        if getattr(arguments, form):
            raise Unusable(words("option-to-come", option=f"--{form}"))
    world = choose_world(arguments.name or order.settings.world, words, order.settings.world_folders)
    for line in _lines(arguments, world, words):
        order.output.line(line)
    return codes.DONE


def _lines(arguments: object, world: ChosenWorld, words: Words) -> tuple[str, ...]:
    if getattr(arguments, "map", False):
        return _map(world)
    if getattr(arguments, "report", False):
        return _report(world.scene.report, words)
    if getattr(arguments, "json", False):
        return (json.dumps(records(world.scene), ensure_ascii=False, indent=1),)
    return _words(world, words)


def _words(world: ChosenWorld, words: Words) -> tuple[str, ...]:
    """What its author says of it, else what can be measured."""
    from sim.picture import picture

    about = world.about(words.language)
    seen, pose = picture(world.scene), world.start()
    if about is None:
        return describe(seen, pose, words)
    sentences = about.description.replace(". ", ".\n").splitlines()
    task = words("world-task", task=about.task)
    title = words("world-title", name=world.name, title=about.title)
    return (title, *sentences, *things_in_words(seen, pose, words), task)


def _map(world: ChosenWorld) -> tuple[str, ...]:
    from sim.picture import picture

    seen, pose = picture(world.scene), world.start()
    cell = seen.at(pose.x, pose.y)
    rows = [list(row) for row in seen.rows]
    if cell is not None and world.scene.robots:
        rows[cell[0]][cell[1]] = "^>v<"[round(pose.heading / 90) % 4]
    return tuple("".join(row) for row in rows)


def _report(report: LoadReport, words: Words) -> tuple[str, ...]:
    names = ", ".join(PurePath(each).name for each in report.files)
    models = ", ".join(f"{count} {type_}" for type_, count in report.loaded)
    remarks = Counter(
        words(f"report-{note.kind.value}", remark=world_note(note, words)) for note in report.notes
    )
    return (
        words("report-files", count=len(report.files), files=names),
        words("report-loaded", models=models or "0"),
        *(remarks or (words("report-clean"),)),
    )
