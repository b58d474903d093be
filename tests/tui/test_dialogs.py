"""Questions, lists to choose from, pages and keys, each by itself in front of an empty screen."""

from pathlib import Path

import pytest
from textual.app import App
from textual.geometry import Offset, Region
from textual.screen import Screen

from donnie_tui.commands.declarations import COMMANDS
from donnie_tui.commands.interaction import Option
from donnie_tui.i18n.words import Words
from donnie_tui.tui import app as application
from donnie_tui.tui import themes
from donnie_tui.tui.screens.dialogs import Chooser, Completions, Question
from donnie_tui.tui.screens.pages import Help, KeyCapture, KeyMenu, Tour, TourPage, TourStrip
from donnie_tui.tui.widgets.rows import BottomKeys

pytestmark = pytest.mark.slow

STYLES = Path(application.__file__).parent / "styles"
OPEN = "(open)"


class Before(Screen[None]):
    """What a dialog is in front of."""


class Showing(App[None]):
    """Shows dialogs; ``answer`` is what the last one was closed with."""

    CSS_PATH = [str(STYLES / "donnie.tcss"), str(STYLES / "later.tcss")]  # noqa: RUF012 -- Textual's own

    def __init__(self, dialog: Screen | None = None, *, plain: bool = False) -> None:
        super().__init__()
        self.dialog, self.plain = dialog, plain
        self.answer = OPEN

    def get_theme_variable_defaults(self) -> dict[str, str]:
        return themes.theme(themes.DARK).variables

    def on_mount(self) -> None:
        self.register_theme(themes.theme(themes.DARK))
        self.theme = themes.DARK
        if self.plain:
            self.screen.add_class("-plain")
        if self.dialog is not None:
            self.push_screen(self.dialog, lambda answer: setattr(self, "answer", answer))

    async def show(self, dialog: Screen) -> None:
        """Another one, alone."""
        while len(self.screen_stack) > 1:
            await self.pop_screen()
        self.answer = OPEN
        await self.push_screen(dialog, lambda answer: setattr(self, "answer", answer))


def shown(pilot) -> list[str]:
    return [strip.text.rstrip() for strip in pilot.app.screen._compositor.render_strips()]


async def click_on_key(pilot, name: str) -> None:
    """On the name of a key in the bottom line."""
    keys = pilot.app.screen.query_one(BottomKeys)
    await pilot.click(keys, offset=(1 + keys.words.index(name), 0))
    await pilot.pause()
    await pilot.pause()


# --- questions


def asking(**given) -> Question:
    said = []
    question = Question("What?", "Enter answers, Esc goes back", said.append, **given)
    question.said = said
    return question


TYPED = [
    ("enter", "old"),
    ("x enter", "x"),
    ("end x enter", "oldx"),
    ("space x space enter", "x"),
    ("escape", None),
    ("up enter", "old"),
    ("tab enter", "old"),
]


async def test_an_answer_is_typed_over_what_is_proposed():
    async with Showing().run_test() as pilot:
        for keys, answer in TYPED:
            dialog = asking(value="old")
            await pilot.app.show(dialog)
            await pilot.pause()
            assert dialog.said == ["What? old"]
            await pilot.press(*keys.split())
            assert pilot.app.answer == answer, keys


CHOSEN = [
    ("enter", "", []),
    ("down enter", "yes", ["yes"]),
    ("up enter", "yes", ["yes"]),
    ("down down enter", "no", ["yes", "no"]),
    ("down down down down enter", "later", ["yes", "no", "later", "later"]),
    ("down down up up enter", "yes", ["yes", "no", "yes", "yes"]),
    ("down down n enter", "n", ["yes", "no"]),
    ("tab enter", "yes", []),
    ("down down tab x enter", "nox", ["yes", "no"]),
]


async def test_an_answer_is_chosen_by_the_arrows_or_written_by_tab():
    async with Showing().run_test() as pilot:
        for keys, answer, said in CHOSEN:
            dialog = asking(answers=("yes", "no", "later"))
            await pilot.app.show(dialog)
            await pilot.pause()
            await pilot.press(*keys.split())
            assert (pilot.app.answer, dialog.said) == (answer, ["What?", *said]), keys


async def test_a_wrong_answer_is_reported_and_typed_over():
    dialog = asking(accepts=lambda answer: None if answer == "y" else f"Not {answer}.")
    async with Showing(dialog).run_test(size=(40, 12)) as pilot:
        await pilot.press("n", "o", "enter")
        await pilot.pause()
        assert (pilot.app.answer, dialog.said[-1]) == (OPEN, "Not no.")
        assert "Not no." in shown(pilot)
        await pilot.press("y", "enter")
        assert pilot.app.answer == "y"


async def test_what_a_question_offers_can_be_clicked():
    async with Showing().run_test(size=(40, 12)) as pilot:
        for x, y, answer in ((2, 1, "no"), (2, None, "x"), (17, None, None)):
            await pilot.app.show(asking(value="x", answers=("yes", "no")))
            await pilot.pause()
            rows = shown(pilot)
            top = next(at for at, row in enumerate(rows) if row.strip(" >") == "yes")
            assert [row.strip(" >") for row in rows[top - 1 : top + 3]] == ["What?", "yes", "no", "x"]
            assert rows[-1] == " Enter answers, Esc goes back"
            await pilot.click(offset=Offset(x, 11 if y is None else top + y))
            await pilot.pause()
            assert pilot.app.answer == answer


async def test_the_answers_of_a_question_leave_room_for_it_and_the_rows_that_are_always_seen():
    """Three below from ten rows on, less the command line and the keys; four for the question."""
    async with Showing().run_test(size=(60, 24)) as pilot:
        for height, rows in ((12, 4), (10, 4), (9, 4), (7, 2), (5, 0)):
            dialog = asking(answers=("a", "b", "c", "d"))
            await pilot.resize_terminal(60, height)
            await pilot.app.show(dialog)
            await pilot.pause()
            assert dialog._list.styles.height.value == rows
            assert dialog._panel.styles.margin.bottom == (1 if height >= 10 else 0)


# --- lists

FRUIT = ("apple", "apple tree", "pineapple", "green apple", "pear")


def choosing(options=None, **given) -> Chooser:
    said = []
    options = options if options is not None else [Option(each, each) for each in FRUIT]
    chooser = Chooser("Fruit", "Enter takes it, Esc goes back", "None fits.", options, said.append, **given)
    chooser.said = said
    return chooser


NARROWED = [
    ("apple", ("apple", "apple tree", "green apple", "pineapple")),
    ("APPLE t", ("apple tree",)),
    ("ear", ("pear",)),
    ("e p", FRUIT),
    ("melon", ("None fits.",)),
]


async def test_what_is_typed_narrows_a_list_with_what_begins_so_first():
    async with Showing().run_test() as pilot:
        for typed, rows in NARROWED:
            dialog = choosing()
            await pilot.app.show(dialog)
            dialog._typed.value = typed
            await pilot.pause()
            assert (dialog.rows.lines, dialog.said[-1]) == (tuple(rows), rows[0])
            await pilot.press("enter")
            assert pilot.app.answer == (OPEN if rows == ("None fits.",) else rows[0])


async def test_another_word_for_a_row_comes_before_one_that_only_begins_so():
    options = [Option("1", "speedy"), Option("2", "fast", also="speed quick"), Option("3", "speed (3)")]
    options += [Option("4", "the speed"), Option("5", "speed: 4"), Option("6", "speed, now")]
    dialog = choosing(options)
    async with Showing(dialog).run_test() as pilot:
        dialog._typed.value = "speed"
        await pilot.pause()
        assert dialog.rows.lines == ("speed (3)", "speed: 4", "speed, now", "fast", "speedy", "the speed")


MOVED = [
    ("enter", 2),
    ("down enter", 3),
    ("up enter", 1),
    ("up up up enter", 0),
    ("pagedown enter", 12),
    ("pagedown pagedown enter", 19),
    ("pagedown pageup enter", 2),
    ("end enter", 19),
    ("home enter", 0),
    ("end down enter", 19),
    ("1 backspace enter", 0),
    ("escape", None),
]


async def test_keys_move_in_a_list_from_what_is_chosen_now():
    options = [Option(str(at), f"row {at}", is_current=at == 2) for at in range(20)]
    async with Showing().run_test(size=(80, 15)) as pilot:
        for keys, chosen in MOVED:
            dialog = choosing(options)
            await pilot.app.show(dialog)
            await pilot.pause()
            assert dialog.said == ["Fruit row 2"]
            await pilot.press(*keys.split())
            await pilot.pause()
            assert pilot.app.answer == (None if chosen is None else str(chosen)), keys
            assert chosen in (None, 2) or dialog.said[-1] == f"row {chosen}"


async def test_the_cursor_of_the_terminal_is_on_the_row_until_something_is_typed():
    dialog = choosing()
    async with Showing(dialog).run_test() as pilot:
        line = dialog._typed
        await pilot.press("down")
        assert line.cursor_screen_offset == dialog.rows.content_region.offset + Offset(0, 1)
        await pilot.press("a")
        await pilot.pause()
        assert line.cursor_screen_offset == line.content_region.offset + Offset(1, 0)
        await pilot.press("down")
        assert line.cursor_screen_offset == dialog.rows.content_region.offset + Offset(0, 1)
        await pilot.press("backspace")
        await pilot.pause()
        assert line.cursor_screen_offset == dialog.rows.content_region.offset


async def test_a_list_is_left_or_a_row_taken_by_a_click():
    """The list is a panel of five rows with its title, in the middle of the room; its keys are below all."""
    async with Showing().run_test(size=(80, 20)) as pilot:
        for row, column, answer in (
            (3, 12, "apple"),
            (5, 12, "pineapple"),
            (None, 3, "apple"),
            (None, 20, None),
            (1, 1, None),
            (1, 12, OPEN),
        ):
            await pilot.app.show(choosing())
            await pilot.pause()
            top = next(at for at, each in enumerate(shown(pilot)) if "Fruit" in each)
            await pilot.click(offset=(column, 19 if row is None else top + row - 1))
            await pilot.pause()
            assert pilot.app.answer == answer


SIZES = [
    ((80, 24), (58, 8), False),
    ((66, 24), (58, 8), False),
    ((65, 24), (65, 8), True),
    ((80, 10), (58, 7), False),
    ((80, 9), (58, 7), False),
]


async def test_a_list_is_as_large_as_it_must_be_and_leaves_eight_columns_or_none():
    """56 columns at least, and a border; a row for each choice, the title, what is typed and the border.

    On a low screen what is typed is next to the title.
    """
    async with Showing().run_test(size=(90, 24)) as pilot:
        for size, panel, is_wide in SIZES:
            dialog = choosing()
            await pilot.resize_terminal(*size)
            await pilot.app.show(dialog)
            await pilot.pause()
            styles = dialog._panel.styles
            assert (styles.width.value, styles.height.value) == panel
            assert dialog._panel.has_class("-wide-as-all") is is_wide
            assert styles.margin.top == (1 if size[1] >= 20 else 0)
            assert styles.margin.bottom == (2 if size[1] >= 10 else 0)


async def test_a_row_of_a_list_as_wide_as_the_screen_does_not_run_into_the_panes_below():
    """A line of the program right below the last choice would look like one more."""
    async with Showing(choosing()).run_test(size=(40, 12)) as pilot:
        dialog = pilot.app.screen
        for size, has_line in (((40, 12), True), ((40, 20), True), ((40, 6), False)):
            await pilot.resize_terminal(*size)
            await pilot.pause()
            below = dialog._panel.region.bottom - 1
            row = dialog._compositor.render_strips()[below].text

            assert (row == "-" * 40) is has_line


async def test_a_long_title_or_a_long_row_makes_a_list_wider():
    async with Showing().run_test(size=(100, 24)) as pilot:
        for wide in ("title", "row"):
            options = [Option("a", "x" * (60 if wide == "row" else 5))]
            dialog = Chooser("x" * (60 if wide == "title" else 5), "Keys", "None", options, lambda _: None)
            await pilot.app.show(dialog)
            await pilot.pause()
            assert dialog._panel.styles.width.value == 64
            assert dialog._panel.styles.height.value == 5


async def test_rows_that_are_broken_need_more_rows():
    dialog = choosing([Option("a", "x" * 100), Option("b", "y")])
    async with Showing(dialog).run_test(size=(60, 24)) as pilot:
        await pilot.pause()
        assert dialog._panel.styles.height.value == 3 + 2 + 1


WORLDS = [
    Option("one", "alpha, easy, a room", columns=("alpha", "easy", "a room with nineteen")),
    Option("two", "be, hard, a hall", columns=("be", "hard", "a hall")),
]


COLUMNS = [
    ((34, 20), ("alpha  easy  a room with nineteen", "be     hard  a hall"), ""),
    ((33, 20), ("alpha  easy", "be     hard"), "a room with nineteen"),
    ((12, 20), ("alpha  easy", "be     hard"), "a room"),
    ((11, 20), ("alpha", "be"), "easy"),
    ((33, 8), ("alpha  easy", "be     hard"), "a room with nineteen"),
    ((33, 7), ("alpha, easy, a room", "be, hard, a hall"), ""),
]


async def test_columns_without_room_are_below_the_list_where_it_is_high_enough():
    """Columns of 5, 4 and 20 cells with gaps of two take 33, and one stays free."""
    async with Showing().run_test(size=(90, 24)) as pilot:
        for size, rows, below in COLUMNS:
            dialog = choosing(WORLDS)
            await pilot.resize_terminal(*size)
            await pilot.app.show(dialog)
            await pilot.pause()
            assert dialog.rows.lines == rows
            assert dialog._listing.has_class("-below") is bool(below)
            if below:
                assert " ".join(dialog._detail.lines).startswith(below)
                await pilot.press("down")
                await pilot.pause()
                assert dialog._detail.lines[-1] in ("a hall", "hall")


async def test_one_long_name_of_four_leaves_the_columns_of_the_others():
    options = [
        Option(str(at), f"{name}, x", columns=(name, "right"))
        for at, name in enumerate(("a", "b", "c", "long" * 4))
    ]
    for few, rows in ((4, ("a         right", "long" * 4 + "  right")), (3, ("b", "long" * 4))):
        dialog = choosing(options[4 - few :])
        async with Showing(dialog).run_test(size=(16, 20)) as pilot:
            await pilot.pause()
            assert (dialog.rows.lines[0], dialog.rows.lines[-1]) == rows


async def test_a_plain_list_has_rows_of_text_and_the_whole_screen():
    dialog = choosing(WORLDS, is_plain=True)
    async with Showing(dialog, plain=True).run_test(size=(80, 24)) as pilot:
        await pilot.pause()
        assert dialog.rows.lines == ("alpha, easy, a room", "be, hard, a hall")
        assert dialog._detail is None
        assert dialog._panel.region.size == (80, 23)


async def test_what_else_there_is_about_a_row_is_cut_at_a_word_where_it_has_no_room():
    asked = []

    def detail(columns: int, rows: int) -> list[str]:
        asked.append((columns, rows))
        return ["some words about it"] * (rows + 1)

    dialog = choosing(
        [
            Option("a", "a", detail=detail),
            Option("b", "b", detail=lambda *_: ["short"]),
            Option("c", "c", columns=("c",)),
        ]
    )
    async with Showing(dialog).run_test(size=(80, 24)) as pilot:
        await pilot.pause()
        columns, rows = asked[-1]
        assert (columns + 2, rows) == tuple(dialog._detail.size)
        assert dialog._detail.lines == (*["some words about it"] * (rows - 1), "some words about ...")
        await pilot.press("down")
        await pilot.pause()
        assert dialog._detail.lines == ("short",)
        await pilot.press("down")
        await pilot.pause()
        assert dialog._detail.lines == ()
        await pilot.press("z")
        await pilot.pause()
        assert dialog._detail.lines == ()


# --- words to complete


BELOW = [
    ((5, 3), 3, (5, 4), 3),
    ((5, 3), 12, (5, 4), 8),
    ((5, 16), 3, (5, 13), 3),
    ((5, 16), 12, (5, 8), 8),
    ((5, 10), 12, (5, 2), 8),
    ((39, 3), 3, (33, 4), 3),
    ((5, 15), 3, (5, 12), 3),
    ((5, 14), 3, (5, 15), 3),
]


async def test_words_are_below_the_cursor_or_above_it_where_there_is_more_room():
    """In rows 1 to 17 of a screen of 40 columns; the words have five letters."""
    async with Showing().run_test(size=(40, 20)) as pilot:
        for below, count, offset, height in BELOW:
            words = [f"word{at % 10}" for at in range(count)]
            dialog = Completions(words, "Keys", Offset(*below), Region(0, 1, 40, 17), lambda _: None)
            await pilot.app.show(dialog)
            await pilot.pause()
            styles = dialog.list.styles
            place = (styles.offset.x.value, styles.offset.y.value)
            assert (place, styles.width.value, styles.height.value) == (offset, 7, height)
            assert below[1] not in range(offset[1], offset[1] + height)


TAKEN = [
    ("enter", ("one", "")),
    ("down enter", ("two", "")),
    ("down tab", ("two", "")),
    ("escape", None),
    ("x", ("", "x")),
    ("space", ("", " ")),
]


async def test_a_word_is_taken_or_a_letter_continues():
    async with Showing().run_test(size=(40, 20)) as pilot:
        for keys, answer in TAKEN:
            said = []
            await pilot.app.show(
                Completions(["one", "two"], "Keys", Offset(0, 0), Region(0, 0, 40, 17), said.append)
            )
            await pilot.pause()
            assert said == ["one"]
            await pilot.press(*keys.split())
            await pilot.pause()
            assert (pilot.app.answer, said) == (answer, ["one", "two"][: 2 if "down" in keys else 1])


async def test_the_cursor_of_the_terminal_is_on_the_chosen_word():
    dialog = Completions(
        [f"w{at}" for at in range(12)], "Keys", Offset(4, 0), Region(0, 0, 40, 17), lambda _: None
    )
    async with Showing(dialog).run_test(size=(40, 20)) as pilot:
        await pilot.press("down", "down")
        assert dialog.list.cursor_screen_offset == (4, 1 + 2)
        await pilot.press(*["down"] * 7)
        await pilot.pause()
        assert dialog.list.cursor_screen_offset == (4, 1 + 7)


# --- pages to read


async def test_a_page_says_its_first_line_and_is_left():
    async with Showing().run_test(size=(40, 24)) as pilot:
        for key in ("escape", "q", "f1"):
            said = []
            dialog = Help("Title", "Esc goes back", ["one", "two"], said.append)
            await pilot.app.show(dialog)
            await pilot.pause()
            assert said == ["Title. Esc goes back. one"]
            assert shown(pilot)[1:4] == [" Title", ">one", " two"]
            assert dialog._page.styles.height.value == 24 - 1 - 3 - 1
            await pilot.press(key)
            assert pilot.app.answer is None


async def test_a_page_without_lines_says_its_title_and_further_keeps_it():
    said = []
    dialog = Help("Title", "Esc goes back", [], said.append, lambda: said.append("further"))
    async with Showing(dialog).run_test(size=(60, 24)) as pilot:
        await pilot.press("f1")
        assert (said, pilot.app.answer) == (["Title. Esc goes back. ", "further"], OPEN)
        assert dialog._page.styles.height.value == 24 - 1 - 3


PAGES = [
    TourPage("One", "Keys", ("first", "line")),
    TourPage("Two", "Keys", ("second",)),
    TourPage("Three", "Keys", ()),
]


TURNED = [
    ("enter", [1], "Two. Keys. second"),
    ("pagedown enter", [1, 2], "Three. Keys."),
    ("backspace", [0], "One. Keys. first line"),
    ("enter pageup", [1, 0], "One. Keys. first line"),
    ("enter enter backspace", [1, 2, 1], "Two. Keys. second"),
]


@pytest.mark.parametrize("kind", [Tour, TourStrip])
async def test_a_tour_turns_its_pages_and_says_each_whole(kind):
    async with Showing().run_test(size=(60, 24)) as pilot:
        for keys, turned, said in TURNED:
            pages: list[int] = []
            spoken: list[str] = []
            tour = kind(PAGES, 0, pages.append, spoken.append)
            await pilot.app.show(tour if kind is Tour else Before())
            if kind is TourStrip:
                await pilot.app.screen.mount(tour)
                tour.focus()
            await pilot.pause()
            assert spoken == ["One. Keys. first line"]
            await pilot.press(*keys.split())
            await pilot.pause()
            assert (pages, spoken[-1], pilot.app.answer) == (turned, said, OPEN)
            assert said.split(". ")[0].strip(".") in "\n".join(shown(pilot))


async def test_a_tour_closes_after_its_last_page():
    pages: list[int] = []
    async with Showing(Tour(PAGES, 2, pages.append, lambda _: None)).run_test() as pilot:
        await pilot.pause()
        assert shown(pilot)[1] == " Three"
        await pilot.press("enter")
        assert (pages, pilot.app.answer) == ([3], None)


async def test_the_strip_of_a_tour_is_turned_by_a_click_but_not_on_the_words_about_esc():
    pages: list[int] = []
    strip = TourStrip(
        [*PAGES[:2], TourPage("Three", "Enter goes on, Esc leaves", ("x",))], 1, pages.append, lambda _: None
    )
    app = Showing(Before())
    async with app.run_test(size=(60, 24)) as pilot:
        await app.screen.mount(strip)
        await pilot.pause()
        assert strip.title == "Two. Keys"
        assert strip.cursor_screen_offset == strip._body.content_region.offset
        await pilot.click(strip._body)
        assert (pages, strip.title) == ([2], "Three. Enter goes on, Esc leaves")
        await pilot.click(strip._heading, offset=(27, 0))
        await pilot.pause()
        assert pages == [2]
        await pilot.click(strip._heading, offset=(9, 0))
        await pilot.pause()
        assert (pages, strip.title) == ([2, 3], "Three. Enter goes on, Esc leaves")


PLAIN_PAGES = [
    lambda said: Help("Title", "Esc goes back", ["one"], said),
    lambda said: Tour([TourPage("Title", "Esc goes back", ("one",))], 0, lambda _: None, said),
    lambda said: KeyMenu({"where": ("ctrl+k i",)}, Words("en"), said, is_plain=True),
]


@pytest.mark.parametrize("plain", [True, False])
async def test_in_the_plain_layout_a_page_has_its_keys_in_its_title_and_the_whole_screen(plain):
    async with Showing(plain=plain).run_test(size=(120, 24)) as pilot:
        for make in PLAIN_PAGES:
            dialog = make(lambda _: None)
            await pilot.app.show(dialog)
            await pilot.pause()
            rows = shown(pilot)
            assert len(dialog.query(BottomKeys)) == (0 if plain else 1)
            titles = [row for row in rows if "Title" in row or Words("en")("menu-title") in row]
            assert [row.rstrip().endswith("Esc goes back") for row in titles] == [plain]
            panel = dialog._panel if isinstance(dialog, KeyMenu) else dialog._page
            below = 0 if plain else 2 - isinstance(dialog, Tour)
            assert panel.styles.height.value == (24 if plain else 24 - 1 - below - 1)


async def test_clicks_on_the_keys_of_pages_do_what_they_say():
    async with Showing().run_test(size=(70, 24)) as pilot:
        app, done = pilot.app, []
        pages = [TourPage("One", "Enter continues, Esc ends", ("first",)), *PAGES]
        tour = lambda: Tour(pages, 0, done.append, lambda _: None)  # noqa: E731
        keys = "F1: the manual, Esc goes back"
        further = lambda: Help("Title", keys, ["one"], lambda _: None, lambda: done.append("on"))  # noqa: E731
        menu = lambda: KeyMenu({"where": ("ctrl+k i",)}, Words("en"), lambda _: None)  # noqa: E731
        for make, said, answer, did in (
            (further, "F1", OPEN, ["on"]),
            (further, "Esc", None, []),
            (lambda: Help("Title", keys, ["one"], lambda _: None), "F1", None, []),
            (tour, "Enter", OPEN, [1]),
            (tour, "Esc", None, []),
            (menu, "Esc", None, []),
        ):
            done.clear()
            dialog = make()
            await app.show(dialog)
            await pilot.pause()
            await click_on_key(pilot, said)
            assert (app.answer, done) == (answer, did), (type(dialog), said)
        await app.show(tour())
        await pilot.pause()
        done.clear()
        await pilot.click(app.screen.rows, offset=(3, 0))
        await pilot.pause()
        assert (done, app.answer) == ([1], OPEN), "a click on a page turns it"
        await app.show(menu())
        await pilot.pause()
        await pilot.click(app.screen.rows, offset=(3, 0))
        await pilot.pause()
        assert app.answer == "where"
        await app.show(KeyCapture("Which key?", "Esc goes back", "Then?", str, lambda _: None))
        await pilot.pause()
        await click_on_key(pilot, "Esc")
        assert app.answer is None


# --- keys after the menu key


async def test_the_keys_after_the_menu_key_are_listed_letters_first():
    said = []
    keys = {
        COMMANDS[0].name: ("ctrl+k shift+a",),
        COMMANDS[1].name: ("f5", "ctrl+k b"),
        COMMANDS[2].name: ("ctrl+k 1",),
    }
    keys |= {COMMANDS[3].name: ("ctrl+k a",)}
    words = Words("en")
    menu = KeyMenu(keys, words, said.append)
    async with Showing(menu).run_test(size=(100, 24)) as pilot:
        await pilot.pause()
        assert [menu.names[key] for key in ("a", "b", "1", "shift+a")] == [
            COMMANDS[at].name for at in (3, 1, 2, 0)
        ]  # fmt: skip
        assert [row[2] for row in menu.cells] == [words(f"action-{COMMANDS[at].name}") for at in (3, 1, 0, 2)]
        assert said == [f"{words('menu-title')}. {words('completion-keys')}. {': '.join(menu.cells[0])}"]
        widths = [max(len(row[at]) for row in menu.cells) for at in range(3)]
        assert menu.rows.lines == tuple(
            "  ".join(cell.ljust(each) for cell, each in zip(row, widths, strict=True)).rstrip()
            for row in menu.cells
        )
        assert menu._panel.styles.width.value == sum(widths) + 8
        await pilot.press("down")
        await pilot.pause()
        assert said[-1] == ": ".join(menu.cells[1])
        await pilot.resize_terminal(sum(widths) + 7, 24)
        await pilot.pause()
        assert menu.rows.lines == tuple(": ".join(each) for each in menu.cells)
        assert menu.rows.line == 1
        await pilot.press("escape")
        assert pilot.app.answer is None


KEYS = [
    ("f5", "f5", []),
    ("escape", None, []),
    ("backspace", "", []),
    ("ctrl+k x", "ctrl+k x", ["Then?"]),
    ("ctrl+k escape", None, ["Then?"]),
    ("x f5", "f5", ["Not x."]),
    ("ctrl+k z f5", "f5", ["Then?", "Not ctrl+k z."]),
    ("ctrl+k backspace", OPEN, ["Then?", "Not ctrl+k backspace."]),
]


async def test_a_key_or_one_after_the_menu_key_is_given():
    def accepts(key: str) -> str | None:
        return None if key in ("f5", "ctrl+k x") else f"Not {key}."

    async with Showing().run_test(size=(60, 24)) as pilot:
        for keys, answer, said in KEYS:
            spoken: list[str] = []
            await pilot.app.show(KeyCapture("Which key?", "Esc goes back", "Then?", accepts, spoken.append))
            await pilot.pause()
            assert {"Which key?", " Esc goes back"} <= set(shown(pilot))
            await pilot.press(*keys.split())
            await pilot.pause()
            assert (pilot.app.answer, spoken) == (answer, ["Which key?", *said]), keys
            assert answer != OPEN or said[-1] in shown(pilot)
