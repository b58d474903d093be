"""The files that a session reads or writes as it goes: whichever word writes, nobody saves onto them."""

from __future__ import annotations

import os
from collections.abc import Iterable


class FilesInUse:
    """Found again under whatever name."""

    def __init__(self, names: Iterable[str] = ()) -> None:
        self._names = tuple(names)

    def __contains__(self, name: str) -> bool:
        return _resolved(name) in map(_resolved, self._names)


def _resolved(name: str) -> str:
    try:
        return os.path.realpath(name)
    except (OSError, ValueError):
        return name
