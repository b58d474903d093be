"""Turns events into lines to print, between the threads that publish them and the thread that prints.

Any thread may publish. The listener never prints: it queues the lines and wakes the main thread. Nothing but
printable text passes, and nothing is lost. The answer to a command that was typed meanwhile is printed first.

Memory is bounded, and typing stays possible: a robot that publishes faster than its lines are printed waits
behind its own lines (``wait_for_room``) until it is stopped. Between blocks of lines the main thread looks
for keys, and after a stop it prints only the last lines.
"""

from __future__ import annotations

import threading
from collections import Counter, deque
from collections.abc import Callable, Iterable

from donnie_tui.bootstrap import Donnie
from donnie_tui.commands.context import Context
from donnie_tui.commands.declarations import BY_NAME
from donnie_tui.commands.dispatch import perform
from donnie_tui.commands.interaction import drive
from donnie_tui.core.answer_log import LONGEST_ANSWER
from donnie_tui.core.events import TRANSIENT, Announced, Answered, Stamped
from donnie_tui.core.transcript import SummingUp, told_lines
from donnie_tui.linear.console import Console
from language.control import ControlState
from language.source import printable

CAPACITY = 500
"""Lines of a robot that may wait before its program waits."""
LARGEST_BLOCK = 18
"""Lines that are printed at once, at most."""

URGENT = ("link",)
"""Codes of announcements that are printed in the middle of a line that is being typed."""
_ENDING = (ControlState.STOPPING, ControlState.ENDED)


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
        """The lines that wait, so many of them at most."""
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
    """Without blanks at its ends."""
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
    def is_running(self) -> bool:
        """Whether a robot runs that is not being stopped."""
        runs = (session.run for session in self._ctx.donnie.team.running)
        return any(run is not None and run.control.state not in _ENDING for run in runs)

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
    ) -> None:
        """``is_paced``: a learner types and reads here, so that quick movements are summed up."""
        self._donnie, self._console, self._queue = donnie, console, queue
        self._background = background
        self._is_typing = self._has_lines = False
        """Whether a line is being typed, and whether events were published meanwhile."""
        console.lines_wait = lambda: self._has_lines and bool(queue)
        self._summing_up = SummingUp(
            donnie.words, console.now, lambda: is_paced and donnie.session.speed is not None
        )
        told_as_printed = donnie.outlets.audible.tell_as(self._summing_up)
        self._unsubscribe = [donnie.session.hub.subscribe(self._on_event), told_as_printed]

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
        if self._is_typing and not isinstance(event, TRANSIENT):
            self._has_lines = True
            self._console.nudge()
        if isinstance(event, Announced) and event.code in URGENT:
            self._console.has_news = True
            self._console.nudge()

    def _put(self, stamped: Stamped) -> None:
        """Print a sum of the movements that were left out, and the event; remember all of its lines.

        An answer is printed before the lines of background robots, if these are more than a block.
        """
        lines, before = told_lines(stamped, self._donnie.words), self._summing_up.before(stamped)
        passes = self._summing_up.passes(stamped)
        event, remembered = stamped.event, lines
        if isinstance(event, Answered) and event.is_repeated:
            remembered = ()
        if isinstance(event, Answered) and (event.at_once or self._background.floods):
            self._queue.put_first(lines, is_kept=bool(remembered))
            lines, remembered, passes = (), (), False
        self._queue.put((*before, *lines) if passes else before, remembered, stamped.robot)
