"""The file actions: which program is in the editor, opening one, beginning anew, going to another.

Nothing that was typed is lost without a question; every failure is a sentence. The document and its copies
know no screen; this asks the person and tells the outcome. Saving, the copies and what is rescued have
modules of their own, and are reached from here.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from donnie_tui.core.breakpoints import KeptBreakpoints
from donnie_tui.core.copies import Copies
from donnie_tui.core.documents import Document, DocumentError, saved_text
from donnie_tui.core.in_use import FilesInUse
from donnie_tui.core.wording import Wording
from donnie_tui.tui.desk import Desk, told
from donnie_tui.tui.open_programs import OpenPrograms, Program
from donnie_tui.tui.recent import Recent
from donnie_tui.tui.recovering import Recovering
from donnie_tui.tui.running import Answer
from donnie_tui.tui.saving import Saving


class Files:
    """The programs of the editor and their files."""

    def __init__(
        self,
        desk: Desk,
        words: Wording,
        make_copies: Callable[[], Copies],
        in_use: FilesInUse,
        recent: Recent,
        kept_breakpoints: KeptBreakpoints,
    ) -> None:
        """``make_copies`` gives each program its own."""
        self._desk = desk
        self._words = words
        self._recent = recent
        self._kept_breakpoints = kept_breakpoints
        self.programs = OpenPrograms(desk, words, make_copies, in_use)
        self.saving = Saving(desk, words, self.programs, recent, kept_breakpoints)
        self.recovering = Recovering(desk, self.programs, self.saving, kept_breakpoints)

    @property
    def document(self) -> Document:
        """The file of what is in the editor."""
        return self.programs.document

    @property
    def name(self) -> str:
        return self.programs.name

    @property
    def is_changed(self) -> bool:
        return self.programs.is_changed

    @property
    def recent(self) -> tuple[Path, ...]:
        """What was opened and saved lately, the newest first."""
        return self._recent.paths()

    # --- several programs

    @property
    def open_programs(self) -> tuple[tuple[str, bool], ...]:
        """The title of each, and whether it is the one in the editor."""
        return self.programs.titles

    def turn_to(self, which: int | None) -> None:
        """Another one of the open programs, or one more, which is empty. No text is lost by it."""
        self._turn_to(self.programs.at(which))

    def _turn_to(self, program: Program) -> None:
        self.programs.keep_copy()
        self.programs.turn_to(program)
        self._desk.talk.tell(Answer("screen-turned-to", {"name": self.name}))

    async def are_safe_to_leave(self) -> bool:
        """Whether every open program may go."""
        await self.saving.is_done()  # so that what is being saved just now is known
        self.programs.take_from_desk()
        here = self.programs.current
        for program in (here, *(each for each in self.programs if each is not here)):
            if program.is_worth_keeping:
                if program is not here:
                    self._turn_to(program)
                if not await self.saving.is_safe_to_leave():
                    return False
        return True

    # --- opening

    async def open(self, name: str) -> None:
        """Open a file, asking for its name where none is given."""
        try:
            found = await self._read(name) if name else await self._asked_for()
        except DocumentError as error:
            self._desk.talk.tell(told(error))
            return
        if found is not None and await self.saving.is_safe_to_leave():
            self._opened(*found)

    def _opened(self, path: Path, text: str) -> None:
        self._become(path, text)
        self._recent.add(path)
        self._desk.talk.tell(Answer("answer-opened", {"name": path.name, "lines": text.count("\n") + 1}))
        if self._desk.breakpoints:
            lines = ", ".join(map(str, sorted(self._desk.breakpoints)))
            self._desk.talk.tell(Answer("break-lines", {"lines": lines}))

    async def _asked_for(self) -> tuple[Path, str] | None:
        """The file of a typed name; what is wrong with it is asked in its place. None: nothing is opened."""
        asked, name = self._words("ask-open"), ""
        while name := await self._desk.talk.ask(asked, value=name) or "":
            try:
                return await self._read(name)
            except DocumentError as error:
                asked = self._words(error.code, path=error.path, reason=error.reason)
        self._desk.talk.tell(Answer("answer-unchanged"))
        return None

    async def _read(self, name: str) -> tuple[Path, str]:
        """Beside the screen. Raises ``DocumentError``."""
        slow = Answer("slow-opening", {"name": Path(name).name or name})
        return await self._desk.talk.patiently(lambda: self.document.read(name), slow)

    async def new(self) -> None:
        if await self.saving.is_safe_to_leave():
            self._become(None, "")
            self._desk.talk.tell(Answer("answer-new"))

    def bring(self, text: str, name: str | None) -> None:
        """A program from the other mode: its file's name, and whatever it is now, saved or not."""
        path = Path(name) if name else None
        self._load(path, text.removesuffix("\n"))
        self.document.become(path, "")

    async def compare(self) -> None:
        """Whether the program that was brought is as its file has it; until then it counts as changed."""
        document = self.document
        path = document.path
        if path is not None:
            saved = await self._desk.talk.patiently(
                lambda: saved_text(path), Answer("slow-opening", {"name": path.name})
            )
            if document.path == path:
                document.become(path, saved)

    def _become(self, path: Path | None, text: str) -> None:
        self.programs.give_up_current()
        self._load(path, text)
        self.document.become(path, self._desk.text)

    def _load(self, path: Path | None, text: str) -> None:
        """With the breakpoints that the program had."""
        self._desk.load(text, self._kept_breakpoints.of(path, text.count("\n") + 1))

    def keep_breakpoints(self) -> None:
        """For the next time that this program is opened."""
        self._kept_breakpoints.keep(self.document.path, self._desk.breakpoints)
