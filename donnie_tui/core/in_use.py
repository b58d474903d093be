"""The files that the session of this process reads or writes as it goes: nobody saves a program onto them.

One for the whole process, because files are: whichever word writes, the recording it would cut off is the
same. Rule: who keeps a file gives it back when its session ends.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from pathlib import Path

_kept: list[frozenset[Path]] = []


def keep(paths: Iterable[Path]) -> Callable[[], None]:
    """These files are in use until what is answered is called."""
    files = frozenset(filter(None, map(_resolved, paths)))
    _kept.append(files)
    return lambda: _kept.remove(files)


def is_in_use(path: Path) -> bool:
    resolved = _resolved(path)
    return any(resolved in files for files in _kept)


def _resolved(path: Path) -> Path | None:
    try:
        return path.resolve()
    except (OSError, ValueError, RuntimeError):
        return None
