"""Programs in files: read in any encoding that is likely, written so that nothing is lost.

A file is written beside the old one and then takes its place, so that a full disk or a crash leaves
either the old text or the new one. A ``Document`` knows which file the program in the editor is, and whether
it changed since.
"""

from __future__ import annotations

import contextlib
import errno
import itertools
import os
from collections.abc import Iterable

from devices.ports.hints import TYPE_CHECKING
from donnie_tui.core.harmless import cleaned
from language.source import lines_in, with_newlines

if TYPE_CHECKING:
    from pathlib import Path

    from donnie_tui.core.in_use import FilesInUse

LARGEST = 8 * 1024 * 1024
"""Bytes that a program file may have; a program of a learner has a few hundred."""


class DocumentError(Exception):
    """A file that can't be read or written. ``code`` says why, ``path`` which."""

    def __init__(self, code: str, path: str, reason: str = "") -> None:
        super().__init__(code)
        self.code = code
        self.path = path
        self.reason = reason


SUFFIX = ".gd"


def program_to_open(name: str) -> Path:
    """The file that somebody means who types ``name``: that one, or the one with the suffix of programs."""
    path = _typed_path(name)
    suffixed = path.with_name(path.name + SUFFIX)
    return suffixed if not exists(path) and exists(suffixed) else path


def program_to_save(name: str, in_use: FilesInUse) -> Path:
    """The file that a program is saved to: the suffix is added where a name has none.

    Raises ``DocumentError``, also for what is in use and for a folder, so that nobody is asked whether to
    replace that.
    """
    path = _typed_path(name)
    meant = path if path.suffix or exists(path) else path.with_name(path.name + SUFFIX)
    if str(meant) in in_use:
        raise DocumentError("file-in-use", str(meant))
    if is_folder(meant):
        raise DocumentError("file-is-folder", str(meant))
    return meant


def page_to_save(name: str, open_programs: Iterable[Path | None], in_use: FilesInUse) -> Path:
    """Where a page that is no program is written, a log or a report. Raises ``DocumentError``.

    Nobody is asked whether it replaces an open program: that is never meant.
    """
    path = program_to_save(name, in_use)
    if any(each is not None and is_same_file(path, each) for each in open_programs):
        raise DocumentError("file-is-open", str(path))
    return path


def _typed_path(name: str) -> Path:
    """The path of a name that may stand between quotes. Raises ``DocumentError``."""
    from pathlib import Path  # slow to load, and a start names no file

    path = Path(unquoted(name))
    if not path.name or "\0" in name:
        raise DocumentError("file-is-folder", str(path))
    try:
        return path.expanduser()
    except RuntimeError:
        return path


def unquoted(name: str) -> str:
    """The name of a file without the quotes that may stand around it."""
    return name.strip().strip("\"'“”")


def exists(path: Path) -> bool:
    """Whether anything is there; never what can't even be looked for, as a name that is too long."""
    try:
        return path.exists()
    except OSError:
        return False


def is_folder(path: Path) -> bool:
    try:
        return path.is_dir()
    except OSError:
        return False


def is_same_file(one: Path, other: Path) -> bool:
    """Of two that may not be there yet. What is no regular file, such as a terminal, may be shared."""
    try:
        if one.exists() and other.exists():
            return one.is_file() and one.samefile(other)
        return one.resolve() == other.resolve()
    except (OSError, ValueError, RuntimeError):
        return False


def read_program(path: Path) -> str:
    """The text of a program in a file: who converses waits for no pipe. Raises ``DocumentError``."""
    if exists(path) and not (path.is_file() or path.is_dir()):
        raise DocumentError("file-not-text", str(path))
    return read_to_the_end(path)


def read_to_the_end(path: Path) -> str:
    """As ``read_program``, a pipe too, which is waited for."""
    try:
        if path.is_dir():
            raise DocumentError("file-is-folder", str(path))
        with path.open("rb") as file:
            return decode(file.read(LARGEST + 1), str(path))  # a device has no end
    except FileNotFoundError:
        raise DocumentError("file-not-found", str(path)) from None
    except (OSError, ValueError) as problem:
        raise DocumentError("file-unreadable", str(path), _reason(problem)) from None


def changed_since(path: Path, known: str) -> bool:
    """Whether a program's file is there with another text than the one last read from it or written to it."""
    try:
        return exists(path) and lines_in(read_program(path)) != lines_in(known)
    except DocumentError:
        return False


def decode(data: bytes, name: str) -> str:
    """UTF-8, else the old Windows code page of our learners' languages; cleaned. Raises ``DocumentError``."""
    if len(data) > LARGEST:
        raise DocumentError("file-too-large", name)
    if b"\0" in data:
        raise DocumentError("file-not-text", name)
    try:
        return cleaned(data.decode("utf-8-sig"))
    except UnicodeDecodeError:
        return cleaned(data.decode("cp1252", errors="replace"))


def write_program(path: Path, text: str) -> None:
    """Write a program as UTF-8. Raises ``DocumentError``."""
    try:
        target = path.resolve()
        if target.is_dir():
            raise DocumentError("file-is-folder", str(path))
        if target.exists() and not target.is_file():  # taking a device's place would break the machine
            raise DocumentError("file-no-file", str(path))
        if target.exists() and not os.access(target, os.W_OK):
            raise PermissionError(errno.EACCES, os.strerror(errno.EACCES))
        _write_beside(target, text)
    except (OSError, ValueError) as problem:
        raise DocumentError("file-unwritable", str(path), _reason(problem)) from None


_numbers = itertools.count()
"""Of the files of this process: a name is never given twice."""


def new_file(folder: Path, prefix: str, suffix: str = "") -> tuple[int, Path]:
    """A file that was not there before, open to be written by its owner alone. Raises ``OSError``.

    ``tempfile`` would do the same: to load it takes as long as to write a hundred files.
    """
    for number in _numbers:
        path = folder / f"{prefix}{os.getpid()}-{number}{suffix}"
        with contextlib.suppress(FileExistsError):
            return os.open(path, os.O_RDWR | os.O_CREAT | os.O_EXCL, 0o600), path
    raise AssertionError("numbers end nowhere")


def _write_beside(target: Path, text: str) -> None:
    handle, beside = new_file(target.parent, f".{target.name}.")
    try:
        with os.fdopen(handle, "w", encoding="utf-8", newline="\n") as out:
            out.write(text)
            out.flush()
            os.fsync(out.fileno())
        beside.chmod(_mode(target))
        beside.replace(target)
    except BaseException:
        with contextlib.suppress(OSError):
            beside.unlink()
        raise


def _mode(target: Path) -> int:
    if target.exists():
        return target.stat().st_mode & 0o777
    mask = os.umask(0)
    os.umask(mask)
    return 0o666 & ~mask


def _reason(problem: Exception) -> str:
    return getattr(problem, "strerror", None) or str(problem)


class Document:
    """The file of the editor's text."""

    def __init__(self, in_use: FilesInUse) -> None:
        self._in_use = in_use
        self.path: Path | None = None
        self._kept = ""
        """The text as the file has it, or as it was given up."""

    def is_changed(self, text: str) -> bool:
        return text != self._kept

    def read(self, name: str) -> tuple[Path, str]:
        """The file that is meant and its text; nothing changes yet. Raises ``DocumentError``."""
        path = program_to_open(name)
        return path, as_lines(read_program(path))

    def become(self, path: Path | None, text: str) -> None:
        """The editor holds this file's text now."""
        self.path = path
        self._kept = text

    def write(self, path: Path, text: str) -> None:
        """Save, under this name from now on. Raises ``DocumentError``."""
        if str(path) in self._in_use:
            raise DocumentError("file-in-use", str(path))
        write_program(path, text if not text or text.endswith("\n") else f"{text}\n")
        self.path = path
        self._kept = text

    def place_for(self, name: str) -> Path:
        """Where a program of that name is saved. Raises ``DocumentError``."""
        return program_to_save(name, self._in_use)

    def overwrites(self, path: Path) -> bool:
        """Whether saving there would replace a file that is not this program's own."""
        try:
            return path.exists() and (self.path is None or not path.samefile(self.path))
        except OSError:
            return False

    def was_changed_outside(self, path: Path) -> bool:
        """Whether somebody else wrote into this program's own file since it was read or saved."""
        return self.path is not None and is_same_file(path, self.path) and changed_since(path, self._kept)


def as_lines(text: str) -> str:
    """The text as the editor holds it: lines end with a newline, and there is none after the last."""
    return with_newlines(text).removesuffix("\n")


def saved_text(path: Path) -> str:
    """The text of a file as the editor would hold it; empty where it can't be read."""
    try:
        return as_lines(read_program(path))
    except DocumentError:
        return ""
