"""The control of a running program: pauses, steps, stops and sleeps."""

from __future__ import annotations

import threading
from collections.abc import Callable

import pytest

from language.control import ControlState, ExecutionControl
from language.diagnostics import Stopped
from tests.timeouts import TIMEOUT


class Clock:
    """A clock that the test sets."""

    def __init__(self) -> None:
        self.now = 0.0

    def __call__(self) -> float:
        return self.now


class Sleeper:
    """A program's thread in a long sleep."""

    def __init__(self, control: ExecutionControl, seconds: float = 1000.0) -> None:
        self.control = control
        self.slept: list[bool] = []
        self._seconds = seconds
        self._thread = threading.Thread(target=self._run, daemon=True)
        self._thread.start()

    def _run(self) -> None:
        self.slept.append(self.control.sleep(self._seconds))

    def is_over(self) -> bool:
        self._thread.join(TIMEOUT)
        return not self._thread.is_alive()


def when_in(control: ExecutionControl, state: ControlState) -> threading.Event:
    """An event that is set once the control becomes PAUSED, or leaves that state for this one."""
    reached = threading.Event()
    control.observe(lambda new: reached.set() if new is state else None)
    return reached


def test_a_sleep_that_ends_in_time_returns_true() -> None:
    control = ExecutionControl()

    assert control.sleep(0)
    assert control.sleep(-5)
    assert control.sleep(0.001)


def test_a_stop_ends_a_sleep() -> None:
    control = ExecutionControl()
    sleeper = Sleeper(control)

    control.stop()

    assert sleeper.is_over()
    assert sleeper.slept == [False]


def test_after_a_stop_no_sleep_and_no_statement_begins() -> None:
    control = ExecutionControl()
    control.stop()
    control.resume()
    control.step()

    assert control.state is ControlState.STOPPING
    assert not control.sleep(1000)
    with pytest.raises(Stopped):
        control.reached(1, 0)


def test_a_pause_holds_a_sleep_and_a_stop_ends_the_pause() -> None:
    control = ExecutionControl()
    paused = when_in(control, ControlState.PAUSED)
    sleeper = Sleeper(control)

    control.pause()
    assert paused.wait(TIMEOUT)
    control.stop()

    assert sleeper.is_over()
    assert sleeper.slept == [False]


def test_the_time_of_a_pause_does_not_count() -> None:
    clock = Clock()
    control = ExecutionControl(clock)
    paused, resumed = when_in(control, ControlState.PAUSED), when_in(control, ControlState.RUNNING)
    sleeper = Sleeper(control, 100.0)
    control.pause()
    assert paused.wait(TIMEOUT)

    clock.now += 1_000_000
    control.resume()
    assert resumed.wait(TIMEOUT)
    control.stop()

    assert sleeper.is_over()
    assert sleeper.slept == [False]


@pytest.mark.parametrize("seconds", [10**400, float("inf"), 1e300])
def test_a_sleep_may_be_longer_than_any_clock(seconds: float) -> None:
    control = ExecutionControl()
    sleeper = Sleeper(control, seconds)

    control.stop()

    assert sleeper.is_over()


def test_a_step_lets_a_held_sleep_end() -> None:
    control = ExecutionControl()
    control.observe(lambda state: control.step() if state is ControlState.PAUSED else None)
    control.pause()

    assert control.sleep(0)
    assert control.state is ControlState.STEPPING


def held_at(
    control: ExecutionControl, then: Callable[[], None], *places: tuple[int, int]
) -> list[tuple[int, int]]:
    """The places at which a program is held, among those that it reaches; calls ``then`` each time."""
    held: list[tuple[int, int]] = []
    current = places[0]

    def on_state(state: ControlState) -> None:
        if state is ControlState.PAUSED:
            held.append(current)
            then()

    end = control.observe(on_state)
    for current in places:
        control.reached(*current)
    end()
    return held


def test_stepping_holds_at_every_statement() -> None:
    control = ExecutionControl()
    control.step()

    assert held_at(control, control.step, (1, 0), (2, 1), (3, 1), (4, 0)) == [(1, 0), (2, 1), (3, 1), (4, 0)]


def test_stepping_over_holds_where_no_more_calls_are_open() -> None:
    control = ExecutionControl()
    control.step()

    assert held_at(control, control.step_over, (1, 1), (2, 2), (3, 3), (4, 1), (5, 0)) == [
        (1, 1),
        (4, 1),
        (5, 0),
    ]


def test_stepping_over_twice_does_not_hold_inside_the_call() -> None:
    control = ExecutionControl()
    control.step()
    held = held_at(control, control.step_over, (1, 1))
    control.step_over()

    assert held_at(control, control.resume, (2, 2), (3, 1)) == [(3, 1)]
    assert held == [(1, 1)]


def test_stepping_over_out_of_a_running_program_is_a_step() -> None:
    control = ExecutionControl()
    control.step_over()

    assert held_at(control, control.resume, (7, 5), (8, 0)) == [(7, 5)]


def test_running_to_a_line_holds_there_each_time() -> None:
    control = ExecutionControl()
    control.run_to(3)

    assert held_at(control, lambda: control.run_to(3), (1, 0), (3, 0), (2, 0), (3, 2)) == [(3, 0), (3, 2)]


def test_a_resumed_program_is_not_held() -> None:
    control = ExecutionControl()
    control.pause()

    assert held_at(control, control.resume, (1, 0), (2, 0), (3, 0)) == [(1, 0)]


def test_a_pause_that_is_cancelled_in_time_holds_nothing() -> None:
    control = ExecutionControl()
    control.pause()
    control.resume()

    assert held_at(control, control.resume, (1, 0)) == []


def test_observers_are_notified_of_pauses_only_until_they_end_it() -> None:
    control = ExecutionControl()
    observed: list[ControlState] = []
    end = control.observe(observed.append)
    control.observe(lambda state: control.resume() if state is ControlState.PAUSED else None)
    control.pause()
    control.reached(1, 0)
    end()
    control.pause()
    control.reached(2, 0)
    control.stop()

    assert observed == [ControlState.PAUSED, ControlState.RUNNING]


def test_an_observer_may_make_any_request() -> None:
    control = ExecutionControl()
    control.observe(lambda state: control.stop())
    control.pause()

    with pytest.raises(Stopped):
        control.reached(1, 0)


def test_an_ended_control_does_nothing_any_more() -> None:
    control = ExecutionControl()
    control.ended()
    for request in (control.pause, control.step, control.stop, control.resume):
        request()

    assert control.state is ControlState.ENDED
    assert not control.sleep(1000)


class OneLook(ExecutionControl):
    """Its look disappears when it is first read, as if another thread removed it."""

    _kept: Callable[[], None] | None = None

    @property
    def _look(self) -> Callable[[], None] | None:
        kept, self._kept = self._kept, None
        return kept

    @_look.setter
    def _look(self, look: Callable[[], None] | None) -> None:
        self._kept = look


def test_another_thread_may_end_the_looks_at_any_time() -> None:
    control, looks = OneLook(), list[None]()
    control.look_before_each(lambda: looks.append(None))

    control.reached(1, 0)
    control.reached(2, 0)

    assert len(looks) == 1


def test_the_runtime_is_called_with_the_state_at_every_change_until_it_is_detached() -> None:
    control, states = ExecutionControl(), list[ControlState]()
    control.attach(states.append)
    control.pause()
    control.break_at(frozenset({2}))
    control.look_before_each(lambda: None)
    control.attach(None)
    control.resume()
    control.break_at(frozenset())
    control.look_before_each(None)

    assert states == [ControlState.RUNNING, *[ControlState.PAUSING] * 3]


def test_a_new_control_lets_its_program_run() -> None:
    control = ExecutionControl()

    assert control.state is ControlState.RUNNING
    assert control.held_at == (0, 0)
    assert control.holds_to_depth() == float("inf")
    assert held_at(control, control.resume, (0, 0), (1, 0)) == []


def test_the_lines_that_hold_are_the_breakpoints_and_on_the_way_to_a_line_that_line() -> None:
    control = ExecutionControl()
    assert control.holds_on_lines() == frozenset()

    control.break_at(frozenset({4}))
    control.run_to(7)
    assert control.holds_on_lines() == {4, 7}

    control.resume()
    assert control.holds_on_lines() == {4}


def test_looks_are_wanted_from_one_request_to_the_next() -> None:
    control = ExecutionControl()
    assert not control.looks_before_each

    control.look_before_each(lambda: None)
    assert control.looks_before_each

    control.look_before_each(None)
    assert not control.looks_before_each


@pytest.mark.parametrize(
    ("request_", "line", "depth", "is_held"),
    [
        ("resume", 3, 0, False),
        ("resume", 4, 9, True),
        ("pause", 3, 9, True),
        ("step", 3, 9, True),
        ("step_over", 3, 2, True),
        ("step_over", 3, 3, False),
        ("step_over", 4, 3, True),
        ("run_to_5", 5, 9, True),
        ("run_to_5", 4, 9, True),
        ("run_to_5", 3, 0, False),
    ],
)
def test_a_program_holds_where_the_last_request_says_and_at_its_breakpoints(
    request_: str, line: int, depth: int, is_held: bool
) -> None:
    """Line 4 has a breakpoint; it was held inside two calls before."""
    control = ExecutionControl()
    control.pause()
    held_at(control, control.resume, (1, 2))
    control.break_at(frozenset({4}))
    control.pause()
    requests = {
        "resume": control.resume,
        "pause": lambda: (control.resume(), control.pause()),
        "step": control.step,
        "step_over": control.step_over,
        "run_to_5": lambda: control.run_to(5),
    }
    held_at(control, lambda: requests[request_](), (2, 2))
    places: list[tuple[int, int]] = []

    def resume(state: ControlState) -> None:
        if state is ControlState.PAUSED:
            places.append(control.held_at)
            control.resume()

    control.observe(resume)
    control.reached(line, depth, 8)

    assert places == ([(line, 8)] if is_held else [])


def test_a_hold_in_a_sleep_has_no_place_and_a_step_over_holds_at_any_depth_then() -> None:
    control, held = ExecutionControl(), list[tuple[int, int]]()
    control.step()
    held_at(control, control.resume, (3, 1))
    assert control.held_at == (3, 0)

    def step_over(state: ControlState) -> None:
        if state is ControlState.PAUSED:
            held.append(control.held_at)
            control.step_over()

    end = control.observe(step_over)
    control.pause()
    assert control.sleep(0)
    end()

    assert held == [(0, 0)]
    assert control.holds_to_depth() == float("inf")
    assert held_at(control, control.resume, (5, 40)) == [(5, 40)]


def test_a_step_over_holds_to_the_depth_of_the_last_hold_only_from_there() -> None:
    control = ExecutionControl()
    control.step()
    held_at(control, control.step_over, (3, 2))
    assert control.holds_to_depth() == 2

    control.step_over()
    assert control.holds_to_depth() == 2

    control.resume()
    control.step_over()
    assert control.holds_to_depth() == float("inf")


def test_a_stopped_program_does_not_look_any_more() -> None:
    control, looks = ExecutionControl(), list[int]()
    control.look_before_each(lambda: looks.append(1))
    control.reached(1, 0)
    control.stop()

    with pytest.raises(Stopped):
        control.reached(2, 0)

    assert looks == [1]


class WaitingClock:
    """A clock that a wait of the control moves on; the test needs no time."""

    def __init__(self, control: ExecutionControl, monkeypatch: pytest.MonkeyPatch) -> None:
        self.now, self.waits = 0.0, list[float]()
        monkeypatch.setattr(control, "_clock", lambda: self.now)
        monkeypatch.setattr(control._changed, "wait", self._wait)

    def _wait(self, seconds: float) -> None:
        self.waits.append(seconds)
        self.now += seconds


def test_a_long_sleep_waits_an_hour_at_a_time_until_its_end(monkeypatch: pytest.MonkeyPatch) -> None:
    control = ExecutionControl()
    clock = WaitingClock(control, monkeypatch)

    assert control.sleep(9000)
    assert clock.waits == [3600, 3600, 1800]
