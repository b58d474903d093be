"""The keys behind a key: each with what it does, and said. The next key does it, Esc goes back."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import ClassVar

from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.screen import ModalScreen
from textual.widgets import Static

from donnie_tui.core.wording import Wording
from donnie_tui.tui.actions import BY_NAME
from donnie_tui.tui.keys import MENU, key_label
from donnie_tui.tui.widgets.text_rows import TextRows


class KeyMenu(ModalScreen[None]):
    """Lists ``names``, the actions by their keys. The application does what is chosen."""

    BINDINGS: ClassVar[list[BindingType]] = [Binding("escape", "leave", show=False, priority=True)]
    AUTO_FOCUS = "#key-rows"
    READING = ("escape", "up", "down", "pageup", "pagedown", "home", "end")
    """What is pressed to read the list; any other key ends it."""

    def __init__(
        self, keys: Mapping[str, tuple[str, ...]], words: Wording, point: Callable[[str], object]
    ) -> None:
        """``point`` says what is shown."""
        super().__init__()
        self._point = point
        self.names = {
            key.partition(" ")[2]: name
            for name, each in keys.items()
            for key in each
            if key.startswith(f"{MENU} ")
        }
        self._words = words
        self.rows = TextRows(id="key-rows")

    def compose(self) -> ComposeResult:
        yield Static(f" {self._words('menu-title')}", classes="screen-title", markup=False)
        yield self.rows

    def on_mount(self) -> None:
        self.rows.show([self._row(key, name) for key, name in sorted(self.names.items(), key=_place)])
        self._point(f"{self._words('menu-title')}. {self.rows.lines[0]}")

    def _row(self, key: str, name: str) -> str:
        language = self._words.language
        word = BY_NAME[name].word(language)
        return f"{key_label(key, language)}: {word}: {self._words(f'action-{name}')}"

    def leave(self) -> None:
        """Go, as soon as it is there."""
        self.call_later(self.action_leave)

    def action_leave(self) -> None:
        self.dismiss(None)


def _place(key_and_name: tuple[str, str]) -> tuple[bool, bool, str]:
    """Letters first, then letters with Shift, then all else."""
    key = key_and_name[0]
    return not (len(key) == 1 and key.isalpha()), not key.startswith("shift+"), key
