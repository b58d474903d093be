"""When the mailbox is emptied, and the log written: often enough to be alive, seldom enough to be cheap."""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence

from textual.timer import Timer

from donnie_tui.core.wording import Wording
from donnie_tui.tui.bridge import Bridge, LogLine, Mail

FRAME = 1 / 20
"""Seconds between two looks into the mailbox: the map moves at most so often."""
CALM = 1 / 2
"""The same for those who asked for little motion: whole squares, at most twice a second."""
FLUSH = 1 / 5
"""Seconds between two writes into the log."""


class Intake:
    """Takes mail for the screen, in the screen's thread."""

    def __init__(
        self,
        bridge: Bridge,
        words: Wording,
        *,
        set_timer: Callable[[float, Callable[[], None]], Timer],
        receive: Callable[[Mail], None],
        write: Callable[[Sequence[LogLine]], None],
    ) -> None:
        """``receive`` is given all mail at once, ``write`` the lines for the log in larger pieces."""
        self.frame = FRAME
        self._bridge = bridge
        self._words = words
        self._set_timer = set_timer
        self._receive = receive
        self._write = write
        self._lines: list[LogLine] = []
        self.taken_at = self._written_at = -FLUSH
        """When the mailbox was emptied last, by the monotonic clock."""
        self._taking: Timer | None = None
        self._writing: Timer | None = None

    def happened(self) -> None:
        """There is mail: take it now, or when it is time again."""
        due = self.taken_at + self.frame - time.monotonic()
        if due <= 0:
            self.take()
        elif self._taking is None:
            self._taking = self._set_timer(due, self.take)

    def begun(self) -> None:
        """A run is shown to have begun: take what has happened in it so far."""
        self._bridge.begun()
        self.take()

    def take(self) -> None:
        """Empty the mailbox now."""
        if self._taking is not None:
            self._taking.stop()
            self._taking = None
        self.taken_at = time.monotonic()
        mail = self._bridge.take()
        if mail.missed:
            self._lines.append(LogLine(self._words("answer-left-out", lines=mail.missed), "answer"))
        self._lines.extend(mail.lines)
        self._receive(mail)
        self._write_soon()

    def _write_soon(self) -> None:
        if not self._lines or self._writing is not None:
            return
        due = self._written_at + FLUSH - time.monotonic()
        if due > 0:
            self._writing = self._set_timer(due, self.write)
        else:
            self.write()

    def write(self) -> None:
        """Write the log now."""
        if self._writing is not None:
            self._writing.stop()
            self._writing = None
        self._written_at = time.monotonic()
        lines, self._lines = self._lines, []
        self._write(lines)
