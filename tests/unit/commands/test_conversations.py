"""What is answered to commands typed one after the other: limits, arguments that are missing or wrong."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from donnie_tui.commands.interaction import EnterWorld, drive
from tests.unit.commands.scripted import Script

OpenScript = Callable[..., Script]

PROGRAM = ("FW 1", "REPEAT 2 TIMES", "FW 2", "END REPEAT")
LISTED = ["1: FW 1", "2: REPEAT 2 TIMES", "3: FW 2", "4: END REPEAT"]
NOTHING_SAID = "Nothing has been said yet."
CLOSER = "Line 4: END REPEAT, closes line 2."


def no_line(number: int) -> list[str]:
    return [f"There is no line {number}. The last is 4."]


def wrong(example: str) -> list[str]:
    return [f"I did not understand. Type {example}."]


CONVERSATIONS: dict[str, tuple[tuple[str, list[str]], ...]] = {
    "until": (
        *((each, wrong("UNTIL 3")) for each in ("UNTIL", "UNTIL 1 2", "UNTIL x")),
        ("UNTIL 0", no_line(0)),
        ("UNTIL 4", ["No command begins on line 4, so I can't stop there."]),
        ("UNTIL 5", no_line(5)),
    ),
    "breakpoints": (
        ("BREAK", ["There are no breakpoints."]),
        ("BREAK 0", no_line(0)),
        ("BREAK 5", no_line(5)),
        ("BREAK 1 2", wrong("BREAK 3")),
        ("BREAK 4", ["No command begins on line 4, so I can't stop there."]),
        ("BREAK 3", ["Breakpoint at line 3."]),
        ("BREAK 1", ["Breakpoint at line 1."]),
        ("BREAK", ["Breakpoints: 1, 3."]),
        ("BREAK 3", ["Line 3 has no breakpoint now."]),
        ("BREAK", ["Breakpoints: 1."]),
    ),
    "reading": (
        ("READ", ["Line 1: FW 1"]),
        ("READ 0", no_line(0)),
        ("READ 4", [CLOSER]),
        ("READ", [CLOSER]),
        ("READ 5", no_line(5)),
        ("READ 1 2", wrong("READ 3")),
        ("FIRST", ["Line 1: FW 1"]),
        ("BACK", ["That is the first line."]),
        ("LAST LINE", [CLOSER]),
        ("NEXT", ["That is the last line."]),
        ("UP", ["Line 2: REPEAT 2 TIMES"]),
        ("UP", ["This line is in no block."]),
        ("DOWN", ["Line 3, level 1: FW 2"]),
        ("DOWN", ["No block opens here."]),
        ("PLACE", ["Line 3 of 4, level 1.", "In REPEAT from line 2."]),
        ("NEXT", ["Line 4, level 0: END REPEAT, closes line 2."]),
        ("BACK", ["Line 3, level 1: FW 2"]),
    ),
    "listing": (
        ("LIST", LISTED),
        ("SHOW PROGRAM", LISTED),
        ("LIST 2", LISTED[1:2]),
        ("LIST 3 4", LISTED[2:]),
        ("LIST 3, 9", LISTED[2:]),
        ("LIST 4 3", wrong("LIST 2 5")),
        ("LIST 1 2 3", wrong("LIST 2 5")),
        ("LIST 0", no_line(0)),
        ("LIST 5", no_line(5)),
        ("LIST 5 9", no_line(5)),
    ),
    "changing": (
        ("INSERT 0 FW 1", no_line(0)),
        ("INSERT 6 FW 1", no_line(6)),
        ("INSERT", wrong("INSERT 3")),
        ("INSERT 1", ["Nothing was changed."]),
        ("CHANGE", wrong("CHANGE 3")),
        ("CHANGE 5 FW 1", no_line(5)),
        ("CHANGE 1", ["Nothing was changed."]),
        ("DELETE 0", no_line(0)),
        ("DELETE 5", no_line(5)),
        ("DELETE 3 5", no_line(5)),
        ("DELETE 3 2", wrong("DELETE 2 5")),
        ("MOVE", wrong("MOVE 5 2")),
        ("MOVE 1", ["I do not know MOVE 1. Did you mean FW 1?"]),
        ("MOVE 1 6", no_line(6)),
        ("MOVE 5 1", no_line(5)),
        ("COPY 5", no_line(5)),
        ("COPY 1 6", no_line(6)),
        ("COPY 3 2 1", wrong("COPY 2 5")),
        ("COMMENT 5", no_line(5)),
        ("COMMENT 3 2", wrong("COMMENT 2 5")),
        ("LIST", LISTED),
    ),
    "searching": (
        ("SEARCH FW", ["Line 1: FW 1"]),
        ("SEARCH fw", ["Line 3, level 1: FW 2"]),
        ("SEARCH FW", ["Line 1, level 0: FW 1"]),
        ("SEARCH zzz", ["zzz is not in the program."]),
        ("REPLACE zzz", ["zzz is not in the program."]),
        ("REPLACE FW", ["Nothing was changed."]),
        ("TRANSLATE pt", ["The program is tidy now."]),
        ("LIST 3", ["3: PF 2"]),
        ("TRANSLATE xx", wrong("TRANSLATE pt")),
        ("UNDO", ["Line 1: FW 1"]),
        ("UNDO", ["Nothing was changed."]),
        ("REDO", ["Line 1: PF 1"]),
        ("REDO", ["Nothing was changed."]),
    ),
    "watching": (
        ("WATCH", ["I watch no variable."]),
        ("WATCH 1x", wrong("WATCH x")),
        ("WATCH a b", wrong("WATCH x")),
        ("WATCH a", ["I will say when a changes."]),
        ("SHOW VARIABLES", ["There are no variables."]),
    ),
    "saying": (
        *((each, [NOTHING_SAID]) for each in ("LAST", "LAST 9", "SPELL", "LAST WORD", "SHOW LOG")),
        *((each, wrong("LAST 2")) for each in ("LAST 0", "LAST x")),
        ("SPELL 0", wrong("SPELL 2")),
        ("FIND", wrong("FIND wall")),
        ("FIND zzz", ["I have not said zzz."]),
        ("TYPED", ["Nothing was typed yet."]),
        ("TYPED 0", wrong("TYPED 2")),
        ("SHOW LOG 3", ["SHOW LOG takes nothing after it. Type SHOW LOG alone."]),
    ),
    "running": (
        *((each, ["Nothing is running."]) for each in ("PAUSE", "CONTINUE", "STOP ALL")),
        *((each, ["This is the start."]) for each in ("STEP BACK", "STEP BACK")),
    ),
}  # fmt: skip


@pytest.mark.parametrize("subject", CONVERSATIONS)
def test_each_command_has_its_answer(open_script: OpenScript, subject: str) -> None:
    script = open_script(*PROGRAM)
    for typed, answers in CONVERSATIONS[subject]:
        assert (typed, script.answers_to(typed)) == (typed, answers)


WITHOUT = {
    "There are no lines yet.": (
        "READ", "FIRST", "LAST LINE", "NEXT", "BACK", "UP", "DOWN", "PLACE", "LIST", "FORMAT", "UNTIL 1",
        "COPY 1", "COMMENT 1", "DELETE 1", "MOVE 1 2",
    ),
    "There are no errors.": ("ERROR", "ERROR NEXT", "ERROR PREVIOUS", "ERRORS", "EXPLAIN"),
    "There is nothing to run.": ("RUN", "AGAIN", "STEP", "OVER", "START"),
    "Nothing was changed.": ("UNDO", "REDO"),
    "There are no blocks.": ("OUTLINE",),
    "There is nothing to delete.": ("DELETE",),
    "No mistakes were found.": ("FIX",),
    "x is not in the program.": ("SEARCH x", "REPLACE x"),
}  # fmt: skip


@pytest.mark.parametrize("answer", WITHOUT)
def test_without_a_program_each_command_says_what_is_missing(open_script: OpenScript, answer: str) -> None:
    script = open_script()
    for typed in WITHOUT[answer]:
        assert (typed, script.answers_to(typed)) == (typed, [answer])


def test_a_program_that_is_refused_says_what_waits_and_its_mistake_is_read(open_script: OpenScript) -> None:
    script = open_script("FW 1", "FWD 3")
    script.interaction.until_over = script.rest
    mistake = ["Error, line 2, column 1: I do not know FWD.", "Line 2: FWD 3", "Did you mean FW?"]

    assert script.answers_to("RUN") == [*mistake, "Nothing ran, 2 lines wait. FIX corrects line 2."]
    for typed in ("ERROR", "ERRORS", "START"):
        assert script.answers_to(typed) == mistake
    for typed in ("ERROR NEXT", "ERROR PREVIOUS"):
        assert script.answers_to(typed) == ["No more errors. That is 1 of 1."]
    assert script.ctx.program.place == 2
    assert script.answers_to("FIX", "FIX") == ["Line 2: FW 3", "No mistakes were found."]


def test_a_mistake_that_was_corrected_is_still_explained_with_its_line(open_script: OpenScript) -> None:
    script = open_script("FW 1", "SPEAK 1 / 0")
    script.interaction.until_over = script.rest
    script.answers_to("AGAIN")
    why = ["No number can be divided by zero.", "Check first: IF x <> 0 THEN."]

    assert script.answers_to("EXPLAIN") == [*why, "Line 2: SPEAK 1 / 0"]
    assert script.answers_to("CHANGE 2 FW 1", "EXPLAIN")[-3:] == [*why, "Line 2: SPEAK 1 / 0"]
    assert script.ctx.program.place == 2


def test_a_second_procedure_of_a_name_is_explained_without_a_variable(open_script: OpenScript) -> None:
    script = open_script(*("PROCEDURE P DO", "FW 1", "END PROCEDURE") * 2)

    script.answers_to("RUN")
    assert script.answers_to("EXPLAIN")[:2] == ["This name is taken already.", "Choose another name."]


@pytest.mark.parametrize(
    ("text", "example"),
    [
        ("IF 1 == 1 THEN\nEND WHILE", "IF DISTANCE F > 3 THEN FW 1 ELSE TR 90 END IF."),
        ("FW 1\nEND WHILE", "WHILE DISTANCE F > 3 DO FW 1 END WHILE."),
    ],
)
def test_a_wrong_end_is_explained_by_an_example_of_the_open_block(
    open_script: OpenScript, text: str, example: str
) -> None:
    script = open_script(*text.split("\n"))

    assert f"Example: {example}" in script.answers_to("RUN", "EXPLAIN")


def test_looking_back_at_a_run_ends_at_its_start_and_a_step_goes_forward_again(
    open_script: OpenScript,
) -> None:
    script = open_script("FW 1", "TR 90")
    script.interaction.until_over = script.rest
    script.answers_to("AGAIN")
    back = [script.answers_to("STEP BACK")[-1] for _ in range(4)]

    assert back == [
        "Back: end of the program. Position 0, 1.",
        "Before TR 90: facing north.",
        "Before FW 1: position 0, 0.",
        "Back: start of the program.",
    ]
    assert script.answers_to("STEP", "OVER", "STEP") == [
        "Start of the program.",
        "I walked 1 step forward.",
        "I turned 90 degrees to the right.",
    ]


PUT, THING = wrong("PUT box red 4 6"), wrong("MOVE treasure 2 0")
REPORTS = "help, list, manual, map, trail, run, distances, paper"
ELSEWHERE: dict[str, tuple[str, tuple[tuple[str, list[str]], ...]]] = {
    "building": (
        "open_floor",
        (
            ("PUT box red 4 6 AS gold", ["Gold, box, red: at 4, 6. From the robot: 4 right, 6 ahead."]),
            *((f"PUT {each}", PUT) for each in ("box", "4 6", "box red blue 1 1", "box 1 2 3")),
            ("PUT box 1 2 3 4", PUT),
            ("PUT gold 1 2 3 4", PUT),
            ("PUT zzz 1 2", ["zzz is neither a thing nor a color."]),
            ("PUT box 4 6", ["Gold, the red box is in the way. Nothing changed."]),
            ("PUT box 0 0", ["The robot donnie is at that place. Nothing changed."]),
            ("PUT gold 5 5", ["Gold, box, red: now at 5, 5. From the robot: 5 right, 5 ahead."]),
            ("MOVE gold 2 0", ["Gold, box, red: now at 7, 5. From the robot: 7 right, 5 ahead."]),
            *((f"MOVE {each}", THING) for each in ("gold 2", "gold")),
            ("MOVE zzz 1 1", ["There is no zzz here. Nothing changed."]),
            ("TURN", ["To turn the robot, type TR 90.", *wrong("TURN treasure 90")]),
            ("TURN gold", wrong("TURN treasure 90")),
            ("TURN zzz 90", ["There is no zzz here. Nothing changed."]),
            ("PUT wall 5 8 -5 8", ["Wall: from -5, 8 to 5, 8."]),
            ("REMOVE zzz", ["There is no zzz here. Nothing changed."]),
            ("SAVE WORLD", ["Nothing was changed."]),
            ("SAVE WORLD mine", ["World saved as mine.world. WORLD mine.world goes there."]),
        ),
    ),
    "one robot": (
        "open_floor",
        (
            *((each, ["There is one robot, donnie."]) for each in ("ROBOTS", "ROBOT")),
            ("ROBOT x", ["There is no robot x here. There is donnie."]),
            ("CONNECT 9", ["There is no number 9 in the list."]),
            (
                "CONNECT x",
                [
                    "1: the simulator, in use now.",
                    "2: a simulated board, to try without a robot.",
                    "Type CONNECT and a number.",
                ],
            ),
        ),
    ),
    "two robots": (
        "two_robots",
        (
            ("ROBOT BOB", ["Now you talk to bob."]),
            ("ROBOT x", ["There is no robot x here. There are alice and bob."]),
            ("FW 1", ["bob: I walked 1 step forward."]),
            ("ROBOTS", ["Now you talk to bob.", "alice: 0, 0, facing north.", "bob: 0, 29, facing south."]),
            ("TOGETHER", ["No robot has a program yet. START gives it one."]),
            ("STOP ALL", ["No robot is running a program."]),
        ),
    ),
    "settings": (
        "open_floor",
        (
            ("SET zzz", ["No setting is called zzz. SET lists them."]),
            ("SET rate 79", ["Set rate: 80."]),
            ("SET rate 451", ["Set rate: 450."]),
            ("SET rate x", ["Set rate: 450.", "Choose a number, 80 to 450."]),
            ("SET page", ["Long answers, page: rest.", "Choose: rest, ask, off."]),
            ("SET page ask", ["Long answers, page: ask."]),
            ("SET progress 3601", ["Progress reports, progress: 10 seconds.", "Choose: 0 10 60."]),
            ("SET theme light", ["Only in the full screen: type VISUAL."]),
            ("SET detail full", ["Detail: full."]),
        ),
    ),
    "the map": (
        "first_room",
        (
            ("AROUND 3", wrong("AROUND north")),
            ("MAP 1", wrong("MAP 3 2")),
            ("MAP ROW", wrong("MAP ROW 2")),
            ("MAP 3 2", ["3, 2: free. 3 right, 2 ahead."]),
            ("MAP 99 99", ["99, 99: outside the world. 99 right, 99 ahead."]),
            *((f"TRAIL {each}", wrong("TRAIL 2")) for each in ("0", "x")),
            ("TRAIL", ["I have not moved yet."]),
            ("FW 3", ["I walked 3 steps forward."]),
            *((each, ["FW 3: 3 steps, to 0, 3."]) for each in ("TRAIL", "TRAIL 1", "TRAIL 9")),
            ("WHERE", ["Position 0, 3. Facing north."]),
        ),
    ),
    "files": (
        "open_floor",
        (
            ("OPEN", ["Nothing was changed."]),
            *((each, ["There is nothing to save."]) for each in ("SAVE", "SAVE AS")),
            ("OPEN zzz", ["There is no file zzz."]),
            ("SAVE LOG", [NOTHING_SAID]),
            ("REPORT", wrong("REPORT map map.html")),
            ("REPORT x", [f"I can't report x. I can report {REPORTS}."]),
            ("REPORT zzz zzz.html", [f"I can't report zzz. I can report {REPORTS}."]),
            ("REPORT map", ["A report of map needs a file: map.html."]),
            ("REPORT paper", ["A report of paper needs a file: paper.svg."]),
            ("RECOVER", ["There is nothing to recover."]),
            *((f"EXAMPLES {each}", wrong("EXAMPLES 2")) for each in ("0", "8", "x")),
            ("EXAMPLES 1", ["Opened A square, 4 lines."]),
            ("CHALLENGE zzz", ["There is no challenge zzz. CHALLENGE lists them."]),
            *((each, ["No challenge here. Type CHALLENGE."]) for each in ("GOALS", "HINT", "QUESTIONS")),
            ("RESULTS", ["You have not tried a challenge yet."]),
            ("LINEAR", ["You are in linear mode already."]),
        ),
    ),
}  # fmt: skip


@pytest.mark.parametrize("subject", ELSEWHERE)
def test_each_command_about_the_world_has_its_answer(open_script: OpenScript, subject: str) -> None:
    world, conversation = ELSEWHERE[subject]
    script = open_script(world=world)
    for typed, answers in conversation:
        assert (typed, script.answers_to(typed)) == (typed, answers)


IN_WORDS = {
    "In linear mode, type MAP 3 2.": ("WHOLE MAP", "NAMES", "NEXT THING", "PREVIOUS THING", "TO THERE"),
    "In linear mode, type MAP PICTURE.": ("PICTURE", "LEGEND"),
    "In linear mode, type WHERE.": ("COORDINATES", "TO ROBOT"),
    "In linear mode, type AROUND north.": ("FROM HERE",),
    "In linear mode, type READ 3.": ("GO TO", "GO TO 2"),
    "In linear mode, type FIND wall.": ("FILTER",),
    "In linear mode, type OPEN file.": ("RECENT",),
    "In linear mode, type HELP FW.": ("KEYS",),
    "In linear mode, type SHOW LOG.": ("LOG",),
    "Only in the full screen: type VISUAL.": (
        "ZOOM IN", "ZOOM OUT", "COMPLETE", "THEME", "THEME light", "PLAIN", "REDRAW", "CHANGE KEYS"
    ),
}  # fmt: skip


@pytest.mark.parametrize("answer", IN_WORDS)
def test_a_word_of_the_screen_names_one_that_says_the_same_in_words(
    open_script: OpenScript, answer: str
) -> None:
    script = open_script()
    for typed in IN_WORDS[answer]:
        assert (typed, script.answers_to(typed)) == (typed, [answer])


def test_without_a_learner_to_ask_a_missing_name_is_not_understood(open_script: OpenScript) -> None:
    script = open_script(*PROGRAM)
    script.interaction.is_attended = False

    assert script.answers_to("OPEN") == wrong("OPEN file")
    assert script.answers_to("SAVE WORLD") == wrong("SAVE WORLD room")
    assert script.interaction.asked == []


def check(script: Script, *conversation: tuple[str, list[str]]) -> None:
    for typed, answers in conversation:
        assert (typed, script.answers_to(typed)) == (typed, answers)


FREE = [f"{side}: free, 10 steps." for side in ("Ahead", "Right", "Behind", "Left")]


def test_on_the_way_back_place_and_trail_are_those_of_that_moment(open_script: OpenScript) -> None:
    script, present = open_script("FW 1", "TR 90", "FW 2"), "You are back in the present."
    start, one = ["Position 0, 0. Facing north."], ["Position 0, 1. Facing north."]
    check(
        script,
        ("STEP", ["Line 1: FW 1"]),
        ("STEP", ["I walked 1 step forward.", "Line 2: TR 90"]),
        ("WHERE", one),
        ("TRAIL", ["FW 1: 1 step, to 0, 1."]),
        (
            "STEP BACK",
            ["Looking back. The robot stays where it is.", "Before FW 1: position 0, 0.", "Line 1: FW 1"],
        ),
        *(("WHERE", start), ("TRAIL", ["I have not moved yet."])),
        *(("STEP BACK", ["Back: start of the program."]), ("WHERE", start)),
        ("AROUND", [present, "There is nothing within 10 steps.", *FREE]),
        ("WHERE", one),
        ("STOP", ["Stopped at line 2."]),
    )


def rejecting(script: Script, line: str, *, can_edit: bool) -> Script:
    script.ctx.program.rejected = line
    script.interaction.can_edit = can_edit
    return script


@pytest.mark.parametrize(
    ("typed", "offered"),
    [("FIX", "FW 2"), ("CHANGE 2", "FWD 2"), ("CHANGE 2 FW 8", "FW 8")],
)
def test_a_rejected_line_is_offered_again(open_script: OpenScript, typed: str, offered: str) -> None:
    script = rejecting(open_script("FW 1", answers=["FW 9"]), "FWD 2", can_edit=True)

    check(script, (typed, []))
    assert script.interaction.asked == [f"Edit line 2, then Enter. {offered}", "> FW 9"]
    assert script.ctx.program.lines == ("FW 1",)


@pytest.mark.parametrize(
    ("typed", "answer", "lines"),
    [
        ("FIX", "Line 2: FW 2", ("FW 1", "FW 2")),
        ("CHANGE 2 FW 8", "Line 2: FW 8", ("FW 1", "FW 8")),
        ("CHANGE 2", "There is no line 2. The last is 1.", ("FW 1",)),
        ("CHANGE 3 FW 8", "There is no line 3. The last is 1.", ("FW 1",)),
    ],
)
def test_where_no_line_can_be_offered_a_rejected_one_is_added(
    open_script: OpenScript, typed: str, answer: str, lines: tuple[str, ...]
) -> None:
    script = rejecting(open_script("FW 1"), "FWD 2", can_edit=False)

    check(script, (typed, [answer]))
    assert script.ctx.program.lines == lines
    assert script.ctx.program.place == len(lines) - (len(lines) == 1)


def test_a_rejected_line_without_a_fix_is_only_offered(open_script: OpenScript) -> None:
    unknown = ["I don't know what was meant."]
    script = rejecting(open_script("FW 1", answers=["FW 2"]), "zzzz qqqq", can_edit=True)
    check(script, ("FIX", unknown))
    assert script.interaction.asked == ["Edit line 2, then Enter. zzzz qqqq", "> FW 2"]

    script = rejecting(open_script("FW 1"), "zzzz qqqq", can_edit=False)
    check(script, ("FIX", unknown))
    assert script.ctx.program.lines == ("FW 1",)


def test_a_line_is_typed_anew_where_it_can_not_be_edited(open_script: OpenScript) -> None:
    script = open_script("FW 1", answers=["FW 3"])
    script.interaction.can_edit = False

    check(
        script, ("CHANGE 1", ["Line 1: FW 3"]), ("UNDO", ["Line 1: FW 1"]), ("UNDO", ["Nothing was changed."])
    )
    assert script.interaction.asked == ["Type line 1, then Enter. FW 1"]


def test_an_undone_first_line_leaves_an_empty_program(open_script: OpenScript) -> None:
    check(
        open_script(),
        ("INSERT 1 FW 1", ["Line 1: FW 1"]),
        ("UNDO", ["There are no lines yet."]),
        ("REDO", ["Line 1: FW 1"]),
    )


def test_a_change_of_lines_that_have_run_says_what_waits_again(open_script: OpenScript) -> None:
    script = open_script("FW 1", "FW 2", "FW 3")
    script.ctx.program.batch_ran()

    check(
        script,
        ("CHANGE 1 FW 5", ["Line 1: FW 5", "RUN runs all 3 lines again."]),
        ("INSERT 2 FW 6", ["Line 2: FW 6"]),
    )


# --- what was said and typed before


def with_twelve(script: Script) -> Script:
    """Twelve answers of two lines, and twelve typed lines."""
    for number in range(1, 13):
        script.ctx.answers.add_lines([f"answer {number}", f"more {number}"])
        script.ctx.answers.end_answer()
        script.ctx.past.remember(f"FW {number}")
    return script


SAID_BEFORE: dict[str, tuple[list[str], bool]] = {
    "LAST": (["answer 12", "more 12"], True),
    "LAST 2": (["answer 11", "more 11"], True),
    "LAST 12": (["answer 1", "more 1"], True),
    "LAST 13": (["12 answers so far."], False),
    "SPELL": (["m, o, r, e, blank, 1, 2."], True),
    "SPELL 2": (["m, o, r, e, blank, 1, 1."], True),
    "LAST WORD": (["1, 2."], True),
    "FIND more 1": (["4 lines, the newest last.", "more 1", "more 10", "more 11", "more 12"], True),
    "FIND zz": (["I have not said zz."], False),
    "SHOW LOG": (
        ["20 lines.", *(f"{word} {each}" for each in range(3, 13) for word in ("answer", "more"))],
        True,
    ),
    "TYPED 2": (["11: FW 11", "12: FW 12"], False),
    "TYPED": ([f"{each}: FW {each}" for each in range(3, 13)], False),
    "TYPED 12": ([f"{each}: FW {each}" for each in range(1, 13)], False),
    "TYPED 13": ([f"{each}: FW {each}" for each in range(1, 13)], False),
}


@pytest.mark.parametrize("typed", SAID_BEFORE)
def test_what_is_repeated_is_not_remembered_anew(open_script: OpenScript, typed: str) -> None:
    script, repeated = with_twelve(open_script()), set[bool]()
    said, is_repeated = SAID_BEFORE[typed]
    unsubscribe = script.donnie.team.stream.subscribe(
        lambda stamped: repeated.add(getattr(stamped.event, "is_repeated", False))
    )
    assert script.answers_to(typed) == said
    unsubscribe()

    assert repeated == {is_repeated}


def test_on_a_screen_all_typed_lines_are_offered_the_newest_first(open_script: OpenScript) -> None:
    script = with_twelve(open_script())
    script.ctx.screen = object()  # type: ignore[assignment] # TYPED asks nothing of it
    script.answers_to("TYPED")

    assert [(each.value, each.number) for each in script.interaction.offered] == [
        (f"FW {number}", number) for number in range(12, 0, -1)
    ]


@pytest.mark.parametrize(("lines", "said"), [(18, []), (19, ["19 lines."])])
def test_a_list_of_more_than_eighteen_lines_begins_with_their_number(
    open_script: OpenScript, lines: int, said: list[str]
) -> None:
    script = open_script()
    script.ctx.answers.add_lines([str(number) for number in range(lines)])
    script.ctx.answers.end_answer()

    assert script.answers_to("LAST") == [*said, *map(str, range(lines))]


MORE_HELP = {
    "MANUAL 99": ["8 chapters. MANUAL 1 reads the first."],
    "MANUAL 9": ["8 chapters. MANUAL 1 reads the first."],
    "MANUAL FW": ["FW: Walks forward, in steps.", "You write: FW value, or FORWARD value.", "Example: FW 5."],
    "HELP SET volume": ["Set volume: 100.", "Choose a number, 0 to 100."],
    "HELP zzz": ["I do not know zzz. HELP lists the commands."],
    "HELP move": [
        *("MOVE 5 2: Puts line 5 before line 2.", "You write: MOVE line before or thing east north."),
        *("Example: MOVE 5 2.", "FW: Walks forward, in steps."),
    ],
    **{
        each: [
            *("SET page ask: Changes a setting.", "You write: SET, or SET name value."),
            "Example: SET page ask.",
        ]
        for each in ("HELP SET", "HELP SET zzz")
    },
}


@pytest.mark.parametrize("typed", MORE_HELP)
def test_help_of_a_word_is_said(open_script: OpenScript, typed: str) -> None:
    assert open_script().answers_to(typed) == MORE_HELP[typed]


@pytest.mark.parametrize(
    ("number", "title", "first"),
    [
        (1, "A program", "A program is a list of commands."),
        (8, "Mistakes", "The message says the line, what is written there and what you probably meant."),
    ],
)
def test_a_chapter_of_the_manual_is_a_page_with_its_title(
    open_script: OpenScript, number: int, title: str, first: str
) -> None:
    script = open_script()

    assert script.answers_to(f"MANUAL {number}")[0] == first
    assert script.interaction.asked == [title]


def test_the_tour_of_a_world_with_several_robots_says_to_which_the_learner_talks(
    open_script: OpenScript,
) -> None:
    script = open_script(world="two_robots")
    assert script.answers_to("TOUR")[0] == "Now you talk to alice."
    script.ctx.tour_page = 9

    assert script.answers_to("TOUR")[-1] == "Enter begins it. One command solves it."
    assert script.ctx.tour_page == 1
    assert script.interaction.more is not None
    with pytest.raises(EnterWorld) as entered:
        drive(script.interaction.more())
    assert entered.value.name == "challenge:1"


@pytest.mark.parametrize(
    ("typed", "code"),
    [
        (("LIST",), 0),
        (("SAVE",), 0),
        (("OPEN zzz",), 2),
        (("PUT zzz 1 2",), 2),
        (("LISTT 2",), 1),
        (("PUT box",), 1),
        (("SPEED 0",), 1),
        (("SET zzz 1",), 1),
        (("SET cue zzz",), 1),
        (("SET volume loud",), 1),
        (("WORLD zzz",), 2),
        (("CHALLENGE zzz",), 2),
        (("LISTT 2", "OPEN zzz"), 2),
        (("OPEN zzz", "LISTT 2", "LIST"), 2),
    ],
)
def test_the_worst_refusal_of_a_script_is_its_exit_code(
    open_script: OpenScript, typed: tuple[str, ...], code: int
) -> None:
    script = open_script("FW 1")
    script.answers_to(*typed)

    assert script.ctx.script_code == code


def test_a_busy_robot_is_named_where_there_are_several(open_script: OpenScript) -> None:
    script = open_script("WAIT 1000", world="two_robots", speed=1.0)
    script.type("START")
    script.printed.clear()
    script.type("RESET")
    script.type("PUT box red 4 6")

    said = [each for each in script.printed if "Waiting" not in each and "begins" not in each]
    assert said == ["alice: A program is running. STOP stops it."] * 2
    script.type("STOP ALL")
    script.rest()
