"""The event stream as JSON lines, for scripts (``--events``)."""

from __future__ import annotations

import json
from collections.abc import Callable
from typing import TextIO

from donnie_tui.core.events import TRANSIENT, Stamped, as_record


class JsonLines:
    """Writes every event that is not transient as one line of JSON.

    A stream that takes no more ends the writing and nothing else; ``on_failure`` is told once.
    """

    def __init__(
        self, out: TextIO, on_failure: Callable[[OSError], None] | None = None, *, whole: bool = False
    ) -> None:
        """``whole``: the events can be made again from the lines."""
        self._out = out
        self._on_failure = on_failure
        self._whole = whole
        self._has_failed = False

    def __call__(self, stamped: Stamped) -> None:
        if isinstance(stamped.event, TRANSIENT) or self._has_failed or self._out.closed:
            return
        try:
            self._out.write(as_line(stamped, whole=self._whole))
            self._out.flush()
        except OSError as problem:
            self._has_failed = True
            if self._on_failure:
                self._on_failure(problem)


def as_line(stamped: Stamped, *, whole: bool = False) -> str:
    """One line with its newline. Keys keep the order of the contract."""
    return json.dumps(as_record(stamped, whole=whole), ensure_ascii=False, separators=(",", ":")) + "\n"
