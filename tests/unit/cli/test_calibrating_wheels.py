"""``donnie calibrate``: which measures are taken, doubted or refused, and what is kept of them."""

from __future__ import annotations

import io
import sys
from argparse import Namespace
from pathlib import Path
from types import SimpleNamespace

import pytest

from devices.ports.robot import LinkNotice, Pose, StoppedBy, TurnResult, WalkResult
from devices.wire.telemetry import Telemetry
from donnie_tui.cli.calibrate import calibrate
from donnie_tui.cli.options import ExitCode, Invocation, Order
from donnie_tui.cli.streams import Output
from donnie_tui.i18n.words import Unusable, Words
from donnie_tui.settings.folders import account_settings_file
from donnie_tui.settings.parsing import read_file
from donnie_tui.settings.settings import Settings


class Robot:
    """Counts 900 times a turn, as the original: 7162 times in a metre with wheels of 20 millimetres.

    And 2250 times while it turns twice on the spot, if its axle is two and a half times as long.
    """

    has_run_away = may_drive_on = False
    port = "/dev/robot"

    def __init__(self, stopped_by: StoppedBy | None) -> None:
        self.stopped_by = stopped_by
        self.telemetry = Telemetry(right=100, left=-200)
        self.done: list[str] = []

    def connect(self) -> None:
        self.done.append("connect")

    def forward(self, steps: int) -> WalkResult:
        self.done.append(f"forward {steps}")
        self.telemetry = Telemetry(right=100 + 7262, left=-200 + 7062)
        return WalkResult(steps, steps, self.stopped_by, Pose(0, 0, 0))

    def turn(self, degrees: int) -> TurnResult:
        self.done.append(f"turn {degrees}")
        before = self.telemetry
        self.telemetry = Telemetry(right=before.right - 2200, left=before.left + 2300)
        return TurnResult(degrees, degrees, self.stopped_by, Pose(0, 0, 0))

    def close(self) -> None:
        self.done.append("close")


class Wheels:
    """One start of the command."""

    stopped_by: StoppedBy | None = None

    def __init__(self, folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        self.environment = {"XDG_CONFIG_HOME": str(folder), "HOME": str(folder)}
        self.report: object = None
        self.robot: Robot | None = None
        self.guarded: list[str] = []
        self._monkeypatch = monkeypatch
        monkeypatch.setattr("donnie_tui.cli.calibrate.Guard", self._guard)

    def run(self, typed: str, robot: str = "double", given: str | None = None) -> int:
        self._monkeypatch.setattr(sys, "stdin", io.StringIO(typed))
        invocation = Invocation("calibrate", {} if given is None else {"robot": given}, Namespace())
        order = Order(invocation, Settings(robot=robot), Words("en"), Output(), self.environment)
        return calibrate(order, self._made)  # type: ignore[arg-type] # it does what is needed here

    def _guard(self, port: str) -> SimpleNamespace:
        """In place of a process."""
        self.guarded.append(port)
        return SimpleNamespace(end=lambda *, may_drive_on: self.guarded.append(f"ends {may_drive_on}"))

    def _made(self, _settings: object, _words: object, _pace: object, report: object) -> Robot:
        self.report, self.robot = report, Robot(self.stopped_by)
        return self.robot


@pytest.fixture
def wheels(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Wheels:
    return Wheels(tmp_path, monkeypatch)


NUMBER, ABSURD = "Type a number, please.", "That number can't be right. I do not count it."


def far(typed: str, expected: int) -> str:
    return f"{typed} is far from {expected}."


@pytest.mark.parametrize(
    ("typed", "answers"),
    [
        ("\n100\n\n\n", ["Wheel radius 20.00 "]),
        ("\n98,5\n\n\n", ["Wheel radius 19.70 "]),
        ("\n51\n\n\n", ["Wheel radius 10.20 "]),
        ("\n199\n\n\n", ["Wheel radius 39.80 "]),
        ("\n50\n\n\n\n", [far("50", 100)]),
        ("\n200\n\n\n\n", [far("200", 100)]),
        ("\n200\n300\n200\n\n\n\n", [far("200", 100), far("300", 100), far("200", 100)]),
        ("\n200\n200\n\n\n", [far("200", 100), "Wheel radius 40.00 "]),
        ("\n1,5\n1.5\n\n\n", [far("1,5", 100), ABSURD]),
        ("\n0\n-1\nfar\n1e6\nnan\n\n\n\n", [NUMBER] * 5),
        ("\n5000\n5000\n\n\n", [far("5000", 100), "Wheel radius 1000.00 "]),
        ("\n5001\n5001\n\n\n", [far("5001", 100), ABSURD]),
        ("\n5,1\n5,1\n\n\n", [far("5,1", 100), "Wheel radius 1.02 "]),
        ("\n4,9\n4,9\n\n\n", [far("4,9", 100), ABSURD]),
        ("\n\n\n720\n", ["Axle 52.50 "]),
        ("\n\n\n361\n", ["Axle 104.71 "]),
        ("\n\n\n360\n\n", [far("360", 720)]),
        ("\n\n\n1440\n\n", [far("1440", 720)]),
        ("\n\n\n1\n1\n", [far("1", 720), ABSURD]),
        ("\n100\n\n720", ["Wheel radius 20.00 ", "Axle 50.00 "]),
        ("98\n\n100\n\n\n", ["Press Enter alone, please.", "Wheel radius 20.00 "]),
    ],
    ids=repr,
)
def test_a_measure_near_the_expected_one_or_typed_twice_is_taken(
    typed: str, answers: list[str], wheels: Wheels, capsys: pytest.CaptureFixture[str]
) -> None:
    is_measured = answers[-1].startswith(("Wheel", "Axle"))
    assert wheels.run(typed) == (0 if is_measured else 1)

    said = capsys.readouterr().out.splitlines()
    questions = ("Put ", "Mark ", "How many ", "That was ", "Nothing ")
    heard = [each for each in said if not each.startswith(questions)]
    assert [line[: len(each)] for line, each in zip(heard, answers, strict=True)] == answers
    end = "That was a simulated board. Nothing is saved."
    assert said[-1] == (end if is_measured else "Nothing was measured. Nothing has changed.")
    assert wheels.robot is not None
    assert wheels.robot.done == ["connect", "forward 20", "turn 720", "close"]
    assert wheels.guarded == []
    assert read_file(account_settings_file(wheels.environment)) == ({}, ())


@pytest.mark.parametrize(
    ("typed", "kept"),
    [
        ("\n100\n\n720\n", {"wheel_radius": 0.02, "axle_length": 0.05}),
        ("\n98.765\n\n\n", {"wheel_radius": 0.01975}),
        ("\n\n\n720\n", {"axle_length": 0.0525}),
    ],
)
def test_the_sizes_of_a_real_robot_are_kept_in_metres(
    typed: str, kept: object, wheels: Wheels, capsys: pytest.CaptureFixture[str]
) -> None:
    assert wheels.run(typed, "serial:/dev/robot") == ExitCode.DONE
    assert read_file(account_settings_file(wheels.environment)) == (kept, ())
    assert wheels.guarded == ["/dev/robot", "ends False"]
    assert capsys.readouterr().out.splitlines()[-1] == "I saved it in the settings."


@pytest.mark.parametrize(
    ("stopped_by", "code", "said"),
    [
        (StoppedBy.LINK, ExitCode.UNUSABLE, ["I have stopped here. Nothing has changed."]),
        (StoppedBy.RUNAWAY, ExitCode.FAILED, ["I have stopped here. Nothing has changed."]),
        (
            StoppedBy.STALL,
            ExitCode.FAILED,
            ["Something stopped the robot. I do not count this walk or turn."],
        ),
        (
            StoppedBy.WRONG_WAY,
            ExitCode.FAILED,
            [
                "My wheels count the wrong way.",
                "See encoders, motors and profile in the settings.",
                "Something stopped the robot. I do not count this walk or turn.",
            ],
        ),
    ],
)
def test_what_stops_the_robot_is_not_measured(
    stopped_by: StoppedBy,
    code: ExitCode,
    said: list[str],
    wheels: Wheels,
    capsys: pytest.CaptureFixture[str],
) -> None:
    wheels.stopped_by = stopped_by
    assert wheels.run("\n") == code
    assert capsys.readouterr().out.splitlines()[2 : 2 + len(said)] == said
    assert wheels.robot is not None
    assert wheels.robot.done[-1] == "close"


def test_only_what_is_wrong_with_the_line_is_said(wheels: Wheels, capsys: pytest.CaptureFixture[str]) -> None:
    wheels.run("")
    capsys.readouterr()
    for news in (LinkNotice.CONNECTED, LinkNotice.LOST):
        wheels.report(news, "")  # type: ignore[operator] # it is a function

    assert capsys.readouterr().out == "Robot lost. If it moves, switch it off.\n"


def test_the_simulator_has_no_wheels(wheels: Wheels) -> None:
    with pytest.raises(Unusable, match="The simulator has no wheels to measure"):
        wheels.run("", given="sim")
    assert wheels.robot is None
