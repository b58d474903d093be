"""Starts, pauses, steps and stops the runs of a world's robots, for every front end.

Requests come from a front end's thread and don't wait for the program. The program's thread publishes the
sentences about its pauses and its end, so that they follow all that the program said. A front end learns
about both as a ``RunObserver``, and calls ``sum_up`` when a run is over.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from itertools import count
from typing import TYPE_CHECKING

from donnie_tui.core.events import (
    TRANSIENT,
    Announced,
    Answered,
    Error,
    Moved,
    Outcome,
    Read,
    RunEnded,
    RunStarted,
    Spoke,
    Stamped,
    Turned,
    Waited,
)
from donnie_tui.core.run_state import (
    STATE_OF,
    TRANSITIONS,
    Begin,
    NothingRuns,
    NothingToRun,
    Request,
    RunNarrator,
    RunObserver,
    RunRecord,
    RunState,
    hints_for,
)
from donnie_tui.core.runner import LAST_WORDS, Run, RunRequest
from donnie_tui.core.session import Busy, RunOptions, Session
from donnie_tui.core.team import Team
from donnie_tui.core.timeline import Chronicle
from donnie_tui.core.transcript import with_robot_name
from donnie_tui.core.wording import Wording
from language.control import ControlState, ExecutionControl
from language.runtime import Frame
from language.source import fold_name

if TYPE_CHECKING:
    from donnie_tui.core.stepping import Stepping
    from donnie_tui.core.timeline import Timeline

MOST_KEPT = 20_000
"""Movements whose variables are kept."""
LONGEST_PAUSE = 1.0
"""Seconds that the answer to PAUSE waits for a program in the background."""
LONGEST_READING = 2.0
"""Seconds; most programs are read in a few thousandths."""


_JUDGED = (Outcome.COMPLETED, Outcome.FAILED)


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

        ``can_hold`` is False if no request for a pause or a step can come.
        """
        self._team, self._words, self._chronicle = team, words, chronicle
        self.observer = RunObserver()
        self._hold_numbers = count(1)
        self._has_prompt, self._can_hold = has_prompt, can_hold
        self._records: dict[str | None, RunRecord] = {}
        """By the robot's name in events."""
        self.watched: list[str] = []
        """The variables that WATCH named, as they were typed."""
        self.past: Timeline | None = None
        """The position of STEP BACK; None in the present. An event of any thread sets it to None."""
        self.judge: Callable[[bool, bool], tuple[str, ...]] | None = None
        """Returns the verdict about a run that ended by itself, in a challenge.

        Its arguments: whether more than a line ran, and whether a question can follow at once.
        """
        self._unjudged: list[RunRecord] = []
        """The runs since the last verdict."""
        self.variables_during: dict[int, tuple[tuple[str, int], ...]] = {}
        """The program's variables during movements, by the number of the event; in runs of several lines."""
        self._unsubscribe = team.stream.subscribe(self._on_event)

    def close(self) -> None:
        """Unsubscribes, as another front end takes the session over."""
        self._unsubscribe()

    # --- looking

    @property
    def _session(self) -> Session:
        return self._team.chosen

    @property
    def _record(self) -> RunRecord | None:
        return self._records.get(self._session.hub.robot)

    @property
    def state(self) -> RunState:
        record = self._record
        if record is not None and record.state is not RunState.READY:
            return record.state
        run = self._session.run
        return RunState.READY if run is None else STATE_OF.get(run.control.state, RunState.RUNNING)

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

    @property
    def hold_number(self) -> int:
        """See ``RunRecord``. Another number than before is a new hold."""
        record = self._record
        return 0 if record is None else record.hold_number

    def has_ended(self, robot: str | None) -> bool:
        """Whether the latest run of that robot has published its last event."""
        record = self._records.get(robot)
        return record is not None and record.has_ended

    @property
    def is_whole(self) -> bool:
        """Whether the latest run is of the whole program."""
        return self._record is not None and self._record.request.is_whole

    @property
    def text_on_its_way(self) -> str | None:
        """The whole program that runs or is paused; None while there is none."""
        is_on_its_way = self.is_whole and self.state in (RunState.RUNNING, RunState.PAUSED)
        return self._record.request.text if is_on_its_way and self._record is not None else None

    @property
    def frames(self) -> tuple[Frame, ...]:
        """The call stack, innermost first, as it is or as STEP BACK left it; empty when nothing runs."""
        past = self.past
        return self._session.frames if past is None else self._frames_at(past) or ()

    def _frames_at(self, past: Timeline) -> tuple[Frame, ...] | None:
        record, stepping = self._record, self._stepping
        held = stepping.frames_at(past) if stepping is not None else None
        return record.frames_at(past) if held is None and record is not None else held

    @property
    def _stepping(self) -> Stepping | None:
        record = self._record
        return record.narrator.stepping if record is not None else None

    @property
    def past_steps(self) -> tuple[int, int] | None:
        """The number of steps before the moment of STEP BACK and in all, or None in the present."""
        past, stepping = self.past, self._stepping
        if past is None:
            return None
        return past.steps if stepping is None else stepping.counted(past)

    @property
    def worked_out(self) -> tuple[tuple[str, ...], ...]:
        """For each expression of the next statement: its text, then each stage of its evaluation.

        Empty unless the program is held, or was held at that moment of the past.
        """
        past, stepping = self.past, self._stepping
        if stepping is None or (past is None and not self.is_held):
            return ()
        return stepping.worked_out(past)

    @property
    def knows_variables(self) -> bool:
        """False at a moment of the past without kept variables."""
        past = self.past
        return past is None or self._frames_at(past) is not None

    # --- starting

    def start(self, request: RunRequest, *, begin: Begin | None = None, is_background: bool = False) -> Run:
        """Starts a program. Raises ``NothingToRun``, and ``Busy`` while something runs."""
        if not request.text.strip():
            raise NothingToRun
        self.require(Request.START)
        session = self._session
        is_unattended = is_background and self._has_prompt
        record = RunRecord(
            session,
            request,
            self._narrator(session, request),
            is_attended=not is_unattended,
            is_steppable=not is_unattended,
            is_background=is_background,
        )
        can_hold = record.is_steppable and bool(
            self._can_hold or begin or self.watched or request.breakpoints
        )

        def prepare(control: ExecutionControl) -> None:
            self._follow(record, control)
            if request.breakpoints and can_hold:
                control.break_at(request.breakpoints)
            if begin is not None:
                begin(control)

        record.run = session.start(
            request.text,
            request.name,
            RunOptions(
                fresh=request.is_whole,
                hooked=can_hold,
                first_line=request.first_line,
                terminal=None if self._has_prompt and not is_background else not request.is_whole,
            ),
            prepare=prepare,
            each_statement=partial(self._look, record) if self.watched else None,
            when_read=self._announce_start if is_background else None,
        )
        return record.run

    def _announce_start(self, run: Run) -> None:
        if not run.was_refused:
            self._answer(self._words("robot-started", name=self._session.name))

    def start_in_background(self, request: RunRequest) -> Run:
        """Starts a program that no prompt waits for; returns once it was read. Raises as ``start``."""
        self._team.give(self._session.name, request)
        self._session.wait_for_stop()
        run = self.start(request, is_background=True)
        run.wait_until_read(LONGEST_READING)
        return run

    def start_together(self) -> Mapping[str, Run]:
        """Starts all programs that robots were given, at the same moment; the runs by the robots' names.

        Raises ``NothingToRun``, and ``Busy`` with the name of the first robot that runs something.
        """
        self._team.wait_for_stop()
        programs = {name: each for name, each in self._team.given.items() if each.text.strip()}
        if not programs:
            raise NothingToRun
        for session in self._team.running:
            if session.name in programs:
                raise Busy(session.name)
        names = tuple(name for name in self._team.names if name in programs)

        def prepare(session: Session, run: Run) -> None:
            request = programs[session.name]
            record = RunRecord(
                session,
                request,
                self._narrator(session, request),
                is_steppable=not self._has_prompt,
                is_background=True,
            )
            record.run = run
            self._follow(record, run.control)

        runs = self._team.start_together(programs, RunOptions(terminal=False), prepare=prepare)
        return dict(zip(names, runs, strict=True))

    def _narrator(self, session: Session, request: RunRequest) -> RunNarrator:
        return RunNarrator(session, request, self.watched, self._words, self._chronicle)

    def _follow(self, record: RunRecord, control: ExecutionControl) -> None:
        record.control = control
        self._records[record.session.hub.robot] = record
        self._unjudged.append(record)
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
        """Run to the next statement; after STEP BACK, go one step towards the present."""
        self._go_on(Request.STEP, ExecutionControl.step, is_step=True)

    def step_over(self) -> None:
        """As ``step``, but runs a procedure call as a whole."""
        self._go_on(Request.STEP, ExecutionControl.step_over, is_step=True)

    def run_to(self, line: int) -> None:
        """Runs until that line of the program is next."""
        self._go_on(Request.STEP, lambda control: control.run_to(line))

    def _go_on(self, request: Request, ask: Begin, *, is_step: bool = False) -> None:
        if is_step and (past := self.past) is not None:
            self._answer(*self._step_forward(past))
            return
        self.require(request)
        record, run = self._record, self._session.run
        self.past = None
        if record is not None:
            record.holds, record.is_silent, record.is_stepped = False, True, is_step
            if record.narrator.stepping is not None and not is_step:
                record.narrator.stepping.run_on()
        if run is not None:  # else it has just ended
            ask(run.control)

    def step_back(self) -> tuple[str, ...]:
        """The sentences for what happened last, undone on ``past``; the robot stays where it is."""
        self.require(Request.STEP_BACK)
        past = self.past
        is_first_step = past is None
        past = past or self._chronicle.timeline()
        if not past.steps[1]:
            return (self._words("undone-start"),)  # nothing has happened
        self.past = past
        begun = (self._words("looking-back"),) if is_first_step else ()
        if (stepping := self._stepping) is not None:
            undone = stepping.step_back(past, self._session.variables, is_first_step=is_first_step)
            return (*begun, *undone)
        from donnie_tui.core.stepping import undo_event

        return (*begun, undo_event(past, self._words))

    def look_at(self, step: int) -> tuple[str, ...]:
        """Go back or forward to the moment after that many steps; the sentences of the last one on the way.

        A step that did several things is undone at once, so this may go past that moment.
        """
        sentences: tuple[str, ...] = ()
        here = self.past_steps
        is_back = here is not None and here[0] > step
        while here is not None and (here[0] > step if is_back else here[0] < step):
            past = self.past
            if past is None:
                break
            sentences = self.step_back() if is_back else self._step_forward(past)
            before, here = here, self.past_steps
            if here == before:
                break
        return sentences

    def _step_forward(self, past: Timeline) -> tuple[str, ...]:
        """The sentences for one step from the past to the present, which ends the way back."""
        if (stepping := self._stepping) is not None:
            sentences = stepping.step_forward(past)
            is_present = stepping.is_present(past)
        else:
            from donnie_tui.core.stepping import redo_event

            sentences = redo_event(past, self._words)
            is_present = past.at == len(past)
        return (*sentences, *(self.to_present() if is_present else ()))

    def to_present(self) -> tuple[str, ...]:
        """Returns to the present, where the next request starts. The sentences say so."""
        was_past, self.past = self.past is not None, None
        return (self._words("looking-back-ended"),) if was_past else ()

    def stop(self) -> None:
        """Stops the program of the chosen robot. The end of an unattended one is summed up at once."""
        self.require(Request.STOP)
        record = self._record
        is_followed = record is not None and record.is_attended and record.is_current  # it may end at once
        self.note_stop()
        self._session.stop()
        if not is_followed:
            self._session.wait_for_stop()
            self.observer.after_stop()
            self._answer_stopped(self._session, record)

    def stop_all(self) -> bool:
        """Stops all programs; whether any ran. In a world with one robot, as ``stop``."""
        if not self._team.has_several:
            self.stop()
            return True
        running = self._team.running
        for each in self._records.values():
            each.was_stopped_with_all = each.is_current
        attended = [each.session for each in self._records.values() if each.is_attended and each.is_current]
        self.note_stop()
        self._team.stop()
        if not any(each in attended for each in running):
            self._team.wait_for_stop()
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
        """Sets the breakpoints of a running program."""
        record, run = self._record, self._session.run
        if run is not None and record is not None and (record.request.is_whole or self._has_prompt):
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

    def _on_control(self, record: RunRecord, state: ControlState) -> None:
        if state is ControlState.PAUSED and record.control is not None:
            was_paused, record.is_pausing = record.is_pausing, False
            self._answer(
                *record.narrator.on_hold(
                    record.control.held_at, was_paused=was_paused, is_steppable=record.is_steppable
                )
            )
            record.was_described.set()
            record.hold_number = next(self._hold_numbers)
            record.holds = record.is_steppable
        self.observer.on_change()

    def _look(self, record: RunRecord) -> None:
        """Looks at the watched variables before each statement."""
        self._answer(*record.narrator.on_statement())

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
            case Read() if own.narrator.stepping is not None:
                own.narrator.stepping.on_read(event)
            case Moved() | Turned() | Waited() if "\n" in own.request.text:
                frames = own.session.frames
                self._keep_variables(stamped.seq, frames)
                own.keep_frames(stamped.seq, frames)
            case Spoke() if "\n" in own.request.text and own.has_room_for_frames:
                own.keep_frames(stamped.seq, own.session.frames)
            case RunEnded():
                self._answer(*own.narrator.on_end(event))
                if event.outcome is Outcome.COMPLETED and own.is_silent and own.is_background:
                    self._answer_of(own.session, "run-done")
                own.has_ended = True
                self.observer.on_change()
            case _:
                pass

    def _keep_variables(self, seq: int, frames: Sequence[Frame]) -> None:
        """Keeps the variables of a movement, which can't change before it ends."""
        if frames and frames[-1].variables:
            self.variables_during[seq] = frames[-1].variables
        if len(self.variables_during) > MOST_KEPT:
            del self.variables_during[next(iter(self.variables_during))]

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
        if run.outcome is Outcome.STOPPED and not record.was_stopped_with_all:
            self._answer_stopped(record.session, record)
        if record.is_background:
            self.say_verdict()
            return
        if not run.was_refused and run.outcome is not Outcome.QUIT:
            self._answer(*hints_for(record.request.text, record.session, self._words))
        if run.outcome is Outcome.COMPLETED:
            self._answer_done(record)
        self._say_verdict()

    @property
    def is_verdict_due(self) -> bool:
        """Whether all programs in the background have ended and wait for their verdict."""
        runs = self._unjudged if self.judge is not None else ()
        return bool(runs) and all(each.is_background and each.has_ended for each in runs)

    def say_verdict(self) -> None:
        """Says the verdict about programs in the background, once all have ended."""
        for each in self._unjudged if self.is_verdict_due else ():
            if each.run is not None:
                each.run.wait(LAST_WORDS)
        if not self._team.running:
            self._say_verdict()

    def _say_verdict(self) -> None:
        records, self._unjudged = self._unjudged, []
        runs = [each.run for each in records]
        if self.judge is not None and any(
            each is not None and not each.was_refused and each.outcome in _JUDGED for each in runs
        ):
            requests = [each.request for each in records]
            is_program = any(each.is_whole or "\n" in each.text.strip() for each in requests)
            is_asked = self._can_hold and not (self._has_prompt and records[-1].is_background)
            self._answer(*self.judge(is_program, is_asked))

    def _answer_done(self, record: RunRecord) -> None:
        """Says that the program is done, if no prompt shows it."""
        if record.request.is_whole and not self._has_prompt:
            code = "screen-done"
        elif record.is_silent or record.is_stepped:
            code = "run-done"
        else:
            return
        self._answer_of(record.session, code)

    def _answer_stopped(self, session: Session, record: RunRecord | None) -> None:
        line = record.stopped_line if record is not None else 0
        self._answer_of(session, "answer-stopped-at" if line else "answer-stopped", line=line)

    def forget_ended(self) -> None:
        """Drops the report of an ended program after the learner chose another robot."""
        record = self._record
        if record is not None and record.run is not None and record.run.is_over:
            record.is_summed_up = True

    def _answer_of(self, session: Session, code: str, **values: object) -> None:
        """A sentence about a robot, with its name where there are several."""
        self._answer(with_robot_name(session.hub.robot, self._words(code, **values), self._words))

    def _answer(self, *sentences: str) -> None:
        for each in sentences:
            self._session.hub.publish(Answered(each))
