"""Programs for the commands: from a file, or from standard input for ``-``."""

from __future__ import annotations

import sys
from pathlib import Path

from devices.ports.values import Frozen
from donnie_tui.core.documents import LARGEST, DocumentError, decode, read_to_the_end
from donnie_tui.i18n.words import Unusable, Words


class Source(Frozen):
    """A program's text, and what it is called."""

    name: str
    text: str
    path: Path | None
    """None for standard input."""


def read_source(name: str, words: Words) -> Source:
    """Raises ``Unusable``."""
    try:
        if name == "-":
            return Source("-", _standard_input(), None)
        return Source(name, read_to_the_end(Path(name)), Path(name))
    except DocumentError as error:
        raise Unusable(words(error.code, path=error.path, reason=error.reason)) from None


def _standard_input() -> str:
    if sys.stdin is None:
        return ""
    return decode(sys.stdin.buffer.read(LARGEST + 1), "-")
