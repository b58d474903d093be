"""What is painted while a line is edited, checked on a terminal that is emulated."""

import pyte
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from donnie_tui.linear.line_editor import LONGEST, Act, EditLine, clusters, places, width
from tests.effort import examples

COLUMNS, ROWS = 20, 12
PROMPT = "> "


class Paper:
    """A small terminal with a prompt on it."""

    def __init__(self, offered: str = "") -> None:
        self.screen = pyte.Screen(COLUMNS, ROWS)
        self._stream = pyte.Stream(self.screen)
        self._stream.feed(PROMPT + offered)
        self.line = EditLine(len(PROMPT), lambda: COLUMNS, offered)
        self.write(self.line.place_cursor())

    def write(self, painted: str) -> None:
        self._stream.feed(painted)

    @property
    def text(self) -> str:
        return "".join(self.screen.display).rstrip()

    @property
    def cursor(self) -> tuple[int, int]:
        return self.screen.cursor.y, self.screen.cursor.x


def edited(*steps: str | Act, offered: str = "") -> EditLine:
    line = EditLine(len(PROMPT), lambda: 80, offered)
    for step in steps:
        line.type(step) if isinstance(step, str) else line.do(step)
    return line


@pytest.mark.parametrize(
    ("steps", "text"),
    [
        (("FW 3",), "FW 3"),
        (("FW 33", Act.BACKSPACE), "FW 3"),
        ((Act.BACKSPACE, "a"), "a"),
        (("W 3", Act.HOME, "F"), "FW 3"),
        (("FFW", Act.HOME, Act.DELETE), "FW"),
        (("FW 3 TR", Act.KILL_WORD), "FW 3 "),
        (("FW 3 ", Act.KILL_WORD), "FW "),
        (("FW 3", Act.LEFT, Act.LEFT, Act.KILL_AFTER), "FW"),
        (("FW 3", Act.LEFT, Act.KILL_BEFORE), "3"),
        (("cafe\u0301", Act.BACKSPACE), "caf"),
        (("e", "\u0301", "x"), "e\u0301x"),
        (("漢字", Act.LEFT, "x"), "漢x字"),
        (("👩‍💻a", Act.LEFT, Act.BACKSPACE), "a"),
        (("FW", Act.HOME, Act.BACKSPACE, "x"), "xFW"),
        (("FW", Act.DELETE, "x"), "FWx"),
        (("FW", Act.HOME, Act.LEFT, "x"), "xFW"),
        (("a b ", Act.HOME, Act.KILL_WORD, "x"), "xa b "),
        (("ab  ", Act.KILL_WORD), ""),
        (("FW", Act.CLOSE, Act.HOME, Act.CLOSE), "W"),
    ],
)
def test_keys_edit(steps: tuple[str | Act, ...], text: str) -> None:
    assert edited(*steps).text == text


def test_a_typed_character_writes_itself_and_nothing_else() -> None:
    assert EditLine(2, lambda: 80).type("F") == "F"


def test_a_key_that_can_do_nothing_writes_nothing() -> None:
    line = EditLine(2, lambda: 80)

    assert [line.do(act) for act in Act if act is not Act.TEXT] == [""] * (len(Act) - 1)


@pytest.mark.parametrize(
    ("act", "written"),
    [(Act.BACKSPACE, "\b\x1b[K"), (Act.LEFT, "\b"), (Act.HOME, "\x1b[4D"), (Act.RIGHT, ""), (Act.END, "")],
)
def test_what_a_key_writes_at_the_end_of_a_line(act: Act, written: str) -> None:
    assert edited("FW 3").do(act) == written


def test_moving_right_says_the_passed_character() -> None:
    assert edited("FW 3", Act.HOME).do(Act.RIGHT) == "F"


@pytest.mark.parametrize(
    ("steps", "act", "written"),
    [
        (("abc",), Act.HOME, "\b\b\b"),
        (("FW 3", Act.HOME), Act.END, "\x1b[4C"),
        (("漢", Act.HOME), Act.RIGHT, "漢"),
        (("ab", Act.HOME), Act.END, "\x1b[2C"),
        (("ab", Act.LEFT), Act.DELETE, "\x1b[K"),
        (("abc", Act.HOME), Act.DELETE, "bc\x1b[K\b\b"),
    ],
)
def test_a_line_writes_as_little_as_it_can(steps: tuple[str | Act, ...], act: Act, written: str) -> None:
    assert edited(*steps).do(act) == written


def test_a_line_that_ends_in_the_row_of_the_cursor_writes_nothing_more() -> None:
    assert edited("FW 3", Act.HOME).finish() == ""


@pytest.mark.parametrize(
    ("typed", "word", "written"),
    [("RE", "REPEAT", "PEAT"), ("REPEAT", "REPEAT", ""), ("re", "REPEAT", "\b\bREPEAT"), ("", "FW", "FW")],
)
def test_a_word_that_is_completed_writes_what_is_new_in_it(typed: str, word: str, written: str) -> None:
    line = edited(f"FW {typed}")
    assert line.complete(typed, word) == written
    assert line.text == f"FW {word}"


def test_a_line_takes_no_more_than_it_can_hold() -> None:
    line = EditLine(2, lambda: 80)
    line.type("x" * (LONGEST + 100))
    line.type("y")

    assert line.text == "x" * LONGEST


def _typing(letters: str) -> st.SearchStrategy[tuple[list[object], str]]:
    """An offered text and what is then done to it; a tuple is a line from the past."""
    text = st.text(st.sampled_from(letters), max_size=30)
    act = st.sampled_from([act for act in Act if act is not Act.TEXT])
    return st.tuples(st.lists(st.one_of(act, text.filter(bool), st.tuples(text)), max_size=12), text)


@settings(max_examples=examples(200))
@given(st.one_of(_typing("ab 12ç"), _typing("漢字")))
def test_the_terminal_shows_the_line_and_the_cursor_after_every_key(typing: tuple[list[object], str]) -> None:
    """Wide and narrow ones not mixed: the emulation does not wrap a wide one that meets the margin."""
    steps, offered = typing
    paper = Paper(offered)
    for step in steps:
        if len(paper.line.text) > 80:
            break
        if isinstance(step, tuple):
            paper.write(paper.line.replace(step[0]))
        elif isinstance(step, Act):
            paper.write(paper.line.do(step))
        elif isinstance(step, str):
            paper.write(paper.line.type(step))

        shown = paper.text.replace(" ", "")
        assert shown == (PROMPT + paper.line.text).replace(" ", "")
        before = len(clusters(paper.line.text_before))
        assert paper.cursor == places(0, len(PROMPT), clusters(paper.line.text), COLUMNS)[before]


def test_what_the_line_leaves_behind_wraps_to_where_the_next_line_may_begin() -> None:
    paper = Paper()
    paper.write(paper.line.type("x" * 30))
    paper.write(paper.line.do(Act.HOME))
    paper.write(paper.line.finish())

    assert paper.cursor[0] == 1


@pytest.mark.parametrize(("character", "cells"), [("a", 1), ("ç", 1), ("漢", 2), ("\u0301", 0), ("👩‍💻", 2)])
def test_each_character_has_its_width(character: str, cells: int) -> None:
    assert width(character) == cells


def test_a_wide_character_that_does_not_fit_begins_the_next_row() -> None:
    assert places(0, 2, clusters("a漢b"), 4) == [(0, 2), (1, 0), (1, 2), (1, 3)]
    assert places(0, 0, clusters("ab"), 2) == [(0, 0), (0, 1), (1, 0)]
    assert places(3, 1, [], 2) == [(3, 1)]


def test_an_enclosing_mark_belongs_to_its_character() -> None:
    assert clusters("1\u20e3b") == ["1\u20e3", "b"]
    assert clusters("❤\ufe0fb") == ["❤\ufe0f", "b"]
