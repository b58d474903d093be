"""From events to printed lines: the queue between the threads, and what is printed when.

Any thread may publish. The listener never prints: it queues the lines and wakes the main thread. Nothing but
printable text passes, and nothing is lost. The answer to a command that was typed meanwhile is printed first.
Memory is bounded, and typing stays possible: a robot that publishes faster than its lines are printed waits
behind its own lines (``wait_for_room``) until it is stopped. Between blocks of lines the main thread looks
for keys, and after a stop it prints only the last lines.

Printed are whole lines, an answer and the prompt in one write, with rests between blocks.
A screen reader loses what scrolls by, and it says a prompt twice that comes in a write of its own. So the
newline of Enter is held back until there is an answer, and no more than a screenful is printed at once. Orca
takes a write of nothing but digits for something typed and keeps silent: such a block ends with a full stop.

Fenrir compares the screen before and after with ``difflib``, which looks first for the longest part of both.
That must be the lines that moved up (``OnScreen``). If an answer that is still on the screen is printed
again, ``difflib`` may find the answer instead: then Fenrir is silent about it and says the lines above. With
fewer lines at once, more lines stay than are new.
"""

from __future__ import annotations

import threading
from collections import Counter, deque
from collections.abc import Callable, Iterable, Sequence

from donnie_tui.bootstrap import Donnie
from donnie_tui.commands.context import Context
from donnie_tui.commands.declarations import BY_NAME
from donnie_tui.commands.dispatch import perform
from donnie_tui.commands.interaction import drive
from donnie_tui.core.events import TRANSIENT, Announced, Answered, Error, Stamped
from donnie_tui.core.session_log import LONGEST_ANSWER
from donnie_tui.core.transcript import SummaryFilter, printed_lines
from donnie_tui.linear.console import Console
from donnie_tui.linear.greeting import PROMPT
from language.source import printable

CAPACITY = 500
"""Lines of a robot that may wait before its program waits."""
LARGEST_BLOCK = 18
"""Lines that are printed at once, at most."""
REST = 0.3
"""Seconds of rest after each block of lines."""
AFTER_STOP = 5
"""Lines that are printed after a stop without a rest: a block leaves room for them and the prompt."""
MANY_NUMBERS = 4
"""Lines of nothing but digits in a block that need a full stop after them."""
FEWEST = 2
"""Least lines printed at once; if not even these are said, the answer is one line over and over."""
URGENT = ("link",)
"""Codes of announcements that are printed in the middle of a line that is being typed."""


class OutputQueue:
    """Lines that wait to be printed, in the order in which they were published."""

    def __init__(self, nudge: Callable[[], None], capacity: int = CAPACITY) -> None:
        """``nudge`` is called when the first line comes after there was none."""
        self._nudge = nudge
        self._capacity = capacity
        self._lines: list[tuple[str, str | None]] = []
        """Each with the robot that it is about."""
        self._waiting = Counter[str | None]()
        """How many lines of each robot wait."""
        self._first: list[str] = []
        """Lines that are printed before them."""
        self._kept: deque[str] = deque(maxlen=LONGEST_ANSWER)
        self._changed = threading.Condition()
        self.holds_back = False
        """Whether a program that prints too much waits."""

    def put(self, lines: Iterable[str], kept: Iterable[str] | None = None, robot: str | None = None) -> None:
        """Add lines, from any thread. What would print as an empty line is left out.

        ``kept`` is what is remembered, if that differs from ``lines``; ``robot`` is the one of the lines.
        """
        said = [line for line in map(_shown, lines) if line]
        kept_lines = said if kept is None else [line for line in map(_shown, kept) if line]
        with self._changed:
            was_empty = not self
            self._lines += [(line, robot) for line in said]
            self._waiting[robot] += len(said)
            self._kept += kept_lines
        if was_empty and said:
            self._nudge()

    def put_first(self, lines: Iterable[str], *, is_kept: bool = True) -> None:
        """Add lines before all that wait, in their order; from any thread."""
        said = [line for line in map(_shown, lines) if line]
        with self._changed:
            self._first += said
            self._kept += said if is_kept else []
        self._nudge()

    def wait_for_room(self, robot: str | None) -> None:
        """In the thread of that robot's program: return once there is room for its next lines."""
        if self._has_room(robot):
            return
        with self._changed:
            self._changed.wait_for(lambda: self._has_room(robot))

    def take(self, most: int | None = None) -> list[str]:
        """The first lines that wait, at most that many."""
        with self._changed:
            lines = self._first[:most]
            self._first = self._first[len(lines) :]
            lines += self._forget(len(self._lines) if most is None else most - len(lines))
        return lines

    def _forget(self, count: int) -> list[str]:
        """Remove and return the oldest lines. Under the lock."""
        gone, self._lines = self._lines[:count], self._lines[count:]
        self._waiting.subtract(robot for _, robot in gone)
        self._changed.notify_all()
        return [line for line, _ in gone]

    def take_kept(self) -> list[str]:
        """The newest lines to remember of those that were added since the last time."""
        with self._changed:
            lines = list(self._kept)
            self._kept.clear()
        return lines

    def trim(self, kept: int) -> int:
        """Remove all but the ``kept`` newest lines. Returns how many were removed."""
        with self._changed:
            return len(self._forget(max(0, len(self._lines) - kept)))

    @property
    def has_first(self) -> bool:
        """Whether a line waits that is printed before all others."""
        return bool(self._first)

    def __len__(self) -> int:
        return len(self._first) + len(self._lines)

    def hold_back(self) -> None:
        """Let a program that prints too much wait from now on. Only while another thread prints."""
        self.holds_back = True

    def let_pass(self) -> None:
        """Let no program wait any more: it was stopped, or is over."""
        with self._changed:
            self.holds_back = False
            self._changed.notify_all()

    def _has_room(self, robot: str | None) -> bool:
        return not self.holds_back or self._waiting[robot] < self._capacity


def _shown(line: str) -> str:
    """The line without blanks at its ends."""
    return printable(line).strip()


class BackgroundRobots:
    """The robots whose programs run while the learner types, since START doesn't wait for them."""

    def __init__(self, ctx: Context, queue: OutputQueue) -> None:
        self._ctx, self._queue = ctx, queue
        self._left_out = 0
        """Lines that were not printed before the stop."""
        self.is_following = False
        """Whether the main thread follows a run: its lines and all others stay in their order."""

    @property
    def floods(self) -> bool:
        """Whether more lines wait than are printed at once, while more may come any time."""
        is_long = len(self._queue) > LARGEST_BLOCK
        return is_long and bool(self._ctx.donnie.team.running) and not self.is_following

    def stop(self, left_out: int = 0) -> None:
        """Stop all robots, and say so; ``left_out`` lines were removed already without being printed."""
        self._left_out = left_out
        drive(perform(self._ctx, BY_NAME["stop_all"], ""))

    def trim_after_stop(self) -> None:
        """Keep only the last lines that wait, and say how many were removed."""
        self._queue.let_pass()
        left_out = self._left_out + self._queue.trim(LARGEST_BLOCK)
        self._left_out = 0
        if left_out:
            self._ctx.answer("answer-left-out", lines=left_out)


class Listener:
    """Queues the lines of all events until ``close``."""

    def __init__(
        self,
        donnie: Donnie,
        console: Console,
        queue: OutputQueue,
        background: BackgroundRobots,
        *,
        is_paced: bool,
        is_known: Callable[[Error], bool],
    ) -> None:
        """``is_paced``: a learner types and reads here, so that quick movements are summed up.

        ``is_known``: whether a mistake was reported before.
        """
        self._donnie, self._console, self._queue = donnie, console, queue
        self._background = background
        self._is_typing = self._has_lines = False
        """Whether a line is being typed, and whether events were published meanwhile."""
        console.lines_wait = lambda: self._has_lines and bool(queue)
        self._summing_up = SummaryFilter(
            donnie.words, console.now, lambda: is_paced and donnie.session.speed is not None, is_known
        )
        stop_filtering = donnie.outlets.audible.speak_only(self._summing_up)
        self._unsubscribe = [donnie.session.hub.subscribe(self._on_event), stop_filtering]

    def close(self) -> None:
        """Unsubscribe: another front end continues with the session."""
        for unsubscribe in self._unsubscribe:
            unsubscribe()

    def line_begins(self) -> None:
        """Interrupt the typing of a line for urgent news from now on."""
        self._has_lines, self._is_typing = False, True

    def line_ended(self) -> None:
        self._is_typing = False

    def _on_event(self, stamped: Stamped) -> None:
        """Queue its lines. From any thread."""
        event = stamped.event
        self._put(stamped)
        if self._is_typing and (isinstance(event, Answered) or not isinstance(event, TRANSIENT)):
            self._has_lines = True
            self._console.nudge()
        if _is_urgent(event):
            self._console.has_news = True
            self._console.nudge()

    def _put(self, stamped: Stamped) -> None:
        """Print a sum of the movements that were left out, and the event; remember all of its lines.

        An answer is printed before the lines of background robots, if these are more than a block.
        """
        lines, before = printed_lines(stamped, self._donnie.words), self._summing_up.before(stamped)
        passes = self._summing_up.passes(stamped)
        event, remembered = stamped.event, lines
        if (isinstance(event, Answered) and event.is_repeated) or (isinstance(event, Error) and not passes):
            remembered = ()
        if isinstance(event, Answered) and (event.at_once or self._background.floods):
            self._queue.put_first(lines, is_kept=bool(remembered))
            lines, remembered, passes = (), (), False
        if _is_urgent(event) and self._is_stopping:  # only the last lines of the program are printed
            self._queue.put_first(lines)
            lines = remembered = ()
        self._queue.put((*before, *lines) if passes else before, remembered, stamped.robot)

    @property
    def _is_stopping(self) -> bool:
        run = self._donnie.session.run
        return run is not None and run.is_ending


def _is_urgent(event: object) -> bool:
    return isinstance(event, Announced) and event.code in URGENT


class PacedOutput:
    """Prints blocks of lines. ``paced`` is for learners; a pipe needs no rests."""

    def __init__(self, target: Console, *, paced: bool) -> None:
        self._target = target
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
        block, lines = self._next_block(lines)
        while lines:
            self._write(block, "")
            block, lines = self._next_block(lines)
            if self._target.interrupted and not to_the_end:
                return len(block) + len(lines)
        self._write(block, prompt)
        return 0

    def _next_block(self, lines: list[str]) -> tuple[list[str], list[str]]:
        """The lines to print now, after a rest if one is due, and the lines after them."""
        if not self.paced:
            return lines, []
        self._make_room(bool(lines))
        size = self._room
        said = self._on_screen.most_said(lines[:size], self._target.rows())
        if said < len(lines[:size]):
            size, self._room = said, 0
        block, rest = lines[:size], lines[size:]
        self._room -= len(block)
        return block, rest

    def _make_room(self, wanted: bool) -> None:
        now = self._target.now()
        if now - self._rested_at >= REST:
            self._room = self.block_size
        elif wanted and self._room <= 0:
            self._rest(self._rested_at + REST)
            self._room = self.block_size

    def _rest(self, until: float) -> None:
        while not self._target.interrupted and (left := until - self._target.now()) > 0:
            self._target.wait(left)

    def _write(self, block: list[str], prompt: str) -> None:
        if self.paced and prompt == "" and are_silent(block):
            block = [*block[:-1], f"{block[-1]}."]
        text = self._held + "".join(f"{line}\n" for line in block) + prompt
        self._held = ""
        self._on_screen.add(block, prompt, self._target.rows())
        if text:
            self._target.write(text)
            self._rested_at = self._target.now()

    @property
    def block_size(self) -> int:
        """Lines that are printed at once."""
        return max(1, min(self._target.rows() - 6, LARGEST_BLOCK))


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
        """Add the lines and the prompt that were printed on a screen of that many rows."""
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
