"""Follows a run in the main thread: prints what the program says, takes words meanwhile, asks while it holds.

Rules: the program's thread never prints. Keys that are pressed meanwhile wait, but for a whole line that is
meant for the running program (PAUSE, STOP, SLOWER, FASTER, SPEED). Ctrl+C stops the robot first. A run that
has said nothing for a while reports that it is still there.
"""

from __future__ import annotations

from collections.abc import Iterable
from math import hypot

from donnie_tui.commands.dispatch import perform, says_slip
from donnie_tui.commands.interaction import drive
from donnie_tui.commands.lookup import find
from donnie_tui.core.events import Outcome
from donnie_tui.core.run_state import RunObserver, RunState
from donnie_tui.core.runner import Run
from donnie_tui.core.session import LONGEST_STOP
from donnie_tui.linear.asking import GRACE
from donnie_tui.linear.desk import Desk
from donnie_tui.linear.greeting import PROMPT
from donnie_tui.linear.output import LARGEST_BLOCK, Told
from donnie_tui.linear.reader import EditingReader, How, Typed
from language import keywords
from language.source import printable

FIRST_SIGN = 3.0
"""Seconds without a line after which a run first reports that it is still there; later ones can be chosen."""
HEARTBEAT = 1.0
NEVER = 1e9
LAST_LINES = 3
"""Lines of a stopped program that are still printed; the number of those left out is printed, too."""
LONGEST_QUOTE = 30
"""Characters of a refused line that its answer repeats."""
_LIVE = ("stop", "stop_all", "robots", "pause", "slower", "faster", "speed", "quiet")
"""Commands that are run while a program runs, also before lines that wait to be read."""


class RunLoop(RunObserver):
    """Follows one run after the other."""

    def __init__(self, desk: Desk, told: Told, editing: EditingReader | None) -> None:
        """``editing`` is None where lines can't be typed before the program has ended."""
        self._desk, self._runs = desk, desk.ctx.runs
        self._console = desk.console
        self._told, self._editing = told, editing
        self._robot: str | None = None
        """The robot whose run is followed; None where the world has but one."""
        self._stopping = False
        self._is_new_hold = False
        """Whether the learner was not asked yet where the program is held."""
        self._was_suspended = False
        """Whether the run was stopped before Ctrl+Z."""
        self._left_out = 0
        self._sign_due = 0.0
        self._runs.observer = self
        self._remove_gate = desk.session.hub.add_gate(told.wait_for_room)

    def close(self) -> None:
        self._runs.close()
        self._remove_gate()

    # --- what the runs report, from any thread

    def on_change(self) -> None:
        self._is_new_hold |= self._runs.is_held
        self._console.nudge()

    def before_stop(self) -> None:
        """What the programs still say must not wait for this thread, which waits for them."""
        self._stopping = self._desk.showing.is_hurrying = True
        self._told.let_pass()

    def after_stop(self) -> None:
        self._desk.beside.leave_out()

    # --- following

    def follow(self, runs: Iterable[tuple[str | None, Run]]) -> None:
        """Until the last of the runs is over, each by the name of its robot in events."""
        self._stopping, self._left_out = False, 0
        self._told.hold_back()
        self._desk.beside.is_watching = True
        try:
            for self._robot, run in runs:
                self._follow(run)
        finally:
            self._told.let_pass()
            self._desk.beside.is_watching = False

    def _follow(self, run: Run) -> None:
        console = self._console
        console.stop_at_once = self._stop_at_once
        console.before_suspending = self._stop_real_robot
        self._was_suspended = False
        self._expect_sign(FIRST_SIGN)
        while not self._is_over(run):
            if console.leaving is not None:
                self._stop()
                run.wait(LONGEST_STOP)
                break
            if console.take_interrupt():
                self._on_interrupt()
            elif self._runs.is_held and not self._stopping:
                self._take_while_held()
            else:
                self._print_pending()
        console.stop_at_once = lambda: None
        console.before_suspending = self._desk.donnie.stop_real_robot
        if self._stopping and console.pressed_interrupt():
            self._on_interrupt()
        self._desk.donnie.team.settle()
        if console.leaving is None:
            self._sum_up(run)
        if run.outcome is Outcome.QUIT:
            self._desk.leaving = 0

    def _is_over(self, run: Run) -> bool:
        return run.is_over or (self._runs.has_ended(self._robot) and run.wait(LONGEST_STOP))

    def _sum_up(self, run: Run) -> None:
        self._leave_out()
        if self._left_out:
            self._desk.answer("answer-left-out", lines=self._left_out)
            self._left_out = 0
        if self._was_suspended and run.outcome is Outcome.STOPPED:
            self._desk.answer("suspended-stopped")
        self._runs.sum_up(self._robot)

    # --- printing

    def _print_pending(self) -> None:
        """Keys are looked for between two blocks of a program that talks without end."""
        if self._take_live():
            if not self._stopping:
                self._desk.showing.show_block()
        elif self._told and not self._stopping:
            self._wait_for_more()
            if not self._runs.has_ended(self._robot):
                self._left_out += self._desk.showing.show_block()
                self._expect_next_sign()
        elif self._console.now() >= self._sign_due:
            self._report_progress()
            self._desk.showing.show_told()
            self._expect_next_sign()
        elif not self._is_woken():
            self._leave_out()
            left = min(HEARTBEAT, self._sign_due - self._console.now())
            self._console.wait(left, reading=self._desk.ends.hears_live)

    def _leave_out(self) -> None:
        """All that waits to be printed of a program that is being stopped, but the last lines."""
        if self._stopping:
            self._left_out += self._told.trim(LAST_LINES)

    def _is_woken(self) -> bool:
        """Whether something came while keys were looked for: it wakes only once."""
        console = self._console
        must_act = self._runs.has_ended(self._robot) or console.interrupted or console.leaving is not None
        return must_act or (self._runs.is_held and not self._stopping)

    def _wait_for_more(self) -> None:
        until = self._console.now() + GRACE
        while not self._runs.has_ended(self._robot) and not self._console.interrupted:
            left = until - self._console.now()
            if left <= 0:
                return
            self._console.wait(left)

    # --- a sign of life

    def _expect_sign(self, seconds: float) -> None:
        self._sign_due = self._console.now() + (seconds if self._desk.ends.options.progress else NEVER)

    def _expect_next_sign(self) -> None:
        self._expect_sign(max(FIRST_SIGN, self._desk.ends.options.progress))

    def _report_progress(self) -> None:
        """How far the robot has walked, or where its program is."""
        desk, state = self._desk, self._runs.state
        if desk.session.run is None:  # those that run together with it have not ended
            for session in desk.donnie.team.running[:1]:
                desk.answer_of(session.hub.robot, "linear-still-running")
            return
        if state is RunState.PAUSED:
            desk.answer_of_robot("linear-paused")
            return
        frames, lines = self._runs.frames, desk.program.lines
        line = frames[0].line if frames else 0
        text = lines[line - 1].strip() if 0 < line <= len(lines) else ""
        before, now = desk.ctx.trail.last_pose, desk.session.pose
        walked = round(hypot(now.x - before.x, now.y - before.y)) if before else 0
        if walked:
            self._report_walk(walked, text)
        elif text:
            desk.answer("linear-still-at", line=line, text=text)
        else:
            desk.answer("linear-still-running" if frames else "linear-still-reading")

    def _report_walk(self, walked: int, text: str) -> None:
        """With the number of steps that were asked for, where the line is just one walk."""
        from language.parser import parse
        from language.syntax import NumberLiteral, WalkCommand

        program = parse(text).program
        statement = program.body[0] if program and len(program.body) == 1 else None
        if isinstance(statement, WalkCommand) and isinstance(statement.steps, NumberLiteral):
            self._desk.answer("still-walking-of", done=walked, asked=statement.steps.value)
        else:
            self._desk.answer("still-walking", done=walked)

    # --- stopping

    def _stop(self) -> None:
        self._runs.note_stop()
        self._desk.session.stop()

    def _on_interrupt(self) -> None:
        """Ctrl+C, which may have stopped the program already."""
        if not self._desk.ends.can_edit:  # a terminal that edits by itself has shown it
            self._desk.ends.hold_newline()
        if not self._stopping:
            self._stop()
        self._desk.donnie.team.stop()

    def _stop_at_once(self) -> None:
        """From a signal, while the terminal takes no output. ``_on_interrupt`` follows when that is over."""
        if not self._stopping:
            self._stop()

    def _stop_real_robot(self) -> None:
        """Before Ctrl+Z: returns once the robot stands; reported when the learner is back."""
        connection = self._desk.donnie.connection
        if not connection.is_real:
            return
        if not self._stopping:
            self._was_suspended = True
            self._stop()
        connection.wait_until_standing()

    # --- words

    def _take_live(self) -> bool:
        """Run the command of a line that was typed for the running program. Whether there was one."""
        if self._editing is None or not self._desk.ends.hears_live:
            return False
        line = self._editing.take_ahead(self._is_live)
        found = find(line) if line else None
        if line is None or found is None:
            return False
        self._desk.past.remember(line)
        self._desk.ctx.is_urgent = True
        try:
            drive(perform(self._desk.ctx, *found))
        finally:
            self._desk.ctx.is_urgent = False
        return True

    def _is_live(self, line: str) -> bool:
        """CONTINUE is one where no prompt asks for it."""
        found = find(line)
        name = found[0].name if found is not None else ""
        return name in _LIVE or (name == "continue_" and not self._runs.is_steppable)

    def _take_while_held(self) -> None:
        """Ask how the program is to go on, or run any other command."""
        if self._told and (left_out := self._told.trim(LARGEST_BLOCK)):
            self._desk.answer("answer-left-out", lines=left_out)
        frames = self._runs.frames if self._is_new_hold else ()
        self._is_new_hold = False
        if frames and 0 < frames[0].line <= len(self._desk.program.lines):
            self._desk.program.place = frames[0].line
        typed = self._desk.asking.read(PROMPT)
        self._take_of_held(typed, typed.text.strip())
        self._expect_sign(FIRST_SIGN)

    def _take_of_held(self, typed: Typed, line: str) -> None:
        word = keywords.canonical(line)
        if typed.how in (How.INTERRUPTED, How.CLOSED) or word in ("QUIT", "EXIT"):
            self._stop()
        elif typed.how is How.ESCAPE or word == "RUN":
            self._runs.continue_()
        elif typed.how is How.TOO_LONG:
            self._desk.answer("linear-too-long")
        elif not line:
            self._runs.step()
        elif found := find(line):
            drive(perform(self._desk.ctx, *found))
            if self._desk.goes_to:
                self._stop()
        elif not says_slip(self._desk.ctx, line):
            self._desk.answer("linear-not-taken", line=printable(line[:LONGEST_QUOTE]))
            self._desk.answer("linear-stepping")
