"""What the actions that tell something do: the surroundings, the map in words, what was said, mistakes.

The sentences are the core's, the same as in the linear mode.
"""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable, Sequence
from typing import TYPE_CHECKING

from donnie_tui.core import map_words
from donnie_tui.core.answer_log import found_in_words, none_so_far, spelled
from donnie_tui.core.around import around_in_words, compass_point
from donnie_tui.core.describe import told_world
from donnie_tui.core.events import Error
from donnie_tui.core.map_grid import MapGrid
from donnie_tui.core.naming import shown_name
from donnie_tui.core.sensor_words import sensors_in_words, sensors_of_board
from donnie_tui.core.told_errors import ToldErrors, line_of
from donnie_tui.core.trail import USUALLY_TOLD, place_in_words
from donnie_tui.core.transcript import lines_said_by
from donnie_tui.core.typed_words import count_in, numbers_in
from donnie_tui.core.wording import Wording
from donnie_tui.i18n.catalogue.signs import SPELLED_OF
from donnie_tui.tui.actions import find
from donnie_tui.tui.deeds_around import go_to_world
from donnie_tui.tui.running import Answer
from donnie_tui.tui.screens.chooser import Choice
from donnie_tui.words import sound_words

if TYPE_CHECKING:
    from donnie_tui.tui.host import WorkHost


class TellingDeeds:
    """One method an action."""

    def __init__(self, host: WorkHost) -> None:
        self._host = host

    # --- where things are

    @property
    def _grid(self) -> MapGrid:
        """As the robot that is talked to finds the world now."""
        donnie = self._host.donnie
        return MapGrid(donnie.picture_now(), self._host.pose, shown_name(donnie.session.name))

    def where(self, _argument: str) -> None:
        host = self._host
        self._tell_of_robot(
            *place_in_words(host.pose, host.trail, host.words, is_full=host.words.detail == "full")
        )

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
            about = self._host.donnie.world.about(words.language)
            self._tell_of_robot(*map_words.map_in_words(self._grid.picture, pose, words, about))
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
        count = count_in(argument, USUALLY_TOLD)
        if count is not None:
            self._tell_of_robot(*self._host.trail.in_words(count, self._host.words))
        return count is not None

    def sensors(self, _argument: str) -> None:
        """In words, and on the map: what is seen by what sees wide, until the robot moves."""
        donnie, words = self._host.donnie, self._host.words
        if donnie.connection.is_board:
            self._tell(*sensors_of_board(shown_name(donnie.session.name), words))
            return
        devices = donnie.mounted()
        self._host.display.show_fields([line for each in devices for line in each.lines])
        self._tell(*sensors_in_words(devices, shown_name(donnie.session.name), words))

    # --- what was said

    def last(self, argument: str) -> bool:
        which = count_in(argument, 1)
        if which is not None:
            answers = self._host.answers
            self._tell(*(answers.again(which) or (none_so_far(answers, self._host.words),)))
        return which is not None

    def last_word(self, _argument: str) -> None:
        self._spell(self._host.answers.last_word())

    def spell(self, argument: str) -> bool:
        which = count_in(argument, 1)
        if which is not None:
            self._spell(self._host.answers.last_line(which))
        return which is not None

    def _spell(self, text: str) -> None:
        self._tell(*spelled(text, SPELLED_OF, self._host.words))

    def find(self, argument: str) -> bool:
        if not argument:
            return False
        self._tell(*found_in_words(self._host.answers, argument, self._host.words))
        self._host.workplace.log_rows.search(argument)
        return True

    async def typed(self, argument: str) -> bool:
        """The lines typed last, the newest first; the chosen one is done again."""
        lines = [each for each in self._host.workplace.command_line.past.lines if not _is_typed(each)]
        count = count_in(argument, max(1, len(lines)))
        if count is None:
            return False
        if lines:
            await self._choose_again(lines[-count:])
        else:
            self._host.talk.tell(Answer("linear-nothing-typed"))
        return True

    async def _choose_again(self, lines: Sequence[str]) -> None:
        rows = [Choice(each, each) for each in dict.fromkeys(reversed(lines))]
        chosen = await self._host.talk.choose(self._host.words("key-typed"), rows)
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

    @property
    def _errors(self) -> ToldErrors:
        return self._host.following.errors

    def errors(self, _argument: str) -> None:
        self._tell(*self._errors.in_words(self._host.words))

    def error(self, _argument: str) -> None:
        self._go_to_error(0)

    def error_next(self, _argument: str) -> None:
        self._go_to_error(1)

    def error_previous(self, _argument: str) -> None:
        self._go_to_error(-1)

    def _go_to_error(self, by: int) -> None:
        error, told = self._errors.go(by, self._host.words)
        self._show(error)
        self._tell(*told)

    def explain(self, _argument: str) -> None:
        """The mistake in plain words, what to do, and the line that was meant."""
        error, words = self._errors.now, self._host.words
        self._show(error)
        self._tell(*self._errors.explained(self._host.donnie.session.hub.robot, words))
        if error is not None:
            self._tell(*line_of(error, words))

    def _show(self, error: Error | None) -> None:
        if error is not None:
            self._host.workplace.editor.go_to(error.line, error.column)

    # --- the world

    def world(self, argument: str) -> Awaitable[None] | None:
        """What its author says of it, and what stands in it; or another one, by its name."""
        if argument:
            return go_to_world(self._host, argument)
        host, words = self._host, self._host.words
        world, about = host.donnie.world, host.donnie.world.about(words.language)
        floor = map_words.map_in_words(self._grid.picture, host.pose, words, about)
        of_robot = lines_said_by(host.donnie.session.hub.robot, floor, words)
        self._tell(*told_world(world.name, about, of_robot, words))
        return None

    # --- telling

    def _tell_of_robot(self, *sentences: str) -> None:
        """The first sentence has the name of the robot that is talked to, where there are several."""
        robot, words = self._host.donnie.session.hub.robot, self._host.words
        self._tell(*lines_said_by(robot, sentences, words))

    def _tell(self, *sentences: str) -> None:
        self._host.talk.tell_sentences(*sentences)


def _is_typed(line: str) -> bool:
    """Whether it asks for the lines that were typed: none to be done again."""
    found = find(line)
    return found is not None and found[0].name == "typed"
