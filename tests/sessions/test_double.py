"""A program that moves does the same on the simulator and on the simulated board of the real robot.

What is compared: the events in their order, with what was asked and done of each movement and why it ended,
what was said, the mistakes, the outcome, the variables. The tolerance: times are the robots' own; a value
that was read, and a number that was said or kept, may be one off, because wheels count and sonars measure
in whole centimetres. The last place may be off by a quarter of a step and half a percent of the way; the
heading by one degree and a quarter, five counts of the wheels, however often it turned: a turn makes up for
what the last one was off, and for what a walk between them was uneven by.
"""

from __future__ import annotations

import contextlib
import io
import json
import re
from math import hypot
from pathlib import Path
from typing import Any

import pytest

from donnie_tui.bootstrap import assemble
from donnie_tui.core.events import Outcome
from donnie_tui.core.runner import RunRequest
from donnie_tui.core.session import RunOptions
from donnie_tui.settings.settings import Settings
from tests.programs.test_conformance import runner  # noqa: F401 -- a fixture
from tests.sessions import command

pytestmark = pytest.mark.slow

TIMEOUT = 300
STEPS, OF_THE_WAY, READING = 0.25, 0.005, 1
DEGREES = 1.25

OWN = Path(__file__).parent.parent / "programs"
PROGRAMS = [
    "FW 3 TR 90 BW 2",
    "TL 45 FW 2 SPEAK POS x SPEAK POS y",
    "FW -3 TR -30 TR 0",
    "FW 5 FW 5",
    "BW 4 STATE",
    "VAR n = DISTANCE F FW n SPEAK n",
    "FOR VAR i = 1; i <= 2; i = i + 1 DO FW i TR 90 END FOR",
    "FW 1 SPEAK q",
    "BELT ON FW 2 VIBRATE F",
    "WAIT 2 FW 1 QUIT",
    "FOR VAR i = 1; i <= 36; i = i + 1 DO FW 1 TR 10 END FOR",
]
NEAR = ("red", 0.0, 6.5)
"""A thing before the robot, so that it meets something."""


def world(folder: Path) -> str:
    from tests import floor

    text = (
        floor._FLOOR
        + f'thing( name "thing" pose [ {NEAR[1] * 0.05} {NEAR[2] * 0.05} 0 0 ] color "{NEAR[0]}" )'
    )
    file = folder / "near.world"
    file.write_text(text, encoding="utf-8")
    return str(file)


def events(text: str, world: str, robot: str, language: str = "en") -> list[dict[str, Any]]:
    """What ``donnie run --events -`` writes of the program, from its first event on."""
    out = io.StringIO()
    settings = Settings(
        world=world, robot=robot, language=language, speed=None, speech="off", sound=False, events="-"
    )
    donnie = assemble(settings, terminal=False, out=out)
    try:
        run = donnie.session.start(text, "test.gd", RunOptions(fresh=True, hooked=False))
        assert run.wait(TIMEOUT)
    finally:
        donnie.close()
    sentences = [json.loads(line) for line in out.getvalue().split("\n") if line]
    began = next(number for number, each in enumerate(sentences) if each["event"] == "run_started")
    return sentences[began:]


def parts_of(event: dict[str, Any]) -> tuple[str, list[float]]:
    """The parts of an event that must be equal, and its numbers, which may be one off."""
    exact = {
        name: value
        for name, value in event.items()
        if name not in ("seq", "t", "pose", "seconds", "version", "levels", "steps", "value", "variables")
    }
    said = str(event.get("text", "")) if event["event"] in ("spoke", "announced") else ""
    if said:
        exact["text"] = re.sub(r"-?\d+", "#", said)
    numbers = [float(each) for each in re.findall(r"-?\d+", said)]
    if "value" in event:
        numbers.append(float(event["value"]))
    numbers += [float(value) for _, value in sorted(event.get("variables", {}).items())]
    return json.dumps(exact, sort_keys=True), numbers


def differences(simulated: list[dict[str, Any]], double: list[dict[str, Any]]) -> list[str]:
    ours, theirs = map(parts_of, _comparable(simulated)), map(parts_of, _comparable(double))
    found = [] if len(_comparable(simulated)) == len(_comparable(double)) else ["another number of events"]
    for (one, numbers), (other, others) in zip(ours, theirs, strict=False):
        if one != other or any(abs(a - b) > READING for a, b in zip(numbers, others, strict=True)):
            found.append(f"{one} {numbers} became {other} {others}")
    here, there = simulated[-1]["pose"], double[-1]["pose"]
    turned = (here["heading"] - there["heading"] + 180) % 360 - 180
    aside = hypot(here["x"] - there["x"], here["y"] - there["y"])
    if aside > STEPS + OF_THE_WAY * _way(simulated) or abs(turned) > DEGREES:
        found.append(f"{here} became {there}")
    return found


def _way(sentences: list[dict[str, Any]]) -> float:
    """Steps."""
    return sum(abs(each["walked"]) for each in sentences if each["event"] == "moved")


def _comparable(sentences: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """The belt and its cue follow the readings a step earlier or later."""
    return [
        each
        for each in sentences
        if each["event"] != "belt" and (each["event"], each.get("name")) != ("cue", "belt")
    ]


@pytest.mark.parametrize("program", PROGRAMS, ids=lambda each: each[:20])
def test_a_program_does_the_same_on_the_simulated_board(program: str, tmp_path: Path) -> None:
    there = world(tmp_path)

    assert differences(events(program, there, "sim"), events(program, there, "double")) == []


TELLS_ITS_HEADING = "turns"
"""One degree off it has other words: "facing 179 degrees, near south" in place of "facing south"."""


def test_donnies_programs_do_the_same_on_the_simulated_board() -> None:
    found, compared = {}, 0
    for program in sorted(OWN.glob("*/*.gd")):
        text, language = program.read_text(encoding="utf-8"), program.parent.name
        where = re.match(r"-- world: (\w+)", text)
        own = OWN / f"{where[1]}.world" if where else OWN
        place = str(own) if own.is_file() else where[1] if where else "open_floor"
        spoken = language if language in ("pt", "es") else "en"
        simulated = events(text, place, "sim", spoken)
        if program.stem == TELLS_ITS_HEADING or not _moves(simulated) or _needs_what_a_board_lacks(simulated):
            continue
        compared += 1
        differs = differences(simulated, events(text, place, "double", spoken))
        found |= {program.stem: differs} if differs else {}

    assert compared >= 8
    assert found == {}


@pytest.mark.parametrize("robot", ["sim", "double"])
def test_a_program_runs_on_the_simulated_board_under_any_name_of_the_robot(
    robot: str, tmp_path: Path
) -> None:
    file = tmp_path / "ana.world"
    text = 'include "donnie.inc"\ndonnie( name "Ana" pose [ 0 0 0 90 ] )'
    file.write_text(text, encoding="utf-8")
    donnie = assemble(
        Settings(world=str(file), robot=robot, speed=None, speech="off", sound=False), terminal=False
    )
    with contextlib.closing(donnie):
        (run,) = donnie.team.start_together({"Ana": RunRequest("FW 2", "a.gd")})
        assert run.wait(TIMEOUT)

        assert run.outcome is Outcome.COMPLETED
        assert donnie.session.name == "Ana"
        assert bool(donnie.mounted()) == (robot == "sim")


def test_the_sensors_of_the_simulated_board_are_those_of_a_board(tmp_path: Path) -> None:
    """COLOR says that it has no camera. The sensors of the world's robot are reported separately."""
    typed = command.donnie(
        tmp_path, "--linear", "--robot", "double", "--lang", "pt", *command.QUIET, typed="SENSORES\n"
    )

    assert typed.stdout.decode().splitlines()[-5:-1] == [
        "Donnie tem:",
        "Sensores de distância ao redor, até 2 m.",
        "Um na cabeça, que gira para ESPIAR.",
        "Sensores de toque. Sem câmera nem garra.",
    ]


def test_an_obstacle_ends_a_walk_on_both_robots_alike(tmp_path: Path) -> None:
    sentences = events("FW 20", world(tmp_path), "double")

    moved = next(each for each in sentences if each["event"] == "moved")
    assert (moved["walked"], moved["stopped_by"]) == (5, "obstacle")


DECIDED_BY_A_READING = "063_s10_for_obstacle"
"""Its thing is 24.9 centimetres away: five steps for the simulator, four for a sonar that rounds down. It
walks as many steps as it read, so it is compared in a test of its own."""

SHARES = 8
"""Of the corpus, so that several processes may compare them."""
MOVING_IN_A_SHARE = 5
"""At the least."""


@pytest.mark.parametrize("share", range(SHARES))
def test_the_corpus_moves_the_simulated_board_as_it_moves_the_simulator(
    share: int,
    runner: Any,  # noqa: F811 -- the fixture
    shared: Path,
    tmp_path: Path,
) -> None:
    found, compared = {}, 0
    for program in sorted((shared / "corpus").glob("*.gd"))[share::SHARES]:
        want = runner.read_expected(program.with_suffix(".expected"))
        if want["mode"] == "terminal" or program.stem == DECIDED_BY_A_READING:
            continue
        text, place = _of_the_corpus(program, want, runner, tmp_path)
        simulated = events(text, place, "sim", want["lang"])
        if _moves(simulated) and not _needs_what_a_board_lacks(simulated):
            compared += 1
            differs = differences(simulated, events(text, place, "double", want["lang"]))
            found |= {program.stem: differs} if differs else {}

    assert compared >= MOVING_IN_A_SHARE
    assert found == {}


def test_a_program_that_walks_a_measured_distance_walks_as_far_on_both_robots(
    runner: Any,  # noqa: F811 -- the fixture
    shared: Path,
    tmp_path: Path,
) -> None:
    program = shared / "corpus" / f"{DECIDED_BY_A_READING}.gd"
    want = runner.read_expected(program.with_suffix(".expected"))
    text, place = _of_the_corpus(program, want, runner, tmp_path)

    simulated, double = (events(text, place, robot, want["lang"]) for robot in ("sim", "double"))

    assert [_read(each) for each in (simulated, double)] == [[5], [4]]
    assert _walked(simulated) == [*_walked(double), (0, "obstacle")]
    assert _walked(double) == [(1, None)] * 4
    assert hypot(double[-1]["pose"]["x"], double[-1]["pose"]["y"] - 4) <= STEPS


def _of_the_corpus(program: Path, want: dict[str, Any], runner: Any, folder: Path) -> tuple[str, str]:  # noqa: F811
    """A program's text, and its world's file."""
    file = folder / f"{program.stem}.world"
    file.write_text(runner.world_text(want), encoding="utf-8")
    return program.read_bytes().decode("utf-8-sig"), str(file)


def _read(sentences: list[dict[str, Any]]) -> list[int]:
    return [each["value"] for each in sentences if each["event"] == "read"]


def _walked(sentences: list[dict[str, Any]]) -> list[tuple[int, str | None]]:
    return [(each["walked"], each["stopped_by"]) for each in sentences if each["event"] == "moved"]


def _moves(sentences: list[dict[str, Any]]) -> bool:
    return any(each["event"] in ("moved", "turned") for each in sentences)


def _needs_what_a_board_lacks(sentences: list[dict[str, Any]]) -> bool:
    """A camera, or a gripper."""
    return any(
        each["event"] in ("scanned", "gripper") or each.get("sensor") == "colour" for each in sentences
    )
