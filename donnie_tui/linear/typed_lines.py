"""What a line does that is typed while no program runs: a word is done, anything else joins the program."""

from __future__ import annotations

from donnie_tui.commands.dispatch import perform, says_slip
from donnie_tui.commands.interaction import drive
from donnie_tui.commands.lookup import find
from donnie_tui.commands.run import run_program
from donnie_tui.core.document import Document, ProgramTooLong
from donnie_tui.linear.desk import Desk
from donnie_tui.linear.leaving import Leaving
from donnie_tui.linear.run_loop import RunLoop
from language import keywords
from language.diagnostics import MistakeKind


class TypedLines:
    """Takes one line after the other."""

    def __init__(self, desk: Desk, runs: RunLoop, leaving: Leaving) -> None:
        self._desk = desk
        self._runs = runs
        self._leaving = leaving
        self._quit_was_refused = False

    def take_and_run(self, line: str) -> None:
        """ESC: what stands there is finished, and everything runs."""
        if not line.strip() and self._desk.next_line is not None:
            self._desk.next_line = None
            self._desk.answer("answer-unchanged")
        elif not line.strip() or self.take(line):
            drive(run_program(self._desk.ctx, is_whole=False))

    def take(self, line: str) -> bool:
        """Do a word, or add the line to the program. Whether it was added and nothing more."""
        then, self._desk.next_line = self._desk.next_line, None
        words = line.split()
        first = keywords.canonical(words[0]) if words else None
        if then and then(line):
            pass
        elif not words:
            self._run_unless_open()
        elif found := find(line):
            self._desk.quit = lambda: self._quit(line)
            drive(perform(self._desk.ctx, *found))
        elif first is not None or not says_slip(self._desk.ctx, line):
            return self._add(line)
        return False

    def _add(self, line: str) -> bool:
        self._quit_was_refused = False
        hears_blocks = self._desk.is_attended and self._desk.donnie.outlets.audible.has_cues
        before = self._desk.program.depth if hears_blocks else 0
        try:
            self._desk.program.add(line)
        except ProgramTooLong:
            self._desk.answer("linear-too-long")
            return False
        if hears_blocks:
            from donnie_tui.commands.sound import chime_block

            chime_block(self._desk.donnie, before, self._desk.program.depth)
        if self._desk.ends.options.enter and not self._desk.program.open_block:
            drive(run_program(self._desk.ctx, is_whole=False))
        return True

    def _run_unless_open(self) -> None:
        """An empty line runs what waits, but not half a block; a mistake in what there is of it is told."""
        program = self._desk.program
        block = program.open_block
        if block and not self._has_mistake(program):
            self._desk.answer("linear-still-open", opener=self._spelled(block.kind), line=block.line)
        elif program.is_waiting:
            drive(run_program(self._desk.ctx, is_whole=False))
        elif self._desk.goes_on is not None:
            go_on, self._desk.goes_on = self._desk.goes_on, None
            go_on()

    def _has_mistake(self, program: Document) -> bool:
        """Whether something is wrong that no further line puts right."""
        return any(
            each.found and each.kind is not MistakeKind.MISSING_END
            for each in self._desk.session.parse(program.waiting_text).diagnostics
        )

    def _quit(self, line: str) -> None:
        """QUIT runs what was typed, then leaves; where that can't be run, a second one leaves all the same.

        What was opened and never run moves no robot because somebody leaves.
        """
        desk, block = self._desk, self._desk.program.open_block
        if self._quit_was_refused:
            self._leaving.leave(0)
        elif desk.program.was_opened and desk.program.is_waiting:
            self._leaving.tell_what_waits()
            self._leaving.leave(0)
        elif block is None:
            self._run_and_quit(line)
        elif self._add(line):
            desk.answer("linear-quit-in-block", opener=self._spelled(block.kind))

    def _run_and_quit(self, line: str) -> None:
        desk = self._desk
        drive(run_program(desk.ctx, is_whole=False, last=line))
        if desk.leaving is not None:
            self._leaving.leave(desk.leaving)
        self._quit_was_refused = desk.program.is_waiting
        if self._quit_was_refused and desk.leaving is None and desk.is_attended:
            desk.answer("linear-quit-again")

    def _spelled(self, canonical: str) -> str:
        return keywords.spelling(canonical, self._desk.say.language)
