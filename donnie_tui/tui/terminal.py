"""Adapts Textual to terminals that are slow, plain, without colours, or read aloud.

A style sheet is read once, unchanged cells are not painted again, no byte is written that a terminal may
show as letters, and the terminal's own cursor follows the focus.
"""

from __future__ import annotations

import codecs
import os
import re
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from functools import partial
from typing import TYPE_CHECKING, Any

from rich.cells import cell_len
from rich.console import Console, RenderableType
from rich.segment import Segment
from textual.app import App
from textual.color import Color
from textual.events import InputEvent, Resize
from textual.filter import LineFilter
from textual.geometry import Offset, Size
from textual.message import Message
from textual.screen import Screen
from textual.timer import Timer, TimerCallback
from textual.widgets import Input, TextArea

from donnie_tui.settings.settings import Settings
from donnie_tui.tui import themes
from donnie_tui.tui.environment import wants_mouse
from language.source import HARMFUL

if TYPE_CHECKING:
    from donnie_tui.tui.terminal_output import Painted


def diff_output(console: Console) -> Painted | None:
    """Removes unchanged cells from the output; None if this version of Textual doesn't fit."""
    try:
        from donnie_tui.tui.terminal_output import Painted, fits
    except (ImportError, TypeError):
        return None
    return Painted() if fits(console) else None


def use_mouse(driver: Any, *, wanted: bool) -> None:
    """Turn mouse reports on or off; does nothing without a terminal. A test guards the names."""
    if not hasattr(driver, "_enable_mouse_support"):
        return
    if wanted and not driver._mouse:
        driver._mouse = True
        driver._enable_mouse_support()
    elif driver._mouse and not wanted:
        driver._disable_mouse_support()
        driver._mouse = False


def _terminal_size(driver: Any) -> Size | None:
    """The size of the terminal now; None where Textual asks no terminal for it."""
    if not hasattr(driver, "_get_terminal_size") or getattr(driver, "_in_band_window_resize", False):
        return None
    return Size(*driver._get_terminal_size())


def take_any_bytes(driver: type) -> None:
    """Decode a byte that is no UTF-8, from a terminal with another encoding, as "\ufffd".

    Textual's driver would end the screen.
    """
    module: Any = sys.modules[driver.__module__]
    if hasattr(module, "getincrementaldecoder"):
        module.getincrementaldecoder = lambda name: partial(
            codecs.getincrementaldecoder(name), errors="replace"
        )


def _stop_reading(driver: Any) -> None:
    """Stop reading as Textual's driver does, but keep the input that was not read yet."""
    import signal

    if driver.exit_event.is_set():
        return
    signal.signal(signal.SIGWINCH, signal.SIG_DFL)
    driver._disable_mouse_support()
    driver.exit_event.set()
    if driver._key_thread is not None:
        driver._key_thread.join()


LONGEST_READ = 1.0
"""Seconds within which the thread that reads the terminal ends."""

SHOW_CURSOR = "\x1b[?25h"

_HARMFUL = re.compile(HARMFUL)


def unskipped(timer: Timer) -> Timer:
    """Make a new timer call even if the computer was too busy to begin it in time.

    Textual skips a late timer to its next time, which one that has only one time never reaches.
    """
    timer._skip = False
    return timer


class TerminalApp(App[int], inherit_bindings=False):
    """The themes and the output; subclasses decide what is shown."""

    def __init__(self, settings: Settings) -> None:
        self._variables_of: dict[str, dict[str, str]] = {}
        """The variables by theme; Textual asks for them repeatedly before the first frame."""
        super().__init__(ansi_color=True if "NO_COLOR" in os.environ else None)  # the filters ask at once
        take_any_bytes(self.driver_class)
        self._kept_input: list[Message] = []
        self._keeps_input = False
        self.animation_level = "none"
        for name in themes.NAMES:
            self.register_theme(themes.theme(name))
        self.theme = themes.TERMINAL if self.no_color else themes.name_of(settings.theme)
        self._read_with = self.get_css_variables()
        """The colours and sizes of the last reading of the style sheets."""
        self.stylesheet.set_variables(self._read_with)
        self._filters.append(PrintableFilter())
        self._painted = diff_output(self.console)

    def set_timer(
        self,
        delay: float,
        callback: TimerCallback | None = None,
        *,
        name: str | None = None,
        pause: bool = False,
    ) -> Timer:
        """As Textual's, but never skipped."""
        return unskipped(super().set_timer(delay, callback, name=name, pause=pause))

    # --- the looks

    def apply_settings(self, settings: Settings) -> None:
        """Apply the theme, if there are colours, and the use of the mouse."""
        if not self.no_color:
            self.theme = themes.name_of(settings.theme)
        use_mouse(self._driver, wanted=wants_mouse(settings))

    def get_css_variables(self) -> dict[str, str]:
        """The variables of the theme, cached since themes never change."""
        if self.theme not in self._variables_of:
            self._variables_of[self.theme] = super().get_css_variables()
        self.theme_variables = self._variables_of[self.theme]
        return self.theme_variables

    def get_theme_variable_defaults(self) -> dict[str, str]:
        """The variables with which the style sheet is read before a theme is chosen."""
        return themes.theme(themes.DARK).variables

    def refresh_css(self, animate: bool = True) -> None:
        """Restyle, but not at the start of the application, when nothing has changed."""
        variables = self.get_css_variables()
        if variables != self._read_with:
            self._read_with = variables
            super().refresh_css(animate)

    # --- the input

    def keep_input(self) -> None:
        """Stop reading the terminal; its input is kept, also what was read and is not handled yet."""
        driver: Any = self._driver
        if driver is None:
            return
        self._keeps_input = True
        if hasattr(driver, "attrs_before"):
            _stop_reading(driver)
            driver.disable_input = partial(_stop_reading, driver)
        driver.send_message = self._kept_input.append

    def post_message(self, message: Message) -> bool:
        """As Textual's, which drops what arrives while the screen closes: input is kept for the next one."""
        is_taken = super().post_message(message)
        if not is_taken and self._keeps_input and isinstance(message, InputEvent):
            self._kept_input.append(message)
        return is_taken

    def messages_not_taken(self) -> list[Message]:
        """The messages that were not handled, in order, after the screen has closed."""
        thread = getattr(self._driver, "_key_thread", None)
        if thread is not None:
            thread.join(LONGEST_READ)
        waiting: list[Message | None] = []
        while not self._message_queue.empty():
            waiting.append(self._message_queue.get_nowait())
        return [each for each in (*waiting, *self._kept_input) if each is not None]

    # --- the output

    @property
    def is_read_by_rows(self) -> bool:
        """Whether a screen reader may read the output, so that rows are written whole."""
        return False

    def _display(self, screen: Screen[Any], renderable: RenderableType | None) -> None:
        """Filter all output. In the plain layout rows are written whole, since readers speak them."""
        if self._painted is not None:
            is_typing = isinstance(screen.focused, (TextArea, Input))
            typing = self.cursor_position if is_typing else None
            renderable = self._painted.less(renderable, rows=self.is_read_by_rows, typing=typing)
        super()._display(screen, renderable)

    @contextmanager
    def suspend(self) -> Iterator[None]:
        """As Textual's, with a full repaint after the other program, which wrote over the terminal."""
        with super().suspend():
            yield
        self.repaint()

    def repaint(self) -> None:
        """Paint everything again: another program may have written over the terminal."""
        self._forget_cells()
        self.refresh()
        self.show_cursor()

    def _forget_cells(self) -> None:
        if self._painted is not None:
            self._painted.forget()

    def on_resize(self, event: Resize) -> None:
        """Repaint: a terminal moves its content, even if its size is restored before Textual notices.

        A size that the terminal no longer has is not used: a signal that interrupts the handler of the one
        before it lets Textual post the two sizes in reversed order.
        """
        self._forget_cells()
        if (now := _terminal_size(self._driver)) not in (None, event.size):
            event.prevent_default().stop()
            self.post_message(Resize(now, now))
            return
        if self._size is not None and event.size in (self._size, self.screen.size):
            self.repaint()

    def _set_pointer_shape(self, shape: str) -> None:
        """Write no pointer shape: it costs bytes, and a console shows it as letters."""

    @property
    def cursor_position(self) -> Offset:
        """The place of the terminal's own cursor, given by the focused widget at every update."""
        place = getattr(self.focused, "cursor_screen_offset", None) if self.is_running else None
        return place if isinstance(place, Offset) else Offset(0, 0)

    @cursor_position.setter
    def cursor_position(self, _place: Offset) -> None:
        """Ignore the value: Textual's editor and input line set it even without the focus."""

    def on_ready(self) -> None:
        self.show_cursor()

    def show_cursor(self) -> None:
        """Show the terminal's cursor, which Textual hides; braille displays and console readers need it."""
        if self._driver is not None:
            self._driver.write(SHOW_CURSOR)


class PrintableFilter(LineFilter):
    """Removes control characters of programs and file names, which could set the terminal's title.

    A character with a width becomes blanks, one without disappears.
    """

    def apply(self, segments: list[Segment], background: Color) -> list[Segment]:  # noqa: ARG002 -- Textual's
        return [_printable(segment) for segment in segments]


def _printable(segment: Segment) -> Segment:
    text, style, control = segment
    if control or (text.isascii() and text.isprintable()) or not _HARMFUL.search(text):
        return segment
    return Segment(_HARMFUL.sub(_blank, text), style)


def _blank(found: re.Match[str]) -> str:
    return " " * cell_len(found.group())
