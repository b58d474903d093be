"""The border between a running program and everything else: its actions, its memory, the way to run it.

The core implements ``Actions`` with a robot and a stream of events, tests with a list. An action may raise
``ActionRefused``; the runtime adds the place. After a stop interrupts an action, the runtime raises
``Stopped`` at its next checkpoint. Every back end turns a program into a ``Runnable``.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable
from typing import Protocol, TypeAlias, TypeVar

from msgspec import Struct, field

from devices.ports.robot import Bearing
from language.control import ExecutionControl
from language.syntax import Axis, DeclaredProcedure


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

    def grip(self) -> None: ...

    def release(self) -> None: ...

    def announce_pose(self) -> None: ...

    def wait(self, seconds: int) -> None: ...

    def belt(self, on: bool) -> None: ...

    def vibrate(self, bearing: Bearing) -> None: ...

    def help(self, topic: str | None) -> None: ...

    def distance(self, bearing: Bearing) -> int: ...

    def named_distance(self, name: str) -> int: ...

    def position(self, axis: Axis) -> int: ...

    def colour(self, colour: str) -> int: ...

    def overwritten(self, name: str) -> None:
        """In the terminal a later batch declared a variable or procedure again."""


class Memory(Struct):
    """The names that one batch leaves to the next in the terminal; a file starts with an empty memory."""

    variables: dict[str, int] = field(default_factory=dict)
    """By folded name."""
    procedures: dict[str, DeclaredProcedure] = field(default_factory=dict)
    """By folded name."""

    def forget(self) -> None:
        self.variables.clear()
        self.procedures.clear()


class Frame(Struct, frozen=True):
    """One open call of a running program, or the program itself, for front ends."""

    procedure: str
    """The name as declared; empty for the program itself."""
    line: int
    variables: tuple[tuple[str, int], ...]


Trace: TypeAlias = Callable[[int, int, int], None]
"""Called with the line, the column and the number of open calls before each statement."""

_MOST_FRAMES = 100
"""The length of ``frames`` in a deep recursion."""

_Frame = TypeVar("_Frame")


class Runnable(Protocol):
    """A compiled program."""

    def run(
        self, actions: Actions, control: ExecutionControl, memory: Memory, *, trace: Trace | None = None
    ) -> None:
        """Run to the end, in this thread.

        Raises ``ProgramError``, ``Stopped``, ``QuitRequested``, or the exception of an action. In all cases
        the memory then holds the program's variables and procedures.
        """

    def frames(self) -> tuple[Frame, ...]:
        """The open calls and the program, innermost first; from any thread, empty unless it runs.

        In a recursion deeper than 100 only the innermost frames and the program.
        """

    def progress(self) -> Hashable:
        """The place of the program and the values of all that it counts; for its own thread.

        If it is equal before two statements, and the robot and its world are the same, too, then the program
        does for ever what it did in between. Needs a program that was compiled with hooks.
        """


def shown_frames(stack: list[_Frame]) -> list[_Frame]:
    """The part of a stack that ``frames`` shows, innermost first. The stack begins with the program."""
    shown = stack if len(stack) <= _MOST_FRAMES else [stack[0], *stack[1 - _MOST_FRAMES :]]
    return shown[::-1]
