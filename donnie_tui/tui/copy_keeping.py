"""The copies of what is not saved, for the case of a crash: written down beside the screen.

Rule: whoever types waits for no disk. One copy of each program at a time, however slow the disk is.
"""

from __future__ import annotations

import asyncio
import contextlib

from donnie_tui.core.copies import Copies
from donnie_tui.core.documents import DocumentError
from donnie_tui.tui.desk import Desk
from donnie_tui.tui.open_programs import OpenPrograms
from donnie_tui.tui.running import Answer


class CopyKeeping:
    """Brings the copies of the open programs up to what is wanted."""

    def __init__(self, desk: Desk, programs: OpenPrograms) -> None:
        self._desk = desk
        self._programs = programs
        self._has_failed = False
        self._bringing_up: dict[Copies, asyncio.Task[None]] = {}

    def keep(self) -> None:
        """Have what is not saved written down, beside the screen; told once if that fails."""
        self._want_copy()
        self.bring_up(self._programs.copies)

    def keep_now(self) -> None:
        """As ``keep``, done once this returns: for whoever leaves. Quietly: who would hear it?"""
        self._want_copy()
        self.settle()

    def settle(self) -> None:
        """What is still to be written down or removed, of any program: done once this returns."""
        for program in self._programs:
            with contextlib.suppress(DocumentError):
                program.copies.settle()

    def forget(self, copies: Copies) -> None:
        """The text is safe elsewhere, or given up."""
        copies.want_none()
        self.bring_up(copies)

    def give_up(self) -> None:
        """Leaving on purpose: no copy is needed."""
        for program in self._programs:
            self.forget(program.copies)

    def give_up_current(self) -> None:
        """The program in the editor is taken along; what the others have that is not saved is kept."""
        self.forget(self._programs.copies)

    def bring_up(self, copies: Copies) -> None:
        """Do what is wanted of them, beside the screen."""
        if copies not in self._bringing_up:
            self._bringing_up[copies] = asyncio.ensure_future(self._settle(copies))

    def _want_copy(self) -> None:
        programs, text = self._programs, self._desk.text
        if programs.is_changed and text.strip():
            programs.copies.want(text, programs.document.path)
        else:
            programs.copies.want_none()

    async def _settle(self, copies: Copies) -> None:
        try:
            while copies.is_behind:
                try:
                    await asyncio.to_thread(copies.settle)
                except DocumentError as error:
                    self._tell_not_kept(error)
        finally:
            del self._bringing_up[copies]

    def _tell_not_kept(self, error: DocumentError) -> None:
        if not self._has_failed:
            self._has_failed = True
            self._desk.tell(Answer("answer-not-kept", {"reason": error.reason}))
