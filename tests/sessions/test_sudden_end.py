"""Sessions that end at random moments leave whole files; ``tests.tools.sudden_end`` has more."""

from __future__ import annotations

import os
import signal
from pathlib import Path

import pytest

from donnie_tui.tui import full_screen
from donnie_tui.tui.app import DonnieApp
from tests.timeouts import TIMEOUT
from tests.tools.fuzz_screens import ForkedScreen
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


class LeavingScreen(ForkedScreen):
    """It is sent SIGTERM in the moment in which it leaves for another world, or between the two screens."""

    is_between = False

    def _be_the_program(self, arguments: list[str], folder: Path) -> int:
        owner, name = (full_screen, "_in_next_world") if self.is_between else (DonnieApp, "keep_input")
        usual = getattr(owner, name)

        def end(app: DonnieApp) -> object:
            os.kill(os.getpid(), signal.SIGTERM)
            return usual(app)

        setattr(owner, name, end)  # in the child only
        return super()._be_the_program(arguments, folder)


class BetweenScreens(LeavingScreen):
    is_between = True


@pytest.mark.parametrize(
    ("kind", "code"), [(LeavingScreen, 128 + signal.SIGTERM), (BetweenScreens, -signal.SIGTERM)]
)
def test_a_signal_ends_a_screen_that_goes_to_another_world(
    tmp_path: Path, kind: type[LeavingScreen], code: int
) -> None:
    screen = kind(tmp_path)
    try:
        screen.wait_until_loaded()
        screen.press("FW 3\rTR 90\rCHALLENGE 2\r")
        screen.read_while(lambda: not screen.has_ended and screen.shown.count(b"\x1b[?1049h") < 2)
        assert screen.has_ended, "it is in the other world"
        assert screen.end() == code
        copies = [each.read_text() for each in tmp_path.rglob("unsaved*.gd")]
        assert copies == ["FW 3\nTR 90\n"]
    finally:
        screen.close()
