"""What is printed, and when: whole lines, an answer and the prompt in one write, rests between blocks.

A screen reader loses what scrolls by, and it says a prompt twice that comes in a write of its own. So the
newline of Enter is held back until there is an answer, and no more than a screenful is printed at once. Orca
takes a write of nothing but digits for something typed and keeps silent: such a block ends with a sentence.

Fenrir compares the screen before and after with ``difflib``, which looks first for the longest part of both.
That must be what has moved up (``OnScreen``). If an answer is printed again that is still on the screen, it
may be the answer, which is then silent, and the lines above it are said. With fewer lines at once more stays
than is new.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Sequence
from enum import Enum
from typing import Protocol

from msgspec import Struct

from donnie_tui.commands.arguments import answered
from donnie_tui.core.answer_log import AnswerLog
from donnie_tui.core.wording import meant
from donnie_tui.i18n.words import Words
from donnie_tui.linear.console import Console
from donnie_tui.linear.greeting import PROMPT
from donnie_tui.linear.listener import LARGEST_BLOCK, OutputQueue
from donnie_tui.linear.reader import EditingReader, How, Reader, Typed
from donnie_tui.settings.settings import Settings

REST = 0.3
"""Seconds of rest after each block of lines."""
AFTER_STOP = 5
"""Lines that are printed after a stop without a rest: a block leaves room for them and the prompt."""
MANY_NUMBERS = 4
"""Lines of nothing but digits in a block that need a sentence after them."""
FEWEST = 2
"""Lines at once; if not even these are said, the answer is one line over and over."""


class Page(Enum):
    """What is between two screenfuls of an answer."""

    REST = "rest"
    ASK = "ask"
    OFF = "off"


class PromptStyle(Enum):
    """What is printed before the line that is typed."""

    SHORT = "short"
    NONE = "none"
    WORD = "word"
    ANSWER = "answer"
    """The last line of the answer, so that the cursor of a braille display stays on it."""


class Options:
    """The settings of the linear mode, as they are now: pages, prompts, editing, progress reports."""

    def __init__(self, settings: Callable[[], Settings]) -> None:
        self._settings = settings

    @property
    def page(self) -> Page:
        return Page(self._settings().page)

    @property
    def prompt(self) -> PromptStyle:
        return PromptStyle(self._settings().prompt)

    @property
    def hold(self) -> bool:
        """Whether each line of an answer waits for Enter."""
        return self._settings().hold == "on"

    @property
    def editor(self) -> bool:
        """Whether Donnie edits lines; else the terminal does, and nothing but text is ever written."""
        return self._settings().editor == "own"

    @property
    def enter(self) -> bool:
        """Whether Enter runs each complete line at once."""
        return self._settings().enter == "runs"

    @property
    def progress(self) -> int:
        """Seconds between two progress reports of a run; 0 is never."""
        return int(self._settings().progress)

    def prompt_at(self, depth: int) -> str:
        """The prompt of a line inside so many blocks."""
        level = str(depth) if depth else ""
        match self.prompt:
            case PromptStyle.NONE:
                return ""
            case PromptStyle.WORD:
                return f"{f'Donnie {level}'.strip()}{PROMPT}"
            case _:
                return f"{level}{PROMPT}"


class Streams(Struct, frozen=True):
    """Where lines come from and where they are printed, as the options say."""

    console: Console
    editing: EditingReader | None
    """Edits lines key by key; None where that is impossible."""
    plain: Reader
    output: Output
    queue: OutputQueue
    options: Options
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
        return self.editing if self.editing is not None and self.options.editor else self.plain

    @property
    def page_size(self) -> int:
        """Lines of a page, after which the learner is asked for more; 0 without pages."""
        if self.options.hold:
            return 1
        return self.output.block_size if self.options.page is Page.ASK else 0

    def apply_options(self) -> None:
        """Let the terminal and the output behave as the options say."""
        if self.editing is not None:
            self.console.edit(self.options.editor)
        self.output.paced = self.is_terminal and self.options.page is Page.REST

    def end_line(self, typed: Typed) -> None:
        """If the terminal has not printed the newline of Enter, hold it back until there is an answer."""
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
        is_answer = self._streams.options.prompt is PromptStyle.ANSWER
        if is_answer and prompt.endswith(PROMPT) and lines:
            prompt = self.prompt = f"{lines.pop()} "
        return self._streams.output.show(lines, prompt, to_the_end=self.is_hurrying)

    def _page_size(self) -> int:
        return 0 if self.is_hurrying else self._streams.page_size

    def _show_page(self, lines: list[str], left: int) -> bool:
        """Print a page and wait for Enter. Returns whether more is wanted; any line typed here ends it."""
        streams = self._streams
        holds = streams.options.hold
        question = f"{lines.pop() if holds else self._words('linear-more', lines=left)} "
        streams.output.show(lines, question)
        typed = streams.reader.read(question)
        streams.end_line(typed)
        streams.console.interrupted |= typed.how is How.INTERRUPTED
        text = typed.text.strip()
        if text and answered(text) is not False and meant(text, "pages") != "enough":
            self._typed_early = typed
        return typed.how in (How.ENTER, How.ESCAPE) and not text


class Paper(Protocol):
    """What is printed on."""

    interrupted: bool

    def write(self, text: str) -> None: ...

    def wait(self, seconds: float) -> object:
        """Rest; shorter if something happens."""

    def now(self) -> float: ...

    def rows(self) -> int: ...


class Output:
    """Prints blocks of lines. ``paced`` is for learners; a pipe needs no rests."""

    def __init__(self, paper: Paper, *, paced: bool, of_numbers: Callable[[int], str] = "{}".format) -> None:
        """``of_numbers`` returns the sentence that says how many numbers those were."""
        self._paper = paper
        self._of_numbers = of_numbers
        self.paced = paced
        """Whether there are rests; may be changed at any time."""
        self._held = ""
        self._room = 0
        self._rested_at = float("-inf")
        self._on_screen = OnScreen()

    def hold_newline(self) -> None:
        """Write the newline of Enter together with the next output."""
        self._held = "\n"

    def show(self, lines: list[str], prompt: str = "", *, to_the_end: bool = False) -> int:
        """Print the lines, then the prompt.

        Ctrl+C during a rest ends it, without the prompt. Returns how many lines were not printed.
        ``to_the_end``: Ctrl+C ends only the rests, and a few lines need none.
        """
        if to_the_end:
            self._room = max(self._room, AFTER_STOP)
        block, lines = self._next_block(lines, prompt)
        while lines:
            self._write(block, "")
            block, lines = self._next_block(lines, prompt)
            if self._paper.interrupted and not to_the_end:
                return len(block) + len(lines)
        self._write(block, prompt)
        return 0

    def _next_block(self, lines: list[str], prompt: str) -> tuple[list[str], list[str]]:
        """The lines to print now, after a rest if one is due, and the lines after them."""
        if not self.paced:
            return lines, []
        self._make_room(bool(lines))
        size = self._room
        if (prompt == "" or len(lines) > size) and are_silent(lines[:size]):
            size -= 1  # for the sentence
        said = self._on_screen.most_said(lines[:size], self._paper.rows())
        if said < len(lines[:size]):
            size, self._room = said, 0
        block, rest = lines[:size], lines[size:]
        self._room -= len(block)
        return block, rest

    def _make_room(self, wanted: bool) -> None:
        now = self._paper.now()
        if now - self._rested_at >= REST:
            self._room = self.block_size
        elif wanted and self._room <= 0:
            self._rest(self._rested_at + REST)
            self._room = self.block_size

    def _rest(self, until: float) -> None:
        while not self._paper.interrupted and (left := until - self._paper.now()) > 0:
            self._paper.wait(left)

    def _write(self, block: list[str], prompt: str) -> None:
        if self.paced and prompt == "" and are_silent(block):
            block = [*block, self._of_numbers(len(block))]
            self._room -= 1
        text = self._held + "".join(f"{line}\n" for line in block) + prompt
        self._held = ""
        self._on_screen.add(block, prompt, self._paper.rows())
        if text:
            self._paper.write(text)
            self._rested_at = self._paper.now()

    @property
    def block_size(self) -> int:
        """Lines that are printed at once."""
        return max(1, min(self._paper.rows() - 6, LARGEST_BLOCK))


def are_silent(lines: list[str]) -> bool:
    """Whether they are many lines that Orca would not say."""
    return len(lines) >= MANY_NUMBERS and all(line.replace(" ", "").isdigit() for line in lines)


class OnScreen:
    """The rows that were printed last."""

    def __init__(self) -> None:
        self._lines: deque[str] = deque()
        self._prompt = PROMPT
        """The line of the cursor; what is typed after it is taken to be the same each time."""

    def add(self, lines: Sequence[str], prompt: str, rows: int) -> None:
        """Add the lines and the prompt that were printed on a screen of so many rows."""
        self._lines += self._new_lines(lines)
        self._prompt = prompt
        while len(self._lines) > rows:
            self._lines.popleft()

    def most_said(self, block: Sequence[str], rows: int) -> int:
        """How many of these lines may be printed at once; all of them if that makes no difference."""
        if len(set(block).intersection(self._lines)) < FEWEST:
            return len(block)
        sizes = range(len(block), FEWEST - 1, -1)
        return next((size for size in sizes if self._are_said(block[:size], rows)), len(block))

    def _are_said(self, block: Sequence[str], rows: int) -> bool:
        from difflib import SequenceMatcher  # slow to load

        before = [*self._lines, self._prompt][-rows:]
        after = [*self._lines, *self._new_lines(block), ""][-rows:]
        silent = [False] * len(after)
        for same in SequenceMatcher(None, before, after, autojunk=False).get_matching_blocks():
            silent[same.b : same.b + same.size] = [True] * same.size
        return [line for line, is_silent in zip(after, silent, strict=True) if line and not is_silent] == [
            *block
        ]

    def _new_lines(self, block: Sequence[str]) -> list[str]:
        """The lines of the screen that the block adds: the prompt's line, which is ended, comes first."""
        return [self._prompt, *block] if self._prompt and block else [*block]
