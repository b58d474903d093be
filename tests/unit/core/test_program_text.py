"""Reading a program by its blocks: levels as in the syntax tree, every END names its opener."""

import difflib

import pytest
from hypothesis import given

from donnie_tui.core.program_text import (
    ProgramText,
    corrected_line,
    fixed,
    line_in_words,
    mistakes,
    no_such_line,
    not_found,
    outline_in_words,
    place_in_words,
)
from donnie_tui.i18n.words import Words
from language.checker import check
from language.parser import parse
from language.syntax import Statement, blocks_of
from tests.formatting import format_source
from tests.properties.programs import programs

RECTANGLE = """\
PROCEDURE RECTANGLE: a DO
  REPEAT 2 TIMES
    FW a

    IF a > 3 THEN
      TR 90
    ELSE
      TL 90
    END IF
  END REPEAT
END PROCEDURE
RECTANGLE [4]""".splitlines()


def depths(statements: tuple[Statement, ...], depth: int = 0) -> dict[int, int]:
    """The level of the first statement of each line, from the syntax tree."""
    found: dict[int, int] = {}
    for statement in statements:
        found.setdefault(statement.span.line, depth)
        for block in blocks_of(statement):
            for line, level in depths(block, depth + 1).items():
                found.setdefault(line, level)
    return found


@given(programs())
def test_the_level_of_a_line_is_its_depth_in_the_syntax_tree(source: str) -> None:
    source = format_source(source)
    program = parse(source).program
    assert program is not None
    text = ProgramText(source.split("\n"))

    for line, depth in depths(program.body).items():
        assert (text.line(line).level, line) == (depth, line)


def test_every_end_names_the_line_that_it_closes() -> None:
    text = ProgramText(RECTANGLE)

    assert [text.line(number).closes for number in (9, 10, 11)] == [5, 2, 1]
    assert (
        line_in_words(text.line(10), text.line(9), Words()) == "Line 10, level 1: END REPEAT, closes line 2."
    )


@pytest.mark.parametrize(
    ("detail", "before", "sentence"),
    [
        ("normal", 2, "Line 3, level 2: FW a"),
        ("normal", 5, "Line 3: FW a"),
        ("full", 5, "Line 3, level 2: FW a"),
        ("brief", 2, "Line 3: FW a"),
    ],
)
def test_the_level_is_said_when_it_changes_always_or_never(detail: str, before: int, sentence: str) -> None:
    text = ProgramText(RECTANGLE)

    assert line_in_words(text.line(3), text.line(before), Words("en", detail)) == sentence


def test_an_empty_line_is_called_empty() -> None:
    assert line_in_words(ProgramText(RECTANGLE).line(4), None, Words("en", "brief")) == "Line 4: empty."


@pytest.mark.parametrize(
    ("number", "up", "down", "following", "before"),
    [
        (1, None, 2, 12, None),
        (2, 1, 3, None, None),
        (3, 2, None, 5, None),
        (5, 2, 6, None, 3),
        (6, 5, None, None, None),
        (7, 2, None, None, 5),
        (10, 2, None, None, 2),
        (12, None, None, None, 1),
    ],
)
def test_moves_follow_the_blocks_and_stay_at_their_limits(
    number: int, up: int | None, down: int | None, following: int | None, before: int | None
) -> None:
    text = ProgramText(RECTANGLE)

    assert (text.up(number), text.down(number)) == (up, down)
    assert (text.next_same(number), text.back_same(number)) == (following, before)


def test_the_place_names_the_blocks_from_the_inside_out() -> None:
    assert place_in_words(ProgramText(RECTANGLE), 6, Words()) == (
        "Line 6 of 12, level 3.",
        "In IF from line 5.",
        "In REPEAT from line 2.",
        "In PROCEDURE RECTANGLE from line 1.",
    )


def test_the_outline_has_the_openers_only() -> None:
    assert outline_in_words(ProgramText(RECTANGLE), Words()) == (
        "3 blocks.",
        "Line 1, level 0: PROCEDURE RECTANGLE: a DO",
        "Line 2, level 1: REPEAT 2 TIMES",
        "Line 5, level 2: IF a > 3 THEN",
    )


def test_half_a_program_can_be_read() -> None:
    text = ProgramText(["REPEAT 2 TIMES", "FW 1", "IF x"])

    assert [text.line(number).level for number in (1, 2, 3)] == [0, 1, 1]
    with pytest.raises(IndexError):
        text.line(4)


@pytest.mark.parametrize(("detail", "widest"), [("brief", 40), ("normal", 80), ("full", 80)])
def test_a_long_line_is_cut_in_the_outline(detail: str, widest: int) -> None:
    lines = ["REPEAT 2 TIMES " + "FW 1 " * 100, "END REPEAT"]
    rows = outline_in_words(ProgramText(lines), Words("en", detail))

    assert len(rows[1]) <= widest
    assert rows[1].startswith("Line 1, level 0: REPEAT 2 TIMES FW")


# --- lines that are typed again

FWD, JUMP = {2: ["FWD 2", "FW 2"]}, {2: ["JUMP 3"]}


@pytest.mark.parametrize(
    ("line", "wrong", "last", "is_next", "is_refused", "number"),
    [
        ("FW 2", FWD, 2, True, True, 2),
        ("FW 2", FWD, 9, False, True, 2),  # like it, wherever it is
        ("FW 2", FWD, 9, True, False, 2),  # after a failed run the very next line
        ("FW 2", FWD, 2, False, False, None),
        ("TR 90", JUMP, 2, True, True, 2),  # quite another one, if only the last was wrong
        ("TR 90", JUMP, 3, True, True, None),
        ("TR 90", JUMP, 2, False, True, None),
        ("TR 90", JUMP, 2, True, False, None),
        ("TR 90", {1: ["HOP"], 2: ["JUMP 3"]}, 2, True, True, None),
        ("END IF", JUMP, 2, True, True, None),  # a part of a block
        ("  FIM SE", JUMP, 2, True, True, None),
        ("ELSE", JUMP, 2, True, True, None),
        ("JUMP 4", {1: ["HOP 4"], 2: ["JUMP 3"]}, 2, True, True, 2),  # the one that is most like it
        ("BW 1", {1: ["FW"], 2: ["BW one two three four"]}, 2, True, True, 2),  # the same command
    ],
)
def test_a_line_that_is_typed_again_replaces_the_wrong_one(
    line: str, wrong: dict[int, list[str]], last: int, is_next: bool, is_refused: bool, number: int | None
) -> None:
    assert corrected_line(line, wrong, last, is_next=is_next, is_refused=is_refused) == number


def test_of_long_lines_only_the_beginning_is_compared(monkeypatch: pytest.MonkeyPatch) -> None:
    """Two of 20 000 characters took more than a minute."""
    compared: list[int] = []

    class Matcher(difflib.SequenceMatcher[str]):
        def ratio(self) -> float:
            compared.append(len(self.a) * len(self.b))
            return super().ratio()

    monkeypatch.setattr(difflib, "SequenceMatcher", Matcher)
    wrong = {1: ["SPEK " + "ab" * 10_000], 2: ["FW 1"]}

    assert corrected_line("SPEAK " + "ab" * 10_000, wrong, 2, is_next=True, is_refused=True) == 1
    assert max(compared) <= 100_000


@pytest.mark.parametrize(("same", "number"), [(180, 1), (179, None)])
def test_three_hundred_characters_of_a_line_are_compared(same: int, number: int | None) -> None:
    """180 of 300 are alike enough, 180 of 301 are not."""
    line, other = ("x" * same + each * (300 - same) for each in "ab")

    assert corrected_line(line + "c", {1: [other + "d"]}, 2, is_next=True, is_refused=True) == number


# --- blocks, line by line


@pytest.mark.parametrize(
    ("number", "level", "closes", "is_statement", "opener", "end"),
    [
        (1, 0, 0, True, 0, 11),
        (2, 1, 0, True, 0, 10),
        (3, 2, 0, True, 0, 3),
        (4, 2, 0, False, 0, 4),
        (5, 2, 0, True, 0, 9),
        (6, 3, 0, True, 0, 6),
        (7, 2, 0, False, 5, 7),
        (9, 2, 5, False, 5, 9),
        (10, 1, 2, False, 2, 10),
        (11, 0, 1, False, 1, 11),
        (12, 0, 0, True, 0, 12),
    ],
)
def test_each_line_knows_its_block(
    number: int, level: int, closes: int, is_statement: bool, opener: int, end: int
) -> None:
    text = ProgramText(RECTANGLE)
    line = text.line(number)

    assert (line.number, line.text) == (number, RECTANGLE[number - 1].strip())
    assert (line.level, line.closes, line.is_statement) == (level, closes, is_statement)
    assert (text.opener_of(number), text.end_of(number)) == (opener, end)
    assert [each.line for each in text.openers(number)] == [1, 2, 5][:level][::-1]


@pytest.mark.parametrize("number", [0, -1, 13])
def test_there_is_no_line_before_the_first_or_after_the_last(number: int) -> None:
    text = ProgramText(RECTANGLE)
    assert len(text) == 12
    with pytest.raises(IndexError, match=str(number)):
        text.line(number)


@pytest.mark.parametrize(
    ("lines", "levels", "openers"),
    [
        (["ELSE", "FW 1"], [0, 0], [0, 0]),  # no block is open
        (["END IF"], [0], [0]),
        (["REPEAT 2 TIMES", "ELSE", "FW 1"], [0, 0, 1], [0, 1, 0]),
        (["REPEAT 2 TIMES FW 1 END REPEAT", "FW 1"], [0, 0], [0, 0]),
        (["IF 1 < 2 THEN REPEAT 2 TIMES", "FW 1", "END REPEAT END IF", "FW 1"], [0, 2, 1, 0], [0, 0, 1, 0]),
        (["SPEAK 1", "", "SE 1 < 2 ENTÃO", "SENÃO", "FIM SE"], [0, 0, 0, 0, 0], [0, 0, 0, 3, 3]),
        (["steps = 1", "END = 2"], [0, 0], [0, 0]),
        ([], [], []),
    ],
)
def test_unfinished_and_short_blocks_have_levels(
    lines: list[str], levels: list[int], openers: list[int]
) -> None:
    text = ProgramText(lines)
    numbers = range(1, len(lines) + 1)

    assert [text.line(number).level for number in numbers] == levels
    assert [text.opener_of(number) for number in numbers] == openers


def test_the_first_line_of_a_text_has_its_level_only_where_it_is_not_0() -> None:
    text = ProgramText(RECTANGLE)

    assert line_in_words(text.line(1), None, Words()) == "Line 1: PROCEDURE RECTANGLE: a DO"
    assert line_in_words(text.line(2), None, Words()) == "Line 2, level 1: REPEAT 2 TIMES"
    assert line_in_words(text.line(1), None, Words("en", "full")).startswith("Line 1, level 0: ")


def test_a_program_without_blocks_has_no_outline_and_one_without_lines_no_line() -> None:
    assert outline_in_words(ProgramText(["FW 1"]), Words()) == (Words()("outline-none"),)
    assert no_such_line(3, 7, Words()) == Words()("answer-no-line", line=7, last=3)
    assert no_such_line(0, 7, Words()) == Words()("no-lines")


@pytest.mark.parametrize(("detail", "widest"), [("brief", 40), ("normal", 80)])
def test_a_row_of_the_outline_is_as_wide_as_a_line_of_print(detail: str, widest: int) -> None:
    first = "Line 1, level 0: REPEAT 2 TIMES "
    for more, is_cut in ((0, False), (1, True)):
        line = f"REPEAT 2 TIMES {'x' * (widest - len(first) + more)}"
        row = outline_in_words(ProgramText([line, "END REPEAT"]), Words("en", detail))[1]
        assert len(row) == widest
        assert row.endswith("\N{HORIZONTAL ELLIPSIS}") is is_cut


@pytest.mark.parametrize(
    ("lines", "count"), [(["REPEAT 2 TIMES REPEAT 3 TIMES", "END REPEAT END REPEAT"], 1), (RECTANGLE, 3)]
)
def test_a_line_that_opens_two_blocks_is_once_in_the_outline(lines: list[str], count: int) -> None:
    assert len(ProgramText(lines).outline_lines) == count


# --- mistakes of lines


def test_the_first_mistake_of_each_line_has_its_fix() -> None:
    source = "FWD 1 FWD 2\nDISTANSE F\nVAR a = 3 *"
    found = mistakes(parse(source).diagnostics, Words())
    first = found[1]

    assert (first.message, first.is_hint, first.meant, first.fixed_line) == (
        "I do not know FWD.",
        False,
        "FW",
        1,
    )
    assert (source[first.start : first.end], first.replacement) == ("FWD", "FW")
    assert fixed(source, first).startswith("FW 1 FWD 2\n")
    assert (found[3].meant, found[3].line) == ("", 3)


def test_a_hint_of_the_checker_is_said_by_its_advice() -> None:
    program = parse("DISTANCE F").program
    assert program is not None
    (hint,) = mistakes(check(program), Words()).values()

    assert (hint.message, hint.is_hint) == ("Did you mean SPEAK DISTANCE F?", True)


def test_a_missing_word_is_put_at_the_end_of_the_line_before() -> None:
    source = "REPEAT 2\nFW 1\nEND REPEAT"
    (missing,) = mistakes(parse(source).diagnostics, Words()).values()

    assert (missing.line, missing.fixed_line, missing.replacement) == (2, 1, " TIMES")
    assert fixed(source, missing) == "REPEAT 2 TIMES\nFW 1\nEND REPEAT"


@pytest.mark.parametrize(
    ("word", "shown"), [("w" * 40, "w" * 40), ("w" * 41, f"{'w' * 39}…"), ("a\x07", "a "), (" ", " ")]
)
def test_a_searched_word_is_quoted_up_to_forty_characters(word: str, shown: str) -> None:
    assert not_found(word, Words()) == f"{shown} is not in the program."
