"""What the own voice says of what is typed: characters, words or nothing; never beside a screen reader."""

from __future__ import annotations

from donnie_tui.audible import Audible
from donnie_tui.core.answer_log import spelled
from donnie_tui.core.wording import Wording
from donnie_tui.i18n.catalogue.signs import CODE_OF
from donnie_tui.linear.keys import Act, Key

LONGEST_PASTED = 200
"""Characters of a pasted text that are said."""


class KeyEcho:
    """Told of each key before it is done."""

    def __init__(self, audible: Audible, words: Wording) -> None:
        self._audible = audible
        self._words = words

    def __call__(self, key: Key, before: str) -> None:
        """``before``: what stands before the cursor."""
        if not self._audible.echoes:
            return
        match self._audible.settings.key_echo:
            case "characters":
                self._say_character(key, before)
            case "words":
                self._say_word(key, before)
            case _:
                pass

    def _say_character(self, key: Key, before: str) -> None:
        """What is typed, or what is deleted; a pasted text as it stands."""
        text = before[-1:] if key.act is Act.BACKSPACE else key.text
        if len(text) == 1:
            self._audible.echo(" ".join(spelled(text, CODE_OF, self._words)))
        elif text.strip():
            self._audible.echo(text[:LONGEST_PASTED])

    def _say_word(self, key: Key, before: str) -> None:
        """The word that a blank or Enter ends."""
        ends = key.act is Act.ENTER or (key.act is Act.TEXT and key.text.endswith(" "))
        typed = (before + key.text).split() if ends else []
        if typed:
            self._audible.echo(typed[-1][:LONGEST_PASTED])
