"""The way to another world, with the same programs."""

from __future__ import annotations

from donnie_tui.commands.interaction import EnterWorld
from donnie_tui.linear.desk import Desk


def depart(desk: Desk) -> None:
    """Raises ``EnterWorld`` where somebody wants to go to one."""
    name, desk.goes_to = desk.goes_to, ""
    if name:
        desk.ctx.runs.stop_to_leave()
        desk.answer("world-going", name=name)
        raise EnterWorld(name)
