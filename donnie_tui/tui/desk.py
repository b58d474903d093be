"""What a file is opened onto: the text in the editor, and the person whom the file actions ask and tell."""

from __future__ import annotations

from typing import Protocol

from donnie_tui.core.documents import DocumentError
from donnie_tui.core.typed_words import answered
from donnie_tui.core.wording import Wording
from donnie_tui.tui.running import Answer
from donnie_tui.tui.talk import Talk


class Desk(Protocol):
    """What a file is opened onto: an editor, and somebody to ask."""

    talk: Talk

    @property
    def text(self) -> str: ...

    @property
    def breakpoints(self) -> frozenset[int]: ...

    def load(self, text: str, breakpoints: frozenset[int] = frozenset()) -> None: ...


def told(error: DocumentError) -> Answer:
    """What went wrong with a file."""
    return Answer(error.code, {"path": error.path, "reason": error.reason})


class YesOrNo:
    """Questions about a file that are answered with yes or no, in any language."""

    def __init__(self, desk: Desk, words: Wording) -> None:
        self._desk = desk
        self._words = words

    async def ask(self, asked: str, name: str) -> bool | None:
        """The answer to a question, None if somebody went back."""
        question = self._words(asked, name=name)

        def unclear(typed: str) -> str | None:
            return None if answered(typed) is not None else f"{self._words('ask-yes-no')} {question}"

        typed = await self._desk.talk.ask(question, accepts=unclear)
        return None if typed is None else answered(typed)
