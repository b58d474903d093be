"""How a conversation ends: by QUIT, the end of the input, Ctrl+C in a script, a signal, or for another place.

Donnie first asks whether to save each changed program; without an answer, it stays. It leaves a copy of
everything unsaved: if no question was possible, the next start offers it, else RECOVER finds it.
"""

from __future__ import annotations

import os
from contextlib import suppress

from donnie_tui.commands.context import FAILED, Context
from donnie_tui.commands.interaction import EnterWorld, SwitchMode, drive
from donnie_tui.commands.run import run_alone
from donnie_tui.core.document import Document
from donnie_tui.core.program_files import DocumentError
from donnie_tui.core.session import Busy
from donnie_tui.linear.output import BackgroundRobots
from donnie_tui.linear.prompter import Printer, Prompter, Streams
from donnie_tui.settings.parsing import remember
from language.keywords import spelling

_CHECK = 0.05
"""Seconds between two checks whether the voice has ended."""
_GOODBYE = 40
_LONGEST_SPEECH = 2400
"""Checks: two seconds; and two minutes, as long as ``donnie run`` waits for the voice."""

_INTERRUPTED = 130
"""The exit code that shells give for Ctrl+C."""


class Leaving:
    """Asks what must be asked, and sets the exit code, which ends the conversation."""

    def __init__(
        self,
        ctx: Context,
        streams: Streams,
        printer: Printer,
        prompter: Prompter,
        background: BackgroundRobots,
        offered: set[bool],
    ) -> None:
        """``offered`` are the modes that were offered as the one to begin in."""
        self._ctx, self._streams, self._console = ctx, streams, streams.console
        self._printer, self._prompter, self._background = printer, prompter, background
        self._offered = offered
        self.code: int | None = None
        """The exit code, once the conversation is to end."""
        self.world = ""
        """The world to enter, once the program that is held was stopped for it."""
        self._keeps_copies = False

    # --- the end

    def quit(self) -> None:
        """Leave because of QUIT, which runs as a program of its own: a recording ends with it.

        While a client drives a robot no program begins, and the learner leaves without it. A
        script that only opened a program did all that it wanted.
        """
        with suppress(Busy):
            drive(run_alone(self._ctx, spelling("QUIT", self._ctx.words.language)))
        self.close(is_failure=not self._ctx.program.was_opened)

    def close(self, *, is_failure: bool = True) -> None:
        """Leave because of Ctrl+D, or the end of the input. Lines that wait do not run, and are reported.

        ``is_failure``: whether a script that leaves such lines ends with an exit code that says so.
        """
        program = self._ctx.program
        waiting = program.waiting if program.is_waiting else 0
        if waiting:
            if is_failure and not self._streams.is_attended:
                self._ctx.refuse(FAILED)
            was_tried = any(each.line > len(program.lines) - waiting for each in self._ctx.errors.all)
            if was_tried:
                self._ctx.answer("lines-did-not-run-mistake", lines=waiting)
            else:
                self._report_waiting_lines()
        self.leave(0)

    def _report_waiting_lines(self) -> None:
        """Say how many lines did not run, and what they would have needed."""
        program, block = self._ctx.program, self._ctx.program.open_block
        missing = spelling("RUN" if block is None else f"END {block.kind}", self._ctx.words.language)
        self._ctx.answer("lines-did-not-run", lines=program.waiting, missing=missing)

    def leave(self, code: int) -> None:
        """Leave, once each changed program is saved or given up; else stay."""
        may_leave = all(map(self._may_leave, self._ctx.workspace.current_first))
        if may_leave and not self._ctx.donnie.site.is_saved:
            from donnie_tui.commands.build import may_leave_built

            may_leave = drive(may_leave_built(self._ctx))
        if self._console.leaving is not None:
            self.leave_by_signal(self._console.leaving)
        elif may_leave:
            if self._ctx.donnie.team.has_unstopped_run:
                self._background.stop()
            self.code = code
        elif self._prompter.has_ended:  # to stay and ask again would never end
            self._keeps_copies = True
            self._ctx.workspace.write_copies()
            if not self._ctx.donnie.site.is_saved:
                from donnie_tui.commands.build import keep_built

                keep_built(self._ctx)
            if not all(each.is_saved for each in self._ctx.workspace.current_first):
                self._ctx.answer("answer-rescued")
            self.code = code
        else:
            self.code = None
            self._ctx.answer("stays-unsaved")

    def _may_leave(self, program: Document) -> bool:
        """Whether the program is saved, given up, or kept without a question, as lines that wait are not."""
        ctx, would_be_missed = self._ctx, program.is_worth_saving or program.is_waiting
        if not self._streams.is_attended or program.is_saved or not would_be_missed:
            if self._streams.is_attended and program.is_kept_unasked:
                ctx.answer("left-kept", lines=len(program.lines))
            return True
        wants_to_save = self._prompter.confirm(ctx.words("ask-save", lines=len(program.lines)))
        if wants_to_save is False:
            ctx.answer("left-unsaved")
        if not wants_to_save:
            return wants_to_save is False
        with ctx.workspace.as_current(program):
            from donnie_tui.commands import files

            return drive(files.save_document(ctx, str(program.path or "")))

    def leave_by_signal(self, number: int) -> None:
        self._ctx.donnie.team.stop()
        self._ctx.workspace.write_copies()
        self._ctx.donnie.rescue_world()
        self.code = 128 + number

    def interrupt(self, line: str) -> None:
        """Clear the line because of Ctrl+C while nothing runs. In a script, it ends the conversation."""
        if self._ctx.donnie.team.running:
            self._background.stop()
        elif not self._streams.is_attended:
            self.code = _INTERRUPTED
        else:
            self._ctx.answer("line-cleared" if line else "nothing-to-stop")

    def say_goodbye(self) -> None:
        ctx = self._ctx
        if self.code == 0:
            ctx.answer("goodbye")
        ctx.donnie.session.hub.wait_until_delivered()
        self._printer.show()
        if self.code == 0 and not self._keeps_copies:
            self._prompter.copying.cancel()
            ctx.workspace.leave_copies(everything=self._streams.is_attended)
            ctx.workspace.write_copies()
        if self.code == 0:
            self.let_speak()

    def let_speak(self) -> None:
        """Let the voice end, for a moment if a learner types, until a key or a signal."""
        audible, is_attended = self._ctx.donnie.outlets.audible, self._streams.is_attended
        if not audible.speaks:
            return
        for _ in range(_GOODBYE if is_attended else _LONGEST_SPEECH):
            if audible.is_quiet_within(0) or self._console.is_disturbed_within(_CHECK, reading=is_attended):
                return

    # --- to another place

    def enter_world(self) -> None:
        """Raises ``EnterWorld`` if the learner wants to enter one."""
        name, self.world = self.world, ""
        if name:
            self._ctx.runs.stop_to_leave()
            self._ctx.answer_entering(name)
            raise EnterWorld(name)

    def switch_to_screen(self) -> None:
        """Raises ``SwitchMode`` with everything, the robot where it stands; says if there is no screen."""
        ctx = self._ctx
        if self._streams.editing is None:
            ctx.answer("screen-needs-terminal")
            return
        self.offer_to_remember(linear=False)
        if self._console.leaving is None:
            ctx.runs.stop_to_leave()
            self._printer.show()
            raise SwitchMode(ctx.program.text, str(ctx.program.path or "") or None, ctx.donnie)

    def offer_to_remember(self, *, linear: bool) -> None:
        """Ask, once in a session, whether Donnie is to begin in this mode from now on."""
        was_asked = linear in self._offered
        self._offered.add(linear)
        if was_asked or not self._streams.is_attended:
            return
        if not self._prompter.confirm(self._ctx.words("mode-ask-linear" if linear else "mode-ask-visual")):
            return
        try:
            remember("linear", linear, os.environ)
        except DocumentError as error:
            self._ctx.answer(error.code, path=error.path, reason=error.reason)
        else:
            self._ctx.answer("mode-remembered")
