"""What happens to the program while somebody types it: words are offered, mistakes marked, blocks heard, and
what is not saved is written down.

Rule: nobody waits for any of it; what costs time comes a moment after the last letter.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from textual.timer import Timer

from donnie_tui.commands.sound import chime_block
from donnie_tui.core.program_text import LONGEST_CHECKED, Completion, completion, mistakes
from language.outline import block_depth

if TYPE_CHECKING:
    from donnie_tui.tui.application import Host
from donnie_tui.tui.workbench import Workbench

CHECK_AFTER = 0.4
"""Seconds without typing after which mistakes are marked."""

COPY_AFTER = 1.0
"""Seconds after an edit within which it is written down."""


class WhileTyping:
    """Told of each edit."""

    def __init__(self, work: Workbench, host: Host) -> None:
        self._work = work
        self._host = host
        self._editor = work.workplace.editor
        self._checking: Timer | None = None
        self._copying: Timer | None = None

    def edited(self) -> None:
        """The text changed: write it down soon."""
        self._work.display.show_titles()
        if self._checking is not None:
            self._checking.stop()
        self._checking = self._host.later(CHECK_AFTER, self.check_now)
        if self._copying is None:
            self._copying = self._host.later(COPY_AFTER, self._keep_copy)

    def check_now(self) -> None:
        """Mark the mistakes of the text as it is."""
        self._checking = None
        text, session = self._editor.text, self._work.donnie.session
        found = session.check(text) if 0 < len(text) <= LONGEST_CHECKED and text.strip() else ()
        self._editor.note(mistakes(found, self._work.words))
        self._work.display.say_status()

    def completion(self, text: str, at: int) -> Completion:
        """What could be meant at that place of the text."""
        return completion(text, at, self._work.words.language, self._work.donnie.session.colours)

    def line_finished(self, row: int) -> None:
        """Enter was pressed in that row (from 0): a block that it opens or closes is heard."""
        text, donnie = self._editor.text, self._work.donnie
        if donnie.outlets.audible.has_cues and len(text) <= LONGEST_CHECKED:
            lines = text.split("\n")
            depths = (block_depth("\n".join(lines[:end])) for end in (row, row + 1))
            chime_block(donnie, *depths)

    # --- copies

    def _keep_copy(self) -> None:
        self._copying = None
        self._work.workspace.keep_copies()

    def stop_copying(self) -> None:
        """The learner leaves: the last copies are written at the end."""
        if self._copying is not None:
            self._copying.stop()
