"""The command palette: Textual's, in the learner's words and without pictures."""

from __future__ import annotations

from textual.command import CommandList, CommandPalette
from textual.widgets.option_list import Option

from donnie_tui.core.wording import Wording


class Palette(CommandPalette):
    """Lists the actions; typing narrows the list, Enter does the first."""

    def __init__(self, words: Wording) -> None:
        super().__init__(placeholder=words("palette-ask"), id="--command-palette")
        self._nothing = words("palette-nothing")

    def _start_no_matches_countdown(self, search_value: str) -> None:
        """Textual says it in English."""
        self._stop_no_matches_countdown()
        self._no_matches_timer = self.set_timer(self._NO_MATCHES_COUNTDOWN, lambda: self._say(search_value))

    def _say(self, search_value: str) -> None:
        if search_value:
            self.query_one(CommandList).add_option(Option(self._nothing, disabled=True, id=self._NO_MATCHES))
        self._list_visible = bool(search_value)
