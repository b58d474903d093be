"""The robots of one world: a session for each, one stream of events, and the chosen robot.

Sessions are made on first use, so a world of a thousand robots costs no more than those in use. Rule: robots
that start together are announced before the first of them acts, so that events do not depend on the threads'
speed.

``TurnMonitor`` detects a program that keeps its turn too long while the other robots wait, and reports it.
The order of turns is correct, but a blind learner can't know why nothing happens. The report is made once for
each run, as an answer. It is no part of the recorded stream, since it depends on the machine's speed.
"""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterable, Mapping
from time import monotonic
from typing import TypeAlias

from msgspec.structs import replace

from donnie_tui.core.events import Answered, RunStarted, Stamped
from donnie_tui.core.hub import Stream
from donnie_tui.core.runner import Run, RunRequest
from donnie_tui.core.session import RUN_OPTIONS, RunOptions, Session
from donnie_tui.core.wording import Wording, robot_called
from language.control import ControlState


class Team:
    """All robots of a world, the first one chosen. Any thread may ask for a stop."""

    def __init__(
        self,
        names: Iterable[str],
        make_session: Callable[[str], Session],
        stream: Stream,
        expect: Callable[[Iterable[str]], None] | None = None,
    ) -> None:
        """``names`` in the order of the world, at least one. ``expect`` announces a common start."""
        self.names = tuple(dict.fromkeys(names))
        self.stream = stream
        self._make_session = make_session
        self._expect = expect
        self._sessions: dict[str, Session] = {}
        self._lock = threading.Lock()
        self._chosen = self.names[0]
        self.given: dict[str, RunRequest] = {}
        """The programs that robots were given last, by name."""

    # --- the robots

    @property
    def has_several(self) -> bool:
        return len(self.names) > 1

    @property
    def chosen_name(self) -> str:
        """The chosen robot's name in its world."""
        return self._chosen

    @property
    def chosen(self) -> Session:
        """The chosen robot's session."""
        return self.session(self._chosen)

    def choose(self, name: str) -> Session:
        """Chooses that robot, and keeps the chosen speed. Raises ``KeyError``."""
        session, speed = self.session(name), self.chosen.speed
        self._chosen = name
        session.speed = speed
        return session

    def called(self, typed: str) -> str | None:
        """The robot's name for what was typed."""
        return robot_called(typed, self.names)

    def give(self, name: str, program: RunRequest) -> None:
        """Sets the program that the robot runs when all start together."""
        self.given[name] = program

    def session(self, name: str) -> Session:
        """Raises ``KeyError`` if there is no such robot."""
        with self._lock:
            if name not in self.names:
                raise KeyError(name)
            if name not in self._sessions:
                self._sessions[name] = self._make_session(name)
            return self._sessions[name]

    @property
    def sessions(self) -> tuple[Session, ...]:
        """The sessions in use, in the order of the world."""
        return tuple(self._sessions[name] for name in self.names if name in self._sessions)

    @property
    def running(self) -> tuple[Session, ...]:
        """The sessions whose programs run."""
        return tuple(each for each in self.sessions if each.run is not None)

    @property
    def has_unstopped_run(self) -> bool:
        """Whether a program runs that is not being stopped."""
        runs = (each.run for each in self.sessions)
        return any(run is not None and not run.is_ending for run in runs)

    # --- their programs

    def start_together(
        self,
        programs: Mapping[str, RunRequest],
        options: RunOptions = RUN_OPTIONS,
        *,
        fresh: bool = True,
        prepare: Callable[[Session, Run], None] = lambda _session, _run: None,
    ) -> tuple[Run, ...]:
        """Starts each robot's program at the same moment, in the order of the world.

        ``fresh``: each from the robot's start. ``prepare`` is called for each before any begins. Raises
        ``Busy`` before any has begun if one of them runs something, ``KeyError`` for an unknown robot.
        """
        for unknown in programs.keys() - set(self.names):
            raise KeyError(unknown)
        claimed: list[tuple[Session, Run]] = []
        names = tuple(filter(programs.__contains__, self.names))
        options = replace(options, fresh=fresh, together=names if len(names) > 1 else ())
        try:
            for session in map(self.session, names):
                program = programs[session.name]
                run = session.claim(program.text, program.name, options)
                claimed.append((session, run))
                prepare(session, run)
            self._begin_together(claimed)
        except BaseException:
            for session, run in claimed:
                session.give_up(run)
            raise
        return tuple(run for _, run in claimed)

    def _begin_together(self, claimed: list[tuple[Session, Run]]) -> None:
        for session, _ in claimed:
            session.speed = self.chosen.speed
        if self._expect is not None:
            self._expect(session.name for session, _ in claimed if session.takes_turns)
        for session, run in claimed:
            session.begin(run)

    def stop(self) -> None:
        """Stops all programs and halts all robots."""
        for session in self.sessions:
            session.stop()

    def wait_for_stop(self) -> None:
        """Waits some moments at most for the stopped programs to end."""
        for session in self.sessions:
            if not session.wait_for_stop():
                return

    def close(self, seconds: float = 1.0) -> None:
        """Stops all, waits that long for each program's thread, and halts the robots."""
        self.stop()
        for session in self.sessions:
            session.close(seconds)


# --- programs that keep their turn

LONGEST_TURN = 3.0
"""Seconds of real time that a program may keep its turn without a report."""
CHECK_INTERVAL = 0.5
"""Seconds between two checks, while any program runs."""

_AT_REST = (ControlState.PAUSING, ControlState.PAUSED, ControlState.STOPPING, ControlState.ENDED)
"""States without a report: a learner who pauses or stops a program knows why nothing happens."""

Turn: TypeAlias = tuple[str, float]
"""The robot whose turn it is while others wait, and the world's time."""


class TurnMonitor:
    """Checks whether the turn changes: ``check`` once, in any thread; ``watch`` in the background."""

    def __init__(
        self,
        team: Team,
        turn: Callable[[], Turn | None],
        wording: Wording,
        *,
        is_excused: Callable[[], bool] = lambda: False,
        now: Callable[[], float] = monotonic,
    ) -> None:
        """``turn`` returns None while no robot waits. ``is_excused``: the reason is known, such as a
        voice."""
        self._team, self._turn, self._say = team, turn, wording
        self._is_excused, self._now = is_excused, now
        self._seen: Turn | None = None
        self._since = 0.0
        self._reported: set[str] = set()
        """Robots whose runs were reported."""
        self._lock = threading.Lock()
        self._is_watching = False
        self._closed = threading.Event()

    def watch(self) -> None:
        """Starts checking whenever programs run."""
        self._team.stream.subscribe(self._on_event)

    def close(self) -> None:
        self._closed.set()

    def check(self) -> None:
        """Reports a program that has kept its turn for a while."""
        turn = None if self._is_excused() else self._turn()
        if turn is None or turn != self._seen or self._rests(turn[0]):
            self._seen, self._since = turn, self._now()
            return
        name = turn[0]
        if self._now() - self._since >= LONGEST_TURN and name not in self._reported:
            self._reported.add(name)
            self._team.chosen.hub.publish(Answered(self._say("holds-up", name=name)))

    def _rests(self, name: str) -> bool:
        run = self._team.session(name).run
        return run is None or run.control.state in _AT_REST

    def _on_event(self, stamped: Stamped) -> None:
        """Called in the thread of the program that begins."""
        if not isinstance(stamped.event, RunStarted):
            return
        with self._lock:
            self._reported.discard(stamped.event.robot)
            if self._is_watching or self._closed.is_set():
                return
            self._is_watching = True
        threading.Thread(target=self._check_repeatedly, name="turn monitor", daemon=True).start()

    def _check_repeatedly(self) -> None:
        while not self._closed.wait(CHECK_INTERVAL):
            with self._lock:
                if not self._team.running:
                    self._is_watching = False
                    self._seen = None
                    return
            self.check()
