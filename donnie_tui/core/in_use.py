"""The files that a session reads or writes as it goes: whichever word writes, nobody saves onto them."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path


class FilesInUse:
    """Found again under whatever name."""

    def __init__(self, paths: Iterable[Path] = ()) -> None:
        self._resolved = frozenset(filter(None, map(_resolved, paths)))

    def __contains__(self, path: Path) -> bool:
        return _resolved(path) in self._resolved


def _resolved(path: Path) -> Path | None:
    try:
        return path.resolve()
    except (OSError, ValueError, RuntimeError):
        return None
