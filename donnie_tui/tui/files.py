"""Opening, saving, beginning anew, recovering: what is asked, and what is answered.

Nothing that was typed is lost without a question; every failure is a sentence. The document and its copies
know no screen; this asks the person and tells the outcome.
"""

from __future__ import annotations

import asyncio
import contextlib
from collections.abc import Awaitable, Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Protocol, TypeVar

from donnie_tui.core.breakpoints import KeptBreakpoints
from donnie_tui.core.copies import Copies, Rescued
from donnie_tui.core.documents import DocumentError, program_to_save, read_program, write_program
from donnie_tui.core.filing import Document, as_lines
from donnie_tui.core.wording import Wording
from donnie_tui.tui.recent import Recent
from donnie_tui.tui.running import Answer
from language.source import fold_name

T = TypeVar("T")


class Desk(Protocol):
    """What a file is opened onto: an editor, and somebody to ask."""

    @property
    def text(self) -> str: ...

    @property
    def breakpoints(self) -> frozenset[int]: ...

    def load(self, text: str, breakpoints: frozenset[int] = frozenset()) -> None: ...

    def patiently(self, do: Callable[[], T], slow: Answer) -> Awaitable[T]: ...

    def tell(self, answer: Answer) -> None: ...

    def ask(
        self, asked: str, value: str = "", accepts: Callable[[str], str | None] | None = None
    ) -> Awaitable[str | None]: ...


@dataclass(slots=True)
class _Program:
    """One of the open programs; ``text`` is up to date while it is not in the editor."""

    document: Document
    copies: Copies
    text: str = ""
    breakpoints: frozenset[int] = frozenset()


class Files:
    """The file actions."""

    def __init__(
        self,
        desk: Desk,
        words: Wording,
        make_copies: Callable[[], Copies],
        recent: Recent | None = None,
        kept_breakpoints: KeptBreakpoints | None = None,
    ) -> None:
        """``make_copies`` gives each program a keeper of its own."""
        self._desk = desk
        self._words = words
        self._make_copies = make_copies
        self._copies = make_copies()
        self._offered = self._copies.all_offered()
        self._copying_failed = False
        self._bringing_up: dict[Copies, asyncio.Task[None]] = {}
        self._recent = recent
        self._kept_breakpoints = kept_breakpoints
        self.document = Document()
        self._saving = asyncio.Lock()
        self._programs = [_Program(self.document, self._copies)]
        self._at = 0

    @property
    def name(self) -> str:
        path = self.document.path
        return path.name if path else self._words("new-program")

    @property
    def is_changed(self) -> bool:
        return self.document.is_changed(self._desk.text)

    @property
    def offers_recovery(self) -> bool:
        return bool(self._offered)

    @property
    def recent(self) -> tuple[Path, ...]:
        """What was opened and saved lately, the newest first."""
        return self._recent.paths() if self._recent else ()

    # --- several programs

    @property
    def open_programs(self) -> tuple[tuple[str, bool], ...]:
        """The title of each, and whether it is the one in the editor."""
        self._programs[self._at].text = self._desk.text
        return tuple((self._title(each), at == self._at) for at, each in enumerate(self._programs))

    def _title(self, program: _Program) -> str:
        path = program.document.path
        name = path.name if path else self._words("new-program")
        code = "program-changed" if program.document.is_changed(program.text) else "program-kept"
        return self._words(code, name=name, lines=program.text.count("\n") + 1)

    def turn_to(self, which: int | None) -> None:
        """Another one of the open programs, or one more, which is empty. No text is lost by it."""
        self.keep_copy()
        before = self._programs[self._at]
        before.text, before.breakpoints = self._desk.text, self._desk.breakpoints
        if which is None:
            self._programs.append(_Program(Document(), self._make_copies()))
            which = len(self._programs) - 1
        self._at = which
        program = self._programs[which]
        self.document, self._copies = program.document, program.copies
        self._desk.load(program.text, program.breakpoints)
        self._desk.tell(Answer("screen-turned-to", {"name": self.name}))

    async def are_safe_to_leave(self) -> bool:
        """Whether every open program may go."""
        async with self._saving:
            pass  # so that what is being saved just now is known
        self._programs[self._at].text = self._desk.text
        others = (at for at in range(len(self._programs)) if at != self._at)
        for at in (self._at, *others):
            program = self._programs[at]
            if program.document.is_changed(program.text) and program.text.strip():
                if at != self._at:
                    self.turn_to(at)
                if not await self.is_safe_to_leave():
                    return False
        return True

    # --- opening

    async def open(self, name: str) -> None:
        """Open a file, asking for its name where none is given."""
        try:
            found = await self._read(name) if name else await self._asked_for()
        except DocumentError as error:
            self._desk.tell(_told(error))
            return
        if found is not None and await self.is_safe_to_leave():
            self._opened(*found)

    def _opened(self, path: Path, text: str) -> None:
        self._become(path, text)
        self._remember(path)
        self._desk.tell(Answer("answer-opened", {"name": path.name, "lines": text.count("\n") + 1}))
        if self._desk.breakpoints:
            lines = ", ".join(map(str, sorted(self._desk.breakpoints)))
            self._desk.tell(Answer("break-lines", {"lines": lines}))

    async def _asked_for(self) -> tuple[Path, str] | None:
        """The file of a typed name; what is wrong with it is asked in its place. None: nothing is opened."""
        asked, name = self._words("ask-open"), ""
        while name := await self._desk.ask(asked, value=name) or "":
            try:
                return await self._read(name)
            except DocumentError as error:
                asked = self._words(error.code, path=error.path, reason=error.reason)
        return None

    async def _read(self, name: str) -> tuple[Path, str]:
        """Beside the screen. Raises ``DocumentError``; that somebody asked for something else is told."""
        slow = Answer("slow-opening", {"name": Path(name).name or name})
        try:
            return await self._desk.patiently(lambda: self.document.read(name), slow)
        except asyncio.CancelledError:
            self._desk.tell(Answer("answer-unchanged"))
            raise

    async def new(self) -> None:
        if await self.is_safe_to_leave():
            self._become(None, "")
            self._desk.tell(Answer("answer-new"))

    def bring(self, text: str, name: str | None) -> None:
        """A program from the other mode: its file's name, and whatever it is now, saved or not."""
        path = Path(name) if name else None
        text = text.removesuffix("\n")
        self._desk.load(text, self._breakpoints_of(path, text))
        self.document.become(path, "")

    async def compare(self) -> None:
        """Whether the program that was brought is as its file has it; until then it counts as changed."""
        document = self.document
        path = document.path
        if path is not None:
            saved = await self._desk.patiently(
                lambda: _saved(path), Answer("slow-opening", {"name": path.name})
            )
            if document.path == path:
                document.become(path, saved)

    def _become(self, path: Path | None, text: str) -> None:
        self._forget(self._copies)
        self._desk.load(text, self._breakpoints_of(path, text))
        self.document.become(path, self._desk.text)

    def _breakpoints_of(self, path: Path | None, text: str) -> frozenset[int]:
        kept = self._kept_breakpoints
        return kept.of(path, text.count("\n") + 1) if kept else frozenset()

    def keep_breakpoints(self) -> None:
        """For the next time that this program is opened."""
        if self._kept_breakpoints is not None:
            self._kept_breakpoints.keep(self.document.path, self._desk.breakpoints)

    def _remember(self, path: Path) -> None:
        if self._recent is not None:
            self._recent.add(path)

    # --- saving

    async def save(self, name: str) -> bool:
        """Save, asking for a name where there is none. False if it was not saved."""
        if not name and self.document.path is not None:
            return await self._write(self.document.path)
        return await self.save_as(name)

    async def save_as(self, name: str) -> bool:
        own = str(self.document.path or "")
        name = name or await self._desk.ask(self._words("ask-save"), value=own) or ""
        if not name:
            return False
        try:
            path = self.document.place_for(name)
        except DocumentError as error:
            self._desk.tell(_told(error))
            return False
        if self.document.overwrites(path) and not await self._yes("ask-replace", path.name):
            self._desk.tell(Answer("answer-unchanged"))
            return False
        return await self._write(path)

    async def may_replace(self, path: Path) -> bool:
        """Whether nothing is there, or somebody wants it replaced; that it stays is told."""
        with contextlib.suppress(OSError, ValueError, RuntimeError):
            if path.expanduser().exists() and not await self._yes("ask-replace", path.name):
                self._desk.tell(Answer("answer-unchanged"))
                return False
        return True

    async def write_beside(self, name: str, text: str) -> None:
        """Another file than the program's; what was there is replaced only by somebody who wants it."""
        try:
            path = program_to_save(name)
            if not await self.may_replace(path):
                return
            slow = Answer("slow-report", {"name": path.name})
            await self._desk.patiently(lambda: write_program(path, text), slow)
        except DocumentError as error:
            self._desk.tell(_told(error))
        else:
            self._desk.tell(Answer("answer-written", {"name": path.name}))

    async def _write(self, path: Path) -> bool:
        """To its end, whatever is asked meanwhile."""
        return await asyncio.shield(asyncio.ensure_future(self._write_alone(path)))

    async def _write_alone(self, path: Path) -> bool:
        async with self._saving:
            return await self._write_now(path, self._programs[self._at], self._desk.text)

    async def _write_now(self, path: Path, program: _Program, text: str) -> bool:
        """A slow disk holds nobody up; whatever is typed meanwhile is not saved, and has its copy."""
        document = program.document
        slow = Answer("slow-saving", {"name": path.name})
        try:
            await self._desk.patiently(lambda: document.write(path, text), slow)
        except DocumentError as error:
            self._desk.tell(_told(error))
            return False
        if self._desk.text == text and self.document is document:
            self._forget(program.copies)
            self.keep_breakpoints()
        self._remember(path)
        self._desk.tell(Answer("answer-saved", {"name": path.name, "lines": text.count("\n") + 1}))
        return True

    async def is_safe_to_leave(self) -> bool:
        """Whether the text may go: it is saved, or was offered to be; what is typed meanwhile too."""
        while True:
            async with self._saving:
                pass  # what is being saved just now is not asked about
            if not self.is_changed or not self._desk.text.strip():
                return True
            answer = await self._yes("ask-unsaved", self.name)
            if not answer:
                return answer is False
            if not await self.save(""):
                return False

    async def _yes(self, asked: str, name: str) -> bool | None:
        """The answer to a question, None if somebody went back."""
        question = self._words(asked, name=name)

        def unclear(typed: str) -> str | None:
            return None if self._understood(typed) is not None else f"{self._words('ask-yes-no')} {question}"

        typed = await self._desk.ask(question, accepts=unclear)
        return None if typed is None else self._understood(typed)

    def _understood(self, typed: str) -> bool | None:
        folded = fold_name(typed)
        if folded in map(fold_name, self._words("answers-yes").split()):
            return True
        return False if folded in map(fold_name, self._words("answers-no").split()) else None

    # --- copies

    def keep_copy(self) -> None:
        """Have what is not saved written down, beside the screen; told once if that fails."""
        self._want_copy()
        self._bring_up(self._copies)

    def keep_copy_now(self) -> None:
        """As ``keep_copy``, done once this returns: for whoever leaves. Quietly: who would hear it?"""
        self._want_copy()
        self.settle()

    def settle(self) -> None:
        """What is still to be written down or removed, of any program: done once this returns."""
        for program in self._programs:
            with contextlib.suppress(DocumentError):
                program.copies.settle()

    def _want_copy(self) -> None:
        text = self._desk.text
        if self.is_changed and text.strip():
            self._copies.want(text, self.document.path)
        else:
            self._copies.want_none()

    def _forget(self, copies: Copies) -> None:
        copies.want_none()
        self._bring_up(copies)

    def _bring_up(self, copies: Copies) -> None:
        """One at a time for each program, however slow the disk is."""
        if copies not in self._bringing_up:
            self._bringing_up[copies] = asyncio.ensure_future(self._settle(copies))

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
        if not self._copying_failed:
            self._copying_failed = True
            self._desk.tell(Answer("answer-not-kept", {"reason": error.reason}))

    def give_up(self) -> None:
        """Leaving on purpose: no copy is needed."""
        for program in self._programs:
            self._forget(program.copies)

    async def recover(self) -> None:
        """Bring back what an earlier start left unsaved, the newest first; others one by one."""
        if not self._offered:
            self._desk.tell(Answer("answer-nothing-to-recover"))
            return
        copy = self._offered[0]
        try:
            found, saved = await self._desk.patiently(
                lambda: self._read_copy(copy), Answer("slow-opening", {"name": copy.name})
            )
        except DocumentError as error:
            self._desk.tell(_told(error))
            return
        if await self.is_safe_to_leave() and copy in self._offered:
            self._recovered(copy, found, saved)

    def _read_copy(self, copy: Path) -> tuple[Rescued, str]:
        """What it holds, and what its file has now."""
        found = self._copies.read(copy)
        return found, _saved(found.path) if found.path is not None else ""

    def _recovered(self, copy: Path, found: Rescued, saved: str) -> None:
        self._offered.remove(copy)
        self._desk.load(found.text, self._breakpoints_of(found.path, found.text))
        self.document.become(found.path, saved)
        self._copies.want(found.text, found.path, instead_of=copy)
        self._bring_up(self._copies)
        code = "answer-recovered" if found.path is None else "answer-recovered-file"
        self._desk.tell(Answer(code, {"lines": found.text.count("\n") + 1, "name": self.name}))
        if self._offered:
            self._desk.tell(Answer("answer-rescued"))


def _saved(path: Path) -> str:
    """The text of a file as the editor would hold it; empty where it can't be read."""
    try:
        return as_lines(read_program(path))
    except DocumentError:
        return ""


def _told(error: DocumentError) -> Answer:
    values: Mapping[str, object] = {"path": error.path, "reason": error.reason}
    return Answer(error.code, values)
