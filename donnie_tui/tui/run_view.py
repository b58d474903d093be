"""What the screen shows of runs: their beginning, their holds, their end, and the way back through them.

Rule: programs run in their own threads and reach the screen through the bridge's mailbox; nothing here waits
for them.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from textual.message import Message
from textual.timer import Timer

from donnie_tui.core.run_state import RunObserver, RunState
from donnie_tui.core.transcript import lines_of
from donnie_tui.tui.bridge import Began, Ended
from donnie_tui.tui.intake import Intake
from donnie_tui.tui.patience import Reminder
from donnie_tui.tui.workbench import Workbench

if TYPE_CHECKING:
    from donnie_tui.core.timeline import Timeline
    from donnie_tui.tui.application import Host

SOON, SELDOM = 1 / 5, 1.0
"""Seconds between two updates of what no event says: at least, and at most."""


class RunHeld(Message):
    """The running program holds, or runs on."""


class RunView(RunObserver):
    """Keeps the screen up with the programs of the robot that the learner talks to."""

    def __init__(self, work: Workbench, host: Host, intake: Intake) -> None:
        self._work, self._host, self._intake = work, host, intake
        self._runs = work.ctx.runs
        self._runs.observer = self
        self.polling = Polling(work.look, host.later)
        self._reading: Reminder | None = None
        self._past: Timeline | None = None
        """What the map shows; None is the present."""

    # --- one run

    def on_change(self) -> None:
        self._host.post_message(RunHeld())

    def on_began(self, event: Began) -> None:
        """What waits in the mailbox is this run's: the end of the last one took everything."""
        self.show_past()
        self._stop_reminder()
        if self._runs.is_whole:
            self._reading = Reminder(self._host, self._report_reading)
        self._work.display.begin(event.pose, fresh=event.fresh)
        self._intake.begun()
        self.polling.begin()
        self._work.look()

    def _stop_reminder(self) -> None:
        if self._reading is not None:
            self._reading.stop()
            self._reading = None

    def _report_reading(self) -> None:
        """A huge program is still read and checked: nothing of it has run yet."""
        if self._runs.state is RunState.RUNNING and not self._runs.frames:
            self._work.ctx.answer("slow-reading", lines=self._work.workplace.editor.line_count)
        else:
            self._stop_reminder()

    def on_held(self) -> None:
        """The hold was described; put the cursor there."""
        frames = self._runs.frames
        if self._runs.is_held and frames:
            self.show_past()
            self._work.ask_distances()
            if self._runs.is_whole:
                self._work.workplace.editor.go_to(frames[0].line)
            self._intake.take()
            self._intake.write()
        self._work.look()

    def on_ended(self, event: Ended) -> None:
        """Sums it up, unless another robot was chosen meanwhile."""
        work = self._work
        if event.robot not in (None, work.donnie.session.name):
            return
        self._stop_reminder()
        self.show_past()
        work.ask_distances()
        self._intake.take()
        work.display.move((event.event.pose,))
        self.polling.end()
        if event.errors and self._runs.is_whole:
            work.workplace.editor.go_to(event.errors[0].line, event.errors[0].column)
        self._runs.sum_up(event.robot)
        self._intake.take()
        self._intake.write()
        if event.errors and self._runs.is_whole:
            work.display.acted()
            work.display.looked()  # the status line is about the first mistake, not the last one in the log
        elif event.errors:
            work.display.keep(lines_of(event.errors[0], work.words)[0])
        work.look()

    # --- which robot, and where it stands

    def robot_changed(self) -> None:
        """Another robot is talked to, or it stands elsewhere: the map shows its way."""
        work = self._work
        self._runs.forget_ended()
        self._stop_reminder()
        if self._runs.state is RunState.READY:
            self.polling.end()
        else:
            self.polling.begin()
        work.display.show_world()
        work.display.begin(work.pose, fresh=True)
        self._runs.to_present()
        self._past = None
        work.display.show_past(work.donnie.chronicle.timeline())
        work.look()

    def show_past(self) -> None:
        """The map as STEP BACK left it, or as it is now."""
        past, before = self._runs.past, self._past
        self._past = past
        if past is not None:
            self._work.display.show_past(past)
        elif before is not None:
            before.go_to(len(before))
            self._work.display.show_past(before)


class Polling:
    """Looks again and again at what no event says: the line that runs, and the variables.

    Each look takes from the program's time. So it comes soon after an event, and in silence more and more
    seldom.
    """

    def __init__(self, look: Callable[[], None], later: Callable[[float, Callable[[], None]], Timer]) -> None:
        """``later`` sets a timer."""
        self._look, self._later = look, later
        self._rest = SOON
        self._timer: Timer | None = None

    @property
    def is_on(self) -> bool:
        return self._timer is not None

    def begin(self) -> None:
        if self._timer is None:
            self._look_in(SOON)

    def on_event(self) -> None:
        """Something happened: the next look is soon."""
        if self._timer is not None and self._rest > SOON:
            self._timer.stop()
            self._look_in(SOON)

    def end(self) -> None:
        if self._timer is not None:
            self._timer.stop()
            self._timer = None

    def _look_in(self, seconds: float) -> None:
        self._rest = seconds
        self._timer = self._later(seconds, self._poll)

    def _poll(self) -> None:
        self._look_in(min(2 * self._rest, SELDOM))
        self._look()
