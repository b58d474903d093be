"""Rows to read: which row is being read while others come and go, and while the width changes."""

import pytest
from textual.app import App, ComposeResult
from textual.events import MouseScrollDown, MouseScrollUp
from textual.widgets import Input

from donnie_tui.tui import themes
from donnie_tui.tui.widgets.rows import MOST_LINES, TextRows, inspector_look

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


async def test_a_search_for_nothing_finds_nothing_and_marks_move_with_the_rows_that_are_forgotten(
    monkeypatch,
):
    monkeypatch.setattr("donnie_tui.tui.widgets.rows.MOST_LINES", 20)
    async with Rows().run_test(size=(80, 24)) as pilot:
        rows = pilot.app.query_one(TextRows)
        rows.append((f"{at} wall" if at % 2 else f"{at} way", "") for at in range(20))
        assert not rows.search("")
        assert rows.search("wall")
        rows.append([("20 wall", ""), ("21 wall", "")])
        marked = [rows._rows[at] for at in range(rows.row_count) if rows._segments(at)[0].text == "*"]
        assert (rows.lines[0], rows.row_text) == ("2 way", "17 wall")
        assert marked == [f"{at} wall" for at in (3, 5, 7, 9, 11, 13, 15, 19)]


# --- which row is read


class Posting(App[None]):
    """Rows that follow or not, what was read, and something else that can have the focus."""

    AUTO_FOCUS = None
    CSS = "TextRows { scrollbar-size: 0 0; }"

    def __init__(self, *, follows: bool) -> None:
        super().__init__()
        self.rows = TextRows(id="rows", follows=follows)
        self.rows.styles.height = 4
        self.read: list[tuple[str, bool]] = []

    def compose(self) -> ComposeResult:
        yield self.rows
        yield Input()

    def on_text_rows_read(self, message: TextRows.Read) -> None:
        self.read.append((message.text, message.has_focus))


def painted(rows: TextRows) -> list[str]:
    return [rows.render_line(y).text.rstrip() for y in range(rows.size.height)]


KEYS = [
    ("up", "8", "8"),
    ("up up up", "6", "6"),
    ("pageup", "6", "6"),
    ("pageup pagedown", "9", "9"),
    ("home", "0", "0"),
    ("home up", "0", "0"),
    ("home down", "1", "1"),
    ("home pagedown", "3", "3"),
    ("down", "9", "9"),
    ("home end", "9", "9"),
]


@pytest.mark.parametrize("follows", [True, False])
async def test_keys_read_rows_and_a_page_is_a_row_less_than_there_is_room_for(follows):
    """Ten rows, of which four have room; rows that don't follow begin with the first."""
    async with Posting(follows=follows).run_test(size=(40, 8)) as pilot:
        rows = pilot.app.rows
        if follows:
            rows.append((str(i), "") for i in range(10))
        else:
            rows.show(str(i) for i in range(10))
        rows.focus()
        await pilot.pause()
        assert rows.row_text == ("9" if follows else "0")
        for keys, row, said in KEYS:
            await pilot.press("end", *keys.split())
            await pilot.pause()
            assert (rows.row_text, pilot.app.read[-1]) == (row, (said, True)), keys
            assert f">{row}" in painted(rows)


async def test_rows_that_are_read_at_the_newest_follow_however_it_was_reached():
    async with Posting(follows=True).run_test(size=(40, 8)) as pilot:
        rows = pilot.app.rows
        rows.focus()
        await pilot.press("down")
        await pilot.pause()
        assert pilot.app.read == [("", True)], "there is none yet"
        rows.append((str(at), "") for at in range(10))
        await pilot.press("up", "down")
        rows.append([("new", "")])
        assert (rows.row_text, painted(rows)[-1]) == ("new", ">new")
        await pilot.press("up")
        rows.append([("newer", "")])
        assert (rows.row_text, painted(rows)[-1]) == ("9", " new")


async def test_only_new_rows_and_the_one_that_is_read_no_longer_are_painted(monkeypatch):
    async with Posting(follows=True).run_test(size=(40, 8)) as pilot:
        rows, painting = pilot.app.rows, []
        rows.append([("0", "")])
        await pilot.pause()
        monkeypatch.setattr(rows, "refresh", lambda *regions, **_: painting.append([*map(tuple, regions)]))
        rows.append([("1", "")])
        assert painting[0] == [(0, 1, 40, 1)]
        for number in range(2, 6):
            rows.append([(str(number), "")])
        monkeypatch.undo()
        rows.focus()
        await pilot.pause()
        monkeypatch.setattr(rows, "refresh", lambda *regions, **_: painting.append([*map(tuple, regions)]))
        painting.clear()
        rows.append([("6", "")])
        assert painting[0] == [(0, 3, 40, 1)], "the row that was the newest; its place changes afterwards"


@pytest.mark.parametrize(("follows", "after"), [(True, "new"), (False, "9")])
async def test_new_rows_are_read_only_by_rows_that_follow_and_are_at_the_newest(follows, after):
    async with Posting(follows=follows).run_test(size=(40, 8)) as pilot:
        rows = pilot.app.rows
        rows.append((str(i), "") for i in range(10))
        rows.focus()
        await pilot.press("end")
        rows.append([("new", "")])
        assert rows.row_text == after
        await pilot.press("up")
        rows.append([("newer", "")])
        assert rows.row_text == ("9" if follows else "8")
        await pilot.press("down")
        rows.append([("newest", "")])
        assert rows.row_text == ("new" if follows else "9")


async def test_the_wheel_moves_the_rows_and_the_one_that_is_read_by_three():
    """At the ends of the list only the row moves."""
    async with Posting(follows=True).run_test(size=(40, 8)) as pilot:
        rows = pilot.app.rows
        rows.append((str(i), "") for i in range(20))
        await pilot.pause()
        bottom = 20 - rows.size.height
        tops = []
        for turn, row in (
            *((MouseScrollUp, read) for read in (16, 13, 10, 7, 4, 1, 0)),
            *((MouseScrollDown, read) for read in (3, 6)),
        ):
            rows.post_message(turn(rows, 0, 0, 0, 0, 0, False, False, False))
            await pilot.pause()
            assert rows.row_text == str(row)
            assert pilot.app.read[-1] == (str(row), False)
            assert f" {row}" in painted(rows)
            tops.append(int(painted(rows)[0]))

        assert tops == [*(max(0, bottom - 3 * turn) for turn in range(1, 8)), 3, 6]


async def test_the_first_row_of_a_line_says_all_of_it_and_the_others_themselves():
    async with Posting(follows=False).run_test(size=(20, 8)) as pilot:
        rows = pilot.app.rows
        rows.show(["one", LONG, "end"])
        rows.focus()
        await pilot.pause()
        assert rows.lines == ("one", LONG, "end")
        assert [rows.line, rows.row, rows.row_count] == [0, 0, 5]
        await pilot.press(*["down"] * 4)
        await pilot.pause()

        assert [text for text, _ in pilot.app.read] == [LONG, "five six seven", "eight nine ten", "end"]
        assert rows.line == 2
        await pilot.press("up")
        assert (rows.line, rows.row) == (1, 3)


async def test_a_line_that_is_read_is_seen_whole_where_there_is_room():
    async with Posting(follows=False).run_test(size=(20, 8)) as pilot:
        rows = pilot.app.rows
        rows.show(["one", "two", "three", LONG, "end"])
        await pilot.pause()
        rows.read_line(3)

        assert (rows.row, painted(rows)) == (
            3, [" three", " one two three four", " five six seven", " eight nine ten"]
        )  # fmt: skip
        rows.read_line(9)
        assert rows.row_text == "end"
        rows.read_line(0)
        assert painted(rows)[0] == " one"


async def test_other_lines_in_their_place_keep_the_row_that_is_read_where_it_can_stay():
    async with Posting(follows=False).run_test(size=(60, 8)) as pilot:
        rows = pilot.app.rows
        rows.show(["a", "b", "c"])
        rows.focus()
        await pilot.press("down", "down")
        for lines, row in ((["a", "b", "d"], "d"), (["e", "f"], "f"), (["e", "f", "g"], "f"), ([], "")):
            rows.show(lines)
            assert rows.row_text == row
        assert (rows.row, rows.line, rows.row_count) == (0, 0, 0)
        rows.show(["h"])
        assert (rows.row_text, painted(rows)) == ("h", [">h", "", "", ""])


async def test_the_cursor_of_the_terminal_stands_at_the_row_that_is_read():
    async with Posting(follows=False).run_test(size=(60, 8)) as pilot:
        rows = pilot.app.rows
        rows.show(str(i) for i in range(10))
        rows.focus()
        await pilot.press(*["down"] * 2)
        assert rows.cursor_screen_offset == (0, 2)
        await pilot.press(*["down"] * 4)
        assert rows.cursor_screen_offset == (0, 3)
        await pilot.press("up")
        assert rows.cursor_screen_offset == (0, 2)


# --- how rows look


@pytest.mark.parametrize("width", [55, 56])
async def test_kinds_have_a_column_of_ten_from_56_columns_on(width):
    async with Posting(follows=True).run_test(size=(width, 8)) as pilot:
        rows = pilot.app.rows
        rows.append([("I met a wall.", "collisions and more"), ("COLLISION here.", "collision")])
        await pilot.pause()

        assert painted(rows)[:2] == (
            [" collisions: I met a wall.", " COLLISION here."]
            if width == 55
            else [" collisions I met a wall.", " collision  COLLISION here."]
        )
        wide = "x" * (54 if width == 55 else 44)
        rows.append([(wide, "x"), (f"{wide}x", "x")])
        assert rows.row_count == 5


async def test_rows_that_do_not_follow_have_a_column_of_kinds_once_a_line_has_one():
    async with Posting(follows=False).run_test(size=(60, 8)) as pilot:
        rows = pilot.app.rows
        rows.append([("none", "")])
        await pilot.pause()
        assert painted(rows)[0] == " none"
        rows.append([("one", "kind"), ("two", "")])
        await pilot.resize_terminal(61, 8)
        await pilot.pause()
        assert painted(rows)[:3] == [f"{'':12}none", f" kind{'':7}one", f"{'':12}two"]
        assert rows.with_kinds == (("none", ""), ("one", "kind"), ("two", ""))


BROKEN = [
    ("a" * 19, ["a" * 19]),
    ("a" * 20, ["a" * 19, "a"]),
    ("a" * 10 + " " + "b" * 8, ["a" * 10 + " " + "b" * 8]),
    ("a" * 10 + " " + "b" * 9, ["a" * 10, "b" * 9]),
    ("日" * 9, ["日" * 9]),
    ("日" * 10, ["日" * 9, "日"]),
    ("a  " + "b" * 18, ["a", "b" * 18]),
    ("  a  b", ["  a  b"]),
    ("", [""]),
]


async def test_rows_have_room_for_a_column_less_than_the_widget_which_is_that_of_the_mark():
    async with Posting(follows=False).run_test(size=(20, 8)) as pilot:
        rows = pilot.app.rows
        for text, shown in BROKEN:
            rows.show([text])
            assert rows._rows == shown
            assert painted(rows)[: len(shown)] == [f" {each}".rstrip() for each in shown]


@pytest.mark.parametrize(
    ("text", "look"),
    [
        ("Variables:", "heading"),
        ("* x: 3", "changed"),
        (" 12 |***", "chart"),
        ("   -3|", "chart"),
        ("x = 3", ""),
        ("x |", ""),
        ("* changed:", "heading"),
    ],
)
def test_the_inspector_shows_headings_changes_and_charts_in_colours(text, look):
    assert inspector_look(text) == look


async def test_only_the_lines_of_a_kind_are_shown_and_a_search_shows_all_again():
    async with Posting(follows=True).run_test(size=(60, 8)) as pilot:
        rows = pilot.app.rows
        rows.append([("one", "a"), ("two", "b"), ("three", "a"), ("> two", "typed")])
        await pilot.pause()
        rows.read_line(0)
        rows.filter("b")
        await pilot.pause()
        assert (rows.only, rows.row_text, rows.row_count) == ("b", "two", 1)
        assert pilot.app.read[-1] == ("two", False)
        rows.append([("four", "b"), ("five", "a")])
        assert (rows.row_text, rows.row_count) == ("four", 2)

        assert rows.search("two")
        assert (rows.only, rows.row_text, rows.row_count) == ("", "two", 6)
        rows.append([("two more", "b")])
        assert [rows._segments(at)[0].text for at in range(7)] == [" ", "*", " ", " ", " ", " ", " "]


async def test_a_kind_has_its_look_and_the_row_that_is_read_another():
    async with Posting(follows=True).run_test(size=(60, 8)) as pilot:
        rows = pilot.app.rows
        rows.looks["alarm"] = "error"
        rows.append([("one", "alarm"), ("two", "other"), ("three", "other")])
        rows.focus()
        await pilot.pause()
        looks = {name: rows.painted_as(name) for name in ("", "error", "kind", "row")}
        first, second, read = ([each.style for each in rows._segments(at)] for at in range(3))

        assert first == [looks[""], looks["error"], looks[""]]
        assert second == [looks[""], looks["kind"], looks[""]]
        assert read == [looks["row"]] * 3
        rows.blur()
        await pilot.pause()
        assert [each.style for each in rows._segments(2)] == second


async def test_where_it_is_narrow_the_kind_before_a_sentence_has_its_look():
    async with Posting(follows=True).run_test(size=(40, 8)) as pilot:
        rows = pilot.app.rows
        rows.append([("one", "other"), ("two", "other")])
        rows.focus()
        await pilot.pause()
        first, read = rows._segments(0), rows._segments(1)

        assert [each.text for each in first] == [" ", "other", ": one"]
        assert [each.style for each in first][1:] == [rows.painted_as("kind"), rows.painted_as()]
        assert [each.style for each in read] == [rows.painted_as("row")] * 3


async def test_rows_without_kinds_have_the_look_of_their_words():
    async with Posting(follows=False).run_test(size=(60, 8)) as pilot:
        rows = pilot.app.rows
        rows.look_of = inspector_look
        rows.show(["Variables:", "* x: 3", "y: 1"])
        rows.focus()
        await pilot.pause()
        styles = [rows._segments(at)[1].style for at in range(3)]
        assert styles == [rows.painted_as(each) for each in ("row", "changed", "")]
        await pilot.press("down")
        assert rows._segments(0)[1].style == rows.painted_as("heading")


async def test_looks_change_with_the_theme():
    async with Posting(follows=False).run_test(size=(60, 8)) as pilot:
        rows, app = pilot.app.rows, pilot.app
        for name in ("donnie-dark", "donnie-light"):
            app.register_theme(themes.theme(name))
        app.theme = "donnie-dark"
        await pilot.pause()
        dark = rows.painted_as("row")
        app.theme = "donnie-light"
        await pilot.pause()

        assert rows.painted_as("row") != dark
