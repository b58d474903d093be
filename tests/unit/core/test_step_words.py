"""Stepping in words: the statement with its level, the round of how many, what a condition found."""

from donnie_tui.core.events import Read
from donnie_tui.core.step_words import StepWords, changes
from donnie_tui.i18n.words import Words
from language.compiler import compile_program
from language.control import ControlState, ExecutionControl
from language.parser import parse
from language.runtime import Memory
from tests.unit.language_back.recorder import Recorder


class Sensing(Recorder):
    """Tells what it is asked, as the session does."""

    def __init__(self, words: StepWords, values: list[int]) -> None:
        super().__init__()
        self._words, self._values = words, values

    def distance(self, bearing: object) -> int:
        value = self._values.pop(0)
        self._words.heard(Read("distance", "F", value))
        return value


def told(source: str, *, detail: str = "brief", values: tuple[int, ...] = ()) -> list[str]:
    """What is told at each step of a program."""
    program = parse(source).program
    assert program is not None
    words = StepWords(program, source.split("\n"), Words("en", detail))
    control, runnable, lines = ExecutionControl(), compile_program(program, hooked=True), list[str]()

    def note(state: ControlState) -> None:
        if state is ControlState.PAUSED:
            lines.extend(words.held(*control.held_at, runnable.frames()))
            control.step()

    control.observe(note)
    control.step()
    runnable.run(Sensing(words, list(values)), control, Memory())
    return [*lines, *words.ended()]


def told_from(source: str, line: int, *, is_first: bool) -> list[str]:
    """What is told at each step from a hold at a line on, at its second time unless ``is_first``."""
    program = parse(source).program
    assert program is not None
    words = StepWords(program, source.split("\n"), Words("en", "brief"), is_first=is_first)
    control, runnable, lines = ExecutionControl(), compile_program(program, hooked=True), list[str]()
    holds = [0]

    def note(state: ControlState) -> None:
        if state is ControlState.PAUSED:
            holds[0] += 1
            if is_first or holds[0] > 1:
                lines.extend(words.held(*control.held_at, runnable.frames()))
                control.step()
            else:
                control.run_to(line)

    control.observe(note)
    control.run_to(line)
    runnable.run(Sensing(words, []), control, Memory())
    return lines


def test_a_loop_that_is_held_in_its_midst_tells_no_number() -> None:
    """L40: nobody counted the rounds before."""
    source = "REPEAT 4 TIMES\nFW 1\nTR 90\nEND REPEAT"

    assert told_from(source, 2, is_first=False)[:5] == [
        "Line 2: FW 1",
        "Line 3: TR 90",
        "Line 1: REPEAT 4 TIMES",
        "Line 2: FW 1",
        "Line 3: TR 90",
    ]
    assert [line for line in told_from(source, 2, is_first=False) if "ound" in line] == ["Next round."]


def test_a_loop_that_a_breakpoint_holds_at_its_head_begins_there() -> None:
    source = "VAR k = 0\nREPEAT 2 TIMES\nFW 1\nEND REPEAT"
    rounds = [line for line in told_from(source, 2, is_first=True) if line.startswith("Round")]

    assert rounds == ["Round 1 of 2.", "Round 2 of 2."]


def test_a_loop_around_the_one_that_was_held_is_not_counted_either() -> None:
    source = "REPEAT 3 TIMES\nREPEAT 2 TIMES\nFW 1\nEND REPEAT\nEND REPEAT"
    rounds = [line for line in told_from(source, 3, is_first=False) if "ound" in line]

    assert rounds == ["Round 1 of 2.", "Round 2 of 2.", "Round 1 of 2.", "Round 2 of 2."]


def test_a_repeat_tells_which_round_of_how_many() -> None:
    assert told("VAR n = 2\nREPEAT n + 0 TIMES\nFW 1\nTR 90\nEND REPEAT") == [
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
        for line in told("REPEAT 2 TIMES\nREPEAT 3 TIMES\nFW 1\nEND REPEAT\nEND REPEAT")
        if line.startswith("Round")
    ]

    assert rounds == [*(f"Round {n} of 3." for n in (1, 2, 3, 1, 2, 3))]


def test_a_condition_is_told_with_what_was_compared() -> None:
    assert told("VAR x = 3\nIF x > 2 THEN\nFW 1\nEND IF\nIF x == 2 THEN\nFW 2\nEND IF\nFW 3")[2:] == [
        "Condition true: 3 greater than 2.",
        "Line 3: FW 1",
        "Line 5: IF x == 2 THEN",
        "Condition false: 3 greater than 2.",
        "Line 8: FW 3",
    ]


def test_what_a_sensor_said_is_told_with_the_condition() -> None:
    lines = told("WHILE DISTANCE F > 3 DO\nFW 1\nEND WHILE\nFW 9", values=(5, 4, 2))

    assert [line for line in lines if line.startswith(("Cond", "Round"))] == [
        "Condition true: 5 greater than 3.",
        "Round 1.",
        "Condition true: 4 greater than 3.",
        "Round 2.",
        "Condition false: 2 less than 3.",
    ]


def test_of_several_commands_on_a_line_each_is_told_alone() -> None:
    assert told("FW 1 TR 90\nREPEAT 1 TIMES FW 2 END REPEAT") == [
        "Line 1: FW 1",
        "Line 1: TR 90",
        "Line 2: REPEAT 1 TIMES",
        "Round 1 of 1.",
        "Line 2: FW 2",
        "Line 2: REPEAT 1 TIMES",
    ]


def test_the_level_is_told_when_it_changes() -> None:
    lines = told("FW 1\nREPEAT 1 TIMES\nFW 2\nFW 3\nEND REPEAT", detail="normal")

    assert [line for line in lines if line.startswith("Line")] == [
        "Line 1: FW 1",
        "Line 2: REPEAT 1 TIMES",
        "Line 3, level 1: FW 2",
        "Line 4: FW 3",
        "Line 2, level 0: REPEAT 1 TIMES",
    ]


def test_a_recursion_counts_each_call_s_rounds_for_itself() -> None:
    body = "REPEAT 2 TIMES\nIF n > 0 THEN\nP [n - 1]\nEND IF\nEND REPEAT"
    source = f"PROCEDURE P: n DO\n{body}\nEND PROCEDURE\nP [1]"

    assert [line for line in told(source) if line.startswith("Round")] == [
        *(f"Round {n} of 2." for n in (1, 1, 2, 2, 1, 2))
    ]


def test_only_a_watched_variable_that_changed_is_told() -> None:
    assert list(changes(["x", "y", "z"], {"x": 1, "y": 2}, {"x": 5, "y": 2}, Words())) == ["x is 5."]


def test_a_condition_in_a_procedure_is_told_with_the_values_of_there() -> None:
    """What comes next may be behind the call, where a name means another variable."""
    procedure = "PROCEDURE P: n DO\nIF n > 3 THEN\nFW 1\nEND IF\nEND PROCEDURE"

    assert "Condition false: 1 less than 3." in told(f"{procedure}\nVAR n = 9\nP [1]\nFW 2")


def test_a_for_that_is_over_tells_what_ended_it() -> None:
    """Its variable is gone then."""
    lines = told("FOR VAR i = 1; i <= 2; i = i + 1 DO\nFW i\nEND FOR\nTR 90")

    assert [line for line in lines if line.startswith("Cond")] == [
        "Condition true: 1 at most 2.",
        "Condition true: 2 at most 2.",
        "Condition false: 3 greater than 2.",
    ]


def test_a_for_that_never_begins_tells_why() -> None:
    lines = told("FOR VAR i = 5; i <= 2; i = i + 1 DO\nFW i\nEND FOR\nTR 90")

    assert "Condition false: 5 greater than 2." in lines


def test_what_a_sensor_said_for_a_for_is_not_taken_for_its_condition() -> None:
    lines = told(
        "FOR VAR i = DISTANCE F; i < DISTANCE B; i = i + 2 DO\nFW i\nEND FOR\nTR 90", values=(1, 2, 2)
    )

    assert [line for line in lines if line.startswith("Cond")] == [
        "Condition true: 1 less than 2.",
        "Condition false: 3 greater than 2.",
    ]


def test_the_condition_that_ended_a_program_is_told_at_its_end() -> None:
    assert told("VAR x = 1\nWHILE x < 2 DO\nx = x + 1\nEND WHILE")[-1] == "Condition false: 2 equal to 2."
