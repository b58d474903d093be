"""Following the programs: what the beginning, the holding and the end of a run do at the screen.

Rule: programs run in their own threads and reach the screen through the bridge's mailbox; nothing here waits
for them.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from textual.message import Message

from donnie_tui.core.events import Outcome
from donnie_tui.core.told_errors import ToldErrors
from donnie_tui.core.transcript import lines_of
from donnie_tui.tui.bridge import Began, Ended
from donnie_tui.tui.glances import Glances
from donnie_tui.tui.intake import Intake
from donnie_tui.tui.patience import Reminder
from donnie_tui.tui.running import Answer, Doing
from language.control import ControlState

if TYPE_CHECKING:
    from donnie_tui.tui.application import Host
    from donnie_tui.tui.past import Past
from donnie_tui.tui.workbench import Workbench


class Paused(Message):
    """The running program holds."""


class Following:
    """Keeps the screen up with the programs of the robot that is talked to."""

    def __init__(self, work: Workbench, host: Host, intake: Intake, past: Past) -> None:
        self._work = work
        self._host = host
        self._intake = intake
        self._past = past
        self.errors = ToldErrors()
        """The mistakes of the last run."""
        self.glances = Glances(work.look, host.later)
        self._reading: Reminder | None = None

    # --- one run

    def began(self, event: Began) -> None:
        """What waits in the mailbox is this run's: the end of the last one took everything."""
        work = self._work
        self._past.to_present()
        self._expect_reading()
        work.display.begin(event.pose, fresh=event.fresh)
        self._intake.begun()
        self.glances.begin()
        work.look()

    def _expect_reading(self) -> None:
        self._forget_reading()
        if self._work.running.is_program:
            self._reading = Reminder(self._host, self._tell_reading)

    def _forget_reading(self) -> None:
        if self._reading is not None:
            self._reading.stop()
            self._reading = None

    def _tell_reading(self) -> None:
        """A huge program is still being read and checked: nothing of it has run yet."""
        running = self._work.running
        if running.doing is Doing.RUNNING and not running.frames:
            self._work.talk.tell(Answer("slow-reading", {"lines": self._work.workplace.editor.line_count}))
        else:
            self._forget_reading()

    def told(self, state: ControlState) -> None:
        """A pause began or ended; told in any thread."""
        if state is ControlState.PAUSED:
            self._host.post_message(Paused())

    def paused(self) -> None:
        """It holds, and has said where: put the cursor there."""
        running = self._work.running
        frames = running.frames
        if running.doing is Doing.PAUSED and frames and running.is_program:
            self._past.to_present()
            self._work.ask_distances()
            self._work.workplace.editor.go_to(frames[0].line)
            self._intake.take()
            self._intake.write()
        self._work.look()

    def ended(self, event: Ended) -> None:
        """Unless another robot was chosen while it was on its way here."""
        work = self._work
        if event.robot not in (None, work.donnie.session.name):
            return
        self._forget_reading()
        self._past.to_present()
        has_run = work.running.ended()
        self.errors = ToldErrors(event.errors)
        work.ask_distances()
        self._intake.take()
        work.display.move((event.event.pose,))
        self.glances.end()
        if has_run:
            work.watch.look(work.donnie.session, event.event.variables.items())
            work.talk.tell_sentences(*work.running.take_hints())
        self._tell_end(event)
        self._intake.take()
        self._intake.write()
        if event.errors and work.running.is_program:
            work.display.acted()
            work.display.looked()  # the status line is about the first mistake, not the one told last
        elif event.errors:
            work.display.keep(lines_of(event.errors[0], work.words)[0])
        work.look()

    def _tell_end(self, event: Ended) -> None:
        work, outcome = self._work, event.event.outcome
        if event.errors and work.running.is_program:
            work.workplace.editor.go_to(event.errors[0].line, event.errors[0].column)
        if outcome is Outcome.STOPPED:
            work.talk.tell(work.running.stopped)
        elif outcome is Outcome.COMPLETED and work.running.is_program:
            work.talk.tell(Answer("screen-done", of_robot=True))
        elif outcome is Outcome.COMPLETED and self._told_nothing:
            work.talk.tell(Answer("linear-done", of_robot=True))

    @property
    def _told_nothing(self) -> bool:
        """Since the command was typed."""
        self._intake.take()
        self._intake.write()
        return not self._work.answers.has_begun

    # --- which robot, and where it stands

    def robot_chosen(self) -> None:
        """Another robot is talked to: the map shows its way."""
        work = self._work
        work.running.look_again()
        self._forget_reading()
        if work.running.doing is Doing.READY:
            self.glances.end()
        else:
            self.glances.begin()
        work.display.show_world()
        work.display.begin(work.pose, fresh=True)
        self._past.forget()
        work.look()

    def show_pose(self) -> None:
        """After a reset: the robot stands at its start."""
        if self._work.running.doing is Doing.READY:
            self._work.display.begin(self._work.pose, fresh=True)
