"""Questions about the world after a run: what is asked, which answer is right, and whether the typed one is.

Directions are compass degrees or a point of the compass, distances are steps until the robot would touch the
thing. Things count where they are at the end of the run.
"""

from __future__ import annotations

import re
from collections.abc import Callable

from msgspec import Struct
from msgspec.structs import replace

from devices.ports.robot import Pose
from donnie_tui.core.describe import target_in_words
from donnie_tui.core.goals import Inventory, Item, Track, bearing, gap_to, in_steps
from donnie_tui.core.wording import COMPASS, Wording, called, coloured, meant, the_coloured
from language import keywords
from language.suggestions import number_in_digits
from worlds.challenges import Ask, Avoided, ChallengeQuestion, Unsensed

TOLERANCES = {Ask.DIRECTION: 30.0, Ask.DISTANCE: 2.0}
"""Degrees and steps that an answer may be off by where the challenge doesn't say; else nothing."""
_NUMBER = re.compile(r"\d+(?:[.,]\d+)?")
_WithColour = Callable[[str, str, str, Wording], str]


class Asked(Struct, frozen=True):
    """A question about the world as one run left it."""

    question: ChallengeQuestion
    track: Track

    def text(self, wording: Wording) -> str:
        """The question in words."""
        code, names = f"question-{self.question.ask.value}", self.question.things
        match self.question.ask:
            case Ask.ORDER:
                listed = (f"{at} {self._called(name, wording)}" for at, name in enumerate(names, start=1))
                return wording(code, origin=self._origin_in_words(wording), things="; ".join(listed))
            case Ask.COUNT:
                return wording(code, target=self._called(names[0], wording))
            case Ask.COLOUR:
                item = self._item(names[0])
                return wording(code, target=called(item.kind, item.name, wording))
            case _:
                target = self._called(names[0], wording, the_coloured)
                return wording(code, origin=self._origin_in_words(wording), target=target)

    def right_answer(self, wording: Wording) -> str:
        """The right answer in words."""
        code = f"answer-{self.question.ask.value}"
        match self.question.ask:
            case Ask.DIRECTION:
                degrees = round(self._direction()) % 360
                point = wording(f"compass-{COMPASS[round(degrees / 45) % 8]}")
                return wording(code, direction=point, degrees=degrees)
            case Ask.DISTANCE:
                return wording(code, steps=round(self._distance(self.question.things[0])))
            case Ask.COUNT:
                return wording(code, count=self._count())
            case Ask.COLOUR:
                return wording(code, colour=wording(f"colour-{self._colour()}"))
            case Ask.ORDER:
                return wording(code, numbers=" ".join(map(str, self._order())))

    def is_right(self, typed: str) -> bool:
        """Whether the learner knows it. Numbers may be words."""
        typed = " ".join(number_in_digits(each.strip(".,")) or each for each in typed.split())
        question = self.question
        default = TOLERANCES.get(question.ask, 0.0)
        tolerance = default if question.tolerance is None else question.tolerance
        numbers = [float(each.replace(",", ".")) for each in _NUMBER.findall(typed)]
        match question.ask:
            case Ask.DIRECTION:
                named = (meant(each, "compass") for each in typed.replace("-", "").strip(".").split())
                points = [COMPASS.index(each) * 45.0 for each in named if each is not None]
                degrees = next(iter(points + numbers), None)
                if degrees is None:
                    return False
                return abs((degrees - self._direction() + 180) % 360 - 180) <= tolerance
            case Ask.DISTANCE | Ask.COUNT as ask:
                amount = self._count() if ask is Ask.COUNT else self._distance(question.things[0])
                return bool(numbers) and abs(numbers[0] - amount) <= tolerance
            case Ask.COLOUR:
                words = (keywords.argument("COLOUR", each) for each in re.findall(r"\w+", typed))
                return self._colour() in [each.value for each in words if each is not None]
            case Ask.ORDER:
                return [int(each) for each in re.findall(r"\d", typed)] == self._order()

    # --- what is right

    def _item(self, name: str) -> Item:
        return next(each for each in self.track.items if each.is_called(name))

    def _called(self, name: str, wording: Wording, with_colour: _WithColour = coloured) -> str:
        """A thing, with its colour where the question names it."""
        item = self._item(name)
        if not item.colour or item.colour not in name:
            return called(item.kind, item.name, wording)
        return with_colour(item.kind, item.name, item.colour, wording)

    def _origin(self) -> Pose:
        match self.question.origin:
            case "start":
                return next(iter(self.track.moments[0].poses.values()))
            case "end":
                return self.track.end("")
            case str() as name:
                item = self._item(name)
                return Pose(item.x, item.y, 0.0)
            case x, y:
                return Pose(x, y, 0.0)

    def _origin_in_words(self, wording: Wording) -> str:
        match self.question.origin:
            case "start" | "end" as place:
                return wording(f"question-from-{place}")
            case str() as name:
                return wording("question-from", origin=self._called(name, wording, the_coloured))
            case x, y:
                return wording("question-from", origin=f"{x:g}, {y:g}")

    def _direction(self) -> float:
        here, item = self._origin(), self._item(self.question.things[0])
        return bearing(here.x, here.y, item.x, item.y)

    def _distance(self, name: str) -> float:
        """A distance from the robot's body where it is or was, else from the middle of the place or thing."""
        is_of_robot = self.question.origin in ("start", "end")
        room = self.track.room if is_of_robot else replace(self.track.room, radius=0.0)
        return gap_to(self._origin(), name, room, self.track.items)[0]

    def _count(self) -> int:
        return sum(each.is_called(self.question.things[0]) for each in self.track.items)

    def _colour(self) -> str:
        return self._item(self.question.things[0]).colour

    def _order(self) -> list[int]:
        """The numbers of the things, from near to far."""
        gaps = [self._distance(each) for each in self.question.things]
        return sorted(range(1, len(gaps) + 1), key=lambda number: gaps[number - 1])


def unsensed_question(asked: Unsensed, room: Inventory, wording: Wording) -> str:
    """Whether a goal is met or a rule was broken, for the learner of a robot that can't sense it."""
    if isinstance(asked, Avoided):
        values = {"target": target_in_words(asked.target, room, wording), "most": in_steps(asked.within)}
        return wording(f"never-ask-{asked.how}", **values)
    listed = ", ".join(asked.robots or ()) or ", ".join(
        target_in_words(each, room, wording)
        for each in asked.targets
        if each != asked.at or asked.kind == "at"
    )
    return wording(f"goal-ask-{asked.kind}", target=listed)
