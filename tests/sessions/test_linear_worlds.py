"""A change of the world in the linear mode keeps the program and the answers."""

from pathlib import Path

import pytest

from tests.sessions.command import QUIET, donnie
from tests.sessions.learner import Learner

pytestmark = pytest.mark.slow


def answers_to(folder: Path, typed: str, *options: str, code: int = 0) -> list[str]:
    """What the linear mode prints between its first lines and the goodbye, with that exit code.

    Lines that did not run make it 1. Without the lines about a slow world: on a busy machine each world may
    be slow.
    """
    done = donnie(folder, "--linear", *QUIET, "--speed", "max", *options, typed=typed)

    assert done.returncode == max(code, b"did not run" in done.stdout), done.stderr
    assert done.stderr == b""
    lines = done.stdout.decode().splitlines()[2:-1]
    return [line for line in lines if not line.startswith(("Loading the world ", "Carregando o mundo "))]


def test_worlds_lists_the_worlds_and_a_name_selects_one_with_the_program(tmp_path: Path) -> None:
    lines = answers_to(tmp_path, "FW 2\n\nWORLDS\nWORLDS maze\nLIST\nWHERE\nAGAIN\nLAST 4\n")

    assert lines[:4] == [
        "I walked 2 steps forward.",
        "28 worlds. WORLD with a name goes there.",
        "first_room: First room, easy.",
        "open_floor: Open floor, easy. You are here.",
    ]
    assert lines[30:] == [
        "I am going to maze.",
        "This is the world maze: Maze.",
        "49 by 41 steps, walls included.",
        "1 thing. WORLD says more.",
        "Your program has 1 line.",
        "1: FW 2",
        "Position 0, 0. Facing north.",
        "I walked 2 steps forward.",
        "I am going to maze.",
        "This is the world maze: Maze.",
        "49 by 41 steps, walls included.",
        "1 thing. WORLD says more.",
        "Your program has 1 line.",
    ]


def test_another_challenge_begins_with_an_empty_program_and_no_line_is_lost(tmp_path: Path) -> None:
    """AGAIN ran what had solved the challenge before."""
    typed = "FW 2\n\nCHALLENGE 1\nLIST\nFW 3\n\nWORLD open_floor\nCHALLENGE 1\nLIST\nNEXT CHALLENGE\nLIST\n"
    lines = answers_to(tmp_path, f"{typed}UNDO\nLIST\nUNDO\nUNDO\nLIST\n", "--world", "first_room")
    away = "Your 1 line is put away. UNDO brings it back."

    assert lines.count(away) == 2
    first, second = (at for at, line in enumerate(lines) if line == away)
    assert lines[first + 1] == "There are no lines yet."
    assert "1: FW 3" in lines[first + 1 : second]
    assert lines[second + 1] == "There are no lines yet."
    rest = lines[second + 2 :]
    assert rest.index("1: FW 3") < rest.index("1: FW 2")


def test_switches_and_watched_variables_stay_in_another_world(tmp_path: Path) -> None:
    lines = answers_to(tmp_path, "SOUND OFF\n\nWATCH x\nWORLD maze\nVAR x = 3\n\nCUES bump\n")

    assert "x is 3." in lines
    assert lines.index("Sound off.") < lines.index("This is the world maze: Maze.")


def test_a_world_can_be_named_by_its_title_in_any_language(tmp_path: Path) -> None:
    typed = "MUNDO Labirinto\nWORLD living-room\nworld LivingRoom\n"
    lines = answers_to(tmp_path, typed, "--lang", "pt", code=2)

    assert [line for line in lines if "mundo" in line and not line.startswith("Vou ")] == [
        "Este é o mundo maze: Labirinto.",
        "Não existe o mundo living-room. Você quis dizer living_room?",
        "Este é o mundo living_room: Sala de estar.",
    ]


def test_a_missing_world_is_reported_and_the_current_one_stays(tmp_path: Path) -> None:
    (tmp_path / "bad.world").write_text("this is no world {", encoding="utf-8")

    typed = "WORLD nowhere\nWORLD x.world\nWORLD bad.world\nWORLD maze\nWHERE\n"
    lines = answers_to(tmp_path, typed, "--world", "maze", code=2)

    assert lines[0] == "There is no world nowhere. WORLDS lists them."
    assert lines[1] == "There is no file x.world."
    assert "bad.world" in lines[2]
    assert lines[-2:] == ["You are in maze already. RESET goes to the start.", "Position 0, 0. Facing north."]


def test_a_user_world_is_selected_by_its_file(tmp_path: Path) -> None:
    (tmp_path / "my.world").write_text(
        'include "donnie.inc"\ndonnie( pose [ 0 0 0 90 ] )\n', encoding="utf-8"
    )

    assert answers_to(tmp_path, "WORLD my.world\nFW 1\n\n")[:2] == [
        "I am going to my.world.",
        "This is the world my.world.",
    ]


def test_running_robots_are_stopped_first_and_reported(tmp_path: Path) -> None:
    lines = answers_to(tmp_path, "REPEAT 9999 TIMES\nWAIT 1\nEND REPEAT\nSTART\nWORLD maze\n", "--speed", "1")

    assert lines[lines.index("I am going to maze.") - 1] == "Stopped at line 2."


def test_a_program_that_is_held_is_stopped_for_another_world(tmp_path: Path) -> None:
    learner = Learner(tmp_path)
    learner.enters("FW 2", "FW 3", "STEP", "WORLD nowhere")
    learner.sees("There is no world nowhere. WORLDS lists them.")
    learner.enters("WORLD maze")
    learner.sees("Stopped at line 1.")
    learner.sees("This is the world maze: Maze.")
    learner.sees("Your program has 2 lines.")
    learner.enters("WHERE")
    learner.sees("Position 0, 0. Facing north.")
    learner.enters("QUIT")

    assert learner.leaves() == 0


def test_programs_of_other_robots_wait_for_them(tmp_path: Path) -> None:
    typed = "FW 1\nROBOT bob\nFW 5\nROBOT alice\nWORLD maze\nWORLD two_robots\nLIST\nROBOT bob\nLIST\n"

    lines = answers_to(tmp_path, typed, "--world", "two_robots")

    assert [line for line in lines if ": FW" in line] == ["1: FW 1", "1: FW 5"]


def test_a_recorded_session_stays_in_its_world(tmp_path: Path) -> None:
    lines = answers_to(tmp_path, "WORLD maze\nWHERE\n", "--events", "e.jsonl")

    assert lines[0].startswith("I stay in this world: e.jsonl is being written")
    assert lines[1:] == ["Position 0, 0. Facing north."]


def test_a_word_that_takes_nothing_says_so(tmp_path: Path) -> None:
    assert answers_to(tmp_path, "WHERE 3\nAGAIN x\n", code=1) == [
        "WHERE takes nothing after it. Type WHERE alone.",
        "AGAIN takes nothing after it. Type AGAIN alone.",
    ]


def test_the_history_and_the_language_stay_in_another_world(tmp_path: Path) -> None:
    learner = Learner(tmp_path)
    learner.enters("FW 2", "", "LANGUAGE pt", "WORLD maze")
    learner.sees("Este é o mundo maze: Labirinto.")
    learner.sees_prompt()
    learner.types("\x1b[A\x1b[A\x1b[A\r\r")
    learner.sees("Andei 2 passos para frente.")
    learner.enters("SAIR")

    assert learner.leaves() == 0


def test_a_world_without_a_robot_says_that_donnie_was_put_in(tmp_path: Path) -> None:
    (tmp_path / "bare.world").write_text("model( size [ 0.4 0.4 1 ] )")
    said = "The world bare.world has no robot, so I put Donnie in, at 0, 10."

    there = answers_to(tmp_path, "FW 2\n\nWHERE\n", "--world", "bare.world")
    assert there == [said, "I walked 2 steps forward.", "Position 0, 12. Facing north."]
    assert said in answers_to(tmp_path, "WORLD bare.world\n")


def test_a_recording_of_a_world_without_a_robot_can_be_run_again(tmp_path: Path) -> None:
    (tmp_path / "bare.world").write_text("model( size [ 0.4 0.4 1 ] )")
    (tmp_path / "a.gd").write_text("FW 2\nTR 90\n")

    run = donnie(tmp_path, "run", "a.gd", "--world", "bare.world", "--record", "a.rec", "--speed", "max")
    again = donnie(tmp_path, "replay", "a.rec", "--check")

    assert run.stderr == b"The world bare.world has no robot, so I put Donnie in, at 0, 10.\n"
    assert (again.returncode, again.stderr) == (0, b"")


def test_the_path_is_said_and_drawn_on_the_map_in_letters(tmp_path: Path) -> None:
    typed = "FW 3\nTR 90\nFW 2\n\nSHOW PATH\nRESET\nSHOW PATH\n"

    lines = answers_to(tmp_path, typed, "--world", "first_room")

    at = lines.index("The path starts at 0, 0.")
    assert lines[at + 1 : at + 4] == [
        "North: 3 steps, to 0, 3.",
        "East: 2 steps, to 2, 3.",
        "5 steps in all.",
    ]
    rows = [line for line in lines[at:] if line.startswith("#") and line.endswith("#")]
    drawn = [row.strip("#").strip(".") for row in rows if "o" in row.strip("#") or "*" in row]
    assert [row.replace("b", "").replace("c", "").strip(".") for row in drawn] == ["oo>", "o", "o", "*"]
    assert lines[-1] == "I have not moved yet."
