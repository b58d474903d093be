"""The compiled and the interpreted program do the same, for any program."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from hypothesis import given, settings
from hypothesis import strategies as st

from language.control import ExecutionControl
from language.diagnostics import LanguageError, ProgramError
from language.runtime import Memory, Runnable
from tests.effort import examples
from tests.properties.programs import programs
from tests.properties.random_programs import ProgramWriter
from tests.unit.language_back.recorder import Make, Recorder, fast, hooked, interpreted_program, read

MOST_VISITS = 300


class Enough(Exception):
    """The program has run long enough to be compared."""


@dataclass
class Seen:
    """Everything observable of a run."""

    visits: list[tuple[int, int, int]]
    done: list[tuple[object, ...]]
    variables: list[dict[str, int]]
    procedures: list[str]
    errors: list[object]


def observe(batches: list[str], make: Make, *, traced: bool) -> Seen:
    """Run some batches with one memory, each to its end or its mistake."""
    memory, actions = Memory(), Recorder()
    seen = Seen([], actions.done, [], [], [])
    for number, batch in enumerate(batches):
        program = make(read(batch, 1 + 1000 * number), terminal=len(batches) > 1)
        seen.errors.append(ending(program, actions, memory, seen.visits if traced else None))
        seen.variables.append(dict(memory.variables))
        seen.procedures = sorted(memory.procedures)
    return seen


def ending(program: Runnable, actions: Recorder, memory: Memory, visits: list[Any] | None) -> object:
    limit = len(visits) + MOST_VISITS if visits is not None else 0

    def visit(*place: int) -> None:
        assert visits is not None
        visits.append(place)
        if len(visits) >= limit:
            raise Enough

    try:
        program.run(actions, ExecutionControl(), memory, trace=None if visits is None else visit)
    except ProgramError as error:
        return error.diagnostic, error.calls
    except (LanguageError, Enough) as error:
        return type(error)
    return None


def compare(batches: list[str]) -> None:
    expected = observe(batches, interpreted_program, traced=True)
    assert observe(batches, hooked, traced=True) == expected
    if Enough not in expected.errors:
        expected.visits = []
        assert observe(batches, fast, traced=False) == expected


@settings(max_examples=examples(500))
@given(seed=st.integers(0, 2**32))
def test_a_program_does_the_same_in_every_back_end(seed: int) -> None:
    compare([ProgramWriter(seed).program()])


@settings(max_examples=examples(150))
@given(seed=st.integers(0, 2**32), count=st.integers(2, 4))
def test_batches_typed_one_after_the_other_do_the_same_in_every_back_end(seed: int, count: int) -> None:
    writer = ProgramWriter(seed)

    compare([writer.program() for _ in range(count)])


@settings(max_examples=examples(30))
@given(programs(language="en", runnable=True, layouts=False))
def test_an_ordinary_program_does_the_same_in_every_back_end(source: str) -> None:
    compare([source])
