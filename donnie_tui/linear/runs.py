"""Running what is typed, and watching it: lines are printed as they come, Ctrl+C stops the robot first.

Rules: the program's thread never prints; keys that are pressed meanwhile wait, but for a whole line that is
meant for the running program (PAUSE, STOP, SLOWER, FASTER, SPEED); a run that has said nothing for a while
says that it is still there.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from functools import partial

from donnie_tui.core.events import TYPED, Outcome, RunEnded, Stamped
from donnie_tui.core.runner import Run
from donnie_tui.core.session import LONGEST_STOP
from donnie_tui.core.told_errors import told_hints
from donnie_tui.linear.asking import GRACE
from donnie_tui.linear.desk import Desk
from donnie_tui.linear.holding import Goes, Holding, Wish
from donnie_tui.linear.output import LARGEST_BLOCK
from donnie_tui.linear.reader import Typed
from donnie_tui.linear.told import Told
from language.control import ExecutionControl

FIRST_SIGN = 3.0
"""Seconds without a line after which a run first says that it is still there; later ones can be chosen."""
HEARTBEAT = 1.0
NEVER = 1e9
LAST_LINES = 3
"""Lines of a stopped program that are still told; what more waited is left out, which is said."""


class Runs:
    """Runs programs at a desk, one after the other."""

    def __init__(
        self, desk: Desk, told: Told, wish_of: Callable[[Typed], Wish | None], live: Callable[[], bool]
    ) -> None:
        """``wish_of`` tells what a line means to a program that is held, and does what else it asks for.

        ``live`` looks for a line that was typed for the running program, and does it.
        """
        self._desk = desk
        self._console = desk.console
        self._told = told
        self._live = live
        self._holding = Holding(desk, wish_of)
        self._ended = False
        self._robot: str | None = None
        """Whose run is watched; None where the world has but one robot."""
        self._stopping = False
        self._rested = False
        self._stopped_at: dict[str | None, int] = {}
        """The line of each robot whose program was stopped."""
        self._left_out = 0
        self._refusals = 0
        """How often in a row what waits was refused."""
        self._told_before = 0
        self._sign_due = 0.0
        hub = desk.session.hub
        self._unsubscribe = [hub.subscribe(each) for each in (self._hear, self._holding.hear)]
        self._unsubscribe.append(hub.add_gate(told.wait_for_room))

    def close(self) -> None:
        for leave in self._unsubscribe:
            leave()

    # --- what to run

    def run_waiting(
        self, last: str | None = None, *, begin: Callable[[ExecutionControl], None] | None = None
    ) -> None:
        """Run the lines that wait, and ``last``, which is no part of the program."""
        program = self._desk.program
        if not program.is_waiting and last is None:
            self._desk.answer("answer-nothing-to-run")
            return
        if not self.is_free(to_leave=last is not None):
            return
        batch = program.take_batch(last)
        run = self._run(batch.text, batch.first_line, begin=begin)
        if not run.was_refused:
            self._refusals = 0
            program.batch_ran()
            self._tell_hints(batch.text)
        elif program.batch_was_refused():
            self._tell_kept()

    def _tell_kept(self) -> None:
        """How to mend what was refused; the second time in a row also how to be rid of it."""
        self._refusals += 1
        first = next(iter(self._desk.heard.errors.all), None)
        code = "linear-kept-known" if first and first.meant else "linear-kept"
        self._desk.answer(code, line=(first.mended_line or first.line) if first else 1)
        if self._refusals > 1:
            self._desk.answer("linear-forget", lines=self._desk.program.waiting)

    def run_all(self, *, begin: Callable[[ExecutionControl], None] | None = None) -> None:
        """Run the whole program from the start of the world."""
        program = self._desk.program
        if not self.is_free():
            return
        if not program.text.strip():
            self._desk.answer("answer-nothing-to-run")
            return
        run = self._run(program.text, 1, fresh=True, begin=begin)
        if not run.was_refused:
            program.batch_ran()
            self._tell_hints(program.text)

    def _run(
        self,
        text: str,
        first_line: int,
        *,
        fresh: bool = False,
        begin: Callable[[ExecutionControl], None] | None = None,
    ) -> Run:
        self._prepare()
        may_be_watched = bool(begin or self._desk.watch.names or self._desk.program.breakpoints)
        try:
            run = self._desk.session.start(
                text,
                self._name(),
                fresh=fresh,
                hooked=self._desk.is_attended or may_be_watched,
                first_line=first_line,
                prepare=partial(self._holding.prepare, text, first_line, begin),
                each_statement=self._desk.watch.begin(self._desk.session, fresh=fresh),
            )
            self._watch(run)
        finally:
            self._watch_no_more()
        if run.outcome is Outcome.QUIT:
            self._desk.leaving = 0
        return run

    def _prepare(self) -> None:
        self._ended = self._stopping = False
        self._robot = self._desk.session.hub.robot
        self._stopped_at, self._left_out = {}, 0
        self._told_before = self._told.count
        self._told.hold_back()
        self._desk.beside.is_watching = True

    def _watch_no_more(self) -> None:
        self._told.let_pass()
        self._desk.beside.is_watching = False

    def watch_together(self, start: Callable[[], tuple[tuple[str, Run], ...]]) -> None:
        """Start several robots and watch until the last of them is done; Ctrl+C stops all."""
        self._prepare()
        try:
            for name, run in start():
                self._robot, self._ended = name, run.is_over
                self._watch(run)
        finally:
            self._watch_no_more()

    def watch_deed(self, start: Callable[[], Run | None]) -> None:
        """Something that takes a moment: what it says belongs to its answer."""
        run = start()
        if run is not None:
            run.wait(LONGEST_STOP)

    @property
    def tells_holds(self) -> bool:
        """Whether it is told where the robot's program is held, and asked there how it is to go on."""
        return self._holding.is_of_running

    def is_free(self, *, to_leave: bool = False) -> bool:
        """Whether the robot can run something, or that it is busy; who wants to leave waits for nobody."""
        session = self._desk.session
        busy = session.run
        if busy is not None and to_leave:
            session.stop()
            busy.wait(LONGEST_STOP)
        elif busy is not None:
            self._desk.answer("robot-busy", name=session.name)
        return session.run is None

    def _tell_hints(self, text: str) -> None:
        """What has no effect and what was probably meant.

        That it is done where nothing was told at all, or the next line was expected to be told.
        """
        if self._desk.leaving is not None:
            return
        self._desk.tell(*told_hints(text, self._desk.session, self._desk.say))
        if self._told.count == self._told_before or self._holding.is_stepped:
            self._desk.answer_of_robot("linear-done")

    def _name(self) -> str:
        name = self._desk.program.name
        return os.path.split(name)[1] if name else TYPED

    # --- watching

    def _hear(self, stamped: Stamped) -> None:
        """In the program's thread."""
        if isinstance(stamped.event, RunEnded) and stamped.robot == self._robot:
            self._ended = True
            self._console.nudge()

    def _watch(self, run: Run) -> None:
        """Until the run is over. What it says last is left for the prompt to take along."""
        self._console.stop_at_once = self._stop_at_once
        self._console.before_suspending = self._stop_real_robot
        self._rested = False
        self._expect_sign(FIRST_SIGN)
        while not self._is_over(run):
            if self._console.leaving is not None:
                self.stop()
                run.wait(LONGEST_STOP)
                break
            if self._console.take_interrupt():
                self._heed_interrupt()
            elif self._holding.is_held and not self._stopping:
                self._while_held(run)
            else:
                self._print_what_comes()
        self._console.stop_at_once = lambda: None
        self._console.before_suspending = self._desk.donnie.stop_real_robot
        if self._stopping and self._console.pressed_interrupt():
            self._heed_interrupt()
        self._desk.donnie.team.settle()
        if self._console.leaving is None:
            self._tell_left_out()
            if run.outcome is Outcome.STOPPED:
                self._tell_stopped()

    def _is_over(self, run: Run) -> bool:
        return run.is_over or (self._ended and run.wait(LONGEST_STOP))

    def _print_what_comes(self) -> None:
        """A program that talks without end is reached by a word all the same."""
        if self._live():
            self._show_answer()
        elif self._told and not self._stopping:
            self._wait_for_more()
            if not self._ended:
                self._left_out += self._desk.showing.show_block()
                self._expect_next_sign()
        elif self._console.now() >= self._sign_due:
            self._give_sign()
        elif not self._is_woken():
            self._leave_out()
            left = min(HEARTBEAT, self._sign_due - self._console.now())
            self._console.wait(left, reading=self._desk.ends.hears_live)

    def _show_answer(self) -> None:
        """To a word said meanwhile; once the program is being stopped, with all that is told of that."""
        if not self._stopping:
            self._desk.showing.show_block()

    def _leave_out(self) -> None:
        """What waits to be printed of a program that is being stopped, but the last of it."""
        if self._stopping:
            self._left_out += self._told.trim(LAST_LINES)

    def _is_woken(self) -> bool:
        """Whether what would end a wait came already, while keys were looked for: it wakes but once."""
        must_go = self._ended or self._console.interrupted or self._console.leaving is not None
        return must_go or (self._holding.is_held and not self._stopping)

    def _wait_for_more(self) -> None:
        until = self._console.now() + GRACE
        while not self._ended and not self._console.interrupted:
            left = until - self._console.now()
            if left <= 0:
                return
            self._console.wait(left)

    # --- a sign of life

    def _expect_sign(self, seconds: float) -> None:
        self._sign_due = self._console.now() + (seconds if self._desk.ends.habits.progress else NEVER)

    def _expect_next_sign(self) -> None:
        self._expect_sign(max(FIRST_SIGN, self._desk.ends.habits.progress))

    def _give_sign(self) -> None:
        from donnie_tui.linear.progress import sign_of_life  # long runs

        sign_of_life(self._desk)
        self._desk.showing.show_told()
        self._expect_next_sign()

    # --- stopping and pausing

    def _heed_interrupt(self) -> None:
        """Ctrl+C, which may have stopped the program already."""
        self._begin_new_line()
        if not self._stopping:
            self.stop()
        self._desk.donnie.team.stop()

    def _stop_at_once(self) -> None:
        """From a signal, while the terminal takes nothing. It is heeded when that is over."""
        if not self._stopping:
            self.stop()

    def _stop_real_robot(self) -> None:
        """Before Ctrl+Z: returns once the robot stands; told when the learner is back."""
        if not self._desk.donnie.connection.is_real:
            return
        if not self._stopping:
            self._rested = True
            self.stop()
        self._desk.donnie.connection.wait_until_standing()

    def stop(self) -> None:
        """Remember where, and stop."""
        self.remember_stop()
        self._desk.session.stop()

    def stop_beside(self) -> None:
        """The program that runs beside the conversation; said once it is done."""
        self.stop()
        self._desk.session.settle()
        self._rested, self._left_out = False, 0
        self._robot = self._desk.session.hub.robot
        self._desk.beside.leave_out()
        self._tell_stopped()

    def remember_stop(self) -> None:
        """It is about to be stopped: remember where; whatever it still tells must not wait for us."""
        self._stopping = self._desk.showing.is_hurrying = True
        frames_of = ((session.hub.robot, session.frames) for session in self._desk.donnie.team.running)
        self._stopped_at = {robot: frames[0].line for robot, frames in frames_of if frames}
        self._told.let_pass()

    def _begin_new_line(self) -> None:
        """A terminal that edits by itself has shown Ctrl+C."""
        if not self._desk.ends.can_edit:
            self._desk.ends.hold_newline()

    def _tell_left_out(self) -> None:
        self._leave_out()
        if self._left_out:
            self._desk.answer("answer-left-out", lines=self._left_out)
            self._left_out = 0

    def _tell_stopped(self) -> None:
        if self._rested:
            self._desk.answer("suspended-stopped")
        line = self._stopped_at.get(self._robot)
        if line is None:
            self._desk.answer_of(self._robot, "answer-stopped")
        else:
            self._desk.answer_of(self._robot, "answer-stopped-at", line=line)

    def _while_held(self, run: Run) -> None:
        """Say where the program is, and do what is asked."""
        if self._desk.is_pausing and (left_out := self._told.trim(LARGEST_BLOCK)):
            self._desk.answer("answer-left-out", lines=left_out)
        wish = self._holding.ask()
        self._told_before = self._told.count
        match wish.goes:
            case Goes.STEP:
                run.control.step()
            case Goes.OVER:
                run.control.step_over()
            case Goes.UNTIL:
                run.control.run_to(wish.line)
            case Goes.ON:
                run.control.resume()
            case Goes.STOP:
                self.stop()
        self._expect_sign(FIRST_SIGN)
