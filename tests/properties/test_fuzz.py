"""The tool that tries random input: some cases of each kind hold; a failure is made small and printed."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.effort import examples
from tests.tools import fuzz
from tests.tools.fuzz import KINDS, Input, Kind

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
