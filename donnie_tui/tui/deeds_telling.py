"""What the actions that tell something do: the surroundings, the map in words, what was said, mistakes.

The sentences are the core's, the same as in the linear mode.
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from donnie_tui import sound_words
from donnie_tui.core import map_words
from donnie_tui.core.answer_log import spelled
from donnie_tui.core.around import around_in_words, compass_point
from donnie_tui.core.map_grid import MapGrid
from donnie_tui.core.naming import shown_name
from donnie_tui.core.sensor_words import sensors_in_words
from donnie_tui.core.transcript import lines_of, said_by
from donnie_tui.core.typed_arguments import count_in, numbers_in
from donnie_tui.core.wording import Wording
from donnie_tui.i18n.catalogue.signs import SPELLED_OF
from donnie_tui.tui.running import Answer
from donnie_tui.tui.screens.chooser import Choice

if TYPE_CHECKING:
    from donnie_tui.tui.host import WorkHost

_TRAIL = 5
"""Moves that TRAIL tells without a number."""


class TellingDeeds:
    """One method an action."""

    def __init__(self, host: WorkHost) -> None:
        self._host = host
        self._error = 0

    # --- where things are

    @property
    def _grid(self) -> MapGrid:
        """As the robot that is talked to finds the world now."""
        donnie = self._host.donnie
        return MapGrid(donnie.picture_now(), self._host.pose, shown_name(donnie.session.name))

    def where(self, _argument: str) -> None:
        self._host.donnie.session.teller.position(self._host.pose)

    def around(self, argument: str) -> bool:
        point = compass_point(argument)
        if argument and point is None:
            return False
        self._tell_of_robot(*around_in_words(self._grid, self._host.pose, self._host.words, compass=point))
        return True

    def map(self, argument: str) -> bool:
        place, words, pose = numbers_in(argument, most=2), self._host.words, self._host.pose
        if place is None or len(place) == 1:
            return False
        if place:
            x, y = place
            self._tell_of_robot(map_words.square_in_words(self._grid, x, y, pose, words))
        else:
            self._tell_of_robot(*map_words.map_in_words(self._grid.picture, pose, words))
        return True

    def map_row(self, argument: str) -> bool:
        return self._tell_squares(map_words.row_in_words, argument)

    def map_column(self, argument: str) -> bool:
        return self._tell_squares(map_words.column_in_words, argument)

    def _tell_squares(
        self, in_words: Callable[[MapGrid, int, Wording], tuple[str, ...]], argument: str
    ) -> bool:
        given = numbers_in(argument, most=1)
        if given:
            self._tell_of_robot(*in_words(self._grid, given[0], self._host.words))
        return bool(given)

    def map_picture(self, _argument: str) -> None:
        lines = map_words.picture_in_letters(self._grid, self._host.words)
        self._host.pages.show_lines(self._host.words("key-show_map"), lines)

    def trail(self, argument: str) -> bool:
        count = count_in(argument, _TRAIL)
        if count is not None:
            self._tell_of_robot(*self._host.trail.in_words(count, self._host.words))
        return count is not None

    def sensors(self, _argument: str) -> None:
        """In words, and on the map: what is seen by what sees wide, until the robot moves."""
        donnie, words = self._host.donnie, self._host.words
        if donnie.connection.is_real:
            self._tell(words("sensors-real"))
            return
        devices = donnie.mounted()
        self._host.display.show_fields([line for each in devices for line in each.lines])
        self._tell(*sensors_in_words(devices, shown_name(donnie.session.name), words))

    # --- what was said

    def last(self, argument: str) -> bool:
        which = count_in(argument, 1)
        if which is not None:
            self._tell(*(self._host.answers.last(which) or (self._host.words("answer-nothing-said"),)))
        return which is not None

    def last_word(self, _argument: str) -> None:
        line = next(iter(self._host.answers.last()[-1:]), "")
        word = next(iter(line.split()[-1:]), "").strip(".,:;!?")
        self._tell(word or self._host.words("answer-nothing-said"))

    def spell(self, argument: str) -> bool:
        which = count_in(argument, 1)
        if which is not None:
            line = next(iter(self._host.answers.last(which)[-1:]), "")
            self._tell(*spelled(line, SPELLED_OF, self._host.words))
        return which is not None

    def find(self, argument: str) -> bool:
        if not argument:
            return False
        found = self._host.answers.found(argument)
        self._tell(*(found or (self._host.words("find-none", word=argument[:40]),)))
        self._host.workplace.log_rows.search(argument)
        return True

    async def typed(self, argument: str) -> bool:
        """The lines typed last, the newest first; the chosen one is done again."""
        lines = self._host.workplace.command_line.past[:-1]  # without this one
        count = count_in(argument, max(1, len(lines)))
        if count is None:
            return False
        if lines:
            await self._choose_again(lines[-count:])
        else:
            self._host.tell(Answer("linear-nothing-typed"))
        return True

    async def _choose_again(self, lines: Sequence[str]) -> None:
        rows = [Choice(each, each) for each in dict.fromkeys(reversed(lines))]
        chosen = await self._host.choose(self._host.words("key-typed"), rows)
        again = self._host.typed(chosen) if chosen else None
        if again is not None:
            await again

    # --- what sounds

    def quiet(self, _argument: str) -> None:
        sound_words.quiet(self._host.donnie)

    async def cues(self, argument: str) -> None:
        """Each with its name; a key ends it."""
        for seconds in sound_words.play_cues(self._host.donnie, argument):
            await asyncio.sleep(seconds)

    # --- mistakes

    def errors(self, _argument: str) -> None:
        errors = self._host.following.errors
        if not errors:
            self._host.tell(Answer("answer-no-errors"))
        for error in errors:
            self._tell(*lines_of(error, self._host.words))

    def error(self, _argument: str) -> None:
        self._tell_error(self._error)

    def error_next(self, _argument: str) -> None:
        self._tell_error(self._error + 1)

    def error_previous(self, _argument: str) -> None:
        self._tell_error(self._error - 1)

    def _tell_error(self, which: int) -> None:
        errors = self._host.following.errors
        if not errors:
            self._host.tell(Answer("answer-no-errors"))
            return
        self._error = min(max(0, which), len(errors) - 1)
        error = errors[self._error]
        self._host.workplace.editor.go_to(error.line, error.column)
        self._tell(*lines_of(error, self._host.words))

    def _tell_of_robot(self, *sentences: str) -> None:
        """The first sentence has the name of the robot that is talked to, where there are several."""
        robot, words = self._host.donnie.session.hub.robot, self._host.words
        self._tell(*(said_by(robot, each, words) for each in sentences[:1]), *sentences[1:])

    def _tell(self, *sentences: str) -> None:
        self._host.tell_sentences(*sentences)

    def explain(self, _argument: str) -> None:
        """The last mistake in plain words, and what to do."""
        errors = self._host.following.errors
        if not errors:
            self._host.tell(Answer("answer-no-errors"))
            return
        error = errors[min(self._error, len(errors) - 1)]
        self._host.workplace.editor.go_to(error.line, error.column)
        self._tell(self._host.words(f"explain-{error.kind}"), self._host.words(f"mend-{error.kind}"))

    def world(self, _argument: str) -> None:
        """What its author says of it, and what stands in it."""
        world = self._host.donnie.world
        about = world.about(self._host.words.language)
        if about is not None:
            self._host.tell(Answer("world-title", {"name": world.name, "title": about.title}))
            self._tell(*about.description.replace(". ", ".\n").splitlines())
        self.map("")
        if about is not None:
            self._host.tell(Answer("world-task", {"task": about.task}))
