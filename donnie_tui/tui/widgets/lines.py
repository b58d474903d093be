"""The fixed rows at the bottom: the status line and the keys. Written only when their words change."""

from __future__ import annotations

from collections.abc import Sequence

from textual.events import Click
from textual.message import Message
from textual.widgets import Static

_GAP = "  "


class FixedLine(Static):
    """One sentence after the other, plain text."""

    def __init__(self, *, id: str) -> None:  # noqa: A002 -- Textual's own name
        super().__init__(id=id, markup=False)
        self.words = ""
        self._choices: tuple[str, ...] = ("",)

    def say(self, *choices: str) -> None:
        """The first of the choices for which there is room, or the last."""
        self._choices = choices
        self._write()

    def on_resize(self) -> None:
        self._write()

    def _write(self) -> None:
        room = self.size.width * max(1, self.size.height)
        words = next((each for each in self._choices if len(each) <= room), self._choices[-1])
        if words != self.words:
            self.words = words
            self.update(words, layout=False)


class KeyLine(FixedLine):
    """What can be pressed now: as many entries as there is room for, the most important first."""

    class Clicked(Message):
        """An entry was clicked: the same as its key."""

        def __init__(self, action: str) -> None:
            super().__init__()
            self.action = action

    def __init__(self, *, id: str) -> None:  # noqa: A002 -- Textual's own name
        super().__init__(id=id)
        self._entries: tuple[tuple[str, str], ...] = ()

    def offer(self, entries: Sequence[tuple[str, str]]) -> None:
        """Actions with the words that are shown for them."""
        self._entries = tuple(entries)
        self._fit()

    def on_click(self, event: Click) -> None:
        place = event.get_content_offset(self)
        begin = 1
        for action, entry in self._entries:
            if place is not None and begin <= place.x < min(begin + len(entry), len(self.words)):
                self.post_message(self.Clicked(action))
            begin += len(entry) + len(_GAP)

    def on_resize(self) -> None:
        self._fit()

    def _fit(self) -> None:
        room = self.size.width - 1
        shown: list[str] = []
        for _action, entry in self._entries:
            room -= len(entry) + (len(_GAP) if shown else 0)
            if room < 0:
                break
            shown.append(entry)
        self.say(f" {_GAP.join(shown)}")
