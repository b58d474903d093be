"""ROBOT, TOGETHER, STOP ALL, CONNECT and WORLDS: which robot, and what is listed to choose from."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from donnie_tui.core.run_state import RunState
from donnie_tui.robot.search import RobotOption
from tests.timeouts import TIMEOUT
from tests.unit.commands.scripted import Script

WAITING = ("WHILE 1 == 1 DO", "WAIT 1000", "END WHILE")

OpenScript = Callable[..., Script]


def stop_all(script: Script) -> None:
    """Stop all robots, and wait for the ends of their programs."""
    runs = [each.run for each in script.donnie.team.running]
    script.type("STOP ALL")
    assert all(run.wait(TIMEOUT) for run in runs if run is not None)


def test_another_robot_can_be_talked_to_while_the_first_one_runs(open_script: OpenScript) -> None:
    script = open_script(*WAITING, speed=1.0, world="two_robots")
    script.type("AGAIN")
    answers = script.answers_to("ROBOT bob", "SPEAK 7")
    assert [line for line in answers if "alice" not in line] == ["Now you talk to bob.", "bob: 7"]
    assert [each.name for each in script.donnie.team.running] == ["alice"]

    script.type("ROBOT alice")
    assert script.donnie.team.running == (script.donnie.session,)
    assert script.ctx.runs.state is RunState.RUNNING
    stop_all(script)
    assert script.donnie.team.running == ()


def test_all_that_were_given_a_program_start_together_and_stop_together(open_script: OpenScript) -> None:
    script = open_script(*WAITING, speed=1.0, world="two_robots")
    script.type("ROBOT bob")
    for line in WAITING:
        script.ctx.program.add(line)
    script.type("TOGETHER")
    assert [each.name for each in script.donnie.team.running] == ["alice", "bob"]
    assert script.ctx.runs.state is RunState.RUNNING

    stop_all(script)
    script.rest()
    assert script.ctx.runs.state is RunState.READY
    assert script.donnie.team.running == ()


def test_an_unknown_robot_changes_nothing(open_script: OpenScript) -> None:
    script = open_script(world="two_robots")

    assert script.answers_to("ROBOT carol") == ["There is no robot carol here. There are alice and bob."]
    assert script.donnie.session.name == "alice"


def test_robot_alone_lists_all_robots_with_their_state_to_choose_from(open_script: OpenScript) -> None:
    script = open_script(*WAITING, speed=1.0, world="two_robots", answers=["bob"])
    script.type("START")
    script.type("ROBOT")

    title, alice, bob = script.interaction.asked
    assert title == "Robots of this world"
    assert alice.startswith("alice runs")
    assert bob == "bob: 0, 30, facing south."
    assert "Now you talk to bob." in script.printed
    assert script.donnie.session.name == "bob"


def test_connect_lists_the_robots_with_their_state_and_takes_one(
    open_script: OpenScript, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    script = open_script(answers=["3"])
    connection, missing = script.donnie.connection, tmp_path / "ttyACM9"
    first, *_, last = connection.options()
    board = RobotOption(f"serial:{missing}", f"robot at {missing}")
    monkeypatch.setattr(connection, "options", lambda: (first, board, last))
    script.type("CONNECT")

    assert script.interaction.asked == [
        "Robots to connect to",
        "1: the simulator, in use now.",
        f"2: robot at {missing}, not plugged in.",
        "3: a simulated board, to try without a robot.",
    ]
    assert "Robot connected." in script.printed
    assert connection.robot == "double"
    assert script.answers_to("CONNECT 1") == ["I will use the simulator."]


def test_a_world_is_listed_with_its_difficulty_and_its_task(open_script: OpenScript) -> None:
    script = open_script()
    script.type("WORLDS")

    (row,) = (each for each in script.interaction.asked if each.startswith("maze:"))
    assert ", hard. " in row
    assert " Task: " in row
