"""A program that is held between two statements: what is told then, and what somebody wants next."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from enum import Enum, auto
from typing import TYPE_CHECKING

from devices.ports.values import frozen
from donnie_tui.core.events import Outcome, Read, RunEnded, RunStarted, Stamped
from donnie_tui.i18n.first_words import PROMPT
from donnie_tui.linear.desk import Desk
from donnie_tui.linear.reader import Typed
from language.control import ControlState, ExecutionControl
from language.runtime import Frame

if TYPE_CHECKING:
    from donnie_tui.core.step_words import StepWords


class Goes(Enum):
    """How a held program goes on."""

    STEP = auto()
    OVER = auto()
    UNTIL = auto()
    ON = auto()
    STOP = auto()


@frozen
class Wish:
    """What somebody wants of a held program."""

    goes: Goes
    line: int = 0
    """For ``UNTIL``."""


class Holding:
    """Tells each hold of one run after the other."""

    def __init__(self, desk: Desk, wish_of: Callable[[Typed], Wish | None]) -> None:
        self._desk = desk
        self._wish_of = wish_of
        self._words: StepWords | None = None
        self._control: ExecutionControl | None = None
        self._text, self._first_line = "", 1
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
        self._words, self._text, self._first_line = None, text, first_line
        self._desk.stepped.begin()
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
        match stamped.event:
            case RunStarted() if not self.is_of_running:
                self._desk.stepped.begin()
            case Read() as read if self._words is not None and self.is_of_running:
                self._words.heard(read)
            case RunEnded() as end:
                self._look_at_what_is_left(end.variables)
                if end.outcome is Outcome.COMPLETED and self._words is not None and self.is_of_running:
                    self._desk.tell(*self._words.ended())

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
        if self._words is None:
            from donnie_tui.core.step_words import StepWords  # a program that is held

            program = self._desk.session.parse(self._text, self._first_line).program
            lines, is_first = self._desk.program.lines, not self._desk.is_pausing
            self._words = StepWords(program, lines, self._desk.say, is_first=is_first)
        line, column = self._control.held_at if self._control else (0, 0)
        self._desk.watch.look(self._desk.session, frames[0].variables if frames else ())
        if self._desk.is_pausing or not line:
            self._desk.answer("answer-paused-at", line=frames[0].line if frames else 1)
        at = line or (frames[0].line if frames else 0)
        if 0 < at <= len(self._desk.program.lines):
            self._desk.place = at
        if line:  # else in the middle of a movement or a wait
            told = self._words.held(line, column, frames)
            self._desk.stepped.held(self._desk.donnie.chronicle.last_seq, told, variables_of(frames))
            self._desk.tell(*told)
        self._desk.is_pausing = False

    def _go(self, wish: Wish) -> None:
        self.is_held, self.is_stepped = False, wish.goes in (Goes.STEP, Goes.OVER)
        if not self.is_stepped and self._words is not None:
            self._words.lose_count()
            self._desk.stepped.goes_on()


def variables_of(frames: Sequence[Frame]) -> dict[str, int]:
    """Those that can be seen there, by name."""
    return dict(frames[0].variables) if frames else {}
