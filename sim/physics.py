"""What is around one robot, or one thing that is pushed: the ground without itself, found fast.

A part inside which its centre stands from the start, such as a floor drawn as a box, is not there for it.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from typing import TYPE_CHECKING

from devices.ports.values import Frozen
from sim.geometry import Point
from sim.ground import Ground
from sim.parts import Part

if TYPE_CHECKING:
    from sim.rays import Hit

__all__ = ["OtherRobots", "Part", "Surroundings"]


SAFE = 1e-6
"""Metres by which a circle of free room is taken smaller."""


class _Room(Frozen):
    """A circle in which nothing comes near, as long as nothing has changed."""

    x: float
    y: float
    radius2: float
    changes: int

    def holds(self, x: float, y: float) -> bool:
        dx, dy = x - self.x, y - self.y
        return dx * dx + dy * dy < self.radius2


_NO_ROOM = _Room(0.0, 0.0, -1.0, -1)


class OtherRobots:
    """What is around one robot, as far as it is robots."""

    def __init__(self, around: Surroundings) -> None:
        self._around = around
        self._robots = frozenset(around.ground.scene.robots)

    def __bool__(self) -> bool:
        return len(self._robots) > 1

    def within(self, left: float, bottom: float, right: float, top: float) -> list[Part]:
        """All parts that come into a box, and perhaps some more, in order."""
        found = self._around.within(left, bottom, right, top)
        return [part for part in found if part.root in self._robots]

    def first_hits(self, x: float, y: float, ends: Sequence[Point], ranging: bool = False) -> list[Hit[Part]]:
        """The robots that looks meet first, unless something else is before them."""
        hits = self._around.first_hits(x, y, ends, ranging)
        return [hit if hit[0] and hit[0].root in self._robots else (None, 1.0) for hit in hits]


class Surroundings:
    """Everything on the ground but one root and what is attached to it."""

    def __init__(self, ground: Ground, root: int, ignored: frozenset[int] = frozenset()) -> None:
        """``root``: the index of a top-level model. ``ignored``: ranks of parts that are not there for it."""
        self.ground = ground
        self.root = root
        self._guard = 0.0
        self._room = _NO_ROOM
        self.has_company = len(ground.movable) > 1
        """Whether anything else on the ground may move."""
        self._ignored = ignored

    @cached_property
    def stands_in(self) -> tuple[int, ...]:
        """The roots inside which it stands from the start."""
        return tuple(dict.fromkeys(part.root for part in self.ground.around_start(self.root)))

    @cached_property
    def _absent(self) -> frozenset[int]:
        return self._ignored | frozenset(part.rank for part in self.ground.around_start(self.root))

    def without(self, roots: frozenset[int]) -> Surroundings:
        """The same, as if these were not there either."""
        ignored = (part.rank for root in roots if root != self.root for part in self.ground.parts_of(root))
        return Surroundings(self.ground, self.root, self._ignored | frozenset(ignored))

    def keep(self, guard: float) -> None:
        """Have ``free_way`` keep that distance (metres) from everything."""
        self._guard = self.ground.guarded(guard)
        self._room = _NO_ROOM

    @property
    def parts(self) -> tuple[Part, ...]:
        """Everything, in order."""
        return tuple(
            part for part in self.ground.parts() if part.root != self.root and part.rank not in self._absent
        )

    def near(self, x: float, y: float, reach: float) -> list[Part]:
        """All parts that come within ``reach`` of a place, and perhaps some more, in order."""
        return self.ground.within(self.root, x - reach, y - reach, x + reach, y + reach, self._absent)

    def within(self, left: float, bottom: float, right: float, top: float) -> list[Part]:
        """All parts that come into a box, and perhaps some more, in order."""
        return self.ground.within(self.root, left, bottom, right, top, self._absent)

    def first_hits(self, x: float, y: float, ends: Sequence[Point], ranging: bool = False) -> list[Hit[Part]]:
        """The parts that looks from one place to each of ``ends`` meet first, and where on the way.

        ``ranging``: as a ranger sees, to which some things are invisible.
        """
        return self.ground.first_hits(self.root, x, y, ends, ranging, self._absent)

    def has_room(self, x: float, y: float, to_x: float, to_y: float) -> bool:
        """Whether a way is known to keep the guard distance; False says nothing.

        It is known of all ways within a circle, which is looked for where a way leaves the last one.
        """
        room = self._room
        is_inside = room.holds(x, y) and room.changes == self.ground.changes_for(self.root)
        if is_inside or self._absent:
            return is_inside and room.holds(to_x, to_y)
        radius = max(0.0, self.ground.room(self.root, x, y, self._guard) - SAFE)
        self._room = _Room(x, y, radius * radius, self.ground.changes_for(self.root))
        return self._room.holds(to_x, to_y)

    def free_way(self, x: float, y: float, to_x: float, to_y: float) -> float:
        """The part of the way, from 0 to 1, on which nothing comes nearer than the guard distance."""
        return self.ground.free_way(self.root, x, y, (to_x, to_y), self._guard, self._absent)
