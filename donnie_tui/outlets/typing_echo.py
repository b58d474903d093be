"""What the own voice says of what is typed, for both front ends: characters, words or nothing.

Never beside a screen reader, which says that itself.
"""

from __future__ import annotations

from donnie_tui.core.answer_log import spelled
from donnie_tui.core.wording import Wording
from donnie_tui.outlets.audible import Audible

LONGEST_PASTED = 200
"""Characters of a pasted text that are said."""


class TypingEcho:
    """Told of each change before it is done. ``before`` is what stands before the cursor."""

    def __init__(self, audible: Audible, words: Wording) -> None:
        self._audible = audible
        self._words = words

    @property
    def kind(self) -> str:
        """What is wanted; ``none`` where somebody else says it."""
        return self._audible.settings.key_echo if self._audible.echoes else "none"

    def typed(self, text: str, before: str) -> None:
        """Something is written: a character, or a pasted text."""
        if self.kind == "characters":
            self._say(text)
        elif self.kind == "words" and text.endswith(" "):
            self._say_word(before + text)

    def deleted(self, before: str) -> None:
        """The character before the cursor goes."""
        if self.kind == "characters":
            self._say(before[-1:])

    def ended(self, before: str) -> None:
        """Enter ends a word too."""
        if self.kind == "words":
            self._say_word(before)

    def _say(self, text: str) -> None:
        if len(text) == 1:
            from donnie_tui.i18n.messages import SPELLING_OF_SIGN

            self._audible.echo(" ".join(spelled(text, SPELLING_OF_SIGN, self._words)))
        elif text.strip():
            self._audible.echo(text[:LONGEST_PASTED])

    def _say_word(self, line: str) -> None:
        words = line.split()
        if words:
            self._audible.echo(words[-1][:LONGEST_PASTED])
