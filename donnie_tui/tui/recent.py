"""The programs that were opened and saved lately, kept from one start to the next.

A comfort only: whatever is wrong with the file of names, nobody hears of it.
"""

from __future__ import annotations

from contextlib import suppress
from pathlib import Path

MOST = 20
LARGEST = 100_000
"""Bytes; twenty paths are a few thousand."""


class Recent:
    """The newest first."""

    def __init__(self, file: Path) -> None:
        self._file = file

    def paths(self) -> tuple[Path, ...]:
        """Those that are still there."""
        found = []
        for line in self._lines():
            with suppress(OSError, ValueError):
                if Path(line).is_file():
                    found.append(Path(line))
        return tuple(found)

    def add(self, path: Path) -> None:
        with suppress(OSError, ValueError):
            name = str(path.resolve())
            lines = [name, *(each for each in self._lines() if each != name)][:MOST]
            self._file.parent.mkdir(parents=True, exist_ok=True)
            self._file.write_text("".join(f"{each}\n" for each in lines), encoding="utf-8")

    def _lines(self) -> list[str]:
        try:
            if self._file.stat().st_size > LARGEST:
                return []
            return self._file.read_text(encoding="utf-8").splitlines()[:MOST]
        except (OSError, ValueError):
            return []
