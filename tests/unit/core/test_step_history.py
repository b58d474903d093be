"""STEP BACK through the holds of a run and forward again, with what each of these moments knows."""

from collections.abc import Sequence

import pytest

from devices.ports.robot import Pose
from donnie_tui.core.events import (
    TYPED,
    Announced,
    Event,
    HowStarted,
    Moved,
    Outcome,
    Read,
    RunEnded,
    RunStarted,
    Stamped,
)
from donnie_tui.core.stepping import Stepping
from donnie_tui.core.timeline import Timeline
from donnie_tui.i18n.words import Words
from language.parser import parse
from language.runtime import Frame

PROGRAM = ("VAR x = 1", "FW x", "x = 2", "FW x", "SPEAK x")


class History:
    """A program that is held, and what happened between its holds: walks to the north."""

    def __init__(self, *lines: str, detail: str = "brief", is_first: bool = True) -> None:
        program = parse("\n".join(lines)).program
        assert program is not None
        how = HowStarted("", 1, fresh=True, terminal=True, trace=False, pose=Pose(0, 0, 0))
        self.happened: list[Event] = [RunStarted(TYPED, "floor", "donnie", 0, "1", how)]
        self.stepping = Stepping(
            program, lines, Words("en", detail), last_seq=lambda: len(self.happened), is_first=is_first
        )
        self.north = 0
        self.now: dict[str, int] = {}

    def walked(self, *steps: int) -> None:
        for each in steps:
            self.north += each
            self.happened += [
                Moved(f"FW {each}", each, each, None, Pose(0, self.north, 0), True),
                Announced("moved", f"I walked {each} forward."),
            ]

    def held(self, line: int, **variables: int) -> tuple[str, ...]:
        self.now = variables
        return self.stepping.on_hold((line, 1), (Frame("", line, tuple(variables.items())),))

    def timeline(self) -> Timeline:
        timeline = Timeline([Stamped(at, 0.0, event) for at, event in enumerate(self.happened, start=1)])
        timeline.go_to(len(timeline))
        return timeline

    def back(self, timeline: Timeline, times: int) -> list[tuple[str, ...]]:
        """The sentences of so many steps back from the present."""
        return [self.stepping.step_back(timeline, self.now, is_first_step=not each) for each in range(times)]

    def forward(self, timeline: Timeline) -> list[tuple[str, ...]]:
        """The sentences of steps forward until the present, and of ten at most."""
        found = list[tuple[str, ...]]()
        while len(found) < 10 and not (found and self.stepping.is_present(timeline)):
            found.append(self.stepping.step_forward(timeline))
        return found

    def lines_at(self, timeline: Timeline) -> Sequence[int] | None:
        frames = self.stepping.frames_at(timeline)
        return None if frames is None else [each.line for each in frames]


def stepped(*, is_held: bool) -> History:
    """Held before each line; the last one has run unless ``is_held`` before it."""
    history = History(*PROGRAM)
    history.held(1)
    history.held(2, x=1)
    history.walked(1)
    history.held(3, x=1)
    history.held(4, x=2)
    if not is_held:
        history.walked(2)
    return history


FORWARD = [
    ("Start of the program.", "Line 1: VAR x = 1"),
    ("Line 2: FW x",),
    ("I walked 1 forward.", "Line 3: x = 2"),
    ("Line 4: FW x",),
]
BACK = [
    ("Back.", "x is 1.", "Line 3: x = 2"),
    ("Before FW 1: position 0, 0.", "Line 2: FW x"),
    ("Back.", "x has no value yet.", "Line 1: VAR x = 1"),
    ("Back: start of the program.",),
    ("This is the start.",),
]


@pytest.mark.parametrize("is_held", [True, False])
def test_each_step_back_leads_to_the_hold_before_and_forward_again_to_the_present(is_held: bool) -> None:
    history, last = stepped(is_held=is_held), [("Before FW 2: position 0, 1.", "Line 4: FW x")]
    timeline = history.timeline()

    assert history.back(timeline, 6 - is_held) == [*([] if is_held else last), *BACK]
    assert not history.stepping.is_present(timeline)
    assert history.forward(timeline) == [*FORWARD, *([] if is_held else [("I walked 2 forward.",)])]


@pytest.mark.parametrize("is_held", [True, False])
def test_a_moment_of_the_past_has_the_calls_of_its_hold_and_its_place_in_all_steps(is_held: bool) -> None:
    """A hold without an event counts, too: of four holds two changed only the variable, or nothing."""
    history, steps = stepped(is_held=is_held), 4 + (not is_held)
    timeline, seen = history.timeline(), list[tuple[object, ...]]()
    for each in range(steps):
        history.stepping.step_back(timeline, history.now, is_first_step=not each)
        frames, counted = history.lines_at(timeline), history.stepping.counted(timeline)
        seen.append((frames, *counted))

    held = [([4], 4, 5)] if not is_held else []
    assert seen == [*held, ([3], 3, steps), ([2], 2, steps), ([1], 1, steps), (None, 0, steps)]


def test_a_step_back_from_the_present_begins_there_again() -> None:
    history = stepped(is_held=True)
    history.back(history.timeline(), 3)

    assert history.back(history.timeline(), 1) == BACK[:1]


def test_the_first_step_back_may_have_been_that_of_another_robot() -> None:
    history = stepped(is_held=True)

    assert history.stepping.step_back(history.timeline(), history.now, is_first_step=False) == BACK[0]


def ran_on(*, is_held: bool) -> History:
    """Held before the first line, and then perhaps before the last one; it ran on in between."""
    history = History("VAR x = 1", "FW x", "FW x", "FW x", "SPEAK x")
    history.held(1)
    history.stepping.run_on()
    history.walked(1, 1, 1)
    history.now = {"x": 1}
    if is_held:
        history.held(5, x=1)
    return history


@pytest.mark.parametrize("is_held", [True, False])
def test_what_ran_between_two_holds_is_undone_walk_by_walk(is_held: bool) -> None:
    history = ran_on(is_held=is_held)
    timeline, seen = history.timeline(), list[tuple[object, ...]]()
    for each in range(3):
        said = history.stepping.step_back(timeline, history.now, is_first_step=not each)
        seen.append((said, history.lines_at(timeline), history.stepping.counted(timeline)))

    first = "Before FW 1: position 0, 0.", "x has no value yet.", "Line 1: VAR x = 1"
    assert seen == [
        (("Before FW 1: position 0, 2.",), None, (3, 4)),
        (("Before FW 1: position 0, 1.",), None, (2, 4)),
        (first, [1], (1, 4)),
    ]
    walked = [("I walked 1 forward.",)] * 3
    held = [*walked[:2], (*walked[2], "Line 5: SPEAK x")]
    assert history.forward(timeline) == (held if is_held else walked)


def test_what_ran_before_the_first_hold_is_undone_and_repeated_walk_by_walk() -> None:
    """As at a breakpoint."""
    history = History("FW 1", "FW 1", "SPEAK 1")
    history.walked(1, 1)
    history.held(3)
    timeline = history.timeline()

    assert history.back(timeline, 2) == [
        ("Before FW 1: position 0, 1.",),
        ("Before FW 1: position 0, 0.",),
    ]
    walked = "I walked 1 forward."
    assert history.forward(timeline) == [(walked,), (walked, "Line 3: SPEAK 1")]


def test_steps_are_counted_one_by_one_after_the_program_ran_on() -> None:
    history = ran_on(is_held=True)
    history.walked(1, 1)
    history.held(5, x=1)

    assert history.back(history.timeline(), 1) == [
        ("Before FW 1: position 0, 4.", "Before FW 1: position 0, 3.", "Line 5: SPEAK x")
    ]


@pytest.mark.parametrize(("walks", "more"), [(5, 0), (6, 1), (8, 3)])
def test_of_a_step_with_many_walks_five_are_listed(walks: int, more: int) -> None:
    history = History("P []", "FW 1")
    history.held(1)
    history.walked(*[1] * walks)
    history.held(2)
    timeline = history.timeline()

    back = [f"Before FW 1: position 0, {walks - each}." for each in range(1, 6)]
    assert history.back(timeline, 1) == [(*back, *[f"Back: {more} more."][:more], "Line 1: P []")]
    forward = *["I walked 1 forward."] * 5, *[f"{more} more."][:more], "Line 2: FW 1"
    assert history.forward(timeline) == [forward]


def test_without_a_hold_each_step_back_undoes_an_event() -> None:
    history = History("FW 1")
    history.walked(1)
    timeline = history.timeline()

    assert history.stepping.worked_out(None) == ()
    assert history.back(timeline, 2) == [
        ("Before FW 1: position 0, 0.",),
        ("Back: start of the program.",),
    ]
    assert (history.lines_at(timeline), history.stepping.worked_out(timeline)) == (None, ())
    assert history.forward(timeline) == [("Start of the program.",), ("I walked 1 forward.",)]


def test_a_pause_within_a_statement_is_no_hold() -> None:
    history = stepped(is_held=True)
    history.walked(1)

    assert history.held(0) == ()
    assert history.back(history.timeline(), 1) == [("Before FW 1: position 0, 1.", "Line 4: FW x")]


def test_the_expressions_of_the_next_statement_are_those_of_the_moment() -> None:
    history = History("VAR x = 1", "FW x + 1", "FW x + 2")
    for line, variables in ((1, {}), (2, {"x": 1}), (3, {"x": 1})):
        history.held(line, **variables)
        history.walked(*[2] * (line == 2))
    timeline = history.timeline()

    assert history.stepping.worked_out(None) == (("x + 2", "1 + 2", "3"),)
    assert history.stepping.worked_out(timeline) == ()
    history.back(timeline, 1)
    assert history.stepping.worked_out(timeline) == (("x + 1", "1 + 1", "2"),)
    timeline.forward()
    assert history.stepping.worked_out(timeline) == ()


def test_of_many_open_calls_the_innermost_are_remembered() -> None:
    history = History("FW 1", "FW 2")
    history.stepping.on_hold((1, 1), [Frame("P", line, ()) for line in range(1, 26)])
    history.held(2)
    timeline = history.timeline()
    history.back(timeline, 1)

    assert history.lines_at(timeline) == list(range(1, 21))


def test_readings_and_the_end_of_the_program_are_said_with_the_condition() -> None:
    history = History("WHILE DISTANCE F > 3 DO", "FW 1", "END WHILE")
    said = [history.held(1)]
    for line, value in ((2, 5), (1, None), (None, 2)):
        if value is not None:
            history.stepping.on_read(Read("distance", "F", value))
        said.append(history.held(line) if line is not None else history.stepping.on_end())

    assert said == [
        ("Line 1: WHILE DISTANCE F > 3 DO",),
        ("5 is greater than 3: true.", "Round 1.", "Line 2: FW 1"),
        ("Line 1: WHILE DISTANCE F > 3 DO",),
        ("2 is greater than 3: false.",),
    ]


@pytest.mark.parametrize("is_first", [True, False])
def test_rounds_are_not_counted_after_the_program_ran_on(is_first: bool) -> None:
    history = History("REPEAT 4 TIMES", "FW 1", "END REPEAT", is_first=is_first)
    first = [line for each in (1, 2, 1) for line in history.held(each) if "ound" in line]
    history.stepping.run_on()

    assert first == (["Round 1 of 4."] if is_first else [])
    assert [history.held(each)[0] for each in (1, 2, 1, 2)] == [
        "Line 1: REPEAT 4 TIMES",
        "Line 2: FW 1",
        "Line 1: REPEAT 4 TIMES",
        "Next round.",
    ]


def test_the_end_of_a_run_is_undone_before_its_last_step() -> None:
    history = stepped(is_held=False)
    history.happened.append(RunEnded(Outcome.COMPLETED, Pose(0, 3, 0), {"x": 2}, 1.0))

    assert history.back(history.timeline(), 1) == [
        ("Back: end of the program. Position 0, 3.", "Before FW 2: position 0, 1.", "Line 4: FW x")
    ]
