"""WORLD, WORLDS: about the world, which others there are, and going there with the same program."""

from __future__ import annotations

from donnie_tui.core.world_words import worlds_in_words
from donnie_tui.linear.arguments import Handler
from donnie_tui.linear.desk import Desk
from donnie_tui.linear.patience import patiently
from donnie_tui.linear.runs import Runs
from donnie_tui.linear.surroundings import say_world
from donnie_tui.words import world_going
from donnie_tui.words.switching import GoToWorld


def _world(desk: Desk, _: Runs, rest: str) -> None:
    if rest:
        _go(desk, rest)
    else:
        say_world(desk)


def _worlds(desk: Desk, _: Runs, rest: str) -> None:
    if rest:
        _go(desk, rest)
    else:
        desk.tell(*worlds_in_words(desk.donnie.world.name, desk.say))


def _go(desk: Desk, typed: str) -> None:
    """Raises ``GoToWorld``; while a program is held that is left to whoever stops it first."""
    name = patiently(
        desk, lambda: world_going.world_to_go_to(desk.donnie, typed), "slow-world", name=typed[:40]
    )
    desk.goes_to = name or ""
    if not desk.beside.is_watching:
        depart(desk)


def depart(desk: Desk) -> None:
    """Raises ``GoToWorld`` where somebody wants to go to one."""
    name, desk.goes_to = desk.goes_to, ""
    if name:
        world_going.stop_before_going(desk.donnie, name)
        desk.beside.leave_out()
        raise GoToWorld(name)


HANDLERS: dict[str, Handler] = {"world": _world, "worlds": _worlds}
