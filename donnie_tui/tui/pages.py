"""What is read in a window of its own: help, keys, the manual, the tour, lists of lines; or in the pager."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from donnie_tui.i18n.manual import manual
from donnie_tui.i18n.tour import tour
from donnie_tui.tui.keys_here import keys_here
from donnie_tui.tui.screens.help import help_text
from language.keywords import canonical

if TYPE_CHECKING:
    from donnie_tui.tui.workbench import Host, Workbench


class Pages:
    """Shows them."""

    def __init__(self, work: Workbench, host: Host) -> None:
        self._work = work
        self._words = work.words
        self._host = host

    def show_lines(self, title: str, lines: Sequence[str]) -> None:
        self._host.show_help(self._words("lines-title", title=title), tuple(lines))

    def show_outside(self, text: str) -> None:
        """In the pager, where the terminal's own ways of reading work."""
        problem = self._host.show_outside(text)
        if problem is not None:
            self._work.tell(problem)

    def show_tour(self) -> None:
        """Donnie in a few pages, the same as in the linear mode."""
        self.show_lines(self._words("tour-title"), tour(self._words))

    def show_manual(self) -> None:
        self._host.show_help(self._words("manual-title"), manual(self._words))

    def show_help(self) -> None:
        """The word at the cursor of the program first, where it is one of GoDonnie's; then everything.

        From there F1 goes on to the manual.
        """
        about = self._about_word() if self._work.workplace.editor.has_focus else ()
        everything = help_text(self._words, self._host.key_table)
        lines = (*about, *self._keys_here(), self._words("help-further"), *everything)
        self._host.show_help(self._words("help-title"), lines, self.show_manual)

    def _about_word(self) -> tuple[str, ...]:
        word = self._work.workplace.editor.word
        return self._words.help(word) if word and canonical(word) is not None else ()

    def show_keys_here(self) -> None:
        """What can be pressed where the focus is."""
        lines = self._keys_here()
        self.show_lines(lines[0].rstrip(":."), lines[1:])

    def _keys_here(self) -> tuple[str, ...]:
        return keys_here(self._work.workplace, self._words, self._host.key_table)
