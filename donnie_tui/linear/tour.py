"""TOUR: Donnie in five minutes, told page by page; between two pages one tries things or goes on."""

from __future__ import annotations

from functools import partial

from donnie_tui.i18n.tour import PAGES, page
from donnie_tui.linear.arguments import Handler, alone
from donnie_tui.linear.desk import Desk


def _tour(desk: Desk) -> None:
    """From where it was left; whoever tries things must know which robot does them."""
    if desk.donnie.team.has_several:
        desk.answer("robot-chosen", name=desk.session.name)
    _page(desk, desk.tour_page)


def _page(desk: Desk, number: int) -> None:
    """One page; an empty line goes on to the next one, anything else is done and the tour waits."""
    desk.tell(*page(number, desk.say))
    desk.tour_page = number if number < PAGES else 1
    if number < PAGES:
        desk.answer("tour-on", page=number, pages=PAGES)
        desk.goes_on = partial(_page, desk, number + 1)


HANDLERS: dict[str, Handler] = {"tour": alone(_tour)}
