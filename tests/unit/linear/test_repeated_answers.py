"""A reader that compares the screen before and after also says a repeated answer.

Fenrir does that: it says the lines that ``difflib.Differ`` finds to be new.
"""

from __future__ import annotations

from difflib import Differ
from itertools import groupby

import pytest

from donnie_tui.linear.output import PacedOutput
from tests.unit.linear.test_output import Paper

TYPED = "SHOW LOG"


class Screen:
    """A terminal that scrolls, with a prompt in its last row, or in its first one."""

    def __init__(self, rows: int, *, is_cleared: bool) -> None:
        self._rows = rows
        self._text = "> " if is_cleared else "$ ls\n" * (rows - 1) + "> "

    @property
    def lines(self) -> list[str]:
        lines = self._text.split("\n")[-self._rows :]
        return lines + [""] * (self._rows - len(lines))

    def read_after(self, text: str) -> list[str]:
        """Print it at once; what is said then, without what was typed."""
        before = self.lines
        self._text += text
        found = [line[2:] for line in Differ().compare(before, self.lines) if line.startswith("+ ")]
        return [line for line in found if line not in (f"> {TYPED}", "> ", "")]


def spoken_lines(paper: Paper, screen: Screen) -> list[str]:
    """What is said of all that was written; one look at the screen for what came at one time."""
    at_once = groupby(paper.written, key=lambda each: each[0])
    return [line for _, writes in at_once for line in screen.read_after("".join(text for _, text in writes))]


@pytest.mark.parametrize("is_cleared", [True, False])
@pytest.mark.parametrize("rows", [12, 24, 30, 50])
def test_a_reader_says_an_answer_each_time_it_is_printed(rows: int, is_cleared: bool) -> None:
    for count in range(1, 61):
        paper, screen = Paper(rows), Screen(rows, is_cleared=is_cleared)
        output = PacedOutput(paper, paced=True)
        answer = [f"I walked {number} steps." for number in range(count)]
        for _ in range(3):
            paper.wait(10)
            paper.written.clear()
            screen.read_after(TYPED)
            output.hold_newline()
            output.show(answer, "> ")
            assert spoken_lines(paper, screen) == answer, count


def test_what_was_never_printed_comes_in_blocks_of_eighteen_all_the_same() -> None:
    paper = Paper()
    output = PacedOutput(paper, paced=True)
    output.show([f"one {number}" for number in range(18)])
    paper.wait(10)
    output.show([f"two {number}" for number in range(18)], "> ")

    assert [time for time, _ in paper.written] == [0.0, 10.0]


def test_a_program_that_says_one_thing_over_and_over_is_not_held_up() -> None:
    paper = Paper()
    output = PacedOutput(paper, paced=True)
    for _ in range(3):
        output.show(["on and on"] * 18)
        paper.wait(10)

    assert [time for time, _ in paper.written] == [0.0, 10.0, 20.0]
