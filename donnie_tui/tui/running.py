"""What the screen asks of a running program: run, stop, pause, step, speed.

Rules: nothing here waits or touches a widget; every request is answered by the code of a sentence and its
values, or by None where the program itself will answer.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from enum import Enum

from devices.ports.values import field, frozen
from donnie_tui.core import speeds
from donnie_tui.core.patience import LAST_WORDS
from donnie_tui.core.runner import Run
from donnie_tui.core.session import Busy, Session
from donnie_tui.core.watching import Watch
from donnie_tui.settings.readers import FASTEST, SLOWEST, read_speed
from language.control import ControlState, ExecutionControl
from language.runtime import Frame


class Doing(Enum):
    """What the program does, as the status line says it."""

    READY = "ready"
    RUNNING = "running"
    PAUSED = "paused"
    STOPPING = "stopping"


@frozen
class Answer:
    """A sentence to be told."""

    code: str
    values: Mapping[str, object] = field(default_factory=dict)
    of_robot: bool = False
    """It is about the robot that is talked to, whose name is told where there are several."""


_NOTHING_RUNS = Answer("answer-nothing-runs")
_BUSY = Answer("screen-busy")


@dataclass(slots=True)
class _Own:
    """What is known of one robot's programs."""

    run: Run | None = None
    stopped_line: int = 0
    is_program: bool = False


class Running:
    """The programs of the robot that is talked to, one at a time; those of others go on by themselves.

    ``told`` hears, in any thread, that a pause began or ended; ``breakpoints`` are those of the editor.
    """

    def __init__(
        self,
        chosen: Callable[[], Session],
        told: Callable[[ControlState], None],
        watch: Watch,
        breakpoints: Callable[[], frozenset[int]],
    ) -> None:
        self._chosen = chosen
        self._told = told
        self._watch = watch
        self._owns: dict[str, _Own] = {}
        self._breakpoints = breakpoints

    @property
    def _session(self) -> Session:
        return self._chosen()

    @property
    def _own(self) -> _Own:
        return self._owns.setdefault(self._session.name, _Own())

    @property
    def _run(self) -> Run | None:
        return self._own.run

    @property
    def is_program(self) -> bool:
        """Whether what runs, or ran last, is the text of the editor."""
        return self._own.is_program

    def adopt(self, runs: Mapping[str, Run]) -> None:
        """Programs that were started together, by the names of their robots."""
        for name, run in runs.items():
            self._owns[name] = _Own(run, is_program=True)
            run.control.observe(self._told)

    def look_again(self) -> None:
        """Another robot was chosen: its program may have ended while nobody looked."""
        if self._own.run is not None and self._own.run.is_over:
            self._own.run = None

    # --- what it does

    @property
    def doing(self) -> Doing:
        if self._run is None:
            return Doing.READY
        match self._run.control.state:
            case ControlState.PAUSED:
                return Doing.PAUSED
            case ControlState.STOPPING | ControlState.ENDED:
                return Doing.STOPPING
            case _:
                return Doing.RUNNING

    @property
    def is_busy(self) -> bool:
        """Whether something runs or holds."""
        return self._run is not None

    @property
    def frames(self) -> tuple[Frame, ...]:
        """The call stack, innermost first; empty when nothing runs."""
        return self._run.frames() if self._run else ()

    # --- beginning and ending

    def run(
        self, text: str, name: str, *, begin: Callable[[ExecutionControl], None] | None = None
    ) -> Answer | None:
        """Run the editor's program from the start of the world, with nothing remembered."""
        if not text.strip():
            return Answer("answer-nothing-to-run")
        return self._start(text, name, program=True, begin=begin)

    def command(self, text: str, name: str) -> Answer | None:
        """Run a typed command where the robot stands, with the variables that there are."""
        return self._start(text, name, program=False, begin=None)

    def _start(
        self, text: str, name: str, *, program: bool, begin: Callable[[ExecutionControl], None] | None
    ) -> Answer | None:
        if self._run is not None:
            return _BUSY

        def prepare(control: ExecutionControl) -> None:
            control.observe(self._told)
            if program:
                control.break_at(self._breakpoints())
            if begin:
                begin(control)

        try:
            run = self._session.start(
                text,
                name,
                fresh=program,
                terminal=not program,
                prepare=prepare,
                each_statement=self._watch.begin(self._session, fresh=program),
            )
        except Busy:
            return _BUSY
        self._owns[self._session.name] = _Own(run, is_program=program)
        return None

    def ended(self) -> bool:
        """The run has told its end; once this returns another one may start. Whether it had run at all."""
        run = self._run
        if run is not None and run.wait(LAST_WORDS):
            self._own.run = None
        return run is None or not run.was_refused

    def stop(self) -> Answer | None:
        if self._run is None:
            return _NOTHING_RUNS
        self.note_line()
        self._session.stop()
        return None

    def note_line(self) -> None:
        """Where a program is that is about to be stopped. Any thread."""
        if frames := self.frames:
            self._own.stopped_line = frames[0].line

    @property
    def stopped(self) -> Answer:
        """Where the program was when it was stopped."""
        line = self._own.stopped_line
        if not line:
            return Answer("answer-stopped", of_robot=True)
        return Answer("answer-stopped-at", {"line": line}, of_robot=True)

    def reset(self) -> Answer:
        try:
            self._session.reset()
        except Busy:
            return _BUSY
        return Answer("answer-reset", of_robot=True)

    # --- pausing and stepping

    def pause_or_continue(self) -> Answer | None:
        return self.go_on() if self.doing is Doing.PAUSED else self.pause()

    def pause(self) -> Answer | None:
        if self._run is None:
            return _NOTHING_RUNS
        self._run.control.pause()
        return None

    def go_on(self) -> Answer:
        if self._run is None:
            return _NOTHING_RUNS
        self._run.control.resume()
        return Answer("answer-continued")

    def step(self, text: str, name: str) -> Answer | None:
        """The next statement; the first one of the program where nothing runs."""
        if self._run is None:
            return self.run(text, name, begin=ExecutionControl.step)
        self._run.control.step()
        return None

    def step_over(self, text: str, name: str) -> Answer | None:
        """As ``step``, a procedure as a whole."""
        if self._run is None:
            return self.run(text, name, begin=ExecutionControl.step)
        self._run.control.step_over()
        return None

    def run_to(self, line: int, text: str, name: str) -> Answer | None:
        """Until that line of the program (from 1) is next."""
        if self._run is None:
            return self.run(text, name, begin=lambda control: control.run_to(line))
        self._run.control.run_to(line)
        return None

    def breakpoints_changed(self) -> None:
        """The program that runs holds before those that there are now."""
        if self._run is not None and self.is_program:
            self._run.control.break_at(self._breakpoints())

    # --- speed

    @property
    def speed(self) -> float | None:
        return self._session.speed

    def faster(self) -> None:
        self._session.speed = speeds.faster(self.speed)

    def slower(self) -> None:
        self._session.speed = speeds.slower(self.speed)

    def set_speed(self, typed: str) -> Answer | None:
        """The speed that somebody typed, or what is wrong with it."""
        try:
            self._session.speed = read_speed(typed)
        except ValueError:
            return Answer("screen-bad-speed", {"slowest": SLOWEST, "fastest": FASTEST})
        return None
