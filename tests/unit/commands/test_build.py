"""PUT, MOVE, TURN, REMOVE, SAVE WORLD: the world is furnished by words, and every answer says where."""

from __future__ import annotations

import shutil
from collections.abc import Callable
from pathlib import Path

import pytest
from msgspec.structs import replace
from PIL import Image

from donnie_tui.commands.build import may_leave_built
from donnie_tui.commands.files import may_lose_all
from donnie_tui.commands.interaction import EnterWorld, drive
from donnie_tui.commands.lookup import find
from donnie_tui.i18n.words import Words
from donnie_tui.world.loading import choose_world
from language.parser import parse
from sim.picture import picture
from tests.timeouts import TIMEOUT
from tests.unit.commands.scripted import Script

OpenScript = Callable[..., Script]


@pytest.mark.parametrize(
    ("language", "lines", "answers"),
    [
        (
            "en",
            ("PUT box red 4 6 AS treasure", "MOVE treasure 2 0", "TURN treasure 90", "REMOVE treasure"),
            [
                "Treasure, box, red: at 4, 6. From the robot: 4 right, 6 ahead.",
                "Treasure, box, red: now at 6, 6. From the robot: 6 right, 6 ahead.",
                "Treasure, box, red: turned 90 degrees to the right, at 6, 6. It is 3 by 3 steps.",
                "Treasure, box, red: gone from 6, 6.",
            ],
        ),
        (
            "en",
            ("PUT box red 4,6 AS treasure", "MOVE treasure 2,-1", "PUT treasure -4, 6"),
            [
                "Treasure, box, red: at 4, 6. From the robot: 4 right, 6 ahead.",
                "Treasure, box, red: now at 6, 5. From the robot: 6 right, 5 ahead.",
                "Treasure, box, red: now at -4, 6. From the robot: 4 left, 6 ahead.",
            ],
        ),
        (
            "pt",
            (
                "COLOCAR caixa vermelha 4 6 COMO tesouro",
                "MOVER tesouro 2 0",
                "VIRAR tesouro 90",
                "REMOVER tesouro",
            ),
            [
                "Tesouro, caixa vermelha: em 4, 6. Do robô: 4 à direita, 6 à frente.",
                "Tesouro, caixa vermelha: agora em 6, 6. Do robô: 6 à direita, 6 à frente.",
                "Tesouro, caixa vermelha: virou 90 graus para a direita, em 6, 6. Mede 3 por 3 passos.",
                "Tesouro, caixa vermelha: não está mais em 6, 6.",
            ],
        ),
        (
            "es",
            ("PONER caja roja 4 6 COMO tesoro", "MOVER tesoro 2 0", "ROTAR tesoro 90", "QUITAR tesoro"),
            [
                "Tesoro, caja roja: en 4, 6. Desde el robot: 4 a la derecha, 6 al frente.",
                "Tesoro, caja roja: ahora en 6, 6. Desde el robot: 6 a la derecha, 6 al frente.",
                "Tesoro, caja roja: rotó 90 grados a la derecha, en 6, 6. Mide 3 por 3 pasos.",
                "Tesoro, caja roja: ya no está en 6, 6.",
            ],
        ),
    ],
)
def test_a_thing_is_put_moved_turned_and_removed(
    open_script: OpenScript, language: str, lines: tuple[str, ...], answers: list[str]
) -> None:
    script = open_script(world="first_room", language=language)

    assert [said for line in lines for said in script.answers_to(line)] == answers


def test_the_map_and_around_agree_at_once(open_script: OpenScript) -> None:
    script = open_script(world="first_room")

    script.type("PUT box red 0 6 AS treasure")

    assert script.answers_to("MAP 0 6") == ["0, 6: treasure. 6 ahead."]
    assert "Treasure, box, red: 6 ahead." in script.answers_to("MAP")
    assert "Ahead: treasure, box, red, 3 steps." in script.answers_to("AROUND")
    script.type("REMOVE treasure")
    assert script.answers_to("MAP 0 6") == ["0, 6: free. 6 ahead."]


def test_a_program_meets_what_was_put(open_script: OpenScript) -> None:
    script = open_script(world="first_room")

    script.type("PUT post 0 6")
    # The post's edge is at 5.5 steps, the robot's at 1.28: 4 whole steps are free.
    assert script.answers_to("SPEAK DISTANCE F") == ["4"]
    assert script.answers_to("FW 9")[0].endswith("I found an obstacle.")


def test_a_robot_on_its_way_stays_where_it_is_and_keeps_its_variables(open_script: OpenScript) -> None:
    script = open_script(world="first_room")
    script.answers_to("VAR a = 7")
    script.answers_to("FW 3")

    script.type("PUT box red 4 6")
    script.type("REMOVE table")

    assert script.answers_to("WHERE") == ["Position 0, 3. Facing north."]
    assert script.answers_to("SPEAK a") == ["7"]
    assert script.answers_to("FW 1")[0].startswith("I walked 1 step")
    assert script.answers_to("WHERE") == ["Position 0, 4. Facing north."]


def test_reset_restores_what_was_built_and_puts_pushed_things_back(open_script: OpenScript) -> None:
    script = open_script(world="first_room")
    script.type("PUT box red 0 6 AS treasure")
    script.answers_to("FW 7")
    assert script.answers_to("MAP 0 6") != ["0, 6: treasure. 0 ahead."]
    pushed = script.donnie.picture_now().things[-1]
    assert pushed.y > 6

    script.type("PUT post 5 5")
    script.type("REMOVE ball")
    again = next(each for each in script.donnie.picture_now().things if each.name == "treasure")
    assert again.y == pushed.y  # what was pushed stays there while others are put and removed

    script.type("RESET")
    back = next(each for each in script.donnie.picture_now().things if each.name == "treasure")
    assert (back.x, back.y) == (0, 6)
    assert any(each.name == "post" for each in script.donnie.picture_now().things)


def test_a_pushed_thing_is_moved_from_where_it_is(open_script: OpenScript) -> None:
    script = open_script(world="first_room")
    script.type("PUT box red 0 6 AS treasure")
    script.answers_to("FW 7")
    pushed = next(each for each in script.donnie.picture_now().things if each.name == "treasure")

    script.type("MOVE treasure 5 0")
    script.type("RESET")

    moved = next(each for each in script.donnie.picture_now().things if each.name == "treasure")
    assert (moved.x, moved.y) == (5, pytest.approx(pushed.y, abs=1e-3))


@pytest.mark.parametrize(
    ("line", "sentence"),
    [
        ("PUT chair 0 1", "The robot donnie is at that place. Nothing changed."),
        ("PUT chair 15 5", "There is a wall at that place. Nothing changed."),
        (
            "PUT chair 99 5",
            "That is outside. The floor goes from -16 to 16 east and from -11 to 21 north. Nothing changed.",
        ),
        (
            "PUT box 9999999 3",
            "That is outside. The floor goes from -16 to 16 east and from -11 to 21 north. Nothing changed.",
        ),
        (
            "MOVE ball 0 -9999999",
            "That is outside. The floor goes from -16 to 16 east and from -11 to 21 north. Nothing changed.",
        ),
        ("PUT box 4 6 3", "I did not understand. Type PUT box red 4 6."),
        ("PUT chair 8 0", "The yellow ball is in the way. Nothing changed."),
        ("MOVE ball 7 0", "There is a wall at that place. Nothing changed."),
        ("MOVE ball -8 0", "The robot donnie is at that place. Nothing changed."),
        ("PUT chair table 4 6", "table is one thing too many. Each line says one thing."),
        ("PUT chiar 4 6", "chiar is neither a thing nor a color. Did you mean chair?"),
        ("PUT box 4 6 AS ball", "Ball is there already. Choose another name."),
        ("MOVE bal 1 0", "There is no bal here. Did you mean ball?"),
        ("REMOVE treasure", "There is no treasure here. Nothing changed."),
        ("TURN donnie 90", "Donnie is a robot. It moves by its program."),
        ("PUT box 4", "I did not understand. Type PUT box red 4 6."),
        ("PUT 4 6", "I did not understand. Type PUT box red 4 6."),
        ("PUT ball 1 2 3 4", "I did not understand. Type PUT box red 4 6."),
        ("PUT box 4 6 AS", "A name begins with a letter: AS treasure."),
        ('PUT box 4 6 AS ""', "A name begins with a letter: AS treasure."),
        ("PUT box 4 6 AS .", "A name begins with a letter: AS treasure."),
        ("PUT box 4 6 AS 7", "A name begins with a letter: AS treasure."),
        ('PUT box 4 6 AS "ball"', "Ball is there already. Choose another name."),
        ("TURN ball", "I did not understand. Type TURN treasure 90."),
        ("MOVE ball", "I did not understand. Type MOVE treasure 2 0."),
        ("MOVE ball 1", "I did not understand. Type MOVE treasure 2 0."),
        ("MOVE 1", "I do not know MOVE 1. Did you mean FW 1?"),
    ],
)
def test_what_can_not_be_done_changes_nothing_and_says_why(
    open_script: OpenScript, line: str, sentence: str
) -> None:
    script = open_script(world="first_room")
    before = script.donnie.picture_now()

    assert script.answers_to(line) == [sentence]
    assert script.donnie.picture_now() == before
    assert script.donnie.site.is_saved


def test_the_place_where_a_robot_starts_stays_free(open_script: OpenScript) -> None:
    script = open_script(world="first_room")
    script.answers_to("FW 6")

    assert script.answers_to("PUT box 0 0") == ["The robot donnie starts at that place. Nothing changed."]


def test_of_several_things_the_names_are_said(open_script: OpenScript) -> None:
    script = open_script(world="first_room")
    script.type("PUT box red 4 6")
    script.type("PUT box blue 8 6")
    script.type("PUT box blue 8 12")

    assert script.answers_to("MOVE red box 1 0") == [
        "Box, red: now at 5, 6. From the robot: 5 right, 6 ahead."
    ]
    assert script.answers_to("REMOVE blue box") == [
        "There are 2: box 2: 8, 6; box 3: 8, 12. Type the name of one."
    ]
    assert script.answers_to("REMOVE box 3") == ["Box, blue: gone from 8, 12."]


@pytest.mark.parametrize(
    ("language", "lines", "answers"),
    [
        (
            "pt",
            ("COLOCAR caixa azul 4 6", "COLOCAR caixa azul 8 6", "REMOVER caixa azul", "REMOVER caixa 2"),
            [
                "Há 2: caixa: 4, 6; caixa 2: 8, 6. Digite o nome de um.",
                "Caixa azul: não está mais em 8, 6.",
            ],
        ),
        (
            "es",
            ("PONER caja azul 4 6", "PONER caja azul 8 6", "QUITAR caja azul", "QUITAR box 2"),
            [
                "Hay 2: caja: 4, 6; caja 2: 8, 6. Escribe el nombre de uno.",
                "Caja azul: ya no está en 8, 6.",
            ],
        ),
    ],
)
def test_things_without_a_name_are_numbered_in_the_learners_language(
    open_script: OpenScript, language: str, lines: tuple[str, ...], answers: list[str]
) -> None:
    script = open_script(world="first_room", language=language)

    assert [said for line in lines for said in script.answers_to(line)][2:] == answers


def test_a_thing_is_found_by_its_kind_and_one_of_its_squares(open_script: OpenScript) -> None:
    script = open_script(world="first_room")
    script.answers_to("PUT box red 4 6", "PUT box red 8 6")

    assert script.answers_to("REMOVE box 9 5") == ["Box, red: gone from 8, 6."]


def test_the_word_that_was_meant_is_one_of_the_learners_language(open_script: OpenScript) -> None:
    """The Spanish rojo is near to roxo, and is another colour."""
    script = open_script(world="first_room", language="pt")

    assert script.answers_to("COLOCAR poste roxo 4 6") == ["roxo não é nem objeto nem cor."]


def test_a_part_of_a_kind_leads_to_the_kind(open_script: OpenScript) -> None:
    script = open_script(world="open_floor")
    script.answers_to("PUT small sofa 8 8 AS couch")

    assert script.answers_to("MOVE sofa 1 0") == ["There is no sofa here. Did you mean small sofa?"]


def test_a_thing_with_a_name_is_put_to_a_place(open_script: OpenScript) -> None:
    script = open_script(world="first_room")
    script.type("PUT box red 4 6 AS treasure")

    assert script.answers_to("PUT treasure -4 6") == [
        "Treasure, box, red: now at -4, 6. From the robot: 4 left, 6 ahead."
    ]


@pytest.mark.parametrize(
    ("language", "line", "sentence"),
    [
        ("pt", 'COLOCAR caixa 4 6 COMO ""', "Um nome começa com uma letra: COMO tesouro."),
        ("es", 'PONER caja 4 6 COMO ""', "Un nombre empieza con una letra: COMO tesoro."),
    ],
)
def test_a_name_is_one_that_other_commands_can_find(
    open_script: OpenScript, language: str, line: str, sentence: str
) -> None:
    script = open_script(world="first_room", language=language)

    assert script.answers_to(line) == [sentence]
    assert script.donnie.site.is_saved


@pytest.mark.parametrize(
    ("language", "line", "sentence"),
    [
        ("pt", "MOVER sofá 1", "Não entendi. Digite assim: MOVER tesouro 2 0."),
        ("es", "MOVER sofá 1", "No entendí. Escribe MOVER tesoro 2 0."),
    ],
)
def test_a_slip_in_moving_a_thing_is_answered_with_the_form_for_things(
    open_script: OpenScript, language: str, line: str, sentence: str
) -> None:
    script = open_script(world="first_room", language=language)

    assert script.answers_to(line) == [sentence]


def test_lines_of_the_program_are_moved_and_removed_as_before(open_script: OpenScript) -> None:
    script = open_script("FW 1", "FW 2", "FW 3", world="first_room")

    assert script.answers_to("MOVE 3 1") == ["Line 1: FW 3"]
    assert script.answers_to("REMOVE 1")
    assert script.ctx.program.lines == ("FW 1", "FW 2")


@pytest.mark.parametrize("line", ["TURN LEFT", "TURN RIGHT 90", "TURN 90", "TURN -90", "MOVE FORWARD 3"])
def test_what_beginners_say_for_the_robot_is_no_command_for_things(line: str) -> None:
    assert find(line) is None


@pytest.mark.parametrize("line", ["TURN treasure 90", "TURN chair -90", "turn red box 45"])
def test_a_thing_after_turn_is_turned(line: str) -> None:
    found = find(line)

    assert found is not None
    assert found[0].name == "turn"


def test_the_hint_for_turn_left_is_still_a_word_of_godonnie() -> None:
    (mistake,) = parse("TURN LEFT 90").diagnostics

    assert (mistake.code, mistake.meant) == ("everyday", "TL 90")


def test_a_challenge_keeps_its_world(open_script: OpenScript) -> None:
    script = open_script(world="challenge:first_walk")

    assert script.answers_to("PUT box 4 6") == ["This world belongs to a challenge and stays as it is."]


def test_a_recorded_session_keeps_its_world(open_script: OpenScript, tmp_path: Path) -> None:
    script = open_script(world="first_room", record=str(tmp_path / "it.rec"))

    assert script.answers_to("PUT box 4 6")[0].endswith("is being recorded, so the world stays as it is.")


@pytest.mark.parametrize("field", ["offers", "stands_in_for"])
def test_a_configuration_file_keeps_its_world(
    open_script: OpenScript, monkeypatch: pytest.MonkeyPatch, field: str
) -> None:
    script = open_script(world="first_room")
    world = replace(script.donnie.world, **{field: ("a robot",)})
    monkeypatch.setattr(type(script.donnie), "world", world)

    assert script.answers_to("PUT box 4 6") == [
        "This world comes from a configuration file. Enter the world file itself."
    ]


@pytest.mark.parametrize("robot", ["is_real", "is_board"])
def test_around_a_real_robot_nothing_is_built(
    open_script: OpenScript, monkeypatch: pytest.MonkeyPatch, robot: str
) -> None:
    script = open_script(world="first_room")
    monkeypatch.setattr(type(script.donnie.connection), robot, True)

    assert script.answers_to("PUT box 4 6") == [
        "I build in a simulated world only. Type CONNECT for the simulated robot."
    ]


@pytest.mark.parametrize("robot", ["alice", "bob"])
def test_nothing_is_built_while_a_program_runs(open_script: OpenScript, robot: str) -> None:
    """Whichever robot the learner talks to meanwhile."""
    script = open_script("WAIT 1000000", speed=1.0, world="two_robots")
    script.type("START")
    script.type(f"ROBOT {robot}")
    before = len(script.printed)

    for line in ("PUT box 4 6", "MOVE red box 1 0", "TURN red box 90", "REMOVE red box"):
        script.type(line)

    assert script.donnie.site.is_saved
    answers = [each for each in script.printed[before:] if "Waiting" not in each]
    assert len(answers) == 4
    assert len(set(answers)) == 1


def test_all_robots_stay_where_they_are(open_script: OpenScript) -> None:
    script = open_script(world="two_robots")
    script.answers_to("FW 2")
    script.type("ROBOT bob")
    script.answers_to("FW 3")

    script.type("PUT post 5 20")
    script.type("REMOVE red box")

    poses = {each.name: each.pose for each in script.donnie.team.sessions}
    assert (poses["alice"].y, poses["bob"].y) == (2, 27)
    seen = {each.name: each for each in script.donnie.picture_now().things}
    assert seen["alice"].y == 2  # as bob finds her
    assert script.answers_to("FW 30")[0].endswith("I found an obstacle.")  # she is still in his way


def test_what_a_robot_holds_is_not_around_it_but_in_its_gripper(open_script: OpenScript) -> None:
    script = open_script(world="two_robots")
    script.type("PUT box red 0 4 AS treasure")
    script.answers_to("FW 1")
    before = script.answers_to("AROUND")
    script.answers_to("GRIP")
    after = script.answers_to("AROUND")
    script.answers_to("RELEASE")

    assert sum("treasure" in line for line in before) == 1
    assert (before[0], after[0]) == (
        "alice: 1 thing within 10 steps.",
        "alice: There is nothing within 10 steps.",
    )
    assert after[1] == "In my gripper: treasure, box, red."
    assert [line for line in after[2:] if "treasure" in line] == []
    assert any(line.startswith("Ahead: free, ") for line in after)
    assert script.answers_to("AROUND") == before
    script.answers_to("GRIP")
    script.type("ROBOT bob")
    assert not any("gripper" in line for line in script.answers_to("AROUND"))


def test_a_robot_lets_go_before_the_world_is_changed(open_script: OpenScript) -> None:
    script = open_script(world="two_robots")
    script.type("PUT box red 0 4 AS treasure")
    script.answers_to("FW 1")
    assert "treasure" in script.answers_to("GRIP")[0]

    assert script.answers_to("MOVE treasure 2 0") == ["A robot holds something. RELEASE it first."]
    script.answers_to("RELEASE")
    assert script.answers_to("MOVE treasure 5 0")[0].startswith("Treasure, box, red: now at 5, ")


# --- walls


@pytest.mark.parametrize(
    ("language", "lines", "answers"),
    [
        (
            "en",
            ("PUT wall -5 8 5 8", "MOVE wall 0 2", "TURN wall 90", "REMOVE wall"),
            [
                "Wall: from -5, 8 to 5, 8.",
                "Wall: now at 0, 10. From the robot: 10 ahead.",
                "Wall: turned 90 degrees to the right, at 0, 10. It is 1 by 11 steps.",
                "Wall: gone from 0, 10.",
            ],
        ),
        (
            "pt",
            ("COLOCAR parede -5 8 5 8", "COLOCAR parede 9 9", "REMOVER parede 2"),
            ["Parede: de -5, 8 a 5, 8.", "Parede 2: de 9, 9 a 9, 9.", "Parede 2: não está mais em 9, 9."],
        ),
        (
            "es",
            ("PONER pared 5 8 -5 8 COMO valla", "QUITAR valla"),
            ["Valla: de -5, 8 a 5, 8.", "Valla: ya no está en 0, 8."],
        ),
    ],
)
def test_a_wall_is_put_between_two_squares(
    open_script: OpenScript, language: str, lines: tuple[str, ...], answers: list[str]
) -> None:
    script = open_script(language=language, world="open_floor")

    assert [said for line in lines for said in script.answers_to(line)] == answers


def test_a_room_is_built_of_walls_by_words_and_read_back(open_script: OpenScript, tmp_path: Path) -> None:
    script = open_script(world="open_floor")

    for corners in ("-10 10 10 10", "-10 -10 10 -10", "-10 -10 -10 10", "10 -10 10 10"):
        assert script.answers_to(f"PUT wall {corners}")[0].startswith("Wall")
    # The wall fills the square 10: its edge is at 9.5 steps, the robot's at 1.28: 8 whole steps are free.
    assert script.answers_to("SPEAK DISTANCE F") == ["8"]
    assert script.answers_to("PUT chair 12 0")[0].startswith("That is outside.")
    assert script.answers_to("PUT chair 9 0") == ["There is a wall at that place. Nothing changed."]
    script.type("SAVE WORLD room")

    walls = picture(choose_world(str(tmp_path / "room.world"), Words("en")).scene).walls
    xs, ys = zip(*(point for outline in walls for point in outline), strict=True)
    assert [round(each, 6) for each in (min(xs), max(xs), min(ys), max(ys))] == [-10.5, 10.5, -10.5, 10.5]


@pytest.mark.parametrize(
    ("line", "sentence"),
    [
        ("PUT wall -3 0 3 0", "The robot donnie is at that place. Nothing changed."),
        ("PUT wall 8 -5 8 5", "The yellow ball is in the way. Nothing changed."),
        ("PUT wall 0 5000", "That is outside. The floor goes from -1000 to 1000 east and from -1000 to 1000"),
        ("PUT wall 3", "I did not understand. Type PUT box red 4 6."),
        ("PUT wall 1 2 3", "I did not understand. Type PUT box red 4 6."),
        ("REMOVE wall", "There are 4 walls. Type one with a square of it, such as wall 4 6."),
        ("REMOVE wall 4 6", "There is no wall 4 6 here. Nothing changed."),
        ("PUT wall 1 1 2 2 AS ball", "Ball is there already. Choose another name."),
    ],
)
def test_a_wall_that_is_impossible_changes_nothing(open_script: OpenScript, line: str, sentence: str) -> None:
    script = open_script(world="first_room")
    before = script.donnie.picture_now()

    assert script.answers_to(line)[0].startswith(sentence)
    assert script.donnie.picture_now() == before


def test_a_wall_without_a_name_is_removed_by_one_of_its_squares(
    open_script: OpenScript, tmp_path: Path
) -> None:
    """Those of ``donnie world new`` have none."""
    file = tmp_path / "room.world"
    file.write_text(
        'include "donnie.inc"\ninclude "things.inc"\n'
        "wall( pose [ 0 0.5 0 0 ] size [ 1.05 0.05 0.24 ] )\n"
        "wall( pose [ 0.5 0 0 0 ] size [ 0.05 0.95 0.24 ] )\n"
        'donnie( name "donnie" pose [ 0 0 0 90 ] )\n',
        encoding="utf-8",
    )
    script = open_script(world=str(file))

    assert script.answers_to("REMOVE wall 10 4") == ["Wall: gone from 10, 0."]
    assert len(script.donnie.picture_now().walls) == 1
    assert script.answers_to("UNDO") == ["Wall: at 10, 0. From the robot: 10 right."]
    assert script.answers_to("REMOVE east wall", "REMOVE wall 3 3")[-1].startswith("There is no wall 3 3")


def test_a_thing_whose_name_has_a_number_is_moved(open_script: OpenScript) -> None:
    script = open_script(world="first_room")
    script.answers_to("PUT box red 4 6", "PUT box red 8 6")

    assert script.answers_to("MOVE box 2 1 0")[0].startswith("Box, red: now at 9, 6.")


# --- saving


def test_the_saved_world_is_what_was_built(open_script: OpenScript, tmp_path: Path) -> None:
    script = open_script(world="first_room")
    script.type("PUT box red 4 6 AS treasure")
    script.type("MOVE table 0 -2")
    script.type("TURN chair 45")
    script.type("REMOVE ball")
    built = script.donnie.picture_now()

    assert script.answers_to("SAVE WORLD mine") == ["World saved as mine.world. WORLD mine.world goes there."]

    saved = choose_world(str(tmp_path / "mine.world"), Words("en"))
    assert picture(saved.scene).things == built.things
    assert saved.scene.report.notes == ()
    text = (tmp_path / "mine.world").read_text(encoding="utf-8")
    assert text.startswith("# The room of the first lesson")  # what its author wrote stays


def test_saving_asks_before_another_file_is_replaced(open_script: OpenScript, tmp_path: Path) -> None:
    (tmp_path / "mine.world").write_text("theirs", encoding="utf-8")
    script = open_script(world="first_room", answers=["no", "yes"])
    script.type("PUT box red 4 6")

    script.type("SAVE WORLD mine")
    assert (tmp_path / "mine.world").read_text(encoding="utf-8") == "theirs"
    script.type("SAVE WORLD mine")
    assert "box" in (tmp_path / "mine.world").read_text(encoding="utf-8")
    script.type("SAVE WORLD")  # its own file by now
    assert len(script.interaction.asked) == 2


def test_the_name_of_a_world_is_read_as_that_of_a_program(
    open_script: OpenScript, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("HOME", str(tmp_path))
    (tmp_path / "folder.world").mkdir()
    script = open_script(world="first_room")
    script.type("PUT box red 4 6")

    assert script.answers_to("SAVE WORLD folder.world") == ["folder.world is a folder."]
    file = tmp_path / "a b.world"
    assert script.answers_to('SAVE WORLD "~/a\x1bb"') == [f"World saved as {file}. WORLD {file} goes there."]
    assert file.is_file()


def test_a_saved_world_is_named_as_it_can_be_typed_again(open_script: OpenScript, tmp_path: Path) -> None:
    (tmp_path / "sub").mkdir()
    script = open_script(world="first_room")

    script.answers_to("PUT box red 4 6")
    (saved,) = script.answers_to("SAVE WORLD ./sub//room")
    assert saved == "World saved as sub/room.world. WORLD sub/room.world goes there."
    with pytest.raises(EnterWorld) as entered:
        script.type(saved.split(". ")[1].removesuffix(" goes there."))
    assert entered.value.name == "sub/room.world"


@pytest.mark.parametrize(
    "typed", ['"~/a b.world"', "~/a b.world", "'{folder}/a b.world'", "{folder}/a b.world"]
)
def test_the_name_that_saved_a_world_enters_it(
    open_script: OpenScript, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, typed: str
) -> None:
    monkeypatch.setenv("HOME", str(tmp_path))
    script = open_script(world="first_room")
    name = typed.format(folder=tmp_path)

    script.answers_to("PUT box red 4 6", f"SAVE WORLD {name}")
    with pytest.raises(EnterWorld) as entered:
        script.type(f"WORLD {name}")
    assert entered.value.name == str(tmp_path / "a b.world")


def test_a_world_of_the_learner_is_saved_to_its_file(open_script: OpenScript, tmp_path: Path) -> None:
    file = tmp_path / "room.world"
    file.write_text('include "donnie.inc"\ndonnie( name "donnie" pose [ 0 0 0 90 ] )\n', encoding="utf-8")
    script = open_script(world=str(file))

    assert script.answers_to("PUT chair 4 6") == ["Chair, green: at 4, 6. From the robot: 4 right, 6 ahead."]
    script.type("SAVE WORLD")

    assert file.read_text(encoding="utf-8") == (
        'include "donnie.inc"\ndonnie( name "donnie" pose [ 0 0 0 90 ] )\n'
        'include "furniture.inc"\nchair( name "chair" pose [ 0.2 0.3 0 0 ] )\n'
    )


@pytest.mark.parametrize(("answers", "leaves"), [(["no"], True), ([None], False), (["yes", "mine"], True)])
def test_leaving_asks_about_a_world_that_is_not_saved(
    open_script: OpenScript, tmp_path: Path, answers: list[str | None], leaves: bool
) -> None:
    script = open_script(world="first_room", answers=answers)
    script.type("PUT box red 4 6")

    assert drive(may_lose_all(script.ctx)) is leaves
    assert script.interaction.asked[0] == "You changed this world. Save it, y or n? Enter means no."
    assert len(script.interaction.asked) == (2 if "mine" in answers else 1), "a name only for what is saved"
    assert ("Not saved, so Donnie stays open." in script.printed) is not leaves
    assert (tmp_path / "mine.world").exists() == ("mine" in answers)


def test_nothing_is_asked_about_a_world_that_is_saved_or_was_not_changed(open_script: OpenScript) -> None:
    script = open_script(world="first_room")
    assert drive(may_leave_built(script.ctx))
    script.type("PUT box red 4 6")
    script.type("SAVE WORLD mine")

    assert drive(may_leave_built(script.ctx))
    assert script.interaction.asked == []


def test_where_no_question_is_possible_a_changed_world_is_kept(open_script: OpenScript) -> None:
    script = open_script(world="first_room")
    script.interaction.is_attended = False
    assert (drive(may_leave_built(script.ctx)), script.printed) == (True, [])
    script.type("PUT box red 4 6")

    assert drive(may_leave_built(script.ctx))
    script.donnie.session.hub.wait_until_delivered(TIMEOUT)
    kept = script.printed[-1].removeprefix("Your world is kept as ").removesuffix(".")
    assert Path(kept).is_file()
    assert script.interaction.asked == []


def test_another_world_is_entered_after_the_question_only(open_script: OpenScript) -> None:
    script = open_script(world="first_room", answers=[None, "no"])
    script.type("PUT box red 4 6")

    assert script.answers_to("WORLD maze") == ["Not saved, so Donnie stays open."]
    with pytest.raises(EnterWorld):
        script.type("WORLD maze")


def test_what_was_built_is_taken_back_step_by_step(open_script: OpenScript) -> None:
    script = open_script("FW 1")

    script.answers_to("PUT box red 4 6 AS treasure", "MOVE treasure 2 0", "REMOVE treasure")
    assert script.answers_to("UNDO")[0].startswith("Treasure, box, red: at 6, 6.")
    assert script.answers_to("UNDO")[0].startswith("Treasure, box, red: now at 4, 6.")
    assert script.answers_to("UNDO")[0].startswith("Treasure, box, red: gone from 4, 6.")
    assert script.answers_to("MAP")[-1] == "There are no things."
    assert script.donnie.site.is_saved


def test_the_program_and_the_world_are_undone_in_the_order_of_their_changes(open_script: OpenScript) -> None:
    script = open_script("FW 1")

    script.answers_to("PUT box red 4 6 AS treasure", "CHANGE 1 FW 2")
    assert script.answers_to("UNDO") == ["Line 1: FW 1"]
    assert script.answers_to("UNDO")[0].startswith("Treasure, box, red: gone from 4, 6.")
    assert script.answers_to("UNDO") == ["Nothing was changed."]


def test_what_was_taken_back_is_built_again_step_by_step(open_script: OpenScript) -> None:
    script = open_script("FW 1")

    script.answers_to("PUT box red 4 6 AS treasure", "MOVE treasure 2 0", "REMOVE treasure")
    built = script.donnie.site.text
    script.answers_to("UNDO", "UNDO", "UNDO")
    assert script.answers_to("REDO")[0].startswith("Treasure, box, red: at 4, 6.")
    assert script.answers_to("REDO")[0].startswith("Treasure, box, red: now at 6, 6.")
    assert script.answers_to("UNDO")[0].startswith("Treasure, box, red: now at 4, 6.")
    assert script.answers_to("REDO", "REDO")[-1] == "Treasure, box, red: gone from 6, 6."
    assert script.donnie.site.text == built
    assert script.answers_to("REDO") == ["Nothing was changed."]


def test_the_program_and_the_world_are_built_again_in_the_order_of_their_changes(
    open_script: OpenScript,
) -> None:
    script = open_script("FW 1")

    script.answers_to("CHANGE 1 FW 2", "PUT box red 4 6 AS treasure", "UNDO", "UNDO")
    assert script.answers_to("REDO") == ["Line 1: FW 2"]
    assert script.answers_to("REDO")[0].startswith("Treasure, box, red: at 4, 6.")


def test_what_is_built_after_an_undo_can_not_be_lost_by_redo(open_script: OpenScript) -> None:
    script = open_script()

    script.answers_to("PUT box red 4 6", "UNDO", "PUT ball 4 6")
    assert script.answers_to("REDO") == ["Nothing was changed."]
    assert script.answers_to("MAP 4 6") == ["4, 6: ball. 4 right, 6 ahead."]


def test_nothing_is_put_back_onto_the_robot(open_script: OpenScript) -> None:
    script = open_script()

    script.answers_to("PUT box red 0 6 AS treasure", "REMOVE treasure", "FW 6")
    said = script.answers_to("UNDO")
    assert "treasure" not in script.answers_to("MAP")[-1].casefold()
    assert said == script.answers_to("UNDO")
    script.answers_to("BW 6")
    assert script.answers_to("UNDO")[0].startswith("Treasure, box, red: at 0, 6.")


def test_a_world_that_was_saved_and_taken_back_is_not_lost(open_script: OpenScript, tmp_path: Path) -> None:
    """What is kept where no question is possible is the world as it is then."""
    script = open_script()

    script.answers_to("PUT box red 4 6 AS treasure", "SAVE WORLD mine", "UNDO")
    assert not script.donnie.site.is_saved
    kept = script.donnie.rescue_world()
    assert kept is not None
    text = kept.read_text(encoding="utf-8")
    assert "donnie(" in text
    assert "treasure" not in text
    script.answers_to("REDO")
    assert script.donnie.site.is_saved


def test_the_words_of_the_author_are_back_where_all_was_taken_back(open_script: OpenScript) -> None:
    script = open_script(world="first_room")

    script.answers_to("PUT box red 4 6")
    assert script.donnie.world.about("en") is None
    script.answers_to("UNDO")
    assert script.donnie.world.about("en") is not None


FURNITURE = 'include "wood.inc" # teak\ndefine desk model ( size [ 0.5 0.25 0.4 ] wood ( ) color "brown" )\n'
WOOD = 'define wood model ( size [ 0.1 0.1 0.1 ] bitmap "grain.png" )\n'


def write_classroom(folder: Path) -> Path:
    """A world that includes a file, which includes another one in its folder, which has a picture there."""
    (folder / "class/parts").mkdir(parents=True)
    Image.new("1", (4, 4)).save(folder / "class/parts/grain.png")
    (folder / "class/parts/desk.inc").write_text(FURNITURE, encoding="utf-8")
    (folder / "class/parts/wood.inc").write_text(WOOD, encoding="utf-8")
    file = folder / "class/room.world"
    file.write_text(
        'include "donnie.inc"\ninclude "parts/desk.inc"; the desks\ndesk( name "front" pose [ 0 1 0 0 ] )\n'
        'donnie( name "donnie" pose [ 0 0 0 90 ] )\n',
        encoding="utf-8",
    )
    return file


def test_a_kept_world_opens_with_all_that_it_includes(open_script: OpenScript, tmp_path: Path) -> None:
    script = open_script(world=str(write_classroom(tmp_path)))
    script.type("PUT box red 4 6 AS treasure")
    built = script.donnie.picture_now()

    kept = script.donnie.rescue_world()
    assert kept is not None
    shutil.rmtree(tmp_path / "class")
    opened = choose_world(str(kept), Words("en"))

    assert picture(opened.scene).things == built.things
    assert "front" in [each.name for each in built.things]
    assert 'include "donnie.inc"' in kept.read_text(encoding="utf-8")


def test_a_world_that_includes_files_is_saved_elsewhere(open_script: OpenScript, tmp_path: Path) -> None:
    file = write_classroom(tmp_path)
    (tmp_path / "mine-1.png").write_bytes(b"of the learner")
    script = open_script(world=str(file))
    script.type("PUT box red 4 6 AS treasure")
    built = script.donnie.picture_now()

    assert script.answers_to("SAVE WORLD mine") == ["World saved as mine.world. WORLD mine.world goes there."]

    assert script.donnie.site.is_saved
    assert (tmp_path / "mine-1.png").read_bytes() == b"of the learner"
    shutil.rmtree(tmp_path / "class")
    assert picture(choose_world("mine.world", Words("en")).scene).things == built.things


def test_a_world_saved_in_its_folder_keeps_its_includes(open_script: OpenScript, tmp_path: Path) -> None:
    file = write_classroom(tmp_path)
    script = open_script(world=str(file))
    before = file.read_text(encoding="utf-8")

    script.answers_to("REMOVE front", "PUT box red 4 6 AS treasure", "SAVE WORLD class/other")

    lines = (tmp_path / "class/other.world").read_text(encoding="utf-8").splitlines()
    assert lines[:2] == before.splitlines()[:2]
    assert sorted(each.name for each in file.parent.iterdir()) == ["other.world", "parts", "room.world"]


def test_a_world_of_the_manual_is_saved_in_the_folder_of_the_learner(
    open_script: OpenScript, tmp_path: Path
) -> None:
    script = open_script(world="bigbob7")
    assert script.answers_to("PUT box red 4 60")[0].startswith("Box, red: at 4, 60.")
    built = script.donnie.picture_now()

    script.type("SAVE WORLD mine")

    assert picture(choose_world(str(tmp_path / "mine.world"), Words("en")).scene).things == built.things


@pytest.mark.parametrize(
    ("units", "hundred"),
    [('unit_length "cm"', "100"), ('unit_length "mm" unit_angle "radians"', "1000"), ("", "1")],
)
def test_a_world_in_other_units_is_furnished(
    open_script: OpenScript, tmp_path: Path, units: str, hundred: str
) -> None:
    file = tmp_path / "units.world"
    file.write_text(f'{units}\nmodel( name "rock" pose [ {hundred} 0 0 0 ] )\n', encoding="utf-8")
    script = open_script(world=str(file))

    assert script.answers_to("PUT box red 4 6 AS treasure", "MOVE rock 2 10", "TURN treasure 90") == [
        "Treasure, box, red: at 4, 6. From the robot: 4 right, 6 ahead.",
        "Rock, red: now at 22, 10. From the robot: 22 right, 10 ahead.",
        "Treasure, box, red: turned 90 degrees to the right, at 4, 6. It is 3 by 3 steps.",
    ]
    script.type("SAVE WORLD mine")
    again = choose_world("mine.world", Words("en")).scene
    assert {each.name: (round(each.x), round(each.y)) for each in picture(again).things} == {
        "treasure": (4, 6),
        "rock": (22, 10),
    }
