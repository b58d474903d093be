"""The tool that tries random input: some cases of each kind hold; a failure is made small and printed."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path
from random import Random

import pytest

from devices.belt import OFF, BeltDetector, BeltSender, contains_complaint, encode_frame
from language.compiler import compile_program
from language.runtime import Runnable
from language.syntax import Program
from tests.effort import examples
from tests.tools import fuzz, fuzz_serial
from tests.tools.fuzz import KINDS, Input, Kind
from tests.unit.language_back import recorder

SLOW = {"sessions": 3, "screens": 3, "frames": 5}
"""Kinds that need processes or sockets, and how many cases of them are tried."""
QUICK = [name for name in KINDS if name not in SLOW]


@pytest.mark.hypothesis  # random, though seeded: the slow check tries more
@pytest.mark.parametrize("name", QUICK)
def test_cases_of_each_kind_hold(name: str) -> None:
    assert fuzz.fuzz(name, 0, range(examples(100))) == 0


@pytest.mark.slow
@pytest.mark.parametrize("name", SLOW)
def test_cases_of_each_slow_kind_hold(name: str) -> None:
    assert fuzz.fuzz(name, 0, range(SLOW[name])) == 0


def is_found(name: str) -> bool:
    """Whether one of some cases of a kind fails."""
    kind = KINDS[name]
    return any(fuzz.failure_of(kind, kind.make(Random(f"0 {name} {number}"))) for number in range(200))


class Forgetful(BeltDetector):
    """Searches only the end of a long chunk."""

    def receive(self, received: bytes) -> None:
        super().receive(received[-16:])


class Hasty(BeltDetector):
    """Doesn't see a complaint that comes in two chunks."""

    def receive(self, received: bytes) -> None:
        self._is_over |= contains_complaint(received)


class Hoarder(BeltSender):
    def __init__(self) -> None:
        super().__init__()
        self.heard = b""

    def receive(self, received: bytes) -> None:
        super().receive(received)
        self.heard += received


class Deaf(BeltSender):
    def receive(self, received: bytes) -> None:
        pass


class Short(BeltSender):
    """Leaves out the last letter of a frame."""

    def next(self, now: float) -> bytes:
        return super().next(now)[:35]


class Endless(BeltSender):
    """Never turns the belt off."""

    def next(self, now: float) -> bytes:
        data = super().next(now)
        return b"" if data == encode_frame(OFF) else data


@pytest.mark.parametrize("fault", [Forgetful, Hasty, Hoarder, Deaf, Short, Endless])
def test_a_fault_of_the_belt_is_found(fault: type, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(fuzz_serial, fault.__base__.__name__, fault)
    assert is_found("serial")


@pytest.mark.parametrize(
    "sign",
    ["", r"(?i)falar", r"(?i)hablar", r"[-+]\s*\+"],
    ids=["any", "Portuguese", "Spanish", "mutated"],
)
def test_a_fault_of_the_compiler_is_found_in_programs_of_each_sort(
    sign: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The compiler with the fault leaves out the last statement of a program with the sign."""

    def compile_part(program: Program, *, terminal: bool = False, hooked: bool = False) -> Runnable:
        is_faulty = re.search(sign, program.source) is not None
        part = replace(program, body=program.body[:-1]) if is_faulty else program
        return compile_program(part, terminal=terminal, hooked=hooked)

    monkeypatch.setattr(recorder, "compile_program", compile_part)
    assert is_found("runs")


def refuse_x(case: Input) -> None:
    assert "x" not in str(case)


@pytest.fixture
def broken(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> str:
    """A kind that fails for each text with an x."""
    monkeypatch.setattr(fuzz, "FOLDER", tmp_path / "found")
    monkeypatch.setitem(
        KINDS, "broken", Kind(lambda chance: "ab" * chance.randrange(1, 50) + "xyz", refuse_x)
    )
    return "broken"


def test_a_failure_is_made_small_kept_and_printed_with_the_way_to_try_it_again(
    broken: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert fuzz.fuzz(broken, 7, [12]) == 1

    assert (tmp_path / "found" / "broken-7-12").read_text(encoding="utf-8") == "x"
    printed = capsys.readouterr().out
    assert "--kind broken --seed 7 --only 12" in printed
    assert printed.endswith("broken: seed 7, 1 cases, 1 failed\n")


@pytest.mark.usefixtures("broken")
def test_many_failures_end_the_kind(capsys: pytest.CaptureFixture[str]) -> None:
    assert fuzz.fuzz("broken", 1, range(1000)) == fuzz.MOST_FAILURES
    assert capsys.readouterr().out.endswith("10 cases, 10 failed\n")


def test_an_interrupted_kind_says_how_many_cases_were_tried(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def interrupt_at(case: Input) -> None:
        if case == "3":
            raise KeyboardInterrupt

    numbers = iter("0123456")
    monkeypatch.setitem(KINDS, "broken", Kind(lambda _: next(numbers), interrupt_at))

    with pytest.raises(KeyboardInterrupt):
        fuzz.fuzz("broken", 7, range(10))
    assert capsys.readouterr().out == "broken: seed 7, 3 cases, 0 failed\n"


def test_a_case_that_takes_too_long_fails() -> None:
    def compute_without_end(_: Input) -> None:
        while True:
            pass

    kind = Kind(lambda _: "", compute_without_end, seconds=0.1)

    assert isinstance(fuzz.failure_of(kind, ""), fuzz.TooSlow)
