"""Questions about the world after a run: what is asked, which answer is right, and whether the typed one is.

Directions are compass degrees or a point of the compass, distances are steps until the robot would touch the
thing. Things count where they are at the end of the run.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from math import inf
from typing import TypeAlias

from msgspec import Struct
from msgspec.structs import replace

from devices.ports.robot import Pose
from donnie_tui.core.describe import target_in_words
from donnie_tui.core.goals import Inventory, Track, gap_to, in_steps
from donnie_tui.core.wording import (
    COMPASS,
    Wording,
    called,
    coloured,
    compass_point,
    meant,
    the_called,
    the_coloured,
)
from language import keywords
from language.suggestions import number_in_digits
from sim.picture import Thing
from worlds.challenges import Avoided, ChallengeQuestion, Unsensed

TOLERANCES = {"direction": 30.0, "distance": 2.0}
"""Degrees and steps that an answer may be off by where the challenge doesn't say; else nothing."""
_NUMBER = re.compile(r"\d+(?:[.,]\d+)?")
_Naming: TypeAlias = tuple[Callable[[str, str, Wording], str], Callable[[str, str, str, Wording], str]]
_LISTED: _Naming = called, coloured
_THE: _Naming = the_called, the_coloured
"""How a sentence has a thing, without its colour and with it; ``_LISTED`` has no article."""


class Asked(Struct, frozen=True):
    """A question about the world as one run left it."""

    question: ChallengeQuestion
    track: Track

    def text(self, wording: Wording) -> str:
        """The question in words."""
        ask, names = self.question.ask, self.question.things
        listed = "; ".join(f"{at} {self._called(name, wording)}" for at, name in enumerate(names, start=1))
        how = _LISTED if ask in ("count", "colour") else _THE  # the question about a colour has the article
        target = self._called(names[0], wording, how)
        origin = self._origin_in_words(wording)
        return wording(f"question-{ask}", origin=origin, target=target, things=listed)

    def right_answer(self, wording: Wording) -> str:
        """The right answer in words."""
        ask, right = self.question.ask, self._right
        if isinstance(right, str):
            return wording("answer-colour", colour=wording(f"colour-{right}"))
        if isinstance(right, list):
            return wording("answer-order", numbers=" ".join(map(str, right)))
        number, point = round(right), compass_point(right, wording)
        values = {"direction": point, "degrees": number % 360, "steps": number, "count": number}
        return wording(f"answer-{ask}", **values)

    def is_right(self, typed: str) -> bool:
        """Whether the learner knows it. Numbers may be words."""
        typed = " ".join(number_in_digits(each.strip(".,")) or each for each in typed.split())
        ask, right = self.question.ask, self._right
        if isinstance(right, str):
            words = (keywords.argument("COLOUR", each) for each in re.findall(r"\w+", typed))
            return right in [each.value for each in words if each is not None]
        if isinstance(right, list):
            return [int(each) for each in re.findall(r"\d", typed)] == right
        numbers = [float(each.replace(",", ".")) for each in _NUMBER.findall(typed)]
        if ask == "direction":
            named = (meant(each, "compass") for each in typed.replace("-", "").strip(".").split())
            numbers = [COMPASS.index(each) * 45.0 for each in named if each is not None] + numbers
        tolerance = self.question.tolerance
        off = numbers[0] - right if numbers else inf
        off = (off + 180) % 360 - 180 if ask == "direction" else off
        return abs(off) <= (TOLERANCES.get(ask, 0.0) if tolerance is None else tolerance)

    @property
    def _right(self) -> float | str | list[int]:
        """Degrees, steps, a number of things, a colour, or the numbers of the things from near to far."""
        names = self.question.things
        ways = [self._way_to(each) for each in names]
        rights: dict[str, float | str | list[int]] = {
            "distance": ways[0][0],
            "direction": ways[0][1],
            "count": len(self.track.end.called(names[0])),
            "colour": self._item(names[0]).colour,
            "order": sorted(range(1, len(names) + 1), key=lambda number: ways[number - 1][0]),
        }
        return rights[self.question.ask]

    def _item(self, name: str) -> Thing:
        return self.track.end.called(name)[0]

    def _called(self, name: str, wording: Wording, how: _Naming = _LISTED) -> str:
        """A thing, with its colour where the question names it and does not ask for it."""
        item, (plain, with_colour) = self._item(name), how
        if self.question.ask == "colour" or not item.colour or item.colour not in name:
            return plain(item.kind, item.name, wording)
        return with_colour(item.kind, item.name, item.colour, wording)

    def _way_to(self, name: str) -> tuple[float, float]:
        """How far and in which direction a thing is: from the robot's body, or from a place or thing."""
        end, origin = self.track.end, self.question.origin
        if origin in ("start", "end"):
            moment = end if origin == "end" else self.track.moments[0]
            return gap_to(next(iter(moment.robots.values())), name, end)
        x, y = (self._item(origin).x, self._item(origin).y) if isinstance(origin, str) else origin
        return gap_to(Pose(x, y, 0.0), name, replace(end, radius=0.0))

    def _origin_in_words(self, wording: Wording) -> str:
        origin = self.question.origin
        if origin in ("start", "end"):
            return wording(f"question-from-{origin}")
        if not isinstance(origin, str):
            return wording("question-from", origin=target_in_words(origin, self.track.end, wording))
        return wording("question-from", origin=self._called(origin, wording, _THE))


def unsensed_question(asked: Unsensed, room: Inventory, wording: Wording) -> str:
    """Whether a goal is met or a rule was broken, for the learner of a robot that can't sense it."""
    if isinstance(asked, Avoided):
        values = {"target": target_in_words(asked.target, room, wording), "most": in_steps(asked.within)}
        return wording(f"never-ask-{asked.how}", **values)
    targets = [each for each in asked.targets if each != asked.at or asked.kind == "at"]
    names = asked.robots or [target_in_words(each, room, wording) for each in targets]
    return wording(f"goal-ask-{asked.kind}", target=", ".join(names))
