"""What the own voice says of what is typed on the screen: in the program, the command line and questions."""

from __future__ import annotations

from textual import events
from textual.widget import Widget
from textual.widgets import Input, TextArea

from donnie_tui.core.wording import Wording
from donnie_tui.outlets.audible import Audible, TypingEcho


class KeyEcho:
    """Told of each key and each paste before the widget with the focus has it."""

    def __init__(self, audible: Audible, words: Wording) -> None:
        self._echo = TypingEcho(audible, words)

    def __call__(self, event: events.Event, focused: Widget | None) -> None:
        before = _before_cursor(focused) if self._echo.kind != "none" else None
        if before is None:
            return
        match event:
            case events.Paste(text=text):
                self._echo.typed(text, before)
            case events.Key(key="backspace"):
                self._echo.deleted(before)
            case events.Key(key="enter"):
                self._echo.ended(before)
            case events.Key(character=str() as character) if event.is_printable:
                self._echo.typed(character, before)
            case _:
                pass


def _before_cursor(widget: Widget | None) -> str | None:
    """What stands before the cursor in its line; None where nobody types."""
    match widget:
        case TextArea():
            row, column = widget.cursor_location
            return widget.document.get_line(row)[:column]
        case Input():
            return widget.value[: widget.cursor_position]
        case _:
            return None
