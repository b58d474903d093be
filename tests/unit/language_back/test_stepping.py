"""Pausing, stepping and tracing a program, and reading its frames while it runs."""

from __future__ import annotations

import threading
from collections.abc import Callable
from contextlib import suppress

import pytest

from language.compiler import compile_program
from language.control import ControlState, ExecutionControl
from language.diagnostics import Stopped
from language.runtime import Frame, Memory, Runnable
from tests.timeouts import TIMEOUT
from tests.unit.language_back.interpreter import interpreted_program
from tests.unit.language_back.recorder import Make, Recorder, fast, hooked, read

steppable = pytest.mark.parametrize("make", [hooked, interpreted_program], ids=["hooked", "interpreted"])

PROGRAM = """VAR a = 1
PROCEDURE P: n DO
VAR b = n
SPEAK b
END PROCEDURE
REPEAT 2 TIMES
P [a]
a = a + 1
END REPEAT
SPEAK a"""


def frames_while(
    program: Runnable, first: Callable[[ExecutionControl], None], then: Callable[[ExecutionControl], None]
) -> list[tuple[Frame, ...]]:
    """The frames at each pause of a run; calls ``then`` at each."""
    control, seen = ExecutionControl(), []

    def on_state(state: ControlState) -> None:
        if state is ControlState.PAUSED:
            seen.append(program.frames())
            then(control)

    control.observe(on_state)
    first(control)
    program.run(Recorder(), control, Memory())
    return seen


def lines(seen: list[tuple[Frame, ...]]) -> list[int]:
    return [frames[0].line for frames in seen]


@steppable
def test_each_step_is_a_statement_or_an_iteration(make: Make) -> None:
    seen = frames_while(make(read(PROGRAM)), ExecutionControl.step, ExecutionControl.step)

    assert lines(seen) == [1, 2, 6, 7, 3, 4, 8, 6, 7, 3, 4, 8, 6, 10]


@steppable
def test_a_step_over_a_call_holds_after_it(make: Make) -> None:
    seen = frames_while(make(read(PROGRAM)), ExecutionControl.step, ExecutionControl.step_over)

    assert lines(seen) == [1, 2, 6, 7, 8, 6, 7, 8, 6, 10]


@steppable
def test_a_program_runs_to_a_line(make: Make) -> None:
    def to_line_4(control: ExecutionControl) -> None:
        control.run_to(4)

    assert lines(frames_while(make(read(PROGRAM)), to_line_4, to_line_4)) == [4, 4]


@steppable
def test_a_paused_program_shows_its_calls_and_variables(make: Make) -> None:
    def to_line_4(control: ExecutionControl) -> None:
        control.run_to(4)

    seen = frames_while(make(read(PROGRAM)), to_line_4, to_line_4)

    assert seen[1] == (Frame("P", 4, (("n", 2), ("b", 2))), Frame("", 7, (("a", 2),)))


@steppable
def test_the_frames_of_deep_loops_are_one_frame(make: Make) -> None:
    loops = "".join(f"FOR VAR i{n} = 0; i{n} < 1; i{n} = i{n} + 1 DO\n" for n in range(40))
    source = f"VAR a\n{loops} a = 5\nSPEAK a {'END FOR ' * 40}"

    def to_line_43(control: ExecutionControl) -> None:
        control.run_to(43)

    (frames,) = frames_while(make(read(source)), to_line_43, ExecutionControl.resume)

    assert [frame.line for frame in frames] == [43]
    assert dict(frames[0].variables) == {"a": 5, **{f"i{n}": 0 for n in range(40)}}


@pytest.mark.parametrize("make", [hooked, interpreted_program, fast])
def test_a_deep_recursion_shows_the_innermost_frames_and_the_program(make: Make) -> None:
    program = make(
        read("PROCEDURE P: n DO\nIF n == 0 THEN\nSPEAK n\nELSE\nP [n - 1]\nEND IF\nEND PROCEDURE\nP [500]")
    )
    seen: list[tuple[Frame, ...]] = []
    actions = Recorder(before=lambda name: seen.append(program.frames()))
    program.run(actions, ExecutionControl(), Memory())

    assert len(seen[0]) == 100
    assert seen[0][0] == Frame("P", 3, (("n", 0),))
    assert seen[0][98] == Frame("P", 5, (("n", 98),))
    assert seen[0][99] == Frame("", 8, ())


@pytest.mark.parametrize("make", [hooked, interpreted_program, fast])
def test_a_program_that_does_not_run_has_no_frames(make: Make) -> None:
    program = make(read("SPEAK 1"))
    before = program.frames()
    program.run(Recorder(), ExecutionControl(), Memory())

    assert before == program.frames() == ()


@steppable
def test_a_trace_receives_every_statement_with_its_place_and_depth(make: Make) -> None:
    traced: list[tuple[int, int, int]] = []
    make(read("VAR a\nPROCEDURE P DO SPEAK 1 END PROCEDURE\n  P [] REPEAT 1 TIMES END REPEAT")).run(
        Recorder(), ExecutionControl(), Memory(), trace=lambda *place: traced.append(place)
    )

    assert traced == [(1, 1, 0), (2, 1, 0), (3, 3, 0), (2, 16, 1), (3, 8, 0), (3, 8, 0)]


def test_a_program_without_hooks_can_not_be_traced() -> None:
    program = compile_program(read("SPEAK 1"), hooked=False)

    with pytest.raises(ValueError, match=r"^only a program that was compiled with hooks can be traced$"):
        program.run(Recorder(), ExecutionControl(), Memory(), trace=lambda *_: None)


@steppable
def test_a_traced_program_can_be_stepped(make: Make) -> None:
    control = ExecutionControl()
    traced: list[int] = []
    paused: list[int] = []

    def step(state: ControlState) -> None:
        if state is ControlState.PAUSED:
            paused.append(len(traced))
            control.step_over()

    control.observe(step)
    control.step()
    make(read(PROGRAM)).run(Recorder(), control, Memory(), trace=lambda line, *_: traced.append(line))

    assert traced == [1, 2, 6, 7, 3, 4, 8, 6, 7, 3, 4, 8, 6, 10]
    assert paused == [0, 1, 2, 3, 6, 7, 8, 11, 12, 13]


def test_only_a_hooked_program_can_be_traced() -> None:
    with pytest.raises(ValueError, match="hooks"):
        compile_program(read("SPEAK 1")).run(Recorder(), ExecutionControl(), Memory(), trace=lambda *_: None)


def test_a_program_without_hooks_is_held_at_its_next_checkpoint() -> None:
    program = fast(read("VAR a\nVAR b\nREPEAT 3 TIMES\na = a + 1\nEND REPEAT\nSPEAK a"))
    seen = frames_while(program, ExecutionControl.pause, ExecutionControl.step)

    assert lines(seen) == [1, 3, 3, 3, 6]
    assert [dict(frames[0].variables).get("a") for frames in seen] == [None, 1, 2, 3, 3]


@steppable
def test_a_stop_while_paused_stops(make: Make) -> None:
    control, memory = ExecutionControl(), Memory()
    control.observe(lambda state: control.stop() if state is ControlState.PAUSED else None)
    control.run_to(3)

    with pytest.raises(Stopped):
        make(read("VAR a = 1\na = 2\na = 3")).run(Recorder(), control, memory)

    assert memory.variables == {"a": 2}


@pytest.mark.parametrize("make", [hooked, interpreted_program, fast])
def test_another_thread_can_read_the_frames_of_a_running_program(make: Make) -> None:
    begun = threading.Event()
    program = make(
        read(
            "PROCEDURE P: n DO\nSPEAK n\nWHILE 1 == 1 DO\nn = n + 1\nEND WHILE\nEND PROCEDURE\n"
            "VAR a = 7 P [5]"
        )
    )
    control = ExecutionControl()

    def run() -> None:
        with pytest.raises(Stopped):
            program.run(Recorder(before=lambda name: begun.set()), control, Memory())

    thread = threading.Thread(target=run)
    thread.start()
    assert begun.wait(TIMEOUT)
    looks = [program.frames() for _ in range(50)]
    control.stop()
    thread.join(TIMEOUT)

    assert not thread.is_alive()
    assert {frames[0].procedure for frames in looks} == {"P"}
    assert {frames[0].line for frames in looks} <= {2, 3, 4}
    assert {frames[-1] for frames in looks} == {Frame("", 7, (("a", 7),))}


@steppable
def test_a_running_program_holds_at_each_of_its_breakpoints(make: Make) -> None:
    def break_at_4_and_10(control: ExecutionControl) -> None:
        control.break_at(frozenset({4, 10}))

    assert lines(frames_while(make(read(PROGRAM)), break_at_4_and_10, ExecutionControl.resume)) == [4, 4, 10]


@steppable
def test_a_breakpoint_that_is_set_during_a_run_holds_it(make: Make) -> None:
    control, held = ExecutionControl(), []

    def on_state(state: ControlState) -> None:
        if state is ControlState.PAUSED:
            held.append(control.held_at)
            control.resume()

    control.observe(on_state)
    recorder = Recorder(before=lambda _: control.break_at(frozenset({3})))
    make(read("SPEAK 1\nSPEAK 2\nSPEAK 3\nSPEAK 4")).run(recorder, control, Memory())

    assert held == [(3, 1)]


@steppable
def test_breakpoints_also_hold_on_the_way_to_a_line_and_in_a_step_over(make: Make) -> None:
    def begin(control: ExecutionControl) -> None:
        control.break_at(frozenset({4}))
        control.run_to(7)

    assert lines(frames_while(make(read(PROGRAM)), begin, ExecutionControl.step_over)) == [
        *(7, 4, 8, 6, 7, 4, 8, 6, 10)
    ]


def test_on_the_way_to_a_line_the_control_is_called_at_that_line_only() -> None:
    """So it runs as fast as without a request."""
    control = CountingControl()
    control.run_to(10)
    control.observe(lambda state: control.resume() if state is ControlState.PAUSED else None)

    hooked(read(PROGRAM)).run(Recorder(), control, Memory())

    assert set(control.lines) == {10}


class CountingControl(ExecutionControl):
    """Keeps the lines at which it was called."""

    def __init__(self) -> None:
        super().__init__()
        self.lines: list[int] = []

    def reached(self, line: int, depth: int, column: int = 0) -> None:
        self.lines.append(line)
        super().reached(line, depth, column)


@steppable
def test_the_place_of_a_hold_has_its_column(make: Make) -> None:
    held = []

    def note(control: ExecutionControl) -> None:
        held.append(control.held_at)
        control.step()

    frames_while(make(read("FW 1 TR 90\nFW 2")), ExecutionControl.step, note)

    assert held == [(1, 1), (1, 6), (2, 1)]


@steppable
def test_a_look_that_begins_in_a_pause_is_called_before_each_statement_from_there(make: Make) -> None:
    """And not after its end."""
    program, looks = make(read("SPEAK 1\nSPEAK 2\nSPEAK 3\nSPEAK 4\nSPEAK 5")), list[int]()
    control = ExecutionControl()

    def look() -> None:
        looks.append(program.frames()[0].line)
        if looks[-1] == 4:
            control.look_before_each(None)

    def on_state(state: ControlState) -> None:
        if state is ControlState.PAUSED:
            control.look_before_each(look)
            control.resume()

    control.observe(on_state)
    control.run_to(2)
    program.run(Recorder(), control, Memory())

    assert looks == [2, 3, 4]


def places_of(text: str, most: int = 1000) -> list[object]:
    """Where the program is before each statement, until it has been there ``most`` times."""
    program, control = hooked(read(text)), ExecutionControl()
    found: list[object] = []

    def look() -> None:
        found.append(program.progress())
        if len(found) == most:
            control.stop()

    control.look_before_each(look)
    with suppress(Stopped):
        program.run(Recorder(), control, Memory())
    return found


@pytest.mark.parametrize(
    "text",
    [
        "REPEAT 3 TIMES\nREPEAT 4 TIMES\nTR 360\nEND REPEAT\nTR 360\nEND REPEAT",
        "VAR n = 5\nREPEAT 2 TIMES\nREPEAT n TIMES\nVAR k = n\nn = 2\nEND REPEAT\nTR 360\nEND REPEAT",
        "PROCEDURE P: n DO\nREPEAT n TIMES\nTR 360\nEND REPEAT\nEND PROCEDURE\nP [2]\nP [3]\nP [2]",
        "PROCEDURE P: n DO\nREPEAT 2 TIMES\nIF n > 0 THEN\nP [n - 1]\nEND IF\n"
        "END REPEAT\nEND PROCEDURE\nP [2]",
        "FOR VAR i = 0; i < 4; i = i + 1 DO\nTR 360\nEND FOR",
        "FOR VAR i = 4; i > 0; i = i - 1 DO\nREPEAT i TIMES\nTR 360\nEND REPEAT\nEND FOR",
        "VAR n = 3\nWHILE n > 0 DO\nTR 360\nn = n - 1\nEND WHILE",
    ],
)
def test_a_program_with_an_end_is_never_in_the_same_place_again(text: str) -> None:
    found = places_of(text)

    assert 5 < len(found) < 1000
    assert len(set(found)) == len(found)


@pytest.mark.parametrize(
    ("text", "round_"),
    [
        ("WHILE 1 == 1 DO\nTR 1\nEND WHILE", 2),
        ("WHILE 1 == 1 DO\nREPEAT 3 TIMES\nTR 1\nEND REPEAT\nEND WHILE", 8),
        ("PROCEDURE P DO\nTR 1\nEND PROCEDURE\nWHILE 1 == 1 DO\nP []\nEND WHILE", 3),
    ],
)
def test_a_program_without_an_end_comes_to_the_same_place_after_a_round(text: str, round_: int) -> None:
    """``round_``: the statements and iterations of one."""
    found = places_of(text, most=60)

    assert found[10 : 60 - round_] == found[10 + round_ :]
    assert len(set(found[10:])) == round_


def test_a_program_that_counts_without_end_never_comes_to_the_same_place() -> None:
    found = places_of("VAR n = 0\nWHILE 1 == 1 DO\nn = n + 1\nEND WHILE")

    assert len(set(found)) == len(found) == 1000
