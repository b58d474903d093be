"""What the own voice says of the keys of the linear mode."""

from __future__ import annotations

from donnie_tui.core.wording import Wording
from donnie_tui.linear.keys import Act, Key
from donnie_tui.outlets.audible import Audible
from donnie_tui.words.typing_echo import TypingEcho


class KeyEcho:
    """Told of each key before it is done."""

    def __init__(self, audible: Audible, words: Wording) -> None:
        self._echo = TypingEcho(audible, words)

    def __call__(self, key: Key, before: str) -> None:
        """``before``: what stands before the cursor."""
        match key.act:
            case Act.BACKSPACE:
                self._echo.deleted(before)
            case Act.ENTER:
                self._echo.ended(before)
            case _:
                self._echo.typed(key.text, before)
