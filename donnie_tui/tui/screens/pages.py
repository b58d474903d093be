"""Screens to read, and the keys after the menu key.

``Help`` shows lines; the first ones are spoken, then each row that is reached. ``Tour`` shows a page at
a time: Enter turns the page, Backspace turns back, Esc lets the learner try what it says; ``TourStrip`` is
the same below the panes. ``KeyMenu`` lists what each key after the menu key does; the next key does it, a
click on a row, or Enter.
``KeyCapture`` waits for the new key of a command: Esc goes back, Backspace removes a chosen key.
Its answer is the key as the settings file writes it, empty for none, or None if the learner went back.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import ClassVar

from msgspec import Struct
from rich.cells import cell_len
from textual import events
from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Vertical
from textual.geometry import Offset
from textual.widgets import Static

from donnie_tui.commands.declarations import BY_NAME
from donnie_tui.commands.keys import MENU, after_menu, key_label
from donnie_tui.commands.lookup import word_of
from donnie_tui.core.wording import Wording
from donnie_tui.tui.screens.dialogs import ClickableRows, Dialog, Panel
from donnie_tui.tui.widgets.command_line import InputLine
from donnie_tui.tui.widgets.rows import BottomKeys, DialogKeys, TextRows


class Help(Panel[None]):
    """Shows lines until Esc; F1 goes ``further`` if there is more to read."""

    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("escape,q", "dismiss", priority=True),
        Binding("ctrl+q", "dismiss", priority=True),
        Binding("f1", "further", priority=True),
    ]
    AUTO_FOCUS = "#help-rows"
    _COVERS_COMMAND_LINE = False

    def __init__(
        self,
        title: str,
        keys: str,
        lines: Sequence[str],
        point: Callable[[str], object],
        further: Callable[[], None] | None = None,
    ) -> None:
        """``point`` says what is shown."""
        super().__init__()
        self._title_words, self._keys = title, keys
        self._lines = lines
        self._point = point
        self._further = further
        self.rows = self._rows()
        self._page = Vertical()

    def _rows(self) -> TextRows:
        return TextRows(id="help-rows")

    def compose(self) -> ComposeResult:
        with self._page:
            yield Static(self._heading, id="help-title", classes="screen-title", markup=False)
            yield self.rows
        if not self.is_alone:
            yield BottomKeys(self._keys)

    @property
    def _heading(self) -> str:
        """In the plain layout, which has no bottom line, with the keys."""
        return f" {self._title_words}{f'. {self._keys}' if self.is_alone else ''}"

    def on_mount(self) -> None:
        self.on_resize()
        self._show()

    def _show(self) -> None:
        self.rows.show(self._lines)
        self._point(f"{self._title_words}. {self._keys}. {next(iter(self._lines), '')}")

    def on_resize(self) -> None:
        room = self.fit(self._page, covers_command_line=self._COVERS_COMMAND_LINE)
        self._page.styles.height = room.height

    def action_further(self) -> None:
        if self._further is None:
            self.dismiss(None)
        else:
            self._further()


class TourPage(Struct, frozen=True):
    """A page of the tour: its title, its keys and its lines."""

    title: str
    keys: str
    lines: tuple[str, ...]

    @property
    def heading(self) -> str:
        """Both in a row."""
        return f"{self.title}. {self.keys}"


class Tour(Help):
    """Begins at one of ``pages`` and closes after the last one; ``turned`` as that of the strip.

    It covers the command line too, so that a page is read as a whole.
    """

    _COVERS_COMMAND_LINE = True

    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("enter,pagedown", "turn(1)", priority=True),
        Binding("backspace,pageup", "turn(-1)", priority=True),
    ]

    def __init__(
        self,
        pages: Sequence[TourPage],
        at: int,
        turned: Callable[[int], None],
        point: Callable[[str], object],
    ) -> None:
        super().__init__(pages[at].title, pages[at].keys, pages[at].lines, point)
        self._pages, self._at, self._turned = pages, at, turned

    def _rows(self) -> TextRows:
        return ClickableRows(id="help-rows")

    def on_clickable_rows_clicked(self) -> None:
        """Turn the page, as a click on the strip does."""
        self.action_turn(1)

    def _show(self) -> None:
        page = self._pages[self._at]
        self._title_words = page.title
        self.query_one("#help-title", Static).update(self._heading)
        self.rows.show(page.lines)
        self.rows.read_line(0)
        self._point(" ".join((f"{page.heading}.", *page.lines)))

    def action_turn(self, pages: int) -> None:
        at = max(0, self._at + pages)
        if at < len(self._pages):
            self._at = at
            self._show()
        else:
            self.dismiss(None)
        self._turned(at)


class TourStrip(Vertical, can_focus=True):
    """The tour above the command line; everything else stays usable.

    With the focus Enter turns the page and Backspace turns back; a click on it turns the page, too.
    """

    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("enter,pagedown", "turn(1)"),
        Binding("backspace,pageup", "turn(-1)"),
    ]

    def __init__(
        self,
        pages: Sequence[TourPage],
        at: int,
        turned: Callable[[int], None],
        point: Callable[[str], object],
    ) -> None:
        """``turned`` gets each page, from 0; one after the last one means that the tour is done."""
        super().__init__(id="tour")
        self._pages, self._at, self._turned, self._point = pages, at, turned, point
        self._heading = DialogKeys(pages[at].heading)
        self._body = Static("\n".join(pages[at].lines), id="tour-lines", markup=False)

    def compose(self) -> ComposeResult:
        yield self._heading
        yield self._body

    @property
    def title(self) -> str:
        return self._heading.words

    @property
    def cursor_screen_offset(self) -> Offset:
        return self._body.content_region.offset

    def on_mount(self) -> None:
        self._show()

    def _show(self) -> None:
        page = self._pages[self._at]
        self._heading.say(page.heading)
        self._body.update("\n".join(page.lines))
        self._point(" ".join((f"{page.heading}.", *page.lines)))

    def action_turn(self, pages: int) -> None:
        at = max(0, self._at + pages)
        if at < len(self._pages):
            self._at = at
            self._show()
        self._turned(at)

    def on_click(self) -> None:
        self.action_turn(1)


class KeyMenu(Panel[str | None]):
    """Lists ``names``, the commands by their keys. Answers the clicked one; the application runs it."""

    BINDINGS: ClassVar[list[BindingType]] = [Binding("escape", "dismiss", priority=True)]
    AUTO_FOCUS = "#key-rows"
    READING = ("escape", "up", "down", "pageup", "pagedown", "home", "end")
    """Keys that move in the list; any other key closes it."""

    def __init__(
        self,
        keys: Mapping[str, tuple[str, ...]],
        words: Wording,
        point: Callable[[str], object],
        *,
        is_plain: bool = False,
    ) -> None:
        """``point`` says what is shown. A plain list has the whole screen, and rows of text."""
        super().__init__(classes="-plain" if is_plain else "")
        self._point = point
        self.names = {
            key.partition(" ")[2]: name
            for name, each in keys.items()
            for key in each
            if key.startswith(f"{MENU} ")
        }
        self._title_words, self._keys = words("menu-title"), words("completion-keys")
        self._sorted = sorted(self.names.items(), key=_place)
        self.cells = [
            (key_label(key, words.language), word_of(BY_NAME[name], words.language), words(f"action-{name}"))
            for key, name in self._sorted
        ]
        """For each row: the key, the word and the purpose."""
        self.rows = ClickableRows(id="key-rows")
        self._panel = Vertical(id="panel")  # a letter may close the menu before it has its children

    def compose(self) -> ComposeResult:
        with self._panel:
            keys = f". {self._keys}" if self.is_alone else ""
            yield Static(f" {self._title_words}{keys}", classes="screen-title", markup=False)
            yield self.rows
        if not self.is_alone:
            yield BottomKeys(self._keys)

    @property
    def chosen(self) -> str:
        """The command of the chosen row."""
        return self._sorted[self.rows.line][1]

    def on_clickable_rows_clicked(self) -> None:
        self.dismiss(self.chosen)

    def on_mount(self) -> None:
        self._lay_out()
        self._point(f"{self._title_words}. {self._keys}. {self._sentence(0)}")

    def on_resize(self) -> None:
        line = self.rows.line
        self._lay_out()
        if self.rows.line != line:
            self.rows.read_line(line)

    def _lay_out(self) -> None:
        """Use columns, in a panel of their width, if there is room."""
        widths = [max(map(cell_len, column)) for column in zip(*self.cells, strict=True)]
        panel, width = self._panel, sum(widths) + 2 * len(widths) + 2
        room = self.fit(panel)
        has_columns = width <= room.width and not self.has_class("-plain")
        panel.set_class(not has_columns, "-wide-as-all")
        panel.styles.width = width if has_columns else None
        panel.styles.height = room.height
        self.rows.show(
            "  ".join(cell.ljust(each) for cell, each in zip(row, widths, strict=True)).rstrip()
            if has_columns
            else self._sentence(at)
            for at, row in enumerate(self.cells)
        )

    def _sentence(self, line: int) -> str:
        return ": ".join(self.cells[line])

    def on_text_rows_read(self, event: TextRows.Read) -> None:
        """Speak the row; if it has columns, as a sentence."""
        if event.has_focus and event.text == self.rows.lines[self.rows.line]:
            event.stop()
            self._point(self._sentence(self.rows.line))

    def leave(self) -> None:
        """Close the menu once it is mounted."""
        self.call_later(self.action_dismiss)


def _place(key_and_name: tuple[str, str]) -> tuple[bool, bool, str]:
    """Sort letters first, then letters with Shift, then other keys."""
    key = key_and_name[0]
    return not (len(key) == 1 and key.isalpha()), not key.startswith("shift+"), key


class _KeyLine(InputLine):
    """The line of the cursor; it takes keys and writes none."""

    def __init__(self, take: Callable[[str], None]) -> None:
        super().__init__(id="answer")
        self._take = take

    async def _on_key(self, event: events.Key) -> None:
        event.stop()
        event.prevent_default()
        self._take(event.key)


class KeyCapture(Dialog[str | None]):
    """Asks for one key, or one after the menu key."""

    AUTO_FOCUS = "#answer"

    def __init__(
        self,
        asked: str,
        keys: str,
        asked_after_menu: str,
        accepts: Callable[[str], str | None],
        point: Callable[[str], object],
    ) -> None:
        """``asked_after_menu`` is asked after the menu key; ``accepts`` returns what is wrong with a key.

        ``point`` says what is asked.
        """
        super().__init__()
        self._point = point
        self._asked, self._key_words, self._asked_after_menu = asked, keys, asked_after_menu
        self._accepts = accepts
        self._has_menu = False
        self._words = Static(asked, id="asked", markup=False)
        self._panel = Vertical(id="question")

    def compose(self) -> ComposeResult:
        with self._panel:
            yield self._words
            yield _KeyLine(self._pressed)
        yield BottomKeys(self._key_words)

    def on_mount(self) -> None:
        self._point(self._asked)

    def on_resize(self) -> None:
        self.fit(self._panel, covers_command_line=True)

    def _say(self, words: str) -> None:
        self._words.update(words)
        self._point(words)

    def _pressed(self, key: str) -> None:
        if key == "escape":
            self.dismiss(None)
        elif key == "backspace" and not self._has_menu:
            self.dismiss("")
        elif key == MENU and not self._has_menu:
            self._has_menu = True
            self._say(self._asked_after_menu)
        else:
            self._try(f"{MENU} {after_menu(key)}" if self._has_menu else key)

    def _try(self, key: str) -> None:
        wrong = self._accepts(key)
        self._has_menu = False
        if wrong is None:
            self.dismiss(key)
        else:
            self._say(wrong)
