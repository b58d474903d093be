"""What a command may use: the robots and their world, the words, the program, the answers so far."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from donnie_tui.bootstrap import Donnie
from donnie_tui.commands.interaction import Interaction, Screen
from donnie_tui.commands.preferences import Preferences
from donnie_tui.core.answer_log import AnswerLog
from donnie_tui.core.events import Answered
from donnie_tui.core.map_grid import Trail
from donnie_tui.core.program_text import no_such_line
from donnie_tui.core.run_controller import RunController
from donnie_tui.core.run_state import RunErrors
from donnie_tui.core.transcript import lines_with_robot_name, with_robot_name
from donnie_tui.core.wording import shown_name

if TYPE_CHECKING:
    from donnie_tui.core.document import Document
    from donnie_tui.core.line_history import LineHistory
    from donnie_tui.core.map_grid import MapGrid
    from donnie_tui.core.workspace import Workspace

MOST_AT_ONCE = 18
"""Lines of a list that are said without their number before."""


class Context:
    """One learner at one front end, from the beginning of a session to its end."""

    def __init__(
        self,
        donnie: Donnie,
        interaction: Interaction,
        workspace: Workspace,
        answers: AnswerLog,
        past: LineHistory,
        preferences: Preferences,
        screen: Screen | None = None,
    ) -> None:
        """``answers`` are what was said before, ``past`` are the lines that were typed."""
        self.donnie = donnie
        self.words = donnie.words
        self.interaction = interaction
        self.workspace = workspace
        self.answers = answers
        self.past = past
        self.preferences = preferences
        self.screen = screen
        self.tour_page = 1
        """The page where TOUR continues in the linear mode."""
        self.is_urgent = False
        """Whether an answer comes before what a running program has said and is not printed yet."""
        self.runs = RunController(
            donnie.team,
            donnie.words,
            donnie.chronicle,
            has_prompt=screen is None,
            can_hold=interaction.is_attended,
        )
        self.trail = Trail(lambda: donnie.session.hub.robot)
        self.errors = RunErrors(of=lambda: donnie.session.hub.robot)
        listeners = (self.trail.on_event, self.errors.on_event)
        self._unsubscribe = [donnie.team.stream.subscribe(each) for each in listeners]

    def close(self) -> None:
        """Another front end continues with the session."""
        self.runs.close()
        for unsubscribe in self._unsubscribe:
            unsubscribe()

    @property
    def program(self) -> Document:
        """The document that the learner works with."""
        return self.workspace.document

    def map_grid(self) -> MapGrid:
        """The floor as the robot that the learner talks to finds it now."""
        from donnie_tui.core.map_grid import MapGrid

        donnie = self.donnie
        return MapGrid(donnie.picture_now(), donnie.session.pose, shown_name(donnie.session.name))

    # --- answers

    def say(self, *lines: str, is_repeated: bool = False) -> None:
        """Answer with lines: each is printed, spoken, and remembered unless it ``is_repeated``."""
        for line in lines:
            self.donnie.session.hub.publish(Answered(line, at_once=self.is_urgent, is_repeated=is_repeated))

    def answer(self, code: str, **values: object) -> None:
        """Answer with a sentence of the catalogue."""
        self.say(self.words(code, **values))

    def answer_no_line(self, number: int) -> None:
        """Answer that the program has no line of that number."""
        self.say(no_such_line(len(self.program.lines), number, self.words))

    def say_of_robot(self, *lines: str) -> None:
        """As ``say``; the first line names the robot that the learner talks to, where there are several."""
        self.say(*self.of_robot(*lines))

    def of_robot(self, *lines: str) -> tuple[str, ...]:
        """The lines as they are for the robot that the learner talks to, with its name where needed."""
        return lines_with_robot_name(self.donnie.session.hub.robot, lines, self.words)

    def answer_of_robot(self, code: str, **values: object) -> None:
        """As ``answer``, with the name of the robot where there are several."""
        self.say(with_robot_name(self.donnie.session.hub.robot, self.words(code, **values), self.words))

    def counted(self, lines: Sequence[str]) -> tuple[str, ...]:
        """A list; the number of its lines comes first where it is long."""
        is_long = len(lines) > MOST_AT_ONCE
        return (*((self.words("number-of-lines", lines=len(lines)),) if is_long else ()), *lines)
