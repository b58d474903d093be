"""How the linear mode speaks with the learner: it prints what waits, asks, and reads lines."""

from __future__ import annotations

from collections.abc import Callable, Coroutine, Sequence
from typing import TYPE_CHECKING, Any, Protocol, TypeVar

from donnie_tui.commands.arguments import answered
from donnie_tui.commands.context import Context
from donnie_tui.commands.interaction import SLOW, SLOW_AGAIN, Option, drive
from donnie_tui.linear.console import run_in_background
from donnie_tui.linear.greeting import PROMPT
from donnie_tui.linear.listener import BackgroundRobots, Listener
from donnie_tui.linear.output import Printer, Streams
from donnie_tui.linear.reader import How, Typed

if TYPE_CHECKING:
    from donnie_tui.core.runner import Run
    from donnie_tui.linear.app import Conversation

T = TypeVar("T")

GRACE = 0.025
"""Seconds that a line waits for the ones after it, so that an answer and the prompt go out together."""
SOON = 1.0
"""Seconds between two copies while lines come without a pause."""
_LONGEST_NUMBER = 8


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
            typed = self._read(prompt, shown=shown)
            if typed.how not in (How.CHOICES, How.NEWS):
                return typed
            if typed.how is How.CHOICES:
                self._ctx.answer("linear-choices", count=len(typed.choices))
                self._ctx.say(*typed.choices)
                self._printer.is_repeating = True
            else:
                self._console.rest(GRACE)
            self.offered = typed.text
            shown = False

    def read_next(self) -> Typed:
        """The next line, which is no part of the program."""
        return self.read(self._streams.options.prompt_at(0))

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
        """Yes or no; None for no answer: Ctrl+C, Escape alone, the end of the input, a signal to leave."""
        answer = self.ask(question)
        while answer and answered(answer) is None:
            answer = self.ask(self._ctx.words("linear-yes-or-no"))
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
        self._ctx.donnie.session.hub.wait_until_heard()
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
            self._ctx.donnie.session.hub.wait_until_heard()
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


class Input(Protocol):
    """What ``CopySchedule`` needs of the console."""

    when_idle: Callable[[], None] | None

    def now(self) -> float: ...

    def has_input(self) -> bool: ...


class CopySchedule:
    """When the copies of unsaved programs are written: at each prompt, while the learner thinks.

    While lines come without a pause, the copies wait until no more are typed or a program runs, but no longer
    than ``SOON``: each line would have the whole program written again.
    """

    def __init__(self, console: Input, keep_copies: Callable[[], bool]) -> None:
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


class LinearInteraction:
    """``commands.interaction.Interaction`` at the prompt. Nothing in it ever waits for an event loop."""

    def __init__(self, conversation: Conversation) -> None:
        self._conversation = conversation

    @property
    def can_edit(self) -> bool:
        return self._conversation.streams.can_edit

    @property
    def is_attended(self) -> bool:
        return self._conversation.streams.is_attended

    # --- questions

    async def ask(
        self, question: str, text: str = "", accepts: Callable[[str], str | None] | None = None
    ) -> str | None:
        prompter = self._conversation.prompter
        prompter.offered = text
        answer = prompter.ask(question)
        while answer and accepts is not None and (problem := accepts(answer)) is not None:
            answer = prompter.ask(problem)
        return answer or None

    async def choose(
        self,
        question: str,  # noqa: ARG002 -- the list is read without it
        options: Sequence[Option],
        printed: Sequence[str] = (),
    ) -> str | None:
        """The number of an option, typed next, chooses it; any other line is none of this."""
        ctx, prompter = self._conversation.ctx, self._conversation.prompter
        by_number = {each.number: each.value for each in options if each.number}
        ctx.say(*printed)
        if not by_number:
            return None
        ctx.answer("linear-type-number")
        typed = prompter.read_next()
        text = typed.text.strip()
        if typed.how is not How.ENTER or not text.isdecimal() or len(text) > _LONGEST_NUMBER:
            prompter.put_back(typed)
            return None
        number = int(text)
        if number not in by_number:
            ctx.answer("answer-no-line", line=number, last=max(by_number))
            return None
        ctx.answer("linear-listed", line=number, text=by_number[number])
        return by_number[number]

    async def confirm(self, question: str) -> bool | None:
        return self._conversation.prompter.confirm(question)

    async def edit_line(self, question: str, text: str = "") -> str | None:
        prompter = self._conversation.prompter
        prompter.offered = text
        self._conversation.ctx.say(question)
        typed = prompter.read_next()
        if typed.how is How.ENTER or (typed.how is How.ESCAPE and typed.text.strip()):
            return typed.text
        if typed.how is How.CLOSED or self._conversation.console.leaving is not None:
            prompter.put_back(typed)
        return None

    async def show_pages(
        self,
        title: str,  # noqa: ARG002 -- the lines are read without it
        lines: Sequence[str],
        printed: Sequence[str] | None = None,
    ) -> None:
        self._conversation.ctx.say(*(lines if printed is None else printed))

    # --- time

    async def background(
        self, task: Callable[[], T], slow: str, *, may_be_left: bool = False, is_slow: bool = False
    ) -> T:
        return run_in_background(
            self._conversation.console,
            task,
            lambda: self._conversation.ctx.say(slow),
            first=SLOW_AGAIN if is_slow else SLOW,
            show=self._conversation.printer.show,
            may_be_left=may_be_left,
        )

    async def finish(self, task: Coroutine[Any, Any, T]) -> T:
        return await task

    async def finished(self) -> None:
        """Nothing runs while a question is asked."""

    async def follow(self, runs: Sequence[tuple[str | None, Run]]) -> bool:
        self._conversation.run_loop.follow(runs)
        return True

    async def wait(self, seconds: float) -> bool:
        self._conversation.printer.show()
        return self._conversation.console.is_disturbed_within(seconds, reading=self.is_attended)

    def print_soon(self) -> None:
        self._conversation.console.nudge()

    def continue_on_enter(self, more: Callable[[], Coroutine[Any, Any, None]]) -> None:
        self._conversation.typed_lines.continuation = lambda: drive(more())

    def setting_changed(self, key: str) -> None:  # noqa: ARG002 -- all options are applied
        self._conversation.streams.apply_options()

    def before_robot_changes(self) -> None:
        """Each robot keeps its own document."""

    def robot_changed(self) -> None:
        ctx = self._conversation.ctx
        ctx.workspace.choose_robot(ctx.donnie.session.name)

    async def type_again(self, line: str) -> None:
        self._conversation.take_again(line)

    # --- ways out

    async def enter_world(self, name: str) -> None:
        """Raises ``EnterWorld``; while a program is held, the run loop stops it first."""
        leaving = self._conversation.leaving
        leaving.world = name
        if not self._conversation.background.is_following:
            leaving.enter_world()

    async def switch_mode(self) -> None:
        self._conversation.leaving.switch_to_screen()

    async def quit(self) -> None:
        self._conversation.typed_lines.quit()
