"""The typed program of each robot, its breakpoints, and the copies that keep it when it can't be saved.

Rule: no typed line is lost, whether the power fails, Donnie is killed or the terminal is gone. While somebody
thinks, it is written down (``Safekeeping``). In a burst, where each line would have the whole program written
anew, it is put off: until nothing more is typed, though a line may be half done by then or a program run,
and for no longer than ``SOON``.
"""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Iterator
from functools import cached_property

from devices.ports.hints import TYPE_CHECKING, Protocol
from donnie_tui.core.breakpoints import KeptBreakpoints
from donnie_tui.core.typed_program import TypedProgram
from donnie_tui.linear.greeting import has_rescued

if TYPE_CHECKING:
    from pathlib import Path

    from donnie_tui.core.copies import Copies, CopyKeeping
    from donnie_tui.core.documents import DocumentError

MOST_REPLACED = 5
"""Programs that another one took the place of, and that are left for the next start."""


class Programs:
    """Those of a conversation: the one of the robot that is talked to, and the others'."""

    def __init__(
        self,
        robot: Callable[[], str],
        folder: str,
        kept_breakpoints: KeptBreakpoints,
        console: Quiet,
        not_kept: Callable[[DocumentError], None],
    ) -> None:
        """``robot`` tells the name of the one that is talked to, ``console`` when there is time.

        ``folder`` has the copies of a program which can't be kept otherwise; ``not_kept`` is told once, in
        another thread, why that fails.
        """
        self.current = TypedProgram()
        """Of the robot that is talked to."""
        self._robot = robot
        self._by_robot: dict[str, TypedProgram] = {}
        """Of the robots that were talked to; this one's is not up to date."""
        self._copies: dict[TypedProgram, Copies] = {}
        self._copies_of_replaced: dict[tuple[str, str | None], Copies] = {}
        self._kept_breakpoints = kept_breakpoints
        self._folder, self._not_kept = folder, not_kept
        self._safekeeping = Safekeeping(console, self._unsaved, self._keep_beside)

    def close(self) -> None:
        self._safekeeping.end()

    def take_over(self, before: Programs) -> None:
        """All programs of the world before: the current one stays so, the others wait for their robots."""
        self.current, self.copies, self._copies = before.current, before.copies, before._copies
        self._copies_of_replaced = before._copies_of_replaced
        here = self._robot()
        others = {name: each for name, each in before.by_robot().items() if each is not self.current}
        self._by_robot = {f"{name} 2" if name == here else name: each for name, each in others.items()}

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

    @property
    def files(self) -> tuple[Path | None, ...]:
        """Of all of them."""
        return tuple(_path_of(each) for each in self.all())

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

    @property
    def has_rescued(self) -> bool:
        """Whether a crash left a program."""
        return has_rescued(self._folder)

    @cached_property
    def copies(self) -> Copies:
        """Those of the first program that has some."""
        from donnie_tui.core.copies import Copies  # for what was typed

        return Copies(self._folder)

    @cached_property
    def _keeping(self) -> CopyKeeping:
        from donnie_tui.core.copies import CopyKeeping

        return CopyKeeping(self._not_kept)

    def keep_copy(self) -> None:
        """What was typed is written down: the power may fail, Donnie may be killed."""
        self._safekeeping.look()

    def keep_for_later(self) -> None:
        """Save what is not saved beside everything else; quietly, since nobody may be there to hear."""
        for copies in (*self._wanted_of_replaced(), *self._wanted(self.all())):
            copies.settle_quietly()

    def _keep_beside(self) -> None:
        """As ``keep_for_later``, while whoever types goes on."""
        for copies in (*self._wanted_of_replaced(), *self._wanted(self.all())):
            self._keeping.bring_up(copies)

    def _wanted_of_replaced(self) -> tuple[Copies, ...]:
        """Of the newest programs that another one took the place of, and of those that are back."""
        known, replaced = self._copies_of_replaced, self._replaced
        gone = [known.pop(each) for each in known.keys() - replaced]
        for copies in gone:
            copies.want_none()
        for text, name in (each for each in replaced if each not in known):
            known[text, name] = self.copies.another()
            known[text, name].follow(text, _path(name), is_saved=False)
        return (*gone, *known.values())

    @property
    def _replaced(self) -> list[tuple[str, str | None]]:
        return [each for program in self.all() for each in program.replaced][-MOST_REPLACED:]

    def _wanted(self, programs: tuple[TypedProgram, ...]) -> Iterator[Copies]:
        """The copies of each, which know now what is wanted of them."""
        for program in programs:
            copies = self.copies_of(program)
            copies.follow(program.text, _path_of(program), is_saved=program.saved)
            yield copies

    def copies_of(self, program: TypedProgram) -> Copies:
        """Each robot's program has a copy of its own."""
        if program not in self._copies:
            self._copies[program] = self.copies.another() if self._copies else self.copies
        return self._copies[program]

    def leave_copies(self, *, of_all: bool) -> None:
        """Leaving on purpose: what is not saved can be asked for the next time.

        ``of_all``: not only of what came out of a copy, because no file has what somebody typed, nor what
        it was that NEW or OPEN took the place of.
        """
        self._safekeeping.end()
        if of_all:
            self._leave_replaced()
        for copies in self._wanted(self.all() if of_all else tuple(self._copies)):
            copies.settle_quietly()
        for copies in self._copies.values():
            copies.leave()

    def _leave_replaced(self) -> None:
        for copies in self._wanted_of_replaced():
            copies.settle_quietly()
        for copies in self._copies_of_replaced.values():
            copies.leave()

    def hand_over(self) -> None:
        """Somebody else goes on with the current program; the others are offered there."""
        self.close()
        self.keep_for_later()
        self._leave_replaced()
        self.copies_of(self.current).forget()

    def _unsaved(self) -> tuple[tuple[str, str | None], ...]:
        return (*((each.text, each.name) for each in self.all() if not each.saved), *self._replaced)


def _path_of(program: TypedProgram) -> Path | None:
    return _path(program.name)


def _path(name: str | None) -> Path | None:
    if not name:
        return None
    from pathlib import Path  # slow to load, and what is typed first has no file

    return Path(name)


SOON = 1.0
"""Seconds between two copies in a burst."""


class Quiet(Protocol):
    """What the console knows of the typing."""

    when_idle: Callable[[], None] | None

    def now(self) -> float: ...

    def has_input(self) -> bool: ...


class Safekeeping:
    """Looks at each prompt."""

    def __init__(self, console: Quiet, unsaved: Callable[[], object], write: Callable[[], None]) -> None:
        """``unsaved`` tells what is not saved, ``write`` writes it down, or removes what was."""
        self._console = console
        self._unsaved, self._write = unsaved, write
        self._copied: object = ()
        self._due = console.now()

    def look(self) -> None:
        """A prompt is shown."""
        if self._console.has_input() and self._console.now() < self._due:
            self._console.when_idle = self._keep
        else:
            self._keep()

    def end(self) -> None:
        """What was put off is wanted no more."""
        self._console.when_idle = None

    def _keep(self) -> None:
        self.end()
        unsaved = self._unsaved()
        if unsaved != self._copied:
            self._copied, self._due = unsaved, self._console.now() + SOON
            self._write()
