"""An editor without a screen."""

from collections.abc import Sequence


class Editor:
    """As the one of the full screen: a text with a cursor and its own history."""

    def __init__(self) -> None:
        self.breakpoints = frozenset[int]()
        self.text = ""
        self.line = 1
        self.selected: tuple[int, int, int] | None = None
        self._past: list[str] = []
        self._future: list[str] = []

    def type(self, text: str) -> None:
        self._past.append(self.text)
        self.text = text

    def show(self, text: str, breakpoints: frozenset[int]) -> None:
        self.text, self.breakpoints = text, breakpoints
        self._past, self._future = [], []

    def change_lines(self, lines: Sequence[str]) -> None:
        self.type("\n".join(lines))

    @property
    def cursor_location(self) -> tuple[int, int]:
        return (self.line - 1, 0) if self.selected is None else (self.selected[0], self.selected[2])

    def go_to(self, line: int) -> None:
        self.line = line

    def select(self, row: int, start: int, end: int) -> None:
        self.selected, self.line = (row, start, end), row + 1

    def replace_range(self, start: int, end: int, text: str) -> None:
        self.type(self.text[:start] + text + self.text[end:])

    def undo(self) -> None:
        if self._past:
            self._future.append(self.text)
            self.text = self._past.pop()

    def redo(self) -> None:
        if self._future:
            self._past.append(self.text)
            self.text = self._future.pop()
