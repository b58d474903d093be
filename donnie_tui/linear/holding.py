"""A program that is held between two statements: what is told then, and what somebody wants next."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from enum import Enum, auto

from devices.ports.values import Frozen
from donnie_tui.core.events import Outcome, RunEnded, RunStarted, Stamped
from donnie_tui.i18n.first_words import PROMPT
from donnie_tui.linear.desk import Desk
from donnie_tui.linear.reader import Typed
from language.control import ControlState, ExecutionControl


class Goes(Enum):
    """How a held program goes on."""

    STEP = auto()
    OVER = auto()
    UNTIL = auto()
    ON = auto()
    STOP = auto()


class Wish(Frozen):
    """What somebody wants of a held program."""

    goes: Goes
    line: int = 0
    """For ``UNTIL``."""


class Holding:
    """Tells each hold of one run after the other."""

    def __init__(self, desk: Desk, wish_of: Callable[[Typed], Wish | None]) -> None:
        self._desk = desk
        self._wish_of = wish_of
        self._control: ExecutionControl | None = None
        self.is_held = False
        self.is_stepped = False
        """Whether somebody waits for what the statement does before which it was held last."""

    def prepare(
        self,
        text: str,
        first_line: int,
        begin: Callable[[ExecutionControl], None] | None,
        control: ExecutionControl,
    ) -> None:
        """A run is about to begin."""
        self.is_held = self.is_stepped = self._desk.is_pausing = False
        self._control = control
        self._desk.stepped.begin(self._desk.session, text, first_line, lambda: self._desk.program.lines)
        control.observe(self._changed)
        if self._desk.program.breakpoints:
            control.break_at(self._desk.program.breakpoints)
        if begin is not None:
            begin(control)

    @property
    def is_of_running(self) -> bool:
        """Whether what the robot runs began here, and was not STARTed, say."""
        run = self._desk.session.run
        return run is not None and run.control is self._control

    def _changed(self, state: ControlState) -> None:
        """In any thread."""
        self.is_held = state is ControlState.PAUSED
        if self.is_held:
            self._desk.console.nudge()

    def hear(self, stamped: Stamped) -> None:
        """In the program's thread: what its sensors say, and what it leaves."""
        if stamped.robot != self._desk.session.hub.robot:
            return
        stepped = self._desk.stepped
        match stamped.event:
            case RunStarted() if not self.is_of_running:
                stepped.forget()
            case RunEnded() as end:
                self._look_at_what_is_left(end.variables)
                if end.outcome is Outcome.COMPLETED:
                    self._desk.tell(*stepped.ended())
            case event:
                stepped.hear(event)

    def _look_at_what_is_left(self, variables: Mapping[str, int]) -> None:
        run = self._desk.session.run
        if run is None or not run.was_refused:
            self._desk.watch.look(self._desk.session, variables.items())

    def ask(self) -> Wish:
        """Say where the program is, and ask until it is clear how to go on."""
        self._tell()
        while True:
            wish = self._wish_of(self._desk.asking.read(PROMPT))
            if wish is not None:
                self._go(wish)
                return wish

    def _tell(self) -> None:
        frames = self._desk.session.frames
        line, column = self._control.held_at if self._control else (0, 0)
        self._desk.watch.look(self._desk.session, frames[0].variables if frames else ())
        if self._desk.is_pausing or not line:
            self._desk.answer("answer-paused-at", line=frames[0].line if frames else 1)
        at = line or (frames[0].line if frames else 0)
        if 0 < at <= len(self._desk.program.lines):
            self._desk.place = at
        was_paused = self._desk.is_pausing
        self._desk.tell(*self._desk.stepped.held((line, column), frames, was_paused=was_paused))
        self._desk.is_pausing = False

    def _go(self, wish: Wish) -> None:
        self.is_held, self.is_stepped = False, wish.goes in (Goes.STEP, Goes.OVER)
        if not self.is_stepped:
            self._desk.stepped.goes_on()
