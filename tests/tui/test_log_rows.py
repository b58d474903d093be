"""The log of the plain layout, as a reader meets it: what is painted, and when."""

import asyncio
from contextlib import asynccontextmanager
from itertools import pairwise

import pytest
from textual.app import App, ComposeResult
from textual.widgets import Input

from donnie_tui.tui.widgets.log_rows import LogRows
from tests.timeouts import TIMEOUT

HEIGHT = 6


class Pictured(LogRows):
    """Records the visible rows each time the log turns or continues a page."""

    def __init__(self):
        super().__init__(id="log")
        self.pictures = []

    @property
    def seen(self):
        return tuple(self.render_line(y).text.strip() for y in range(HEIGHT))

    def _fill(self):
        super()._fill()
        self.look()

    def _turn(self):
        super()._turn()
        self.look()

    def look(self):
        if self.pictures[-1:] != [self.seen]:
            self.pictures.append(self.seen)


class LogApp(App[None]):
    """A log of six rows, and something else that can have the focus."""

    def compose(self) -> ComposeResult:
        yield Pictured()
        yield Input(id="elsewhere")


class Seen:
    """A reader of the log."""

    def __init__(self, app, pilot):
        self.app, self.pilot = app, pilot
        self.log = app.query_one(Pictured)

    @property
    def rows(self):
        return self.log.seen

    async def until(self, condition):
        async with asyncio.timeout(TIMEOUT):
            while not condition():
                await self.pilot.pause(0.01)

    async def append(self, *lines):
        self.log.append((line, "spoke") for line in lines)
        await self.until(lambda: lines[-1] in (row.lstrip(">") for row in self.rows))


@asynccontextmanager
async def listening():
    async with LogApp().run_test(size=(60, HEIGHT + 3)) as pilot:
        seen = Seen(pilot.app, pilot)
        seen.log.styles.height = HEIGHT
        pilot.app.query_one("#elsewhere").focus()
        await pilot.pause()
        seen.log.set_paged(True)
        await pilot.pause()
        seen.log.pictures[:] = [seen.rows]
        yield seen


def rows_that_changed(before, after):
    return [(old, new) for old, new in zip(before, after, strict=True) if old != new]


async def test_a_row_stays_in_its_place_until_its_page_is_turned():
    async with listening() as seen:
        for number in range(20):
            await seen.append(f"Answer {number}.")

        assert len(seen.log.pictures) > 20
        for before, after in pairwise(seen.log.pictures):
            for old, new in rows_that_changed(before, after):
                assert not old or not new, (before, after)


async def test_a_burst_is_shown_page_by_page_with_empty_pages_between():
    async with listening() as seen:
        lines = [f"Row {number}." for number in range(3 * HEIGHT)]
        await seen.append(*lines)

        pages = [tuple(lines[at : at + HEIGHT]) for at in range(0, len(lines), HEIGHT)]
        empty = ("",) * HEIGHT
        assert seen.log.pictures == [empty, pages[0], empty, pages[1], empty, pages[2]]


async def test_a_command_begins_a_page_where_more_than_half_is_full():
    async with listening() as seen:
        await seen.append("One.", "Two.", "Three.")
        seen.log.begin_answer()
        await seen.append("Four.")
        assert seen.rows[:4] == ("One.", "Two.", "Three.", "Four.")

        seen.log.begin_answer()
        assert seen.rows == ("",) * HEIGHT
        await seen.append("Five.")
        assert seen.rows == ("Five.", *("",) * (HEIGHT - 1))


async def test_a_flood_is_not_shown_row_by_row():
    async with listening() as seen:
        lines = [f"Row {number}." for number in range(5000)]
        await seen.append(*lines)

        assert seen.rows == tuple(lines[-HEIGHT:])
        assert len(seen.log.pictures) < 10


@pytest.mark.slow
async def test_a_full_log_forgets_its_oldest_rows_and_continues_its_page(monkeypatch):
    monkeypatch.setattr("donnie_tui.tui.widgets.rows.MOST_LINES", 100)
    async with listening() as seen:
        await seen.append(*(f"Row {number}." for number in range(99)))
        await seen.append("Row 99.", "Row 100.")
        await seen.append("News.")

        assert len(seen.log.lines) < 100
        assert [row for row in seen.rows if row][-1] == "News."


async def test_a_number_alone_becomes_a_sentence_for_listeners():
    async with listening() as seen:
        seen.log.append([("5", "spoke"), ("12345678901234567890123", "spoke"), ("-5", "spoke")])
        await seen.until(lambda: "-5" in seen.rows)
        assert seen.rows[:3] == ("5.", "12345678901234567890123", "-5")
        assert seen.log.lines[0] == "5"

        seen.log.set_paged(False)
        assert "5." not in seen.rows


async def test_the_focused_log_has_all_rows_and_continues_after_the_focus_leaves():
    async with listening() as seen:
        await seen.append(*(f"Row {number}." for number in range(HEIGHT + 2)))
        seen.log.focus()
        await seen.until(lambda: seen.log.has_focus)
        await seen.pilot.press("home")
        assert seen.rows[0] == ">Row 0."

        seen.app.query_one("#elsewhere").focus()
        await seen.until(lambda: not seen.log.has_focus)
        assert seen.rows == tuple(f"Row {number}." for number in range(HEIGHT))
        await seen.append("News.")
        assert seen.rows == ("News.", *("",) * (HEIGHT - 1))


async def test_a_row_that_the_wheel_chose_is_seen_whatever_comes():
    """The log has no focus then, and turns no page."""
    async with listening() as seen:
        await seen.append(*(f"Row {number}." for number in range(3 * HEIGHT)))
        seen.log.choose_further(-2 * HEIGHT)
        chosen = f"Row {HEIGHT - 1}."
        assert (seen.log.row_text, chosen in seen.rows) == (chosen, True)

        before = seen.rows
        seen.log.append([("News.", "spoke")])
        await seen.pilot.pause()
        assert seen.rows == before


async def test_no_row_moves_while_the_focus_only_passes():
    async with listening() as seen:
        await seen.append(*(f"Row {number}." for number in range(HEIGHT + 2)))
        before = seen.rows
        seen.log.focus()
        await seen.until(lambda: seen.log.has_focus)
        assert [row.lstrip(">") for row in seen.rows] == list(before)
        await seen.append("While it is read.")
        seen.app.query_one("#elsewhere").focus()
        await seen.until(lambda: not seen.log.has_focus)
        assert seen.rows == (*before[:2], "While it is read.", *before[3:])


async def test_another_size_shows_the_newest_rows():
    async with listening() as seen:
        await seen.append(*(f"Row {number}." for number in range(HEIGHT + 1)))
        assert seen.rows[0] == f"Row {HEIGHT}."
        await seen.pilot.resize_terminal(50, HEIGHT + 3)
        await seen.until(lambda: seen.rows[-1] == f"Row {HEIGHT}.")
        assert seen.rows[0] == "Row 1."


async def test_the_log_is_filtered_by_kind_with_counts_and_shows_all_again(open_screen):
    async with open_screen() as screen:
        await screen.run('FW 2 TR 90 SPEAK "one" FW 1 SPEAK "two"')
        await screen.type_line("FILTER")
        await screen.until(lambda: screen.app.screen is not screen.main, "the kinds")
        assert [each.text for each in screen.app.screen._choices if "moved" in each.text] == [
            "moved, 2 lines."
        ]
        await screen.press(*"says", "enter")
        await screen.shows("Only says: 2 lines.")
        await screen.until(lambda: screen.main.log_pane._titles[0] == "Log: only says", "the title")
        rows = screen.main.log_rows
        assert [rows._rows[at] for at in range(rows.row_count)] == ["one", "two"]

        await screen.run('SPEAK "three" FW 1')
        assert rows._rows == ["one", "two", "three"]
        assert any("I walked 1 step forward." in line for line in screen.log)
        rows.focus()
        await screen.press("f")
        await screen.until(lambda: screen.app.screen is not screen.main, "the kinds")
        await screen.press("home", "enter")
        await screen.until(lambda: screen.main.log_pane._titles[0] == "Log", "all lines")
        assert rows.row_count == len(screen.log)


async def test_find_shows_what_a_filter_hides_with_its_count_and_marks(open_screen):
    async with open_screen() as screen:
        await screen.run('FW 2 SPEAK "two steps" TR 90')
        screen.app.controller.ctx.screen.filter_log("turned")
        await screen.type_line("FIND steps")
        await screen.shows("2 lines")

        assert not screen.main.log_rows.only
        await screen.until(lambda: screen.main.log_pane._titles[0] == "Log: 2 lines with steps", "the title")
        marked = [
            at
            for at in range(screen.main.log_rows.row_count)
            if screen.main.log_rows._segments(at)[0].text == "*"
        ]
        assert len(marked) >= 2


@pytest.mark.parametrize(
    ("language", "title"),
    [
        ("en", "Log: 12 lines with apple"),
        ("pt", "Registro: 12 linhas com apple"),
        ("es", "Registro: 12 líneas con apple"),
    ],
)
@pytest.mark.parametrize("size", [(40, 12), (80, 24), (120, 40)], ids=str)
async def test_how_many_lines_find_found_stays_in_sight(open_screen, size, language, title):
    """Twelve lines and their copies in the answer are more than the log has room for."""
    async with open_screen(size=size, language=language) as screen:
        screen.load('REPEAT 12 TIMES SPEAK "apple" END REPEAT')
        await screen.press("f5")
        await screen.until(lambda: screen.log.count("apple") == 12, "the words")
        await screen.idle()
        screen.main.go_to(screen.main.log_pane)
        await screen.type_line("FIND apple")
        await screen.until(lambda: screen.log.count("apple") == 24, "the answer")
        await screen.painted()
        for _ in range(2):
            assert sum(title in row for row in screen.text.splitlines()) == 1
            await screen.press("up", "pageup", "end")
            await screen.type_line("SPEAK 7")
            await screen.until(lambda: screen.log[-1] == "7", "another answer")
            await screen.painted()
        assert sum(line.startswith("12 ") for line in screen.log) == 1, "said once"

        await screen.type_line("FIND pear")
        await screen.until(lambda: "pear" in screen.log[-1], "no such line")
        await screen.painted()
        assert title not in screen.text


async def test_the_plain_layout_has_one_title_of_the_log(open_screen):
    """A reader would speak a changed one, after the answer."""
    async with open_screen("SPEAK 12", plain=True) as screen:
        await screen.press("f5")
        await screen.type_line("FIND 12")
        await screen.shows("1 line")
        await screen.painted()
        assert screen.main.log_pane._titles[0] == "Log"


@pytest.mark.parametrize("size", [(40, 12), (80, 24)])
async def test_what_find_typed_and_answered_has_no_mark(open_screen, size):
    async with open_screen(size=size) as screen:
        await screen.run('SPEAK "Maçã"')
        rows = screen.main.log_rows

        def marked() -> list[str]:
            return [rows._rows[at] for at in range(rows.row_count) if rows._segments(at)[0].text == "*"]

        await screen.type_line("FIND pear")
        await screen.shows("I have not said pear.")
        assert marked() == []

        await screen.type_line("FIND maca")
        await screen.shows("1 line")
        assert marked() == ["Maçã" if size[0] > 40 else "says: Maçã"]
