"""What is heard of the robots: each event becomes lines to be printed, and what words ask for is remembered.

Rule: any thread may tell something; it never prints, it wakes who does.
"""

from __future__ import annotations

from donnie_tui.bootstrap import Donnie
from donnie_tui.core.events import TRANSIENT, Announced, Answered, Stamped
from donnie_tui.core.transcript import SummingUp, printed_lines
from donnie_tui.linear.beside import Beside
from donnie_tui.linear.ends import Ends

CANNOT_WAIT = ("link",)
"""Codes of announcements that are told in the middle of a line that is being typed."""


class Hearing:
    """Listens from the beginning to ``close``."""

    def __init__(self, donnie: Donnie, ends: Ends, beside: Beside) -> None:
        self._donnie = donnie
        self._beside = beside
        self._ends = ends
        self._is_reading = self._told_beside = False
        """Whether a line is being typed, and a robot that runs beside the conversation told something."""
        ends.console.lines_wait = self._lines_wait
        self._summing_up = SummingUp(donnie.words, ends.console.now, self._has_pace)
        told_as_printed = donnie.outlets.audible.speak_only(self._summing_up)
        self._unsubscribe = [donnie.session.hub.subscribe(self._hear), told_as_printed]

    def close(self) -> None:
        """Hear no more: somebody else goes on with the session."""
        for leave in self._unsubscribe:
            leave()

    def hear_out(self) -> None:
        """Return once all that was published is here: the answer to a word may be delivered by a program."""
        self._donnie.session.hub.wait_until_delivered()

    def line_begins(self) -> None:
        """From now on what is told is told beside a line that is being typed."""
        self._told_beside, self._is_reading = False, True

    def line_ended(self) -> None:
        self._is_reading = False

    def _hear(self, stamped: Stamped) -> None:
        """Any thread's: what the event says will be printed."""
        event, console = stamped.event, self._ends.console
        self._put(stamped)
        if self._is_reading and not isinstance(event, TRANSIENT):
            self._told_beside = True
            console.nudge()
        if isinstance(event, Announced) and event.code in CANNOT_WAIT:
            console.has_news = True
            console.nudge()

    def _put(self, stamped: Stamped) -> None:
        """To be printed: a sum of what was not told before, and what is told; to be remembered: all.

        An answer waits for nothing that robots tell beside, where that is more than is printed at once.
        """
        lines, before = printed_lines(stamped, self._donnie.words), self._summing_up.before(stamped)
        passes = self._summing_up.passes(stamped)
        event, remembered = stamped.event, lines
        if isinstance(event, Answered) and event.is_repeated:
            remembered = ()
        if isinstance(event, Answered) and (event.at_once or self._beside.floods):
            self._ends.told.put_first(lines, is_kept=bool(remembered))
            lines, remembered, passes = (), (), False
        self._ends.told.put((*before, *lines) if passes else before, remembered, stamped.robot)

    def _lines_wait(self) -> bool:
        return self._told_beside and bool(self._ends.told)

    def _has_pace(self) -> bool:
        """Whether somebody listens to a robot that takes its time."""
        has_speed = self._donnie.session.speed is not None
        return self._ends.prompts and self._ends.is_terminal and has_speed
