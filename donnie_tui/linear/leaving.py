"""How a conversation ends: by a word, by the end of the input, by Ctrl+C in a script, by a signal.

Rule: of a program that would be missed is asked whether to save it first; who does not answer stays. A copy
of whatever is not saved is left: where nobody could be asked it is offered the next time, else it is there
for whoever asks for it.
"""

from __future__ import annotations

from donnie_tui.commands.interaction import drive
from donnie_tui.core.document import Document
from donnie_tui.linear.desk import Desk
from language.keywords import spelling

_GLANCE = 0.05
_GOODBYE = 40
_LONGEST_SPEECH = 2400
"""Glances: two seconds; and two minutes, as ``donnie run`` gives the voice behind its end."""

_INTERRUPTED = 130
"""The exit code that shells give for Ctrl+C."""


class Leaving:
    """Sets the exit code at the desk, which ends the conversation."""

    def __init__(self, desk: Desk) -> None:
        self._desk = desk
        self._keeps_copies = False

    def close(self) -> None:
        """Ctrl+D, or the end of the input."""
        desk = self._desk
        waiting = desk.program.waiting if desk.program.is_waiting else 0
        if waiting and not desk.is_attended:
            was_tried = any(each.line > len(desk.program.lines) - waiting for each in desk.ctx.errors.all)
            if was_tried:
                desk.answer("linear-did-not-run-mistake", lines=waiting)
            else:
                self.tell_what_waits()
        self.leave(0)

    def tell_what_waits(self) -> None:
        """How many lines did not run, and what they would have needed."""
        program, block = self._desk.program, self._desk.program.open_block
        missing = spelling("RUN" if block is None else f"END {block.kind}", self._desk.say.language)
        self._desk.answer("linear-did-not-run", lines=program.waiting, missing=missing)

    def leave(self, code: int) -> None:
        """Leave, once a program that would be missed is saved or given up; else stay."""
        desk = self._desk
        is_settled = all(map(self._is_settled, desk.workspace.current_first))
        if desk.console.leaving is not None:
            self.leave_by_signal(desk.console.leaving)
        elif is_settled:
            self._stop_what_runs()
            desk.leaving = code
        elif desk.asking.has_ended:
            self._leave_with_copies(code)
        else:
            desk.leaving = None
            desk.answer("linear-stays")

    def _stop_what_runs(self) -> None:
        """Robots that were STARTed and go on: that they are stopped is told."""
        if self._desk.beside.goes_on:
            self._desk.beside.stop()

    def _is_settled(self, program: Document) -> bool:
        """Whether nobody would miss it any more."""
        desk = self._desk
        if not (desk.is_attended and program.is_worth_saving):
            return True
        wants_to_save = desk.asking.decide(desk.say("linear-ask-save", lines=len(program.lines)))
        if wants_to_save is False:
            desk.answer("linear-left")
        if not wants_to_save:
            return wants_to_save is False
        with desk.workspace.as_current(program):
            from donnie_tui.commands import files

            return drive(files.save_document(desk.ctx, str(program.path or "")))

    def _leave_with_copies(self, code: int) -> None:
        """The input ended at the question: to stay and ask again would never end."""
        self._keeps_copies = True
        self._desk.workspace.write_copies()
        self._desk.answer("answer-rescued")
        self._desk.leaving = code

    def leave_by_signal(self, number: int) -> None:
        self._desk.donnie.team.stop()
        self._desk.workspace.write_copies()
        self._desk.leaving = 128 + number

    def interrupt(self, line: str) -> None:
        """Ctrl+C where nothing runs: it clears the line. A script is ended by it."""
        desk = self._desk
        gives_up, desk.next_line, desk.goes_on = desk.next_line is not None, None, None
        if desk.donnie.team.running:
            desk.beside.stop()
        elif not desk.is_attended:
            desk.leaving = _INTERRUPTED
        elif gives_up:
            desk.answer("answer-unchanged")
        elif line:
            desk.answer("linear-cleared")
        else:
            desk.answer("linear-nothing-to-stop")

    def say_goodbye(self) -> None:
        if self._desk.leaving == 0:
            self._desk.answer("linear-goodbye")
        self._desk.heard.hear_out()
        self._desk.showing.show_told()
        if self._desk.leaving == 0 and not self._keeps_copies:
            self._desk.copying.cancel()
            self._desk.workspace.leave_copies(everything=self._desk.is_attended)
            self._desk.workspace.write_copies()
        if self._desk.leaving == 0:
            self.let_speak()

    def let_speak(self) -> None:
        """All is done: the voice gets its time, where somebody types a moment, until a key or a signal."""
        desk = self._desk
        if not desk.donnie.outlets.audible.speaks:
            return
        from donnie_tui.linear.sounding import is_disturbed

        for _ in range(_GOODBYE if desk.is_attended else _LONGEST_SPEECH):
            if desk.donnie.outlets.audible.is_quiet_within(0) or is_disturbed(desk, _GLANCE):
                return
