"""Program files: which file a typed name means, reading in any likely encoding, writing without loss.

The new text goes into a second file, which then takes the place of the first. So a full disk or a crash
leaves either the old text or the new one. ``FilesInUse`` are the files that no command may save onto,
``RecentFiles`` the ones that were opened and saved lately, ``BreakpointFile`` keeps their breakpoints,
``ProgressFile`` what was done for challenges.
"""

from __future__ import annotations

import contextlib
import errno
import itertools
import os
import re
from codecs import BOM_UTF16_BE, BOM_UTF16_LE
from collections.abc import Container, Iterable, Iterator
from typing import TYPE_CHECKING, BinaryIO

from msgspec import Struct, convert
from msgspec.structs import astuple

from donnie_tui.process.confinement import (
    OpenFolder,
    OutsideError,
    check_name,
    confinement,
    folder_items,
    is_allowed,
    make_folder,
    open_bytes,
    open_descriptor,
    open_text,
    part_below,
    real_path,
)
from language.source import cleaned, fold_name, lines_in, printable, with_newlines

if TYPE_CHECKING:
    from pathlib import Path

LARGEST = 8 * 1024 * 1024
"""Bytes that a program file may have; a program of a learner has a few hundred."""

LONGEST_SILENCE = 10.0
"""Seconds in which something must be written into a pipe that is read."""

SUFFIX = ".gd"
STANDARD_OUTPUT = "-"
"""The name by which an option means standard output."""


class DocumentError(Exception):
    """A file can't be read or written. ``code`` says why, ``path`` which file."""

    def __init__(self, code: str, path: str, reason: str = "") -> None:
        super().__init__(code)
        self.code = code
        self.path = path
        self.reason = reason


class FilesInUse:
    """The files that a session reads or writes while it runs: no command saves onto them."""

    def __init__(self, names: Iterable[str] = ()) -> None:
        self._names = tuple(names)

    def __contains__(self, name: str) -> bool:
        """Finds a file under any of its names."""
        return real_path(name) in map(real_path, self._names)


# --- typed names


def program_to_open(name: str) -> Path:
    """The file that a typed name means: this file, or the one with the suffix of programs."""
    path = _typed_path(name)
    suffixed = path.with_name(path.name + SUFFIX)
    return _checked_again(suffixed) if not exists(path) and exists(suffixed) else path


def _checked_again(path: Path) -> Path:
    """Checks the name again: with its suffix it may be a link to somewhere else."""
    return path if confinement() is None else checked_path(path)


def program_to_save(name: str, in_use: FilesInUse) -> Path:
    """The file that a program is saved to. A name without a suffix gets the one of programs.

    Raises ``DocumentError``, also for a file in use and for a folder: the learner is not asked whether to
    replace these.
    """
    return file_to_save(name, in_use, SUFFIX)


def file_to_save(name: str, in_use: FilesInUse, suffix: str, own: Path | None = None) -> Path:
    """The same for another suffix; ``own`` is in use by what is saved. A new file has a printable name."""
    path = _typed_path(name)
    meant = path if path.suffix or exists(path) else _checked_again(path.with_name(path.name + suffix))
    if not exists(meant) and printable(meant.name) != meant.name:
        meant = _checked_again(meant.with_name(printable(meant.name).strip()))
    if str(meant) in in_use and meant != own:
        raise DocumentError("file-in-use", str(meant))
    if is_folder(meant):
        raise DocumentError("file-is-folder", str(meant))
    return meant


def page_to_save(name: str, open_programs: Iterable[Path | None], in_use: FilesInUse) -> Path:
    """Where a log or a report is written. Raises ``DocumentError``, also for the file of an open program."""
    path = program_to_save(name, in_use)
    if any(each is not None and is_same_file(path, each) for each in open_programs):
        raise DocumentError("file-is-open", str(path))
    return path


def _typed_path(name: str) -> Path:
    """The path of a name, which may have quotes around it. Raises ``DocumentError``."""
    from pathlib import Path  # slow to load, and a start names no file

    path = Path(unquoted(name))
    if not path.name:
        raise DocumentError("file-is-folder", str(path))
    if confinement() is not None:
        return checked_path(path)
    try:
        return path.expanduser()
    except RuntimeError:
        return path


def checked_path(path: Path) -> Path:
    """The path that a learner gave. Raises ``DocumentError`` where a confined session must not use it.

    The home of an account, ``~``, is outside.
    """
    with _reported(path, "file-unreadable"):
        if confinement() is not None and str(path).startswith("~"):
            raise OutsideError(path)
        check_name(path)
    return path


@contextlib.contextmanager
def _reported(path: Path, code: str) -> Iterator[None]:
    """Raises ``DocumentError`` for a failure with this file, and for one outside of the allowed folders."""
    try:
        yield
    except OutsideError as problem:
        raise DocumentError(problem.code, str(path)) from None
    except (OSError, ValueError) as problem:
        raise DocumentError(code, str(path), reason_of(problem)) from None


def unquoted(name: str) -> str:
    """The name of a file without the quotes around it."""
    return name.strip().strip("\"'“”")


exists, is_folder, is_file, is_link = os.path.exists, os.path.isdir, os.path.isfile, os.path.islink
"""False for a name that is too long to be looked for, where those of ``Path`` raise ``OSError``."""


def is_same_file(one: Path, other: Path) -> bool:
    """Whether both are one file, which may not exist yet. False for a terminal or another device."""
    try:
        if one.exists():
            return one.is_file() and one.samefile(other)
        return real_path(one) == real_path(other)
    except (OSError, ValueError):
        return False


# --- what there is to open


class ProgramEntry(Struct, frozen=True):
    """A program in a folder, or a folder in it."""

    path: Path
    name: str
    """As it is shown: in one line, and with a slash after the name of a folder."""
    folded: str
    """For comparisons."""
    real: str = ""
    """Where a folder leads to; empty for a program."""


def programs_in(folder: Path, inside: Container[str] = ()) -> tuple[ProgramEntry, ...]:
    """The programs of a folder in their order, then its folders; hidden ones are left out.

    So is a link to a folder that is ``inside``, or that this one lies in: it would lead in circles. Raises
    ``DocumentError``.
    """
    found = []
    with _reported(folder, "file-unreadable"):
        here = real_path(folder)
        for name, is_folder, is_link in folder_items(folder):
            path, shown = folder / name, printable(name)
            if not is_folder:
                if name.endswith(SUFFIX):
                    found.append(ProgramEntry(path, shown, fold_name(shown)))
                continue
            real = real_path(path) if is_link else f"{here.rstrip(os.sep)}{os.sep}{name}"
            if not is_link or (real not in inside and part_below(real, here) is None):
                found.append(ProgramEntry(path, f"{shown}/", fold_name(shown), real))
    return tuple(sorted(found, key=_place))


def _place(entry: ProgramEntry) -> tuple[bool, list[str | int]]:
    """By numbers in the name, too: program2 comes before program10."""
    parts = re.split(r"(\d+)", entry.folded)
    return bool(entry.real), [int(each) if at % 2 else each for at, each in enumerate(parts)]


def program_meant(name: str) -> Path:
    """The only program whose name begins as a typed one, which names no file; else the file of that name.

    Raises ``DocumentError`` if several begin so.
    """
    path = _typed_path(name)
    typed, listed = fold_name(path.name), tuple[ProgramEntry, ...]()
    with contextlib.suppress(DocumentError):
        listed = programs_in(path.parent)
    begins = [each for each in listed if not each.real and each.folded.startswith(typed)]
    if len(begins) > 1:
        raise DocumentError("file-several", str(path), str(len(begins)))
    return begins[0].path if begins else path


# --- reading


def read_program(path: Path) -> str:
    """The text of a program in a file. Refuses a pipe, which may block. Raises ``DocumentError``."""
    if exists(path) and not (path.is_file() or path.is_dir()):
        raise DocumentError("file-no-file", str(path))
    return read_to_the_end(path)


def read_to_the_end(path: Path) -> str:
    """As ``read_program``, but reads a pipe too, until it is closed. One that stays empty is refused."""
    with _reported(path, "file-unreadable"):
        if path.is_dir():
            raise DocumentError("file-is-folder", str(path))
        try:
            with _open_pipe(path) if path.is_fifo() else open_bytes(path) as file:
                return decode(file.read(LARGEST + 1), str(path))  # a device has no end
        except FileNotFoundError:
            raise DocumentError("file-not-found", str(path)) from None


def _open_pipe(path: Path) -> BinaryIO:
    """A named pipe, once something was written. Raises ``DocumentError`` if nothing is, and ``OSError``."""
    import select  # few programs are read from pipes

    pipe = open_descriptor(path, os.O_RDONLY | os.O_NONBLOCK)
    written = select.poll()
    written.register(pipe, select.POLLIN)
    if not written.poll(LONGEST_SILENCE * 1000):
        os.close(pipe)
        raise DocumentError("file-pipe-silent", str(path))
    os.set_blocking(pipe, True)
    return os.fdopen(pipe, "rb")


def saved_text(path: Path) -> str:
    """The text of a file; empty if it can't be read."""
    try:
        return read_program(path)
    except DocumentError:
        return ""


def changed_since(path: Path, known: str) -> bool:
    """Whether the file exists and has another text than ``known``, which was last read or written."""
    try:
        return exists(path) and lines_in(read_program(path)) != lines_in(known)
    except DocumentError:
        return False


def save_question(path: Path, own: Path | None, known: str) -> str:
    """The code of the question before a save replaces ``path``; empty if nothing would be lost.

    ``own`` is the file of the program, and ``known`` its text when it was last read or written.
    """
    if not exists(path):
        return ""
    if own is None or not is_same_file(path, own):
        return "ask-replace"
    return "ask-replace-changed" if changed_since(path, known) else ""


def decode(data: bytes, name: str) -> str:
    """UTF-8, or UTF-16 with its mark, else the old Windows code page of our learners' languages; cleaned.

    Raises ``DocumentError``.
    """
    if len(data) > LARGEST:
        raise DocumentError("file-too-large", name, str(LARGEST // 1024**2))
    try:
        text = data.decode("utf-16" if data[:2] in (BOM_UTF16_LE, BOM_UTF16_BE) else "utf-8-sig")
    except UnicodeDecodeError:
        text = data.decode("cp1252", errors="replace")
    if "\0" in text:
        raise DocumentError("file-not-text", name)
    return cleaned(text)


def as_lines(text: str) -> str:
    """The text with a newline after each line but the last, as an editor shows it."""
    return with_newlines(text).removesuffix("\n")


# --- writing


def write_program(path: Path, text: str) -> None:
    """Write a program as UTF-8. Raises ``DocumentError``."""
    with _reported(path, "file-unwritable"):
        data = text.encode("utf-8")
    write_bytes(path, data)


def write_bytes(path: Path, data: bytes) -> None:
    """Write a file whole or not at all. Raises ``DocumentError``."""
    from pathlib import Path

    with _reported(path, "file-unwritable"):
        # in a confined session a link that is made from now on is not followed
        target = Path(real_path(path))
        if target.is_symlink():
            raise OSError(errno.ELOOP, os.strerror(errno.ELOOP))
        if target.is_dir():
            raise DocumentError("file-is-folder", str(path))
        if target.exists() and not target.is_file():  # to replace a device would break the machine
            raise DocumentError("file-no-file", str(path))
        if target.exists() and not os.access(target, os.W_OK):
            raise PermissionError(errno.EACCES, os.strerror(errno.EACCES))
        _replace_file(target, data)


def write_companion(path: Path, suffix: str, data: bytes) -> str:
    """Write a file that belongs to ``path`` and return its name, the first that is free or has that content.

    Raises ``DocumentError`` and ``OSError``.
    """
    for number in itertools.count(1):
        other = path.with_name(f"{path.stem}-{number}{suffix}")
        if not exists(other):
            write_bytes(other, data)
            return other.name
        if other.is_file():
            with open_bytes(other) as file:
                if file.read() == data:
                    return other.name
    raise AssertionError("numbers have no end")


_numbers = itertools.count()
"""Of the files of this process: a name is never given twice."""


def new_file(folder: Path, prefix: str, suffix: str = "") -> tuple[int, Path]:
    """A file that did not exist before, open for writing by its owner only. Raises ``OSError``.

    ``tempfile`` would do the same, but loading it takes as long as writing a hundred files.
    """
    with OpenFolder(folder) as opened:
        handle, name = _new_file_in(opened, prefix, suffix)
    return handle, folder / name


def _new_file_in(folder: OpenFolder, prefix: str, suffix: str = "") -> tuple[int, str]:
    for number in _numbers:
        name = f"{prefix}{os.getpid()}-{number}{suffix}"
        with contextlib.suppress(FileExistsError):
            return folder.open_new(name), name
    raise AssertionError("numbers have no end")


def _replace_file(target: Path, data: bytes) -> None:
    with OpenFolder(target.parent) as folder:
        handle, second = _new_file_in(folder, f".{target.name}.")
        try:
            with os.fdopen(handle, "wb") as out:
                out.write(data)
                out.flush()
                os.fsync(out.fileno())
                _set_mode(out.fileno(), target)
            folder.replace(second, target.name)
        except BaseException:
            with contextlib.suppress(OSError):
                folder.remove(second)
            raise


def _set_mode(number: int, target: Path) -> None:
    """As the file that is replaced, or a new one."""
    if hasattr(os, "fchmod"):
        os.fchmod(number, _mode(target))


def _mode(target: Path) -> int:
    if target.exists():
        return target.stat().st_mode & 0o777
    mask = os.umask(0)
    os.umask(mask)
    return 0o666 & ~mask


def reason_of(problem: OSError | ValueError) -> str:
    """Why a file can't be used, as the system says it."""
    if isinstance(problem, UnicodeError):
        return str(problem)
    if isinstance(problem, ValueError):  # a zero byte in the name
        return os.strerror(errno.EINVAL)
    return problem.strerror or str(problem)


# --- what is kept of program files from one start to the next


def file_names(typed: str) -> tuple[str, ...]:
    """The files and folders that a typed name may become; a folder ends with a slash."""
    from pathlib import Path

    folder, _, name = typed.rpartition("/")
    place = Path(folder or ("/" if typed.startswith("/") else "."))
    try:
        found = [each for each in sorted(place.iterdir()) if is_allowed(each)] if is_allowed(place) else []
        names = [f"{each.name}/" if each.is_dir() else each.name for each in found]
    except OSError:
        return ()
    before = f"{folder}/" if "/" in typed else ""
    return tuple(
        before + each for each in names if each.startswith(name) and (name or not each.startswith("."))
    )


class _KeptFile:
    """A text file that is kept from one start to the next.

    It is a convenience: a fault of the file is never reported.
    """

    LARGEST = 100_000
    """Bytes; a larger file is damaged."""

    def __init__(self, file: str) -> None:
        self._file_name = file

    def _lines(self) -> list[str]:
        try:
            with open_text(self._file_name) as file:
                text = file.read(self.LARGEST + 1)
        except (OSError, ValueError):
            return []
        return text.splitlines() if len(text) <= self.LARGEST else []

    def _write(self, lines: Iterable[str], mode: str = "w") -> None:
        from pathlib import Path  # slow to load, and few programs have a file at the start

        with contextlib.suppress(OSError, ValueError):
            file = Path(self._file_name)
            make_folder(file.parent)
            with open_text(file, mode) as out:
                out.writelines(f"{each}\n" for each in lines)


class RecentFiles(_KeptFile):
    """The programs that were opened and saved lately, the newest first."""

    MOST = 20

    def paths(self) -> tuple[Path, ...]:
        """The paths that still exist."""
        from pathlib import Path

        found = []
        for line in self._lines()[: self.MOST]:
            with contextlib.suppress(OSError, ValueError):
                if is_allowed(line) and Path(line).is_file():
                    found.append(Path(line))
        return tuple(found)

    def add(self, path: Path) -> None:
        with contextlib.suppress(OSError, ValueError):
            name = real_path(path)
            self._write([name, *(each for each in self._lines() if each != name)][: self.MOST])


class Attempted(Struct, frozen=True, array_like=True, forbid_unknown_fields=True):
    """One run for a challenge, as it is kept."""

    when: str
    name: str
    solved: bool
    met: int
    goals: int
    commands: int
    steps: int
    bumps: int
    hints: int
    """Those that were given before."""
    seconds: int = 0
    """Of robot time."""
    shortest: int = 0
    """Steps of the solution."""
    questions: int = 0
    right: int = 0
    """The questions that were answered rightly."""


class ProgressFile(_KeptFile):
    """What the learner did for challenges, one line a try, its values separated by tabs.

    A line that can't be read is left out.
    """

    LARGEST = 10_000_000
    """A hundred thousand tries."""

    def attempts(self) -> tuple[Attempted, ...]:
        """All, the oldest first."""
        found = []
        for line in self._lines():
            with contextlib.suppress(ValueError):
                found.append(convert(line.split("\t"), Attempted, strict=False))
        return tuple(found)

    @property
    def solved(self) -> frozenset[str]:
        """The names of the challenges that were solved."""
        return frozenset(each.name for each in self.attempts() if each.solved)

    def add(self, attempt: Attempted) -> None:
        self._write(["\t".join(map(str, astuple(attempt)))], "a")


class BreakpointFile(_KeptFile):
    """The breakpoints of each program that has a file, by its path; the program used last comes first."""

    MOST_PROGRAMS = 200
    MOST_LINES = 200
    """Breakpoints of one program that are kept."""
    LARGEST = 400_000

    def read(self, program: Path | None, line_count: int) -> frozenset[int]:
        """The breakpoints of that program, as far as its lines reach."""
        if program is None:
            return frozenset()
        lines = dict(self._entries()).get(real_path(program), ())
        return frozenset(each for each in lines if 1 <= each <= line_count)

    def write(self, program: Path | None, lines: Iterable[int]) -> None:
        """Keep these for the next start. Ignores a program without a file, and a file it can't write."""
        if program is None:
            return
        name, chosen = real_path(program), tuple(sorted(lines))[: self.MOST_LINES]
        before = self._entries()
        if dict(before).get(name, ()) == chosen:
            return
        others = [each for each in before if each[0] != name]
        entries = [(name, chosen), *others][: self.MOST_PROGRAMS] if chosen else others
        self._write(f"{' '.join(map(str, each))}\t{path}" for path, each in entries if path.isprintable())

    def _entries(self) -> list[tuple[str, tuple[int, ...]]]:
        return [entry for line in self._lines() if (entry := _entry(line)) is not None]


def _entry(line: str) -> tuple[str, tuple[int, ...]] | None:
    """``3 7``, a tab and the path."""
    numbers, _tab, name = line.partition("\t")
    given = numbers.split()
    if not name or not all(each.isdecimal() and len(each) < 9 for each in given):
        return None
    return name, tuple(map(int, given))
