"""Which file the program in the editor is, whether it changed since, and a copy for the case of a crash.

The copy is written into the state folder while somebody types, one file a program, and removed once the
text is saved or given up on purpose. What a crash left is offered at the next start.
"""

from __future__ import annotations

import contextlib
import os
from pathlib import Path

from donnie_tui.core.documents import (
    DocumentError,
    program_to_open,
    program_to_save,
    read_program,
    write_program,
)

MOST_COPIES = 20
"""Copies that are kept; the oldest go first."""

_PREFIX, _SUFFIX = "unsaved-", ".gd"


class Document:
    """The file of the editor's text."""

    def __init__(self) -> None:
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
        write_program(path, text if not text or text.endswith("\n") else f"{text}\n")
        self.path = path
        self._kept = text

    def place_for(self, name: str) -> Path:
        """Where a program of that name is saved. Raises ``DocumentError``."""
        return program_to_save(name)

    def overwrites(self, path: Path) -> bool:
        """Whether saving there would replace a file that is not this program's own."""
        try:
            return path.exists() and (self.path is None or not path.samefile(self.path))
        except OSError:
            return False


def as_lines(text: str) -> str:
    """The text as the editor holds it: lines end with a newline, and there is none after the last."""
    return "\n".join(text.split("\r\n")).replace("\r", "\n").removesuffix("\n")


class Copies:
    """The copies in one folder. Raises ``DocumentError`` where it can't write."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._own: Path | None = None

    def offered(self) -> Path | None:
        """The newest copy that an earlier start left."""
        return next(iter(self.all_offered()), None)

    def all_offered(self) -> list[Path]:
        """All of them, the newest first: there may have been several programs."""
        return [each for each in self._newest_first() if each != self._own and not _is_in_use(each)]

    def take(self, path: Path) -> str:
        """A copy's text, written down anew as this start's own. Raises ``DocumentError``."""
        text = as_lines(read_program(path))
        self.forget()
        self.keep(text)
        with contextlib.suppress(OSError):
            path.unlink()
        return text

    def keep(self, text: str) -> None:
        """Write the text down. Raises ``DocumentError``."""
        try:
            path = self._own = self._own or self._new()
        except OSError as problem:
            raise DocumentError(
                "file-unwritable", str(self._folder), problem.strerror or str(problem)
            ) from None
        write_program(path, text)

    def forget(self) -> None:
        """The text is safe elsewhere, or given up."""
        if self._own is not None:
            with contextlib.suppress(OSError):
                self._own.unlink()
            self._own = None

    def _new(self) -> Path:
        import tempfile  # slow to load, and few sessions write

        self._folder.mkdir(parents=True, exist_ok=True)
        handle, name = tempfile.mkstemp(dir=self._folder, prefix=f"{_PREFIX}{os.getpid()}-", suffix=_SUFFIX)
        os.close(handle)
        for old in [each for each in self._newest_first() if not _is_in_use(each)][MOST_COPIES:]:
            with contextlib.suppress(OSError):
                old.unlink()
        return Path(name)

    def _newest_first(self) -> list[Path]:
        try:
            found = [(each.stat().st_mtime, each) for each in self._folder.glob(f"{_PREFIX}*{_SUFFIX}")]
        except OSError:
            return []
        return [each for _, each in sorted(found, reverse=True)]


def _is_in_use(copy: Path) -> bool:
    """Whether another process that still runs keeps this copy; its number is in the name."""
    number = copy.name.removeprefix(_PREFIX).partition("-")[0]
    if os.name != "posix" or not number.isdecimal() or int(number) in (0, os.getpid()):
        return False
    try:
        os.kill(int(number), 0)
    except PermissionError:
        return True
    except (OSError, OverflowError):
        return False
    return True
