"""The event stream as JSON lines, for scripts (``--events``)."""

from __future__ import annotations

import json
from typing import TextIO

from donnie_tui.core.events import TRANSIENT, Stamped, as_record


class JsonLines:
    """Writes every event that is not transient as one line of JSON."""

    def __init__(self, out: TextIO) -> None:
        self._out = out

    def __call__(self, stamped: Stamped) -> None:
        if not isinstance(stamped.event, TRANSIENT):
            self._out.write(as_line(stamped))
            self._out.flush()


def as_line(stamped: Stamped) -> str:
    """One line with its newline. Keys keep the order of the contract."""
    return json.dumps(as_record(stamped), ensure_ascii=False, separators=(",", ":")) + "\n"
