"""Only what changed is sent to the terminal, and the terminal shows the same as if all had been sent."""

import random
import sys

import pyte
import pytest
from rich.console import Console
from rich.segment import ControlType, Segment
from rich.style import Style
from textual import _compositor
from textual._compositor import ChopsUpdate, CompositorUpdate, LayoutUpdate
from textual.app import App
from textual.geometry import Offset, Region
from textual.strip import Strip

from donnie_tui import tui
from donnie_tui.tui import terminal_output
from donnie_tui.tui.terminal import diff_output
from donnie_tui.tui.terminal_output import ChangedCells, Painted, fits

COLUMNS, ROWS = 30, 4
CONSOLE = Console(force_terminal=True, color_system="truecolor")
STYLES = [
    Style.parse(each)
    for each in ("red on black", "blue on black", "bold on white", "reverse", "underline", "", "bold")
]
LETTERS = [*"aabb    éü²=界🤖", "e\u0301", "so\xadft"]


def part_of_screen(chance: random.Random) -> ChopsUpdate:
    """Two strips in a row, of which a span is to be painted."""
    row, first, last = chance.randrange(ROWS), chance.randrange(20), chance.randrange(4, COLUMNS)
    strips: dict[int, Strip | None] = {0: some_strip(chance), 12: some_strip(chance)}
    strips[chance.choice((24, 0))] = None
    chops = [strips if row == y else {} for y in range(ROWS)]
    return ChopsUpdate(chops, [(row, min(first, last), last)], [[12, 24, COLUMNS]] * ROWS)


def update(x: int, y: int, strip: Strip) -> ChopsUpdate:
    return ChopsUpdate(
        [{x: strip} if row == y else {} for row in range(ROWS)], [(y, 0, COLUMNS)], [[COLUMNS]] * ROWS
    )


def whole_screen(chance: random.Random) -> LayoutUpdate:
    x, y = chance.randrange(4), chance.randrange(2)
    strips = [[some_strip(chance), some_strip(chance)] for _ in range(ROWS - y)]
    return LayoutUpdate(strips, Region(x, y, 24, ROWS - y))


def some_strip(chance: random.Random) -> Strip:
    pieces = [
        Segment("".join(chance.choices(LETTERS, k=chance.randrange(5))), chance.choice(STYLES))
        for _ in range(4)
    ]
    return Strip(pieces).adjust_cell_length(12, chance.choice(STYLES))


class Seen:
    def __init__(self) -> None:
        self.screen = pyte.Screen(COLUMNS, ROWS)
        self._stream = pyte.Stream(self.screen)

    def feed(self, sent: str) -> int:
        self._stream.feed(sent)
        return len(sent)

    def cells(self) -> list[tuple[object, ...]]:
        """What is seen of each cell: of a blank neither its colour nor that it is bold."""
        return [self._cell(self.screen.buffer[y][x]) for y in range(ROWS) for x in range(COLUMNS)]

    def _cell(self, cell: pyte.screens.Char) -> tuple[object, ...]:
        if cell.data == " " and not (cell.underscore or cell.reverse):
            return (" ", cell.bg)
        return tuple(cell)


def test_the_terminal_shows_the_same():
    chance = random.Random(1)
    thin, whole, painted = Seen(), Seen(), Painted()
    for _ in range(600):
        x, y, strip = chance.randrange(2) * 12, chance.randrange(ROWS), some_strip(chance)
        given = chance.choice((update(x, y, strip), part_of_screen(chance)))
        if chance.random() < 0.1:
            given = whole_screen(chance)
        thin.feed(painted.less(given).render_segments(CONSOLE))
        whole.feed(given.render_segments(CONSOLE))

        assert thin.cells() == whole.cells()


def test_what_is_there_already_costs_nothing_and_one_letter_little():
    painted, red = Painted(), STYLES[0]
    before, after = (Strip([Segment(text, red)]) for text in ("I walked 4 steps.", "I walked 5 steps."))
    painted.less(update(0, 0, before)).render_segments(CONSOLE)

    assert painted.less(update(0, 0, before)).render_segments(CONSOLE) == ""
    assert painted.less(update(0, 0, after)).render_segments(CONSOLE) == "\x1b[31;40m\x1b[1;10H5\x1b[0m"


@pytest.mark.parametrize(
    ("text", "are_cells"),
    [("FW 3", True), ("é", True), ("\u02ff", True), ("e\u0300", False), ("a\xad", False), ("界", False)],
)
def test_letters_that_may_be_wider_or_narrower_than_a_cell_are_sent_each_time(text, are_cells):
    """How the terminal shows them is not known."""
    painted, given = Painted(), update(0, 0, Strip([Segment(text)]))
    first = painted.less(given).render_segments(CONSOLE)

    assert first == f"\x1b[1;1H{text}"
    assert painted.less(given).render_segments(CONSOLE) == ("" if are_cells else first)


def test_what_is_no_letter_is_sent_each_time():
    painted, given = Painted(), update(0, 0, Strip([Segment("x", None, [(ControlType.BELL,)])]))

    assert [painted.less(given).render_segments(CONSOLE) for _ in range(2)] == ["\x1b[1;1Hx"] * 2


@pytest.mark.parametrize(
    ("changed", "runs"),
    [
        ([], []),
        ([0], [(0, 1)]),
        ([3, 4, 20], [(3, 21)]),
        ([3, 20], [(3, 4), (20, 21)]),
        ([1, 17, 34, 35], [(1, 18), (34, 36)]),
    ],
)
def test_cells_with_at_most_fifteen_equal_ones_between_them_are_written_together(changed, runs):
    """The way to another place in a row is up to eight bytes, and a style comes with it."""
    assert list(terminal_output._runs(changed)) == runs


@pytest.mark.parametrize(
    ("before", "after", "is_sent"),
    [
        ("red on black", "blue on black", False),
        ("bold italic", "", False),
        ("red on black", "red on white", True),
        *(
            (f"{each} on black", "on black", True)
            for each in ("underline", "underline2", "reverse", "strike", "overline", "link a.org")
        ),
    ],
)
def test_a_blank_is_written_only_if_its_look_changes(before, after, is_sent):
    painted = Painted()
    for style in (before, after):
        given = update(0, 0, Strip([Segment("  ", Style.parse(style))]))
        sent = painted.less(given).render_segments(CONSOLE)

    assert bool(sent) is is_sent


@pytest.mark.parametrize(
    ("colours", "red"),
    [("truecolor", "38;2;250;1;2"), (None, "38;2;250;1;2"), ("256", "38;5;196"), ("standard", "31")],
)
def test_colours_are_those_that_the_terminal_has(colours, red):
    """If it is not known, all: Textual asks for them so."""
    console = Console(force_terminal=True, color_system=colours)
    given = update(0, 0, Strip([Segment("FW", Style(color="#fa0102"))]))

    assert Painted().less(given).render_segments(console) == f"\x1b[{red}m\x1b[1;1HFW\x1b[0m"


def test_after_something_else_was_written_nothing_is_known():
    painted, strip = Painted(), Strip([Segment("FW 4", STYLES[0])])
    sent = painted.less(update(0, 0, strip)).render_segments(CONSOLE)
    for forget in (lambda: painted.less("something else"), painted.forget):
        forget()
        assert painted.less(update(0, 0, strip)).render_segments(CONSOLE) == sent

    first = LayoutUpdate([[strip]], Region(0, 0, 4, 1))
    painted = Painted()
    painted.less(first).render_segments(CONSOLE)
    painted.forget()
    assert painted.less(first).render_segments(CONSOLE) == first.render_segments(CONSOLE)
    assert painted.less(None) is None
    assert painted.less("a page") == "a page"
    painted.less(first).render_segments(CONSOLE)
    assert painted.less(first).render_segments(CONSOLE) == ""  # nothing was written: all is known


def test_a_whole_screen_that_shows_the_same_costs_nothing():
    """Textual paints all of it where the focus goes elsewhere."""
    rows = [[Strip([Segment("Program".ljust(12), each)])] for each in STYLES[:ROWS]]
    painted, screen = Painted(), LayoutUpdate(rows, Region(0, 0, COLUMNS, ROWS))

    assert painted.less(screen).render_segments(CONSOLE) == screen.render_segments(CONSOLE)
    assert painted.less(screen).render_segments(CONSOLE) == ""


def test_a_screen_that_was_not_written_is_not_known():
    """Textual drops what it painted before its driver runs: the page of a browser stayed empty."""
    painted, screen = Painted(), whole_screen(random.Random(3))
    painted.less(screen)

    assert painted.less(screen).render_segments(CONSOLE) == screen.render_segments(CONSOLE)


def sent(painted: Painted, text: str, *, row: int = 0, typing: Offset | None = None) -> str:
    strip = Strip([Segment(text.ljust(20), STYLES[0])])
    return painted.less(update(0, row, strip), rows=True, typing=typing).render_segments(CONSOLE)


def test_where_rows_are_written_whole_only_those_that_differ_are():
    """A reader says what is written: half a row is no sentence."""
    painted = Painted()
    sent(painted, "I walked 4 steps.")

    assert sent(painted, "I walked 4 steps.") == ""
    assert "I walked 5 steps." in sent(painted, "I walked 5 steps.")
    assert "I walked 5" in sent(painted, "I walked 5")  # and what was behind it is gone
    assert sent(painted, "I walked 5") == ""


def test_where_rows_are_written_whole_a_typed_letter_is_a_letter():
    painted = Painted()
    sent(painted, "FW 1")

    assert "FW" not in sent(painted, "FW 12", typing=Offset(5, 0))
    assert "FW 123" in sent(painted, "FW 123", typing=Offset(3, 1))
    assert "BK 123" in sent(painted, "BK 123", typing=Offset(6, 0))


@pytest.mark.parametrize(
    ("after", "cursor", "is_whole"),
    [
        ("FW 12", 6, False),  # the letter before the one before the cursor
        ("FW 12", 7, True),
        ("FX 1", 4, True),
        ("FW 1", 4, True),  # the same letters in another style, as a mark
    ],
)
def test_a_row_is_written_whole_if_it_changes_before_the_typed_letters(after, cursor, is_whole):
    painted = Painted()
    sent(painted, "FW 1")
    style = STYLES[1 if after == "FW 1" else 0]
    strip = Strip([Segment(after.ljust(20), style)])
    given = painted.less(update(0, 0, strip), rows=True, typing=Offset(cursor, 0))

    assert (f"{after}" in given.render_segments(CONSOLE)) is is_whole


def test_letters_are_written_alone_though_the_look_of_others_before_them_changes():
    """As where a word becomes a command when the next one ends."""
    painted, plain, command = Painted(), *STYLES[:2]
    before = Strip([Segment("FW 12345678901234567890    ", plain)])
    after = Strip([Segment("FW", command), Segment(" 12345678901234567890+  ", plain)])
    painted.less(update(0, 0, before), rows=True).render_segments(CONSOLE)
    written = painted.less(update(0, 0, after), rows=True, typing=Offset(24, 0)).render_segments(CONSOLE)

    assert written == "\x1b[34;40m\x1b[1;1HFW\x1b[0m\x1b[31;40m\x1b[1;24H+\x1b[0m"


@pytest.mark.parametrize(
    ("others", "is_whole"),
    [
        ([], False),
        ([("old", "new", 0)], False),
        ([("old", "new", 0), ("old", "new", 0)], True),
        ([("old", "old", 1), ("old", "old", 1)], True),
        ([("old", "old", 0), ("old", "old", 0)], False),
        ([("界", "界", 0), ("界", "界", 0)], True),
    ],
    ids=("alone", "status line", "others", "other looks", "the same", "wide letters"),
)
def test_a_typed_letter_may_change_the_status_line_too(others, is_whole):
    """If more rows change, or may have, it is no letter: the row was filled anew."""
    painted = Painted()
    for at in (0, 1):
        rows = [("FW 1", 0) if not at else ("FW 12", 0)]
        rows += [(each[at], each[2] if at else 0) for each in others]
        strips = [Strip([Segment(text.ljust(20), STYLES[look])]) for text, look in rows]
        chops = [{0: strips[row]} if row < len(rows) else {} for row in range(ROWS)]
        spans = [(row, 0, COLUMNS) for row in range(len(rows))]
        given = ChopsUpdate(chops, spans, [[COLUMNS]] * ROWS)
        written = painted.less(given, rows=True, typing=Offset(5, 0)).render_segments(CONSOLE)

    assert ("\x1b[1;1HFW 12" in written) is is_whole


def test_a_whole_row_ends_after_its_last_letter_or_change():
    """Blanks after it say nothing."""
    painted = Painted()
    first = sent(painted, "ab")
    assert "ab" + " " * 18 in first  # what was there is not known

    assert sent(painted, "ac").endswith("Hac\x1b[0m")
    assert sent(painted, "a").endswith("Ha \x1b[0m")


@pytest.fixture
def written(monkeypatch):
    """What is written to the terminal, update by update."""
    updates: list[str] = []
    less = Painted.less

    def noted(self, update, **how):
        smaller = less(self, update, **how)
        if isinstance(smaller, ChangedCells):
            updates.append(smaller.render_segments(CONSOLE))
        return smaller

    monkeypatch.setattr(Painted, "less", noted)
    return updates


def cost(updates: list[str]) -> int:
    """In bytes."""
    return len("".join(updates).encode())


@pytest.mark.parametrize(("plain", "most"), [(False, 100), (True, 140)], ids=["panes", "plain"])
async def test_a_typed_key_costs_few_bytes(open_screen, written, plain, most):
    """At the end of a line, in the program and in the command line.

    One of three: on a busy machine the mark of a mistake, painted when typing rests, may change with a key.
    """
    async with open_screen("FW 1\nTR 90\n", plain=plain) as screen:
        for widget in (screen.main.editor, screen.main.command_line):
            widget.focus()
            for key in ("end", "space", *"tr 12"):
                await screen.press(key)
            await screen.painted()
            costs = []
            for key in "345":
                written.clear()
                await screen.press(key)
                await screen.painted()
                costs.append(cost(written))

            assert 0 < min(costs) <= most, costs


@pytest.mark.parametrize(("plain", "most"), [(False, 1500), (True, 2500)], ids=["panes", "plain"])
async def test_a_move_to_the_next_pane_writes_only_the_changes(open_screen, written, plain, most):
    """Titles, the status line and the keys, not the whole screen; in the plain layout another pane."""
    async with open_screen("FW 1", plain=plain) as screen:
        await screen.press("tab")  # where Textual paints styles for the first time
        await screen.painted()
        for _ in range(3):
            written.clear()
            await screen.press("tab")
            await screen.painted()

            assert 0 < cost(written) < most


def test_the_installed_version_of_textual_fits():
    assert fits(CONSOLE)
    assert isinstance(diff_output(CONSOLE), Painted)


class WithoutChops(CompositorUpdate):
    """An update of another version: of another form."""

    def __init__(self, rows, *_others):
        self.rows = rows

    def render_segments(self, console):
        return "of another version"


@pytest.mark.parametrize("name", ["ChopsUpdate", "LayoutUpdate"])
async def test_textuals_own_output_is_sent_where_its_updates_have_another_form(
    open_screen, monkeypatch, name
):
    monkeypatch.setattr(terminal_output, name, WithoutChops)
    monkeypatch.setattr(terminal_output, "Update", WithoutChops)
    sent = []
    async with open_screen("FW 1") as screen:
        monkeypatch.setattr(App, "_display", lambda self, screen, renderable: sent.append(renderable))
        await screen.type_line("POS")
        await screen.until(lambda: any(isinstance(each, ChopsUpdate) for each in sent), "Textual's update")

    assert diff_output(CONSOLE) is None
    assert not any(isinstance(each, ChangedCells) for each in sent)


def test_textuals_own_output_is_sent_where_its_updates_have_no_such_name(monkeypatch):
    monkeypatch.delattr(_compositor, "ChopsUpdate")
    monkeypatch.delitem(sys.modules, "donnie_tui.tui.terminal_output")
    monkeypatch.delattr(tui, "terminal_output")

    assert diff_output(CONSOLE) is None
