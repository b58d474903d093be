"""What the words of the linear mode work with: the session, the typed program, and how to answer and to ask.

Rule: an answer goes through the hub like everything else that is told, so that it is also spoken.
"""

from __future__ import annotations

import contextlib
from collections import deque
from collections.abc import Callable
from dataclasses import dataclass

from donnie_tui.bootstrap import Donnie
from donnie_tui.core.documents import DocumentError
from donnie_tui.core.events import Answered, Error, RunStarted, Stamped
from donnie_tui.core.filing import Copies
from donnie_tui.core.transcript import lines_of
from donnie_tui.core.typed_program import TypedProgram
from donnie_tui.linear.console import Console
from donnie_tui.linear.output import Output
from donnie_tui.linear.reader import How, Reader, Typed
from donnie_tui.linear.told import Told

REMEMBERED = 1000
"""Answers that LAST can reach."""
LONGEST_ANSWER = 200
"""Lines of one answer that are remembered, its last ones."""

_YES = ("y", "yes", "s", "sim", "si", "sí")
_NO = ("", "n", "no", "não", "nao")


@dataclass(frozen=True, slots=True)
class Ends:
    """Both ends of the conversation."""

    console: Console
    reader: Reader
    output: Output
    told: Told
    prompts: bool
    """Whether somebody types: prompts are printed, and questions asked."""


class Desk:
    """One conversation."""

    def __init__(self, donnie: Donnie, ends: Ends, copies: Copies) -> None:
        """``copies`` keep a program which can't be kept otherwise."""
        self.session = donnie.session
        self.say = donnie.words
        self.donnie = donnie
        self.console = ends.console
        self.program = TypedProgram()
        self.copies = copies
        self.errors: list[Error] = []
        """Those of the last run."""
        self.answers: deque[tuple[str, ...]] = deque(maxlen=REMEMBERED)
        self.is_repeating = False
        """Whether what is told now was said before, and is not remembered again."""
        self.leaving: int | None = None
        """The exit code, once we are to leave."""
        self.next_line: Callable[[str], None] | None = None
        """Who takes the next line in place of the program."""
        self.offered = ""
        """The text that is offered for editing."""
        self._ends = ends
        self.session.hub.subscribe(self._hear)

    @property
    def can_edit(self) -> bool:
        """Whether a text can be offered for editing."""
        return self._ends.reader.holds_newline

    @property
    def is_attended(self) -> bool:
        """Whether there is somebody to be asked."""
        return self._ends.prompts

    # --- answering

    def answer(self, code: str, **values: object) -> None:
        self.tell(self.say(code, **values))

    def tell(self, *lines: str) -> None:
        for line in lines:
            self.session.hub.publish(Answered(line))

    def _hear(self, stamped: Stamped) -> None:
        """Any thread's: what the event says will be printed."""
        event = stamped.event
        if isinstance(event, RunStarted):
            self.errors = []
        elif isinstance(event, Error):
            self.errors = [*self.errors[-LONGEST_ANSWER:], event]
        self._ends.told.put(lines_of(event, self.say))

    def show_told(self, prompt: str = "") -> int:
        """Print what was told, then the prompt. How many lines were left out because of Ctrl+C."""
        lines = self._ends.told.take()
        if lines and not self.is_repeating:
            self.answers.append(tuple(lines[-LONGEST_ANSWER:]))
        self.is_repeating = False
        return self._ends.output.show(lines, prompt if self._ends.prompts else "")

    # --- asking

    def read(self, prompt: str, *, shown: bool = False) -> Typed:
        """Print what was told and the prompt, unless it is ``shown`` already, and read a line."""
        offered, self.offered = self.offered if self.can_edit else "", ""
        if not shown:
            self._show_whole(prompt + offered)
        typed = self._ends.reader.read(prompt, offered)
        if self.can_edit or typed.how is not How.ENTER:
            self.hold_newline()
        return typed

    def _show_whole(self, prompt: str) -> None:
        """Print what was told and the prompt; after Ctrl+C, how much was left out and the prompt."""
        left_out = self.show_told(prompt)
        if left_out:
            self.console.take_interrupt()
            self.answer("answer-left-out", lines=left_out)
            self.show_told(prompt)

    def hold_newline(self) -> None:
        if self._ends.prompts:
            self._ends.output.hold_newline()

    def ask(self, code: str, **values: object) -> str:
        """The answer to a question; empty if there is none."""
        self.answer(code, **values)
        typed = self.read("> ")
        return typed.text.strip() if typed.how in (How.ENTER, How.ESCAPE) else ""

    def ask_yes(self, code: str, **values: object) -> bool:
        """Whether the answer is yes."""
        answer = self.ask(code, **values).casefold()
        while answer not in _YES + _NO:
            answer = self.ask("linear-yes-or-no").casefold()
        return answer in _YES

    def may_lose_program(self) -> bool:
        """Whether the typed program may be replaced; asks where somebody would miss it."""
        if not (self.is_attended and self.program.is_worth_saving):
            return True
        return self.ask_yes("linear-ask-lose", lines=len(self.program.lines))

    # --- leaving

    def keep_for_later(self) -> None:
        """Save what is not saved beside everything else; quietly, since nobody may be there to hear."""
        if not self.program.saved and self.program.lines:
            with contextlib.suppress(DocumentError, OSError):
                self.copies.keep(self.program.text)
