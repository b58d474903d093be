"""A copy of what is not saved, for the case of a crash: what a crash left is offered at the next start.

Copies are written into the state folder while somebody types, one file a program, and removed once the text
is saved. Whoever leaves without saving leaves the copy behind: the next start does not speak of it, for most
have done with it, but brings it back for whoever asks. Rule: whoever types waits for no disk. ``want`` says
what is to be kept, ``settle`` writes it down, in whatever thread; the last one that was wanted is what is
there at the end.

A front end's copies (``CopyKeeping``) are written in a thread of their own, which is there only while there
is something to write; each program's by one thread at a time, and what is wanted meanwhile is written once
that is done.
"""

from __future__ import annotations

import contextlib
import os
import sys
import threading
from collections.abc import Callable, Iterable

from devices.ports.hints import TYPE_CHECKING
from devices.ports.values import Frozen
from donnie_tui.core.documents import DocumentError, as_lines, new_file, read_program, write_program

if TYPE_CHECKING:
    from pathlib import Path

MOST_COPIES = 20
"""Copies of each kind that are kept; the oldest go first."""

_PREFIX, _SUFFIX = "unsaved-", ".gd"
_LEFT = "left-"
"""In the place of the prefix: somebody left without saving it."""
_FILE = "-- What was not saved of the file: "
"""The first line of a copy, with the path of the file; a comment of the language, for whoever looks."""


class Rescued(Frozen):
    """What a copy holds."""

    text: str
    path: Path | None = None
    """The file that it is the program of."""


class Copies:
    """The copy of one program, and those that others left in the same folder. Any thread may ask."""

    def __init__(self, folder: str, ours: set[Path] | None = None) -> None:
        """``ours``: the copies of this start's programs, which are shared with ``another``."""
        self._folder = folder
        self._ours: set[Path] = set() if ours is None else ours
        self._own: Path | None = None
        self._wanted: Rescued | None = None
        self._replaced: list[Path] = []
        """Copies whose text is kept by this one."""
        self.is_behind = False
        """Whether the folder is not yet as it is wanted."""
        self._is_given_up = False
        self._writing = threading.Lock()

    def another(self) -> Copies:
        """For one more program, in the same folder."""
        return Copies(self._folder, self._ours)

    # --- what others left

    def offered(self) -> Path | None:
        """The one that is to be brought back first."""
        return next(iter(self.all_offered()), None)

    def all_offered(self) -> list[Path]:
        """Those that nobody wanted to leave, then those that somebody left; of each the newest first."""
        return self.rescued() + self.left()

    def left(self) -> list[Path]:
        """Those that somebody left on purpose, the newest first."""
        return self._newest_first(_LEFT)

    def rescued(self) -> list[Path]:
        """Those that a crash or a lost line left, the newest first: there may have been several programs."""
        found = self._newest_first(_PREFIX)
        return [each for each in found if each not in self._ours and not _is_in_use(each)]

    def read(self, copy: Path) -> Rescued:
        """What it holds; nothing changes. Raises ``DocumentError``."""
        text = as_lines(read_program(copy))
        first, _, rest = text.partition("\n")
        if not first.startswith(_FILE):
            return Rescued(text)
        name = first.removeprefix(_FILE)
        return Rescued(rest, _path(name) if name else None)

    def take(self, copy: Path) -> Rescued:
        """What it holds, written down anew as this start's own. Raises ``DocumentError``."""
        found = self.read(copy)
        self.want(found.text, found.path, instead_of=copy)
        self.settle()
        return found

    # --- the own one

    def want(self, text: str, path: Path | None = None, *, instead_of: Path | None = None) -> None:
        """From now on this is to be kept. ``instead_of``: a copy which is removed once it is."""
        if instead_of is not None:
            self._replaced.append(instead_of)
        self._wanted = Rescued(text, path)
        self.is_behind = True

    def follow(self, text: str, path: Path | None = None, *, is_saved: bool) -> None:
        """From now on the text is to be kept where no file has it, and where there is anything in it."""
        if is_saved or not text.strip():
            self.want_none()
        else:
            self.want(text, path)

    def want_none(self) -> None:
        """The text is safe elsewhere, or given up."""
        self._wanted = None
        self.is_behind = True

    def settle(self) -> None:
        """Bring the folder up to what is wanted, by then. Raises ``DocumentError`` where it can't write."""
        with self._writing:
            while self.is_behind:
                self.is_behind = False  # first: what is wanted meanwhile is one more round
                self._bring_up(self._wanted)
            if self._is_given_up:
                self._leave_own()

    def settle_quietly(self) -> None:
        """As ``settle``, for whoever leaves: who would hear why not?"""
        with contextlib.suppress(DocumentError, OSError):
            self.settle()

    def keep(self, text: str, path: Path | None = None) -> None:
        """Write the text down at once. Raises ``DocumentError``."""
        self.want(text, path)
        self.settle()

    def give_up(self) -> None:
        """Once what is wanted is written, leave it to whoever asks for it."""
        self._is_given_up = self.is_behind = True

    def leave(self) -> None:
        """Leave the copy, if there is one, to whoever asks for it: this start has done with the program."""
        with self._writing:
            self._leave_own()

    def _leave_own(self) -> None:
        own, self._own = self._own, None
        if own is not None:
            self._ours.discard(own)
            with contextlib.suppress(OSError):
                _make_newest(own, self.left())
                own.rename(own.with_name(_LEFT + own.name.removeprefix(_PREFIX)))
            _forget_oldest(self.left())

    def forget(self) -> None:
        """Remove the copy at once."""
        self.want_none()
        self.settle()

    def _bring_up(self, wanted: Rescued | None) -> None:
        if wanted is None:
            self._remove_own()
        else:
            self._write(wanted)
        while self._replaced:
            with contextlib.suppress(OSError):
                self._replaced.pop().unlink()

    def _remove_own(self) -> None:
        own, self._own = self._own, None
        if own is not None:
            with contextlib.suppress(OSError):
                own.unlink()
            self._ours.discard(own)

    def _write(self, wanted: Rescued) -> None:
        try:
            own = self._own = self._own or self._new()
            self._ours.add(own)
        except OSError as problem:
            reason = problem.strerror or str(problem)
            raise DocumentError("file-unwritable", self._folder, reason) from None
        write_program(own, _with_file(wanted))

    def _new(self) -> Path:
        folder = _path(self._folder)
        folder.mkdir(parents=True, exist_ok=True)
        handle, own = new_file(folder, _PREFIX, _SUFFIX)
        os.close(handle)
        _forget_oldest(each for each in self._newest_first(_PREFIX) if not _is_in_use(each))
        return own

    def _newest_first(self, prefix: str) -> list[Path]:
        try:
            with os.scandir(self._folder) as entries:
                copies = [
                    each for each in entries if each.name.startswith(prefix) and each.name.endswith(_SUFFIX)
                ]
            found = [(each.stat().st_mtime_ns, each.path) for each in copies]
        except OSError:
            return []
        return [_path(each) for _, each in sorted(found, reverse=True)]


def _path(name: str) -> Path:
    from pathlib import Path  # slow to load, and a start mostly finds no copy

    return Path(name)


def _make_newest(copy: Path, newest_first: list[Path]) -> None:
    """Whoever asks gets first what was left last, though several are left within one tick of the clock."""
    copy.touch()
    before = newest_first[0].stat().st_mtime_ns if newest_first else 0
    if copy.stat().st_mtime_ns <= before:
        os.utime(copy, ns=(before + 1, before + 1))


def _forget_oldest(newest_first: Iterable[Path]) -> None:
    for old in [*newest_first][MOST_COPIES:]:
        with contextlib.suppress(OSError):
            old.unlink()


def _with_file(wanted: Rescued) -> str:
    """The text of the copy. A path that would be no line of text is left out."""
    name = str(wanted.path.absolute()) if wanted.path is not None else ""
    if not name.isprintable():
        name = ""
    return f"{_FILE}{name}\n{wanted.text}" if name or wanted.text.startswith(_FILE) else wanted.text


def _is_in_use(copy: Path) -> bool:
    """Whether another process that still runs keeps this copy; its number is in the name."""
    number = copy.name.removeprefix(_PREFIX).partition("-")[0]
    if os.name != "posix" or not number.isdecimal() or int(number) in (0, os.getpid()):
        return False
    return _is_donnie(number) if sys.platform == "linux" else _is_running(int(number))


def _is_donnie(number: str) -> bool:
    """Not one that ended and that nobody has looked after, nor another program that has its number now."""
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


class CopyKeeping:
    """Brings copies up to what is wanted of them."""

    def __init__(self, not_kept: Callable[[DocumentError], object]) -> None:
        """``not_kept`` is told once, in another thread, why something can't be written down."""
        self._not_kept, self._has_failed = not_kept, False
        self._lock = threading.Lock()
        self._in_work: set[Copies] = set()

    def bring_up(self, copies: Copies) -> None:
        """Have done what is wanted of them; from any thread."""
        with self._lock:
            if copies in self._in_work or not copies.is_behind:
                return
            self._in_work.add(copies)
        threading.Thread(target=self._work, args=(copies,), name="copies", daemon=True).start()

    def forget(self, copies: Copies) -> None:
        """The text is safe elsewhere, or given up."""
        copies.want_none()
        self.bring_up(copies)

    def _work(self, copies: Copies) -> None:
        while self._goes_on(copies):
            try:
                copies.settle()
            except DocumentError as error:
                self._tell(error)

    def _goes_on(self, copies: Copies) -> bool:
        """Decided under the lock, so that what is wanted just now is done by this thread or the next."""
        with self._lock:
            if not copies.is_behind:
                self._in_work.discard(copies)
            return copies in self._in_work

    def _tell(self, error: DocumentError) -> None:
        with self._lock:
            told, self._has_failed = self._has_failed, True
        if not told:
            self._not_kept(error)
