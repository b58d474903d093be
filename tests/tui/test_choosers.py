"""Lists to choose from and questions, alone: which rows are shown, chosen, spoken and answered."""

from __future__ import annotations

from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from typing import Any

import pytest
from textual.app import App
from textual.geometry import Offset, Region
from textual.pilot import Pilot
from textual.screen import Screen

from donnie_tui.commands.interaction import Option
from donnie_tui.tui.screens.dialogs import Chooser, Completions, Question, _columns, _rank

# --- values


@pytest.mark.parametrize(
    ("text", "typed", "rank"),
    [
        ("run\n", "run", 0), ("run (f5): runs\n", "run", 0), ("run: runs\n", "run", 0),
        ("run, all\n", "run", 0), ("running\n", "run", 2), ("run again\n", "run", 2),
        ("go\nstart, run", "run", 1), ("go\nrunning", "run", 4),
        ("to run\n", "run", 3), ("rerun\n", "run", 4), ("to runs\n", "run", 4), ("go\n", "", 2),
    ],
)  # fmt: skip
def test_an_exact_name_comes_before_other_words_beginnings_and_parts(
    text: str, typed: str, rank: int
) -> None:
    assert _rank(text, typed) == rank


def option(*columns: str, text: str = "", detail: Any = None) -> Option:
    return Option(columns[0] if columns else text, text or " ".join(columns), columns=columns, detail=detail)


@pytest.mark.parametrize(
    ("choices", "widths"),
    [
        ([], ()),
        ([option("ab", "c"), option("a", "cde")], (4, 5)),
        ([option("ab"), option("a", "cde")], (4, 5)),
        ([option("ab", "c"), option(text="abcdef")], ()),
        ([option(text="abc", detail=lambda *_: ())], (5,)),
        ([option("日本")], (6,)),
    ],
)
def test_columns_are_as_wide_as_their_widest_cell_and_two_blanks(
    choices: list[Option], widths: tuple[int, ...]
) -> None:
    assert _columns(choices) == widths


def chooser(choices: list[Option], **how: Any) -> Chooser:
    return Chooser("Title", "Keys", "Nothing fits", choices, how.pop("point", lambda _: None), **how)


@pytest.mark.parametrize(
    ("room", "may_drop", "widths"),
    [
        (100, True, (7, 6, 5)), (16, True, (7, 6, 5)), (15, True, (7, 6)), (11, True, (7, 6)),
        (10, True, (7,)),
        (5, True, (7,)), (4, True, (7,)), (15, False, ()), (16, False, (7, 6, 5)), (4, False, ()),
    ],
)  # fmt: skip
async def test_as_many_columns_are_shown_as_fit(room: int, may_drop: bool, widths: tuple[int, ...]) -> None:
    """Of five, four and three cells, and two blanks each; the last has no blanks after it."""
    async with App[None]().run_test(size=(20, 5)):
        made = chooser([option("abcde", "abcd", "abc")])
        assert made._columns_in(room, (7, 6, 5), may_drop=may_drop) == widths


async def test_one_name_in_four_may_be_longer_than_its_column() -> None:
    async with App[None]().run_test(size=(20, 5)):
        few = [option("x" * 30, "abc"), *(option("x", "abc") for _ in range(3))]
        assert chooser(few)._columns_in(20, (32, 5), may_drop=True) == (17, 5)
        assert chooser(few[:3])._columns_in(20, (32, 5), may_drop=True) == (32,)
        made = chooser(few)
        made._columns = (17, 5)
        assert made._row(few[0]) == f"{'x' * 30}  abc"
        assert made._row(few[1]) == f"x{' ' * 16}abc"
        made._columns = (17,)
        assert made._dropped(few[1]) == ("abc",)
        made._columns = ()
        assert made._row(few[1]) == "x abc"


@pytest.mark.parametrize(
    ("columns", "rows"), [((4, 6, 22), 0), ((4, 6), 2), ((4,), 3), ((), 4)], ids=["all", "two", "one", "none"]
)
def test_the_dropped_columns_need_their_rows_below_a_list_but_less_than_half(
    columns: tuple[int, ...], rows: int
) -> None:
    """In twelve columns ten cells have room in a row, so that twenty need two."""
    made = chooser([option("ab", "easy", "x" * 20), option("a", "easy", "x")])
    made._columns = columns
    dropped = [("ab", "easy", "x" * 20)[len(columns) :], ("a", "easy", "x")[len(columns) :]]
    assert [made._dropped(each) for each in made._choices] == dropped
    most = [made._rows_below(12, height) for height in (20, 6)]
    assert most == [rows, min(2, rows)]
    made._has_details = True
    assert [made._rows_below(12, height) for height in (20, 6)] == [8, 2]


# --- on a screen


class Shown:
    def __init__(self, pilot: Pilot[None]) -> None:
        self.pilot = pilot
        self.said: list[str] = []
        self.answers: list[Any] = []

    async def push(self, screen: Screen[Any]) -> None:
        self.pilot.app.push_screen(screen, self.answers.append)
        await self.pilot.pause()

    async def press(self, *keys: str) -> list[str]:
        self.said.clear()
        await self.pilot.press(*keys)
        await self.pilot.pause()
        return [*self.said]


@asynccontextmanager
async def screen(width: int = 80, height: int = 24) -> AsyncIterator[Shown]:
    async with App[None]().run_test(size=(width, height)) as pilot:
        yield Shown(pilot)


FRUIT = [
    Option("a", "apple"),
    Option("b", "banana", is_current=True),
    Option("c", "cherry", also="apple of the sea"),
    Option("p", "pineapple"),
]


async def test_rows_are_chosen_by_keys_and_narrowed_by_letters() -> None:
    async with screen() as it:
        made = chooser(FRUIT, point=it.said.append)
        await it.push(made)
        assert it.said == ["Title banana"]
        assert await it.press("down", "up", "home", "up") == ["cherry", "banana", "apple", "apple"]
        assert await it.press("end", "down") == ["pineapple", "pineapple"]
        assert await it.press("pageup", "pagedown") == ["apple", "pineapple"]

        assert await it.press("a", "p", "p") == ["apple", "apple", "apple"]
        assert [*made.rows.lines] == ["apple", "cherry", "pineapple"]
        assert await it.press("down") == ["cherry"]
        assert await it.press("space", "s", "e", "a")
        assert [*made.rows.lines] == ["cherry"]
        assert await it.press("x") == ["Nothing fits"]
        assert [*made.rows.lines] == ["Nothing fits"]
        await it.press("enter")
        assert it.answers == []
        await it.press("backspace", "enter")
        assert it.answers == ["c"]


async def test_a_list_is_left_without_an_answer() -> None:
    async with screen() as it:
        await it.push(chooser(FRUIT))
        await it.press("escape")
        assert it.answers == [None]


@pytest.mark.parametrize(
    ("width", "height", "is_wide", "panel"),
    [(80, 24, False, (58, 7)), (66, 24, False, (58, 7)), (65, 24, True, (65, 7)), (80, 9, False, (58, 6))],
)
async def test_a_panel_is_as_large_as_its_list(
    width: int, height: int, is_wide: bool, panel: tuple[int, int]
) -> None:
    """56 columns at least and a border; as wide as the screen if fewer than eight columns are left."""
    async with screen(width, height) as it:
        made = chooser(FRUIT)
        await it.push(made)
        assert made._panel.has_class("-wide-as-all") == is_wide
        assert (made._panel.outer_size.width, made._panel.outer_size.height) == panel


async def test_details_of_the_chosen_row_are_shown_and_cut() -> None:
    def detail(columns: int, rows: int) -> tuple[str, ...]:
        return tuple(f"line {number} of it" for number in range(40))

    async with screen(100, 24) as it:
        made = chooser([option("one", detail=detail), option("two", detail=lambda *_: ("short",))])
        await it.push(made)
        assert made._detail is not None
        lines = made._detail.lines
        assert lines[0] == "line 0 of it"
        assert lines[-1].endswith(" ...")
        assert len(lines) == made._detail.size.height
        await it.press("down")
        assert [*made._detail.lines] == ["short"]
        await it.press("z", "z")
        assert [*made._detail.lines] in ([], [""])


# --- questions


async def test_a_question_is_typed_over_and_a_wrong_answer_is_said() -> None:
    async with screen() as it:
        wrong = {"x": "Not x."}
        await it.push(Question("Why?", "Keys", it.said.append, value="old", accepts=wrong.get))
        assert it.said == ["Why? old"]
        assert await it.press("x", "enter") == ["Not x."]
        assert await it.press("up", "down", "tab") == []
        await it.press("y", "space", "enter")
        assert it.answers == ["y"]


async def test_answers_above_a_question_are_chosen_written_or_left() -> None:
    async with screen() as it:
        asked = Question("Why?", "Keys", it.said.append, answers=("one", "two", "three"))
        await it.push(asked)
        assert it.said == ["Why?"]
        assert await it.press("down", "down", "up", "up") == ["one", "two", "one", "one"]
        assert await it.press("down", "down", "down") == ["two", "three", "three"]
        await it.press("tab")
        assert asked._line.value == "three"
        await it.press("s", "enter")
        assert it.answers == ["threes"]


@pytest.mark.parametrize(
    ("keys", "answer"),
    [
        (("down", "down", "enter"), "two"),
        (("enter",), ""),
        (("escape",), None),
        (("up", "enter"), "one"),
        (("tab", "enter"), "one"),
    ],
)
async def test_enter_takes_the_chosen_row_or_what_was_typed(
    keys: tuple[str, ...], answer: str | None
) -> None:
    async with screen() as it:
        await it.push(Question("Why?", "Keys", it.said.append, answers=("one", "two")))
        await it.press(*keys)
        assert it.answers == [answer]


# --- words that may follow


@pytest.mark.parametrize(
    ("row", "count", "place"),
    [
        (5, 3, (10, 6, 3)),
        (20, 3, (10, 17, 3)),
        (5, 20, (10, 6, 8)),
        (22, 30, (10, 14, 8)),
        (1, 2, (10, 2, 2)),
    ],
)
async def test_words_are_below_the_cursor_or_above_where_there_is_more_room(
    row: int, count: int, place: tuple[int, int, int]
) -> None:
    async with screen() as it:
        words = [f"word{number}" for number in range(count)]
        made = Completions(words, "Keys", Offset(10, row), Region(0, 1, 80, 22), it.said.append)
        await it.push(made)
        styles = made.list.styles
        assert styles.height is not None
        assert (styles.offset.x.value, styles.offset.y.value, styles.height.value) == place
        assert it.said == ["word0"]


@pytest.mark.parametrize(
    ("keys", "answer"),
    [
        (("enter",), ("one", "")),
        (("tab",), ("one", "")),
        (("down", "tab"), ("two", "")),
        (("escape",), None),
        (("x",), ("", "x")),
    ],
)
async def test_a_word_is_taken_or_a_letter_typed(
    keys: tuple[str, ...], answer: tuple[str, str] | None
) -> None:
    async with screen() as it:
        await it.push(
            Completions(["one", "two"], "Keys", Offset(78, 5), Region(0, 0, 80, 24), it.said.append)
        )
        await it.press(*keys)
        assert it.answers == [answer]
