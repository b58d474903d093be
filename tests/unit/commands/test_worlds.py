"""The map in words, and what is said and kept on the way to another world."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest
from msgspec.structs import replace

from donnie_tui.commands.interaction import EnterWorld
from donnie_tui.commands.world import arrive, settings_there
from donnie_tui.settings.settings import SettingSource
from tests.timeouts import TIMEOUT
from tests.unit.commands.scripted import Script

OpenScript = Callable[..., Script]


def arrived(script: Script, *, is_silent: bool = False) -> list[str]:
    before = len(script.printed)
    arrive(script.ctx, is_silent=is_silent)
    script.donnie.session.hub.wait_until_delivered(TIMEOUT)
    return script.printed[before:]


FLOOR = [
    *("This is the world open_floor: Open floor.", "An open floor without walls.", "There are no things."),
]
WALK = ["Challenge: The first walk. World: First room.", "Walk 5 steps to the north."]


def test_a_program_is_no_world(open_script: OpenScript, tmp_path: Path) -> None:
    file = tmp_path / "walk.gd"
    file.write_text("FW 1")

    assert open_script().answers_to(f"WORLD {file}") == [f"{file} is a program, not a world."]


def test_a_world_is_described_on_arrival_and_the_program_stays(open_script: OpenScript) -> None:
    script = open_script("FW 1")

    assert arrived(script) == FLOOR
    assert script.ctx.program.lines == ("FW 1",)


def test_sound_that_was_off_is_off_there_too(open_script: OpenScript) -> None:
    assert arrived(open_script(), is_silent=True) == ["Sound off.", *FLOOR]


def test_another_challenge_begins_empty_and_undo_brings_the_program_back(open_script: OpenScript) -> None:
    script = open_script("FW 1", "FW 2", world="challenge:1")
    assert arrived(script) == [*WALK, "Your 2 lines are put away. UNDO brings them back."]
    assert script.ctx.program.lines == ()
    script.type("UNDO")
    assert script.ctx.program.lines == ("FW 1", "FW 2")
    assert arrived(open_script(world="challenge:1")) == WALK


def test_the_same_challenge_keeps_the_program(open_script: OpenScript) -> None:
    script = open_script("FW 1", world="challenge:1")
    challenge = script.donnie.world.challenge
    assert challenge is not None
    script.ctx.workspace.challenge = challenge.name

    assert arrived(script) == WALK
    assert script.ctx.program.lines == ("FW 1",)


def test_another_world_has_the_settings_of_this_one_and_the_changes_since(open_script: OpenScript) -> None:
    script = open_script(speed=5.0)
    settings = replace(script.ctx.preferences.settings, notices=("a notice",))  # type: ignore[arg-type]
    script.donnie.words.language, script.donnie.words.detail = "pt", "brief"
    script.donnie.session.speed = 2.0
    there = settings_there(script.donnie, settings, "maze")

    assert (there.world, there.language, there.verbosity, there.speed) == ("maze", "pt", "brief", 2.0)
    assert (there.notices, there.robot, there.sources) == ((), settings.robot, settings.sources)
    there = settings_there(script.donnie, replace(settings, robot="serial:/dev/x"), "maze")
    assert there.robot == settings.robot
    assert there.sources == {**settings.sources, "robot": SettingSource.OPTION}


@pytest.mark.parametrize(
    ("typed", "said"),
    [
        ("MAP 1 2 3", ["I did not understand. Type MAP 3 2."]),
        ("MAP 0 0", ["0, 0: Donnie. here."]),
        *((each, ["I did not understand. Type MAP ROW 2."]) for each in ("MAP ROW", "MAP ROW 1 2")),
        *((each, ["I did not understand. Type MAP COLUMN 2."]) for each in ("MAP COLUMN", "MAP COLUMN 1 2")),
        (
            "MAP ROW 0",
            [
                "Row 0, from -16: wall, 3 free, 3 chair, 9 free, Donnie.",
                "Row 0, from 1: 6 free, 3 ball, 6 free, wall.",
            ],
        ),
        (
            "AROUND east",
            [
                *("3 things within 10 steps.", "East: ball, yellow, 5 steps.", "South: wall, 9 steps."),
                *("West: chair, green, 8 steps.", "West: small sofa, blue, 10 steps."),
                "North: free, 10 steps.",
            ],
        ),
        ("AROUND nowhere", ["I did not understand. Type AROUND north."]),
    ],
)
def test_the_map_is_said_by_squares_rows_and_sides(
    open_script: OpenScript, typed: str, said: list[str]
) -> None:
    assert open_script(world="first_room").answers_to(typed) == said


def test_the_sign_of_free_squares_is_chosen(open_script: OpenScript) -> None:
    script = open_script(world="first_room")
    dots = script.answers_to("MAP PICTURE")

    assert "Free: ." in dots
    assert script.answers_to("SET free f", "MAP PICTURE")[1:] == [
        each.replace(".", "f") if each[:1] in "#.^" or each == "Free: ." else each for each in dots
    ]


def test_the_driven_path_is_said_leg_by_leg_and_drawn(open_script: OpenScript) -> None:
    script = open_script()
    script.interaction.until_over = script.rest
    script.answers_to("FW 3", "TR 90", "FW 2")
    said = script.answers_to("SHOW PATH")

    assert said[:3] == ["The path starts at 0, 0.", "North: 3 steps, to 0, 3.", "East: 2 steps, to 2, 3."]
    assert script.interaction.asked == ["Path"]
    assert len(said) > 8, "and the map"


def test_a_world_where_the_learner_is_or_that_is_not_there_is_not_entered(open_script: OpenScript) -> None:
    script = open_script()

    assert script.answers_to("WORLD open_floor") == [
        "You are in open_floor already. RESET goes to the start."
    ]
    (answer,) = script.answers_to("WORLD nowhere")
    assert "nowhere" in answer


def test_trail_says_the_last_five_moves(open_script: OpenScript) -> None:
    script = open_script()
    script.answers_to(*(f"TR {degrees}" for degrees in range(1, 7)))

    assert [each.partition(":")[0] for each in script.answers_to("TRAIL")] == [
        f"TR {degrees}" for degrees in range(2, 7)
    ]


def test_place_moves_and_path_are_those_of_the_moment_that_is_looked_back_at(open_script: OpenScript) -> None:
    script = open_script("FW 3", "TR 90", "FW 2")
    script.interaction.until_over = script.rest
    script.answers_to("RUN", "DETAIL full")
    walked, turned, last = "FW 3: 3 steps, to 0, 3.", "TR 90: now facing east.", "FW 2: 2 steps, to 2, 3."
    for typed, answers in (
        ("WHERE", ["Position 2, 3. Facing east.", last]),
        ("TRAIL", [walked, turned, last]),
        ("TRAIL 2", [turned, last]),
        ("TRAIL 0", ["I did not understand. Type TRAIL 2."]),
    ):
        assert (typed, script.answers_to(typed)) == (typed, answers)
    script.answers_to(*["STEP BACK"] * 3)
    assert script.answers_to("WHERE") == ["Position 0, 3. Facing north.", walked]
    assert script.answers_to("TRAIL") == [walked]
    path = script.answers_to("SHOW PATH")
    assert path[:3] == ["The path starts at 0, 0.", "North: 3 steps, to 0, 3.", "3 steps in all."]
    assert [each.replace(".", "") for each in path if each.startswith("....")][-10:-6] == [*"^oo*"]
    script.answers_to(*["STEP BACK"] * 2)
    assert script.answers_to("WHERE") == ["Position 0, 0. Facing north.", "I have not moved yet."]
    assert script.answers_to("TRAIL") == ["I have not moved yet."]

    assert script.answers_to("MAP 0 1", "WHERE") == [
        *("You are back in the present.", "0, 1: free. 2 right, 2 behind."),
        *("Position 2, 3. Facing east.", last),
    ]


@pytest.mark.parametrize("typed", ["AROUND", "MAP", "MAP ROW 1", "MAP COLUMN 1", "MAP PICTURE", "SENSORS"])
def test_what_is_about_now_ends_the_way_back(open_script: OpenScript, typed: str) -> None:
    script = open_script("FW 3")
    script.interaction.until_over = script.rest
    script.answers_to("RUN", "STEP BACK")

    assert script.answers_to(typed)[0] == "You are back in the present."
    assert script.ctx.runs.past is None


def test_worlds_are_offered_with_title_difficulty_and_a_map_where_it_fits(open_script: OpenScript) -> None:
    script = open_script(world="first_room")
    script.type("WORLDS")
    offered = {each.value: each for each in script.interaction.offered}
    room = offered["first_room"]
    assert room.detail is not None
    text = [
        *("A room of 31 by 31 steps with walls", "around. Donnie stands in the south half,"),
        "in the middle, and looks north. A yellow",
    ]
    wide, narrow = room.detail(40, 30), room.detail(40, 12)

    assert [each.value for each in offered.values() if each.is_current] == ["first_room"]
    assert room.columns == ("First room", "easy")
    assert offered["maze"].columns == ("Maze", "hard")
    about = [*wide][wide.index("") + 1 :]
    assert " ".join(about[:3]).startswith(" ".join(text)[:60])
    assert max(map(len, about)) <= 40
    assert wide[0] == "#" * len(wide[0])
    assert list(narrow) == about
    assert "" in room.detail(40, len(about) + 6), "room for five rows"
    assert "" not in room.detail(40, len(about) + 5)


def test_a_world_is_entered_by_its_name_and_from_the_list(open_script: OpenScript) -> None:
    for typed, answers in (("WORLD maze", ()), ("WORLDS maze", ()), ("WORLDS", ("maze",))):
        script = open_script(answers=answers)
        with pytest.raises(EnterWorld) as entered:
            script.type(typed)
        assert entered.value.name == "maze"
    script = open_script(world="challenge:1")
    with pytest.raises(EnterWorld):
        script.type("WORLD maze")
    assert script.ctx.workspace.challenge == "first_walk"


def test_a_recorded_world_is_not_left(open_script: OpenScript) -> None:
    script = open_script(record="a.rec")
    stays = (
        "I stay in this world: a.rec is being written, and another world would overwrite it. "
        "Leave with QUIT, then start donnie with --world."
    )

    assert script.answers_to("WORLD maze") == [stays]
    assert script.answers_to("PUT box red 4 6") == ["a.rec is being recorded, so the world stays as it is."]


def test_challenges_are_offered_by_number_with_their_task_and_the_present_one_is_marked(
    open_script: OpenScript,
) -> None:
    script = open_script(world="challenge:2")
    said = script.answers_to("CHALLENGE")
    offered = script.interaction.offered

    assert [each.text for each in offered] == said
    assert [each.value for each in offered if each.is_current] == ["to_the_ball"]
    assert (offered[0].value, said[0]) == ("first_walk", "1. The first walk")
    assert offered[0].detail is not None
    assert offered[0].detail(40, 10) == ("Challenge: The first walk.", "Walk 5 steps to the north.")


@pytest.mark.parametrize(("turn", "sign"), [("TR 90", ">"), ("TL 90", "<"), ("TR 180", "v")])
def test_a_path_that_ends_with_a_turn_shows_where_the_robot_faces(
    open_script: OpenScript, turn: str, sign: str
) -> None:
    script = open_script()
    script.answers_to("FW 3", turn)
    path = script.answers_to("SHOW PATH")

    assert path[1:4] == [
        "North: 3 steps, to 0, 3.",
        "3 steps in all.",
        f"Picture, 40 by 18. The robot is {sign}",
    ]
    assert "." * 20 + sign + "." * 19 in path
