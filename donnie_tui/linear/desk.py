"""What the words of the linear mode work with: the session, the typed program, and how to answer and to ask.

Rule: an answer goes through the hub like everything else that is told, so that it is also spoken.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Protocol

from donnie_tui.bootstrap import Donnie
from donnie_tui.commands.declarations import BY_NAME
from donnie_tui.commands.dispatch import perform
from donnie_tui.commands.interaction import drive
from donnie_tui.core.answer_log import AnswerLog
from donnie_tui.core.document import Document
from donnie_tui.core.line_history import LineHistory
from donnie_tui.core.runner import Run
from donnie_tui.core.session import Session
from donnie_tui.core.transcript import lines_with_robot_name, with_robot_name
from donnie_tui.core.workspace import Workspace
from donnie_tui.linear.asking import Asking
from donnie_tui.linear.beside import Beside
from donnie_tui.linear.console import Console
from donnie_tui.linear.ends import Ends
from donnie_tui.linear.hearing import Hearing
from donnie_tui.linear.output import LARGEST_BLOCK
from donnie_tui.linear.showing import Showing

if TYPE_CHECKING:
    from donnie_tui.commands.context import Context
    from donnie_tui.linear.reader import Typed

SOON = 1.0
"""Seconds between two copies while lines come without a pause."""


class Desk:
    """One conversation."""

    def __init__(
        self,
        donnie: Donnie,
        ends: Ends,
        workspace: Workspace,
        answers: AnswerLog,
        past: LineHistory,
    ) -> None:
        """``answers`` and ``past`` come from before, from another world."""
        self.say = donnie.words
        self.donnie = donnie
        self.ends = ends
        self.workspace = workspace
        workspace.begin_with(self.session.name)
        workspace.report_failure = lambda error: self.answer("answer-not-kept", reason=error.reason)
        self.copying = CopySchedule(ends.console, workspace.keep_copies)
        self.answers = answers
        self.beside = Beside(donnie, ends.told, self.answer, self._stop_all)
        self.heard = Hearing(donnie, ends, self.beside)
        self.showing = Showing(ends, self.say, self.answers)
        self.asking = Asking(
            ends, self.heard, self.showing, self.beside, self.say, self.answer, self.tell, self._keep_copy
        )
        self.leaving: int | None = None
        """The exit code, once we are to leave."""
        self.goes_to = ""
        """The world that is to be gone to once the program that is held was stopped for it."""
        self.next_line: Callable[[str], bool] | None = None
        """Who takes the next line in place of the program; False if it does not want it."""
        self.reads_next = False
        """Whether a command waits for the next line."""
        self.goes_on: Callable[[], None] | None = None
        """What an empty line does where nothing waits to be run."""
        self.past = past
        """The lines typed so far, this one included."""
        self.follow: Callable[[Sequence[tuple[str | None, Run]]], None] = _nothing
        """Waits for the end of runs, and prints what they say."""
        self.take_again: Callable[[str], None] = _nothing
        """Does a line as if it had been typed."""
        self.quit: Callable[[], None] = lambda: None
        """Leaves, as the word does that is typed alone."""
        self.tour_page = 1
        """Where TOUR goes on."""
        self.ctx: Context
        """What commands use."""

    def close(self) -> None:
        """Hear no more: somebody else goes on with the session."""
        self.ctx.close()
        self.copying.cancel()
        self.heard.close()

    @property
    def session(self) -> Session:
        """That of the robot which is talked to."""
        return self.donnie.session

    @property
    def program(self) -> Document:
        """The document of the chosen robot."""
        return self.workspace.document

    @property
    def console(self) -> Console:
        return self.ends.console

    @property
    def is_attended(self) -> bool:
        """Whether there is somebody to be asked."""
        return self.ends.prompts

    def answer(self, code: str, **values: object) -> None:
        self.tell(self.say(code, **values))

    def answer_of_robot(self, code: str, **values: object) -> None:
        """About the robot that is talked to: with its name, where there are several."""
        self.answer_of(self.session.hub.robot, code, **values)

    def answer_of(self, robot: str | None, code: str, **values: object) -> None:
        """About that robot, by the name in its events."""
        self.tell(with_robot_name(robot, self.say(code, **values), self.say))

    def tell_of_robot(self, *lines: str) -> None:
        """As it is for the robot that is talked to; the first line has its name, where there are several."""
        self.tell(*lines_with_robot_name(self.session.hub.robot, lines, self.say))

    def tell_list(self, lines: Sequence[str]) -> None:
        self.tell(*self.with_number(lines))

    def with_number(self, lines: Sequence[str]) -> tuple[str, ...]:
        """A list of more lines than are told at once; their number comes first."""
        return (
            *((self.say("linear-lines", lines=len(lines)),) if len(lines) > LARGEST_BLOCK else ()),
            *lines,
        )

    def tell(self, *lines: str) -> None:
        self.ctx.say(*lines)

    def read_next(self) -> Typed:
        """The next line, which is no part of the program."""
        self.reads_next = True
        try:
            return self.asking.read(self.ends.options.prompt_at(0))
        finally:
            self.reads_next = False

    def _stop_all(self) -> None:
        drive(perform(self.ctx, BY_NAME["stop_all"], ""))

    def _keep_copy(self) -> None:
        if self.is_attended:
            self.copying.at_prompt()


def _nothing(_: object) -> None:
    return


class Input(Protocol):
    """What the console knows of the typing."""

    when_idle: Callable[[], None] | None

    def now(self) -> float: ...

    def has_input(self) -> bool: ...


class CopySchedule:
    """When the copies of unsaved programs are written: at each prompt, while the learner thinks.

    While lines come without a pause it waits until no more are typed, or a program runs, and for no longer
    than ``SOON``: each line would have the whole program written again.
    """

    def __init__(self, console: Input, keep_copies: Callable[[], bool]) -> None:
        """``keep_copies`` returns whether there was anything to write."""
        self._console, self._keep_copies = console, keep_copies
        self._due = console.now()

    def at_prompt(self) -> None:
        if self._console.has_input() and self._console.now() < self._due:
            self._console.when_idle = self._keep
        else:
            self._keep()

    def cancel(self) -> None:
        """Nothing more is to be written when the learner pauses."""
        self._console.when_idle = None

    def _keep(self) -> None:
        self.cancel()
        if self._keep_copies():
            self._due = self._console.now() + SOON
