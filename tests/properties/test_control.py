"""The control keeps its rules for any requests, in any order, from any number of threads."""

from __future__ import annotations

import threading
from collections.abc import Callable

from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.stateful import (
    RuleBasedStateMachine,
    initialize,
    invariant,
    precondition,
    rule,
    run_state_machine_as_test,
)

from language.control import ControlState, ExecutionControl
from language.diagnostics import Stopped
from tests.effort import examples
from tests.timeouts import TIMEOUT

WILL_HOLD = {
    ControlState.PAUSING,
    ControlState.STEPPING,
    ControlState.STEPPING_OVER,
    ControlState.RUNNING_TO,
}
OVER = {ControlState.STOPPING, ControlState.ENDED}


class Program:
    """A thread that runs one order at a time and may be held in it."""

    def __init__(self) -> None:
        self._orders: list[Callable[[], object]] = []
        self._changed = threading.Condition()
        self._thread = threading.Thread(target=self._run, daemon=True)
        self.is_idle = True
        self.is_held = False
        self.stopped = False
        self._thread.start()

    def do(self, order: Callable[[], object]) -> None:
        with self._changed:
            self.is_idle = False
            self._orders.append(order)
            self._changed.notify_all()

    def _run(self) -> None:
        while True:
            with self._changed:
                self._changed.wait_for(lambda: self._orders)
                order = self._orders.pop()
            try:
                order()
            except Stopped:
                self.stopped = True
            with self._changed:
                self.is_idle = True
                self._changed.notify_all()

    def wait(self) -> None:
        """Wait until the program is idle or held."""
        with self._changed:
            assert self._changed.wait_for(lambda: self.is_idle or self.is_held, TIMEOUT)

    def on_state(self, state: ControlState) -> None:
        with self._changed:
            self.is_held = state is ControlState.PAUSED
            self._changed.notify_all()

    def becomes_idle(self) -> bool:
        with self._changed:
            return self._changed.wait_for(lambda: self.is_idle, TIMEOUT)


class ControlMachine(RuleBasedStateMachine):
    """One program, and every possible request. ``expected`` is the state by the rules."""

    @initialize()
    def begin(self) -> None:
        self.control = ExecutionControl()
        self.observed: list[ControlState] = []
        self.control.observe(self.observed.append)
        self.program = Program()
        self.control.observe(self.program.on_state)
        self.expected = ControlState.RUNNING
        self.line = 0
        self.over_depth = 0.0
        self.depth = float("inf")

    def requested(self, after: ControlState) -> None:
        """A request was made, and nothing else happened."""
        was_held = self.expected is ControlState.PAUSED
        if self.expected not in OVER:
            self.expected = after
        if was_held and self.expected is not ControlState.PAUSED:
            assert self.program.becomes_idle()

    @rule()
    def pause(self) -> None:
        self.control.pause()
        if self.expected is not ControlState.PAUSED:
            self.requested(ControlState.PAUSING)

    @rule()
    def resume(self) -> None:
        self.control.resume()
        self.requested(ControlState.RUNNING)

    @rule()
    def step(self) -> None:
        self.control.step()
        self.requested(ControlState.STEPPING)

    @rule()
    def step_over(self) -> None:
        if self.expected is ControlState.PAUSED:
            self.over_depth = self.depth
        elif self.expected is not ControlState.STEPPING_OVER:
            self.over_depth = float("inf")
        self.control.step_over()
        self.requested(ControlState.STEPPING_OVER)

    @rule(line=st.integers(1, 3))
    def run_to(self, line: int) -> None:
        self.control.run_to(line)
        self.line = line
        self.requested(ControlState.RUNNING_TO)

    @rule()
    def stop(self) -> None:
        self.control.stop()
        self.requested(ControlState.STOPPING)

    @precondition(lambda self: self.program.is_idle)
    @rule()
    def end(self) -> None:
        self.control.ended()
        self.expected = ControlState.ENDED

    @precondition(lambda self: self.program.is_idle)
    @rule(line=st.integers(1, 3), depth=st.integers(0, 3))
    def reach(self, line: int, depth: int) -> None:
        self.program.stopped = False
        self.program.do(lambda: self.control.reached(line, depth))
        self.program.wait()
        assert self.program.stopped == (self.expected is ControlState.STOPPING)
        if self.holds(line, depth):
            self.expected, self.depth = ControlState.PAUSED, depth

    @precondition(lambda self: self.program.is_idle)
    @rule()
    def sleep(self) -> None:
        answers: list[bool] = []
        self.program.do(lambda: answers.append(self.control.sleep(0)))
        self.program.wait()
        if self.expected is ControlState.PAUSING:
            self.expected, self.depth = ControlState.PAUSED, float("inf")
        else:
            assert answers == [self.expected not in OVER]

    def holds(self, line: int, depth: int) -> bool:
        match self.expected:
            case ControlState.STEPPING_OVER:
                return depth <= self.over_depth
            case ControlState.RUNNING_TO:
                return line == self.line
            case state:
                return state in WILL_HOLD

    @invariant()
    def the_state_follows_the_rules(self) -> None:
        assert self.control.state is self.expected

    @invariant()
    def the_program_is_held_exactly_while_it_is_paused(self) -> None:
        assert self.program.is_idle == (self.expected is not ControlState.PAUSED)

    @invariant()
    def observers_are_notified_of_each_pause_and_its_end(self) -> None:
        assert all(state is ControlState.PAUSED for state in self.observed[::2])
        assert all(state is not ControlState.PAUSED for state in self.observed[1::2])
        assert (len(self.observed) % 2 == 1) == (self.expected is ControlState.PAUSED)

    def teardown(self) -> None:
        self.control.stop()
        assert self.program.becomes_idle()


def test_requests_one_after_the_other_follow_the_rules() -> None:
    run_state_machine_as_test(
        ControlMachine, settings=settings(max_examples=examples(80), stateful_step_count=30)
    )


REQUESTS: list[Callable[[ExecutionControl], None]] = [
    ExecutionControl.pause,
    ExecutionControl.resume,
    ExecutionControl.step,
    ExecutionControl.step_over,
    lambda control: control.run_to(2),
]


@settings(max_examples=examples(60))
@given(st.lists(st.lists(st.sampled_from(REQUESTS), max_size=20), min_size=1, max_size=4))
def test_a_stop_ends_the_program_after_requests_from_many_threads(
    requests: list[list[Callable[[ExecutionControl], None]]],
) -> None:
    control, observed = ExecutionControl(), []
    control.observe(observed.append)

    def work() -> None:
        line = 0
        try:
            while control.sleep(0):
                line += 1
                control.reached(line % 3, line % 5)
        except Stopped:
            pass
        control.ended()

    threads = [
        threading.Thread(target=lambda each=each: [request(control) for request in each]) for each in requests
    ]
    program = threading.Thread(target=work)
    program.start()
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join(TIMEOUT)
    control.stop()
    program.join(TIMEOUT)

    assert not any(thread.is_alive() for thread in [*threads, program])
    assert control.state is ControlState.ENDED
    assert 2 * observed.count(ControlState.PAUSED) == len(observed)
