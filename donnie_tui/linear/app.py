"""The linear mode: lines are typed, run and answered; nothing that stands printed is ever changed.

Rules: leaving is always possible; whatever ends the session, the robot stops, the terminal is as it was
found, and no typed program is lost.
"""

from __future__ import annotations

import contextlib
import os
import signal
from pathlib import Path

from donnie_tui.bootstrap import Donnie, SwitchMode, Unusable, assemble
from donnie_tui.core.filing import Copies
from donnie_tui.core.typed_program import ProgramTooLong
from donnie_tui.core.use_cases import When
from donnie_tui.folders import state_folder
from donnie_tui.i18n.first_words import PROMPT
from donnie_tui.linear import choices, commands, files, greeting
from donnie_tui.linear.console import Console
from donnie_tui.linear.desk import Desk, Ends
from donnie_tui.linear.output import Output
from donnie_tui.linear.reader import EditingReader, How, PlainReader, Reader, Typed
from donnie_tui.linear.recall import Past
from donnie_tui.linear.runs import Hold, Runs
from donnie_tui.linear.terminal import Terminal
from donnie_tui.linear.told import Told
from donnie_tui.settings import Settings
from language import keywords

INTERRUPTED = 130


def run_linear(settings: Settings, file: Path | None, cause: str, *, text: str | None = None) -> int:
    """Talk until the learner leaves; the exit code. ``cause``: see ``i18n.first_words``.

    ``text`` is the program that the other mode left, where it did; ``file`` is then only its name.
    Raises ``SwitchMode`` for the full screen, and ``Unusable`` for a world that can't be used.
    """
    greeting.greet(settings.language, cause, os.environ, prompt=file is None and not text)
    terminal = greeting.DONE.terminal
    console = Console(terminal if isinstance(terminal, Terminal) else None)
    with contextlib.ExitStack() as closing:
        closing.callback(greeting.forget)
        closing.callback(console.close)
        donnie = closing.enter_context(contextlib.closing(_assembled(settings)))
        return LinearMode(donnie, console, Path(state_folder(os.environ))).talk(file, text)


def _assembled(settings: Settings) -> Donnie:
    try:
        return assemble(settings, terminal=True)
    except Unusable:
        greeting.withdraw()
        raise


class LinearMode:
    """One conversation, from the first prompt to the goodbye."""

    def __init__(self, donnie: Donnie, console: Console, folder: Path) -> None:
        """``folder`` keeps what was typed before and what could not be saved."""
        told = Told(console.nudge)
        edits, attended = greeting.DONE.terminal is not None, os.isatty(0)
        self._past = Past(folder / "history" if edits else None)
        reader: Reader = EditingReader(console, self._past) if edits else PlainReader(console)
        output = Output(console, paced=os.isatty(1))
        self._desk = Desk(donnie, Ends(console, reader, output, told, attended), Copies(folder / "unsaved"))
        self._runs = Runs(self._desk, told, self._wish_of)
        self._console = console
        self._quit_was_refused = False

    # --- the conversation

    def talk(self, file: Path | None, text: str | None = None) -> int:
        """Read and answer until something ends it. The exit code."""
        try:
            return self._talk(file, text)
        except SwitchMode:
            raise
        except OSError:  # the terminal is gone, or nobody reads any more
            self._desk.keep_for_later()
            return 128 + (self._console.leaving or signal.SIGHUP)
        except BaseException:
            self._desk.keep_for_later()
            raise
        finally:
            self._past.trim()

    def _talk(self, file: Path | None, text: str | None) -> int:
        desk = self._desk
        is_shown = greeting.DONE.has_prompt
        greeting.DONE.has_prompt = False
        if text is not None:
            self._take_over(text, file)
        elif file is not None:
            files.open_file(desk, file)
        self._tell_notices()
        while desk.leaving is None:
            self._take(desk.read(self._prompt(), shown=is_shown))
            is_shown = False
        self._say_goodbye()
        return desk.leaving

    def _take_over(self, text: str, file: Path | None) -> None:
        """The program that the full screen left; it is saved if its file says the same."""
        program = self._desk.program
        program.replace(text, str(file) if file else None)
        program.saved = files.holds(file, text) if file else not text.strip()
        if program.lines:
            self._desk.answer("linear-lines", lines=len(program.lines))

    def _tell_notices(self) -> None:
        """What had to be done without. Where the prompt stands already, they come with the first answer."""
        desk = self._desk
        desk.tell(*desk.donnie.notices)
        if desk.is_attended and desk.copies.offered():
            desk.answer("answer-rescued")

    def _prompt(self) -> str:
        in_program = self._desk.is_attended and not self._desk.next_line
        depth = self._desk.program.depth if in_program else 0
        return f"{depth}{PROMPT}" if depth else PROMPT

    # --- one line

    def _take(self, typed: Typed) -> None:
        if self._desk.leaving is None and self._console.leaving is not None:
            self._leave_by_signal(self._console.leaving)
            return
        match typed.how:
            case How.CLOSED:
                self._close()
            case How.INTERRUPTED:
                self._clear(typed.text)
            case How.ENTER:
                self._past.remember(typed.text)
                self._take_line(typed.text)
            case How.ESCAPE:
                self._past.remember(typed.text)
                self._take_line_and_run(typed.text)

    def _take_line_and_run(self, line: str) -> None:
        """ESC: what stands there is finished, and everything runs."""
        if line.strip() and self._take_line(line):
            self._runs.run_waiting()
        elif not line.strip():
            self._run()

    def _take_line(self, line: str) -> bool:
        """Do a word, or add the line to the program. Whether it was added and nothing more."""
        then, self._desk.next_line = self._desk.next_line, None
        words = line.split()
        first = keywords.canonical(words[0]) if words else None
        if then:
            then(line)
        elif not words:
            self._run_unless_open()
        elif first == "RUN" and len(words) == 1:
            self._run()
        elif first in ("QUIT", "EXIT") and len(words) == 1:
            self._quit(line)
        elif first == "HELP":
            choices.say_help(self._desk, " ".join(words[1:]), commands.listed())
        elif found := commands.find(line):
            commands.do(*found, self._desk, self._runs)
        else:
            return self._add(line)
        return False

    def _add(self, line: str) -> bool:
        self._quit_was_refused = False
        try:
            self._desk.program.add(line)
        except ProgramTooLong:
            self._desk.answer("linear-too-long")
            return False
        return True

    # --- running

    def _run(self) -> None:
        self._runs.run_waiting()

    def _run_unless_open(self) -> None:
        """An empty line runs what waits, but not half a block."""
        program = self._desk.program
        block = program.open_block
        if block:
            self._desk.answer("linear-still-open", opener=self._spelled(block.kind), line=block.line)
        elif program.is_waiting:
            self._run()

    def _wish_of(self, typed: Typed) -> Hold | None:
        """What a line means to a program that is held between two steps."""
        line = typed.text.strip()
        found = commands.find(line)
        canonical = keywords.canonical(line)
        if typed.how in (How.INTERRUPTED, How.CLOSED) or canonical in ("QUIT", "EXIT"):
            return Hold.STOP
        if typed.how is How.ESCAPE or canonical == "RUN":
            return Hold.REST
        if not line or (found and found[0].name in ("step", "stop")):
            return Hold.STOP if found and found[0].name == "stop" else Hold.NEXT
        if found and found[0].when is not When.IDLE:
            commands.do(*found, self._desk, self._runs)
        else:
            self._desk.answer("linear-stepping")
        return None

    # --- leaving

    def _quit(self, line: str) -> None:
        """QUIT runs what waits, then leaves; where that can't be run, a second one leaves all the same."""
        desk, block = self._desk, self._desk.program.open_block
        if self._quit_was_refused:
            self._leave(0)
        elif block is None:
            self._run_and_quit(line)
        elif self._add(line):
            desk.answer("linear-quit-in-block", opener=self._spelled(block.kind))

    def _run_and_quit(self, line: str) -> None:
        desk = self._desk
        self._runs.run_waiting(last=line)
        if desk.leaving is not None:
            self._leave(desk.leaving)
        self._quit_was_refused = desk.program.is_waiting

    def _spelled(self, canonical: str) -> str:
        return keywords.spelling(canonical, self._desk.say.language)

    def _close(self) -> None:
        """Ctrl+D, or the end of the input."""
        desk = self._desk
        waiting = desk.program.waiting if desk.program.is_waiting else 0
        if waiting and not desk.is_attended:
            desk.answer("linear-did-not-run", lines=waiting)
        self._leave(0)

    def _leave(self, code: int) -> None:
        """Leave, once a program that would be missed is saved or given up."""
        desk, program = self._desk, self._desk.program
        desk.leaving = code
        would_be_missed = desk.is_attended and program.is_worth_saving
        if would_be_missed and desk.ask_yes("linear-ask-save", lines=len(program.lines)):
            files.save_named(desk, "")

    def _leave_by_signal(self, number: int) -> None:
        self._desk.session.stop()
        self._desk.keep_for_later()
        self._desk.leaving = 128 + number

    def _clear(self, line: str) -> None:
        """Ctrl+C where nothing runs: it clears the line. A script is ended by it."""
        desk = self._desk
        desk.next_line = None
        if not desk.is_attended:
            desk.leaving = INTERRUPTED
        elif line:
            desk.answer("linear-cleared")
        else:
            desk.answer("linear-nothing-to-stop")

    def _say_goodbye(self) -> None:
        if self._desk.leaving == 0:
            self._desk.answer("linear-goodbye")
        self._desk.show_told()
        if self._desk.leaving == 0:
            self._desk.copies.forget()
