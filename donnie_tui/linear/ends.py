"""Both ends of the conversation, used as it was chosen: where lines come from, and where they are printed."""

from __future__ import annotations

from msgspec import Struct

from donnie_tui.linear.console import Console
from donnie_tui.linear.options import Options, Page
from donnie_tui.linear.output import Output, Told
from donnie_tui.linear.reader import How, Reader, Typed


class Ends(Struct, frozen=True):
    """Who types, and who reads."""

    console: Console
    editing: Reader | None
    """Edits lines key by key; None where that is impossible."""
    plain: Reader
    output: Output
    told: Told
    options: Options
    prompts: bool
    """Whether somebody types: prompts are printed, and questions asked."""
    is_terminal: bool
    """Whether somebody reads, and needs rests."""
    offered: set[bool]
    """The modes that somebody was asked about whether to begin in them."""

    @property
    def has_terminal(self) -> bool:
        return self.editing is not None

    @property
    def can_edit(self) -> bool:
        """Whether a text can be offered for editing."""
        return self.reader.holds_newline

    @property
    def hears_live(self) -> bool:
        """Whether lines may be typed for a program that runs: by somebody who edits them here."""
        return self.prompts and self.can_edit

    @property
    def reader(self) -> Reader:
        """Where the next line comes from."""
        return self.editing if self.editing is not None and self.options.editor else self.plain

    @property
    def page_size(self) -> int:
        """Lines that come before somebody is asked for more; 0 if nobody is."""
        if self.options.hold:
            return 1
        return self.output.block_size if self.options.page is Page.ASK else 0

    def apply_options(self) -> None:
        """Let the terminal and the printing be as it was chosen."""
        if self.has_terminal:
            self.console.edit(self.options.editor)
        self.output.paced = self.is_terminal and self.options.page is Page.REST

    def hold_newline(self) -> None:
        """What comes next begins on a line of its own."""
        if self.prompts:
            self.output.hold_newline()

    def end_line(self, typed: Typed) -> None:
        """Where the terminal has not shown Enter's new line, it is held back until there is an answer."""
        if self.can_edit or typed.how is not How.ENTER:
            self.hold_newline()
