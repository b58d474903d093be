"""What the words of the linear mode work with: the session, the typed program, and how to answer and to ask.

Rule: an answer goes through the hub like everything else that is told, so that it is also spoken.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from devices.ports.hints import TYPE_CHECKING
from donnie_tui.bootstrap import Donnie
from donnie_tui.core.answer_log import AnswerLog
from donnie_tui.core.breakpoints import KeptBreakpoints
from donnie_tui.core.events import Answered
from donnie_tui.core.session import Session
from donnie_tui.core.stepped import Stepped
from donnie_tui.core.transcript import lines_said_by, said_by
from donnie_tui.core.typed_program import TypedProgram
from donnie_tui.core.watching import Watch
from donnie_tui.linear.asking import Asking
from donnie_tui.linear.beside import Beside
from donnie_tui.linear.console import Console
from donnie_tui.linear.ends import Ends
from donnie_tui.linear.hearing import Hearing
from donnie_tui.linear.output import LARGEST_BLOCK
from donnie_tui.linear.programs import Programs
from donnie_tui.linear.showing import Showing

if TYPE_CHECKING:
    from donnie_tui.core.reading import ProgramText


class Desk:
    """One conversation."""

    def __init__(
        self,
        donnie: Donnie,
        ends: Ends,
        folder: str,
        kept_breakpoints: KeptBreakpoints,
        answers: AnswerLog | None = None,
    ) -> None:
        """``folder`` has the copies of what is not saved; ``answers`` were told before."""
        self.say = donnie.words
        self.donnie = donnie
        self.ends = ends
        self.programs = Programs(
            lambda: self.session.name,
            folder,
            kept_breakpoints,
            ends.console,
            lambda error: self.answer("answer-not-kept", reason=error.reason),
        )
        self.answers = answers or AnswerLog()
        self.beside = Beside(donnie, ends.told, self.answer)
        self.heard = Hearing(donnie, ends, self.beside)
        self.showing = Showing(ends, self.say, self.answers)
        self.asking = Asking(
            ends, self.heard, self.showing, self.beside, self.answer, self.tell, self._keep_copy
        )
        self.place = 0
        """The line of the program that was read last, 0 before any."""
        self.read_text: ProgramText | None = None
        """The program as it was read last."""
        self.searched = ""
        """What SEARCH looked for last."""
        self.watch = Watch(self.say)
        self.stepped = Stepped(lambda: donnie.chronicle.last_seq, self.say)
        """The holds of the program that runs or ran last, for STEP BACK."""
        self.is_pausing = False
        """Whether PAUSE was said to the running program."""
        self.answers_first = False
        """Whether a word is done that was typed while a program runs: the answer waits for nothing."""
        self.leaving: int | None = None
        """The exit code, once we are to leave."""
        self.goes_to = ""
        """The world that is to be gone to once the program that is held was stopped for it."""
        self.next_line: Callable[[str], bool] | None = None
        """Who takes the next line in place of the program; False if it does not want it."""
        self.goes_on: Callable[[], None] | None = None
        """What an empty line does where nothing waits to be run."""
        self.past: list[str] = []
        """The lines typed so far, this one included."""
        self.take_again: Callable[[str], None] = _nothing
        """Does a line as if it had been typed."""
        self.tour_page = 1
        """Where TOUR goes on."""

    def close(self) -> None:
        """Hear no more: somebody else goes on with the session."""
        self.programs.close()
        self.heard.close()

    @property
    def session(self) -> Session:
        """That of the robot which is talked to."""
        return self.donnie.session

    @property
    def program(self) -> TypedProgram:
        """That of the robot which is talked to."""
        return self.programs.current

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
        self.tell(said_by(robot, self.say(code, **values), self.say))

    def tell_of_robot(self, *lines: str) -> None:
        """As it is for the robot that is talked to; the first line has its name, where there are several."""
        self.tell(*lines_said_by(self.session.hub.robot, lines, self.say))

    def tell_list(self, lines: Sequence[str]) -> None:
        self.tell(*self.with_number(lines))

    def with_number(self, lines: Sequence[str]) -> tuple[str, ...]:
        """A list of more lines than are told at once; their number comes first."""
        return (
            *((self.say("linear-lines", lines=len(lines)),) if len(lines) > LARGEST_BLOCK else ()),
            *lines,
        )

    def tell(self, *lines: str) -> None:
        for line in lines:
            self.session.hub.publish(Answered(line, at_once=self.answers_first))

    def _keep_copy(self) -> None:
        if self.is_attended:
            self.programs.keep_copy()


def _nothing(_: str) -> None:
    return
