"""Which robot runs which program: ``FILE`` for the first robot of the world, ``ROBOT=FILE`` for each."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path, PurePath

from donnie_tui.cli.sources import read_source
from donnie_tui.core.naming import no_such_robot
from donnie_tui.core.team import Assigned, Team
from donnie_tui.i18n.words import Unusable, Words

MOST_NAMES = 5
"""Robots that are named where one is unknown."""


def read_programs(arguments: Sequence[str], words: Words) -> tuple[tuple[str | None, Assigned], ...]:
    """What was written behind ``donnie run``: the robot's name, None for the first one, and its program.

    Raises ``Unusable``. A file of exactly that name wins over a robot.
    """
    parts = [_parts(each) for each in arguments]
    if len(parts) > 1:
        _refuse_nameless(parts, words)
    if sum(file == "-" for _, file in parts) > 1:
        raise Unusable(words("robots-one-input"))
    return tuple((robot, _program(file, words)) for robot, file in parts)


def assign(programs: Sequence[tuple[str | None, Assigned]], team: Team, words: Words) -> dict[str, Assigned]:
    """The programs by the names that the robots have in their world. Raises ``Unusable``."""
    assigned: dict[str, Assigned] = {}
    for robot, program in programs:
        name = team.names[0] if robot is None else team.called(robot)
        if name is None:
            raise Unusable(no_such_robot(robot or "", team.names, MOST_NAMES, words))
        if name in assigned:
            raise Unusable(words("robot-twice", name=name))
        assigned[name] = program
    return assigned


def _parts(argument: str) -> tuple[str | None, str]:
    robot, equals, file = argument.partition("=")
    if not (robot and equals) or _exists(argument):
        return None, argument
    return robot, file


def _exists(name: str) -> bool:
    try:
        return Path(name).exists()
    except (OSError, ValueError):
        return False


def _refuse_nameless(parts: Sequence[tuple[str | None, str]], words: Words) -> None:
    for robot, file in parts:
        if robot is None:
            raise Unusable(words("robots-need-names", file=file))


def _program(file: str, words: Words) -> Assigned:
    source = read_source(file, words)
    return Assigned(source.text, PurePath(source.name).name)
