"""The words of an event as lines of text: what linear mode prints, the log shows and the voice says.

Whatever is spoken is printed: the voice takes its text from here too.
"""

from __future__ import annotations

from donnie_tui.core.events import Announced, Answered, Error, Event, Spoke
from donnie_tui.core.wording import Wording


def lines_of(event: Event, wording: Wording) -> tuple[str, ...]:
    """The lines that tell the event, none if it is not told in words."""
    match event:
        case Spoke(text=text) | Announced(text=text) | Answered(text=text):
            return tuple(text.splitlines()) or ("",)
        case Error():
            return _lines_of_error(event, wording)
        case _:
            return ()


def _lines_of_error(error: Error, wording: Wording) -> tuple[str, ...]:
    """At most three lines: where and what, the line itself, what was probably meant."""
    lines = [wording("error-at", line=error.line, column=error.column, message=error.message)]
    if error.source_line:
        lines.append(wording("error-line", line=error.line, text=error.source_line))
    if error.hint:
        lines.append(error.hint)
    return tuple(lines)
