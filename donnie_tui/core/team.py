"""The robots of one world: a session for each, one stream of events, and the chosen robot.

Sessions are made on first use, so a world of a thousand robots costs no more than those in use. Rule: robots
that start together are announced before the first of them acts, so that events do not depend on the threads'
speed.
"""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterable, Mapping

from msgspec import Struct

from donnie_tui.core.hub import Stream
from donnie_tui.core.runner import Run
from donnie_tui.core.session import Session
from language.source import fold_name


class Assigned(Struct, frozen=True):
    """A program for one robot."""

    text: str
    name: str
    """The program's name."""


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
        self.given: dict[str, Assigned] = {}
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
        """The robot's name for what was typed, in any case and with or without accents."""
        if typed in self.names:
            return typed
        return next((name for name in self.names if fold_name(name) == fold_name(typed)), None)

    def give(self, name: str, program: Assigned) -> None:
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

    # --- their programs

    def start_together(
        self,
        programs: Mapping[str, Assigned],
        *,
        trace: bool = False,
        hooked: bool = True,
        terminal: bool | None = None,
        prepare: Callable[[Session, Run], None] = lambda _session, _run: None,
    ) -> tuple[Run, ...]:
        """Starts each robot's program from its start at the same moment, in the order of the world.

        ``prepare`` is called for each before any begins. Raises ``Busy`` before any has begun if one of them
        runs something, ``KeyError`` for an unknown robot.
        """
        for unknown in programs.keys() - set(self.names):
            raise KeyError(unknown)
        claimed: list[tuple[Session, Run]] = []
        names = tuple(filter(programs.__contains__, self.names))
        try:
            for session in map(self.session, names):
                program = programs[session.name]
                run = session.claim(
                    program.text,
                    program.name,
                    fresh=True,
                    trace=trace,
                    hooked=hooked,
                    terminal=terminal,
                    together=names if len(names) > 1 else (),
                )
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

    def settle(self) -> None:
        """Waits some moments at most for the stopped programs to end."""
        for session in self.sessions:
            if not session.settle():
                return

    def close(self, seconds: float = 1.0) -> None:
        """Stops all, waits that long for each program's thread, and halts the robots."""
        self.stop()
        for session in self.sessions:
            session.close(seconds)
