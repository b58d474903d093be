"""The rows at the bottom of the screen and of dialogs, the slider: what has room, and what a click means."""

import pytest
from textual.app import App, ComposeResult
from textual.events import Click
from textual.geometry import Size
from textual.message import Message
from textual.widget import Widget

from donnie_tui.tui.widgets.rows import (
    BottomKeys,
    DialogKeys,
    FixedLine,
    KeyEntry,
    KeyLine,
    Slider,
    rows_always_seen,
)

ONE, TWO, LONG, SHORT, ALL = (
    KeyEntry("one", "A", "one"),
    KeyEntry("two", "B", "two"),
    KeyEntry("long", "C", "something long"),
    KeyEntry("short", "D", "x"),
    KeyEntry("all", "P", "All"),
)


def click(widget: Widget, x: int, y: int = 0) -> Click:
    """Of the left button, on that place of a widget at the corner of the screen."""
    return Click(widget, x, y, 0, 0, 1, False, False, False, x, y)


class Row(App[None]):
    """A widget of a width and a height, and the messages that it posts and the keys that it presses."""

    def __init__(self, widget: Widget, width: int, height: int = 1) -> None:
        super().__init__()
        self.widget = widget
        widget.styles.width, widget.styles.height = width, height
        self.posted: list[Message] = []

    def compose(self) -> ComposeResult:
        yield self.widget

    def on_key_line_clicked(self, message: KeyLine.Clicked) -> None:
        self.posted.append(message)

    on_slider_moved = on_key = on_key_line_clicked

    @property
    def rows(self) -> list[str]:
        return [self.widget.render_line(y).text.rstrip() for y in range(self.widget.size.height)]


SENTENCES = [
    (1, "", ("x" * 20, "y"), "x" * 20),
    (1, "", ("x" * 21, "y"), "y"),
    (1, "", ("x" * 21, "y" * 22), "y" * 22),
    (1, "", ("日" * 10, "y"), "日" * 10),
    (1, "", ("日" * 10 + "x", "y"), "y"),
    (1, "ON", ("x" * 16, "y"), "x" * 16),
    (1, "ON", ("x" * 17, "y"), "y"),
    (2, "", ("a" * 20 + " " + "b" * 20, "y"), "a" * 20 + " " + "b" * 20),
    (2, "", ("a" * 20 + " " + "b" * 21, "y"), "y"),
    (2, "", ("a" * 19 + " bb " + "c" * 17, "y"), "a" * 19 + " bb " + "c" * 17),
    (2, "", ("a" * 19 + " bb " + "c" * 18, "y"), "y"),
    (2, "", ("x" * 30, "y"), "y"),
]


async def test_the_first_sentence_with_room_is_shown_or_the_last():
    """In 20 columns; a badge takes a blank on both sides, and a row ends with a word."""
    line = FixedLine(id="line")
    async with Row(line, 20).run_test(size=(20, 4)) as pilot:
        for height, badge, choices, shown in SENTENCES:
            line.styles.height = height
            await pilot.pause()
            line.say(*choices, badge=badge)
            printed = "".join(pilot.app.rows).replace(" ", "")
            assert line.words == shown
            assert printed.startswith((badge + shown).replace(" ", "")[:20])


async def test_a_sentence_changes_with_the_room_and_a_badge_with_its_words():
    line = FixedLine(id="line")
    async with Row(line, 20).run_test(size=(20, 4)) as pilot:
        line.say("a long sentence", "short", badge="ON", colour="red")
        await pilot.pause()
        badge, words = [each for each in line.render_line(0) if each.text.strip()][:2]
        assert (badge.text, badge.style.reverse, badge.style.color.name) == (" ON ", True, "#ff0000")
        assert (words.text.strip(), bool(words.style.reverse)) == ("a long sentence", False)

        line.styles.width = 18
        await pilot.pause()
        assert pilot.app.rows == [" ON short"]
        line.say("short", badge="OFF")
        await pilot.pause()
        assert pilot.app.rows == [" OFF short"]
        line.say("[red]")
        await pilot.pause()
        assert pilot.app.rows == ["[red]"]


ROOM = [
    (20, (ONE, TWO, ALL), " A one  B two  P All"),
    (19, (ONE, TWO, ALL), " A one  P All"),
    (13, (ONE, TWO, ALL), " A one  P All"),
    (12, (ONE, TWO, ALL), " P All"),
    (24, (ONE, LONG, SHORT, ALL), " A one  D x  P All"),
    (40, (ONE, LONG, SHORT, ALL), " A one  C something long  D x  P All"),
]


async def test_as_many_keys_are_shown_as_there_is_room_for_and_always_the_last():
    line = KeyLine(id="keys")
    async with Row(line, 40).run_test(size=(60, 4)) as pilot:
        assert pilot.app.rows == [""]
        for width, entries, shown in ROOM:
            line.styles.width = width
            await pilot.pause()
            line.offer(entries)
            await pilot.pause()
            assert pilot.app.rows == [shown]
            keys = "".join(each.text for each in line.render_line(0) if each.style and each.style.reverse)
            assert keys == "".join(each.key for each in entries if each.text in shown)


async def test_a_click_on_a_key_or_its_words_is_that_key_and_between_them_it_is_none():
    line = KeyLine(id="keys")
    async with Row(line, 40).run_test(size=(60, 4)) as pilot:
        line.offer((ONE, TWO, ALL))
        await pilot.pause()
        for x in (0, 1, 5, 6, 7, 8, 12, 13, 15, 19, 20, 30):
            line.on_click(click(line, x))
        await pilot.pause()

        assert [each.action for each in pilot.app.posted] == ["one", "one", "two", "two", "all", "all"]


async def test_other_keys_are_shown_where_the_room_changes():
    line = KeyLine(id="keys")
    async with Row(line, 19).run_test(size=(60, 4)) as pilot:
        line.offer((ONE, TWO, ALL))
        line.styles.width = 20
        await pilot.pause()

        assert pilot.app.rows == [" A one  B two  P All"]


PLACES = [
    ((0, 10), " < |O----------| >"),
    ((3, 10), " < |===O-------| >"),
    ((10, 10), " < |==========O| >"),
    ((10, 40), " < |==O--------| >"),
    ((0, 0), " < |O----------| >"),
    ((1, 1), " < |==========O| >"),
]


async def test_the_slider_shows_where_the_learner_looks():
    """In 19 columns, of which four at each end are its ends."""
    slider = Slider()
    async with Row(slider, 19).run_test(size=(60, 4)) as pilot:
        for at, shown in PLACES:
            slider.show(*at)
            assert pilot.app.rows == [shown]


CLICKS = [
    ((5, 20), 0, 4),
    ((5, 20), 3, 4),
    ((0, 20), 0, 0),
    ((5, 20), 4, 0),
    ((5, 20), 9, 10),
    ((5, 20), 14, 20),
    ((5, 20), 15, 6),
    ((5, 20), 18, 6),
    ((20, 20), 15, 20),
]


async def test_a_click_on_the_slider_goes_there_and_at_its_ends_a_step():
    slider = Slider()
    async with Row(slider, 19).run_test(size=(60, 4)) as pilot:
        await pilot.pause()
        for at, x, _step in CLICKS:
            slider.show(*at)
            slider.on_click(click(slider, x))
        await pilot.pause()

        assert [each.step for each in pilot.app.posted] == [step for _at, _x, step in CLICKS]


async def test_the_slider_grows_with_its_room_and_has_a_cell_at_least():
    slider = Slider()
    async with Row(slider, 19).run_test(size=(60, 4)) as pilot:
        slider.show(2, 4)
        for width, shown in ((13, " < |==O--| >"), (9, " < |O| >"), (8, " < |O| >")):
            slider.styles.width = width
            await pilot.pause()
            assert slider.words.rstrip() == shown


WORDS = "Enter takes it, Up and Down choose, Esc goes back"


ALL_WORDS = "Enter takes it, arrows choose, Tab completes, F1: help, Esc goes back"
FITTING = [
    (70, ALL_WORDS),
    (69, "Enter takes it, Tab completes, F1: help, Esc goes back"),
    (54, "Enter takes it, F1: help, Esc goes back"),
    (39, "Enter takes it, Esc goes back"),
    (29, "Esc goes back"),
    (5, "Esc goes back"),
    (70, ALL_WORDS),
]


async def test_where_there_is_little_room_the_bottom_line_of_a_dialog_leaves_out_what_is_needed_least():
    keys = BottomKeys(ALL_WORDS)
    async with Row(keys, 70).run_test(size=(80, 4)) as pilot:
        for columns, shown in FITTING:
            keys.styles.width = columns
            await pilot.pause()
            assert keys.words == shown
            reversed_keys = [each.text for each in keys.render_line(0) if each.style and each.style.reverse]
            assert columns < 20 or set(reversed_keys) <= {"Enter", "Tab", "F1", "Esc"}


@pytest.mark.parametrize(
    ("width", "clicked"),
    [
        (60, {(0, 0): "", (1, 0): "enter", (16, 0): "enter", (17, 0): "", (36, 0): "", (37, 0): "escape"}),
        (25, {(1, 0): "enter", (17, 0): "", (1, 1): "", (12, 1): "escape", (20, 1): "escape"}),
    ],
    ids=str,
)
async def test_a_click_on_what_a_dialog_says_of_enter_and_esc_presses_it(width, clicked):
    """In 25 columns the second row begins with the 25th, in the words about arrows."""
    keys = DialogKeys(WORDS)
    async with Row(keys, width, 2).run_test(size=(60, 4)) as pilot:
        await pilot.pause()
        pressed = {}
        for place in clicked:
            pilot.app.posted.clear()
            keys.on_click(click(keys, *place))
            await pilot.pause()
            pressed[place] = "".join(each.key for each in pilot.app.posted)

        assert pressed == clicked


@pytest.mark.parametrize(
    ("name", "key"), [("Esc", "escape"), ("Enter", "enter"), ("F1", "f1"), ("Tab", "tab"), ("Up", "")]
)
async def test_a_click_presses_the_key_that_its_words_name(name, key):
    keys = DialogKeys(f"{name} does it")
    async with Row(keys, 60).run_test(size=(60, 4)) as pilot:
        keys.on_click(click(keys, 3))
        await pilot.pause()

        assert [each.key for each in pilot.app.posted] == [key] * bool(key)


async def test_a_click_next_to_a_row_is_none_and_one_on_a_key_goes_no_further():
    for widget in (KeyLine(id="keys"), Slider(), DialogKeys(WORDS)):
        async with Row(widget, 30).run_test(size=(60, 4)) as pilot:
            if isinstance(widget, KeyLine):
                widget.offer((ONE, ALL))
            for place in ((1, 2), (31, 0)):
                widget.on_click(event := click(widget, *place))
                await pilot.pause()
                assert (pilot.app.posted, event._stop_propagation) == ([], False)
    keys = DialogKeys(WORDS)
    async with Row(keys, 60).run_test(size=(60, 4)) as pilot:
        stopped = []
        for x in (2, 20):
            keys.on_click(event := click(keys, x))
            stopped.append(event._stop_propagation)
        assert stopped == [True, False]


@pytest.mark.parametrize("plain", [True, False])
@pytest.mark.parametrize("kind", [DialogKeys, BottomKeys])
async def test_names_of_keys_are_reversed_but_not_in_the_plain_layout(kind, plain):
    keys = kind(WORDS)
    app = Row(keys, 60)
    async with app.run_test(size=(60, 4)) as pilot:
        app.screen.set_class(plain, "-plain")
        keys.say(WORDS)
        await pilot.pause()
        assert app.rows == [f" {WORDS}"]
        reversed_keys = [each.text for each in keys.render_line(0) if each.style and each.style.reverse]
        assert reversed_keys == ([] if plain else ["Enter", "Esc"])
        assert keys.has_class("bottom-keys" if kind is BottomKeys else "screen-keys")


async def test_words_of_a_dialog_are_no_markup():
    keys = DialogKeys("[red]Esc[/]")
    async with Row(keys, 60).run_test(size=(60, 4)) as pilot:
        await pilot.pause()
        assert pilot.app.rows == [" [red]Esc[/]"]


@pytest.mark.parametrize(("size", "rows"), [((60, 10), 3), ((59, 10), 4), ((60, 9), 0), ((59, 9), 0)])
def test_the_fixed_rows_are_one_more_where_it_is_narrow_and_none_where_it_is_low(size, rows):
    assert rows_always_seen(Size(*size)) == rows
