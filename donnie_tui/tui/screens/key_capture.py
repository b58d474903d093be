"""Waits for the key that an action is to have. Esc goes back, Backspace takes a chosen key away again.

The answer is the key as the settings file has it, an empty one for none, or None if somebody went back.
"""

from __future__ import annotations

from collections.abc import Callable

from textual import events
from textual.app import ComposeResult
from textual.containers import Vertical
from textual.screen import ModalScreen
from textual.widgets import Static

from donnie_tui.tui.keys import MENU, behind_menu
from donnie_tui.tui.widgets.input_line import InputLine


class _KeyLine(InputLine):
    """Where the cursor stands; keys are taken and not written."""

    def __init__(self, take: Callable[[str], None]) -> None:
        super().__init__(id="answer")
        self._take = take

    async def _on_key(self, event: events.Key) -> None:
        event.stop()
        event.prevent_default()
        self._take(event.key)


class KeyCapture(ModalScreen[str | None]):
    """Asks for one key, or one behind the menu key."""

    AUTO_FOCUS = "#answer"

    def __init__(
        self,
        asked: str,
        keys: str,
        behind: str,
        accepts: Callable[[str], str | None],
        point: Callable[[str], object],
    ) -> None:
        """``behind`` is said after the menu key; ``accepts`` answers what is wrong with a key.

        ``point`` says what is asked.
        """
        super().__init__()
        self._point = point
        self._asked, self._key_words, self._behind = asked, keys, behind
        self._accepts = accepts
        self._has_menu = False
        self._words = Static(asked, id="asked", markup=False)

    def compose(self) -> ComposeResult:
        with Vertical(id="question"):
            yield self._words
            yield _KeyLine(self._pressed)
            yield Static(f" {self._key_words}", id="question-keys", markup=False)

    def on_mount(self) -> None:
        self._point(self._asked)

    def _say(self, words: str) -> None:
        self._words.update(words)
        self._point(words)

    def _pressed(self, key: str) -> None:
        if key == "escape":
            self.dismiss(None)
        elif key == "backspace" and not self._has_menu:
            self.dismiss("")
        elif key == MENU and not self._has_menu:
            self._has_menu = True
            self._say(self._behind)
        else:
            self._try(f"{MENU} {behind_menu(key)}" if self._has_menu else key)

    def _try(self, key: str) -> None:
        wrong = self._accepts(key)
        self._has_menu = False
        if wrong is None:
            self.dismiss(key)
        else:
            self._say(wrong)
