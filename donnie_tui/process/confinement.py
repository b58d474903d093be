"""Confines a process: it may use all files and programs, or the files of one folder and no other program.

A teacher confines a session with ``donnie --confined FOLDER``. There is one ``Confinement`` in a process. The
command line sets it before anything is opened, and no command lifts it. Every file that a learner can name
is opened, created and replaced here.

A path means the file that it leads to once its links are resolved. Then each folder on the way is opened by
itself, without following a link, so a link that is made in between leads nowhere. Names that begin with a dot
belong to Donnie and to the account: a learner who could write ``.bashrc`` would be free at the next login.
"""

from __future__ import annotations

import errno
import os
import stat

TYPE_CHECKING = False  # that of typing takes longer to load than all that is here
if TYPE_CHECKING:
    from collections.abc import Iterable
    from typing import Any, BinaryIO, Self, TextIO, TypeAlias

    AnyPath: TypeAlias = str | os.PathLike[str]

OWN_FOLDER = ".donnie"
"""The folder of settings, history and unsaved copies, inside that of a confined session."""

IS_POSSIBLE = hasattr(os, "O_NOFOLLOW") and os.open in os.supports_dir_fd
"""Whether this system can open a file below an open folder."""

_FOLDER = getattr(os, "O_DIRECTORY", 0)
"""Flags to read a folder."""
_NO_LINK = getattr(os, "O_NOFOLLOW", 0)
_PASSING = getattr(os, "O_PATH", os.O_RDONLY) | _FOLDER | _NO_LINK
"""Flags to open a folder on the way; if possible without the permission to list it."""
_CHANGING = os.O_WRONLY | os.O_RDWR | os.O_CREAT | os.O_TRUNC | os.O_APPEND


class OutsideError(PermissionError):
    """A file that a confined session must not use. ``code`` is the code of a sentence with a ``path``."""

    def __init__(self, path: AnyPath, code: str = "file-outside") -> None:
        super().__init__(errno.EACCES, os.strerror(errno.EACCES), os.fspath(path))
        self.path = os.fspath(path)
        self.code = code


class Confinement:
    """Allows the files of one folder, and the built-in ones."""

    def __init__(self, folder: str, readable: Iterable[str] = ()) -> None:
        """``readable``: folders outside that can be read."""
        self.folder = _followed(folder)
        self.own_folder = os.path.join(self.folder, OWN_FOLDER)  # noqa: PTH118 -- pathlib is slow to load
        self._readable = tuple(map(_followed, readable))

    def check(self, path: AnyPath) -> None:
        """Raises ``OutsideError`` unless a learner may name this path: inside the folder and not hidden."""
        inside = part_below(self.folder, _followed(path))
        if inside is None:
            raise OutsideError(path)
        if any(part.startswith(".") for part in _parts(inside)):
            raise OutsideError(path, "file-hidden")

    def open(self, path: AnyPath, flags: int, permissions: int) -> int:
        """The descriptor of a file inside, or to be read in a readable folder. Raises ``OSError``."""
        real = _followed(path)
        for root in (self.folder, *(() if flags & _CHANGING else self._readable)):
            inside = part_below(root, real)
            if inside is not None:
                try:
                    return _opened_below(root, inside, flags, permissions)
                except OSError as problem:
                    if problem.errno in (errno.ELOOP, errno.ENOTDIR) and os.path.islink(real):  # noqa: PTH114
                        break
                    raise
        raise OutsideError(path)


def part_below(folder: str, path: str) -> str | None:
    """The rest of a real path below a real folder; empty for the folder itself, None outside of it."""
    if path == folder:
        return ""
    start = folder if folder.endswith(os.sep) else folder + os.sep
    return path[len(start) :] if path.startswith(start) else None


def _parts(path: str) -> list[str]:
    return path.split(os.sep)  # noqa: PTH206 -- pathlib is slow to load


def _opened_below(root: str, inside: str, flags: int, permissions: int) -> int:
    """Opens folder after folder; neither these nor the file may be links."""
    *folders, name = _parts(inside)
    here = os.open(root, _PASSING)
    try:
        for each in folders:
            below = os.open(each, _PASSING, dir_fd=here)
            os.close(here)
            here = below
        return os.open(name or os.curdir, flags | _NO_LINK, permissions, dir_fd=here)
    finally:
        os.close(here)


# --- the confinement of this process

_confinement: Confinement | None = None


def confine(confinement: Confinement | None) -> None:
    """Confine this process, or lift it with None. A relative name means a file inside."""
    global _confinement
    _confinement = confinement
    if confinement is not None and part_below(confinement.folder, _followed(os.curdir)) is None:
        os.chdir(confinement.folder)


def confinement() -> Confinement | None:
    """None if nothing is confined."""
    return _confinement


def may_run_programs() -> bool:
    """Whether a pager may start, and Ctrl+Z may return to a shell. Donnie's own voice may always start."""
    return _confinement is None


def check_name(path: AnyPath) -> None:
    """Raises ``OutsideError`` for a path that a learner must not name."""
    if _confinement is not None:
        _confinement.check(path)


def check_own(path: AnyPath) -> None:
    """Raises ``OutsideError`` for a folder of Donnie's own that is outside, by a link."""
    if _confinement is not None and part_below(_confinement.folder, _followed(path)) is None:
        raise OutsideError(path)


def is_allowed(path: AnyPath) -> bool:
    """Whether a learner may name this path."""
    try:
        check_name(path)
    except (OSError, ValueError):
        return False
    return True


# --- files


def real_path(path: AnyPath) -> str:
    """The path with its links followed, as far as they lead anywhere; never raises.

    ``Path.resolve`` raises ``RuntimeError`` for a link to itself, and ``ValueError`` for a zero byte.
    """
    try:
        return _followed(path)
    except ValueError:
        return os.path.normpath(path)


def _followed(path: AnyPath) -> str:
    """The path with its links followed. Raises ``ValueError`` for a zero byte.

    A relative path stays relative where the working folder was removed: there it leads nowhere.
    """
    try:
        return os.path.realpath(path)
    except OSError:
        return os.path.normpath(path)


def open_descriptor(path: AnyPath, flags: int, permissions: int = 0o666) -> int:
    """As ``os.open``, for every file that a learner can name. Raises ``OSError``."""
    if _confinement is None:
        return os.open(path, flags, permissions)
    return _confinement.open(path, flags, permissions)


def open_bytes(path: AnyPath, mode: str = "rb") -> BinaryIO:
    """A file to read, or with ``wb`` to begin anew. Raises ``OSError`` or ``ValueError``.

    Refuses to read a named pipe, which may be opened and read without end.
    """
    opener = _open_without_waiting if mode == "rb" else open_descriptor
    # pathlib knows no opener; the mode says of which type it is
    return open(path, mode, opener=opener)  # type: ignore[return-value]


def _open_without_waiting(path: AnyPath, flags: int) -> int:
    number = open_descriptor(path, flags | getattr(os, "O_NONBLOCK", 0))
    if stat.S_ISFIFO(os.fstat(number).st_mode):
        os.close(number)
        raise OSError(errno.EINVAL, "is a pipe", os.fspath(path))
    if hasattr(os, "O_NONBLOCK"):
        os.set_blocking(number, True)
    return number


def open_text(path: AnyPath, mode: str = "r", *, errors: str = "strict") -> TextIO:
    """As ``open_bytes``, as text in UTF-8."""
    newline = None if mode == "r" else "\n"
    how: Any = {"encoding": "utf-8", "errors": errors, "newline": newline, "opener": open_descriptor}
    return open(path, mode, **how)  # type: ignore[return-value] # noqa: PTH123 -- as above


def make_folder(path: AnyPath) -> None:
    """Create a folder and those above it, if they are missing. Raises ``OSError``."""
    if _confinement is not None:
        check_own(path)
    os.makedirs(path, exist_ok=True)  # noqa: PTH103


def folder_items(path: AnyPath) -> list[tuple[str, bool, bool]]:
    """The files and folders in a folder: each name, whether it is a folder, and whether it is a link.

    Leaves out hidden ones, and those that a confined session must not use. Raises ``OSError``.
    """
    check_name(path)
    number = None if _confinement is None else open_descriptor(path, _FOLDER)
    found = []
    try:
        with os.scandir(os.fspath(path) if number is None else number) as items:
            for each in items:
                if each.name.startswith("."):
                    continue
                try:
                    is_folder, is_link = each.is_dir(), each.is_symlink()
                    is_used = is_folder or each.is_file()
                except OSError:  # a link to itself
                    continue
                if is_used and (not is_link or is_allowed(f"{os.fspath(path)}/{each.name}")):
                    found.append((each.name, is_folder, is_link))
    finally:
        if number is not None:
            os.close(number)
    return found


class OpenFolder:
    """A folder in which files are made and replaced. Confined, it is the same one until ``close``."""

    def __init__(self, path: AnyPath) -> None:
        """Raises ``OSError``."""
        self._path = os.fspath(path)
        self._number = None
        if _confinement is not None:
            check_own(path)
            self._number = open_descriptor(path, _FOLDER)

    def open_new(self, name: str) -> int:
        """A file that did not exist before, open for writing by its owner only. Raises ``OSError``."""
        return os.open(
            self._place(name), os.O_RDWR | os.O_CREAT | os.O_EXCL | _NO_LINK, 0o600, dir_fd=self._number
        )

    def replace(self, name: str, other: str) -> None:
        """Replace the file ``other`` by the file ``name``."""
        os.replace(self._place(name), self._place(other), src_dir_fd=self._number, dst_dir_fd=self._number)

    def remove(self, name: str) -> None:
        os.unlink(self._place(name), dir_fd=self._number)

    def _place(self, name: str) -> str:
        return os.path.join(self._path, name) if self._number is None else name  # noqa: PTH118

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        if self._number is not None:
            os.close(self._number)
