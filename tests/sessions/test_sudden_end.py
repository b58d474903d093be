"""Sessions that end by SIGKILL at random moments leave whole files; ``tests.tools.sudden_end`` has more."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.timeouts import TIMEOUT
from tests.tools.sudden_end import end_suddenly, made

pytestmark = pytest.mark.slow

SEED, CASES = 12, 8


@pytest.mark.parametrize("number", range(CASES))
def test_a_session_that_ends_suddenly_leaves_whole_files(tmp_path: Path, number: int) -> None:
    """How much is lost at most is up to the tool: here the machine may be busy."""
    end_suddenly(made(SEED, number), tmp_path, at_most=TIMEOUT)


@pytest.mark.parametrize("mode", ["robot", "screen"])
@pytest.mark.parametrize("number", range(3))
def test_the_same_holds_in_the_full_screen_and_a_robot_stands(tmp_path: Path, number: int, mode: str) -> None:
    end_suddenly(made(SEED, number), tmp_path, at_most=TIMEOUT, mode=mode)


def test_the_cases_end_while_lines_are_typed_saved_and_run() -> None:
    ends = [made(SEED, number).steps[-1] for number in range(CASES)]

    assert {"RUN", "SAVE work"} < {*ends}
    assert any(each.startswith(("SPEAK", "FW")) for each in ends)
