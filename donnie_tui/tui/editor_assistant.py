"""Help while a program is typed: completion, marked mistakes, cues of blocks, and unsaved copies.

Nothing waits for any of it; what costs time comes a moment after the last letter.
"""

from __future__ import annotations

from typing import Any

from textual.app import App
from textual.timer import Timer

from donnie_tui.commands.context import Context
from donnie_tui.commands.sound import chime_block
from donnie_tui.core.program_text import LONGEST_CHECKED, Completion, completion, mistakes
from donnie_tui.tui.display import Display
from donnie_tui.tui.widgets.editor import Editor
from language.outline import block_depth

CHECK_AFTER = 0.4
"""Seconds without typing after which mistakes are marked."""

COPY_AFTER = 1.0
"""Seconds after an edit within which a copy is written."""


class EditorAssistant:
    """Follows each edit of the program."""

    def __init__(self, app: App[Any], ctx: Context, display: Display, editor: Editor) -> None:
        self._app, self._ctx, self._display, self._editor = app, ctx, display, editor
        self._checking: Timer | None = None
        self._copying: Timer | None = None

    def edited(self) -> None:
        """The text changed: check it and copy it soon."""
        self._display.show_titles()
        if self._checking is not None:
            self._checking.stop()
        self._checking = self._app.set_timer(CHECK_AFTER, self.check_now)
        if self._copying is None:
            self._copying = self._app.set_timer(COPY_AFTER, self._keep_copy)

    def check_now(self) -> None:
        """Mark the mistakes of the text as it is."""
        self._checking = None
        text, session = self._editor.text, self._ctx.donnie.session
        found = session.check(text) if 0 < len(text) <= LONGEST_CHECKED and text.strip() else ()
        self._editor.note(mistakes(found, self._ctx.words))
        self._display.say_status()

    def offer_words(self, *, wanted: bool) -> None:
        """Whether the editor shows how a word may continue."""
        self._editor.complete = self.completion if wanted else None

    def completion(self, text: str, at: int) -> Completion:
        """What could be meant at that place of the text."""
        language, colours = self._ctx.words.language, self._ctx.donnie.session.colours
        return completion(text, at, language, colours)

    def line_finished(self, row: int) -> None:
        """Enter was pressed in that row (from 0): a cue sounds for a block that it opens or closes."""
        text, donnie = self._editor.text, self._ctx.donnie
        if donnie.outlets.audible.has_cues and len(text) <= LONGEST_CHECKED:
            lines = text.split("\n")
            depths = (block_depth("\n".join(lines[:end])) for end in (row, row + 1))
            chime_block(donnie, *depths)

    # --- copies

    def _keep_copy(self) -> None:
        self._copying = None
        self._ctx.workspace.keep_copies()

    def stop_copying(self) -> None:
        """The learner leaves: the last copies are written at the end."""
        if self._copying is not None:
            self._copying.stop()
