"""A stop ends the program at any place; its effects stay."""

from __future__ import annotations

import threading
import traceback
from types import TracebackType

import pytest

from language.call_stack import Activation, StackReader
from language.control import ControlState, ExecutionControl
from language.diagnostics import LanguageError, Stopped
from language.runtime import Memory
from tests.timeouts import TIMEOUT
from tests.unit.language_back.recorder import BACK_ENDS, Make, Recorder, fast, hooked, read, run

back_ends = pytest.mark.parametrize("make", BACK_ENDS.values(), ids=BACK_ENDS.keys())

ENDLESS = {
    "empty loop": "WHILE 1 == 1 DO END WHILE",
    "loop": "VAR a WHILE a >= 0 DO a = a + 1 END WHILE",
    "counted loop": "FOR VAR i = 0; i < 99999999999999; i = i + 1 DO END FOR",
    "repeat": f"REPEAT {'9' * 4000} TIMES END REPEAT",
    "for with a product": "FOR VAR i = 1; i > 0; i = i * 1 DO END FOR",
    "calls without loops": "PROCEDURE P: n DO IF n > 0 THEN P [n - 1] P [n - 1] END IF END PROCEDURE P [60]",
    "deep recursion": "PROCEDURE P: n DO IF n > 0 THEN P [n - 1] ELSE WHILE 1 == 1 DO END WHILE END IF "
    "END PROCEDURE P [15000]",
    "huge numbers": f"VAR a = {'9' * 4300} VAR b WHILE 1 == 1 DO b = a / 7 * 7 / 3 - a + a END WHILE",
    "deep loops": "REPEAT 1 TIMES " * 40 + "WHILE 1 == 1 DO END WHILE" + " END REPEAT" * 40,
}


@back_ends
@pytest.mark.parametrize("endless", ENDLESS.values(), ids=ENDLESS.keys())
def test_a_stop_ends_an_endless_program(make: Make, endless: str) -> None:
    begun, control, memory = threading.Event(), ExecutionControl(), Memory()
    program = make(read(f"VAR kept = 3 SPEAK 1 {endless}"))
    errors: list[type[LanguageError]] = []

    def run_program() -> None:
        try:
            program.run(Recorder(before=lambda name: begun.set()), control, memory)
        except LanguageError as error:
            errors.append(type(error))

    thread = threading.Thread(target=run_program, daemon=True)
    thread.start()
    assert begun.wait(TIMEOUT)
    control.stop()
    thread.join(TIMEOUT)

    assert not thread.is_alive()
    assert errors == [Stopped]
    assert memory.variables["kept"] == 3
    assert "i" not in memory.variables


DEEP = "PROCEDURE P: n DO IF n > 0 THEN P [n - 1] ELSE SPEAK n END IF END PROCEDURE P [9000] SPEAK 7"
DEEP_LOOPS = (
    f"PROCEDURE P: n DO {'REPEAT 1 TIMES ' * 40} SPEAK n {'END REPEAT ' * 40} END PROCEDURE P [0] SPEAK 7"
)


@pytest.mark.parametrize("source", [DEEP, DEEP_LOOPS], ids=["calls", "loops"])
@pytest.mark.parametrize("make", [fast, hooked], ids=["fast", "hooked"])
def test_a_stop_leaves_open_calls_without_an_exception_in_each(
    make: Make, source: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """That would take many times as long."""
    seen: list[int] = []

    def outermost(reader: StackReader, raised: TracebackType | None) -> list[Activation]:
        seen.append(len(list(traceback.walk_tb(raised))))
        return reader.of_traceback(raised)

    monkeypatch.setattr(StackReader, "outermost", outermost)
    control = ExecutionControl()
    recorder = Recorder(before=lambda _: control.stop())

    with pytest.raises(Stopped):
        make(read(source)).run(recorder, control, Memory())

    assert seen == [3], "the run, the program, and what ends it"
    assert recorder.done == [("speak", 0)]


@back_ends
@pytest.mark.parametrize("command", ["FW 5", "BW 5", "TR 5", "TL 5", "WAIT 5", "SPEAK 5", "SCAN"])
@pytest.mark.parametrize("after", ["", " SPEAK 2"])
def test_after_an_interrupted_command_no_other_runs(make: Make, command: str, after: str) -> None:
    control = ExecutionControl()
    actions = Recorder(before=lambda name: control.stop())
    outcome = run(f"VAR a = 1 {command}{after}", make, actions=actions, control=control)

    assert isinstance(outcome.error, Stopped)
    assert len(actions.done) == 1
    assert outcome.variables == {"a": 1}


@back_ends
def test_a_stop_before_the_start_runs_nothing(make: Make) -> None:
    control = ExecutionControl()
    control.stop()
    outcome = run("VAR a SPEAK a", make, control=control)

    assert isinstance(outcome.error, Stopped)
    assert outcome.actions.done == []


@back_ends
@pytest.mark.parametrize("source", ["SPEAK 1", "SPEAK 1 / 0", "SPEAK none"])
def test_the_control_is_ended_however_the_program_ends(make: Make, source: str) -> None:
    control = ExecutionControl()
    run(source, make, control=control)

    assert control.state is ControlState.ENDED


@back_ends
@pytest.mark.parametrize(
    "error", [KeyError, NameError, ZeroDivisionError, IndexError, RecursionError, MemoryError]
)
@pytest.mark.parametrize("source", ["SPEAK 1", "b = DISTANCE F", "PROCEDURE P DO FW 1 END PROCEDURE P []"])
def test_the_exception_of_an_action_passes_unchanged(make: Make, error: type[Exception], source: str) -> None:
    raised = error("the robot's own")
    control, memory = ExecutionControl(), Memory()

    def fail(name: str) -> None:
        raise raised

    with pytest.raises(error) as caught:
        make(read(f"VAR a = 4 VAR b {source}")).run(Recorder(before=fail), control, memory)

    assert caught.value is raised
    assert memory.variables == {"a": 4, "b": 0}
    assert control.state is ControlState.ENDED


@back_ends
def test_the_memory_is_updated_before_the_end_is_reported(make: Make) -> None:
    """The variables are a new dict, so that another thread never sees half of them."""
    memory = Memory(variables={"old": 1})
    before = memory.variables
    run("VAR a = 1 a = a / 0", make, terminal=True, memory=memory)

    assert memory.variables == {"old": 1, "a": 1}
    assert before == {"old": 1}


@back_ends
def test_a_program_can_run_again(make: Make) -> None:
    program = make(read("VAR a = 1 PROCEDURE P DO END PROCEDURE P [] SPEAK a"))
    actions = Recorder()
    program.run(actions, ExecutionControl(), Memory())
    program.run(actions, ExecutionControl(), Memory())

    assert actions.said == [1, 1]
