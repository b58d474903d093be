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
from donnie_tui.core.documents import DocumentError, program_to_save, write_program
from donnie_tui.core.filing import Copies, Document
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
        name = name or await self._desk.ask(self._words("ask-open"), accepts=self._wrong_to_open) or ""
        if name and await self.is_safe_to_leave():
            self.open_now(name)

    def open_now(self, name: str) -> bool:
        """Open a file without asking anything. False if it could not be read, which was told."""
        try:
            path, text = self.document.read(name)
        except DocumentError as error:
            self._desk.tell(_told(error))
            return False
        self._become(path, text)
        self._remember(path)
        self._desk.tell(Answer("answer-opened", {"name": path.name, "lines": text.count("\n") + 1}))
        if self._desk.breakpoints:
            lines = ", ".join(map(str, sorted(self._desk.breakpoints)))
            self._desk.tell(Answer("break-lines", {"lines": lines}))
        return True

    def _wrong_to_open(self, name: str) -> str | None:
        try:
            if name:
                self.document.read(name)
        except DocumentError as error:
            answer = _told(error)
            return self._words(answer.code, **answer.values)
        return None

    async def new(self) -> None:
        if await self.is_safe_to_leave():
            self._become(None, "")
            self._desk.tell(Answer("answer-new"))

    def bring(self, text: str, name: str | None) -> None:
        """A program from the other mode: its file's name, and whatever it is now, saved or not."""
        path = Path(name) if name else None
        saved = ""
        if path is not None:
            try:
                _, saved = self.document.read(name or "")
            except DocumentError:
                saved = ""
        self._become(path, saved)
        text = text.removesuffix("\n")
        self._desk.load(text, self._breakpoints_of(path, text))

    def _become(self, path: Path | None, text: str) -> None:
        self._copies.forget()
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
            program.copies.forget()
            self.keep_breakpoints()
        self._remember(path)
        self._desk.tell(Answer("answer-saved", {"name": path.name, "lines": text.count("\n") + 1}))
        return True

    async def is_safe_to_leave(self) -> bool:
        """Whether the text may go: it is saved, or was offered to be."""
        async with self._saving:
            pass  # what is being saved just now is not asked about
        if not self.is_changed or not self._desk.text.strip():
            return True
        answer = await self._yes("ask-unsaved", self.name)
        if answer is None:
            return False
        return await self.save("") if answer else True

    async def _yes(self, asked: str, name: str) -> bool | None:
        """The answer to a question, None if somebody went back."""
        question = self._words(asked, name=name)

        def unclear(typed: str) -> str | None:
            return None if self._understood(typed) is not None else question

        typed = await self._desk.ask(question, accepts=unclear)
        return None if typed is None else self._understood(typed)

    def _understood(self, typed: str) -> bool | None:
        folded = fold_name(typed)
        if folded in map(fold_name, self._words("answers-yes").split()):
            return True
        return False if folded in map(fold_name, self._words("answers-no").split()) else None

    # --- copies

    def keep_copy(self) -> None:
        """Write down what is not saved; told once if that fails."""
        text = self._desk.text
        if not self.is_changed or not text.strip():
            self._copies.forget()
            return
        try:
            self._copies.keep(text)
        except DocumentError as error:
            if not self._copying_failed:
                self._copying_failed = True
                self._desk.tell(Answer("answer-not-kept", {"reason": error.reason}))

    def give_up(self) -> None:
        """Leaving on purpose: no copy is needed."""
        for program in self._programs:
            program.copies.forget()

    async def recover(self) -> None:
        """Bring back what an earlier start left unsaved, the newest first; others one by one."""
        if not self._offered:
            self._desk.tell(Answer("answer-nothing-to-recover"))
        elif await self.is_safe_to_leave():
            self._recover_now(self._offered[0])

    def _recover_now(self, copy: Path) -> None:
        try:
            text = self._copies.take(copy)
        except DocumentError as error:
            self._desk.tell(_told(error))
            return
        self._offered = self._offered[1:]
        self.document.become(None, "")
        self._desk.load(text)
        self._desk.tell(Answer("answer-recovered", {"lines": text.count("\n") + 1}))
        if self._offered:
            self._desk.tell(Answer("answer-rescued"))


def _told(error: DocumentError) -> Answer:
    values: Mapping[str, object] = {"path": error.path, "reason": error.reason}
    return Answer(error.code, values)
