"""The event stream as JSON lines, for scripts (``--events``)."""

from __future__ import annotations

import json
from collections.abc import Callable
from typing import TextIO

from donnie_tui.core.events import TRANSIENT, Stamped, as_record
from donnie_tui.core.line_file import LineFile


class JsonLines:
    """Writes every event that is not transient as one line of JSON.

    A stream that takes no more ends the writing and nothing else; ``on_failure`` is told once.
    """

    def __init__(
        self, out: TextIO, on_failure: Callable[[OSError], None] | None = None, *, whole: bool = False
    ) -> None:
        """``whole``: the events can be made again from the lines."""
        self._file = LineFile(out, on_failure)
        self._whole = whole

    def __call__(self, stamped: Stamped) -> None:
        if not isinstance(stamped.event, TRANSIENT) and self._file.takes_more:
            self._file.write(as_line(stamped, whole=self._whole))


def as_line(stamped: Stamped, *, whole: bool = False) -> str:
    """One line with its newline. Keys keep the order of the contract."""
    return json.dumps(as_record(stamped, whole=whole), ensure_ascii=False, separators=(",", ":")) + "\n"
