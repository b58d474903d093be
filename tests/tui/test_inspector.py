"""The distances in the inspector: those of the place where the robot is, whether its program asked or not."""

import pytest

from devices.ports.robot import Bearing, Pose
from donnie_tui.core.events import Read, Sensed
from donnie_tui.core.run_state import RunState
from donnie_tui.i18n.words import Words
from donnie_tui.tui.event_queue import EventBatch
from donnie_tui.tui.pane_text import (
    Histories,
    VariableChanges,
    inspector_lines,
    reading_name,
    robot_sentence,
    scopes_of,
    state_badge,
    state_sentences,
    working_in_a_row,
    working_lines,
)
from language.runtime import Frame


def ahead(screen) -> int:
    """What the inspector says of it."""
    return int(shown(screen)[0])


def known(screen) -> list[str]:
    """What the inspector should say, in its order."""
    distances = screen.app.controller.donnie.session._robot.known_distances()
    return [str(distances[bearing]) for bearing in sorted(distances, key=lambda each: each.value)]


def shown(screen) -> list[str]:
    """From the front to the right and round, out of a list or a picture of the robot from above."""
    lines = screen.main.inspector.lines
    first = lines.index("Distances now:") + 1
    if screen.main.is_plain:
        return [line.split(": ")[1] for line in lines[first : first + 6]]
    front_left, front, front_right = lines[first].split()[1:]
    assert lines[first + 1].split() == ["left", "^", "right"]
    back_left, back, back_right = lines[first + 2].split()[1:]
    return [front, front_right, back_right, back, back_left, front_left]


async def test_the_distances_are_there_before_anything_runs(open_screen):
    async with open_screen(world="living_room", size=(120, 40)) as screen:
        lines = screen.main.inspector.lines

        assert lines[1:] == (
            "Distances now:",
            "ahead      3    24    35",
            "            left ^ right",
            "behind     3     2     3",
        )
        assert shown(screen) == known(screen)


@pytest.mark.parametrize(
    ("language", "drawing"),
    [
        ("pt", ("à frente     3    24    35", "          esquerda ^ direita", "atrás        3     2     3")),
        (
            "es",
            ("al frente     3    24    35", "          izquierda ^ derecha", "atrás         3     2     3"),
        ),
    ],
)
async def test_all_four_sides_of_the_robot_have_their_names(open_screen, language, drawing):
    """In the narrowest pane that stands next to the map."""
    async with open_screen(world="living_room", size=(120, 40), language=language) as screen:
        assert screen.main.inspector.lines[-3:] == drawing
        assert all(row in screen.text for row in drawing)


async def test_the_distances_follow_a_moving_robot_and_are_right_where_it_stops(open_screen):
    async with open_screen("FW 30", world="corridor", size=(120, 40), speed=2.0) as screen:
        start = ahead(screen)
        await screen.press("f5")
        await screen.until(lambda: ahead(screen) <= start - 2, "they follow")
        assert screen.app.controller.ctx.runs.state is RunState.RUNNING

        await screen.press("f8")
        await screen.idle()

        assert shown(screen) == known(screen)


async def test_the_distances_are_right_where_a_program_holds_and_where_it_ends(open_screen):
    async with open_screen("FW 3\nTR 90\nFW 2", world="living_room", size=(120, 40)) as screen:
        start = shown(screen)
        screen.main.editor.go_to(3)
        await screen.press("f10")
        await screen.shows("Line 3: FW 2")
        held = shown(screen)
        assert held == known(screen) != start

        await screen.press("f6")
        await screen.shows("The program is done.")

        assert shown(screen) == known(screen) != held


async def test_the_distances_are_those_of_the_selected_robot(open_screen):
    async with open_screen(world="two_robots", size=(120, 40)) as screen:
        await screen.type_line("FW 4")
        await screen.shows("alice: I walked 4 steps forward.")
        await screen.idle()
        of_alice = shown(screen)
        await screen.type_line("ROBOT bob")
        await screen.shows("Now you talk to bob.")

        await screen.until(lambda: shown(screen) == known(screen), "those of bob")
        assert shown(screen) != of_alice


async def test_the_distances_change_when_another_robot_approaches(open_screen):
    async with open_screen(
        "REPEAT 9 TIMES FW 1 END REPEAT", world="two_robots", size=(120, 40), speed=5.0
    ) as screen:
        before = ahead(screen)
        await screen.type_line("ROBOT bob")
        await screen.shows("Now you talk to bob.")
        await screen.press("f5")
        await screen.reaches(RunState.RUNNING)
        await screen.type_line("ROBOT alice")
        await screen.shows("Now you talk to alice.")

        await screen.until(lambda: ahead(screen) == before - 9, "bob has come near")


async def test_a_robot_without_rangers_has_no_distances(open_screen):
    async with open_screen(world="bigbob1", size=(120, 40)) as screen:
        assert screen.main.inspector.lines == ("No variables.",)


async def test_a_reader_is_not_given_each_distance_of_a_moving_robot(open_screen):
    async with open_screen("FW 30", world="corridor", plain=True, speed=5.0) as screen:
        session = screen.app.controller.donnie.session
        heard: list[Sensed] = []
        screen.app.controller.donnie.team.stream.subscribe(
            lambda it: heard.append(it.event) if isinstance(it.event, Sensed) else None
        )
        await screen.press("f5")
        await screen.until(lambda: session.pose.y > 3, "the robot is on its way")
        assert not any(each.distances != heard[0].distances for each in heard)
        await screen.until(lambda: "Distances now:" not in screen.main.inspector.lines, "they are not shown")

        await screen.press("f8")
        await screen.idle()

        assert shown(screen) == known(screen)


@pytest.mark.parametrize(
    ("value", "shown"),
    [
        (10**18 - 1, "999999999999999999"),
        (2**63, "922337... (19)"),
        (-(10**20 - 1), "-999999... (20)"),
        (10**4300 - 1, "999999... (4300)"),
    ],
    ids=["whole", "19", "20", "4300"],
)
def test_a_long_number_has_its_first_digits_and_how_many_there_are(value, shown):
    assert inspector_lines((), {"a": value}, {}, (), (), Words())[1] == f"a is {shown}"


def test_variables_are_a_table_with_what_they_were_and_marks_of_the_last_step():
    changes = VariableChanges()

    def step(line: int, **variables: int) -> tuple[str, ...]:
        changes.look([("", tuple(variables.items()))], [line])
        return inspector_lines((), variables, {}, (), (), Words(), changes)

    step(1, base=5, height=4)
    assert step(2, base=5, height=3) == (
        " name    value  was",
        " base        5",
        "*height      3    4",
    )
    assert step(3, base=5, height=3)[2] == " height      3    4"


def test_after_a_run_without_steps_no_variable_has_the_mark_of_the_last_step():
    changes = VariableChanges()
    changes.look([("", (("base", 5),))], [])
    assert inspector_lines((), {"base": 5}, {}, (), (), Words(), changes)[1] == " base      5"

    changes.look([("", (("base", 5),))], [1])
    changes.look([("", (("base", 6),))], [])
    assert inspector_lines((), {"base": 6}, {}, (), (), Words(), changes)[1] == "*base      6    5"


def test_a_change_is_kept_with_the_value_before_it_until_a_program_begins_anew():
    changes, n = VariableChanges(), ("", "n")
    for value, lines, changed, was in (
        (1, [3], {n}, {}),
        (1, [3], {n}, {}),  # the same moment
        (1, [4], set(), {}),
        (2, [5], {n}, {n: 1}),
        (3, [], {n}, {n: 2}),
        (4, [], set(), {n: 2}),  # the program ended unseen
    ):
        changes.look([("", (("n", value),))], lines)
        assert (changes.changed, changes.was) == (changed, was)
    changes.look([("WALK", (("n", 9),)), ("", (("n", 4),))], [1])
    assert (changes.changed, changes.was) == ({("WALK", "n")}, {n: 2})
    changes.forget()
    assert (changes.changed, changes.was) == (frozenset(), {})
    changes.look([("", (("n", 4),))], [1])
    assert (changes.changed, changes.was) == ({n}, {})


@pytest.mark.parametrize("changes", [VariableChanges(), None], ids=["seen", "heard"])
def test_variables_that_are_not_known_are_not_called_none(changes):
    assert inspector_lines((), None, {}, (), (), Words(), changes)[0] == "Variables: not known here."
    assert inspector_lines((), {}, {}, (), (), Words(), changes)[0] == "No variables."


def test_inside_a_procedure_the_variables_of_the_program_are_still_there():
    frames = (Frame("WALK", 2, (("steps", 3),)), Frame("", 5, (("total", 12),)))
    changes = VariableChanges()

    lines = inspector_lines(frames, {}, {}, (), (), Words(), changes)
    assert lines[:4] == (" name   value  was", " steps      3", "Of the program:", " total     12")
    heard = inspector_lines(frames, {}, {}, (), (), Words())
    assert heard[:4] == ("Variables:", "steps is 3", "Of the program:", "total is 12")


class _Holding:
    """The runs at the moment at which a program holds: it runs until its variables are read."""

    def __init__(self, runs, state, frames):
        self._runs, self.state, self._frames = runs, state, frames

    def __getattr__(self, name):
        return getattr(self._runs, name)

    @property
    def frames(self):
        self.state = RunState.PAUSED
        return self._frames


async def test_a_look_before_a_program_holds_marks_no_variable(open_screen, monkeypatch):
    """The look after it would have found no change, so the mark was gone."""
    program = "VAR sum = 6\nsum = sum + 1\nFW 1"
    async with open_screen(program, size=(120, 40)) as screen:
        screen.main.editor.go_to(2)
        await screen.press("f10")
        await screen.shows("Line 2")
        display = screen.app.controller.display
        for state, line in ((RunState.RUNNING, 2), (RunState.PAUSED, 3)):
            frames = (Frame("", line, (("sum", 7),)),)
            monkeypatch.setattr(display, "_runs", _Holding(display._runs, state, frames))
            display._show_inspector()
        monkeypatch.undo()

        assert "*sum       7    6" in screen.main.inspector.lines


async def test_a_step_marks_the_variable_that_it_changed(open_screen):
    program = "PROCEDURE ADD: n DO\nVAR sum = n + 1\nsum = sum + 1\nFW 1\nEND PROCEDURE\nVAR a = 5\nADD [a]"
    async with open_screen(program, size=(120, 40)) as screen:
        screen.main.editor.go_to(3)
        await screen.press("f10")
        await screen.shows("Line 3, level 1")
        await screen.press("f7")
        await screen.shows("Line 4: FW 1")
        lines = screen.main.inspector.lines

        assert "*sum       7    6" in lines
        assert " a         5" in lines


def test_a_chart_has_the_highest_value_above_and_the_newest_at_the_right():
    histories = Histories()
    for value in (0, 10, 20, 30):
        histories.add("ahead", value)

    assert histories.charts(20, Words()) == ("ahead over time:", "30|   *", "  |  *", "  | *", " 0|*")
    assert histories.charts(5, Words())[1:] == ("30| *", "  |", "  |", "20|*")


def test_what_never_changed_has_no_chart():
    histories = Histories()
    for _ in range(5):
        histories.look((("", (("a", 3),)),))
        histories.add("ahead", 7)

    assert histories.charts(20, Words()) == ()


async def test_distances_and_variables_are_charts_over_time(open_screen):
    text = "VAR a = 0\nREPEAT 4 TIMES\na = a + 1\nFW 5\nSPEAK DISTANCE F\nEND REPEAT"
    async with open_screen(text, world="living_room", size=(120, 40)) as screen:
        for line, value in ((2, 0), (5, 1), (5, 2), (5, 3), (5, 4)):
            screen.main.editor.go_to(line)
            await screen.press("f10")
            await screen.until(
                lambda value=str(value): (
                    value in screen.main.inspector.lines[1].replace("*", " ").split()[1:2]
                ),
                "it",
            )
            await screen.reaches(RunState.PAUSED)
        await screen.press("f6")
        await screen.shows("The program is done.")
        await screen.idle()
        lines = screen.main.inspector.lines
        of_a = lines.index("a over time:") + 1
        of_distance = next(at for at, line in enumerate(lines) if "over time" in line and at != of_a - 1) + 1

        assert [line.rstrip() for line in lines[of_a : of_a + 4]] == ["4|    *", " |  **", " | *", "0|*"]
        assert [line.partition("|")[2] for line in lines[of_distance : of_distance + 4]] == [
            "*",
            " *",
            "  *",
            "   *",
        ]


async def test_the_plain_layout_has_no_charts(open_screen):
    async with open_screen("REPEAT 4 TIMES\nFW 1\nSPEAK DISTANCE F\nEND REPEAT", plain=True) as screen:
        await screen.press("f5")
        await screen.shows("The program is done.")

        assert not any("over time" in line for line in screen.main.inspector.lines)


async def test_the_first_step_back_after_a_run_marks_what_it_changes_alone(open_screen):
    program = "VAR a = 5\nVAR sum = 6\nFW 1\nsum = sum + 1\nFW 1"
    async with open_screen(program, size=(120, 40)) as screen:
        await screen.press("f5")
        await screen.shows("The program is done.")
        await screen.idle()
        await screen.until(lambda: " sum       7" in screen.main.inspector.lines, "the variables")
        seen = []
        for _ in range(3):
            screen.app.controller.do("step_back")
            await screen.painted()
            seen.append(list(screen.main.inspector.lines[1:3]))

        assert seen[1:] == [[" a         5", " sum       7"], [" a         5", "*sum       6    7"]]


# --- the texts of the status line and the inspector, by themselves

WORDS = Words("en")
CALLS = (Frame("WALK", 2, (("steps", 3),)), Frame("", 5, (("total", 12),)))


@pytest.mark.parametrize(
    ("name", "pose", "sentence"),
    [
        (None, Pose(0, 0, 0), "Donnie at 0, 0 facing north."),
        ("bob", Pose(3, -2, 45), "bob at 3, -2 facing northeast."),
        (None, Pose(0, 0, 44), "Donnie at 0, 0 facing 44 degrees."),
    ],
)
def test_the_status_says_where_the_robot_is_and_a_heading_between_points_as_a_number(name, pose, sentence):
    assert robot_sentence(name, pose, WORDS) == sentence


@pytest.mark.parametrize(
    ("state", "past", "speed", "was_stopped", "badge"),
    [
        (RunState.READY, None, 5.0, False, ("READY", "$success")),
        (RunState.READY, None, 5.0, True, ("STOPPED", "$error")),
        (RunState.RUNNING, None, 5.0, True, ("RUNNING x5", "$accent")),
        (RunState.RUNNING, None, None, False, ("RUNNING MAX", "$accent")),
        (RunState.PAUSED, None, 5.0, False, ("PAUSED", "$warning")),
        (RunState.STOPPING, None, 5.0, False, ("STOPPING", "$error")),
        (RunState.READY, (2, 5), 5.0, True, ("LOOKING BACK, 2 OF 5", "$warning")),
    ],
)
def test_the_badge_says_what_the_program_does_and_has_its_colour(state, past, speed, was_stopped, badge):
    assert state_badge(state, past, speed, WORDS, was_stopped=was_stopped) == badge


@pytest.mark.parametrize(
    ("state", "sentences"),
    [
        ("running", ("Running, speed max.", "Running.")),
        ("looking-back", ("Looking back.", "Looking back.")),
    ],
)
def test_the_state_has_a_sentence_with_the_speed_and_one_without(state, sentences):
    assert state_sentences(state, None, WORDS) == sentences


def test_variables_calls_belt_and_readings_are_sentences_in_this_order():
    readings = (Read("distance", "front", 4), Read("colour", "red", 2), Read("position", "x", 7))

    assert inspector_lines(CALLS, {}, {}, readings, ("Belt: nothing near.",), WORDS) == (
        *("Variables:", "steps is 3", "Of the program:", "total is 12"),
        *("Calls:", "WALK, line 2", "program, line 5", "Belt: nothing near."),
        *("Last readings:", "distance ahead: 4", "color red: 2", "position x: 7"),
    )
    many = inspector_lines([Frame("P", at, ()) for at in range(25)], {}, {}, (), (), WORDS)
    assert many[-1] == "P, line 19"
    assert len(many) == 1 + 1 + 20


def test_distances_are_a_picture_for_the_eye_and_a_list_for_a_listener():
    distances = {Bearing.BACK_LEFT: 12, Bearing.FRONT: 4}

    assert inspector_lines((), {}, distances, (), (), WORDS, VariableChanges())[1:] == (
        *("Distances now:", "ahead      -     4     -"),
        *("            left ^ right", "behind    12     -     -"),
    )
    assert inspector_lines((), {}, distances, (), (), WORDS)[1:] == (
        "Distances now:", "ahead: 4", "behind left: 12"
    )  # fmt: skip


@pytest.mark.parametrize(
    ("worked_out", "lines", "row"),
    [
        ([], (), ()),
        ([("a", "1")], ("a", "= 1"), ("a = 1", "= 1")),
        (
            [("3 + 4 * 2", "3 + 8", "11"), ("a", "1")],
            ("3 + 4 * 2", "= 3 + 8", "= 11", "a", "= 1"),
            ("3 + 4 * 2 = 3 + 8 = 11; a = 1", "3 + 4 * 2 = 11; a = 1", "= 11; = 1"),
        ),
    ],
)
def test_what_a_line_works_out_is_shown_step_by_step_or_in_a_row(worked_out, lines, row):
    assert working_lines(worked_out, WORDS) == (("Worked out in this line:", *lines) if lines else ())
    assert working_in_a_row(worked_out) == row


@pytest.mark.parametrize(
    ("frames", "scopes"),
    [
        ((), (("", (("x", 1),)),)),
        (CALLS, (("WALK", (("steps", 3),)), ("", (("total", 12),)))),
        (CALLS[:1], (("WALK", (("steps", 3),)), ("", ()))),
        (CALLS[1:], (("", (("total", 12),)),)),
    ],
)
def test_the_variables_of_the_procedure_come_before_those_of_the_program(frames, scopes):
    assert scopes_of(frames, {"x": 1}) == scopes


def test_charts_are_of_three_that_changed_from_three_values_below_a_million_on():
    histories = Histories()
    for values, charts in (((1, 2), 0), ((3,), 1), ((10**6,), 0)):
        for value in values:
            histories.add("a", value)
        assert len(histories.charts(20, WORDS)) == 5 * charts
    for name in "bcde":
        for value in (1, 2, 3):
            histories.add(name, value)
    assert histories.charts(20, WORDS)[::5] == tuple(f"{each} over time:" for each in "bcd")
    histories.forget()
    for value in (10**6 - 1, 1, 2, -5):
        histories.add("a", value)
    assert histories.charts(20, WORDS)[1:] == ("999999|*", "      |", "      |", "    -5| ***")
    histories.forget()
    for value in range(300):
        histories.add("a", value)
    charts = histories.charts(400, WORDS)
    assert (charts[1][:4], charts[4]) == ("299|", "100|" + "*" * 34)


@pytest.mark.parametrize(
    ("columns", "charted"),
    [
        (5, ("2| *", " |", " |", "1|* *")),
        (4, ("2|*", " |", " |", "1| *")),
        (3, ("1|", " |", " |", "1|*")),
        (0, ("1|", " |", " |", "1|*")),
    ],
)
def test_a_chart_has_the_newest_values_for_which_there_is_room_and_one_at_least(columns, charted):
    histories = Histories()
    for value in (1, 2, 1):
        histories.add("a", value)
    assert histories.charts(columns, WORDS)[1:] == charted


@pytest.mark.parametrize(
    ("read", "name"),
    [
        (Read("distance", "back left", 4), "distance behind left"),
        (Read("distance", "beak", 4), "distance beak"),
        (Read("colour", "", 4), "color unknown"),
        (Read("position", "red", 4), "position red"),
    ],
)
def test_a_reading_has_the_name_of_its_sensor_and_of_what_that_was_asked(read, name):
    assert reading_name(read, WORDS) == name


async def test_the_belt_stays_among_the_variables_once_it_has_shown_something(open_screen, monkeypatch):
    async with open_screen(size=(120, 40)) as screen:
        display, inspector = screen.app.controller.display, screen.main.inspector
        monkeypatch.setattr(display._donnie.outlets.belt, "rows", lambda: ("Belt: ahead.",))
        display.receive(EventBatch())
        assert "Belt: ahead." not in inspector.lines
        for batch in (
            EventBatch(belt=(1,) * 14),
            EventBatch(),
            EventBatch(distances={Bearing.FRONT: 4}),
        ):
            display.receive(batch)
            assert "Belt: ahead." in inspector.lines
        assert "Distances now:" in inspector.lines
