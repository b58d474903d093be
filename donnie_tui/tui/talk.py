"""What somebody is told at the screen, and asked.

Rule: whatever is shown is said too, so it goes through the hub.
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, TypeVar

from donnie_tui.core.events import Pointed
from donnie_tui.core.transcript import with_robot_name
from donnie_tui.tui import patience
from donnie_tui.tui.answer import Answer

if TYPE_CHECKING:
    from textual.geometry import Offset

    from donnie_tui.bootstrap import Donnie
    from donnie_tui.commands.interaction import Option
    from donnie_tui.tui.application import Host

T = TypeVar("T")


class Talk:
    """Between the work and whoever works."""

    def __init__(self, host: Host, donnie: Donnie) -> None:
        self._host = host
        self._donnie = donnie
        self._words = donnie.words

    # --- telling

    def tell(self, answer: Answer | None) -> None:
        """An answer of our own."""
        if answer is not None:
            sentence, robot = self._words(answer.code, **answer.values), self._donnie.session.hub.robot
            self.tell_sentences(with_robot_name(robot if answer.of_robot else None, sentence, self._words))

    def tell_sentences(self, *sentences: str) -> None:
        """Answers that are sentences already."""
        self._donnie.publish_answers(*sentences)

    def point(self, words: str) -> None:
        """Say what somebody looks at on the map or in a list; any key ends it, and it stands in no log."""
        self._donnie.session.hub.publish(Pointed(words))

    # --- asking

    async def ask(
        self, asked: str, value: str = "", accepts: Callable[[str], str | None] | None = None
    ) -> str | None:
        return await self._host.ask(asked, self._words("ask-keys"), value, accepts)

    async def choose(self, title: str, choices: Sequence[Option]) -> str | None:
        keys, nothing = self._words("chooser-keys"), self._words("palette-nothing")
        return await self._host.choose(title, keys, nothing, choices)

    async def press_key(self, asked: str, accepts: Callable[[str], str | None]) -> str | None:
        keys, behind = self._words("keys-capture"), self._words("keys-second-key")
        return await self._host.press_key(asked, keys, behind, accepts)

    async def choose_word(self, words: Sequence[str], below: Offset) -> tuple[str, str]:
        return await self._host.choose_word(words, below)

    # --- what may take long

    async def patiently(self, do: Callable[[], T], slow: Answer) -> T:
        """Do what may take long beside the screen; ``slow`` is told if it does, again and again.

        Where something else is asked for meanwhile, it is told that nothing comes of it.
        """
        try:
            return await patience.patiently(self._host, do, lambda: self.tell(slow))
        except asyncio.CancelledError:
            self.tell(Answer("answer-unchanged"))
            raise
