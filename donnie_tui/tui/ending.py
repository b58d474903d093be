"""How the full screen ends when nobody leaves it: by a signal, a lost line, stuck output, a fault of ours.

Rules: whatever ends it, the robots are halted first and the text is kept; the process is gone in time.
"""

from __future__ import annotations

import asyncio
import os
import signal
import threading
import traceback
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path

from textual.app import App

from donnie_tui.tui.lifeline import BACK, Lifeline, give_back
from donnie_tui.tui.session_behind import SessionBehind

FAULT = "fault.txt"
"""Beside the copies: what went wrong at last, for whoever mends it."""

LAST = 1.0
"""Seconds for each thing that is to be saved when the screen does not leave by itself."""


class Ending:
    """Hears the signals from ``begin`` to ``end_lifeline``."""

    def __init__(
        self,
        app: App[int],
        behind: SessionBehind,
        folder: Path,
        *,
        stop_all: Callable[[], object],
        repaint: Callable[[], object],
    ) -> None:
        """``folder`` holds the copies; ``stop_all`` is as the key of that name."""
        self._app, self._behind, self._folder = app, behind, folder
        self._stop_all, self._repaint = stop_all, repaint
        self._lifeline: Lifeline | None = None

    def begin(self) -> None:
        """Somebody ends the process, or the line is lost. Ctrl+C from elsewhere only stops the program."""
        loop = asyncio.get_running_loop()

        def tell(number: int) -> None:
            with suppress(RuntimeError):  # the loop may be gone
                loop.call_soon_threadsafe(self._signalled, number)

        def stuck() -> None:
            if self._behind.stop_real_robot():
                tell(0)

        lifeline = Lifeline(
            halt=self._behind.halt,
            before_rest=self._behind.stop_real_robot,
            tell=tell,
            on_stuck=stuck,
            part=self._part,
            writer=lambda: getattr(self._app._driver, "_writer_thread", None),
        )
        with suppress(ValueError):
            lifeline.begin()
            self._lifeline = lifeline

    def end_lifeline(self) -> None:
        """In the main thread, once nothing is written to the screen any more."""
        if self._lifeline is not None:
            self._lifeline.end()

    # --- in the screen's thread

    def _signalled(self, number: int) -> None:
        if number == signal.SIGINT:
            self._interrupt()
        elif number == BACK:
            self._repaint()
        elif number:
            self.leave(number)
        elif self._behind.work is not None:
            self._behind.work.talk.tell_sentences(self._behind.work.words("stuck-stopped"))

    def _interrupt(self) -> None:
        """As the key that stops all."""
        if not self._behind.give_up_search() and self._behind.runs:
            self._stop_all()
        if self._lifeline is not None:
            self._lifeline.answered.set()

    def leave(self, number: int) -> None:
        """As that signal wants it."""
        self._behind.halt()
        self._behind.keep_text()
        self._app.exit(128 + number)

    def save_from_fault(self) -> None:
        """What can be, after an exception that nobody caught: while it is being handled."""
        with suppress(Exception):
            self._behind.halt()
        with suppress(Exception):
            self._behind.keep_text()
        with suppress(OSError):
            self._folder.mkdir(parents=True, exist_ok=True)
            (self._folder / FAULT).write_text(traceback.format_exc(), encoding="utf-8")

    # --- in the lifeline's thread

    def _part(self, number: int) -> None:
        """The screen did not leave by itself: what can be saved in a moment, and the end."""
        for last in (self._behind.keep_text, self._behind.close):
            saving = threading.Thread(target=last, daemon=True)
            saving.start()
            saving.join(LAST)
        give_back(self._app._driver)
        os._exit(128 + number)
