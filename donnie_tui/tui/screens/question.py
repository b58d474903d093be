"""A question at the bottom of the screen, answered by typing. Esc, or Enter alone, goes back."""

from __future__ import annotations

from collections.abc import Callable
from typing import ClassVar

from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Vertical
from textual.screen import ModalScreen
from textual.widgets import Input, Static

from donnie_tui.tui.widgets.input_line import InputLine


class Question(ModalScreen[str | None]):
    """Asks for one line. ``accepts`` answers what is wrong with an answer, or None if nothing is."""

    BINDINGS: ClassVar[list[BindingType]] = [Binding("escape", "go_back", show=False, priority=True)]
    AUTO_FOCUS = "#answer"

    def __init__(
        self,
        asked: str,
        keys: str,
        point: Callable[[str], object],
        *,
        value: str = "",
        accepts: Callable[[str], str | None] | None = None,
    ) -> None:
        """``point`` says what is asked."""
        super().__init__()
        self._point = point
        self._asked = asked
        self._keys = keys
        self._value = value
        self._accepts = accepts

    def compose(self) -> ComposeResult:
        with Vertical(id="question"):
            yield Static(self._asked, id="asked", markup=False)
            yield InputLine(self._value, id="answer")
            yield Static(f" {self._keys}", id="question-keys", markup=False)

    def on_mount(self) -> None:
        self.query_one(InputLine).select_all()  # what is proposed is typed over
        self._point(f"{self._asked} {self._value}".strip())

    def on_input_submitted(self, event: Input.Submitted) -> None:
        event.stop()
        answer = event.value.strip()
        wrong = self._accepts(answer) if self._accepts else None
        if wrong:
            self.query_one("#asked", Static).update(wrong)
            self.query_one(InputLine).select_all()
            self._point(wrong)
        else:
            self.dismiss(answer or None)

    def action_go_back(self) -> None:
        self.dismiss(None)
