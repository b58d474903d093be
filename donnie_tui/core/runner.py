"""One run of one program, in a thread of its own.

Rules: it begins with ``run_started`` and ends with ``run_ended`` whatever happens between them, and the
robot is halted before that is told. The thread that asked for the run never waits for it unless it wants to.
"""

from __future__ import annotations

import threading
from collections.abc import Callable

from devices.ports.hints import Protocol, TypeAlias, TypeGuard
from devices.ports.robot import Robot
from devices.ports.values import Frozen
from donnie_tui.core.events import INTERNAL, Announced, Error, Outcome, RunEnded, RunStarted, Statement
from donnie_tui.core.hub import Hub
from donnie_tui.core.wording import Wording
from language import keywords
from language.compiler import Runnable
from language.control import ExecutionControl
from language.diagnostics import MOST_MISTAKES, Diagnostic, Kind, ProgramError, QuitRequested, Stopped
from language.runtime import Actions, Frame, Memory

Readable: TypeAlias = Runnable | tuple[Diagnostic, ...]
"""A text once it was read: a program, or its mistakes of form."""


class TakesTurns(Protocol):
    """A robot that shares its world with others: from ``join`` to ``leave`` they act in a fixed order."""

    def join(self) -> None:
        """Called in the program's thread; returns when it is this robot's turn, or the run was stopped."""

    def leave(self) -> None: ...


def takes_turns(robot: object) -> TypeGuard[TakesTurns]:
    """Whether a robot acts in the order of a simulated world; a real one waits for nobody."""
    return hasattr(robot, "join")


class Stage(Frozen):
    """What every run of a session shares."""

    robot: Robot
    hub: Hub
    actions: Actions
    wording: Wording
    has_begun: Callable[[], None]
    """Told behind the first event."""
    about_to_end: Callable[[Outcome], None]
    """Told before the last event, so that this one stays the last."""


class Run:
    """A program on its way, or at its end."""

    def __init__(
        self,
        stage: Stage,
        name: str,
        begin: Callable[[bool], RunStarted],
        read: Callable[[], Readable],
        source_lines: tuple[str, ...],
        memory: Memory,
        *,
        control: ExecutionControl,
        first_line: int = 1,
        trace: bool = False,
    ) -> None:
        """``begin`` makes the world ready for it, unless it is told that the run was refused."""
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
        self._memory = memory
        self._trace = trace
        self._has_read = threading.Event()
        self._over = threading.Event()
        self.has_begun = False
        self.when_read: Callable[[], None] | None = None
        """Called in the program's thread once it was read, before anything of it runs."""

    def start(self, then: Callable[[Run], None]) -> None:
        """Begin; ``then`` is called in the program's thread, before ``wait`` returns."""
        thread = threading.Thread(target=self._run, args=(then,), name=f"program {self.name}", daemon=True)
        thread.start()
        self.has_begun = True

    def wait(self, seconds: float | None = None) -> bool:
        """Wait for the end. False if it has not come in time."""
        return self._over.wait(seconds)

    def wait_until_read(self, seconds: float | None = None) -> bool:
        """Wait until it is known whether it ``was_refused``. False if that has not come in time."""
        return self._has_read.wait(seconds)

    @property
    def is_over(self) -> bool:
        return self._over.is_set()

    @property
    def was_refused(self) -> bool:
        """Whether mistakes of form kept it from running; known once it has been read."""
        return isinstance(self._program, tuple)

    def frames(self) -> tuple[Frame, ...]:
        """The call stack, innermost first; empty when nothing runs."""
        program = self._program
        return () if self.is_over or program is None or isinstance(program, tuple) else program.frames()

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
        """Whatever other robots do: for that nobody needs a turn. What goes wrong is told in its place."""
        try:
            self._program = self._read()
        except Exception as problem:  # noqa: BLE001 -- raised again where it is told
            self._problem = problem
        finally:
            if self.when_read is not None:
                self.when_read()
            self._has_read.set()

    def _run_in_turn(self) -> Outcome:
        """From its first event to its last one the run is in its place among those of other robots."""
        robot = self._stage.robot
        if not takes_turns(robot):
            return self._tell_and_run()
        robot.join()
        try:
            return self._tell_and_run()
        finally:
            robot.leave()

    def _tell_and_run(self) -> Outcome:
        hub, robot = self._stage.hub, self._stage.robot
        started = self._begin(self.was_refused)
        began = robot.time()
        hub.hold_back_here()
        hub.publish(started)
        self._stage.has_begun()
        outcome = self._outcome()
        hub.hold_back_nobody()
        robot.halt()
        seconds = robot.time() - began
        self._stage.about_to_end(outcome)
        hub.publish(RunEnded(outcome, robot.pose(), dict(sorted(self._memory.variables.items())), seconds))
        hub.wait_until_heard()
        return outcome

    def _outcome(self) -> Outcome:
        try:
            return self._read_and_run()
        except ProgramError as error:
            self._publish_error(error.diagnostic, tuple(call.line for call in error.calls))
            return Outcome.FAILED
        except Stopped:
            return Outcome.STOPPED
        except QuitRequested:
            return Outcome.QUIT
        except Exception:  # whatever went wrong, the learner must hear of it
            import logging  # slow to load, and never needed as long as all is well

            logging.getLogger(__name__).exception("the program's thread failed")
            self._publish_failure()
            return Outcome.FAILED

    def _read_and_run(self) -> Outcome:
        if self._problem is not None:
            raise self._problem
        program = self._program
        assert program is not None
        if isinstance(program, tuple):
            self._publish_errors(program)
            return Outcome.FAILED
        trace = self._visit if self._trace else None
        program.run(self._stage.actions, self.control, self._memory, trace=trace)
        return Outcome.COMPLETED

    def _visit(self, line: int, column: int, depth: int) -> None:
        self._stage.hub.publish(Statement(line, column, depth))

    def _publish_errors(self, mistakes: tuple[Diagnostic, ...]) -> None:
        for each in mistakes:
            self._publish_error(each)
        if len(mistakes) >= MOST_MISTAKES:
            told = self._stage.wording("more-mistakes", limit=MOST_MISTAKES)
            self._stage.hub.publish(Announced("more-mistakes", told))

    def _publish_error(self, diagnostic: Diagnostic, calls: tuple[int, ...] = ()) -> None:
        wording = self._stage.wording
        span, details = diagnostic.span, diagnostic.details
        in_head = str(details.get("opener", "")) if diagnostic.kind is Kind.SYNTAX else ""
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
                in_head or keywords.topic_at(self._source_line(span.line), span.column),
                int(details.get("line", 0)),
            )
        )

    def _publish_failure(self) -> None:
        """Our own fault: told like a mistake, so that nobody waits in silence."""
        frames = self.frames()
        line = frames[0].line if frames else self._first_line
        told = self._stage.wording("internal-error")
        self._stage.hub.publish(Error(INTERNAL, line, 1, told, None, self._source_line(line).strip()))

    def _source_line(self, line: int) -> str:
        index = line - self._first_line
        return self._source_lines[index] if 0 <= index < len(self._source_lines) else ""
