"""Rows to read: which row is being read while others come and go, and while the width changes."""

from textual.app import App, ComposeResult

from donnie_tui.tui.widgets.rows import MOST_LINES, TextRows

LONG = "one two three four five six seven eight nine ten"


class Rows(App[None]):
    def compose(self) -> ComposeResult:
        yield TextRows(id="rows", follows=True)


async def test_the_line_being_read_is_still_the_one_after_a_resize():
    async with Rows().run_test(size=(30, 10)) as pilot:
        rows = pilot.app.query_one(TextRows)
        rows.append((f"{i} {LONG}", "") for i in range(9))
        rows.read_line(5)
        for width in (100, 20, 30):
            await pilot.resize_terminal(width, 10)
            await pilot.pause()
            assert rows.row_text.startswith("5 "), width


async def test_the_row_being_read_is_still_the_one_when_the_oldest_are_forgotten():
    async with Rows().run_test(size=(80, 24)) as pilot:
        rows = pilot.app.query_one(TextRows)
        rows.append((f"line {i}", "") for i in range(MOST_LINES))
        rows.read_line(MOST_LINES // 2)
        rows.append([("one more", "")])
        await pilot.pause()

        assert len(rows.lines) < MOST_LINES
        assert rows.row_text == f"line {MOST_LINES // 2}"


async def test_a_search_goes_to_the_next_older_line_and_from_the_oldest_to_the_newest():
    async with Rows().run_test(size=(80, 24)) as pilot:
        rows = pilot.app.query_one(TextRows)
        rows.append((f"{i} wall" if i % 2 else f"{i} way", "") for i in range(7))
        found = []
        for _ in range(4):
            assert rows.search("WALL")
            found.append(rows.row_text)

        assert found == ["5 wall", "3 wall", "1 wall", "5 wall"]
        assert [rows.render_line(row).text[0] for row in range(7)] == [*" * * > "]
        assert not rows.search("gate")
