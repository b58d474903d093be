"""What a typed line does: while nothing runs it joins the program or is a command; then the run is followed.

The main thread follows a run: it prints what the program says, takes commands meanwhile, and asks while the
program is held. The program's thread never prints. Keys that are pressed meanwhile wait, except a whole line
that is a command for the running program (``Command.is_live``). Ctrl+C stops the robot first.
A run that has printed nothing for a while reports that it is still there.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from math import hypot

from donnie_tui.commands.context import Context
from donnie_tui.commands.dispatch import perform, says_slip
from donnie_tui.commands.interaction import drive
from donnie_tui.commands.lookup import find
from donnie_tui.commands.run import run_program
from donnie_tui.core.document import ProgramTooLong
from donnie_tui.core.events import Outcome
from donnie_tui.core.run_state import RunObserver, RunState
from donnie_tui.core.runner import Run
from donnie_tui.core.session import LONGEST_STOP
from donnie_tui.core.transcript import with_robot_name
from donnie_tui.linear.greeting import PROMPT
from donnie_tui.linear.leaving import Leaving
from donnie_tui.linear.output import LARGEST_BLOCK, BackgroundRobots
from donnie_tui.linear.prompter import GRACE, Printer, Prompter, Streams
from donnie_tui.linear.reader import How, Typed
from language import keywords
from language.diagnostics import Diagnostic, MistakeKind
from language.source import quoted

FIRST_REPORT = 3.0
"""Seconds without a line after which a run first reports that it is still there; later ones can be chosen."""
HEARTBEAT = 1.0
NEVER = 1e9
RUNS = "runs"
"""The value of ``enter`` with which Enter runs each complete line at once."""
LAST_LINES = 3
"""Lines of a stopped program that are still printed; the number of those left out is printed, too."""


class TypedLines:
    """Takes the lines that are typed while no program is followed."""

    def __init__(self, ctx: Context, streams: Streams) -> None:
        self._ctx, self._streams = ctx, streams
        self.continuation: Callable[[], None] | None = None
        """What an empty line does if no line waits to be run."""

    def take_and_run(self, line: str) -> None:
        """ESC: take the line, and run everything."""
        if not line.strip() or self.take(line):
            drive(run_program(self._ctx, is_whole=False))

    def take(self, line: str) -> bool:
        """Perform a command, or add the line to the program. Whether it was added and nothing more."""
        words = line.split()
        first = keywords.canonical(words[0]) if words else None
        if not words:
            self._run_unless_open()
        elif found := find(line):
            drive(perform(self._ctx, *found))
        elif first is not None or not says_slip(self._ctx, line):
            return self._add(line)
        return False

    def _add(self, line: str) -> bool:
        ctx, program = self._ctx, self._ctx.program
        chimes = self._streams.is_attended and ctx.donnie.outlets.audible.has_cues
        before = program.depth if chimes else 0
        try:
            corrected = program.add(line)
            if corrected is not None:
                ctx.answer("line-replaced", line=corrected, lines=program.waiting)
        except ProgramTooLong:
            ctx.answer("program-too-long")
            return False
        if chimes:
            from donnie_tui.commands.sound import chime_block

            chime_block(ctx.donnie, before, program.depth)
        if self._streams.settings().enter == RUNS and not program.open_block:
            drive(run_program(ctx, is_whole=False))
        return True

    def _run_unless_open(self) -> None:
        """Run the lines that wait, but no part of a block, unless it has a mistake that is to be reported."""
        program = self._ctx.program
        block = program.open_block
        mistakes = self._ctx.donnie.session.parse(program.waiting_text).diagnostics if block else ()
        if block and all(not each.found or each.kind is MistakeKind.MISSING_END for each in mistakes):
            self._ctx.answer("block-still-open", opener=self._spelled(block.kind), line=block.line)
            self._hint_at_else_if(mistakes)
        elif program.is_waiting:
            drive(run_program(self._ctx, is_whole=False))
        elif self.continuation is not None:
            continuation, self.continuation = self.continuation, None
            continuation()

    def _hint_at_else_if(self, mistakes: tuple[Diagnostic, ...]) -> None:
        hint = next((self._ctx.words.hint(each) for each in mistakes if each.code == "else-if"), None)
        if hint is not None:
            self._ctx.say(hint)

    def _spelled(self, canonical: str) -> str:
        return keywords.spelling(canonical, self._ctx.words.language)


class RunLoop(RunObserver):
    """Follows one run after the other."""

    def __init__(
        self,
        ctx: Context,
        streams: Streams,
        printer: Printer,
        prompter: Prompter,
        background: BackgroundRobots,
        leaving: Leaving,
    ) -> None:
        self._ctx, self._runs = ctx, ctx.runs
        self._streams, self._console, self._queue = streams, streams.console, streams.queue
        self._printer, self._prompter = printer, prompter
        self._background, self._leaving = background, leaving
        self._robot: str | None = None
        """The robot whose run is followed; None if the world has only one."""
        self._stopping = False
        self._asked_at = 0
        """The number of the hold at which the learner was asked last."""
        self._was_suspended = False
        """Whether the run was stopped before Ctrl+Z."""
        self.turns_page: Callable[[], bool] = lambda: False
        """Whether Enter ends the stepping and turns a page of the tour, which has asked for it."""
        self._left_out = 0
        self._report_due = 0.0
        self._runs.observer = self
        self._remove_gate = ctx.donnie.session.hub.add_gate(streams.queue.wait_for_room)

    def close(self) -> None:
        self._runs.close()
        self._remove_gate()

    # --- what the runs report, from any thread

    def on_change(self) -> None:
        if not self._background.is_following and self._runs.is_verdict_due:
            self._console.has_news = True
        self._console.nudge()

    def before_stop(self) -> None:
        """The last lines of the programs must not wait for this thread, which waits for the programs."""
        self._stopping = self._printer.is_hurrying = True
        self._queue.let_pass()

    def after_stop(self) -> None:
        self._background.trim_after_stop()

    # --- following

    def follow(self, runs: Iterable[tuple[str | None, Run]]) -> None:
        """Follows the runs, each by the name of its robot in events, until the last one is over."""
        self._stopping, self._left_out = False, 0
        self._queue.hold_back()
        self._background.is_following = True
        try:
            for self._robot, run in runs:
                self._follow(run)
        finally:
            self._queue.let_pass()
            self._background.is_following = False

    def _follow(self, run: Run) -> None:
        console = self._console
        console.stop_at_once = self._stop_at_once
        console.before_suspending = self._stop_real_robot
        self._was_suspended = False
        self._expect_report(FIRST_REPORT)
        while not run.is_over and not (self._runs.has_ended(self._robot) and run.wait(LONGEST_STOP)):
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
        console.before_suspending = self._ctx.donnie.stop_real_robot
        if self._stopping and console.pressed_interrupt():
            self._on_interrupt()
        self._ctx.donnie.team.wait_for_stop()
        if console.leaving is None:
            self._sum_up(run)
        if run.outcome is Outcome.QUIT:
            self._leaving.code = 0

    def _sum_up(self, run: Run) -> None:
        self._leave_out()
        if self._left_out:
            self._ctx.answer("answer-left-out", lines=self._left_out)
            self._left_out = 0
        if self._was_suspended and run.outcome is Outcome.STOPPED:
            self._ctx.answer("suspended-stopped")
        self._runs.sum_up(self._robot)

    # --- printing

    def _print_pending(self) -> None:
        """Print a block, report progress, or wait; keys are noticed in between, however much is printed."""
        if self._take_live():
            if not self._stopping:
                self._printer.show_block()
        elif self._queue and not self._stopping:
            self._wait_for_more()
            if not self._runs.has_ended(self._robot):
                self._left_out += self._printer.show_block()
                self._expect_next_report()
        elif self._console.now() >= self._report_due:
            self._report_progress()
            self._printer.show()
            self._expect_next_report()
        elif not self._is_woken():
            self._leave_out()
            left = min(HEARTBEAT, self._report_due - self._console.now())
            self._console.wait(left, reading=self._streams.takes_live_commands)

    def _leave_out(self) -> None:
        """Keep only the last lines of a program that is being stopped."""
        if self._stopping:
            self._left_out += self._queue.trim(LAST_LINES)

    def _is_woken(self) -> bool:
        """Whether something happened during the look for keys: it wakes only once."""
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

    # --- progress reports

    def _expect_report(self, seconds: float) -> None:
        self._report_due = self._console.now() + (
            seconds if self._streams.settings().progress != "0" else NEVER
        )

    def _expect_next_report(self) -> None:
        self._expect_report(max(FIRST_REPORT, int(self._streams.settings().progress)))

    def _report_progress(self) -> None:
        """Say how far the robot has walked, or where its program is."""
        ctx, session = self._ctx, self._ctx.donnie.session
        if session.run is None:  # those that run together with it have not ended
            for other in ctx.donnie.team.running[:1]:
                ctx.say(with_robot_name(other.hub.robot, ctx.words("still-running"), ctx.words))
            return
        if self._runs.state is RunState.PAUSED:
            ctx.answer_of_robot("program-paused")
            return
        frames, lines = self._runs.frames, ctx.program.lines
        line = frames[0].line if frames else 0
        text = lines[line - 1].strip() if 0 < line <= len(lines) else ""
        before, now = ctx.trail.last_pose, session.pose
        walked = round(hypot(now.x - before.x, now.y - before.y)) if before else 0
        if walked:
            self._report_walk(walked, text)
        elif text:
            ctx.answer("still-at-line", line=line, text=text)
        else:
            ctx.answer("still-running" if frames else "still-reading-program")

    def _report_walk(self, walked: int, text: str) -> None:
        """Reports how far the robot is, with the steps that were asked for if the line is just one walk."""
        from language.parser import parse
        from language.syntax import NumberLiteral, WalkCommand

        program = parse(text).program
        statement = program.body[0] if program and len(program.body) == 1 else None
        if isinstance(statement, WalkCommand) and isinstance(statement.steps, NumberLiteral):
            self._ctx.answer("still-walking-of", done=walked, asked=statement.steps.value)
        else:
            self._ctx.answer("still-walking", done=walked)

    # --- stopping

    def _stop(self) -> None:
        self._runs.note_stop()
        self._ctx.donnie.session.stop()

    def _on_interrupt(self) -> None:
        """Stop because of Ctrl+C, which may have stopped the program already."""
        if self._streams.is_attended and not self._streams.can_edit:  # the terminal has shown it
            self._streams.output.hold_newline()
        if not self._stopping:
            self._stop()
        self._ctx.donnie.team.stop()

    def _stop_at_once(self) -> None:
        """Stop because of a signal while the terminal takes no output. ``_on_interrupt`` follows later."""
        if not self._stopping:
            self._stop()

    def _stop_real_robot(self) -> None:
        """Stop before Ctrl+Z, and return once the robot stands; the end of the run reports it."""
        connection = self._ctx.donnie.connection
        if not connection.is_real:
            return
        if not self._stopping:
            self._was_suspended = True
            self._stop()
        connection.wait_until_standing()

    # --- commands

    def _take_live(self) -> bool:
        """Perform a command that was typed for the running program. Whether there was one."""
        ctx, editing = self._ctx, self._streams.editing
        if editing is None or not self._streams.takes_live_commands:
            return False
        line = editing.take_ahead(self._is_live)
        found = find(line) if line else None
        if line is None or found is None:
            return False
        ctx.past.remember(line)
        ctx.is_urgent = True
        try:
            drive(perform(ctx, *found))
        finally:
            ctx.is_urgent = False
        return True

    def _is_live(self, line: str) -> bool:
        """Whether it is for the running program; CONTINUE is if no prompt asks for it."""
        found = find(line)
        if found is None:
            return False
        command, _ = found
        return command.is_live or (command.name == "continue_" and not self._runs.is_steppable)

    def _take_while_held(self) -> None:
        """Ask how the program is to continue, or perform any other command."""
        hold = self._runs.hold_number
        is_new, self._asked_at = hold != self._asked_at, hold
        if is_new and self._queue and (left_out := self._queue.trim(LARGEST_BLOCK)):
            self._ctx.answer("answer-left-out", lines=left_out)  # of a program, never of an answer
        frames = self._runs.frames if is_new else ()
        if frames and 0 < frames[0].line <= len(self._ctx.program.lines):
            self._ctx.program.place = frames[0].line
        typed = self._prompter.read(PROMPT)
        self._act_while_held(typed, typed.text.strip())
        self._expect_report(FIRST_REPORT)

    def _act_while_held(self, typed: Typed, line: str) -> None:
        word = keywords.canonical(line)
        if typed.how in (How.INTERRUPTED, How.CLOSED):
            self._stop()
        elif word in ("QUIT", "EXIT"):
            self._leaving.leave(0)
            if self._leaving.code is not None:
                self._stop()
        elif typed.how is How.ESCAPE or word == "RUN":
            self._runs.continue_()
        elif typed.how is How.TOO_LONG:
            self._ctx.answer("program-too-long")
        elif not line and self.turns_page():
            self._prompter.put_back(typed)
            self._stop()
        elif not line:
            self._runs.step()
        elif found := find(line):
            drive(perform(self._ctx, *found))
            if self._leaving.world:
                self._stop()
        elif not says_slip(self._ctx, line):
            self._ctx.answer("line-not-taken", line=quoted(line))
            self._ctx.answer("stepping-commands")
