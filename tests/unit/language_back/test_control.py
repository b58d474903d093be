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
