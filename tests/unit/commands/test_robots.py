"""ROBOT, TOGETHER, STOP ALL, CONNECT and WORLDS: which robot, and what is listed to choose from."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path

import pytest

from donnie_tui.core.run_state import RunState
from donnie_tui.robot.search import RobotOption
from donnie_tui.settings.folders import settings_file
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


def test_a_connection_that_may_not_be_opened_is_listed_and_the_chosen_one_is_kept(
    open_script: OpenScript, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    script = open_script()
    connection, port = script.donnie.connection, tmp_path / "ttyACM9"
    port.touch()
    first, *_, last = connection.options()
    board = RobotOption(f"serial:{port}", "the board")
    far = RobotOption("serial:socket://h:1", "the far one")
    monkeypatch.setattr(connection, "options", lambda: (first, board, far, last))
    can_be_opened = "2: the board."
    assert can_be_opened in script.answers_to("CONNECT x")
    monkeypatch.setattr("os.access", lambda *_: False)
    assert script.answers_to("CONNECT x") == [
        "1: the simulator, in use now.",
        "2: the board, you may not open it.",
        "3: the far one.",
        "4: a simulated board, to try without a robot.",
        "Type CONNECT and a number.",
    ]
    monkeypatch.undo()
    settings = Path(settings_file(os.environ))
    for number in (0, len(connection.options()) + 1):
        assert not settings.exists()
        script.type(f"CONNECT {number}")
    assert script.printed[-1].startswith("There is no number ")


def test_the_robot_that_was_connected_is_that_of_the_next_start(
    open_script: OpenScript, tmp_path: Path
) -> None:
    script = open_script()
    number = len(script.donnie.connection.options())
    trying = script.answers_to(f"CONNECT {number}")
    settings = Path(settings_file(os.environ))
    assert (trying[0], settings.read_text()) == (
        "I am looking for the robot. Please wait.",
        'robot = "double"\n',
    )
    assert script.answers_to("CONNECT 1") == ["I will use the simulator."]
    assert settings.read_text() == 'robot = "sim"\n'
    settings.unlink()
    settings.mkdir()
    simulator, problem = script.answers_to("CONNECT 1")
    assert simulator == "I will use the simulator."
    assert str(settings) in problem


def test_of_very_many_robots_thirty_are_listed(open_script: OpenScript, tmp_path: Path) -> None:
    robots = "".join(
        f'donnie( name "r{number}" pose [ {number % 6} {number // 6} 0 90 ] )\n' for number in range(32)
    )
    (tmp_path / "many.world").write_text(f'include "donnie.inc"\n{robots}')
    script = open_script(world=str(tmp_path / "many.world"))
    said = script.answers_to("ROBOTS")
    assert said[0] == "Now you talk to r0."
    assert [each.partition(":")[0] for each in said[1:-1]] == [f"r{number}" for number in range(30)]
    assert said[-1] == "And 2 more."


def test_a_world_is_listed_with_its_difficulty_and_its_task(open_script: OpenScript) -> None:
    script = open_script()
    script.type("WORLDS")

    (row,) = (each for each in script.interaction.asked if each.startswith("maze:"))
    assert ", hard. " in row
    assert " Task: " in row


# --- one robot and its surroundings


def check_conversation(script: Script, *lines: tuple[str, list[str]]) -> None:
    for typed, answers in lines:
        assert (typed, script.answers_to(typed)) == (typed, answers)


THINGS = [
    "42 by 42 steps, walls included.",
    "5 things, the nearest first.",
    "Small sofa, blue: 1 left, 28 ahead.",
    "Large sofa, blue, 10 by 5: 16 right, 34 ahead.",
    "Chair, green: 33 right, 18 ahead.",
    "Chair, green: 29 right, 25 ahead.",
    "Table, red, 5 by 10: 34 right, 26 ahead.",
]


def test_the_surroundings_are_said_from_the_robot_or_from_a_side_of_the_world(
    open_script: OpenScript,
) -> None:
    """The room has 40 by 40 steps; the robot's middle is 4 from the walls behind it, its radius is 2."""
    nothing = "There is nothing within 10 steps."
    check_conversation(
        open_script(world="living_room"),
        ("WHERE", ["Position 0, 0. Facing north."]),
        (
            "AROUND",
            [
                nothing,
                *("Ahead: free, 10 steps.", "Right: free, 10 steps."),
                *("Behind: wall, 2 steps.", "Left: wall, 2 steps."),
            ],
        ),
        (
            "AROUND east",
            [
                nothing,
                *("East: free, 10 steps.", "South: wall, 2 steps."),
                *("West: wall, 2 steps.", "North: free, 10 steps."),
            ],
        ),
        ("AROUND up", ["I did not understand. Type AROUND north."]),
        ("MAP", THINGS),
        ("SHOW MAP", THINGS),
    )


def test_a_square_a_row_and_a_column_of_the_map_are_said_up_to_its_edges(open_script: OpenScript) -> None:
    check_conversation(
        open_script(world="living_room"),
        ("MAP 3 2", ["3, 2: free. 3 right, 2 ahead."]),
        ("MAP 0 0", ["0, 0: Donnie. here."]),
        ("MAP 37 0", ["37, 0: wall. 37 right."]),
        ("MAP 38 0", ["38, 0: outside the world. 38 right."]),
        ("MAP -5 0", ["-5, 0: outside the world. 5 left."]),
        ("MAP ROW 2", ["Row 2, from -4: wall, 40 free, wall."]),
        ("MAP COLUMN 2", ["Column 2, from -4: wall, 40 free, wall."]),
        ("MAP ROW 37", ["Row 37, from -4: 42 wall."]),
        ("MAP ROW 38", ["No row 38. Rows go from -4 to 37."]),
        ("MAP COLUMN -5", ["No column -5. They go from -4 to 37."]),
    )


def test_the_way_that_was_walked_is_said_and_drawn(open_script: OpenScript) -> None:
    script = open_script(world="living_room")
    check_conversation(
        script,
        ("TRAIL", ["I have not moved yet."]),
        ("SHOW PATH", ["I have not moved yet."]),
        ("FW 3", ["I walked 3 steps forward."]),
        ("TR 90", ["I turned 90 degrees to the right."]),
        ("BW 2", ["I walked only 1 step backward. I found an obstacle.", "Wall, behind."]),
        (
            "TRAIL",
            ["FW 3: 3 steps, to 0, 3.", "TR 90: now facing east.", "BW 2: blocked after 1 step, at -1, 3."],
        ),
        ("TRAIL 1", ["BW 2: blocked after 1 step, at -1, 3."]),
        ("TRAIL 2", ["TR 90: now facing east.", "BW 2: blocked after 1 step, at -1, 3."]),
        ("WHERE", ["Position -1, 3. Facing east."]),
    )
    path = script.answers_to("SHOW PATH")

    assert path[:4] == [
        "The path starts at 0, 0.",
        "North: 3 steps, to 0, 3.",
        "West: 1 step, to -1, 3.",
        "4 steps in all.",
    ]
    assert path[4:11] == [
        "Picture, 40 by 18. The robot is >",
        "Only a part: x -4 to 35, y -4 to 13.",
        "The whole map: x -4 to 37, y -4 to 37. MAP ROW says the rest.",
        *("The start: *", "Trail: o", "Wall: #", "Free: ."),
    ]
    assert path[11:] == [
        *["#" + "." * 39] * 10,
        *("#..>o" + "." * 35, "#...o" + "." * 35, "#...o" + "." * 35, "#...*" + "." * 35),
        *["#" + "." * 39] * 3,
        "#" * 40,
    ]


def test_what_robots_and_worlds_there_are_and_are_not(open_script: OpenScript) -> None:
    check_conversation(
        open_script(world="living_room"),
        ("ROBOTS", ["There is one robot, donnie."]),
        ("ROBOT bob", ["There is no robot bob here. There is donnie."]),
        ("ROBOT donnie", ["Now you talk to donnie."]),
        ("WORLD living", ["There is no world living. Did you mean living_room?"]),
    )
    check_conversation(
        open_script(world="two_robots"),
        ("ROBOTS", ["Now you talk to alice.", "alice: 0, 0, facing north.", "bob: 0, 30, facing south."]),
        ("ROBOT bob", ["Now you talk to bob."]),
        ("FW 2", ["bob: I walked 2 steps forward."]),
        ("WHERE", ["bob: Position 0, 28. Facing south."]),
        ("TRAIL", ["bob: FW 2: 2 steps, to 0, 28."]),
        ("ROBOT ALICE", ["Now you talk to alice."]),
        ("TRAIL", ["alice: I have not moved yet."]),
        ("ROBOT 2", ["There is no robot 2 here. There are alice and bob."]),
    )


def test_the_sensors_of_a_robot_are_listed_by_kind_and_direction(open_script: OpenScript) -> None:
    sonar = "Distance sensor {}, 15 degrees wide, range 3 m."
    listed = [
        "2 times: " + sonar.format("ahead"),
        *(sonar.format(each) for each in ("45 right", "45 left", "behind", "135 right", "135 left")),
        "Color camera ahead, 180 degrees wide, range 5 m.",
        *(f"Bumper {each}." for each in ("45 left", "45 right", "135 left", "135 right")),
    ]
    assert open_script(world="living_room").answers_to("SENSORS") == ["Donnie has:", *listed]
    assert open_script(world="two_robots").answers_to("SENSORS") == ["alice has:", *listed, "Gripper ahead."]


def test_without_a_challenge_its_words_say_so(open_script: OpenScript) -> None:
    script = open_script(world="two_robots")
    for word in ("GOALS", "HINT", "QUESTIONS"):
        check_conversation(script, (word, ["No challenge here. Type CHALLENGE."]))
    check_conversation(
        script,
        ("TASK", ["Task: Give each robot a program, so that they meet and do not bump."]),
        ("RESULTS", ["You have not tried a challenge yet."]),
    )


def test_the_lines_of_a_program_are_counted_where_it_is_another_robots(open_script: OpenScript) -> None:
    script, counted = open_script("FW 1", "TR 90", world="two_robots"), "Your program has 2 lines."
    names = script.donnie.team.names

    assert counted not in script.answers_to(f"ROBOT {names[0]}"), "it was the chosen one"
    assert counted not in script.answers_to(f"ROBOT {names[1]}"), "its program is empty"
    assert counted in script.answers_to(f"ROBOT {names[0]}")
