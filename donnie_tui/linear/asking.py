"""Reads a line: at the prompt, or in answer to a question. What was told is printed before."""

from __future__ import annotations

from collections.abc import Callable

from donnie_tui.i18n.words import Words
from donnie_tui.linear.beside import Beside
from donnie_tui.linear.ends import Ends
from donnie_tui.linear.greeting import PROMPT
from donnie_tui.linear.hearing import Hearing
from donnie_tui.linear.reader import How, Typed
from donnie_tui.linear.showing import Showing

GRACE = 0.025
"""Seconds that a line waits for the ones after it, so that an answer and the prompt go out together."""


class Asking:
    """Asks whoever types."""

    def __init__(
        self,
        ends: Ends,
        heard: Hearing,
        showing: Showing,
        beside: Beside,
        words: Words,
        answer: Callable[..., None],
        tell: Callable[..., None],
        before_typing: Callable[[], None],
    ) -> None:
        """``answer`` tells a sentence by its code, ``tell`` lines; ``before_typing`` is done at prompts."""
        self._ends = ends
        self._words = words
        self._console = ends.console
        self._heard = heard
        self._showing = showing
        self._beside = beside
        self._answer, self._tell = answer, tell
        self._before_typing = before_typing
        self._typed_before: Typed | None = None
        self.offered = ""
        """The text that is offered for editing with the next prompt."""
        self.has_ended = False
        """Whether in place of the last answer the input ended."""

    def read(self, prompt: str, *, shown: bool = False) -> Typed:
        """Print what was told and the prompt, unless it is ``shown`` already, and read a line."""
        if self._typed_before is not None:
            typed, self._typed_before = self._typed_before, None
            return typed
        while True:
            typed = self._read(prompt, shown=shown)
            if typed.how not in (How.CHOICES, How.NEWS):
                return typed
            if typed.how is How.CHOICES:
                self._tell_choices(typed)
            else:
                self._console.rest(GRACE)
            self.offered = typed.text
            shown = False

    def put_back(self, typed: Typed) -> None:
        """What was read was meant for the next one who reads."""
        self._typed_before = typed

    def ask(self, code: str, **values: object) -> str:
        """The answer to a question; empty if there is none."""
        return self.answer_to(self._words(code, **values)) or ""

    def ask_yes(self, code: str, **values: object) -> bool:
        """Whether the answer is yes."""
        return self.decide(self._words(code, **values)) is True

    def decide(self, question: str) -> bool | None:
        """Yes or no; None for no answer: Ctrl+C, Escape alone, the end of the input, a signal to leave."""
        from donnie_tui.commands.arguments import answered

        answer = self.answer_to(question)
        while answer and answered(answer) is None:
            answer = self.answer_to(self._words("ask-yes-no"))
        return bool(answered(answer)) if answer is not None else None

    def answer_to(self, question: str) -> str | None:
        """What is typed next; empty for an empty line, None where the learner gave up or left."""
        self._tell(question)
        typed = self.read(PROMPT)
        text = typed.text.strip()
        self.has_ended = typed.how is How.CLOSED
        is_answered = typed.how is How.ENTER or (typed.how is How.ESCAPE and text)
        return text if is_answered else None

    def _read(self, prompt: str, *, shown: bool) -> Typed:
        """Meanwhile a robot that runs beside tells no more than is read, as one does that is watched."""
        told = self._ends.told
        is_watched = told.holds_back
        told.hold_back()
        try:
            return self._show_and_read(prompt, shown=shown)
        finally:
            if not is_watched:
                told.let_pass()

    def _show_and_read(self, prompt: str, *, shown: bool) -> Typed:
        offered, self.offered = self.offered if self._ends.can_edit else "", ""
        self._showing.prompt = None
        self._heard.hear_out()
        self._heard.line_begins()
        if not shown:
            self._console.has_news = False
            self._show_whole(prompt, offered)
        self._showing.is_hurrying = False
        early = self._showing.take_early()
        if early is not None:
            self._heard.line_ended()
            return early
        self._before_typing()
        shown_prompt = self._showing.prompt
        typed = self._ends.reader.read(prompt if shown_prompt is None else shown_prompt, offered)
        self._heard.line_ended()
        self._ends.end_line(typed)
        return typed

    def _show_whole(self, prompt: str, offered: str) -> None:
        """Print what was told and the prompt; after Ctrl+C, how much was left out and the prompt.

        Where a program was just stopped little is left, and it is where and why: a second Ctrl+C ends no
        more than its rests.
        """
        if self._show_flood():
            self._ends.output.show([], prompt + offered)
            return
        left_out = self._showing.show_told(prompt + offered)
        if self._showing.is_hurrying:
            self._console.take_interrupt()
        if left_out:
            self._console.take_interrupt()
            if self._beside.is_any:
                self._beside.stop(left_out)
            else:
                self._answer("answer-left-out", lines=left_out)
            self._showing.show_told(prompt + offered)

    def _show_flood(self) -> bool:
        """Print by blocks what robots tell beside. Whether a key was pressed: the rest waits for its line."""
        ends, console = self._ends, self._console
        if self._beside.is_any:
            self._heard.hear_out()
        while ends.prompts and not ends.page_size and self._beside.floods and console.leaving is None:
            left_out = self._showing.show_block()
            if console.pressed_interrupt():
                self._beside.stop(left_out)
                return False
            is_typing = ends.reader.has_typed or console.has_input()
            if is_typing and self._beside.waits_behind_answers:
                return True
        return False

    def _tell_choices(self, typed: Typed) -> None:
        """Tab found several words: how many, and each on a line; the typed line is offered again."""
        self._answer("linear-choices", count=len(typed.choices))
        self._tell(*typed.choices)
        self._showing.is_repeating = True
