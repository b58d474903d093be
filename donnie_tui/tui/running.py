"""What the screen asks of a running program: run, stop, pause, step, speed.

Rules: nothing here waits or touches a widget; every request is answered by the code of a sentence and its
values, or by None where the program itself will answer.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from enum import Enum

from devices.ports.values import Frozen, field
from donnie_tui.core import speeds
from donnie_tui.core.events import Answered, Event, Outcome, Read, RunEnded, Stamped
from donnie_tui.core.patience import LAST_WORDS
from donnie_tui.core.runner import Run
from donnie_tui.core.session import Busy, Session
from donnie_tui.core.stepped import Stepped
from donnie_tui.core.team import Team
from donnie_tui.core.timeline import Timeline
from donnie_tui.core.told_errors import told_hints
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


class Answer(Frozen):
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

    session: Session
    stepped: Stepped
    run: Run | None = None
    stopped_line: int = 0
    text: str = ""
    is_program: bool = False
    is_pausing: bool = False
    """Whether somebody asked it to hold."""

    def hear(self, event: Event) -> None:
        """In the program's thread."""
        self.stepped.hear(event)
        if isinstance(event, RunEnded) and event.outcome is Outcome.COMPLETED:
            for each in self.stepped.ended():
                self.session.hub.publish(Answered(each))

    def tell_hold(self, place: tuple[int, int]) -> None:
        """In the program's thread: where it is held, so that it is told behind all that came before."""
        frames = self.session.frames
        if frames and self.is_program:
            told = self.stepped.held(place, frames, was_paused=self.is_pausing)
            self.is_pausing = False
            for each in told or (self.stepped.line_of(frames[0]),):
                self.session.hub.publish(Answered(each))


class Running:
    """The programs of the robot that is talked to, one at a time; those of others go on by themselves.

    ``told`` hears, in any thread, that a pause began or ended; ``breakpoints`` are those of the editor,
    ``last_seq`` is the number of the last event.
    """

    def __init__(
        self,
        chosen: Callable[[], Session],
        told: Callable[[ControlState], None],
        watch: Watch,
        breakpoints: Callable[[], frozenset[int]],
        last_seq: Callable[[], int],
    ) -> None:
        self._chosen = chosen
        self._told = told
        self._watch = watch
        self._owns: dict[str, _Own] = {}
        self._breakpoints = breakpoints
        self._last_seq = last_seq

    @property
    def _session(self) -> Session:
        return self._chosen()

    @property
    def _own(self) -> _Own:
        own = self._owns.get(self._session.name)
        return own or self._owns.setdefault(self._session.name, self._new_own(self._session))

    def _new_own(self, session: Session, text: str = "", *, is_program: bool = False) -> _Own:
        own = _Own(session, Stepped(self._last_seq, session.wording), text=text, is_program=is_program)
        own.stepped.begin(session, text)
        return own

    @property
    def _run(self) -> Run | None:
        return self._own.run

    @property
    def is_program(self) -> bool:
        """Whether what runs, or ran last, is the text of the editor."""
        return self._own.is_program

    def adopt(self, runs: Mapping[str, Run], team: Team) -> None:
        """Programs that were started together, by the names of their robots."""
        for name, run in runs.items():
            own = self._new_own(team.session(name), team.given[name].text, is_program=True)
            own.run, self._owns[name] = run, own
            self._observe(own, run.control)

    def _observe(self, own: _Own, control: ExecutionControl) -> None:
        def told(state: ControlState) -> None:
            if state is ControlState.PAUSED:
                own.tell_hold(control.held_at)
            self._told(state)

        control.observe(told)

    def hear(self, stamped: Stamped) -> None:
        """What robots' sensors say, and that a program is done. In any thread."""
        if isinstance(stamped.event, Read | RunEnded):
            for own in tuple(self._owns.values()):
                if own.session.hub.robot == stamped.robot:
                    own.hear(stamped.event)

    def told_back(self, timeline: Timeline, *, is_now: bool) -> tuple[str, ...]:
        """One step back of the robot that is talked to; ``is_now``: the first one."""
        return self._own.stepped.back(timeline, is_now=is_now)

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

        own = self._new_own(self._session, text, is_program=program)

        def prepare(control: ExecutionControl) -> None:
            self._observe(own, control)
            if program:
                control.break_at(self._breakpoints())
            if begin:
                begin(control)

        try:
            own.run = self._session.start(
                text,
                name,
                fresh=program,
                terminal=not program,
                prepare=prepare,
                each_statement=self._watch.begin(self._session, fresh=program),
            )
        except Busy:
            return _BUSY
        self._owns[own.session.name] = own
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

    def take_hints(self) -> tuple[str, ...]:
        """What had no effect of what has run; told once."""
        text, self._own.text = self._own.text, ""
        return told_hints(text, self._session, self._session.wording)

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
        self._own.is_pausing = True
        self._run.control.pause()
        return None

    def go_on(self) -> Answer:
        if self._run is None:
            return _NOTHING_RUNS
        self._own.stepped.goes_on()
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
        self._own.stepped.goes_on()
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
