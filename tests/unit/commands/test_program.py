"""LIST, CHANGE, INSERT, DELETE, MOVE, UNDO: the lines of the program, and wrong arguments of commands."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from donnie_tui.core import document
from donnie_tui.core.run_state import RunState
from tests.unit.commands.scripted import Script

PROGRAM = ("FW 1", "FW 2", "FW 3", "FW 4")

OpenScript = Callable[..., Script]


@pytest.mark.parametrize(
    ("typed", "answers", "lines"),
    [
        ("CHANGE 2 BK 2", ["Line 2: BK 2"], ("FW 1", "BK 2", "FW 3", "FW 4")),
        ("INSERT 1 TR 90", ["Line 1: TR 90"], ("TR 90", *PROGRAM)),
        ("INSERT 5 TR 90", ["Line 5: TR 90"], (*PROGRAM, "TR 90")),
        ("DELETE 2 3", ["Lines 2 to 3 are deleted.", "Line 2: FW 4"], ("FW 1", "FW 4")),
        ("DELETE 4", ["Line 4 is deleted."], PROGRAM[:3]),
        ("DELETE 1 4", ["Lines 1 to 4 are deleted."], ()),
        ("MOVE 4 1", ["Line 1: FW 4"], ("FW 4", *PROGRAM[:3])),
        ("MOVE 1 2 5", ["Line 3: FW 1", "Line 4: FW 2"], ("FW 3", "FW 4", "FW 1", "FW 2")),
    ],
)
def test_a_command_changes_the_lines_and_undo_restores_them(
    open_script: OpenScript, typed: str, answers: list[str], lines: tuple[str, ...]
) -> None:
    script = open_script(*PROGRAM)
    assert script.answers_to(typed) == answers
    assert script.ctx.program.lines == lines

    script.type("UNDO")
    assert script.ctx.program.lines == PROGRAM


@pytest.mark.parametrize(
    ("typed", "answers"),
    [
        (("CHANGE 2 BK 2", "UNDO"), ["Line 2: BK 2", "Line 2: FW 2"]),
        (("INSERT 5 TR 90", "UNDO"), ["Line 5: TR 90", "Your program has 4 lines."]),
        (("REDO", "UNDO"), ["Nothing was changed.", "Nothing was changed."]),
    ],
)
def test_undo_prints_the_first_changed_line(
    open_script: OpenScript, typed: tuple[str, ...], answers: list[str]
) -> None:
    assert open_script(*PROGRAM).answers_to(*typed) == answers


@pytest.mark.parametrize(
    ("typed", "answer", "lines"),
    [
        ((), "Line 1 has run. CHANGE 1 changes it.", ("FW -3",)),
        (("x = 3",), "I don't know what was meant.", ("FW -3", "x = 3")),
        (("FWD 2",), "Line 2: FW 2", ("FW -3", "FW 2")),
        (("FW", "TR 90"), "Line 2: FW 2", ("FW -3", "FW 2", "TR 90")),
    ],
)
def test_fix_changes_no_line_that_ran(
    open_script: OpenScript, typed: tuple[str, ...], answer: str, lines: tuple[str, ...]
) -> None:
    script = open_script("FW -3")
    script.ctx.program.batch_ran()
    for line in typed:
        script.ctx.program.add(line)

    assert script.answers_to("FIX") == [answer]
    assert (script.ctx.program.lines, script.ctx.program.ran) == (lines, 1)


def test_a_line_without_its_text_is_offered_for_editing(open_script: OpenScript) -> None:
    script = open_script(*PROGRAM, answers=["FW 9"])

    assert script.answers_to("CHANGE 3") == ["Line 3: FW 9"]
    assert script.interaction.asked == ["Edit line 3, then Enter. FW 3"]
    assert script.ctx.program.lines == ("FW 1", "FW 2", "FW 9", "FW 4")


@pytest.mark.parametrize(
    ("typed", "number"),
    [
        ("CHANGE 9 FW 1", 9),
        ("DELETE 0", 0),
        ("MOVE 7 1", 7),
        *((f"{word} 99", 99) for word in ("LIST", "READ", "BREAK", "UNTIL")),
    ],
)
def test_a_missing_line_is_reported_with_the_last_one(
    open_script: OpenScript, typed: str, number: int
) -> None:
    script = open_script(*PROGRAM)

    assert script.answers_to(typed) == [f"There is no line {number}. The last is 4."]
    assert script.ctx.program.lines == PROGRAM


NUMBERED = (
    *("BREAK", "UNTIL", "READ", "LIST", "CHANGE", "INSERT", "DELETE", "MOVE", "MAP", "MAP ROW"),
    *("MAP COLUMN", "TRAIL", "LAST", "SPELL", "TYPED"),
)


def test_a_wrong_argument_is_reported_and_changes_nothing(open_script: OpenScript) -> None:
    """Otherwise DELETE would delete another line."""
    script = open_script(*PROGRAM)
    for word in (*NUMBERED, "AROUND", "WATCH"):
        (answer,) = script.answers_to(f"{word} --3")
        assert answer.startswith(f"I did not understand. Type {word}"), word
    assert script.answers_to("DELETE abc", "FIND") == [
        "I did not understand. Type DELETE 2 5.",
        "I did not understand. Type FIND wall.",
    ]

    assert script.ctx.program.lines == PROGRAM
    assert not script.ctx.program.breakpoints


@pytest.mark.parametrize(
    ("typed", "answer"),
    [
        ("listt 2", "I do not know listt. Did you mean LIST?"),
        ("ZOM IN", "I do not know ZOM IN. Did you mean ZOOM IN?"),
    ],
)
def test_a_slip_in_a_word_is_answered_with_that_word_and_runs_nothing(
    open_script: OpenScript, typed: str, answer: str
) -> None:
    script = open_script(*PROGRAM)

    assert script.answers_to(typed) == [answer]
    assert script.ctx.runs.state is RunState.READY


@pytest.mark.parametrize("typed", ["FWW 2", "LISTT"])
def test_a_slip_in_godonnie_or_a_name_of_the_program_is_left_to_the_language(
    open_script: OpenScript, typed: str
) -> None:
    script = open_script("PROCEDURE LISTT DO", "FW 1", "END PROCEDURE", "LISTT")

    assert not script.type(typed)
    assert script.printed == []


# --- copies and comments


@pytest.mark.parametrize(
    ("typed", "lines", "said"),
    [
        ("COPY 1", ["FW 1", "FW 1", "TR 90", "BW 2"], ["Line 2: FW 1"]),
        ("COPY 3 1", ["BW 2", "FW 1", "TR 90", "BW 2"], ["Line 1: BW 2"]),
        ("COPY 1 2 4", ["FW 1", "TR 90", "BW 2", "FW 1", "TR 90"], ["Line 4: FW 1", "Line 5: TR 90"]),
        ("COMMENT 2", ["FW 1", "-- TR 90", "BW 2"], ["Line 2: -- TR 90"]),
        ("COMMENT 1 2", ["-- FW 1", "-- TR 90", "BW 2"], ["Line 1: -- FW 1", "Line 2: -- TR 90"]),
        ("COPY 9", ["FW 1", "TR 90", "BW 2"], None),
        ("COMMENT 2 9", ["FW 1", "TR 90", "BW 2"], None),
        ("COPY 1 9", ["FW 1", "TR 90", "BW 2"], None),
    ],
)
def test_lines_are_copied_and_become_comments(open_script, typed, lines, said) -> None:
    script = open_script("FW 1", "TR 90", "BW 2")

    answers = script.answers_to(typed)

    assert list(script.ctx.program.lines) == lines
    assert answers == said if said else answers[0].startswith("There is no line 9")
    if said:
        script.type("UNDO")
        assert list(script.ctx.program.lines) == ["FW 1", "TR 90", "BW 2"]


def test_a_comment_becomes_a_line_again_and_keeps_its_indentation(open_script) -> None:
    script = open_script("REPEAT 2 TIMES", "  FW 1", "END REPEAT")

    script.type("COMMENT 2")
    assert script.ctx.program.lines[1] == "  -- FW 1"
    script.type("COMMENT 2")
    assert script.ctx.program.lines[1] == "  FW 1"


# --- reading

NESTED = (
    *("REPEAT 2 TIMES", "FW 1", "IF 1 == 1 THEN", "TR 90", "END IF", "BW 1", "END REPEAT"),
    "FW 2",
)


def check_conversation(script: Script, *lines: tuple[str, list[str]]) -> None:
    for typed, answers in lines:
        assert (typed, script.answers_to(typed)) == (typed, answers)


def test_a_program_is_read_along_its_blocks(open_script: OpenScript) -> None:
    check_conversation(
        open_script(*NESTED),
        ("PLACE", ["Line 1 of 8, level 0."]),
        ("READ 4", ["Line 4, level 2: TR 90"]),
        ("PLACE", ["Line 4 of 8, level 2.", "In IF from line 3.", "In REPEAT from line 1."]),
        ("UP", ["Line 3, level 1: IF 1 == 1 THEN"]),
        ("UP", ["Line 1, level 0: REPEAT 2 TIMES"]),
        ("UP", ["This line is in no block."]),
        ("DOWN", ["Line 2, level 1: FW 1"]),
        ("DOWN", ["No block opens here."]),
        ("NEXT SAME", ["Line 3: IF 1 == 1 THEN"]),
        ("NEXT SAME", ["Line 6: BW 1"]),
        ("NEXT SAME", ["There is no later line on this level."]),
        ("BACK SAME", ["Line 3: IF 1 == 1 THEN"]),
        ("BACK SAME", ["Line 2: FW 1"]),
        ("BACK SAME", ["There is no earlier line on this level."]),
    )


def test_a_program_is_read_line_by_line_between_its_ends(open_script: OpenScript) -> None:
    check_conversation(
        open_script(*NESTED),
        ("FIRST", ["Line 1: REPEAT 2 TIMES"]),
        ("BACK", ["That is the first line."]),
        ("NEXT", ["Line 2, level 1: FW 1"]),
        ("LAST LINE", ["Line 8, level 0: FW 2"]),
        ("NEXT", ["That is the last line."]),
        ("BACK", ["Line 7: END REPEAT, closes line 1."]),
        ("READ", ["Line 7: END REPEAT, closes line 1."]),
        ("LIST 2 3", ["2: FW 1", "3: IF 1 == 1 THEN"]),
        ("LIST 7", ["7: END REPEAT"]),
    )


def test_the_outline_goes_to_the_block_that_is_chosen(open_script: OpenScript) -> None:
    rows = ["2 blocks.", "Line 1, level 0: REPEAT 2 TIMES", "Line 3, level 1: IF 1 == 1 THEN"]
    script = open_script(*NESTED, answers=[None, "3"])

    check_conversation(script, ("OUTLINE", rows), ("READ", ["Line 1: REPEAT 2 TIMES"]))
    check_conversation(script, ("OUTLINE", [*rows, rows[2]]), ("READ", ["Line 3: IF 1 == 1 THEN"]))


@pytest.mark.parametrize(
    ("answer", "typed"),
    [
        (
            "There are no lines yet.",
            "PLACE,UP,DOWN,FIRST,LAST LINE,NEXT,BACK,LIST,READ,FORMAT,COPY,COMMENT,SHOW PROGRAM",
        ),
        ("There are no blocks.", "OUTLINE"),
        ("There are no errors.", "ERROR,ERRORS,ERROR NEXT,ERROR PREVIOUS,EXPLAIN"),
        ("Nothing has been said yet.", "LAST,LAST WORD,SPELL,SHOW LOG"),
        ("I have not said wall.", "FIND wall"),
        ("Nothing was typed yet.", "TYPED"),
        ("wall is not in the program.", "SEARCH wall,SEARCH AGAIN,REPLACE wall"),
        ("Nothing was changed.", "UNDO,REDO"),
        ("There is nothing to delete.", "DELETE"),
        ("There is nothing to save.", "SAVE"),
        ("Nothing is running.", "STOP,STOP ALL,PAUSE,CONTINUE"),
        ("There are no breakpoints.", "BREAK"),
    ],
)
def test_without_a_program_a_command_says_what_is_missing(
    open_script: OpenScript, answer: str, typed: str
) -> None:
    script = open_script()
    for word in typed.split(","):
        check_conversation(script, (word, [answer]))


def test_what_was_typed_is_listed_and_the_line_that_is_chosen_is_typed_again(open_script: OpenScript) -> None:
    script = open_script(answers=[None, "FW 1"])
    for line in ("FW 1", "TR 90", "TYPED"):
        script.ctx.past.remember(line)

    check_conversation(script, ("TYPED", ["1: FW 1", "2: TR 90"]), ("TYPED 1", ["2: TR 90"]))
    assert script.interaction.asked == [*("Typed before", "TR 90", "FW 1"), "Typed before", "TR 90", "> FW 1"]


# --- mistakes

FW, FWD, SPEAK = (
    ["Error, line 1, column 1: FW needs a number, such as FW 2.", "Line 1: FW"],
    ["Error, line 3, column 1: I do not know FWD.", "Line 3: FWD 2", "Did you mean FW?"],
    ['Error, line 4, column 1: SPEAK needs a text, such as SPEAK "hello".', "Line 4: SPEAK"],
)
EXPLAINED = [
    "Something is missing or out of place.",
    "You write: FW value, or FORWARD value.",
    "Example: FW 5.",
]


def test_the_errors_of_a_run_are_said_one_by_one(open_script: OpenScript) -> None:
    check_conversation(
        open_script("FW", "TR 90", "FWD 2", "SPEAK"),
        ("AGAIN", [*FW, *FWD, *SPEAK]),
        ("ERROR", FW),
        ("ERROR NEXT", FWD),
        ("READ", ["Line 3: FWD 2"]),
        ("ERROR NEXT", SPEAK),
        ("ERROR NEXT", ["No more errors. That is 3 of 3."]),
        ("ERROR PREVIOUS", FWD),
        ("ERROR PREVIOUS", FW),
        ("ERROR PREVIOUS", ["No more errors. That is 1 of 3."]),
        ("READ", ["Line 1: FW"]),
        ("ERRORS", [*FW, *FWD, *SPEAK]),
    )


def test_an_explanation_shows_the_line_as_it_was_when_it_failed(open_script: OpenScript) -> None:
    script = open_script("TR 90", "FW")
    script.answers_to("AGAIN")  # to its end
    check_conversation(script, ("EXPLAIN", [*EXPLAINED, "Line 2: FW"]), ("READ", ["Line 2: FW"]))

    script.type("CHANGE 2 FW 1")
    script.type("FIRST")
    check_conversation(script, ("EXPLAIN", [*EXPLAINED, "Line 2: FW"]), ("READ", ["Line 2: FW 1"]))


# --- searching and replacing


def test_a_word_is_searched_from_the_place_on_and_again_from_the_start(open_script: OpenScript) -> None:
    check_conversation(
        open_script("FW wall", "TR 90", "SPEAK wall", "FW 1"),
        ("SEARCH wall", ["Line 1: FW wall"]),
        ("SEARCH AGAIN", ["Line 3: SPEAK wall"]),
        ("SEARCH AGAIN", ["Line 1: FW wall"]),
        ("SEARCH nothing", ["nothing is not in the program."]),
    )


def test_a_word_is_replaced_everywhere_and_undo_takes_it_back(open_script: OpenScript) -> None:
    script = open_script("FW wall", "TR 90", "SPEAK wall", answers=["w2", "none"])

    check_conversation(
        script,
        ("REPLACE wall", ["Replaced 2 times."]),
        ("LIST", ["1: FW w2", "2: TR 90", "3: SPEAK w2"]),
        ("UNDO", ["Line 1: FW wall"]),
        ("REDO", ["Line 1: FW w2"]),
        ("LIST 3", ["3: SPEAK w2"]),
    )
    assert script.interaction.asked == ['Instead of wall, everywhere; Enter leaves it, "" deletes it:']
    check_conversation(script, ("SEARCH", ["none is not in the program."]))
    assert script.interaction.asked[1:] == ["Search for:"]


# --- the words of another language


def test_keywords_are_translated_where_the_language_is_named_or_chosen(open_script: OpenScript) -> None:
    script = open_script("REPEAT 2 TIMES", "FW 1", "END REPEAT", answers=["es", None])

    check_conversation(script, ("TRANSLATE pt", ["The program is tidy now."]))
    assert script.ctx.program.lines == ("REPITA 2 VEZES", "  PF 1", "FIM REPITA")
    check_conversation(
        script, ("TRANSLATE", ["1: English", "2: Portuguese", "3: Spanish", "The program is tidy now."])
    )
    assert script.ctx.program.lines == ("REPETIR 2 VECES", "  AV 1", "FIN REPETIR")
    check_conversation(
        script,
        ("TRANSLATE", ["1: English", "2: Portuguese", "3: Spanish"]),
        ("TRANSLATE xx", ["I did not understand. Type TRANSLATE pt."]),
    )
    assert script.interaction.asked.count("English") == 2


def test_a_program_with_a_mistake_is_not_tidied(open_script: OpenScript) -> None:
    script = open_script("FW 1", "FW")

    (answer,) = script.answers_to("FORMAT")

    assert "2" in answer
    assert script.ctx.program.lines == ("FW 1", "FW")


def test_a_change_that_makes_the_program_too_long_is_refused(
    open_script: OpenScript, monkeypatch: pytest.MonkeyPatch
) -> None:
    script = open_script("FW 1", "FW 2")
    monkeypatch.setattr(document, "LARGEST", 12)

    for typed in ("CHANGE 1 FW 1000", "INSERT 1 TR 90"):
        assert script.answers_to(typed) == ["The program would be too long. Nothing was changed."]
    assert script.ctx.program.lines == ("FW 1", "FW 2")


# --- the whole of a change: what is said, which lines there are, and where reading continues

LONG = tuple(f"FW {number}" for number in range(1, 22))
LINES: dict[str, tuple[tuple[str, ...], tuple[tuple[str, list[str], tuple[str, ...], int], ...]]] = {
    "an empty line": (
        ("FW 1", "", "FW 3"),
        (
            ("COMMENT 2", ["Nothing was changed."], ("FW 1", "", "FW 3"), 0),
            (
                *("COMMENT 1 3", ["Line 1: -- FW 1", "Line 2: empty.", "Line 3: -- FW 3"]),
                *(("-- FW 1", "", "-- FW 3"), 3),
            ),
            ("COMMENT 1 3", ["Line 1: FW 1", "Line 2: empty.", "Line 3: FW 3"], ("FW 1", "", "FW 3"), 3),
            ("COMMENT 2 3", ["Line 2: empty.", "Line 3: -- FW 3"], ("FW 1", "", "-- FW 3"), 3),
            ("DELETE 1", ["Line 1 is deleted.", "Line 1: empty."], ("", "-- FW 3"), 1),
        ),
    ),
    "the place": (
        ("FW 1", "FW 2", "--FW 3"),
        (
            ("COMMENT", ["Line 1: -- FW 1"], ("-- FW 1", "FW 2", "--FW 3"), 1),
            ("COMMENT 3", ["Line 3: FW 3"], ("-- FW 1", "FW 2", "FW 3"), 3),
            ("COMMENT", ["Line 3: -- FW 3"], ("-- FW 1", "FW 2", "-- FW 3"), 3),
            ("COMMENT 1 2", ["Line 1: -- -- FW 1", "Line 2: -- FW 2"],
             ("-- -- FW 1", "-- FW 2", "-- FW 3"), 2),
            ("COPY", ["Line 3: -- FW 2"], ("-- -- FW 1", "-- FW 2", "-- FW 2", "-- FW 3"), 3),
            ("DELETE 2 4", ["Lines 2 to 4 are deleted."], ("-- -- FW 1",), 3),
            ("CHANGE 1 FW 1", ["Line 1: FW 1"], ("FW 1",), 1),
            ("CHANGE 1 FW 1", ["Nothing was changed."], ("FW 1",), 1),
            ("INSERT 2 FW 2", ["Line 2: FW 2"], ("FW 1", "FW 2"), 2),
            ("DELETE", ["Lines 1 to 2 are deleted."], (), 2),
        ),
    ),
    "copies": (
        ("FW 1", "FW 2", "FW 3"),
        (
            ("COPY", ["Line 2: FW 1"], ("FW 1", "FW 1", "FW 2", "FW 3"), 2),
            ("COPY 1 5", ["Line 5: FW 1"], ("FW 1", "FW 1", "FW 2", "FW 3", "FW 1"), 5),
            ("COPY 1 0", ["There is no line 0. The last is 5."], ("FW 1", "FW 1", "FW 2", "FW 3", "FW 1"), 5),
            ("COPY 0 1", ["There is no line 0. The last is 5."], ("FW 1", "FW 1", "FW 2", "FW 3", "FW 1"), 5),
            (
                *("COPY 3 3 1", ["Line 1: FW 2"]),
                *(("FW 2", "FW 1", "FW 1", "FW 2", "FW 3", "FW 1"), 1),
            ),
            (
                *("COPY 4 5 1", ["Line 1: FW 2", "Line 2: FW 3"]),
                *(("FW 2", "FW 3", "FW 2", "FW 1", "FW 1", "FW 2", "FW 3", "FW 1"), 2),
            ),
        ),
    ),
    "moves": (
        ("FW 1", "FW 2", "FW 3"),
        (
            *((f"MOVE {each}", ["Nothing was changed."], ("FW 1", "FW 2", "FW 3"), 0) for each in (
                "1 1", "1 2", "1 2 1", "1 2 2", "1 2 3", "3 4", "2 3 4"
            )),
            *((f"MOVE {each}", [f"There is no line {number}. The last is 3."], ("FW 1", "FW 2", "FW 3"), 0)
              for each, number in (("0 1", 0), ("4 1", 4), ("1 4 1", 4), ("1 0", 0), ("1 5", 5))),
            ("MOVE 3 2 1", ["I did not understand. Type MOVE 5 2."], ("FW 1", "FW 2", "FW 3"), 0),
            ("MOVE 3 1", ["Line 1: FW 3"], ("FW 3", "FW 1", "FW 2"), 1),
            ("MOVE 1 4", ["Line 3: FW 3"], ("FW 1", "FW 2", "FW 3"), 3),
            ("MOVE 2 3 1", ["Line 1: FW 2", "Line 2: FW 3"], ("FW 2", "FW 3", "FW 1"), 2),
            ("MOVE 1 3", ["Line 2: FW 2"], ("FW 3", "FW 2", "FW 1"), 2),
        ),
    ),
    "lists": (
        ("FW 1", "FW 2"),
        (
            ("LIST 2 1", ["I did not understand. Type LIST 2 5."], ("FW 1", "FW 2"), 0),
            ("LIST 2 0", ["There is no line 0. The last is 2."], ("FW 1", "FW 2"), 0),
            ("LIST 3 1", ["There is no line 3. The last is 2."], ("FW 1", "FW 2"), 0),
            ("LIST 2 2", ["2: FW 2"], ("FW 1", "FW 2"), 0),
        ),
    ),
    "a long list": (LONG, (("LIST", ["21 lines.", *(f"{at}: FW {at}" for at in range(1, 22))], LONG, 0),)),
    "formatting": (
        ("FW 1", "REPEAT 2 TIMES FW 1 END REPEAT", "TR 90", "TL 90"),
        (
            ("READ 4", ["Line 4: TL 90"], ("FW 1", "REPEAT 2 TIMES FW 1 END REPEAT", "TR 90", "TL 90"), 4),
            *(
                (each, ["The program is tidy now."], (
                    "FW 1", "REPEAT 2 TIMES", "  FW 1", "END REPEAT", "TR 90", "TL 90"
                ), 4)
                for each in ("FORMAT", "FORMAT")
            ),
            ("UNDO", ["Line 2: REPEAT 2 TIMES FW 1 END REPEAT"], (
                "FW 1", "REPEAT 2 TIMES FW 1 END REPEAT", "TR 90", "TL 90"
            ), 2),
        ),
    ),
}  # fmt: skip


@pytest.mark.parametrize("subject", LINES)
def test_after_each_change_the_lines_and_the_place_are_known(open_script: OpenScript, subject: str) -> None:
    lines, conversation = LINES[subject]
    script = open_script(*lines)
    for typed, answers, after, place in conversation:
        answered = script.answers_to(typed)
        assert (typed, answered, script.ctx.program.lines, script.ctx.program.place) == (
            *(typed, answers, after, place),
        )


@pytest.mark.parametrize(
    ("typed", "said"),
    [
        ("CHANGE 1 FW 7", ["Line 1: FW 7", "RUN runs all 2 lines again."]),
        ("INSERT 2 FW 5", ["Line 2: FW 5", "RUN runs all 3 lines again."]),
        ("INSERT 3 FW 5", ["Line 3: FW 5"]),
        ("MOVE 1 3", ["Line 2: FW 1", "RUN runs all 2 lines again."]),
        ("COPY 2", ["Line 3: FW 2"]),
        ("COMMENT 1", ["Line 1: -- FW 1", "RUN runs all 2 lines again."]),
        ("DELETE 1", ["Line 1 is deleted.", "Line 1: FW 2"]),
        ("DELETE", ["There is nothing to delete."]),
    ],
)
def test_of_two_lines_that_have_run_it_is_said_if_both_wait_again(
    open_script: OpenScript, typed: str, said: list[str]
) -> None:
    script = open_script("FW 1", "FW 2")
    script.ctx.program.batch_ran()

    assert script.answers_to(typed) == said


@pytest.mark.parametrize(
    ("added", "said"),
    [(("FW 2",), "Line 2 is deleted."), (("FW 2", "FW 3"), "Lines 2 to 3 are deleted.")],
)
def test_without_a_number_the_lines_that_have_not_run_are_deleted(
    open_script: OpenScript, added: tuple[str, ...], said: str
) -> None:
    script = open_script("FW 1")
    script.ctx.program.batch_ran()
    for line in added:
        script.ctx.program.add(line)

    assert script.answers_to("DELETE") == [said]
    assert script.ctx.program.lines == ("FW 1",)


@pytest.mark.parametrize(
    ("lines", "place", "fixed"),
    [
        (("FWD 1", "FWD 2", "FWD 3"), 0, ["Line 1: FW 1", "Line 2: FW 2", "Line 3: FW 3"]),
        (("FWD 1", "FWD 2", "FWD 3"), 2, ["Line 2: FW 2", "Line 3: FW 3", "Line 1: FW 1"]),
        (("FWD 1", "FWD 2", "FWD 3"), 3, ["Line 3: FW 3", "Line 1: FW 1", "Line 2: FW 2"]),
        (("FWD 1", "FW 1", "FWD 3"), 2, ["Line 3: FW 3", "Line 1: FW 1", "No mistakes were found."]),
    ],
)
def test_the_mistake_at_the_place_is_fixed_first_then_the_next_below(
    open_script: OpenScript, lines: tuple[str, ...], place: int, fixed: list[str]
) -> None:
    script = open_script(*lines)
    script.ctx.program.place = place

    assert script.answers_to("FIX", "FIX", "FIX") == fixed


def test_the_mistake_that_error_said_is_fixed_before_those_below_the_place(open_script: OpenScript) -> None:
    script = open_script("FW 1", "FWD 2", "TR 90", "FWD 4", "FWD 5")
    script.answers_to("AGAIN", "ERROR NEXT", "READ 3")

    assert script.answers_to("FIX", "FIX") == ["Line 4: FW 4", "Line 5: FW 5"]
    script = open_script("FW 1", "FWD 2", "TR 90", "FWD 4", "FWD 5")
    script.answers_to("AGAIN", "ERROR NEXT", "ERROR NEXT", "READ 3")
    assert script.answers_to("FIX", "FIX") == ["Line 5: FW 5", "Line 2: FW 2"]


def test_the_word_that_was_searched_is_offered_again_and_an_empty_one_searches_nothing(
    open_script: OpenScript,
) -> None:
    script = open_script("FW 1", "REPEAT 2 TIMES", "FW 2", "END REPEAT", answers=["FW", "", '""', None])

    check_conversation(
        script,
        ("SEARCH", ["Line 1: FW 1"]),
        ("SEARCH AGAIN", ["Line 3, level 1: FW 2"]),
        ("SEARCH", ["Nothing was changed."]),
        ("REPLACE 1", ["Replaced 1 time."]),
        ("REPLACE FW", ["Nothing was changed."]),
        ("REPLACE fw", ["Line 1 has FW. REPLACE takes a word as it is written there."]),
    )
    assert script.interaction.asked[:2] == ["Search for:", "Search for: FW"]
    assert script.ctx.program.lines[0] == "FW "


def test_a_text_that_changed_while_it_was_formatted_stays(
    open_script: OpenScript, monkeypatch: pytest.MonkeyPatch
) -> None:
    script = open_script("REPEAT 2 TIMES FW 1 END REPEAT")

    async def meanwhile(task: Callable[[], object], slow: str, **_: bool) -> object:
        script.ctx.program.add("FW 9")
        return task()

    monkeypatch.setattr(script.interaction, "background", meanwhile)
    assert script.answers_to("FORMAT") == ["The program was changed meanwhile, so I left it as it is."]
    assert script.ctx.program.lines == ("REPEAT 2 TIMES FW 1 END REPEAT", "FW 9")


def test_the_level_is_said_where_it_is_another_one_also_after_the_last_line(
    open_script: OpenScript,
) -> None:
    check_conversation(
        open_script("REPEAT 2 TIMES", "FW 1", "FW 2"),
        ("READ 3", ["Line 3, level 1: FW 2"]),
        ("READ 2", ["Line 2: FW 1"]),
        ("READ 3", ["Line 3: FW 2"]),
        ("READ 1", ["Line 1, level 0: REPEAT 2 TIMES"]),
    )
