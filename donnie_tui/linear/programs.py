"""The typed program of each robot, its breakpoints, and the copies that keep it when it can't be saved.

Rule: no typed line is lost, whether the power fails, Donnie is killed or the terminal is gone.
"""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Iterator
from pathlib import Path

from donnie_tui.core.breakpoints import KeptBreakpoints
from donnie_tui.core.copies import Copies
from donnie_tui.core.documents import DocumentError
from donnie_tui.core.typed_program import TypedProgram
from donnie_tui.linear.safekeeping import Quiet, Safekeeping

MOST_LINES_COPIED = 5000
"""Lines that are written down anew with each that is typed."""


class Programs:
    """Those of a conversation: the one of the robot that is talked to, and the others'."""

    def __init__(
        self, robot: Callable[[], str], copies: Copies, kept_breakpoints: KeptBreakpoints, console: Quiet
    ) -> None:
        """``robot`` tells the name of the one that is talked to, ``console`` when there is time.

        ``copies`` keep a program which can't be kept otherwise.
        """
        self.current = TypedProgram()
        """Of the robot that is talked to."""
        self.copies = copies
        self._robot = robot
        self._by_robot: dict[str, TypedProgram] = {}
        """Of the robots that were talked to; this one's is not up to date."""
        self._copies: dict[TypedProgram, Copies] = {}
        self._kept_breakpoints = kept_breakpoints
        self._safekeeping = Safekeeping(console, self._unsaved, self.keep_for_later)

    def close(self) -> None:
        self._safekeeping.end()

    def change_robot(self, before: str) -> None:
        """After ``before`` another robot is talked to: its own program is the current one."""
        self._by_robot[before] = self.current
        self.current = self._by_robot.setdefault(self._robot(), TypedProgram())

    def by_robot(self) -> dict[str, TypedProgram]:
        """Those of all robots that were talked to, by name."""
        self._by_robot[self._robot()] = self.current
        return dict(self._by_robot)

    def all(self) -> tuple[TypedProgram, ...]:
        """Of all robots, the one that is talked to first."""
        others = (each for name, each in self._by_robot.items() if name != self._robot())
        return (self.current, *others)

    @contextlib.contextmanager
    def as_current(self, program: TypedProgram) -> Iterator[None]:
        """For a while that one is the current one, whoever is talked to."""
        before, self.current = self.current, program
        try:
            yield
        finally:
            self.current = before

    # --- breakpoints

    def bring_breakpoints(self) -> None:
        """Those that the file just opened had the last time."""
        program = self.current
        program.breakpoints = self._kept_breakpoints.of(_path_of(program), len(program.lines))

    def keep_breakpoints(self) -> None:
        """For the next time that this program is opened."""
        self._kept_breakpoints.keep(_path_of(self.current), self.current.breakpoints)

    # --- copies

    def keep_copy(self) -> None:
        """What was typed is written down: the power may fail, Donnie may be killed."""
        if sum(len(each.lines) for each in self.all()) <= MOST_LINES_COPIED:
            self._safekeeping.look()

    def keep_for_later(self) -> None:
        """Save what is not saved beside everything else; quietly, since nobody may be there to hear."""
        for program in self.all():
            if not program.saved and program.lines:
                with contextlib.suppress(DocumentError, OSError):
                    self.copies_of(program).keep(program.text, _path_of(program))
            else:
                self.copies_of(program).forget()

    def copies_of(self, program: TypedProgram) -> Copies:
        """Each robot's program has a copy of its own."""
        if program not in self._copies:
            self._copies[program] = self.copies.another() if self._copies else self.copies
        return self._copies[program]

    def forget_copies(self) -> None:
        """Leaving on purpose: nothing is missed."""
        self._safekeeping.end()
        for copies in self._copies.values():
            copies.forget()

    def _unsaved(self) -> tuple[tuple[str, str | None], ...]:
        return tuple((each.text, each.name) for each in self.all() if not each.saved)


def _path_of(program: TypedProgram) -> Path | None:
    return Path(program.name) if program.name else None
