"""Bringing back what an earlier start left unsaved."""

from __future__ import annotations

from pathlib import Path

from donnie_tui.core.breakpoints import KeptBreakpoints
from donnie_tui.core.copies import Rescued
from donnie_tui.core.documents import DocumentError, saved_text
from donnie_tui.tui.desk import Desk, told
from donnie_tui.tui.open_programs import OpenPrograms
from donnie_tui.tui.running import Answer
from donnie_tui.tui.saving import Saving


class Recovering:
    """The copies that an earlier start left, the newest first."""

    def __init__(
        self,
        desk: Desk,
        programs: OpenPrograms,
        saving: Saving,
        kept_breakpoints: KeptBreakpoints,
    ) -> None:
        self._desk = desk
        self._programs = programs
        self._saving = saving
        self._kept_breakpoints = kept_breakpoints
        copies = programs.current.copies
        self._rescued = copies.rescued()
        self._taken: set[Path] = set()

    @property
    def is_offered(self) -> bool:
        """Whether there is one that nobody wanted to leave; what somebody left is there for who asks."""
        return not self._taken.issuperset(self._rescued)

    def _offered(self) -> list[Path]:
        """What is left may have been left just now."""
        found = (*self._rescued, *self._programs.current.copies.left())
        return [each for each in found if each not in self._taken]

    async def recover(self) -> None:
        """Bring back the newest, as the program in the editor; others one by one."""
        copy = next(iter(self._offered()), None)
        if copy is None:
            self._desk.talk.tell(Answer("answer-nothing-to-recover"))
            return
        try:
            found, saved = await self._desk.talk.patiently(
                lambda: self._read(copy), Answer("slow-opening", {"name": copy.name})
            )
        except DocumentError as error:
            self._desk.talk.tell(told(error))
            return
        if await self._saving.is_safe_to_leave() and copy not in self._taken:
            self._bring_back(copy, found, saved)

    def _read(self, copy: Path) -> tuple[Rescued, str]:
        """What it holds, and what its file has now."""
        found = self._programs.current.copies.read(copy)
        return found, saved_text(found.path) if found.path is not None else ""

    def _bring_back(self, copy: Path, found: Rescued, saved: str) -> None:
        self._taken.add(copy)
        self._programs.give_up_current()
        lines = found.text.count("\n") + 1
        self._desk.load(found.text, self._kept_breakpoints.of(found.path, lines))
        self._programs.document.become(found.path, saved)
        self._programs.keep_rescued(found, copy)
        code = "answer-recovered" if found.path is None else "answer-recovered-file"
        self._desk.talk.tell(Answer(code, {"lines": lines, "name": self._programs.name}))
        if self.is_offered:
            self._desk.talk.tell(Answer("answer-rescued-more"))
