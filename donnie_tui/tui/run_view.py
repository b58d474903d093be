"""Runs on the screen: their beginning, their pauses, their end, and the way back through them.

Programs run in their own threads and reach the screen through the event queue; nothing here waits for them.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from textual.message import Message

from donnie_tui.core.run_state import RunObserver, RunState
from donnie_tui.core.transcript import lines_of
from donnie_tui.tui.event_queue import RunBegan, RunFinished
from donnie_tui.tui.timers import Polling, Reminder

if TYPE_CHECKING:
    from donnie_tui.core.timeline import Timeline
    from donnie_tui.tui.controller import ScreenController


class RunStateChanged(Message):
    """The running program pauses, or continues."""


class RunView(RunObserver):
    """Updates the screen with the programs of the robot that the learner talks to."""

    def __init__(self, controller: ScreenController) -> None:
        self._controller, self._events = controller, controller.events
        self._runs = controller.ctx.runs
        self._runs.observer = self
        self.polling = Polling(controller.look, controller.app.set_timer)
        self._reading: Reminder | None = None
        self._past: Timeline | None = None
        """What the map shows; None is the present."""

    # --- one run

    def on_change(self) -> None:
        self._controller.app.post_message(RunStateChanged())

    def on_began(self, event: RunBegan) -> None:
        """What waits in the queue is this run's: the end of the last one took everything."""
        self.show_past()
        self._stop_reminder()
        if self._runs.is_whole:
            self._reading = Reminder(self._controller.app, self._report_reading)
        self._controller.display.begin(event.pose, fresh=event.fresh)
        self._events.begun()
        self.polling.begin()
        self._controller.look()

    def _stop_reminder(self) -> None:
        if self._reading is not None:
            self._reading.stop()
            self._reading = None

    def _report_reading(self) -> None:
        """A huge program is still read and checked: nothing of it has run yet."""
        if self._runs.state is RunState.RUNNING and not self._runs.frames:
            lines = self._controller.main_screen.editor.line_count
            self._controller.ctx.answer("slow-reading", lines=lines)
        else:
            self._stop_reminder()

    def on_state_changed(self) -> None:
        """A pause was described; put the cursor there."""
        frames = self._runs.frames
        if self._runs.is_held and frames:
            self.show_past()
            self._controller.ask_distances()
            if self._runs.is_whole:
                self._controller.main_screen.editor.go_to(frames[0].line)
            self._events.flush()
        self._controller.look()

    def on_finished(self, event: RunFinished) -> None:
        """Sum the run up, unless another robot was chosen meanwhile."""
        controller = self._controller
        if event.robot not in (None, controller.donnie.session.name):
            return
        self._stop_reminder()
        self.show_past()
        controller.ask_distances()
        self._events.take()
        controller.display.move((event.event.pose,))
        self.polling.end()
        if event.errors and self._runs.is_whole:
            controller.main_screen.editor.go_to(event.errors[0].line, event.errors[0].column)
        self._runs.sum_up(event.robot)
        self._events.flush()
        if event.errors and self._runs.is_whole:
            controller.display.acted()
            controller.display.looked()  # the status line is about the first mistake, not the log's last one
        elif event.errors:
            controller.display.keep(lines_of(event.errors[0], controller.words)[0])
        controller.look()

    # --- which robot, and where it stands

    def robot_changed(self) -> None:
        """The learner talks to another robot, or it stands elsewhere: the map shows its way."""
        controller = self._controller
        self._runs.forget_ended()
        self._stop_reminder()
        if self._runs.state is RunState.READY:
            self.polling.end()
        else:
            self.polling.begin()
        controller.display.show_world()
        controller.display.begin(controller.donnie.session.pose, fresh=True)
        self._runs.to_present()
        self._past = None
        controller.display.show_past(controller.donnie.chronicle.timeline())
        controller.look()

    def show_past(self) -> None:
        """The map as STEP BACK left it, or as it is now."""
        past, before = self._runs.past, self._past
        self._past = past
        if past is not None:
            self._controller.display.show_past(past)
        elif before is not None:
            before.go_to(len(before))
            self._controller.display.show_past(before)
