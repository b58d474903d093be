"""What is read in a window of its own: help, keys, the manual, the tour, lists of lines; or in the pager."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from donnie_tui.commands.declarations import COMMANDS
from donnie_tui.commands.keys import MENU, PALETTE, key_label
from donnie_tui.commands.lookup import word_of
from donnie_tui.i18n.help import SCREEN_TOUR_PAGES, manual, screen_tour_page
from donnie_tui.tui.keys_here import keys_here
from donnie_tui.tui.screens.pages import Page, help_text
from language.keywords import canonical

if TYPE_CHECKING:
    from donnie_tui.tui.application import Host
from donnie_tui.tui.workbench import Workbench


class Pages:
    """Shows them."""

    def __init__(self, work: Workbench, host: Host) -> None:
        self._work = work
        self._words = work.words
        self._host = host
        self._tour_at = 0
        """The page of the tour that was left, from 0."""

    def show_lines(self, title: str, lines: Sequence[str]) -> None:
        self._host.show_help(self._words("lines-title", title=title), tuple(lines))

    def show_outside(self, text: str) -> None:
        """In the pager, where the terminal's own ways of reading work."""
        problem = self._host.show_outside(text)
        if problem is not None:
            self._work.talk.tell(problem)

    def show_tour(self) -> None:
        """The screen in a few pages, from the one that was left to try what it says."""
        self._host.show_tour(self._tour_pages, self._tour_at, self._turned)

    @property
    def _tour_pages(self) -> tuple[Page, ...]:
        words, keys = self._words, self._keys_by_name
        numbers = range(1, SCREEN_TOUR_PAGES + 1)
        return tuple(
            Page(
                words("screen-tour-title", page=each, pages=SCREEN_TOUR_PAGES),
                screen_tour_page(each, words, keys),
            )
            for each in numbers
        )

    @property
    def _keys_by_name(self) -> dict[str, str]:
        """The key of each action as it is now; of one without a key the word."""
        table, language = self._host.key_table, self._words.language
        own = {each.name: table.label(each.name, language) or word_of(each, language) for each in COMMANDS}
        return own | {"menu": key_label(MENU, language), "palette": key_label(PALETTE, language)}

    def _turned(self, at: int) -> None:
        self._tour_at = at

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
