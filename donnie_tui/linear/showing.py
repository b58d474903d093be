"""Prints what was told and remembers it: all of it, a block, or page by page for who wants to be asked."""

from __future__ import annotations

from donnie_tui.commands.arguments import answered
from donnie_tui.core.answer_log import AnswerLog
from donnie_tui.core.wording import meant
from donnie_tui.i18n.words import Words
from donnie_tui.linear.ends import Ends
from donnie_tui.linear.greeting import PROMPT
from donnie_tui.linear.options import Prompt
from donnie_tui.linear.output import LARGEST_BLOCK
from donnie_tui.linear.reader import How, Typed

"""What ends an answer that is told page by page."""


class Showing:
    """Shows what waits to be printed, and the prompt after it."""

    def __init__(self, ends: Ends, say: Words, answers: AnswerLog) -> None:
        """``answers`` remembers what is shown."""
        self._ends = ends
        self._say = say
        self._answers = answers
        self.is_hurrying = False
        """Whether a program was just stopped: what is told then asks for nothing."""
        self.is_repeating = False
        """Whether what is told now was said before, and is not remembered again."""
        self.prompt: str | None = None
        """The last line of an answer, where that was shown in the place of the prompt."""
        self._typed_early: Typed | None = None
        """A line that was typed where an answer waited for Enter."""

    def take_early(self) -> Typed | None:
        """The line that was typed where an answer waited for Enter, if there is one."""
        early, self._typed_early = self._typed_early, None
        return early

    def print_now(self, code: str) -> None:
        """A sentence in print alone, while a program may tell more than is printed."""
        self._ends.told.put_first([self._say(code)], is_kept=False)

    def show_told(self, prompt: str = "", *, most: int | None = None) -> int:
        """Print what was told (``most`` lines of it), then the prompt.

        How many lines were left out because of Ctrl+C.
        """
        lines, kept = self._ends.told.take(most), self._ends.told.take_kept()
        if not self.is_repeating:
            self._answers.add_lines(kept)
        if prompt:
            self._answers.end_answer()
        self.is_repeating = False
        if not self._ends.prompts:
            return self._ends.output.show(lines)
        return self._show_pages(lines, prompt)

    def show_block(self) -> int:
        """As ``show_told``, but a block of it, so that keys are looked for in between.

        All of it where somebody is asked page by page.
        """
        return self.show_told(most=None if self._page_size() else LARGEST_BLOCK)

    def _show_pages(self, lines: list[str], prompt: str) -> int:
        """As ``show_told``; where somebody wants to be asked, page by page."""
        size = self._page_size()
        while size and len(lines) > size:
            wants_more, lines = self._show_page(lines[:size], len(lines) - size), lines[size:]
            if self._ends.console.interrupted:
                return len(lines)
            if not wants_more:
                lines = []
            if self._typed_early is not None:
                return 0
        if self._ends.options.prompt is Prompt.ANSWER and prompt.endswith(PROMPT) and lines:
            prompt = self.prompt = f"{lines.pop()} "
        return self._ends.output.show(lines, prompt, to_the_end=self.is_hurrying)

    def _page_size(self) -> int:
        return 0 if self.is_hurrying else self._ends.page_size

    def _show_page(self, lines: list[str], left: int) -> bool:
        """Show a page and wait for Enter. Whether more is wanted; whoever types a line wants that instead."""
        ends = self._ends
        question = f"{lines.pop()} " if ends.options.hold else f"{self._say('linear-more', lines=left)} "
        ends.output.show(lines, question)
        typed = ends.reader.read(question)
        ends.end_line(typed)
        ends.console.interrupted |= typed.how is How.INTERRUPTED
        if typed.text.strip() and not _is_enough(typed.text):
            self._typed_early = typed
        return typed.how in (How.ENTER, How.ESCAPE) and not typed.text.strip()


def _is_enough(typed: str) -> bool:
    return answered(typed) is False or meant(typed, "pages") == "enough"
