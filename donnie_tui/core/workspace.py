"""The workspace: all open documents, their files, and the copies that keep them safe.

Rule: no typed line is lost, whether the power fails, Donnie is killed, the terminal goes away, or NEW and
OPEN replace a program. What is not saved is written to the state folder in the background. RECOVER opens,
in this order: what a crash left, what was replaced in this session, what a learner left without saving.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from functools import cached_property
from typing import TYPE_CHECKING

from donnie_tui.core.document import Document
from donnie_tui.core.editing import TextEditor, UnsavedText
from donnie_tui.core.program_files import BreakpointFile

if TYPE_CHECKING:
    from pathlib import Path

    from donnie_tui.core.program_files import DocumentError, RecentFiles
    from donnie_tui.core.recovery import CopyFolder, CopyWriter, UnsavedCopy

MOST_REPLACED, MOST_PUT_AWAY = 5, 20
"""Replaced programs of which copies are kept, and of those that were put away without a question."""


class Workspace:
    """The documents. In the linear mode each robot has its own; the full screen shows one of several."""

    def __init__(self, copies: str, breakpoints: str, recent: str) -> None:
        """The folder of the copies, the file of breakpoints, and the file of what was used lately."""
        self.document = Document()
        """The document that commands work with."""
        self.documents = [self.document]
        """All of them, in the order in which they were opened."""
        self._editor: TextEditor | None = None
        """Where the current document is shown and edited."""
        self.searched = ""
        """What SEARCH looked for last."""
        self.report_failure: Callable[[DocumentError], object] = lambda _: None
        """Called once, in another thread, if copies can't be written."""
        self._copies_name, self._recent_name = copies, recent
        self._breakpoint_file = BreakpointFile(breakpoints)
        self._robot = ""
        self._by_robot: dict[str, Document] = {}
        """The documents of the other robots that the learner has chosen before."""
        self._copies: dict[Document, UnsavedCopy] = {}
        self._copies_of_replaced: dict[UnsavedText, UnsavedCopy] = {}
        self._removals: list[UnsavedCopy] = []
        """Copies that may still have to be removed from the disk."""
        self._kept: object = ()
        """What was not saved when the copies were last written."""
        self._is_finished = False
        self._put_away: list[UnsavedText] = []
        """The unsaved programs that a challenge put away, the oldest first."""
        self.challenge = ""
        """The name of the challenge that the learner left last."""
        self._taken: set[Path | UnsavedText] = set()
        """What was recovered since the start."""

    # --- the documents

    def add_document(self) -> Document:
        """Add an empty document."""
        self.documents.append(Document())
        return self.documents[-1]

    def attach(self, editor: TextEditor) -> None:
        """Show the current document in an editor, and every later current one."""
        self._editor = editor
        self.document.attach(editor)

    def detach(self) -> None:
        """Stop showing documents in the editor."""
        self._editor = None
        self.document.detach()

    def turn_to(self, document: Document) -> None:
        """Make another one the current document."""
        self.document.detach()
        self.document = document
        if self._editor is not None:
            document.attach(self._editor)

    @property
    def current_first(self) -> tuple[Document, ...]:
        """All documents, the current one first."""
        return (self.document, *(each for each in self.documents if each is not self.document))

    @property
    def files(self) -> tuple[Path | None, ...]:
        """The files of all documents; None for one without a file."""
        return tuple(each.path for each in self.documents)

    @contextmanager
    def as_current(self, document: Document) -> Iterator[None]:
        """Makes it the current document inside the ``with`` block."""
        before, self.document = self.document, document
        try:
            yield
        finally:
            self.document = before

    # --- robots

    def begin_with(self, robot: str) -> None:
        """Give the current document to ``robot``, the current robot of a new world.

        Other documents are kept for robots of the same names; a robot of this name gets a new one.
        """
        others = {name: each for name, each in self.by_robot().items() if each is not self.document}
        self._by_robot = {f"{name} 2" if name == robot else name: each for name, each in others.items()}
        self._robot = robot

    def choose_robot(self, robot: str) -> None:
        """Make the document of another robot the current one."""
        self._by_robot[self._robot] = self.document
        self._robot = robot
        if robot not in self._by_robot:
            self._by_robot[robot] = self.add_document()
        self.turn_to(self._by_robot[robot])

    def by_robot(self) -> dict[str, Document]:
        """The documents of all robots that were chosen so far."""
        return {**self._by_robot, self._robot: self.document} if self._robot else {}

    # --- files

    @cached_property
    def recent(self) -> RecentFiles:
        """The programs that were opened and saved lately."""
        from donnie_tui.core.program_files import RecentFiles

        return RecentFiles(self._recent_name)

    def open(self, path: Path, text: str) -> None:
        """Replace the current document by the text of a file."""
        self.replace(text, path)
        self.recent.add(path)

    def replace(
        self, text: str, path: Path | None, *, in_file: str | None = None, keeps_empty: bool = False
    ) -> None:
        """Put another program in place of the current one, with the breakpoints that it had."""
        document = self.document
        document.replace(text, path, in_file=in_file, keeps_empty=keeps_empty)
        if path is not None:
            document.breakpoints = self._breakpoint_file.read(path, len(document.lines))

    def put_away(self) -> int:
        """Begin with an empty program for every robot. UNDO and RECOVER restore the old ones.

        Returns how many lines the current program had.
        """
        lines = len(self.document.lines)
        for document in dict.fromkeys((self.document, *self.by_robot().values())):
            if not document.is_saved:
                self._put_away = [*self._put_away, UnsavedText(document.text, document.path)][-MOST_PUT_AWAY:]
            document.replace("", None)
        return lines

    def save(self, document: Document, path: Path, text: str) -> None:
        """Write ``text``, the document's text at the time of the request. Raises ``DocumentError``."""
        from donnie_tui.core.program_files import write_program

        write_program(path, text)
        document.mark_saved(path, text)
        self.recent.add(path)
        if document.is_saved:
            self._breakpoint_file.write(path, document.breakpoints)

    def keep_breakpoints(self) -> None:
        """Keep the breakpoints of the current document until it is opened again."""
        self._breakpoint_file.write(self.document.path, self.document.breakpoints)

    # --- recovering

    @cached_property
    def _folder(self) -> CopyFolder:
        from donnie_tui.core.recovery import CopyFolder  # once something is typed

        return CopyFolder(self._copies_name)

    def rescued(self) -> list[Path]:
        """The copies that a start offers and that were not recovered yet."""
        return [each for each in self._folder.rescued() if each not in self._taken]

    def recoverable(self) -> Path | UnsavedText | None:
        """What RECOVER opens next: a copy of an earlier start, or a program that was replaced in this one."""
        left = [each for each in self._folder.left() if each not in self._taken]
        found: list[Path | UnsavedText] = [*self.rescued(), *reversed(self._replaced()), *left]
        return next((each for each in found if each not in self._taken), found[0] if found else None)

    def read_recoverable(self, found: Path | UnsavedText) -> tuple[UnsavedText, str]:
        """The program, and the text that its file has now. Raises ``DocumentError``."""
        from donnie_tui.core.program_files import saved_text
        from donnie_tui.core.recovery import read_copy

        program = found if isinstance(found, UnsavedText) else read_copy(found)
        return program, saved_text(program.path) if program.path is not None else ""

    def recover(self, found: Path | UnsavedText, program: UnsavedText, in_file: str) -> None:
        """Put a recovered program in place of the current one. It is saved if its file has the same text."""
        self.replace(program.text, program.path, in_file=in_file, keeps_empty=True)
        self._taken.add(found)
        if isinstance(found, UnsavedText):
            self._put_away = [each for each in self._put_away if each != found]
        else:
            self._copy_of(self.document).want(self.document.text, program.path, instead_of=found)
        self.keep_copies()

    def _replaced(self) -> list[UnsavedText]:
        """The unsaved programs that were replaced, the newest last."""
        present = {UnsavedText(each.text, each.path) for each in self.documents}
        found = [
            each for document in self.documents for each in document.versions.replaced if each not in present
        ]
        by_learner = list(dict.fromkeys(found))[-MOST_REPLACED:]
        put_away = [each for each in self._put_away if each not in present and each not in by_learner]
        return [*dict.fromkeys(put_away), *by_learner]

    # --- copies

    def keep_copies(self) -> bool:
        """Write the unsaved programs in the background. Returns whether there was anything to write."""
        unsaved = (
            *((each.text, each.path) for each in self.documents if not each.is_saved),
            *self._replaced(),
        )
        if self._is_finished or unsaved == self._kept:
            return False
        self._kept = unsaved
        self._writer.write(self._updated_copies())
        return True

    def write_copies(self) -> None:
        """As ``keep_copies``, but returns only after the writing. Ignores failures, since Donnie ends."""
        if not self._is_finished:
            self._updated_copies()
        for copy in (*self._copies_of_replaced.values(), *self._copies.values(), *self._removals):
            copy.write_quietly()

    def leave_copies(self, *, everything: bool = True) -> None:
        """Leaves copies for RECOVER of what is unsaved when the learner quits.

        That start offers only a program that was kept without a question, and it offers it once.

        ``everything``: else only programs that came out of a copy, as in a script, whose lines are in a file.
        """
        documents = self.documents if everything else list(self._copies)
        self._updated_copies(documents, with_replaced=everything)
        if everything:
            self._folder.withdraw_offers(self._taken)
        for copy in self._copies_of_replaced.values():
            copy.leave()
        for document, copy in self._copies.items():
            copy.leave(is_offered=everything and document.is_kept_unasked)
        self._is_finished = True

    def hand_over(self) -> None:
        """Hands the current program to the other front end, which offers the others to recover."""
        self._updated_copies()
        for copy in self._copies_of_replaced.values():
            copy.leave()
        self._copy_of(self.document).want_none()
        self._is_finished = True
        self.write_copies()

    @cached_property
    def _writer(self) -> CopyWriter:
        from donnie_tui.core.recovery import CopyWriter

        return CopyWriter(lambda error: self.report_failure(error))

    def _updated_copies(
        self, documents: Iterable[Document] | None = None, *, with_replaced: bool = True
    ) -> list[UnsavedCopy]:
        """All copies, which know what is wanted of them; those of replaced programs are written first."""
        documents = self.documents if documents is None else documents
        replaced = self._replaced() if with_replaced else []
        known = self._copies_of_replaced
        self._removals = [each for each in self._removals if each.is_outdated]
        for program in [each for each in known if each not in replaced]:
            self._removals.append(known.pop(program))
            self._removals[-1].want_none()
        for program in replaced:
            if program not in known:
                known[program] = self._new_copy()
                known[program].follow(program.text, program.path, is_saved=False)
        for each in documents:
            self._copy_of(each).follow(each.text, each.path, is_saved=each.is_saved)
        return [*known.values(), *self._copies.values(), *self._removals]

    def _copy_of(self, document: Document) -> UnsavedCopy:
        if document not in self._copies:
            self._copies[document] = self._new_copy()
        return self._copies[document]

    def _new_copy(self) -> UnsavedCopy:
        from donnie_tui.core.recovery import UnsavedCopy

        return UnsavedCopy(self._folder)
