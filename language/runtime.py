"""What a running program asks of the world around it, what it leaves behind, and how it is run.

``Actions`` is the whole border between the language and everything else: the core implements it with a
robot and a stream of events, tests with a list. An action may raise ``Refused``; the runtime adds the
place. After an action was cut short by a stop, the runtime raises ``Stopped`` at its next checkpoint.
``Runnable`` is what every back end makes of a program.
"""

from __future__ import annotations

from collections.abc import Callable

from devices.ports.hints import TYPE_CHECKING, Protocol, TypeAlias
from devices.ports.robot import Bearing
from devices.ports.values import Frozen, Mutable, field
from language.control import ExecutionControl
from language.scopes import Declared
from language.syntax import Axis


class Actions(Protocol):
    """The commands of GoDonnie. ``command`` is the command as it was typed, for STATE and HISTORY."""

    def speak(self, what: int | str) -> None: ...

    def sound(self, on: bool) -> None: ...

    def forward(self, steps: int, command: str) -> None: ...

    def backward(self, steps: int, command: str) -> None: ...

    def turn_right(self, degrees: int, command: str) -> None: ...

    def turn_left(self, degrees: int, command: str) -> None: ...

    def scan(self) -> None: ...

    def state(self) -> None: ...

    def history(self) -> None: ...

    def tell_position(self) -> None: ...

    def wait(self, seconds: int) -> None: ...

    def belt(self, on: bool) -> None: ...

    def vibrate(self, bearing: Bearing) -> None: ...

    def help(self, topic: str | None) -> None: ...

    def distance(self, bearing: Bearing) -> int: ...

    def position(self, axis: Axis) -> int: ...

    def colour(self, colour: str) -> int: ...

    def overwritten(self, name: str) -> None:
        """In the terminal a later batch declared a variable or procedure again."""


class Memory(Mutable):
    """What one batch leaves to the next in the terminal; a file starts with an empty one."""

    variables: dict[str, int] = field(default_factory=dict)
    """By folded name."""
    procedures: dict[str, Declared] = field(default_factory=dict)
    """By folded name."""

    def forget(self) -> None:
        self.variables.clear()
        self.procedures.clear()


class Frame(Frozen):
    """One level of a running program, for front ends: the program itself or a procedure."""

    procedure: str
    """The name as declared; empty for the program itself."""
    line: int
    variables: tuple[tuple[str, int], ...]


Trace: TypeAlias = Callable[[int, int, int], None]
"""Told the line, the column and the number of open calls before each statement."""

_MOST_FRAMES = 100
"""What ``frames`` tells of a deep recursion."""

if TYPE_CHECKING:
    from typing import TypeVar

    _Level = TypeVar("_Level")


class Runnable(Protocol):
    """A compiled program."""

    def run(
        self, actions: Actions, control: ExecutionControl, memory: Memory, *, trace: Trace | None = None
    ) -> None:
        """Run to the end, in this thread.

        Raises ``ProgramError``, ``Stopped``, ``QuitRequested``, or whatever an action raised. The memory
        holds the program's variables and procedures then, as it does after the end.
        """

    def frames(self) -> tuple[Frame, ...]:
        """The open calls and the program, innermost first; from any thread, empty unless it runs.

        Of a recursion deeper than 100 only the innermost frames and the program are told.
        """


def told_levels(levels: list[_Level]) -> list[_Level]:
    """Of levels from the program inwards those that ``frames`` tells, innermost first."""
    told = levels if len(levels) <= _MOST_FRAMES else [levels[0], *levels[1 - _MOST_FRAMES :]]
    return told[::-1]
