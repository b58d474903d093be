"""What a robot has to sense with, in words: kind by kind, alike ones together."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from typing import TYPE_CHECKING

from donnie_tui.core.wording import Wording
from language import keywords

if TYPE_CHECKING:
    from sim.mounted import Mounted

MOST = 20
"""Kinds and directions that are told one by one."""


def sensors_in_words(devices: Iterable[Mounted], name: str, wording: Wording) -> tuple[str, ...]:
    """A sentence for each kind and direction, with how many there are of it. ``name``: empty is Donnie."""
    name = name or wording("cell-robot")
    counted = Counter(_told(each, wording) for each in devices)
    if not counted:
        return (wording("sensors-none", name=name),)
    told = [
        text if count == 1 else wording("sensors-several", count=count, what=text)
        for text, count in counted.items()
    ]
    more = len(told) - MOST
    return (
        wording("sensors-title", name=name),
        *told[:MOST],
        *((wording("sensors-more", count=more),) if more > 0 else ()),
    )


def sensors_of_board(name: str, wording: Wording) -> tuple[str, ...]:
    """The same of the original robot's board, which has them built in, in whatever world it stands."""
    return (
        wording("sensors-title", name=name or wording("cell-robot")),
        wording("sensors-board-around"),
        wording("sensors-board-head", scan=keywords.spelling("SCAN", wording.language)),
        wording("sensors-board-lacks"),
    )


def _told(device: Mounted, wording: Wording) -> str:
    return wording(
        f"sensors-{device.device.value}",
        where=_where(device.degrees, wording),
        width=round(device.width),
        metres=f"{device.metres:.2f}".rstrip("0").rstrip("."),
    )


def _where(degrees: float, wording: Wording) -> str:
    turned = round(degrees)
    if turned == 0:
        return wording("sensors-ahead")
    if abs(turned) == 180:
        return wording("sensors-behind")
    return wording("sensors-right" if turned > 0 else "sensors-left", degrees=abs(turned))
