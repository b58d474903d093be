"""Prints the lines that wait, prompts, and reads a line: at the prompt, or in answer to a question."""

from __future__ import annotations

from collections.abc import Callable

from msgspec import Struct

from donnie_tui.commands.context import Context
from donnie_tui.commands.interaction import answered
from donnie_tui.commands.lookup import find
from donnie_tui.core.session_log import AnswerLog
from donnie_tui.core.wording import meant
from donnie_tui.i18n.words import Words
from donnie_tui.linear.console import Console
from donnie_tui.linear.greeting import PROMPT
from donnie_tui.linear.output import LARGEST_BLOCK, BackgroundRobots, Listener, OutputQueue, PacedOutput
from donnie_tui.linear.reader import EditingReader, How, Reader, Typed
from donnie_tui.settings.settings import Settings
from language import keywords
from language.source import quoted

GRACE = 0.025
"""Seconds that a line waits for the ones after it, so that an answer and the prompt go out together."""
ON = "on"
OWN_EDITOR = "own"
"""The value of ``editor`` with which Donnie edits lines; else the terminal does, and only text is written."""
SOON = 1.0
"""Seconds between two copies while lines come without a pause."""


def prompt_text(settings: Settings, depth: int) -> str:
    """The prompt of a line inside that many blocks."""
    level = str(depth) if depth else ""
    if settings.prompt == "none":
        return ""
    return f"{f'Donnie {level}'.strip() if settings.prompt == 'word' else level}{PROMPT}"


class Streams(Struct, frozen=True):
    """Where lines come from and where they are printed, as the settings say."""

    console: Console
    editing: EditingReader | None
    """Edits lines key by key; None if that is impossible."""
    plain: Reader
    output: PacedOutput
    queue: OutputQueue
    settings: Callable[[], Settings]
    """As they are now: pages, prompts, editing, progress reports."""
    is_attended: bool
    """Whether a learner types: prompts are printed, and questions are asked."""
    is_terminal: bool
    """Whether the lines are printed on a terminal, and need rests."""

    @property
    def can_edit(self) -> bool:
        """Whether a text can be offered for editing."""
        return self.reader.holds_newline

    @property
    def takes_live_commands(self) -> bool:
        """Whether lines may be typed for a running program: by a learner who edits them here."""
        return self.is_attended and self.can_edit

    @property
    def reader(self) -> Reader:
        """Where the next line comes from."""
        if self.editing is not None and self.settings().editor == OWN_EDITOR:
            return self.editing
        return self.plain

    @property
    def page_size(self) -> int:
        """Lines of a page, after which the learner is asked for more; 0 without pages."""
        if self.settings().hold == ON:
            return 1
        return self.output.block_size if self.settings().page == "ask" else 0

    def apply_settings(self) -> None:
        """Let the terminal and the output behave as the settings say."""
        if self.editing is not None:
            self.console.edit(self.settings().editor == OWN_EDITOR)
        self.output.paced = self.is_terminal and self.settings().page == "rest"

    def end_line(self, typed: Typed) -> None:
        """Hold the newline of Enter back until there is an answer, if the terminal has not printed it."""
        if self.is_attended and (self.can_edit or typed.how is not How.ENTER):
            self.output.hold_newline()


class Printer:
    """Prints the lines that wait and remembers them: all, a block, or page by page; then the prompt."""

    def __init__(self, streams: Streams, words: Words, answers: AnswerLog) -> None:
        """``answers`` remembers what is printed."""
        self._streams, self._words, self._answers = streams, words, answers
        self.is_hurrying = False
        """Whether a program was just stopped: its last lines need no Enter."""
        self.is_repeating = False
        """Whether the next lines were printed before, and are not remembered again."""
        self.prompt: str | None = None
        """The last line of an answer, if it was printed in place of the prompt."""
        self._typed_early: Typed | None = None
        """A line that was typed where an answer waited for Enter."""

    def take_early(self) -> Typed | None:
        """The line that was typed where an answer waited for Enter, if there is one."""
        early, self._typed_early = self._typed_early, None
        return early

    def show(self, prompt: str = "", *, most: int | None = None) -> int:
        """Print the lines that wait (``most`` of them), then the prompt.

        Returns how many lines were left out because of Ctrl+C.
        """
        lines, kept = self._streams.queue.take(most), self._streams.queue.take_kept()
        if not self.is_repeating:
            self._answers.add_lines(kept)
        if prompt:
            self._answers.end_answer()
        self.is_repeating = False
        if not self._streams.is_attended:
            return self._streams.output.show(lines)
        return self._show_pages(lines, prompt)

    def show_block(self) -> int:
        """As ``show``, but only a block, so that keys are noticed in between; with pages, all of it."""
        return self.show(most=None if self._page_size() else LARGEST_BLOCK)

    def _show_pages(self, lines: list[str], prompt: str) -> int:
        """As ``show``; if the learner wants pages, page by page."""
        size = self._page_size()
        while size and len(lines) > size:
            wants_more, lines = self._show_page(lines[:size], len(lines) - size), lines[size:]
            if self._streams.console.interrupted:
                return len(lines)
            if not wants_more:
                lines = []
            if self._typed_early is not None:
                return 0
        is_answer = self._streams.settings().prompt == "answer"
        if is_answer and prompt.endswith(PROMPT) and lines:
            prompt = self.prompt = f"{lines.pop()} "
        return self._streams.output.show(lines, prompt, to_the_end=self.is_hurrying)

    def _page_size(self) -> int:
        return 0 if self.is_hurrying else self._streams.page_size

    def _show_page(self, lines: list[str], left: int) -> bool:
        """Print a page and wait for Enter or Q. Returns whether more is wanted.

        Where each line waits for Enter, any line typed here ends that.
        """
        streams = self._streams
        holds = streams.settings().hold == ON
        question = f"{lines.pop() if holds else self._words('more-lines', lines=left)} "
        while True:
            streams.output.show(lines, question)
            typed = streams.reader.read(question)
            streams.end_line(typed)
            streams.console.interrupted |= typed.how is How.INTERRUPTED
            text = typed.text.strip()
            if typed.how not in (How.ENTER, How.ESCAPE):
                return False
            if not text:
                return True
            if answered(text) is False or meant(text, "pages") == "enough":
                return False
            if holds:
                self._typed_early = typed
                return False
            lines = [self._words("more-not-understood", word=quoted(text))]


class Prompter:
    """Reads a line, at the prompt or in answer to a question, after printing the lines that wait."""

    def __init__(
        self,
        ctx: Context,
        streams: Streams,
        printer: Printer,
        listener: Listener,
        background: BackgroundRobots,
    ) -> None:
        self._ctx, self._streams, self._console = ctx, streams, streams.console
        self._printer, self._listener, self._background = printer, listener, background
        self.copying = CopySchedule(streams.console, ctx.workspace.keep_copies)
        self._put_back: Typed | None = None
        self.offered = ""
        """The text that is offered for editing with the next prompt."""
        self.has_ended = False
        """Whether the input ended in place of the last answer."""

    def read(self, prompt: str, *, shown: bool = False) -> Typed:
        """Print the lines that wait and the prompt, unless it is ``shown`` already, and read a line."""
        if self._put_back is not None:
            typed, self._put_back = self._put_back, None
            return typed
        while True:
            if self._ctx.attempt is not None:
                self._ctx.runs.say_verdict()
            typed = self._read(prompt, shown=shown)
            if typed.how not in (How.CHOICES, How.NEWS):
                return typed
            if typed.how is How.CHOICES:
                self._ctx.answer("completions-found", count=len(typed.choices))
                self._ctx.say(*typed.choices)
                self._printer.is_repeating = True
            else:
                self._console.rest(GRACE)
            self.offered = typed.text
            shown = False

    def read_next(self) -> Typed:
        """The next line, which is no part of the program."""
        return self.read(prompt_text(self._streams.settings(), 0))

    def put_back(self, typed: Typed) -> None:
        """Return this line from the next ``read``."""
        self._put_back = typed

    def ask(self, question: str) -> str | None:
        """What is typed next; empty for an empty line, None if the learner gave up or left."""
        self._ctx.say(question)
        typed = self.read(PROMPT)
        text = typed.text.strip()
        self.has_ended = typed.how is How.CLOSED
        is_answered = typed.how is How.ENTER or (typed.how is How.ESCAPE and text)
        return text if is_answered else None

    def confirm(self, question: str) -> bool | None:
        """Yes or no; None for no answer: Ctrl+C, Escape alone, the end of the input, a signal to leave.

        A command is no answer either: it is carried out instead.
        """
        answer = self.ask(question)
        while answer and answered(answer) is None:
            if find(answer) or keywords.canonical(answer.split()[0]):
                self.put_back(Typed(answer, How.ENTER))
                return None
            answer = self.ask(self._ctx.words("yes-or-no"))
        return bool(answered(answer)) if answer is not None else None

    def _read(self, prompt: str, *, shown: bool) -> Typed:
        """Meanwhile a background robot that prints too much waits, as one does whose run is followed."""
        queue = self._streams.queue
        held_back = queue.holds_back
        queue.hold_back()
        try:
            return self._show_and_read(prompt, shown=shown)
        finally:
            if not held_back:
                queue.let_pass()

    def _show_and_read(self, prompt: str, *, shown: bool) -> Typed:
        offered, self.offered = self.offered if self._streams.can_edit else "", ""
        self._printer.prompt = None
        self._ctx.donnie.session.hub.wait_until_delivered()
        self._listener.line_begins()
        if not shown:
            self._console.has_news = False
            self._show_all(prompt, offered)
        self._printer.is_hurrying = False
        early = self._printer.take_early()
        if early is not None:
            self._listener.line_ended()
            return early
        if self._streams.is_attended:
            self.copying.at_prompt()
        printed = self._printer.prompt
        typed = self._streams.reader.read(prompt if printed is None else printed, offered)
        self._listener.line_ended()
        self._streams.end_line(typed)
        return typed

    def _show_all(self, prompt: str, offered: str) -> None:
        """Print the lines that wait and the prompt; after Ctrl+C, how much was left out and the prompt.

        After the stop of a program few lines are left, which say where and why: a second Ctrl+C ends only
        the rests between them.
        """
        if self._show_flood():
            self._streams.output.show([], prompt + offered)
            return
        left_out = self._printer.show(prompt + offered)
        if self._printer.is_hurrying:
            self._console.take_interrupt()
        if left_out:
            self._console.take_interrupt()
            if self._ctx.donnie.team.running:
                self._background.stop(left_out)
            else:
                self._ctx.answer("answer-left-out", lines=left_out)
            self._printer.show(prompt + offered)

    def _show_flood(self) -> bool:
        """Print the lines of background robots by blocks, as long as they come faster than they are printed.

        Returns whether a key was pressed: the rest waits for the line that is being typed.
        """
        streams, console = self._streams, self._console
        if self._ctx.donnie.team.running:
            self._ctx.donnie.session.hub.wait_until_delivered()
        is_possible = streams.is_attended and not streams.page_size
        while is_possible and self._background.floods and console.leaving is None:
            left_out = self._printer.show_block()
            if console.pressed_interrupt():
                self._background.stop(left_out)
                return False
            is_typing = streams.reader.has_typed or console.has_input()
            if is_typing and not streams.queue.has_first:
                return True
        return False


class CopySchedule:
    """When the copies of unsaved programs are written: at each prompt, while the learner thinks.

    While lines come without a pause, the copies wait until no more are typed or a program runs, but no longer
    than ``SOON``: each line would have the whole program written again.
    """

    def __init__(self, console: Console, keep_copies: Callable[[], bool]) -> None:
        """``keep_copies`` returns whether there was anything to write."""
        self._console, self._keep_copies = console, keep_copies
        self._due = console.now()

    def at_prompt(self) -> None:
        if self._console.has_input() and self._console.now() < self._due:
            self._console.when_idle = self._keep
        else:
            self._keep()

    def cancel(self) -> None:
        """Write nothing when the learner pauses."""
        self._console.when_idle = None

    def _keep(self) -> None:
        self.cancel()
        if self._keep_copies():
            self._due = self._console.now() + SOON
