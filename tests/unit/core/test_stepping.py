"""Stepping in words: the statement with its level, the round of how many, what a condition found."""

import pytest

from donnie_tui.core.events import Read
from donnie_tui.core.stepping import StepNarrator, changes, worked_out
from donnie_tui.i18n.words import Words
from language.compiler import compile_program
from language.control import ControlState, ExecutionControl
from language.parser import parse
from language.runtime import Frame, Memory
from tests.unit.language_back.recorder import Recorder

CALLS = (Frame("", 1, ()),)


class Sensing(Recorder):
    """Reports each reading to the words, as the session does."""

    def __init__(self, words: StepNarrator, values: list[int]) -> None:
        super().__init__()
        self._words, self._values = words, values

    def distance(self, bearing: object) -> int:
        value = self._values.pop(0)
        self._words.on_read(Read("distance", "F", value))
        return value


def step_lines(
    source: str, *, detail: str = "brief", values: tuple[int, ...] = (), language: str = "en"
) -> list[str]:
    """The lines of each step of a program."""
    program = parse(source).program
    assert program is not None
    words = StepNarrator(program, source.split("\n"), Words(language, detail))
    control, runnable, lines = ExecutionControl(), compile_program(program, hooked=True), list[str]()

    def note(state: ControlState) -> None:
        if state is ControlState.PAUSED:
            lines.extend(words.on_hold(*control.held_at, runnable.frames()))
            control.step()

    control.observe(note)
    control.step()
    runnable.run(Sensing(words, list(values)), control, Memory())
    return [*lines, *words.on_end()]


def step_lines_from(source: str, line: int, *, is_first: bool) -> list[str]:
    """The lines of each step after a hold at a line, at its second time unless ``is_first``."""
    program = parse(source).program
    assert program is not None
    words = StepNarrator(program, source.split("\n"), Words("en", "brief"), is_first=is_first)
    control, runnable, lines = ExecutionControl(), compile_program(program, hooked=True), list[str]()
    holds = [0]

    def note(state: ControlState) -> None:
        if state is ControlState.PAUSED:
            holds[0] += 1
            if is_first or holds[0] > 1:
                lines.extend(words.on_hold(*control.held_at, runnable.frames()))
                control.step()
            else:
                control.run_to(line)

    control.observe(note)
    control.run_to(line)
    runnable.run(Sensing(words, []), control, Memory())
    return lines


def test_a_loop_that_is_held_in_the_middle_has_no_number_of_rounds() -> None:
    """The rounds before were not counted."""
    source = "REPEAT 4 TIMES\nFW 1\nTR 90\nEND REPEAT"

    assert step_lines_from(source, 2, is_first=False)[:5] == [
        "Line 2: FW 1",
        "Line 3: TR 90",
        "Line 1: REPEAT 4 TIMES",
        "Line 2: FW 1",
        "Line 3: TR 90",
    ]
    assert [line for line in step_lines_from(source, 2, is_first=False) if "ound" in line] == ["Next round."]


def test_a_loop_that_a_breakpoint_holds_at_its_head_begins_there() -> None:
    source = "VAR k = 0\nREPEAT 2 TIMES\nFW 1\nEND REPEAT"
    rounds = [line for line in step_lines_from(source, 2, is_first=True) if line.startswith("Round")]

    assert rounds == ["Round 1 of 2.", "Round 2 of 2."]


def test_a_loop_around_the_one_that_was_held_is_not_counted_either() -> None:
    source = "REPEAT 3 TIMES\nREPEAT 2 TIMES\nFW 1\nEND REPEAT\nEND REPEAT"
    rounds = [line for line in step_lines_from(source, 3, is_first=False) if "ound" in line]

    assert rounds == ["Round 1 of 2.", "Round 2 of 2.", "Round 1 of 2.", "Round 2 of 2."]


def test_a_repeat_has_its_round_and_their_number() -> None:
    assert step_lines("VAR n = 2\nREPEAT n + 0 TIMES\nFW 1\nTR 90\nEND REPEAT") == [
        "Line 1: VAR n = 2",
        "Line 2: REPEAT n + 0 TIMES",
        "Round 1 of 2.",
        "Line 3: FW 1",
        "Line 4: TR 90",
        "Line 2: REPEAT n + 0 TIMES",
        "Round 2 of 2.",
        "Line 3: FW 1",
        "Line 4: TR 90",
        "Line 2: REPEAT n + 0 TIMES",
    ]


def test_loops_in_each_other_count_for_themselves() -> None:
    rounds = [
        line
        for line in step_lines("REPEAT 2 TIMES\nREPEAT 3 TIMES\nFW 1\nEND REPEAT\nEND REPEAT")
        if line.startswith("Round")
    ]

    assert rounds == [*(f"Round {n} of 3." for n in (1, 2, 3, 1, 2, 3))]


def test_a_condition_is_printed_with_the_compared_values() -> None:
    assert step_lines("VAR x = 3\nIF x > 2 THEN\nFW 1\nEND IF\nIF x == 2 THEN\nFW 2\nEND IF\nFW 3")[2:] == [
        "3 is greater than 2: true.",
        "Line 3: FW 1",
        "Line 5: IF x == 2 THEN",
        "3 is equal to 2: false.",
        "Line 8: FW 3",
    ]


@pytest.mark.parametrize(
    ("comparison", "en", "pt", "es"),
    [
        ("1 == 1", "1 is equal to 1: true.", "1 é igual a 1: verdadeiro.", "1 es igual a 1: verdadero."),
        ("1 == 2", "1 is equal to 2: false.", "1 é igual a 2: falso.", "1 es igual a 2: falso."),
        ("1 <> 1", "1 is not equal to 1: false.", "1 é diferente de 1: falso.", "1 es distinto de 1: falso."),
        ("1 < 1", "1 is less than 1: false.", "1 é menor que 1: falso.", "1 es menor que 1: falso."),
        ("1 > 1", "1 is greater than 1: false.", "1 é maior que 1: falso.", "1 es mayor que 1: falso."),
        (
            "2 <= 1",
            "2 is at most 1: false.",
            "2 é menor ou igual a 1: falso.",
            "2 es menor o igual que 1: falso.",
        ),
        (
            "1 >= 2",
            "1 is at least 2: false.",
            "1 é maior ou igual a 2: falso.",
            "1 es mayor o igual que 2: falso.",
        ),
        (
            "1 <= 1",
            "1 is at most 1: true.",
            "1 é menor ou igual a 1: verdadeiro.",
            "1 es menor o igual que 1: verdadero.",
        ),
        (
            "1 >= 1",
            "1 is at least 1: true.",
            "1 é maior ou igual a 1: verdadeiro.",
            "1 es mayor o igual que 1: verdadero.",
        ),
    ],
)
def test_a_condition_is_printed_as_the_program_has_it(comparison: str, en: str, pt: str, es: str) -> None:
    for language, said in (("en", en), ("pt", pt), ("es", es)):
        assert step_lines(f"IF {comparison} THEN\nEND IF", language=language)[-1] == said


def test_computed_values_are_printed_as_numbers_in_a_condition() -> None:
    source = "VAR x = 3\nIF x * 2 - 1 <= DISTANCE F + 4 THEN\nEND IF"

    assert step_lines(source, values=(0,))[-1] == "5 is at most 4: false."


def test_the_reading_of_a_sensor_is_printed_with_the_condition() -> None:
    lines = step_lines("WHILE DISTANCE F > 3 DO\nFW 1\nEND WHILE\nFW 9", values=(5, 4, 2))

    assert [line for line in lines if line.startswith("Round") or line[0].isdigit()] == [
        "5 is greater than 3: true.",
        "Round 1.",
        "4 is greater than 3: true.",
        "Round 2.",
        "2 is greater than 3: false.",
    ]


def test_each_of_several_commands_on_a_line_is_printed_alone() -> None:
    assert step_lines("FW 1 TR 90\nREPEAT 1 TIMES FW 2 END REPEAT") == [
        "Line 1: FW 1",
        "Line 1: TR 90",
        "Line 2: REPEAT 1 TIMES",
        "Round 1 of 1.",
        "Line 2: FW 2",
        "Line 2: REPEAT 1 TIMES",
    ]


def test_the_level_is_printed_when_it_changes() -> None:
    lines = step_lines("FW 1\nREPEAT 1 TIMES\nFW 2\nFW 3\nEND REPEAT", detail="normal")

    assert [line for line in lines if line.startswith("Line")] == [
        "Line 1: FW 1",
        "Line 2: REPEAT 1 TIMES",
        "Line 3, level 1: FW 2",
        "Line 4: FW 3",
        "Line 2, level 0: REPEAT 1 TIMES",
    ]


def test_the_number_of_rounds_is_that_of_the_beginning() -> None:
    source = "VAR n = 2\nREPEAT n TIMES\nn = n + 5\nEND REPEAT"

    assert [line for line in step_lines(source) if "ound" in line] == ["Round 1 of 2.", "Round 2 of 2."]


@pytest.mark.parametrize(
    "condition",
    ["DISTANCE F > 1", "1 < DISTANCE F", "-DISTANCE F < 1", "DISTANCE F + 1 > 1", "1 < 1 + DISTANCE F"],
)
def test_a_condition_whose_reading_is_not_known_is_not_printed(condition: str) -> None:
    program = parse(f"IF {condition} THEN\nFW 1\nEND IF").program
    words = StepNarrator(program, (), Words("en", "brief"))

    assert words.on_hold(1, 1, CALLS) == (f"Line 1: IF {condition} THEN",)
    assert words.on_hold(2, 1, CALLS) == ("Line 2: FW 1",)


@pytest.mark.parametrize(("is_read", "said"), [(True, ("9 is less than 5: false.",)), (False, ())])
def test_the_condition_of_a_for_has_no_old_value_where_the_new_one_is_not_known(
    is_read: bool, said: tuple[str, ...]
) -> None:
    """Its variable is 2 in the first round, and 7 more after it."""
    program = parse("FOR VAR i = 2; i < 5; i = i + DISTANCE F DO\nFW 1\nEND FOR").program
    words = StepNarrator(program, (), Words("en", "brief"))
    first_round = (Frame("", 1, (("i", 2),)),)
    words.on_hold(1, 1, CALLS)
    words.on_hold(2, 1, first_round)
    words.on_hold(1, 1, first_round)
    if is_read:
        words.on_read(Read("distance", "F", 7))

    assert words.on_end() == said


def test_a_for_without_a_start_value_begins_at_0() -> None:
    assert "0 is less than 1: true." in step_lines("FOR VAR i; i < 1; i = i + 1 DO\nEND FOR")


def test_a_for_that_is_held_at_its_head_in_the_middle_names_no_condition_there() -> None:
    """Whether it starts there or does its step was not seen; its next round is known again."""
    source = "FOR VAR i = 1; i <= 3; i = i + 1 DO\nFW i\nEND FOR"
    lines = step_lines_from(source, 1, is_first=False)

    assert [line for line in lines if not line.startswith("Line")] == ["3 is at most 3: true.", "Next round."]


def test_a_recursion_counts_each_call_s_rounds_for_itself() -> None:
    body = "REPEAT 2 TIMES\nIF n > 0 THEN\nP [n - 1]\nEND IF\nEND REPEAT"
    source = f"PROCEDURE P: n DO\n{body}\nEND PROCEDURE\nP [1]"

    assert [line for line in step_lines(source) if line.startswith("Round")] == [
        *(f"Round {n} of 2." for n in (1, 1, 2, 2, 1, 2))
    ]


def test_only_a_watched_variable_that_changed_is_printed() -> None:
    before, now = {"x": 1, "y": 2, "gone": 3}, {"x": 5, "y": 2}

    assert list(changes(["x", "y", "z", "gone"], before, now, Words())) == ["x is 5."]


def test_a_condition_in_a_procedure_is_printed_with_the_values_of_the_procedure() -> None:
    """The next statement may be after the call, where the name means another variable."""
    procedure = "PROCEDURE P: n DO\nIF n > 3 THEN\nFW 1\nEND IF\nEND PROCEDURE"

    assert "1 is greater than 3: false." in step_lines(f"{procedure}\nVAR n = 9\nP [1]\nFW 2")


def test_the_end_of_a_for_names_the_condition_that_ended_it() -> None:
    """Its variable no longer exists then."""
    lines = step_lines("FOR VAR i = 1; i <= 2; i = i + 1 DO\nFW i\nEND FOR\nTR 90")

    assert [line for line in lines if line[0].isdigit()] == [
        "1 is at most 2: true.",
        "2 is at most 2: true.",
        "3 is at most 2: false.",
    ]


def test_a_for_without_a_round_names_the_reason() -> None:
    lines = step_lines("FOR VAR i = 5; i <= 2; i = i + 1 DO\nFW i\nEND FOR\nTR 90")

    assert "5 is at most 2: false." in lines


def test_a_reading_in_the_head_of_a_for_is_not_part_of_its_condition() -> None:
    lines = step_lines(
        "FOR VAR i = DISTANCE F; i < DISTANCE B; i = i + 2 DO\nFW i\nEND FOR\nTR 90", values=(1, 2, 2)
    )

    assert [line for line in lines if line[0].isdigit()] == [
        "1 is less than 2: true.",
        "3 is less than 2: false.",
    ]


def test_the_end_of_a_program_names_the_condition_that_ended_it() -> None:
    assert step_lines("VAR x = 1\nWHILE x < 2 DO\nx = x + 1\nEND WHILE")[-1] == "2 is less than 2: false."


@pytest.mark.parametrize(
    "expression, steps",
    [
        ("a * b + 1", ["5 * 3 + 1", "15 + 1", "16"]),
        ("1 + a * b", ["1 + 5 * 3", "1 + 15", "16"]),
        ("10 - (b - a)", ["10 - (3 - 5)", "10 - (-2)", "12"]),
        ("-a", ["-5"]),
        ("a", ["5"]),
        ("7 / -2", ["-3"]),
        ("2 * (DISTANCE F + a * 2)", ["2 * (DISTANCE F + 5 * 2)", "2 * (DISTANCE F + 10)"]),
        ("1 / (a - 5)", ["1 / (5 - 5)", "1 / 0"]),
        ("10 - b - a", ["10 - 3 - 5", "7 - 5", "2"]),
        ("10 - (b + a)", ["10 - (3 + 5)", "10 - 8", "2"]),
        ("(b - a) * 2", ["(3 - 5) * 2", "-2 * 2", "-4"]),
        ("2 * (b * a)", ["2 * (3 * 5)", "2 * 15", "30"]),
        ("-(a + b)", ["-(5 + 3)", "-8"]),
        ("-(a + b) * 2", ["-(5 + 3) * 2", "-8 * 2", "-16"]),
        ("7 / (a * b)", ["7 / (5 * 3)", "7 / 15", "0"]),
        ("2 * (7 / b)", ["2 * (7 / 3)", "2 * 2", "4"]),
        ("-(-a)", ["5"]),
        ("-DISTANCE F + b", ["-DISTANCE F + 3"]),
        ("-(DISTANCE F + a * b)", ["-(DISTANCE F + 5 * 3)", "-(DISTANCE F + 15)"]),
        ("1000000000000000 + 0", ["1000000000000000"]),
        ("1000000000000000 + 1", []),
        ("-1000000000000000 - 1", []),
        (
            "1+1+1+1+1+1+1+1",
            [
                "2 + 1 + 1 + 1 + 1 + 1 + 1",
                "3 + 1 + 1 + 1 + 1 + 1",
                "4 + 1 + 1 + 1 + 1",
                "5 + 1 + 1 + 1",
                "6 + 1 + 1",
                "8",
            ],
        ),
        (
            "1+1+1+1+1+1+1+DISTANCE F",
            [
                "2 + 1 + 1 + 1 + 1 + 1 + DISTANCE F",
                "3 + 1 + 1 + 1 + 1 + DISTANCE F",
                "4 + 1 + 1 + 1 + DISTANCE F",
                "5 + 1 + 1 + DISTANCE F",
                "6 + 1 + DISTANCE F",
            ],
        ),
        ("7", []),
        ("DISTANCE F", []),
    ],
)
def test_an_expression_is_worked_out_operation_by_operation(expression: str, steps: list[str]) -> None:
    program = parse(f"SPEAK {expression}").program
    assert program is not None
    [speak] = program.body

    assert list(worked_out(speak.what, program, {"a": 5, "b": 3})) == [expression, *steps]  # type: ignore[union-attr]


def test_in_full_detail_a_step_says_what_it_computes() -> None:
    source = "VAR n = 3\nREPEAT n - 1 TIMES\nFW n * 2 + 1\nEND REPEAT\nIF n > 4 THEN\nFW 1\nEND IF"

    assert [line for line in step_lines(source, detail="full") if ": " in line and "Line" not in line] == [
        "n - 1: 3 - 1, 2.",
        "n * 2 + 1: 3 * 2 + 1, 6 + 1, 7.",
        "n * 2 + 1: 3 * 2 + 1, 6 + 1, 7.",
        "n: 3.",
        "3 is greater than 4: false.",
    ]


@pytest.mark.parametrize(
    ("source", "said"),
    [
        ("SPEAK -2 * 3", ["-2 * 3: -6."]),
        ("VAR \u00c1 = 4\na = \u00e1 * A\nSPEAK A + 1", ["\u00e1 * A: 4 * 4, 16.", "A + 1: 16 + 1, 17."]),
        (
            "TR 45 + 45\nTL 9 - 8\nBW 2 / 2\nWAIT 1 + 1",
            ["45 + 45: 90.", "9 - 8: 1.", "2 / 2: 1.", "1 + 1: 2."],
        ),
        (
            "PROCEDURE P: n, m DO\nFW n - m\nEND PROCEDURE\nP [1 + 1, 3 - 2]",
            ["1 + 1: 2.", "3 - 2: 1.", "n - m: 2 - 1, 1."],
        ),
        (
            "VAR n = 1\nWHILE n * 2 < 3 + 0 DO\nn = n + 1\nEND WHILE",
            ["n * 2: 1 * 2, 2.", "3 + 0: 3.", "n + 1: 1 + 1, 2.", "n * 2: 2 * 2, 4.", "3 + 0: 3."],
        ),
        ("REPEAT 1 + 1 TIMES\nREPEAT 3 - 2 TIMES\nEND REPEAT\nEND REPEAT", ["1 + 1: 2.", *["3 - 2: 1."] * 2]),
        ('SPEAK "a: b"\nVAR x\nSPEAK 7\nSPEAK DISTANCE F', []),
    ],
)
def test_each_expression_of_a_statement_is_worked_out(source: str, said: list[str]) -> None:
    lines = step_lines(source, detail="full", values=(5,))

    assert [
        line for line in lines if ": " in line and not line.startswith("Line") and "than" not in line
    ] == said


def test_the_values_of_a_negative_and_of_a_quotient_are_compared() -> None:
    source = "VAR x = 7\nIF -x / 2 == -3 THEN\nEND IF\nIF -(x - 1) < x / (0 - 2) THEN\nEND IF"

    assert [line for line in step_lines(source) if line[0] in "-0123456789"] == [
        "-3 is equal to -3: true.",
        "-6 is less than -3: true.",
    ]


def test_a_statement_of_an_else_has_the_level_of_its_block() -> None:
    source = "IF 1 > 2 THEN\nFW 1\nELSE\nREPEAT 1 TIMES\nFW 2\nEND REPEAT\nEND IF"

    assert [line for line in step_lines(source, detail="full") if line.startswith("Line")] == [
        "Line 1, level 0: IF 1 > 2 THEN",
        "Line 4, level 1: REPEAT 1 TIMES",
        "Line 5, level 2: FW 2",
        "Line 4, level 1: REPEAT 1 TIMES",
    ]


def test_a_line_of_no_known_program_is_said_as_it_is_written() -> None:
    words = StepNarrator(None, ["  FW 1 ", "TR 90"], Words("en", "full"))

    assert [words.on_hold(line, 1, CALLS) for line in (1, 2, 3, 0)] == [
        *(("Line 1: FW 1",), ("Line 2: TR 90",), ("Line 3: ",), ("Line 0: ",))
    ]
    assert words.on_end() == ()


def test_a_procedure_of_another_program_changes_no_level() -> None:
    """Its lines are not those of this program."""
    program = parse("FW 1\nFW 2").program
    words = StepNarrator(program, (), Words("en", "normal"))

    assert words.on_hold(1, 1, CALLS) == ("Line 1: FW 1",)
    assert words.on_hold(9, 1, CALLS * 2) == ("Line 9: ",)
    assert words.on_hold(2, 1, CALLS) == ("Line 2: FW 2",)


def test_a_for_loop_computes_the_start_once_and_then_its_step() -> None:
    source = "FOR VAR i = 1 + 1; i <= 3; i = i + 1 DO\nEND FOR"

    assert [line for line in step_lines(source, detail="full") if "+" in line and "Line" not in line] == [
        "1 + 1: 2.",
        "i + 1: 2 + 1, 3.",
        "i + 1: 3 + 1, 4.",
    ]
