"""Saving the program, and asking before something is lost: what stands in another file, or what is not saved.

A slow disk holds nobody up; what is being saved is saved to its end, whatever is asked meanwhile.
"""

from __future__ import annotations

import asyncio
import contextlib
from pathlib import Path

from donnie_tui.core.breakpoints import KeptBreakpoints
from donnie_tui.core.documents import DocumentError, page_to_save, write_program
from donnie_tui.core.wording import Wording
from donnie_tui.tui.desk import Desk, YesOrNo, told
from donnie_tui.tui.open_programs import OpenPrograms, Program
from donnie_tui.tui.recent import Recent
from donnie_tui.tui.running import Answer


class Saving:
    """Saves the program in the editor, and what else is written on the learner's word."""

    def __init__(
        self,
        desk: Desk,
        words: Wording,
        programs: OpenPrograms,
        recent: Recent,
        kept_breakpoints: KeptBreakpoints,
    ) -> None:
        self._desk = desk
        self._words = words
        self._programs = programs
        self._recent = recent
        self._kept_breakpoints = kept_breakpoints
        self._question = YesOrNo(desk, words)
        self._saving = asyncio.Lock()

    async def save(self, name: str) -> bool:
        """Save, asking for a name where there is none. False if it was not saved."""
        path = self._programs.document.path
        if not name and path is not None:
            return await self._save_to(path)
        return await self.save_as(name)

    async def save_as(self, name: str) -> bool:
        own = str(self._programs.document.path or "")
        name = name or await self._desk.talk.ask(self._words("ask-save"), value=own) or ""
        if not name:
            return self._goes_no_further()
        try:
            path = self._programs.document.place_for(name)
        except DocumentError as error:
            self._desk.talk.tell(told(error))
            return False
        return await self._save_to(path)

    async def _save_to(self, path: Path) -> bool:
        """Asks before it replaces what this program did not put there."""
        slow = Answer("slow-saving", {"name": path.name})
        asked = await self._desk.talk.patiently(lambda: self._to_be_asked(path), slow)
        if asked and not await self._question.ask(asked, path.name):
            return self._goes_no_further()
        return await self._write(path)

    def _goes_no_further(self) -> bool:
        """Somebody left a question."""
        self._desk.talk.tell(Answer("answer-unchanged"))
        return False

    def _to_be_asked(self, path: Path) -> str:
        """The code of a question; empty where nothing would be lost."""
        document = self._programs.document
        if document.overwrites(path):
            return "ask-replace"
        return "ask-replace-changed" if document.was_changed_outside(path) else ""

    async def _write(self, path: Path) -> bool:
        """To its end, whatever is asked meanwhile."""
        return await asyncio.shield(asyncio.ensure_future(self._write_alone(path)))

    async def _write_alone(self, path: Path) -> bool:
        async with self._saving:
            return await self._write_now(path, self._programs.current, self._desk.text)

    async def _write_now(self, path: Path, program: Program, text: str) -> bool:
        """A slow disk holds nobody up; whatever is typed meanwhile is not saved, and has its copy."""
        slow = Answer("slow-saving", {"name": path.name})
        try:
            await self._desk.talk.patiently(lambda: program.document.write(path, text), slow)
        except DocumentError as error:
            self._desk.talk.tell(told(error))
            return False
        if self._desk.text == text and self._programs.current is program:
            self._programs.forget_copy(program)
            self._kept_breakpoints.keep(path, self._desk.breakpoints)
        self._recent.add(path)
        self._desk.talk.tell(Answer("answer-saved", {"name": path.name, "lines": text.count("\n") + 1}))
        return True

    # --- other files than the program's

    async def may_replace(self, path: Path) -> bool:
        """Whether nothing is there, or somebody wants it replaced; that it stays is told."""
        with contextlib.suppress(OSError, ValueError, RuntimeError):
            if path.expanduser().exists() and not await self._question.ask("ask-replace", path.name):
                return self._goes_no_further()
        return True

    async def write_beside(self, name: str, text: str) -> None:
        """Another file than the program's; what was there is replaced only by somebody who wants it."""
        try:
            path = page_to_save(name, self._programs.files, self._programs.in_use)
            if not await self.may_replace(path):
                return
        except DocumentError as error:
            self._desk.talk.tell(told(error))
        else:
            await asyncio.shield(asyncio.ensure_future(self._write_other(path, text)))

    async def _write_other(self, path: Path, text: str) -> None:
        """To its end, whatever is asked meanwhile."""
        slow = Answer("slow-report", {"name": path.name})
        try:
            await self._desk.talk.patiently(lambda: write_program(path, text), slow)
        except DocumentError as error:
            self._desk.talk.tell(told(error))
        else:
            self._desk.talk.tell(Answer("answer-written", {"name": path.name}))

    # --- before a text goes

    async def is_done(self) -> None:
        """Waits for what is being saved just now."""
        async with self._saving:
            pass

    async def is_safe_to_leave(self) -> bool:
        """Whether the text may go: it is saved, or was offered to be; what is typed meanwhile too."""
        while True:
            await self.is_done()  # what is being saved just now is not asked about
            if not self._programs.is_changed or not self._desk.text.strip():
                return True
            answer = await self._question.ask("ask-unsaved", self._programs.name)
            if answer is None:
                return self._goes_no_further()
            if not answer:
                return True
            if not await self.save(""):
                return False
