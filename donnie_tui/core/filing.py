"""Which file the program in the editor is, and whether it changed since."""

from __future__ import annotations

from pathlib import Path

from donnie_tui.core.documents import (
    DocumentError,
    program_to_open,
    program_to_save,
    read_program,
    write_program,
)


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


def saved_text(path: Path) -> str:
    """The text of a file as the editor would hold it; empty where it can't be read."""
    try:
        return as_lines(read_program(path))
    except DocumentError:
        return ""
