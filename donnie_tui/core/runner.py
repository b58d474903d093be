"""One run of one program, in a thread of its own.

Rules: a run begins with ``run_started`` and ends with ``run_ended`` whatever happens between them. The robot
is halted before ``run_ended`` is published. The thread that started the run waits for it only by ``wait``.
"""

from __future__ import annotations

import threading
from collections.abc import Callable, Hashable, Sequence
from typing import Protocol, TypeAlias, TypeGuard

from msgspec import Struct

from devices.ports.robot import Robot
from donnie_tui.core.events import INTERNAL, TYPED, Announced, Error, Outcome, RunEnded, RunStarted, Statement
from donnie_tui.core.hub import Hub
from donnie_tui.core.wording import Wording
from language import keywords
from language.control import ControlState, ExecutionControl
from language.diagnostics import MOST_MISTAKES, Diagnostic, MistakeKind, ProgramError, QuitRequested, Stopped
from language.runtime import Actions, Frame, Memory, Runnable

LAST_WORDS = 1.0
"""Seconds for a run to end after a stop or its last event. Milliseconds, unless its output is stuck."""

Readable: TypeAlias = Runnable | tuple[Diagnostic, ...]
"""The result of parsing a text: a program, or its mistakes of form."""


class TakesTurns(Protocol):
    """A robot that shares its world with others: from ``join`` to ``leave`` they act in a fixed order."""

    def join(self) -> None:
        """Called in the program's thread; returns when it is this robot's turn, or the run was stopped."""

    def leave(self) -> None: ...


def takes_turns(robot: object) -> TypeGuard[TakesTurns]:
    """Whether a robot acts in the order of a simulated world; a real one waits for no other."""
    return hasattr(robot, "join")


class RunRequest(Struct, frozen=True):
    """A text to be run: the whole program, or a part of it that continues where the robot stands."""

    text: str
    name: str = TYPED
    first_line: int = 1
    is_whole: bool = True
    """Whether it begins at the start of the world with nothing remembered."""
    breakpoints: frozenset[int] = frozenset()
    lines: Sequence[str] = ()
    """The lines of the whole program; if empty, the lines of ``text``."""


class Stage(Struct, frozen=True):
    """The objects that all runs of a session share."""

    robot: Robot
    memory: Memory
    hub: Hub
    actions: Actions
    wording: Wording
    has_begun: Callable[[], None]
    """Called after the first event."""
    about_to_end: Callable[[Outcome], None]
    """Called before the last event, so that this one stays the last."""


class Run:
    """A program that runs or has ended."""

    def __init__(
        self,
        stage: Stage,
        name: str,
        begin: Callable[[bool], RunStarted],
        read: Callable[[], Readable],
        source_lines: tuple[str, ...],
        *,
        control: ExecutionControl,
        first_line: int = 1,
        trace: bool = False,
    ) -> None:
        """``begin`` prepares the world, unless its argument says that the run was refused."""
        self.control = control
        self.name = name
        self.outcome: Outcome | None = None
        self._stage = stage
        self._begin = begin
        self._read = read
        self._program: Readable | None = None
        self._problem: Exception | None = None
        self._source_lines = source_lines
        self._first_line = first_line
        self._trace = trace
        self.has_turns = True
        """Whether it waits for its robot's turn; not where others drive the robot."""
        self._has_read = threading.Event()
        self._over = threading.Event()
        self.has_begun = False
        self.when_read: Callable[[], None] | None = None
        """Called in the program's thread once the text was parsed, before anything runs."""

    def start(self, then: Callable[[Run], None]) -> None:
        """Starts; ``then`` is called in the program's thread, before ``wait`` returns."""
        thread = threading.Thread(target=self._run, args=(then,), name=f"program {self.name}", daemon=True)
        thread.start()
        self.has_begun = True

    def wait(self, seconds: float | None = None) -> bool:
        """Waits for the end. False if it has not come in time."""
        return self._over.wait(seconds)

    def wait_until_read(self, seconds: float | None = None) -> bool:
        """Waits until ``was_refused`` is known. False if that has not come in time."""
        return self._has_read.wait(seconds)

    @property
    def is_over(self) -> bool:
        return self._over.is_set()

    @property
    def is_ending(self) -> bool:
        """Whether it was stopped, or has come to its end."""
        return self.control.state in (ControlState.STOPPING, ControlState.ENDED)

    @property
    def was_refused(self) -> bool:
        """Whether mistakes of form prevented the run; known once the text was parsed."""
        return isinstance(self._program, tuple)

    def frames(self) -> tuple[Frame, ...]:
        """The call stack, innermost first; empty when nothing runs."""
        program = self._program
        return () if self.is_over or program is None or isinstance(program, tuple) else program.frames()

    def progress(self) -> Hashable:
        """See ``Runnable.progress``."""
        assert self._program is not None and not isinstance(self._program, tuple)
        return self._program.progress()

    def _run(self, then: Callable[[Run], None]) -> None:
        try:
            self._read_first()
            self.outcome = self._run_in_turn()
        finally:
            try:
                then(self)
            finally:
                self._over.set()

    def _read_first(self) -> None:
        """Parses the text, which needs no turn. A failure is kept, and reported in the run's place."""
        try:
            self._program = self._read()
        except Exception as problem:  # noqa: BLE001 -- raised again where it is reported
            self._problem = problem
        finally:
            if self.when_read is not None:
                self.when_read()
            self._has_read.set()

    def _run_in_turn(self) -> Outcome:
        """Runs the program, and keeps the robot's turn from the first event to the last."""
        robot = self._stage.robot
        if not (self.has_turns and takes_turns(robot)):
            return self._publish_and_run()
        robot.join()
        try:
            return self._publish_and_run()
        finally:
            robot.leave()

    def _publish_and_run(self) -> Outcome:
        hub, robot = self._stage.hub, self._stage.robot
        started = self._begin(self.was_refused)
        began = robot.time()
        hub.hold_back_here()
        hub.publish(started)
        self._stage.has_begun()
        outcome = self._outcome()
        hub.stop_holding_back()
        robot.halt()
        seconds = robot.time() - began
        self._stage.about_to_end(outcome)
        variables = dict(sorted(self._stage.memory.variables.items()))
        hub.publish(RunEnded(outcome, robot.pose(), variables, seconds, robot.true_pose()))
        hub.wait_until_delivered()
        return outcome

    def _outcome(self) -> Outcome:
        try:
            if self._problem is not None:
                raise self._problem
            program = self._program
            assert program is not None
            if isinstance(program, tuple):
                self._publish_errors(program)
                return Outcome.FAILED
            trace = self._visit if self._trace else None
            program.run(self._stage.actions, self.control, self._stage.memory, trace=trace)
        except ProgramError as error:
            self._publish_error(error.diagnostic, tuple(call.line for call in error.calls))
            return Outcome.FAILED
        except Stopped:
            return Outcome.STOPPED
        except QuitRequested:
            return Outcome.QUIT
        except Exception:  # the learner must learn of every failure
            import logging  # slow to load, and never needed as long as all is well

            logging.getLogger(__name__).exception("the program's thread failed")
            self._publish_failure()
            return Outcome.FAILED
        return Outcome.COMPLETED

    def _visit(self, line: int, column: int, depth: int) -> None:
        self._stage.hub.publish(Statement(line, column, depth))

    def _publish_errors(self, mistakes: tuple[Diagnostic, ...]) -> None:
        for each in mistakes:
            self._publish_error(each)
        if len(mistakes) >= MOST_MISTAKES:
            sentence = self._stage.wording("more-mistakes", limit=MOST_MISTAKES)
            self._stage.hub.publish(Announced("more-mistakes", sentence))

    def _publish_error(self, diagnostic: Diagnostic, calls: tuple[int, ...] = ()) -> None:
        wording = self._stage.wording
        span, details = diagnostic.span, diagnostic.details
        has_opener = diagnostic.kind in (MistakeKind.SYNTAX, MistakeKind.WRONG_END)
        opener = str(details.get("opener", "")) if has_opener else ""
        self._stage.hub.publish(
            Error(
                diagnostic.kind.value,
                span.line,
                span.column,
                wording.mistake(diagnostic),
                wording.hint(diagnostic),
                self._source_line(span.line).strip(),
                calls,
                diagnostic.code,
                diagnostic.meant,
                opener or keywords.topic_at(self._source_line(span.line), span.column),
                int(details.get("line", 0)),
            )
        )

    def _publish_failure(self) -> None:
        """Publishes an internal error like a mistake, so that the learner knows why the program ended."""
        line = self._first_line  # no call is open any more
        sentence = self._stage.wording("internal-error")
        self._stage.hub.publish(Error(INTERNAL, line, 1, sentence, None, self._source_line(line).strip()))

    def _source_line(self, line: int) -> str:
        index = line - self._first_line
        return self._source_lines[index] if 0 <= index < len(self._source_lines) else ""
