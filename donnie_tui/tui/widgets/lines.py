"""The fixed rows at the bottom: the status line and the keys. Written only when their words change."""

from __future__ import annotations

from collections.abc import Sequence

from textual.widgets import Static

_GAP = "  "


class FixedLine(Static):
    """One sentence after the other, plain text."""

    def __init__(self, *, id: str) -> None:  # noqa: A002 -- Textual's own name
        super().__init__(id=id, markup=False)
        self.words = ""

    def say(self, words: str) -> None:
        if words != self.words:
            self.words = words
            self.update(words, layout=False)


class KeyLine(FixedLine):
    """What can be pressed now: as many entries as there is room for, the most important first."""

    def __init__(self, *, id: str) -> None:  # noqa: A002 -- Textual's own name
        super().__init__(id=id)
        self._entries: tuple[str, ...] = ()

    def offer(self, entries: Sequence[str]) -> None:
        self._entries = tuple(entries)
        self._write()

    def on_resize(self) -> None:
        self._write()

    def _write(self) -> None:
        room = self.size.width - 1
        shown: list[str] = []
        for entry in self._entries:
            room -= len(entry) + (len(_GAP) if shown else 0)
            if room < 0:
                break
            shown.append(entry)
        self.say(f" {_GAP.join(shown)}")
