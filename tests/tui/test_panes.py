"""The panes of the main screen and the command line, alone: titles, the focus, what is typed."""

from __future__ import annotations

import pytest
from textual.app import App, ComposeResult
from textual.geometry import Offset
from textual.message import Message

from donnie_tui.core.session_log import LineHistory
from donnie_tui.tui.widgets.command_line import CommandLine, Pane
from tests.tui.test_fixed_rows import click


class Panes(App[None]):
    """A pane of 20 columns with a command line in it, another one, and what was posted."""

    AUTO_FOCUS = None

    def __init__(self) -> None:
        super().__init__()
        self.posted: list[Message] = []
        self.sent: list[str] = []
        self.line = CommandLine(id="line", send=lambda: self.sent.append(self.line.value))
        self.other = CommandLine(id="other")
        self.pane, self.below = Pane(self.line, id="pane"), Pane(self.other, id="below")
        for each in (self.pane, self.below):
            each.styles.width, each.styles.height = 20, 3

    def compose(self) -> ComposeResult:
        yield self.pane
        yield self.below

    def on_command_line_typed(self, message: Message) -> None:
        self.posted.append(message)

    on_pane_title_clicked = on_command_line_typed

    @property
    def painted(self) -> str:
        return self.pane._heading.render_line(0).text.rstrip()


TITLES = [
    (("a" * 15, "b" * 14), "N ^", " " + "b" * 14 + " N ^"),
    (("a" * 14, "b"), "N ^", " " + "a" * 14 + " N ^"),
    (("a" * 15, "b" * 16), "N ^", " " + "b" * 13 + "… N ^"),
    (("日" * 8, "日" * 7), "N ^", " " + "日" * 7 + " N ^"),
    (("short",), "N ^", " short" + " " * 10 + "N ^"),
    (("a" * 30, "b"), "", " " + "a" * 19),
    (("a", "b"), "N" * 19, " a"),
]


async def test_a_title_leaves_its_corner_in_sight_and_is_the_first_with_room():
    """In 20 columns: a mark, fifteen cells or less, a blank, and a corner of three."""
    app = Panes()
    async with app.run_test(size=(60, 10)) as pilot:
        await pilot.pause()
        for titles, corner, shown in TITLES:
            app.pane.entitle(*titles, corner=corner)
            await pilot.pause()
            assert app.painted == shown
        app.pane.entitle("a" * 15, "b" * 16, corner="N ^")
        app.pane.styles.width = 23
        await pilot.pause()
        assert app.painted == " " + "a" * 15 + "   N ^", "another width, another title"
        app.pane.entitle("[red]x[/]")
        await pilot.pause()
        assert app.painted == " [red]x[/]"


async def test_the_title_of_the_pane_with_the_focus_has_a_mark():
    app = Panes()
    async with app.run_test(size=(60, 10)) as pilot:
        app.pane.entitle("Map")
        for focus, mark in ((app.line, ">"), (app.other, " "), (app.line, ">"), (None, " ")):
            app.set_focus(focus)
            await pilot.pause()
            assert (app.painted, app.pane.has_class("-chosen")) == (f"{mark}Map".rstrip(), mark == ">")
            assert app.below.has_class("-chosen") is (focus is app.other)


async def test_only_a_click_on_a_title_is_meant_for_it():
    app = Panes()
    async with app.run_test(size=(60, 10)) as pilot:
        await pilot.pause()
        for widget, clicked in ((app.line, []), (app.pane, []), (app.pane._heading, [app.pane])):
            app.pane.on_click(click(widget, 1))
            await pilot.pause()
            assert [each.pane for each in app.posted if isinstance(each, Pane.TitleClicked)] == clicked


async def test_a_typed_line_is_posted_without_blanks_cleared_and_recalled():
    app = Panes()
    async with app.run_test(size=(60, 10)) as pilot:
        app.line.focus()
        for typed, lines in ((" FW 1 ", ["FW 1"]), ("  ", ["FW 1"]), ("FW 2", ["FW 1", "FW 2"])):
            app.line.value = typed
            await pilot.press("enter")
            await pilot.pause()
            assert [each.text for each in app.posted] == lines
            assert app.line.value == ""
        assert app.sent == [" FW 1 ", "FW 2"], "before the line is cleared"
        app.line.value = "new"
        for key, value in (("up", "FW 2"), ("up", "FW 1"), ("up", "FW 1"), ("down", "FW 2"), ("down", "new")):
            await pilot.press(key)
            assert (app.line.value, app.line.cursor_position) == (value, len(value))
        past = LineHistory()
        past.remember("BW 1")
        app.line.have_typed(past)
        await pilot.press("up")
        assert (app.line.value, app.line.past) == ("BW 1", past)


@pytest.mark.parametrize(
    ("typed", "cursor", "column"), [("", 0, 0), ("abc", 3, 3), ("abc", 1, 1), ("日本x", 2, 4), ("a\tb", 3, 5)]
)
async def test_the_cursor_of_the_terminal_is_after_the_cells_before_it(typed, cursor, column):
    app = Panes()
    async with app.run_test(size=(60, 10)) as pilot:
        app.line.value = typed
        app.line.cursor_position = cursor
        await pilot.pause()
        assert app.line.cursor_screen_offset == app.line.content_region.offset + Offset(column, 0)
        assert not app.line.cursor_blink
