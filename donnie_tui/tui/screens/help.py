"""The help: every key and word of the screen, then every command of GoDonnie. Rows to read, nothing else.

What is shown first is said; each row is said as it is reached.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import ClassVar

from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.screen import ModalScreen
from textual.widgets import Static

from donnie_tui.core.use_cases import help_line
from donnie_tui.core.wording import Wording
from donnie_tui.tui.actions import ACTIONS, Action
from donnie_tui.tui.key_table import KeyTable
from donnie_tui.tui.widgets.text_rows import TextRows


class Help(ModalScreen[None]):
    """Shows lines until Esc; F1 goes ``further`` where there is more to read."""

    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("escape,q", "dismiss", show=False, priority=True),
        Binding("ctrl+q", "dismiss", show=False, priority=True),
        Binding("f1", "further", show=False, priority=True),
    ]
    AUTO_FOCUS = "#help-rows"

    def __init__(
        self,
        title: str,
        lines: Sequence[str],
        point: Callable[[str], object],
        further: Callable[[], None] | None = None,
    ) -> None:
        """``point`` says what is shown."""
        super().__init__()
        self._title_words = title
        self._lines = lines
        self._point = point
        self._further = further
        self.rows = TextRows(id="help-rows")

    def compose(self) -> ComposeResult:
        yield Static(f" {self._title_words}", id="help-title", classes="screen-title", markup=False)
        yield self.rows

    def on_mount(self) -> None:
        self.rows.show(self._lines)
        self._point(f"{self._title_words}. {next(iter(self._lines), '')}")

    def action_further(self) -> None:
        if self._further is None:
            self.dismiss(None)
        else:
            self._further()


def help_text(words: Wording, table: KeyTable) -> tuple[str, ...]:
    """The lines of the help, in the learner's language."""
    listed = [action for action in ACTIONS if not action.hidden]
    return (
        words("help-screen-words"),
        *(_line(action, words, table) for action in listed),
        words("help-palette"),
        words("help-program-words"),
        *_program_lines(listed, words),
    )


def _program_lines(listed: Sequence[Action], words: Wording) -> tuple[str, ...]:
    """GoDonnie's commands, but for those that the screen has listed."""
    told = {action.word(words.language) for action in listed}
    return tuple(line for line in words.help(None) if line.partition(":")[0] not in told)


def _line(action: Action, words: Wording, table: KeyTable) -> str:
    """The typed word first: it works everywhere; then its keys, then what it does."""
    return help_line(action.case, words, table.labels(action.name, words.language))
