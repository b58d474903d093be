"""Copies of programs that are not saved, written in the background, so that a crash loses no typed line.

There is one file a program in the state folder. It is removed once the program is saved. A learner who
leaves without saving leaves the copy in the folder. RECOVER opens it; the next start mentions it only if the
learner was not asked whether to save the program.

Rule: the learner never waits for the disk. ``UnsavedCopy.want`` sets what is to be on disk, ``write`` brings
the disk up to it, in any thread, and the last text that was wanted is the one on disk at the end.
``CopyWriter`` writes in a thread of its own, which runs only while there is something to write.
"""

from __future__ import annotations

import contextlib
import os
import sys
import threading
from collections.abc import Callable, Container, Iterable
from typing import TYPE_CHECKING

from donnie_tui.core.editing import UnsavedText
from donnie_tui.core.program_files import DocumentError, as_lines, new_file, read_program, write_program
from donnie_tui.process.confinement import check_own, make_folder

if TYPE_CHECKING:
    from pathlib import Path

MOST_COPIES = 20
"""Copies of each kind that are kept; the oldest are removed first."""

_PREFIX, _SUFFIX = "unsaved-", ".gd"
_KEPT = "kept-"
"""The prefix of a copy that its learner left without a question: the next start offers it."""
_LEFT = "left-"
"""The prefix of a copy that its learner gave up, or did not open at the next start."""
_FILE = "-- What was not saved of the file: "
"""The first line of a copy, with the path of the program's file; a comment of the language."""


class CopyFolder:
    """The folder of the copies: those of this start, and those that earlier starts left. Thread-safe."""

    def __init__(self, name: str) -> None:
        self.name = name
        self.in_use: set[Path] = set()
        """The copies of this start's programs."""
        self._naming = threading.Lock()
        """Held while a copy of this start is made: it is not one that an earlier start left."""

    def rescued(self) -> list[Path]:
        """The copies that a start offers, the newest of each kind first.

        A crash or a lost connection left them, or a learner who was asked nothing at the start before.
        """
        with self._naming:
            found = self.newest_first(_PREFIX)
        crashed = [
            each for each in found if each not in self.in_use and _has_text(each) and not _is_in_use(each)
        ]
        return crashed + self.newest_first(_KEPT)

    def left(self) -> list[Path]:
        """The copies that a learner left on purpose, the newest first."""
        return self.newest_first(_LEFT)

    def offered(self) -> list[Path]:
        """The copies that RECOVER opens, in this order: ``rescued``, then ``left``."""
        return self.rescued() + self.left()

    def new_copy(self) -> Path:
        """An empty file for one more program. Raises ``OSError``."""
        folder = _path(self.name)
        make_folder(folder)
        with self._naming:
            handle, copy = new_file(folder, _PREFIX, _SUFFIX)
            self.in_use.add(copy)
        os.close(handle)
        _remove_oldest(each for each in self.newest_first(_PREFIX) if not _is_in_use(each))
        return copy

    def leave(self, copy: Path, *, is_offered: bool = False) -> None:
        """Rename a copy to one that its learner left, and that the next start offers, or not.

        It is the newest of them.
        """
        self.in_use.discard(copy)
        prefix = _KEPT if is_offered else _LEFT
        with contextlib.suppress(OSError):
            _make_newest(copy, self.newest_first(prefix))
            copy.rename(copy.with_name(prefix + copy.name.split("-", 1)[1]))
        _remove_oldest(self.newest_first(prefix))

    def withdraw_offers(self, opened: Container[object]) -> None:
        """Stop offering the copies of the start before, except those ``opened``; RECOVER still finds them."""
        for each in reversed(self.newest_first(_KEPT)):
            if each not in opened:
                self.leave(each)

    def newest_first(self, prefix: str) -> list[Path]:
        found: list[tuple[int, str]] = []
        with contextlib.suppress(OSError):
            check_own(self.name)
            with os.scandir(self.name) as entries:
                for each in entries:
                    if each.name.startswith(prefix) and each.name.endswith(_SUFFIX):
                        with contextlib.suppress(FileNotFoundError):  # removed in the meantime
                            found.append((each.stat().st_mtime_ns, each.path))
        return [_path(each) for _, each in sorted(found, reverse=True)]


class UnsavedCopy:
    """The copy of one program. Any thread may call it."""

    def __init__(self, folder: CopyFolder) -> None:
        self._folder = folder
        self._file: Path | None = None
        self._wanted: UnsavedText | None = None
        self._superseded: list[Path] = []
        """Copies of earlier starts whose text this copy holds now."""
        self.is_outdated = False
        """Whether the disk is not yet as it is wanted."""
        self._is_left = self._is_offered = False
        self._writing = threading.Lock()

    @property
    def is_removal(self) -> bool:
        """Whether to write it removes a file and nothing else."""
        return self._wanted is None

    # --- what is wanted

    def want(self, text: str, path: Path | None = None, *, instead_of: Path | None = None) -> None:
        """Ask for this text to be on disk from now on. ``instead_of``: a copy that is removed afterwards."""
        if instead_of is not None:
            self._superseded.append(instead_of)
        self._wanted = UnsavedText(text, path)
        self.is_outdated = True

    def want_none(self) -> None:
        """The program is saved, or given up."""
        self._wanted = None
        self.is_outdated = True

    def follow(self, text: str, path: Path | None = None, *, is_saved: bool) -> None:
        """Ask for the text to be on disk from now on, unless it is saved or blank."""
        if is_saved or not text.strip():
            self.want_none()
        else:
            self.want(text, path)

    def leave(self, *, is_offered: bool = False) -> None:
        """Leave the copy for RECOVER once it is written: this start has finished with the program.

        ``is_offered``: the next start mentions it.
        """
        self._is_left = self.is_outdated = True
        self._is_offered = is_offered

    # --- writing

    def write(self) -> None:
        """Bring the disk up to what is wanted by then. Raises ``DocumentError``."""
        with self._writing:
            while self.is_outdated:
                self.is_outdated = False  # first: what is wanted during the write needs one more round
                self._update(self._wanted)
            if self._is_left and self._file is not None:
                left, self._file = self._file, None
                self._folder.leave(left, is_offered=self._is_offered)

    def write_quietly(self) -> None:
        """As ``write``, at an end where a failure can't be reported any more."""
        with contextlib.suppress(DocumentError, OSError):
            self.write()

    def _update(self, wanted: UnsavedText | None) -> None:
        if wanted is not None:
            self._write(wanted)
        elif self._file is not None:
            unwanted, self._file = self._file, None
            with contextlib.suppress(OSError):
                unwanted.unlink()
            self._folder.in_use.discard(unwanted)
        while self._superseded:
            with contextlib.suppress(OSError):
                self._superseded.pop().unlink()

    def _write(self, wanted: UnsavedText) -> None:
        try:
            file = self._file = self._file or self._folder.new_copy()
        except OSError as problem:
            reason = problem.strerror or str(problem)
            raise DocumentError("file-unwritable", self._folder.name, reason) from None
        write_program(file, _with_file_line(wanted))


class CopyWriter:
    """Writes copies in the background, one after the other; removals come last."""

    def __init__(self, report: Callable[[DocumentError], object]) -> None:
        """``report`` is called once, in the thread that writes, with the reason why it fails."""
        self._report, self._has_failed = report, False
        self._lock = threading.Lock()
        self._pending: dict[UnsavedCopy, None] = {}
        self._is_running = False

    def write(self, copies: Iterable[UnsavedCopy]) -> None:
        """Write what is wanted of these. Any thread may call it."""
        with self._lock:
            self._pending.update(dict.fromkeys(each for each in copies if each.is_outdated))
            if self._is_running or not self._pending:
                return
            self._is_running = True
        threading.Thread(target=self._run, name="copies", daemon=True).start()

    def _run(self) -> None:
        while (copy := self._next()) is not None:
            try:
                copy.write()
            except DocumentError as error:
                if not self._has_failed:
                    self._has_failed = True
                    self._report(error)

    def _next(self) -> UnsavedCopy | None:
        """A text that came back from one copy to another is removed only once it is written there."""
        with self._lock:
            found = min(self._pending, key=lambda each: each.is_removal, default=None)
            if found is None:
                self._is_running = False
            else:
                del self._pending[found]
            return found


def read_copy(copy: Path) -> UnsavedText:
    """Read a copy and change nothing. Raises ``DocumentError``."""
    text = as_lines(read_program(copy))
    first, _, rest = text.partition("\n")
    if not first.startswith(_FILE):
        return UnsavedText(text)
    name = first.removeprefix(_FILE)
    return UnsavedText(rest, _path(name) if name else None)


def _with_file_line(wanted: UnsavedText) -> str:
    """The text of the copy. A path that does not fit into a line of text is left out."""
    name = ""
    with contextlib.suppress(OSError):  # the working folder was removed
        name = str(wanted.path.absolute()) if wanted.path is not None else ""
    if not name.isprintable():
        name = ""
    return f"{_FILE}{name}\n{wanted.text}" if name or wanted.text.startswith(_FILE) else wanted.text


def _path(name: str) -> Path:
    from pathlib import Path  # slow to load, and most starts find no copy

    return Path(name)


def _make_newest(copy: Path, newest_first: list[Path]) -> None:
    """Gives the copy a time that is later than that of any other."""
    newest = 1 + max(each.stat().st_mtime_ns for each in (copy, *newest_first[:1]))
    os.utime(copy, ns=(newest, newest))


def _remove_oldest(newest_first: Iterable[Path]) -> None:
    for old in [*newest_first][MOST_COPIES:]:
        with contextlib.suppress(OSError):
            old.unlink()


def _has_text(copy: Path) -> bool:
    """False for one that was made just before a sudden end, and never written."""
    try:
        return copy.stat().st_size > 0
    except OSError:
        return False


def _is_in_use(copy: Path) -> bool:
    """Whether another process that still runs keeps this copy; its number is in the name."""
    number = copy.name.removeprefix(_PREFIX).partition("-")[0]
    if os.name != "posix" or not number.isdecimal() or int(number) in (0, os.getpid()):
        return False
    return _is_donnie(number) if sys.platform == "linux" else _is_running(int(number))


def _is_donnie(number: str) -> bool:
    """False for a process that ended and was not collected, and for another program with its number."""
    try:
        words = _path(f"/proc/{number}/cmdline").read_bytes().lower().split(b"\0")
    except OSError:
        return False
    return any(b"donnie" in each for each in words[1:])


def _is_running(number: int) -> bool:
    try:
        os.kill(number, 0)
    except PermissionError:
        return True
    except (OSError, OverflowError):
        return False
    return True
