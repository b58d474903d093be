"""Runs on the screen: their beginning, their pauses, their end, and the way back through them.

Programs run in their own threads and reach the screen through the event queue; nothing here waits for them.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from textual.app import App
from textual.message import Message
from textual.timer import Timer

from donnie_tui.commands.context import Context
from donnie_tui.commands.interaction import SLOW, SLOW_AGAIN
from donnie_tui.core.run_state import RunObserver, RunState
from donnie_tui.core.transcript import lines_of
from donnie_tui.tui.display import Display
from donnie_tui.tui.event_queue import EventReader, RunBegan, RunFinished
from donnie_tui.tui.widgets.editor import Editor

if TYPE_CHECKING:
    from donnie_tui.core.timeline import Timeline

SOON, SELDOM = 1 / 5, 1.0
"""Seconds between two updates of what no event reports: at least, and at most."""


class RunStateChanged(Message):
    """The running program pauses, or continues."""


class RunView(RunObserver):
    """Updates the screen with the programs of the robot that the learner talks to."""

    def __init__(
        self, app: App[Any], ctx: Context, events: EventReader, display: Display, editor: Editor
    ) -> None:
        self._app, self._ctx, self._events = app, ctx, events
        self._display, self._editor = display, editor
        self._runs = ctx.runs
        self._runs.observer = self
        self.polling = Polling(display.update, app.set_timer)
        self._reading: Reminder | None = None
        self._past: Timeline | None = None
        """The position that the map shows; None is the present."""

    # --- one run

    def on_change(self) -> None:
        if self._runs.state is RunState.RUNNING:  # a step may be over before the message is handled
            self._editor.is_edited = False
        self._app.post_message(RunStateChanged())

    def on_began(self, event: RunBegan) -> None:
        """Begin to show a run; all queued events are its own, as the end of the last run took the others."""
        self.show_past()
        self._stop_reminder()
        if self._runs.is_whole:
            self._editor.begin_following()
            self._reading = Reminder(self._app, self._report_reading)
        self._display.begin(event.pose, fresh=event.fresh)
        self._events.begun()
        self.polling.begin()
        self._display.update()

    def _stop_reminder(self) -> None:
        if self._reading is not None:
            self._reading.stop()
            self._reading = None

    def _report_reading(self) -> None:
        """Report that a huge program is still being parsed, and nothing of it has run."""
        if self._runs.state is RunState.RUNNING and not self._runs.frames:
            self._ctx.answer("slow-reading", lines=self._editor.line_count)
        else:
            self._stop_reminder()

    def on_state_changed(self) -> None:
        """Put the cursor to the line of a described pause, unless the learner types meanwhile."""
        frames = self._runs.frames
        if self._runs.is_held and frames:
            self.show_past()
            self._display.ask_distances()
            if self._runs.is_whole:
                if not self._editor.is_edited:
                    self._editor.go_to(frames[0].line)
                self._editor.begin_following()
            self._events.flush()
        self._display.update()

    def on_finished(self, event: RunFinished) -> None:
        """Sum the run up, unless another robot was chosen meanwhile."""
        display = self._display
        if event.robot not in (None, self._ctx.donnie.session.name):
            self._runs.say_verdict()
            self._events.flush()
            return
        self._stop_reminder()
        self.show_past()
        display.ask_distances()
        self._events.take()
        display.end(event.event)
        self.polling.end()
        self._editor.end_following()
        if event.errors and self._runs.is_whole:
            self._editor.go_to(event.errors[0].line, event.errors[0].column)
        self._runs.sum_up(event.robot)
        self._events.flush()
        if event.errors and self._runs.is_whole:
            display.acted()
            display.looked()  # the status line is about the first mistake, not the log's last one
        elif event.errors:
            display.keep(lines_of(event.errors[0], self._ctx.words)[0])
        display.update()

    # --- which robot, and where it stands

    def robot_changed(self) -> None:
        """Show the map with the path of the robot, which is another one or was placed elsewhere."""
        display, donnie = self._display, self._ctx.donnie
        self._runs.forget_ended()
        self._stop_reminder()
        if self._runs.state is RunState.READY:
            self.polling.end()
        else:
            self.polling.begin()
        display.show_world()
        display.begin(donnie.session.pose, fresh=True)
        self._runs.to_present()
        self._past = None
        display.show_past(donnie.chronicle.timeline())
        display.update()

    def show_past(self) -> None:
        """Show the map at the position of STEP BACK, or as it is now."""
        past, before = self._runs.past, self._past
        self._past = past
        if past is not None or before is not None:
            self._display.show_slider()
        if past is not None:
            self._display.show_past(past)
            if self._runs.is_whole and self._runs.frames:
                self._editor.go_to(self._runs.frames[0].line)
        elif before is not None:
            before.go_to(len(before))
            self._display.show_past(before)


class Reminder:
    """Reports what takes long, again and again until it is stopped."""

    def __init__(self, app: App[Any], report: Callable[[], None]) -> None:
        self._timers = (app.set_timer(SLOW, report), app.set_interval(SLOW_AGAIN, report))

    def stop(self) -> None:
        for each in self._timers:
            each.stop()


class Polling:
    """Polls what no event reports: the line that runs, and the variables.

    Each poll costs the program time, so it comes soon after an event, and without events more and more
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
        """Poll soon, since something happened."""
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
