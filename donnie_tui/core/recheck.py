"""Runs a recording again: the same programs in the same world must give the same events.

A run that the learner stopped is compared up to the stop, since the moment of a stop can't be repeated. What
follows can be compared only from where everything begins anew.
"""

from __future__ import annotations

import threading
from collections.abc import Mapping, Sequence
from enum import Enum

from msgspec import Struct

from donnie_tui.core.events import (
    BELT_LINK,
    TRANSIENT,
    Announced,
    HowStarted,
    Moved,
    Outcome,
    Reset,
    RunEnded,
    RunStarted,
    Stamped,
    Turned,
    Waited,
    as_record,
)
from donnie_tui.core.runner import Run, RunRequest
from donnie_tui.core.session import RunOptions
from donnie_tui.core.team import Team
from donnie_tui.core.wording import Wording


class Result(Enum):
    """The result; each has a sentence ``recheck-...``."""

    SAME = "same"
    DIFFERENT = "different"
    STOPPED = "stopped"
    """The same up to the learner's stop."""
    OVERLAPPING = "overlapping"
    """The same up to where the learner started robots at different moments."""


class Verdict(Struct, frozen=True):
    """``index`` is the event up to which it is the same; for a difference, also what happened instead."""

    result: Result
    index: int
    now: Stamped | None = None


def recheck(events: Sequence[Stamped], team: Team, wording: Wording) -> Verdict:
    """Runs everything again with ``team``, which is at the start of the same world, and compares.

    Blocks as long as the programs take. ``team.stop`` ends it from another thread, which counts as a
    difference.
    """
    checking = _Checking(events, team, wording)
    leave = team.stream.subscribe(checking.on_event)
    try:
        return checking.verdict()
    finally:
        leave()


class _Segment(Struct, frozen=True):
    """Runs that began together, and all that happened until the last of them ended."""

    first: int
    starts: Mapping[str | None, Stamped]
    end: int
    """The position after it."""
    cut: int | None
    """The first event that depends on the moment of the learner's stop."""
    intruder: int | None
    """A run that the learner began meanwhile."""


class _Checking:
    """The position in the recording. The stream's order makes it safe between the programs' threads."""

    def __init__(self, events: Sequence[Stamped], team: Team, wording: Wording) -> None:
        self._events = events
        self._team = team
        self._wording = wording
        self._at = 0
        self._until = 0
        self._difference: Verdict | None = None
        self._lock = threading.Lock()

    def verdict(self) -> Verdict:
        stopped_at: int | None = None
        while self._at < len(self._events):
            event = self._events[self._at].event
            if isinstance(event, RunStarted) and event.how is not None:
                segment = self._segment(event.how)
                if stopped_at is not None and not self._begins_anew(event.how):
                    break
                failure = self._run(segment)
                if failure is not None:
                    return failure
                stopped_at = segment.cut if segment.cut is not None else stopped_at
            else:
                self._between_runs(self._events[self._at])
        if stopped_at is not None:
            return Verdict(Result.STOPPED, stopped_at)
        return Verdict(Result.SAME, len(self._events))

    def _begins_anew(self, how: HowStarted) -> bool:
        """Whether the run begins without any effects of what was stopped."""
        return how.begins_anew and len(how.together or ("",)) == len(self._team.names)

    # --- a segment

    def _segment(self, how: HowStarted) -> _Segment:
        """The segment that begins here.

        The result of a stopped run's last command depends on the stop. A run without any command may not even
        have begun: it had no turn while the first one computed.
        """
        first = self._at
        first_robot, commanded = self._events[first].robot, set[str | None]()
        names: set[str | None] = set(how.together) or {first_robot}
        starts: dict[str | None, Stamped] = {}
        ended, cuts, intruder = 0, list[int](), None
        limits: dict[str | None, int] = {}
        index = first
        while index < len(self._events) and ended < len(names):
            stamped = self._events[index]
            match stamped.event:
                case RunStarted() if stamped.robot in names and stamped.robot not in starts:
                    starts[stamped.robot] = stamped
                    limits[stamped.robot] = index if index > first else index + 1
                case RunStarted() if intruder is None:
                    intruder = index
                case Moved() | Turned() | Waited():
                    limits[stamped.robot] = index
                    commanded.add(stamped.robot)
                case RunEnded(outcome=outcome) if stamped.robot in names:
                    ended += 1
                    if outcome is Outcome.STOPPED:
                        cuts.append(limits.get(stamped.robot, index))
                case Announced():
                    pass  # the announcement of the stop
                case _ if stamped.robot == first_robot and stamped.robot not in commanded:
                    limits[stamped.robot] = index + 1
            index += 1
        if ended < len(names):  # the recording ends before the run did
            cuts.append(index if len(starts) == len(names) else first)
        return _Segment(first, starts, index, min(cuts, default=None), intruder)

    def _run(self, segment: _Segment) -> Verdict | None:
        """Runs a segment. None if it is the same, as far as it can be compared."""
        limits = [each for each in (segment.cut, segment.intruder) if each is not None]
        self._until = min([segment.end, *limits])
        if self._until > segment.first:  # nothing would stop them otherwise
            for run in self._start(segment.starts):
                run.wait()
        with self._lock:
            if self._difference is None and self._at < self._until:
                self._difference = Verdict(Result.DIFFERENT, self._at)
            if self._difference is not None:
                return self._difference
            if segment.intruder == self._until:
                return Verdict(Result.OVERLAPPING, self._until)
            self._at = segment.end
            return None

    def _start(self, starts: Mapping[str | None, Stamped]) -> tuple[Run, ...]:
        hows = {
            robot or self._team.names[0]: (each.event, each.event.how)
            for robot, each in starts.items()
            if isinstance(each.event, RunStarted)
        }
        first = next(how for _, how in hows.values() if how is not None)
        self._wording.language, self._wording.detail = first.language, first.detail
        if len(hows) > 1:
            programs = {
                robot: RunRequest(how.text, started.program)
                for robot, (started, how) in hows.items()
                if how is not None
            }
            options = RunOptions(hooked=False, trace=first.trace, terminal=first.terminal)
            return self._team.start_together(programs, options)
        (robot, (started, how)) = next(iter(hows.items()))
        assert how is not None  # it is the first
        options = RunOptions(
            fresh=how.fresh,
            hooked=False,
            trace=how.trace,
            first_line=how.first_line,
            terminal=how.terminal,
        )
        return (self._team.session(robot).start(how.text, started.program, options),)

    def on_event(self, stamped: Stamped) -> None:
        """Compares a new event with the recording, in a program's thread."""
        if isinstance(stamped.event, TRANSIENT):
            return
        with self._lock:
            if self._difference is not None or self._at >= self._until:
                return
            self._skip_uncaused(stamped)
            if self._at < self._until and not _is_same(self._events[self._at], stamped):
                self._difference = Verdict(Result.DIFFERENT, self._at, stamped)
            self._at += 1
            is_over = self._at >= self._until or self._difference is not None
        if is_over:
            self._team.stop()

    def _skip_uncaused(self, stamped: Stamped) -> None:
        """Skips events that no program caused: the learner asked for the position, or the belt was lost."""
        while (
            self._at < self._until
            and _is_uncaused(self._events[self._at])
            and not _is_same(self._events[self._at], stamped)
        ):
            self._at += 1

    # --- between runs

    def _between_runs(self, stamped: Stamped) -> None:
        if isinstance(stamped.event, Reset):
            self._team.session(stamped.robot or self._team.names[0]).reset()
        self._at += 1


def _is_uncaused(stamped: Stamped) -> bool:
    return isinstance(stamped.event, Announced) and stamped.event.code in ("position", "help", BELT_LINK)


def _is_same(one: Stamped, other: Stamped) -> bool:
    return _compared(one) == _compared(other)


def _compared(stamped: Stamped) -> dict[str, object]:
    """The event without its number, which depends on questions meanwhile, and without Donnie's version."""
    record = as_record(stamped, whole=True)
    return {name: value for name, value in record.items() if name not in ("seq", "version")}
