"""The programs that are open, of which the editor has one: each with its file, and its copy."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path

from donnie_tui.core.copies import Copies, CopyKeeping, Rescued
from donnie_tui.core.documents import Document, DocumentError
from donnie_tui.core.in_use import FilesInUse
from donnie_tui.core.wording import Wording
from donnie_tui.tui.desk import Desk
from donnie_tui.tui.running import Answer


@dataclass(slots=True, eq=False)
class Program:
    """One of the open programs; ``text`` is up to date while it is not in the editor."""

    document: Document
    copies: Copies
    text: str = ""
    breakpoints: frozenset[int] = frozenset()

    @property
    def is_worth_keeping(self) -> bool:
        """Whether there is something in it that no file has."""
        return self.document.is_changed(self.text) and bool(self.text.strip())


class OpenPrograms:
    """All of them, and which one is in the editor."""

    def __init__(
        self, desk: Desk, words: Wording, make_copies: Callable[[], Copies], in_use: FilesInUse
    ) -> None:
        """``make_copies`` gives each program its own."""
        self._desk = desk
        self._words = words
        self._make_copies = make_copies
        self.in_use = in_use
        self._keeping = CopyKeeping(self._tell_not_kept)
        self._programs = [Program(Document(in_use), make_copies())]
        self.current = self._programs[0]
        """The one in the editor."""
        self._are_left = False
        self._given_up: list[Copies] = []
        """Of what another program took the place of."""

    def __iter__(self) -> Iterator[Program]:
        return iter(tuple(self._programs))

    @property
    def document(self) -> Document:
        return self.current.document

    @property
    def files(self) -> tuple[Path | None, ...]:
        """Of all of them; None of one that has none."""
        return tuple(each.document.path for each in self._programs)

    @property
    def name(self) -> str:
        """What the program in the editor is called."""
        return self._name_of(self.current)

    @property
    def is_changed(self) -> bool:
        return self.document.is_changed(self._desk.text)

    def _name_of(self, program: Program) -> str:
        path = program.document.path
        return path.name if path else self._words("new-program")

    @property
    def titles(self) -> tuple[tuple[str, bool], ...]:
        """Of each, and whether it is the one in the editor."""
        self.take_from_desk()
        return tuple((self._title(each), each is self.current) for each in self._programs)

    def _title(self, program: Program) -> str:
        code = "program-changed" if program.document.is_changed(program.text) else "program-kept"
        return self._words(code, name=self._name_of(program), lines=program.text.count("\n") + 1)

    def take_from_desk(self) -> None:
        """What the editor has now is the current one's."""
        self.current.text, self.current.breakpoints = self._desk.text, self._desk.breakpoints

    def at(self, which: int | None) -> Program:
        """By its place in the list; None is one more, which is empty."""
        if which is None:
            self._programs.append(Program(Document(self.in_use), self._make_copies()))
            return self._programs[-1]
        return self._programs[which]

    def turn_to(self, program: Program) -> None:
        """Have another one in the editor. No text is lost by it."""
        self.take_from_desk()
        self.current = program
        self._desk.load(program.text, program.breakpoints)

    # --- the copies of what is not saved, for the case of a crash

    def keep_copy(self) -> None:
        """Have what is not saved of the current one written down, beside the screen."""
        self._follow()
        self._keeping.bring_up(self.current.copies)

    def keep_copy_now(self) -> None:
        """As ``keep_copy``, done once this returns: for whoever leaves."""
        self._follow()
        self.settle_copies()

    def settle_copies(self) -> None:
        """What is still to be written down or removed, of any program: done once this returns."""
        for copies in (*(each.copies for each in self._programs), *self._given_up):
            copies.settle_quietly()
        if self._are_left:
            for each in self._programs:
                each.copies.leave()

    def leave_copies(self) -> None:
        """Leaving on purpose: once they are settled, what is not saved can be asked for the next time."""
        self.take_from_desk()
        for each in self._programs:
            is_saved = not each.document.is_changed(each.text)
            each.copies.follow(each.text, each.document.path, is_saved=is_saved)
        self._are_left = True

    def give_up_current(self) -> None:
        """Another text takes its place: what no file has of it can be asked for."""
        given_up = self.current.copies
        self._follow()
        given_up.give_up()
        self._given_up = [each for each in (*self._given_up, given_up) if each.is_behind]
        self.current.copies = self._make_copies()
        self._keeping.bring_up(given_up)

    def keep_rescued(self, rescued: Rescued, copy: Path) -> None:
        """The current one came out of a copy of an earlier start, which is removed once it has its own."""
        self.current.copies.want(rescued.text, rescued.path, instead_of=copy)
        self._keeping.bring_up(self.current.copies)

    def forget_copy(self, program: Program) -> None:
        """Its text is safe elsewhere, or given up."""
        self._keeping.forget(program.copies)

    def forget_copies(self) -> None:
        """Leaving on purpose: none is needed."""
        for program in self._programs:
            self.forget_copy(program)

    def _tell_not_kept(self, error: DocumentError) -> None:
        self._desk.talk.tell(Answer("answer-not-kept", {"reason": error.reason}))

    def _follow(self) -> None:
        self.current.copies.follow(self._desk.text, self.document.path, is_saved=not self.is_changed)
