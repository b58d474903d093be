"""The programs that are open, of which the editor has one: each with its file, and its copy."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass

from donnie_tui.core.copies import Copies
from donnie_tui.core.filing import Document
from donnie_tui.core.wording import Wording
from donnie_tui.tui.desk import Desk


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

    def __init__(self, desk: Desk, words: Wording, make_copies: Callable[[], Copies]) -> None:
        """``make_copies`` gives each program a keeper of its own."""
        self._desk = desk
        self._words = words
        self._make_copies = make_copies
        self._programs = [Program(Document(), make_copies())]
        self.current = self._programs[0]
        """The one in the editor."""

    def __iter__(self) -> Iterator[Program]:
        return iter(tuple(self._programs))

    @property
    def document(self) -> Document:
        return self.current.document

    @property
    def copies(self) -> Copies:
        return self.current.copies

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
            self._programs.append(Program(Document(), self._make_copies()))
            return self._programs[-1]
        return self._programs[which]

    def turn_to(self, program: Program) -> None:
        """Have another one in the editor. No text is lost by it."""
        self.take_from_desk()
        self.current = program
        self._desk.load(program.text, program.breakpoints)
