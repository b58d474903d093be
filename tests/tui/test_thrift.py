"""Only what changed is sent to the terminal, and the terminal shows the same as if all had been sent."""

import random

import pyte
from rich.console import Console
from rich.segment import Segment
from rich.style import Style
from textual._compositor import ChopsUpdate
from textual.strip import Strip

from donnie_tui.tui.thrift import Painted

COLUMNS, ROWS = 30, 4
CONSOLE = Console(force_terminal=True, color_system="truecolor")
STYLES = [
    Style.parse(each)
    for each in ("red on black", "blue on black", "bold on white", "reverse", "underline", "")
]
LETTERS = [*"aabb    éü²=界🤖", "e\u0301"]


def update(x: int, y: int, strip: Strip) -> ChopsUpdate:
    return ChopsUpdate(
        [{x: strip} if row == y else {} for row in range(ROWS)], [(y, 0, COLUMNS)], [[COLUMNS]] * ROWS
    )


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
        thin.feed(painted.less(update(x, y, strip)).render_segments(CONSOLE))
        whole.feed(update(x, y, strip).render_segments(CONSOLE))

        assert thin.cells() == whole.cells()


def test_what_is_there_already_costs_nothing_and_one_letter_little():
    painted, red = Painted(), STYLES[0]
    before, after = (Strip([Segment(text, red)]) for text in ("I walked 4 steps.", "I walked 5 steps."))
    painted.less(update(0, 0, before)).render_segments(CONSOLE)

    assert painted.less(update(0, 0, before)).render_segments(CONSOLE) == ""
    assert painted.less(update(0, 0, after)).render_segments(CONSOLE) == "\x1b[31;40m\x1b[1;10H5\x1b[0m"


def test_after_the_whole_screen_was_painted_nothing_is_known():
    painted, strip = Painted(), Strip([Segment("FW 4", STYLES[0])])
    sent = painted.less(update(0, 0, strip)).render_segments(CONSOLE)
    painted.less("something else")

    assert painted.less(update(0, 0, strip)).render_segments(CONSOLE) == sent


async def test_in_the_plain_layout_rows_are_written_whole(work, monkeypatch):
    """A reader tells what is written: half a row is no sentence."""
    asked = []
    monkeypatch.setattr(Painted, "less", lambda _self, update: asked.append(update) or update)
    async with work("FW 1", plain=True) as desk:
        await desk.press("f5")
        await desk.told("The program is done.")
    assert asked == []

    async with work("FW 1", plain=False) as desk:
        await desk.press("f5")
        await desk.told("The program is done.")
    assert asked != []
