"""The state of runs: what a front end can request in which state, what is said of a run, and its mistakes.

``TRANSITIONS`` says in which state a run takes which request. Of several mistakes the first one counts until
the learner asks for another: it is the one to correct first.
"""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterable, Sequence
from enum import Enum, auto
from typing import TYPE_CHECKING, TypeAlias

from donnie_tui.core.events import Error, Outcome, RunEnded, RunStarted, Stamped
from donnie_tui.core.runner import Run, RunRequest
from donnie_tui.core.session import Session
from donnie_tui.core.timeline import Chronicle, is_main_event
from donnie_tui.core.transcript import lines_of, lines_with_robot_name, with_robot_name
from donnie_tui.core.wording import Wording
from language.control import ControlState, ExecutionControl
from language.diagnostics import MistakeKind
from language.source import fold_name

if TYPE_CHECKING:
    from donnie_tui.core.stepping import Stepping
    from donnie_tui.core.timeline import Timeline
    from language.runtime import Frame

MOST_KEPT = 200
"""Mistakes that are remembered, the newest ones."""
MOST_FRAMES, MOST_CALLS = 2000, 20
"""Moments of a run whose open calls are remembered, and of each the innermost calls."""
MOST_HINTS = 3
LARGEST_HINTED = 50_000
"""Characters of a text that is searched for hints: the search must not keep the learner waiting."""


class RunState(Enum):
    """The state of a robot's program."""

    READY = "ready"
    """No program runs: one can be started."""
    RUNNING = "running"
    PAUSED = "paused"
    """The program is held between two statements, or within one that takes time."""
    STOPPING = "stopping"
    """The program was stopped or has ended, and was not summed up yet."""


class Request(Enum):
    """Requests to a run, and changes that its program makes by itself."""

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

STATE_OF = {
    ControlState.PAUSED: RunState.PAUSED,
    ControlState.STOPPING: RunState.STOPPING,
    ControlState.ENDED: RunState.STOPPING,
}
"""Of a program's control; all other states are RUNNING."""


class NothingRuns(Exception):
    """The request needs a program that runs."""


class NothingToRun(Exception):
    """The program has no text."""


Begin: TypeAlias = Callable[[ExecutionControl], None]
"""Makes a request before the first statement, such as a step."""


class RunObserver:
    """A front end's reactions to runs; each method does nothing unless it is overridden."""

    def on_change(self) -> None:
        """A hold was described or has ended, or a run is at its end. Called in any thread."""

    def before_stop(self) -> None:
        """Programs are about to be stopped. Called in any thread."""

    def after_stop(self) -> None:
        """Programs that ran unattended have been stopped; the answer follows."""


class RunRecord:
    """What is known of the latest run of one robot."""

    def __init__(
        self,
        session: Session,
        request: RunRequest,
        narrator: RunNarrator,
        *,
        is_attended: bool = True,
        is_steppable: bool = True,
        is_background: bool = False,
    ) -> None:
        self.session, self.request, self.narrator = session, request, narrator
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
        self.was_stopped_with_all = False
        """Whether STOP ALL stopped it, whose answer is about all robots."""
        self.holds = False
        """Whether a hold was described that no request has answered."""
        self.hold_number = 0
        """Which hold was described last, among those of all runs; 0 before the first."""
        self.is_silent = True
        """Whether nothing was said since it began or since the last request."""
        self.is_stepped = False
        """Whether the last request was for one step: the learner waits for what it does."""
        self._frames: dict[int, tuple[Frame, ...]] = {}
        """The open calls during what the program did, by the number of the event; of the newest."""

    @property
    def is_current(self) -> bool:
        """Whether this is the robot's latest run."""
        run = self.session.run
        return run is not None and run.control is self.control

    @property
    def has_room_for_frames(self) -> bool:
        """False once many were kept: reading them at each word would slow down a program that talks a lot."""
        return len(self._frames) < MOST_FRAMES

    def keep_frames(self, seq: int, frames: Sequence[Frame]) -> None:
        """Remembers the calls at the event with that number."""
        self._frames[seq] = tuple(frames[:MOST_CALLS])
        if len(self._frames) > MOST_FRAMES:
            del self._frames[next(iter(self._frames))]

    def frames_at(self, timeline: Timeline) -> tuple[Frame, ...] | None:
        """The calls at that position; None if they were not kept."""
        robot = self.session.hub.robot
        following = (timeline.events[at] for at in range(timeline.at, len(timeline)))
        done = (each for each in following if each.robot == robot and is_main_event(each.event))
        return next((self._frames.get(each.seq) for each in done), None)

    @property
    def state(self) -> RunState:
        """The state; an attended run is STOPPING until it is summed up."""
        if self.control is None or self.is_summed_up or not (self.is_attended or self.is_current):
            return RunState.READY
        return STATE_OF.get(self.control.state, RunState.RUNNING)


class RunNarrator:
    """Publishes the sentences about one run: at its holds, at changes of watched variables, at its end."""

    def __init__(
        self,
        session: Session,
        request: RunRequest,
        watched: Sequence[str],
        words: Wording,
        chronicle: Chronicle,
    ) -> None:
        self._session, self._request, self._watched = session, request, watched
        self._words, self._chronicle = words, chronicle
        self.stepping: Stepping | None = None
        """From the first hold that is described in full."""
        remembered = {} if request.is_whole else session.variables
        self.known = {fold_name(name): value for name, value in remembered.items()}
        """Variables by folded name, as they were when they were compared last."""

    def on_statement(self) -> tuple[str, ...]:
        """The changes of watched variables before a statement."""
        frames = self._session.frames if self._watched else ()
        return self._changes(frames[0].variables) if frames else ()

    def on_hold(self, place: tuple[int, int], *, was_paused: bool, is_steppable: bool) -> tuple[str, ...]:
        """The sentences of a hold before the statement at that line and column, or within one at line 0."""
        frames, words = self._session.frames, self._words
        if not frames:
            return ()
        sentences = [*self._changes(frames[0].variables)]
        if was_paused or not place[0]:
            paused = words("answer-paused-at", line=frames[0].line)
            sentences.append(with_robot_name(self._session.hub.robot, paused, words))
        if is_steppable:
            self.stepping = self.stepping or self._new_stepping(is_first=not was_paused)
            sentences += self.stepping.on_hold(place, frames)
        return tuple(sentences)

    def on_end(self, event: RunEnded) -> tuple[str, ...]:
        """The last changes, and what ended the loop that was stepped through."""
        run = self._session.run
        was_refused = run is not None and run.was_refused
        changes = () if was_refused else self._changes(event.variables.items())
        if event.outcome is Outcome.COMPLETED and self.stepping is not None:
            return (*changes, *self.stepping.on_end())
        return changes

    def _changes(self, variables: Iterable[tuple[str, int]]) -> tuple[str, ...]:
        """A sentence for each watched variable that has changed; each change once."""
        if not self._watched:
            return ()
        now = {fold_name(name): value for name, value in variables}
        from donnie_tui.core.stepping import changes  # few learners watch a variable

        sentences = tuple(changes(self._watched, self.known, now, self._words))
        self.known |= now
        return sentences

    def _new_stepping(self, *, is_first: bool) -> Stepping:
        from donnie_tui.core.stepping import Stepping  # only programs that are held

        request = self._request
        return Stepping(
            self._session.parse(request.text, request.first_line).program,
            request.lines or request.text.split("\n"),
            self._words,
            last_seq=lambda: self._chronicle.last_seq,
            is_first=is_first,
        )


# --- mistakes


class RunErrors:
    """The mistakes of one robot's last run, and the one that the learner is at. Subscribe ``on_event``."""

    def __init__(self, errors: Iterable[Error] = (), of: Callable[[], str | None] = lambda: None) -> None:
        """``of``: the robot, by the name in its events; None in a world of one robot."""
        self._of = of
        self.all = tuple(errors)
        self.had_any = False
        """Whether a run of any robot had a mistake or failed, since the start."""
        self._at = 0
        self.known: frozenset[Error] = frozenset()
        """Mistakes that were reported before the lines that made them are run again."""

    def is_known(self, error: Error) -> bool:
        """Whether the same mistake was reported before; from any thread."""
        return error in self.known

    def go_to_new(self) -> Error | None:
        """Moves to the first mistake that was not known, and returns it; a missing END comes last."""
        new = [at for at, each in enumerate(self.all) if each not in self.known]
        if not new:
            return None
        self._at = min(new, key=lambda at: (self.all[at].kind == MistakeKind.MISSING_END.value, at))
        return self.all[self._at]

    def on_event(self, stamped: Stamped) -> None:
        """Called in any thread. A run begins without mistakes."""
        event = stamped.event
        self.had_any |= isinstance(event, Error)
        if stamped.robot != self._of():
            return
        if isinstance(event, RunStarted):
            self.all, self._at = (), 0
        elif isinstance(event, Error):
            self.add(event)

    def add(self, error: Error) -> None:
        self.all = (*self.all[-MOST_KEPT + 1 :], error)

    @property
    def now(self) -> Error | None:
        """The mistake that the learner is at."""
        return self.all[self._at] if self.all else None

    def go(self, by: int, wording: Wording) -> tuple[Error | None, tuple[str, ...]]:
        """Moves by that many mistakes; returns the mistake and the sentences, or None and a sentence."""
        if not self.all:
            return None, self._none(wording)
        wanted = self._at + by
        if not 0 <= wanted < len(self.all):
            return None, (wording("answer-no-more-errors", number=self._at + 1, count=len(self.all)),)
        self._at = wanted
        return self.all[wanted], lines_of(self.all[wanted], wording)

    def in_words(self, wording: Wording) -> tuple[str, ...]:
        """All mistakes again."""
        return tuple(line for each in self.all for line in lines_of(each, wording)) or self._none(wording)

    def explained(self, robot: str | None, wording: Wording) -> tuple[str, ...]:
        """The current mistake in plain words, and what to do. ``robot`` has made it."""
        if self.now is None:
            return self._none(wording)
        return lines_with_robot_name(robot, wording.explanation(self.now), wording)

    def _none(self, wording: Wording) -> tuple[str, ...]:
        return (wording("answer-no-errors"),)


def line_of(error: Error, wording: Wording) -> tuple[str, ...]:
    """The line as it was when the mistake was made, none if it is not known."""
    return lines_of(error, wording)[1:2] if error.source_line else ()


def hints_for(text: str, session: Session, wording: Wording) -> tuple[str, ...]:
    """Hints about statements of a run without effect, and what was probably meant."""
    found = session.check(text, whole=False)[:MOST_HINTS] if len(text) <= LARGEST_HINTED else ()
    sentences = ((wording.mistake(each), wording.hint(each)) for each in found)
    return tuple(sentence for both in sentences for sentence in both if sentence)
