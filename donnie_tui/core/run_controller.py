"""The runs of a world's robots: starting, holding, stepping and stopping them, for every front end.

``TRANSITIONS`` says in which state a run takes which request. Requests come from a front end's thread and
never wait. Holds and ends come from the program's thread, which publishes their sentences, so that they stand
in order after all that the program said. A front end learns of them as a ``RunObserver`` and calls ``sum_up``
once a run is over.
"""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterable, Mapping, Sequence
from enum import Enum, auto
from functools import partial
from typing import TYPE_CHECKING, TypeAlias

from msgspec import Struct

from donnie_tui.core.events import (
    TRANSIENT,
    TYPED,
    Announced,
    Answered,
    Error,
    Outcome,
    Read,
    RunEnded,
    RunStarted,
    Spoke,
    Stamped,
)
from donnie_tui.core.runner import Run
from donnie_tui.core.session import Busy, Session
from donnie_tui.core.team import Assigned, Team
from donnie_tui.core.timeline import Chronicle
from donnie_tui.core.timeouts import LAST_WORDS
from donnie_tui.core.transcript import said_by
from donnie_tui.core.wording import Wording
from language.control import ControlState, ExecutionControl
from language.runtime import Frame
from language.source import fold_name

if TYPE_CHECKING:
    from donnie_tui.core.stepping import Stepping
    from donnie_tui.core.timeline import Timeline

MOST_HINTS = 3
LARGEST_HINTED = 50_000
"""Characters of a text that is searched for hints: the search must not keep the learner waiting."""
LONGEST_PAUSE = 1.0
"""Seconds that the answer to PAUSE waits for a program in the background."""
LONGEST_READING = 2.0
"""Seconds; most programs are read in a few thousandths."""


class RunState(Enum):
    """What the program of a robot does."""

    READY = "ready"
    """No program runs: one can be started."""
    RUNNING = "running"
    PAUSED = "paused"
    """The program is held between two statements, or within one that takes time."""
    STOPPING = "stopping"
    """The program was stopped or has ended, and was not summed up yet."""


class Request(Enum):
    """What can be asked of a run, and what its program does by itself."""

    START = auto()
    PAUSE = auto()
    CONTINUE = auto()
    STEP = auto()
    """To the next statement, also STEP OVER and RUN TO."""
    STEP_BACK = auto()
    STOP = auto()
    HOLD = auto()
    """The program holds: a pause, a step or a breakpoint was reached."""
    END = auto()
    """The program ends."""
    SUM_UP = auto()


_S, _R = RunState, Request
TRANSITIONS: dict[tuple[RunState, Request], RunState] = {
    (_S.READY, _R.START): _S.RUNNING,
    (_S.READY, _R.STEP_BACK): _S.READY,
    (_S.RUNNING, _R.PAUSE): _S.RUNNING,
    (_S.RUNNING, _R.CONTINUE): _S.RUNNING,
    (_S.RUNNING, _R.STEP): _S.RUNNING,
    (_S.RUNNING, _R.HOLD): _S.PAUSED,
    (_S.PAUSED, _R.PAUSE): _S.PAUSED,
    (_S.PAUSED, _R.CONTINUE): _S.RUNNING,
    (_S.PAUSED, _R.STEP): _S.RUNNING,
    (_S.PAUSED, _R.STEP_BACK): _S.PAUSED,
    **{(state, _R.STOP): _S.STOPPING for state in (_S.RUNNING, _S.PAUSED, _S.STOPPING)},
    **{(state, _R.END): _S.STOPPING for state in (_S.RUNNING, _S.STOPPING)},
    (_S.STOPPING, _R.PAUSE): _S.STOPPING,
    (_S.STOPPING, _R.CONTINUE): _S.STOPPING,
    (_S.STOPPING, _R.STEP): _S.STOPPING,
    (_S.STOPPING, _R.SUM_UP): _S.READY,
}
"""Where each request leads; one that is not listed is refused."""

_STATE_OF = {
    ControlState.PAUSED: RunState.PAUSED,
    ControlState.STOPPING: RunState.STOPPING,
    ControlState.ENDED: RunState.STOPPING,
}
"""Of a program's control; all other states are RUNNING."""


class NothingRuns(Exception):
    """The request needs a program that runs."""


class NothingToRun(Exception):
    """The program has no text."""


class Program(Struct, frozen=True):
    """A text to be run: the whole program, or a part of it that continues where the robot stands."""

    text: str
    name: str = TYPED
    first_line: int = 1
    is_whole: bool = True
    """Whether it begins at the start of the world with nothing remembered."""
    breakpoints: frozenset[int] = frozenset()
    lines: Sequence[str] = ()
    """Those of the whole program; where it is empty, those of ``text``."""


Begin: TypeAlias = Callable[[ExecutionControl], None]
"""Asks for something before the first statement: a step, say."""


class RunObserver:
    """A front end's reactions to runs; each method does nothing unless it is overridden."""

    def on_change(self) -> None:
        """A hold was described or has ended, or a run is at its end. Called in any thread."""

    def before_stop(self) -> None:
        """Programs are about to be stopped. Called in any thread."""

    def after_stop(self) -> None:
        """Programs that ran unattended have been stopped; the answer follows."""


class _Record:
    """What is known of the latest run of one robot."""

    def __init__(
        self,
        session: Session,
        program: Program,
        watched: Sequence[str],
        *,
        is_attended: bool = True,
        is_steppable: bool = True,
        is_background: bool = False,
    ) -> None:
        self.session, self.program = session, program
        self.is_background = is_background
        """Whether the learner does not wait for it: its end gets few words."""
        self.is_attended = is_attended
        """Whether the front end follows it and sums it up."""
        self.is_steppable = is_steppable
        """Whether its holds are described in full, and wait for a request."""
        self.run: Run | None = None
        self.control: ExecutionControl | None = None
        self.has_ended = self.is_summed_up = False
        self.stopped_line = 0
        self.is_pausing = False
        """Whether a pause was asked for."""
        self.was_described = threading.Event()
        """Set when a hold was described."""
        self.holds = False
        """Whether a hold was described that no request has answered."""
        self.is_silent = True
        """Whether nothing was said since it began or since the last request."""
        self.is_stepped = False
        """Whether the last request was for one step: the learner waits for what it does."""
        self.stepping: Stepping | None = None
        self._watched = watched
        self._known: dict[str, int] = {}
        """Variables by folded name, as they were when they were compared last."""

    @property
    def is_current(self) -> bool:
        """Whether the robot runs this, and not something that was started later."""
        run = self.session.run
        return run is not None and run.control is self.control

    @property
    def state(self) -> RunState:
        """A run that is attended is STOPPING until it is summed up."""
        if self.control is None or self.is_summed_up or not (self.is_attended or self.is_current):
            return RunState.READY
        return _STATE_OF.get(self.control.state, RunState.RUNNING)

    def know(self, variables: Iterable[tuple[str, int]]) -> None:
        """The values with which the run begins."""
        self._known = {fold_name(name): value for name, value in variables}

    def changes(self, variables: Iterable[tuple[str, int]], words: Wording) -> tuple[str, ...]:
        """A sentence for each watched variable that has changed; each change once."""
        if not self._watched:
            return ()
        now = {fold_name(name): value for name, value in variables}
        from donnie_tui.core.stepping import changes  # few learners watch a variable

        sentences = tuple(changes(self._watched, self._known, now, words))
        self._known |= now
        return sentences


class RunController:
    """The runs of the robots of a team. Unless a robot is named, the chosen one is meant."""

    def __init__(
        self,
        team: Team,
        words: Wording,
        chronicle: Chronicle,
        *,
        has_prompt: bool = False,
        can_hold: bool = True,
    ) -> None:
        """``has_prompt``: the learner waits for a prompt that comes back after each run, and can ask for
        programs that run unattended. The end of a program that said something needs no words then.

        ``can_hold`` is False where no request for a pause or a step can come.
        """
        self._team, self._words, self._chronicle = team, words, chronicle
        self.observer = RunObserver()
        self._has_prompt, self._can_hold = has_prompt, can_hold
        self._records: dict[str | None, _Record] = {}
        """By the robot's name in events."""
        self.watched: list[str] = []
        """The variables that WATCH named, as they were typed."""
        self.past: Timeline | None = None
        """The position of STEP BACK; None in the present."""
        self._unsubscribe = team.stream.subscribe(self._on_event)

    def close(self) -> None:
        """Unsubscribes, as another front end takes the session over."""
        self._unsubscribe()

    # --- looking

    @property
    def _session(self) -> Session:
        return self._team.chosen

    @property
    def _record(self) -> _Record | None:
        return self._records.get(self._session.hub.robot)

    @property
    def state(self) -> RunState:
        record = self._record
        if record is not None and record.state is not RunState.READY:
            return record.state
        run = self._session.run
        return RunState.READY if run is None else _STATE_OF.get(run.control.state, RunState.RUNNING)

    @property
    def is_busy(self) -> bool:
        """Whether a program runs, or its end was not summed up yet."""
        return self.state is not RunState.READY

    @property
    def is_steppable(self) -> bool:
        """Whether the holds of the program that runs are described, and wait for a request."""
        record = self._record
        return record is not None and record.is_steppable and record.is_current

    @property
    def is_held(self) -> bool:
        """Whether the program is held, was described, and waits for a request."""
        record = self._record
        return record is not None and record.holds and record.state is RunState.PAUSED

    def has_ended(self, robot: str | None) -> bool:
        """Whether the latest run of that robot has published its last event."""
        record = self._records.get(robot)
        return record is not None and record.has_ended

    @property
    def is_whole(self) -> bool:
        """Whether the latest run is of the whole program."""
        return self._record is not None and self._record.program.is_whole

    @property
    def frames(self) -> tuple[Frame, ...]:
        """The call stack, innermost first; empty when nothing runs."""
        return self._session.frames

    # --- starting

    def start(self, program: Program, *, begin: Begin | None = None, is_background: bool = False) -> Run:
        """Starts a program. Raises ``NothingToRun``, and ``Busy`` while something runs."""
        if not program.text.strip():
            raise NothingToRun
        self.require(Request.START)
        session = self._session
        is_unattended = is_background and self._has_prompt
        record = _Record(
            session,
            program,
            self.watched,
            is_attended=not is_unattended,
            is_steppable=not is_unattended,
            is_background=is_background,
        )
        record.know(() if program.is_whole else session.variables.items())
        can_hold = record.is_steppable and bool(
            self._can_hold or begin or self.watched or program.breakpoints
        )

        def prepare(control: ExecutionControl) -> None:
            self._follow(record, control)
            if program.breakpoints and can_hold:
                control.break_at(program.breakpoints)
            if begin is not None:
                begin(control)

        record.run = session.start(
            program.text,
            program.name,
            fresh=program.is_whole,
            hooked=can_hold,
            first_line=program.first_line,
            terminal=None if self._has_prompt and not is_background else not program.is_whole,
            prepare=prepare,
            each_statement=partial(self._look, record) if self.watched else None,
            when_read=self._announce_start if is_background else None,
        )
        return record.run

    def _announce_start(self, run: Run) -> None:
        if not run.was_refused:
            self._answer(self._words("robot-started", name=self._session.name))

    def start_in_background(self, program: Program) -> Run:
        """Starts a program that no prompt waits for; returns once it was read. Raises as ``start``."""
        self._team.give(self._session.name, Assigned(program.text, program.name))
        self._session.settle()
        run = self.start(program, is_background=True)
        run.wait_until_read(LONGEST_READING)
        return run

    def start_together(self) -> Mapping[str, Run]:
        """Starts all programs that robots were given, at the same moment; the runs by the robots' names.

        Raises ``NothingToRun``, and ``Busy`` with the name of the first robot that runs something.
        """
        self._team.settle()
        programs = {name: each for name, each in self._team.given.items() if each.text.strip()}
        if not programs:
            raise NothingToRun
        for session in self._team.running:
            if session.name in programs:
                raise Busy(session.name)
        names = tuple(name for name in self._team.names if name in programs)

        def prepare(session: Session, run: Run) -> None:
            given = programs[session.name]
            record = _Record(
                session,
                Program(given.text, given.name),
                self.watched,
                is_steppable=not self._has_prompt,
                is_background=True,
            )
            record.run = run
            self._follow(record, run.control)

        runs = self._team.start_together(programs, terminal=False, prepare=prepare)
        return dict(zip(names, runs, strict=True))

    def _follow(self, record: _Record, control: ExecutionControl) -> None:
        record.control = control
        self._records[record.session.hub.robot] = record
        self.past = None
        control.observe(partial(self._on_control, record))

    # --- requests to a program that runs

    def require(self, request: Request) -> RunState:
        """The state, in which the request is possible. Raises ``NothingRuns`` or ``Busy``."""
        state = self.state
        if (state, request) not in TRANSITIONS:
            raise NothingRuns if state is RunState.READY else Busy(self._session.name)
        return state

    def pause(self) -> bool:
        """Holds the program at its next statement, or within one that takes time.

        A program in the background holds where it waits for its robot: this waits a moment for that, and
        returns whether it came.
        """
        record, run = self._record, self._session.run
        if self.require(Request.PAUSE) is not RunState.RUNNING or run is None:
            return True
        if record is not None:
            record.is_pausing = True
            record.was_described.clear()
        run.control.pause()
        return record is None or record.is_steppable or record.was_described.wait(LONGEST_PAUSE)

    def continue_(self) -> None:
        self._go_on(Request.CONTINUE, ExecutionControl.resume)

    def step(self) -> None:
        self._go_on(Request.STEP, ExecutionControl.step, is_step=True)

    def step_over(self) -> None:
        """As ``step``, a procedure as a whole."""
        self._go_on(Request.STEP, ExecutionControl.step_over, is_step=True)

    def run_to(self, line: int) -> None:
        """Runs until that line of the program is next."""
        self._go_on(Request.STEP, lambda control: control.run_to(line))

    def _go_on(self, request: Request, ask: Begin, *, is_step: bool = False) -> None:
        self.require(request)
        record, run = self._record, self._session.run
        self.past = None
        if record is not None:
            record.holds, record.is_silent, record.is_stepped = False, True, is_step
            if record.stepping is not None and not is_step:
                record.stepping.run_on()
        if run is not None:  # else it has just ended
            ask(run.control)

    def step_back(self) -> tuple[str, ...]:
        """The sentences for what happened last, undone on ``past``; the robot stays where it is."""
        self.require(Request.STEP_BACK)
        is_first_step = self.past is None
        past = self.past = self.past or self._chronicle.timeline()
        record = self._record
        if record is not None and record.stepping is not None:
            return record.stepping.step_back(past, self._session.variables, is_first_step=is_first_step)
        from donnie_tui.core.stepping import undo_event

        return (undo_event(past, self._words),)

    def to_present(self) -> None:
        """Ends the way back: what is asked for now starts from where the robot really is."""
        self.past = None

    def stop(self) -> None:
        """Stops the program of the chosen robot. The end of an unattended one is summed up at once."""
        self.require(Request.STOP)
        self.note_stop()
        self._session.stop()
        record = self._record
        if record is None or not (record.is_attended and record.is_current):
            self._session.settle()
            self.observer.after_stop()
            self._answer_stopped(self._session, record)

    def stop_all(self) -> bool:
        """Stops all programs; whether any ran. In a world with one robot, as ``stop``."""
        if not self._team.has_several:
            self.stop()
            return True
        running = self._team.running
        self.note_stop()
        self._team.stop()
        attended = [each.session for each in self._records.values() if each.is_attended and each.is_current]
        if not any(each in attended for each in running):
            self._team.settle()
            self.observer.after_stop()
        return bool(running)

    def stop_to_leave(self) -> None:
        """Stops all programs before the front end ends, waits a moment for that, and answers as STOP does."""
        running, record = self._team.running, self._record
        if not running:
            return
        self.note_stop()
        self._team.stop()
        for session in running:
            if session.run is not None:
                session.run.wait(LAST_WORDS)
        for each in self._records.values():
            each.is_summed_up = True
        self.observer.after_stop()
        if self._team.has_several:
            self._answer(self._words("robot-all-stopped"))
        else:
            self._answer_stopped(self._session, record)

    def note_stop(self) -> None:
        """Remembers where the programs are that are about to be stopped. Any thread."""
        self.observer.before_stop()
        for record in tuple(self._records.values()):
            frames = record.session.frames if record.is_current else ()
            if frames:
                record.stopped_line = frames[0].line

    def break_at(self, lines: frozenset[int]) -> None:
        """The breakpoints of the program have changed: a run of it holds before those that there are now."""
        record, run = self._record, self._session.run
        if run is not None and record is not None and (record.program.is_whole or self._has_prompt):
            run.control.break_at(lines)

    def reset(self) -> None:
        """Puts the robot back to its start and forgets everything. Raises ``Busy``."""
        self.require(Request.START)
        self.past = None
        self._session.reset()

    def toggle_watch(self, name: str) -> tuple[str, ...]:
        """Watches that variable from now on, or no more; without a name, the sentences of all watched."""
        known = next((each for each in self.watched if fold_name(each) == fold_name(name)), None)
        if known is not None:
            self.watched.remove(known)
            sentences: tuple[str, ...] = (self._words("watch-gone", name=name),)
        elif name:
            self.watched.append(name)
            sentences = (self._words("watch-set", name=name),)
        else:
            sentences = tuple(self._words("watch-set", name=each) for each in self.watched)
        record = self._record
        if record is not None and record.is_current and record.control is not None:
            record.control.look_before_each(partial(self._look, record) if self.watched else None)
        return sentences or (self._words("watch-none"),)

    # --- what a program does, in its own thread

    def _on_control(self, record: _Record, state: ControlState) -> None:
        if state is ControlState.PAUSED and record.control is not None:
            self._describe_hold(record, record.control.held_at)
            record.was_described.set()
            record.holds = record.is_steppable
        self.observer.on_change()

    def _describe_hold(self, record: _Record, place: tuple[int, int]) -> None:
        frames = record.session.frames
        if not frames:
            return
        self._answer(*record.changes(frames[0].variables, self._words))
        was_paused, record.is_pausing = record.is_pausing, False
        if was_paused or not place[0]:
            self._answer_of(record.session, "answer-paused-at", line=frames[0].line)
        if not record.is_steppable:
            return
        if record.stepping is None:
            record.stepping = self._new_stepping(record, is_first=not was_paused)
        self._answer(*record.stepping.on_hold(place, frames))

    def _new_stepping(self, record: _Record, *, is_first: bool) -> Stepping:
        from donnie_tui.core.stepping import Stepping  # only programs that are held

        program = record.program
        return Stepping(
            record.session.parse(program.text, program.first_line).program,
            program.lines or program.text.split("\n"),
            self._words,
            last_seq=lambda: self._chronicle.last_seq,
            is_first=is_first,
        )

    def _look(self, record: _Record) -> None:
        """Before each statement, where variables are watched."""
        frames = record.session.frames if self.watched else ()
        if frames:
            self._answer(*record.changes(frames[0].variables, self._words))

    def _on_event(self, stamped: Stamped) -> None:
        event = stamped.event
        if not isinstance(event, TRANSIENT):
            self.past = None
        is_text = isinstance(event, Spoke | Announced | Answered) and bool(event.text.strip())
        if is_text or isinstance(event, Error):
            for record in tuple(self._records.values()):
                record.is_silent &= record.is_background and record.session.hub.robot != stamped.robot
        own = self._records.get(stamped.robot)
        if own is None or not own.is_current:
            return
        match event:
            case RunStarted():
                own.is_silent = True
            case Read() if own.stepping is not None:
                own.stepping.on_read(event)
            case RunEnded():
                self._describe_end(own, event)
                own.has_ended = True
                self.observer.on_change()
            case _:
                pass

    def _describe_end(self, record: _Record, event: RunEnded) -> None:
        """What the program leaves: the last changes, and what ended the loop that was stepped through."""
        run = record.session.run
        if run is None or not run.was_refused:
            self._answer(*record.changes(event.variables.items(), self._words))
        if event.outcome is Outcome.COMPLETED and record.stepping is not None:
            self._answer(*record.stepping.on_end())
        if event.outcome is Outcome.COMPLETED and record.is_silent and record.is_background:
            self._answer_of(record.session, "linear-done")

    # --- after the end of a run

    def sum_up(self, robot: str | None) -> None:
        """Announces the result of a run that is over, and allows another one.

        Waits a moment for the program's thread, which ends right after its last event.
        """
        record = self._records.get(robot)
        run = record.run if record is not None else None
        if record is None or run is None or record.is_summed_up:
            return
        run.wait(LAST_WORDS)
        record.is_summed_up = True
        if run.outcome is Outcome.STOPPED:
            self._answer_stopped(record.session, record)
        if record.is_background:
            return
        if not run.was_refused and run.outcome is not Outcome.QUIT:
            self._answer(*hints_for(record.program.text, record.session, self._words))
        if run.outcome is Outcome.COMPLETED:
            self._answer_done(record)

    def _answer_done(self, record: _Record) -> None:
        """Of a program that nothing else shows the end of."""
        if record.program.is_whole and not self._has_prompt:
            code = "screen-done"
        elif record.is_silent or record.is_stepped:
            code = "linear-done"
        else:
            return
        self._answer_of(record.session, code)

    def _answer_stopped(self, session: Session, record: _Record | None) -> None:
        line = record.stopped_line if record is not None else 0
        self._answer_of(session, "answer-stopped-at" if line else "answer-stopped", line=line)

    def forget_ended(self) -> None:
        """Another robot was chosen: if its program is over, that needs no words any more."""
        record = self._record
        if record is not None and record.run is not None and record.run.is_over:
            record.is_summed_up = True

    def _answer_of(self, session: Session, code: str, **values: object) -> None:
        """A sentence about a robot, with its name where there are several."""
        self._answer(said_by(session.hub.robot, self._words(code, **values), self._words))

    def _answer(self, *sentences: str) -> None:
        for each in sentences:
            self._session.hub.publish(Answered(each))


def hints_for(text: str, session: Session, wording: Wording) -> tuple[str, ...]:
    """What had no effect as that text ran, and what was probably meant."""
    found = session.check(text, whole=False)[:MOST_HINTS] if len(text) <= LARGEST_HINTED else ()
    sentences = ((wording.mistake(each), wording.hint(each)) for each in found)
    return tuple(sentence for both in sentences for sentence in both if sentence)
