"""The lines that wait to be printed, between the threads that tell and the one that prints.

Rules: nothing but printable text gets through; nothing is lost; telling never waits, so that it holds
nobody else; and no program eats the memory: the robot whose program tells faster than anybody reads is held
back behind its own lines (``wait_for_room``), until it is stopped. What is answered to a word that was typed
meanwhile is printed first.

What is printed, and when: whole lines, an answer and the prompt in one write, rests between blocks.

A screen reader loses what scrolls by, and it says a prompt twice that comes in a write of its own. So the
new line of Enter is held back until there is an answer, and no more than a screenful comes at once. Orca
takes a write of nothing but digits for something typed and keeps silent: such a block ends with a sentence.

Fenrir compares the screen before and after with ``difflib``, which looks first for the longest part of both.
That must be what has moved up (``OnScreen``). Where an answer is said again that stands there it may be the
answer, which is then silent, and the lines above it are said. With fewer lines at once more stays than is
new.
"""

from __future__ import annotations

import threading
from collections import Counter, deque
from collections.abc import Callable, Iterable, Sequence
from typing import Protocol

from donnie_tui.core.answer_log import LONGEST_ANSWER
from donnie_tui.linear.greeting import PROMPT
from language.source import printable

CAPACITY = 500
"""Lines that may wait before a program is held back."""


class Told:
    """Lines in the order in which they were told."""

    def __init__(self, nudge: Callable[[], None], capacity: int = CAPACITY) -> None:
        """``nudge`` is called when the first line comes after there was none."""
        self._nudge = nudge
        self._capacity = capacity
        self._lines: list[tuple[str, str | None]] = []
        """Each with the robot that told it."""
        self._waiting = Counter[str | None]()
        """How many lines of each robot wait."""
        self._first: list[str] = []
        """What is printed before them."""
        self._kept: deque[str] = deque(maxlen=LONGEST_ANSWER)
        self._changed = threading.Condition()
        self.holds_back = False
        """Whether a program that tells too much waits."""
        self.count = 0
        """Lines that were ever told."""

    def put(self, lines: Iterable[str], kept: Iterable[str] | None = None, robot: str | None = None) -> None:
        """Tell some lines, from any thread. What would print as an empty line is left out.

        ``kept`` is what is remembered of it, where that is not what is printed; ``robot`` is who tells it.
        """
        said = [line for line in map(_shown, lines) if line]
        kept_lines = said if kept is None else [line for line in map(_shown, kept) if line]
        with self._changed:
            was_empty = not self
            self._lines += [(line, robot) for line in said]
            self._waiting[robot] += len(said)
            self._kept += kept_lines
            self.count += len(said) or len(kept_lines)
        if was_empty and said:
            self._nudge()

    def put_first(self, lines: Iterable[str], *, is_kept: bool = True) -> None:
        """Tell some lines before all that waits, in their order; from any thread."""
        said = [line for line in map(_shown, lines) if line]
        with self._changed:
            self._first += said
            self._kept += said if is_kept else []
            self.count += len(said)
        self._nudge()

    def wait_for_room(self, robot: str | None) -> None:
        """In the thread of that robot's program: return once there is room for what it tells next."""
        if self._has_room(robot):
            return
        with self._changed:
            self._changed.wait_for(lambda: self._has_room(robot))

    def take(self, most: int | None = None) -> list[str]:
        """The lines that wait, so many of them at most."""
        with self._changed:
            lines = self._first[:most]
            self._first = self._first[len(lines) :]
            lines += self._forget(len(self._lines) if most is None else most - len(lines))
        return lines

    def _forget(self, count: int) -> list[str]:
        """The oldest lines, which wait no more. Under the lock."""
        gone, self._lines = self._lines[:count], self._lines[count:]
        self._waiting.subtract(robot for _, robot in gone)
        self._changed.notify_all()
        return [line for line, _ in gone]

    def take_kept(self) -> list[str]:
        """What is to be remembered of what was told since the last time, the newest lines of it."""
        with self._changed:
            lines = list(self._kept)
            self._kept.clear()
        return lines

    def trim(self, kept: int) -> int:
        """Leave only the ``kept`` newest lines. How many were left out."""
        with self._changed:
            return len(self._forget(max(0, len(self._lines) - kept)))

    @property
    def has_first(self) -> bool:
        """Whether something waits that is printed before all else."""
        return bool(self._first)

    def __len__(self) -> int:
        return len(self._first) + len(self._lines)

    def hold_back(self) -> None:
        """From now on the program that tells too much waits. Only while another thread prints."""
        self.holds_back = True

    def let_pass(self) -> None:
        """Nobody waits any more: the program was stopped, or is over."""
        with self._changed:
            self.holds_back = False
            self._changed.notify_all()

    def _has_room(self, robot: str | None) -> bool:
        return not self.holds_back or self._waiting[robot] < self._capacity


def _shown(line: str) -> str:
    """Without blanks at its ends."""
    return printable(line).strip()


REST = 0.3
"""Seconds of rest after each block of lines."""
LARGEST_BLOCK = 18
AFTER_STOP = 5
"""Lines that are told at a stop without a rest: a block leaves room for them and the prompt."""

MANY_NUMBERS = 4
"""Lines of a block that need a sentence, if they are nothing but digits. A few are not worth one."""


class Paper(Protocol):
    """What is printed on."""

    interrupted: bool

    def write(self, text: str) -> None: ...

    def wait(self, seconds: float) -> object:
        """Rest; shorter if something happens."""

    def now(self) -> float: ...

    def rows(self) -> int: ...


class Output:
    """Prints blocks of lines. ``paced`` is for people; a pipe needs no rests."""

    def __init__(self, paper: Paper, *, paced: bool, of_numbers: Callable[[int], str] = "{}".format) -> None:
        """``of_numbers``: the sentence that tells how many numbers those were."""
        self._paper = paper
        self._of_numbers = of_numbers
        self.paced = paced
        """Whether there are rests; may be changed at any time."""
        self._held = ""
        self._room = 0
        self._rested_at = float("-inf")
        self._on_screen = OnScreen()

    def hold_newline(self) -> None:
        """Enter was pressed: its new line goes out with whatever comes next."""
        self._held = "\n"

    def show(self, lines: list[str], prompt: str = "", *, to_the_end: bool = False) -> int:
        """Print the lines, then the prompt.

        Ctrl+C during a rest ends it, without the prompt; the answer is how many lines were not printed.
        ``to_the_end``: it ends the rests and nothing else, and a few lines need none.
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
        """What may be printed now, after a rest if one is due, and what comes after it."""
        if not self.paced:
            return lines, []
        self._make_room(bool(lines))
        size = self._room
        if (prompt == "" or len(lines) > size) and are_silent(lines[:size]):
            size -= 1  # for the sentence
        heard = self._on_screen.most_heard(lines[:size], self._paper.rows())
        if heard < len(lines[:size]):
            size, self._room = heard, 0
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
    """Whether Orca would not say them, and they are many."""
    return len(lines) >= MANY_NUMBERS and all(line.replace(" ", "").isdigit() for line in lines)


FEWEST = 2
"""Lines at once; where not even these would be found the answer is one line over and over."""


class OnScreen:
    """The rows that were printed last."""

    def __init__(self) -> None:
        self._lines: deque[str] = deque()
        self._prompt = PROMPT
        """What stands where the cursor is; what is typed behind it is taken to be the same each time."""

    def add(self, lines: Sequence[str], prompt: str, rows: int) -> None:
        """They were printed, and the prompt, on a screen of so many rows."""
        self._lines += self._new_lines(lines)
        self._prompt = prompt
        while len(self._lines) > rows:
            self._lines.popleft()

    def most_heard(self, block: Sequence[str], rows: int) -> int:
        """How many of these lines may be printed at once; all of them where that makes no difference."""
        if len(set(block).intersection(self._lines)) < FEWEST:
            return len(block)
        sizes = range(len(block), FEWEST - 1, -1)
        return next((size for size in sizes if self._are_heard(block[:size], rows)), len(block))

    def _are_heard(self, block: Sequence[str], rows: int) -> bool:
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
        """The prompt's line is ended, where there is one."""
        return [self._prompt, *block] if self._prompt and block else [*block]
