"""Actions that only record their calls, and functions that run a text on them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

from devices.ports.robot import Bearing
from language.compiler import compile_program
from language.control import ExecutionControl
from language.diagnostics import ActionRefused, Diagnostic, LanguageError, MistakeKind, ProgramError
from language.parser import parse
from language.runtime import Memory, Runnable
from language.syntax import Axis, Program
from tests.unit.language_back.interpreter import interpreted_program

SENSED = {Bearing.FRONT: 12, Bearing.BACK: 60}


@dataclass
class Recorder:
    """Records each command. The robot is at (3, -4), heading 90; the belt is off at first."""

    done: list[tuple[object, ...]] = field(default_factory=list)
    before: Callable[[str], None] = lambda name: None
    """Called with the name of each command, first."""
    belt_is_on: bool = False

    @property
    def said(self) -> list[object]:
        return [what[1] for what in self.done if what[0] == "speak"]

    def _note(self, name: str, *details: object) -> None:
        self.before(name)
        self.done.append((name, *details))

    def speak(self, what: int | str) -> None:
        self._note("speak", what)

    def sound(self, on: bool) -> None:
        self._note("sound", on)

    def forward(self, steps: int, command: str) -> None:
        self._note("forward", steps, command)

    def backward(self, steps: int, command: str) -> None:
        self._note("backward", steps, command)

    def turn_right(self, degrees: int, command: str) -> None:
        self._note("turn_right", degrees, command)

    def turn_left(self, degrees: int, command: str) -> None:
        self._note("turn_left", degrees, command)

    def scan(self) -> None:
        self._note("scan")

    def state(self) -> None:
        self._note("state")

    def history(self) -> None:
        self._note("history")

    def grip(self) -> None:
        self._note("grip")

    def release(self) -> None:
        self._note("release")

    def announce_pose(self) -> None:
        self._note("announce_pose")

    def wait(self, seconds: int) -> None:
        self._note("wait", seconds)

    def belt(self, on: bool) -> None:
        self._note("belt", on)
        self.belt_is_on = on

    def vibrate(self, bearing: Bearing) -> None:
        self._note("vibrate", bearing)
        if not self.belt_is_on:
            raise ActionRefused(MistakeKind.BELT_OFF)

    def help(self, topic: str | None) -> None:
        self._note("help", topic)

    def distance(self, bearing: Bearing) -> int:
        self._note("distance", bearing)
        return SENSED.get(bearing, 60)

    def named_distance(self, name: str) -> int:
        self._note("named_distance", name)
        return len(name)

    def position(self, axis: Axis) -> int:
        self._note("position", axis)
        return {Axis.X: 3, Axis.Y: -4, Axis.ANGLE: 90}[axis]

    def colour(self, colour: str) -> int:
        self._note("colour", colour)
        return len(colour)

    def overwritten(self, name: str) -> None:
        self._note("overwritten", name)


Make = Callable[..., Runnable]
"""``compile_program`` and its like: takes a program and ``terminal``."""


def fast(program: Program, *, terminal: bool = False) -> Runnable:
    return compile_program(program, terminal=terminal)


def hooked(program: Program, *, terminal: bool = False) -> Runnable:
    return compile_program(program, terminal=terminal, hooked=True)


BACK_ENDS: dict[str, Make] = {"fast": fast, "hooked": hooked, "interpreted": interpreted_program}


@dataclass
class Outcome:
    """The result of a run."""

    actions: Recorder
    variables: dict[str, int]
    error: LanguageError | None

    @property
    def diagnostic(self) -> Diagnostic:
        assert isinstance(self.error, ProgramError), self.error
        return self.error.diagnostic

    @property
    def place(self) -> tuple[str, int, int]:
        return self.diagnostic.kind.value, self.diagnostic.span.line, self.diagnostic.span.column

    @property
    def calls(self) -> list[tuple[str, int]]:
        assert isinstance(self.error, ProgramError)
        return [(call.procedure, call.line) for call in self.error.calls]


def read(source: str, first_line: int = 1) -> Program:
    parsed = parse(source, first_line=first_line)
    assert parsed.program is not None, parsed.diagnostics
    return parsed.program


def run(
    source: str,
    make: Make = fast,
    *,
    terminal: bool = False,
    memory: Memory | None = None,
    actions: Recorder | None = None,
    control: ExecutionControl | None = None,
    first_line: int = 1,
) -> Outcome:
    """Run a text to its end, in any way; other exceptions than those of the language pass."""
    actions, memory = actions or Recorder(), Memory() if memory is None else memory
    error = None
    try:
        program = make(read(source, first_line), terminal=terminal)
        program.run(actions, control or ExecutionControl(), memory)
    except LanguageError as ended:
        error = ended
    return Outcome(actions, memory.variables, error)
